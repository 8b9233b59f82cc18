"""What an edit of a situation changes: facts by name, with what they were and what they are."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from typing import Any, cast

from chatscene.terms.frame import Frame
from chatscene.terms.scenario import Measure, Quantity, Shift, Slots, Unused
from chatscene.terms.slots import SLOTS
from chatscene.terms.surroundings import Surroundings

Numbers = dict[Measure, tuple[Quantity | Shift, ...]]


@dataclass(frozen=True, slots=True, kw_only=True)
class Facts:
    """All facts of a situation that an edit may name.

    Attributes:
        slots: Who does what and where.
        surroundings: Light, weather and the state of the road.
        numbers: What was said of each measure: a number, and how it was shifted since.
    """

    slots: Slots
    surroundings: Surroundings
    numbers: Numbers

    @classmethod
    def of(cls, frame: Frame, slots: Slots) -> Facts:
        """The facts of a frame, once its slots are decided."""
        of_ego = (frame.ego_speed,) if frame.ego_speed is not None else ()
        said = (*frame.quantities, *of_ego, *frame.shifts)
        numbers = {measure: tuple(one for one in said if one.measure is measure) for measure in Measure}
        return cls(slots=slots, surroundings=frame.surroundings, numbers={m: n for m, n in numbers.items() if n})

    @property
    def quantities(self) -> tuple[Quantity, ...]:
        """The numbers that were said."""
        return tuple(one for several in self.numbers.values() for one in several if isinstance(one, Quantity))

    @property
    def shifts(self) -> tuple[Shift, ...]:
        """How numbers were shifted."""
        return tuple(one for several in self.numbers.values() for one in several if isinstance(one, Shift))

    def on(self, frame: Frame) -> Frame:
        """A frame that says these facts and is sure of them."""
        of_ego = [one for one in self.quantities if one.measure is Measure.EGO_SPEED]
        return replace(
            frame,
            outright=self.slots,
            surroundings=self.surroundings,
            quantities=tuple(one for one in self.quantities if one not in of_ego),
            ego_speed=next(iter(of_ego), None),
            shifts=self.shifts,
        )

    def named(self) -> dict[str, Any]:
        """Every fact by its name; how far off it starts may be a number or near or far."""
        slots = {name: getattr(self.slots, name) for name in ("adversary", "actions", *SLOTS, "others")}
        around = {name: getattr(self.surroundings, name) for name in ("light", "weather", "surface")}
        numbers = {str(measure): self.numbers.get(measure, ()) or slots.get(measure) or () for measure in Measure}
        return {**slots, **around, **numbers}


@dataclass(frozen=True, slots=True, kw_only=True)
class Change:
    """A fact that is another one now.

    Attributes:
        fact: Its name: a slot, a measure, or ``light``, ``weather``, ``surface``.
        before: What it was; None or empty if nothing was said.
        after: What it is.
    """

    fact: str
    before: Any
    after: Any

    def __str__(self) -> str:
        """In words."""
        return f"{self.fact}: {in_words(self.before)} → {in_words(self.after)}"


def changes(before: Facts, after: Facts) -> tuple[Change, ...]:
    """What differs between facts."""
    was, now = before.named(), after.named()
    return tuple(Change(fact=name, before=was[name], after=now[name]) for name in was if was[name] != now[name])


@dataclass(frozen=True, slots=True, kw_only=True)
class Edit:
    """An edit, read against the facts at hand.

    Attributes:
        text: As the user wrote it.
        facts: All facts as they are to be.
        named: The facts that it names, each with its words.
        unused: What it says and no scene has, such as how heavy a rain is.
    """

    text: str
    facts: Facts
    named: dict[str, str]
    unused: tuple[Unused, ...] = ()


def with_edits(text: str, edits: Iterable[str]) -> str:
    """A sentence as it was written, and what was changed of it since."""
    return " ".join((text, *(f"(edited: {one})" for one in edits)))


def in_words(value: object) -> str:
    """A fact for people."""
    if value is None or value == ():
        return "not said"
    if value is True:
        return "yes"
    if value is False:
        return "no"
    if isinstance(value, Slots):
        return f"{value.adversary} {' then '.join(value.actions)} ({value.position or 'anywhere'})"
    if isinstance(value, tuple):
        many = cast("Iterable[object]", value)
        return " then ".join(in_words(one) for one in many)
    return str(value)
