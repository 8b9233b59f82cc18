"""A driver by rule that looks ahead: it tries ways of going on against what everybody near may do next.

At each step it weighs some accelerations and sideways shifts over four seconds, in coordinates along its route. No
shift leads off the driving lanes. Everybody near is expected to go on, and with less weight to brake, to speed up, to
keep straight where the route bends or, where they stand beside the way, to step into it. The way that costs least is
begun. It remembers nothing, so that it can be learned from (`chatscene.learn.finetune.pupil`).

Its numbers are those of any machine: arrays are only added, multiplied, compared and rooted, sums go through them in
the order of time or of who is expected, and angles are Python's own. So `engine.c` gives the same.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from chatscene.ego.intelligent_driver import CAR, curve_speed, pressed
from chatscene.ego.observation import AHEAD, OWN, PER_ACTOR, ROAD, Observation
from chatscene.terms.actors import Limits

DT = 0.2  # [s]
TIMES = np.arange(1, 21) * DT
_ACCELERATIONS = (-8.0, -5.0, -3.0, -1.5, 0.0, 1.5, 3.0)  # [m/s²]
_SHIFTS = (0.0, 1.2, -1.2, 2.4, -2.4, 3.6, -3.6)  # [m, positive = left of the route]
ACCELERATION = np.repeat(_ACCELERATIONS, len(_SHIFTS))  # of each way
SHIFT = np.tile(_SHIFTS, len(_ACCELERATIONS))
MOVING, WAITING = 0.5, 1.5  # [m/s]: from here on somebody may brake or speed up; up to here, step into the way
BESIDE, NEAR = 1.6, 8.0  # [m] from the route: who stands between these may step into it
REACTION = 0.3  # [s] before somebody who stands sets out
ACROSS = 0.5  # sine of the angle to the route from which on somebody crosses it
FASTEST = 12.0  # [m/s] up to which others are expected to speed up
AT_ONCE = 1.6  # [m] of a shift that is steered for at once
SHORTEST = 5.0  # [m] ahead that is steered for

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True, kw_only=True)
class Caution:
    """What the ways are weighed by.

    Found by CMA-ES over drives on kept scenes of routes that train (decision 0023): crashes, and half as much what was
    not completed.

    Attributes:
        speed: Wanted speed [m/s].
        crash: What a crash costs for each m/s of its impact …
        graze: … beside so many m/s that every crash has.
        patience: After so many seconds a crash that is expected weighs less by e [s].
        braking: Deceleration that others may begin with [m/s²], and what that is believed.
        starting: Acceleration, likewise.
        stepping: Speed at which somebody who stands may set out for the route [m/s], and what that is believed.
        crossing: What is believed of somebody who crosses the route: that he keeps straight where the route bends.
        room: Kept free ahead and behind [m].
        side: Kept free beside [m] …
        widening: … and so much more for each second ahead [m/s].
        berth: Beyond that, room that is better not passed fast [m] …
        haste: … and what each metre in it costs.
        offset: What a second costs one metre beside the route, growing with the square.
        astray: What each metre beyond two costs besides.
        jerk: What acceleration costs, growing with the square.
        resolve: What each metre sideways costs.
        agility: Sideways speed for each m/s ahead.
        drift: Largest sideways speed [m/s].
    """

    speed: float = 4.8
    crash: float = 22.0
    graze: float = 0.09
    patience: float = 1.44
    braking: tuple[float, float] = (4.6, 0.81)
    starting: tuple[float, float] = (0.91, 0.23)
    stepping: tuple[float, float] = (1.26, 0.17)
    crossing: float = 0.0
    room: float = 0.85
    side: float = 0.25
    widening: float = 0.07
    berth: float = 1.04
    haste: float = 1.19
    offset: float = 0.052
    astray: float = 0.15
    jerk: float = 0.023
    resolve: float = 0.12
    agility: float = 0.88
    drift: float = 1.34


HARDENED = Caution(
    speed=7.63, crash=11.3, graze=0.0781, patience=1.71, braking=(5.57, 0.205), starting=(0.721, 0.946),
    stepping=(1.53, 0.0311), crossing=1.0, room=2.23, side=0.0765, widening=0.223, berth=0.533, haste=8.47,
    offset=0.0429, astray=0.118, jerk=0.0655, resolve=0.109, agility=0.99, drift=1.79,
)  # fmt: skip
"""Found by CMA-ES against adversaries that were searched for again after each round (decision 0106), but for
`crossing`, which came after (decision 0110)."""


@dataclass(frozen=True, slots=True, eq=False)
class _Others:
    """What everybody near may do: (H,) expectations, the first six (T, H) over time, in route coordinates.

    Attributes:
        along: Ahead of where the ego is now [m].
        beside: Left of the route [m].
        speed_along: [m/s].
        speed_beside: [m/s].
        half_along: Half the extent along the route [m].
        half_beside: Half the extent across it [m].
        now_along: Where they are now.
        now_beside: Where they are now.
        moves: 1 for those who move now.
        belief: What each expectation counts.
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


