"""Find routes for the ego: ten diverse ones for a geometry, on any map that has it.

Paper: section 4.2 (ten routes per base scenario). Routes are found from the road network alone, in a fixed order,
so that a route's number means the same everywhere.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import count as counter
from itertools import islice
from typing import Any

import shapely

from chatscene.errors import MapError
from chatscene.maps.crossings import ALL_LEGS, TURNS, conflicting_paths
from chatscene.maps.equipment import is_equipped
from chatscene.maps.junctions import control_before, junction_control
from chatscene.maps.kept import kept, kept_with_network
from chatscene.maps.lane_runs import centre_line, lane_runs
from chatscene.maps.layout import JunctionKind, arms, junction_kinds, shape_from
from chatscene.maps.neighbours import opposes, section_beside
from chatscene.maps.network import map_with
from chatscene.maps.off_lane import TIGHTEST
from chatscene.maps.open_road import CURVED_ROAD, SHORT_ROAD, on_road, turned, windows
from chatscene.maps.settings import is_two_way, lies_in
from chatscene.maps.sites import AT_JUNCTIONS, routes_at
from chatscene.terms.nouns import with_article
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Beside, Equipment, Route, RouteQuery
from chatscene.terms.scenario import BaseScenario, Control, Maneuver, Place, Site, includes

APPROACHES = (42.0, 36.0, 48.0, 30.0)  # [m] from the start to the junction's entry; the first where possible
EXIT = 45.0  # [m] driven after the junction
ELSEWHERE = "; name no map, or the map "  # in a refusal, before the map that has such a site
TO_LINE = 4.0  # [m] from the middle of a car that waits at a junction to its entry: the nose is half a car nearer

_SEAM = 0.1  # [m]
_LEAST_TURNED = math.radians(45)
_MOST_TURNED = math.radians(150)  # more is a ramp that winds

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
            maneuver=Maneuver.STRAIGHT,
            place=Place.FOUR_WAY,
            control=Control.SIGNAL,
            conflicting_from=("left",),
        ),
    ),
    BaseScenario.UNPROTECTED_LEFT_TURN: (
        RouteQuery(maneuver=Maneuver.LEFT_TURN, control=Control.SIGNAL, conflicting_from=("oncoming",)),
    ),
    BaseScenario.RIGHT_TURN: (RouteQuery(maneuver=Maneuver.RIGHT_TURN, conflicting_from=("left",)),),
    BaseScenario.CROSSING_NEGOTIATION: (
        RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.JUNCTION, control=Control.NONE, conflicting_from=("left",)),
    ),
}


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
    find = _at_site if query.site in AT_JUNCTIONS else _through_junctions if _needs_junction(query) else _along_roads
    if query.site is not None and find is _through_junctions:
        raise MapError(f"no route leads through a junction and along the {query.site}: {', '.join(_in_words(query))}")
    candidates: list[_Candidate] = []
    for variant in range(len(APPROACHES)):  # later variants only fill up what earlier ones leave
        if len(candidates) < count:
            found = find(network, map_name, query, variant)
            candidates += (one for one in found if is_equipped(network, one.route, query.has))
    if not candidates:
        other = map_with(query.site)
        remedy = "" if query.site is None or map_name == other else f"{ELSEWHERE}{other!r}"
        raise MapError(f"map {map_name!r} has no place for {', '.join(_in_words(query))}{remedy}")
    chosen = _spread(candidates)[:count]
    slug, site = query.slug, query.site
    return tuple(replace(route, id=f"{slug}-{number:02d}", site=site) for number, route in enumerate(chosen))


_ENDS = {
    Beside.KERB: "a kerb to end at",
    Beside.DRIVEWAY: "a driveway to end in",
    Beside.DRIVEWAY_ACROSS: "a driveway beyond the oncoming lanes to end in",
    Beside.BACK: f"lanes of the other direction {2 * TIGHTEST:.0f} m away to turn into",
}

_EQUIPMENT = {
    Equipment.CROSSWALKS: "crosswalks at the junction",
    Equipment.CYCLE_LANE: "a cycle lane",
    Equipment.TRAM_TRACK: "rails in the road",
    Equipment.BAYS: "bays on both sides",
    Equipment.GIVE_WAY: "a give-way sign",
    Equipment.BUS_LANE: "a bus lane",
}


def _needs_junction(query: RouteQuery) -> bool:
    return (
        query.place in (Place.JUNCTION, Place.THREE_WAY, Place.FOUR_WAY)
        or query.maneuver in (Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN)
        or query.control in (Control.SIGNAL, Control.STOP_SIGN)
        or bool(query.conflicting_from)
    )


def _spread(candidates: list[_Candidate]) -> list[Route]:
    """Round after round, one candidate of each group."""
    rank: dict[tuple[int, str], Iterator[int]] = {}
    keyed = [
        (c.variant, next(rank.setdefault((c.variant, c.group), counter())), i, c.route)
        for i, c in enumerate(candidates)
    ]
    return [route for *_, route in sorted(keyed, key=lambda entry: entry[:3])]


def lacking(network: Any, map_name: str, query: RouteQuery) -> str:
    """What a map that has no route for a query has not, in words.

    That is the one thing without which there would be routes, or two; else all that was asked for.
    """
    anything = replace(query, control=None, place=None)
    for freer in (replace(query, conflicting_from=()), replace(query, control=None), anything):
        if freer != query:
            with suppress(MapError):
                find_routes(network, map_name, freer, 1)
                return ", ".join(word for word in _in_words(query) if word not in _in_words(freer))
    return ", ".join(_in_words(query))


def _in_words(query: RouteQuery) -> list[str]:
    words = [f"the manoeuvre {query.maneuver}"]
    if query.place is not None:
        words.append(f"place {query.place}")
    if query.control is not None:
        words.append(f"control {query.control}")
    if query.lanes_same_way > 1 or query.most_lanes is not None:
        most = "" if query.most_lanes is None else f" and {query.most_lanes} at most"
        words.append(f"{query.lanes_same_way} lanes in the ego's direction{most}")
    if query.opposite_lane:
        words.append("an oncoming lane beside the ego's")
    if query.lane_beside == "none":
        words.append("no second lane in the ego's direction")
    elif query.lane_beside:
        words.append(f"a lane of the ego's direction to its {query.lane_beside}")
    words += [f"the {site}" for site in (query.site,) if site is not None]
    words += [f"the setting {query.setting}"] * (query.setting is not None) + ["a median"] * query.divided
    words += [_EQUIPMENT[one] for one in query.has]
    if query.lane is not None:
        words.append(f"lane {abs(query.lane)} from the {'outermost' if query.lane > 0 else 'innermost'}")
    words += [f"the shape {query.shape}"] * (query.shape is not None)
    words += [f"{query.arms} arms"] * (query.arms is not None)
    words += [f"{one[0]:g} to {one[1]:g} m across" for one in (query.across,) if one is not None]
    words += [f"exit {query.by_exit}"] * (query.by_exit is not None)
    words += [f"{with_article(query.begins)} to begin at" for _ in (query.begins,) if query.begins is not None]
    words += [_ENDS[query.ends] for _ in (query.ends,) if query.ends is not None]
    words += [f"{query.approach:.0f} m of road before it" for _ in (query.approach,) if query.approach is not None]
    if query.conflicting_from:
        words.append(f"traffic from {' and '.join(query.conflicting_from)} that crosses the ego's way")
    if query.site is None:
        before = f"{min(APPROACHES):.0f} m of lane before a junction"
        straight = "straight lane" if (query.place or Place.ROAD) is Place.ROAD else "lane"
        words.append(before if _needs_junction(query) else f"{SHORT_ROAD:.0f} m of {straight} without a junction")
    return words


def _at_site(network: Any, map_name: str, query: RouteQuery, variant: int) -> Iterator[_Candidate]:
    way = RouteQuery(  # what the way itself depends on
        maneuver=query.maneuver,
        site=query.site,
        approach=query.approach,
        lanes_same_way=query.lanes_same_way,
        lane_beside=query.lane_beside,
        lane=query.lane if query.site in (Site.PAST_ON_RAMP, Site.PAST_OFF_RAMP) else None,
        most_lanes=query.most_lanes if query.site is Site.ROUNDABOUT else None,
        arms=query.arms,
        across=query.across,
        by_exit=query.by_exit,
    )
    known = kept(network, "_at_sites", lambda _: dict[tuple[str, RouteQuery, int], tuple[_Candidate, ...]]())
    if (map_name, way, variant) not in known:
        known[map_name, way, variant] = tuple(_ways_at_site(network, map_name, way, variant))
    yield from (one for one in known[map_name, way, variant] if _offers(network, _first_lane(network, one), query))


def _ways_at_site(network: Any, map_name: str, query: RouteQuery, variant: int) -> Iterator[_Candidate]:
    for group, route in routes_at(network, map_name, query, variant):
        if shapely.contains_xy(_drivable(network), route.line.points).all():
            yield _Candidate(variant, group, route)


def _first_lane(network: Any, found: _Candidate) -> Any:
    return network.elements[found.route.lane_ids[0]]


@kept_with_network()
def _drivable(network: Any) -> Any:
    """All lanes, and the seams between them."""
    area = shapely.buffer(network.drivableRegion.polygons, _SEAM)
    shapely.prepare(area)
    return area


# Junctions


def place_of(intersection: Any) -> Place:
    """How many arms one of Scenic's intersections has, as a place."""
    return {3: Place.THREE_WAY, 4: Place.FOUR_WAY}.get(arms(intersection), Place.JUNCTION)


