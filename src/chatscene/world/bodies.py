"""The bodies of a scene: where each is, and what is asked of it.

This is where a behavior and a simulator meet. Behaviors and the ego write into a body what they ask for; the simulator
that made it moves it and writes into it where it is then; everybody reads that.
Pedals and steering mean what they mean in CARLA: throttle and brake in [0, 1], steering in [-1, 1] with right
positive, as a share of the largest wheel angle.

State is kept in plain Python floats: one step of one body costs about a microsecond, an array call costs more.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

from chatscene.terms.actors import LIMITS

Led = tuple[float, float, float, float]  # x, y [m], heading [rad], speed [m/s] of a centre


@dataclass(frozen=True, slots=True, kw_only=True)
class Placement:
    """How a thing of a scene begins.

    Attributes:
        kind: One that moves (see `LIMITS`) or any other, which stays in place, as does what has no top speed.
        x: Centre [m], map frame.
        y: Centre [m], map frame.
        heading: [rad, 0 = +x, counter-clockwise].
        speed: [m/s] along the heading.
        length: [m].
        width: [m].
        wheelbase: Of a vehicle [m]; else 0.
        wheel_angle: Largest wheel angle of a vehicle [rad]; else 0.
        top_speed: Of one that is faster than its kind, its top speed [m/s]; else 0.
        blueprint: What the program says that it is in CARLA; empty where it does not.
        grip: The largest acceleration that the road lets it have [m/s²].
        backs: Whether it drives backwards; heading and speed are then those of its way, so that its nose is behind.
    """

    kind: str
    x: float
    y: float
    heading: float
    speed: float = 0.0
    length: float
    width: float
    wheelbase: float = 0.0
    wheel_angle: float = 0.0
    top_speed: float = 0.0
    blueprint: str = ""
    grip: float = math.inf
    backs: bool = False


class Body:
    """A body that does not move, and the common state of those that do.

    Attributes:
        moves: Whether bodies of this class move.
        x, y: Centre [m], map frame.
        heading: [rad, 0 = +x, counter-clockwise], never wrapped.
        cos, sin: Of the heading.
        speed: [m/s] along the heading, negative backwards.
        before: The speed before the last step [m/s]: what an impact happens at, since a step may end in standstill.
        length, width: [m].
        grip: The largest acceleration that the road lets it have [m/s²].
    """

    __slots__ = (
        "before",
        "cos",
        "grip",
        "half_length",
        "half_width",
        "heading",
        "length",
        "radius",
        "sin",
        "speed",
        "width",
        "x",
        "y",
    )

    moves = False
    heading: float

    def __init__(self, x: float, y: float, heading: float, length: float, width: float, speed: float = 0.0) -> None:
        self.x = x
        self.y = y
        self.heading = heading
        self.speed = speed
        self.before = 0.0
        self.length = length
        self.width = width
        self.grip = math.inf
        self.half_length = length / 2
        self.half_width = width / 2
        self.radius = math.hypot(length, width) / 2
        self.cos = math.cos(heading)
        self.sin = math.sin(heading)


class Vehicle(Body):
    """A vehicle or two-wheeler, and what is asked of it.

    Attributes:
        throttle, brake: Pedals in [0, 1].
        steer: In [-1, 1], right positive.
        reverse: Whether the throttle pushes backwards.
        target_speed: A speed asked for directly [m/s], to be reached within the pedals' limits; None obeys pedals.
        backs: Whether it drives backwards. It is then carried as it goes: its heading is where it goes to, its speed
            positive, its nose behind, and the wheels that steer are the rear ones of its way.
        led: Where it is after the next step, and how fast, whatever it could do; None where it moves by itself.
        spin: How far it turns about itself for each metre that it slides [rad/m]; None where its tyres hold.
        course: The direction in which it slides [rad, 0 = +x, counter-clockwise]: that which it had.
    """

    __slots__ = ("backs", "brake", "course", "led", "reverse", "spin", "steer", "target_speed", "throttle")

    moves = True

    def __init__(self, x: float, y: float, heading: float, length: float, width: float, speed: float = 0.0) -> None:
        super().__init__(x, y, heading, length, width, speed)
        self.throttle = 0.0
        self.brake = 0.0
        self.steer = 0.0
        self.reverse = False
        self.backs = False
        self.target_speed: float | None = None
        self.led: Led | None = None
        self.spin: float | None = None
        self.course = heading

    def slide(self, spin: float, brake: float) -> None:
        """Slide on from now, or still: see `spin`; with a share of what the brakes give."""
        if self.spin is None:
            self.course = self.heading
        self.spin = spin
        self.throttle, self.brake, self.steer = 0.0, brake, 0.0
        self.reverse, self.target_speed = False, None


class Walker(Body):
    """Somebody on foot, and what is asked of them.

    Attributes:
        course: The direction to walk in [rad, 0 = +x, counter-clockwise].
        target_speed: The speed to walk at [m/s].
        led: Where it is after the next step, and how fast, whatever it could do; None where it moves by itself.
    """

    __slots__ = ("course", "led", "target_speed")

    moves = True

    def __init__(self, x: float, y: float, heading: float, length: float, width: float, speed: float = 0.0) -> None:
        super().__init__(x, y, heading, length, width, speed)
        self.course = heading
        self.target_speed = speed
        self.led: Led | None = None


def going(body: Body, heading: float) -> float:
    """Where a body goes [rad] that heads somewhere: there, unless it slides."""
    return body.course if isinstance(body, Vehicle) and body.spin is not None else heading


def become(body: Body, other: Body) -> None:
    """Let a body be where another of its class is, as large and as fast."""
    for name in _slots_of(type(body)):
        setattr(body, name, getattr(other, name))


@cache
def _slots_of(kind: type[Body]) -> tuple[str, ...]:
    return tuple(name for one in kind.__mro__ for name in getattr(one, "__slots__", ()))


def body_of(placement: Placement) -> Body:
    """The plain body of a thing, for a simulator that keeps how it moves elsewhere."""
    limits = LIMITS.get(placement.kind)
    cls = Body if limits is None or not limits.top_speed else Vehicle if limits.wheelbase else Walker
    body = cls(placement.x, placement.y, placement.heading, placement.length, placement.width, placement.speed)
    body.grip = placement.grip
    return body
