"""Actors: what a client spawned, and the body of ours that each of them has.

Here, and only here, frames change: clients speak CARLA's (left-handed, y to the right of x, degrees, clockwise), bodies
ours (right-handed, y to the left of x, radians, counter-clockwise): y and yaw change their sign.
"""

from __future__ import annotations

import math
from typing import Any

from carla_stand_in.blueprints import Blueprint
from carla_stand_in.roads import Roads, Signal, wrapped
from carla_stand_in.wire import Refused
from chatscene.errors import ChatSceneError
from chatscene.simulate.physics import Physics, PhysicsOf
from chatscene.terms.actors import LIMITS
from chatscene.terms.nouns import with_article
from chatscene.world.bodies import Body, Placement, Vehicle, Walker

_HALF_LANE = 1.75  # [m]
_DROP = 3.0  # [m]; who is deeper below the road than that stays there


class Actor:
    """Anything with an id; this class is for what has no body: sensors, controllers, lights, the spectator.

    Args:
        number: Its id, never used again.
        description: As it goes over the wire.
        blueprint: What it is.
        location: [m].
        rotation: Pitch, yaw, roll [degrees].
        parent: What it is attached to; the pose is relative to it then.

    Attributes:
        location, rotation: As above, in the world.
        velocity: [m/s].
        turning: About the z axis [degrees/s].
        acceleration: [m/s²].
    """

    def __init__(
        self,
        number: int,
        description: list[Any],
        blueprint: Blueprint,
        location: list[float],
        rotation: list[float],
        parent: Actor | None = None,
    ) -> None:
        self.id = number
        self.description = description
        self.blueprint = blueprint
        self.parent = parent
        self.location = list(location)
        self.rotation = list(rotation)
        self.velocity = [0.0, 0.0, 0.0]
        self.acceleration = [0.0, 0.0, 0.0]
        self.turning = 0.0
        self._mount = (list(location), list(rotation))
        self.follow()

    @property
    def box(self) -> list[Any]:
        """Its bounding box as it goes over the wire."""
        return self.blueprint.box

    @property
    def attributes(self) -> dict[str, str]:
        """What it was given at its spawn."""
        return {key: value for key, _, value in self.description[2]}

    def attribute(self, name: str, otherwise: str = "") -> str:
        """One of them."""
        return self.attributes.get(name, otherwise)

    def follow(self) -> None:
        """Take the place at its parent."""
        if self.parent is None:
            return
        (x, y, z), (pitch, yaw, roll) = self._mount
        base, turn = self.parent.location, self.parent.rotation[1]
        c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        self.location = [base[0] + c * x - s * y, base[1] + s * x + c * y, base[2] + z]
        self.rotation = [pitch, wrapped(yaw + turn), roll]
        self.velocity = self.parent.velocity

    def place(self, location: list[float], rotation: list[float] | None = None) -> None:
        """Put it elsewhere; relative to its parent, if it has one."""
        rotation = self._mount[1] if rotation is None else rotation
        self._mount = (list(location), list(rotation))
        self.location, self.rotation = list(location), list(rotation)
        self.follow()


class LightActor(Actor):
    """A traffic light: its box is that of the lanes that wait for it, across which its x axis points.

    Args:
        number: Its id.
        description: As it goes over the wire.
        blueprint: What it is.
        signal: Where it stands.
    """

    def __init__(self, number: int, description: list[Any], blueprint: Blueprint, signal: Signal) -> None:
        along = signal.stops[0][2] if signal.stops else signal.rotation[1]
        rotation = [0.0, wrapped(along + 90.0), 0.0]
        super().__init__(number, description, blueprint, list(signal.location), rotation)
        self._signal = signal

    @property
    def box(self) -> list[Any]:
        """As it goes over the wire, in the light's own frame."""
        x, y, z = self.location
        c, s = math.cos(math.radians(self.rotation[1])), math.sin(math.radians(self.rotation[1]))
        stops = [(c * (a - x) + s * (b - y), c * (b - y) - s * (a - x)) for a, b, _ in self._signal.stops]
        across = [a for a, _ in stops] or [0.0]
        middle = (min(across) + max(across)) / 2
        behind = sum(b for _, b in stops) / max(len(stops), 1)
        half = (max(across) - min(across)) / 2 + _HALF_LANE
        return [[middle, behind, -z], [half, 1.0, 1.0], [0.0, 0.0, 0.0]]


