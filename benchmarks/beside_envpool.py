"""How many steps of vehicles EnvPool's highway makes a second of processor time, to stand beside `native_speed.py`.

    python -m venv /tmp/envpool && /tmp/envpool/bin/pip install envpool gymnasium
    /tmp/envpool/bin/python benchmarks/beside_envpool.py [--rounds 3]

EnvPool is no extra of ours: this file needs it alone, and nothing of chatscene.

Its `Highway-v0` is highway-env's in C++: everybody but the ego drives by IDM and MOBIL on a straight road of four
lanes; 16 environments are stepped in one call by one thread, observation and reward included, the ego holding its
speed. *10 Hz* steps its world once a step, as ours; *as shipped* 15 times, and 5 times in `HighwayFast-v0`. A step of
one vehicle in its world counts one.
"""

from __future__ import annotations

import argparse
import statistics
import time
from importlib.metadata import version
from typing import Any

import envpool  # pyright: ignore[reportMissingImports]
import numpy as np

MANY = 16
STEPS = 300
IDLE = 1
CASES = {
    "3 vehicles, 10 Hz": ("Highway-v0", {"vehicles_count": 2, "simulation_frequency": 10, "policy_frequency": 10}),
    "20 vehicles, 10 Hz": ("Highway-v0", {"vehicles_count": 19, "simulation_frequency": 10, "policy_frequency": 10}),
    "50 vehicles, 10 Hz": ("Highway-v0", {"vehicles_count": 49, "simulation_frequency": 10, "policy_frequency": 10}),
    "51 vehicles, as shipped": ("Highway-v0", {}),
    "21 vehicles, as shipped, fast": ("HighwayFast-v0", {}),
}


def rate(env: Any) -> float:
    """Steps of a vehicle a second of processor time."""
    config = env.spec.config
    ticks = config.simulation_frequency // config.policy_frequency
    idle = np.full(MANY, IDLE)
    env.reset()
    began = time.process_time()
    for _ in range(STEPS):
        env.step(idle)
    return STEPS * MANY * (config.vehicles_count + 1) * ticks / (time.process_time() - began)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=3)
    rounds = parser.parse_args().rounds
    print(f"EnvPool {version('envpool')}")
    for case, (name, told) in CASES.items():
        env: Any = envpool.make_gymnasium(name, num_envs=MANY, num_threads=1, seed=0, **told)
        rates = [rate(env) for _ in range(rounds)]
        each = ", ".join(f"{one:,.0f}" for one in rates)
        print(f"{case}: {statistics.median(rates):,.0f} agent-steps/s ({each})")


if __name__ == "__main__":
    main()
