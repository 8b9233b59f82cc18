"""Of two who go the same way side by side, of whom one comes over to the other: which parts of the two touch."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets
from chatscene.build.contact import touches
from chatscene.build.place import GOES_OVER, LANE, NEXT_LANE
from chatscene.terms.situation import Contact, Deed, Other, Situation
from chatscene.terms.vocabulary import (
    ASIDE,
    COMES_OVER,
    GOES_ON,
    NOSE,
    SIDES_OF,
    Act,
    EgoRoute,
    Heads,
    Part,
    Side,
    Striker,
    Where,
    acts_of,
)

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

OVERLAP = 1.2  # [m] at least of both that are side by side as they touch, also if one gains a little
INTO = (0.1, 0.6)  # [m], from and to, that somebody goes farther than to where it touches the ego
AT_CORNER = 1.0  # [m] of where somebody is level with a corner, next to where it is with all
CORNER = 0.3  # of half its length ahead of its middle, or behind: from there on it is a corner that is touched
Level = tuple[float, float]
"""How far [m] ahead of the ego's middle that of the other is, from and to."""
_MOVES_OVER = ASIDE | COMES_OVER
_TURNS_OVER = {Side.LEFT: Act.TURN_RIGHT, Side.RIGHT: Act.TURN_LEFT}
_GOES_ON = GOES_ON | acts_of(Heads.THROUGH, Heads.LEVEL)
_INTO_DRIVEWAY = (EgoRoute.ENTER_DRIVEWAY, EgoRoute.ENTER_DRIVEWAY_ACROSS)
_TURNS = frozenset((EgoRoute.LEFT_TURN, EgoRoute.RIGHT_TURN, *_INTO_DRIVEWAY))


def comes_over(situation: Situation, one: Other) -> bool:
    """Whether somebody level with an ego that drives comes over to it, after it did nothing but go on."""
    side = one.starts.side
    if not one.does or one.starts.where is not Where.BESIDE or side is None or _stands(situation.ego.does):
        return False
    *before, last = one.does
    over = (last.act in _MOVES_OVER and last.to is not side) or last.act is _TURNS_OVER[side]
    said = (last.distance, last.time if last.act is Act.CUT_IN else None, last.when, last.lateral)
    level = last.whom is None and all(one is None for one in said)
    return over and level and all(deed.act in _GOES_ON for deed in before)


def ego_comes_over(situation: Situation, one: Other) -> bool:
    """Whether the ego comes over the way of somebody who goes on beside it."""
    route, start = situation.ego.route, one.starts
    goes_on = bool(one.does) and one.does[0].act in _GOES_ON
    return route is not None and start.where in NEXT_LANE and GOES_OVER.get(route) is start.side and goes_on


def level_as_said(situation: Situation, one: Other, length: float) -> Level | None:
    """How far ahead of the ego's middle that of somebody is as they touch, so that it is with the parts that were said.

    Who comes over touches with the corner of its nose, or is touched by that of the other: so is known where.

    Args:
        situation: What was said.
        one: Who is beside the ego.
        length: How long that is [m].

    Returns:
        From and to; None of whom nothing of the kind was said, or whom that does not fit.
    """
    contact, by_ego = situation.contact, ego_comes_over(situation, one)
    if contact is None or not touches(situation, one) or not (by_ego or comes_over(situation, one)):
        return None
    own = situation.ego.body.row.limits.length
    most = 0.5 * (own + length) - OVERLAP
    low, high = -most, most
    if by_ego and situation.ego.route in _TURNS and contact.striker is not Striker.EGO and not _front(contact.ego):
        high = 0.5 * (own - length) - NOSE  # it runs into the ego's side
    for part, half, sign in ((contact.ego, 0.5 * own, -1.0), (contact.other, 0.5 * length, 1.0)):
        least, greatest = _corner(part, half, 0.5 * (own + length) - half, sign)
        low, high = max(low, least), min(high, greatest)
    if low >= high:
        return None
    if low > 0.0:
        return low, min(high, low + AT_CORNER)
    return (max(low, high - AT_CORNER), high) if high < 0.0 else (low, high)


def _corner(part: Part | None, half: float, other: float, sign: float) -> Level:
    """How far ahead the other is of whom a corner is touched, from and to.

    The middle of what lies side by side is then at that end of it.

    Args:
        part: What is touched.
        half: Half of its length [m].
        other: Half of the length of the one that touches it [m].
        sign: 1 if it is the other's, -1 if it is the ego's.
    """
    sides = SIDES_OF[part] if part is not None else ()
    ends = {"front": -1.0, "rear": 1.0}
    end = next((ends[side] for side in sides if side in ends), None)
    if end is None:
        return -100.0, 100.0
    far = sign * end * max(0.0, 2.0 * CORNER * half + other - half)  # from its middle
    return (far, 100.0) if sign * end > 0.0 else (-100.0, far)


def _front(part: Part | None) -> bool:
    return part is not None and "front" in SIDES_OF[part]


def parts_at_flank(actor: Actor) -> Iterator[str]:
    """The paths of what was said of a contact that is so since two touch side by side."""
    situation, one = actor.ledger.situation, actor.one
    contact = situation.contact
    if contact is None or actor.stand.meets is not Meets.ALONG or actor.stand.rolls:
        return
    if level_as_said(situation, one, actor.limits.length) is None:
        return
    by_ego = ego_comes_over(situation, one)
    yield from _facing(contact, one.starts.side or Side.LEFT)
    runs_in = by_ego and situation.ego.route in _TURNS and not _front(contact.ego)
    if runs_in and contact.other is Part.FRONT:
        yield "contact.other"
    striker = Striker.EGO if by_ego and not runs_in else Striker.OTHER
    if contact.striker is striker:
        yield "contact.striker"


def set_level(actor: Actor) -> None:
    """Let who comes over to the ego keep level with it, and come as far as to its side."""
    situation, one, numbers = actor.ledger.situation, actor.one, actor.numbers
    if level_as_said(situation, one, actor.limits.length) is None or not comes_over(situation, one):
        return
    if not numbers.is_said("SPEED"):
        numbers.narrow("SPEED", actor.along_speed, actor.along_speed)
    room = LANE - 0.5 * (actor.limits.width + actor.ego_limits.width)
    for name in ("DRIFT", "SWERVE"):
        numbers.narrow(name, *(room + far for far in INTO))
    actor.ledger.take(*parts_at_flank(actor))


def _facing(contact: Contact, side: Side) -> Iterator[str]:
    """The parts of a contact at the sides by which the ego and who is at a side of it face each other."""
    facing = Side.RIGHT if side is Side.LEFT else Side.LEFT
    if contact.ego is not None and str(side) in SIDES_OF[contact.ego]:
        yield "contact.ego"
    if contact.other is not None and str(facing) in SIDES_OF[contact.other]:
        yield "contact.other"


def _stands(deeds: tuple[Deed, ...]) -> bool:
    return bool(deeds) and deeds[0].act is Act.STAND
