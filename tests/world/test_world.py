"""Driving along a line, signals on a clock, and what stands beside the road."""

import math
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.errors import MapError
from chatscene.maps.network import load_network, resolve_map
from chatscene.simulate.embedded.dynamics import VehicleBody
from chatscene.terms.actors import LIMITS
from chatscene.terms.polyline import Polyline
from chatscene.world.control import CURVE_ACCELERATION, Tracker, curve_speeds, pedals
from chatscene.world.ego_route import choose_route
from chatscene.world.places import laneLine, neighbourPath, ownLane, ownWay, shortOfJunction, trafficFrom, wayOf
from chatscene.world.signals import MODES, signal_states

DT = 0.1
EAST = Polyline([(float(x), 0.0) for x in range(200)])


def circle(radius: float) -> Polyline:
    angles = np.arange(0, math.pi, 1 / radius)
    return Polyline(np.column_stack((radius * np.sin(angles), radius * (1 - np.cos(angles)))))


def drive(body: VehicleBody, tracker: Tracker, speed: float, steps: int) -> None:
    limits = body.limits
    assert limits.wheelbase
    for _ in range(steps):
        pose = body.x, body.y, body.heading, body.speed
        body.throttle, body.brake, body.steer = tracker.controls(pose, speed)
        body.step(DT)


@settings(max_examples=30)
@given(st.floats(-3, 3), st.floats(-0.4, 0.4), st.floats(2, 15), st.sampled_from(["Car", "Truck", "Motorcycle"]))
def test_a_vehicle_set_beside_its_line_comes_back_to_it(offset: float, turn: float, speed: float, kind: str) -> None:
    limits = LIMITS[kind]
    body = VehicleBody(0.0, offset, turn, limits, speed)
    drive(body, Tracker(EAST, limits.wheelbase, limits.wheel_angle), speed, 100)
    assert abs(body.y) < 0.3


def test_a_circle_is_driven_at_the_speed_its_radius_allows() -> None:
    line = circle(20.0)
    middle = curve_speeds(line)[len(line) // 2]
    assert middle == pytest.approx(math.sqrt(CURVE_ACCELERATION * 20.0), rel=0.02)
    assert min(curve_speeds(EAST)) > 100


def test_a_driver_slows_before_a_curve_and_not_in_it() -> None:
    line = Polyline.join(EAST, Polyline(circle(10.0).points + np.array((200.0, 0.0))))
    caps = curve_speeds(line)
    assert caps[0] > caps[150] > caps[190] > caps[199]


@given(st.floats(0, 30), st.floats(0, 30))
def test_pedals_are_never_pressed_together(speed: float, wish: float) -> None:
    throttle, brake = pedals(speed, wish)
    assert 0.0 <= throttle <= 1.0
    assert 0.0 <= brake <= 1.0
    assert throttle * brake == 0.0


@pytest.mark.parametrize("mode", MODES)
def test_crossing_axes_never_have_green_at_once(mode: str) -> None:
    own, other = (signal_states(mode, axis, 600, DT) for axis in (True, False))
    assert len(own) == len(other) == 600
    assert not any(a in "gy" and b in "gy" for a, b in zip(own, other, strict=True))


def test_a_held_signal_does_not_change() -> None:
    assert set(signal_states("ego-green", True, 50, DT)) == {"g"}
    assert set(signal_states("ego-red", True, 50, DT)) == {"r"}
    for mode, shown in (("ego-turns-green", "rg"), ("ego-turns-red", "gyr"), ("ego-yellow", "gyr")):
        own, other = (signal_states(mode, axis, 150, DT) for axis in (True, False))
        assert "".join(dict.fromkeys(own)) == shown
        assert all("r" in pair for pair in zip(own, other, strict=True))
    assert signal_states("ego-yellow", True, 60, DT)[50] == "y"


TOWN = resolve_map("town")


def route(**query: Any):
    return choose_route(load_network(TOWN), str(TOWN), 0, **query)


def test_the_lane_beside_the_ego_begins_level_with_it() -> None:
    ego = route(maneuver="lane-change-left", lanes=2)
    beside = neighbourPath(ego, "left")
    x, y = beside.point_at(0.0)
    along, left, _ = ownLane(ego).project(x, y)
    assert along == pytest.approx(0.0, abs=0.2)
    assert left == pytest.approx(3.5, abs=0.1)


def test_whoever_leads_the_ego_stays_in_its_lane_where_it_changes_lanes_and_else_goes_its_way() -> None:
    changing, turning = route(maneuver="lane-change-left", lanes=2), route(maneuver="left-turn")
    assert ownWay(changing).heading_at(0.0) == pytest.approx(ownWay(changing).heading_at(40.0), abs=0.05)
    assert ownWay(turning) is turning.line


def test_a_place_beside_the_road_ends_before_a_junction() -> None:
    turning, straight = route(maneuver="left-turn"), route(maneuver="straight", place="road")
    assert shortOfJunction(turning, 500.0) == turning.eventAt - 3.0
    assert shortOfJunction(turning, 5.0) == 5.0
    assert shortOfJunction(straight, 500.0) == 500.0


def test_an_opposing_lane_runs_against_the_ego() -> None:
    ego = route(maneuver="bypass", opposite=True)
    against = neighbourPath(ego, "left").heading_at(10.0) - ego.line.heading_at(0.0)
    assert math.cos(against) == pytest.approx(-1.0, abs=1e-3)


def test_a_lane_that_is_not_there_is_named() -> None:
    with pytest.raises(MapError, match="no lane to its right"):
        neighbourPath(route(maneuver="bypass", opposite=True), "right")


def test_traffic_that_crosses_comes_from_where_it_says() -> None:
    ego = route(maneuver="straight", place="four-way", control="signal", crossed=("left",))
    way = wayOf(trafficFrom(ego, "left"), "straight")
    x, y = way.line.point_at(max(way.entry - 5.0, 0.0))
    assert ego.line.project(x, y)[1] > 2.0
    near = ego.line.project(*way.line.point_at(way.meets_at))
    assert abs(near[1]) < 2.6
    assert near[0] == pytest.approx(way.ego_meets_at, abs=1.5)


def test_a_lane_goes_on_through_junctions() -> None:
    network = load_network(TOWN)
    lane = min((lane for lane in network.lanes if lane.maneuvers), key=lambda lane: lane.uid)
    assert laneLine(lane, 500.0).length >= 500.0
