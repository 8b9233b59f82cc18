"""Where it happens, by what was said: at a junction, a roundabout or on a road, and on which arm of it somebody is."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from chatscene.maps.ring_ways import ROUND
from chatscene.maps.road_spec import LaidRoad, is_laid, road_of
from chatscene.situations.check import RULED_BY, TURNS, arms_said
from chatscene.terms.actors import PROPS
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.backing import backs
from chatscene.terms.route import Equipment
from chatscene.terms.routing import BEGINS, ENDS
from chatscene.terms.scenario import Maneuver, Site
from chatscene.terms.situation import EGO, Other, Situation
from chatscene.terms.vocabulary import (
    ARMS_OF,
    HALTS,
    ROUNDABOUTS,
    Act,
    Breach,
    EgoRoute,
    Facing,
    Feature,
    Heads,
    RightOfWay,
    RoadKind,
    Side,
    Tempo,
    UserKind,
    Where,
    acts_of,
)
from chatscene.world.ego_route import EgoRoute as Route
from chatscene.world.places import lanes_beside, neighbourPath, ownLane

ONWARD = 100.0  # [m] past the end of a lane, in which somebody goes straight on
LANE = 3.5  # [m], a lane's width
CHANGED = 0.9  # of a lane's width aside of its lane, from where on somebody is in the next
NEXT_LANE = frozenset((Where.AHEAD_BESIDE, Where.BESIDE, Where.BEHIND_BESIDE))
AT_JUNCTION = (2.7, 5.3)  # [m] from a junction, on a crosswalk of the packaged maps
AT_CROSSWALKS = frozenset((Where.CROSSING, Where.EXIT_CROSSING))
ROUNDABOUT_PLACES = frozenset((Where.IN_ROUNDABOUT, Where.ROUNDABOUT_ENTRY))
WAYS = {Act.TURN_LEFT: Maneuver.LEFT_TURN, Act.TURN_RIGHT: Maneuver.RIGHT_TURN}
DRIVEWAYS = {Side.RIGHT: Site.DRIVEWAY, Side.LEFT: Site.DRIVEWAY_LEFT}
PACKAGED = ("town", "outskirts", "region")
DROPS = {Side.RIGHT: Site.PAST_LANE_DROP, Side.LEFT: Site.PAST_LANE_DROP_LEFT}
_COMES_OVER = acts_of(Heads.MERGES, Heads.BEFORE, Heads.OVER)
_STOPS = HALTS | acts_of(Tempo.SETS_OFF, Tempo.WAITS)
_TO_SIDE = {EgoRoute.LEFT_TURN: Side.LEFT, EgoRoute.RIGHT_TURN: Side.RIGHT}
GOES_OVER = _TO_SIDE | {
    EgoRoute.LANE_CHANGE_LEFT: Side.LEFT,
    EgoRoute.LANE_CHANGE_RIGHT: Side.RIGHT,
    EgoRoute.ENTER_DRIVEWAY: Side.RIGHT,
    EgoRoute.ENTER_DRIVEWAY_ACROSS: Side.LEFT,
    EgoRoute.PARK: Side.RIGHT,
}
"""The side on which the ego goes over the way of who goes on beside it."""


@dataclass(frozen=True, slots=True)
class Found:
    """Where it happens.

    Attributes:
        map: The map's name or file.
        query: What the program asks the map for, as `selectRoute` takes it.
        route: The first route that the map answers with.
        sides: For each of others whose side was left open, the one that was chosen.
        further: How many times as much road as usual leads up to what happens.
        sought: Whether the longest road was looked for, up to that which is needed.
    """

    map: str
    query: dict[str, Any]
    route: Route
    sides: dict[str, Side]
    further: float = 1.0
    sought: bool = False

    @property
    def laid(self) -> LaidRoad | None:
        """The road that was laid for it; None on any other map."""
        return road_of(self.map) if is_laid(self.map) else None


def at_junction(situation: Situation) -> bool:
    """Whether it happens at a junction."""
    road, others = situation.road, situation.others
    elsewhere = at_roundabout(situation) or beside_lane(situation) or road.kind is RoadKind.RAIL_CROSSING
    goes_on = situation.ego.route in (None, EgoRoute.STRAIGHT)
    return not elsewhere and (
        road.kind in (RoadKind.JUNCTION, *ARMS_OF)
        or road.arms is not None
        or road.side_road is not None
        or Feature.TURN_LANE in road.has
        or situation.ego.route in TURNS
        or (control_of(situation) is not None and not (at_free_crosswalk(situation) or at_signed_driveway(situation)))
        or any(one.starts.where.row.junction for one in others if one.starts.where not in ROUNDABOUT_PLACES)
        or any(deed.act is Act.GO_STRAIGHT for one in others for deed in one.does)
        or (goes_on and road.kind is None and any(_turns_across(one) for one in others))
    )


def _turns_across(one: Other) -> bool:
    """Whether somebody who comes the other way turns off over the ego's way: there is a junction, as roads have."""
    drives = one.kind.moves in (Moves.DRIVES, Moves.RIDES)
    return drives and one.starts.where is Where.ONCOMING and bool(one.does) and one.does[0].act is Act.TURN_LEFT


