"""The run folder: create it, open it, say how far it came, keep what is not a table."""

from __future__ import annotations

import platform
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import zip_longest
from pathlib import Path
from typing import Any, TypeVar, overload
from urllib.parse import quote, unquote

from pydantic import ValidationError

from chatscene.errors import RunError
from chatscene.files.caches import installed
from chatscene.runs.atomic import (
    is_leftover,
    json_of,
    read_bytes,
    sweep,
    write_bytes,
    writing,
)
from chatscene.runs.digests import damage, digest_of, is_drawn, is_sealed, write_sealed
from chatscene.runs.exclusive import at_work
from chatscene.runs.record import (
    RECORDS,
    SCHEMA_VERSION,
    STOPPED,
    Kind,
    Record,
    RunRecord,
    Status,
    first_problem,
    upgraded,
)

RECORD = "run.json"
_OF_A_REFUSED_RUN = ("explanation.json", "map.json", "report.html", "situation.yaml", RECORD)
_RECORDS_OF_0_1 = ("benchmark.json", "finetune.json", "reproduce.json", "train.json")
_UPGRADED = 2  # the oldest schema that is read


@dataclass(frozen=True, slots=True)
class Workspace:
    """A run folder by its path; the state is on disk, so any process may hold one."""

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


def take_up(folder: Path, asked: Record) -> Workspace:
    """Start work in a new or empty folder, or go on in one where the same was asked for.

    A run that was refused, and so was never searched with, makes way for another. What may be another the next time is
    from now on what `asked` says.

    Raises:
        RunError: The folder holds something else, or what was asked for with other settings; or it is damaged, or
            cannot be written.
    """
    run = Workspace(folder)
    if not run.file(RECORD).exists():
        return create(folder, asked)
    before = read_record(run, Record)
    other = _other(before, asked)
    if other is None:
        open_run(folder)
        update(run, **{name: getattr(asked, name) for name in asked.model_fields_set - asked.asked()})
        return run
    if before.status is Status.REFUSED:
        return create(folder, asked)
    _require(run, before, type(asked))
    name, then, now = other
    raise RunError(
        f"{folder} holds {before.kind.in_words()} with other settings: {name} was {then!r} and is now {now!r}. To "
        f"continue that run: chatscene resume {folder}. For a new one, choose another folder with --out"
    )


def create(folder: Path, asked: Record) -> Workspace:
    """Start work in a new or empty folder, or in place of a run that was refused.

    Raises:
        RunError: The folder holds something, or cannot be written.
    """
    run = Workspace(folder)
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
        _refuse_links(folder)
        refused = _of_a_refused_run(run)
        if not all(path in refused or path.is_dir() or is_leftover(path) for path in folder.rglob("*")):
            raise RunError(
                _of_an_older_version(run) or f"{folder} is not empty; choose a new or empty folder with --out"
            )
        for path in refused:
            path.unlink()
    sweep(folder)
    _write_record(run, asked.model_copy(update={"versions": _versions()}))
    return run


def _other(before: Record, asked: Record) -> tuple[str, Any, Any] | None:
    """The first of what was asked for that is asked for otherwise now: its name, then and now.

    Of whole files the first line that differs is told, and only where nothing else does.
    """
    fields = set(asked.asked())
    then, now = (one.model_dump(mode="json", include=fields) for one in (before, asked))
    found = list(_differences(then, now))
    plain = [one for one in found if not _is_file(one[1]) and not _is_file(one[2])]
    if plain or not found:
        return plain[0] if plain else None
    name, old, new = found[0]
    lines = ((a, b) for a, b in zip_longest(str(old).splitlines(), str(new).splitlines(), fillvalue="") if a != b)
    then, now = next(lines, (old, new))
    return name, then, now


