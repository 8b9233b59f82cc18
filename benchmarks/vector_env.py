"""What a step of an environment takes: alone in either simulator, and several side by side in `native`.

    python benchmarks/vector_env.py [--count 8] [--steps 300] [--courses 2] [--seed 0] [--together]

Ordinary drives of the town, actions drawn at random. Processor time of a step of one environment, and what resets add
to it; compiling is left out, since every course is begun once before.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from typing import Any

import click
import numpy as np

from chatscene.learn.env import DrivingEnv, vector_env
from chatscene.maps.network import resolve_map
from chatscene.program.ordinary import Course, ordinary_courses
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator

NATIVE = SimulationSettings(simulator="native")


def alone(settings: SimulationSettings, courses: Sequence[Course], actions: Any, seed: int) -> tuple[float, int]:
    """Seconds of steps and resets of environments that drive one after the other, and how many drives there were."""
    env = DrivingEnv(courses, settings=settings)
    for course in range(len(courses)):
        env.reset(seed=seed, options={"course": course})
    began, drives = time.process_time(), 0
    for i in range(actions.shape[1]):
        env.reset(seed=seed + i)
        over = False
        for action in actions[:, i]:
            if over:
                env.reset()
                over = False
                drives += 1
            else:
                over = any(env.step(action)[2:4])
    env.close()
    return time.process_time() - began, drives


def together(courses: Sequence[Course], actions: Any, seed: int) -> tuple[float, int]:
    """The same of environments side by side."""
    envs = vector_env(actions.shape[1], courses=courses, settings=NATIVE)
    for course in range(len(courses)):
        envs.reset(seed=seed, options={"course": course})
    began, drives = time.process_time(), 0
    envs.reset(seed=seed)
    for row in actions:
        _, _, terminated, truncated, _ = envs.step(row)
        drives += int(np.count_nonzero(terminated | truncated))
    envs.close()
    return time.process_time() - began, drives


@click.command()
@click.option("--count", default=8)
@click.option("--steps", default=300)
@click.option("--courses", "several", default=2)
@click.option("--seed", default=0)
@click.option("--together", "only", is_flag=True, help="Side by side alone; many are slow in the embedded simulator.")
def main(count: int, steps: int, several: int, seed: int, *, only: bool) -> None:
    draw = np.random.default_rng(seed)
    actions = draw.uniform((-0.3, -0.05), (1.0, 0.05), (steps, count, 2)).astype(np.float32)
    courses = ordinary_courses(load_simulator(resolve_map("town"), SimulationSettings()))[:several]
    ways = {
        "alone, embedded": lambda: alone(SimulationSettings(), courses, actions, seed),
        "alone, native": lambda: alone(NATIVE, courses, actions, seed),
        "side by side, native": lambda: together(courses, actions, seed),
    }
    for name, way in [*ways.items()][2 * only :]:
        seconds, drives = way()
        each = seconds / (steps * count)
        print(f"{name}: {1e6 * each:.0f} us a step, {1.0 / each:,.0f} steps/s; {drives} drives ended")


if __name__ == "__main__":
    main()
