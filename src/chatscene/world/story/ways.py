"""Where those in a story go: the lateral half of what a story tells somebody to do.

('lane', shape, dimension, amount, target, left)      target: ('to', number) or ('of', whom, lanes to its left)
('aside', shape, most lateral acceleration, target, for good)   target: ('to' or 'mine', left) or ('of', whom, left)
('line', points or (place, points), times, start, faces, closed)
    times: () or (absolute, ((s, m), …), evenly), evenly: each piece at a steady acceleration; start: where on it [m];
    faces: none, or ((m, rad), …): which way it looks where, with times ((s, rad), …): when
('way', points)                                       a route: followed from now on
('beside', whom, distance, side, freespace, for good)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from copy import copy
from itertools import pairwise
from typing import Any

from chatscene.maps.neighbours import number_beside
from chatscene.terms.polyline import Polyline
from chatscene.world.places import line_of
from chatscene.world.story.conditions import World
from chatscene.world.story.entities import Entity, along
from chatscene.world.story.pace import SPRING, STEEPEST, UNBOUND, shaped
from chatscene.world.story.places import moved

Pose = tuple[float, float, float]  # x, y [m], heading [rad]

_STEP_ASIDE = 0.5  # [m/s²] across, with which somebody goes aside where nothing is told
_NO_WAY = 1e-6  # [m]
_BESIDE = 0.01  # [m] within which a distance to the side is reached
_ACROSS = 0.1  # [m] before and behind, between which the direction of a line is seen


class Way:
    """A line that somebody goes along, some way beside it.

    Args:
        who: Who goes.
        line: The line.
        left: How far to the left of it [m]; None for where somebody is.

    Attributes:
        done: Whether what was told of it is over.
        timed: Whether it tells how fast, too.
        ends: Whether nothing is left of it once it is over, so that somebody goes on along the lane there.
        line: The line.
        at: How far along it somebody is [m].
    """

    ends = timed = False

    def __init__(self, who: Entity, line: Polyline, left: float | None = None) -> None:
        self._who = who
        x, y, heading = who.origin
        self.at, beside = along(line, x, y)
        self.line, self._left, self.done = line, beside if left is None else left, True
        self._turn = math.remainder(heading - _bearing(line, self.at), math.tau)

    def untimed(self) -> Way:
        """The same, without speeds."""
        return self

    def steady(self) -> Way:
        """The way along the same line, as far beside it as somebody is now."""
        way = Way(self._who, self.line)
        way._turn = 0.0
        return way

    def goes_on_along(self, line: Polyline) -> None:
        """Go on as before, along another line that begins where this one ends, and as far beside it."""
        self.at, self.line = self.over, line

    def goes(self, gone: float, dt: float) -> Pose:
        """Where somebody is who goes so far [m] in a time [s]: x [m], y [m], heading [rad]."""
        del dt
        self._onward(gone)
        return self._pose(self._turn)

    def _onward(self, gone: float) -> None:
        """Go along the line; so far beside it that it bends, somebody goes less or more of it."""
        bend = 0.0
        if abs(self._left) > 0.01:
            ends = (self.line.heading_at(self.at + d) for d in (_ACROSS, -_ACROSS))
            bend = math.remainder(next(ends) - next(ends), math.tau) / (2.0 * _ACROSS)
        self.at += gone / max(1.0 - bend * self._left, 0.1)

    def _pose(self, turn: float) -> Pose:
        heading = _bearing(self.line, self.at)
        x, y = self.line.point_at(self.at)
        left = self._left
        return x - left * math.sin(heading), y + left * math.cos(heading), heading + turn

    def speed(self) -> float | None:
        """The speed [m/s] that its time table has somebody go at now; None where it has none."""
        return None

    @property
    def over(self) -> float:
        """How far beyond the end of the line somebody is [m]."""
        return self.at - self.line.length


class Shift(Way):
    """Goes over to another distance from a line: in a time, or on a distance.

    Args:
        who: Who goes.
        line: The line.
        after: How far to the left of it [m] it goes.
        lasts: The time [s] or distance [m] that it takes.
        shape: How it goes over.
        in_metres: Whether that is a distance.
        aside: Whether somebody goes as far along the line as without; else as far in all.
        for_good: Whether it keeps to what `after` says, whatever that is, for good.
    """

    def __init__(
        self, who: Entity, line: Polyline, after: Callable[[], float], lasts: float, shape: str, *,
        in_metres: bool = False, aside: bool = False, for_good: bool = False,
    ) -> None:  # fmt: skip
        super().__init__(who, line)
        self._turn, self._before, self._after, self._lasts, self._shape = 0.0, self._left, after, lasts, shape
        self._in_metres, self._aside, self._for_good, self._passed, self._to = in_metres, aside, for_good, 0.0, after()
        self.done = False

    def goes(self, gone: float, dt: float) -> Pose:
        """Where it is after that."""
        if self._for_good:
            self._to = self._after()  # of somebody who moves meanwhile
        was, turn = self._left, self._turn
        if self._lasts <= 0.0:
            self._passed, self._left = 1.0, self._to
            self._onward(gone)
        elif gone or self._aside:
            self._crosses(gone, dt)
            slope = (self._left - was) / abs(gone) if gone else 0.0
            turn = math.atan(slope / math.sqrt(max(1.0 - slope**2, 1e-6))) * (1.0 if gone >= 0.0 else -1.0)
        self.done = self._share() >= 1.0 - 1e-9 and not self._for_good
        return self._pose(0.0 if self.done else turn)

    def _share(self) -> float:
        return self._passed / self._lasts if self._lasts > 0.0 else 1.0

    def _at(self, passed: float) -> float:
        return self._before + (self._to - self._before) * shaped(self._shape, passed / self._lasts)

    def _crosses(self, gone: float, dt: float) -> None:
        """Go on across the line and along it; in all no farther than it goes."""
        way, rest = abs(gone), self._lasts - self._passed
        step = min(dt, rest)
        if self._in_metres:
            ahead = max(min(way, rest), 1e-9)
            slope = (self._at(self._passed + ahead) - self._left) / ahead
            step = min(way / math.hypot(1.0, slope), rest)
        across = abs(self._at(self._passed + step) - self._left)
        if across > way and not self._aside:  # it comes no farther aside than it goes
            step *= way / across
            across = abs(self._at(self._passed + step) - self._left)
        self._passed += step
        self._left = self._at(self._passed)
        straight = way if self._aside else math.sqrt(max(way**2 - across**2, 0.0))
        self._onward(math.copysign(straight, gone))


class Beside(Way):
    """Keeps a distance to the side of somebody, or comes to it: at once where nothing bounds it.

    With a bound on its acceleration across, it is pulled there as by a spring, with no swinging past it; with one on
    its speed alone, it goes over at that. It goes no farther in all than without.
    """

    def __init__(self, who: Entity, other: Entity, told: tuple[Any, ...]) -> None:
        super().__init__(who, who.line)
        distance, side, freespace, self._for_good, *limits = told
        self._top, self._gains, self._jerk = limits[0] if limits else (UNBOUND,) * 3
        self._other, self._across, self._gain = other, who.speed * math.sin(self._turn), 0.0
        room = (who.agent.width + other.agent.width) / 2 if freespace else 0.0
        x, y, heading = other.origin
        at, theirs = along(who.line, x, y)
        its = math.copysign(side, side * math.cos(heading - _bearing(who.line, at)))  # which is to a side of the other
        self._want = (its or (1.0 if self._left >= theirs else -1.0)) * (distance + room)
        self.done = False

    def goes(self, gone: float, dt: float) -> Pose:
        """Beside the other."""
        off = along(self.line, *self._other.origin[:2])[1] + self._want - self._left
        if min(self._top, self._gains) >= UNBOUND:
            self._left += off
            self.done = not self._for_good
            return super().goes(gone, dt)
        self.done = not self._for_good and abs(off) < _BESIDE
        if dt > 0.0:
            top = min(self._top, abs(gone) / dt)
            self._across = min(max(self._goes_over(off, top, dt), -top), top)
        over = self._across * dt
        self._left += over
        straight = math.copysign(math.sqrt(max(gone**2 - over**2, 0.0)), gone)
        self._onward(straight)
        return self._pose(math.atan2(over, straight) if gone > 0.0 else 0.0)

    def _goes_over(self, off: float, top: float, dt: float) -> float:
        """How fast it is to go across [m/s], so far off [m]."""
        if self._gains >= UNBOUND:
            return math.copysign(min(top, abs(off) / dt), off)
        spring = SPRING * self._gains
        pull = off * spring - 2.0 * math.sqrt(spring) * self._across
        change = min(max(pull - self._gain, -self._jerk * dt), self._jerk * dt)
        self._gain = min(max(self._gain + change, -self._gains), self._gains)
        return self._across + self._gain * dt


class Line(Way):
    """Follows a line from a place on it to its end, by a time table if it has one.

    Args:
        who: Who follows it.
        world: The story.
        line: The line.
        times: When how much of it is behind somebody: whether by the time of the story, and times [s] and ways [m].
        start: Where on it somebody begins [m].
        faces: Which way somebody looks where: ways [m], or with a time table times [s], and headings [rad, not
            wrapped]; empty for along the line, whichever way it is gone along; None for the way that somebody goes.
        closed: Whether its end leads to its beginning, so that somebody goes round it for good.
    """

    ends = True

    def __init__(
        self,
        who: Entity,
        world: World,
        line: Polyline,
        times: Any,
        start: float,
        faces: Any = None,
        closed: bool = False,
    ) -> None:
        super().__init__(who, line, 0.0)
        self._closed = closed
        self._faces: tuple[tuple[float, float], ...] = tuple(faces or ())
        self.at, self._world, self._start = min(start, line.length), world, start
        absolute, self._table, *evenly = times or (False, ())
        self.timed, self.done = bool(self._table), False
        self._began = 0.0 if absolute else world.time - (_when(self._table, start) if start > 0.0 else 0.0)
        backs = who.speed < 0.0 and not self.timed and faces is None
        self._gains: Gains | None = None
        if evenly and evenly[0]:
            self._table = _from(self._table, start)
            self._gains = _steadily(self._table, _speed_along(who, line, self.at))
        self._time = world.time - self._began
        self._turn = math.pi if backs else 0.0
        self._way = -1.0 if backs or (self._faces and math.cos(self._looks() - _bearing(line, self.at)) < 0.0) else 1.0

    def untimed(self) -> Way:
        """The same line, without its time table."""
        other = copy(self)
        other._table, other.timed = (), False
        if self._table:
            other._faces = tuple((_due(self._table, time, self._gains), heading) for time, heading in self._faces)
        return other

    def goes(self, gone: float, dt: float) -> Pose:
        """Where it is on the line after that."""
        if self._table:
            self._time = self._world.time + dt - self._began
            self.at = max(_due(self._table, self._time, self._gains), self._start)
            self.done = self._time >= self._table[-1][0] - 1e-9
        else:
            self.at += gone * self._way
            if self._closed:
                self.at %= self.line.length
            self.done = not self._closed and (
                self.at >= self.line.length - 1e-6 or (self.at <= 0.0 and gone * self._way < 0.0)
            )
        x, y, heading = self._pose(self._turn)
        return (x, y, self._looks()) if self._faces else (x, y, heading)

    def speed(self) -> float | None:
        """The speed of the table, backwards where somebody looks back."""
        if not self._table:
            return None
        time = self._world.time - self._began
        slope = _slope(self._table, time, self._gains)
        back = self._faces and math.cos(self._looks() - _bearing(self.line, self.at)) < 0.0
        return -slope if back else slope

    def _looks(self) -> float:
        passed = self._time if self._table else self.at
        for (s0, h0), (s1, h1) in pairwise(self._faces):
            if passed < s1:
                return h0 + (h1 - h0) * max(passed - s0, 0.0) / max(s1 - s0, 1e-9)
        return self._faces[-1][1]


def _bearing(line: Polyline, at: float) -> float:
    """The direction [rad] of a line at a place on it [m], without the corners of its pieces."""
    (x0, y0), (x1, y1) = line.point_at(at - _ACROSS), line.point_at(at + _ACROSS)
    return math.atan2(y1 - y0, x1 - x0)


def _speed_along(who: Entity, line: Polyline, at: float) -> float:
    """How fast somebody goes along a line at a place on it [m/s]; 0 for who goes the other way."""
    return max(who.speed if math.cos(who.pose[2] - _bearing(line, at)) >= 0.0 else -who.speed, 0.0)


def _from(table: Sequence[tuple[float, float]], start: float) -> Sequence[tuple[float, float]]:
    """A table from a place on the line [m] on."""
    later = [one for one in table if one[1] > start]
    return table if start <= 0.0 or not later else [(_when(table, start), start), *later]


Gains = list[tuple[float, float]]  # of each piece of a table: speed at its beginning [m/s] and acceleration [m/s²]


def _steadily(table: Sequence[tuple[float, float]], speed: float) -> Gains:
    """How fast each piece is begun and how fast that changes, so that speeds do not jump; who stops, waits."""
    gains: Gains = []
    for (t0, s0), (t1, s1) in pairwise(table):
        time, way = max(t1 - t0, 1e-9), s1 - s0
        gain = 2.0 * (way - speed * time) / time**2 if way > _NO_WAY else 0.0
        if way > _NO_WAY and speed + gain * time < 0.0:  # it would come back
            gain = -(speed**2) / (2.0 * way)
        begins = speed if way > _NO_WAY else 0.0
        gains.append((begins, gain))
        speed = max(begins + gain * time, 0.0)
    return gains


def _due(table: Sequence[tuple[float, float]], time: float, gains: Gains | None = None) -> float:
    """How much of a line is behind somebody at a time [m]."""
    if time <= table[0][0]:
        return table[0][1]
    for i, ((t0, s0), (t1, s1)) in enumerate(pairwise(table)):
        if time < t1:
            if gains is None:
                return s0 + (s1 - s0) * (time - t0) / max(t1 - t0, 1e-9)
            speed, gain = gains[i]
            passed = min(time - t0, -speed / gain if gain < 0.0 else math.inf)
            return s0 + speed * passed + gain * passed**2 / 2.0
    return table[-1][1]


def _slope(table: Sequence[tuple[float, float]], time: float, gains: Gains | None = None) -> float:
    """How fast that grows at a time [m/s]; behind the last, as before it."""
    if time < table[0][0] or len(table) < 2:
        return 0.0
    i = next((i for i, one in enumerate(table[1:]) if time < one[0]), len(table) - 2)
    (t0, s0), (t1, s1) = table[i], table[i + 1]
    if gains is None:
        return (s1 - s0) / max(t1 - t0, 1e-9)
    speed, gain = gains[i]
    return max(speed + gain * (min(time, t1) - t0), 0.0)


def _when(table: Sequence[tuple[float, float]], at: float) -> float:
    """When somebody comes to a place on a line [s]."""
    for (t0, s0), (t1, s1) in pairwise(table):
        if s0 <= at < s1:
            return t0 + (t1 - t0) * (at - s0) / (s1 - s0)
    return table[-1][0] if table else 0.0


def way_of(told: tuple[Any, ...], who: Entity, world: World) -> Way | None:
    """What a story tells somebody about where to go; None where it tells of something else."""
    match told:
        case ("lane", shape, dimension, amount, target, left):
            return _lane(who, world, shape, dimension, amount, target, left)
        case ("aside", shape, most, target, for_good):
            return _aside(who, world, shape, most, target, for_good)
        case ("line", line, times, start, *faces):
            return Line(who, world, _placed(line, world), times, start, *faces)
        case ("way", line):
            return Way(who, _placed(line, world))
        case ("beside", whom, *rest):
            return Beside(who, world.entity(whom), tuple(rest))
        case _:
            return None


def _placed(told: Any, world: World) -> Polyline:
    """The line through points, on the map or in the frame of a place as it is now; or the line of a route."""
    if not isinstance(told, tuple):
        return line_of(told)
    if not isinstance(told[0][0], str):
        return Polyline(told)  # type: ignore[reportUnknownArgumentType] - pairs of numbers
    place, points = told  # type: ignore[reportUnknownVariableType]
    frame = world.place(place).pose()  # type: ignore[reportUnknownArgumentType]
    return Polyline([moved(frame, x, y, 0.0)[:2] for x, y in points])  # type: ignore[reportUnknownVariableType]


def _lane(
    who: Entity, world: World, shape: str, dimension: str, amount: float, target: tuple[Any, ...], left: float
) -> Way:
    if target[0] == "to":
        number = int(target[1])
    else:
        own, side = world.entity(target[1]).sides()
        number = number_beside(own, side * int(target[2]))
    line = who.lane_line(number)
    after, amount = left * _same_side(who), abs(amount)
    far = abs(after - along(line, *who.origin[:2])[1])
    if dimension == "rate":
        amount = far / amount * STEEPEST.get(shape, 1.0) if amount else 0.0
    amount = 0.0 if shape == "step" else amount
    return Shift(who, line, lambda: after, amount, shape, in_metres=dimension == "distance")


def _same_side(who: Entity) -> int:
    """1 where metres to the left of the road's line are to the left of who goes there, else -1."""
    return who.sides()[1] if not who.agent.isWalker else 1


def _aside(who: Entity, world: World, shape: str, most: float, target: tuple[Any, ...], for_good: bool) -> Way:
    """A change of the distance to its line; it takes as long as the lateral acceleration that is told lets it."""
    line, side = who.line, 1 if target[0] != "to" else _same_side(who)
    other = world.entity(target[1]) if target[0] == "of" else None

    def after() -> float:
        if other is None:
            return target[-1] * side
        x, y, heading = other.origin
        at, beside = along(line, x, y)
        return beside + math.copysign(target[-1], target[-1] * math.cos(heading - _bearing(line, at)))

    far = abs(after() - along(line, *who.origin[:2])[1])
    peak = math.pi**2 / 2 if shape == "sinusoidal" else 6.0  # of its second derivative
    lasts = 0.0 if shape == "step" else math.sqrt(peak * far / (most if most > 0.0 else _STEP_ASIDE))
    return Shift(who, line, after, lasts, shape, aside=True, for_good=for_good)
