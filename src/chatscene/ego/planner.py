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
from dataclasses import replace

import numpy as np

from chatscene.ego import at_speed
from chatscene.ego.at_speed import slower, softness_of, steered
from chatscene.ego.caution import HARDENED, HARDENED_AT_SPEED, Caution
from chatscene.ego.expectations import DT, MOVING, TIMES, Array, Others, expected
from chatscene.ego.intelligent_driver import CAR, curve_speed, pressed
from chatscene.ego.observation import AHEAD, ALLOWED, OWN, PER_ACTOR, ROAD, Observation, scale_of
from chatscene.terms.actors import Limits

_ACCELERATIONS = (-8.0, -5.0, -3.0, -1.5, 0.0, 1.5, 3.0)  # [m/s²]
_SHIFTS = (0.0, 1.2, -1.2, 2.4, -2.4, 3.6, -3.6)  # [m, positive = left of the route]
ACCELERATION = np.repeat(_ACCELERATIONS, len(_SHIFTS))  # of each way
SHIFT = np.tile(_SHIFTS, len(_ACCELERATIONS))
AT_ONCE = 1.6  # [m] of a shift that is steered for at once
SHORTEST = 5.0  # [m] ahead that is steered for
KEPT = 0.8  # [m] beside the route up to which a car is in its lane
STRAYS = 80.0  # times as much each metre beyond that costs, for each time that it is faster than what is usual
LANE = 1.75  # [m] from the middle of a lane to its edge
LEFT = 4.0  # [m/s²] that may be needed, at the end of what is looked at, to stop behind somebody


class Planner:
    """Looks four seconds ahead, on the preset ``road``, with the whole brake pedal.

    Of one of which a speed is wanted the preset is ``traffic``. It drives no faster than is allowed, counts on no more
    than its engine gives at that speed, and is where a way ends to be able to stop behind somebody with `LEFT` m/s².
    A way on which it speeds up does so for one step and then keeps its speed, since it looks again by then: else what
    another may do in four seconds would keep it slower than whom it follows.

    Args:
        caution: What its ways are weighed by.
        name: How it is called in tables.
        body: What the vehicle can do that it drives.
        wants: The speed that is wanted of it [m/s]; None where nothing is, and its caution has its speed.
        swift: What its ways are weighed by where a speed is wanted; None for the same as else.

    Attributes:
        caution: What its ways are weighed by, with the speed that is wanted.
        discount: (T,) what a crash that is expected then counts.
    """

    pedals = "full-brake"

    def __init__(
        self,
        caution: Caution | None = None,
        *,
        name: str = "planner",
        body: Limits = CAR,
        wants: float | None = None,
        swift: Caution | None = None,
    ) -> None:
        self.name, self.body, self.wants = name, body, wants
        self._usual, self._swift = caution or Caution(), swift
        self.observation = "road" if wants is None else "traffic"
        self._acceleration = np.minimum(np.maximum(ACCELERATION, -body.brake), body.throttle)  # of each way
        self.caution = self._usual if wants is None else replace(swift or self._usual, speed=wants)
        self.discount = np.array([math.exp(-time / self.caution.patience) for time in TIMES.tolist()])

    def wanting(self, speed: float) -> Planner:
        """The same driver with another wanted speed [m/s]."""
        return Planner(self._usual, name=self.name, body=self.body, wants=speed, swift=self._swift)

    def driving(self, body: Limits) -> Planner:
        """The same driver in another vehicle."""
        return Planner(self._usual, name=self.name, body=body, wants=self.wants, swift=self._swift)

    def act(self, observation: Observation) -> tuple[float, float]:
        """Acceleration and steering in [-1, 1] for one step."""
        return carried_out(observation, self.choose(observation), self.caution.speed, self.body)

    def choose(self, observation: Observation) -> int:
        """The way that costs least, an index into `ACCELERATION` and `SHIFT`."""
        return int(self.costs(observation).argmin())

    def costs(self, observation: Observation) -> Array:
        """What each way costs, (ways,)."""
        c, swift = self.caution, self.wants is not None
        speed, offset = float(observation[0]), float(observation[1])
        k, acceleration = scale_of(speed) if swift else 1.0, self._acceleration
        if swift:
            acceleration = np.minimum(acceleration, at_speed.able(speed, self.body))
        wish = _wish(observation, c.speed)
        times = TIMES[:, None]
        if swift:
            times = np.where(acceleration > 0.0, DT, times)
        speeds = np.maximum(speed + times * acceleration, 0.0)
        speeds = np.minimum(speeds, max(wish, speed - 3.0 * DT))  # (T, ways)
        gone = speeds.cumsum(axis=0) * DT
        reach = np.minimum(c.drift, c.agility * speeds).cumsum(axis=0) * DT
        shift = _shifts(observation, self.body)
        beside = offset + np.minimum(np.maximum(shift - offset, -reach), reach)
        cost = c.jerk * (acceleration * acceleration) - gone[-1] + c.resolve * np.abs(shift - offset)
        off = c.offset * (beside * beside) + c.astray * np.maximum(np.abs(beside) - 2.0, 0.0)
        if swift:
            fast = scale_of(wish) if _led(observation) else k
            off += (STRAYS * c.astray * (fast - 1.0)) * np.maximum(np.abs(beside) - KEPT, 0.0)
        cost += np.add.reduce(off, axis=0) * DT
        if (others := expected(observation, c, self.body, k, at_speed=swift)) is not None:
            danger, lost = self._danger(others, offset, speeds, gone, beside)
            cost += danger
            if swift:
                cost += lost
        return cost

    def _danger(self, others: Others, offset: float, speeds: Array, gone: Array, beside: Array) -> tuple[Array, Array]:
        """(ways,) what the crashes cost that each way may come to, and passing by too near; what is not driven then."""
        c, body = self.caution, self.body
        along, across = body.length / 2 + others.half_along, body.width / 2 + others.half_beside  # (T, H)
        # Who is nearer than we want already is not to stop us from moving away.
        apart, aside = np.abs(others.now_along) - along[0], np.abs(others.now_beside - offset) - across[0]
        room = np.where(aside < c.side + 0.2, np.minimum(np.maximum(apart - 0.1, 0.05), c.room), c.room)
        side = np.where(apart < c.room + 0.2, np.minimum(np.maximum(aside - 0.05, 0.05), c.side), c.side)
        ahead = others.along[:, :, None] - gone[:, None]
        gap = np.abs(ahead) - along[:, :, None]  # (T, H, ways)
        berth = np.abs(others.beside[:, :, None] - beside[:, None]) - across[:, :, None]
        near, passing = gap < room[:, None], speeds[:, None]
        if self.wants is not None:
            closing = speeds[:, None] - others.speed_along[:, :, None]
            nearly = 1.0 - np.maximum(berth, 0.0) / (c.side + c.berth)  # less, the more room there is
            passing = np.abs(closing) * nearly
            stops = np.maximum(closing[-1], 0.0)
            stops = (stops * stops) / (2.0 * LEFT)
            near[-1] |= (ahead[-1] > 0.0) & others.stays[:, None] & (gap[-1] < room[:, None] + stops)
        hits = near & (berth < (side + (c.widening * TIMES)[:, None] * others.moves)[:, :, None])
        first = hits.argmax(axis=0)
        one, way = np.arange(len(others.belief))[:, None], np.arange(len(SHIFT))
        ahead, sideways = speeds[first, way] - others.speed_along[first, one], others.speed_beside[first, one]
        impact = np.sqrt(ahead * ahead + sideways * sideways)
        hit = hits.any(axis=0)
        crash = np.where(hit, c.crash * self.discount[first] * (c.graze + impact), 0.0)
        close = (gap < c.room + 0.5) & (berth < c.side + c.berth)
        haste = c.haste * np.add.reduce(close * passing, axis=0) * DT
        lost = np.where(hit & others.surely[:, None], gone[-1] - gone[first, way], 0.0).max(axis=0, initial=0.0)
        return np.add.reduce((crash + haste) * others.belief[:, None], axis=0), lost


