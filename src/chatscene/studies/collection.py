"""Egos on the programs of a folder that was imported: each drives every program, on that program's own map.

Nothing is searched: a program without parameters is one scene, of one with parameters a few are drawn from their
ranges, the same as `verify` draws. What came of a program is kept when all egos drove it, so that an evaluation that
was cut goes on with the next (`resume`). Programs are a stranger's and run in the sandbox.
"""

from __future__ import annotations

import hashlib
import json
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass, replace
from functools import cache, partial
from itertools import groupby
from pathlib import Path
from typing import Any

from chatscene import runs
from chatscene.ego.asking import wanting
from chatscene.ego.policy import EgoPolicy, in_words, load_ego, senses_of
from chatscene.errors import (
    ChatSceneError,
    EgoError,
    ForeignCodeRefused,
    MapError,
    ProgramError,
    ProgramStopped,
    RunError,
    SettingsError,
    StuckBehavior,
)
from chatscene.imports.collection import CollectedProgram, Collection, read_collection
from chatscene.measure.drive import Ran, drive
from chatscene.program.sample import drawn_scene
from chatscene.report.collection import Drives, Row, collection_page
from chatscene.report.evaluation import fared_of
from chatscene.report.tables import write_tables
from chatscene.runs.atomic import json_of, read_bytes, write_bytes, write_json, writing
from chatscene.runs.digests import DRAWN, digest_of
from chatscene.runs.executor import ONE, Workers
from chatscene.runs.parallel import spread
from chatscene.runs.progress import Progress, silent
from chatscene.runs.record import path_from, seen_from
from chatscene.runs.tables import RAW
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.working import going_on
from chatscene.search.generators.foreign import read_foreign
from chatscene.settings import DRAWS, EGO, SimulationSettings
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.simulate.simulator import fails_in_its_scene
from chatscene.studies.one_map import OneMap
from chatscene.terms.results import Cell, ResultTable
from chatscene.terms.scenario import Slots
from chatscene.terms.scene import Scene, ScenicProgram, at_speed

AS_TOLD = "as-written"
"""What the file's own ego is called, where it drives."""
_DRIVES = "drives.jsonl"
_RESULT = "evaluation.json"
_OF_A_PROGRAM = (MapError, ProgramError, StuckBehavior, ProgramStopped)


@dataclass(frozen=True, slots=True, kw_only=True)
class Driving:
    """How programs are driven.

    Attributes:
        egos: Who drives: by name, file or ``package.module:factory``.
        as_written: Whether each is driven as its file says, too.
        scenes: How many scenes of a program with parameters.
        physics: How bodies answer; empty for the usual way.
        speed: What egos drive at [km/h] where the file does not say; None for what the programs have.
    """

    egos: tuple[str, ...]
    as_written: bool = False
    scenes: int = DRAWS
    seed: int = 0
    physics: str = ""
    speed: float | None = None

    @property
    def every(self) -> tuple[str, ...]:
        """Who drives, the file's own ego last."""
        return (*self.egos, *((AS_TOLD,) if self.as_written else ()))

    @property
    def simulation(self) -> SimulationSettings:
        """What they are simulated with."""
        return SimulationSettings(physics=self.physics) if self.physics else SimulationSettings()


@dataclass(frozen=True, slots=True, kw_only=True)
class Compared:
    """What an evaluation of a collection came to.

    Attributes:
        tables: By name; also written to ``tables/``.
        fared: A row for each ego, as that of an evaluation.
        lost: Why programs were not driven at all, by their names.
        partly: Of those that were, how many drives were not made, and why.
    """

    folder: Path
    page: Path
    tables: dict[str, ResultTable]
    fared: list[dict[str, Any]]
    failures: dict[str, str]
    lost: dict[str, str]
    partly: dict[str, str]
    seconds: float