def turns_in(situation: Situation) -> Iterator[Side]:
    """To which sides somebody turns off the road where there is no junction, at a place that its way before tells.

    It has just passed the ego, or is ahead of it.
    """
    if at_junction(situation) or at_roundabout(situation) or beside_lane(situation):
        return
    for one in situation.others:
        for k, deed in enumerate(one.does):
            if turns_in_ahead(one, k) or hooks_off(one, k):
                yield Side.LEFT if deed.act is Act.TURN_LEFT else Side.RIGHT


def turns_out(one: Other) -> Maneuver | None:
    """To which side somebody turns who comes out of a driveway and was said to; None of who was not."""
    first = next((deed.act for deed in one.does if deed.act not in (Act.STAND, Act.SET_OFF, Act.GO_ALONG)), None)
    drives = one.starts.where is Where.DRIVEWAY and one.kind.moves in (Moves.DRIVES, Moves.RIDES)
    return WAYS.get(first) if drives and first is not None else None


def turns_round_from_opposite(found: Found, one: Other) -> bool:
    """Whether somebody turns round who stands at the kerb of the oncoming lane, as those who come that way do."""
    turns = any(deed.act is Act.U_TURN for deed in one.does) and one.starts.facing is not Facing.ALONG
    at_kerb = one.starts.where is Where.KERB and one.starts.side is Side.LEFT
    return turns and at_kerb and lanes_beside(found.route).get("left") is True


def shares_driveway(situation: Situation) -> bool:
    """Whether somebody is in a driveway into which another turns."""
    into = {*turns_in(situation)}
    return any(
        one.starts.where is Where.DRIVEWAY and (one.starts.side or Side.RIGHT) in into for one in situation.others
    )


def hooks_off(one: Other, k: int) -> bool:
    """Whether somebody turns off by its k-th deed just after it passed the ego, or passed it and slowed down."""
    return one.does[k].act in WAYS and one.does[k].when is None and passed_before(one, k) is not None


def passed_before(one: Other, k: int) -> int | None:
    """The number of the deed by which somebody passed the ego who does nothing until its k-th but to slow down."""
    for n in range(k - 1, -1, -1):
        deed = one.does[n]
        if deed.act is Act.OVERTAKE and deed.done_to == EGO:
            return n
        if deed.act not in (Act.BRAKE, Act.SLOW_DOWN) or deed.when is not None:
            return None
    return None


def turns_in_ahead(one: Other, k: int) -> bool:
    """Whether somebody in the ego's lane turns off by its k-th deed, before which it stands, or goes along."""
    first = one.starts.where is Where.AHEAD and one.starts.distance is None
    waits = all(before.act in (Act.STAND, Act.GO_ALONG, Act.SLOW_DOWN) for before in one.does[:k])
    return first and waits and one.does[k].act in WAYS and one.does[k].when is None


def is_marked(found: Found) -> bool:
    """Whether the ego's way leads over a crosswalk between junctions."""
    return found.query.get("site") == Site.CROSSWALK


def has_crosswalks(found: Found) -> bool:
    """Whether it leads over one before its junction, and over one behind it."""
    return Equipment.CROSSWALKS in found.query.get("has", ())


def ending_lane(situation: Situation) -> Side | None:
    """On which side of the ego's, or of the lane that it comes into, a lane is that was said to end; else None.

    It is that from which somebody comes over, or else the outermost.
    """
    ego = situation.ego
    if Feature.LANE_DROP not in situation.road.has:
        return None
    if any(deed.act in _COMES_OVER and deed.to is Side.RIGHT for deed in ego.does):
        return Side.LEFT
    over = (one for one in situation.others if one.starts.where in NEXT_LANE)
    sides = [one.starts.side for one in over if any(deed.act in _COMES_OVER for deed in one.does)]
    return (
        Side.LEFT
        if sides and all(side is Side.LEFT for side in sides) and ego.route is not EgoRoute.MERGE
        else Side.RIGHT
    )


