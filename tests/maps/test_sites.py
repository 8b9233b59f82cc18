"""Routes at sites: round, on, off, beside, past; on the road, without a kink, in the lanes they name."""

from __future__ import annotations

import math
import re
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

from chatscene.errors import MapError
from chatscene.maps.crossings import conflicting_paths
from chatscene.maps.furniture import Stand, furniture_of
from chatscene.maps.lane_map import LaneMap
from chatscene.maps.layout import JunctionKind as Kind
from chatscene.maps.layout import motorway_groups, ramp_ways, roundabouts, weaving_sections
from chatscene.maps.network import load_network, map_with, resolve_map
from chatscene.maps.routes import find_routes
from chatscene.terms.route import Route, RouteQuery
from chatscene.terms.scenario import Control, Maneuver, Place, Site
from places import SHARED

NETWORK: Any = load_network(resolve_map("outskirts"))
LANES = LaneMap(NETWORK)
MADE = Path(__file__).with_name("netconvert")
QUERIES = [
    *(
        RouteQuery(maneuver=m, site=Site.ROUNDABOUT)
        for m in (Maneuver.RIGHT_TURN, Maneuver.STRAIGHT, Maneuver.LEFT_TURN)
    ),
    *(RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.MOTORWAY, lanes_same_way=3, lane=lane) for lane in (1, 2, 3)),
    RouteQuery(maneuver=Maneuver.LANE_CHANGE_LEFT, site=Site.MOTORWAY),
    RouteQuery(maneuver=Maneuver.LANE_CHANGE_RIGHT, site=Site.MOTORWAY),
    RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.ON_RAMP),
    RouteQuery(maneuver=Maneuver.LANE_CHANGE_LEFT, site=Site.ON_RAMP),
    RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.OFF_RAMP),
    RouteQuery(maneuver=Maneuver.LANE_CHANGE_RIGHT, site=Site.OFF_RAMP),
    RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.WEAVING),
    RouteQuery(maneuver=Maneuver.LANE_CHANGE_LEFT, site=Site.WEAVING),
    RouteQuery(maneuver=Maneuver.LANE_CHANGE_RIGHT, site=Site.WEAVING),
    RouteQuery(maneuver=Maneuver.LANE_CHANGE_LEFT, site=Site.LANE_DROP),
    RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.RURAL),
    RouteQuery(maneuver=Maneuver.BYPASS, site=Site.RURAL),
    RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.RURAL, place=Place.LEFT_CURVE),
    RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.RURAL, place=Place.RIGHT_CURVE),
    RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.CROSSWALK),
    RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.PARKING),
    RouteQuery(maneuver=Maneuver.STRAIGHT, site=Site.BUS_BAY),
]


def _routes(**query: Any) -> tuple[Route, ...]:
    return find_routes(NETWORK, "outskirts", RouteQuery(**query))


def _check(route: Route, query: RouteQuery, network: Any, lanes: LaneMap, bend: float) -> None:
    step = np.diff(route.line.points, axis=0)
    heading = np.unwrap(np.arctan2(step[:, 1], step[:, 0]))
    assert np.hypot(*step.T).max() < 1.2
    assert np.abs(np.diff(heading)).max() < bend
    assert not lanes.off_road(route.line.points).any()
    assert 80 <= route.length <= 270
    assert 0 < route.event_at < route.length
    assert route.maneuver is query.maneuver
    assert route.control is Control.NONE
    inside = lanes.lane_index(route.line.points, route.lane_ids)
    assert {lanes.lane_ids[i] for i in inside.tolist()} <= set(route.lane_ids)
    assert all(uid in network.elements for uid in route.lane_ids)


@pytest.mark.parametrize("query", QUERIES, ids=lambda query: query.slug)
def test_the_outskirts_have_routes_for_each_site(query: RouteQuery) -> None:
    routes = find_routes(NETWORK, "outskirts", query)
    assert len(routes) >= 4
    assert len({route.id for route in routes}) == len(routes)
    for route in routes:
        _check(route, query, NETWORK, LANES, 0.1)
    again = find_routes(NETWORK, "outskirts", query)
    assert all(np.array_equal(a.line.points, b.line.points) for a, b in zip(routes, again, strict=True))


