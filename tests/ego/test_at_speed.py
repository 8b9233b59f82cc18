"""Drivers by rule at the speed of traffic keep speed and lane, and brake as drivers and their systems do."""

from __future__ import annotations

from functools import partial

import numpy as np
import pytest

from benchmarks.proving_ground import (
    Driven,
    Told,
    ahead,
    cuts_in,
    drive,
    line_of,
    pedestrian,
    towards,
)
from chatscene.ego.asking import wanting
from chatscene.ego.at_speed import bearing_at, bends
from chatscene.ego.observation import ALLOWED, RouteView, scale_of
from chatscene.ego.policy import EgoPolicy, load_ego, name_of, observation_of, pedals_of
from chatscene.simulate.embedded.dynamics import make_body
from chatscene.simulate.embedded.lagged import LaggedVehicle
from chatscene.simulate.embedded.physics import EmbeddedPhysics
from chatscene.simulate.physics import PhysicsOf
from chatscene.testing import check_ego

KMH = 1.0 / 3.6
PHYSICS: dict[str, PhysicsOf] = {
    "kinematic": EmbeddedPhysics,
    "lagged": partial(EmbeddedPhysics, partial(make_body, vehicle=LaggedVehicle)),
}
DRIVERS = ("rule-based", "idm", "planner", "hardened")
ALL_AROUND = DRIVERS[1:]
ROAD = line_of((1000.0, 0.0))


def told(name: str, speed: float) -> EgoPolicy:
    return wanting(load_ego(name), speed * KMH)


def driven(name: str, speed: float, *others: Told, physics: str = "kinematic", seconds: float = 20.0) -> Driven:
    return drive(told(name, speed), ROAD, speed * KMH, others, physics=PHYSICS[physics](), seconds=seconds)


@pytest.mark.parametrize("name", DRIVERS)
def test_a_driver_of_which_a_speed_is_wanted_sees_traffic_and_has_the_whole_brake(name: str) -> None:
    own, at_speed = load_ego(name), told(name, 100.0)
    assert observation_of(own) != "traffic" == observation_of(at_speed)
    assert (name_of(at_speed), pedals_of(at_speed)) == (name_of(own), "full-brake")
    check_ego(at_speed)


@pytest.mark.parametrize("physics", PHYSICS)
@pytest.mark.parametrize("name", DRIVERS)
def test_it_keeps_its_speed_up_to_130_kmh_and_its_lane_when_it_begins_beside_it(name: str, physics: str) -> None:
    for speed in (10.0, 130.0):
        kept = drive(told(name, speed), ROAD, speed * KMH, physics=PHYSICS[physics](), seconds=12.0, offset=1.0)
        assert np.abs(kept.speed / (speed * KMH) - 1.0).max() < 0.02
        assert kept.offset.min() > -0.05  # it does not swing
        assert abs(kept.offset[-1]) < 0.05
        assert np.abs(kept.across).max() < 5.5


@pytest.mark.parametrize("physics", PHYSICS)
@pytest.mark.parametrize("name", ("idm", "planner"))
def test_it_takes_bends_at_the_speed_that_is_allowed(name: str, physics: str) -> None:
    line = line_of((200.0, 0.0), (150.0, 1 / 150), (150.0, -1 / 150), (100.0, 0.0))
    bent = drive(told(name, 80.0), line, 80.0 * KMH, physics=PHYSICS[physics](), seconds=60.0)
    assert (bent.speed - bent.allowed).max() < 1.0
    assert np.abs(bent.offset).max() < 0.3
    assert np.abs(bent.across).max() < 4.0


@pytest.mark.parametrize("name", DRIVERS)
def test_it_drives_no_faster_than_is_allowed(name: str) -> None:
    view = RouteView(ROAD, allowed=np.full(1000, 10.0))
    view.locate(0.0, 0.0)
    seen = view.traffic(ego := Told(lambda _: (0.0, 0.0, 0.0, 12.0)).body, [])
    assert (ego.speed, seen[ALLOWED]) == (12.0, 10.0)
    assert told(name, 100.0).act(seen)[0] < 0.0
    seen[ALLOWED] = 20.0
    assert told(name, 100.0).act(seen)[0] > 0.0


@pytest.mark.parametrize("name", DRIVERS)
@pytest.mark.parametrize("speed", (20.0, 50.0, 80.0, 130.0))
def test_it_brakes_in_time_for_a_car_that_stands_as_drivers_do(name: str, speed: float) -> None:
    stands = driven(name, speed, Told(ahead(6.0 * speed * KMH)), physics="lagged", seconds=25.0)
    assert stands.impact is None
    assert stands.speed[-1] < 1.0
    assert -5.5 < stands.acceleration.min() < -0.5


