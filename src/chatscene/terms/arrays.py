"""Columns of numbers: what they are, how they are kept, and by how much they change from one row to the next."""

from __future__ import annotations

from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Kept = TypeVar("Kept", bound=NDArray[Any])


def fixed(array: Kept) -> Kept:
    """An array as it is kept and given out more than once: nobody can write to it, but who made it."""
    view = array.view()
    view.setflags(write=False)
    return view


def changes(values: Array) -> Array:
    """(T - 1,) By how much each is greater than the one before: `np.diff`, whose call takes longer than its work."""
    return values[1:] - values[:-1]


def changes_at(values: Array) -> Array:
    """(T,) The same at each row; 0 in row 0."""
    return np.concatenate((values[:1] - values[:1], changes(values)))


def paces(x: Array, y: Array) -> Array:
    """(T - 1,) How far [m] each place is from the one before."""
    return np.hypot(changes(x), changes(y))
