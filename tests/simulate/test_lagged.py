"""The physics ``lagged``: what it does in closed form, and what it may never do."""

import math
from dataclasses import replace
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene import pipeline, runs
from chatscene.ego.rule_based import RuleBased
from chatscene.errors import RunError, SettingsError
from chatscene.learn.finetune.scenes import kept_scenes
from chatscene.maps.network import resolve_map
from chatscene.runs.progress import silent
from chatscene.runs.record import settings_from
from chatscene.runs.replay import replay
from chatscene.settings import PHYSICS, SearchSettings, Settings, SimulationSettings
from chatscene.simulate.embedded.dynamics import VehicleBody, WalkerBody, make_body
from chatscene.simulate.embedded.lagged import DRY, GRAVITY, LAG_SPEED, LaggedVehicle, build_up
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.studies.evaluation import evaluate
from chatscene.terms.actors import AIR_DRAG, LIMITS
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.testing.simulators import check_simulator
from chatscene.world.bodies import Placement

DT = 0.1
CAR = LIMITS["Car"]
UNDRAGGED = replace(CAR, drag=0.0)
LAGGED = SimulationSettings(physics="lagged")
pedal = st.floats(0, 1)
wheel = st.floats(-1, 1)
kinds = st.sampled_from([kind for kind, limits in LIMITS.items() if limits.wheelbase])


def car(speed: float = 0.0, friction: float = DRY) -> LaggedVehicle:
    return LaggedVehicle(0.0, 0.0, 0.0, UNDRAGGED, speed, friction)


def run(body: VehicleBody, steps: int, dt: float = DT) -> None:
    for _ in range(steps):
        body.step(dt)


def test_what_is_asked_for_is_reached_to_63_percent_after_its_time_constant_whatever_the_step() -> None:
    for steps in (1, 3, 100):
        value = 0.0
        for _ in range(steps):
            _, value = build_up(value, 1.0, 0.3, 0.3 / steps)
        assert value == pytest.approx(1.0 - math.exp(-1.0))


def test_the_brake_has_63_percent_after_its_time_constant() -> None:
    body = car(20.0)
    body.brake = 1.0
    run(body, 3)
    assert body.braking == pytest.approx(CAR.brake * (1.0 - math.exp(-0.3 / CAR.brake_lag)))


def test_braking_loses_as_much_speed_as_the_integral_of_its_build_up_says() -> None:
    body, lag, seconds = car(20.0), CAR.brake_lag, 1.0
    body.brake = 1.0
    run(body, 1000, seconds / 1000)
    lost = CAR.brake * (seconds - lag * (1.0 - math.exp(-seconds / lag)))
    drag = AIR_DRAG * 17.5**2 * seconds  # about, at the mean speed
    assert 20.0 - body.speed == pytest.approx(lost + drag, abs=0.05)


def test_a_car_s_brake_loses_as_much_speed_as_the_ramp_of_un_r157() -> None:
    ramp = 0.5 * 0.6  # [s] of full braking that a linear ramp of 0.6 s loses
    lagged, at_once = car(20.0), VehicleBody(0.0, 0.0, 0.0, UNDRAGGED, 20.0)
    for body in (lagged, at_once):
        body.brake = 1.0
        run(body, 20)
    assert (lagged.speed - at_once.speed) / CAR.brake == pytest.approx(ramp, rel=0.1)


def test_a_truck_s_brake_reaches_75_percent_in_the_time_that_un_r13_allows() -> None:
    body = LaggedVehicle(0.0, 0.0, 0.0, LIMITS["Truck"], 20.0)
    body.brake = 1.0
    run(body, 6)
    assert body.braking / LIMITS["Truck"].brake == pytest.approx(0.75, abs=0.01)


def test_the_yaw_rate_has_63_percent_after_its_time_constant() -> None:
    body = car(LAG_SPEED)
    body.target_speed = LAG_SPEED
    body.wheel = 0.01
    body.steer = -0.01 / CAR.wheel_angle
    reached: list[float] = []
    for _ in range(100):
        body.step(0.01)
        reached.append(body.yaw_rate)
    assert reached[round(CAR.yaw_lag / 0.01) - 1] / reached[-1] == pytest.approx(1.0 - math.exp(-1.0), abs=1e-3)