@pytest.mark.parametrize("name", DRIVERS)
def test_it_uses_the_whole_brake_where_nothing_less_does(name: str) -> None:
    late = driven(name, 110.0, Told(ahead(65.0)))
    assert late.impact is None
    assert late.acceleration.min() < -7.5
    too_late = driven(name, 130.0, Told(ahead(60.0)))
    assert too_late.impact is not None
    assert too_late.impact < 90.0 * KMH


@pytest.mark.parametrize("name", DRIVERS)
def test_it_follows_a_slower_car_and_stops_behind_one_that_brakes(name: str) -> None:
    follows = driven(name, 100.0, Told(ahead(150.0, 60.0 * KMH)), seconds=25.0)
    assert follows.speed[-1] == pytest.approx(60.0 * KMH, abs=1.5)
    assert driven(name, 50.0, Told(ahead(40.0, 50.0 * KMH, braking=6.0))).impact is None
    assert driven(name, 50.0, Told(ahead(12.0, 50.0 * KMH, braking=2.0))).impact is None


@pytest.mark.parametrize(("name", "slow"), [("planner", 30.0), ("planner", 60.0), ("hardened", 60.0)])
def test_it_does_not_stay_slower_than_whom_it_follows(name: str, slow: float) -> None:
    follows = driven(name, 100.0, Told(ahead(60.0, slow * KMH)), seconds=24.0)
    assert follows.impact is None
    assert follows.speed[-40:].min() > (slow - 1.0) * KMH
    assert 60.0 + (slow * KMH - follows.speed).sum() * 0.1 < 45.0


@pytest.mark.parametrize("name", ALL_AROUND)
def test_it_yields_to_who_cuts_in_and_brakes_for_who_crosses(name: str) -> None:
    assert driven(name, 110.0, Told(cuts_in(30.0, 80.0 * KMH, 1.0)), seconds=12.0).impact is None
    for speed in (30.0, 50.0):
        assert driven(name, speed, pedestrian(speed * KMH, 5.0 * KMH, 0.5), seconds=10.0).impact is None


def test_an_adaptive_cruise_control_heeds_nobody_on_foot() -> None:
    crossed = driven("rule-based", 50.0, pedestrian(50.0 * KMH, 5.0 * KMH, 0.5), seconds=10.0)
    assert crossed.impact == pytest.approx(50.0 * KMH, abs=0.1)


def test_an_emergency_brake_does_not_know_that_somebody_will_cross() -> None:
    crossed = driven("idm", 50.0, walks := pedestrian(50.0 * KMH, 5.0 * KMH, 0.5), seconds=10.0)
    first = int((crossed.acceleration < -0.5).argmax())
    walks.go(float(crossed.time[first]))
    assert (walks.body.x - crossed.along[first]) / crossed.speed[first] < 2.5  # [s]


@pytest.mark.parametrize("name", DRIVERS)
def test_it_does_not_brake_for_traffic_in_other_lanes(name: str) -> None:
    line = line_of((150.0, 0.0), (250.0, 1 / 150), (100.0, 0.0))
    met = [Told(towards(line, at, 22.0)) for at in (120.0, 220.0, 330.0)]
    alone, among = (drive(told(name, 80.0), line, 22.0, others, physics=EmbeddedPhysics()) for others in ((), met))
    assert len(alone.speed) == len(among.speed)
    assert np.abs(alone.speed - among.speed).max() < 0.3


@pytest.mark.parametrize("name", ("planner", "hardened"))
def test_it_does_not_overtake_into_a_lane_that_it_cannot_see_the_end_of(name: str) -> None:
    others = [Told(ahead(60.0, 60.0 * KMH)), Told(towards(ROAD, 650.0, 22.0))]
    stayed = drive(told(name, 80.0), ROAD, 22.0, others, physics=EmbeddedPhysics(), room=(5.25, 1.75))
    assert stayed.impact is None
    assert np.abs(stayed.offset).max() < 0.9


def test_where_a_bend_of_one_radius_leads_is_told_exactly() -> None:
    line, speed = line_of((400.0, 1 / 200)), 24.0
    view = RouteView(line)
    view.locate(0.0, 0.0)
    seen = view.traffic(Told(lambda _: (0.0, 0.0, 0.0, speed)).body, [])
    middles, bearings = bends(seen, k := scale_of(speed))
    for along in (0.0, 7.0, 33.0, 30.0 * k):
        assert bearing_at(along, middles, bearings) == pytest.approx(along / 200, abs=0.003)
