"""The paper's five tables, each from one command, with the paper's numbers below ours.

What is missing is run, what was cut is gone on with, what is there is not done again. A folder holds, per method, a
benchmark under ``generation/<method>``; for table 3 also a fine-tuning per method and base scenario under
``finetune/<method>/<base scenario>`` and, per base scenario, all of these egos on all methods' scenes under
``tested/<base scenario>``; and the tables under ``tables``.
"""

from __future__ import annotations

import time
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from chatscene import runs
from chatscene.benchmark import benchmark
from chatscene.errors import SettingsError, no_such
from chatscene.evaluate.tables import avoidability_table, diagnostic_table, ego_table, generation_table
from chatscene.evaluation import carry_on, evaluate, read_displacements, read_drives
from chatscene.finetune import PRESETS, FinetuneSettings, finetune
from chatscene.pipeline import Progress
from chatscene.report.beside_paper import beside_paper
from chatscene.report.tables import write_tables
from chatscene.runs.atomic import read_json, write_json
from chatscene.terms.metrics import Mode
from chatscene.terms.results import Displacement, Drive, ResultTable
from chatscene.terms.scenario import BaseScenario
from chatscene.workers import spread

METHODS = ("learning-to-collide", "advsim", "carla-scenario-generator", "adversarial-trajectory", "chatscene")
TABLES = ("table1", "table2", "table3", "table4", "table5")
SURROGATE = "sac"
BEFORE = "before"  # the surrogate as it was, in table 3


@dataclass(frozen=True, slots=True, kw_only=True)
class Budget:
    """How much is spent on the tables.

    Attributes:
        benchmark: A budget of `chatscene.benchmark`, for every method.
        finetune: Every fine-tuning of table 3.
        bases: The base scenarios of table 3.
    """

    benchmark: str
    finetune: FinetuneSettings
    bases: tuple[BaseScenario, ...] = tuple(BaseScenario)


