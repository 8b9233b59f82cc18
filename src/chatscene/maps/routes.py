"""Find routes for the ego: ten diverse ones for a geometry, on any map that has it.

Paper: section 4.1 (ten routes per base scenario). Routes are found from the road network alone, in a fixed order,
so that a route's number means the same everywhere.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import count as counter
from typing import Any

import numpy as np

from chatscene.errors import MapError
from chatscene.maps.junctions import junction_control
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route, RouteQuery
from chatscene.terms.scenario import BaseScenario, Control, Maneuver, Place

APPROACHES = (42.0, 36.0, 48.0, 30.0)  # [m] from the start to the junction's entry; the first where possible
EXIT = 45.0  # [m] driven after the junction
OPEN_ROAD = 100.0  # [m] of a route without a junction
ONSETS = (10.0, 45.0, 80.0, 115.0)  # [m] into the lane, where a route without a junction may start
CHANGE_AT, CHANGE_OVER = 30.0, 25.0  # [m], where a lane change begins and how long it takes
BLOCKER_AT, SWING, PASSING = 50.0, 22.0, 10.0  # [m], a bypass: the blocker, swinging out and in, passing beside
MEETING = 2.5  # [m], paths nearer than this meet: about a car's width and some

_STRAIGHT_ROAD = math.radians(5)
_CURVED_ROAD = math.radians(30)
_TURNS = {
    "STRAIGHT": Maneuver.STRAIGHT,
    "LEFT_TURN": Maneuver.LEFT_TURN,
    "RIGHT_TURN": Maneuver.RIGHT_TURN,
}

BASE_SCENARIO_QUERIES: dict[BaseScenario, tuple[RouteQuery, ...]] = {
    BaseScenario.STRAIGHT_OBSTACLE: (RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.ROAD),),
    BaseScenario.TURNING_OBSTACLE: (
        RouteQuery(maneuver=Maneuver.LEFT_TURN),
        RouteQuery(maneuver=Maneuver.RIGHT_TURN),
    ),
    BaseScenario.LANE_CHANGING: (
        RouteQuery(maneuver=Maneuver.LANE_CHANGE_LEFT, lanes_same_way=2),
        RouteQuery(maneuver=Maneuver.LANE_CHANGE_RIGHT, lanes_same_way=2),
    ),
    BaseScenario.VEHICLE_PASSING: (RouteQuery(maneuver=Maneuver.BYPASS, opposite_lane=True),),
    BaseScenario.RED_LIGHT_RUNNING: (
        RouteQuery(
            maneuver=Maneuver.STRAIGHT, place=Place.FOUR_WAY, control=Control.SIGNAL, conflicting_from=("left",)
        ),
    ),
    BaseScenario.UNPROTECTED_LEFT_TURN: (
        RouteQuery(maneuver=Maneuver.LEFT_TURN, control=Control.SIGNAL, conflicting_from=("oncoming",)),
    ),
    BaseScenario.RIGHT_TURN: (RouteQuery(maneuver=Maneuver.RIGHT_TURN, conflicting_from=("left",)),),
    BaseScenario.CROSSING_NEGOTIATION: (
        RouteQuery(
            maneuver=Maneuver.STRAIGHT, place=Place.JUNCTION, control=Control.NONE, conflicting_from=("left",)
        ),
    ),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class CrossingPath:
    """The way of another vehicle that meets the ego's at a junction.

    Attributes:
        line: Its lane before the junction, through it, and after.
        turn: What it does there.
        from_side: Where it comes from, seen from the ego: ``left``, ``right`` or ``oncoming``.
        entry: Arc length [m] on `line` where it enters the junction.
        meets_at: Arc length [m] on `line` where it first comes near the ego's route.
        ego_meets_at: Arc length [m] on the ego's route of that place.
    """

    line: Polyline
    turn: Maneuver
    from_side: str
    entry: float
    meets_at: float
    ego_meets_at: float


@dataclass(frozen=True, slots=True)
class _Candidate:
    """A possible route. Those of a lower `variant` and `rank` come first; `group` is what to spread over."""

    variant: int
    group: str
    route: Route


def find_routes(network: Any, map_name: str, query: RouteQuery, count: int = 10) -> tuple[Route, ...]:
    """The routes of a map that answer a query, spread over junctions and roads first.

    Args:
        network: Scenic's road network.
        map_name: Goes into the routes.
        query: What they must offer.
        count: How many at most.

    Returns:
        Between one and `count` routes, always the same and in the same order.

    Raises:
        MapError: There is none.
    """
    at_junction = query.place in (Place.JUNCTION, Place.THREE_WAY, Place.FOUR_WAY) or (
        query.maneuver in (Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN)
    )
    find = _through_junctions if at_junction else _along_roads
    candidates: list[_Candidate] = []
    for variant in range(len(APPROACHES)):  # later variants only fill up what earlier ones leave
        if len(candidates) < count:
            candidates += find(network, map_name, query, variant)
    if not candidates:
        raise MapError(f"map {map_name!r} has no place for {_in_words(query)}")
    chosen = _spread(candidates)[:count]
    return tuple(_named(route, f"{query.maneuver}-{number:02d}") for number, route in enumerate(chosen))


def _spread(candidates: list[_Candidate]) -> list[Route]:
    """Round after round, one candidate of each group."""
    rank: dict[tuple[int, str], Iterator[int]] = {}
    keyed = [
        (c.variant, next(rank.setdefault((c.variant, c.group), counter())), i, c.route)
        for i, c in enumerate(candidates)
    ]
    return [route for *_, route in sorted(keyed, key=lambda entry: entry[:3])]


def _named(route: Route, name: str) -> Route:
    return Route(
        id=name,
        map_name=route.map_name,
        maneuver=route.maneuver,
        place=route.place,
        control=route.control,
        line=route.line,
        lane_ids=route.lane_ids,
        event_at=route.event_at,
        junction=route.junction,
    )


def _in_words(query: RouteQuery) -> str:
    words = [f"the manoeuvre {query.maneuver}"]
    if query.place is not None:
        words.append(f"place {query.place}")
    if query.control is not None:
        words.append(f"control {query.control}")
    if query.lanes_same_way > 1:
        words.append(f"{query.lanes_same_way} lanes in the ego's direction")
    if query.opposite_lane:
        words.append("an oncoming lane beside the ego's")
    if query.conflicting_from:
        words.append(f"traffic from {' and '.join(query.conflicting_from)} that crosses the ego's way")
    return ", ".join(words)


# Junctions


def _place_of(intersection: Any) -> Place:
    if intersection.is4Way:
        return Place.FOUR_WAY
    return Place.THREE_WAY if intersection.is3Way else Place.JUNCTION


def _through_junctions(network: Any, map_name: str, query: RouteQuery, variant: int) -> Iterator[_Candidate]:
    for intersection in sorted(network.intersections, key=lambda i: str(i.uid)):
        place, control = _place_of(intersection), junction_control(intersection)
        if query.place not in (None, Place.JUNCTION, place) or query.control not in (None, control):
            continue
        maneuvers = [m for m in intersection.maneuvers if _TURNS.get(m.type.name) is query.maneuver]
        for maneuver in sorted(maneuvers, key=lambda m: (m.startLane.uid, m.endLane.uid)):
            route = _junction_route(maneuver, intersection, map_name, place, control, APPROACHES[variant])
            if route is None or not _offers(maneuver.startLane, query):
                continue
            if not query.conflicting_from or set(query.conflicting_from) <= {
                path.from_side for path in conflicting_paths(network, route)
            }:
                yield _Candidate(variant, str(intersection.uid), route)


def _junction_route(
    maneuver: Any, intersection: Any, map_name: str, place: Place, control: Control, approach: float
) -> Route | None:
    before, after = _centre(maneuver.startLane), _centre(maneuver.endLane)
    if before.length < approach + 2 or after.length < 15 or maneuver.connectingLane is None:
        return None
    line = Polyline.join(
        before.between(before.length - approach, before.length),
        _centre(maneuver.connectingLane),
        after.between(0.0, min(EXIT, after.length)),
    )
    return Route(
        id="",
        map_name=map_name,
        maneuver=_TURNS[maneuver.type.name],
        place=place,
        control=control,
        line=line.resampled(1.0),
        lane_ids=(maneuver.startLane.uid, maneuver.connectingLane.uid, maneuver.endLane.uid),
        event_at=approach,
        junction=str(intersection.uid),
    )


@lru_cache(maxsize=1024)
def conflicting_paths(network: Any, route: Route) -> tuple[CrossingPath, ...]:
    """The ways of other vehicles through a route's junction that meet the route.

    Args:
        network: Scenic's road network.
        route: The ego's route; one without a junction has no conflicts.

    Returns:
        Straight ways first, then left turns, then right turns; each at most once per pair of lanes.
    """
    if route.junction is None:
        return ()
    intersection = network.elements[route.junction]
    start = network.elements[route.lane_ids[0]]
    found = [
        path
        for maneuver in sorted(intersection.maneuvers, key=lambda m: (m.startLane.uid, m.endLane.uid))
        if maneuver.startLane.road is not start.road or maneuver.startLane.group is not start.group
        if (path := _crossing(maneuver, route)) is not None
    ]
    order = list(_TURNS.values())
    return tuple(sorted(found, key=lambda path: order.index(path.turn)))


def _crossing(maneuver: Any, route: Route) -> CrossingPath | None:
    turn = _TURNS.get(maneuver.type.name)
    if turn is None or maneuver.connectingLane is None:
        return None
    before = _centre(maneuver.startLane)
    side = _from_side(before.heading_at(before.length) - route.line.heading_at(route.event_at))
    if side is None:
        return None
    line = _way(maneuver)
    entry = int(before.length)
    reach = line.points[entry : entry + 60]
    distance = np.hypot(
        reach[:, None, 0] - route.line.points[None, :, 0], reach[:, None, 1] - route.line.points[None, :, 1]
    )
    near = np.flatnonzero(distance.min(axis=1) < MEETING)
    if near.size == 0:
        return None
    first = int(near[0])
    return CrossingPath(
        line=line,
        turn=turn,
        from_side=side,
        entry=before.length,
        meets_at=float(entry + first),
        ego_meets_at=float(distance[first].argmin()),
    )


@lru_cache(maxsize=4096)
def _centre(lane: Any) -> Polyline:
    """The centre line of a lane."""
    return Polyline(lane.centerline.points)


@lru_cache(maxsize=4096)
def _way(maneuver: Any) -> Polyline:
    """The line of a vehicle that does a manoeuvre, from the start of its lane to the end of the one after."""
    lanes = (maneuver.startLane, maneuver.connectingLane, maneuver.endLane)
    return Polyline.join(*(_centre(lane) for lane in lanes)).resampled(1.0)


def _from_side(difference: float) -> str | None:
    """Where somebody comes from whose heading differs from the ego's by so much [rad]."""
    turned = math.degrees((difference + math.pi) % (2 * math.pi) - math.pi)
    if abs(turned) > 135:
        return "oncoming"
    if 45 <= turned:
        return "right"
    return "left" if turned <= -45 else None


