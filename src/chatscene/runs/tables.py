"""The Parquet tables of a run: their columns, and the way from nouns to rows and back.

The same rows give the same bytes: fixed compression, no pandas metadata, nothing that depends on the time.
"""

from __future__ import annotations

import hashlib
import io
from collections import defaultdict
from collections.abc import Callable, Generator, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import MISSING, asdict, fields
from pathlib import Path
from typing import Any, get_args, get_type_hints

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
from pydantic import BaseModel

from chatscene.errors import RunError
from chatscene.files.atomic import temporary_of
from chatscene.runs.atomic import write_bytes, writing
from chatscene.runs.rows import EventRow, Part, RangeRow, SceneRow, SignalRow
from chatscene.terms.criticality import CRITICALITY
from chatscene.terms.metrics import Measurements
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.terms.speeds import Speeds
from chatscene.terms.surroundings import Surroundings

Table = Any  # a `pyarrow.Table`; pyarrow ships no types


_TYPES: dict[Any, Any] = {
    str: pa.string(), int: pa.int32(), float: pa.float64(), bool: pa.bool_(), list[str]: pa.list_(pa.string()),
}  # fmt: skip


def _columns(rows: type[BaseModel], *names: str) -> list[tuple[str, Any]]:
    """Some columns of rows, by the types of their fields."""
    types = get_type_hints(rows)
    kinds = {name: next(kind for kind in (types[name], *get_args(types[name])) if kind in _TYPES) for name in names}
    return [(name, _TYPES[kind]) for name, kind in kinds.items()]


_PLACE = [("scenario_id", pa.string()), ("route_id", pa.string()), ("block", pa.int32())]
EVENTS = pa.schema(_columns(EventRow, *EventRow.model_fields))
SIGNALS = pa.schema(_columns(SignalRow, *SignalRow.model_fields))
RANGES = pa.schema([*_PLACE, *_columns(RangeRow, *RangeRow.model_fields)])
_SCENE_HEAD = pa.schema(
    [
        ("scene_id", pa.string()),
        *_PLACE,
        ("seed", pa.uint64()),
        ("status", pa.string()),
        ("reason", pa.string()),
    ]
)
_SCENE_OUTCOME = pa.schema(
    [
        ("meaning_ok", pa.bool_()),
        *_columns(SceneRow, "meaning_failures", "collision", "impact_speed", "severity", "fault", "avoidable"),
        *_columns(SceneRow, "crash_type", "ego_kind", "other_kind", "happened", "happened_at", "gap_in_time", "ego"),
        *_columns(SceneRow, "ending", "route_completion", "dt", "light", "weather", "surface"),
    ]
)
_SCENE_TAIL = pa.schema(
    [
        ("overall_score", pa.float64()),
        ("selected", pa.bool_()),
        ("fill_in", pa.bool_()),
    ]
)
RAW = "raw_"  # what the metrics are computed from, so that any set of scenes can be scored from the table alone
_MEASUREMENTS = tuple(f"{RAW}{field.name}" for field in fields(Measurements))
_CRITICALITY = tuple(CRITICALITY)
_SPEEDS = tuple(field.name for field in fields(Speeds) if field.name not in ("ego_kind", "other_kind"))
_NUMBERS = pa.schema([(name, pa.float64()) for name in (*_CRITICALITY, *_SPEEDS, *_MEASUREMENTS)])
SCENES = pa.schema([*_SCENE_HEAD, *_SCENE_OUTCOME, *_NUMBERS, *_SCENE_TAIL])  # and those of parameters and metrics
_FIXED = frozenset(SCENES.names) - {"overall_score"}
# What a scene that was driven may lack. The last two are of the ego only.
_OPTIONAL = frozenset(
    {
        "reason",
        "impact_speed",
        "severity",
        "fault",
        "avoidable",
        "crash_type",
        "ego_kind",
        "other_kind",
        "happened",
        "happened_at",
        "gap_in_time",
        f"{RAW}time",
        "distance_to_route",
        "off_road",
    }
    | set(_CRITICALITY)
    | set(_SPEEDS)
)
# What folders lack that were written before there was such a column, and what every scene that was driven had then.
_LATER: dict[str, str | None] = {
    **{name: str(value) for name, value in asdict(Surroundings()).items()},
    **dict.fromkeys(("crash_type", "happened", "happened_at", "gap_in_time")),  # which were not kept
}
# What nothing can be read without. Whatever else a table has may have been added since: an older one lacks it.
_NEEDED = frozenset(
    {
        *_SCENE_HEAD.names,
        *("collision", "ego", "ending", "route_completion", "dt", "meaning_ok", "meaning_failures"),
        *("selected", "fill_in", "step", "actor", "role", "kind", "x", "y", "heading", "speed", "length", "width"),
        *("distance_to_route", "off_road", "x0", "y0", "x1", "y1", "state", "parameter", "low", "high", "other"),
    }
) - {"reason"}

