"""An index over run folders: what all runs below a folder asked for and came to, as a few Arrow tables.

It is made anew each time, from `run.json`, `explanation.json` and the Parquet files, and nothing is written. A folder
is data of somebody else: it is opened as any is, with every digest compared, and one that cannot be read is left out
with the reason.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields
from itertools import groupby
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa

from chatscene import runs
from chatscene.errors import ChatSceneError, RunError
from chatscene.report.index_columns import IN_SQL, TABLES, schema_of
from chatscene.report.sql import literal, quoted
from chatscene.runs.tables import EVENTS, RANGES, SCENES, Table, columns_of, read_table, rows_of, scan_table
from chatscene.runs.workspace import RECORD
from chatscene.terms.scenario import Slots

_BLOCK = ("scenario_id", "route_id", "block")
_AT_ONCE = 20_000  # scenes whose parameters are made rows at a time
LARGE = 20_000  # scenes of a run, above which they are read as a query needs them
_PATTERN = frozenset("*?[")  # which DuckDB reads in the name of a file as a pattern
_OF_A_RUN = ("scenario_id", "ego_speed_before", "other_speed_before", "impact_speed")
_HAS_RUN = "scenes.parquet has a column 'run', which an index has for the run's name"
_COUNTS = ("scenes", "ran", "rejected", "collided", "off_road", "timeout", "waiting", "selected", "fill_in")
OTHERWISE_CALLED = {"distance": "start_distance", "group": "in_group", "ego": "ego_state"}
"""Slots whose names are words of SQL, or columns of `scenes`, by their columns in `facts`."""


@dataclass(frozen=True, slots=True, kw_only=True)
class LeftOut:
    """A folder whose scenes are not in an index."""

    folder: Path
    why: str

    def __str__(self) -> str:
        """In a line."""
        return f"left out {self.folder}: {self.why}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Large:
    """A run with so many scenes that an index reads no row of them before it is asked for.

    Attributes:
        selects: By table (`scenes`, `parameters`, `events`), its rows as a SELECT in DuckDB's SQL.
    """

    run: str
    folder: Path
    selects: Mapping[str, str]
    files: tuple[Path, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Index:
    """What an index holds.

    Attributes:
        tables: Arrow tables by name, with the columns of `chatscene.report.index_columns.TABLES`.
        large: The runs whose scenes, parameters and events are in none of them, as these are too many.
        evaluations: The records of evaluations, by folder; they have no scenes of their own.
        left_out: Folders whose scenes are in none of them.
    """

    tables: Mapping[str, Table]
    large: tuple[Large, ...] = ()
    evaluations: Mapping[Path, runs.EvaluationRecord | runs.ComparisonRecord]
    left_out: tuple[LeftOut, ...]

    def scenes(self, names: Sequence[str]) -> dict[str, Iterable[Mapping[str, Any]]]:
        """Rows of scenes with some columns, by run; those of a large run are read as they are asked for, once."""
        rows = self.tables["scenes"].select(["run", *names]).to_pylist()
        by_run: dict[str, Iterable[Mapping[str, Any]]] = {
            run: [{name: row[name] for name in names} for row in some]
            for run, some in groupby(rows, key=lambda row: row["run"])
        }
        return by_run | {one.run: runs.each_scene(runs.Workspace(one.folder), names) for one in self.large}


def index(folder: Path) -> Index:
    """Read all runs below a folder, in the order of their paths.

    Raises:
        RunError: There is no such folder, or neither run nor evaluation in it.
    """
    if not folder.is_dir():
        raise RunError(f"no folder '{folder}' here; start where your runs are, or name their folder")
    read: list[Mapping[str, Table]] = []
    large: list[Large] = []
    evaluations: dict[Path, runs.EvaluationRecord | runs.ComparisonRecord] = {}
    left_out: list[LeftOut] = []
    for path in sorted(found.parent for found in folder.rglob(RECORD)):
        try:
            record = runs.read_record(runs.Workspace(path), runs.Record)
            if isinstance(record, runs.EvaluationRecord | runs.ComparisonRecord):
                evaluations[path] = record
            if isinstance(record, runs.RunRecord):
                run = runs.open_run(path, runs.RunRecord)
                one, unread = _read(run, record, name_of(path, folder))
                _joined([one])  # alone first: what does not fit must not keep the others from being shown
                read.append(one)
                large += unread
                if record.status is not runs.Status.REFUSED:  # which has all that it ever will
                    runs.require_done(run, record)
        except ChatSceneError as error:
            left_out.append(LeftOut(folder=path, why=str(error)))
        except Exception as error:  # noqa: BLE001 - a folder is data of somebody else, and one must not end the list
            why = f"it cannot be read ({type(error).__name__}: {error}); it was changed or damaged after it was written"
            left_out.append(LeftOut(folder=path, why=why))
    if not (read or evaluations or left_out):
        raise RunError(f"there is no run in {folder}; give a folder with those that `chatscene run` named")
    return Index(tables=_joined(read), large=tuple(large), evaluations=evaluations, left_out=tuple(left_out))


def _joined(read: list[Mapping[str, Table]]) -> dict[str, Table]:
    """The tables of all runs, one after the other."""
    return {
        name: pa.concat_tables(
            [schema_of(name).empty_table(), *(one[name] for one in read if name in one)], promote_options="default"
        )
        for name in TABLES
    }


def name_of(path: Path, folder: Path) -> str:
    """What a run folder is called in an index: its path below the folder that was given, or that folder's own name."""
    name = path.resolve().name if path == folder else path.relative_to(folder).as_posix()
    return name.encode("utf-8", "backslashreplace").decode()