class Driver:
    """Drives programs, one after another."""

    def __init__(self, driving: Driving) -> None:
        self._driving = driving
        self._egos: dict[str, EgoPolicy] = {}
        self._given_up: dict[str, str] = {}
        self._simulators = OneMap[ConfinedSimulator]()

    def __call__(self, program: CollectedProgram) -> list[dict[str, Any]]:
        """A row for each drive, or one for a program that does not run; a drive that fails leaves the others."""
        try:
            found = self._program(program)
            simulator = self._simulator_on(program.map_path)
            if not found.drawn:
                simulator.route(found, 0)
        except _OF_A_PROGRAM as error:
            return [{"program": program.name, **_failed(error)}]
        told = cache(partial(self._told, program))  # read once; what refuses it does so for each drive
        scenes = [drawn_scene(found, n, seed=self._driving.seed) for n in range(self._scenes(found))]
        rows, stopped = list[dict[str, Any]](), dict[str, Any]()
        for scene in scenes:
            for ego in self._driving.every:
                row = {"program": program.name, "scene_id": scene.id, "values": dict(scene.values), "ego": ego}
                try:
                    driven = told() if ego == AS_TOLD else found
                    rows.append(row | (stopped or self._drive(driven, scene, ego, simulator)))
                except ForeignCodeRefused as error:
                    rows.append(row | _failed(error))
                except _OF_A_PROGRAM as error:
                    failed = _failed(error)
                    stopped = {} if fails_in_its_scene(error) else failed
                    rows.append(row | failed)
        return rows

    def _scenes(self, program: ScenicProgram) -> int:
        return self._driving.scenes if program.parameters else 1

    def _program(self, program: CollectedProgram) -> ScenicProgram:
        found = read_foreign(program.path, searched_with=False).program
        return found if self._driving.speed is None else at_speed(found, self._driving.speed / 3.6)

    def _told(self, program: CollectedProgram) -> ScenicProgram:
        """A program whose own ego drives as its file says."""
        return read_foreign(program.path, searched_with=False, as_written=True).program

    def _simulator_on(self, map_path: Path) -> ConfinedSimulator:
        return self._simulators.on(map_path, (), lambda: ConfinedSimulator(map_path, self._driving.simulation))

    def _drive(self, program: ScenicProgram, scene: Scene, ego: str, simulator: ConfinedSimulator) -> dict[str, Any]:
        if ego not in self._given_up:
            try:
                if ego not in self._egos:
                    self._egos[ego] = load_ego(EGO if ego == AS_TOLD else ego)
                outcome = drive(program, Slots(), scene, simulator=simulator, ego=self._egos[ego])
                return _ran(outcome) if isinstance(outcome, Ran) else {"status": "rejected", "reason": outcome.reason}
            except EgoError as error:
                self._given_up[ego] = str(error)
        return {"status": "ego failed", "reason": self._given_up[ego]}

    def close(self) -> None:
        """End the simulator's process."""
        self._simulators.close()


def _ran(outcome: Ran) -> dict[str, Any]:
    crash = outcome.episode.collision
    return {
        "status": "ran",
        "collision": crash is not None,
        "other": crash.other if crash else None,
        "impact_speed": outcome.criticality.impact_speed,
        "fault": outcome.fault,
        "avoidable": outcome.avoidable,
        "crash_type": outcome.crash_type,
        "ending": outcome.episode.ending,
        "seconds": round(outcome.episode.duration, 3),
        "distance": outcome.criticality.distance,
        "unplayed": list(outcome.unplayed),
        **{RAW + name: value for name, value in asdict(outcome.measurements).items()},
    }


def _failed(error: ChatSceneError) -> dict[str, Any]:
    return {"status": "failed", "reason": str(error).partition("\n")[0]}


