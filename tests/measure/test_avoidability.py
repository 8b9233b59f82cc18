"""The careful driver of UN R157 against toy scenes with known answers."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from blind import STRAIGHT, Blind, car_ahead
from chatscene.ego.observation import Observation
from chatscene.errors import EgoError, ProgramError, ProgramStopped, SandboxError, ServerError, StuckBehavior
from chatscene.maps.network import resolve_map
from chatscene.measure.avoidability import (
    BRAKING_DELAY,
    FULL_BRAKE,
    RAMP,
    RISK_EVALUATION,
    CarefulDriver,
    _visible,  # pyright: ignore[reportPrivateUsage] - checked against the ego's own sight
    avoidable,
    avoidable_if_driven,
    careful_braking,
    risk_step,
)
from chatscene.settings import SimulationSettings
from chatscene.simulate.embedded.dynamics import VehicleBody
from chatscene.simulate.embedded.lagged import LaggedVehicle
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.actors import LIMITS, height_of_kind
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.terms.sight import eye_of, is_hidden

EAST = Polyline([(float(x), 0.0) for x in range(300)])
DT = 0.1


def track(actor: str, role: Role, x: float, y: float, heading: float, speed: float, *, steps: int = 60) -> Track:
    """Somebody who goes straight on, from a pose at step 0."""
    time = np.arange(steps) * DT
    size = (4.9, 2.1) if role is not Role.ADVERSARY else (0.6, 0.6)
    return Track(
        actor=actor,
        role=role,
        kind="Car",
        length=size[0],
        width=size[1],
        x=np.asarray(x + speed * time * math.cos(heading), dtype=np.float64),
        y=np.asarray(y + speed * time * math.sin(heading), dtype=np.float64),
        heading=np.full(steps, heading),
        speed=np.full(steps, speed),
    )


def episode(*others: Track, crash_at: int, speed: float = 8.0) -> Episode:
    ego = track("ego", Role.EGO, 0.0, 0.0, 0.0, speed)
    steps = len(ego.x)
    return Episode(
        scene_id="s",
        ego="toy",
        dt=DT,
        tracks=(ego, *others),
        events=(Event(kind=EventKind.COLLISION, step=crash_at, other="adversary"),),
        signals=(),
        ending=Ending.COLLISION,
        route_completion=0.5,
        distance_to_route=np.zeros(steps),
        off_road=np.zeros(steps, dtype=bool),
    )


def test_a_thing_in_the_way_is_a_risk_three_seconds_before_it_is_hit() -> None:
    standing = track("adversary", Role.ADVERSARY, 40.0, 0.0, 0.0, 0.0)
    # 40 m less half a car (2.45) and half a walker (0.3) is 37.25 m; 3 s at 8 m/s are 24 m; so after 13.25 m.
    assert risk_step(episode(standing, crash_at=46), EAST) == math.ceil(13.25 / 0.8)


def test_somebody_who_walks_beside_the_road_is_none_until_they_turn_into_it() -> None:
    walker = track("adversary", Role.ADVERSARY, 30.0, 4.0, 0.0, 0.0)
    turned = np.where(np.arange(60) < 20, 0.0, -math.pi / 2)
    speed = np.where(np.arange(60) < 20, 0.0, 2.5)
    walker = replace(walker, heading=turned, speed=speed)
    assert risk_step(episode(walker, crash_at=40), EAST) == 20


def test_nobody_is_a_risk_while_a_thing_hides_them() -> None:
    walker = track("adversary", Role.ADVERSARY, 30.0, -4.0, math.pi / 2, 1.2)
    van = track("van", Role.OCCLUDER, 26.0, -3.4, 0.0, 0.0)
    seen, hidden = risk_step(episode(walker, crash_at=34), EAST), risk_step(episode(walker, van, crash_at=34), EAST)
    assert seen is not None
    assert hidden is not None
    assert hidden > seen


def test_without_occlusion_only_things_at_the_roadside_hide_from_a_careful_driver() -> None:
    walker = track("adversary", Role.ADVERSARY, 30.0, -4.0, math.pi / 2, 1.2)
    lorry = replace(track("lorry", Role.BACKGROUND, 26.0, -3.4, 0.0, 0.0), kind="Truck")
    alone, seen, hidden = (
        risk_step(episode(walker, *others, crash_at=34), EAST, occlusion=occlusion)
        for others, occlusion in (((), False), ((lorry,), False), ((replace(lorry, role=Role.OCCLUDER),), False))
    )
    assert alone is not None
    assert seen == alone
    assert hidden is not None
    assert hidden > alone
    assert risk_step(episode(walker, lorry, crash_at=34), EAST) != seen


@pytest.mark.parametrize("name", ["native", "embedded", "confined"])
def test_a_simulator_says_whether_bodies_hide_others(name: str) -> None:
    for occlusion in (True, False):
        settings = SimulationSettings(simulator=name, occlusion=occlusion)
        assert load_simulator(resolve_map("town"), settings).identity.occlusion is occlusion


def test_without_a_crash_there_is_no_risk_to_speak_of() -> None:
    calm = replace(episode(crash_at=0), events=())
    assert risk_step(calm, EAST) is None


@given(turn=st.floats(-3.0, 3.0), dx=st.floats(-500.0, 500.0), dy=st.floats(-500.0, 500.0))
def test_the_moment_of_risk_does_not_depend_on_where_the_map_lies(turn: float, dx: float, dy: float) -> None:
    cos, sin = math.cos(turn), math.sin(turn)

    def moved(t: Track) -> Track:
        return replace(t, x=t.x * cos - t.y * sin + dx, y=t.x * sin + t.y * cos + dy, heading=t.heading + turn)

    walker = track("adversary", Role.ADVERSARY, 31.3, 4.1, -math.pi / 2, 1.3)
    van = track("van", Role.OCCLUDER, 22.0, 3.4, 0.0, 0.0)
    here = episode(walker, van, crash_at=30)
    there = replace(here, tracks=tuple(moved(t) for t in here.tracks))
    x, y = EAST.points.T
    line = Polyline(np.column_stack((x * cos - y * sin + dx, x * sin + y * cos + dy)))
    assert risk_step(there, line) == risk_step(here, EAST)


def test_the_careful_driver_brakes_along_the_ramp_of_the_regulation() -> None:
    class Cruise:
        def act(self, observation: Observation) -> tuple[float, float]:
            return 0.0, 0.0

    driver = CarefulDriver(Cruise(), careful_braking(5, DT), DT)
    body = VehicleBody(0.0, 0.0, 0.0, LIMITS["Car"], 20.0)
    speeds = [body.speed]
    for _ in range(20):
        acceleration, _ = driver.act(np.zeros(4))
        body.brake = max(0.0, -acceleration)
        body.step(DT)
        speeds.append(body.speed)
    braking = -np.diff(speeds) / DT
    air = 0.0008 * 20.0**2
    assert braking[:5] == pytest.approx(0.2, abs=air)
    assert braking[5:11] == pytest.approx(FULL_BRAKE * np.arange(1, 7) * DT / RAMP, abs=air)
    assert braking[11:] == pytest.approx(FULL_BRAKE, abs=air)


def test_the_careful_driver_s_foot_leaves_to_a_brake_that_lags_what_that_does_of_the_ramp() -> None:
    class Cruise:
        def act(self, observation: Observation) -> tuple[float, float]:
            return 0.0, 0.0

    def lost(body: VehicleBody, brake_lag: float) -> float:
        """Speed [m/s] lost in a second of the careful driver's braking."""
        driver = CarefulDriver(Cruise(), careful_braking(0, DT, brake_lag), DT)
        for _ in range(round(1.0 / DT)):
            body.brake = max(0.0, -driver.act(np.zeros(4))[0])
            body.step(DT)
        return 20.0 - body.speed

    car = LIMITS["Car"]
    at_once = lost(VehicleBody(0.0, 0.0, 0.0, car, 20.0), 0.0)
    assert lost(LaggedVehicle(0.0, 0.0, 0.0, car, 20.0), car.brake_lag) == pytest.approx(at_once, rel=0.05)
    assert lost(LaggedVehicle(0.0, 0.0, 0.0, car, 20.0), 0.0) < 0.75 * at_once


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings())


