"""Where things are, relative to the ego's route: the words in which snippets place and time an adversary.

Functions that may be given a sampled value (an ``OPT_`` parameter) are marked so that Scenic defers them. Points
are Scenic vectors; directions are Scenic headings [rad, 0 = +y, counter-clockwise], because they go straight into
specifiers.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
import shapely

from chatscene.errors import MapError
from chatscene.maps.crossings import CrossingPath, conflicting_paths, passing_path
from chatscene.maps.kept import kept_with_network
from chatscene.maps.lane_runs import centre_line, lane_runs
from chatscene.maps.neighbours import oncoming_line, opposes, section_beside
from chatscene.maps.ramp_lines import off_ramp_line
from chatscene.maps.ring_ways import line_beside, ring_ways
from chatscene.maps.ways_off import way_off, ways_out
from chatscene.terms.actors import LIMITS, kind_of
from chatscene.terms.nouns import with_article
from chatscene.terms.pace import NOMINAL, Pace
from chatscene.terms.polyline import Polyline
from chatscene.terms.profile import Timetable, allowed_speeds
from chatscene.terms.scenario import Maneuver
from chatscene.world.control import Tracker
from chatscene.world.deferring import deferred, reject, vector
from chatscene.world.ego_route import EgoRoute

if TYPE_CHECKING:
    from scenic.core.vectors import Vector

QUARTER = math.pi / 2
FOLLOWING_SIGHT = 40.0  # [m], beyond which a driver in traffic need not care up to 10 m/s
FOLLOWING_CORRIDOR = 1.3  # [m] beside a path that a driver keeps free
FOLLOWING_BRAKE = 2.5  # [m/s²], comfortable
STANDSTILL_GAP = 3.0  # [m], kept to a vehicle that stands
_WIDTHS = [1.0 + 0.25 * np.arange(i, i + 25) for i in range(0, 200, 25)]  # [m], where the edge of a road is looked for
_LANE_WIDTH = 2.5  # [m] at least
KERB_SHORT = 3.0  # [m] before a junction, where a kerb ends


def lineThrough(*points: tuple[float, float]) -> Polyline:  # noqa: N802
    """A path through points [m], map frame, in driving order; as of lanes, its own lie a metre apart."""
    return Polyline(points).resampled(1.0)


def line_of(path: EgoRoute | CrossingPath | Polyline) -> Polyline:
    """The line of anything that has one."""
    return path if isinstance(path, Polyline) else path.line


@deferred
def pointOn(path: Any, ahead: float, left: float = 0.0) -> Vector:  # noqa: N802 - Scenic's naming
    """The point `ahead` [m] along a path from its start, `left` [m] beside it (negative: to the right)."""
    line = line_of(path)
    x, y = line.point_at(ahead)
    if left:
        direction = line.heading_at(ahead)
        x, y = x - left * math.sin(direction), y + left * math.cos(direction)
    return vector(x, y)


@deferred
def speedOn(route: EgoRoute, ahead: float, wanted: float) -> float:  # noqa: N802
    """What an ego drives at [m/s] that wants a speed [m/s], so far [m] along its route: no more than is allowed."""
    return min(float(route.allowed(keeps_limits=True)[route.line.segment_at(ahead)]), wanted)


@deferred
def directionOn(path: Any, ahead: float, turn: float = 0.0) -> float:  # noqa: N802
    """Scenic heading [rad] of a path `ahead` [m] along it, turned left by `turn` [rad]."""
    return line_of(path).heading_at(ahead) - QUARTER + turn


@deferred
def crossingDirection(path: Any, ahead: float, side: str) -> float:  # noqa: N802
    """Scenic heading [rad] of somebody standing on that `side` of a path and looking straight across it."""
    return line_of(path).heading_at(ahead) - QUARTER + (QUARTER if side == "right" else -QUARTER)


@deferred
def besideRoad(route: EgoRoute, ahead: float, side: str, beyond: float) -> Vector:  # noqa: N802
    """The point level with `ahead` [m] on the ego's route, `beyond` [m] outside the driving lanes on that side.

    Where lanes go on and on to that side, as along a crossing road, there is none, and the draw is rejected.
    """
    found = beside_road(route, ahead, side, beyond)
    if found is None:
        raise reject(f"the road has no {side} edge {ahead:.1f} m along the ego's route")
    return vector(*found)


def beside_road(route: EgoRoute, ahead: float, side: str, beyond: float) -> tuple[float, float] | None:
    """The same point [m], map frame; None where there is none."""
    x, y = route.line.point_at(ahead)
    outward = route.line.heading_at(ahead) + (QUARTER if side == "left" else -QUARTER)
    dx, dy = math.cos(outward), math.sin(outward)
    lanes = route.network.drivableRegion.polygons
    for some in _WIDTHS:
        outside = some[~shapely.intersects_xy(lanes, x + some * dx, y + some * dy)]
        if len(outside):
            at = float(outside[0]) + beyond
            return x + at * dx, y + at * dy
    return None


def followingSpeed(path: Any, agent: Any, others: Sequence[Any], wish: float) -> float:  # noqa: N802
    """The speed [m/s], at most `wish`, from which an agent on a path can still stop behind whoever is ahead on it."""
    line = line_of(path)
    x, y, _, _ = agent.pose
    along, _, near = line.project(x, y)
    sight = max(FOLLOWING_SIGHT, wish * wish / (2 * FOLLOWING_BRAKE) + 0.5 * FOLLOWING_SIGHT)  # to stop in, and bodies
    for other in others:
        ox, oy, _, speed = other.pose
        if math.hypot(ox - x, oy - y) > sight:
            continue
        at, beside, _ = line.project(ox, oy, near)
        if at > along and abs(beside) < FOLLOWING_CORRIDOR + 0.5 * other.width:
            room = at - along - 0.5 * (agent.length + other.length) - STANDSTILL_GAP
            wish = min(wish, math.sqrt(max(speed, 0.0) ** 2 + 2 * FOLLOWING_BRAKE * room) if room > 0.0 else 0.0)
    return wish


def waitingTraffic(route: EgoRoute) -> tuple[CrossingPath, ...]:  # noqa: N802
    """One way into the ego's junction for each side that traffic comes from and that meets the ego's; else none."""
    ways = conflicting_paths(route.network, route.route)
    return tuple({way.from_side: way for way in reversed(ways)}.values())


def lanesBeside(route: EgoRoute) -> tuple[tuple[Polyline, bool], ...]:  # noqa: N802
    """The lines of the lanes directly beside the ego's, and whether each runs against it."""
    return tuple(
        (line_beside(route.network, route.route, side), against) for side, against in lanes_beside(route).items()
    )


