"""Whose scenes carry over: every generator searched against every ego, and every ego on what was kept.

    python benchmarks/transfer.py --out runs/transfer [--seeds 5] [--seed 0 …] [--jobs 2] [--tables]

A cell is a generator, the ego that it searches against and a seed: 800 simulations over the eight base scenarios in
the native simulator, forty pairs of a scenario and a route, 20 simulations and two kept scenes each. ChatScene has five
sentences a base scenario, and `random-triple` five draws, on one route each; the other baselines have one scenario, on
five routes. `by-others` is ChatScene with sentences by four other writers, of `texts/by-base.jsonl` the first five of
each base scenario that are served. All egos then drive what was kept. A cell that is done is not done again, so
processes may share the folder, a seed each; `--tables` alone reads it.

Of each generator, over all pairs of two different egos (what an ego does on scenes kept for it says how well they were
searched): how often the ego collides with the adversary, how often in a crash that a careful driver would have
avoided, and how often it does not arrive unhurt. Intervals resample scenarios within base scenarios and the routes
within them; a sentence's seeds, surrogates and egos stay together, and base scenarios stay as they are. Differences
from ChatScene are tested by the same draws, and the p-values of an endpoint corrected after Holm.

And the frontier: of all kept scenes those that avoidably hit at least so many of the egos other than the one that is
tested, how often they hit that one, and how much of it is avoidable; over all drives. Intervals resample
the pairs of a scenario and a route within base scenarios, those of which nothing is left among them.
"""

from __future__ import annotations

import json
from collections import defaultdict
from dataclasses import dataclass, replace
from functools import cache
from itertools import product
from pathlib import Path
from statistics import fmean

import click
import numpy as np

from chatscene import pipeline, runs
from chatscene.errors import ChatSceneError
from chatscene.runs.executor import Workers
from chatscene.runs.progress import silent
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import PAPER, RetrievalSettings
from chatscene.studies.benchmark import BUDGETS, Budget, benchmark
from chatscene.terms.criticality import Fault
from chatscene.terms.scenario import BaseScenario, Scenario

EGOS = ("sac", "ppo", "td3", "idm", "planner")
OURS = "chatscene"
BY_OTHERS = "by-others"
GENERATORS = (
    OURS, "learning-to-collide", "advsim", "carla-scenario-generator", "adversarial-trajectory", "random-triple",
    BY_OTHERS,
)  # fmt: skip
FIVE = (OURS, "random-triple", BY_OTHERS)  # that have five scenarios a base scenario
TEXTS = Path(__file__).with_name("texts") / "by-base.jsonl"
FORTY = {  # pairs of a scenario and a route
    "five sentences": Budget(scenarios=5, search=replace(PAPER, scenes=20, routes=1)),
    "five routes": Budget(scenarios=1, search=replace(PAPER, scenes=20, routes=5)),
}
ADVERSARY = (Fault.ADVERSARY_INTO_EGO, Fault.EGO_INTO_ADVERSARY)
BLIND = ("sac", "ppo", "td3")  # egos that see four numbers
ENDPOINTS = ("hits the adversary", "avoidably", "does not arrive unhurt")
DRAWS = 10_000


class ByOthers(Retrieved):
    """ChatScene with sentences by others."""

    def texts(self, base: BaseScenario) -> tuple[str, ...]:
        """The first five that are served."""
        return served()[base]

    def read(self, text: str, settings: RetrievalSettings) -> Scenario:
        """As ever, of the base scenario that it was written for, whatever it reads like."""
        base = next((base for base, texts in served().items() if text in texts), None)
        return replace(super().read(text, settings), base=base)


@cache
def served() -> dict[BaseScenario, tuple[str, ...]]:
    """Of the sentences by others the first five of each base scenario that the library serves."""
    found: dict[BaseScenario, list[str]] = {base: [] for base in BaseScenario}
    for line in TEXTS.read_text().splitlines():
        row = json.loads(line)
        some = found[BaseScenario(row["base"])]
        if len(some) < FORTY["five sentences"].scenarios:
            try:
                pipeline.understand(row["text"])
            except ChatSceneError:
                continue
            some.append(row["text"])
    return {base: tuple(some) for base, some in found.items()}


@dataclass(frozen=True)
class Drive:
    """What an ego made of a kept scene: the endpoints, and where it belongs."""

    generator: str
    surrogate: str
    seed: int
    ego: str
    base: str
    scenario: str
    route: str
    scene: str
    came: tuple[bool, bool, bool]


