"""Routes: as the query says, diverse, on the road, and always the same."""

from __future__ import annotations

import math
from itertools import product
from typing import Any

import numpy as np
import pytest

from chatscene.errors import MapError
from chatscene.maps.crossings import conflicting_paths
from chatscene.maps.junctions import junction_control
from chatscene.maps.lane_map import LaneMap
from chatscene.maps.network import load_network, resolve_map
from chatscene.maps.routes import BASE_SCENARIO_QUERIES, find_routes
from chatscene.terms.route import Route, RouteQuery
from chatscene.terms.scenario import BaseScenario, Control, Maneuver, Place
from places import SHARED

DATA = SHARED / "data" / "maps"
NETWORK: Any = load_network(resolve_map("town"))
LANES = LaneMap(NETWORK)
BASE = [(base, query) for base, queries in BASE_SCENARIO_QUERIES.items() for query in queries]
BASE_IDS = [f"{base}-{query.maneuver}" for base, query in BASE]
TURN = {Maneuver.LEFT_TURN: 90.0, Maneuver.RIGHT_TURN: -90.0}
AT_JUNCTION = [
    RouteQuery(maneuver=maneuver, place=place, control=control)
    for maneuver, place, control in product(
        (Maneuver.STRAIGHT, Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN),
        (Place.THREE_WAY, Place.FOUR_WAY, Place.JUNCTION),
        (None, *Control),
    )
]


def _turned(route: Route) -> float:
    """Net change of heading along a route [degrees], positive = left."""
    steps = np.diff(route.line.points, axis=0)
    heading = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
    return math.degrees(heading[-1] - heading[0])


def _check(route: Route, query: RouteQuery, network: Any, lanes: LaneMap) -> None:
    steps = np.hypot(*np.diff(route.line.points, axis=0).T)
    assert steps[:-1].max() < 1.2
    assert 75 <= route.length <= 140
    assert not lanes.off_road(route.line.points).any()
    assert route.maneuver is query.maneuver
    assert query.place in (None, Place.JUNCTION, route.place)
    assert query.control in (None, route.control)
    assert 0 < route.event_at < route.length
    assert all(uid in network.elements for uid in route.lane_ids)
    if route.junction is None:
        assert route.control is Control.NONE
    else:
        junction = network.elements[route.junction]
        assert route.control is junction_control(junction)
        assert junction.polygons.distance(_point(route, route.event_at)) < 0.5
        assert junction.polygons.distance(_point(route, route.event_at - 5)) > 2


def _point(route: Route, s: float) -> Any:
    import shapely

    return shapely.Point(route.line.point_at(s))


@pytest.mark.parametrize(("base", "query"), BASE, ids=BASE_IDS)
def test_the_town_has_ten_different_routes_for_each_base_scenario(base: BaseScenario, query: RouteQuery) -> None:
    routes = find_routes(NETWORK, "town", query)
    assert len(routes) == 10
    assert len({route.line.point_at(0.0) for route in routes}) == 10
    assert len({route.lane_ids for route in routes}) >= 8
    for route in routes:
        _check(route, query, NETWORK, LANES)


@pytest.mark.parametrize("query", AT_JUNCTION, ids=lambda q: f"{q.maneuver}-{q.place}-{q.control}")
def test_every_manoeuvre_is_found_at_every_kind_of_junction(query: RouteQuery) -> None:
    routes = find_routes(NETWORK, "town", query)
    assert len(routes) == 10
    for route in routes:
        _check(route, query, NETWORK, LANES)
        assert _turned(route) == pytest.approx(TURN.get(query.maneuver, 0.0), abs=3)


def test_the_town_has_ten_routes_round_a_curve() -> None:
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.CURVE)
    routes = find_routes(NETWORK, "town", query)
    assert len(routes) == 10
    for route in routes:
        _check(route, query, NETWORK, LANES)
        assert abs(_turned(route)) > 30


@pytest.mark.parametrize(("place", "sign"), [(Place.LEFT_CURVE, 1), (Place.RIGHT_CURVE, -1)])
def test_a_bend_to_a_side_turns_that_way_and_is_a_curve(place: Place, sign: int) -> None:
    routes = find_routes(NETWORK, "town", RouteQuery(maneuver=Maneuver.STRAIGHT, place=place))
    assert len(routes) == 10
    for route in routes:
        assert route.place is Place.CURVE
        assert sign * _turned(route) > 30


