"""Find what `chatscene.ego.planner` weighs its ways by: CMA-ES over drives on kept scenes.

    python benchmarks/planner.py RUNS [--minutes 35] [--scenes 110]

RUNS are the folders of searched runs, as `chatscene finetune` takes them. Only scenes of routes 0 to 5 are driven, so
that 6 and 7 can choose and 8 and up test. Minimised is the collision rate, plus half of what was not completed, plus a
little for every weight that is far from where it began. Needs the extra `search`. Prints the best so far.
"""

from __future__ import annotations

import argparse
import time
from dataclasses import fields, replace
from pathlib import Path

import numpy as np
from cmaes import CMA

from chatscene.ego.planner import Caution, Planner
from chatscene.learn.finetune.scenes import TRAIN, judge, kept_scenes, split
from chatscene.maps.network import resolve_map
from chatscene.simulate.simulator import load_simulator

# Where the search that gave the present weights began.
START = Caution(
    speed=8.0, crash=12.0, graze=0.1, patience=2.0, braking=(5.0, 0.3), starting=(3.0, 0.25), stepping=(1.5, 0.15),
    room=0.8, side=0.3, widening=0.12, berth=0.6, haste=1.0, offset=0.06, astray=0.24, jerk=0.03, resolve=0.15,
    agility=0.4, drift=2.2,
)  # fmt: skip
FASTEST = 8.5  # [m/s]


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("runs", nargs="+", type=Path)
    parser.add_argument("--minutes", type=float, default=35.0)
    parser.add_argument("--scenes", type=int, default=110)
    options = parser.parse_args()
    lessons = kept_scenes(options.runs)
    simulator = load_simulator(resolve_map(lessons.map_name), lessons.simulation)
    train = split(lessons.scenes, choice="held-out", train_routes=8, validation_routes=2)[TRAIN]
    drawn = [train[i] for i in np.random.default_rng(0).permutation(len(train))[: options.scenes]]
    search = CMA(mean=np.zeros(len(flat(START))), sigma=0.3, seed=0, population_size=10)
    began, best = time.monotonic(), np.inf
    while time.monotonic() - began < 60.0 * options.minutes:
        told = []
        for _ in range(search.population_size):
            x = search.ask()
            figures = judge(Planner(moved(x)), drawn, simulator, on_scene=lambda _done, _total: None).figures
            worth = figures["collision_rate"] + 0.5 * (1.0 - figures["completion"]) + 0.01 * float(np.mean(x**2))
            told.append((x, worth))
            if worth < best:
                best = worth
                print(f"{figures['collision_rate']:.3f} at {figures['completion']:.3f}: {moved(x)}", flush=True)
        search.tell(told)


def flat(caution: Caution) -> list[float]:
    """Its numbers in a row."""
    values = (getattr(caution, field.name) for field in fields(caution))
    return [number for value in values for number in (value if isinstance(value, tuple) else (value,))]


def moved(x: np.ndarray) -> Caution:
    """The start, each number times e to the power of one of `x`."""
    numbers = iter((np.array(flat(START)) * np.exp(x)).tolist())
    values = {
        field.name: (next(numbers), next(numbers)) if isinstance(getattr(START, field.name), tuple) else next(numbers)
        for field in fields(START)
    }
    found = Caution(**values)
    return replace(found, speed=min(found.speed, FASTEST))


if __name__ == "__main__":
    main()