def in_bus_lane(situation: Situation) -> bool:
    """Whether the ego drives in the lane for buses that the road has: a bus, or who may in an emergency."""
    drives = situation.ego.kind in (UserKind.BUS, UserKind.EMERGENCY_VEHICLE)
    return drives and Feature.BUS_LANE in situation.road.has and situation.road.ego_lane in (None, 1)


def in_cycle_lane(situation: Situation) -> bool:
    """Whether the ego rides in the lane for bicycles that the road has."""
    rides = situation.ego.kind in (UserKind.BICYCLE, UserKind.E_SCOOTER)
    return rides and Feature.CYCLE_LANE in situation.road.has


def lacks_at(found: Found, where: Where) -> str | None:
    """What is not on the map where somebody starts who is said to be at it; None if it is, or nothing was said."""
    match where:
        case Where.CROSSING | Where.EXIT_CROSSING if not (is_marked(found) or has_crosswalks(found)):
            return "crosswalk"
        case Where.BUS_BAY if found.query.get("site") != Site.BUS_BAY:
            return "bus bay"
        case Where.MEDIAN if "divided" not in found.query:
            return "median"
        case Where.ON_RAMP if found.query.get("site") not in (Site.ON_RAMP, Site.PAST_ON_RAMP, Site.WEAVING):
            return "on-ramp"
        case Where.DRIVEWAY if not (
            between_bays(found) or found.query.get("site") in (*DRIVEWAYS.values(), Site.RAIL_CROSSING)
        ):  # out of a bay, or along the rails
            return "driveway"
        case _:
            return None


def between_bays(found: Found) -> bool:
    """Whether it is a car park, where one stands across the way in a bay."""
    return Equipment.BAYS in found.query.get("has", ())


def leaves_by_ramp(situation: Situation, one: Other) -> bool:
    """Whether somebody who goes along with the ego leaves the road by a ramp."""
    along = one.starts.where in NEXT_LANE | {Where.AHEAD, Where.BEHIND}
    elsewhere = at_roundabout(situation) or at_junction(situation)
    return along and not elsewhere and any(deed.act is Act.EXIT for deed in one.does)


def beside_ramp(query: Mapping[str, Any]) -> int:
    """How many lanes of a ramp lie beside the road where a route is asked for."""
    return int(query.get("site") in (Site.PAST_ON_RAMP, Site.PAST_OFF_RAMP))


def at_free_crosswalk(situation: Situation) -> bool:
    """Whether it is a crosswalk that is said to have neither lights nor signs, and no junction."""
    marked = Feature.CROSSWALK in situation.road.has or any(
        one.starts.where is Where.CROSSING for one in situation.others
    )
    return marked and situation.road.control is RightOfWay.NONE


def at_signed_driveway(situation: Situation) -> bool:
    """Whether the sign that was said is that of a driveway, out of which somebody comes, and not of a junction."""
    places = {one.starts.where for one in situation.others}
    return situation.road.control is RightOfWay.PRIORITY and situation.road.kind is None and Where.DRIVEWAY in places


def stands_in_closed_lane(situation: Situation) -> bool:
    """Whether the ego stands, and nothing else, where roadworks close its lane."""
    stands = [deed.act for deed in situation.ego.does] == [Act.STAND]
    return stands and bool({Feature.ROADWORKS, Feature.CLOSED_LANE} & {*situation.road.has})


def beside_lane(situation: Situation) -> bool:
    """Whether the ego's way begins or ends beside its lane."""
    return situation.ego.route in BEGINS or situation.ego.route in ENDS or backs(situation)


def control_of(situation: Situation) -> RightOfWay | None:
    """What rules the junction: as was said, else what is there since somebody has it or breaks its rule."""
    if situation.map is not None and is_laid(situation.map) and only_side_signs(situation):
        return RightOfWay.NONE
    if situation.road.control is not None:
        return situation.road.control
    if situation.road.ego_light is not None:
        return RightOfWay.SIGNAL
    if only_others_stop(situation) and not any(deed.breaks is not None for deed in situation.ego.does):
        return RightOfWay.NONE
    broken = (deed.breaks for _, does in situation.everybody() for deed in does)
    return next((RULED_BY[breach] for breach in broken if breach is not None and breach in RULED_BY), None)