def _through_junctions(network: Any, map_name: str, query: RouteQuery, variant: int) -> Iterator[_Candidate]:
    kinds = junction_kinds(network)
    for intersection in sorted(network.intersections, key=lambda i: str(i.uid)):
        if kinds[intersection.uid] is not JunctionKind.CROSSING:
            continue
        if query.place not in (None, Place.JUNCTION, place_of(intersection)):
            continue
        if query.arms not in (None, arms(intersection)):
            continue
        maneuvers = [m for m in intersection.maneuvers if TURNS.get(m.type.name) is query.maneuver]
        for maneuver in sorted(maneuvers, key=lambda m: (m.startLane.uid, m.endLane.uid)):
            approach = APPROACHES[variant] * (1.0 if query.approach is None else query.approach / APPROACHES[0])
            control = control_before(intersection, maneuver.startLane)
            if query.shape is not None and query.shape is not shape_from(intersection, maneuver.startLane):
                continue
            if query.control not in (None, control) or not _offers(network, maneuver.startLane, query):
                continue
            route = _junction_route(network, maneuver, map_name, approach)
            if route is None:
                continue
            if not query.conflicting_from or set(query.conflicting_from) <= {
                path.from_side for path in conflicting_paths(network, route)
            }:
                yield _Candidate(variant, str(intersection.uid), route)