def lanes_beside(route: EgoRoute) -> dict[str, bool]:
    """On which sides of the ego's start a lane lies, and whether that runs against the ego's."""
    start = route.line.point_at(0.0)
    section = route.network.laneSectionAt(start) or route.network.elements[route.route.lane_ids[0]].sections[0]
    there = {side: section_beside(section, turn) for side, turn in (("left", 1), ("right", -1))}
    return {side: opposes(section.lane, other.lane) for side, other in there.items() if other is not None}


@deferred
def levelOn(path: Any, route: EgoRoute, ahead: float) -> float:  # noqa: N802
    """How far [m] along another path lies level with the point `ahead` [m] along the ego's route."""
    return line_of(path).project(*route.line.point_at(ahead))[0]


@deferred
def backFrom(to: float, metres: float) -> float:  # noqa: N802
    """Arc length [m] on a path so many metres before another; where the path begins later, the draw is rejected."""
    if metres > to:
        raise reject(f"a way begins {to:.0f} m before where it was to be met, not {metres:.0f} m")
    return to - metres


@deferred
def asideOf(route: EgoRoute, ahead: float, side: str, metres: float) -> Vector:  # noqa: N802
    """The point so many metres to a side of the ego's route; where that lies on a lane, the draw is rejected."""
    point = pointOn(route, ahead, metres if side == "left" else -metres)
    if shapely.intersects_xy(route.network.drivableRegion.polygons, point.x, point.y):
        raise reject(f"{metres:.0f} m to the {side} of the ego's route there is still a lane")
    return point