def only_others_stop(situation: Situation) -> bool:
    """Whether somebody from an arm does not stop at a sign that the ego, which goes on, is not said to have."""
    broken = (one for one in situation.others for deed in one.does if deed.breaks is Breach.STOP_SIGN)
    goes_on = not any(deed.act in _STOPS for deed in situation.ego.does)
    own = situation.road.control not in (None, RightOfWay.NONE, RightOfWay.PRIORITY)
    return goes_on and not own and any(one.starts.where is Where.ARM for one in broken)


def only_side_signs(situation: Situation) -> bool:
    """Whether the side roads alone have signs.

    So it is said, or somebody breaks theirs; or there is a stop sign, the ego goes straight on and does not stop, and
    somebody comes from a side road. A four-way junction with a stop sign has one on each arm.
    """
    road, ego = situation.road, situation.ego
    if road.control is RightOfWay.PRIORITY or only_others_stop(situation):
        return True
    goes_on = ego.route in (None, EgoRoute.STRAIGHT) and not any(one.act in _STOPS or one.breaks for one in ego.does)
    comes = any(one.starts.where is Where.ARM for one in situation.others)
    return road.control is RightOfWay.STOP_SIGN and road.kind is not RoadKind.FOUR_WAY and goes_on and comes


def at_roundabout(situation: Situation) -> bool:
    """Whether it happens at a roundabout."""
    road, ego = situation.road, situation.ego
    named = road.kind in ROUNDABOUTS or ego.route is EgoRoute.ROUNDABOUT or ego.exit is not None
    return named or any(one.starts.where in ROUNDABOUT_PLACES for one in situation.others)


def rides_at_edge(one: Other, route: EgoRoute | None = None) -> bool:
    """Whether it is on two wheels, and beside the ego at the edge of the ego's own lane.

    Who has no motor always is; who has one is where the ego turns to that side, out of the lane at the edge.

    Args:
        one: Who.
        route: The ego's.
    """
    if one.kind.moves is not Moves.RIDES:
        return False
    turned_to = route is not None and one.starts.side is not None and one.starts.side is _TO_SIDE.get(route)
    return turned_to or not one.kind.row.body.row.motorised


def arm_of(situation: Situation, one: Other, sides: dict[str, Side]) -> str:
    """From where traffic through the ego's junction comes; empty for who comes from none of its arms."""
    if at_roundabout(situation) or from_left(situation, one):
        return ""
    if one.starts.where is Where.ARM:
        return str(one.starts.side or sides[one.id])
    return "oncoming" if one.starts.where is Where.ONCOMING and at_junction(situation) else ""


def ring_arms(one: Other, sides: dict[str, Side]) -> tuple[str, ...]:
    """From where traffic in the ego's roundabout comes, best first; nothing for who is elsewhere."""
    match one.starts.where:
        case Where.IN_ROUNDABOUT:
            return (ROUND,)
        case Where.ROUNDABOUT_ENTRY:
            side = one.starts.side
            return (str(side),) if side is not None else ("right", "left", "oncoming")  # the ego comes past, or it does
        case Where.ARM:
            return (str(one.starts.side or sides[one.id]),)
        case Where.ONCOMING:
            return ("oncoming",)
        case _:
            return ()


def from_left(situation: Situation, one: Other) -> bool:
    """Whether somebody comes along the road that the ego drives onto out of a driveway, in the lane that it takes."""
    out = situation.ego.route is EgoRoute.LEAVE_DRIVEWAY or (backs(situation) and situation.ego.route in BEGINS)
    return out and one.starts.where is Where.ARM and one.starts.side in (Side.LEFT, None)


def says_way(one: Other) -> bool:
    """Whether it was said where somebody goes who comes through a junction."""
    return any(deed.act in (*WAYS, Act.ENTER, Act.GO_STRAIGHT) for deed in one.does)


def ways_of(situation: Situation, one: Other, arm: str) -> tuple[Maneuver, ...]:
    """What somebody who comes through a junction may do there: as was said, else straight on, best first.

    Where three arms were said, it need not be that: who goes on then turns, and at a fork who goes straight does.
    """
    first = way_of(situation, one, arm)
    at_fork = situation.road.kind is RoadKind.FORK and first is Maneuver.STRAIGHT
    if arms_said(situation.road) != 3 or (says_way(one) and not at_fork):
        return (first,)
    return tuple(dict.fromkeys((first, Maneuver.STRAIGHT, Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN)))


