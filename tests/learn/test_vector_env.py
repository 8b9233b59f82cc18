"""Several environments at a time, each as it would be alone."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

pytest.importorskip("gymnasium", reason="the extra 'gym' is not installed")

import gymnasium
from gymnasium.vector import AutoresetMode

from chatscene.learn.env import DrivingEnv, vector_env
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
