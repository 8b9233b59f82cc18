"""Columns of numbers: what they are, how they are kept, and by how much they change from one row to the next."""

from __future__ import annotations

import math
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


def unwrapped(angles: Array) -> Array:
    """(T,) Angles [rad] without jumps: `np.unwrap`, which is asked only where there is one."""
    if not (np.abs(changes(angles)) < math.pi).all():
        return np.unwrap(angles)
    same = angles + 0.0  # as it adds no turns
    same[:1] = angles[:1]
    return same


def slopes(values: Array) -> Array:
    """(T,) By how much each changes a row, two at least: `np.gradient`, whose call takes longer than its work."""
    found = np.empty_like(values)
    found[1:-1] = (values[2:] - values[:-2]) / 2.0
    found[0], found[-1] = values[1] - values[0], values[-1] - values[-2]
    return found
