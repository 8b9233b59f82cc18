"""How close a drive came to harm, and who ran into whom; `docs/criticality.md` has each measure's definition.

All measures compare the ego with each adversary, over all steps at once, and keep the worst.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from chatscene.terms.criticality import Criticality, Fault, Severity
from chatscene.terms.episode import Array, Episode, Role, Track

CORRIDOR = 0.0  # [m] beside the bodies: who overlaps sideways is in the way
CELL = 0.5  # [m], how finely the area both pass through is looked at
STILL = 0.05  # [m], who moved less than this over a drive never moved
ON_FOOT = ("Pedestrian", "Bicycle")
# Upper ends [m/s] of S0, S1, S2 by impact speed; decision 0012.
SEVERITY_VULNERABLE = (2.8, 8.3, 13.9)
SEVERITY_VEHICLE = (2.8, 5.6, 11.1)


def criticality(episode: Episode) -> Criticality:
    """The measures of a drive; None where one does not apply."""
    ego, others = episode.ego_track, episode.adversaries
    crash = episode.collision
    headway, braking = zip(*(_following(ego, other) for other in others), strict=True) if others else ((), ())
    return Criticality(
        time_to_collision=_least(_time_to_collision(ego, other) for other in others),
        post_encroachment_time=None
        if crash is not None
        else _least(_post_encroachment(ego, other, episode.dt) for other in others),
        time_headway=_least(headway),
        deceleration_required=_most(braking),
        distance=_least(_distance(ego, other) for other in others),
        impact_speed=None if crash is None else crash.impact_speed,
        severity=None if crash is None else _severity(crash.impact_speed, _struck(episode, crash.other)),
    )


def fault(episode: Episode) -> Fault | None:
    """Whose own motion closed the gap at the moment of contact; None without a collision.

    The one whose velocity, in the step before, had the larger part toward the other along the line of contact, the
    direction in which the boxes overlap least. A thing, or whoever never moved, was run into.
    """
    crash = episode.collision
    if crash is None:
        return None
    ego, other = episode.ego_track, _struck(episode, crash.other)
    if other.role is Role.OCCLUDER or np.ptp(other.x) + np.ptp(other.y) < STILL:
        return Fault.EGO_INTO_STATIC
    before = max(crash.step - 1, 0)
    nx, ny = _normal(ego, other, crash.step)
    own = ego.speed[before] * (math.cos(ego.heading[before]) * nx + math.sin(ego.heading[before]) * ny)
    theirs = -other.speed[before] * (math.cos(other.heading[before]) * nx + math.sin(other.heading[before]) * ny)
    adversary = other.role is Role.ADVERSARY
    if own >= theirs:
        return Fault.EGO_INTO_ADVERSARY if adversary else Fault.EGO_INTO_BACKGROUND
    return Fault.ADVERSARY_INTO_EGO if adversary else Fault.BACKGROUND_INTO_EGO


def _struck(episode: Episode, name: str) -> Track:
    return next(track for track in episode.tracks if track.actor == name)


def _severity(speed: float, other: Track) -> Severity:
    ends = SEVERITY_VULNERABLE if other.kind in ON_FOOT else SEVERITY_VEHICLE
    return list(Severity)[sum(speed > end for end in ends)]


def _least(values: Iterable[float]) -> float | None:
    """The smallest finite value, or None if there is none."""
    return min((value for value in values if math.isfinite(value)), default=None)


def _most(values: Iterable[float]) -> float | None:
    return max((value for value in values if math.isfinite(value) and value > 0.0), default=None)


def _frames(a: Track, b: Track) -> tuple[list[tuple[Array, Array]], list[Array]]:
    """The four axes on which two boxes can be apart, and how near their centres are there when they touch."""
    ca, sa, cb, sb = np.cos(a.heading), np.sin(a.heading), np.cos(b.heading), np.sin(b.heading)
    c, s = np.abs(ca * cb + sa * sb), np.abs(ca * sb - sa * cb)
    al, aw, bl, bw = a.length / 2, a.width / 2, b.length / 2, b.width / 2
    axes = [(ca, sa), (-sa, ca), (cb, sb), (-sb, cb)]
    reach = [al + bl * c + bw * s, aw + bl * s + bw * c, bl + al * c + aw * s, bw + al * s + aw * c]
    return axes, reach


def _velocity(track: Track) -> tuple[Array, Array]:
    return track.speed * np.cos(track.heading), track.speed * np.sin(track.heading)


def _time_to_collision(a: Track, b: Track) -> float:
    """The least time [s], over all steps, until the boxes touch if both go on as they do; inf if they never would."""
    axes, reach = _frames(a, b)
    (avx, avy), (bvx, bvy) = _velocity(a), _velocity(b)
    dx, dy, vx, vy = b.x - a.x, b.y - a.y, bvx - avx, bvy - avy
    enter, leave = np.full(len(dx), -np.inf), np.full(len(dx), np.inf)
    for (ax, ay), near in zip(axes, reach, strict=True):
        d, v = dx * ax + dy * ay, vx * ax + vy * ay
        still = np.abs(v) < 1e-9
        rate = np.where(still, 1.0, v)
        first, last = (-near - d) / rate, (near - d) / rate
        apart = np.abs(d) > near
        enter = np.maximum(enter, np.where(still, np.where(apart, np.inf, -np.inf), np.minimum(first, last)))
        leave = np.minimum(leave, np.where(still, np.inf, np.maximum(first, last)))
    meets = (enter <= leave) & (leave >= 0.0)
    return float(np.where(meets, np.maximum(enter, 0.0), np.inf).min())


def _distance(a: Track, b: Track) -> float:
    """The least distance [m] between the boxes over all steps."""
    best = np.full(len(a.x), np.inf)
    for one, two in ((a, b), (b, a)):
        px, py = _corners(one)
        c, s = np.cos(two.heading)[:, None], np.sin(two.heading)[:, None]
        dx, dy = px - two.x[:, None], py - two.y[:, None]
        beyond_x = np.maximum(np.abs(dx * c + dy * s) - two.length / 2, 0.0)
        beyond_y = np.maximum(np.abs(dy * c - dx * s) - two.width / 2, 0.0)
        best = np.minimum(best, np.hypot(beyond_x, beyond_y).min(axis=1))
    axes, reach = _frames(a, b)
    gaps = [np.abs((b.x - a.x) * ax + (b.y - a.y) * ay) - near for (ax, ay), near in zip(axes, reach, strict=True)]
    return float(np.where(np.max(gaps, axis=0) <= 0.0, 0.0, best).min())


def _corners(track: Track) -> tuple[Array, Array]:
    """The corners of a track's box, (T, 4) each."""
    c, s = np.cos(track.heading)[:, None], np.sin(track.heading)[:, None]
    along = track.length / 2 * np.array((1.0, 1.0, -1.0, -1.0))
    across = track.width / 2 * np.array((1.0, -1.0, -1.0, 1.0))
    return track.x[:, None] + along * c - across * s, track.y[:, None] + along * s + across * c


