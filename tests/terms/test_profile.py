"""How fast a line can be driven, place by place, and how long that takes."""

from __future__ import annotations

import math

import numpy as np
import pytest

from chatscene.maps.lane_runs import lane_runs
from chatscene.maps.limits import MOTORWAY, limits_of
from chatscene.maps.network import PACKAGED, load_network
from chatscene.terms.polyline import Polyline
from chatscene.terms.profile import COMFORTABLE, CURVE_ACCELERATION, Timetable, allowed_speeds, bend_speeds

STRAIGHT = Polyline([(0.0, 0.0), (200.0, 0.0)]).resampled(1.0)


def bend(radius: float, chord_error: float = 0.05, approach: float = 150.0) -> Polyline:
    """A quarter of a circle between straight pieces, drawn with corners as a map draws it."""
    corners = max(math.ceil(math.pi / 2 * radius / math.sqrt(8 * chord_error * radius)), 2)
    turned = np.linspace(0.0, math.pi / 2, corners + 1).tolist()
    arc = [(radius * math.sin(a), radius * (1 - math.cos(a))) for a in turned]
    return Polyline([(-approach, 0.0), *arc, (radius, radius + approach)]).resampled(1.0)


@pytest.mark.parametrize("radius", [6.0, 10.0, 15.0, 50.0, 100.0, 250.0, 600.0])
@pytest.mark.parametrize("chord_error", [0.0005, 0.05])
def test_a_bend_is_driven_at_what_its_radius_allows_however_it_is_drawn(radius: float, chord_error: float) -> None:
    line = bend(radius, chord_error)
    inside = slice(int(150 + 0.3 * radius), int(150 + 1.2 * radius) + 1)
    speeds, wanted = bend_speeds(line)[inside], math.sqrt(CURVE_ACCELERATION * radius)
    assert np.median(speeds) == pytest.approx(wanted, rel=0.02)
    assert bend_speeds(line).min() >= 0.94 * wanted


def test_nothing_holds_back_on_a_straight_road_and_at_corners_that_the_drawing_makes() -> None:
    assert np.isinf(allowed_speeds(STRAIGHT)).all()
    rng = np.random.default_rng(5)
    x = np.arange(0.0, 300.0)
    assert bend_speeds(Polyline(np.column_stack((x, rng.normal(0.0, 0.02, len(x)))))).min() > 40.0


def test_the_packaged_motorway_holds_nobody_back_who_drives_as_fast_as_is_allowed_there() -> None:
    network = load_network(PACKAGED["outskirts"])
    limits = limits_of(network)
    runs = [run for run in lane_runs(network).values() if limits[run.lanes[0].road.id].at(1.0) == MOTORWAY]
    assert len(runs) > 5
    assert min(bend_speeds(run.line.resampled(1.0)).min() for run in runs) > MOTORWAY


def test_one_slows_in_time_for_a_bend_and_for_a_lower_limit() -> None:
    line = bend(10.0)
    limits = np.full(len(line) - 1, 22.0)
    limits[:20] = 30.0
    speeds = allowed_speeds(line, limits)
    arcs = np.array(line.columns[2])
    assert (np.diff(speeds**2) >= -2.0 * COMFORTABLE * np.diff(arcs)[:-1] - 1e-9).all()
    assert speeds[19] == pytest.approx(math.sqrt(22.0**2 + 2 * COMFORTABLE), abs=0.05)
    assert speeds.max() < 30.0
    assert speeds[30] == 22.0
    assert speeds.min() == pytest.approx(math.sqrt(3.0 * 10.0), rel=0.03)


def test_a_timetable_says_when_a_place_is_passed() -> None:
    limits = np.full(200, 20.0)
    limits[100:] = 10.0
    table = Timetable(STRAIGHT, limits, wanted=25.0)
    assert table.time_at(100.0) == pytest.approx(5.0)
    assert table.time_to(50.0, 150.0) == pytest.approx(7.5)
    assert table.time_to(150.0, 50.0) == pytest.approx(-7.5)
    assert Timetable(STRAIGHT, limits, wanted=5.0).time_to(0.0, 200.0) == pytest.approx(40.0)
    assert (table.speed_at(-5.0), table.speed_at(99.5), table.speed_at(500.0)) == (20.0, 20.0, 10.0)


def test_a_timetable_goes_on_beyond_both_ends() -> None:
    table = Timetable(STRAIGHT, np.full(200, 20.0), wanted=10.0)
    assert table.time_at(-10.0) == pytest.approx(-1.0)
    assert table.time_at(220.0) == pytest.approx(22.0)


def test_behind_a_bend_speed_is_taken_up_by_and_by() -> None:
    limits = np.full(200, 20.0)
    limits[:50] = 10.0
    speeds = Timetable(STRAIGHT, limits, wanted=20.0, gain=2.0).speeds
    assert speeds[49] == 10.0
    assert speeds[100] == pytest.approx(math.sqrt(10.0**2 + 2 * 2.0 * 51))
    assert speeds[-1] == 20.0
