"""A proving ground: a line to drive along, others who do as they are told, and what becomes of it.

Nothing is placed and nothing is searched for, so that a driver can be held to a protocol's numbers: so far away, so
fast, braking so hard. What the driver sees is `RouteView`'s, how its car answers is up to a `Physics`.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from chatscene.ego.asking import begin
from chatscene.ego.observation import RouteView, Seen
from chatscene.ego.policy import EgoPolicy, controls, observation_of, pedals_of
from chatscene.simulate.contact import touch
from chatscene.simulate.physics import Physics
from chatscene.terms.actors import LIMITS, Limits
from chatscene.terms.polyline import Polyline
from chatscene.terms.profile import allowed_speeds
from chatscene.world.bodies import Body, Placement, Vehicle

DT = 0.1  # [s]
LANE = 3.5  # [m]
CAR = LIMITS["Car"]

Array = NDArray[np.float64]
Path = Callable[[float], tuple[float, float, float, float]]
"""Where somebody is at a time [s]: x, y [m], heading [rad] and speed [m/s]."""


@dataclass(slots=True)
class Told:
    """Somebody who does as he is told.

    Attributes:
        path: Where he is when.
        limits: Whose size he has.
        body: What the ego sees and touches.
    """

    path: Path
    limits: Limits = CAR
    body: Body = field(init=False)

    def __post_init__(self) -> None:
        self.body = Body(0.0, 0.0, 0.0, self.limits.length, self.limits.width)
        self.go(0.0)

    def go(self, time: float) -> None:
        """Be where he is at a time [s]."""
        body = self.body
        body.x, body.y, body.heading, body.speed = self.path(time)
        body.cos, body.sin = math.cos(body.heading), math.sin(body.heading)


@dataclass(frozen=True, slots=True, eq=False)
class Driven:
    """What became of a drive, step by step.

    Attributes:
        time: [s].
        along: Of the ego on its line [m].
        offset: Left of it [m].
        speed: [m/s].
        allowed: The speed allowed there [m/s].
        acceleration: Along its heading [m/s²].
        across: Across it [m/s²].
        steering: What the driver asked for, in [-1, 1].
        impact: Speed of the ego when it touched somebody [m/s]; None if it did not.
    """

    time: Array
    along: Array
    offset: Array
    speed: Array
    allowed: Array
    acceleration: Array
    across: Array
    steering: Array
    impact: float | None


def line_of(*pieces: tuple[float, float]) -> Polyline:
    """A line from the origin to the east, of pieces that are so long [m] and bend so much [1/m, positive = left]."""
    x, y, heading = 0.0, 0.0, 0.0
    points = [(x, y)]
    for length, curvature in pieces:
        step = length / (count := max(round(length), 1))
        for _ in range(count):
            middle = heading + 0.5 * curvature * step
            x, y, heading = x + step * math.cos(middle), y + step * math.sin(middle), heading + curvature * step
            points.append((x, y))
    return Polyline(points)


def drive(
    ego: EgoPolicy,
    line: Polyline,
    speed: float,
    others: Sequence[Told] = (),
    *,
    physics: Physics,
    seconds: float = 30.0,
    offset: float = 0.0,
    room: tuple[float, float] = (LANE / 2, LANE / 2),
) -> Driven:
    """Let an ego drive along a line until it is at its end, touches somebody, or the time is over.

    Args:
        ego: Who drives a car; it is to see one of the presets along a route.
        line: Its route.
        speed: At which it begins [m/s].
        others: Who else is there.
        physics: How its car answers; without a body yet.
        seconds: How long [s].
        offset: How far to the left of the route it begins [m].
        room: How far the driving lanes go on to the left and to the right of the route [m].
    """
    (x, y), heading = line.point_at(0.0), line.heading_at(0.0)
    starts = Placement(
        kind="Car",
        x=x - offset * math.sin(heading),
        y=y + offset * math.cos(heading),
        heading=heading,
        speed=speed,
        length=CAR.length,
        width=CAR.width,
        wheelbase=CAR.wheelbase,
        wheel_angle=CAR.wheel_angle,
    )
    car = physics.add(starts)
    assert isinstance(car, Vehicle)
    allowed = allowed_speeds(line)
    view = RouteView(line, np.tile(room, (len(line), 1)), allowed)
    see = {"actors": view.actors, "road": view.road, "traffic": view.traffic}[observation_of(ego)]
    pedals = pedals_of(ego)
    shown = [Seen(other.body, not other.limits.wheelbase, math.inf) for other in others]
    rows: list[tuple[float, ...]] = []
    begin(ego)
    impact = None
    for step in range(round(seconds / DT)):
        view.locate(car.x, car.y)
        if view.along >= line.length - 1.0:
            break
        action = ego.act(see(car, shown))
        car.throttle, car.brake, car.steer = controls(action, pedals)
        for other in others:
            other.go(step * DT)
        was, turned = car.speed, car.heading
        physics.step(DT)
        across = (car.heading - turned) / DT * 0.5 * (was + car.speed)
        here = min(line.segment_at(view.along), len(allowed) - 1)
        rows.append((step * DT, view.along, view.offset, was, allowed[here], (car.speed - was) / DT, across, action[1]))
        for other in others:
            other.go((step + 1) * DT)
        if any(touch(car, other.body) for other in others):
            impact = car.speed
            break
    return Driven(*np.array(rows).T, impact=impact)


def ahead(distance: float, speed: float = 0.0, *, braking: float = 0.0, after: float = 1.0) -> Path:
    """In the ego's lane on a line to the east, from tail to nose so far [m]; then it brakes so hard [m/s²]."""

    def path(time: float) -> tuple[float, float, float, float]:
        since = min(max(time - after, 0.0), speed / braking if braking else 0.0)
        gone = speed * (min(time, after) if braking else time) + speed * since - 0.5 * braking * since * since
        return distance + CAR.length + gone, 0.0, 0.0, speed - braking * since

    return path


