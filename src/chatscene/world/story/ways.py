"""Where those in a story go: the lateral half of what a story tells somebody to do.

('lane', shape, dimension, amount, target, left)      target: ('to', number) or ('of', whom, lanes to its left)
('aside', shape, most lateral acceleration, target, for good)   target: ('to' or 'mine', left) or ('of', whom, left)
('line', line or (place, points), times, start)       times: () or (absolute, ((s, m), …)); start: where on it [m]
('way', line)                                         a route: followed from now on
('beside', whom, distance, side, freespace, for good)
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from itertools import pairwise
from typing import Any

from chatscene.maps.neighbours import number_beside
from chatscene.terms.polyline import Polyline
from chatscene.world.control import LOOK_AHEAD, LOOK_AHEAD_TIME, wheel_to
from chatscene.world.places import line_of
from chatscene.world.story.conditions import World
from chatscene.world.story.entities import Entity, along
from chatscene.world.story.pace import shaped
from chatscene.world.story.places import moved

_AT_END = 0.5  # [m] before the end of a line, where it is over
_STEP_ASIDE = 1.0  # [s] that a change of lane takes at least, whatever is told: nothing jumps
_PULLS = 1.0  # [1/s] with which a time table is kept
_WALKS_AHEAD = 1.0  # [m] to the point of its line that somebody on foot goes to


class Way:
    """A line and how far beside it to go.

    Args:
        line: The line.
        left: How far to the left of it [m].

    Attributes:
        done: Whether it is over.
        timed: Whether it tells how fast, too.
        ends: Whether nothing is left of it once it is over, so that somebody goes on along the lane there.
        line: The line.
    """

    ends = timed = False

    def __init__(self, line: Polyline, left: float = 0.0) -> None:
        self.line, self._left, self.done = line, left, True

    def untimed(self) -> Way:
        """The same, without speeds."""
        return self

    def left(self, time: float) -> float:
        """How far beside the line it is to be at a time [m]."""
        del time
        return self._left

    def hastens(self, who: Entity, dt: float) -> float | None:
        """The speed [m/s] that its time table asks for; None where it has none."""
        del who, dt
        return None

    def leaves_at(self, who: Entity) -> float:
        """The speed [m/s] that somebody keeps behind it."""
        return who.speed


class Shift(Way):
    """Goes over to another distance from a line in some time, and keeps it for good if that is told."""

    def __init__(
        self, world: World, line: Polyline, before: float, after: Callable[[], float], lasts: float, shape: str,
        *, for_good: bool = False,
    ) -> None:  # fmt: skip
        super().__init__(line, after())
        self._world, self._before, self._after, self._lasts, self._shape = world, before, after, lasts, shape
        self._began, self._for_good = world.time, for_good
        self.done = False

    def left(self, time: float) -> float:
        """Where between the two it is at a time."""
        if self._for_good:
            self._left = self._after()  # of somebody who moves meanwhile
        share = (time - self._began) / self._lasts
        self.done = not self._for_good and self._world.time - self._began >= self._lasts
        return self._before + (self._left - self._before) * shaped(self._shape, share)


class Beside(Way):
    """Keeps a distance to the side of somebody."""

    def __init__(self, who: Entity, other: Entity, told: tuple[Any, ...]) -> None:
        super().__init__(who.line)
        distance, side, freespace, self._for_good = told
        self._other, self._who = other, who
        room = (who.agent.width + other.agent.width) / 2 if freespace else 0.0
        mine, theirs = (along(who.line, *e.origin[:2])[1] for e in (who, other))
        self._want = (side or (1.0 if mine >= theirs else -1.0)) * (distance + room)
        self.done = False

    def left(self, time: float) -> float:
        """Beside the other."""
        del time
        want = along(self.line, *self._other.origin[:2])[1] + self._want
        self.done = not self._for_good and abs(along(self.line, *self._who.origin[:2])[1] - want) < 0.1
        return want


class Line(Way):
    """Follows a line from a place on it to its end, by a time table if it has one."""

    ends = True

    def __init__(self, who: Entity, world: World, line: Polyline, times: Any, start: float) -> None:
        start = min(start, max(line.length - _AT_END, 0.0))  # a program's line is the shorter by some millimetres
        super().__init__(line.between(start, line.length) if start > 0.0 else line)
        self._who, self._world = who, world
        absolute, table = times or (False, ())
        self._table: list[tuple[float, float]] = _onward(table, start) if start > 0.0 else list(table)
        self.timed = bool(self._table)
        self._began = 0.0 if absolute else world.time - (self._table[0][0] if start > 0.0 and table else 0.0)
        self.done = False

    def untimed(self) -> Way:
        """The same line, without its time table."""
        return Line(self._who, self._world, self.line, (), 0.0)

    def left(self, time: float) -> float:
        """On the line."""
        del time
        if self._table:  # who is at its end too soon waits there
            self.done = self._world.time - self._began >= self._table[-1][0]
        else:
            self.done = along(self.line, *self._who.origin[:2])[0] >= self.line.length - _AT_END
        return 0.0

    def hastens(self, who: Entity, dt: float) -> float | None:
        """The speed of the table at the end of the step, and more or less where it is late or early."""
        if not self._table:
            return None
        time = self._world.time - self._began
        at, after = (self._due(one) for one in (time, time + 2.0 * dt))
        behind = at - along(self.line, *who.origin[:2])[0]
        return max((after - at) / (2.0 * dt) + _PULLS * behind, 0.0)

    def leaves_at(self, who: Entity) -> float:
        """That at which its table ends, if it has come so far: who is to stand there by then does not creep on."""
        if not (self.done and len(self._table) > 1):
            return who.speed
        (t0, s0), (t1, s1) = self._table[-2:]
        return min((s1 - s0) / max(t1 - t0, 1e-9), who.speed)

    def _due(self, time: float) -> float:
        table = self._table
        if time <= table[0][0]:
            return table[0][1]
        for (t0, s0), (t1, s1) in pairwise(table):
            if time < t1:
                return s0 + (s1 - s0) * (time - t0) / max(t1 - t0, 1e-9)
        return table[-1][1]


def _onward(table: Sequence[tuple[float, float]], start: float) -> list[tuple[float, float]]:
    """A time table from a place on [m]: it begins at the time at which that place is passed."""
    left = [(time, gone - start) for time, gone in table if gone > start]
    for (t0, s0), (t1, s1) in pairwise(table):
        if s0 <= start < s1:
            return [(t0 + (t1 - t0) * (start - s0) / (s1 - s0), 0.0), *left]
    return left or [(table[-1][0], 0.0)] if table else []


def way_of(told: tuple[Any, ...], who: Entity, world: World) -> Way | None:
    """What a story tells somebody about where to go; None where it tells of something else."""
    match told:
        case ("lane", shape, dimension, amount, target, left):
            return _lane(who, world, shape, dimension, amount, target, left)
        case ("aside", shape, most, target, for_good):
            return _aside(who, world, shape, most, target, for_good)
        case ("line", line, times, start):
            return Line(who, world, _placed(line, world), times, start)
        case ("way", line):
            return Way(line_of(line))
        case ("beside", whom, *rest):
            return Beside(who, world.entity(whom), tuple(rest))
        case _:
            return None


def _placed(told: Any, world: World) -> Polyline:
    """A line of the program, or the points of one in the frame of a place as it is now."""
    if not isinstance(told, tuple):
        return line_of(told)
    place, points = told
    frame = world.place(place).pose()
    return Polyline([moved(frame, x, y, 0.0)[:2] for x, y in points])


def _lane(
    who: Entity, world: World, shape: str, dimension: str, amount: float, target: tuple[Any, ...], left: float
) -> Way:
    if target[0] == "to":
        number = int(target[1])
    else:
        own, side = world.entity(target[1]).sides()
        number = number_beside(own, side * int(target[2]))
    line = who.lane_line(number)
    before, after = along(line, *who.origin[:2])[1], left * _same_side(who)
    far, amount = abs(after - before), abs(amount)
    if dimension == "rate":
        amount = (
            far / amount * (math.pi / 2 if shape == "sinusoidal" else 1.5 if shape == "cubic" else 1.0) if amount else 0
        )
    elif dimension == "distance":
        amount /= max(who.speed, 0.1)
    shape = shape if shape != "step" else "sinusoidal"
    return Shift(world, line, before, lambda: after, max(amount, _STEP_ASIDE), shape)


def _same_side(who: Entity) -> int:
    """1 where metres to the left of the road's line are to the left of who goes there, else -1."""
    return who.sides()[1] if not who.agent.isWalker else 1


