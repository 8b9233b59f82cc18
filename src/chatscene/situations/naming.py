"""What each road user of a situation is called, and in which order they are told."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from enum import Enum
from typing import Self

from chatscene.situations.phrases import KINDS, NUMBERS, Voice
from chatscene.terms.situation import SEVERAL, Deed, Other, Situation, When

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


_ORDINALS = ("first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth", "ninth", "tenth")


def in_order(others: tuple[Other, ...], needs: Callable[[Other], frozenset[str]]) -> tuple[tuple[Other, ...], bool]:
    """Some so that whom each needs stands before it, else as they stood; and whether some need each other."""
    left, made, circular = list(others), list[Other](), False
    while left:
        waiting = {one.id for one in left}
        free = next((one for one in left if not needs(one) & waiting - {one.id}), None)
        circular = circular or free is None
        made.append(free or left[0])
        left.remove(made[-1])
    return tuple(made), circular


def spoken_of(one: Other) -> frozenset[str]:
    """The ids of those whom one speaks of."""
    return hider(one).union(*(named_by(deed) for deed in one.does))


def hider(one: Other) -> frozenset[str]:
    """The id of who hides one."""
    return frozenset(filter(None, (one.hidden_by,)))


def named_by(deed: Deed) -> frozenset[str]:
    """The ids of those whom a deed names."""
    when = deed.when or When()
    deeds = (reference.partition(".")[0] for reference in (when.after, when.during) if reference)
    return frozenset(filter(None, (deed.whom, when.of, *deeds)))


def called_of(one: Other) -> str:
    """What somebody is called, if nobody else is called so."""
    noun = KINDS[one.kind]
    if one.count == 1:
        return noun.one.partition(" ")[2]
    return noun.many if one.count == SEVERAL else f"{numeral(one.count)} {noun.many}"


def name_of(one: Other, called: str, rank: int | None) -> str:
    """What somebody is called who was named, and is the only one called so, or one of them."""
    if rank is None:
        return f"the {called}"
    return f"the {ordinal(rank)} {'' if one.count == 1 else 'group of '}{called}"


def target_of(one: Other) -> str:
    """What a test protocol calls one."""
    return f"target{'s' * (one.count != 1)} {one.id}"


def form_of(one: Other) -> Form:
    """The form of a verb that goes with one."""
    return Form.ONE if one.count == 1 else Form.SEVERAL


def numeral(number: int) -> str:
    """A number, in words if it is small."""
    return NUMBERS[number] if number < len(NUMBERS) else str(number)


def ordinal(rank: int) -> str:
    """A rank, counted from 0, in words."""
    return _ORDINALS[rank] if rank < len(_ORDINALS) else f"number {rank + 1}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Named:
    """A situation whose road users have their names and their order.

    Attributes:
        order: The others in the order in which they are told: whom somebody speaks of stands before.
        apart: Whether all are put in their places before anybody does anything, since they speak of each other.
        names: What each is called, once it was named.
        rank: Which of those of the same name each is, from 0; None of the only one.
    """

    situation: Situation
    voice: Voice
    order: tuple[Other, ...]
    apart: bool
    names: Mapping[str, str]
    rank: Mapping[str, int | None]

    @classmethod
    def of(cls, situation: Situation, voice: Voice) -> Self:
        """What all are called, by who tells it."""
        order, circular = in_order(situation.others, spoken_of)
        if circular:
            order, _ = in_order(situation.others, hider)
        called = [called_of(one) for one in order]
        rank = {
            one.id: called[:i].count(name) if called.count(name) > 1 else None
            for i, (one, name) in enumerate(zip(order, called, strict=True))
        }
        names = {
            one.id: name_of(one, name, rank[one.id]) if voice is Voice.PLAIN else target_of(one)
            for one, name in zip(order, called, strict=True)
        }
        return cls(situation=situation, voice=voice, order=order, apart=circular, names=names, rank=rank)
