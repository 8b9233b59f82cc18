"""How fast those in a story go: the longitudinal half of what a story tells somebody to do.

('speed', shape, dimension, amount, target)      target: ('to', m/s), ('delta' or 'factor', whom, value, for good)
('profile', whom or '', ((s, m/s), …), (top, speeding up, slowing down), at its times whatever bounds it)
('distance', whom, m or s, 'm' or 's', side, freespace, for good, (top, speeding up, slowing down))
('meet', whom, its place, own place, final)      final: None or (target, steady m, steady s)
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any

from chatscene.world.story.conditions import World
from chatscene.world.story.entities import Entity, along, offset

_NEAR = 0.1  # [m] within which a distance is reached
SPRING = 0.4  # of the largest acceleration, per metre: how hard a distance is pulled to, with no swinging past it
_STANDS = 1e-6  # [m/s]
_PAST = 1e-3  # [m] by which somebody comes farther from a place that lies behind it
UNBOUND = 1e3  # [m/s] and [m/s²], from which on a limit is none
NO_TIME = -1.0  # in the place of the time of a speed that is to be reached as soon as may be
_USUAL = 3.0  # [m/s²] with which a speed without a time is reached where nothing bounds it
_FREE = (UNBOUND,) * 3


class Pace:
    """Says how fast somebody is.

    Attributes:
        done: Whether it is over.
        jump: How far ahead somebody is put at once [m].
    """

    done = False
    jump = 0.0

    def speed(self, dt: float) -> float:
        """The speed [m/s] that it has after the next step; after none, as it begins."""
        raise NotImplementedError


class Steady(Pace):
    """Keeps a speed."""

    done = True

    def __init__(self, speed: float) -> None:
        self._speed = speed

    def speed(self, dt: float) -> float:
        """The same."""
        del dt
        return self._speed


class Waits(Pace):
    """Takes some time, whoever drives meanwhile."""

    def __init__(self, world: World, seconds: float) -> None:
        self._world, self._until = world, world.time + seconds

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


class Change(Pace):
    """Brings a speed to another within a time, over a distance or at a rate; a step is held for as long as is told.

    It takes longer where the body is said to be slower, and at a rate where the speed meant changes meanwhile.
    """

    def __init__(self, who: Entity, world: World, shape: str, dimension: str, amount: float, target: Any) -> None:
        self._who, self._dimension, self._amount = who, dimension, abs(amount)
        self._target, self._for_good = target_of(target, world)
        self._from, self._at, self._passed, self._since, self._shape = who.speed, who.travelled, 0.0, 0.0, shape
        self._holds = self._amount if shape == "step" else 0.0
        self._lasts = self._takes()

    def speed(self, dt: float) -> float:
        """Where the change has come to; once it is over, the speed stays, whatever the other one does."""
        if self.done:
            return self._who.speed
        self._since += dt
        self._passed += dt
        if self._dimension == "rate":
            self._lasts = self._takes()
        share = self._passed / self._lasts if self._lasts > 0.0 else 1.0
        now, bounds, speed = self._between(share), self._who.bounds, self._who.speed
        if self._lasts and dt:
            can = min(max(now, speed - bounds.down * dt), speed + bounds.up * dt)
            if can != now and share < 1.0:  # the change waits for the body
                self._passed -= dt * (1.0 - (can - speed) / (now - speed))
            now = can
        held = self._who.travelled - self._at if self._dimension == "distance" else self._since
        self.done = share >= 1.0 - 1e-9 and not self._for_good and held >= self._holds - 1e-9
        return now

    def _between(self, share: float) -> float:
        return self._from + (self._wish() - self._from) * shaped(self._shape, share)

    def _takes(self) -> float:
        """How long it takes [s] to the speed that is meant now; no time for a step."""
        wish = self._wish()
        change = wish - self._from
        if self._shape == "step" or self._amount == 0.0 or change == 0.0:
            return 0.0
        most = self._who.bounds.up if change > 0.0 else self._who.bounds.down
        lasts = _lasts(self._dimension, self._amount, self._from, wish, self._shape)
        return max(lasts, abs(change) * STEEPEST.get(self._shape, 1.0) / most)

    def _wish(self) -> float:
        top = self._who.bounds.top
        return min(max(self._target(), -top), top)


def _lasts(dimension: str, amount: float, begin: float, end: float, shape: str) -> float:
    """How long a change of speed takes [s]."""
    if dimension == "rate":
        return abs(end - begin) / amount * STEEPEST.get(shape, 1.0)
    if dimension == "time":
        return amount
    if begin * end < 0.0:  # over standstill: each part at its own mean
        share = begin**2 / (begin**2 + end**2)
        return 2.0 * amount * (share / abs(begin) + (1.0 - share) / abs(end))
    return 2.0 * amount / abs(begin + end)


class Profile(Pace):
    """Goes through speeds that are told with their times, each reached from the one before.

    It takes longer where it is bound to a smaller acceleration, by what is told or by the body; not where it is told
    to keep to its times exactly.
    """

    def __init__(self, who: Entity, world: World, told: tuple[Any, ...], base: Entity | None) -> None:
        entries, limits, exactly = told
        self._world, self._began, self._base = world, world.time, base
        self._points: list[tuple[float, float]] = [(0.0, who.speed - (base.speed if base else 0.0))]
        top, up, down = map(min, limits, who.bounds.each)
        for time, wish in entries:
            at, before = self._points[-1]
            if exactly and time >= 0.0:
                self._points.append((at + time, wish))
                continue
            speed = min(max(wish, -top), top)
            most = up if speed > before else down
            usual = most if most < UNBOUND else _USUAL
            lasts = max(time, abs(speed - before) / (usual if time < 0.0 else most))
            self._points.append((at + lasts, speed))

    def speed(self, dt: float) -> float:
        """Where it has come to."""
        since = self._world.time + dt - self._began
        self.done = since >= self._points[-1][0]
        own = self._base.speed if self._base else 0.0
        for (t0, v0), (t1, v1) in pairwise(self._points):
            if since < t1:
                return own + v0 + (v1 - v0) * (since - t0) / max(t1 - t0, 1e-9)
        return own + self._points[-1][1]


class Distance(Pace):
    """Keeps a distance to somebody along its way or comes to it: at once where nothing bounds it; else as a spring."""

    def __init__(self, who: Entity, other: Entity, told: tuple[Any, ...]) -> None:
        self._who, self._other = who, other
        self._amount, self._unit, side, self._freespace, self._for_good, self._limits = told
        ahead, _ = offset(who, other, "road")
        self._side = side or (1.0 if ahead <= 0.0 else -1.0)

    def speed(self, dt: float) -> float:
        """The other's, corrected by how far off the distance is."""
        who, other = self._who, self._other
        ahead, _ = offset(who, other, "road", of_centres=self._freespace)
        room = (who.agent.length + other.agent.length) / 2 if self._freespace else 0.0
        want = self._amount if self._unit == "m" else self._amount * abs(other.speed)
        off = self._side * (want + room) + ahead  # how far on it has still to come
        top, up, down = self._limits if self._limits == _FREE else map(min, self._limits, who.bounds.each)
        self.done = not self._for_good and abs(off) < _NEAR
        if min(up, down) >= UNBOUND:
            self.jump = off
            return other.speed
        spring = SPRING * (up if off < 0.0 else down)
        gains = min(max(off * spring - 2.0 * math.sqrt(spring) * (who.speed - other.speed), -down), up)
        return min(max(who.speed + gains * dt, -top), top)


