"""The packaged outskirts: what the plan gives, and what readers of OpenDRIVE make of it."""

from __future__ import annotations

import math
import xml.etree.ElementTree as ET
from typing import Any

import pytest

from chatscene.maps.lane_runs import lane_runs
from chatscene.maps.network import load_network, resolve_map
from chatscene.maps.survey import check_map
from chatscene.maps.writing.opendrive import write_opendrive
from chatscene.maps.writing.streets import Node, Street
from chatscene.terms.scenario import Control
from making.maps.outskirts import plan

OUTSKIRTS = resolve_map("outskirts")
NETWORK: Any = load_network(OUTSKIRTS)
ROOT = ET.parse(OUTSKIRTS).getroot()


def test_the_packaged_map_is_what_the_plan_gives_byte_for_byte() -> None:
    assert write_opendrive("outskirts", plan(), located=True).encode() == OUTSKIRTS.read_bytes()


def test_it_is_smaller_than_the_town() -> None:
    assert OUTSKIRTS.stat().st_size < resolve_map("town").stat().st_size


def test_its_header_says_where_it_lies_and_how_far_it_reaches() -> None:
    header = ROOT.find("header")
    assert header is not None
    assert "+proj=tmerc" in (header.findtext("geoReference") or "")
    west, south, east, north = (float(header.get(side, "nan")) for side in ("west", "south", "east", "north"))
    x0, y0, x1, y1 = NETWORK.drivableRegion.polygons.bounds
    assert west < x0 < x1 < east
    assert south < y0 < y1 < north


def test_it_has_no_faults() -> None:
    assert check_map(OUTSKIRTS) == ()


def test_every_lane_leads_on_but_those_that_taper_out_beside_one_that_does() -> None:
    stuck = [lane for lane in NETWORK.lanes if not lane.maneuvers]
    assert len(stuck) == 4
    for lane in stuck:
        assert math.dist(lane.leftEdge.points[-1][:2], lane.rightEdge.points[-1][:2]) < 0.01
        assert lane.sections[-1]._laneToLeft.lane.maneuvers
        assert lane.sections[-1]._laneToLeft.isForward == lane.sections[-1].isForward


def test_one_can_drive_from_every_lane_to_every_other() -> None:
    lanes = [lane for lane in NETWORK.lanes if lane.maneuvers]
    after = {lane.uid: _beyond(lane) for lane in NETWORK.lanes}
    for start in lanes[:3]:
        reached, ahead = {start.uid}, [start.uid]
        while ahead:
            fresh = after[ahead.pop()] - reached
            reached |= fresh
            ahead += fresh
        assert reached == {lane.uid for lane in NETWORK.lanes}


def _beyond(lane: Any) -> set[str]:
    """Where one can get from a lane: on from its end, or into a lane of its direction beside it."""
    ways = {(m.connectingLane or m.endLane).uid for m in lane.maneuvers}
    if lane._successor is not None:
        ways.add(lane._successor.uid)
    sides = [side for part in lane.sections for side in (part._laneToLeft, part._laneToRight) if side is not None]
    return ways | {side.lane.uid for side in sides if side.isForward == lane.sections[0].isForward}


def test_the_carriageways_have_three_lanes_for_300_m_without_a_junction() -> None:
    runs = {run.lanes[0].uid: run for run in lane_runs(NETWORK).values()}
    wide = [run for run in runs.values() if len(run.lanes[0].group.lanes) == 3 and run.line.length > 300]
    assert len({run.lanes[0].road.uid for run in wide}) >= 2
    assert all(run.lanes[0].road.backwardLanes is None for run in wide)


def test_carla_can_drive_on_everywhere_and_sees_the_crosswalk(capfd: pytest.CaptureFixture[str]) -> None:
    carla = pytest.importorskip("carla", reason="the carla client has no wheel for this Python")
    world_map = carla.Map("outskirts", OUTSKIRTS.read_text())
    told = capfd.readouterr()
    assert "WARNING" not in told.out + told.err
    (*corners, first) = world_map.get_crosswalks()
    assert len(corners) == 4
    assert corners[0] == first
    assert {mark.type for mark in world_map.get_all_landmarks()} == {"1000001", "206", "224"}
    ends = {(w.road_id, w.lane_id) for w in world_map.generate_waypoints(2.0) if not w.next(3.0)}
    assert len(ends) == 4  # where lanes taper out
    assert {road for road, _ in ends} == {street.id for street in plan() if street.ceases}


def test_corners_that_leave_no_room_for_each_other_are_refused() -> None:
    a, b = (Node(id=number, x=200.0 * number, y=0.0, control=Control.NONE) for number in (1, 2))
    with pytest.raises(ValueError, match="overlap by"):
        write_opendrive("tight", [Street(id=1, start=a, end=b, lanes=1, via=((300.0, 80.0, 900.0),))])


def test_a_street_that_goes_on_in_another_must_say_where() -> None:
    node = Node(id=1, x=0.0, y=0.0, control=Control.NONE)
    with pytest.raises(ValueError, match="street 2 needs the place"):
        write_opendrive("open", [Street(id=1, start=node, end=2, lanes=1)])
