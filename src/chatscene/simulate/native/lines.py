"""Lines in the engine's terms, and where the points of a track lie on one."""

from __future__ import annotations

import ctypes
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from chatscene.simulate.native.building import NoEngine
from chatscene.simulate.native.engine import PART, Engine, Line, load_engine
from chatscene.terms.arrays import Array
from chatscene.terms.polyline import Polyline


@lru_cache(maxsize=256)
def line_of(line: Polyline) -> tuple[Line, list[NDArray[np.float64]]]:
    """A line in the engine's terms, and what that points at."""
    x, y = line.columns[:2]
    parts = [slice(first, first + PART + 1) for first in range(0, len(line) - 1, PART)]
    boxes = [bound(of[part]) for part in parts for of in (x, y) for bound in (min, max)]
    columns = [np.array(column) for column in (*line.columns, boxes)]
    pointers = (column.ctypes.data_as(ctypes.POINTER(ctypes.c_double)) for column in columns)
    return Line(len(line), *pointers), columns


def follow(line: Polyline, x: Array, y: Array, *, whole: bool = False) -> tuple[Array, Array]:
    """(T,) arc length [m] and (T,) signed lateral offset [m] of points [m] on a line, as `Polyline.project` has them.

    Args:
        line: The line.
        x: (T,) map frame [m].
        y: (T,) map frame [m].
        whole: Whether each is looked for on the whole line, and not from where the one before it was.
    """
    if (native := engine()) is not None:
        return native.follow(line_of(line)[0], x, y, whole=whole)
    found = np.empty((2, len(x)))
    near: int | None = None
    for i, (each_x, each_y) in enumerate(zip(x.tolist(), y.tolist(), strict=True)):
        found[0, i], found[1, i], near = line.project(each_x, each_y, None if whole else near)
    return found[0], found[1]


@lru_cache(maxsize=1)
def engine() -> Engine | None:
    """The engine, or None on a machine that has none."""
    try:
        return load_engine()
    except NoEngine:
        return None