@deferred
def maximum(a: float, b: float) -> float:
    """The larger of two numbers, of which either may be sampled."""
    return max(a, b)


def trafficFrom(route: EgoRoute, side: str) -> tuple[CrossingPath, ...]:  # noqa: N802
    """The ways of vehicles that come from a side of the ego's junction and meet the ego's way there.

    Args:
        route: The ego's.
        side: ``left``, ``right`` or ``oncoming``.

    Raises:
        MapError: Nobody from that side meets the ego's route.
    """
    found = tuple(path for path in conflicting_paths(route.network, route.route) if path.from_side == side)
    if not found:
        raise MapError(f"route {route.route.id!r} has no traffic from the {side} that meets it")
    return found


def opposite(route: EgoRoute) -> CrossingPath:
    """The way of who comes from the arm opposite the ego's, goes straight on, and passes it in the junction.

    Raises:
        MapError: Nobody comes so.
    """
    way = passing_path(route.network, route.route)
    if way is None:
        raise MapError(f"route {route.route.id!r} has nobody who comes from opposite and passes it in the junction")
    return way


def ringTraffic(route: EgoRoute, *sides: str) -> CrossingPath:  # noqa: N802
    """The way of somebody in the roundabout of the ego's route that meets it; from the first side where there is one.

    Args:
        route: The ego's.
        sides: From where: ``round`` of who goes round in it already, or from its arm to the ``left`` or ``right`` of
            the ego's entry or ``oncoming``; best first.

    Raises:
        MapError: Nobody from there meets the ego's route.
    """
    ways = {way.from_side: way for way in reversed(ring_ways(route.network, route.route))}
    for side in sides:
        if side in ways:
            return ways[side]
    raise MapError(f"route {route.route.id!r} has no traffic {' or '.join(sides)} in a roundabout that meets it")


def wayOf(traffic: tuple[CrossingPath, ...], turns: str | tuple[str, ...], lane: str = "") -> CrossingPath:  # noqa: N802
    """Among the ways of crossing traffic, one that does a turn; of several turns, the first that anybody can do.

    Args:
        traffic: From one side, as `trafficFrom` gives it.
        turns: ``straight``, ``left-turn`` or ``right-turn``, or more of them, best first.
        lane: ``inner`` or ``outer``, of those that come from there in several lanes; the first of them if left out.

    Raises:
        MapError: Nobody from there can do any of them across the ego's way.
    """
    wanted = (turns,) if isinstance(turns, str) else turns
    way = next((path for turn in wanted for path in traffic if path.turn.value == turn), None)
    if way is None:
        told = " or ".join(map(with_article, wanted))
        raise MapError(f"no traffic from the {traffic[0].from_side} meets the ego's route in {told}")
    if not lane:
        return way
    alike = sorted((path for path in traffic if path.turn is way.turn), key=lambda path: _to_left(path, way))
    return alike[-1 if lane == "inner" else 0]


def _to_left(path: CrossingPath, way: CrossingPath) -> float:
    """How far [m] a way enters a junction to the left of another."""
    return way.line.project(*path.line.point_at(path.entry))[1]


def outOfDriveway(route: EgoRoute, side: str) -> tuple[CrossingPath, ...]:  # noqa: N802
    """The ways of vehicles that come out of the driveway beside the ego's way, and turn onto its road.

    Args:
        route: The ego's.
        side: On which side of it the driveway is, ``left`` or ``right``.

    Raises:
        MapError: There is none, or nobody from there meets the ego's way.
    """
    if not (found := ways_out(route.network, route.route, side)):
        raise MapError(f"route {route.route.id!r} has no driveway on its {side} from which somebody meets it")
    return found