_COMES = {"left": -1, "right": 1, "oncoming": 2}
_EXITS = {EgoRoute.LEFT_TURN: 1, EgoRoute.TURN: 1, EgoRoute.RIGHT_TURN: -1}
_QUARTERS = {0: Maneuver.STRAIGHT, 1: Maneuver.LEFT_TURN, -1: Maneuver.RIGHT_TURN}


def way_of(situation: Situation, one: Other, arm: str) -> Maneuver:
    """What somebody who comes through a junction does there: as was said, or so that it comes onto the ego's road."""
    said = next((WAYS[deed.act] for deed in one.does if deed.act in WAYS), None)
    if said is None and any(deed.act is Act.ENTER for deed in one.does):
        route = situation.ego.route
        turn = (_EXITS.get(route, 0) if route is not None else 0) - _COMES[arm]  # in quarters of a circle to the left
        return _QUARTERS.get((turn + 1) % 4 - 1, Maneuver.STRAIGHT)
    return said or Maneuver.STRAIGHT


def wrong_way(one: Other) -> Other:
    """The same; who goes on wheels in the ego's lane, and faces it, comes the other way there."""
    goes = any(deed.act is not Act.STAND for deed in one.does) and one.kind.moves in (Moves.DRIVES, Moves.RIDES)
    if not goes or one.starts.where is not Where.AHEAD or one.starts.facing is not Facing.AGAINST:
        return one
    return replace(one, starts=replace(one.starts, where=Where.ONCOMING_IN_OUR_LANE))


def along_the_road(one: Other) -> Other:
    """The same; who goes along the road from beside it faces along, and not across, as a hedge or a wall does."""
    first = next((deed.act for deed in one.does if deed.act is not Act.STAND), None)
    beside = one.starts.where is Where.ROADSIDE and one.starts.facing is None
    limits = PROPS.get(one.kind.scenic)
    along = first is Act.GO_ALONG or (limits is not None and limits.length > limits.width)
    return replace(one, starts=replace(one.starts, facing=Facing.ALONG)) if beside and along else one


def filters(one: Other) -> bool:
    """Whether somebody is so narrow that it passes between two lanes of others."""
    return one.kind.moves is Moves.RIDES and one.kind.row.body.row.motorised


def between_lanes(side: str) -> float:
    """How far [m] to the left of the middle of the lane on a side of the ego's the line between the two is."""
    return 0.5 * LANE if side == Side.RIGHT else -0.5 * LANE


def lane_beside(side: str) -> str:
    """The lane on a side of the ego's, as a program says it: from behind the ego's start to beyond where it ends."""
    return f'onward(extended(neighbourPath(egoRoute, "{side}"), 60), {ONWARD:g})'


def changed_at(route: Route) -> float:
    """How far [m] along its way an ego that changes lanes is in the other lane."""
    own, metres = ownLane(route), range(round(route.eventAt), round(route.line.length))
    over = (at for at in metres if abs(own.project(*route.line.point_at(at))[1]) > CHANGED * LANE)
    return float(next(over, round(route.line.length)))


def merged_at(route: Route) -> float:
    """How far [m] along its way an ego that comes from a ramp is in the lane beside that."""
    beside, metres = neighbourPath(route, "left"), range(round(route.eventAt), round(route.line.length))
    near = (at for at in metres if abs(beside.project(*route.line.point_at(at))[1]) < (1.0 - CHANGED) * LANE)
    return float(next(near, round(route.line.length)))


def comes_across(found: Found) -> bool:
    """Whether who comes the other way on a road that was laid does so beyond a median, or beyond another lane."""
    laid, lane = found.laid, found.query.get("lane")
    return laid is not None and bool(laid.back) and (laid.median > 0.0 or (lane is not None and lane < laid.ahead))


def room_against(route: Route) -> float:
    """How far ahead [m] of the ego somebody can be at most who comes against it in the lane to its left.

    It is 0 where no lane lies there, as beside a lane that is kept apart from those who come the other way.
    """
    if "left" not in lanes_beside(route):
        return 0.0
    return ownLane(route).project(*neighbourPath(route, "left").point_at(0.0))[0]
