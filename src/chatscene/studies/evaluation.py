"""Step 8 of 9: egos on kept scenes, into a folder with the run's contract and the paper's tables.

The unit of work is one ego on the kept scenes of one scenario on one route; it is kept when it is done, as a block is
(in an evaluation the column `block` is the ego's place in the list), so an evaluation can be killed and continued. An
ego that fails is given up with its reason, and the others' results stand.
"""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import groupby
from operator import itemgetter
from pathlib import Path

from chatscene import runs
from chatscene.ego.policy import load_ego
from chatscene.errors import EgoError, RunError, SettingsError
from chatscene.maps.carried import CarriedMap
from chatscene.maps.network import name_of
from chatscene.measure.drive import Ran, drive_all
from chatscene.measure.score import average_displacement
from chatscene.measure.tables import (
    avoidability_table,
    diagnostic_table,
    ego_table,
    fault_table,
    generation_table,
)
from chatscene.report.egos import egos_in_words
from chatscene.report.evaluation import write_evaluation
from chatscene.report.summary import stepped_in_words
from chatscene.report.tables import write_tables
from chatscene.runs.digests import digest_of
from chatscene.runs.executor import ONE, Workers
from chatscene.runs.parallel import spread
from chatscene.runs.progress import Progress, silent
from chatscene.runs.rebuild import map_of, rebuild
from chatscene.runs.record import seen_from
from chatscene.runs.together import simulated_alike
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.working import working
from chatscene.search.climb import simulator_of
from chatscene.search.explore import Block
from chatscene.search.generator import load_generator
from chatscene.settings import EGO, Settings
from chatscene.simulate.simulator import Simulator, check_jobs
from chatscene.studies.one_map import OneMap
from chatscene.terms.metrics import Mode
from chatscene.terms.results import Displacement, Drive, ResultTable
from chatscene.terms.scenario import BaseScenario, Said
from chatscene.terms.scene import Rejected, Scene, ScenicProgram, at_speed

EGOS = ("sac", "ppo", "td3")  # the paper's
COMPARED = (EGO, "idm", "sac")  # where nobody is named: who drives in `run`, the simplest who sees, the paper's


@dataclass(frozen=True, slots=True, kw_only=True)
class Evaluated:
    """What an evaluation came to.

    Attributes:
        tables: By name; also written to ``tables/``.
    """

    folder: Path
    page: Path
    tables: dict[str, ResultTable]
    failures: dict[str, str]
    stepped: str
    seconds: float


@dataclass(frozen=True, slots=True, kw_only=True)
class _Task:
    """One ego on the kept scenes of one route of one source."""

    source: runs.SourceRecord
    ego: str
    number: int
    route: int


@dataclass(frozen=True, slots=True, kw_only=True)
class _Given:
    """A task with all that a worker needs for it, who may have no folder of ours."""

    task: _Task
    program: ScenicProgram
    said: Said
    scenes: tuple[Scene, ...]
    generator: str
    settings: Settings


def evaluate(
    sources: Sequence[Path],
    folder: Path,
    *,
    egos: Sequence[str] = EGOS,
    every_scene: bool = False,
    first_route: int = 0,
    simulator: str = "",
    physics: str = "",
    speed: float | None = None,
    workers: Workers = ONE,
    progress: Progress,
    repeated: Repeated | None = None,
) -> Evaluated:
    """Drive the kept scenes of runs with egos, into a new folder, or on in one where the same was cut.

    Raises:
        RunError: A source is not finished, its map is another by now, they were not simulated alike, or the folder is
            taken; or a source names what must be repeated (`chatscene.runs.trust.follow`).
        EgoError: An ego cannot be loaded.
        SettingsError: There is no ego, or one is named twice; or there is no such simulator.
    """
    if not egos or len(set(egos)) != len(egos):
        raise SettingsError(f"name each ego once, and at least one: {', '.join(egos) or 'none given'}")
    found = [runs.open_run(path) for path in runs.run_folders(sources)]
    repeated = repeated or Repeated()
    follow(repeated, simulators_of=() if simulator else found, joining_of=found)
    records = [runs.read_record(run) for run in found]
    for run, record in zip(found, records, strict=True):
        runs.require_done(run, record)
    simulation = simulated_alike(found, records, simulator=simulator, physics=physics)
    told = [
        _source(run, folder, record, first_route, kept_for="" if every_scene else record.ego)
        for run, record in zip(found, records, strict=True)
    ]
    for number, source in enumerate(told):
        if (twin := next((s for s in told[:number] if s.scenario_id == source.scenario_id), None)) is not None:
            raise RunError(
                f"{twin.path_from(folder)} and {source.path_from(folder)} hold scenes of one and the same sentence, "
                "which the tables cannot tell apart; evaluate them one by one"
            )
    settings = replace(runs.settings_of(records[0]), simulation=simulation)
    check_jobs(settings.simulation, workers.jobs)
    scenes = runs.Driven.EVERY if every_scene else runs.Driven.KEPT
    told = _as_before(folder, told)
    asked = runs.asked_evaluation(
        told,
        scenes=scenes,
        egos=egos,
        settings=settings,
        speed=speed,
        told_speeds=any(record.situation is not None for record in records),
    )
    with runs.alone(folder):
        kept = runs.take_up(folder, asked)
        return _carry_on(
            kept, workers, progress, replace(repeated, ego=tuple(egos), simulator=(settings.simulation.simulator,))
        )