def _differences(then: Any, now: Any, name: str = "") -> Iterator[tuple[str, Any, Any]]:
    """Where two JSON values differ, by their paths."""
    if isinstance(then, dict) and isinstance(now, dict):
        for one in dict.fromkeys((*then, *now)):
            yield from _differences(then.get(one), now.get(one), f"{name}.{one}" if name else str(one))
    elif then != now:
        yield name, then, now


def _is_file(value: object) -> bool:
    return isinstance(value, str) and "\n" in value


def _of_a_refused_run(run: Workspace) -> list[Path]:
    """What a refused run left, which was never searched with, its record last; nothing if the run was not refused."""
    if not run.file(RECORD).exists() or read_record(run, Record).status is not Status.REFUSED:
        return []
    named = [run.file(name) for name in _OF_A_REFUSED_RUN]
    return [*run.file("programs").glob("*.scenic"), *(path for path in named if path.exists())]


def _of_an_older_version(run: Workspace) -> str | None:
    """What to say of a folder whose kind had no `run.json` in version 0.1; None if it is no such folder."""
    name = next((name for name in _RECORDS_OF_0_1 if run.file(name).is_file()), None)
    if name is None:
        return None
    return (
        f"{run.path} was made by chatscene 0.1, which kept {name} in it and no run.json; go on with it by that "
        "version, or start again in another folder with --out"
    )


def _refuse_links(folder: Path) -> None:
    """A link in a run folder would have files written and deleted wherever it leads."""
    if (link := next((path for path in sorted(folder.rglob("*")) if path.is_symlink()), None)) is not None:
        raise RunError(f"{link} is a link, and a run folder holds files of its own only; take it away")


def free_folder(parent: Path, text: str) -> Path:
    """A folder name made from a sentence that is not taken yet."""
    stem = "-".join(re.findall(r"[a-z0-9]+", text.lower())[:6]) or "run"
    taken = (parent / f"{stem}-{n}" if n > 1 else parent / stem for n in range(1, 10_000))
    return next(folder for folder in taken if not folder.exists())


def open_run(folder: Path, of: type[Record] = Record) -> Workspace:
    """Open a folder that is there, and check that this version can read it and that it is whole.

    Raises:
        RunError: There is no record in the folder, or it is of another kind, broken, or of a version that this one does
            not read; or a file was changed, damaged or removed after it was written.
    """
    run = Workspace(folder)
    record, as_written = read_guarded(run)
    _refuse_links(folder)
    _require(run, record, of)
    if not as_written:
        raise RunError(f"{run.file(RECORD)} was changed or damaged after it was written; {_REMEDY}")
    wrong = list(damage(folder, {name: told for name, told in record.files.items() if not is_drawn(name)}))
    if wrong:
        name, how = wrong[0]
        others = f" (the first of {len(wrong)}; chatscene check {folder} names them)" if wrong[1:] else ""
        raise RunError(f"{run.file(name)} is {how}{others}; {_REMEDY}")
    return run


_REMEDY = "put back what was there, or run it again into another folder"


def _require(run: Workspace, record: Record, of: type[Record]) -> None:
    if not isinstance(record, of):
        wanted = next(kind for kind, known in RECORDS.items() if known is of)
        raise RunError(f"{run.path} holds {record.kind.in_words()}, and this takes the folder of {wanted.in_words()}")


def require_done(run: Workspace, record: Record) -> None:
    """Hold a run to its end, for whoever needs its scenes.

    Raises:
        RunError: It is not done; a run that was refused never will be.
    """
    if record.status is Status.REFUSED:
        raise RunError(
            f"{run.path} was refused and has no scenes: {record.reason}; say it in other words, or take one of the "
            "readings that chatscene explain names, and run it again"
        )
    if record.status is not Status.DONE:
        stands = standing(run, record)
        if stands == STOPPED:
            raise RunError(
                f"{run.path} was interrupted; continue with: chatscene resume {run.path} (not while another machine "
                "works on it)"
            )
        raise RunError(f"{run.path} is {stands}, not done; finish it with: chatscene resume {run.path}")


