"""What each road user of a situation is called, and in which order they are told."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Self

from chatscene.situations.phrases import KINDS, NUMBERS, Voice
from chatscene.situations.wording import Form
from chatscene.terms.situation import SEVERAL, Deed, Other, Situation, When

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
        situation: What is told.
        voice: Who tells it.
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