class BodyActor(Actor):
    """An actor with a body of ours: a vehicle, a walker or a thing.

    Attributes:
        body: Where it is in our frame.
        control: What was asked last, as it goes over the wire.
        moving: Whether physics moves it; without, it stays where it is put.
        touchable: Whether it meets others.
        constant: Forward speed that it is held at [m/s], or None.
        target: Steering [share of the largest wheel angle] and speed [m/s] of an Ackermann control, or None.
        force: What pushes it during the next step [N].
        light: The traffic light it waits at.
        lights_on: Bits of the lamps that are on.
        came_from: x [m], y [m] and heading [rad] of its body before the last step; None where no step took it here.
    """

    def __init__(
        self,
        number: int,
        description: list[Any],
        blueprint: Blueprint,
        location: list[float],
        rotation: list[float],
        physics_of: PhysicsOf,
    ) -> None:
        super().__init__(number, description, blueprint, location, rotation)
        self._physics_of = physics_of
        self._physics: Physics
        self.body: Body
        self.control: list[Any] = (
            [[1.0, 0.0, 0.0], 0.0, False] if blueprint.group == "walker" else [0.0, 0.0, 0.0, False, False, False, 1]
        )
        self.moving = blueprint.group in ("vehicle", "walker")
        self.touchable = True
        self.constant: float | None = None
        self.target: tuple[float, float] | None = None
        self.force = [0.0, 0.0, 0.0]
        self.light: int | None = None
        self.lights_on = 0
        self.came_from: tuple[float, float, float] | None = None
        self._had = self.velocity
        self._make(0.0)

    def _make(self, speed: float) -> None:
        """The body at the actor's pose: bodies cannot be moved at will, so another one is made.

        Raises:
            Refused: There can be no such body.
        """
        kind, (length, width, _) = self.blueprint.kind, self.blueprint.size
        limits = LIMITS.get(kind)
        placement = Placement(
            kind=kind or "Prop",
            x=self.location[0],
            y=-self.location[1],
            heading=-math.radians(self.rotation[1]),
            speed=max(0.0, min(limits.top_speed, speed)) if limits else 0.0,
            length=length,
            width=width,
            wheelbase=limits.wheelbase * length / limits.length if limits else 0.0,
            wheel_angle=limits.wheel_angle if limits else 0.0,
        )
        physics = self._physics_of()
        try:
            self.body = physics.add(placement)
        except (ChatSceneError, ValueError) as error:
            raise Refused(f"{self.blueprint.id} cannot be placed: {error}") from error
        self._physics = physics
        self._stood: list[float] = []

    def place(self, location: list[float], rotation: list[float] | None = None) -> None:
        """Put it elsewhere; it keeps its speed along its new heading."""
        super().place(location, rotation)
        self.came_from = None
        self._make(self.body.speed)
        if isinstance(self.body, Vehicle):
            self._obey_vehicle(self.body)

    def push(self, velocity: list[float]) -> None:
        """Take a velocity [m/s] at once: its part along the heading, since bodies do not slide."""
        body = self.body
        if isinstance(body, Vehicle):
            self._take(velocity[0] * body.cos - velocity[1] * body.sin)
        self.velocity = list(velocity) if not self.moving else self._velocity()

    def strike(self, impulse: list[float]) -> None:
        """Take an impulse [N s] at once: the part along the heading changes the speed, by the mass.

        Raises:
            Refused: It is no vehicle.
        """
        body = self.body
        if not isinstance(body, Vehicle):
            raise Refused(
                f"actor {self.id} is {with_article(self.blueprint.id)}; only vehicles take impulses and forces here"
            )
        self._take(body.speed + (impulse[0] * body.cos - impulse[1] * body.sin) / self.blueprint.mass)

    def _take(self, speed: float) -> None:
        """Have a speed at once [m/s], within what the body can reach."""
        top = LIMITS[self.blueprint.kind].top_speed
        self.body.speed = max(-top, min(top, speed))

    def level_with(self, other: BodyActor) -> bool:
        """Whether two boxes could meet by their heights."""
        above = self.location[2] + self.blueprint.lifted - other.location[2] - other.blueprint.lifted
        return abs(above) < self.blueprint.extent[2] + other.blueprint.extent[2]

    def step(self, dt: float, roads: Roads) -> None:
        """Advance by `dt` [s]."""
        if not self.moving:
            self.came_from = None
            self.acceleration = [0.0, 0.0, 0.0]
            self.turning = 0.0
            return
        body, self._had, heading = self.body, self.velocity, self.body.heading
        self.came_from = (body.x, body.y, heading)
        force, self.force = self.force, [0.0, 0.0, 0.0]
        if isinstance(body, Vehicle):
            if any(force):
                self.strike([part * dt for part in force])
            if self.constant is not None:
                body.speed = self.constant
            self._obey_vehicle(body)
        elif isinstance(body, Walker):
            self._obey_walker(body)
        self._physics.step(dt)
        x, y = body.x, -body.y
        if body.moves and (x != self.location[0] or y != self.location[1]):
            self.rotation = [0.0, wrapped(-math.degrees(body.heading)), 0.0]
        if self._stood != [x, y, self.location[2]]:
            self._stood = [x, y, self._height(roads, [x, y, self.location[2]])]
        self.location = list(self._stood)
        self.velocity = self._velocity()
        self.turning = -math.degrees(body.heading - heading) / dt
        self._accelerated(dt)

    def keep(self, share: float, at: tuple[float, float, float], dt: float) -> None:
        """Keep a share of the last step's motion, since somebody is in the way of the rest.

        Args:
            share: In [0, 1]; so much it keeps of its speed, too.
            at: x [m], y [m] and heading [rad] of its body then.
            dt: What the step took [s].
        """
        speed, before = share * self.body.speed, self.body.before
        self.location = [at[0], -at[1], self.location[2]]
        self.rotation = [0.0, wrapped(-math.degrees(at[2])), 0.0]
        self._make(speed)
        self.body.speed, self.body.before = speed, before
        self.turning *= share
        self.velocity = self._velocity()
        self._accelerated(dt)

    def _accelerated(self, dt: float) -> None:
        self.acceleration = [(now - then) / dt for now, then in zip(self.velocity, self._had, strict=True)]

    def _velocity(self) -> list[float]:
        body = self.body
        return [body.speed * body.cos, -body.speed * body.sin, 0.0]

    def _height(self, roads: Roads, at: list[float]) -> float:
        """On the road, at once: there is no falling."""
        foot = at[2] - (self.blueprint.extent[2] if self.blueprint.group == "walker" else 0.0)
        ground = roads.ground(at)
        return at[2] if foot < ground - _DROP else at[2] - foot + ground

    def _obey_vehicle(self, body: Vehicle) -> None:
        throttle, steer, brake, hand_brake, reverse, manual, gear = self.control
        body.throttle = 0.0 if manual and gear == 0 else throttle
        body.brake = 1.0 if hand_brake else brake
        body.steer = steer
        body.reverse = reverse or (manual and gear < 0)
        body.target_speed = self.constant
        if self.target is not None:
            body.steer, body.target_speed = self.target

    def _obey_walker(self, body: Walker) -> None:
        (x, y, _), speed, _ = self.control
        if x or y:
            body.course = math.atan2(-y, x)
        body.target_speed = speed