def standing(run: Workspace, record: Record) -> str:
    """How far the work came, as far as this machine can tell.

    A process that was killed could not write down that it is no more; whether one is at work is seen at the folder, in
    which nothing is written.

    Returns:
        The status of the record, but `STOPPED` for one that is running by its record and that no process works on.
    """
    if record.status is not Status.RUNNING or at_work(run.path) is not False:
        return record.status.value
    since = read_record(run, Record).status  # it may have ended after the record was read
    return STOPPED if since is Status.RUNNING else record.status.value


def is_drawn_up(run: Workspace) -> bool:
    """Whether a run is done to its last file: its report and its animation are there, as they were written."""
    record = read_record(run, Record)
    drawn = {name: told for name, told in record.files.items() if is_drawn(name)}
    wanted = {Path(name).suffix for name in drawn} >= {".html", ".gif"}
    return record.status is Status.DONE and wanted and not any(damage(run.path, drawn))


def note(run: Workspace, *drawn: Path) -> None:
    """Keep the digests of files that were drawn from a finished run; of an unfinished one, none are kept."""
    if files := read_record(run, Record).files:
        added = {path.relative_to(run.path).as_posix(): digest_of(path) for path in drawn}
        update(run, files=dict(sorted((files | added).items())))


R = TypeVar("R", bound=Record)


@overload
def read_record(run: Workspace) -> RunRecord: ...
@overload
def read_record(run: Workspace, of: type[R]) -> R: ...
def read_record(run: Workspace, of: type[Record] = RunRecord) -> Record:
    """What `run.json` says now.

    Raises:
        RunError: It is missing, broken, of another kind, or of a version that this one does not read.
    """
    record, _ = read_guarded(run)
    _require(run, record, of)
    return record


def read_guarded(run: Workspace) -> tuple[Record, bool]:
    """What `run.json` says now, and whether it is, to the byte, as it was written.

    It is read once, since another process may write it anew meanwhile.

    Raises:
        RunError: It is missing, broken, or of a version that this one does not read.
    """
    path = run.file(RECORD)
    if not path.is_file():
        raise RunError(
            _of_an_older_version(run)
            or f"{run.path} is not a run folder: it has no run.json; "
            "give the folder that `chatscene run` named, or start one with: chatscene run TEXT"
        )
    written = read_bytes(path)
    content = json_of(path, written)
    as_written = is_sealed(written, content.get("digest"))
    content = _readable(run, content)
    try:
        record = RECORDS[Kind(content.get("kind", ""))].model_validate(content)
    except ValidationError as error:
        raise RunError(f"{path} is not the record of a run: {first_problem(error)}") from error
    except ValueError as error:
        raise RunError(f"{path} is not the record of a run: kind: {error}") from error
    _require_counts(run, record)
    return record, as_written


_COUNTED = ("scenes", "ran", "rejected", "collided", "selected", "fill_in")


def _require_counts(run: Workspace, record: Record) -> None:
    """Counts are all there, or none is."""
    counts = record.counts if isinstance(record, RunRecord) else {}
    if counts and (lacking := [name for name in _COUNTED if name not in counts]):
        raise RunError(f"{run.file(RECORD)} is not the record of a run: counts: {lacking[0]} is missing; {_REMEDY}")


def _readable(run: Workspace, content: dict[str, Any]) -> dict[str, Any]:
    """A record as this version has it."""
    found = content.get("schema_version")
    if isinstance(found, int) and found > SCHEMA_VERSION:
        raise RunError(
            f"{run.path} was written by a newer chatscene (schema {found}, this one reads {SCHEMA_VERSION}); "
            "read it with a newer checkout (git pull), or a newer wheel, of chatscene"
        )
    if found == _UPGRADED:
        return upgraded(content)
    if isinstance(found, int) and found < _UPGRADED:
        made_by = (content.get("versions") or {}).get("chatscene", "that run.json names")
        raise RunError(
            f"{run.path} was written by a chatscene of before 0.1.0 (schema {found}, this one reads {_UPGRADED} and "
            f"{SCHEMA_VERSION}); read it with the chatscene that made it, {made_by}, or run it again"
        )
    return content