def _read(run: runs.Workspace, record: runs.RunRecord, name: str) -> tuple[Mapping[str, Table], list[Large]]:
    """The rows of one run in each table; of a large one, where those of its scenes are."""
    done = record.status is runs.Status.DONE
    if done and record.counts.get("scenes", 0) > LARGE and not _PATTERN.intersection(str(run.path.absolute())):
        scenes = pa.concat_tables(scan_table(run.file("scenes.parquet"), SCENES, names=_OF_A_RUN))
        return _of_all(run, record, name, scenes), [_large(run, name)]
    scenes, ranges, events = (
        read_table(run.file(file), columns) if done else columns.empty_table()
        for file, columns in (("scenes.parquet", SCENES), ("ranges.parquet", RANGES), ("events.parquet", EVENTS))
    )
    named = {str(one) for one in ranges.column("parameter").to_pylist()} - set(SCENES.names)
    parameters = [one for one in scenes.column_names if one.startswith("OPT_") or one in named]
    return {
        **_of_all(run, record, name, scenes),
        "scenes": _of_run(name, scenes.drop_columns(parameters)),
        "parameters": _parameters(name, scenes, ranges, parameters),
        "events": _of_run(name, events),
    }, []


def _of_all(run: runs.Workspace, record: runs.RunRecord, name: str, scenes: Table) -> dict[str, Table]:
    """The rows that are not of single scenes."""
    return {
        "runs": _table("runs", [{"run": name, **_run_row(run.path, record), **_speeds(scenes)}]),
        "facts": _table("facts", [{"run": name, **row} for row in _facts(run, scenes)]),
    }


def _large(run: runs.Workspace, name: str) -> Large:
    """Where the rows of a large run are."""
    scenes, ranges, events = (run.file(f"{one}.parquet").absolute() for one in ("scenes", "ranges", "events"))
    there, lacking = columns_of(scenes, SCENES)
    named = {str(one) for one in read_table(ranges, RANGES).column("parameter").to_pylist()} - set(SCENES.names)
    parameters = [one for one in there if one.startswith("OPT_") or one in named]
    own = [one for one in there if one not in parameters]
    if "run" in own:
        raise RunError(_HAS_RUN)
    drawn, block = ", ".join(map(quoted, parameters)), ", ".join(_BLOCK)
    values = (
        f"SELECT * FROM (SELECT scene_id, {block}, {drawn} FROM {_file(scenes)}) UNPIVOT (value FOR name IN ({drawn}))"
        if parameters
        else f"SELECT scene_id, {block}, '' AS name, 0.0 AS value FROM {_file(scenes)} LIMIT 0"
    )
    return Large(
        run=name,
        folder=run.path,
        selects={
            "scenes": _select(name, own, {one: (SCENES, usual) for one, usual in lacking.items()}, scenes),
            "parameters": (
                f"SELECT {literal(name)} AS run, scene_id, name, value, unit, low, high, meaning FROM ({values}) "
                f"LEFT JOIN (SELECT {block}, parameter AS name, unit, low, high, meaning FROM {_file(ranges)}) "
                f"USING ({block}, name)"
            ),
            "events": _select(name, *_events(events), events),
        },
        files=(scenes, ranges, events),
    )


def _events(path: Path) -> tuple[list[str], dict[str, tuple[Any, str | None]]]:
    there, lacking = columns_of(path, EVENTS)
    return there, {one: (EVENTS, usual) for one, usual in lacking.items()}