def _aside(who: Entity, world: World, shape: str, most: float, target: tuple[Any, ...], for_good: bool) -> Way:
    """A change of the distance to its line; it takes as long as the lateral acceleration that is told lets it."""
    line, side = who.line, 1 if target[0] == "mine" else _same_side(who)
    other = world.entity(target[1]) if target[0] == "of" else None

    def after() -> float:
        beside = along(line, *other.origin[:2])[1] if other is not None else 0.0
        return beside + target[-1] * side

    before = along(line, *who.origin[:2])[1]
    far = abs(after() - before)
    peak = {"sinusoidal": math.pi**2 / 2, "cubic": 6.0}.get(shape, 4.0)  # of its second derivative
    lasts = math.sqrt(peak * far / most) if most > 0.0 else _STEP_ASIDE
    shape = shape if shape != "step" else "sinusoidal"
    return Shift(world, line, before, after, max(lasts, _STEP_ASIDE), shape, for_good=for_good)


def steering(who: Entity, way: Way, time: float) -> float:
    """The wheel with which a vehicle follows its way: toward where it is to be once it has come as far as it looks."""
    agent = who.agent
    x, y, _, speed = pose = agent.pose
    ahead = max(LOOK_AHEAD, LOOK_AHEAD_TIME * abs(speed))
    left = way.left(time + ahead / max(abs(speed), 1.0))
    at = way.line.project(x, y)[0]
    return wheel_to(way.line, at, pose, left, agent.wheelbase, agent.wheelAngle)


def course(who: Entity, way: Way, time: float) -> float:
    """The direction [rad] in which somebody on foot follows a way."""
    x, y, _, _ = who.agent.pose
    left = way.left(time)
    at = along(way.line, x, y)[0] + _WALKS_AHEAD
    px, py = way.line.point_at(at)
    heading = way.line.heading_at(at)
    return math.atan2(py + left * math.cos(heading) - y, px - left * math.sin(heading) - x)
