"""The packaged geometries: each has routes on a packaged map, no two are the same, and they keep their word."""

from __future__ import annotations

import ast
import math
import re
from functools import cache
from itertools import combinations
from typing import Any

import numpy as np
import pytest

from chatscene.errors import MapError
from chatscene.library.compatibility import compatibility, ways_of
from chatscene.library.load import load_library
from chatscene.maps.crossings import conflicting_paths
from chatscene.maps.network import load_network, map_with, resolve_map
from chatscene.program.meaning import maneuver_of
from chatscene.terms.route import Route
from chatscene.terms.scenario import Component, Maneuver, Place, Site, includes
from chatscene.terms.snippet import Snippet
from chatscene.world.ego_route import routes_for
from chatscene.world.places import besideRoad, neighbourPath, trafficFrom, wayOf

GEOMETRIES = load_library().of(Component.GEOMETRY)
TRAFFIC = {"trafficFromLeft": "left", "trafficFromRight": "right", "oncomingTraffic": "oncoming"}

each = pytest.mark.parametrize("geometry", GEOMETRIES, ids=lambda g: g.id)


def _query(geometry: Snippet) -> dict[str, Any]:
    """What a geometry asks `selectRoute` for."""
    call = re.search(r"selectRoute\(.*\)", geometry.source)
    assert call is not None
    parsed = ast.parse(call[0], mode="eval").body
    assert isinstance(parsed, ast.Call)
    return {str(keyword.arg): ast.literal_eval(keyword.value) for keyword in parsed.keywords}


@cache
def _routes(geometry_id: str) -> tuple[Route, ...]:
    geometry = next(g for g in GEOMETRIES if g.id == geometry_id)
    return routes_for(
        _network(geometry.slots.site), str(resolve_map(map_with(geometry.slots.site))), **_query(geometry)
    )


def _network(site: Site | None) -> Any:
    return load_network(resolve_map(map_with(site)))


def _ways(routes: tuple[Route, ...]) -> frozenset[bytes]:
    return frozenset(np.round(route.line.points, 2).tobytes() for route in routes)


def _start(route: Route) -> Any:
    return _network(route.site).elements[route.lane_ids[0]]


@each
def test_a_packaged_map_has_two_routes_or_more_for_a_geometry(geometry: Snippet) -> None:
    assert len(_routes(geometry.id)) >= 2


def test_no_two_geometries_give_the_same_names_on_the_same_routes() -> None:
    same = [
        (one.id, other.id)
        for one, other in combinations(GEOMETRIES, 2)
        if set(one.provides) == set(other.provides) and _ways(_routes(one.id)) == _ways(_routes(other.id))
    ]
    assert not same


@each
def test_the_routes_of_a_geometry_are_what_its_facts_say(geometry: Snippet) -> None:
    facts = geometry.slots
    for route in _routes(geometry.id):
        assert maneuver_of(route) is facts.maneuver
        assert facts.control in (None, route.control)
        assert facts.place is not None
        if facts.place in (Place.LEFT_CURVE, Place.RIGHT_CURVE):
            turned = math.remainder(route.line.heading_at(route.length) - route.start_heading, 2 * math.pi)
            assert (turned > 0) == (facts.place is Place.LEFT_CURVE)
        else:
            assert includes(facts.place, route.place)


@each
def test_lanes_and_a_lane_of_oncoming_traffic_are_there_where_a_geometry_says_so(geometry: Snippet) -> None:
    for route in _routes(geometry.id):
        lane = _start(route)
        assert geometry.slots.lanes in (None, len(lane.group.lanes))
        left = lane.sections[0]._laneToLeft
        against = left is not None and left.lane.group is not lane.group
        assert geometry.slots.two_way in (None, against)
        if "oppositeLane" in geometry.provides:
            assert against
        for side in ("left", "right"):
            if f"{side}Lane" in geometry.provides:
                beside = neighbourPath(_ego(route), side)
                assert math.cos(beside.heading_at(5.0) - route.start_heading) > 0.9


@each
def test_traffic_that_a_geometry_names_can_cross_the_ego_on_each_of_its_routes(geometry: Snippet) -> None:
    named = {side for name, side in TRAFFIC.items() if name in geometry.provides}
    for route in _routes(geometry.id):
        assert named <= {path.from_side for path in conflicting_paths(_network(route.site), route)}


@each
def test_who_goes_straight_on_has_an_arm_to_go_on_into_on_each_route(geometry: Snippet) -> None:
    joint = compatibility(load_library())
    straight = [ways_of(behavior) == ("straight",) for behavior in joint.behaviors]
    joined = joint.mask[straight, joint.geometries.index(geometry)].any(axis=0)
    sides = {TRAFFIC[arm] for spawn, ok in zip(joint.spawns, joined, strict=True) if ok for arm in TRAFFIC
             if arm in spawn.requires}  # fmt: skip
    for route in _routes(geometry.id):
        assert sides <= {
            p.from_side for p in conflicting_paths(_network(route.site), route) if p.turn is Maneuver.STRAIGHT
        }


def test_at_a_three_way_junction_nobody_goes_straight_on_out_of_the_side_road() -> None:
    for route in _routes("geometry/straight-three-way-side-left"):
        traffic = trafficFrom(_ego(route), "left")
        assert wayOf(traffic, ("straight", "left-turn")).turn is Maneuver.LEFT_TURN
        with pytest.raises(MapError, match="no traffic from the left meets the ego's route in a straight"):
            wayOf(traffic, "straight")


@each
def test_the_lane_at_the_kerb_has_no_other_to_its_right(geometry: Snippet) -> None:
    if "kerbLane" not in geometry.provides:
        return
    for route in _routes(geometry.id):
        edge = besideRoad(_ego(route), 10.0, "right", 0.0)
        assert abs(route.line.project(edge.x, edge.y)[1]) < 2.1


def _ego(route: Route) -> Any:
    from chatscene.world.ego_route import EgoRoute

    return EgoRoute(route, _network(route.site), 1)
