"""Egos on the programs of a folder that was imported: each drives every program, on that program's own map.

Nothing is searched: a program without parameters is one scene, of one with parameters a few are drawn from their
ranges, the same as `verify` draws. What came of a program is kept when all egos drove it, so that an evaluation that
was cut goes on with the next. Programs are a stranger's and run in the sandbox.
"""

from __future__ import annotations

import json
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from typing import Any

from chatscene import runs
from chatscene.ego.policy import EgoPolicy, in_words, load_ego, senses_of, wanting
from chatscene.errors import EgoError, MapError, ProgramError, RunError, SettingsError, StuckBehavior
from chatscene.imports.collection import CollectedProgram, Collection, read_collection
from chatscene.measure.drive import Ran, drive
from chatscene.program.sample import draw, scene_seed
from chatscene.report.collection import collection_page
from chatscene.report.evaluation import fared_of
from chatscene.report.tables import write_tables
from chatscene.runs.atomic import read_bytes, write_bytes, write_json, writing
from chatscene.runs.digests import digest_of
from chatscene.runs.executor import Workers
from chatscene.runs.parallel import spread
from chatscene.runs.progress import Progress
from chatscene.runs.tables import RAW
from chatscene.search.generators.foreign import read_foreign
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.terms.results import Cell, ResultTable
from chatscene.terms.scenario import Slots
from chatscene.terms.scene import Rejected, Scene, ScenicProgram, at_speed

SCENES = 10  # drawn of a program with parameters, as many as `verify` judges
_DRIVES = "drives.jsonl"
_ASKED = "asked"

Row = Mapping[str, Any]


@dataclass(frozen=True, slots=True, kw_only=True)
class Driving:
    """How programs are driven.

    Attributes:
        egos: Who drives: by name, file or ``package.module:factory``.
        scenes: How many scenes of a program with parameters.
        seed: What their values are drawn by.
        physics: How bodies answer; empty for the usual way.
        speed: What egos drive at [km/h] where the file does not say; None for what the programs have.
    """

    egos: tuple[str, ...]
    scenes: int = SCENES
    seed: int = 0
    physics: str = ""
    speed: float | None = None

    @property
    def simulation(self) -> SimulationSettings:
        """What they are simulated with."""
        return SimulationSettings(physics=self.physics) if self.physics else SimulationSettings()


@dataclass(frozen=True, slots=True, kw_only=True)
class Compared:
    """What an evaluation of a collection came to.

    Attributes:
        folder: Where it is.
        page: Its page, egos side by side.
        tables: By name; also written to ``tables/``.
        fared: A row for each ego, as that of an evaluation.
        failures: Why egos were given up, by ego.
        lost: Why programs were not driven, by their names.
        seconds: Wall time of this call.
    """

    folder: Path
    page: Path
    tables: dict[str, ResultTable]
    fared: list[dict[str, Any]]
    failures: dict[str, str]
    lost: dict[str, str]
    seconds: float


class Driver:
    """Drives programs, one after another, and keeps the simulator of a map as long as the programs lie on it."""

    def __init__(self, driving: Driving) -> None:
        self._driving = driving
        self._egos: dict[str, EgoPolicy] = {}
        self._failed: dict[str, str] = {}
        self._map: Path | None = None
        self._simulator: ConfinedSimulator | None = None

    def __call__(self, program: CollectedProgram) -> list[dict[str, Any]]:
        """A row for each drive, or one for a program that does not run."""
        try:
            found = self._program(program)
            simulator = self._simulator_on(program.map_path)
            simulator.route(found, 0)
            return [row for scene in self.scenes(found) for row in self._each(program, found, scene, simulator)]
        except (MapError, ProgramError, StuckBehavior) as error:
            return [{"program": program.name, "status": "failed", "reason": str(error).partition("\n")[0]}]

    def _program(self, program: CollectedProgram) -> ScenicProgram:
        found = read_foreign(program.path, searched_with=False).program
        return found if self._driving.speed is None else at_speed(found, self._driving.speed / 3.6)

    def scenes(self, program: ScenicProgram) -> Iterator[Scene]:
        """The scenes of a program."""
        for number in range(self._driving.scenes if program.parameters else 1):
            name = f"{program.scenario_id}/route-00/draw-{number:03d}"
            seed = scene_seed(self._driving.seed, name)
            values = draw(program.parameters, seed=seed)
            yield Scene(id=name, scenario_id=program.scenario_id, route=0, block=0, seed=seed, values=values)

    def _simulator_on(self, map_path: Path) -> ConfinedSimulator:
        if self._simulator is None or self._map != map_path:
            self.close()
            self._map, self._simulator = map_path, ConfinedSimulator(map_path, self._driving.simulation)
        return self._simulator

    def _each(
        self, program: CollectedProgram, found: ScenicProgram, scene: Scene, simulator: ConfinedSimulator
    ) -> Iterator[dict[str, Any]]:
        for name in self._driving.egos:
            row = {"program": program.name, "scene_id": scene.id, "values": dict(scene.values), "ego": name}
            if name not in self._failed:
                try:
                    if name not in self._egos:
                        self._egos[name] = load_ego(name)
                    outcome = drive(found, Slots(), scene, simulator=simulator, ego=self._egos[name])
                    yield row | (_ran(outcome) if isinstance(outcome, Ran) else _rejected(outcome))
                    continue
                except EgoError as error:
                    self._failed[name] = str(error)
            yield row | {"status": "ego failed", "reason": self._failed[name]}

    def close(self) -> None:
        """End the simulator's process."""
        if self._simulator is not None:
            self._simulator.close()
            self._simulator = None


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


