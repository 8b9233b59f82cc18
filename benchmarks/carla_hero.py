"""Drives the hero of a scenario that another program runs: CARLA's own BasicAgent at its wheel.

    PYTHONPATH=AGENTS PYTHON benchmarks/carla_hero.py PORT SPEED

Waits for a vehicle whose role is `hero`, drives it at SPEED km/h in each frame until it is gone or killed. Needs the
wheel carla and a folder AGENTS that has CARLA's package `agents`. Its turns at junctions are drawn from seed 0.
"""

from __future__ import annotations

import random
import sys
import time

import carla  # pyright: ignore[reportMissingImports]
from agents.navigation.basic_agent import BasicAgent  # pyright: ignore[reportMissingImports]


def main() -> None:
    port, speed = int(sys.argv[1]), float(sys.argv[2])
    random.seed(0)
    client = carla.Client("127.0.0.1", port)
    client.set_timeout(20.0)
    hero = None
    while hero is None:
        time.sleep(0.1)
        world = client.get_world()
        cars = world.get_actors().filter("vehicle.*")
        hero = next((car for car in cars if car.attributes.get("role_name") == "hero"), None)
    print("drives", hero.id, flush=True)
    agent = BasicAgent(hero, speed)
    while hero.is_alive:
        world.wait_for_tick(20.0)
        hero.apply_control(agent.run_step())


if __name__ == "__main__":
    main()
