"""Questions about a map: lanes under a track, stop lines, the drawing, the description."""

from __future__ import annotations

import json
import math
from dataclasses import asdict
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from numpy.typing import NDArray
from shapely import Polygon

from chatscene.errors import MapError
from chatscene.maps.drawing import map_drawing
from chatscene.maps.furniture import furniture_of
from chatscene.maps.junctions import junction_control, junction_signals
from chatscene.maps.lane_map import LaneMap
from chatscene.maps.lane_runs import centre_line
from chatscene.maps.network import load_network, resolve_map
from chatscene.maps.survey import check_map, describe_map
from chatscene.terms.polyline import Polyline
from chatscene.terms.scenario import BaseScenario, Control
from places import SHARED

TOWN = resolve_map("town")
DATA = SHARED / "data" / "maps"
NETWORK: Any = load_network(TOWN)
LANES = LaneMap(NETWORK)
MAIN_LANES = {lane.uid: lane for road in NETWORK.roads for lane in road.lanes}


def _line(lane: Any) -> NDArray[Any]:
    return centre_line(lane).points


@settings(max_examples=40)
@given(uid=st.sampled_from(sorted(MAIN_LANES)), where=st.floats(0.02, 0.98), aside=st.floats(-1.5, 1.5))
def test_a_point_near_a_centre_line_lies_in_that_lane_and_on_the_road(uid: str, where: float, aside: float) -> None:
    line = _line(MAIN_LANES[uid])
    at = where * (len(line) - 1)
    i = int(at)
    step = line[i + 1] - line[i]
    normal = np.array([-step[1], step[0]]) / np.hypot(*step)
    xy = (line[i] + (at - i) * step + aside * normal)[None, :]
    assert LANES.lane_ids[int(LANES.lane_index(xy)[0])] == uid
    assert not LANES.off_road(xy)[0]


def test_shoulders_sidewalks_and_fields_are_off_the_road() -> None:
    shoulder = NETWORK.shoulders[0].centerline.points
    sidewalk = NETWORK.sidewalks[0].centerline.points
    xy = np.array([[*p[:2]] for p in (*shoulder[:3], *sidewalk[:3])] + [[9e3, 9e3]])
    assert LANES.off_road(xy).all()
    assert (LANES.lane_index(xy) == -1).all()


def test_the_tolerance_at_the_edge_of_the_road_is_a_tenth_of_a_metre() -> None:
    edge = np.array(NETWORK.roads[0].forwardLanes.rightEdge.points)[:, :2]
    along = edge[1] - edge[0]
    away = np.array([along[1], -along[0]]) / np.hypot(*along)  # to the right of the lane's direction
    xy = edge[0] + 0.4 * along + np.array([[0.08], [0.12]]) * away
    assert LANES.off_road(xy).tolist() == [False, True]


def test_where_lanes_overlap_the_lanes_of_the_route_win() -> None:
    junction = next(j for j in NETWORK.intersections if j.is4Way)
    for maneuver in junction.maneuvers:
        lane = maneuver.connectingLane
        inside = Polyline(_line(lane)).resampled(1.0).points[1:-1]
        indices = LANES.lane_index(inside, along=(lane.uid,))
        assert {LANES.lane_ids[i] for i in indices.tolist()} == {lane.uid}


def test_no_points_are_in_no_lane() -> None:
    nothing = np.empty((0, 2))
    assert LANES.lane_index(nothing).shape == LANES.off_road(nothing).shape == (0,)


def test_every_incoming_lane_has_one_stop_line_across_its_end() -> None:
    for junction in NETWORK.intersections:
        lines = junction_signals(NETWORK, junction.uid)
        assert {line.lane for line in lines} == {lane.uid for lane in junction.incomingLanes}
        for line in lines:
            end = _line(NETWORK.elements[line.lane])[-2:]
            middle = ((line.x0 + line.x1) / 2, (line.y0 + line.y1) / 2)
            assert math.dist(middle, end[1]) < 0.05
            assert math.dist((line.x0, line.y0), (line.x1, line.y1)) == pytest.approx(3.5, abs=0.01)
            way = math.atan2(*(end[1] - end[0])[::-1])
            assert abs(math.remainder(line.heading - way, 2 * math.pi)) < 0.01


