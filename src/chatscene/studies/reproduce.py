"""The paper's five tables, each from one command, with the paper's numbers below ours.

What is missing is run, what was cut is gone on with, what is there is not done again. A folder holds, per method, a
benchmark under ``generation/<method>``; for table 3 also, under ``finetuning/<preset>-<choice>``, a fine-tuning per
method and base scenario (``egos``), and per base scenario all of these egos on all methods' scenes (``tested``); and
``tables`` and ``figures``.
"""

from __future__ import annotations

import time
from collections.abc import Generator, Sequence
from contextlib import contextmanager
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from statistics import fmean

from chatscene import runs
from chatscene.errors import SettingsError, no_such
from chatscene.learn.finetune import PRESETS, FinetuneSettings, finetune
from chatscene.measure.score import score
from chatscene.measure.tables import avoidability_table, diagnostic_table, ego_table, generation_table
from chatscene.report.beside_paper import beside_paper
from chatscene.report.egos import egos_in_words
from chatscene.report.figures import two_curves
from chatscene.report.tables import write_tables
from chatscene.runs.executor import ONE, Workers
from chatscene.runs.parallel import spread
from chatscene.runs.progress import Progress, silent
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.working import going_on
from chatscene.settings import PHYSICS, SimulationSettings
from chatscene.studies.benchmark import benchmark
from chatscene.studies.evaluation import evaluate, read_displacements, read_drives
from chatscene.terms.metrics import Measurements, Mode
from chatscene.terms.results import Cell, Displacement, Drive, ResultTable
from chatscene.terms.scenario import BaseScenario

METHODS = ("learning-to-collide", "advsim", "carla-scenario-generator", "adversarial-trajectory", "chatscene")
TABLES = ("table1", "table2", "table3", "table4", "table5")
SURROGATE = "sac"
LEAVES = ("tables/*", "figures/*", "finetuning/*/figures/*")  # besides the folders in it
BEFORE = "before"  # the surrogate as it was, in table 3


@dataclass(frozen=True, slots=True, kw_only=True)
class Budget:
    """How much is spent on the tables."""

    benchmark: str
    finetune: FinetuneSettings
    bases: tuple[BaseScenario, ...] = tuple(BaseScenario)