# Open road


def _along_roads(network: Any, map_name: str, query: RouteQuery, variant: int) -> Iterator[_Candidate]:
    onset = ONSETS[variant]
    for lane in sorted(network.lanes, key=lambda lane: lane.uid):
        if lane.road not in network.roads or not _offers(lane, query):
            continue
        centre = _centre(lane)
        if centre.length < onset + OPEN_ROAD + 5:
            continue
        own = centre.between(onset, onset + OPEN_ROAD)
        place = _shape(own)
        if place is None or (query.place or Place.ROAD) is not place:
            continue
        found = _on_road(lane, centre, own, onset, query)
        if found is not None:
            line, lanes, event_at = found
            route = Route(
                id="",
                map_name=map_name,
                maneuver=query.maneuver,
                place=place,
                control=Control.NONE,
                line=line.resampled(1.0),
                lane_ids=lanes,
                event_at=event_at,
            )
            yield _Candidate(variant, str(lane.road.uid), route)


def _shape(line: Polyline) -> Place | None:
    """ROAD for a straight line, CURVE for a bend, None for what is neither."""
    bend = abs(line.heading_at(line.length) - line.heading_at(0.0))
    bend = min(bend, 2 * math.pi - bend)
    if bend < _STRAIGHT_ROAD:
        return Place.ROAD
    return Place.CURVE if bend > _CURVED_ROAD else None


