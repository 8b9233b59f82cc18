"""How many steps of vehicles highway-env makes a second of processor time, to stand beside `native_speed.py`.

    python -m venv /tmp/highway && /tmp/highway/bin/pip install highway-env
    /tmp/highway/bin/python benchmarks/beside_highway_env.py [--rounds 3]

highway-env is no extra of ours: this file needs it alone, and nothing of chatscene.

Everybody, the ego too, drives by IDM and MOBIL on a straight road of four lanes at 10 Hz. *Moving* is what moves them,
`Road.act` and `Road.step`; *environment* is `step` of highway-v0 with an ego that holds its speed, observation and
reward included, at 10 Hz as well. A step of one vehicle counts one.
"""

from __future__ import annotations

import argparse
import statistics
import time
from collections.abc import Callable
from typing import Any

import gymnasium
import highway_env  # pyright: ignore[reportMissingImports]
from highway_env.road.road import Road, RoadNetwork  # pyright: ignore[reportMissingImports]
from highway_env.vehicle.behavior import IDMVehicle  # pyright: ignore[reportMissingImports]

STEPS = 200
IDLE = 1
DT = 0.1  # [s]


def moving(vehicles: int) -> Callable[[], int]:
    """Moves vehicles, and says how many steps of a vehicle that were."""
    road: Any = Road(RoadNetwork.straight_road_network(4))
    for _ in range(vehicles):
        road.vehicles.append(IDMVehicle.create_random(road, spacing=1))

    def go() -> int:
        for _ in range(STEPS):
            road.act()
            road.step(DT)
        return STEPS * vehicles

    return go


def environment(vehicles: int) -> Callable[[], int]:
    """Steps a whole environment until it ends, again and again."""
    rates = {"simulation_frequency": 10, "policy_frequency": 10, "duration": STEPS}
    env: Any = gymnasium.make("highway-v0", config={**rates, "vehicles_count": vehicles - 1})
    env.reset(seed=0)

    def go() -> int:
        for _ in range(STEPS):
            _, _, terminated, truncated, _ = env.step(IDLE)
            if terminated or truncated:
                env.reset()
        return STEPS * vehicles

    return go


def rate(go: Callable[[], int]) -> float:
    """Steps of a vehicle a second of processor time."""
    began = time.process_time()
    steps = go()
    return steps / (time.process_time() - began)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("--rounds", type=int, default=3)
    rounds = parser.parse_args().rounds
    print(f"highway-env {highway_env.__version__}")
    for vehicles in (3, 20, 50):
        for what, go in (("moving", moving(vehicles)), ("environment", environment(vehicles))):
            rates = [rate(go) for _ in range(rounds)]
            each = ", ".join(f"{one:,.0f}" for one in rates)
            print(f"{vehicles} vehicles, {what}: {statistics.median(rates):,.0f} agent-steps/s ({each})")


if __name__ == "__main__":
    main()
