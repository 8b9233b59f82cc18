"""The boxes of two bodies over time: when they overlap, how far they are apart, and when they would touch."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from chatscene.terms.episode import Array, Track

Steps = NDArray[np.intp]

ROUNDING = 1e-6  # [m], more than rounding makes of a distance
NOTHING = 1e-9  # [m] or [m/s], what rounding makes of nothing
KEPT = 16  # of the tracks and pairs that were asked for last, what was found: each measure of a drive asks anew
FINENESS = 4  # into how many parts a step is cut to time who leaves and who comes


@dataclass(frozen=True, slots=True, eq=False)
class Boxes:
    """The boxes of one body at some moments; arrays of one shape, and half its sizes [m]."""

    x: Array
    y: Array
    cos: Array
    sin: Array
    half_length: float
    half_width: float

    @staticmethod
    @lru_cache(maxsize=KEPT)
    def of(track: Track, parts: int = 1) -> Boxes:
        """At every step, and at as many moments between two steps as make `parts` of it."""
        x, y, heading = track.x, track.y, track.heading
        if parts > 1:
            rows = np.arange(len(x))
            moments = np.arange((len(x) - 1) * parts + 1) / parts
            x, y, heading = (np.interp(moments, rows, values) for values in (x, y, heading))
        return Boxes(x, y, np.cos(heading), np.sin(heading), track.length / 2, track.width / 2)

    def at(self, moments: Steps | int) -> Boxes:
        """At some of them."""
        return Boxes(
            self.x[moments],
            self.y[moments],
            self.cos[moments],
            self.sin[moments],
            self.half_length,
            self.half_width,
        )


@dataclass(frozen=True, slots=True, eq=False)
class Pair:
    """Two bodies' boxes on the four axes on which boxes can be apart; arrays are (4, …).

    Attributes:
        axis_x: The axes: along and across the first, along and across the second.
        axis_y: The same.
        offset: From the first centre to the second along each axis [m].
        reach: How near the centres are along it when the boxes touch [m].
    """

    axis_x: Array
    axis_y: Array
    offset: Array
    reach: Array

    @staticmethod
    def of(a: Boxes, b: Boxes) -> Pair:
        """How two sets of boxes lie to each other, row by row."""
        c, s = np.abs(a.cos * b.cos + a.sin * b.sin), np.abs(a.cos * b.sin - a.sin * b.cos)
        axis_x, axis_y = np.array((a.cos, -a.sin, b.cos, -b.sin)), np.array((a.sin, a.cos, b.sin, b.cos))
        reach = np.array(
            (
                a.half_length + b.half_length * c + b.half_width * s,
                a.half_width + b.half_length * s + b.half_width * c,
                b.half_length + a.half_length * c + a.half_width * s,
                b.half_width + a.half_length * s + a.half_width * c,
            )
        )
        return Pair(axis_x, axis_y, (b.x - a.x) * axis_x + (b.y - a.y) * axis_y, reach)

    @property
    def touching(self) -> NDArray[np.bool_]:
        """(…) Whether the boxes overlap: whether they do on all four axes."""
        return np.asarray((np.abs(self.offset) <= self.reach).all(axis=0))

    def overlap(self, vx: Array, vy: Array) -> tuple[Array, Array]:
        """(4, …) When the boxes begin and cease to overlap on each axis, the second moving past the first.

        In units of time of the velocity, from now on; from -inf to inf where they always overlap, and from inf to
        inf where they never will.
        """
        speed = vx * self.axis_x + vy * self.axis_y
        still = np.abs(speed) < NOTHING
        rate = np.where(still, 1.0, speed)
        first, last = (-self.reach - self.offset) / rate, (self.reach - self.offset) / rate
        always = np.where(np.abs(self.offset) <= self.reach, -np.inf, np.inf)
        return np.where(still, always, np.minimum(first, last)), np.where(still, np.inf, np.maximum(first, last))


@lru_cache(maxsize=KEPT)
def pair_of(a: Track, b: Track) -> Pair:
    """How two bodies lie to each other at every step."""
    return Pair.of(Boxes.of(a), Boxes.of(b))


def _fixed(array: Array) -> Array:
    """An array that is given out more than once."""
    array.setflags(write=False)
    return array


@lru_cache(maxsize=KEPT)
def times_to_collision(ego: Track, other: Track) -> Array:
    """(T,) Time [s] until the boxes touch if both keep velocity and heading; inf where they never would."""
    a, b = Boxes.of(ego), Boxes.of(other)
    enter, leave = pair_of(ego, other).overlap(
        other.speed * b.cos - ego.speed * a.cos, other.speed * b.sin - ego.speed * a.sin
    )
    begin, end = enter.max(axis=0), leave.min(axis=0)
    meets = (begin <= end) & (end >= 0.0)
    return _fixed(np.where(meets, np.maximum(begin, 0.0), np.inf))


def post_encroachment(ego: Track, other: Track) -> float:
    """Least time [steps] between one leaving a place and the other coming to it; inf where they share none.

    That is the least |s - t| for which the ego's box at s overlaps the other's at t. Whole steps tell it up to two too
    long; around those found, the ego's step is cut into parts, and the other moves on straight and evenly in its own.
    """
    b = Boxes.of(other)
    i, j = overlaps(Boxes.of(ego), b)
    if not i.size:
        return math.inf
    apart = np.abs(i - j)
    least = apart.min()
    if least == 0:
        return 0.0
    near = apart <= least + 1
    i, j, apart = i[near], j[near], apart[near]
    toward = np.sign(j - i)
    parts = np.arange(FINENESS + 1)[:, None]
    moments = i * FINENESS + toward * parts
    back = j - toward
    pair = Pair.of(Boxes.of(ego, FINENESS).at(moments), b.at(np.broadcast_to(j, moments.shape)))
    enter, leave = pair.overlap(b.x[back] - b.x[j], b.y[back] - b.y[j])
    begin, end = enter.max(axis=0), leave.min(axis=0)
    meets = (begin <= end) & (begin <= 1.0) & (end >= 0.0)
    closest = apart - parts / FINENESS - np.minimum(end, 1.0)
    return max(float(closest[meets].min(initial=least)), 0.0)


def _at_all_near(a: Boxes, b: Boxes, reach: float) -> Steps:
    """The moments of the first at which it is so near [m] to the rectangle that the centres of the second span."""
    (low_x, high_x), (low_y, high_y) = ((np.nanmin(ends), np.nanmax(ends)) for ends in (b.x, b.y))
    within_x = (a.x >= low_x - reach) & (a.x <= high_x + reach)
    return np.flatnonzero(within_x & (a.y >= low_y - reach) & (a.y <= high_y + reach))


def overlaps(a: Boxes, b: Boxes) -> tuple[Steps, Steps]:
    """All pairs of moments of which the first's box at the one overlaps the second's at the other."""
    reach = math.hypot(a.half_length, a.half_width) + math.hypot(b.half_length, b.half_width) + ROUNDING
    ones, others = _at_all_near(a, b, reach), _at_all_near(b, a, reach)
    dx, dy = np.subtract.outer(a.x[ones], b.x[others]), np.subtract.outer(a.y[ones], b.y[others])
    near = np.flatnonzero(dx * dx + dy * dy <= reach * reach)
    i, j = np.divmod(near, max(len(others), 1))
    i, j = ones[i], others[j]
    touching = Pair.of(a.at(i), b.at(j)).touching
    return i[touching], j[touching]


@lru_cache(maxsize=KEPT)
def gaps(ego: Track, other: Track) -> Array:
    """(T,) Gap [m] between the boxes; 0 where they overlap."""
    a, b = Boxes.of(ego), Boxes.of(other)
    # Between two convex shapes that are apart, a corner of one of them is nearest.
    apart = np.minimum(_corner_gaps(a, b), _corner_gaps(b, a))
    return _fixed(np.where(pair_of(ego, other).touching, 0.0, apart))


def least_gap(ego: Track, other: Track) -> float:
    """Least gap [m] between the boxes over all steps."""
    return float(gaps(ego, other).min())


def _corner_gaps(a: Boxes, b: Boxes) -> Array:
    """(T,) Least distance [m] from a corner of the first box to the second box."""
    along = a.half_length * np.array((1.0, 1.0, -1.0, -1.0))[:, None]
    across = a.half_width * np.array((1.0, -1.0, -1.0, 1.0))[:, None]
    dx, dy = a.x + along * a.cos - across * a.sin - b.x, a.y + along * a.sin + across * a.cos - b.y
    beyond_x = np.maximum(np.abs(dx * b.cos + dy * b.sin) - b.half_length, 0.0)
    beyond_y = np.maximum(np.abs(dy * b.cos - dx * b.sin) - b.half_width, 0.0)
    return np.asarray(np.hypot(beyond_x, beyond_y).min(axis=0))
