"""What sensors tell: collisions, obstacles ahead, place on Earth, accelerations, drawings, points.

Contents are true: there is no noise. Vectors are CARLA's; those of an inertial sensor are in its own frame, x ahead,
y to the right, z up. Lane invasion is found by the wheel itself, from the map.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Container, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Any

from carla_stand_in import wire
from carla_stand_in.actors import Actor, BodyActor
from carla_stand_in.calls_actors import described
from carla_stand_in.pictures import drawn, size_of
from carla_stand_in.rays import Lidar, Radar
from carla_stand_in.world import Contact, World

_PARALLEL = 1e-9
_RAYS: dict[str, Callable[[Actor], Lidar | Radar]] = {
    "sensor.lidar.ray_cast": partial(Lidar, semantic=False),
    "sensor.lidar.ray_cast_semantic": partial(Lidar, semantic=True),
    "sensor.other.radar": Radar,
}


@dataclass(frozen=True, slots=True)
class Reading:
    """What one sensor tells of one step.

    Attributes:
        sensor: Which.
        kind: Position in the wheel's registry of sensors.
        content: As it goes over the wire, behind the header.
    """

    sensor: Actor
    kind: int
    content: bytes


class Sensors:
    """All sensors of a world.

    Args:
        world: Where they are.
        port: Of the streams, for the descriptions of actors in events.
        pack: Msgpack.
    """

    def __init__(self, world: World, port: int, pack: Callable[[Any], bytes]) -> None:
        self._world, self._port, self._pack = world, port, pack
        self._told: dict[int, float] = {}
        self._looking: dict[int, Lidar | Radar] = {}
        self._always: dict[str, tuple[int, Callable[[Actor], bytes]]] = {
            "sensor.other.gnss": (wire.GNSS, self._on_earth),
            "sensor.other.imu": (wire.IMU, self._inertia),
            "sensor.camera.rgb": (wire.PICTURE, self._picture),
            "sensor.camera.semantic_segmentation": (wire.TAGS, self._tags),
            "sensor.lidar.ray_cast": (wire.LIDAR, self._points),
            "sensor.lidar.ray_cast_semantic": (wire.LABELLED_LIDAR, self._points),
            "sensor.other.radar": (wire.RADAR, self._points),
        }

    def readings(self, contacts: list[Contact], heard: Container[int]) -> Iterator[Reading]:
        """What is told of the step that was taken by the sensors that somebody hears."""
        for sensor in [self._world.actors[number] for number in self._world.actors if number in heard]:
            name = sensor.blueprint.id
            if name == "sensor.other.collision":
                yield from self._collisions(sensor, contacts)
            elif self._due(sensor):
                if name == "sensor.other.obstacle":
                    yield from self._obstacle(sensor)
                elif name in self._always:
                    kind, tell = self._always[name]
                    yield Reading(sensor, kind, tell(sensor))

    def forget(self) -> None:
        """Begin anew, after a loading."""
        self._told.clear()
        self._looking.clear()

    @staticmethod
    def check(sensor: Actor) -> None:
        """Refuse a sensor whose attributes make none.

        Raises:
            Refused: They do not.
        """
        name = sensor.blueprint.id
        try:
            if name.startswith("sensor.camera."):
                size_of(sensor)
            elif name in _RAYS:
                _RAYS[name](sensor)
        except ValueError as error:
            raise wire.Refused(f"{name} cannot be made: {error}") from error

    def _due(self, sensor: Actor) -> bool:
        """Whether its own period, if it has one, is over."""
        now, period = self._world.time, _number(sensor, "sensor_tick", 0.0)
        if now < self._told.get(sensor.id, -math.inf) + period - 1e-6:
            return False
        self._told[sensor.id] = now
        return True

    def _collisions(self, sensor: Actor, contacts: list[Contact]) -> Iterator[Reading]:
        """An event for each step in which something touches the parent."""
        for contact in contacts:
            for one, other, sign in ((contact.one, contact.other, 1.0), (contact.other, contact.one, -1.0)):
                if one is sensor.parent:
                    impulse = [sign * part for part in contact.impulse]
                    event = [described(one, self._port), described(other, self._port), impulse]
                    yield Reading(sensor, wire.COLLISION, self._pack(event))

    def _obstacle(self, sensor: Actor) -> Iterator[Reading]:
        """The nearest body ahead within reach."""
        reach, wide = _number(sensor, "distance", 5.0), _number(sensor, "hit_radius", 0.5)
        dynamic = sensor.attribute("only_dynamics").lower() == "true"
        near: list[tuple[float, BodyActor]] = []
        for other in self._world.bodies():
            if other is sensor.parent or (dynamic and not other.body.moves):
                continue
            distance = _ahead(sensor, other, wide)
            if distance is not None and distance <= reach:
                near.append((distance, other))
        if near:
            distance, other = min(near, key=lambda found: (found[0], found[1].id))
            event = [described(sensor.parent or sensor, self._port), described(other, self._port), distance]
            yield Reading(sensor, wire.OBSTACLE, self._pack(event))

    def _on_earth(self, sensor: Actor) -> bytes:
        return self._pack(self._world.roads.on_earth(sensor.location))

    def _inertia(self, sensor: Actor) -> bytes:
        return self._pack(_inertia(sensor, self._world.gravity))

    def _picture(self, sensor: Actor) -> bytes:
        return drawn(self._world, sensor, tags=False)

    def _tags(self, sensor: Actor) -> bytes:
        return drawn(self._world, sensor, tags=True)

    def _points(self, sensor: Actor) -> bytes:
        if sensor.id not in self._looking:
            self._looking[sensor.id] = _RAYS[sensor.blueprint.id](sensor)
        return self._looking[sensor.id].looked(self._world, max(self._world.dt, _number(sensor, "sensor_tick", 0.0)))


def _inertia(sensor: Actor, gravity: float) -> list[Any]:
    """Acceleration [m/s²] with that of standing on the ground, turning [rad/s], compass [rad, 0 = north = -y]."""
    parent = sensor.parent or sensor
    yaw = math.radians(sensor.rotation[1])
    c, s = math.cos(yaw), math.sin(yaw)
    x, y, z = parent.acceleration
    compass = (yaw + math.pi / 2) % math.tau
    return [[c * x + s * y, c * y - s * x, z + gravity], [0.0, 0.0, math.radians(parent.turning)], compass]


def _ahead(sensor: Actor, other: BodyActor, wide: float) -> float | None:
    """How far ahead of a sensor the box of a body begins [m], grown by `wide`; None where it is not ahead."""
    length, width, height = (half + wide for half in other.blueprint.extent)
    x, y, z = (here - there for here, there in zip(sensor.location, other.location, strict=True))
    if abs(z - other.blueprint.lifted) > height:
        return None
    turn = math.radians(other.rotation[1])
    look = math.radians(sensor.rotation[1]) - turn
    c, s = math.cos(turn), math.sin(turn)
    near, far = 0.0, math.inf
    for start, step, half in (
        (c * x + s * y, math.cos(look), length),
        (c * y - s * x, math.sin(look), width),
    ):
        if abs(step) < _PARALLEL:
            if abs(start) > half:
                return None
            continue
        enter, leave = sorted(((-half - start) / step, (half - start) / step))
        near, far = max(near, enter), min(far, leave)
    return near if near <= far else None


def _number(sensor: Actor, name: str, otherwise: float) -> float:
    """An attribute as a number."""
    try:
        return float(sensor.attribute(name) or otherwise)
    except ValueError:
        return otherwise