_SHORT = FinetuneSettings(
    episodes=12, round=6, first_choice=6, train_routes=1, validation_routes=1, learning_starts=200,
    warm_up_steps=400, critic_steps=100, updates_per_step=0.1,
)  # fmt: skip
BUDGETS: dict[str, Budget] = {
    "paper": Budget(benchmark="paper", finetune=FinetuneSettings(**PRESETS["released"])),
    "reference": Budget(benchmark="reference", finetune=FinetuneSettings(**PRESETS["released"])),
    "small": Budget(benchmark="small", finetune=_SHORT, bases=(BaseScenario.STRAIGHT_OBSTACLE,)),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Reproduced:
    """What a reproduction came to.

    Attributes:
        folder: Where everything is.
        tables: By name, with the paper's rows.
        seconds: Wall time by part, over every call that worked on the folder.
    """

    folder: Path
    tables: dict[str, ResultTable]
    seconds: dict[str, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Lesson:
    """One fine-tuning."""

    folder: Path
    source: Path


def reproduce(
    folder: Path,
    tables: Sequence[str] = TABLES,
    *,
    budget: str = "small",
    avoidable_only: bool = False,
    seed: int = 0,
    jobs: int = 1,
    progress: Progress,
) -> Reproduced:
    """Make tables of the paper.

    Args:
        folder: Where to; a new one, or one to go on in.
        tables: Which, of `TABLES`.
        budget: One of `BUDGETS`.
        avoidable_only: Keep no collision that a careful driver would not have avoided.
        seed: Of everything.
        jobs: Processes; any number gives the same.
        progress: Told what is done.

    Raises:
        SettingsError: There is no such table or budget.
        RunError: The folder holds something else.
        MissingExtra: A package is missing that a method or the fine-tuning needs.
    """
    for name in tables:
        if name not in TABLES:
            raise SettingsError(no_such("table", name, TABLES))
    if budget not in BUDGETS:
        raise SettingsError(no_such("budget", budget, BUDGETS))
    chosen, clock = BUDGETS[budget], _Clock(folder / "reproduce.json")
    drives: list[Drive] = []
    displacements: list[Displacement] = []
    for method in METHODS:
        began = time.monotonic()
        done = benchmark(
            folder / "generation" / method,
            generator=method,
            budget=chosen.benchmark,
            surrogate=SURROGATE,
            avoidable_only=avoidable_only,
            seed=seed,
            jobs=jobs,
            progress=lambda what, count, total, method=method: progress(f"{method}: {what}", count, total),
        )
        clock.spent(f"generation, {method}", began)
        run = runs.open_run(done.evaluated.folder)
        drives += read_drives(run, runs.read_record(run))
        displacements += read_displacements(run, runs.read_record(run))
    found = {
        "table1": generation_table(drives, displacements, Mode.PAPER),
        "table2": diagnostic_table(drives, Mode.PAPER),
        "table4": ego_table(drives, Mode.PAPER, which="collision_rate"),
        "table5": ego_table(drives, Mode.PAPER, which="overall_score"),
    }
    if "table3" in tables:
        found["table3"] = _finetuned(folder, chosen, seed, jobs, clock, progress)
    made = {name: beside_paper(found[name], name) for name in TABLES if name in tables}
    made["avoidability"] = avoidability_table(drives)
    write_tables(folder / "tables", made)
    return Reproduced(folder=folder, tables=made, seconds=clock.seconds)


class _Clock:
    """Wall times by part, kept in a file, added up over calls."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self.seconds: dict[str, float] = read_json(path)["seconds"] if path.is_file() else {}

    def spent(self, part: str, began: float) -> None:
        """Add what has passed since `began`."""
        self.seconds[part] = round(self.seconds.get(part, 0.0) + time.monotonic() - began, 1)
        write_json(self._path, {"seconds": self.seconds})


# Table 3


def _finetuned(folder: Path, budget: Budget, seed: int, jobs: int, clock: _Clock, progress: Progress) -> ResultTable:
    """The surrogate, and what it became on each method's scenes of the training routes, on all methods' others."""
    settings = replace(budget.finetune, ego=SURROGATE, seed=seed)
    began = time.monotonic()
    lessons = [
        _Lesson(folder=folder / "finetune" / method / base, source=folder / "generation" / method / "scenes" / base)
        for base in budget.bases
        for method in METHODS
    ]
    for count, _ in enumerate(spread(_Tutor, settings, lessons, jobs=jobs), 1):
        progress("fine-tuning", count, len(lessons))
    clock.spent("fine-tuning", began)
    began = time.monotonic()
    drives: list[Drive] = []
    for base in budget.bases:
        drives += _tested(folder, base, settings.train_routes, jobs, progress)
    clock.spent("testing the fine-tuned", began)
    collided, scored = (ego_table(drives, Mode.PAPER, which=which) for which in ("collision_rate", "overall_score"))
    return replace(
        collided,
        title="Fine-tuned egos on the scenes of all methods on the routes that they did not train on",
        rows=(*_named("CR", collided), *_named("OS", scored)),
        notes=(
            *collided.notes,
            f"{BEFORE}: {SURROGATE} before fine-tuning; others: fine-tuned on the scenes of that method.",
        ),
    )


def _named(what: str, table: ResultTable) -> list[tuple[str, tuple[object, ...]]]:
    return [(f"{what}, {label.partition(',')[0]}", cells) for label, cells in table.rows]


class _Tutor:
    """Fine-tunes one ego after another."""

    def __init__(self, settings: FinetuneSettings) -> None:
        self._settings = settings

    def __call__(self, lesson: _Lesson) -> Path:
        return finetune(lesson.folder, [lesson.source], self._settings, progress=_silent).folder


def _silent(_what: str, _done: int, _total: int) -> None:
    pass


def _tested(folder: Path, base: BaseScenario, train_routes: int, jobs: int, progress: Progress) -> list[Drive]:
    """The egos of a base scenario on all methods' scenes, on the routes that none of them trained on."""
    egos = {SURROGATE: BEFORE} | {str(folder / "finetune" / m / base / "policy.npz"): m for m in METHODS}
    where = folder / "tested" / base
    if (where / "run.json").exists():
        done = carry_on(runs.open_run(where), jobs=jobs, progress=progress)
    else:
        sources = [folder / "generation" / method / "scenes" / base for method in METHODS]
        done = evaluate(sources, where, egos=list(egos), jobs=jobs, progress=progress)
    run = runs.open_run(done.folder)
    drives = read_drives(run, runs.read_record(run))
    return [replace(d, ego=egos[d.ego], generator="all") for d in drives if d.route >= train_routes]