def update(
    run: Workspace,
    *,
    status: Status | None = None,
    reason: str = "",
    timings: Mapping[str, float] | None = None,
    **found: Any,
) -> Record:
    """Rewrite `run.json` in one step.

    Args:
        run: Which folder.
        status: The new status; None leaves it. A status replaces the reason as well.
        reason: Why it failed or was refused.
        timings: Added to those that stand there, key by key, so that work that is resumed keeps its first part.
        found: Other fields of the record, by name; the rest is left as it is.
    """
    record = read_record(run, Record)
    changes = dict(found)
    if status is not None:
        changes |= {"status": status, "reason": reason}
    if timings is not None:
        changes["timings"] = _added(record.timings, timings)
    changed = type(record).model_validate({**record.model_dump(), **changes})
    _write_record(run, changed)
    return changed


def _added(before: Mapping[str, float], more: Mapping[str, float]) -> dict[str, float]:
    return dict(before) | {name: round(before.get(name, 0.0) + seconds, 3) for name, seconds in more.items()}


def _write_record(run: Workspace, record: Record) -> None:
    content = record.model_dump(mode="json", exclude={"digest"})
    last = {name: content.pop(name) for name in ("settings", "versions", "timings", "files")}
    write_sealed(run.file(RECORD), {"schema_version": SCHEMA_VERSION, "kind": record.kind, **content, **last})


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
            f"{path} is not UTF-8 text ({error.reason} at byte {error.start}); it was changed after it was written"
        ) from error


def run_folders(sources: Sequence[Path], *, readable: bool = False) -> list[Path]:
    """Every folder of a search among or below some folders, in a fixed order.

    Raises:
        RunError: There is none in one of them, or none is named, or a record cannot be read.
    """
    folders: list[Path] = []
    for source in sources:
        below = sorted(path.parent for path in source.rglob(RECORD)) if source.is_dir() else []
        searches = [path for path in below if _kind_of(path, readable=readable) is Kind.RUN]
        if not searches:
            raise RunError(f"there is no run in {source}; give the folder that `chatscene run` named")
        folders += searches
    if not folders:
        raise RunError("no run is named; give the folder that `chatscene run` named")
    return list(dict.fromkeys(path.resolve() for path in folders))


def _kind_of(folder: Path, *, readable: bool) -> Kind | None:
    try:
        return read_record(Workspace(folder), Record).kind
    except RunError:
        if not readable:
            raise
        return None


def inside(folder: Path) -> list[str]:
    """The folders in a folder that have a `run.json` of their own, by path, sorted; none that is in one of these."""
    names: list[str] = []
    for path in sorted(path.parent.relative_to(folder) for path in folder.rglob(RECORD) if path.parent != folder):
        if not any(path.is_relative_to(name) for name in names):
            names.append(path.as_posix())
    return names


def _versions() -> dict[str, str]:
    return {
        "python": platform.python_version(),
        **{package: _version(package) for package in ("chatscene", "scenic", "numpy", "shapely")},
        "platform": " ".join([platform.system(), platform.machine(), *platform.libc_ver()]).strip(),
    }


def changed_versions(record: Record) -> dict[str, tuple[str, str]]:
    """What a run was made with and this process has otherwise: by name, the version then and now."""
    now = _versions()
    then = {name: version for name, version in record.versions.items() if name in now}
    return {name: (version, now[name]) for name, version in then.items() if version != now[name]}


@cache
def _version(package: str) -> str:
    try:
        return installed(package)
    except ModuleNotFoundError:  # run from a source tree that was never installed
        return "unknown"