_FEW = 500  # rows
_MOST_VALUES = 50_000_000  # of a table: a few hundred MB of numbers. What is a few kB on disk may unpack to any size.
_MOST_OF_A_BYTE = 8  # values; of a million scenes that we wrote, a byte is about one


_AS_WRITTEN: dict[str, Any] = {
    "compression": "zstd",
    "compression_level": 3,
    "version": "2.6",
    "write_page_checksum": True,
}
Names = tuple[Sequence[str], Sequence[str]]
"""The parameters and the metrics of scenes."""


@contextmanager
def writing_table(path: Path) -> Generator[Callable[[Table], None]]:
    """Write a Parquet file some rows at a time, whole or not at all, without waiting for the disk.

    Yields:
        What adds rows to it.
    """
    temporary, writer = temporary_of(path), list[Any]()

    def add(rows: Table) -> None:
        if not writer:
            writer.append(pq.ParquetWriter(temporary, rows.schema, **_AS_WRITTEN))
        writer[0].write_table(rows, row_group_size=1 << 20)

    with writing(path):
        try:
            yield add
            writer[0].close()
            temporary.replace(path)
        except BaseException:
            for one in writer:
                one.close()
            temporary.unlink(missing_ok=True)
            raise


def write_table(path: Path, table: Table) -> str:
    """Write a Parquet file, whole or not at all, without waiting for the disk; the SHA-256 of what was written."""
    sink = io.BytesIO()
    pq.write_table(table, sink, row_group_size=1 << 20, **_AS_WRITTEN)
    write_bytes(path, sink.getvalue(), lasting=False)
    return hashlib.sha256(sink.getvalue()).hexdigest()


def read_table(path: Path, columns: Any, **among: str) -> Table:
    """Read a Parquet file, or its rows where a named column has the given value.

    Args:
        path: Of the file.
        columns: Those it has here, as one of the schemas of this module. One that the file lacks, since there was none
            when it was written, is read as what held then, or as null. Further ones are kept if they hold numbers, as
            parameters and metrics of one's own do, and left out if not.
        among: One column, and its value.

    Raises:
        RunError: It is not there, not readable, or not such a table.
    """
    where = next(((name, (value,)) for name, value in among.items()), None)
    return pa.concat_tables(scan_table(path, columns, among=where))


Among = tuple[str, Iterable[Any]]
"""A column, and the values of it in the rows that are wanted."""


def scan_table(path: Path, columns: Any, *, names: Sequence[str] = (), among: Among | None = None) -> Generator[Table]:
    """Read a Parquet file part by part, as it was written, so that it may be of any size.

    Args:
        path: Of the file.
        columns: As for `read_table`.
        names: Those of the columns that are wanted; all if none is named.
        among: The rows that are wanted. Parts of the file that have none are not read.

    Yields:
        Some rows; at least once.

    Raises:
        RunError: As for `read_table`.
    """
    try:
        with pq.ParquetFile(path, page_checksum_verification=True) as file:
            _check_size(file.metadata, path.stat().st_size)
            yield from _parts_of(file, columns, names, among)
    except (OSError, ValueError, KeyError, pa.ArrowException) as error:
        raise RunError(f"cannot read {path}: {error}; it is missing or was changed or damaged") from error


