"""Driving along a line: steering by pure pursuit, speed by pedals, slower in curves.

Source for pure pursuit: R. C. Coulter, "Implementation of the Pure Pursuit Path Tracking Algorithm", CMU 1992.
"""

from __future__ import annotations

import math
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from chatscene.terms.polyline import Polyline
from chatscene.terms.profile import HELD_BACK

Pose = tuple[float, float, float, float]  # x [m], y [m], heading [rad, 0 = +x, counter-clockwise], speed [m/s]

LOOK_AHEAD = 4.0  # [m], least distance of the point aimed at
LOOK_AHEAD_TIME = 0.6  # [s]
CURVE_ACCELERATION = 4.0  # [m/s²], lateral, that a driver takes curves with
CURVE_BRAKING = 3.0  # [m/s²], with which a driver slows for a curve ahead


_EVEN = 2.0  # times the shortest segment of a line, up to which its segments are of one length
_STEP = 1.0  # [m], in which a line of uneven segments is looked at


@lru_cache(maxsize=64)
def curve_speeds(line: Polyline, grip: float = math.inf) -> tuple[float, ...]:
    """The speed [m/s] at which each segment can be driven with `CURVE_ACCELERATION`, slowing in time.

    Args:
        line: N points.
        grip: What the road holds [m/s²].

    Returns:
        N - 1 speeds, one per segment.
    """
    step = np.diff(line.points, axis=0)
    length = np.hypot(step[:, 0], step[:, 1])
    heading = np.unwrap(np.arctan2(step[:, 1], step[:, 0]))
    if len(length) < 4 or length[1:-1].max() <= _EVEN * length[1:-1].min():
        return tuple(_speeds(length, heading, grip))
    # A slight bend between a long segment and a short one is no sharp curve: it turns from middle to middle.
    ends = np.cumsum(length)
    steps = max(math.ceil(line.length / _STEP), 2)
    at = (np.arange(steps) + 0.5) * line.length / steps
    evenly = _speeds(np.full(steps, line.length / steps), np.interp(at, ends - 0.5 * length, heading), grip)
    first = np.minimum(((ends - length) * steps / line.length).astype(int), steps - 1)
    return tuple(evenly[i] for i in first.tolist())


def _speeds(length: NDArray[np.float64], heading: NDArray[np.float64], grip: float) -> list[float]:
    """The same, of segments that are about equally long [m], with the heading of each [rad]."""
    # Curvature over a window of segments, so that a kink between two straight pieces is not a hairpin.
    turn = (
        np.abs(np.gradient(np.convolve(np.pad(heading, 2, mode="edge"), np.ones(5) / 5, mode="valid")))
        if len(heading) > 1
        else np.zeros(1)
    )
    lateral, braking = (min(most, HELD_BACK * grip) for most in (CURVE_ACCELERATION, CURVE_BRAKING))
    cap = np.sqrt(lateral * length / np.maximum(turn, 1e-6))
    speeds: list[float] = cap.tolist()
    for i in range(len(speeds) - 2, -1, -1):
        reachable = math.sqrt(speeds[i + 1] ** 2 + 2 * braking * float(length[i]))
        speeds[i] = min(speeds[i], reachable)
    return speeds


class Tracker:
    """Follows a line with one vehicle; remembers where on it the vehicle was.

    Args:
        line: What to follow, in driving order.
        wheelbase: Of the vehicle [m].
        wheel_angle: Its largest wheel angle [rad].
        left: Constant lateral offset from the line [m, positive = left].
        grip: What the road holds [m/s²].
    """

    __slots__ = ("_angle", "_caps", "_left", "_line", "_near", "_wheelbase", "along", "offset")

    def __init__(
        self, line: Polyline, wheelbase: float, wheel_angle: float, left: float = 0.0, grip: float = math.inf
    ) -> None:
        self._line = line
        self._caps = curve_speeds(line, grip)
        self._wheelbase = wheelbase
        self._angle = wheel_angle
        self._left = left
        self._near: int | None = None
        self.along = 0.0
        self.offset = 0.0

    def controls(self, pose: Pose, speed: float, left: float = 0.0) -> tuple[float, float, float]:
        """Throttle, brake and steering that follow the line at `speed` [m/s], `left` [m] beside it."""
        return (*pedals(pose[3], self.allowed(pose, speed)), self.steer(pose, left))

    def allowed(self, pose: Pose, speed: float) -> float:
        """`speed` [m/s], or less where the line curves; updates `along` and `offset`."""
        self.along, self.offset, self._near = self._line.project(pose[0], pose[1], self._near)
        cap = self._caps[self._near]
        return cap if cap < speed else speed

    def steer(self, pose: Pose, left: float = 0.0) -> float:
        """Steering in [-1, 1], right positive, toward a point ahead on the line (call `allowed` first)."""
        return wheel_to(self._line, self.along, pose, left + self._left, self._wheelbase, self._angle)


def wheel_to(line: Polyline, along: float, pose: Pose, left: float, wheelbase: float, wheel_angle: float) -> float:
    """Steering in [-1, 1], right positive, toward a point ahead on a line.

    Args:
        line: What is followed.
        along: How far along it [m] the vehicle is.
        pose: Of the vehicle.
        left: How far [m] to the left of the line it is to be.
        wheelbase: Of the vehicle [m].
        wheel_angle: Its largest wheel angle [rad].
    """
    x, y, heading, speed = pose
    ahead = along + max(LOOK_AHEAD, LOOK_AHEAD_TIME * abs(speed))
    px, py = line.point_at(ahead)
    if left:
        direction = line.heading_at(ahead)
        px -= left * math.sin(direction)
        py += left * math.cos(direction)
    dx, dy = px - x, py - y
    bearing = math.atan2(dy, dx) - heading
    curvature = 2.0 * math.sin(bearing) / max(math.hypot(dx, dy), 1e-3)
    wheel = math.atan(wheelbase * curvature)
    return max(-1.0, min(1.0, -wheel / wheel_angle))


def pedals(speed: float, wish: float) -> tuple[float, float]:
    """Throttle and brake in [0, 1] that bring `speed` to `wish` [m/s]."""
    error = wish - speed
    if error >= -0.1:
        throttle = 0.06 + 0.5 * error
        return (throttle if throttle < 1.0 else 1.0), 0.0
    return 0.0, min(1.0, -0.3 * error)