def test_routes_of_different_sites_have_different_names() -> None:
    names = [query.slug for query in QUERIES]
    assert len(set(names)) == len(names)
    assert RouteQuery(maneuver=Maneuver.STRAIGHT).slug == "straight"


@pytest.mark.parametrize(
    ("maneuver", "turned"), [(Maneuver.RIGHT_TURN, -90), (Maneuver.STRAIGHT, 0), (Maneuver.LEFT_TURN, 90)]
)
def test_a_roundabout_is_gone_round_counter_clockwise_to_the_exit_asked_for(maneuver: Maneuver, turned: int) -> None:
    (ring,) = roundabouts(NETWORK)
    for route in _routes(maneuver=maneuver, site=Site.ROUNDABOUT):
        turn = math.remainder(route.line.heading_at(route.length) - route.start_heading, 2 * math.pi)
        assert math.degrees(turn) == pytest.approx(turned, abs=3)
        assert route.junction in ring.junctions
        assert set(route.lane_ids) & set(ring.lanes)
        angle = np.unwrap(np.arctan2(route.line.points[:, 1], route.line.points[:, 0]))
        near = np.hypot(*route.line.points.T) < 25
        assert (np.diff(angle[near]) > 0).all()


def test_who_enters_a_roundabout_meets_who_goes_round() -> None:
    for route in _routes(maneuver=Maneuver.STRAIGHT, site=Site.ROUNDABOUT)[:4]:
        assert "left" in {path.from_side for path in conflicting_paths(NETWORK, route)}


@pytest.mark.parametrize("lane", [1, 2, 3])
def test_a_lane_of_the_motorway_is_counted_from_the_outermost(lane: int) -> None:
    carriageways = {group.uid for group in motorway_groups(NETWORK)}
    for route in _routes(maneuver=Maneuver.STRAIGHT, site=Site.MOTORWAY, lanes_same_way=3, lane=lane):
        first = NETWORK.elements[route.lane_ids[0]]
        assert first.group.uid in carriageways
        beside, right = first.sections[0]._laneToRight, 1
        while beside is not None:
            beside, right = beside._laneToRight, right + 1
        assert right == lane


@pytest.mark.parametrize("site", [Site.ON_RAMP, Site.OFF_RAMP])
def test_a_ramp_is_driven_and_with_a_lane_change_the_next_lane_of_the_motorway(site: Site) -> None:
    on = site is Site.ON_RAMP
    ways = ramp_ways(NETWORK, Kind.MERGE if on else Kind.DIVERGE)
    ramps = {(m.startLane if on else m.endLane).uid for m in ways}
    change = Maneuver.LANE_CHANGE_LEFT if on else Maneuver.LANE_CHANGE_RIGHT
    for maneuver in (Maneuver.STRAIGHT, change):
        routes = _routes(maneuver=maneuver, site=site)
        ends = {route.lane_ids[0 if on else -1] for route in routes}
        assert ends == ramps
        for route in routes:
            beside = np.array([route.line.point_at(route.length - 5 if on else route.event_at)])
            other = NETWORK.elements[LANES.lane_ids[int(LANES.lane_index(beside, route.lane_ids)[0])]]
            assert (other.sections[0]._laneToRight is None) == (maneuver is Maneuver.STRAIGHT)


def test_weaving_is_between_the_ramps_that_share_a_lane() -> None:
    (weave,) = weaving_sections(NETWORK)
    for maneuver in (Maneuver.STRAIGHT, Maneuver.LANE_CHANGE_LEFT, Maneuver.LANE_CHANGE_RIGHT):
        for route in _routes(maneuver=maneuver, site=Site.WEAVING):
            assert weave.first in route.lane_ids


def test_a_lane_that_tapers_out_is_left_while_it_is_wide() -> None:
    for route in _routes(maneuver=Maneuver.LANE_CHANGE_LEFT, site=Site.LANE_DROP):
        assert NETWORK.elements[route.lane_ids[-1]].maneuvers
        over = route.line.point_at(route.event_at)
        lane = NETWORK.elements[LANES.lane_ids[int(LANES.lane_index(np.array([over]), route.lane_ids)[0])]]
        assert lane.leftEdge.lineString.distance(shapely.Point(over)) > 1.2