def _parts_of(file: Any, columns: Any, names: Sequence[str], among: Among | None) -> Iterator[Table]:
    wanted, none = among and frozenset(among[1]), True
    read = [name for name in file.schema_arrow.names if name in {*names, "status"}] if names else None
    for group in range(file.num_row_groups):
        numbers = list[int]()
        if among and wanted is not None:
            values = file.read_row_group(group, columns=[among[0]]).column(among[0]).to_pylist()
            numbers = [number for number, value in enumerate(values) if value in wanted]
            if not numbers:
                continue
        rows = file.read_row_group(group, columns=read)
        yield _as_known(_of_numbers(rows, numbers) if among else rows, columns, names)
        none = False
    if none:
        yield _as_known(file.schema_arrow.empty_table(), columns, names)


def _as_known(table: Table, columns: Any, names: Sequence[str]) -> Table:
    """A table with the columns that this version knows, or with some of them."""
    if unknown := [field.name for field in table.schema if _is_unknown(field, columns)]:
        table = table.drop_columns(unknown)
    known = [field for field in columns if not names or field.name in {*names, "status"}]
    _check_columns(table, pa.schema(known))
    there = frozenset(table.column_names)
    for field in known:
        if field.name not in there:
            table = table.append_column(field, _as_before(field, table))
    return table.select(list(names)) if names else table


def columns_of(path: Path, columns: Any) -> tuple[list[str], dict[str, str | None]]:
    """The columns that `read_table` would give of a Parquet file, without its rows.

    Returns:
        Those that it has; and those that it lacks, with what held in every scene that was driven when there were none.

    Raises:
        RunError: As for `read_table`; whether values are lacking is not looked at.
    """
    try:
        with pq.ParquetFile(path) as file:
            _check_size(file.metadata, path.stat().st_size)
            known = _as_known(file.schema_arrow.empty_table(), columns, ()).column_names
            there = frozenset(file.schema_arrow.names)
    except (OSError, ValueError, KeyError, pa.ArrowException) as error:
        raise RunError(f"cannot read {path}: {error}; it is missing or was changed or damaged") from error
    lacking = {name: _LATER.get(name) if "status" in there else None for name in known if name not in there}
    return [name for name in known if name in there], lacking


def read_some(path: Path, columns: Any, *, every: int, always: str) -> Table:
    """Of a large Parquet file, every so manieth row, and those in which a column is true; read part by part.

    Raises:
        RunError: As for `read_table`.
    """
    found, before = list[Table](), 0
    for rows in scan_table(path, columns):
        numbers = np.arange(before, before + rows.num_rows) % every == 0
        found.append(rows.filter(pa.array(numbers | rows.column(always).to_numpy())))
        before += rows.num_rows
    return pa.concat_tables(found)


def rows_of(table: Table) -> list[dict[str, Any]]:
    """The rows of a table, by column; of many column by column, which takes a fifth of the time of Arrow's own.

    Of few it is not worth what that needs to be loaded.
    """
    if table.num_rows < _FEW:
        rows: list[dict[str, Any]] = table.to_pylist()
        return rows
    return list(each_row(table))


def each_row(table: Table) -> Iterator[dict[str, Any]]:
    """The rows of a table as `rows_of` gives them, one by one, so that no more than one need be kept."""
    if table.num_rows < _FEW:
        yield from table.to_pylist()
        return
    names = table.column_names
    columns = [_values(column) for column in table.columns]
    for values in zip(*columns, strict=True):
        yield dict(zip(names, values, strict=True))


def _values(column: Any) -> list[Any]:
    kind = column.type
    if pa.types.is_string(kind):
        told = column.combine_chunks().dictionary_encode()
        words = [*told.dictionary.to_pylist(), None]
        return [words[number] for number in told.indices.fill_null(len(words) - 1).to_numpy().tolist()]
    if not (pa.types.is_floating(kind) or pa.types.is_integer(kind) or pa.types.is_boolean(kind)):
        return column.to_pylist()
    numbers = column.fill_null(False if pa.types.is_boolean(kind) else 0) if column.null_count else column
    values: list[Any] = numbers.to_numpy().tolist()
    if column.null_count:
        there = column.is_valid().to_numpy().tolist()
        return [value if valid else None for value, valid in zip(values, there, strict=True)]
    return values


def rows_with(table: Table, column: str, value: str) -> Table:
    """The rows of a table in which a column has a value."""
    return rows_by(table, column).get(value, table.slice(0, 0))