def test_at_its_characteristic_speed_a_car_turns_half_as_much_as_its_wheel_says() -> None:
    body = car(CAR.characteristic_speed)
    body.target_speed = CAR.characteristic_speed
    body.wheel = 0.01
    body.steer = -0.01 / CAR.wheel_angle
    run(body, 30)
    assert body.yaw_rate / body.speed == pytest.approx(0.5 * math.tan(0.01) / CAR.wheelbase, rel=1e-3)


def test_a_slow_car_drives_the_circle_of_the_kinematic_physics() -> None:
    lagged, kinematic = car(2.0), VehicleBody(0.0, 0.0, 0.0, UNDRAGGED, 2.0)
    for body in (lagged, kinematic):
        body.steer, body.target_speed = 0.3, 2.0
        run(body, 100)
    assert lagged.heading == pytest.approx(kinematic.heading, rel=0.02)


def test_a_parked_car_does_not_turn_and_a_car_that_stopped_in_a_curve_stays() -> None:
    body = car(8.0)
    body.steer, body.brake = 0.5, 1.0
    run(body, 40)
    pose = body.x, body.y, body.heading
    assert body.speed == 0.0
    run(body, 20)
    assert (body.x, body.y, body.heading) == pose


def test_reverse_gear_first_brakes_and_then_drives_backwards() -> None:
    body = car(2.0)
    body.reverse, body.throttle = True, 0.6
    run(body, 2)
    assert 0.0 < body.speed < 2.0
    run(body, 40)
    assert -6.0 <= body.speed < -1.0


def test_a_speed_asked_for_is_reached_later_than_at_once_and_then_held() -> None:
    body = car(15.0)
    body.target_speed = 5.0
    run(body, 12)
    assert body.speed > 5.0
    run(body, 10)
    assert body.speed == 5.0


@settings(max_examples=100)
@given(
    kinds,
    st.lists(st.tuples(pedal, pedal, wheel, st.booleans()), min_size=1, max_size=30),
    st.floats(0, 25),
    st.sampled_from([DRY, 0.5, 0.2]),
)
def test_no_control_leaves_the_friction_circle(
    kind: str, orders: list[tuple[float, float, float, bool]], speed: float, friction: float
) -> None:
    limits = replace(LIMITS[kind], drag=0.0)
    body = LaggedVehicle(0.0, 0.0, 0.0, limits, min(speed, limits.top_speed), friction)
    for body.throttle, body.brake, body.steer, body.reverse in orders:
        x, y, before, heading = body.x, body.y, body.speed, body.heading
        body.step(DT)
        air = AIR_DRAG * before * before
        along = max(0.0, abs(body.speed - before) / DT - air)
        across = 0.5 * abs(body.speed + before) * abs(body.heading - heading) / DT
        assert math.hypot(along, across) <= friction * GRAVITY + 1e-6
        assert math.hypot(body.x - x, body.y - y) <= max(abs(before), abs(body.speed)) * DT + 1e-9
        assert across <= limits.lateral * (1.0 + 1e-9) + 1e-6
        assert -6.0 <= body.speed <= limits.top_speed


def test_a_wet_road_lengthens_braking_as_its_friction_says() -> None:
    body = car(20.0, friction=0.4)
    body.brake = 1.0
    run(body, 10)
    before = body.speed
    body.step(DT)
    assert (before - body.speed) / DT == pytest.approx(0.4 * GRAVITY + AIR_DRAG * before**2)


def test_walkers_are_those_of_the_kinematic_physics() -> None:
    physics = load_simulator(resolve_map("town"), LAGGED).physics_of()  # type: ignore[attr-defined]
    walker = Placement(kind="Pedestrian", x=0.0, y=0.0, heading=0.0, speed=0.0, length=0.6, width=0.6)
    assert type(physics.add(walker)) is WalkerBody is type(make_body(walker))


@pytest.mark.parametrize("simulator", ["embedded", "confined"])
def test_the_physics_keeps_the_contract_of_a_simulator(simulator: str) -> None:
    check_simulator(
        lambda map_path, given: load_simulator(map_path, replace(given, simulator=simulator, physics="lagged"))
    )