def evaluate_collection(folder: Path, out: Path, driving: Driving, *, workers: Workers, progress: Progress) -> Compared:
    """Let egos drive every program of a folder that was imported, and write how they fared.

    Raises:
        RunError: The collection is none, or was changed; or the folder holds something else.
        EgoError: An ego cannot be loaded.
        SettingsError: There is no ego, or one is named twice; or nothing was imported.
    """
    began = time.monotonic()
    egos = driving.every
    if not egos or len(set(egos)) != len(egos):
        raise SettingsError(f"name each ego once, and at least one: {', '.join(egos) or 'none given'}")
    collection = read_collection(folder)
    if not collection.programs:
        raise SettingsError(f"of the files of {folder} none became a program; there is nothing to drive")
    asked = _asked(collection, out, driving)
    with going_on(out, asked, progress, leaves=(_DRIVES, _RESULT, *DRAWN)) as (work, tell):
        rows = _drive_all(collection, work, driving, workers, tell)
        compared = _written(collection, work, asked, rows)
    return replace(compared, seconds=time.monotonic() - began)


def resume(
    folder: Path, *, workers: Workers = ONE, progress: Progress = silent, repeated: Repeated | None = None
) -> Compared:
    """Go on with an evaluation of an imported folder that was killed or failed.

    Raises:
        RunError: There is none in the folder; what it drives was changed since; or it names what must be repeated
            (`chatscene.runs.trust.follow`).
    """
    work = runs.open_run(folder, runs.ComparisonRecord)
    follow(repeated or Repeated(), egos_of=[work])
    record = runs.read_record(work, runs.ComparisonRecord)
    imported = path_from(folder, record.imported)
    driving = runs.settings_from(Driving, {**record.settings, "egos": tuple(record.egos)})
    now = _asked(read_collection(imported), folder, driving)
    if (record.programs, record.maps) != (now.programs, now.maps):
        raise RunError(
            f"{imported} is not what {folder} was begun with: a program or a map was changed, added or removed; put "
            "it back, or evaluate it into another folder"
        )
    return evaluate_collection(imported, folder, driving, workers=workers, progress=progress)


def _asked(collection: Collection, out: Path, driving: Driving) -> runs.ComparisonRecord:
    """What is asked for, as `run.json` has it."""
    maps = {one.map_path: one.name for one in reversed(collection.programs)}
    return runs.ComparisonRecord(
        imported=seen_from(out, collection.folder),
        programs={one.name: digest_of(one.path) for one in collection.programs},
        maps={name: digest_of(path) for path, name in sorted(maps.items(), key=lambda one: one[1])},
        egos=list(driving.egos),
        ego_digests=runs.ego_digests(driving.egos),
        senses={ego: senses_of(wanting(load_ego(ego), None)) for ego in driving.egos},
        settings={name: value for name, value in asdict(driving).items() if name != "egos"},
    )


def _drive_all(
    collection: Collection, work: runs.Workspace, driving: Driving, workers: Workers, progress: Progress
) -> list[dict[str, Any]]:
    """Drive what is not driven yet; all rows, in the order of programs."""
    where = work.file(_DRIVES)
    kept = _kept(where, {one.name for one in collection.programs})
    left = [one for one in _by_map(collection.programs) if one.name not in kept]
    every = len(collection.programs)
    with writing(where), where.open("a", encoding="utf-8") as stream:
        for done, own in enumerate(spread(Driver, driving, left, workers=workers), every - len(left) + 1):
            kept[own[0]["program"]] = own
            stream.write(_line(own))
            stream.flush()
            progress("driving, programs", done, every)
    return [row for one in collection.programs for row in kept[one.name]]


def _by_map(programs: Sequence[CollectedProgram]) -> list[CollectedProgram]:
    """Those of a map behind one another, so that it is read once."""
    return sorted(programs, key=lambda one: str(one.map_path))


def _line(rows: Sequence[Row]) -> str:
    """What is kept of a program when all egos drove it, with a digest by which damage is seen."""
    return json.dumps({"digest": _digest(rows), "drives": rows}) + "\n"


def _digest(rows: object) -> str:
    return hashlib.sha256(json.dumps(rows).encode()).hexdigest()


