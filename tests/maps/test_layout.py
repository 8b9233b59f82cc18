"""What junctions are, whatever the map calls them.

The maps in ``netconvert`` were made from the ``.osm`` files beside them, which are ours, by SUMO 1.28.0 with
``netconvert --no-turnarounds --ramps.guess --roundabouts.guess --junctions.join --tls.guess-signals
--default.lanewidth 3.5 --precision 3``; its comment and its dates were taken out.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from chatscene.errors import MapError
from chatscene.maps.furniture import Stand, furniture_of
from chatscene.maps.junctions import junction_control, junction_signals
from chatscene.maps.layout import (
    JunctionKind,
    arms,
    junction_kinds,
    motorway_groups,
    ramp_ways,
    roundabouts,
    weaving_sections,
)
from chatscene.maps.network import load_network, resolve_map
from chatscene.maps.routes import BASE_SCENARIO_QUERIES, find_routes
from chatscene.maps.survey import check_map, describe_map
from chatscene.terms.scenario import Control
from places import SHARED

MADE = Path(__file__).with_name("netconvert")
TOWN: Any = load_network(resolve_map("town"))
OUTSKIRTS: Any = load_network(resolve_map("outskirts"))


def _count(network: Any, kind: JunctionKind) -> int:
    return list(junction_kinds(network).values()).count(kind)


def test_the_town_has_crossings_and_nothing_else() -> None:
    assert set(junction_kinds(TOWN).values()) == {JunctionKind.CROSSING}
    assert roundabouts(TOWN) == weaving_sections(TOWN) == motorway_groups(TOWN) == ()
    assert all(arms(junction) == len(junction.roads) for junction in TOWN.intersections)


def test_the_outskirts_are_described_as_what_they_are() -> None:
    found = describe_map(resolve_map("outskirts"))
    assert found.junctions == {"3-way none": 4, "3-way stop-sign": 2, "4-way signal": 1}
    assert (found.roundabouts, found.merges, found.diverges, found.weaving_sections) == (1, 2, 2, 1)
    assert (found.crosswalks, found.parking_strips, found.bus_bays) == (1, 2, 2)
    assert 2.0 < found.motorway_kilometres < 2.2


def test_two_roads_of_one_direction_each_are_one_arm() -> None:
    (crossing,) = (j for j in OUTSKIRTS.intersections if junction_control(j) is Control.SIGNAL)
    assert len(crossing.roads) == 5
    assert arms(crossing) == 4


def test_a_crossing_made_by_netconvert_has_four_arms_and_lights() -> None:
    network: Any = load_network(MADE / "crossing.xodr")
    (crossing,) = network.intersections
    assert len(crossing.roads) == 8
    assert arms(crossing) == 4
    assert junction_control(crossing) is Control.SIGNAL
    lines = junction_signals(network, crossing.uid)
    assert len(lines) == 4
    assert {line.control for line in lines} == {Control.SIGNAL}
    lights = [light for line in lines for light in line.lights]
    assert sorted(lights, key=lambda light: int(light[2:])) == [f"1_{number}" for number in range(len(lights))]
    assert len(lights) == 12
    assert describe_map(MADE / "crossing.xodr").junctions == {"4-way signal": 1}
    assert describe_map(MADE / "crossing.xodr").routes["red-light-running"] == 10


def test_a_roundabout_made_by_netconvert_is_one() -> None:
    network: Any = load_network(MADE / "roundabout.xodr")
    (ring,) = roundabouts(network)
    assert ring.junctions == {junction.uid for junction in network.intersections}
    assert describe_map(MADE / "roundabout.xodr").junctions == {}


def test_a_motorway_made_by_netconvert_has_a_merge_and_a_diverge() -> None:
    network: Any = load_network(MADE / "motorway.xodr")
    assert (_count(network, JunctionKind.MERGE), _count(network, JunctionKind.DIVERGE)) == (1, 1)
    assert 1.1 < sum(group.centerline.length for group in motorway_groups(network)) / 1000 < 1.3
    assert all(len(m.startLane.group.lanes) == 1 for m in ramp_ways(network, JunctionKind.MERGE))
    assert all(len(m.endLane.group.lanes) == 1 for m in ramp_ways(network, JunctionKind.DIVERGE))


def test_ramps_are_those_that_join_and_leave_the_carriageways() -> None:
    carriageways = {group.uid for group in motorway_groups(OUTSKIRTS)}
    for kind, ramp, main in (
        (JunctionKind.MERGE, "startLane", "endLane"),
        (JunctionKind.DIVERGE, "endLane", "startLane"),
    ):
        ways = ramp_ways(OUTSKIRTS, kind)
        assert len(ways) == 2
        for way in ways:
            assert len(getattr(way, ramp).group.lanes) == 1
            assert getattr(way, main).group.uid in carriageways


def test_the_weaving_section_is_240_m_long_and_has_a_fourth_lane() -> None:
    (weave,) = weaving_sections(OUTSKIRTS)
    lane = OUTSKIRTS.elements[weave.first]
    assert weave.first == weave.last
    assert len(lane.group.lanes) == 4
    assert lane.centerline.length == pytest.approx(240, abs=0.1)
    assert lane.sections[0]._laneToRight is None


def test_no_base_scenario_drives_through_a_merge_a_diverge_or_a_roundabout() -> None:
    kinds = junction_kinds(OUTSKIRTS)
    seen = 0
    for query in (query for queries in BASE_SCENARIO_QUERIES.values() for query in queries):
        for route in find_routes(OUTSKIRTS, "outskirts", query):
            seen += 1
            assert route.junction is None or kinds[route.junction] is JunctionKind.CROSSING
    assert seen > 80


def test_a_map_of_ramps_alone_has_no_turn() -> None:
    network: Any = load_network(MADE / "roundabout.xodr")
    for query in (query for queries in BASE_SCENARIO_QUERIES.values() for query in queries):
        try:
            routes = find_routes(network, "roundabout", query)
        except MapError:
            continue
        assert all(route.junction is None for route in routes)


@pytest.mark.parametrize("name", ["crossing", "roundabout", "motorway"])
def test_what_netconvert_made_has_no_faults_but_its_own(name: str) -> None:
    problems = check_map(MADE / f"{name}.xodr")
    assert problems == () if name != "motorway" else all("without a way through" in problem for problem in problems)


def test_the_crosswalk_lies_across_its_street_between_junctions() -> None:
    ((road, area),) = furniture_of(OUTSKIRTS).crosswalks
    street = next(r for r in OUTSKIRTS.roads if r.id == road)
    assert area.area == pytest.approx(40)
    assert all(lane.polygons.intersects(area) for lane in street.lanes)
    assert OUTSKIRTS.intersectionRegion.polygons.distance(area) > 80


def test_buses_stop_and_cars_park_on_both_sides_of_the_street() -> None:
    for use in Stand:
        places = [place for place in furniture_of(OUTSKIRTS).standing if place.use is use]
        assert {place.forward for place in places} == {True, False}
    assert {place.end - place.start for place in furniture_of(OUTSKIRTS).standing} == {65.0, 140.0}


@pytest.mark.parametrize(("name", "merges", "diverges"), [("Town04", 6, 2), ("Town06", 4, 6)])
def test_the_motorways_of_carla_have_ramps(name: str, merges: int, diverges: int) -> None:
    path = SHARED / "data" / "maps" / f"{name}.xodr"
    if not path.is_file():
        pytest.skip(f"{name}.xodr is not beside this repository")
    network = load_network(path)
    assert (_count(network, JunctionKind.MERGE), _count(network, JunctionKind.DIVERGE)) == (merges, diverges)
    assert sum(group.centerline.length for group in motorway_groups(network)) > 2000
