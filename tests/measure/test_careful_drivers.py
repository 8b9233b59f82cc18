"""The rules of reference drivers by hand, and all of the drivers on a crash behind a slower car."""

from __future__ import annotations

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from benchmarks.careful_drivers import (
    JERK,
    REFERENCE_DRIVERS,
    Ahead,
    Fuzzy,
    ResponsibilitySensitive,
    Rule,
    meet,
)
from blind import STRAIGHT, Blind, car_ahead
from chatscene.maps.network import resolve_map
from chatscene.measure.avoidability import FULL_BRAKE
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.episode import Episode, Role, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import Scene

EAST = Polyline([(float(x), 0.0) for x in range(300)])
STANDING = Ahead(gap=30.0, beside=0.0, along=0.0, inward=0.0)


def wish(rule: Rule, speed: float, gap: float, along: float = 0.0, beside: float = 0.0, inward: float = 0.0) -> float:
    return rule.braking(speed, 0.0, Ahead(gap=gap, beside=beside, along=along, inward=inward))


def test_the_jerk_is_that_of_the_regulation() -> None:
    assert pytest.approx(12.65, abs=0.01) == JERK


def test_rss_brakes_below_its_safe_distance_and_not_above() -> None:
    # 10 m/s for 0.75 s with 3 m/s² are 8.344 m; then 12.25 m/s come to a stand in 9.882 m.
    safe = 0.75 * (10.0 + 12.25) / 2.0 + 12.25**2 / (2.0 * FULL_BRAKE)
    assert safe == pytest.approx(18.22, abs=0.01)
    rule = ResponsibilitySensitive()
    assert wish(rule, 10.0, safe + 0.01) == 0.0
    assert wish(rule, 10.0, safe - 0.01) == FULL_BRAKE
    assert wish(rule, 10.0, safe - 0.01, along=10.0) == 0.0  # who drives on leaves room
    assert wish(rule, 10.0, safe + 5.0, along=-10.0) == FULL_BRAKE  # who comes the other way takes it


def test_rss_leaves_alone_who_is_far_enough_aside() -> None:
    # Standing, 0.75 s with 1 m/s² and as much again to a stand are 0.5625 m, and 0.3 m are kept.
    rule = ResponsibilitySensitive()
    assert wish(rule, 10.0, 5.0, beside=0.87) == 0.0
    assert wish(rule, 10.0, 5.0, beside=0.85) == FULL_BRAKE
    assert wish(rule, 10.0, 5.0, beside=2.0, inward=2.0) == FULL_BRAKE


def test_the_fuzzy_driver_brakes_comfortably_in_time_and_harder_the_later() -> None:
    rule = Fuzzy()
    # 10 m/s: 7.5 m to react, 12.5 m with 4 m/s², 8.33 m with 6 m/s², and 2 m kept twice.
    assert wish(rule, 10.0, 24.01) == 0.0
    assert 0.0 < wish(rule, 10.0, 22.0) < 4.0
    assert 4.0 < wish(rule, 10.0, 18.0) < 6.0
    assert wish(rule, 10.0, 15.8) == pytest.approx(6.0)


def test_the_fuzzy_driver_minds_who_comes_in_before_it_and_not_who_comes_later() -> None:
    rule = Fuzzy()
    assert wish(rule, 10.0, 15.0, beside=2.0, inward=2.0) > 0.0
    assert wish(rule, 10.0, 15.0, beside=4.0, inward=2.0) == 0.0
    assert wish(rule, 10.0, 15.0, beside=2.0) == 0.0


@given(
    speed=st.floats(0.0, 30.0),
    gap=st.floats(-5.0, 80.0),
    nearer=st.floats(0.0, 20.0),
    along=st.floats(-15.0, 30.0),
    acceleration=st.floats(-8.0, 3.0),
)
def test_no_driver_brakes_less_for_somebody_who_is_nearer(
    speed: float, gap: float, nearer: float, along: float, acceleration: float
) -> None:
    for rule in (ResponsibilitySensitive(), Fuzzy()):
        far, near = (
            rule.braking(speed, acceleration, Ahead(gap=g, beside=0.0, along=along, inward=0.0))
            for g in (gap, gap - nearer)
        )
        assert 0.0 <= far <= near + 1e-9


def still(x: float, y: float, heading: float, speed: float, role: Role) -> Track:
    row = {"x": x, "y": y, "heading": heading, "speed": speed}
    return Track(
        actor=role.value, role=role, kind="Car", length=4.0, width=2.0, **{k: np.array([v]) for k, v in row.items()}
    )


def test_who_is_ahead_is_met_along_the_route() -> None:
    ego = still(10.0, 0.0, 0.0, 8.0, Role.EGO)
    ahead = meet(ego, still(40.0, 0.0, 0.0, 5.0, Role.ADVERSARY), EAST)
    assert (ahead.gap, ahead.beside, ahead.along) == pytest.approx((26.0, 0.0, 5.0))
    crossing = meet(ego, still(40.0, -6.0, math.pi / 2, 3.0, Role.ADVERSARY), EAST)
    assert crossing.gap == pytest.approx(30.0 - 2.0 - 1.0)
    assert crossing.beside == pytest.approx(6.0 - 1.0 - 2.0 - 0.375)
    assert (crossing.along, crossing.inward) == pytest.approx((0.0, 3.0))
    leaving = meet(ego, still(40.0, 6.0, math.pi / 2, 3.0, Role.ADVERSARY), EAST)
    assert leaving.inward == pytest.approx(-3.0)


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings(simulator="native"))


def crash_behind(gap: float, simulator: Simulator) -> tuple[Episode, Scene]:
    scene = car_ahead(gap)
    driven = simulate(simulator, STRAIGHT, scene, Blind())
    assert isinstance(driven, Episode)
    return driven, scene


@pytest.mark.parametrize("name", sorted(REFERENCE_DRIVERS))
def test_every_reference_driver_keeps_off_the_car_ahead(name: str, simulator: Simulator) -> None:
    driven, scene = crash_behind(15.0, simulator)
    assert driven.collision is not None
    assert REFERENCE_DRIVERS[name](driven, STRAIGHT, scene, Blind(), simulator) is True


@pytest.mark.parametrize("name", sorted(REFERENCE_DRIVERS))
def test_no_reference_driver_is_asked_where_nothing_crashed(name: str, simulator: Simulator) -> None:
    driven, scene = crash_behind(80.0, simulator)
    assert driven.collision is None
    assert REFERENCE_DRIVERS[name](driven, STRAIGHT, scene, Blind(), simulator) is None
