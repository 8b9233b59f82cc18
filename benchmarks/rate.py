"""Whether `chatscene rate` tells what brute force finds, and with how many drives.

    python benchmarks/rate.py --out FOLDER [--case 0 …] [--brute 1000000] [--repetitions 100] [--jobs 2]
    python benchmarks/rate.py --out FOLDER --forty idm [--forty planner] [--brute 3000] [--repetitions 1] [--jobs 2]

For each case, a sentence with an ego, `--brute` scenes with every value of the ranges alike, on one route, driven and
not judged; and `--repetitions` rates, each of a run of twenty such scenes of its own and of so many further ones as the
case has. Prints the share of crashes with the adversary by brute force with its interval; of the rates, how many could
be told, their mean, how many of their intervals hold the share and how many meet its interval; and how many drives
without weights have intervals as narrow. `--forty` takes the benchmark's forty sentences with an ego. What brute force
found and the runs stay in the folder. The scenes of brute force are drawn, placed and driven by what a run uses; that
they are counted alike is the one thing that no code of `rate` has a part in.
"""

from __future__ import annotations

import hashlib
import json
import math
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import asdict, dataclass
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
from chatscene.search.generator import load_generator
from chatscene.search.rare import Share
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.terms.scenario import BaseScenario
from chatscene.terms.scene import Rejected, Scene

CASES = (  # further scenes of a rate: as many as most rates of the case can be told from
    ("A car runs the red light from the left.", "planner", 300),
    ("We go straight on at the lights; from the left a car ignores its red signal and turns left.", "idm", 6000),
    (
        "We try to overtake a slow leader by changing lanes; the car in the next lane drops to the speed of the leader "
        "and keeps us from getting in.",
        "idm",
        1500,
    ),
    ("The car ahead of us in the left lane cuts in.", "idm", 4000),
)
OF_THE_FORTY = 600  # further scenes of a rate
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


def forced(case: tuple[str, str], scenes: int, workers: Workers, out: Path) -> Forced:
    """What brute force finds of a sentence and an ego; what it found before is in the folder."""
    known = out / f"forced-{scenes}-{hashlib.sha256(' '.join(case).encode()).hexdigest()[:12]}.json"
    if known.exists():
        return Forced(**json.loads(known.read_text()))
    batches: Iterable[range] = [range(at, min(at + BATCH, scenes)) for at in range(0, scenes, BATCH)]
    found = list(spread(Driver, case, batches, workers=workers))
    whole = Forced(sum(one.placed for one in found), sum(one.crashed for one in found))
    out.mkdir(parents=True, exist_ok=True)
    known.write_text(json.dumps(asdict(whole)))
    return whole


@click.command()
@click.option("--case", "numbers", type=click.IntRange(0, len(CASES) - 1), multiple=True, help="All if none is named.")
@click.option("--forty", "egos", multiple=True, help="The forty sentences with this ego, in place of the cases.")
@click.option("--brute", default=1_000_000, show_default=True)
@click.option("--repetitions", default=100, show_default=True)
@click.option("--jobs", default=1, show_default=True)
@click.option("--out", type=click.Path(file_okay=False, path_type=Path), required=True)
def main(numbers: tuple[int, ...], egos: tuple[str, ...], brute: int, repetitions: int, jobs: int, out: Path) -> None:
    generator = load_generator("chatscene")
    forty = [text for base in BaseScenario for text in generator.texts(base)]
    cases = [CASES[number] for number in numbers or range(len(CASES))]
    cases = [(text, ego, OF_THE_FORTY) for ego in egos for text in forty] or cases
    counted: Counter[str] = Counter()
    for text, ego, scenes in cases:
        truth = forced((text, ego), brute, Workers(jobs), out)
        low, high = truth.interval()
        told = f"{truth.crashed} of {truth.placed} crash, {truth.share:.4%} ({low:.4%} to {high:.4%})"
        print(f"{text} {ego}: brute force: {told}", flush=True)
        found = list(rates(text, ego, scenes, repetitions, jobs, out))
        probable = [one for one in found if one.probability is not None]
        held = sum((one.low or 0) <= truth.share <= (one.high or 0) for one in probable)
        met = sum((one.low or 0) <= high and low <= (one.high or 0) for one in probable)
        counted.update(told=len(probable), held=held, met=met, none=sum(not one.seen for one in found))
        if not probable:
            below = [f"{one.high:.2%}" for one in found if one.high is not None]
            seen = sorted(one.seen for one in found)
            print(f"  none of {repetitions} could be told; crashes seen: {seen}; below {' '.join(below)}", flush=True)
            continue
        shares = np.array([one.probability for one in probable])
        widths = np.array([(one.high or 0) - (one.low or 0) for one in probable])
        as_many = (2 * 1.96) ** 2 * truth.share * (1 - truth.share) / np.median(widths) ** 2
        print(
            f"  {len(probable)} of {repetitions} told from {scenes + 20} scenes each: mean {shares.mean():.4%}, from "
            f"{shares.min():.4%} to {shares.max():.4%}; {held} hold what brute force found, {met} meet its interval; "
            f"as narrow as {as_many:.0f} drives without weights, {as_many / (scenes + 20):.1f} times as many",
            flush=True,
        )
    print(f"of {len(cases) * repetitions} rates: {dict(counted)}")


def rates(text: str, ego: str, scenes: int, repetitions: int, jobs: int, out: Path) -> Iterator[Share]:
    """How often it crashes, told anew from a run of its own."""
    name = pipeline.understand(text).scenario.id
    for seed in range(repetitions):
        folder = out / f"{name}-{ego}-{seed}"
        if not (folder / "run.json").exists():
            chatscene.run(text, folder, ego=ego, sampler="random", simulator="native", scenes=20, seed=seed)
        yield chatscene.rate(folder, scenes=scenes, seed=seed, jobs=jobs).crash


if __name__ == "__main__":
    main()