@kept_with_network(ALL_LEGS)
def _junction_route(network: Any, maneuver: Any, map_name: str, approach: float) -> Route | None:
    runs = lane_runs(network)
    before, after = runs[maneuver.startLane.uid], runs[maneuver.endLane.uid]
    start, end = before.line.length - approach, min(EXIT, after.line.length)
    if start < 2 or end < 15:
        return None
    line = Polyline.join(
        before.line.between(start, before.line.length),
        centre_line(maneuver.connectingLane),
        after.line.between(0.0, end),
    )
    if not _goes(line, TURNS[maneuver.type.name]):
        return None
    return Route(
        id="",
        map_name=map_name,
        maneuver=TURNS[maneuver.type.name],
        place=place_of(maneuver.intersection),
        control=junction_control(maneuver.intersection),
        line=line.resampled(1.0),
        lane_ids=(
            *before.ids_between(start, before.line.length),
            maneuver.connectingLane.uid,
            *after.ids_between(0.0, end),
        ),
        event_at=approach,
        junction=str(maneuver.intersection.uid),
    )


def from_line(network: Any, route: Route, to_line: float = TO_LINE) -> tuple[Route, Polyline | None]:
    """A route that begins where a car waits that wants into its junction, and the way to there; as it is without one.

    Args:
        network: Scenic's road network.
        route: A route from `find_routes`.
        to_line: How far its middle is from the junction's entry [m].
    """
    if route.junction is None:
        return route, None
    begin = route.event_at - to_line
    x, y = route.line.point_at(begin)
    lanes = list(route.lane_ids)
    while len(lanes) > 1 and not shapely.contains_xy(network.elements[lanes[0]].polygons, x, y):
        lanes.pop(0)
    cut = replace(
        route,
        id=f"{route.id}-at-line" + ("" if to_line == TO_LINE else f"-{to_line:g}"),
        line=route.line.between(begin, route.length),
        lane_ids=tuple(lanes),
        event_at=to_line,
    )
    return cut, route.line.between(0.0, begin)


