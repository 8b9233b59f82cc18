"""Words that know which fact each piece of them tells."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from enum import Enum

_PIECE = re.compile(r"<(?P<maybe>[^<>]*)>|\{(?P<slot>\w+)\}|\[(?P<verb>[^][]*)\]")


class Form(Enum):
    """A form of a verb, by its place in the brackets of a phrase."""

    SEVERAL = 0  # they stop
    ONE = 1  # it stops
    ING = 2  # stopping
    WOULD = 3  # would stop

    def of(self, verb: str) -> str:
        """The form of a verb that is written as ``stop/stops/stopping``."""
        forms = verb.split("/")
        return f"would {forms[0]}" if self is Form.WOULD else forms[self.value]


@dataclass(frozen=True, slots=True)
class Words:
    """A text, and the facts in it.

    Attributes:
        text: The text.
        facts: Of each fact that it tells, the path, and where its words begin and end.
    """

    text: str = ""
    facts: tuple[tuple[str, int, int], ...] = ()

    def __add__(self, other: Words | str) -> Words:
        """Both, one after the other."""
        more = Words(other) if isinstance(other, str) else other
        moved = ((path, low + len(self.text), high + len(self.text)) for path, low, high in more.facts)
        return Words(self.text + more.text, (*self.facts, *moved))

    def __bool__(self) -> bool:
        """Whether anything is said."""
        return bool(self.text)

    def tells(self, *paths: str) -> Words:
        """The same, all of which, but for spaces and commas about it, tells some more facts."""
        low = len(self.text) - len(self.text.lstrip(" ,"))
        high = len(self.text.rstrip(" ,"))
        return Words(self.text, (*((path, low, high) for path in paths), *self.facts))

    def capitalised(self) -> Words:
        """The same with a capital letter first."""
        return Words(self.text[:1].upper() + self.text[1:], self.facts)

    def with_first(self, pattern: re.Pattern[str], by: str) -> Words:
        """The same with the first match of a pattern replaced; what tells a fact still does."""
        found = pattern.search(self.text)
        if found is None:
            return self
        new = found.expand(by)
        more = len(new) - len(found[0])

        def moved(at: int) -> int:
            return at + more if at >= found.end() else at

        facts = ((path, moved(low), moved(high)) for path, low, high in self.facts)
        return Words(self.text[: found.start()] + new + self.text[found.end() :], tuple(facts))


def filled(phrase: str, form: Form, slots: Mapping[str, Words]) -> Words:
    """A phrase with its verbs in a form and its slots filled; what has no words for its slot is left out.

    Raises:
        KeyError: It has a slot that nobody fills.
    """
    made, at = Words(), 0
    for piece in _PIECE.finditer(phrase):
        made += phrase[at : piece.start()]
        at = piece.end()
        if piece["verb"] is not None:
            made += form.of(piece["verb"])
        elif piece["slot"] is not None:
            made += slots[piece["slot"]]
        else:
            made += _maybe(piece["maybe"], form, slots)
    return made + phrase[at:]


def _maybe(phrase: str, form: Form, slots: Mapping[str, Words]) -> Words:
    """A phrase that stands for the facts in it, or nothing if one of them was not said."""
    names = [piece["slot"] for piece in _PIECE.finditer(phrase) if piece["slot"] is not None]
    if not all(slots.get(name) for name in names):
        return Words()
    made = filled(phrase, form, slots)
    return Words(made.text).tells(*(path for path, _, _ in made.facts))


def joined(words: Iterable[Words], by: str = ", ", last: str = " and ") -> Words:
    """Some in a row, as in *a, b and c*."""
    *others, end = tuple(words) or (Words(),)
    made = Words()
    for i, one in enumerate(others):
        made = made + (by if i else "") + one
    return made + last + end if others else end


def sentence(*words: Words | str) -> Words:
    """One sentence of some words in a row; nothing of nothing."""
    made = Words()
    for one in words:
        made += one
    return made.capitalised() + "." if made else made
