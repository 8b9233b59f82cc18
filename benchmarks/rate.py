"""Whether `chatscene rate` tells what brute force finds, and with how many drives.

    python benchmarks/rate.py --out FOLDER [--case 0 …] [--brute 100000] [--scenes 300] [--repetitions 100] [--jobs 2]

For each sentence and ego `--brute` scenes with every value of the ranges alike, on one route, driven and not judged;
and `--repetitions` rates, each of a run of twenty such scenes of its own and `--scenes` further ones. Prints the share
of crashes with the adversary by brute force with its interval; of the rates, how many could be told, their mean, how
many of their intervals hold the share and how many meet its interval; and how many drives without weights have
intervals as narrow. The scenes of brute force are drawn, placed and driven by what a run uses; that they are counted
alike is the one thing that no code of `rate` has a part in.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path

import click
import numpy as np

import chatscene
from chatscene import pipeline
from chatscene.ego.policy import load_ego
from chatscene.maps.network import resolve_map
from chatscene.program.sample import draw, scene_seed
from chatscene.runs.executor import Workers
from chatscene.runs.parallel import spread
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.terms.scene import Rejected, Scene

CASES = (
    ("A car runs the red light from the left.", "planner"),
    ("A car pulls out from the left kerb.", "planner"),
    ("A car from the right runs the red light while we turn left.", "idm"),
    (
        "We try to overtake a slow leader by changing lanes; the car in the next lane drops to the speed of the leader "
        "and keeps us from getting in.",
        "planner",
    ),
)
BATCH = 500


@dataclass(frozen=True)
class Forced:
    """What brute force found.

    Attributes:
        placed: How many scenes could be placed.
        crashed: In how many of them the ego's first collision was with an adversary.
    """

    placed: int
    crashed: int

    @property
    def share(self) -> float:
        """Of the scenes that could be placed."""
        return self.crashed / self.placed

    def interval(self) -> tuple[float, float]:
        """Wilson's, 95 %."""
        z2, n, p = 1.96**2, self.placed, self.share
        half = 1.96 * math.sqrt(p * (1 - p) / n + z2 / (4 * n * n))
        return tuple((p + z2 / (2 * n) + sign * half) / (1 + z2 / n) for sign in (-1, 1))  # pyright: ignore[reportReturnType]


class Driver:
    """Drives batches of scenes in one process, and counts."""

    def __init__(self, case: tuple[str, str]) -> None:
        text, ego = case
        self._program = pipeline.understand(text).program
        self._simulator = load_simulator(resolve_map("town"), SimulationSettings(simulator="native"))
        self._ego = load_ego(ego)

    def __call__(self, scenes: range) -> Forced:
        """Draw, place and drive them."""
        placed = crashed = 0
        for number in scenes:
            name = f"{self._program.scenario_id}/brute-{number}"
            seed = scene_seed(1, name)
            values = draw(self._program.parameters, seed=seed)
            scene = Scene(id=name, scenario_id=self._program.scenario_id, route=0, block=0, seed=seed, values=values)
            episode = simulate(self._simulator, self._program, scene, self._ego)
            if not isinstance(episode, Rejected):
                placed += 1
                crash = episode.collision
                crashed += crash is not None and crash.other in {one.actor for one in episode.adversaries}
        return Forced(placed, crashed)


def forced(case: tuple[str, str], scenes: int, workers: Workers) -> Forced:
    """What brute force finds of a sentence and an ego."""
    batches: Iterable[range] = [range(at, min(at + BATCH, scenes)) for at in range(0, scenes, BATCH)]
    found = list(spread(Driver, case, batches, workers=workers))
    return Forced(sum(one.placed for one in found), sum(one.crashed for one in found))


@click.command()
@click.option("--case", "numbers", type=int, multiple=True, default=tuple(range(len(CASES))), show_default=True)
@click.option("--brute", default=100_000, show_default=True)
@click.option("--scenes", default=300, show_default=True)
@click.option("--repetitions", default=100, show_default=True)
@click.option("--jobs", default=1, show_default=True)
@click.option("--out", type=click.Path(file_okay=False, path_type=Path), required=True)
def main(numbers: tuple[int, ...], brute: int, scenes: int, repetitions: int, jobs: int, out: Path) -> None:
    for number in numbers:
        text, ego = CASES[number]
        truth = forced((text, ego), brute, Workers(jobs))
        low, high = truth.interval()
        told = f"{truth.crashed} of {truth.placed} crash, {truth.share:.3%} ({low:.3%} to {high:.3%})"
        print(f"{text} {ego}: brute force: {told}", flush=True)
        found = []
        for seed in range(repetitions):
            folder = out / f"{number}-{seed}"
            if not (folder / "run.json").exists():
                chatscene.run(text, folder, ego=ego, sampler="random", simulator="native", scenes=20, seed=seed)
            found.append(chatscene.rate(folder, scenes=scenes, seed=seed).crash)
        rates = [one for one in found if one.probability is not None]
        if not rates:
            print(f"  none of {repetitions} could be told; crashes seen: {[one.seen for one in found]}", flush=True)
            continue
        held = sum((one.low or 0) <= truth.share <= (one.high or 0) for one in rates)
        met = sum((one.low or 0) <= high and low <= (one.high or 0) for one in rates)
        shares = np.array([one.probability for one in rates])
        widths = np.array([(one.high or 0) - (one.low or 0) for one in rates])
        as_many = (2 * 1.96) ** 2 * truth.share * (1 - truth.share) / widths.mean() ** 2
        print(
            f"  {len(rates)} of {repetitions} told from {scenes + 20} scenes each: mean {shares.mean():.3%}, from "
            f"{shares.min():.3%} to {shares.max():.3%}; {held} hold what brute force found, {met} meet its interval; "
            f"as narrow as {as_many:.0f} drives without weights",
            flush=True,
        )


if __name__ == "__main__":
    main()