@click.command()
@click.option("--out", type=click.Path(path_type=Path), required=True)
@click.option("--seeds", default=5, show_default=True)
@click.option("--seed", "only", type=int, multiple=True, help="Only these.")
@click.option("--generator", "generators", multiple=True, default=GENERATORS)
@click.option("--surrogate", "surrogates", multiple=True, default=EGOS)
@click.option("--jobs", default=1, show_default=True)
@click.option("--tables", is_flag=True, help="Only read what is there.")
def main(
    out: Path,
    seeds: int,
    only: tuple[int, ...],
    generators: tuple[str, ...],
    surrogates: tuple[str, ...],
    jobs: int,
    tables: bool,
) -> None:
    BUDGETS.update(FORTY)
    drives: list[Drive] = []
    for seed in only or range(seeds):
        for surrogate in surrogates:
            for generator in generators:
                folder = out / f"{generator}-{surrogate}-{seed}"
                if not tables:
                    benchmark(
                        folder,
                        generator="transfer:ByOthers" if generator == BY_OTHERS else generator,
                        budget="five sentences" if generator in FIVE else "five routes",
                        egos=EGOS,
                        surrogate=surrogate,
                        seed=seed,
                        simulator="native",
                        workers=Workers(jobs),
                        progress=silent,
                    )
                    print(folder.name, flush=True)
                drives += _drives(folder, generator, surrogate, seed)
    _print_matrix(drives, generators, surrogates)
    _print_transfer([one for one in drives if one.ego != one.surrogate], generators)
    _print_frontier(drives, generators)


def _drives(folder: Path, generator: str, surrogate: str, seed: int) -> list[Drive]:
    evaluation = runs.Workspace(folder / "evaluation")
    record = runs.read_record(evaluation, runs.EvaluationRecord)
    bases = {source.scenario_id: source.base for source in record.sources}
    found: list[Drive] = []
    for row in runs.read_scenes(evaluation):
        if row["status"] == "ran":
            hit = bool(row["collision"]) and row["fault"] in ADVERSARY
            arrived = row["ending"] == "arrived" and not row["collision"]
            found.append(
                Drive(
                    generator=generator,
                    surrogate=surrogate,
                    seed=seed,
                    ego=record.egos[row["block"]],
                    base=bases[row["scenario_id"]],
                    scenario=row["scenario_id"],
                    route=row["route_id"],
                    scene=row["scene_id"],
                    came=(hit, hit and row["avoidable"] is True, not arrived),
                )
            )
    return found


def _print_matrix(drives: list[Drive], generators: tuple[str, ...], surrogates: tuple[str, ...]) -> None:
    """A table for each endpoint: generators and surrogates down, egos across; means over base scenarios."""
    cells: dict[tuple[str, str, str], dict[str, list[tuple[bool, ...]]]] = defaultdict(lambda: defaultdict(list))
    for one in drives:
        cells[one.generator, one.surrogate, one.ego][one.base].append(one.came)
    for number, endpoint in enumerate(ENDPOINTS):
        print(f"\n{endpoint}\n| generator | searched against | {' | '.join(EGOS)} |")
        for generator in generators:
            for surrogate in surrogates:
                shares = [_share(cells[generator, surrogate, ego], number) for ego in EGOS]
                told = [f"*{s:.2f}*" if ego == surrogate else f"{s:.2f}" for ego, s in zip(EGOS, shares, strict=True)]
                print(f"| {generator} | {surrogate} | {' | '.join(told)} |")


def _share(by_base: dict[str, list[tuple[bool, ...]]], number: int) -> float:
    return fmean(fmean(came[number] for came in of_base) for of_base in by_base.values())


def _print_transfer(drives: list[Drive], generators: tuple[str, ...]) -> None:
    """Each generator over all pairs of two egos, with intervals, and how it differs from ChatScene."""
    rng = np.random.default_rng(0)
    drawn = {g: _resampled([one for one in drives if one.generator == g], rng) for g in generators}
    for number, endpoint in enumerate(ENDPOINTS):
        print(f"\n{endpoint}: pairs of two egos\n| generator | share | 95 % | minus {OURS} | 95 % | p, Holm |")
        others = [g for g in generators if g != OURS]
        apart = {g: drawn[g][1:, number] - drawn[OURS][1:, number] for g in others if OURS in drawn}
        p = _holm({g: min(1.0, 2 * min(np.mean(d <= 0), np.mean(d >= 0)) + 1 / DRAWS) for g, d in apart.items()})
        for g in generators:
            row = f"| {g} | {drawn[g][0, number]:.3f} | {_interval(drawn[g][1:, number])} |"
            if g in apart:
                difference = drawn[g][0, number] - drawn[OURS][0, number]
                row += f" {difference:+.3f} | {_interval(apart[g])} | {p[g]:.4f} |"
            print(row)
    avoidable = {g: _ratio(drawn[g]) for g in generators}
    print("\nof collisions with the adversary, avoidable\n| generator | share | 95 % |")
    for g, (share, interval) in avoidable.items():
        print(f"| {g} | {share:.3f} | {interval} |")


