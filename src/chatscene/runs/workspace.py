"""The run folder: create it, open it, say how far it came, keep what is not a table."""

from __future__ import annotations

import platform
import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import Annotated, Any
from urllib.parse import quote, unquote

from pydantic import BaseModel, Field, ValidationError

from chatscene.ego.policy import FILES
from chatscene.errors import RunError
from chatscene.runs.atomic import (
    is_leftover,
    json_of,
    read_bytes,
    read_json,
    sweep,
    write_bytes,
    write_json,
    writing,
)
from chatscene.runs.digests import damage, digest_of, is_drawn, is_sealed, write_sealed
from chatscene.runs.record import (
    DIGESTS_SINCE,
    SCHEMA_VERSION,
    RunRecord,
    SimulatorRecord,
    SourceRecord,
    Status,
    egos_of,
    first_problem,
    settings_to_json,
)
from chatscene.settings import Settings
from chatscene.terms.simulator import SimulatorIdentity

FARTHEST = 1e6  # [m] from the map's origin: no road is longer, and what draws must end
_Metres = Annotated[float, Field(ge=-FARTHEST, le=FARTHEST)]
_Points = Annotated[list[tuple[_Metres, _Metres]], Field(min_length=2)]
_Areas = list[Annotated[list[_Points], Field(min_length=1)]]


class _Line(BaseModel):
    kind: str = ""
    points: _Points


class _Drawing(BaseModel):
    """What `chatscene.maps.drawing.map_drawing` gives, and the routes by name."""

    roads: _Areas = []
    junctions: _Areas = []
    shoulders: _Areas = []
    sidewalks: _Areas = []
    lane_boundaries: list[_Line] = []
    stop_lines: list[_Line] = []
    routes: dict[str, _Points] = {}


_OF_A_REFUSED_RUN = ("explanation.json", "report.html", "run.json")


@dataclass(frozen=True, slots=True)
class Workspace:
    """A run folder by its path; the state is on disk, so any process may hold one.

    Attributes:
        path: The folder.
    """

    path: Path

    def file(self, name: str) -> Path:
        """The path of a file in the folder."""
        return self.path / name

    def episodes(self, scenario_id: str, route: int, block: int) -> Path:
        """Where the tracks of one block are."""
        return self.path / "episodes" / f"{_stem(scenario_id, route, block)}.parquet"

    def part(self, scenario_id: str, route: int, block: int) -> Path:
        """Where the rest of one block is until the run is finished."""
        return self.path / "parts" / f"{_stem(scenario_id, route, block)}.json"


def _stem(scenario_id: str, route: int, block: int) -> str:
    return f"{quote(scenario_id, safe='')}-route-{route:02d}-block-{block:02d}"


def create(
    folder: Path,
    *,
    text: str,
    settings: Settings,
    map_name: str,
    ego: str,
    map_path: Path | None = None,
    generator: str = "chatscene",
    sources: Sequence[SourceRecord] = (),
    senses: Mapping[str, dict[str, str]] | None = None,
    simulator: SimulatorIdentity | None = None,
) -> Workspace:
    """Start a run in a new or empty folder, or in place of one that was refused, with status ``running``.

    Args:
        folder: Made if it is not there.
        text: The sentence.
        settings: All settings, resolved.
        map_name: The map as the user named it.
        map_path: Its file, of which a digest is kept.
        ego: The ego as the user named it; of an evaluation, the egos, comma between them.
        generator: Who makes the scenes.
        sources: The runs whose scenes are driven, for an evaluation.
        senses: What each ego sees and brakes with, by ego.
        simulator: What runs the scenes; None for the one that the settings name, of no known version.

    Raises:
        RunError: The folder holds something, or cannot be written.
    """
    run = Workspace(folder)
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
        _refuse_links(folder)
        refused = _of_a_refused_run(run)
        if not all(path in refused or path.is_dir() or is_leftover(path) for path in folder.rglob("*")):
            raise RunError(_occupied(run))
        for path in refused:
            path.unlink()
    sweep(folder)
    command = "evaluate" if sources else "run"
    named = egos_of(command, ego)
    _write_record(
        run,
        RunRecord(
            schema_version=SCHEMA_VERSION,
            status=Status.RUNNING,
            text=text,
            map_name=map_name,
            map_digest=digest_of(map_path) if map_path else "",
            ego=ego,
            ego_digests={name: digest_of(Path(name)) for name in named if Path(name).suffix in FILES},
            senses=dict(senses or {}),
            generator=generator,
            simulator=SimulatorRecord(name=simulator.name, version=simulator.version, physics=simulator.physics)
            if simulator
            else SimulatorRecord(name=settings.simulation.simulator),
            command=command,
            sources=list(sources),
            settings=settings_to_json(settings),
            versions=_versions(),
            seed=settings.search.seed,
        ),
    )
    return run


