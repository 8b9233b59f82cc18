"""Who hides somebody from a lane of its own: in a queue against the ego, in the next lane, or waiting at the junction.

It stands there, comes to a stand there, or drives by; whom it hides begins in its shadow.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from chatscene.build.asked import ROOM, Meets, Stand, passes_with, stands_first
from chatscene.build.chain import meeting_of
from chatscene.build.deeds import OWN, STILL
from chatscene.build.hiding import hidden_with
from chatscene.build.naming import name_of
from chatscene.build.place import LANE, beside_lane, lane_beside
from chatscene.errors import NotBuilt, NothingBuilds
from chatscene.terms.actors import LIMITS
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.amount import Length
from chatscene.terms.backing import backs
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import PLAIN, SLOWS, STOPS, WAITING, Act, EgoRoute, Role, Side, Where

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

GAP = 2.6  # [m] along the road between whom it hides and its end
INTO_JUNCTION, OVER_LINE = (
    7.0,
    3.0,
)  # [m] behind the entry of a junction of the nose of who waits to turn off there, and of who stops
AT_EDGE = 0.8, 1.2  # [m] outside the lanes, from and to, that somebody begins whom traffic against the ego hides
IN_SHADOW = 0.0, 0.4  # [m] beyond the side of who hides it, seen from the ego, that somebody begins
AT_LINE = 1.0  # [m] before that who lets others by there stands
STOOD = 1.0  # [s] that it has stood when whom it hides comes out
BEFORE_MET = 5.0  # [s] before somebody at a junction is met, when who hides it there has come to a stand
EASES = (0.35, 0.5)  # of its brakes, from and to, that who was not said to brake hard stops with
DRIVEN_BY = 1.0  # [s] before they meet that who hides somebody has gone by, if it was not said how near the ego is then
_LEFT_BEHIND = {EgoRoute.LANE_CHANGE_LEFT: Side.RIGHT, EgoRoute.LANE_CHANGE_RIGHT: Side.LEFT}
"""On which side of an ego that changes lanes the lane is that it leaves."""
_OUTSIDE = re.compile(r'besideRoad\((.*), "(left|right)", \$X\)')
_NEXT = frozenset((Where.AHEAD_BESIDE, Where.BESIDE))
_FROM_OUTSIDE = frozenset((Where.ROADSIDE, Where.CROSSING, Where.DRIVEWAY, Where.KERB))


@dataclass(frozen=True, slots=True, kw_only=True)
class Screen:
    """Where and how somebody hides another. In texts ``$NAME`` is a parameter of who hides.

    Attributes:
        way: The line it is on.
        at: Arc length [m] on that, of the first of it.
        farther: Arc length [m] of the first of those that stand behind whom it hides; empty if all stand before.
        sign: Of who stands farther from whom it hides, along the line.
        phases: What it does; nothing if it only stands.
    """

    way: str
    at: str
    farther: str = ""
    sign: str = "+"
    phases: tuple[str, ...] = ()


def from_its_lane(situation: Situation, one: Other, hidden: Other) -> bool:
    """Whether somebody hides another from a lane, and not from beside the road."""
    if beside_lane(situation) or backs(situation):
        return False  # of whom it is seen from elsewhere
    drives = one.kind.moves is Moves.DRIVES and one.role is not Role.ADVERSARY
    in_lane = one.starts.where in _NEXT | {Where.ONCOMING} and hidden.starts.where in _FROM_OUTSIDE
    at_line = one.starts.where in _NEXT and hidden.starts.where is Where.ARM
    at_line = at_line and (None in (one.starts.side, hidden.starts.side) or one.starts.side is hidden.starts.side)
    waits = one.starts.where is hidden.starts.where is Where.ONCOMING and not passes_with(one, hidden)
    there = waits or in_lane or at_line or _waits_to_turn(one, hidden) or drives_by(one, hidden)
    return hidden.hidden_by == one.id and drives and (there or _in_the_lane_left(situation, one, hidden))


def _waits_to_turn(one: Other, hidden: Other) -> bool:
    """Whether somebody beside the ego, as who is to turn left there, hides another that turns off from opposite."""
    beside = one.starts.where in _NEXT and one.starts.side in (None, Side.LEFT)
    turns = any(deed.act is Act.TURN_LEFT for deed in hidden.does)
    return beside and turns and hidden.starts.where is Where.ONCOMING


def drives_by(one: Other, hidden: Other) -> bool:
    """Whether somebody who comes the other way hides another, which comes from the left, until it has gone by."""
    goes = one.starts.where is Where.ONCOMING and not stands_first(one) and all(deed.act in PLAIN for deed in one.does)
    return goes and hidden.starts.where is Where.ARM and hidden.starts.side in (None, Side.LEFT)


def _in_the_lane_left(situation: Situation, one: Other, hidden: Other) -> bool:
    """Whether somebody stops in the lane that the ego leaves, and hides who crosses from beyond that lane."""
    route = situation.ego.route
    side = None if route is None else _LEFT_BEHIND.get(route)
    from_beyond = side is not None and hidden.starts.side in (None, side)
    return from_beyond and one.starts.where is Where.AHEAD and hidden.starts.where in _FROM_OUTSIDE


def side_hidden(situation: Situation, one: Other) -> Side | None:
    """The side from which somebody comes who is hidden from a lane; None if any."""
    by = situation[one.hidden_by] if one.hidden_by is not None else None
    if by is None or not from_its_lane(situation, by, one) or not one.starts.where.row.sided:
        return None
    if by.starts.where is Where.AHEAD and situation.ego.route is not None:
        return _LEFT_BEHIND.get(situation.ego.route)
    return Side.LEFT if by.starts.where is Where.ONCOMING else by.starts.side


def screen_of(actor: Actor, hidden: Actor) -> Screen:
    """Where and how somebody hides another from its lane; whom it hides begins in its shadow.

    Raises:
        NotBuilt: It cannot be between the ego and whom it hides.
    """
    if hidden.stand.meets is Meets.THROUGH:
        screen = _at_junction(actor, hidden)
    elif hidden.stand.meets is Meets.ACROSS:
        screen = _beside_lane(actor, hidden)
    else:
        raise NothingBuilds(
            f"cannot be built yet: {actor.one.id} hiding a road user that starts {hidden.one.starts.where}"
        )
    actor.ledger.take(*(f"others.{name}.hidden_by" for name in hidden_with(actor, hidden.one)))
    actor.ledger.take(*(f"{actor.path}.does.{k}.act" for k in range(len(actor.deeds))))
    return screen


def shadowed(stand: Stand, by: Other, width: float) -> Stand:
    """The same, of somebody who is to cross: it begins where who hides it from a lane is between it and the ego."""
    if by.starts.where is Where.ONCOMING and not stands_first(by):
        return stand  # which drives where it would stand
    aside = LANE + 0.5 * width
    found = _OUTSIDE.match(stand.point)
    if found is None:
        return stand
    off = f"{aside:.3g} + $X" if found[2] == Side.LEFT else f"-{aside:.3g} - $X"
    return replace(stand, point=f"pointOn({found[1]}, {off})")


def _refused(actor: Actor, hidden: Actor, why: str) -> NotBuilt:
    return NotBuilt(f"cannot be built yet: {actor.path} hiding {hidden.one.id}: {why}")


def _acts(actor: Actor) -> frozenset[Act]:
    return frozenset(deed.act for deed in actor.deeds)


def _beside_lane(actor: Actor, hidden: Actor) -> Screen:
    """In the next lane, or in that of those who come against the ego."""
    against = actor.one.starts.where is Where.ONCOMING
    left = actor.one.starts.where is Where.AHEAD  # in the lane that the ego leaves
    side = Side.LEFT if against else hidden.one.starts.side if left else actor.one.starts.side
    if hidden.one.starts.side is not side:
        raise _refused(actor, hidden, f"it is not on the {hidden.one.starts.side}")
    way = 'neighbourPath(egoRoute, "left")' if against else OWN if left else lane_beside(str(side))
    one, level = name_of(actor.one.id), f"level{name_of(hidden.one.id)}"
    there, sign = f"levelOn(way{one}, egoRoute, {level})", "+" if against else "-"
    away = GAP + 0.5 * actor.limits.length
    at, farther = f"{there} {sign} {away:.3g}", f"{there} {'-' if against else '+'} {away:.3g}"
    acts, seconds = _acts(actor), hidden.ego.seconds(level)
    lead = hidden.filled(
        f"({meeting_of(hidden).metres:.2f} / $SPEED + $OFFSET)"
    )  # before the ego is there it comes out
    if acts <= WAITING:
        return Screen(way=way, at=at, farther=farther, sign=sign)
    if acts <= WAITING | SLOWS | PLAIN and acts & STOPS:
        _come_in_time(actor, hidden)
        return _comes_to_stand(actor, Screen(way=way, at=at, sign=sign), f"{seconds} - {lead} - {STOOD:g}")
    if acts <= PLAIN and against:
        aside = hidden.numbers.middle("X") + 1.5 * LANE
        by = f"{(1.0 - LANE / aside) * actor.ego_speed:.3g} * {lead}"  # on the line of sight as that comes out
        start = f"backFrom({there} + {by}, $SPEED * maximum(0, {seconds} - {lead}))"
        return Screen(way=way, at=start, phases=("DrivePath({p}, $SPEED)",))
    raise _refused(actor, hidden, "say that it stands or stops" + (", or goes along" if against else ""))


def _at_junction(actor: Actor, hidden: Actor) -> Screen:
    """At the junction: opposite the ego, beside who goes on there, or beside the ego before an arm."""
    one, other, acts = name_of(actor.one.id), name_of(hidden.one.id), _acts(actor)
    half = 0.5 * actor.limits.length
    if hidden.one.starts.where is Where.ONCOMING and actor.one.starts.where is Where.ONCOMING:
        way = 'wayOf(trafficFrom(egoRoute, "oncoming"), "straight", "inner")'
        lets = acts & (STOPS | {Act.YIELD})
        at = f"way{one}.entry " + f"- {half - (OVER_LINE if lets else INTO_JUNCTION):.3g}"
    elif drives_by(actor.one, hidden.one):
        return _goes_by(actor, hidden)
    elif _waits_to_turn(actor.one, hidden.one):
        way = lane_beside(Side.LEFT)
        at = f"levelOn(way{one}, egoRoute, egoRoute.eventAt) - {half - INTO_JUNCTION:.3g}"
    elif actor.one.starts.where in _NEXT and actor.one.starts.side is hidden.one.starts.side:
        way = lane_beside(str(actor.one.starts.side))
        at = f"levelOn(way{one}, egoRoute, egoRoute.eventAt) - {half + AT_LINE:.3g}"
    else:
        raise _refused(actor, hidden, "it is not between the ego and the arm")
    screen = Screen(way=way, at=at, sign="-")
    if acts <= WAITING:
        return screen
    if acts <= WAITING | STOPS | PLAIN and acts & STOPS:
        return _comes_to_stand(actor, screen, f"{actor.ego.seconds(f'egoMeet{other}')} - {BEFORE_MET:g}")
    raise _refused(actor, hidden, "say that it stands or stops")


def _goes_by(actor: Actor, hidden: Actor) -> Screen:
    """It comes the other way, and its tail leaves the line of sight to who comes from the left as the ego is near.

    The two come to where they meet at steady speeds, so that the line of sight crosses its lane at one place.
    """
    one, other = name_of(actor.one.id), name_of(hidden.one.id)
    near = next((deed.when.ego_within for deed in hidden.said if deed.when is not None and deed.when.ego_within), None)
    late = near.most / actor.ego_speed if isinstance(near, Length) else DRIVEN_BY if near is None else near.most
    before = hidden.filled(f"{LANE * actor.ego_speed:.4g} / $SPEED")
    there = f"levelOn(way{one}, egoRoute, egoMeet{other} - {before}) + {0.5 * actor.limits.length:.3g}"
    start = f"backFrom({there}, $SPEED * maximum(0, {actor.ego.seconds(f'egoMeet{other}')} - {late:.3g}))"
    return Screen(way="opposite(egoRoute)", at=start, phases=("DrivePath({p}, $SPEED)",))


def _come_in_time(actor: Actor, hidden: Actor) -> None:
    """Let somebody be so slow that it has stopped before the other comes out, however near the ego begins to that.

    The other comes out in the later half of its times, or there would be none to come driving in.
    """
    soonest, latest, *_ = hidden.numbers.range_of("OFFSET")
    if not hidden.numbers.is_said("OFFSET"):
        hidden.numbers.narrow("OFFSET", soonest, 0.5 * (soonest + latest))
    met = meeting_of(hidden).metres / hidden.numbers.middle("SPEED") + hidden.numbers.range_of("OFFSET")[1]
    left = hidden.ego.time_at(hidden.numbers.range_of("Y")[0]) - met - STOOD
    stops = left * EASES[1] * LIMITS[actor.one.kind.scenic].brake
    high = actor.numbers.range_of("SPEED")[1]
    if not actor.numbers.is_said("SPEED") and 0.0 < stops < high:
        actor.numbers.narrow("SPEED", 0.8 * stops, stops)


def _comes_to_stand(actor: Actor, screen: Screen, when: str) -> Screen:
    """It comes driving, and has stopped there at a time [s]."""
    numbers = actor.numbers
    braking = [deed for deed in actor.deeds if deed.act in STOPS]
    said = next((k for k, deed in enumerate(actor.deeds) if deed in braking and deed.acceleration is not None), None)
    if said is None:
        numbers.narrow("BRAKE", *EASES)
    else:
        amount = actor.deeds[said].acceleration
        assert amount is not None
        numbers.bind("BRAKE", amount, f"{actor.path}.does.{said}.acceleration")
    hard = LIMITS[actor.one.kind.scenic].brake
    brakes, takes = f"$SPEED * $SPEED / ({2 * hard:g} * $BRAKE)", f"$SPEED / ({hard:g} * $BRAKE)"
    start = f"backFrom({screen.at}, {brakes} + $SPEED * maximum(0, {when} - {takes}))"
    left = f"distanceLeft({{p}}, self, {screen.at})"
    return replace(
        screen,
        at=start,
        phases=(
            f"DrivePath({{p}}, $SPEED) until {left} < brakingDistance(self) / $BRAKE + 0.5",
            f"BrakeOnPath({{p}}, $BRAKE) until {STILL}",
            "Halt()",
        ),
    )


def stands_at(actor: Actor, screen: Screen, n: int) -> tuple[str, str]:
    """Where the n-th of it stands, and which way it faces: before whom it hides, and behind in turn."""
    way, apart = f"way{name_of(actor.one.id)}", actor.limits.length + ROOM
    behind = n % 2 == 1 and bool(screen.farther)
    k = n // 2 if screen.farther else n
    sign = screen.sign if not behind else ("-" if screen.sign == "+" else "+")
    at = (screen.farther if behind else screen.at) + (f" {sign} {k * apart:.3g}" if k else "")
    return actor.filled(f"pointOn({way}, {at})"), actor.filled(f"directionOn({way}, {at})")