def _as_before(folder: Path, told: list[runs.SourceRecord]) -> list[runs.SourceRecord]:
    """Sources by their absolute paths, if an evaluation of before is to be gone on with, which knew them by these."""
    try:
        record = runs.read_record(runs.Workspace(folder), runs.EvaluationRecord)
    except RunError:
        return told
    if not any(Path(source.folder).is_absolute() for source in record.sources):
        return told
    return [source.model_copy(update={"folder": str(source.path_from(folder))}) for source in told]


def _source(
    run: runs.Workspace, folder: Path, record: runs.RunRecord, first_route: int, *, kept_for: str
) -> runs.SourceRecord:
    scenario, _ = runs.read_choice(run)
    if scenario.base is None:
        raise RunError(f"the scenario of {run.path} belongs to none of the eight base scenarios that tables have")
    path = map_of(record)
    return runs.SourceRecord(
        folder=seen_from(folder, run.path),
        scenario_id=scenario.id,
        base=scenario.base,
        generator=record.generator,
        first_route=first_route,
        kept_for=kept_for,
        map_name=name_of(path),
        map_digest=digest_of(path),
    )


def resume(
    folder: Path, *, workers: Workers = ONE, progress: Progress = silent, repeated: Repeated | None = None
) -> Evaluated:
    """Go on with an evaluation that was killed or failed.

    Raises:
        RunError: It is damaged, or one of its sources is; another process is at work on it; or one of them names what
            must be repeated (`chatscene.runs.trust.follow`).
    """
    run = runs.open_run(folder, runs.EvaluationRecord)
    check_jobs(runs.settings_of(runs.read_record(run, runs.EvaluationRecord)).simulation, workers.jobs)
    with runs.alone(folder):
        return _carry_on(run, workers, progress, repeated or Repeated())


def _carry_on(run: runs.Workspace, workers: Workers, progress: Progress, repeated: Repeated) -> Evaluated:
    began = time.monotonic()
    record = runs.read_record(run, runs.EvaluationRecord)
    sources = [runs.Workspace(source.path_from(run.path)) for source in record.sources]
    follow(repeated, egos_of=[run], simulators_of=[run], joining_of=sources)
    failures = dict(record.failures)
    with working(run, progress) as tell:
        runs.resume(run, told=lambda said: tell(said, 0, 0))
        if runs.read_record(run, runs.Record).status is not runs.Status.DONE:
            tasks = _tasks(run, record)
            failures |= _drive_all(run, record, tasks, failures, workers, tell)
            every = [(t.source.scenario_id, t.route, t.number) for t in tasks if t.ego not in failures]
            runs.finish(run, selected=_fill_ins(run, record), expected=every)
        tell("computing the tables", 0, 0)
        tables = tabulate(run)
        write_tables(run.file("tables"), tables)
        runs.note(run, *run.file("tables").iterdir())
        page = write_evaluation(run)
    return Evaluated(
        folder=run.path,
        page=page,
        tables=tables,
        failures=failures,
        stepped=stepped_in_words(runs.read_record(run, runs.EvaluationRecord)),
        seconds=time.monotonic() - began,
    )


def _tasks(run: runs.Workspace, record: runs.EvaluationRecord) -> list[_Task]:
    """Every ego that did not fail on every route with scenes of every source."""
    for source in record.sources:
        runs.open_run(source.path_from(run.path))
    egos = [(number, ego) for number, ego in enumerate(record.egos) if ego not in record.failures]
    return [  # all egos on a route one after the other, since its program is compiled for it
        _Task(source=source, ego=ego, number=number, route=route)
        for source in record.sources
        for route in sorted({row for row, _ in _kept(run, source, record)})
        for number, ego in egos
    ]


