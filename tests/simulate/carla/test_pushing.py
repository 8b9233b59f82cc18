"""Bodies of the stand-in for CARLA that push against each other."""

from __future__ import annotations

from itertools import combinations, pairwise
from typing import Any

import pytest

from chatscene.maps.network import resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.contact import depth
from chatscene.simulate.simulator import load_simulator

pytest.importorskip("carla", reason="the extra 'carla' is not installed, or has no wheel for this Python")
world_of: Any = pytest.importorskip("carla_stand_in.world")

TOWN = resolve_map("town")
MKZ, BIKE, WALKER, BOX = (
    "vehicle.lincoln.mkz_2017", "vehicle.diamondback.century", "walker.pedestrian.0001", "static.prop.trashcan01"
)  # fmt: skip
FULL, REVERSE = [1.0, 0.0, 0.0, False, False, False, 1], [1.0, 0.0, 0.0, False, True, False, 1]
SPAN = 4.9017  # [m], the length of an MKZ


@pytest.fixture(params=["kinematic", "lagged"])
def world(request: pytest.FixtureRequest) -> Any:
    simulator: Any = load_simulator(TOWN, SimulationSettings(simulator="embedded", physics=request.param))
    made = world_of.World({"town": TOWN}, "town", simulator.physics_of)
    made.settings = world_of.checked_settings([True, False, [True, 0.05]])
    return made


def put(world: Any, blueprint: str = MKZ, ahead: float = 0.0, aside: float = 0.0, turned: float = 0.0) -> Any:
    """Somebody ahead of a place to begin at, to its right [m], and turned [degrees]."""
    (x, y, z), (_, yaw, _) = world.roads.spawn_points[0]
    assert abs(yaw) % 180.0 < 1e-3
    sign = 1.0 if abs(yaw) < 1.0 else -1.0
    return world.spawn([0, blueprint, []], [[x + sign * ahead, y + sign * aside, z], [0.0, yaw + turned, 0.0]])


def steps(world: Any, count: int) -> list[list[Any]]:
    """The contacts of each step."""
    told: list[list[Any]] = []
    world.on_step = told.append
    for _ in range(count):
        world.step()
    return told


@pytest.mark.parametrize("dt", [0.05, 0.1, 1.0])
def test_who_keeps_pushing_against_a_standing_car_stays_before_it(world: Any, dt: float) -> None:
    world.settings = world_of.checked_settings([True, False, [True, dt]])
    car, other = put(world), put(world, ahead=12.0)
    stood = other.location[:2]
    car.control = FULL
    told = steps(world, 400)
    assert depth(car.body, other.body) <= 0.011
    assert other.location[:2] == stood
    met = next(i for i, contacts in enumerate(told) if contacts)
    assert all([(c.one.id, c.other.id) for c in contacts] == [(car.id, other.id)] for contacts in told[met:])
    assert abs(car.body.speed) < 0.1
    assert car.velocity == pytest.approx([0.0, 0.0, 0.0], abs=0.1)


def test_until_two_have_met_nothing_is_otherwise_than_in_any_simulator(world: Any) -> None:
    car, other = put(world), put(world, ahead=12.0)
    alone = put(world, aside=40.0)
    car.control = alone.control = FULL
    for _ in range(200):
        world.step()
        assert car.body.x - alone.body.x == pytest.approx(0.0, abs=1e-9)
        if depth(car.body, other.body) >= 0.0:
            break
    assert depth(car.body, other.body) > 0.05
    world.step()
    assert depth(car.body, other.body) <= 0.011


def test_a_constant_speed_and_a_set_velocity_push_nobody_through(world: Any) -> None:
    car, other = put(world), put(world, ahead=8.0)
    car.constant = 20.0
    steps(world, 100)
    assert depth(car.body, other.body) <= 0.011
    car.constant = None
    for _ in range(100):
        car.push([20.0 * car.body.cos, -20.0 * car.body.sin, 0.0])
        world.step()
        assert depth(car.body, other.body) <= 0.011


def test_nobody_jumps_over_anybody_in_a_long_step(world: Any) -> None:
    world.settings = world_of.checked_settings([True, False, [True, 1.0]])
    car, box = put(world), put(world, BOX, ahead=15.0)
    car.constant = 30.0
    told = steps(world, 3)
    assert depth(car.body, box.body) <= 0.011
    assert abs(car.body.x - box.body.x) < SPAN
    assert all(told)


def test_who_pushed_can_drive_back_and_then_touches_nobody(world: Any) -> None:
    car, other = put(world), put(world, ahead=8.0)
    car.control = FULL
    steps(world, 100)
    car.control = REVERSE
    told = steps(world, 100)
    assert depth(car.body, other.body) < 0.0
    assert told[-1] == []


@pytest.mark.parametrize("ahead", [-2.0, 0.0, 2.0])
def test_who_was_spawned_in_each_other_can_drive_apart(world: Any, ahead: float) -> None:
    car = put(world)
    box = put(world, BOX, ahead=ahead)
    car.control = FULL if ahead <= 0.0 else REVERSE
    steps(world, 150)
    assert depth(car.body, box.body) < 0.0


def test_a_column_that_touches_moves_off_together(world: Any) -> None:
    cars = [put(world, ahead=-(SPAN + 0.3) * i) for i in range(4)]
    for car in cars[1:]:
        car.control = FULL
    steps(world, 60)
    for one, other in pairwise(cars):
        assert 0.0 <= depth(one.body, other.body) <= 0.011
    began = [car.body.x for car in cars]
    for car in cars:
        car.control = FULL
    steps(world, 40)
    assert all(abs(car.body.x - x) > 5.0 for car, x in zip(cars, began, strict=True))
    assert all(depth(one.body, other.body) <= 0.011 for one, other in pairwise(cars))


def test_a_walker_that_walked_into_a_car_can_walk_away(world: Any) -> None:
    car, walker = put(world), put(world, WALKER, aside=3.0)
    side = [car.body.x - walker.body.x, -(car.body.y - walker.body.y), 0.0]
    toward = [part / 3.0 for part in side]
    walker.control = [toward, 2.0, False]
    steps(world, 100)
    assert 0.0 <= depth(car.body, walker.body) <= 0.011
    for turn in ([-toward[1] - toward[0], toward[0] - toward[1], 0.0], [-part for part in toward]):
        walker.control = [turn, 2.0, False]
        steps(world, 60)
    assert depth(car.body, walker.body) < 0.0


def _crash(world: Any) -> list[Any]:
    cars = [put(world), put(world, ahead=9.0, turned=30.0), put(world, BIKE, ahead=20.0, turned=180.0)]
    for car, steer in zip(cars, (0.02, -0.4, 0.0), strict=True):
        car.control = [1.0, steer, 0.0, False, False, False, 1]
    return cars


def test_in_a_pile_nobody_sinks_in_and_the_same_calls_end_the_same(world: Any) -> None:
    tracks: list[list[Any]] = []
    for _ in range(2):
        world.load("town", reset=False)
        cars = _crash(world)
        track: list[Any] = []
        for _ in range(200):
            world.step()
            track.append([(car.body.x, car.body.y, car.body.heading, car.body.speed) for car in cars])
        assert max(depth(one.body, other.body) for one, other in combinations(cars, 2)) <= 0.011
        tracks.append(track)
    assert tracks[0] == tracks[1]
