"""Several environments at a time, each as it would be alone."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

pytest.importorskip("gymnasium", reason="the extra 'gym' is not installed")

import gymnasium
from gymnasium.vector import AutoresetMode

from chatscene.errors import EgoError
from chatscene.learn.env import DrivingEnv, SideBySide, vector_env
from chatscene.program.ordinary import Course, ordinary_program, ordinary_queries
from chatscene.settings import SimulationSettings

NATIVE = SimulationSettings(simulator="native", max_steps=15)
COURSES = [Course(program=ordinary_program(ordinary_queries()[0]), route=route) for route in (0, 1)]


def test_environments_side_by_side_are_what_each_is_alone() -> None:
    count, steps = 3, 40
    actions = np.random.default_rng(0).uniform(-1.0, 1.0, (steps, count, 2)).astype(np.float32)
    together = vector_env(count, courses=COURSES, settings=NATIVE)
    assert isinstance(together, gymnasium.vector.SyncVectorEnv)
    assert together.metadata["autoreset_mode"] is AutoresetMode.NEXT_STEP
    seen, _ = together.reset(seed=5)
    came = [together.step(row)[:4] for row in actions]
    together.close()
    for i in range(count):
        alone = DrivingEnv(COURSES, settings=SimulationSettings(max_steps=15))  # embedded
        first, _ = alone.reset(seed=5 + i)
        assert np.array_equal(first, seen[i])
        over, drives = False, 1
        for action, row in zip(actions[:, i], came, strict=True):
            expected: Any = (alone.reset()[0], 0.0, False, False) if over else alone.step(action)[:4]
            drives += over
            assert all(np.array_equal(mine, its) for mine, its in zip(expected, (part[i] for part in row), strict=True))
            over = expected[2] or expected[3]
        assert drives > 1
        alone.close()


def _same(one: Any, other: Any) -> bool:
    if isinstance(one, dict):
        return one.keys() == other.keys() and all(_same(one[name], other[name]) for name in one)
    return np.array_equal(one, other) and np.asarray(one).dtype == np.asarray(other).dtype


@pytest.mark.parametrize(("preset", "reward"), [("safebench", "progress"), ("traffic", "safebench")])
def test_a_step_in_one_call_tells_all_that_steps_one_after_the_other_do(preset: str, reward: str) -> None:
    count, steps = 4, 40
    actions = np.random.default_rng(1).uniform(-1.0, 1.0, (steps, count, 2)).astype(np.float32)
    how: dict[str, Any] = {"courses": COURSES, "ego_observation": preset, "reward": reward, "settings": NATIVE}
    together, apart = vector_env(count, **how), gymnasium.vector.SyncVectorEnv([lambda: DrivingEnv(**how)] * count)
    assert isinstance(together, SideBySide)
    first, then = together.reset(seed=3), apart.reset(seed=3)
    assert _same(first[1], then[1])
    ended = 0
    for row in actions:
        mine, its = together.step(row), apart.step(row)
        assert all(_same(one, other) for one, other in zip(mine, its, strict=True))
        ended += int(np.count_nonzero(mine[2] | mine[3]))
    assert ended > count
    one, other = (envs.envs[0].unwrapped.episode("x") for envs in (together, apart))  # pyright: ignore[reportAttributeAccessIssue]
    assert one.route_completion == other.route_completion
    assert all(map(np.array_equal, (t.x for t in one.tracks), (t.x for t in other.tracks)))


def test_what_is_no_action_is_refused_as_by_one_alone_and_a_drive_begun_by_hand_is_driven() -> None:
    envs = vector_env(2, courses=COURSES, settings=NATIVE)
    envs.reset(seed=0)
    with pytest.raises(EgoError, match="finite"):
        envs.step(np.array([[0.0, 0.0], [np.nan, 0.0]], np.float32))
    assert isinstance(envs, SideBySide)
    seen, _ = envs.envs[1].reset(seed=9)
    alone = DrivingEnv(COURSES, settings=NATIVE)
    assert np.array_equal(alone.reset(seed=9)[0], seen)
    action = np.array([0.5, 0.1], np.float32)
    assert np.array_equal(envs.step(np.array([action, action]))[0][1], alone.step(action)[0])


def test_a_drive_that_was_driven_to_its_end_by_hand_is_stepped_no_further() -> None:
    envs = vector_env(2, courses=COURSES, settings=NATIVE)
    envs.reset(seed=0)
    actions = np.zeros((2, 2), np.float32)
    envs.step(actions)
    assert isinstance(envs, SideBySide)
    first, second = (env.unwrapped for env in envs.envs)
    assert isinstance(first, DrivingEnv)
    assert isinstance(second, DrivingEnv)
    while not any(second.step(actions[1])[2:4]):
        pass
    with pytest.raises(EgoError, match="is over: begin another"):
        envs.step(actions)
    assert [env.drive.step_number for env in (first, second) if env.drive] == [1, 15]