def wayOff(route: EgoRoute, side: str) -> Polyline:  # noqa: N802
    """The way off the ego's road to a side, from the ego's lane: into the arm of its junction, or into the driveway.

    Args:
        route: The ego's.
        side: ``left`` or ``right``.

    Raises:
        MapError: Nothing leads off there.
    """
    if (line := way_off(route.network, route.route, side)) is None:
        raise MapError(f"route {route.route.id!r} has no way off to its {side}")
    return line


def adjacentPath(route: EgoRoute) -> Polyline:  # noqa: N802
    """The centre line of a lane of the ego's direction beside its own: the right one, or else the left one.

    Raises:
        MapError: The ego's is the only lane of its direction.
    """
    there = lanes_beside(route)
    for side in ("right", "left"):
        if there.get(side) is False:
            return line_beside(route.network, route.route, side)
    raise MapError(f"route {route.route.id!r} has no second lane of its direction")


def extended(path: Any, back: float) -> Polyline:
    """A path that begins `back` [m] earlier, straight, or the way the ego came: where somebody behind it can be."""
    line = line_of(path)
    if isinstance(path, EgoRoute) and path.before is not None:
        line, back = Polyline.join(path.before, line), back - path.before.length
        if back <= 0.0:
            return line.between(-back, line.length)
    return Polyline([line.point_at(-back), *line.points])


def onward(path: Any, metres: float) -> Polyline:
    """A path that goes on straight beyond its end, so many metres: where somebody is who drives on past it."""
    line = line_of(path)
    (x, y), heading = line.point_at(line.length), line.heading_at(line.length)
    return Polyline.join(line, headingLine(x, y, heading, metres))


def straightOn(route: EgoRoute) -> Polyline:  # noqa: N802
    """The way of somebody who rides beside the ego up to its junction and, where the ego turns, goes straight on."""
    line, begin = route.line, route.eventAt
    (x, y), heading = line.point_at(begin), line.heading_at(begin)
    ahead = headingLine(x, y, heading, 45.0)
    return Polyline.join(line.between(0.0, begin), ahead)


def against(path: Any) -> Polyline:
    """A path in the opposite direction: the way of somebody who drives on it the wrong way."""
    return Polyline(line_of(path).points[::-1])


def neighbourPath(route: EgoRoute, side: str) -> Polyline:  # noqa: N802
    """The centre line of the lane beside the ego's, in its own driving order.

    For a lane of the same direction, arc length 0 is level with the ego's start. For an opposing lane, the line
    runs against the ego's.

    Raises:
        MapError: There is no such lane.
    """
    return line_beside(route.network, route.route, side)


def oncomingPath(route: EgoRoute) -> Polyline:  # noqa: N802
    """The centre line of the nearest lane that runs against the ego's, in its own order; others may lie between.

    Raises:
        MapError: There is no such lane.
    """
    line = oncoming_line(route.network, route.route)
    if line is None:
        raise MapError(f"route {route.route.id!r} on map {route.route.map_name!r} has no lane of the other direction")
    return line


def laneLine(lane: Any, least: float = 200.0, of: Callable[[Any], Polyline] = centre_line) -> Polyline:  # noqa: N802
    """The line of a lane and of the straightest lanes after it, at least `least` [m] if the map goes on.

    Args:
        lane: Scenic's lane.
        least: How long it is [m].
        of: What line of a lane is meant: its centre line, as it is driven by, or `chatscene.maps.lane_curves`' own.
    """
    if lane is None:
        raise ValueError("it stands on no lane that it could follow; place it on one, or give it a path")
    line = of(lane)
    while line.length < least and lane.maneuvers:
        straight = [m for m in lane.maneuvers if m.type.name == "STRAIGHT"]
        maneuver = (straight or list(lane.maneuvers))[0]
        parts = [part for part in (maneuver.connectingLane, maneuver.endLane) if part is not None]
        line = Polyline.join(line, *(of(part) for part in parts))
        lane = maneuver.endLane
    return line


