"""The boxes of two bodies over time: when they overlap, how far they are apart, and when they would touch."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.simulate.native.engine import boxes_of, reach_squared
from chatscene.simulate.native.lines import engine
from chatscene.terms.arrays import Array, fixed
from chatscene.terms.episode import Track

Steps = NDArray[np.int64]

NOTHING = 1e-9  # [m] or [m/s], what rounding makes of nothing
KEPT = 16  # of the tracks and pairs that were asked for last, what was found: each measure of a drive asks anew
CRAWL = 0.1  # [m/s], below this somebody follows nobody
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
    @lru_cache(maxsize=4 * KEPT)
    def of(track: Track) -> Boxes:
        """At every step."""
        x, y, cos, sin = map(fixed, (track.x, track.y, np.cos(track.heading), np.sin(track.heading)))
        return Boxes(x, y, cos, sin, track.length / 2, track.width / 2)

    @staticmethod
    def within(track: Track, moments: Array) -> Boxes:
        """At moments between steps, in steps."""
        rows = np.arange(len(track.x))
        x, y, heading = (np.interp(moments, rows, values) for values in (track.x, track.y, track.heading))
        return Boxes(x, y, np.cos(heading), np.sin(heading), track.length / 2, track.width / 2)

    def at(self, moments: Steps | int | slice) -> Boxes:
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


@dataclass(frozen=True, slots=True, eq=False)
class Between:
    """How two bodies lie to each other at each step, (T,) each; see `between`.

    Attributes:
        gaps: Between the boxes [m]; 0 where they overlap.
        times: Until the boxes touch if both keep velocity and heading [s]; inf where they never would.
        ahead: From the front of the first to the nearest of what is ahead of the second [m]; -inf if nothing is.
        closing: How fast the first closes in on the second along its own heading [m/s].
        least: The least gap [m].
        nearest: The first step at which it is that.
        soonest: The least time until they touch [s].
        headway: The least time [s] in which the first is where the second is ahead, if it is faster than `CRAWL`.
        braking: The hardest braking [m/s²] that keeps the first from the second ahead; 0 where none is needed.
    """

    gaps: Array
    times: Array
    ahead: Array
    closing: Array
    least: float
    nearest: int
    soonest: float
    headway: float
    braking: float


@lru_cache(maxsize=KEPT)
def between(ego: Track, other: Track) -> Between:
    """How another lies to the ego at every step.

    It is ahead in the corridor as wide as the ego, straight on from its front. The engine works it out where there is
    one.
    """
    a, b = Boxes.of(ego), Boxes.of(other)
    native = engine()
    if native is None:
        return in_numpy(a, b, ego.speed, other.speed)
    found, told = native.between(_told(a), ego.speed, _told(b), other.speed, CRAWL)
    gaps, times, ahead, closing = fixed(found)
    least, nearest, soonest, headway, braking = told
    return Between(gaps, times, ahead, closing, least, int(nearest), soonest, headway, braking)


def in_numpy(a: Boxes, b: Boxes, speed: Array, other_speed: Array) -> Between:
    """What `between` finds, without the engine."""
    pair = Pair.of(a, b)
    enter, leave = pair.overlap(other_speed * b.cos - speed * a.cos, other_speed * b.sin - speed * a.sin)
    begin, end = enter.max(axis=0), leave.min(axis=0)
    meets = (begin <= end) & (end >= 0.0)
    # Between two convex shapes that are apart, a corner of one of them is nearest.
    apart = np.minimum(_corner_gaps(a, b), _corner_gaps(b, a))
    along, across = pair.offset[:2]
    c, turned = a.cos * b.cos + a.sin * b.sin, a.cos * b.sin - a.sin * b.cos
    s = np.abs(turned)
    beside = np.abs(across) - a.half_width - b.half_length * s - b.half_width * np.abs(c)
    gap = along - a.half_length - b.half_length * np.abs(c) - b.half_width * s + _beyond_corner(a, b, across, c, turned)
    gaps, times = np.where(pair.touching, 0.0, apart), np.where(meets, np.maximum(begin, 0.0), np.inf)
    ahead, closing = np.where((gap > 0.0) & (beside < 0.0), gap, -np.inf), speed - other_speed * c
    follows = (ahead > 0.0) & (speed > CRAWL)
    nears = (ahead > 0.0) & (closing > NOTHING)
    return Between(
        gaps=fixed(gaps),
        times=fixed(times),
        ahead=fixed(ahead),
        closing=fixed(closing),
        least=float(gaps.min()),
        nearest=int(gaps.argmin()),
        soonest=float(times.min()),
        headway=float((ahead[follows] / speed[follows]).min(initial=math.inf)),
        braking=float((closing[nears] ** 2 / (2.0 * ahead[nears])).max(initial=0.0)),
    )


def _beyond_corner(a: Boxes, b: Boxes, across: Array, c: Array, s: Array) -> Array:
    """(T,) How much farther than its nearest corner the part of the second is that lies in the corridor [m].

    That corner may lie beside the corridor. Then the edge from it into the corridor is nearest where it enters.

    Args:
        a: The first, whose corridor it is.
        b: The second.
        across: How far to the left of the first its centre is [m].
        c: Cosine of its heading seen from the first.
        s: Sine of it.
    """
    alike = (c < 0.0) == (s < 0.0)
    c, s = np.abs(c), np.abs(s)
    offset = b.half_width * c - b.half_length * s
    corner = across + np.where(alike, offset, -offset)
    out = np.abs(corner) - a.half_width
    short = (corner > 0.0) == alike  # whether the edge into the corridor is one of the two as long as it is wide
    deep = 2.0 * np.where(short, b.half_width * s, b.half_length * c)
    wide = 2.0 * np.where(short, b.half_width * c, b.half_length * s)
    share = np.divide(out, wide, out=np.ones_like(out), where=(out > 0.0) & (wide > out))
    return np.where(out > 0.0, deep * share, 0.0)


@lru_cache(maxsize=KEPT)
def _told(boxes: Boxes) -> Any:
    """Boxes in the engine's terms."""
    return boxes_of(boxes.x, boxes.y, boxes.cos, boxes.sin, boxes.half_length, boxes.half_width)


