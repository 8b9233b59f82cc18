"""Lidar and radar: rays that end at boxes or on the ground below the sensor's parent."""

from __future__ import annotations

import math
import struct
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from carla_stand_in.actors import Actor, BodyActor
from carla_stand_in.world import TAGS, World

_MOST = 200_000  # rays in one step
_FADING = 0.004  # [1/m]; CARLA's default attenuation
_PARALLEL = 1e-9
_NOTHING, _GROUND = -2, -1
_ROAD_TAG = 1
_GOLDEN = math.pi * (3.0 - math.sqrt(5.0))  # [rad] between one ray of a radar and the next
_POINT = np.dtype([("at", "<f4", 3), ("facing", "<f4"), ("actor", "<u4"), ("tag", "<u4")])

Array = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class _Ends:
    """Where R rays end.

    Attributes:
        far: (R,) how far each goes [m]; infinite where it meets nothing.
        who: (R,) index among `bodies`; -1 for the ground, -2 for nothing.
        facing: (R,) cosine of the angle between ray and what it meets, 1 where straight upon it.
        bodies: What there is to meet.
    """

    far: Array
    who: NDArray[np.int64]
    facing: Array
    bodies: list[BodyActor]


class Lidar:
    """A lidar that turns.

    Args:
        sensor: Whose attributes say how it looks around.
        semantic: Whether its points say what they lie on, in place of how bright they are.

    Raises:
        ValueError: They are no numbers that a lidar can have.
    """

    def __init__(self, sensor: Actor, *, semantic: bool) -> None:
        self._sensor = sensor
        self._semantic = semantic
        self._reach = _given(sensor, "range", 10.0)
        self._channels = int(_given(sensor, "channels", 32))
        self._rate = _given(sensor, "points_per_second", 56000)
        self._turns = _given(sensor, "rotation_frequency", 10.0)
        self._wide = min(_given(sensor, "horizontal_fov", 360.0), 360.0)
        self._low, self._high = _given(sensor, "lower_fov", -30.0), _given(sensor, "upper_fov", 10.0)
        self._angle = 0.0
        if not (1 <= self._channels <= 1024 and self._rate >= 0 and self._turns >= 0):
            raise ValueError("a lidar with such attributes")

    def looked(self, world: World, dt: float) -> bytes:
        """What is sent of a step of `dt` [s]: angle, points by channel, and x, y, z [m] and intensity of each point.

        A semantic one sends the cosine of incidence, the id of the actor and its label in place of the intensity.
        Points are in the sensor's own frame, x ahead, y to the right, z up.
        """
        each = int(min(self._rate * dt / self._channels, _MOST / self._channels))
        swept = min(360.0 * self._turns * dt, 360.0)
        across = self._angle + np.arange(each) * (swept / max(each, 1))
        self._angle = (self._angle + swept) % 360.0
        across = (across + 180.0) % 360.0 - 180.0
        up = np.linspace(self._high, self._low, self._channels)
        rays = _directions(np.radians(across), np.radians(up)).reshape(-1, 3)
        ends = _ends(world, self._sensor, rays)
        seen = np.broadcast_to(np.abs(across) <= self._wide / 2, (self._channels, each)).reshape(-1)
        hit = (ends.far <= self._reach) & seen
        each_hit = hit.reshape(self._channels, each).sum(axis=1)
        head = struct.pack(f"<fI{self._channels}I", math.radians(self._angle), self._channels, *each_hit)
        points = rays[hit] * ends.far[hit][:, None]
        if self._semantic:
            return head + _labelled(points, ends, hit)
        light = np.exp(-_FADING * ends.far[hit])[:, None]
        return head + np.hstack([points, light]).astype("<f4").tobytes()


class Radar:
    """A radar: rays spread evenly over its cone, the same in each step.

    Args:
        sensor: Whose attributes say how it looks ahead.

    Raises:
        ValueError: They are no numbers that a radar can have.
    """

    def __init__(self, sensor: Actor) -> None:
        self._sensor = sensor
        self._reach = _given(sensor, "range", 100.0)
        self._rate = _given(sensor, "points_per_second", 1500)
        self._wide, self._high = (_given(sensor, f"{way}_fov", 30.0) for way in ("horizontal", "vertical"))
        if not (self._rate >= 0 and 0 < self._wide <= 180 and 0 < self._high <= 180):
            raise ValueError("a radar with such attributes")

    def looked(self, world: World, dt: float) -> bytes:
        """What is sent of a step of `dt` [s]: of each point its speed [m/s], azimuth, altitude [rad] and distance [m].

        The speed is that at which it goes away; it is negative where it comes nearer.
        """
        number: Array = np.arange(int(min(self._rate * dt, _MOST)), dtype=np.float64)
        spread, turn = np.sqrt((number + 0.5) / max(len(number), 1)), number * _GOLDEN
        azimuth = spread * np.cos(turn) * math.radians(self._wide / 2)
        altitude = spread * np.sin(turn) * math.radians(self._high / 2)
        level = np.cos(altitude)
        ahead, right = (np.multiply(level, part) for part in (np.cos(azimuth), np.sin(azimuth)))
        rays: Array = np.stack([ahead, right, np.sin(altitude)], axis=1)
        ends = _ends(world, self._sensor, rays)
        hit = ends.far <= self._reach
        moving = np.array([[0.0] * 3, *(body.velocity for body in ends.bodies)])[np.maximum(ends.who, _GROUND) + 1]
        yaw = math.radians(self._sensor.rotation[1])
        c, s = math.cos(yaw), math.sin(yaw)
        out = np.stack([c * rays[:, 0] - s * rays[:, 1], s * rays[:, 0] + c * rays[:, 1], rays[:, 2]], axis=1)
        away = ((moving - np.array(self._sensor.velocity)) * out).sum(axis=1)
        return np.stack([away, azimuth, altitude, ends.far], axis=1)[hit].astype("<f4").tobytes()


