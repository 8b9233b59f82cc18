"""What everybody near may do next, in coordinates along a route: what the driver that looks ahead expects of others."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from chatscene.ego.at_speed import bends, other
from chatscene.ego.caution import Caution
from chatscene.ego.observation import AHEAD, OWN, PER_ACTOR, ROAD, Observation
from chatscene.terms.actors import Limits

DT = 0.2  # [s]
TIMES = np.arange(1, 21) * DT
MOVING, WAITING = 0.5, 1.5  # [m/s]: from here on somebody may brake or speed up; up to here, step into the way
BESIDE, NEAR = 1.6, 8.0  # [m] from the route: who stands between these may step into it
REACTION = 0.3  # [s] before somebody who stands sets out
ACROSS = 0.5  # sine of the angle to the route from which on somebody crosses it
FASTEST = 12.0  # [m/s] up to which others are expected to speed up
GOES_ON, BRAKES, SPEEDS_UP, STEPS_IN, KEEPS_STRAIGHT = range(5)

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, eq=False)
class Others:
    """What everybody near may do: (H,) expectations, the first six (T, H) over time, in route coordinates.

    Attributes:
        along: Ahead of where the ego is now [m].
        beside: Left of the route [m].
        speed_along: [m/s].
        speed_beside: [m/s].
        half_along: Half the extent along the route [m].
        half_beside: Half the extent across it [m].
        moves: 1 for those who move now.
        surely: Whether it is that somebody goes on.
        stays: Whether it is that somebody goes on in our way or beside it, and does not cross it.
    """

    along: Array
    beside: Array
    speed_along: Array
    speed_beside: Array
    half_along: Array
    half_beside: Array
    now_along: Array
    now_beside: Array
    moves: Array
    belief: Array
    surely: NDArray[np.bool_]
    stays: NDArray[np.bool_]


def expected(observation: Observation, caution: Caution, body: Limits, k: float, *, at_speed: bool) -> Others | None:
    """What everybody near may do; None where nobody is."""
    rows = observation[OWN:ROAD].reshape(-1, PER_ACTOR)
    if not (count := len(rows := rows[rows[:, 0] > 0.0])):
        return None
    points = observation[4:OWN].reshape(-1, 2).tolist()
    if at_speed:
        way = bends(observation, k)
        told = np.array([_at_speed(row, k, *way) for row in rows.tolist()]).T
    else:
        told = np.array([_along_the_route(points, row) for row in rows.tolist()]).T
    along, beside, ds, db, speed, half_along, half_beside = told
    moving = speed > MOVING
    waiting = (speed < WAITING) & (np.abs(beside) > BESIDE) & (np.abs(beside) < NEAR) & (along > -2.0)
    crossing = moving & (np.abs(db) > ACROSS * speed)
    belief = np.empty((5, count))
    belief[GOES_ON], belief[BRAKES] = 1.0, caution.braking[1] * moving
    belief[SPEEDS_UP], belief[STEPS_IN] = caution.starting[1] * moving, caution.stepping[1] * waiting
    belief[KEEPS_STRAIGHT] = caution.crossing * crossing
    if at_speed:
        aside = np.abs(beside - observation[1])
        follows = (ds > 0.0) & (along < -(half_along + body.length / 2)) & (aside < half_beside + body.width / 2)
        belief[STEPS_IN] *= rows[:, 10]
        belief *= ~follows
    times = TIMES[:, None]
    fast = np.empty((len(TIMES), 4, count))
    fast[:, GOES_ON] = speed
    fast[:, BRAKES] = np.maximum(speed - caution.braking[0] * times, 0.0)
    fast[:, SPEEDS_UP] = np.minimum(speed + caution.starting[0] * times, np.maximum(speed, FASTEST))
    fast[:, STEPS_IN] = caution.stepping[0] * (times > REACTION)
    heading = np.empty((2, 4, count))
    heading[:, :3] = (np.array((ds, db)) / np.maximum(speed, 0.1))[:, None]
    heading[0, STEPS_IN], heading[1, STEPS_IN] = 0.0, -np.sign(beside)
    kind, who = (belief[:4] > 0.0).nonzero()
    speed_along, speed_beside = heading[:, None, kind, who] * fast[:, kind, who]
    ways = [
        along[who] + speed_along.cumsum(axis=0) * DT,
        beside[who] + speed_beside.cumsum(axis=0) * DT,
        speed_along,
        speed_beside,
        *(np.broadcast_to(half[who], speed_along.shape) for half in (half_along, half_beside)),
    ]
    if (straight := (belief[KEEPS_STRAIGHT] > 0.0).nonzero()[0]).size:
        kept = _straight(points, rows[straight], along[straight], beside[straight], k)
        ways = [np.concatenate(both, axis=1) for both in zip(ways, kept, strict=True)]
        who = np.concatenate((who, straight))
        kind = np.concatenate((kind, np.full(len(straight), KEEPS_STRAIGHT)))
    return Others(
        *ways,
        now_along=along[who],
        now_beside=beside[who],
        moves=moving[who],
        belief=belief[kind, who],
        surely=kind == GOES_ON,
        stays=(kind == GOES_ON) & ~crossing[who],
    )


def _at_speed(row: list[float], k: float, middles: list[float], bearings: list[float]) -> tuple[float, ...]:
    """As `_along_the_route`, of the preset ``traffic``."""
    o = other(row, k, middles, bearings)
    return o.along, o.beside, o.ds, o.db, math.hypot(o.ds, o.db), o.half_along, o.half_beside


def _along_the_route(points: list[list[float]], row: list[float]) -> tuple[float, ...]:
    """Where somebody is and how fast, along the route and beside it, his speed, and half his extent in both."""
    _, along, beside, _, _, vx, vy, turned, half_length, half_width, _ = row
    at = min(max(sum(point < along for point in (0.0, *AHEAD)) - 1, 0), len(points) - 1)
    (x, y), (before_x, before_y) = points[at], points[at - 1] if at else (0.0, 0.0)
    way = math.atan2(y - before_y, x - before_x)  # where the route leads beside him
    ahead, left = math.cos(way), math.sin(way)
    ds, db = vx * ahead + vy * left, vy * ahead - vx * left
    c, s = abs(math.cos(turned - way)), abs(math.sin(turned - way))
    return along, beside, ds, db, math.hypot(ds, db), half_length * c + half_width * s, half_length * s + half_width * c


def _straight(points: list[list[float]], rows: Array, along: Array, beside: Array, k: float) -> tuple[Array, ...]:
    """Who keeps straight in the plane, in coordinates of the route: (T, N) where, how fast, and half the extents."""
    starts = [[0.0, 0.0], *points[:-1]]
    bearings = [math.atan2(y - b, x - a) for (a, b), (x, y) in zip(starts, points, strict=True)]
    c, s = (np.array([f(way) for way in bearings])[:, None, None] for f in (math.cos, math.sin))
    x0, y0 = np.array(starts).T[:, :, None, None]
    x1, y1 = np.array(points).T[:, :, None, None]
    length = (x1 - x0) * c + (y1 - y0) * s
    length[-1] = math.inf
    least = np.zeros_like(length)
    least[0] = -math.inf
    x, y, vx, vy = rows[:, 3:7].T
    times = np.concatenate(([0.0], TIMES))[:, None]
    dx, dy = x + vx * times - x0, y + vy * times - y0  # (pieces of the route, 1 + T, N)
    ahead, left = dx * c + dy * s, dy * c - dx * s
    foot = np.minimum(np.maximum(ahead, least), length)
    beyond = ahead - foot
    away = beyond * beyond + left * left
    piece = away.argmin(axis=0)
    at = (piece, *np.indices(piece.shape))
    gone = np.array((0.0, *(ahead * k for ahead in AHEAD[:-1])))[piece] + foot[at]
    aside = np.where(left[at] < 0.0, -1.0, 1.0) * np.sqrt(away[at])
    c, s = c[piece[1:], 0, 0], s[piece[1:], 0, 0]
    cos, sin = np.array([(math.cos(turned), math.sin(turned)) for turned in rows[:, 7].tolist()]).T
    turned_c, turned_s = np.abs(cos * c + sin * s), np.abs(sin * c - cos * s)
    half_length, half_width = rows[:, 8], rows[:, 9]
    return (
        along + (gone[1:] - gone[0]),
        beside + (aside[1:] - aside[0]),
        vx * c + vy * s,
        vy * c - vx * s,
        half_length * turned_c + half_width * turned_s,
        half_length * turned_s + half_width * turned_c,
    )