def rows_by(table: Table, column: str) -> dict[str, Table]:
    """The rows of a table by the value that they have in a column."""
    there = defaultdict[str, list[int]](list)
    for number, value in enumerate(table.column(column).to_pylist()):
        there[value].append(number)
    return {value: _of_numbers(table, numbers) for value, numbers in there.items()}


def copied(table: Table) -> Table:
    """A table of its own, where rows of another are a view that keeps all of that."""
    return table.take(np.arange(table.num_rows))


def _of_numbers(table: Table, numbers: list[int]) -> Table:
    if numbers[-1] - numbers[0] == len(numbers) - 1:  # as those of a scene lie in what we write
        return table.slice(numbers[0], len(numbers))
    return table.take(numbers)


def _check_size(told: Any, packed: int) -> None:
    """Refuse a table that unpacks to far more than its bytes on disk, before it is unpacked."""
    if told.num_rows * told.num_columns > max(_MOST_VALUES, _MOST_OF_A_BYTE * packed):
        raise ValueError(f"it unpacks to {told.num_rows:,} rows, more than any work leaves")


def _is_unknown(field: Any, columns: Any) -> bool:
    """Whether a column is from a later version: none of ours, and no number."""
    return field.name not in columns.names and field.type != pa.float64()


def _as_before(field: Any, table: Table) -> Any:
    """The values of a column in a table that was written before there was such a column."""
    usual = _LATER.get(field.name)
    if usual is None or "status" not in table.column_names:
        return pa.nulls(table.num_rows, field.type)
    return pa.array([usual if status == "ran" else None for status in table.column("status").to_pylist()], field.type)


def _check_columns(table: Table, columns: Any) -> None:
    """Refuse a table that lacks what no drive is without, or values that a column always has, or holds others."""
    types = {field.name: field.type for field in table.schema}
    there = [field for field in columns if field.name in types]
    if lacking := [name for name in columns.names if name in _NEEDED and name not in types]:
        raise ValueError(f"it has no column {lacking[0]!r}")
    for field in there:
        found = types[field.name]
        if found != field.type:
            raise ValueError(f"its column {field.name!r} holds {found} and not {field.type}")
    driven = rows_with(table, "status", "ran") if "status" in columns.names else table
    head = frozenset(_SCENE_HEAD.names)
    for field in there:
        always = table if field.name in head else driven
        if field.name not in _OPTIONAL and always.column(field.name).null_count:
            raise ValueError(f"its column {field.name!r} lacks values")


def route_id(route: int) -> str:
    """The name of a route in the tables."""
    return f"route-{route:02d}"


def route_index(name: str) -> int:
    """The inverse of `route_id`.

    Raises:
        RunError: It is the name of no route.
    """
    try:
        return int(name.removeprefix("route-"))
    except ValueError as error:
        raise RunError(f"{name!r} is not a route; the folder was changed or damaged after it was written") from error


def scenes_table(
    parts: Sequence[Part], selected: Mapping[str, bool] | None = None, names: Names | None = None
) -> Table:
    """One row per scene.

    Raises:
        RunError: A metric has the name of another column.
    """
    parameters, metrics = names_in(parts) if names is None else names
    if taken := sorted(_FIXED.intersection(metrics)):
        raise RunError(f"a metric may not have the name of another column of scenes.parquet: {', '.join(taken)}")
    numbers = [(name, pa.float64()) for name in (*parameters, *metrics)]
    schema = pa.schema(
        [
            *_SCENE_HEAD,
            *numbers[: len(parameters)],
            *_SCENE_OUTCOME,
            *numbers[len(parameters) :],
            *_NUMBERS,
            *_SCENE_TAIL,
        ]
    )
    rows = [_scene_row(part, scene, selected or {}) for part in parts for scene in part.scenes]
    return pa.Table.from_pylist(rows, schema=schema)


def names_in(parts: Sequence[Part]) -> Names:
    """What the parameters, sorted, and the metrics of the scenes of some blocks are called."""
    scenes = [scene for part in parts for scene in part.scenes]
    metrics = dict.fromkeys(name for scene in scenes for name in scene.metrics if name != "overall_score")
    return sorted({name for scene in scenes for name in scene.values}), list(metrics)


