"""How bodies move at once: a kinematic bicycle for vehicles and two-wheelers, a point for walkers, nothing for things.

No body can be asked to teleport or to change its velocity at once: every request is limited to what the kind of body
can do (decision 0008), and to what the road holds (`Body.grip`, decision 0056).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache

from chatscene.terms.actors import AIR_DRAG, LIMITS, REVERSE_SPEED, Limits, one_of_class
from chatscene.world.bodies import Body, Placement, Vehicle, Walker

TAU = 2.0 * math.pi


THING = Limits(length=0.0, width=0.0)  # stays where it is
LEAST_REVERSAL = 0.05  # [m/s], below which the gear may change


class VehicleBody(Vehicle):
    """A kinematic bicycle whose reference point is its centre.

    Attributes:
        wheel: Angle of the front wheels [rad, positive = left].
    """

    __slots__ = ("limits", "wheel")

    def __init__(self, x: float, y: float, heading: float, limits: Limits, speed: float = 0.0) -> None:
        super().__init__(x, y, heading, limits.length, limits.width, speed)
        self.limits = limits
        self.wheel = 0.0

    def step(self, dt: float) -> None:
        """Advance by `dt` [s]."""
        if self.spin is not None:
            self._slide(self.spin, dt)
            return
        limits = self.limits
        old = self.before = self.speed
        speed = self._next_speed(dt)
        asked = -(1.0 if self.steer > 1.0 else -1.0 if self.steer < -1.0 else self.steer) * limits.wheel_angle
        most = limits.wheel_rate * dt
        turn = asked - self.wheel
        self.wheel += most if turn > most else -most if turn < -most else turn
        mean = 0.5 * (old + speed)
        if self.wheel == 0.0:
            self.x += mean * self.cos * dt
            self.y += mean * self.sin * dt
        elif mean > 1e-6 or mean < -1e-6:
            curvature = math.tan(self.wheel) / limits.wheelbase
            lateral = limits.lateral if limits.lateral < self.grip else self.grip
            tightest = lateral / (mean * mean)
            curvature = tightest if curvature > tightest else -tightest if curvature < -tightest else curvature
            # Slip of a centre half a wheelbase ahead of the rear axle, which follows the arc.
            slip = math.atan(0.5 * limits.wheelbase * curvature)
            slip = -slip if self.backs else slip
            turned = mean * curvature * math.cos(slip) * dt
            course = self.heading + slip + 0.5 * turned
            self.x += mean * math.cos(course) * dt
            self.y += mean * math.sin(course) * dt
            self.heading += turned
            self.cos = math.cos(self.heading)
            self.sin = math.sin(self.heading)
        self.speed = speed

    def _slide(self, spin: float, dt: float) -> None:
        """Go on where it went, whichever way it is turned, and turn about itself by how far it gets."""
        old = self.before = self.speed
        speed = self._next_speed(dt)
        mean = 0.5 * (old + speed)
        self.x += mean * math.cos(self.course) * dt
        self.y += mean * math.sin(self.course) * dt
        self.heading += spin * mean * dt
        self.cos = math.cos(self.heading)
        self.sin = math.sin(self.heading)
        self.speed = speed

    def _next_speed(self, dt: float) -> float:
        """The speed [m/s] after `dt`: pedals, drag, and never through standstill within one step."""
        limits, speed, grip = self.limits, self.speed, self.grip
        if self.target_speed is not None:
            wish = self.target_speed - speed
            able = limits.throttle if abs(self.target_speed) > abs(speed) else limits.brake
            most = (able if able < grip else grip) * dt
            return speed + (most if wish > most else -most if wish < -most else wish)
        fade = 1.0 - abs(speed) / limits.top_speed
        throttle = 0.0 if self.throttle < 0.0 else 1.0 if self.throttle > 1.0 else self.throttle
        brake = 0.0 if self.brake < 0.0 else 1.0 if self.brake > 1.0 else self.brake
        push = limits.throttle * throttle * (fade if fade > 0.0 else 0.0)
        push = push if push < grip else grip
        braked = limits.brake * brake
        resist = (braked if braked < grip else grip) + limits.drag + AIR_DRAG * speed * speed
        forward = speed > LEAST_REVERSAL or (speed >= -LEAST_REVERSAL and not self.reverse)
        sign = 1.0 if forward else -1.0
        if forward == self.reverse:  # gear against motion: the engine cannot push, the wheels brake
            push, resist = 0.0, resist + push
        rolling = sign * speed
        rolling += (push - resist) * dt if rolling > 0.0 or push > resist else 0.0
        rolling = 0.0 if rolling < 0.0 else rolling
        onward = forward != self.backs
        return sign * (rolling if onward or rolling < REVERSE_SPEED else REVERSE_SPEED)


class WalkerBody(Walker):
    """A point that moves in any direction and faces where it goes.

    Attributes:
        vx, vy: Velocity [m/s].
    """

    __slots__ = ("limits", "vx", "vy")

    def __init__(self, x: float, y: float, heading: float, limits: Limits, speed: float = 0.0) -> None:
        super().__init__(x, y, heading, limits.length, limits.width, speed)
        self.limits = limits
        self.vx = self.speed * self.cos
        self.vy = self.speed * self.sin

    def step(self, dt: float) -> None:
        """Advance by `dt` [s]: the velocity moves toward the wish, at most as fast as legs can."""
        limits = self.limits
        self.before = self.speed
        wish = min(max(self.target_speed, 0.0), limits.top_speed)
        ax = wish * math.cos(self.course) - self.vx
        ay = wish * math.sin(self.course) - self.vy
        change = math.hypot(ax, ay)
        most = min(limits.throttle if wish >= self.speed else limits.brake, self.grip) * dt
        if change > most:
            ax, ay = ax * most / change, ay * most / change
        vx, vy = self.vx + ax, self.vy + ay
        self.x += 0.5 * (self.vx + vx) * dt
        self.y += 0.5 * (self.vy + vy) * dt
        self.vx, self.vy = vx, vy
        self.speed = math.hypot(vx, vy)
        if self.speed > 0.05:
            facing = math.atan2(vy, vx)
            self.heading += (facing - self.heading + math.pi) % TAU - math.pi
            self.cos = vx / self.speed
            self.sin = vy / self.speed


@lru_cache(maxsize=64)
def _faster(known: Limits, top_speed: float) -> Limits:
    return replace(known, top_speed=top_speed)


@lru_cache(maxsize=64)
def _limits_of(known: Limits, length: float, width: float, wheelbase: float, wheel_angle: float) -> Limits:
    return replace(known, length=length, width=width, wheelbase=wheelbase, wheel_angle=wheel_angle)


def make_body(
    placement: Placement, vehicle: Callable[[float, float, float, Limits, float], VehicleBody] = VehicleBody
) -> Body:
    """The body for a thing of the world model.

    Args:
        placement: How the thing begins.
        vehicle: Makes a vehicle's or two-wheeler's, from where it is, its heading, its limits and its speed.

    Raises:
        ValueError: Nothing can be of that size, or nothing of its kind goes at that speed.
    """
    kind, size = placement.kind, (placement.length, placement.width)
    x, y, heading, speed = placement.x, placement.y, placement.heading, placement.speed
    if not (min(size) > 0.0 and all(map(math.isfinite, (x, y, heading, speed, *size)))):
        raise ValueError(f"{one_of_class(kind)} of {size[0]:g} m by {size[1]:g} m at ({x:g}, {y:g}), at {speed:g} m/s")
    known = LIMITS.get(kind, THING)
    if placement.top_speed not in (0.0, known.top_speed):
        known = _faster(known, placement.top_speed)
    slowest = -REVERSE_SPEED if known.wheelbase else 0.0
    if placement.backs and not speed <= -slowest:
        raise ValueError(
            f"{one_of_class(kind)} that begins backwards at {speed:g} m/s; it goes so at {-slowest:g} m/s at most"
        )
    if not slowest <= speed <= known.top_speed:
        raise ValueError(
            f"{one_of_class(kind)} that begins at {speed:g} m/s; it goes at {slowest:g} to {known.top_speed:g} m/s"
        )
    if not known.top_speed:
        return Body(x, y, heading, *size)
    limits = _limits_of(known, *size, placement.wheelbase, placement.wheel_angle)
    body = vehicle(x, y, heading, limits, speed) if known.wheelbase else WalkerBody(x, y, heading, limits, speed)
    if isinstance(body, Vehicle):
        body.backs = placement.backs
    body.grip = min(body.grip, placement.grip)
    return body
