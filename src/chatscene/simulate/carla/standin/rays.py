"""Lidar: rays that end at boxes or on the ground below the sensor's parent."""

from __future__ import annotations

import math
import struct

import numpy as np
from numpy.typing import NDArray

from chatscene.simulate.carla.standin.actors import Actor, BodyActor
from chatscene.simulate.carla.standin.world import World

_MOST = 200_000  # rays in one step
_FADING = 0.004  # [1/m]; CARLA's default attenuation
_PARALLEL = 1e-9

Array = NDArray[np.float64]


class Lidar:
    """A lidar that turns.

    Args:
        sensor: Whose attributes say how it looks around.

    Raises:
        ValueError: They are no numbers that a lidar can have.
    """

    def __init__(self, sensor: Actor) -> None:
        def given(name: str, otherwise: float) -> float:
            return float(sensor.attribute(name) or otherwise)

        self._sensor = sensor
        self._reach = given("range", 10.0)
        self._channels = int(given("channels", 32))
        self._rate = given("points_per_second", 56000)
        self._turns = given("rotation_frequency", 10.0)
        self._wide = min(given("horizontal_fov", 360.0), 360.0)
        self._low, self._high = given("lower_fov", -30.0), given("upper_fov", 10.0)
        self._angle = 0.0
        known = (self._reach, self._rate, self._turns, self._wide, self._low, self._high)
        if not (
            all(map(math.isfinite, known)) and 1 <= self._channels <= 1024 and self._rate >= 0 and self._turns >= 0
        ):
            raise ValueError("a lidar with such attributes")

    def looked(self, world: World, dt: float) -> bytes:
        """What is sent of a step of `dt` [s]: angle, points by channel, and x, y, z [m] and intensity of each point.

        Points are in the sensor's own frame, x ahead, y to the right, z up.
        """
        each = int(min(self._rate * dt / self._channels, _MOST / self._channels))
        swept = min(360.0 * self._turns * dt, 360.0)
        across = self._angle + np.arange(each) * (swept / max(each, 1))
        self._angle = (self._angle + swept) % 360.0
        across = (across + 180.0) % 360.0 - 180.0
        up = np.linspace(self._high, self._low, self._channels)
        rays = _directions(np.radians(across), np.radians(up))
        far = _ends(world, self._sensor, rays.reshape(-1, 3)).reshape(self._channels, each)
        hit = (far <= self._reach) & (np.abs(across) <= self._wide / 2)[None, :]
        points = rays[hit] * far[hit][:, None]
        light = np.exp(-_FADING * far[hit])[:, None]
        head = struct.pack(f"<fI{self._channels}I", math.radians(self._angle), self._channels, *hit.sum(axis=1))
        return head + np.hstack([points, light]).astype("<f4").tobytes()


def _directions(across: Array, up: Array) -> Array:
    """(C, N, 3) unit vectors in the sensor's frame, from N angles to the right and C angles upwards [rad]."""
    level = np.cos(up)[:, None]
    rise = np.broadcast_to(np.sin(up)[:, None], (len(up), len(across)))
    parts: list[Array] = [np.multiply(level, np.cos(across)), np.multiply(level, np.sin(across)), rise]
    return np.stack(parts, axis=-1)


def _ends(world: World, sensor: Actor, rays: Array) -> Array:
    """(R,) how far each ray goes [m]; infinite where it meets nothing."""
    yaw = math.radians(sensor.rotation[1])
    floor = (sensor.parent or sensor).location[2]
    if isinstance(sensor.parent, BodyActor):
        floor += sensor.parent.lifted - sensor.parent.extent[2]
    drop = floor - sensor.location[2]
    with np.errstate(divide="ignore", invalid="ignore"):
        ground = drop / rays[:, 2]
    far: Array = np.asarray(np.where((rays[:, 2] < -_PARALLEL) & (drop < 0.0), ground, np.inf))
    for body in world.bodies():
        if body is not sensor.parent:
            far = np.minimum(far, _to_box(sensor, body, rays, yaw))
    return far


def _to_box(sensor: Actor, body: BodyActor, rays: Array, yaw: float) -> Array:
    """(R,) how far it is to a box along each ray [m]; infinite where it is missed."""
    turn = math.radians(body.rotation[1])
    x, y, z = (here - there for here, there in zip(sensor.location, body.location, strict=True))
    c, s = math.cos(turn), math.sin(turn)
    start = np.array([c * x + s * y, c * y - s * x, z - body.lifted])
    c, s = math.cos(yaw - turn), math.sin(yaw - turn)
    step = np.stack([c * rays[:, 0] - s * rays[:, 1], s * rays[:, 0] + c * rays[:, 1], rays[:, 2]], axis=1)
    step = np.where(np.abs(step) < _PARALLEL, _PARALLEL, step)
    half = np.array(body.extent)
    one, other = (-half - start) / step, (half - start) / step
    near = np.minimum(one, other).max(axis=1)
    leave = np.maximum(one, other).min(axis=1)
    far: Array = np.where((near <= leave) & (near > 0.0), near, np.inf)
    return far