def _drive_all(
    run: runs.Workspace,
    record: runs.EvaluationRecord,
    tasks: Sequence[_Task],
    failed: dict[str, str],
    workers: Workers,
    progress: Progress,
) -> dict[str, str]:
    """Run every task that is not done; the reasons of the egos that failed in it."""
    done = runs.done_blocks(run)
    left = [task for task in tasks if (task.source.scenario_id, task.route, task.number) not in done]
    maps = {task.source.map_name: CarriedMap.of(map_of(task.source)) for task in tasks}
    left.sort(key=lambda task: list(maps).index(task.source.map_name))
    failures: dict[str, str] = {}
    rows = [deque(of) for _, of in groupby(_given(run, left, record), key=lambda one: _place(one.task))]
    waiting = {_place(row[0].task): row for row in rows}

    def next_on_route(came: tuple[_Task, Block | str]) -> list[_Given]:
        """The next ego goes to who has the program; another worker would compile it once more."""
        row = waiting[_place(came[0])]
        return [row.popleft()] if row else []

    first = [row.popleft() for row in rows]
    came = spread(_Evaluator, maps, first, workers=workers, then=next_on_route)
    for count, (task, block) in enumerate(came, len(tasks) - len(left) + 1):
        if isinstance(block, Block):
            runs.write_block(run, block)
        elif task.ego not in failures:
            failures[task.ego] = block
            runs.update(run, failures={**failed, **failures})
        progress("driving, ego and route", count, len(tasks))
    for number, ego in enumerate(record.egos):
        if ego in failures or ego in failed:  # a kill may have come between the failure and this
            runs.drop_blocks(run, number)
    return failures


def _given(run: runs.Workspace, tasks: Sequence[_Task], record: runs.EvaluationRecord) -> list[_Given]:
    """Tasks with the programs of their sources, made again, and how these are run."""
    found: list[_Given] = []
    for source, of_source in groupby(tasks, key=lambda task: task.source):
        folder = runs.Workspace(source.path_from(run.path))
        made, retrieval = rebuild(folder), runs.settings_of(runs.read_record(folder)).retrieval
        kept = _kept(run, source, record)
        scenes = {
            route: tuple(runs.scene_of(row, made.program) for _, row in rows)
            for route, rows in groupby(sorted(kept, key=itemgetter(0)), key=itemgetter(0))
        }
        driven = made.program if record.speed is None else at_speed(made.program, record.speed / 3.6)
        simulation = runs.settings_of(record).simulation
        found += (
            _Given(
                task=task,
                program=driven,
                said=made.scenario.said,
                scenes=scenes[task.route],
                generator=made.generator,
                settings=Settings(simulation=simulation, retrieval=retrieval),
            )
            for task in of_source
        )
    return found


def _place(task: _Task) -> tuple[str, int]:
    """Which scenes a task drives: those of a source on a route."""
    return task.source.folder, task.route


def _kept(
    run: runs.Workspace, source: runs.SourceRecord, record: runs.EvaluationRecord
) -> list[tuple[int, dict[str, object]]]:
    """The rows of a source that are to be driven, each with its route."""
    every = record.scenes is runs.Driven.EVERY
    rows = runs.read_scenes(runs.Workspace(source.path_from(run.path)), selected=not every)
    return [
        (runs.route_index(row["route_id"]), row)
        for row in rows
        if (row["selected"] or (every and row["status"] == "ran"))
        and runs.route_index(row["route_id"]) >= source.first_route
    ]


def _fill_ins(run: runs.Workspace, record: runs.EvaluationRecord) -> dict[str, bool]:
    kept = (row for source in record.sources for _, row in _kept(run, source, record))
    return {str(row["scene_id"]): bool(row["fill_in"]) for row in kept}