def _on_road(
    lane: Any, centre: Polyline, own: Polyline, onset: float, query: RouteQuery
) -> tuple[Polyline, tuple[str, ...], float] | None:
    """Line, lanes and event of a route that starts in a lane and does the query's manoeuvre."""
    if query.maneuver is Maneuver.STRAIGHT:
        return own, (lane.uid,), own.length / 2
    side = 1 if query.maneuver in (Maneuver.LANE_CHANGE_LEFT, Maneuver.BYPASS) else -1
    beside = _neighbour(lane, onset + CHANGE_AT, centre, side)
    if beside is None or _opposes(lane, beside) != (query.maneuver is Maneuver.BYPASS):
        return None
    other = _centre(beside)
    x, y = own.point_at(CHANGE_AT)
    gap = other.project(x, y)[1]
    shift = abs(gap) * side
    if query.maneuver is Maneuver.BYPASS:
        line = _shifted(own, shift, BLOCKER_AT - PASSING - SWING, BLOCKER_AT + PASSING)
        return line, (lane.uid, beside.uid), BLOCKER_AT
    return _shifted(own, shift, CHANGE_AT, None), (lane.uid, beside.uid), CHANGE_AT


def _shifted(line: Polyline, left: float, out_at: float, back_at: float | None) -> Polyline:
    """A line that moves `left` [m] over from `out_at` on, and back from `back_at` on (None: stays)."""
    fine = line.resampled(1.0)
    s = np.arange(len(fine), dtype=float)
    over = CHANGE_OVER if back_at is None else SWING
    share = _smooth((s - out_at) / over)
    if back_at is not None:
        share = share - _smooth((s - back_at) / over)
    tangent = np.gradient(fine.points, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    normal = np.column_stack((-tangent[:, 1], tangent[:, 0]))
    return Polyline(fine.points + (left * share)[:, None] * normal)


def _smooth(t: np.ndarray) -> np.ndarray:
    t = np.clip(t, 0.0, 1.0)
    return t * t * (3 - 2 * t)


def _neighbour(lane: Any, at: float, centre: Polyline, side: int) -> Any:
    """The lane beside another at an arc length: left for side 1, right for -1; None if there is none."""
    x, y = centre.point_at(at)
    section = next((s for s in lane.sections if s.containsPoint((x, y))), lane.sections[0])
    beside = section._laneToLeft if side > 0 else section._laneToRight
    return None if beside is None else beside.lane


def _opposes(lane: Any, other: Any) -> bool:
    return lane.group is not other.group


def _offers(lane: Any, query: RouteQuery) -> bool:
    """Whether a lane has the neighbours a query asks for."""
    if len(lane.group.lanes) < query.lanes_same_way:
        return False
    if query.opposite_lane is None:
        return True
    left = lane.sections[0]._laneToLeft
    return (left is not None and _opposes(lane, left.lane)) == query.opposite_lane
