"""The ChatScene benchmark: every base scenario, scenes by a generator against a surrogate ego, then other egos on them.

Paper: section 4.2. Eight base scenarios, five scenarios each, ten routes, fifty simulations with refinement, two kept
(20,000 simulations, 800 scenes), then measured with SAC, PPO and TD3.

A benchmark's folder holds a run folder per scenario under ``scenes/<base scenario>/<n>``, the evaluation under
``evaluation``, and says in ``benchmark.json`` what it is. It can be killed at any moment: what is there is not done
again.
"""

from __future__ import annotations

import time
from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from chatscene import runs
from chatscene.ego.policy import load_ego, senses_of
from chatscene.errors import ChatSceneError, MapError, MeansSomethingElse, NothingFits, RunError, SettingsError, no_such
from chatscene.maps.network import resolve_map
from chatscene.pipeline import search
from chatscene.runs.atomic import read_json, write_json, writing
from chatscene.runs.parallel import spread
from chatscene.runs.progress import Progress, silent
from chatscene.runs.trust import Repeated, follow
from chatscene.search.generator import load_generator, simulator_of
from chatscene.search.sampler import load_sampler
from chatscene.settings import SearchSettings, Settings, SimulationSettings
from chatscene.simulate.simulator import load_simulator
from chatscene.studies.evaluation import EGOS, Evaluated, carry_on, evaluate
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
    "paper": Budget(scenarios=5, search=SearchSettings(scenes=50, block=10, keep=2, routes=10, selection="worst")),
    "small": Budget(scenarios=2, search=SearchSettings(scenes=20, block=10, keep=2, routes=2, selection="worst")),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Benchmarked:
    """What a benchmark came to.

    Attributes:
        folder: Where it is.
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


@dataclass(frozen=True, slots=True, kw_only=True)
class _Setup:
    """What every process of a benchmark needs to know."""

    generator: str
    settings: Settings
    map_name: str
    surrogate: str


def benchmark(
    folder: Path,
    *,
    generator: str = "chatscene",
    budget: str = "small",
    egos: Sequence[str] = EGOS,
    surrogate: str = "sac",
    map_name: str = "town",
    seed: int = 0,
    sampler: str = "paper",
    simulator: str = SimulationSettings().simulator,
    avoidable_only: bool = False,
    jobs: int = 1,
    progress: Progress,
) -> Benchmarked:
    """Run a benchmark, or go on with one that was cut.

    Raises:
        SettingsError: There is no such generator, simulator or budget.
        RunError: The folder holds something else, or a benchmark with other settings.
        MapError: The map serves none of the scenarios.
    """
    load_sampler(sampler)
    scenarios, search = _share(generator, budget)
    settings = Settings(
        search=replace(search, seed=seed, avoidable_only=avoidable_only, sampler=sampler),
        simulation=SimulationSettings(simulator=simulator),
    )
    load_simulator(resolve_map(map_name), settings.simulation)
    setup = _Setup(generator=generator, settings=settings, map_name=map_name, surrogate=surrogate)
    with runs.alone(folder):
        record = _open(folder, {"generator": generator, "budget": budget, "egos": list(egos), **asdict(setup)})
        tasks = _tasks(folder, generator, scenarios)

        began = time.monotonic()
        refused: dict[str, str] = {}
        for count, (task, reason) in enumerate(spread(_Searcher, setup, tasks, jobs=jobs), 1):
            if reason:
                refused[task.text] = reason
            progress("searching, scenarios", count, len(tasks))
        found = [task.folder for task in tasks if task.text not in refused]
        if not found:
            raise MapError(f"map {map_name!r} serves none of the scenarios; the first: {next(iter(refused.values()))}")
        record |= {"refused": refused, "counts": _counts(found)}
        record = _spent(folder, record, "search", time.monotonic() - began)

        where = folder / "evaluation"
        if (where / "run.json").exists():
            repeated = Repeated(ego=tuple(egos), generator=(generator,), simulator=(simulator,))
            evaluated = carry_on(runs.open_run(where), jobs=jobs, progress=progress, repeated=repeated)
        else:
            repeated = Repeated(generator=(generator,), simulator=(simulator,))
            evaluated = evaluate(found, where, egos=egos, jobs=jobs, progress=progress, repeated=repeated)
        record = _spent(folder, record, "evaluation", evaluated.seconds)
        return Benchmarked(
            folder=folder, evaluated=evaluated, refused=refused, counts=record["counts"], seconds=record["seconds"]
        )


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


def _spent(folder: Path, record: dict[str, Any], phase: str, seconds: float) -> dict[str, Any]:
    """The record with a phase's wall time added, also on disk."""
    before: dict[str, float] = record.get("seconds", {})
    added = record | {"seconds": before | {phase: round(before.get(phase, 0.0) + seconds, 1)}}
    write_json(folder / "benchmark.json", added)
    return added


def _open(folder: Path, settings: dict[str, Any]) -> dict[str, Any]:
    """The record of a benchmark, new or taken up again."""
    path = folder / "benchmark.json"
    if path.is_file():
        record = read_json(path)
        if {name: record.get(name) for name in settings} != settings:
            raise RunError(f"{folder} holds a benchmark with other settings; choose another folder with --out")
        return record
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
        if any(folder.iterdir()):
            raise RunError(f"{folder} is not empty and holds no benchmark; choose another folder with --out")
    write_json(path, settings)
    return settings


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


class _Searcher:
    """Searches with one scenario after another."""

    def __init__(self, setup: _Setup) -> None:
        self._setup = setup

    def __call__(self, task: _Task) -> tuple[_Task, str]:
        """Search; the reason if the scenario cannot be searched with."""
        with runs.alone(task.folder):
            return self._search(task)

    def _search(self, task: _Task) -> tuple[_Task, str]:
        setup = self._setup
        if (task.folder / "run.json").exists():
            run = runs.open_run(task.folder)
            named = Repeated(
                ego=(setup.surrogate,),
                generator=(setup.generator,),
                sampler=(setup.settings.search.sampler,),
                simulator=(setup.settings.simulation.simulator,),
            )
            follow(named, egos_of=[run], simulators_of=[run], reading_of=[run])
        else:
            map_path = resolve_map(setup.map_name)
            simulator = simulator_of(load_generator(setup.generator), map_path, setup.settings)
            run = runs.create(
                task.folder,
                text=task.text,
                settings=setup.settings,
                map_name=setup.map_name,
                map_path=map_path,
                ego=setup.surrogate,
                generator=setup.generator,
                senses={setup.surrogate: senses_of(load_ego(setup.surrogate))},
                simulator=simulator.identity,
            )
        record = runs.read_record(run)
        if record.status is runs.Status.REFUSED:
            return task, record.reason
        try:
            search(run, 1, silent)
        except (NothingFits, MeansSomethingElse, MapError) as error:
            runs.update(run, status=runs.Status.REFUSED, reason=str(error))
            return task, str(error)
        except ChatSceneError as error:
            runs.update(run, status=runs.Status.FAILED, reason=str(error))
            raise
        return task, ""