def test_each_stop_line_has_the_control_of_its_junction() -> None:
    for junction in NETWORK.intersections:
        controls = {line.control for line in junction_signals(NETWORK, junction.uid)}
        assert controls == {junction_control(junction)}


def test_an_unknown_junction_is_named() -> None:
    with pytest.raises(MapError, match="intersection999"):
        junction_signals(NETWORK, "intersection999")


def test_a_drawing_lies_inside_its_box_and_is_plain_json() -> None:
    x0, y0, x1, y1 = NETWORK.intersections[3].polygons.bounds
    box = (x0 - 40, y0 - 40, x1 + 40, y1 + 40)
    drawing = map_drawing(NETWORK, box)
    assert json.loads(json.dumps(drawing)) == drawing
    assert all(drawing.values())
    rings = [
        ring for kind in ("roads", "junctions", "shoulders", "sidewalks") for area in drawing[kind] for ring in area
    ]
    lines = [entry["points"] for kind in ("lane_boundaries", "stop_lines") for entry in drawing[kind]]
    for x, y in (point for points in rings + lines for point in points):
        assert box[0] - 0.01 <= x <= box[2] + 0.01
        assert box[1] - 0.01 <= y <= box[3] + 0.01
        assert (x, y) == (round(x, 2), round(y, 2))
    assert {entry["kind"] for entry in drawing["lane_boundaries"]} == {"solid", "dashed", "centre"}


def test_a_crosswalk_is_drawn_as_stripes_across_the_street_and_only_where_there_is_one() -> None:
    network = load_network(resolve_map("outskirts"))
    ((_, area),) = furniture_of(network).crosswalks
    stripes = [Polygon(rings[0]) for rings in map_drawing(network, area.bounds)["crosswalks"]]
    assert len(stripes) == 10
    assert all(area.buffer(0.05).contains(stripe) for stripe in stripes)
    assert "crosswalks" not in map_drawing(NETWORK, NETWORK.intersections[3].polygons.bounds)


def test_cycle_lanes_driveways_and_rails_are_drawn_as_what_they_are() -> None:
    road = load_network(resolve_map("road:1+1,cycle-lane,tram,driveway=right"))
    drawing = map_drawing(road, (-60.0, -40.0, 60.0, 40.0))
    assert len(drawing["cycle_lanes"]) == 2
    assert len(drawing["driveways"]) == 1
    assert len(drawing["rails"]) == 4  # of a track each way
    assert "crosswalks" not in drawing
    assert not {"cycle_lanes", "driveways", "rails"} & map_drawing(NETWORK, (9e3, 9e3, 9.1e3, 9.1e3)).keys()


def test_a_drawing_of_nowhere_is_empty() -> None:
    assert not any(map_drawing(NETWORK, (9e3, 9e3, 9.1e3, 9.1e3)).values())


def test_the_town_is_described_with_ten_routes_or_more_for_every_base_scenario() -> None:
    described = asdict(describe_map(TOWN))
    assert json.loads(json.dumps(described)) == described
    assert set(described["routes"]) == {base.value for base in BaseScenario}
    assert min(described["routes"].values()) >= 10
    assert sum(described["junctions"].values()) == len(NETWORK.intersections)


@pytest.mark.parametrize("name", ["Town01", "Town04", "Town10HD"])
def test_a_town_of_carla_can_be_asked_the_same_questions(name: str) -> None:
    path = DATA / f"{name}.xodr"
    if not path.is_file():
        pytest.skip(f"{name}.xodr is not beside this repository")
    network = load_network(path)
    lanes = LaneMap(network)
    for junction in network.intersections:
        lines = junction_signals(network, junction.uid)
        assert all(2.0 < math.dist((s.x0, s.y0), (s.x1, s.y1)) < 6.0 for s in lines)
        if junction_control(junction) is not Control.NONE:
            assert any(line.control is junction_control(junction) for line in lines)
    for lane in network.lanes:
        assert not lanes.off_road(_line(lane)).any()
    assert describe_map(path).routes["turning-obstacle"] > 0
    assert check_map(path) == ()
    assert map_drawing(network, network.intersections[0].polygons.bounds)["junctions"]
