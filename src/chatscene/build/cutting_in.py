"""Who comes into the ego's lane from beside it: first ahead of its nose, then over, at a speed that can be avoided."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets, stands_first
from chatscene.build.contact import misses, touches
from chatscene.build.over_lanes import lane_after
from chatscene.build.sideways import seconds_over
from chatscene.build.timing import Body
from chatscene.build.towards import done_to
from chatscene.errors import NotBuilt
from chatscene.situations.phrases import one_of
from chatscene.terms.situation import EGO, Other, Situation
from chatscene.terms.vocabulary import CHANGES, COMES_OVER, Act, Heads, Part, Role, Striker, Where, acts_of

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

LEAVES = (1.0, 6.0)  # [m], from and to, that somebody leaves who comes in before the ego
AVOIDED = (
    0.35,
    12.0,
)  # [s], [m/s²]: a lane keeping system avoids whom it reaches after 0.35 s + closing / 12 m/s² (R157)
KEEPS = 0.75  # of the ego's speed, the least of who comes in before it
WITHIN = 1.0  # [m] of the room that it is to have
TOP = 40.0  # [m/s] that it wants at most
PACES = 0.8  # [1/s] by which who keeps a place beside another is faster, for each metre that it lacks
FARTHEST = 240.0  # [m] that an ego of which no speed was said drives at most while somebody gets before it
SLOWER = 1.0  # [m/s] than the ego, from which on the ego comes up to somebody
_STEP, _LONGEST = 0.1, 60.0  # [s], followed in such and for as long
AHEAD = 0.8  # of how far the two are apart where they no more are level, that somebody is ahead at most who is beside
NEAR_BEHIND = 4.0  # [m] that somebody is behind the ego at most who is to get before it
BESIDE_EGO = frozenset((Where.BESIDE, Where.BEHIND_BESIDE))
_LEVEL = BESIDE_EGO | {Where.ON_RAMP}


def comes_before(actor: Actor, k: int) -> bool:
    """Whether somebody who is not ahead yet comes in before the ego in its k-th deed, and is not to strike its side."""
    drives = not (actor.stand.rolls or actor.ego.stands) and actor.stand.meets is Meets.ALONG
    return drives and _is_to(actor.ledger.situation, actor.one, k)


def _is_to(situation: Situation, one: Other, k: int) -> bool:
    """The same, as far as what was said tells it."""
    deed = one.does[k]
    over = deed.act in COMES_OVER and (deed.act is not Act.LANE_CHANGE or lane_after(one, one.does, k) == 0)
    first = not any(before.act in COMES_OVER | acts_of(Heads.BY, Heads.OUT) for before in one.does[:k])
    meets = one.role is Role.ADVERSARY and done_to(deed) == EGO and situation.ego.route not in CHANGES
    there = one.starts.where in _LEVEL and not stands_first(one)
    return over and first and meets and there and not _strikes_side(situation, one)


def _strikes_side(situation: Situation, one: Other) -> bool:
    """Whether somebody is to touch the ego, and not in the way of who is before it."""
    contact = situation.contact
    if contact is None or not touches(situation, one):
        return False
    runs_into = contact.striker is Striker.EGO and contact.ego is None and contact.other is None
    return not runs_into and contact.ego is not Part.FRONT and contact.other is not Part.REAR


def begins_beside(situation: Situation, one: Other, middles: float) -> tuple[float, float] | None:
    """How far [m] ahead of the ego, or behind it, somebody in the next lane begins who is to come in before it.

    Args:
        situation: What was said.
        one: Who.
        middles: How far [m] its middle and the ego's are apart where they touch, one behind the other.

    Returns:
        From and to, so near as its place lets it be; None of who does not, or is elsewhere.
    """
    if not any(_is_to(situation, one, k) for k in range(len(one.does))):
        return None
    near = {Where.BESIDE: (0.0, AHEAD * middles), Where.BEHIND_BESIDE: (middles, middles + NEAR_BEHIND)}
    return near.get(one.starts.where)


def set_speed(actor: Actor, k: int) -> None:
    """Let who comes in before the ego, and does nothing then, be as fast, or so much slower as can just be avoided.

    Raises:
        NotBuilt: It is too slow to get before an ego of which no speed was said.
    """
    if not comes_before(actor, k):
        return
    most = _most_road(actor)
    if seconds_to_get_before(actor, k) * actor.ego_speed >= most and actor.one.starts.where is not Where.ON_RAMP:
        raise NotBuilt(_is_too_slow(actor, k, most))
    free = actor.deeds[k].speed is None and not actor.numbers.is_said("SPEED")
    if free and k == len(actor.deeds) - 1 and not misses(actor.ledger.situation, actor.one):
        delay, hard = AVOIDED
        slower = 0.5 * (math.sqrt((hard * delay) ** 2 + 2.0 * hard * sum(LEAVES)) - hard * delay)
        ego, most = actor.ego_speed, actor.along_speed
        actor.numbers.narrow("SPEED", min(max(ego - slower, KEEPS * ego), most), most)


def _most_road(actor: Actor) -> float:
    """How far [m] the ego may drive at most until somebody is before it: as the road is long that was looked for."""
    if actor.ledger.situation.ego.speed is None:
        return FARTHEST  # a slower one may do
    return actor.found.route.line.length if actor.found.sought else _LONGEST * actor.ego_speed


def _is_too_slow(actor: Actor, k: int, most: float) -> str:
    """What is told of somebody who does not get before the ego: by its speed or its kind, and what could be said."""
    begins, ego, seconds = 3.6 * _first_speed(actor), 3.6 * actor.ego_speed, seconds_to_get_before(actor, k)
    holds = f"{one_of(actor.one.kind)} with at most {3.6 * Body(actor.limits, actor.walks).fastest:.0f} km/h"
    who = f"{one_of(actor.one.kind)} at {begins:.0f} km/h" if actor.numbers.is_said("SPEED") else holds
    near = f"; say {Where.AHEAD_BESIDE}, or a slower ego" if actor.one.starts.where in BESIDE_EGO else ""
    return (
        f"{actor.path}.does.{k}: {who} cannot get ahead of an ego at {ego:.0f} km/h from {actor.one.starts.where}"
        f"{f' within {most:.0f} m' if seconds < _LONGEST else ''}{near}"
    )


def _first_speed(actor: Actor) -> float:
    """The speed [m/s] at which somebody goes until it gets before the ego: that which was said, or the ego's."""
    said = actor.numbers.is_said("SPEED")
    return min(actor.along_speed, actor.numbers.range_of("SPEED")[0]) if said else actor.along_speed