def times_to_collision(ego: Track, other: Track) -> Array:
    """(T,) Time [s] until the boxes touch if both keep velocity and heading; inf where they never would."""
    return between(ego, other).times


def post_encroachment(ego: Track, other: Track) -> float:
    """Least time [steps] between one leaving a place and the other coming to it; inf where they share none.

    That is the least |s - t| for which the ego's box at s overlaps the other's at t. Whole steps tell it up to two too
    long; around those found, the ego's step is cut into parts, and the other moves on straight and evenly in its own.
    `chatscene.measure.sums` has the same from the engine.
    """
    b = Boxes.of(other)
    i, j = overlaps(Boxes.of(ego), b, np.arange(len(other.x)), max(len(ego.x), len(other.x)))
    if not i.size:
        return math.inf
    apart = np.abs(i - j)
    least = apart.min()
    if least == 0:
        return 0.0
    toward = np.sign(j - i)
    parts = np.arange(FINENESS + 1)[:, None]
    moments = i * FINENESS + toward * parts
    mine = Boxes.within(ego, moments / FINENESS)
    back = j - toward
    pair = Pair.of(mine, b.at(np.broadcast_to(j, moments.shape)))
    enter, leave = pair.overlap(b.x[back] - b.x[j], b.y[back] - b.y[j])
    begin, end = enter.max(axis=0), leave.min(axis=0)
    meets = (begin <= end) & (begin <= 1.0) & (end >= 0.0)
    closest = apart - parts / FINENESS - np.minimum(end, 1.0)
    return max(float(closest[meets].min(initial=least)), 0.0)


def overlaps(a: Boxes, b: Boxes, at: Steps, most: int) -> tuple[Steps, Steps]:
    """Where two sets of boxes overlap: all pairs of those nearest in time, and of those one step farther.

    The engine finds them where there is one. The pairs come in any order.

    Args:
        a: One, (T,) at a step each, or (K, T) if it may be in several places; a place may be nowhere (nan).
        b: The other, (N,).
        at: (N,) The step at which each of these is there.
        most: How many steps may lie between the two.

    Returns:
        The numbers of those of `a`, row after row, and of those of `b`.
    """
    width = a.x.shape[-1]
    native = engine()
    if native is not None:
        return native.overlaps(_told(a), (a.x.size // max(width, 1), width), _told(b), at, most, _square(a, b))
    rows = Boxes(a.x.ravel(), a.y.ravel(), a.cos.ravel(), a.sin.ravel(), a.half_length, a.half_width)
    found, least = [(at[:0], at[:0])], most
    for lag in range(most + 1):
        if lag > least + 1:
            break
        found += [_overlaps_at(rows, width, b, at, by) for by in sorted({-lag, lag})]
        if found[-1][0].size or found[-2][0].size:
            least = min(least, lag)
    i, j = zip(*found, strict=True)
    return np.concatenate(i), np.concatenate(j)


def _square(a: Boxes, b: Boxes) -> float:
    """Of how far [m] the centres of boxes that overlap are from each other at most."""
    return reach_squared((a.half_length, a.half_width), (b.half_length, b.half_width))


def _overlaps_at(a: Boxes, width: int, b: Boxes, at: Steps, lag: int) -> tuple[Steps, Steps]:
    """The pairs of which the first is so many steps later."""
    there = np.flatnonzero((at + lag >= 0) & (at + lag < width))
    steps = np.arange(0, a.x.size, width)[:, None] + at[there] + lag
    i, j = steps.ravel(), np.broadcast_to(there, steps.shape).ravel()
    touching = Pair.of(a.at(i), b.at(j)).touching
    return i[touching], j[touching]


def near_any(x: Array, y: Array, other_x: Array, other_y: Array, within: float) -> NDArray[np.bool_]:
    """(N,) Whether each point [m] is nearer than that [m] to any of others; by the engine, where there is one."""
    native = engine()
    if native is not None:
        return native.near_any(x, y, other_x, other_y, within)
    dx, dy = np.subtract.outer(x, other_x), np.subtract.outer(y, other_y)
    return np.asarray((dx * dx + dy * dy < within**2).any(axis=1))


def gaps(ego: Track, other: Track) -> Array:
    """(T,) Gap [m] between the boxes; 0 where they overlap."""
    return between(ego, other).gaps


def least_gap(ego: Track, other: Track) -> float:
    """Least gap [m] between the boxes over all steps."""
    return between(ego, other).least


def _corner_gaps(a: Boxes, b: Boxes) -> Array:
    """(T,) Least distance [m] from a corner of the first box to the second box."""
    along = a.half_length * np.array((1.0, 1.0, -1.0, -1.0))[:, None]
    across = a.half_width * np.array((1.0, -1.0, -1.0, 1.0))[:, None]
    dx, dy = a.x + along * a.cos - across * a.sin - b.x, a.y + along * a.sin + across * a.cos - b.y
    beyond_x = np.maximum(np.abs(dx * b.cos + dy * b.sin) - b.half_length, 0.0)
    beyond_y = np.maximum(np.abs(dy * b.cos - dx * b.sin) - b.half_width, 0.0)
    return np.asarray(np.hypot(beyond_x, beyond_y).min(axis=0))
