"""How fast a line can be driven, place by place, and how long that takes: the speed profile of a route.

A bend is driven with `CURVE_ACCELERATION`, and slowed for with `COMFORTABLE`. That lies between 1.5 m/s², which
M. Treiber, A. Kesting, "Traffic Flow Dynamics" (2013), section 11.3, take for comfortable, and the 2.5 m/s² with which
`idm` brakes where nothing presses, so that it can follow.
"""

from __future__ import annotations

import math
from bisect import bisect_right

import numpy as np
from numpy.typing import NDArray

from chatscene.terms.polyline import Polyline

CURVE_ACCELERATION = 3.0  # [m/s²], lateral, that an ego takes curves with
COMFORTABLE = 2.0  # [m/s²], with which it slows for what is known before
HELD_BACK = 0.8  # share of what the road holds that a driver who knows the road uses in and before a bend
CUT = 0.2  # [m]; a bend that can be rounded off by less is none: maps draw their lines with such corners
WINDOWS = tuple(4.0 * 2.0 ** (i / 3.0) for i in range(11))  # [m], from 4 to 40, over which a line may be seen to bend

Array = NDArray[np.float64]


def allowed_speeds(line: Polyline, limits: Array | None = None, grip: float = math.inf) -> Array:
    """The speed [m/s] allowed on each segment of a line: by its limits and bends, and by those ahead.

    Args:
        line: What is driven, N points.
        limits: The speed allowed on each segment otherwise [m/s]; None where nothing else limits it.
        grip: What the road holds [m/s²].

    Returns:
        (N - 1,); infinite where nothing limits it.
    """
    lateral, braking = (min(most, HELD_BACK * grip) for most in (CURVE_ACCELERATION, COMFORTABLE))
    speeds = bend_speeds(line, lateral)
    return reachable(line, speeds if limits is None else np.minimum(speeds, limits), braking)


def bend_speeds(line: Polyline, lateral: float = CURVE_ACCELERATION) -> Array:
    """The speed [m/s] of each segment of a line, (N - 1,), that asks for so much lateral acceleration [m/s²]."""
    curvature = bends(line)
    return np.sqrt(np.divide(lateral, curvature, out=np.full(len(curvature), np.inf), where=curvature > 0.0))


def bends(line: Polyline) -> Array:
    """The curvature [1/m] of each segment of a line, without sign, (N - 1,).

    It is the turn between the mean headings of a stretch before the segment's middle and one behind it, over the
    shortest stretches that show more than `CUT`.
    """
    _, _, s, hx, hy = line.columns
    arcs, heading = np.array(s), np.unwrap(np.arctan2(np.array(hy), np.array(hx)))
    turned = np.concatenate(([0.0], np.cumsum(heading * np.diff(arcs))))  # the integral of the heading up to each point
    mids, most = 0.5 * (arcs[:-1] + arcs[1:]), np.zeros(len(heading))
    for window in (one for one in WINDOWS if one <= line.length):
        half = window / 2.0
        middle = np.clip(mids, half, line.length - half)  # near its ends, a line bends as it does a little inside
        before, here, beyond = (np.interp(middle + off, arcs, turned) for off in (-half, 0.0, half))
        bent = np.abs(beyond - here - (here - before)) / (half * half)
        most = np.maximum(most, np.where(bent * window * window / 8.0 >= CUT, bent, 0.0))
    return most


def reachable(line: Polyline, speeds: Array, braking: float) -> Array:
    """Speeds [m/s] of a line's segments, (N - 1,), each no more than from which braking so [m/s²] reaches the next."""
    found, (_, _, s, *_) = speeds.tolist(), line.columns
    for i in range(len(found) - 2, -1, -1):
        found[i] = min(found[i], math.sqrt(found[i + 1] ** 2 + 2.0 * braking * (s[i + 1] - s[i])))
    return np.array(found)


class Timetable:
    """When somebody is where on a line, who drives as fast as he wants and is allowed.

    Args:
        line: What is driven, N points.
        allowed: The speed allowed on each segment [m/s], (N - 1,).
        wanted: The speed wanted [m/s].
        gain: With which speed is taken up again behind what held it back [m/s²].

    Attributes:
        arcs: Arc length of each point [m].
        speeds: What is driven at on each segment [m/s].
        seconds: When each point is passed after the first [s].
    """

    __slots__ = ("arcs", "seconds", "speeds")

    def __init__(self, line: Polyline, allowed: Array, wanted: float, gain: float = math.inf) -> None:
        arcs = line.columns[2]
        speeds = np.minimum(allowed, wanted).tolist()
        for i in range(1, len(speeds)):
            speeds[i] = min(speeds[i], math.sqrt(speeds[i - 1] ** 2 + 2.0 * gain * (arcs[i] - arcs[i - 1])))
        self.arcs, self.speeds = list(arcs), speeds
        self.seconds = [0.0]
        for i, speed in enumerate(speeds):
            self.seconds.append(self.seconds[i] + (arcs[i + 1] - arcs[i]) / speed)

    def speed_at(self, s: float) -> float:
        """What is driven at [m/s] at arc length `s` [m]; beyond the ends as there."""
        return self.speeds[self._segment(s)]

    def time_at(self, s: float) -> float:
        """When arc length `s` [m] is passed [s], after the start of the line; beyond the ends it goes on as there."""
        i = self._segment(s)
        return self.seconds[i] + (s - self.arcs[i]) / self.speeds[i]

    def _segment(self, s: float) -> int:
        """The segment of an arc length [m]; beyond the ends the last there."""
        return min(max(bisect_right(self.arcs, s) - 1, 0), len(self.speeds) - 1)

    def time_from(self, start: float, speed: float, end: float, gain: float) -> float:
        """The same [s], of somebody who has a speed [m/s] and takes up with `gain` [m/s²] what he misses."""
        usual, seconds = self.speed_at(start), self.time_at(end) - self.time_at(start)
        left, missing = end - start, usual - speed
        if missing <= 0.0 or left <= 0.0:
            return seconds
        if left * 2.0 * gain >= usual * usual - speed * speed:
            return seconds + missing * missing * (0.5 / gain) / usual
        return max(seconds, (math.sqrt(speed * speed + 2.0 * gain * left) - speed) / gain)

    def time_to(self, start: float, end: float) -> float:
        """How long it takes from one arc length [m] to another [s]; less than nothing to one that lies behind."""
        return self.time_at(end) - self.time_at(start)