def _following(ego: Track, other: Track) -> tuple[float, float]:
    """The least time headway [s] and the largest deceleration required [m/s²] behind an adversary ahead.

    Ahead: its box overlaps the ego's sideways, in the ego's frame, and it is in front. The gap is from bumper to
    bumper; the headway is from the ego's front to its rear.
    """
    c, s = np.cos(ego.heading), np.sin(ego.heading)
    dx, dy = other.x - ego.x, other.y - ego.y
    along, across = dx * c + dy * s, dy * c - dx * s
    turned = other.heading - ego.heading
    half_length = np.abs(np.cos(turned)) * other.length / 2 + np.abs(np.sin(turned)) * other.width / 2
    half_width = np.abs(np.sin(turned)) * other.length / 2 + np.abs(np.cos(turned)) * other.width / 2
    gap = along - half_length - ego.length / 2
    ahead = (gap > 0.0) & (np.abs(across) < half_width + ego.width / 2 + CORRIDOR)
    if not ahead.any():
        return math.inf, -math.inf
    speed, closing = ego.speed[ahead], ego.speed[ahead] - (other.speed * np.cos(turned))[ahead]
    room = gap[ahead]
    headway = np.where(speed > 0.1, room / np.maximum(speed, 0.1), np.inf)
    braking = np.where(closing > 0.0, closing**2 / (2.0 * room), -np.inf)
    return float(headway.min()), float(braking.max())


def _post_encroachment(a: Track, b: Track, dt: float) -> float:
    """The least time [s] between one leaving a place and the other coming to it; inf where they share none."""
    first_a, last_a = _presence(a)
    first_b, last_b = _presence(b)
    shared = first_a.keys() & first_b.keys()
    between = (max(first_b[cell] - last_a[cell], first_a[cell] - last_b[cell]) for cell in shared)
    return min((steps * dt for steps in between if steps > 0), default=math.inf)


def _presence(track: Track) -> tuple[dict[int, int], dict[int, int]]:
    """The first and the last step at which a body covers each cell of a grid; cells as single numbers."""
    if np.ptp(track.x) + np.ptp(track.y) < STILL:
        return {}, {}  # who stands encroaches on nothing: the measure is for ways that cross
    along = np.linspace(-0.5, 0.5, max(2, math.ceil(track.length / CELL) + 1)) * track.length
    across = np.linspace(-0.5, 0.5, max(2, math.ceil(track.width / CELL) + 1)) * track.width
    u, v = (grid.ravel() for grid in np.meshgrid(along, across))
    c, s = np.cos(track.heading)[:, None], np.sin(track.heading)[:, None]
    column = np.floor((track.x[:, None] + u * c - v * s) / CELL).astype(np.int64)
    row = np.floor((track.y[:, None] + u * s + v * c) / CELL).astype(np.int64)
    cells: NDArray[np.int64] = (column * 1_000_003 + row).ravel()
    steps = np.repeat(np.arange(len(track.x)), len(u))
    kinds, first = np.unique(cells, return_index=True)
    _, from_end = np.unique(cells[::-1], return_index=True)
    last = len(cells) - 1 - from_end
    return dict(zip(kinds.tolist(), steps[first].tolist(), strict=True)), dict(
        zip(kinds.tolist(), steps[last].tolist(), strict=True)
    )


def _normal(ego: Track, other: Track, step: int) -> tuple[float, float]:
    """The direction from the ego to the other along which their boxes overlap least at a step, as a unit vector."""
    axes, reach = _frames(ego, other)
    dx, dy = float(other.x[step] - ego.x[step]), float(other.y[step] - ego.y[step])
    depth = [
        (float(near[step]) - abs(dx * float(ax[step]) + dy * float(ay[step])), i)
        for i, ((ax, ay), near) in enumerate(zip(axes, reach, strict=True))
    ]
    ax, ay = (float(part[step]) for part in axes[min(depth)[1]])
    return (ax, ay) if dx * ax + dy * ay >= 0.0 else (-ax, -ay)
