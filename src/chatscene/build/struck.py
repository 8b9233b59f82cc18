"""Who runs into the rear of the ego: after what the ego does, from how far behind it, and how fast.

The ego stands, comes to a stand, slows down or sets off as was said, and who is behind it fails to see that: it follows
the ego until that is as slow as it is itself when the two touch, and goes on.
"""

from __future__ import annotations

from enum import Enum
from typing import TYPE_CHECKING

from chatscene.build.contact import strikes_from_behind
from chatscene.situations.check import TURNS
from chatscene.terms.backing import backs
from chatscene.terms.situation import Deed, Other, Situation
from chatscene.terms.vocabulary import (
    CHANGES,
    PLAIN,
    Act,
    EgoRoute,
    Heads,
    Role,
    Tempo,
    Where,
    acts_of,
)

if TYPE_CHECKING:
    from chatscene.build.actor import Actor
    from chatscene.build.asked import Asked

STANDS_FOR = 4.0  # [s] that an ego stands that is struck as it sets off
SETS_OFF_AT, LEAST = 0.4, 0.7  # of the speed of who runs into it, and [m/s] at least, at which an ego sets off then
SOON = (0.9, 1.5)  # [s] later than it sets off, from and to, somebody would be where it stood
COMES_FOR = (5.0, 8.0)  # [s] in which somebody comes up to an ego that stands, from and to
FOLLOWS = (0.6, 1.8)  # [s] that the ego stands, from and to, when somebody who followed it is there
EASES = 3.0  # [m/s²] about with which it has come to a stand
CLOSEST, FARTHEST = 1.5, 1.3  # [m] at least, and [s] at most at the ego's speed, behind that
SLOWER = 0.75  # of the ego's speed: who is faster comes up to it, and does not follow it
SLOWED = 4.0  # [m/s]: who is slower never comes up to an ego that only slows down
_AT_PEDALS = acts_of(Tempo.STANDS, Tempo.SETS_OFF, Tempo.HALTS, Tempo.BRAKES, Tempo.SLOWS, Tempo.WAITS, Heads.ALONG)
_BEHIND = frozenset((Where.BEHIND, Where.BEHIND_BESIDE))
_ELSEWHERE = CHANGES | {EgoRoute.BYPASS, EgoRoute.OVERTAKE, EgoRoute.LEAVE_DRIVEWAY, EgoRoute.LEAVE_PARKING}


class Does(Enum):
    """What the ego does when somebody runs into its rear."""

    STANDS = "stands"
    SETS_OFF = "sets off"
    STOPS = "stops"
    SLOWS = "slows"


SHARES = {Does.STANDS: (0.25, 0.6), Does.SETS_OFF: (0.3, 0.45), Does.STOPS: (0.25, 0.6), Does.SLOWS: (0.5, 0.75)}
"""How fast somebody then runs into it, from and to, as shares of what the ego drives at where nothing holds it."""


def runs_into(situation: Situation, one: Other) -> Does | None:
    """What the ego does, as was said, when somebody who only drives on behind it runs into its rear; None else."""
    start, ego = one.starts, situation.ego
    only = all(deed.act in PLAIN and deed.manner is None and _is_plain(deed) for deed in one.does)
    free = start.distance is None and start.speed is None and one.count == 1 and one.kind.row.body.row.motorised
    if not (only and free and one.role is Role.ADVERSARY and strikes_from_behind(situation, one)):
        return None
    if backs(situation) or ego.route in _ELSEWHERE or not ego.does:
        return None
    acts = [deed.act for deed in ego.does]
    alone = all(_is_plain(deed) and situation.answered(deed) is None for deed in ego.does)
    if not (alone and _AT_PEDALS.issuperset(acts)):
        return None
    if acts[0] in acts_of(Tempo.STANDS, Tempo.SETS_OFF):
        later = set(acts[1:]) - acts_of(Heads.ALONG, Tempo.SETS_OFF)
        sets_off = not acts_of(Tempo.SETS_OFF, Heads.ALONG).isdisjoint(acts)
        return None if later - {Act.STAND} else Does.SETS_OFF if sets_off else Does.STANDS
    if Act.STOP in acts or gives_way(situation):
        return Does.STOPS
    return Does.SLOWS if not acts_of(Tempo.BRAKES, Tempo.SLOWS).isdisjoint(acts) else None


