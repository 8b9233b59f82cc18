"""How fast who was, before the encounter, at its height and at the impact."""

import math
from dataclasses import replace

import numpy as np
import pytest

from chatscene.measure.criticality import criticality
from chatscene.measure.speeds import risks, speeds
from chatscene.measure.sums import sums
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, Track

DT = 0.1
NORTH, WEST = math.pi / 2, math.pi


def track(
    actor: str,
    speed: Array | float,
    *,
    x: float = 0.0,
    y: float = 0.0,
    heading: float = 0.0,
    rows: int = 100,
    kind: str = "Car",
    role: Role | None = None,
    size: tuple[float, float] = (4.0, 2.0),
) -> Track:
    """An actor that goes straight on at given speeds [m/s]."""
    fast = np.broadcast_to(np.asarray(speed, np.float64), (rows,)).copy()
    way = np.concatenate(([0.0], np.cumsum(fast[:-1] * DT)))
    return Track(
        actor=actor, role=role or Role(actor), kind=kind, length=size[0], width=size[1],
        x=x + way * math.cos(heading), y=y + way * math.sin(heading), heading=np.full(rows, heading), speed=fast,
    )  # fmt: skip


def episode(*tracks: Track, events: tuple[Event, ...] = ()) -> Episode:
    rows = len(tracks[0].x)
    return Episode(
        scene_id="s", ego="e", dt=DT, tracks=tracks, events=events, signals=(), route_completion=0.5,
        ending=Ending.COLLISION if events else Ending.TIMEOUT,
        distance_to_route=np.zeros(rows), off_road=np.zeros(rows, dtype=np.bool_),
    )  # fmt: skip


def crash(ego: Track, other: Track, side: str = "front", step: int | None = None) -> Episode:
    """A drive that ends with the contact of two, at the first step at which their boxes overlap."""
    from chatscene.simulate.boxes import gaps

    at = int(np.argmax(gaps(ego, other) <= 0.0)) if step is None else step
    assert at > 0
    ways = [np.array((math.cos(t.heading[at]), math.sin(t.heading[at]))) * t.speed[at - 1] for t in (ego, other)]
    speed = float(np.hypot(*(ways[0] - ways[1])))
    event = Event(kind=EventKind.COLLISION, step=at, other=other.actor, side=side, impact_speed=speed)
    return episode(ego, other, events=(event,))


def braking(speed: float, begins: int, by: float, rows: int = 100) -> Array:
    return np.maximum(speed - by * DT * np.maximum(np.arange(rows) - begins, 0.0), 0.0)


def test_speeds_are_those_before_the_first_of_both_brakes() -> None:
    lead = track("adversary", braking(11.0, 30, 6.0), x=40.0)
    found = speeds(episode(track("ego", braking(14.0, 40, 5.0)), lead))
    assert found.encounter_time == pytest.approx(3.0)
    assert (found.ego_speed_before, found.other_speed_before) == (14.0, 11.0)
    assert (found.ego_braking_most, found.other_braking_most) == (pytest.approx(5.0), pytest.approx(6.0))


def test_where_nobody_brakes_it_is_the_nearest_moment() -> None:
    scene = episode(track("ego", 14.0), track("adversary", 1.4, x=60.0, y=-15.0, heading=NORTH, kind="Pedestrian"))
    found = speeds(scene)
    assert found.ego_speed_before == found.ego_speed_most == 14.0
    assert found.other_speed_before == 1.4
    assert found.encounter_time == pytest.approx(60 / 14, abs=0.5)
    assert found.ego_speed_at_impact is found.closing_speed is found.ego_delta_v is found.other_injury_risk is None


def test_a_braking_that_was_over_long_before_is_of_another_reason() -> None:
    fast = np.concatenate((braking(14.0, 0, 3.0, 20), np.full(80, 8.3)))
    found = speeds(episode(track("ego", fast), track("adversary", 1.4, x=75.0, y=-12.0, heading=NORTH)))
    assert found.ego_speed_before == pytest.approx(8.3)
    assert found.ego_speed_most == 14.0


def test_who_slows_down_behind_a_slow_one_and_follows_it_is_told_at_the_speed_before() -> None:
    slows = np.concatenate((braking(14.0, 10, 3.0, 40), np.full(160, 5.6)))
    lead = track("adversary", 5.5, x=60.0, rows=200)
    found = speeds(episode(track("ego", slows, rows=200), lead))
    assert found.encounter_time == pytest.approx(1.0)
    assert found.ego_speed_before == 14.0
    goes_on = np.concatenate((slows[:60], np.linspace(5.6, 9.0, 60), np.full(80, 9.0)))
    assert speeds(episode(track("ego", goes_on, rows=200), lead)).ego_speed_before == pytest.approx(9.0)


