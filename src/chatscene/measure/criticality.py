"""How close a drive came to harm, and who ran into whom; `docs/criticality.md` has each measure's definition.

All measures compare the ego with each adversary, over all steps at once, and keep the worst. Bodies are their boxes.
None of it depends on where the scene lies or which way it is turned.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from chatscene.simulate.contact import contact_side
from chatscene.terms.actors import BY_CLASS, LIMITS
from chatscene.terms.criticality import Criticality, Fault, Severity
from chatscene.terms.episode import Array, Episode, Event, Role, Track
from chatscene.world.bodies import Body

Steps = NDArray[np.intp]

STILL = 0.05  # [m], who moved less than this until contact never moved
CRAWL = 0.1  # [m/s], below this an ego follows nobody
NOTHING = 1e-9  # [m] or [m/s], what rounding makes of nothing
FINENESS = 4  # into how many parts a step is cut to time who leaves and who comes
# Above which impact speed [m/s] S1, S2 and S3 begin; decision 0012 has the sources.
SEVERITY_VULNERABLE = (0.0, 29 / 3.6, 10.8)
SEVERITY_OCCUPANT = (7 / 3.6, 35 / 3.6, 52.5 / 3.6)


def criticality(episode: Episode) -> Criticality:
    """The measures of a drive; None where one does not apply."""
    ego, others, crash = episode.ego_track, episode.adversaries, episode.collision
    following = [_following(ego, other) for other in others]
    return Criticality(
        time_to_collision=_least(float(times_to_collision(ego, other).min()) for other in others),
        post_encroachment_time=_least(_post_encroachment(ego, other) * episode.dt for other in others),
        time_headway=_least(headway for headway, _ in following),
        deceleration_required=max((braking for _, braking in following if braking > 0.0), default=None),
        distance=_least(least_gap(ego, other) for other in others),
        impact_speed=None if crash is None else crash.impact_speed,
        severity=None if crash is None else severity_of(crash.impact_speed, _struck(episode, crash)),
    )


def fault(episode: Episode) -> Fault | None:
    """Who struck whom in the first collision of a drive; None without one.

    The line of contact is the normal of the side at which the boxes met in the step that ended in contact. Whoever
    moved farther along it toward the other in that step ran into the other; if both did alike, the ego did. A thing,
    or whoever had not moved until then, was run into.
    """
    crash = episode.collision
    if crash is None:
        return None
    ego, other = episode.ego_track, _struck(episode, crash)
    until = slice(0, crash.step + 1)
    moved = np.hypot(other.x[until] - other.x[0], other.y[until] - other.y[0]).max()
    if other.role is Role.OCCLUDER or moved < STILL:
        return Fault.EGO_INTO_STATIC
    adversary = other.role is Role.ADVERSARY
    if _ego_strikes(ego, other, crash.step):
        return Fault.EGO_INTO_ADVERSARY if adversary else Fault.EGO_INTO_BACKGROUND
    return Fault.ADVERSARY_INTO_EGO if adversary else Fault.BACKGROUND_INTO_EGO


def part_struck(track: Track, by: Track, step: int) -> str:
    """Where on a vehicle another one touches it at a step: ``front``, ``rear``, ``left`` or ``right``; else empty."""
    if track.kind not in LIMITS or not LIMITS[track.kind].wheelbase:
        return ""
    return contact_side(_posed(track, step), _posed(by, step))


def _posed(track: Track, step: int) -> Body:
    pose = float(track.x[step]), float(track.y[step]), float(track.heading[step])
    return Body(*pose, track.length, track.width)


def _ego_strikes(ego: Track, other: Track, step: int) -> bool:
    """Whether the ego moved at least as far toward the other as the other toward it, in the step before `step`."""
    before = max(step - 1, 0)
    mine = np.array((ego.x[step] - ego.x[before], ego.y[step] - ego.y[before]))
    theirs = np.array((other.x[step] - other.x[before], other.y[step] - other.y[before]))
    pair = _Pair.of(_Boxes.of(ego).at(before), _Boxes.of(other).at(before))
    # The boxes met on the axis on which they were apart for longest.
    enter, _ = pair.overlap(*(theirs - mine))
    axis = int(np.argmax(enter))
    normal = np.array((pair.axis_x[axis], pair.axis_y[axis])) * math.copysign(1.0, pair.offset[axis])
    return bool(mine @ normal >= -theirs @ normal - NOTHING)


def _struck(episode: Episode, crash: Event) -> Track:
    return next(track for track in episode.tracks if track.actor == crash.other)


def severity_of(speed: float, other: Track) -> Severity:
    """The class of injury that an impact speed [m/s] stands for, where the ego meets that road user or thing."""
    kind = BY_CLASS.get(other.kind)
    begins = SEVERITY_VULNERABLE if kind and kind.is_vulnerable else SEVERITY_OCCUPANT
    return list(Severity)[sum(speed > begin for begin in begins)]


def _least(values: Iterable[float]) -> float | None:
    return min((value for value in values if math.isfinite(value)), default=None)


@dataclass(frozen=True, slots=True, eq=False)
class _Boxes:
    """The boxes of one body at some moments; arrays of one shape, and half its sizes [m]."""

    x: Array
    y: Array
    cos: Array
    sin: Array
    half_length: float
    half_width: float

    @staticmethod
    def of(track: Track, parts: int = 1) -> _Boxes:
        """At every step, and at as many moments between two steps as make `parts` of it."""
        x, y, heading = track.x, track.y, track.heading
        if parts > 1:
            rows = np.arange(len(x))
            moments = np.arange((len(x) - 1) * parts + 1) / parts
            x, y, heading = (np.interp(moments, rows, values) for values in (x, y, heading))
        return _Boxes(x, y, np.cos(heading), np.sin(heading), track.length / 2, track.width / 2)

    def at(self, moments: Steps | int) -> _Boxes:
        """At some of them."""
        return _Boxes(
            self.x[moments],
            self.y[moments],
            self.cos[moments],
            self.sin[moments],
            self.half_length,
            self.half_width,
        )


@dataclass(frozen=True, slots=True, eq=False)
class _Pair:
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
    def of(a: _Boxes, b: _Boxes) -> _Pair:
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
        return _Pair(axis_x, axis_y, (b.x - a.x) * axis_x + (b.y - a.y) * axis_y, reach)

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


def times_to_collision(ego: Track, other: Track) -> Array:
    """(T,) Time [s] until the boxes touch if both keep velocity and heading; inf where they never would."""
    a, b = _Boxes.of(ego), _Boxes.of(other)
    enter, leave = _Pair.of(a, b).overlap(
        other.speed * b.cos - ego.speed * a.cos, other.speed * b.sin - ego.speed * a.sin
    )
    begin, end = enter.max(axis=0), leave.min(axis=0)
    meets = (begin <= end) & (end >= 0.0)
    return np.where(meets, np.maximum(begin, 0.0), np.inf)


def _post_encroachment(ego: Track, other: Track) -> float:
    """Least time [steps] between one leaving a place and the other coming to it; inf where they share none.

    That is the least |s - t| for which the ego's box at s overlaps the other's at t. Whole steps tell it up to two too
    long; around those found, the ego's step is cut into parts, and the other moves on straight and evenly in its own.
    """
    b = _Boxes.of(other)
    i, j = _overlaps(_Boxes.of(ego), b)
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
    pair = _Pair.of(_Boxes.of(ego, FINENESS).at(moments), b.at(np.broadcast_to(j, moments.shape)))
    enter, leave = pair.overlap(b.x[back] - b.x[j], b.y[back] - b.y[j])
    begin, end = enter.max(axis=0), leave.min(axis=0)
    meets = (begin <= end) & (begin <= 1.0) & (end >= 0.0)
    closest = apart - parts / FINENESS - np.minimum(end, 1.0)
    return max(float(closest[meets].min(initial=least)), 0.0)


def _overlaps(a: _Boxes, b: _Boxes) -> tuple[Steps, Steps]:
    """All pairs of moments of which the first's box at the one overlaps the second's at the other."""
    reach = math.hypot(a.half_length, a.half_width) + math.hypot(b.half_length, b.half_width)
    near = np.flatnonzero(np.abs(np.subtract.outer(a.x + 1j * a.y, b.x + 1j * b.y)) <= reach)
    i, j = np.divmod(near, len(b.x))
    touching = _Pair.of(a.at(i), b.at(j)).touching
    return i[touching], j[touching]


def gaps(ego: Track, other: Track) -> Array:
    """(T,) Gap [m] between the boxes; 0 where they overlap."""
    a, b = _Boxes.of(ego), _Boxes.of(other)
    # Between two convex shapes that are apart, a corner of one of them is nearest.
    apart = np.minimum(_corner_gaps(a, b), _corner_gaps(b, a))
    return np.where(_Pair.of(a, b).touching, 0.0, apart)


def least_gap(ego: Track, other: Track) -> float:
    """Least gap [m] between the boxes over all steps."""
    return float(gaps(ego, other).min())


def _corner_gaps(a: _Boxes, b: _Boxes) -> Array:
    """(T,) Least distance [m] from a corner of the first box to the second box."""
    along = a.half_length * np.array((1.0, 1.0, -1.0, -1.0))[:, None]
    across = a.half_width * np.array((1.0, -1.0, -1.0, 1.0))[:, None]
    dx, dy = a.x + along * a.cos - across * a.sin - b.x, a.y + along * a.sin + across * a.cos - b.y
    beyond_x = np.maximum(np.abs(dx * b.cos + dy * b.sin) - b.half_length, 0.0)
    beyond_y = np.maximum(np.abs(dy * b.cos - dx * b.sin) - b.half_width, 0.0)
    return np.asarray(np.hypot(beyond_x, beyond_y).min(axis=0))


def _following(ego: Track, other: Track) -> tuple[float, float]:
    """Least time headway [s] and greatest deceleration required [m/s²] behind another ahead; inf and 0 without.

    Ahead: in the corridor as wide as the ego, straight on from its front. The gap is from its front to what of the
    other is nearest.
    """
    a, b = _Boxes.of(ego), _Boxes.of(other)
    along, across = _Pair.of(a, b).offset[:2]
    c, s = a.cos * b.cos + a.sin * b.sin, np.abs(a.cos * b.sin - a.sin * b.cos)
    gap = along - a.half_length - b.half_length * np.abs(c) - b.half_width * s
    beside = np.abs(across) - a.half_width - b.half_length * s - b.half_width * np.abs(c)
    ahead = (gap > 0.0) & (beside < 0.0)
    gap, speed, closing = gap[ahead], ego.speed[ahead], (ego.speed - other.speed * c)[ahead]
    moves = speed > CRAWL
    headway = gap[moves] / speed[moves]
    braking = np.where(closing > NOTHING, closing, 0.0) ** 2 / (2.0 * gap)
    return float(headway.min(initial=math.inf)), float(braking.max(initial=0.0))