def ownLane(route: EgoRoute) -> Polyline:  # noqa: N802
    """The centre line of the lane the ego starts in, from level with its start on, whatever the route does."""
    line = lane_runs(route.network)[route.route.lane_ids[0]].line
    level, _, _ = line.project(*route.line.point_at(0.0))
    return line.between(level, line.length)


def wholeLane(route: EgoRoute) -> Polyline:  # noqa: N802
    """The centre line of the lane the ego starts in or beside, from its beginning: where traffic comes from behind."""
    return lane_runs(route.network)[route.route.lane_ids[0]].line


def lastLane(route: EgoRoute) -> Polyline:  # noqa: N802
    """The centre line of the lane the ego ends in, from its beginning: where traffic there comes from."""
    return lane_runs(route.network)[route.route.lane_ids[-1]].line


def offRamp(route: EgoRoute) -> Polyline:  # noqa: N802
    """The line of the lane that leads off the ego's road by the nearest ramp, and on down that.

    Raises:
        MapError: No ramp leads off its road.
    """
    return off_ramp_line(route.network, route.route)


def leftAt(route: EgoRoute) -> float:  # noqa: N802
    """Arc length [m] at which a route that changes lanes has all but left its first one, which is free for others then.

    Raises:
        MapError: It keeps its lane.
    """
    lane = ownLane(route)
    aside = np.abs([lane.project(x, y)[1] for x, y in route.line.points.tolist()])
    if aside.max() < _LANE_WIDTH:
        raise MapError(f"route {route.route.id!r} keeps its lane")
    return float(np.argmax(aside > 0.8 * aside.max())) * route.line.length / (len(aside) - 1)


def ownWay(route: EgoRoute) -> Polyline:  # noqa: N802
    """The way of traffic ahead of the ego: its route, or its first lane where it is about to leave that."""
    return ownLane(route) if route.maneuver in (Maneuver.LANE_CHANGE_LEFT, Maneuver.LANE_CHANGE_RIGHT) else route.line


@deferred
def shortOfJunction(route: EgoRoute, along: float) -> float:  # noqa: N802
    """Arc length [m] on the ego's route, cut to `KERB_SHORT` before its junction, where the kerb turns away."""
    return along if route.route.junction is None else min(along, route.eventAt - KERB_SHORT)


def headingLine(x: float, y: float, heading: float, length: float = 60.0) -> Polyline:  # noqa: N802
    """A straight line from a point along a heading [rad, 0 = +x, counter-clockwise]."""
    return Polyline([(x, y), (x + length * math.cos(heading), y + length * math.sin(heading))])


def trackerFor(agent: Any, path: Any, left: float = 0.0) -> Tracker:  # noqa: N802
    """A tracker of a path for an agent of the world model."""
    return Tracker(line_of(path), agent.wheelbase, agent.wheelAngle, left, agent.body.grip)


def progressOn(path: Any, agent: Any, near: int | None = None) -> tuple[float, int]:  # noqa: N802
    """How far [m] along a path an agent is, and the segment to start from next time."""
    at, _, near = line_of(path).project(agent.pose[0], agent.pose[1], near)
    return at, near


def offsetFrom(path: Any, agent: Any) -> float:  # noqa: N802
    """How far [m] to the left of a path an agent is (negative: to the right)."""
    return line_of(path).project(agent.pose[0], agent.pose[1])[1]


def gap(a: Any, b: Any) -> float:
    """Distance [m] between the centres of two actors."""
    pa, pb = a.pose, b.pose
    return math.hypot(pa[0] - pb[0], pa[1] - pb[1])


def distanceLeft(path: Any, agent: Any, to: float) -> float:  # noqa: N802
    """How far [m] an agent still has to go on a path until arc length `to`; negative when past it."""
    return to - line_of(path).project(agent.pose[0], agent.pose[1])[0]


def headway(path: Any, a: Any, b: Any) -> float:
    """How far [m] actor `a` still has to go on a path until it is level with actor `b`; negative when past it."""
    return distanceLeft(path, a, line_of(path).project(b.pose[0], b.pose[1])[0])