def _print_frontier(drives: list[Drive], generators: tuple[str, ...]) -> None:
    """What is left of the kept scenes if they must avoidably hit so many other egos, and what it does to an ego."""
    hit_by_scene: dict[tuple[str, str, int, str], set[str]] = defaultdict(set)
    for one in drives:
        if one.came[1]:
            hit_by_scene[one.generator, one.surrogate, one.seed, one.scene].add(one.ego)
    print(
        f"\nthe frontier\n| ego | others | generator | pairs | drives | hit | 95 % | minus {OURS} "
        f"| of these avoidable | 95 % | minus {OURS} |"
    )
    for egos, least in product((BLIND, *((ego,) for ego in EGOS[3:])), range(len(EGOS))):
        ours = None
        for generator in generators:
            counts: dict[tuple[str, str, str], np.ndarray] = {}  # drives, hits, avoidable ones of scenarios on routes
            for one in drives:
                if one.generator == generator and one.ego in egos and one.ego != one.surrogate:
                    count = counts.setdefault((one.base, one.scenario, one.route), np.zeros(3))
                    others = hit_by_scene[generator, one.surrogate, one.seed, one.scene] - {one.ego}
                    if len(others) >= least:
                        count += (1, *one.came[:2])
            n, hits, avoidable = sum(counts.values(), np.zeros(3))
            if not hits:
                continue
            drawn = _drawn_anew(counts)
            with np.errstate(invalid="ignore"):
                shares = drawn[:, 1] / drawn[:, 0], drawn[:, 2] / drawn[:, 1]
            ours = shares if generator == OURS else ours
            told = f"| {', '.join(egos)} | {least} | {generator} | {sum(c[0] > 0 for c in counts.values())} | {n:.0f} "
            for share, of, others in zip((hits / n, avoidable / hits), shares, ours or (None, None), strict=True):
                apart = "" if others is None or generator == OURS else _interval(of - others)
                told += f"| {share:.3f} | {_interval(of)} | {apart} "
            print(f"{told}|")


def _drawn_anew(counts: dict[tuple[str, str, str], np.ndarray]) -> np.ndarray:
    """(DRAWS, counts) Scenarios on routes drawn anew within base scenarios, also those of which none is left."""
    rng = np.random.default_rng(0)
    by_base: dict[str, list[np.ndarray]] = defaultdict(list)
    for (base, *_), count in sorted(counts.items()):
        by_base[base].append(count)
    total = np.zeros((DRAWS, 3))
    for some in by_base.values():
        total += np.array(some)[rng.integers(len(some), size=(DRAWS, len(some)))].sum(axis=1)
    return total


def _ratio(drawn: np.ndarray) -> tuple[float, str]:
    shares = drawn[:, 1] / drawn[:, 0]
    return float(shares[0]), _interval(shares[1:])


def _resampled(drives: list[Drive], rng: np.random.Generator) -> np.ndarray:
    """(1 + DRAWS, endpoints) The shares as they are, and of resampled scenarios and routes; means over bases."""
    by_base: dict[str, dict[str, dict[str, list[tuple[bool, ...]]]]] = defaultdict(
        lambda: defaultdict(lambda: defaultdict(list))
    )
    for one in drives:
        by_base[one.base][one.scenario][one.route].append(one.came)
    total = np.zeros((1 + DRAWS, len(ENDPOINTS)))
    for scenarios in by_base.values():
        means = [np.array([np.mean(came, axis=0) for came in routes.values()]) for routes in scenarios.values()]
        whole = np.concatenate(means).mean(axis=0)
        total[0] += whole / len(by_base)
        for draw in range(1, 1 + DRAWS):
            chosen = [means[i] for i in rng.integers(len(means), size=len(means))]
            routes = [routes[rng.integers(len(routes), size=len(routes))].mean(axis=0) for routes in chosen]
            total[draw] += np.mean(routes, axis=0) / len(by_base)
    return total


def _interval(values: np.ndarray) -> str:
    low, high = np.nanquantile(values, (0.025, 0.975))
    return f"{low:.3f} to {high:.3f}"


def _holm(p: dict[str, float]) -> dict[str, float]:
    """P-values of a family, corrected after Holm: each at least as great as those below it."""
    found: dict[str, float] = {}
    least = 0.0
    for rank, (name, value) in enumerate(sorted(p.items(), key=lambda one: one[1])):
        least = max(least, min(1.0, value * (len(p) - rank)))
        found[name] = least
    return found


if __name__ == "__main__":
    main()
