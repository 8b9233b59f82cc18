"""The packaged town and the OpenDRIVE writer behind it."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from collections import Counter
from itertools import combinations, pairwise
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from asam_checker import assert_nothing_wrong
from chatscene.maps.junctions import junction_control
from chatscene.maps.network import load_network, resolve_map
from chatscene.maps.writing.opendrive import write_opendrive
from chatscene.maps.writing.streets import Node, Street
from chatscene.terms.scenario import Control
from making.maps.town import plan

TOWN = resolve_map("town")


@pytest.fixture(scope="module")
def network() -> Any:
    return load_network(TOWN)


def test_the_packaged_map_is_what_the_plan_gives_byte_for_byte() -> None:
    assert write_opendrive("town", plan()).encode() == TOWN.read_bytes()


def test_the_packaged_map_is_small() -> None:
    assert TOWN.stat().st_size < 600_000


def test_scenic_reads_every_road_and_junction_of_the_plan(network: Any) -> None:
    streets = plan()
    assert len(network.roads) == len(streets)
    assert len(network.intersections) == len({node for s in streets for node in (s.start, s.end)})


def test_there_are_two_signalised_and_two_unsignalised_four_way_junctions(network: Any) -> None:
    kinds = Counter(junction_control(j) for j in network.intersections if j.is4Way)
    assert kinds[Control.SIGNAL] >= 2
    assert kinds[Control.NONE] + kinds[Control.STOP_SIGN] >= 2
    assert kinds[Control.STOP_SIGN] >= 1


def test_three_way_junctions_come_with_every_control(network: Any) -> None:
    assert {junction_control(j) for j in network.intersections if j.is3Way} == set(Control)


def test_straights_of_220_m_come_with_one_and_with_two_lanes_each_way(network: Any) -> None:
    long = [road for road in network.roads if road.centerline.length >= 220]
    assert {(len(r.forwardLanes.lanes), len(r.backwardLanes.lanes)) for r in long} >= {(1, 1), (2, 2)}


def test_every_street_has_a_shoulder_and_a_sidewalk_on_both_sides(network: Any) -> None:
    for road in network.roads:
        for group in (road.forwardLanes, road.backwardLanes):
            assert group._shoulder is not None
            assert group._sidewalk is not None


def test_sidewalks_run_on_round_corners(network: Any) -> None:
    """Along streets and round corners they make a few long strips; each street end alone would make many."""
    walkway = network.sidewalkRegion.polygons.buffer(0.1)
    pieces = [part.area for part in getattr(walkway, "geoms", [walkway])]
    blocks = len(network.intersections) - len(network.roads)  # Euler: faces of a planar graph, but for the sign
    assert len(pieces) == 2 - blocks


def test_every_lane_leads_on(network: Any) -> None:
    ends = [lane.uid for lane in network.lanes if not lane.maneuvers]
    assert ends == []


def test_every_junction_has_straight_left_and_right_ways_that_conflict(network: Any) -> None:
    for junction in network.intersections:
        assert {m.type.name for m in junction.maneuvers} == {"STRAIGHT", "LEFT_TURN", "RIGHT_TURN"}
        assert any(m.conflictingManeuvers for m in junction.maneuvers)


def test_there_is_a_curved_street() -> None:
    arcs = [geometry for road in _roads(TOWN) for geometry in road.iter("arc") if road.get("junction") == "-1"]
    assert arcs


def test_signals_and_stop_signs_are_in_the_file() -> None:
    kinds = {signal.get("type") for road in _roads(TOWN) for signal in road.iter("signal")}
    assert kinds == {"1000001", "206"}


def test_carla_reads_the_packaged_map() -> None:
    carla = pytest.importorskip("carla", reason="the carla client has no wheel for this Python")
    world_map = carla.Map("town", TOWN.read_text())
    assert len(world_map.generate_waypoints(5.0)) > 1000
    assert {mark.type for mark in world_map.get_all_landmarks()} == {"1000001", "206"}


@pytest.mark.parametrize("name", ["town", "outskirts", "region"])
def test_the_asam_checker_finds_nothing_wrong(caplog: pytest.LogCaptureFixture, name: str) -> None:
    _, checks = assert_nothing_wrong(resolve_map(name), caplog, "opendrive")
    assert checks > 15


# Three or four streets, in twelfths of a turn, with at least a quarter between neighbours.
STARS = [
    found
    for count in (3, 4)
    for found in combinations(range(12), count)
    if all((b - a) % 12 >= 3 for a, b in pairwise((*found, found[0])))
]


@settings(max_examples=15)
@given(
    angles=st.sampled_from(STARS),
    lanes=st.integers(1, 2),
)
def test_reference_lines_join_end_to_end_without_a_kink(angles: tuple[int, ...], lanes: int) -> None:
    hub = Node(id=1, x=0.0, y=0.0, control=Control.SIGNAL)
    streets = [
        Street(id=i, start=hub, end=_ring_node(i + 1, angle), lanes=lanes)
        for i, angle in enumerate(sorted(angles), start=1)
    ]
    for road in ET.fromstring(write_opendrive("star", streets)).iter("road"):
        pieces = [_piece(geometry) for geometry in road.iter("geometry")]
        assert math.isclose(sum(piece["length"] for piece in pieces), float(road.get("length", "0")), abs_tol=1e-6)
        for before, after in pairwise(pieces):
            x, y, heading = _end(before)
            assert math.isclose(before["s"] + before["length"], after["s"], abs_tol=1e-6)
            assert math.hypot(after["x"] - x, after["y"] - y) < 1e-4
            assert abs(math.remainder(after["hdg"] - heading, 2 * math.pi)) < 1e-5


def _ring_node(number: int, angle: int) -> Node:
    direction = angle * math.pi / 6
    return Node(id=number, x=200 * math.cos(direction), y=200 * math.sin(direction), control=Control.NONE)


def _roads(path: Path) -> list[ET.Element]:
    return list(ET.parse(path).getroot().iter("road"))


def _piece(geometry: ET.Element) -> dict[str, float]:
    piece = {name: float(geometry.get(name, "nan")) for name in ("s", "x", "y", "hdg", "length")}
    arc = geometry.find("arc")
    return {**piece, "curvature": 0.0 if arc is None else float(arc.get("curvature", "nan"))}


def _end(piece: dict[str, float]) -> tuple[float, float, float]:
    length, curvature = piece["length"], piece["curvature"]
    turned = length * curvature
    ahead, left = (math.sin(turned) / curvature, (1 - math.cos(turned)) / curvature) if curvature else (length, 0.0)
    c, s = math.cos(piece["hdg"]), math.sin(piece["hdg"])
    return piece["x"] + ahead * c - left * s, piece["y"] + ahead * s + left * c, piece["hdg"] + turned