def test_a_bend_to_any_side_may_be_either() -> None:
    routes = find_routes(NETWORK, "town", RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.CURVE))
    assert {math.copysign(1, _turned(route)) for route in routes} == {-1, 1}


def test_no_lane_beside_means_the_only_lane_of_its_direction() -> None:
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.ROAD, lane_beside="none")
    for route in find_routes(NETWORK, "town", query):
        assert len(NETWORK.elements[route.lane_ids[0]].group.lanes) == 1
        assert "one-lane" in route.id


def test_a_map_without_a_narrow_one_way_street_says_so() -> None:
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.ROAD, lane_beside="none", opposite_lane=False)
    with pytest.raises(MapError, match="no second lane in the ego's direction"):
        find_routes(NETWORK, "town", query)


def test_a_bypass_away_from_oncoming_traffic_uses_a_lane_of_its_own_direction() -> None:
    query = RouteQuery(maneuver=Maneuver.BYPASS, place=Place.ROAD, lanes_same_way=2, opposite_lane=False)
    routes = find_routes(NETWORK, "town", query)
    assert len(routes) == 10
    for route in routes:
        own, other = route.lane_ids[:2]
        assert NETWORK.elements[own].group is NETWORK.elements[other].group
        lanes = [LANES.lane_ids[i] for i in LANES.lane_index(route.line.points).tolist()]
        assert lanes[0] == lanes[-1] == own
        assert lanes[round(route.event_at)] == other


@pytest.mark.parametrize("control", [Control.SIGNAL, Control.STOP_SIGN])
def test_straight_on_under_a_control_is_at_a_junction_that_has_it(control: Control) -> None:
    for route in find_routes(NETWORK, "town", RouteQuery(maneuver=Maneuver.STRAIGHT, control=control)):
        assert route.control is control
        assert route.junction is not None


def test_straight_on_across_traffic_is_at_a_junction() -> None:
    query = RouteQuery(maneuver=Maneuver.STRAIGHT, conflicting_from=("left",))
    for route in find_routes(NETWORK, "town", query):
        assert "left" in {path.from_side for path in conflicting_paths(NETWORK, route)}


def test_routes_of_different_queries_have_different_names() -> None:
    """A name stands for one route on a map: what is known of a route is kept by its name."""
    by_name: dict[str, Route] = {}
    for query in [query for _, query in BASE] + AT_JUNCTION:
        for route in find_routes(NETWORK, "town", query):
            other = by_name.setdefault(route.id, route)
            assert np.array_equal(other.line.points, route.line.points)
            assert other.lane_ids == route.lane_ids


def test_the_same_question_has_the_same_answer() -> None:
    for _, query in BASE:
        first, second = (find_routes(NETWORK, "town", query) for _ in range(2))
        assert [r.id for r in first] == [r.id for r in second]
        assert all(np.array_equal(a.line.points, b.line.points) for a, b in zip(first, second, strict=True))


def test_fewer_routes_are_the_first_of_more() -> None:
    query = BASE[0][1]
    few, more = find_routes(NETWORK, "town", query, count=3), find_routes(NETWORK, "town", query, count=10)
    assert [r.line.point_at(0) for r in few] == [r.line.point_at(0) for r in more[:3]]


def test_the_first_routes_are_spread_over_junctions() -> None:
    routes = find_routes(NETWORK, "town", RouteQuery(maneuver=Maneuver.LEFT_TURN))
    assert len({route.junction for route in routes}) == 10


@pytest.mark.parametrize("side", ["left", "right"])
def test_a_lane_change_ends_in_the_lane_beside(side: str) -> None:
    query = RouteQuery(maneuver=Maneuver(f"lane-change-{side}"), lanes_same_way=2)
    for route in find_routes(NETWORK, "town", query):
        first, last = LANES.lane_index(route.line.points)[[0, -1]]
        assert (LANES.lane_ids[first], LANES.lane_ids[last]) == (route.lane_ids[0], route.lane_ids[-1])
        start, end = (NETWORK.elements[uid].sections[0] for uid in (route.lane_ids[0], route.lane_ids[-1]))
        assert (start._laneToLeft if side == "left" else start._laneToRight) is end
        assert start.isForward == end.isForward