def _goes(line: Polyline, maneuver: Maneuver) -> bool:
    """Whether a whole route turns as its manoeuvre says; on a winding approach it may not."""
    left = turned(line, 0.0, line.length)
    if maneuver is Maneuver.STRAIGHT:
        return abs(left) < CURVED_ROAD
    return _LEAST_TURNED < (left if maneuver is Maneuver.LEFT_TURN else -left) < _MOST_TURNED


# Open road


def _along_roads(network: Any, map_name: str, query: RouteQuery, variant: int) -> Iterator[_Candidate]:
    wanted = query.place or Place.ROAD
    for run in dict.fromkeys(lane_runs(network).values()):
        window = next(islice(windows(network, run, wanted, query), variant, None), None)
        if window is None or not _offers(network, run.lane_at(window[0]), query):
            continue
        found = on_road(network, run, *window, query)
        if found is not None:
            line, lanes, event_at = found
            if not _is_lane(run.lane_at(window[0] + event_at), query):
                continue  # another lane begins, or ends, before what happens there
            route = Route(
                id="",
                map_name=map_name,
                maneuver=query.maneuver,
                place=Place.CURVE if includes(Place.CURVE, wanted) else wanted,
                control=Control.NONE,
                line=line.resampled(1.0),
                lane_ids=lanes,
                event_at=event_at,
            )
            yield _Candidate(variant, str(run.lanes[0].road.uid), route)


def _offers(network: Any, lane: Any, query: RouteQuery) -> bool:
    """Whether a lane has the neighbours and the surroundings a query asks for."""
    elsewhere = query.setting is not None and not lies_in(network, lane, query.setting)
    if elsewhere or (query.divided and is_two_way(lane)):
        return False
    there = len(lane.group.lanes)
    if not query.lanes_same_way <= there <= (query.most_lanes or there):
        return False
    left, right = section_beside(lane.sections[0], 1), section_beside(lane.sections[0], -1)
    if not _is_lane(lane, query) or (query.lane_beside == "none" and len(lane.group.lanes) > 1):
        return False
    if query.lane_beside in ("left", "right"):
        there = left if query.lane_beside == "left" else right
        if there is None or opposes(lane, there.lane):
            return False
    if query.opposite_lane is None:
        return True
    return (left is not None and opposes(lane, left.lane)) == query.opposite_lane


def _is_lane(lane: Any, query: RouteQuery) -> bool:
    """Whether it is the lane that a query asks for, counted from the outermost or, below 0, from the innermost."""
    return query.lane is None or query.lane in ((number := _number_of(lane)), number - len(lane.group.lanes) - 1)


def _number_of(lane: Any) -> int:
    """Which lane of its direction it is where it starts, 1 for the outermost."""
    section, number = lane.sections[0], 1
    while section._laneToRight is not None and section._laneToRight.isForward == section.isForward:
        section, number = section._laneToRight, number + 1
    return number