@deferred
def wheelbase_of(kind: str, length: float) -> float:
    """The wheelbase [m] of a vehicle of a kind that is `length` [m] long: in proportion."""
    limits = LIMITS[kind]
    return limits.wheelbase if length == limits.length else limits.wheelbase * length / limits.length


def unplaced() -> Vector:
    """Where a thing stands that is given no place.

    Raises:
        ValueError: Always; Scenic would draw a place from the whole map, where a scene is its parameter values.
    """
    raise ValueError("a thing is given no place; say where it stands, as in `at pointOn(egoRoute, 30)`")


def secondsTo(path: Any, agent: Any, to: float) -> float:  # noqa: N802
    """How long [s] an ego that nobody holds needs until arc length `to`, by its own pace; below 0 past it.

    One of which the program wants a speed is as slow in bends, and where it keeps limits, as they let it.
    """
    pace = Pace.of(agent)
    if (table := timetable_of(path, agent)) is None:
        missing = max(0.0, pace.speed - agent.pose[3])
        return distanceLeft(path, agent, to) / pace.speed + missing * missing * pace.loss
    return table.time_from(progressOn(path, agent)[0], agent.pose[3], to, pace.gain)


def timetable_of(path: Any, agent: Any) -> Timetable | None:
    """When an ego is where on a path if nobody holds it, of which a program wants a speed; None if it wants none."""
    if (wanted := getattr(agent, "wantedSpeed", None)) is None:
        return None
    keeps, grip = bool(getattr(agent, "keepsLimits", False)), float(agent.body.grip)
    return timetable(path, float(wanted), keeps_limits=keeps, gain=Pace.of(agent).gain, grip=grip)


def timetable(
    path: EgoRoute | CrossingPath | Polyline,
    wanted: float,
    *,
    keeps_limits: bool,
    gain: float = NOMINAL.gain,
    grip: float = math.inf,
) -> Timetable:
    """When an ego is where on a path that wants a speed [m/s], and that nobody holds.

    Args:
        path: On which; limits are known of an ego's route.
        wanted: What it wants [m/s].
        keeps_limits: Whether the limits of roads hold for it besides bends.
        gain: With which it takes up speed [m/s²].
        grip: What the road holds [m/s²].
    """
    if isinstance(path, EgoRoute):
        return _by_limits(path.network, path, wanted, keeps_limits, gain, grip)
    return _by_bends(line_of(path), wanted, gain, grip)


@kept_with_network(256)
def _by_limits(
    _network: Any, route: EgoRoute, wanted: float, keeps_limits: bool, gain: float, grip: float
) -> Timetable:
    return Timetable(route.line, route.allowed(keeps_limits=keeps_limits, grip=grip), wanted, gain)


@lru_cache(maxsize=256)
def _by_bends(line: Polyline, wanted: float, gain: float, grip: float) -> Timetable:
    return Timetable(line, allowed_speeds(line, None, grip), wanted, gain)


@deferred
def timeTo(  # noqa: N802
    route: EgoRoute, ahead: float, wanted: float, keeps: bool = False, gain: float = NOMINAL.gain
) -> float:
    """How long [s] an ego is on its way to `ahead` [m] on its route, if it wants a speed [m/s] and nobody holds it."""
    return timetable(route, wanted, keeps_limits=keeps, gain=gain).time_at(ahead)


def brakingDistance(agent: Any) -> float:  # noqa: N802
    """How far [m] an agent still goes if it brakes now as hard as it and the road can."""
    return agent.pose[3] ** 2 / (2 * min(LIMITS[kind_of(agent)].brake, agent.body.grip))


def restsWithin(path: Any, agent: Any, distance: float) -> bool:  # noqa: N802
    """Whether an agent that heads for a path and brakes now would stop no farther than `distance` [m] from it."""
    return abs(offsetFrom(path, agent)) - brakingDistance(agent) < distance
