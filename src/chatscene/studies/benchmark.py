"""The ChatScene benchmark: every base scenario, scenes by a generator against a surrogate ego, then other egos on them.

Paper: section 4.2. Eight base scenarios, five scenarios each, ten routes, fifty simulations with refinement, two kept
(20,000 simulations, 800 scenes), then measured with SAC, PPO and TD3.

A benchmark's folder holds a run folder per scenario under ``scenes/<base scenario>/<n>`` and the evaluation under
``evaluation``. It can be killed at any moment: what is there is not done again.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from pathlib import Path

from chatscene import runs
from chatscene.errors import MapError, SettingsError, no_such
from chatscene.runs.executor import ONE, Workers
from chatscene.runs.progress import Progress, silent
from chatscene.runs.searching import Search, search_all
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.working import going_on
from chatscene.search.generator import load_generator
from chatscene.search.generators.exploring import Exploring
from chatscene.settings import PAPER, SIMULATOR, SearchSettings, Settings, SimulationSettings
from chatscene.simulate.simulator import check_jobs
from chatscene.studies.evaluation import EGOS, Evaluated, evaluate
from chatscene.terms.scenario import BaseScenario


@dataclass(frozen=True, slots=True, kw_only=True)
class Budget:
    """How much a generator may try, and how much is kept: the same for all.

    Attributes:
        scenarios: Per base scenario; a generator that has fewer tries, and keeps, as much more with each.
        search: Scenes, blocks, routes and how many are kept, per scenario.
    """

    scenarios: int
    search: SearchSettings


REFERENCE = "reference"  # the budget that is each generator's own
BUDGETS: dict[str, Budget] = {
    "paper": Budget(scenarios=5, search=PAPER),
    "small": Budget(scenarios=2, search=replace(PAPER, scenes=20, routes=2)),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Benchmarked:
    """What a benchmark came to.

    Attributes:
        evaluated: The egos on the kept scenes, with the tables.
        refused: Scenarios that could not be searched with, and why, by text.
        counts: Scenes ran, collided, kept, fill-ins, rejected draws.
        seconds: Wall time by phase, over every call that worked on the folder.
    """

    folder: Path
    evaluated: Evaluated
    refused: dict[str, str]
    counts: dict[str, int]
    seconds: dict[str, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Task:
    """One scenario to search with."""

    folder: Path
    text: str


def benchmark(
    folder: Path,
    *,
    generator: str = "chatscene",
    budget: str = "small",
    egos: Sequence[str] = EGOS,
    surrogate: str = "sac",
    map_name: str = "town",
    seed: int = 0,
    sampler: str = PAPER.sampler,
    simulator: str = SIMULATOR,
    physics: str = SimulationSettings().physics,
    avoidable_only: bool = False,
    workers: Workers = ONE,
    progress: Progress,
) -> Benchmarked:
    """Run a benchmark, or go on with one that was cut.

    Raises:
        SettingsError: There is no such generator, simulator, physics or budget.
        RunError: The folder holds something else, or a benchmark with other settings.
        MapError: The map serves none of the scenarios.
    """
    _check_sampler(generator, sampler)
    scenarios, search = _share(generator, budget)
    settings = Settings(
        search=replace(search, seed=seed, avoidable_only=avoidable_only, sampler=sampler),
        simulation=SimulationSettings(simulator=simulator, physics=physics),
    )
    check_jobs(settings.simulation, workers.jobs)
    asked = runs.asked_benchmark(
        generator, budget, egos=egos, surrogate=surrogate, settings=settings, map_name=map_name
    )
    with going_on(folder, asked, progress, leaves=()) as (work, tell):
        tasks = _tasks(folder, generator, scenarios)
        began = time.monotonic()
        refused = _searched(asked, tasks, workers, tell)
        found = [task.folder for task in tasks if task.text not in refused]
        if not found:
            raise MapError(f"map {map_name!r} serves none of the scenarios; the first: {next(iter(refused.values()))}")
        counts = _counts(found)
        stepped, instead = _stepped(found)
        runs.update(
            work,
            refused=refused,
            counts=counts,
            stepped=stepped,
            instead=instead,
            timings={"search": time.monotonic() - began},
        )

        repeated = Repeated(generator=(generator,), simulator=(simulator,))
        evaluated = evaluate(found, folder / "evaluation", egos=egos, workers=workers, progress=tell, repeated=repeated)
        record = runs.update(work, timings={"evaluation": evaluated.seconds})
    return Benchmarked(folder=folder, evaluated=evaluated, refused=refused, counts=counts, seconds=record.timings)


def resume(
    folder: Path, *, workers: Workers = ONE, progress: Progress = silent, repeated: Repeated | None = None
) -> Benchmarked:
    """Go on with a benchmark that was killed or failed.

    Raises:
        RunError: There is none in the folder, or it names what must be repeated (`chatscene.runs.trust.follow`).
    """
    work = runs.open_run(folder, runs.BenchmarkRecord)
    follow(repeated or Repeated(), egos_of=[work], simulators_of=[work], reading_of=[work])
    record = runs.read_record(work, runs.BenchmarkRecord)
    settings = runs.settings_of(record)
    return benchmark(
        folder,
        generator=record.generator,
        budget=record.budget,
        egos=record.egos,
        surrogate=record.surrogate,
        map_name=record.map_name,
        seed=settings.search.seed,
        sampler=settings.search.sampler,
        simulator=settings.simulation.simulator,
        physics=settings.simulation.physics,
        avoidable_only=settings.search.avoidable_only,
        workers=workers,
        progress=progress,
    )


def _check_sampler(generator: str, sampler: str) -> None:
    """Refuse another sampler than the one that a generator always searches with, which would be ignored."""
    source = load_generator(generator)
    own = source.searching(replace(PAPER, sampler=sampler)).sampler if isinstance(source, Exploring) else sampler
    if own != sampler != PAPER.sampler:
        raise SettingsError(f"the generator {generator!r} searches with the sampler {own!r} alone; leave out --sampler")


def _share(generator: str, budget: str) -> tuple[int, SearchSettings]:
    """How many scenarios a generator has per base scenario within a budget, and how much it tries with each."""
    source = load_generator(generator)
    texts = max(len(source.texts(base)) for base in BaseScenario)
    if budget == REFERENCE:
        return texts, source.reference
    if budget not in BUDGETS:
        raise SettingsError(no_such("budget", budget, (*BUDGETS, REFERENCE)))
    whole = BUDGETS[budget]
    scenarios = min(max(texts, 1), whole.scenarios)
    scenes, keep = (whole.scenarios * number // scenarios for number in (whole.search.scenes, whole.search.keep))
    return scenarios, replace(whole.search, scenes=scenes, keep=keep)


def _tasks(folder: Path, generator: str, scenarios: int) -> list[_Task]:
    source = load_generator(generator)
    tasks = [
        _Task(folder=folder / "scenes" / base / str(number), text=text)
        for base in BaseScenario
        for number, text in enumerate(source.texts(base)[:scenarios])
    ]
    if not tasks:
        raise SettingsError(f"the generator {generator!r} has no texts for a benchmark; use chatscene")
    return tasks


def _counts(folders: Iterable[Path]) -> dict[str, int]:
    total: dict[str, int] = {}
    for folder in folders:
        for name, count in runs.read_record(runs.open_run(folder)).counts.items():
            total[name] = total.get(name, 0) + count
    return total


def _stepped(folders: Iterable[Path]) -> tuple[dict[str, int], dict[str, list[str]]]:
    """Who stepped the drives of all runs, and which scenes not the simulator that was asked for, by why."""
    stepped: dict[str, int] = {}
    instead: dict[str, list[str]] = {}
    for record in (runs.read_record(runs.open_run(folder)) for folder in folders):
        for name, count in record.stepped.items():
            stepped[name] = stepped.get(name, 0) + count
        for reason, scenes in record.instead.items():
            instead.setdefault(reason, []).extend(scenes)
    return stepped, instead


def _searched(
    asked: runs.BenchmarkRecord, tasks: Sequence[_Task], workers: Workers, progress: Progress
) -> dict[str, str]:
    """Search with every scenario, each into its run folder; those that cannot be searched with, and why."""
    refused: dict[str, str] = {}
    searches: dict[str, Search] = {}
    settings = runs.settings_of(asked)
    with ExitStack() as locks:
        for task in tasks:
            locks.enter_context(runs.alone(task.folder))
            of = runs.asked_run(
                task.text,
                settings=settings,
                map_name=asked.map_name,
                ego=asked.surrogate,
                generator=asked.generator,
            )
            run = runs.take_up(task.folder, of)
            if (record := runs.read_record(run)).status is runs.Status.REFUSED:
                refused[task.text] = record.reason
                continue
            done = runs.resume(run)
            if (record := runs.read_record(run)).status is not runs.Status.DONE:
                searches[task.text] = Search(record=record, run=run, settings=settings.search, done=done)
        over = len(tasks) - len(searches)
        since: dict[Path, float] = {}
        for one in search_all(list(searches.values()), workers=workers):
            began = since.setdefault(one.run.path, time.monotonic())
            if one.is_over:
                runs.update(one.run, timings={"total": time.monotonic() - began})
            progress("searching, scenarios", over + sum(one.is_over for one in searches.values()), len(tasks))
    return refused | {text: one.refused for text, one in searches.items() if one.refused}
