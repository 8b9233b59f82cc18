"""Searches against each other on the same programs: hits, distinct failures, severity and avoidability by budget.

    python benchmarks/searches.py [--ego sac] [--seeds 3] [--routes 2] [--jobs 2]

Each search of each seed drives 200 scenes a route in blocks of ten; the smaller budgets are its first scenes. A cell
of failures divides every parameter's declared range into four; what counts is how many have a collision.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np

from chatscene import pipeline
from chatscene.ego.policy import load_ego
from chatscene.maps.network import resolve_map
from chatscene.runs.executor import Workers
from chatscene.runs.parallel import spread
from chatscene.search.explore import explore
from chatscene.search.sampler import SAMPLERS
from chatscene.settings import SearchSettings, SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.terms.snippet import ParameterRange

SCENARIOS = {
    "hidden pedestrian": "A pedestrian steps out from behind a bus stop on the right and freezes in front of us.",
    "cut-in": "A car in the left lane cuts in right in front of us and brakes.",
    "red light": "We drive straight across the junction and a car from the left runs the red light.",
}
BUDGETS = (50, 100, 200)
CELLS = 4  # per parameter


@dataclass(frozen=True)
class Task:
    """One search of every route."""

    scenario: str
    sampler: str
    seed: int
    routes: int


@dataclass(frozen=True)
class Found:
    """Per scene of one search, in order: whether it collided, its cell, its speed of impact, whether avoidable."""

    hits: np.ndarray
    cells: list[tuple[int, ...]]
    impacts: np.ndarray
    avoidable: np.ndarray


class Searcher:
    """Does tasks in one process."""

    def __init__(self, ego: str) -> None:
        self._simulator = load_simulator(resolve_map("town"), SimulationSettings())
        self._ego = load_ego(ego)

    def __call__(self, task: Task) -> tuple[Task, list[Found]]:
        """Search; what was found on each route."""
        understood = pipeline.understand(SCENARIOS[task.scenario])
        settings = SearchSettings(scenes=max(BUDGETS), block=10, sampler=task.sampler, seed=task.seed)
        found: list[Found] = []
        for route in range(task.routes):
            blocks = explore(
                understood.program,
                understood.scenario.slots,
                route,
                simulator=self._simulator,
                ego=self._ego,
                settings=settings,
            )
            ran = [ran for block in blocks for ran in block.ran]
            found.append(
                Found(
                    hits=np.array([r.episode.collision is not None for r in ran]),
                    cells=[cell(understood.program.parameters, r.scene.values) for r in ran],
                    impacts=np.array([r.criticality.impact_speed or 0.0 for r in ran]),
                    avoidable=np.array([bool(r.avoidable) for r in ran]),
                )
            )
        return task, found


def cell(declared: Sequence[ParameterRange], values: Mapping[str, float]) -> tuple[int, ...]:
    """In which quarter of each range the values lie."""
    shares = [(values[p.name] - p.low) / max(p.high - p.low, 1e-12) for p in declared]
    return tuple(min(int(CELLS * share), CELLS - 1) for share in shares)


def row(found: Sequence[Found], budget: int) -> tuple[float, ...]:
    """Hit rate, failing cells, mean and greatest speed of impact, avoidable share of the hits; means of all.

    The last three are means of the searches that hit anything, and 0 if none did.
    """
    values: list[tuple[float, ...]] = []
    for one in found:
        hits = one.hits[:budget]
        impacts = one.impacts[:budget][hits]
        distinct = len({c for c, hit in zip(one.cells[:budget], hits, strict=False) if hit})
        values.append(
            (
                float(hits.mean()),
                float(distinct),
                float(impacts.mean()) if hits.any() else np.nan,
                float(impacts.max()) if hits.any() else np.nan,
                float(one.avoidable[:budget][hits].mean()) if hits.any() else np.nan,
            )
        )
    found_any = np.array([value for value in values if value[0] > 0.0])
    rate, distinct = np.array(values)[:, :2].mean(axis=0).tolist()
    return (rate, distinct, *(found_any[:, 2:].mean(axis=0).tolist() if len(found_any) else [0.0] * 3))


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--ego", default="sac")
    parser.add_argument("--seeds", type=int, default=3)
    parser.add_argument("--routes", type=int, default=2)
    parser.add_argument("--jobs", type=int, default=1)
    given = parser.parse_args()
    tasks = [
        Task(scenario, sampler, seed, given.routes)
        for scenario, sampler, seed in product(SCENARIOS, SAMPLERS.built_in, range(given.seeds))
    ]
    results: dict[tuple[str, str], list[Found]] = {}
    for task, found in spread(Searcher, given.ego, tasks, workers=Workers(given.jobs)):
        results.setdefault((task.scenario, task.sampler), []).extend(found)
    for scenario, text in SCENARIOS.items():
        print(f"\n**{scenario}**: {text}\n")
        print("| sampler | " + " | ".join(f"{budget} scenes" for budget in BUDGETS) + " |")
        print("|---|" + "---|" * len(BUDGETS))
        for sampler in SAMPLERS.built_in:
            cells = [
                "{:.0%} / {:.1f} / {:.1f} / {:.1f} / {:.0%}".format(*row(results[scenario, sampler], budget))
                for budget in BUDGETS
            ]
            print(f"| {sampler} | " + " | ".join(cells) + " |")
    print("\nhits / distinct failing cells / mean impact [m/s] / greatest impact [m/s] / avoidable share of the hits")


if __name__ == "__main__":
    main()