def _select(name: str, there: Sequence[str], lacking: Mapping[str, tuple[Any, str | None]], path: Path) -> str:
    """The rows of a file as they are in an index."""
    added = (
        f"(CASE WHEN status = 'ran' THEN {literal(usual)} END)::{IN_SQL[columns.field(one).type]} AS {quoted(one)}"
        if usual is not None
        else f"NULL::{IN_SQL[columns.field(one).type]} AS {quoted(one)}"
        for one, (columns, usual) in lacking.items()
    )
    return f"SELECT {', '.join((f'{literal(name)} AS run', *map(quoted, there), *added))} FROM {_file(path)}"


def _file(path: Path) -> str:
    return f"read_parquet({literal(str(path))})"


def _table(name: str, rows: list[dict[str, Any]]) -> Table:
    return pa.Table.from_pylist(rows, schema=schema_of(name))


def _of_run(name: str, rows: Table) -> Table:
    """Rows with the name of their run."""
    if "run" in rows.column_names:
        raise RunError(_HAS_RUN)
    return rows.add_column(0, "run", pa.array([name] * rows.num_rows, pa.string()))


def _run_row(path: Path, record: runs.RunRecord) -> dict[str, Any]:
    settings = runs.settings_of(record)
    return {
        "folder": str(path.resolve()).encode("utf-8", "backslashreplace").decode(),
        "text": record.title,
        "generator": record.generator,
        "status": runs.standing(runs.Workspace(path), record),
        "reason": record.reason,
        "seed": settings.search.seed,
        "ego": record.ego,
        "map": record.map_name,
        "sampler": settings.search.sampler,
        "simulator": record.simulator.name,
        "simulator_version": record.simulator.version or None,
        "physics": settings.simulation.physics,
        "version": record.versions.get("chatscene"),
        "schema_version": record.schema_version,
        "edited_from": record.edited_from or None,
        "seconds": record.timings.get("total"),
        **{name: record.counts.get(name) for name in _COUNTS},
    }


def _speeds(scenes: Table) -> dict[str, float | None]:
    """How fast its drives were [m/s]."""
    of = {"ego_speed": "ego_speed_before", "other_speed": "other_speed_before", "impact_speed": "impact_speed"}
    columns = {name: scenes.column(column).to_numpy() for name, column in of.items()}
    told = {name: values[~np.isnan(values)] for name, values in columns.items()}
    return {
        name: float(np.max(values) if name == "impact_speed" else np.median(values)) if len(values) else None
        for name, values in told.items()
    }


def _facts(run: runs.Workspace, scenes: Table) -> Iterator[dict[str, Any]]:
    """A row per scenario; one of which nothing was read has all facts null."""
    if run.file("explanation.json").is_file():
        scenario, choice = runs.read_choice(run)
        row = _slots_row(scenario.slots) | {"scenario_id": scenario.id, "base": scenario.base}
        if choice:
            row["adversary"] = choice.adversary
            row |= dict(zip(("behavior", "geometry", "spawn"), choice.snippet_ids, strict=True))
        yield row
    else:
        for scenario_id in scenes.column("scenario_id").unique().to_pylist():
            yield {"scenario_id": scenario_id}


def _slots_row(slots: Slots) -> dict[str, Any]:
    told = {field.name: getattr(slots, field.name) for field in fields(Slots)}
    return {OTHERWISE_CALLED.get(name, name): value for name, value in told.items()} | {"others": len(slots.others)}


def _parameters(run: str, scenes: Table, ranges: Table, names: list[str]) -> Table:
    """A row per scene and parameter, with what the scene's block drew from."""
    drawn = {tuple(row[key] for key in (*_BLOCK, "parameter")): row for row in rows_of(ranges)}
    own = scenes.select(["scene_id", *_BLOCK, *names])
    parts = (own.slice(first, _AT_ONCE) for first in range(0, max(own.num_rows, 1), _AT_ONCE))
    return pa.concat_tables(
        [_table("parameters", [{"run": run, **row} for row in _in_rows(part, drawn, names)]) for part in parts]
    )


def _in_rows(
    scenes: Table, drawn: Mapping[tuple[Any, ...], Mapping[str, Any]], names: list[str]
) -> Iterator[dict[str, Any]]:
    for scene in rows_of(scenes):
        block = tuple(scene[key] for key in _BLOCK)
        for name in names:
            if scene[name] is not None:
                told = drawn.get((*block, name), {})
                of_block = {key: told.get(key) for key in ("unit", "low", "high", "meaning")}
                yield {"scene_id": scene["scene_id"], "name": name, "value": scene[name], **of_block}