class Planner:
    """Looks four seconds ahead, on the preset ``road``, with the whole brake pedal.

    Args:
        caution: What its ways are weighed by.
        name: How it is called in tables.
        body: What the vehicle can do that it drives.

    Attributes:
        caution: As it was given.
        body: As it was given.
        discount: (T,) what a crash that is expected then counts.
    """

    observation = "road"
    pedals = "full-brake"

    def __init__(self, caution: Caution | None = None, *, name: str = "planner", body: Limits = CAR) -> None:
        self.name, self.body = name, body
        self._acceleration = np.minimum(np.maximum(ACCELERATION, -body.brake), body.throttle)  # of each way
        self._gain = TIMES[:, None] * self._acceleration  # [m/s]
        self.caution = caution or Caution()
        self.discount = np.array([math.exp(-time / self.caution.patience) for time in TIMES.tolist()])

    def wanting(self, speed: float) -> Planner:
        """The same driver with another wanted speed [m/s]."""
        return Planner(replace(self.caution, speed=speed), name=self.name, body=self.body)

    def driving(self, body: Limits) -> Planner:
        """The same driver in another vehicle."""
        return Planner(self.caution, name=self.name, body=body)

    def act(self, observation: Observation) -> tuple[float, float]:
        """Acceleration and steering in [-1, 1] for one step."""
        return carried_out(observation, self.choose(observation), self.caution.speed, self.body)

    def choose(self, observation: Observation) -> int:
        """The way that costs least, an index into `ACCELERATION` and `SHIFT`."""
        c = self.caution
        speed, offset = float(observation[0]), float(observation[1])
        wish = min(c.speed, curve_speed(observation[4:OWN].reshape(-1, 2)))
        speeds = np.minimum(np.maximum(speed + self._gain, 0.0), max(wish, speed - 3.0 * DT))  # (T, ways)
        gone = speeds.cumsum(axis=0) * DT
        reach = np.minimum(c.drift, c.agility * speeds).cumsum(axis=0) * DT
        shift = _shifts(observation, self.body)
        beside = offset + np.minimum(np.maximum(shift - offset, -reach), reach)
        cost = c.jerk * (self._acceleration * self._acceleration) - gone[-1] + c.resolve * np.abs(shift - offset)
        off = c.offset * (beside * beside) + c.astray * np.maximum(np.abs(beside) - 2.0, 0.0)
        cost += np.add.reduce(off, axis=0) * DT
        rows = observation[OWN:ROAD].reshape(-1, PER_ACTOR)
        if len(rows := rows[rows[:, 0] > 0.0]):
            cost += self._danger(self._others(observation, rows), offset, speeds, gone, beside)
        return int(cost.argmin())

    def _others(self, observation: Observation, rows: Array) -> _Others:
        caution, count = self.caution, len(rows)
        points = observation[4:OWN].reshape(-1, 2).tolist()
        told = np.array([_along_the_route(points, row) for row in rows.tolist()]).T
        along, beside, ds, db, speed, half_along, half_beside = told
        moving = speed > MOVING
        waiting = (speed < WAITING) & (np.abs(beside) > BESIDE) & (np.abs(beside) < NEAR) & (along > -2.0)
        # Five expectations of everybody: to go on, to brake, to speed up, to step into the way, to keep straight.
        crossing = moving & (np.abs(db) > ACROSS * speed)
        belief = np.empty((5, count))
        belief[0], belief[1] = 1.0, caution.braking[1] * moving
        belief[2], belief[3] = caution.starting[1] * moving, caution.stepping[1] * waiting
        belief[4] = caution.crossing * crossing
        times = TIMES[:, None]
        fast = np.empty((len(TIMES), 4, count))
        fast[:, 0] = speed
        fast[:, 1] = np.maximum(speed - caution.braking[0] * times, 0.0)
        fast[:, 2] = np.minimum(speed + caution.starting[0] * times, np.maximum(speed, FASTEST))
        fast[:, 3] = caution.stepping[0] * (times > REACTION)
        heading = np.empty((2, 4, count))
        heading[:, :3] = (np.array((ds, db)) / np.maximum(speed, 0.1))[:, None]
        heading[0, 3], heading[1, 3] = 0.0, -np.sign(beside)
        kind, who = (belief[:4] > 0.0).nonzero()
        speed_along, speed_beside = heading[:, None, kind, who] * fast[:, kind, who]
        ways = [
            along[who] + speed_along.cumsum(axis=0) * DT,
            beside[who] + speed_beside.cumsum(axis=0) * DT,
            speed_along,
            speed_beside,
            *(np.broadcast_to(half[who], speed_along.shape) for half in (half_along, half_beside)),
        ]
        if (straight := (belief[4] > 0.0).nonzero()[0]).size:
            kept = _straight(points, rows[straight], along[straight], beside[straight])
            ways = [np.concatenate(both, axis=1) for both in zip(ways, kept, strict=True)]
            who, kind = np.concatenate((who, straight)), np.concatenate((kind, np.full(len(straight), 4)))
        return _Others(*ways, now_along=along[who], now_beside=beside[who], moves=moving[who], belief=belief[kind, who])

    def _danger(self, others: _Others, offset: float, speeds: Array, gone: Array, beside: Array) -> Array:
        """(ways,) what the crashes cost that each way may come to, and passing by too near."""
        c, body = self.caution, self.body
        along, across = body.length / 2 + others.half_along, body.width / 2 + others.half_beside  # (T, H)
        # Who is nearer than we want already is not to stop us from moving away.
        apart, aside = np.abs(others.now_along) - along[0], np.abs(others.now_beside - offset) - across[0]
        room = np.where(aside < c.side + 0.2, np.minimum(np.maximum(apart - 0.1, 0.05), c.room), c.room)
        side = np.where(apart < c.room + 0.2, np.minimum(np.maximum(aside - 0.05, 0.05), c.side), c.side)
        gap = np.abs(others.along[:, :, None] - gone[:, None]) - along[:, :, None]  # (T, H, ways)
        berth = np.abs(others.beside[:, :, None] - beside[:, None]) - across[:, :, None]
        hits = (gap < room[:, None]) & (berth < (side + (c.widening * TIMES)[:, None] * others.moves)[:, :, None])
        first = hits.argmax(axis=0)
        one, way = np.arange(len(others.belief))[:, None], np.arange(len(SHIFT))
        ahead, sideways = speeds[first, way] - others.speed_along[first, one], others.speed_beside[first, one]
        impact = np.sqrt(ahead * ahead + sideways * sideways)
        crash = np.where(hits.any(axis=0), c.crash * self.discount[first] * (c.graze + impact), 0.0)
        close = (gap < c.room + 0.5) & (berth < c.side + c.berth)
        haste = c.haste * np.add.reduce(close * speeds[:, None], axis=0) * DT
        return np.add.reduce((crash + haste) * others.belief[:, None], axis=0)