def _of_a_refused_run(run: Workspace) -> list[Path]:
    """What a refused run left, which was never searched with, its record last; nothing if the run was not refused."""
    if not run.file("run.json").exists() or read_record(run).status is not Status.REFUSED:
        return []
    named = [run.file(name) for name in _OF_A_REFUSED_RUN]
    return [*run.file("programs").glob("*.scenic"), *(path for path in named if path.exists())]


def _occupied(run: Workspace) -> str:
    if run.file("run.json").exists() and read_record(run).status is not Status.REFUSED:
        return (
            f"{run.path} already holds a run; continue it with: chatscene resume {run.path}, "
            "or choose another folder with --out"
        )
    return f"{run.path} is not empty; choose a new or empty folder with --out"


def _refuse_links(folder: Path) -> None:
    """A link in a run folder would have files written and deleted wherever it leads.

    Raises:
        RunError: There is one.
    """
    if (link := next((path for path in sorted(folder.rglob("*")) if path.is_symlink()), None)) is not None:
        raise RunError(f"{link} is a link, and a run folder holds files of its own only; take it away")


def free_folder(parent: Path, text: str) -> Path:
    """A folder name made from a sentence that is not taken yet."""
    stem = "-".join(re.findall(r"[a-z0-9]+", text.lower())[:6]) or "run"
    taken = (parent / f"{stem}-{n}" if n > 1 else parent / stem for n in range(1, 10_000))
    return next(folder for folder in taken if not folder.exists())


def open_run(folder: Path, *, holds: str = "") -> Workspace:
    """Open a run that is there, and check that this version can read it and that it is whole.

    Args:
        folder: Its folder.
        holds: What it must hold, ``run`` or ``evaluate``; empty for either.

    Raises:
        RunError: There is no run in the folder, its `run.json` is broken, a newer version wrote it, or a file was
            changed, damaged or removed after it was written.
    """
    run = Workspace(folder)
    record, as_written = read_guarded(run)
    _refuse_links(folder)
    if holds and record.command != holds:
        raise RunError(f"{folder} holds what `chatscene {record.command}` leaves, not what `chatscene {holds}` does")
    if not as_written:
        raise RunError(f"{run.file('run.json')} was changed or damaged after it was written; {_REMEDY}")
    wrong = list(damage(folder, {name: told for name, told in record.files.items() if not is_drawn(name)}))
    if wrong:
        name, how = wrong[0]
        others = f" (the first of {len(wrong)}; chatscene check {folder} names them)" if wrong[1:] else ""
        raise RunError(f"{run.file(name)} is {how}{others}; {_REMEDY}")
    return run


_REMEDY = "put back what was there, or run it again into another folder"


def note(run: Workspace, *drawn: Path) -> None:
    """Keep the digests of files that were drawn from a finished run; of an unfinished one, none are kept."""
    record = read_record(run)
    if record.files:
        added = {path.relative_to(run.path).as_posix(): digest_of(path) for path in drawn}
        _write_record(run, record.model_copy(update={"files": dict(sorted((record.files | added).items()))}))


def read_record(run: Workspace) -> RunRecord:
    """What `run.json` says now.

    Raises:
        RunError: It is missing, broken, or newer than this version.
    """
    return read_guarded(run)[0]


def read_guarded(run: Workspace) -> tuple[RunRecord, bool]:
    """What `run.json` says now, and whether it is, to the byte, as it was written.

    It is read once, since another process may write it anew meanwhile. Of a run of an older version nobody can tell.

    Raises:
        RunError: It is missing, broken, or newer than this version.
    """
    path = run.file("run.json")
    if not path.is_file():
        raise RunError(
            f"{run.path} is not a run folder: it has no run.json; "
            "give the folder that `chatscene run` named, or start one with: chatscene run TEXT"
        )
    written = read_bytes(path)
    content = json_of(path, written)
    found = content.get("schema_version")
    if isinstance(found, int) and found > SCHEMA_VERSION:
        raise RunError(
            f"{run.path} was written by a newer chatscene (schema {found}, this one reads {SCHEMA_VERSION}); "
            "upgrade with: pip install --upgrade chatscene"
        )
    try:
        record = RunRecord.model_validate(content)
    except ValidationError as error:
        raise RunError(f"{path} is not the record of a run: {first_problem(error)}") from error
    return record, record.schema_version < DIGESTS_SINCE or is_sealed(written, record.digest)


