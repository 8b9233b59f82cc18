"""Just enough English grammar to write a verb in the forms that a sentence about now needs."""

from __future__ import annotations

_DOUBLES = frozenset(
    ("step", "stop", "run", "cut", "set", "hit", "get", "jam", "slam", "zigzag", "sit", "begin", "travel", "drop")
)


def inflected(verb: str) -> tuple[str, str, str]:
    """A verb as several do it, as one does it, and as it is being done: *stop, stops, stopping*."""
    return verb, _third_person(verb), _going_on(verb)


def _third_person(verb: str) -> str:
    if verb == "have":
        return "has"
    if verb.endswith(("s", "sh", "ch", "x", "o", "z")):
        return verb + "es"
    return verb[:-1] + "ies" if verb.endswith("y") and verb[-2] not in "aeiou" else verb + "s"


def _going_on(verb: str) -> str:
    silent = verb.endswith("e") and not verb.endswith(("ee", "oe"))
    stem = verb + verb[-1] if verb in _DOUBLES else verb
    return (verb[:-1] if silent else stem) + "ing"