_SHORT = FinetuneSettings(
    episodes=12, round=6, first_choice=6, train_routes=1, validation_routes=1, learning_starts=200,
    warm_up_steps=400, critic_steps=100, updates_per_step=0.1,
)  # fmt: skip
BUDGETS: dict[str, Budget] = {
    "paper": Budget(benchmark="paper", finetune=FinetuneSettings()),
    "reference": Budget(benchmark="reference", finetune=FinetuneSettings()),
    "small": Budget(benchmark="small", finetune=_SHORT, bases=(BaseScenario.STRAIGHT_OBSTACLE,)),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Reproduced:
    """What a reproduction came to.

    Attributes:
        seconds: Wall time by part, over every call that worked on the folder.
    """

    folder: Path
    tables: dict[str, ResultTable]
    seconds: dict[str, float]


@dataclass(frozen=True, slots=True, kw_only=True)
class _Common:
    """What all tables of a folder have in common."""

    budget: str
    avoidable_only: bool
    physics: str
    seed: int


@dataclass(frozen=True, slots=True)
class _Lessons:
    """The fine-tunings of a table 3."""

    folder: Path
    where: Path
    bases: tuple[BaseScenario, ...]
    settings: FinetuneSettings

    def scenes(self, method: str, base: BaseScenario) -> Path:
        """The scenes of a method."""
        return self.folder / "generation" / method / "scenes" / base

    def ego(self, method: str, base: BaseScenario) -> Path:
        """The folder of the ego that learned from them."""
        return self.where / "egos" / method / base


def reproduce(
    folder: Path,
    tables: Sequence[str] = TABLES,
    *,
    budget: str = "small",
    avoidable_only: bool = False,
    physics: str = SimulationSettings().physics,
    preset: str = "released",
    choice: str = "paper",
    seed: int = 0,
    workers: Workers = ONE,
    progress: Progress,
) -> Reproduced:
    """Make tables of the paper.

    Args:
        folder: Where to; a new one, or one to go on in.
        tables: Which, of `TABLES`.
        budget: One of `BUDGETS`.
        avoidable_only: Keep no collision that a careful driver would not have avoided.
        physics: How bodies answer, in every drive.
        preset: How often a fine-tuning learns, of `chatscene.learn.finetune.PRESETS`.
        choice: Who chooses its checkpoint.
        seed: Of everything.
        workers: Who works; an ego is fine-tuned in its folder, by a process of this machine.
        progress: Told what is done.

    Raises:
        SettingsError: There is no such table, budget or physics.
        RunError: The folder holds something else.
        MissingExtra: A package is missing that a method or the fine-tuning needs.
    """
    for name in tables:
        if name not in TABLES:
            raise SettingsError(no_such("table", name, TABLES))
    if budget not in BUDGETS:
        raise SettingsError(no_such("budget", budget, BUDGETS))
    if physics not in PHYSICS:
        raise SettingsError(no_such("physics", physics, PHYSICS))
    if preset not in PRESETS:
        raise SettingsError(no_such("preset", preset, PRESETS))
    chosen = BUDGETS[budget]
    settings = replace(chosen.finetune, **PRESETS[preset], ego=SURROGATE, choice=choice, seed=seed)
    common = _Common(budget=budget, avoidable_only=avoidable_only, physics=physics, seed=seed)
    asked = runs.ReproductionRecord(
        settings=asdict(common),
        tables=list(tables),
        preset=preset,
        choice=choice,
    )
    with going_on(folder, asked, progress, leaves=LEAVES) as (work, tell):
        done = _made(work, chosen, tables, settings, f"{preset}-{choice}", common, workers, tell)
        write_tables(folder / "tables", done)
    return Reproduced(folder=folder, tables=done, seconds=runs.read_record(work, runs.ReproductionRecord).timings)


def _made(
    work: runs.Workspace,
    budget: Budget,
    tables: Sequence[str],
    settings: FinetuneSettings,
    taught: str,
    common: _Common,
    workers: Workers,
    progress: Progress,
) -> dict[str, ResultTable]:
    """The tables, each with the paper's rows; what they need is made first."""
    drives: list[Drive] = []
    displacements: list[Displacement] = []
    seen: tuple[str, ...] = ()
    for method in METHODS:
        with _timed(work, f"generation, {method}"):
            done = benchmark(
                work.file("generation") / method,
                generator=method,
                budget=budget.benchmark,
                surrogate=SURROGATE,
                physics=common.physics,
                avoidable_only=common.avoidable_only,
                seed=common.seed,
                workers=workers,
                progress=lambda what, count, total, method=method: progress(f"{method}: {what}", count, total),
            )
        run = runs.open_run(done.evaluated.folder)
        drives += read_drives(run)
        displacements += read_displacements(run)
        record = runs.read_record(run, runs.EvaluationRecord)
        seen = tuple(f"{ego}." for ego in egos_in_words(record))  # the same egos each time
    found = {
        "table1": generation_table(drives, displacements, Mode.PAPER),
        "table2": diagnostic_table(drives, Mode.PAPER),
        "table4": ego_table(drives, Mode.PAPER, which="collision_rate"),
        "table5": ego_table(drives, Mode.PAPER, which="overall_score"),
    }
    if "table3" in tables:
        lessons = _Lessons(work.path, work.file("finetuning") / taught, budget.bases, settings)
        found["table3"] = _finetuned(lessons, work, workers, progress)
    progress("drawing the search", 0, 0)
    curves = {method: _searched(work.file("generation") / method / "scenes") for method in METHODS}
    x = "share of the simulations"
    two_curves(work.file("figures") / "search.svg", curves, x=x, second="overall score")
    made = {name: beside_paper(found[name], name) for name in TABLES if name in tables}
    made["avoidability"] = avoidability_table(drives)
    return {name: replace(table, notes=(*table.notes, *seen)) for name, table in made.items()}


@contextmanager
def _timed(work: runs.Workspace, part: str) -> Generator[None]:
    """Write down what a part takes."""
    began = time.monotonic()
    yield
    runs.update(work, timings={part: time.monotonic() - began})


def resume(
    folder: Path, *, workers: Workers = ONE, progress: Progress = silent, repeated: Repeated | None = None
) -> Reproduced:
    """Go on with a reproduction that was killed or failed.

    Raises:
        RunError: There is none in the folder.
    """
    work = runs.open_run(folder, runs.ReproductionRecord)
    follow(repeated or Repeated(), egos_of=[work])
    record = runs.read_record(work, runs.ReproductionRecord)
    return reproduce(
        folder,
        record.tables,
        preset=record.preset,
        choice=record.choice,
        **asdict(runs.settings_from(_Common, record.settings)),
        workers=workers,
        progress=progress,
    )


def _searched(scenes: Path) -> list[tuple[float, float, float]]:
    """Over the blocks of a search: the share of simulations done, collision rate and overall score of the block."""
    blocks: dict[int, dict[str, list[Measurements]]] = {}
    for run in map(runs.open_run, runs.run_folders([scenes])):
        base = run.path.parent.name
        for row in runs.each_scene(run):
            if row["status"] == "ran":
                blocks.setdefault(row["block"], {}).setdefault(base, []).append(runs.measurements_of(row))
    curve: list[tuple[float, float, float]] = []
    for number, by_base in sorted(blocks.items()):
        scores = [score(measured) for measured in by_base.values()]
        curve.append(
            (
                (number + 1) / len(blocks),
                fmean(each.collision_rate for each in scores),
                fmean(each.overall_score for each in scores),
            )
        )
    return curve


# Table 3


def _finetuned(lessons: _Lessons, work: runs.Workspace, workers: Workers, progress: Progress) -> ResultTable:
    """The surrogate, and what it became on each method's scenes of the training routes, on all methods' others."""
    tasks = [(method, base) for base in lessons.bases for method in METHODS]
    with _timed(work, f"fine-tuning, {lessons.where.name}"):
        for count, _ in enumerate(spread(_Tutor, lessons, tasks, workers=workers.here()), 1):
            progress("fine-tuning", count, len(tasks))
    curves = {method: _learned([lessons.ego(method, base) for base in lessons.bases]) for method in METHODS}
    two_curves(lessons.where / "figures" / "finetuning.svg", curves, x="episodes", second="completion")
    with _timed(work, f"testing, {lessons.where.name}"):
        drives = [drive for base in lessons.bases for drive in _tested(lessons, base, workers, progress)]
    collided = ego_table(drives, Mode.PAPER, which="collision_rate")
    scored = ego_table(drives, Mode.PAPER, which="overall_score")
    completed = ego_table(drives, Mode.PAPER, which="completion")
    return replace(
        collided,
        title="Fine-tuned egos on the scenes of all methods, on the routes that they did not train on",
        rows=(
            *_named("CR", collided.rows),
            *_named("OS", scored.rows),
            *_named("Comp", completed.rows),
        ),
        notes=(
            *collided.notes,
            f"{BEFORE}: {SURROGATE} before fine-tuning; the others: fine-tuned on the scenes of that method.",
            "A cell is one training. Its interval is over the test routes alone: how another training would come out,"
            " which moves single cells far more, is not in it, so where rows are close their order is noise.",
        ),
    )


class _Tutor:
    """Fine-tunes one ego after another."""

    def __init__(self, lessons: _Lessons) -> None:
        self._lessons = lessons

    def __call__(self, task: tuple[str, BaseScenario]) -> Path:
        scenes, ego = self._lessons.scenes(*task), self._lessons.ego(*task)
        return finetune(ego, [scenes], self._lessons.settings, progress=silent).folder


def _learned(egos: Sequence[Path]) -> list[tuple[float, float, float]]:
    """Over the checkpoints of a method: episodes, collision rate and completion where they are chosen; means of all."""
    checkpoints: dict[float, list[dict[str, float]]] = {}
    for ego in egos:
        for row in runs.read_record(runs.Workspace(ego), runs.FinetuningRecord).curve:
            if "collision_rate" in row:
                checkpoints.setdefault(float(row["episode"]), []).append(row)
    return [
        (episodes, fmean(row["collision_rate"] for row in rows), fmean(row["completion"] for row in rows))
        for episodes, rows in sorted(checkpoints.items())
    ]


def _named(what: str, rows: Sequence[tuple[str, tuple[Cell, ...]]]) -> list[tuple[str, tuple[Cell, ...]]]:
    return [(f"{what}, {label.partition(',')[0]}", cells) for label, cells in rows]


def _tested(lessons: _Lessons, base: BaseScenario, workers: Workers, progress: Progress) -> list[Drive]:
    """The egos of a base scenario on all methods' scenes, on the routes that none of them trained on."""
    egos = {SURROGATE: BEFORE} | {str(lessons.ego(method, base) / "policy.npz"): method for method in METHODS}
    where = lessons.where / "tested" / base
    sources = [lessons.scenes(method, base) for method in METHODS]
    first = lessons.settings.train_routes
    done = evaluate(sources, where, egos=list(egos), first_route=first, workers=workers, progress=progress)
    run = runs.open_run(done.folder)
    return [replace(d, ego=egos[d.ego], generator="all") for d in read_drives(run)]