def _given(sensor: Actor, name: str, otherwise: float) -> float:
    """An attribute as a finite number.

    Raises:
        ValueError: It is none.
    """
    number = float(sensor.attribute(name) or otherwise)
    if not math.isfinite(number):
        raise ValueError(f"{name} is {number}")
    return number


def _labelled(points: Array, ends: _Ends, hit: NDArray[np.bool_]) -> bytes:
    """Points of a semantic lidar: place, cosine of incidence, id of the actor (0 for the ground), label."""
    ids = np.array([0, *(body.id for body in ends.bodies)])
    tags = np.array([_ROAD_TAG, *(TAGS[body.blueprint.group] for body in ends.bodies)])
    told = np.zeros(len(points), dtype=_POINT)
    told["at"], told["facing"] = points, ends.facing[hit]
    told["actor"], told["tag"] = ids[ends.who[hit] + 1], tags[ends.who[hit] + 1]
    return told.tobytes()


def _directions(across: Array, up: Array) -> Array:
    """(C, N, 3) unit vectors in the sensor's frame, from N angles to the right and C angles upwards [rad]."""
    level = np.cos(up)[:, None]
    rise = np.broadcast_to(np.sin(up)[:, None], (len(up), len(across)))
    parts: list[Array] = [np.multiply(level, np.cos(across)), np.multiply(level, np.sin(across)), rise]
    return np.stack(parts, axis=-1)


def _ends(world: World, sensor: Actor, rays: Array) -> _Ends:
    """Where (R, 3) rays in the sensor's frame end: at a box, or on the ground below its parent."""
    yaw = math.radians(sensor.rotation[1])
    floor = (sensor.parent or sensor).location[2]
    if isinstance(sensor.parent, BodyActor):
        floor += sensor.parent.blueprint.lifted - sensor.parent.blueprint.extent[2]
    drop = floor - sensor.location[2]
    with np.errstate(divide="ignore", invalid="ignore"):
        ground = drop / rays[:, 2]
    down = (rays[:, 2] < -_PARALLEL) & (drop < 0.0)
    far: Array = np.asarray(np.where(down, ground, np.inf))
    who = np.where(down, _GROUND, _NOTHING)
    facing: Array = np.abs(rays[:, 2])
    bodies = [body for body in world.bodies() if body is not sensor.parent]
    for number, body in enumerate(bodies):
        distance, straight = _to_box(sensor, body, rays, yaw)
        nearer = distance < far
        far, who, facing = (
            np.where(nearer, distance, far),
            np.where(nearer, number, who),
            np.where(nearer, straight, facing),
        )
    return _Ends(far, who, facing, bodies)


def _to_box(sensor: Actor, body: BodyActor, rays: Array, yaw: float) -> tuple[Array, Array]:
    """(R,) how far it is to a box along each ray [m], infinite where it is missed; (R,) how straight it is met."""
    turn = math.radians(body.rotation[1])
    x, y, z = (here - there for here, there in zip(sensor.location, body.location, strict=True))
    c, s = math.cos(turn), math.sin(turn)
    start = np.array([c * x + s * y, c * y - s * x, z - body.blueprint.lifted])
    c, s = math.cos(yaw - turn), math.sin(yaw - turn)
    step = np.stack([c * rays[:, 0] - s * rays[:, 1], s * rays[:, 0] + c * rays[:, 1], rays[:, 2]], axis=1)
    step = np.where(np.abs(step) < _PARALLEL, _PARALLEL, step)
    half = np.array(body.blueprint.extent)
    one, other = (-half - start) / step, (half - start) / step
    enters = np.minimum(one, other)
    near = enters.max(axis=1)
    leave = np.maximum(one, other).min(axis=1)
    far: Array = np.where((near <= leave) & (near > 0.0), near, np.inf)
    straight: Array = np.abs(np.take_along_axis(step, enters.argmax(axis=1)[:, None], axis=1)[:, 0])
    return far, straight