def test_a_crosswalk_lies_where_the_event_is() -> None:
    ((_, area),) = furniture_of(NETWORK).crosswalks
    for route in _routes(maneuver=Maneuver.STRAIGHT, site=Site.CROSSWALK):
        assert area.distance(shapely.Point(route.line.point_at(route.event_at))) < 0.2
        assert area.distance(shapely.Point(route.line.point_at(route.event_at - 2))) > 1


@pytest.mark.parametrize(("site", "use"), [(Site.PARKING, Stand.PARKING), (Site.BUS_BAY, Stand.BUS)])
def test_a_bay_begins_on_the_right_where_the_event_is(site: Site, use: Stand) -> None:
    roads = {place.road for place in furniture_of(NETWORK).standing if place.use is use}
    for route in _routes(maneuver=Maneuver.STRAIGHT, site=site):
        lane = NETWORK.elements[route.lane_ids[0]]
        assert lane.road.id in roads
        x, y = route.line.point_at(route.event_at + 20)
        right = route.line.heading_at(route.event_at + 20) - math.pi / 2
        bay = shapely.Point(x + 4.0 * math.cos(right), y + 4.0 * math.sin(right))
        assert lane.group.shoulder.polygons.contains(bay)


def test_a_place_beside_a_taper_is_no_lane_to_change_into() -> None:
    """On no route of the base scenarios lies a lane change into a lane that is still, or already, too narrow."""
    for maneuver in (Maneuver.LANE_CHANGE_LEFT, Maneuver.LANE_CHANGE_RIGHT):
        for route in _routes(maneuver=maneuver, lanes_same_way=2):
            for s in np.arange(route.event_at + 25, route.length, 5):
                lane = NETWORK.elements[route.lane_ids[-1]]
                point = shapely.Point(route.line.point_at(s))
                if lane.polygons.contains(point):
                    width = lane.leftEdge.lineString.distance(point) + lane.rightEdge.lineString.distance(point)
                    assert width > 2.2


def test_a_map_without_a_site_says_so() -> None:
    town: Any = load_network(resolve_map("town"))
    for site in set(Site) - {Site.RURAL}:
        with pytest.raises(MapError, match=f"'town' has no place for .* the {site}"):
            find_routes(town, "town", RouteQuery(maneuver=Maneuver.STRAIGHT, site=site))


def test_a_turn_is_not_looked_for_along_a_motorway() -> None:
    with pytest.raises(MapError, match="no route leads through a junction and along the motorway"):
        _routes(maneuver=Maneuver.LEFT_TURN, site=Site.MOTORWAY)


@pytest.mark.parametrize(
    ("name", "sites"),
    [("roundabout", (Site.ROUNDABOUT,)), ("motorway", (Site.MOTORWAY, Site.ON_RAMP, Site.OFF_RAMP))],
)
def test_what_netconvert_made_serves_the_sites_it_has(name: str, sites: tuple[Site, ...]) -> None:
    network: Any = load_network(MADE / f"{name}.xodr")
    lanes = LaneMap(network)
    for site in sites:
        query = RouteQuery(maneuver=Maneuver.STRAIGHT, site=site)
        for route in find_routes(network, name, query):
            _check(route, query, network, lanes, 0.25)


def test_a_town_of_carla_serves_its_ramps() -> None:
    path = SHARED / "data" / "maps" / "Town04.xodr"
    if not path.is_file():
        pytest.skip("Town04.xodr is not beside this repository")
    network: Any = load_network(path)
    lanes = LaneMap(network)
    for site in (Site.MOTORWAY, Site.ON_RAMP, Site.OFF_RAMP):
        query = RouteQuery(maneuver=Maneuver.STRAIGHT, site=site)
        for route in find_routes(network, "Town04", query):
            assert not lanes.off_road(route.line.points).any()


@pytest.mark.parametrize("site", list(Site))
def test_who_names_no_map_gets_the_one_that_has_the_site(site: Site) -> None:
    town, maneuvers = load_network(resolve_map("town")), (Maneuver.STRAIGHT, Maneuver.LANE_CHANGE_LEFT)
    found: list[Route] = []
    for maneuver in maneuvers:
        query = RouteQuery(maneuver=maneuver, site=site)
        with pytest.raises(MapError, match=re.escape(f"name no map, or the map {map_with(site)!r}")):
            find_routes(town, "town", query)
        with suppress(MapError):
            found += find_routes(load_network(resolve_map(map_with(site))), map_with(site), query)
    assert found
    assert {route.site for route in found} == {site}