def _rejected(outcome: Rejected) -> dict[str, Any]:
    return {"status": "rejected", "reason": outcome.reason}


def evaluate_collection(folder: Path, out: Path, driving: Driving, *, workers: Workers, progress: Progress) -> Compared:
    """Let egos drive every program of a folder that was imported, and write how they fared.

    Args:
        folder: What `chatscene.imports.import_folder` left.
        out: Where to; a new folder, or one in which the same was cut.
        driving: Who drives, and how.
        workers: Who simulates.
        progress: Told what is done.

    Raises:
        RunError: The collection is none, or was changed; or the folder holds something else.
        EgoError: An ego cannot be loaded.
        SettingsError: There is no ego, or one is named twice; or nothing was imported.
    """
    began = time.monotonic()
    egos = driving.egos
    if not egos or len(set(egos)) != len(egos):
        raise SettingsError(f"name each ego once, and at least one: {', '.join(egos) or 'none given'}")
    senses = {ego: senses_of(wanting(load_ego(ego), None)) for ego in egos}
    collection = read_collection(folder)
    if not collection.programs:
        raise SettingsError(f"of the files of {folder} none became a program; there is nothing to drive")
    with runs.alone(out):
        rows = _drive_all(collection, out, driving, workers, progress)
        return replace(_written(collection, out, egos, senses, rows), seconds=time.monotonic() - began)


def _drive_all(
    collection: Collection, out: Path, driving: Driving, workers: Workers, progress: Progress
) -> list[dict[str, Any]]:
    """Drive what is not driven yet; all rows, in the order of programs."""
    kept = _taken_up(collection, out, driving)
    left = [one for one in _by_map(collection.programs) if one.name not in kept]
    every = len(collection.programs)
    with writing(out / _DRIVES), (out / _DRIVES).open("a", encoding="utf-8") as stream:
        for done, own in enumerate(spread(Driver, driving, left, workers=workers), every - len(left) + 1):
            kept[own[0]["program"]] = own
            stream.write(json.dumps(own) + "\n")
            stream.flush()
            progress("driving, programs", done, every)
    return [row for one in collection.programs for row in kept[one.name]]


def _by_map(programs: Sequence[CollectedProgram]) -> list[CollectedProgram]:
    """Those of a map behind one another, so that it is read once."""
    return sorted(programs, key=lambda one: str(one.map_path))


def _taken_up(collection: Collection, out: Path, driving: Driving) -> dict[str, list[dict[str, Any]]]:
    """What was driven before the same evaluation was cut, by the name of the program.

    Raises:
        RunError: The folder holds something else.
    """
    where = out / _DRIVES
    digests = {one.name: digest_of(one.path) for one in collection.programs}
    asked = json.dumps({_ASKED: asdict(driving), "programs": digests}, sort_keys=True)
    if not where.is_file():
        if any(out.iterdir()):
            raise RunError(f"{out} holds something else; choose a new folder with --out")
        write_bytes(where, (asked + "\n").encode())
        return {}
    first, *lines = read_bytes(where).decode("utf-8", errors="replace").split("\n")
    if first != asked:
        raise RunError(f"{out} holds another evaluation; choose a new folder with --out")
    whole = lines[:-1]  # behind the last end of a line is what a kill cut off
    write_bytes(where, "".join(f"{line}\n" for line in (first, *whole)).encode())
    found = [json.loads(line) for line in whole]
    return {rows[0]["program"]: rows for rows in found}


def _written(
    collection: Collection, out: Path, egos: Sequence[str], senses: Mapping[str, Any], rows: Sequence[Row]
) -> Compared:
    """The folder's tables, page and JSON."""
    failures = {row["ego"]: row["reason"] for row in rows if row["status"] == "ego failed"}
    lost = {row["program"]: row["reason"] for row in rows if row["status"] in {"failed", "rejected"}}
    ran = [row for row in rows if row["status"] == "ran" and row["ego"] not in failures]
    own = {ego: [row for row in ran if row["ego"] == ego] for ego in egos}
    fared = [fared_of(ego, in_words(senses[ego]), drives) for ego, drives in own.items() if drives]
    tables = {"collisions": _collisions(collection, own)}
    write_tables(out / "tables", tables)
    write_json(out / "evaluation.json", {"imported": str(collection.folder), "egos": fared, "drives": list(rows)})
    page = out / "report.html"
    write_bytes(page, collection_page(collection, fared, own, lost, failures).encode())
    return Compared(folder=out, page=page, tables=tables, fared=fared, failures=failures, lost=lost, seconds=0.0)


def _collisions(collection: Collection, own: Mapping[str, Sequence[Row]]) -> ResultTable:
    """The share of each program's drives in which each ego collides."""

    def cell(ego: str, program: str) -> Cell:
        hits = [bool(row["collision"]) for row in own[ego] if row["program"] == program]
        return Cell(sum(hits) / len(hits) if hits else None)

    return ResultTable(
        title="Collision rate of each ego in each program that was imported",
        columns=tuple(own),
        rows=tuple((one.name, tuple(cell(ego, one.name) for ego in own)) for one in collection.programs),
        notes=(
            "The share of the drives of a program that end with a collision of the ego; one drive has no interval.",
        ),
    )
