"""Distinct avoidable failures that searches find, per 1,000 simulations, over the forty sentences of the benchmark.

    python benchmarks/avoidable.py [--ego idm] [--half 0] [--sampler random …] [--routes 3] [--seeds 5]
        [--generator chatscene] [--physics kinematic] [--jobs 2]

A row is a search; each drives 50 scenes a sentence, route and seed in the native simulator, and is held by what a
careful driver of UN R157 would have avoided. Failures are distinct if their outcomes are: who struck whom with what
part, severity, place and relative heading (`chatscene.measure.outcome`). Samplers are chosen by the even sentences
(--half 0) and told of by the odd ones (--half 1). Another generator has the scenarios that it has, and is searched with
by the same samplers.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import product

import click
import numpy as np

from chatscene.ego.policy import load_ego
from chatscene.maps.network import resolve_map
from chatscene.measure.sums import STANDING
from chatscene.runs.executor import Workers
from chatscene.runs.parallel import spread
from chatscene.search.explore import explore
from chatscene.search.generator import load_generator
from chatscene.search.sampler import SAMPLERS
from chatscene.settings import RetrievalSettings, SearchSettings, SimulationSettings
from chatscene.simulate.simulator import load_simulator, routes_of
from chatscene.terms.braking import STANDSTILL
from chatscene.terms.episode import Episode
from chatscene.terms.scenario import BaseScenario

BEFORE = SearchSettings(sampler="paper", objective="collision")


@dataclass(frozen=True)
class Task:
    """One search: a sentence on all its routes with one seed."""

    text: str
    settings: SearchSettings


@dataclass(frozen=True)
class Crash:
    """One crash of a search.

    Attributes:
        route: On which route.
        kind: `chatscene.measure.crash_type`.
        avoidable: Whether a careful driver would have avoided it.
        by_ego: Whether the ego struck.
        blocked: Whether the ego ran into somebody who had stood still for as long as one waits for nothing more.
    """

    route: int
    kind: str
    avoidable: bool
    by_ego: bool
    blocked: bool


@dataclass(frozen=True)
class Found:
    """What a search came to."""

    driven: int
    crashes: tuple[Crash, ...]
    waited: int


class Searcher:
    """Does searches in one process."""

    def __init__(self, generator_ego_and_physics: tuple[str, str, str]) -> None:
        generator, ego, physics = generator_ego_and_physics
        self._generator = load_generator(generator)
        self._simulator = load_simulator(resolve_map("town"), SimulationSettings(simulator="native", physics=physics))
        self._ego = load_ego(ego)

    def __call__(self, task: Task) -> tuple[Task, Found]:
        """Search on every route."""
        scenario = self._generator.read(task.text, RetrievalSettings())
        program = self._generator.write(scenario, RetrievalSettings()).program
        driven = waited = 0
        crashes: list[Crash] = []
        for route in routes_of(self._simulator, program, task.settings.routes):
            blocks = explore(
                program,
                scenario.slots,
                route,
                simulator=self._simulator,
                ego=self._ego,
                settings=task.settings,
            )
            for ran in (ran for block in blocks for ran in block.ran):
                driven += 1
                waited += ran.waits
                if ran.fault is not None:
                    blocked = stood(ran.episode)
                    crashes.append(Crash(route, ran.crash_type, bool(ran.avoidable), ran.fault.by_ego, blocked))
        return task, Found(driven, tuple(crashes), waited)


def stood(episode: Episode) -> bool:
    """Whether whom the ego collided with had stood still for as long as one waits for nothing more."""
    crash = episode.collision
    assert crash is not None
    other = next(track for track in episode.tracks if track.actor == crash.other)
    before = other.speed[max(crash.step - round(STANDSTILL / episode.dt), 0) : crash.step + 1]
    return bool((np.abs(before) < STANDING).all())


def row(found: Sequence[Found]) -> dict[str, float]:
    """Per 1,000 simulations of all searches together."""
    driven = sum(one.driven for one in found) / 1000
    avoidable = [[crash for crash in one.crashes if crash.avoidable] for one in found]
    return {
        "crashes": sum(len(one.crashes) for one in found) / driven,
        "avoidable": sum(map(len, avoidable)) / driven,
        "by the ego": sum(crash.by_ego for crashes in avoidable for crash in crashes) / driven,
        "distinct": sum(len({(crash.route, crash.kind) for crash in crashes}) for crashes in avoidable) / driven,
        "blockers": sum(crash.blocked for crashes in avoidable for crash in crashes) / driven,
        "waited": sum(one.waited for one in found) / driven,
    }


def interval(of: dict[str, list[Found]], against: dict[str, list[Found]], what: str) -> tuple[float, float]:
    """95 % of how many times as many one has as another, drawing sentences anew: they are what varies most."""
    rng, texts = np.random.default_rng(0), sorted(of)
    ratios: list[float] = []
    for _ in range(2000):
        drawn = [texts[i] for i in rng.integers(len(texts), size=len(texts))]
        one, other = (row([found for text in drawn for found in by[text]])[what] for by in (of, against))
        ratios.append(one / other if other else np.inf)
    low, high = np.quantile(ratios, (0.025, 0.975), method="nearest")
    return float(low), float(high)


@click.command()
@click.option("--ego", default="idm", show_default=True)
@click.option("--generator", default="chatscene", show_default=True)
@click.option("--half", type=click.IntRange(0, 1), default=None, help="Of the sentences; both if none is named.")
@click.option("--sampler", "samplers", multiple=True, help="Repeat; all if none is named.")
@click.option("--scenes", default=50, show_default=True)
@click.option("--routes", default=3, show_default=True)
@click.option("--seeds", default=5, show_default=True)
@click.option("--physics", default="kinematic", show_default=True)
@click.option("--jobs", default=1, show_default=True)
def main(
    ego: str,
    generator: str,
    half: int | None,
    samplers: tuple[str, ...],
    scenes: int,
    routes: int,
    seeds: int,
    physics: str,
    jobs: int,
) -> None:
    texts = [text for base in BaseScenario for text in load_generator(generator).texts(base)]
    texts = texts if half is None else texts[half::2]
    searches = {"before: paper, collision": BEFORE}
    searches |= {name: SearchSettings(sampler=name) for name in samplers or SAMPLERS.built_in}
    results: dict[str, dict[str, list[Found]]] = {}
    print(
        "| search | crashes | avoidable | of these by the ego | **distinct avoidable** | times before "
        "| into blockers | waited |"
    )
    print("|---|---:|---:|---:|---:|---:|---:|---:|")
    for name, search in searches.items():
        tasks = [
            Task(text, replace(search, scenes=scenes, routes=routes, seed=seed))
            for text, seed in product(texts, range(seeds))
        ]
        found = results.setdefault(name, {text: [] for text in texts})
        for task, one in spread(Searcher, (generator, ego, physics), tasks, workers=Workers(jobs)):
            found[task.text].append(one)
        told, (first, *_) = row([one for every in found.values() for one in every]), results.values()
        base = row([one for every in first.values() for one in every])["distinct"]
        low, high = interval(found, first, "distinct")
        print(
            f"| {name} | {told['crashes']:.0f} | {told['avoidable']:.1f} | {told['by the ego']:.1f} | "
            f"{told['distinct']:.1f} | {told['distinct'] / base if base else np.inf:.1f} ({low:.1f} to {high:.1f}) | "
            f"{told['blockers']:.1f} | {told['waited']:.0f} |",
            flush=True,
        )
    print(
        f"\nPer 1,000 simulations, {generator}, {len(texts)} scenarios, {routes} routes, {seeds} seeds, against {ego}, "
        f"{physics}."
    )


if __name__ == "__main__":
    main()