def _kept(where: Path, programs: set[str]) -> dict[str, list[dict[str, Any]]]:
    """What was driven before the same evaluation was cut, by the name of the program."""
    if not where.is_file():
        return {}
    *whole, cut = read_bytes(where).decode("utf-8", errors="replace").split("\n")
    if cut:  # behind the last end of a line is what a kill cut off
        write_bytes(where, "".join(f"{line}\n" for line in whole).encode())
    found = dict[str, list[dict[str, Any]]]()
    for number, line in enumerate(whole, 1):
        told = json_of(where, line.encode())
        rows = told.get("drives") or [{"program": ""}]
        if told.get("digest") != _digest(rows) or rows[0]["program"] not in programs:
            raise RunError(f"{where}, line {number}, is not what was written; evaluate into another folder")
        found[rows[0]["program"]] = rows
    return found


def _written(
    collection: Collection, work: runs.Workspace, asked: runs.ComparisonRecord, rows: Sequence[Row]
) -> Compared:
    """The folder's tables, page and JSON."""
    failures = {row["ego"]: row["reason"] for row in rows if row["status"] == "ego failed"}
    every_ego = (*asked.egos, *((AS_TOLD,) if asked.settings.get("as_written") else ()))
    egos = [ego for ego in every_ego if ego not in failures]
    drives: Drives = {ego: {} for ego in egos}
    for row in rows:
        if row["status"] == "ran" and row["ego"] in drives:
            drives[row["ego"]].setdefault(row["program"], []).append(row)
    every = {ego: [row for own in by_program.values() for row in own] for ego, by_program in drives.items()}
    senses = {**{ego: in_words(asked.senses[ego]) for ego in asked.egos}, AS_TOLD: "nothing: it does as is written"}
    fared = [fared_of(ego, senses[ego], every[ego]) for ego in egos if every[ego]]
    lost, partly = _not_driven(rows)
    tables = {"collisions": _collisions(collection, drives)}
    write_tables(work.file("tables"), tables)
    write_json(work.file(_RESULT), {"imported": asked.imported, "egos": fared, "drives": list(rows)})
    page = work.file("report.html")
    write_bytes(page, collection_page(collection, fared, drives, lost, partly, failures).encode())
    runs.update(work, failures=failures)
    return Compared(
        folder=work.path,
        page=page,
        tables=tables,
        fared=fared,
        failures=failures,
        lost=lost,
        partly=partly,
        seconds=0.0,
    )


def _not_driven(rows: Sequence[Row]) -> tuple[dict[str, str], dict[str, str]]:
    """Programs of which no drive was made, and why; and those of which some were not, with how many."""
    lost, partly = dict[str, str](), dict[str, str]()
    tried = [row for row in rows if row["status"] != "ego failed"]
    for program, own in groupby(tried, key=lambda row: row["program"]):  # they stand together
        drives = list(own)
        why = Counter(row["reason"] for row in drives if row["status"] != "ran")
        told = "; ".join(why if len(why) == 1 else (f"{many} times, {reason}" for reason, many in why.items()))
        if why.total() == len(drives):
            lost[program] = told
        elif why:
            partly[program] = f"{why.total()} of {len(drives)} drives: {told}"
    return lost, partly


def _collisions(collection: Collection, drives: Drives) -> ResultTable:
    """The share of each program's drives in which each ego collides."""

    def cell(ego: str, program: str) -> Cell:
        hits = [bool(row["collision"]) for row in drives[ego].get(program, ())]
        return Cell(sum(hits) / len(hits) if hits else None)

    return ResultTable(
        title="Collision rate of each ego in each program that was imported",
        columns=tuple(drives),
        rows=tuple((one.name, tuple(cell(ego, one.name) for ego in drives)) for one in collection.programs),
        notes=(
            "The share of the drives of a program that end with a collision of the ego; one drive has no interval.",
        ),
    )