def update(
    run: Workspace,
    *,
    status: Status | None = None,
    reason: str = "",
    counts: Mapping[str, int] | None = None,
    timings: Mapping[str, float] | None = None,
    failures: Mapping[str, str] | None = None,
    files: Mapping[str, str] | None = None,
) -> RunRecord:
    """Rewrite `run.json` in one step.

    Args:
        run: Which run.
        status: The new status; None leaves it. A status replaces the reason as well.
        reason: Why it failed or was refused.
        counts: New counts; None leaves them.
        timings: Added to those that stand there, key by key, so that a resumed run keeps its first part.
        failures: Why egos were given up; None leaves them.
        files: The digest of every file, now that the run is finished; None leaves them.
    """
    record = read_record(run)
    changes: dict[str, Any] = {}
    if status is not None:
        changes |= {"status": status, "reason": reason}
    if counts is not None:
        changes["counts"] = dict(counts)
    if timings is not None:
        changes["timings"] = _added(record.timings, timings)
    if failures is not None:
        changes["failures"] = dict(failures)
    if files is not None:
        changes |= {"files": dict(files), "schema_version": SCHEMA_VERSION}
    changed = record.model_copy(update=changes)
    _write_record(run, changed)
    return changed


def _added(before: Mapping[str, float], more: Mapping[str, float]) -> dict[str, float]:
    return dict(before) | {name: round(before.get(name, 0.0) + seconds, 3) for name, seconds in more.items()}


def _write_record(run: Workspace, record: RunRecord) -> None:
    write_sealed(run.file("run.json"), record.model_dump(mode="json", exclude={"digest"}))


def write_program(run: Workspace, scenario_id: str, source: str) -> Path:
    """Keep the program of a scenario as `programs/<scenario>.scenic`."""
    path = run.file("programs") / f"{quote(scenario_id, safe='')}.scenic"
    write_bytes(path, source.encode())
    return path


def read_programs(run: Workspace) -> dict[str, str]:
    """The kept programs by scenario, sorted.

    Raises:
        RunError: One cannot be read, or is no text.
    """
    paths = sorted(run.file("programs").glob("*.scenic"))
    return {unquote(path.stem): _read_program(path) for path in paths}


def _read_program(path: Path) -> str:
    try:
        return read_bytes(path).decode()
    except UnicodeDecodeError as error:
        raise RunError(
            f"{path} is no text in UTF-8 ({error.reason} at byte {error.start}); it was changed after it was written"
        ) from error


def write_explanation(run: Workspace, explanation: Mapping[str, Any]) -> None:
    """Keep what was understood and why; `chatscene.runs.explanation.explain` makes it."""
    write_json(run.file("explanation.json"), explanation)


def run_folders(sources: Sequence[Path]) -> list[Path]:
    """Every folder of a search among or below some folders, in a fixed order.

    Raises:
        RunError: There is none in one of them, or none is named.
    """
    folders: list[Path] = []
    for source in sources:
        below = sorted(path.parent for path in source.rglob("run.json")) if source.is_dir() else []
        searches = [path for path in below if read_record(Workspace(path)).command == "run"]
        if not searches:
            raise RunError(f"there is no run in {source}; give the folder that `chatscene run` named")
        folders += searches
    if not folders:
        raise RunError("no run is named; give the folder that `chatscene run` named")
    return list(dict.fromkeys(path.resolve() for path in folders))


def write_drawing(run: Workspace, drawing: Mapping[str, Any]) -> None:
    """Keep the drawing of the map as `map.json`; `docs/run-folder.md` has its shape. Metres, map frame."""
    write_json(run.file("map.json"), drawing)


def read_drawing(run: Workspace) -> dict[str, Any]:
    """The drawing of the map; empty if there is none.

    Raises:
        RunError: It is none.
    """
    path = run.file("map.json")
    content = read_json(path) if path.is_file() else {}
    try:
        _Drawing.model_validate(content)
    except ValidationError as error:
        raise RunError(
            f"{path} is no drawing of a map: {first_problem(error)}; it was changed or damaged after it was written"
        ) from error
    return content


def _versions() -> dict[str, str]:
    return {
        "python": platform.python_version(),
        **{package: _version(package) for package in ("chatscene", "scenic", "numpy", "shapely")},
        "platform": " ".join([platform.system(), platform.machine(), *platform.libc_ver()]).strip(),
    }


def changed_versions(record: RunRecord) -> dict[str, tuple[str, str]]:
    """What a run was made with and this process has otherwise: by name, the version then and now."""
    now = _versions()
    then = {name: version for name, version in record.versions.items() if name in now}
    return {name: (version, now[name]) for name, version in then.items() if version != now[name]}


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:  # run from a source tree that was never installed
        return "unknown"
