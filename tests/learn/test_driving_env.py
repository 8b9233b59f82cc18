"""The Gymnasium environment: its contract, its rewards, and what ends a drive."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace

import numpy as np
import pytest

pytest.importorskip("gymnasium", reason="the extra 'gym' is not installed")

from gymnasium.utils.env_checker import check_env

import chatscene
from chatscene.ego.intelligent_driver import IntelligentDriver
from chatscene.ego.observation import OBSERVATIONS
from chatscene.ego.rule_based import RuleBased
from chatscene.errors import EgoError, SettingsError
from chatscene.learn.env import DrivingEnv, vector_env
from chatscene.learn.reward import CRASH, REWARDS, Moment, progress, safebench
from chatscene.maps.network import resolve_map
from chatscene.program.ordinary import Course, ordinary_program, ordinary_queries
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, routes_of, simulate
from chatscene.terms.scene import Rejected, Scene

STRAIGHT = Course(program=ordinary_program(ordinary_queries()[0]), route=0)
CALM = {
    "OPT_PARKED_Y": 40.0,
    "OPT_AHEAD_Y": 70.0,
    "OPT_AHEAD_SPEED": 9.0,
    "OPT_BESIDE_Y": 10.0,
    "OPT_BESIDE_SPEED": 6.0,
}
AHEAD = {**CALM, "OPT_AHEAD_Y": 15.0, "OPT_AHEAD_SPEED": 5.0}
FULL = np.array((1.0, 0.0), np.float32)


@pytest.fixture
def env() -> Iterator[DrivingEnv]:
    made = DrivingEnv([STRAIGHT])
    yield made
    made.close()


@pytest.mark.parametrize("observation", sorted(OBSERVATIONS))
def test_gymnasium_finds_nothing_wrong_with_it(observation: str) -> None:
    env = DrivingEnv([STRAIGHT], ego_observation=observation, render_mode="rgb_array")
    check_env(env, skip_render_check=True)
    env.close()


def test_the_same_seed_gives_the_same_drive(env: DrivingEnv) -> None:
    def drive() -> list[list[float]]:
        seen, _ = env.reset(seed=5)
        return [seen.tolist(), *(env.step(FULL)[0].tolist() for _ in range(20))]

    assert drive() == drive()


def test_a_course_and_its_values_can_be_asked_for(env: DrivingEnv) -> None:
    _, info = env.reset(options={"course": 0, "values": CALM})
    assert info["values"] == CALM
    with pytest.raises(SettingsError, match="course must be a whole number from 0 to"):
        env.reset(options={"course": 7})


def test_a_course_with_values_is_one_scene() -> None:
    env = DrivingEnv([replace(STRAIGHT, values=CALM)])
    assert all(env.reset(seed=seed)[1]["values"] == CALM for seed in (1, 2))
    assert env.reset(options={"values": AHEAD})[1]["values"] == AHEAD
    env.close()


def test_a_picture_shows_what_moved() -> None:
    env = DrivingEnv([replace(STRAIGHT, values=CALM)], render_mode="rgb_array")
    env.reset()
    first = env.render()
    for _ in range(10):
        env.step(FULL)
    later = env.render()
    env.close()
    assert first is not None
    assert later is not None
    assert first.shape == later.shape == (360, 640, 3)
    assert first.dtype == np.uint8
    blue = np.array((42, 102, 224))  # the ego, which the picture holds in its middle
    assert all(
        np.abs(picture[170:190, 310:330].astype(int) - blue).sum(axis=2).min() < 30 for picture in (first, later)
    )
    assert not np.array_equal(first, later)


def test_there_is_no_picture_unless_it_was_asked_for(env: DrivingEnv) -> None:
    env.reset(seed=0)
    assert env.render() is None
    with pytest.raises(SettingsError, match=r"no render mode 'human'.*rgb_array"):
        DrivingEnv([STRAIGHT], render_mode="human")


def test_a_crash_terminates_and_is_not_truncated(env: DrivingEnv) -> None:
    env.reset(options={"course": 0, "values": AHEAD})
    while True:
        _, reward, terminated, truncated, info = env.step(FULL)
        if terminated or truncated:
            break
    assert (terminated, truncated, info["ending"], info["collision"]) == (True, False, "collision", True)
    assert info["reward"]["collision"] == CRASH
    assert reward == pytest.approx(math.fsum(info["reward"].values()))
    assert 0.0 < info["completion"] < 1.0


def test_running_out_of_steps_truncates_and_is_not_terminated() -> None:
    env = DrivingEnv([STRAIGHT], settings=SimulationSettings(max_steps=4))
    env.reset(options={"values": CALM})
    endings = [env.step(FULL)[2:4] for _ in range(4)]
    env.close()
    assert endings == [(False, False)] * 3 + [(False, True)]


def test_to_arrive_truncates_because_driving_goes_on_after_the_route(env: DrivingEnv) -> None:
    ego = RuleBased()
    observation, _ = env.reset(options={"values": CALM})
    while True:
        last = observation
        action = np.array(ego.act(observation.astype(float)), np.float32)
        observation, _, terminated, truncated, info = env.step(action)
        if terminated or truncated:
            break
    assert (terminated, truncated, info["ending"], info["completion"]) == (False, True, "arrived", 1.0)
    assert not np.array_equal(observation, last)  # a learner's bootstrap needs the state after the last step


def test_its_drives_are_those_of_the_simulator(env: DrivingEnv) -> None:
    env.reset(options={"values": CALM})
    for _ in range(40):
        env.step(np.array((0.5, 0.0), np.float32))
    episode = env.episode("half throttle")
    env.close()

    class HalfThrottle:
        def act(self, observation: object) -> tuple[float, float]:
            return 0.5, 0.0

    simulator = load_simulator(resolve_map("town"), SimulationSettings(max_steps=40))
    scene = Scene(id="s", scenario_id=STRAIGHT.program.scenario_id, route=0, block=0, seed=0, values=CALM)
    again = simulate(simulator, STRAIGHT.program, scene, HalfThrottle())
    assert hasattr(again, "ego_track")
    assert np.array_equal(episode.ego_track.x, again.ego_track.x)  # pyright: ignore[reportAttributeAccessIssue]


def test_stepping_without_a_drive_says_to_reset(env: DrivingEnv) -> None:
    with pytest.raises(EgoError, match="call reset first"):
        env.step(FULL)


@pytest.mark.parametrize("simulator", ["native", "embedded"])
def test_a_step_after_the_end_says_to_reset_and_so_does_the_session(simulator: str) -> None:
    env = DrivingEnv([STRAIGHT], settings=SimulationSettings(max_steps=2, simulator=simulator))
    env.reset(options={"values": CALM})
    assert [env.step(FULL)[3] for _ in range(2)] == [False, True]
    with pytest.raises(EgoError, match="call reset first"):
        env.step(FULL)
    env.close()
    scene = Scene(id="s", scenario_id=STRAIGHT.program.scenario_id, route=0, block=0, seed=0, values=CALM)
    there = load_simulator(resolve_map("town"), SimulationSettings(max_steps=2, simulator=simulator))
    session = there.open(STRAIGHT.program, scene, observation="road", pedals="safebench")
    assert not isinstance(session, Rejected)
    for _ in range(2):
        session.step(FULL)
    with pytest.raises(EgoError, match=r"the drive is over \(timeout\)"):
        session.step(FULL)
    session.close()


def test_a_second_environment_takes_the_drive_and_says_so(env: DrivingEnv) -> None:
    env.reset(seed=0)
    other = DrivingEnv([STRAIGHT])
    other.reset(seed=0)
    other.step(FULL)
    with pytest.raises(EgoError, match="a process of its own"):
        env.step(FULL)
    other.close()


def test_work_of_another_kind_takes_the_process_from_an_open_environment(env: DrivingEnv) -> None:
    env.reset(seed=0)
    written = chatscene.explain("A truck runs the red light from the left.")
    simulator = load_simulator(resolve_map("town"), SimulationSettings())
    assert routes_of(simulator, written.program, 1)  # compiles it
    with pytest.raises(EgoError, match="something else was simulated in this process"):
        env.step(FULL)
    env.reset(seed=0)
    env.step(FULL)


@pytest.mark.parametrize(("what", "name"), [("reward", "money"), ("pedals", "clutch")])
def test_unknown_presets_are_named(what: str, name: str) -> None:
    with pytest.raises(SettingsError, match=name):
        DrivingEnv([STRAIGHT], **{what: name})  # pyright: ignore[reportArgumentType]


def test_several_environments_run_in_processes_of_their_own() -> None:
    envs = vector_env(2, courses=[STRAIGHT])
    seen, _ = envs.reset(seed=[1, 1])  # pyright: ignore[reportArgumentType]
    assert np.array_equal(seen[0], seen[1])
    actions = np.array([[1.0, 0.0], [0.0, 0.0]], np.float32)
    for _ in range(5):
        seen = envs.step(actions)[0]
    assert seen[0][2] > seen[1][2]
    envs.close()


def moment(**changes: float | bool) -> Moment:
    standing = {"collided": False, "speed": 0.0, "lateral": 0.0, "steer": 0.0, "progress": 0.0}
    return Moment(**standing | changes)  # pyright: ignore[reportArgumentType]


def test_safebench_pays_for_speed_and_takes_ten_above_eight_metres_per_second() -> None:
    assert sum(safebench(moment(speed=7.5)).values()) == pytest.approx(7.5)
    assert sum(safebench(moment(speed=8.5)).values()) == pytest.approx(-1.5)


def test_safebench_charges_for_lane_steering_and_cornering_as_its_code_does() -> None:
    terms = safebench(moment(speed=5.0, lateral=-4.5, steer=0.2, collided=True))
    assert terms == pytest.approx(
        {
            "collision": -1.0,
            "speed": 5.0,
            "too_fast": 0.0,
            "out_of_lane": -1.0,
            "steering": -0.2,
            "lateral_acceleration": -1.0,
        }
    )


def test_progress_does_not_pay_for_standing_still_and_charges_for_a_crash() -> None:
    assert sum(progress(moment()).values()) < 0.0
    assert sum(progress(moment(speed=7.0, progress=0.7)).values()) > 0.0
    # More than driving on for the rest of a route could be worth at a discount of 0.99: 0.7 m a step, 100 times over.
    assert progress(moment(collided=True))["collision"] < -0.5 * 0.7 / (1 - 0.99)


@pytest.mark.parametrize("name", sorted(REWARDS))
def test_every_reward_is_a_sum_of_named_numbers(name: str) -> None:
    terms = REWARDS[name](moment(speed=3.0, progress=0.3))
    assert terms
    assert all(math.isfinite(value) for value in terms.values())


def test_the_intelligent_driver_brakes_for_a_pedestrian_the_four_numbers_do_not_show() -> None:
    env = DrivingEnv([STRAIGHT], ego_observation="actors", pedals="full-brake")
    observation, _ = env.reset(options={"values": CALM})
    env.close()
    walker = observation.astype(float)
    walker[0] = 7.0
    walker[14:25] = (1.0, 12.0, 0.0, 12.0, 0.0, 0.0, 0.5, 1.57, 0.3, 0.3, 1.0)
    assert IntelligentDriver().act(walker)[0] < -0.2


@pytest.mark.parametrize("reward", sorted(REWARDS))
def test_at_the_speed_of_the_road_no_reward_charges_for_a_speed_that_is_allowed(reward: str) -> None:
    env = DrivingEnv(ego_observation="traffic", reward=reward, speed=40.0, settings=SimulationSettings(max_steps=5))
    assert all(course.program.wanted_speed == pytest.approx(40 / 3.6, abs=0.01) for course in env.courses)
    observation, _ = env.reset(seed=0, options={"course": 0})
    assert observation.shape == env.observation_space.shape == (OBSERVATIONS["traffic"],)
    assert observation[0] == pytest.approx(40 / 3.6, abs=0.01)
    rested = env.step(np.array((-0.3, 0.0), np.float32))[-1]["reward"]
    hurried = [env.step(np.array((1.0, 0.0), np.float32))[-1]["reward"] for _ in range(4)]
    env.close()
    assert rested["too_fast"] == 0.0
    assert hurried[-1]["too_fast"] < 0.0


@pytest.mark.parametrize("simulator", ["native", "embedded"])
def test_no_courses_are_no_ordinary_courses(simulator: str) -> None:
    settings = SimulationSettings(simulator=simulator)
    with pytest.raises(SettingsError, match="nothing to drive" if simulator == "native" else "count must be"):
        vector_env(2 if simulator == "native" else 0, courses=[], settings=settings)


@pytest.mark.parametrize("speed", [0, -5, 1000, float("nan")])
def test_a_speed_that_no_command_takes_is_refused(speed: float) -> None:
    with pytest.raises(SettingsError, match=r"speed must be a number from 1\.0 to 300\.0"):
        DrivingEnv(speed=speed)