def _is_plain(deed: Deed) -> bool:
    """Whether nothing was said of when a deed begins, how long it lasts or how far it leads."""
    return deed.when is None and deed.time is None and deed.distance is None


def gives_way(situation: Situation) -> bool:
    """Whether the ego stops to give way: to nobody who is there, as all others are behind it, or struck as it does."""
    yields = any(deed.act is Act.YIELD and deed.whom is None for deed in situation.ego.does)
    struck = any(strikes_from_behind(situation, one) for one in situation.others)
    return yields and (struck or all(one.starts.where in _BEHIND for one in situation.others))


def slows_turning(situation: Situation) -> bool:
    """Whether somebody runs into an ego that slows down as it turns, and not before."""
    return situation.ego.route in TURNS and any(runs_into(situation, one) is Does.SLOWS for one in situation.others)


def creeps_at(situation: Situation, ego_speed: float) -> tuple[float, str] | None:
    """How fast [m/s] an ego sets off that somebody then runs into, and who does; None of any other.

    Args:
        situation: What was said.
        ego_speed: What the ego wants [m/s].
    """
    for one in situation.others:
        if runs_into(situation, one) is Does.SETS_OFF:
            said = next((deed.speed for deed in one.does if deed.speed is not None), None)
            usual = 0.5 * sum(SHARES[Does.SETS_OFF]) * ego_speed
            speed = usual if said is None else said.beside(ego_speed).near(usual)
            return max(LEAST, SETS_OFF_AT * speed), one.id
    return None


def behind_by(asked: Asked) -> tuple[float, float] | None:
    """How far [m] behind the ego, nose to tail, somebody is who runs into it after what it does; None of others."""
    does = runs_into(asked.situation, asked.one)
    speed, ego = asked.numbers.middle("SPEED"), asked.ego.speed
    match does:
        case Does.STANDS if asked.ego.stands:
            low, high = (seconds * speed for seconds in COMES_FOR)
        case Does.SETS_OFF:
            low, high = ((asked.ego.held or STANDS_FOR) * speed + seconds * speed for seconds in SOON)
        case Does.STOPS | Does.SLOWS if _follows(does, speed, ego):
            gains = CLOSEST + 0.5 * speed**2 / EASES  # while the ego loses the speed that it has itself
            low, high = (min(gains + seconds * speed, FARTHEST * ego) for seconds in FOLLOWS)
        case _:
            return None
    return max(low, CLOSEST), max(high, CLOSEST + 1.0)


def strikes(actor: Actor) -> tuple[str, ...]:
    """The phases of who follows the ego until that is slow, and then goes on into its rear; none of others."""
    does = runs_into(actor.ledger.situation, actor.one)
    if does not in (Does.STOPS, Does.SLOWS) or not _follows(does, actor.numbers.middle("SPEED"), actor.ego_speed):
        return ()
    slow = "ego.pose[3] < $SPEED"
    stops = sum(deed.act is Act.STOP for deed in actor.ledger.situation.ego.does)
    if stops > 1:  # it is struck at the last
        slow += f" and progressOn(egoRoute, ego)[0] > {1.0 - 0.5 / stops:.3g} * egoRoute.eventAt"
    return f"PaceOnPath({{p}}, ego, -$Y, 40) until {slow}", "DrivePath({p}, $SPEED)"


def _follows(does: Does, speed: float, ego: float) -> bool:
    """Whether somebody at a speed [m/s] is slower than the ego drives, and faster than that comes to be."""
    return speed < SLOWER * ego and (does is Does.STOPS or speed > SLOWED)
