"""What maps offer that ``chatscene map import`` made: see ``tests/simulate/confined/test_netconvert.py``."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pytest

from chatscene.maps.drawing import map_drawing
from chatscene.maps.junctions import junction_control
from chatscene.maps.lane_map import LaneMap
from chatscene.maps.layout import motorway_groups, roundabouts
from chatscene.maps.neighbours import neighbour_line, opposes, section_beside
from chatscene.maps.network import PACKAGED, load_network, resolve_map
from chatscene.maps.routes import BASE_SCENARIO_QUERIES, find_routes
from chatscene.maps.survey import check_map, describe_map
from chatscene.terms.route import RouteQuery
from chatscene.terms.scenario import BaseScenario, Control, Maneuver, Site
from chatscene.world.ego_route import EgoRoute
from chatscene.world.places import lanesBeside
from places import SHARED

MADE = Path(__file__).with_name("osm")
(BYPASS,) = BASE_SCENARIO_QUERIES[BaseScenario.VEHICLE_PASSING]
NONE_ELSEWHERE = {BaseScenario.STRAIGHT_OBSTACLE, BaseScenario.VEHICLE_PASSING}
SERVED = {
    "crossing": set(BaseScenario) - {BaseScenario.CROSSING_NEGOTIATION},
    "roundabout": NONE_ELSEWHERE,
    "motorway": set(BaseScenario) - {BaseScenario.RED_LIGHT_RUNNING, BaseScenario.UNPROTECTED_LEFT_TURN},
}


def _network(name: str) -> Any:
    return load_network(MADE / f"{name}.xodr")


@pytest.mark.parametrize("name", SERVED)
def test_an_imported_map_serves_the_base_scenarios_that_it_has_places_for(name: str) -> None:
    described = describe_map(MADE / f"{name}.xodr")
    assert {base for base, count in described.routes.items() if count} == SERVED[name]
    assert set(described.lacking) == set(BaseScenario) - SERVED[name]


def test_what_a_map_has_not_is_told_as_the_one_thing_that_is_missing() -> None:
    assert describe_map(MADE / "crossing.xodr").lacking == {"crossing-negotiation": "control none"}
    lacking = describe_map(MADE / "motorway.xodr").lacking
    assert lacking == {"red-light-running": "place four-way, control signal", "unprotected-left-turn": "control signal"}


def test_the_crossing_has_four_arms_lights_and_sidewalks() -> None:
    described = describe_map(MADE / "crossing.xodr")
    assert described.junctions == {"4-way signal": 1}
    assert described.sidewalks == 12  # two along each arm, and one round each corner
    assert check_map(MADE / "crossing.xodr") == ()
    (junction,) = _network("crossing").intersections
    assert junction_control(junction) is Control.SIGNAL


def test_the_roundabout_is_one_and_is_driven_round() -> None:
    network = _network("roundabout")
    (ring,) = roundabouts(network)
    assert ring.junctions == {junction.uid for junction in network.intersections}
    for maneuver in (Maneuver.LEFT_TURN, Maneuver.STRAIGHT, Maneuver.RIGHT_TURN):
        assert find_routes(network, "roundabout", RouteQuery(maneuver=maneuver, site=Site.ROUNDABOUT))


def test_the_motorway_has_carriageways_that_are_parted_and_ramps() -> None:
    network = _network("motorway")
    groups = motorway_groups(network)
    assert groups
    assert all(section_beside(lane.sections[0], 1) is None for g in groups for lane in g.lanes[-1:])
    for site in (Site.MOTORWAY, Site.ON_RAMP, Site.OFF_RAMP):
        assert find_routes(network, "motorway", RouteQuery(maneuver=Maneuver.STRAIGHT, site=site))


@pytest.mark.parametrize("name", SERVED)
def test_a_bypass_leads_through_the_oncoming_lane_of_another_road(name: str) -> None:
    network = _network(name)
    lanes = LaneMap(network)
    for route in find_routes(network, name, BYPASS):
        first, used = (network.elements[uid] for uid in (route.lane_ids[0], route.lane_ids[-1]))
        assert first.road is not used.road
        assert opposes(first, used)
        assert not lanes.off_road(route.line.points).any()
        line = neighbour_line(network, route, "left")
        along, left, _ = line.project(*route.line.point_at(0.0))
        assert abs(math.remainder(line.heading_at(along) - route.start_heading - math.pi, 2 * math.pi)) < 0.05
        assert left == pytest.approx(3.5, abs=0.1)
        assert [against for _, against in lanesBeside(EgoRoute(route, network, 1))] == [True]


def test_oncoming_lanes_of_two_roads_are_each_beside_the_other() -> None:
    network = _network("crossing")
    sections = [lane.sections[0] for road in network.roads for lane in road.lanes]
    pairs = {s.uid: there.uid for s in sections if (there := section_beside(s, 1)) and opposes(s.lane, there.lane)}
    assert len(pairs) == 8
    assert all(pairs[there] == uid for uid, there in pairs.items())


@pytest.mark.parametrize("name", ["town", "outskirts", "region", "Town04"])
def test_lanes_of_two_roads_that_only_meet_are_not_beside_each_other(name: str) -> None:
    path = SHARED / "data" / "maps" / f"{name}.xodr"
    if name not in PACKAGED and not path.is_file():
        pytest.skip(f"{path.name} is not beside this repository")
    network: Any = load_network(PACKAGED.get(name, path))
    sections = [section for road in network.roads for lane in road.lanes for section in lane.sections]
    assert all(section_beside(section, 1) is section._laneToLeft for section in sections)
    assert all(section_beside(section, -1) is section._laneToRight for section in sections)


def test_a_street_of_two_roads_is_rural_where_it_has_no_sidewalk() -> None:
    rural = RouteQuery(maneuver=Maneuver.BYPASS, site=Site.RURAL)
    assert find_routes(_network("motorway"), "motorway", rural)


def test_the_line_between_two_directions_is_painted_once_whichever_road_they_are_in() -> None:
    for path, streets in ((MADE / "roundabout.xodr", 4), (resolve_map("outskirts"), None)):
        network: Any = load_network(path)
        lines = map_drawing(network, network.drivableRegion.polygons.bounds)["lane_boundaries"]
        centres = [line for line in lines if line["kind"] == "centre"]
        assert centres
        assert streets in (None, len(centres))