def slows_for_it(actor: Actor, k: int) -> bool:
    """Whether somebody level with the ego, or behind it, comes in before it at less than the ego's speed.

    It goes with the ego at first, or it would never be before it.
    """
    said, start = actor.deeds[k].speed, actor.one.starts
    if said is None or start.speed is not None or start.where not in BESIDE_EGO:
        return False
    return said.high < actor.ego_speed and _is_to(actor.ledger.situation, actor.one, k)


def room_to_avoid(slower: float) -> float:
    """How near [m] somebody may be, nose to tail, who is so much slower [m/s] and can still be avoided."""
    delay, hard = AVOIDED
    return slower * (delay + slower / hard)


def leaves(actor: Actor) -> tuple[float, float]:
    """How much room [m] somebody leaves, from and to: more by what it takes to avoid who cannot be as fast."""
    more = room_to_avoid(actor.ego_speed - actor.along_speed) + _between(actor)
    return LEAVES[0] + more, LEAVES[1] + more


def _between(actor: Actor) -> float:
    """How much room [m] another needs who comes in from the other side at the same time; 0 where none does."""
    situation, start = actor.ledger.situation, actor.one.starts
    waits = (deed.when.during for deed in actor.one.does if deed.act in COMES_OVER and deed.when is not None)
    named = [name for name in waits if name is not None and not name.startswith(EGO)]
    others = [situation[name.partition(".")[0]] for name in named if situation.deed(name).act in COMES_OVER]
    beside = [one for one in others if one.starts.where in BESIDE_EGO and one.starts.side is not start.side]
    return max((LEAVES[1] + one.kind.row.body.row.limits.length for one in beside), default=0.0)


def gets_before(actor: Actor, k: int, way: str, room: str) -> str:
    """The phase in which somebody gets so far ahead that it leaves a room once it is over the line.

    Args:
        actor: Who.
        k: The number of its deed.
        way: The line it goes along.
        room: Between the middles of the two then [m].
    """
    slower = f"{seconds_over(actor, k)[0]} * max(0, {actor.ego_speed:.4g} - ${actor.speed_in(k)})"
    least = KEEPS * actor.ego_speed
    there = f"abs(headway(egoRoute, ego, self) - ({room} + {slower})) < {WITHIN:g}"
    return f"PaceOnPath({way}, ego, {room} + {slower}, {TOP:g}, {least:.4g}) until {there}"


def seconds_to_get_before(actor: Actor, k: int) -> float:
    """How long [s] it takes at most to be as far ahead of the ego as it must be; a minute of who never is."""
    body, ego = Body(actor.limits, actor.walks), actor.ego_speed
    if actor.one.starts.where in BESIDE_EGO and _first_speed(actor) < ego - SLOWER and actor.numbers.is_said("SPEED"):
        return _LONGEST  # it was said to keep to a speed at which it falls back
    low, high, *_ = actor.numbers.range_of("Y")
    least = actor.numbers.range_of(actor.speed_in(k))[0]
    middles = 0.5 * (actor.limits.length + actor.ego_limits.length)
    left = (
        middles
        + leaves(actor)[1]
        + seconds_over(actor, k)[1] * max(0.0, ego - least)
        + (high if actor.stand.behind else -low)
    )
    seconds, speed = 0.0, _first_speed(actor)
    left += actor.numbers.range_of("STEADY")[1] * (ego - speed)
    while left > WITHIN and seconds < _LONGEST:
        speed = body.after(speed, min(TOP, ego + PACES * left))
        left, seconds = left - (speed - ego) * _STEP, seconds + _STEP
    return seconds
