"""The one table of slots: what each may hold, and who speaks of it. A new slot is a field of `Slots` and a row here."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scenario import (
    Component,
    Control,
    Distance,
    EgoState,
    Maneuver,
    Occluder,
    Place,
    Position,
    Side,
    Site,
)

YES = (True,)  # of what is either said or not
BEHAVIOR, GEOMETRY, SPAWN = Component


@dataclass(frozen=True, slots=True, kw_only=True)
class Slot:
    """What holds of a slot, whoever fills it.

    Attributes:
        of: The components whose snippets it tells apart; none for the adversary, on whom all three agree, and for what
            no snippet does.
        shared: Whether two parts of one program may both speak of it, and must then agree.
        added: Whether a snippet that fills it adds something to a scene, which may not have been asked for.
        about: Whether that is somebody or something that stands or drives about.
        taught: Whether a scene may have it unasked, and sentences of ours tell it.
    """

    values: tuple[Any, ...]
    of: tuple[Component, ...] = ()
    shared: bool = False
    added: bool = False
    about: bool = False
    taught: bool = True


SLOTS: dict[str, Slot] = {
    "adversary": Slot(values=tuple(kind for kind in AdversaryKind if kind.heard_as is kind)),
    "side": Slot(values=tuple(Side), of=(SPAWN,), shared=True),
    "position": Slot(values=tuple(Position), of=(BEHAVIOR, SPAWN), shared=True),
    "occluder": Slot(values=tuple(Occluder), of=(SPAWN,), shared=True, added=True, about=True),
    "maneuver": Slot(values=tuple(Maneuver), of=(GEOMETRY,), shared=True),
    "place": Slot(values=tuple(Place), of=(GEOMETRY, SPAWN), shared=True),
    "control": Slot(values=tuple(Control), of=(BEHAVIOR, GEOMETRY), shared=True, added=True),
    "leader": Slot(values=YES, of=(SPAWN,), shared=True, added=True, about=True),
    "blocker": Slot(values=YES, of=(SPAWN,), shared=True, added=True, about=True),
    "distance": Slot(values=tuple(Distance), of=(SPAWN,), added=True),
    "group": Slot(values=YES, of=(SPAWN,), shared=True, added=True, about=True),
    "lanes": Slot(values=(1, 2, 3), of=(GEOMETRY,), added=True),
    "two_way": Slot(values=(True, False), of=(GEOMETRY,)),
    "ego": Slot(values=tuple(EgoState), taught=False),
    "site": Slot(values=tuple(Site), of=(GEOMETRY,), shared=True, added=True, taught=False),
}
"""Every slot with one value; what the adversary does, `Slots.actions`, are acts (`chatscene.terms.acts`)."""


def slots_of(component: Component) -> tuple[str, ...]:
    """The names of the slots by which the snippets of a component are told apart, acts among them."""
    named = tuple(name for name, slot in SLOTS.items() if component in slot.of)
    return ("actions", *named) if component is BEHAVIOR else named