@pytest.mark.parametrize(("gap", "expected"), [(15.0, True), (80.0, None)])
def test_to_run_into_the_car_ahead_is_avoidable_and_not_to_is_no_question(
    simulator: Simulator, gap: float, expected: bool | None
) -> None:
    scene = car_ahead(gap)
    driven = simulate(simulator, STRAIGHT, scene, Blind())
    assert isinstance(driven, Episode)
    assert avoidable(driven, STRAIGHT, scene, Blind(), simulator) is expected


def test_an_ego_that_fails_only_the_second_time_is_an_error_of_the_ego(simulator: Simulator) -> None:
    class Moody(Blind):
        calls = 0

        def act(self, observation: Observation) -> tuple[float, float]:
            Moody.calls += 1
            if Moody.calls > 200:
                raise LookupError("no more")
            return super().act(observation)

    scene = car_ahead(15.0)
    driven = simulate(simulator, STRAIGHT, scene, Moody())
    assert isinstance(driven, Episode)
    Moody.calls = 200
    with pytest.raises(
        EgoError, match="fails at step 0 of scene 's', which it drove once before: LookupError: no more"
    ):
        avoidable(driven, STRAIGHT, scene, Moody(), simulator)
    assert isinstance(simulate(simulator, STRAIGHT, scene, Blind()), Episode)  # the process is free for another drive