class _Evaluator:
    """Does tasks in one process, and keeps what was compiled and loaded."""

    def __init__(self, maps: Mapping[str, CarriedMap]) -> None:
        self._maps = maps
        self._simulators = OneMap[Simulator]()
        self._failed: dict[str, str] = {}

    def __call__(self, given: _Given) -> tuple[_Task, Block | str]:
        """Drive; the reason if the ego failed, now or before."""
        task = given.task
        if task.ego in self._failed:
            return task, self._failed[task.ego]
        try:
            return task, self._block(given, self._simulator_of(given))
        except EgoError as error:
            self._failed[task.ego] = str(error)
            return task, str(error)

    def _simulator_of(self, given: _Given) -> Simulator:
        """Where a program is run, which is for its own generator to say; one for all that are alike."""
        name, generator = given.task.source.map_name, load_generator(given.generator)
        return self._simulators.on(
            name,
            (given.generator, given.settings),
            lambda: simulator_of(generator, self._maps[name].file(), given.settings),
        )

    def _block(self, given: _Given, simulator: Simulator) -> Block:
        task, ego = given.task, load_ego(given.task.ego)
        outcomes = drive_all(given.program, given.said, given.scenes, simulator=simulator, ego=ego)
        return Block(
            scenario_id=given.program.scenario_id,
            route=task.route,
            number=task.number,
            ranges=(),
            ran=tuple(outcome for outcome in outcomes if isinstance(outcome, Ran)),
            rejected=tuple(outcome for outcome in outcomes if isinstance(outcome, Rejected)),
        )


def tabulate(run: runs.Workspace) -> dict[str, ResultTable]:
    """The tables of a finished evaluation, by name."""
    drives = read_drives(run)
    displacements = read_displacements(run)
    tables: dict[str, ResultTable] = {}
    for mode in Mode:
        suffix = "" if mode is Mode.PAPER else f"-{mode}"
        tables[f"generation{suffix}"] = generation_table(drives, displacements, mode)
        tables[f"diagnostic{suffix}"] = diagnostic_table(drives, mode)
        tables[f"overall-score-by-ego{suffix}"] = ego_table(drives, mode, which="overall_score")
    tables["collision-rate-by-ego"] = ego_table(drives, Mode.PAPER, which="collision_rate")
    tables["avoidability"] = avoidability_table(drives)
    tables["fault"] = fault_table(drives)
    record = runs.read_record(run, runs.EvaluationRecord)
    told = [f"{ego}." for ego in egos_in_words(record)]
    if record.speed is not None:
        told.append(f"Where no speed was said, egos were to drive at {record.speed:g} km/h.")
    return {name: replace(table, notes=(*table.notes, *told)) for name, table in tables.items()}


def read_drives(run: runs.Workspace) -> list[Drive]:
    """Every drive of an evaluation that was not rejected."""
    record = runs.read_record(run, runs.EvaluationRecord)
    sources = {source.scenario_id: source for source in record.sources}
    drives: list[Drive] = []
    for row in runs.each_scene(run):
        source = sources[row["scenario_id"]]
        if row["status"] == "ran":
            drives.append(
                Drive(
                    generator=source.generator,
                    base_scenario=BaseScenario(source.base),
                    scenario_id=row["scenario_id"],
                    route=runs.route_index(row["route_id"]),
                    scene_id=row["scene_id"],
                    ego=record.egos[row["block"]],
                    measurements=runs.measurements_of(row),
                    fill_in=row["fill_in"],
                    avoidable=row["avoidable"],
                    fault=row["fault"],
                    by_selection=source.kept_for == record.egos[row["block"]],
                    map_name=source.map_name,
                )
            )
    return drives


def read_displacements(run: runs.Workspace) -> list[Displacement]:
    """The ADE of each scenario, route and ego of which at least two scenes were driven."""
    record = runs.read_record(run, runs.EvaluationRecord)
    sources = {source.scenario_id: source for source in record.sources}
    groups: dict[tuple[str, str, int], list[str]] = {}
    for row in runs.each_scene(run, ("scenario_id", "route_id", "block", "scene_id", "status")):
        if row["status"] == "ran":
            groups.setdefault((row["scenario_id"], row["route_id"], row["block"]), []).append(row["scene_id"])
    found: list[Displacement] = []
    for (scenario_id, route_id, number), scene_ids in sorted(groups.items()):
        source, route = sources[scenario_id], runs.route_index(route_id)
        tracks = runs.read_adversaries(run, scenario_id, route, number, scene_ids)
        if len(tracks) > 1:
            found.append(
                Displacement(
                    generator=source.generator,
                    base_scenario=BaseScenario(source.base),
                    scenario_id=scenario_id,
                    route=route,
                    ego=record.egos[number],
                    value=average_displacement(tracks),
                    map_name=source.map_name,
                )
            )
    return found