class Meeting(Pace):
    """Comes to a place when another comes to its place, at a speed that is told, if one is.

    Without one, it keeps the steady acceleration that takes the time. With one, its speed rises and then falls, or
    falls and then rises, as steeply both times, so that both time and speed are met; where it would have to drive
    backwards for that, it stands for a while.
    """

    def __init__(self, who: Entity, other: Entity, world: World, told: tuple[Any, ...]) -> None:
        theirs, ours, final = told
        self._who, self._other = who, other
        self._ours, self._theirs = world.place(ours), world.place(theirs)
        self._final = target_of(final[0], world)[0] if final else None
        self._steady = final[1:] if final else (0.0, 0.0)
        self._last, self._is_linear, self._lines = (math.inf, math.inf), False, (who.line, other.line)

    def speed(self, dt: float) -> float:
        """Its speed after a step."""
        if self.done or dt == 0.0:
            return self._who.speed
        left, theirs = abs(_left(self._who, self._ours.pose())), abs(_left(self._other, self._theirs.pose()))
        pace, speed = abs(self._other.speed), self._who.speed
        lines = self._who.line, self._other.line
        if any(line is not was for line, was in zip(lines, self._lines, strict=True)):  # the places may be farther
            self._lines, self._last = lines, (math.inf, math.inf)
        away = left > self._last[0] + _PAST or theirs > self._last[1] + _PAST
        self.done = away or (pace > _STANDS and theirs / pace < dt)
        self._last = left, theirs
        if self.done:
            return self._final() if self._final else speed
        if pace < _STANDS:
            return 0.0
        time = theirs / pace
        if self._final is None:
            return max(speed + 2.0 * (left / time - speed) / time * dt, 0.0)
        return self._toward(left, time, self._final(), dt)

    def _toward(self, left: float, time: float, final: float, dt: float) -> float:
        """The speed after a step, where a last speed [m/s] is told and so much is left [m, s]."""
        speed = self._who.speed
        steady = max(self._steady[0], self._steady[1] * final)
        if steady:
            left, time = left - steady, time - steady / max(final, _STANDS)
            if left <= 0.0 or time <= dt:
                return final
        straight = 2.0 * left / time - final  # from which a steady change of speed takes the time
        if self._is_linear or abs(speed - straight) < 1e-3:
            self._is_linear = True
            return max(straight + (final - straight) * dt / time, 0.0)
        turn, gains = _in_two(left, time, speed, final)
        if turn < 0.0:  # it would have to drive backwards
            if speed <= _STANDS:
                self._is_linear = time < 2.0 * left / max(final, _STANDS)
                return 0.0
            halts = 2.0 * speed * left / (speed**2 + final**2)
            gains = -speed / max(halts, dt)
        if gains * (speed - straight) > 0.0:
            self._is_linear = True
        return max(speed + gains * dt, 0.0)