def hardened() -> Planner:
    """The driver that was hardened against its own adversaries."""
    return Planner(HARDENED, name="hardened", swift=HARDENED_AT_SPEED)


def carried_out(observation: Observation, way: int, at_most: float, body: Limits = CAR) -> tuple[float, float]:
    """Acceleration and steering in [-1, 1] of one step of a way.

    Args:
        observation: The preset ``road`` or ``traffic``, or ``actors``, which has no edge of the road.
        way: Index into `ACCELERATION` and `SHIFT`.
        at_most: The speed that is not to be exceeded [m/s]; curves may allow less.
        body: What the vehicle can do.
    """
    speed, offset = float(observation[0]), float(observation[1])
    wish = _wish(observation, at_most)
    acceleration = min(max(float(ACCELERATION[way]), -body.brake), body.throttle)
    shift = float(_shifts(observation, body)[way])
    if len(observation) > ALLOWED:
        if acceleration >= 0.0:
            acceleration = min(acceleration, slower(speed, wish))
        pedal = at_speed.pressed(acceleration, speed, body)
        return pedal, steered(observation, shift, softness_of(body))
    if acceleration >= 0.0 and speed >= wish - 0.05:
        acceleration = max(-3.0, 2.0 * (wish - speed))
    pedal = pressed(acceleration, body)
    shift = offset + max(-AT_ONCE, min(AT_ONCE, shift - offset))
    return max(-1.0, min(1.0, pedal)), _steering(observation, speed, shift)


def _wish(observation: Observation, at_most: float) -> float:
    """The speed [m/s] that is driven where nobody is: what is wanted, and no more than the road allows."""
    if len(observation) > ALLOWED:
        return min(at_most, float(observation[ALLOWED]))
    return min(at_most, curve_speed(observation[4:OWN].reshape(-1, 2)))


def _led(observation: Observation) -> bool:
    """Whether somebody drives ahead in our lane: to overtake him takes longer than we see, at the speed we would go."""
    rows = observation[OWN:ROAD].reshape(-1, PER_ACTOR)
    return bool(((rows[:, 1] > 0.0) & (np.abs(rows[:, 2]) < LANE) & (rows[:, 5] > MOVING)).any())


def _shifts(observation: Observation, body: Limits) -> Array:
    """(ways,) where each way leads beside the route [m]: with the whole body on the driving lanes, if they are seen."""
    if len(observation) <= ROAD:
        return SHIFT
    left, right = np.maximum(observation[ROAD:ALLOWED] - body.width / 2, 0.0)
    return np.minimum(np.maximum(SHIFT, -right), left)


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
