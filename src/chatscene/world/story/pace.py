"""How fast those in a story go: the longitudinal half of what a story tells somebody to do.

('speed', shape, dimension, amount, target)      target: ('to', m/s), ('delta' or 'factor', whom, value, for good)
('profile', whom or '', for times, ((s, m/s), …), acceleration)
('distance', whom, m or s, 'm' or 's', side, freespace, for good, (top, speeding up, slowing down))
('meet', whom, its place, own place, final)      final: None or (target, steady m, steady s)
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any, Protocol

from chatscene.world.story.conditions import World
from chatscene.world.story.entities import Entity, along, offset

_LATE = 5.0  # [s] after which a change of speed that a body cannot follow counts as over
_NEAR = 0.2  # [m/s] and [m]
_PULLS = 0.5  # [1/s] with which a distance is corrected


class Pace(Protocol):
    """Says how fast somebody is to be."""

    done: bool

    def speed(self, dt: float) -> float:
        """The speed [m/s] that it is to have after the next step."""
        ...


class Steady:
    """Keeps a speed."""

    def __init__(self, speed: float) -> None:
        self.done = True
        self._speed = speed

    def speed(self, dt: float) -> float:
        """The same."""
        del dt
        return self._speed


class Waits:
    """Takes some time, whoever drives meanwhile."""

    def __init__(self, world: World, seconds: float) -> None:
        self._world, self._until = world, world.time + seconds
        self.done = False

    def passes(self) -> bool:
        """Whether the time has passed."""
        self.done = self._world.time >= self._until - 1e-9
        return self.done

    def speed(self, dt: float) -> float:
        """Nobody's."""
        del dt
        return 0.0


def shaped(shape: str, share: float) -> float:
    """How much of a change is done after a share of its time, by its shape."""
    u = min(max(share, 0.0), 1.0)
    if shape == "step":
        return 1.0
    if shape == "cubic":
        return u * u * (3.0 - 2.0 * u)
    return 0.5 * (1.0 - math.cos(math.pi * u)) if shape == "sinusoidal" else u


STEEPEST = {"cubic": 1.5, "sinusoidal": math.pi / 2}  # of a change by its shape, times its mean


def target_of(told: tuple[Any, ...], world: World) -> Any:
    """What speed is meant, to be asked [m/s], and whether that is so for good."""
    if told[0] == "to":
        return (lambda: told[1]), False
    kind, whom, value, continuous = told
    other = world.entity(whom)
    return (lambda: other.speed + value if kind == "delta" else other.speed * value), bool(continuous)


class Change:
    """Brings a speed to another within a time, over a distance or at a rate; a step is held for as long as is told."""

    def __init__(self, who: Entity, world: World, shape: str, dimension: str, amount: float, target: Any) -> None:
        self._who, self._world = who, world
        self._target, self._for_good = target_of(target, world)
        self._shape = shape
        self._from, self._began, self._at = who.speed, world.time, who.travelled
        self._holds, self._in_metres = (abs(amount) if shape == "step" else 0.0), dimension == "distance"
        change, mean = abs(self._target() - self._from), abs(self._target() + self._from) / 2
        amount = abs(amount)
        if shape == "step" or amount == 0.0:
            self._lasts, self._shape = 0.0, "step"
        elif dimension == "rate":
            self._lasts = change / amount * STEEPEST.get(shape, 1.0)
        else:
            self._lasts = amount if dimension == "time" else amount / max(mean, 0.1)
        self.done = False

    def speed(self, dt: float) -> float:
        """Where the change has come to."""
        since = self._world.time + dt - self._began
        share = since / self._lasts if self._lasts > 0.0 else 1.0
        wish = self._target()
        now = self._from + (wish - self._from) * shaped(self._shape, share)
        reached = share >= 1.0 and (abs(self._who.speed - wish) < _NEAR or since > self._lasts + _LATE)
        held = self._who.travelled - self._at if self._in_metres else since
        self.done = reached and not self._for_good and held >= self._holds
        return now


