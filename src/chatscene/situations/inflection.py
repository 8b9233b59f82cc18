"""Just enough English grammar to put marked phrases into a person and a tense.

A phrase marks its verbs with brackets, ``[run] the light and [stop]``; what stands in braces is filled in later.
"""

from __future__ import annotations

import re
from enum import StrEnum
from functools import lru_cache


def listed(text: str) -> tuple[str, ...]:
    """The alternatives in a text, which stand between bars or on lines of their own."""
    return tuple(part.strip() for part in text.replace("\n", "|").split("|") if part.strip())


class Form(StrEnum):
    """A form of a verb."""

    SINGULAR = "s"  # he runs
    PLURAL = "p"  # they run
    PAST = "d"  # they ran
    ING = "g"  # running


_PAST = {
    "begin": "began", "break": "broke", "come": "came", "creep": "crept", "cut": "cut", "do": "did", "drive": "drove",
    "freeze": "froze", "get": "got", "go": "went", "hang": "hung", "hit": "hit", "keep": "kept", "leave": "left",
    "make": "made", "meet": "met", "overtake": "overtook", "ride": "rode", "run": "ran", "set": "set", "shoot": "shot",
    "sit": "sat", "speed": "sped", "stand": "stood", "swing": "swung", "take": "took", "tear": "tore",
}  # fmt: skip
_DOUBLES = frozenset(
    ("step", "stop", "run", "cut", "set", "hit", "get", "jam", "slam", "zigzag", "sit", "begin", "travel", "drop")
)
_BE = {Form.SINGULAR: "is", Form.PLURAL: "are", Form.PAST: "was", Form.ING: "being"}
_MARKED = re.compile(r"\[([a-z]+)\]")


def inflected(verb: str, form: Form) -> str:  # noqa: PLR0911 - English
    """A verb in a form."""
    if verb == "be":
        return _BE[form]
    if form is Form.PLURAL:
        return verb
    if form is Form.SINGULAR:
        return _third_person(verb)
    stem = verb + verb[-1] if verb in _DOUBLES else verb
    if form is Form.ING:
        silent = verb.endswith("e") and not verb.endswith(("ee", "oe"))
        return (verb[:-1] if silent else stem) + "ing"
    if verb in _PAST:
        return _PAST[verb]
    if verb.endswith("e"):
        return verb + "d"
    return verb[:-1] + "ied" if _ends_in_y(verb) else stem + "ed"


def _third_person(verb: str) -> str:
    if verb == "have":
        return "has"
    if verb.endswith(("s", "sh", "ch", "x", "o", "z")):
        return verb + "es"
    return verb[:-1] + "ies" if _ends_in_y(verb) else verb + "s"


def _ends_in_y(verb: str) -> bool:
    return verb.endswith("y") and verb[-2] not in "aeiou"


@lru_cache(maxsize=16384)
def conjugated(phrase: str, form: Form) -> str:
    """A phrase with its marked verbs in a form."""
    return _MARKED.sub(lambda m: inflected(m[1], form), phrase)