def _in_two(left: float, time: float, speed: float, final: float) -> tuple[float, float]:
    """The speed [m/s] at which a change of speed turns round, and its acceleration before that [m/s²].

    So much is left [m, s], and it rises as steeply as it falls.
    """
    square = 4.0 * left**2 - 4.0 * (final + speed) * time * left + 2.0 * (final**2 + speed**2) * time**2
    root = math.sqrt(max(square, 0.0))
    for turn in ((2.0 * left - root) / (2.0 * time), (2.0 * left + root) / (2.0 * time)):
        whole = 2.0 * turn - speed - final  # up and down, or down and up
        if whole == 0.0:
            continue
        until = time * (turn - speed) / whole
        if 0.0 < until < time:
            return turn, (turn - speed) / until
    return speed, 0.0


def _left(who: Entity, place: tuple[float, ...]) -> float:
    """How far somebody still has to go to a place along its line; straight where the place is not on that [m]."""
    x, y, _ = who.origin
    (at, aside), (there, beside) = along(who.line, x, y), along(who.line, *place[:2])
    if abs(beside - aside) > 8.0:
        return math.dist((x, y), place[:2])
    return there - at


SHORT = 3.0  # [s] that is waited for what somebody else does where it is not told how long that takes


def lasts(told: tuple[Any, ...]) -> Any:
    """How long what is told takes [s], where it says so; else None."""
    match told:
        case ("speed" | "lane", _, "time", amount, *_):
            return amount
        case _:
            return None


def pace_of(told: tuple[Any, ...], who: Entity, world: World) -> Pace | None:
    """What a story tells somebody about its speed; None where it tells of something else."""
    match told:
        case ("speed", shape, dimension, amount, target):
            return Change(who, world, shape, dimension, amount, target)
        case ("profile", whom, *rest):
            return Profile(who, world, tuple(rest), world.entity(whom) if whom else None)
        case ("distance", whom, *rest):
            return Distance(who, world.entity(whom), tuple(rest))
        case ("meet", whom, *rest):
            return Meeting(who, world.entity(whom), world, tuple(rest))
        case _:
            return None