class Profile:
    """Goes through speeds that are told with their times, each reached from the one before."""

    def __init__(self, who: Entity, world: World, entries: Any, most: float, base: Entity | None) -> None:
        self._world, self._began, self._base = world, world.time, base
        self._points: list[tuple[float, float]] = [(0.0, who.speed - (base.speed if base else 0.0))]
        for time, speed in entries:
            at, before = self._points[-1]
            lasts = time if time > 0.0 else abs(speed - before) / most
            self._points.append((at + lasts, speed))
        self.done = False

    def speed(self, dt: float) -> float:
        """Where it has come to."""
        since = self._world.time + dt - self._began
        self.done = since >= self._points[-1][0]
        own = self._base.speed if self._base else 0.0
        for (t0, v0), (t1, v1) in pairwise(self._points):
            if since < t1:
                return own + v0 + (v1 - v0) * (since - t0) / max(t1 - t0, 1e-9)
        return own + self._points[-1][1]


class Distance:
    """Keeps a distance to somebody along its way, or comes to it."""

    def __init__(self, who: Entity, other: Entity, told: tuple[Any, ...]) -> None:
        self._who, self._other = who, other
        self._amount, self._unit, side, self._freespace, self._for_good, self._limits = told
        ahead, _ = offset(who, other, "road")
        self._side = side or (1.0 if ahead <= 0.0 else -1.0)
        self.done = False

    def speed(self, dt: float) -> float:
        """The other's, corrected by how far off the distance is."""
        who, other = self._who, self._other
        ahead, _ = offset(who, other, "road", of_centres=self._freespace)
        room = (who.agent.length + other.agent.length) / 2 if self._freespace else 0.0
        want = (
            self._amount if self._unit == "m" else self._amount * max(other.speed if self._side > 0 else who.speed, 0.0)
        )
        off = self._side * (want + room) + ahead  # how far on it has still to come
        top, up, down = self._limits
        self.done = not self._for_good and abs(off) < _NEAR
        wish = other.speed + math.copysign(min(_PULLS * abs(off), math.sqrt(2.0 * min(up, down, 3.0) * abs(off))), off)
        return min(max(wish, 0.0, who.speed - down * dt), top, who.speed + up * dt)


class Meeting:
    """Comes to a place when another comes to its place, at a speed that is told, if one is."""

    def __init__(self, who: Entity, other: Entity, world: World, told: tuple[Any, ...]) -> None:
        theirs, ours, final = told
        self._who, self._other = who, other
        self._ours, self._theirs = world.place(ours), world.place(theirs)
        self._final = target_of(final[0], world)[0] if final else None
        self._steady = final[1:] if final else (0.0, 0.0)
        self._kept = who.speed
        self.done = False

    def speed(self, dt: float) -> float:
        """The speed from which a constant acceleration leads there in time."""
        left, theirs = _left(self._who, self._ours.pose()), _left(self._other, self._theirs.pose())
        pace = self._other.speed
        if left <= _NEAR or theirs <= _NEAR:
            self.done = True
            self._kept = self._final() if self._final and left > _NEAR else self._kept
            return self._kept
        if pace < 0.1:
            return self._kept
        time = theirs / pace
        if self._final is None:
            self._kept = left / time
            return self._kept
        final = max(self._final(), 0.1)
        steady = max(self._steady[0], self._steady[1] * final)
        left, time = left - steady, time - steady / final
        if left <= 0.0 or time <= dt:
            self._kept = final
            return final
        now = max(2.0 * left / time - final, 0.0)  # with which a steady change of speed to the last one takes the time
        self._kept = now + (final - now) * dt / time if now > 0.0 else 0.0
        return self._kept


def _left(who: Entity, place: tuple[float, ...]) -> float:
    """How far somebody still has to go to a place along its line; straight where the place is not on that [m]."""
    x, y, _ = who.origin
    (at, aside), (there, beside) = along(who.line, x, y), along(who.line, *place[:2])
    if abs(beside - aside) > 8.0:
        return math.dist((x, y), place[:2])
    return there - at


def pace_of(told: tuple[Any, ...], who: Entity, world: World) -> Pace | None:
    """What a story tells somebody about its speed; None where it tells of something else."""
    match told:
        case ("speed", shape, dimension, amount, target):
            return Change(who, world, shape, dimension, amount, target)
        case ("profile", whom, entries, most):
            return Profile(who, world, entries, most, world.entity(whom) if whom else None)
        case ("distance", whom, *rest):
            return Distance(who, world.entity(whom), tuple(rest))
        case ("meet", whom, *rest):
            return Meeting(who, world.entity(whom), world, tuple(rest))
        case _:
            return None