def hardened() -> Planner:
    """The driver that was hardened against its own adversaries."""
    return Planner(HARDENED, name="hardened")


def carried_out(observation: Observation, way: int, at_most: float, body: Limits = CAR) -> tuple[float, float]:
    """Acceleration and steering in [-1, 1] of one step of a way.

    Args:
        observation: The preset ``road``, or ``actors``, which has no edge of the road.
        way: Index into `ACCELERATION` and `SHIFT`.
        at_most: The speed that is not to be exceeded [m/s]; curves may allow less.
        body: What the vehicle can do.
    """
    speed, offset = float(observation[0]), float(observation[1])
    wish = min(at_most, curve_speed(observation[4:OWN].reshape(-1, 2)))
    acceleration = min(max(float(ACCELERATION[way]), -body.brake), body.throttle)
    if acceleration >= 0.0 and speed >= wish - 0.05:
        acceleration = max(-3.0, 2.0 * (wish - speed))
    pedal = pressed(acceleration, body)
    shift = offset + max(-AT_ONCE, min(AT_ONCE, float(_shifts(observation, body)[way]) - offset))
    return max(-1.0, min(1.0, pedal)), _steering(observation, speed, shift)


def _shifts(observation: Observation, body: Limits) -> Array:
    """(ways,) where each way leads beside the route [m]: with the whole body on the driving lanes, if they are seen."""
    if len(observation) <= ROAD:
        return SHIFT
    left, right = np.maximum(observation[ROAD:] - body.width / 2, 0.0)
    return np.minimum(np.maximum(SHIFT, -right), left)


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


def _straight(points: list[list[float]], rows: Array, along: Array, beside: Array) -> tuple[Array, ...]:
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
    gone = np.array((0.0, *AHEAD[:-1]))[piece] + foot[at]
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


def _steering(observation: Observation, speed: float, shift: float) -> float:
    """Pure pursuit of a point ahead, `shift` [m] left of the route, as a car's wheel turns there (`controls`)."""
    look = max(SHORTEST, 0.9 * speed)
    xs, ys = observation[4:OWN:2].tolist(), observation[5:OWN:2].tolist()
    way = math.atan2(ys[1] - ys[0], xs[1] - xs[0])
    x = _between(look, xs) - math.sin(way) * shift
    y = _between(look, ys) + math.cos(way) * shift
    wheel = math.atan(CAR.wheelbase * 2.0 * y / max(x * x + y * y, 1.0))
    return max(-1.0, min(1.0, -wheel / CAR.wheel_angle / 0.3))


def _between(ahead: float, values: list[float]) -> float:
    """A value so far ahead [m], of those at `AHEAD`; beyond the last, that."""
    i = sum(point <= ahead for point in AHEAD) - 1
    if i == len(AHEAD) - 1:
        return values[i]
    return (values[i + 1] - values[i]) / (AHEAD[i + 1] - AHEAD[i]) * (ahead - AHEAD[i]) + values[i]