def test_who_brakes_twice_with_a_short_pause_brakes_once_and_who_waits_still_brakes() -> None:
    twice = np.concatenate((braking(14.0, 10, 4.0, 20), np.full(10, 10.4), braking(10.4, 0, 6.0, 70)))
    assert np.diff(twice)[19] == pytest.approx(0.0)
    other = track("adversary", 1.4, x=80.0, y=-12.0, heading=NORTH, kind="Pedestrian")
    found = speeds(episode(track("ego", twice), other))
    assert found.ego_speed_before == 14.0
    assert found.encounter_time == pytest.approx(1.0)
    long = track("ego", np.concatenate((twice, np.zeros(100))), rows=200)
    late = track("adversary", 1.4, x=80.0, y=-25.0, heading=NORTH, rows=200, kind="Pedestrian")
    assert speeds(episode(long, late)).ego_speed_before == 14.0


def test_whom_it_meets_is_whom_it_strikes_else_the_adversary_that_comes_nearest() -> None:
    far = track("adversary", 5.0, y=40.0)
    near = replace(track("adversary", 7.0, y=4.0), actor="B")
    parked = track("background", 0.0, x=60.0)
    ego = track("ego", 10.0)
    assert sums(episode(ego, far, near, parked)).meets is near
    struck = crash(ego, parked)
    assert sums(struck).meets is parked
    assert (speeds(struck).other_kind, speeds(struck).other_speed_before) == ("Car", 0.0)


def test_an_ego_that_meets_nobody_has_speeds_of_its_own() -> None:
    found = speeds(episode(track("ego", braking(12.0, 50, 4.0))))
    assert (found.ego_speed_before, found.ego_speed_most, found.ego_braking_most) == (12.0, 12.0, pytest.approx(4.0))
    assert found.other_kind is found.other_speed_before is found.encounter_time is None


def test_who_reverses_is_as_fast_as_who_goes_forward() -> None:
    found = speeds(episode(track("ego", -2.0, x=40.0), track("adversary", -3.0, x=45.0, y=3.0)))
    assert (found.ego_speed_before, found.other_speed_most) == (2.0, 3.0)


def test_a_rear_end_crash_has_the_closing_speed_and_a_change_for_each_by_the_masses() -> None:
    car, truck = track("ego", 20.0), track("adversary", 8.0, x=40.0, kind="Truck", size=(8.0, 2.5))
    scene = crash(car, truck)
    found = speeds(scene)
    assert (found.ego_speed_at_impact, found.other_speed_at_impact) == (20.0, 8.0)
    assert found.closing_speed == pytest.approx(12.0)
    assert found.impact_angle == 0.0
    assert found.ego_delta_v == pytest.approx(12.0 * 8000 / 9700)
    assert found.other_delta_v == pytest.approx(12.0 * 1700 / 9700)
    assert found.ego_injury_risk == pytest.approx(1 / (1 + math.exp(4.457 - 0.177 * 12.0 * 8000 / 9700)))
    assert found.other_injury_risk is None


def test_momentum_is_kept() -> None:
    found = speeds(crash(track("ego", 20.0), track("adversary", 5.0, x=60.0, heading=WEST, kind="Bus")))
    assert found.ego_delta_v is not None
    assert found.other_delta_v is not None
    assert 1700 * found.ego_delta_v == pytest.approx(6500 * found.other_delta_v)
    assert found.impact_angle == pytest.approx(math.pi)
    assert found.ego_delta_v + found.other_delta_v == pytest.approx(25.0)


def test_a_crossing_crash_closes_along_the_side_that_was_struck() -> None:
    scene = crash(track("ego", 10.0), track("adversary", 10.0, x=30.0, y=-27.0, heading=NORTH))
    found = speeds(scene)
    assert criticality(scene).impact_speed == pytest.approx(10 * math.sqrt(2))
    assert found.closing_speed == pytest.approx(10.0)
    assert found.impact_angle == pytest.approx(NORTH)
    assert found.other_injury_risk is not None


def test_a_graze_closes_slowly_and_has_no_curve() -> None:
    swerves = track("ego", 15.0, heading=0.1)
    found = speeds(crash(swerves, track("adversary", 15.0, x=3.0, y=2.25, heading=WEST), side="left"))
    assert found.closing_speed is not None
    assert found.closing_speed < 5.0
    assert found.ego_delta_v == found.other_delta_v == found.closing_speed / 2
    assert found.ego_injury_risk is found.other_injury_risk is None


def test_a_pedestrian_before_the_front_of_a_car_has_both_curves_and_the_car_none() -> None:
    scene = crash(track("ego", 50 / 3.6), track("adversary", 0.0, x=40.0, kind="Pedestrian", size=(0.5, 0.5)))
    found = speeds(scene)
    assert found.other_death_risk == pytest.approx(0.083, abs=0.001)
    assert found.other_injury_risk == pytest.approx(0.368, abs=0.001)
    assert found.ego_injury_risk is found.ego_death_risk is None
    assert found.other_delta_v == pytest.approx(50 / 3.6 * 1700 / 1780)
    assert [found.curve.source for found in risks(scene)[1]] == ["Rosén and Sander 2009", "Lubbe et al. 2022"]


def test_a_thing_beside_the_road_stands_as_a_wall() -> None:
    kiosk = track("occluder", 0.0, x=40.0, kind="Kiosk")
    found = speeds(crash(track("ego", 10.0), kiosk))
    assert (found.ego_delta_v, found.other_delta_v) == (10.0, None)
    assert found.ego_injury_risk is None