def test_a_bypass_passes_the_blocker_in_the_opposite_lane_and_comes_back() -> None:
    for route in find_routes(NETWORK, "town", RouteQuery(maneuver=Maneuver.BYPASS, opposite_lane=True)):
        own, opposite = route.lane_ids[:2]
        lanes = [LANES.lane_ids[i] for i in LANES.lane_index(route.line.points).tolist()]
        assert lanes[0] == lanes[-1] == own
        assert lanes[round(route.event_at)] == opposite
        group = NETWORK.elements[own].group
        assert NETWORK.elements[opposite].group is group._opposite
        assert len(group.lanes) == 1


@pytest.mark.parametrize(("base", "query"), BASE, ids=BASE_IDS)
def test_crossing_paths_meet_the_route_where_they_say(base: BaseScenario, query: RouteQuery) -> None:
    for route in find_routes(NETWORK, "town", query):
        paths = conflicting_paths(NETWORK, route)
        assert set(query.conflicting_from) <= {path.from_side for path in paths}
        for path in paths:
            assert 0 < path.entry <= path.meets_at + 1.0 <= path.line.length
            there = path.line.point_at(path.meets_at)
            assert math.dist(there, route.line.point_at(path.ego_meets_at)) < 3.0
            assert path.ego_meets_at >= route.event_at - 2.0
            came = math.degrees(
                math.remainder(
                    path.line.heading_at(path.entry - 1) - route.line.heading_at(route.event_at - 1),
                    2 * math.pi,
                )
            )
            assert came == pytest.approx(
                {"left": -90, "right": 90}.get(path.from_side, math.copysign(180, came)), abs=45
            )


def test_an_open_road_has_no_crossing_paths() -> None:
    route = find_routes(NETWORK, "town", RouteQuery(maneuver=Maneuver.STRAIGHT, place=Place.ROAD))[0]
    assert conflicting_paths(NETWORK, route) == ()


def test_what_a_map_lacks_is_said() -> None:
    query = RouteQuery(maneuver=Maneuver.LANE_CHANGE_LEFT, lanes_same_way=5)
    with pytest.raises(MapError, match=r"town.*lane-change-left.*5 lanes"):
        find_routes(NETWORK, "town", query)


@pytest.mark.parametrize(
    ("name", "serves", "lacks"),
    [
        (
            "Town01",
            {
                "straight-obstacle",
                "turning-obstacle",
                "vehicle-passing",
                "unprotected-left-turn",
                "right-turn",
            },
            {"lane-changing", "red-light-running", "crossing-negotiation"},
        ),
        (
            "Town04",
            {
                "straight-obstacle",
                "turning-obstacle",
                "lane-changing",
                "red-light-running",
                "unprotected-left-turn",
                "right-turn",
                "crossing-negotiation",
            },
            set[str](),
        ),
        (
            "Town10HD",
            {"straight-obstacle", "turning-obstacle", "lane-changing", "unprotected-left-turn", "right-turn"},
            set[str](),
        ),
    ],
)
def test_the_towns_of_carla_serve_what_they_have_the_geometry_for(name: str, serves: set[str], lacks: set[str]) -> None:
    path = DATA / f"{name}.xodr"
    if not path.is_file():
        pytest.skip(f"{name}.xodr is not beside this repository")
    network = load_network(path)
    lanes = LaneMap(network)
    found: set[str] = set()
    for base, query in BASE:
        try:
            routes = find_routes(network, name, query)
        except MapError as error:
            assert name in str(error)
            continue
        found.add(base.value)
        for route in routes:
            assert not lanes.off_road(route.line.points).any()
            steps = np.diff(route.line.points, axis=0)
            assert np.hypot(*steps.T).max() < 1.5
            assert (steps[1:] * steps[:-1]).sum(axis=1).min() > 0  # never back
            turned = _turned(route)
            if route.maneuver in TURN and route.junction is not None:
                assert 30 < math.copysign(1, TURN[route.maneuver]) * turned < 160
    assert serves <= found
    assert not lacks & found