@pytest.mark.parametrize("simulator", ["embedded", "confined"])
def test_a_simulator_says_which_physics_it_has(simulator: str) -> None:
    kinematic, lagged = (
        load_simulator(resolve_map("town"), SimulationSettings(simulator=simulator, physics=physics)).identity
        for physics in ("kinematic", "lagged")
    )
    assert kinematic.physics == "kinematic bicycles and walkers within actuator limits"
    assert "lag" in lagged.physics
    assert (kinematic.brake_lag, lagged.brake_lag) == (0.0, CAR.brake_lag)


def test_a_physics_that_there_is_not_is_refused_by_name() -> None:
    with pytest.raises(SettingsError, match=r"no physics 'laged'.*lagged"):
        SimulationSettings(physics="laged")


@pytest.fixture(scope="module")
def runs_of(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """The same search under each physics."""
    folders: dict[str, Path] = {}
    for physics in PHYSICS:
        few = Settings(search=SearchSettings(scenes=4, block=2, keep=1), simulation=SimulationSettings(physics=physics))
        folders[physics] = tmp_path_factory.mktemp(physics) / "run"
        asked = runs.asked_run("AdvSim: straight-obstacle", settings=few, ego="rule-based", generator="advsim")
        pipeline.run(asked, folders[physics])
    return folders


def test_a_record_says_its_physics_and_a_replay_has_the_same(runs_of: dict[str, Path]) -> None:
    for physics, folder in runs_of.items():
        record = runs.read_record(runs.Workspace(folder))
        assert runs.settings_of(record).simulation.physics == physics
        assert ("lag" in record.simulator.physics) is (physics == "lagged")
        scene = next(row["scene_id"] for row in runs.read_scenes(runs.Workspace(folder)) if row["status"] == "ran")
        assert replay(folder, scene).identical


def test_the_same_scene_ends_differently_under_each_physics(runs_of: dict[str, Path]) -> None:
    ends = {
        physics: [row["impact_speed"] for row in runs.read_scenes(runs.Workspace(folder))]
        for physics, folder in runs_of.items()
    }
    assert ends["kinematic"] != ends["lagged"]


def test_an_evaluation_has_the_physics_of_the_runs_unless_another_is_asked_for(
    runs_of: dict[str, Path], tmp_path: Path
) -> None:
    for asked, meant in (("", "lagged"), ("kinematic", "kinematic")):
        folder = tmp_path / meant
        evaluate([runs_of["lagged"]], folder, egos=["rule-based"], every_scene=True, physics=asked, progress=silent)
        record = runs.read_record(runs.Workspace(folder), runs.EvaluationRecord)
        assert runs.settings_of(record).simulation.physics == meant
    assert kept_scenes([runs_of["lagged"]]).simulation == LAGGED
    assert kept_scenes([runs_of["lagged"]], physics="kinematic").simulation == SimulationSettings()


def test_runs_under_different_physics_are_not_measured_together(runs_of: dict[str, Path], tmp_path: Path) -> None:
    with pytest.raises(
        RunError, match=r"differ in physics \(lagged and kinematic\); name one for all, as with --physics kinematic"
    ):
        evaluate(list(runs_of.values()), tmp_path / "both", egos=["rule-based"], progress=silent)


def test_a_record_without_a_physics_is_kinematic() -> None:
    assert settings_from(SimulationSettings, {"dt": 0.1, "max_steps": 300}).physics == "kinematic"


def test_behind_the_walls_bodies_lag_as_they_do_before_them() -> None:
    source = "model chatscene.world.model\negoRoute = selectRoute(maneuver='straight')\n"
    source += "ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute\n"
    program = ScenicProgram(scenario_id="road", source=source, parameters=(), snippet_ids=())
    scene = Scene(id="road/0", scenario_id="road", route=0, block=0, seed=0, values={})

    def speeds(simulator: str, physics: str) -> list[float]:
        settings = SimulationSettings(simulator=simulator, physics=physics, max_steps=30)
        episode = simulate(load_simulator(resolve_map("town"), settings), program, scene, RuleBased())
        assert isinstance(episode, Episode)
        return episode.ego_track.speed.tolist()

    assert speeds("confined", "lagged") == speeds("embedded", "lagged") != speeds("embedded", "kinematic")