def metrics_of(row: Mapping[str, Any]) -> dict[str, float]:
    """The metrics in a row of `scenes.parquet`, by name; of a rejected scene, none."""
    return {
        name: value
        for name, value in row.items()
        if name not in _FIXED and not name.startswith(("OPT_", RAW)) and value is not None
    }


def criticality_of(row: Mapping[str, Any]) -> dict[str, float]:
    """The measures of criticality in a row of `scenes.parquet`, by name; those that do not apply are left out."""
    return {name: row[name] for name in _CRITICALITY if row[name] is not None}


def speeds_of(row: Mapping[str, Any]) -> dict[str, float]:
    """The speeds in a row of `scenes.parquet`, by name; those that do not apply, or were not kept, are left out."""
    return {name: row[name] for name in _SPEEDS if row[name] is not None}


def scene_of(row: Mapping[str, Any], program: ScenicProgram) -> Scene:
    """The scene in a row of `scenes.parquet`, ready to be driven again.

    Raises:
        RunError: The row lacks a value of the program.
    """
    if missing := [p.name for p in program.parameters if row.get(p.name) is None]:
        raise RunError(
            f"scene {row['scene_id']!r} has no {missing[0]} in scenes.parquet; it was changed or damaged after it "
            "was written"
        )
    return Scene(
        id=row["scene_id"],
        scenario_id=row["scenario_id"],
        route=route_index(row["route_id"]),
        block=row["block"],
        seed=row["seed"],
        values={p.name: row[p.name] for p in program.parameters},
    )


def measurements_of(row: Mapping[str, Any]) -> Measurements:
    """The raw numbers in a row of `scenes.parquet`, of a scene that was driven.

    Raises:
        RunError: One was not measured yet when the folder was written, and has no default.
    """
    numbers: dict[str, Any] = {field.name: row[RAW + field.name] for field in fields(Measurements)}
    for field in fields(Measurements):
        if numbers[field.name] is None and field.default is not MISSING:
            numbers[field.name] = field.default
        elif numbers[field.name] is None and RAW + field.name not in _OPTIONAL:
            raise RunError(
                f"scene {row['scene_id']!r} has no {RAW + field.name} in scenes.parquet, which was written before that "
                "was measured; run it again into another folder to score it"
            )
    numbers |= {name: int(numbers[name]) for name in ("red_lights", "stop_signs", "lane_invasions")}
    return Measurements(**numbers | {"collided": bool(numbers["collided"])})


_NO_COLUMNS = {"values", "metrics", "measurements", "criticality", "speeds", "waits", "stepped", "instead", "unplayed"}


def _scene_row(part: Part, scene: SceneRow, selected: Mapping[str, bool]) -> dict[str, Any]:
    row = scene.model_dump(exclude=_NO_COLUMNS)
    row |= scene.values | scene.metrics | scene.criticality | scene.speeds
    row |= {f"{RAW}{name}": value for name, value in scene.measurements.items()}
    driven = scene.reason is None
    if driven:
        row |= {name: row[name] or usual for name, usual in _LATER.items()}  # of a block that was done before
    return row | {
        "scenario_id": part.scenario_id,
        "route_id": route_id(part.route),
        "block": part.block,
        "crash_type": scene.crash_type or None,
        "happened": scene.happened,
        "happened_at": scene.happened_at,
        "gap_in_time": scene.gap_in_time,
        "status": "ran" if driven else "rejected",
        "meaning_ok": not scene.meaning_failures if driven else None,
        "meaning_failures": scene.meaning_failures if driven else None,
        "selected": scene.scene_id in selected,
        "fill_in": selected.get(scene.scene_id, False),
    }


def events_table(parts: Sequence[Part]) -> Table:
    """One row per event."""
    return pa.Table.from_pylist([row.model_dump() for part in parts for row in part.events], schema=EVENTS)


def signals_table(parts: Sequence[Part]) -> Table:
    """One row per drive and traffic signal."""
    return pa.Table.from_pylist([row.model_dump() for part in parts for row in part.signals], schema=SIGNALS)


def ranges_table(parts: Sequence[Part]) -> Table:
    """One row per block and parameter."""
    rows = [
        row.model_dump() | {"scenario_id": part.scenario_id, "route_id": route_id(part.route), "block": part.block}
        for part in parts
        for row in part.ranges
    ]
    return pa.Table.from_pylist(rows, schema=RANGES)