def across(speed: float, walked: float, arrives: float, to: float, *, side: int = -1, share: float = 0.5) -> Path:
    """Somebody who crosses the ego's lane at right angles, on a line to the east.

    Args:
        speed: His [m/s].
        walked: How far from the middle of the lane he sets out [m].
        arrives: When the nose of an ego that does not brake is where he crosses [s].
        to: How far along the line that is, from the middle of the ego at its start [m].
        side: Where he comes from: -1 the right, 1 the left.
        share: Which share of the ego's width he has then passed, from the side that he comes from.
    """
    target = side * CAR.width * (0.5 - share)

    def path(time: float) -> tuple[float, float, float, float]:
        left = max(arrives - time, -10.0) * speed
        y = target + side * min(left, abs(side * walked - target))
        return to, y, -side * math.pi / 2, speed if left < abs(side * walked - target) else 0.0

    return path


def cuts_in(distance: float, speed: float, sideways: float, *, after: float = 1.0, aside: float = LANE) -> Path:
    """From the lane to the left, from tail to nose so far [m]: it comes over so fast [m/s]."""

    def path(time: float) -> tuple[float, float, float, float]:
        over = min(max(time - after, 0.0) * sideways, aside)
        heading = -math.atan2(sideways, speed) if 0.0 < over < aside else 0.0
        return distance + CAR.length + speed * time, aside - over, heading, speed

    return path


def towards(line: Polyline, starts: float, speed: float, *, aside: float = LANE) -> Path:
    """Against the ego's direction in the lane to its left, from so far along its line [m]."""

    def path(time: float) -> tuple[float, float, float, float]:
        at = starts - speed * time
        (x, y), heading = line.point_at(at), line.heading_at(at)
        return x - aside * math.sin(heading), y + aside * math.cos(heading), heading + math.pi, speed

    return path


def pedestrian(speed: float, walks: float, share: float, *, side: int = -1, walked: float = 6.0) -> Told:
    """Euro NCAP's crossing pedestrian for a test speed [m/s], who is met no sooner than after 4 s."""
    arrives = max(4.0, (walked + CAR.width) / walks)
    to = arrives * speed + CAR.length / 2
    return Told(across(walks, walked, arrives, to, side=side, share=share), LIMITS["Pedestrian"])
