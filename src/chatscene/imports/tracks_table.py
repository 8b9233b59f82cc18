"""Tracks of any simulator as a table of text: a row per road user and moment.

Columns are found by their names: ``time`` [s], ``id``, ``kind``, ``x`` and ``y`` [m], ``heading`` [rad, 0 = +x,
counter-clockwise], ``speed`` [m/s] and, if there are any, ``ego`` (1 or true in the ego's rows), ``length`` and
``width`` [m]. Those of our own export are taken too.
"""

from __future__ import annotations

import csv
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np

from chatscene.errors import ScenarioError
from chatscene.files.bounded import check_file
from chatscene.imports.recording import Poses

MOST_BYTES = 64 * 2**20
NAMES: Mapping[str, tuple[str, ...]] = {
    "time": ("time", "time_s"),
    "id": ("id", "actor"),
    "kind": ("kind",),
    "x": ("x", "x_m"),
    "y": ("y", "y_m"),
    "heading": ("heading", "heading_rad"),
    "speed": ("speed", "speed_m_per_s"),
    "ego": ("ego", "role"),
    "length": ("length", "length_m"),
    "width": ("width", "width_m"),
}
"""What a column may be called, the name of our own export last."""
_LEFT_OUT = ("ego", "length", "width")  # columns that need not be there
_YES = frozenset(("1", "true", "yes", "ego"))
_NUMBERS = ("time", "x", "y", "heading", "speed")


@dataclass(slots=True)
class _Rows:
    """The rows of one road user."""

    kind: str
    ego: bool
    length: float | None
    width: float | None
    numbers: list[tuple[float, ...]] = field(default_factory=list[tuple[float, ...]])


def read_table(path: Path) -> tuple[Poses, ...]:
    """Who was where and when.

    Raises:
        ScenarioError: It cannot be read, lacks a column, or has what is no number; the message names the line.
    """
    try:
        check_file(path)
        if path.stat().st_size > MOST_BYTES:
            raise ScenarioError(f"{path} has more than {MOST_BYTES // 2**20} MB; cut it down to the drive")
        with path.open(encoding="utf-8-sig", newline="") as file:
            found = _rows(path, csv.reader(file))
    except UnicodeDecodeError as error:
        raise ScenarioError(f"{path} is not UTF-8 text: {error.reason} at byte {error.start}") from error
    except OSError as error:
        raise ScenarioError(f"{path} cannot be read: {error.strerror or error}") from error
    except (ValueError, csv.Error) as error:
        raise ScenarioError(f"{path} is not a table: {error}") from error
    return tuple(_poses(path, name, rows) for name, rows in found.items())


def _rows(path: Path, reader: Iterator[list[str]]) -> dict[str, _Rows]:
    columns = _columns(path, [one.strip().lower() for one in next(reader, [])])
    found: dict[str, _Rows] = {}
    for line, row in enumerate(reader, 2):
        if not row:
            continue
        said = {name: row[at].strip() if at < len(row) else "" for name, at in columns.items()}
        if not said["id"] or not said["kind"]:
            raise ScenarioError(f"{path}, line {line}: it has no {'kind' if said['id'] else 'id'}")
        length, width = (
            _number(path, line, name, said[name]) if said.get(name) else None for name in ("length", "width")
        )
        made = _Rows(said["kind"], said.get("ego", "").lower() in _YES, length, width)
        one = found.setdefault(said["id"], made)
        one.numbers.append(tuple(_number(path, line, name, said[name]) for name in _NUMBERS))
    return found


def _columns(path: Path, header: list[str]) -> dict[str, int]:
    """Where the columns are, by their names."""
    columns = {name: header.index(called) for name, names in NAMES.items() for called in names if called in header}
    if lacking := [name for name in NAMES if name not in columns and name not in _LEFT_OUT]:
        raise ScenarioError(
            f"{path}, line 1: it has no column {', '.join(lacking)}; a table of tracks has "
            f"{', '.join(NAMES)}, the last three if there are any"
        )
    return columns


def _number(path: Path, line: int, name: str, written: str) -> float:
    try:
        found = float(written)
    except ValueError:
        found = math.nan
    if not math.isfinite(found) or abs(found) > 1e9:
        raise ScenarioError(f"{path}, line {line}: the {name} {written[:40]!r} is not a number")
    return found


def _poses(path: Path, name: str, rows: _Rows) -> Poses:
    time, x, y, heading, speed = np.array(sorted(rows.numbers)).T
    if (np.diff(time) <= 0.0).any():
        raise ScenarioError(f"{path}: {name} is in two rows at {time[int(np.argmin(np.diff(time)))]:g} s")
    return Poses(
        name=name,
        kind=rows.kind,
        time=time,
        x=x,
        y=y,
        heading=heading,
        speed=speed,
        ego=rows.ego,
        length=rows.length,
        width=rows.width,
    )