def test_braking_needs_the_time_the_regulation_gives(simulator: Simulator) -> None:
    scene = car_ahead(15.0)
    driven = simulate(simulator, STRAIGHT, scene, Blind())
    assert isinstance(driven, Episode)
    crash = driven.collision
    assert crash is not None
    # The same crash, had the other only appeared one step after the last moment at which braking would have begun.
    late = crash.step - math.ceil((RISK_EVALUATION + BRAKING_DELAY) / DT) + 1
    ahead = next(t for t in driven.tracks if t.actor == crash.other)
    away = replace(ahead, x=np.where(np.arange(len(ahead.x)) < late, 1e6, ahead.x))
    hidden = replace(driven, tracks=tuple(away if t is ahead else t for t in driven.tracks))
    assert avoidable(hidden, STRAIGHT, scene, Blind(), simulator) is False


def _program(*, as_written: bool = False) -> ScenicProgram:
    return ScenicProgram(scenario_id="x", source="", parameters=(), snippet_ids=(), as_written=as_written)


class _Fails:
    """A simulator in which a program fails when it is asked for its route, as before it is driven again."""

    def __init__(self, error: Exception) -> None:
        self.error = error

    def route_in(self, *_: object) -> None:
        raise self.error


def _driven_again(error: Exception, program: ScenicProgram) -> tuple[bool | None, tuple[str, ...]]:
    crashed = episode(track("a", Role.ADVERSARY, 20.0, 0.0, 0.0, 0.0), crash_at=20)
    scene = Scene(id="s", scenario_id="x", route=0, block=0, seed=0, values={})
    return avoidable_if_driven(crashed, program, scene, Blind(), _Fails(error))  # pyright: ignore[reportArgumentType]


@pytest.mark.parametrize("kind", [ProgramError, StuckBehavior, ProgramStopped])
def test_a_program_that_fails_when_driven_again_leaves_its_first_drive(kind: type[Exception]) -> None:
    careful, why = _driven_again(kind("it fails\n  in line 1"), _program())
    assert careful is None
    assert why == ("whether a careful driver avoids the collision is not known: driven again, it fails",)


def test_who_is_driven_again_wants_the_speed_that_the_program_has() -> None:
    wanted: list[float] = []

    class Wanting(Blind):
        def wanting(self, speed: float) -> Blind:
            wanted.append(speed)
            return Blind()

    crashed = episode(track("a", Role.ADVERSARY, 20.0, 0.0, 0.0, 0.0), crash_at=20)
    scene = Scene(id="s", scenario_id="x", route=0, block=0, seed=0, values={})
    program = replace(_program(), source="ego = new Car with wantedSpeed 13.9")
    avoidable_if_driven(crashed, program, scene, Wanting(), _Fails(ProgramError("it fails")))  # pyright: ignore[reportArgumentType]
    assert wanted == [13.9]


@pytest.mark.parametrize("kind", [ServerError, SandboxError, EgoError])
def test_what_is_lost_otherwise_is_told(kind: type[Exception]) -> None:
    with pytest.raises(kind):
        _driven_again(kind("it is gone"), _program())


def test_nobody_is_put_in_the_place_of_a_programs_own_ego() -> None:
    assert _driven_again(AssertionError("it is driven again"), _program(as_written=True)) == (None, ())


@given(
    x=st.floats(8.0, 60.0),
    y=st.floats(-8.0, 8.0),
    van=st.tuples(st.floats(6.0, 50.0), st.floats(-8.0, 8.0), st.floats(-3.0, 3.0), st.floats(0.0, 20.0)),
    kind=st.sampled_from(("Child", "Pedestrian", "Car", "Truck")),
)
def test_a_careful_driver_sees_whom_an_ego_sees(
    x: float, y: float, van: tuple[float, float, float, float], kind: str
) -> None:
    ahead = replace(track("adversary", Role.ADVERSARY, x, y, 1.0, 2.0), kind=kind)
    between = replace(track("van", Role.BACKGROUND, *van), kind="Van", length=5.5, width=2.0)
    drive = episode(ahead, between, crash_at=59)
    for step, seen in enumerate(_visible(drive, ahead)):
        ego, other, one = (_box(track, step) for track in (drive.ego_track, ahead, between))
        eye, high = eye_of(ego, height_of_kind("Car")), height_of_kind(kind)
        surely, perhaps = (
            is_hidden(eye, other, high, [(replace(one, half_width=1.0 + grown), height_of_kind("Van"))])
            for grown in (-1e-6, 1e-6)
        )
        if surely == perhaps:  # else it is a matter of rounding
            assert seen != surely


@dataclass
class _Box:
    x: float
    y: float
    cos: float
    sin: float
    half_length: float
    half_width: float


def _box(of: Track, step: int) -> _Box:
    heading = float(of.heading[step])
    place = float(of.x[step]), float(of.y[step])
    return _Box(*place, math.cos(heading), math.sin(heading), of.length / 2, of.width / 2)
