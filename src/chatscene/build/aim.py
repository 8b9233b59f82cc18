"""Which part of whom is met: the window of time in which somebody crosses the ego's way so that it is."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets, stops_on_its_way
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.situation import Contact, Other
from chatscene.terms.vocabulary import Act, Part, Role, Side, Striker

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

NEAR_MISS = 1.0  # [s] before the ego at most that somebody has gone by where there is no contact
YIELDS = (1.2, 2.5)  # [s] before the ego that somebody is at a junction who lets it by
STOOD = 1.0  # [s] that somebody has stood in the ego's way when the ego comes, so that it is seen to stop
GENTLE = 2.5  # [m/s²] that an ego brakes with that nothing forces to brake harder
Window = tuple[float, float]

EGO: Mapping[Part, Window] = {
    Part.FRONT: (0.0, 1.0),
    Part.LEFT_FRONT: (-0.35, 0.3),
    Part.RIGHT_FRONT: (-0.35, 0.3),
    Part.LEFT: (-0.8, -0.2),
    Part.RIGHT: (-0.8, -0.2),
    Part.LEFT_REAR: (-1.0, -0.55),
    Part.RIGHT_REAR: (-1.0, -0.55),
    Part.REAR: (-1.0, -0.75),
}
OTHER: Mapping[Part, Window] = {
    Part.FRONT: (-1.0, 0.0),
    Part.LEFT_FRONT: (-0.3, 0.35),
    Part.RIGHT_FRONT: (-0.3, 0.35),
    Part.LEFT: (0.2, 0.8),
    Part.RIGHT: (0.2, 0.8),
    Part.LEFT_REAR: (0.55, 1.0),
    Part.RIGHT_REAR: (0.55, 1.0),
    Part.REAR: (0.75, 1.0),
}
STRIKER: Mapping[Striker, Window] = {Striker.EGO: (0.0, 1.0), Striker.OTHER: (-1.0, 0.0)}
"""For a part of the ego or of who crosses its way, and for who strikes: the share of the window in which that is met.

At -1 the other touches the ego's tail, at 0 both noses are there at once, at 1 the other has just gone by.
"""
_LEFT = frozenset((Part.LEFT, Part.LEFT_FRONT, Part.LEFT_REAR))
_RIGHT = frozenset((Part.RIGHT, Part.RIGHT_FRONT, Part.RIGHT_REAR))


def set_offset(actor: Actor) -> None:
    """Let somebody be where the ways meet from when it would touch the ego's tail to when it would just have gone by.

    Whoever comes later strikes the other.
    """
    ego = AdversaryKind.CAR.row.limits
    late = -0.5 * (ego.length + actor.limits.length) / actor.ego_speed
    early = (ego.width + actor.limits.length) / actor.numbers.middle("SPEED")
    yields = bool(actor.deeds) and actor.deeds[0].act is Act.YIELD
    if yields:  # who waits for the ego is there well before it
        late, early = YIELDS
    late, early, *taken = aimed(actor.ledger.situation.contact, actor.one, late, early)
    actor.ledger.take(*taken)
    if actor.one.role is Role.SUPPORTING and not yields:  # not met: before the ego, which can still brake for it
        late, early = early + 0.5 * actor.ego_speed / GENTLE, early + actor.ego_speed / GENTLE
    if actor.stand.meets is Meets.THROUGH and any(
        stops_on_its_way(Meets.THROUGH, actor.deeds, k) for k in range(len(actor.deeds))
    ):
        stops = 0.5 * actor.numbers.middle("SPEED") / actor.limits.brake + STOOD
        late, early = stops, stops + early  # it stands there when the ego comes
    actor.numbers.narrow("OFFSET", late, early)


def aimed(contact: Contact | None, one: Other, late: float, early: float) -> tuple[float, float, *tuple[str, ...]]:
    """When somebody is where the ways meet, and the facts that this has.

    Args:
        contact: What was said of the contact.
        one: Who crosses the ego's way.
        late: How much sooner than the ego [s] it is there if it touches the ego's tail; below 0.
        early: The same if it has just gone by.

    Returns:
        How much sooner than the ego it is there, from and to, then the paths of what is aimed at. A part that cannot be
        met together with what stands before it is not aimed at.
    """
    if contact is None or contact.whom not in (None, one.id):
        return late, early
    if not contact.happens:
        return early, early + NEAR_MISS, "contact.happens"
    low, high, taken = -1.0, 1.0, list[str]()
    for path, window in _windows(contact, one):
        if (least := max(low, window[0])) < (most := min(high, window[1])):
            low, high = least, most
            taken.append(path)
    return _at(low, late, early), _at(high, late, early), *taken


def _windows(contact: Contact, one: Other) -> list[tuple[str, Window]]:
    turned = {Side.LEFT: _RIGHT, Side.RIGHT: _LEFT}
    away = turned[one.starts.side] if one.starts.side is not None else frozenset[Part]()
    windows: list[tuple[str, Window]] = []
    if contact.striker is not None:
        windows.append(("contact.striker", STRIKER[contact.striker]))
    if contact.ego is not None and contact.ego not in away:
        windows.append(("contact.ego", EGO[contact.ego]))
    if contact.other is not None and (one.starts.side is None or contact.other in away or contact.other in _ENDS):
        windows.append(("contact.other", OTHER[contact.other]))
    return windows


_ENDS = frozenset((Part.FRONT, Part.REAR))


def _at(share: float, late: float, early: float) -> float:
    return -share * late if share < 0 else share * early
