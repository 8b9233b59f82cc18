"""The protocol's layouts: envelopes of calls, tokens of streams, frames of the world.

Facts from runs of the PyPI wheel carla 0.9.16; see `docs/carla.md`. Calls are msgpack-rpc on one port, streams are
length-prefixed on the next. All positions here are CARLA's: metres, left-handed, z up; angles in degrees.
"""

from __future__ import annotations

import math
import struct
from collections.abc import Sequence
from typing import Any

VERSION = "0.9.16"
FARTHEST = 1e7  # [m]; also the largest number of any other kind that is taken

# Positions in the wheel's registry of sensors.
COLLISION, GNSS, IMU, OBSTACLE, RADAR, LABELLED_LIDAR, LIDAR, PICTURE, TAGS = 0, 4, 5, 7, 9, 10, 11, 13, 14
WORLD_OBSERVER = 17

_TCP = 1
_HOST_OF_CLIENT = 0
_TOKEN = struct.Struct("<IHBB16s")
_HEADER = struct.Struct("<QQd6f")
_EPISODE = struct.Struct("<Qdf3iI")
_ACTOR = struct.Struct("<IB15f")
_VEHICLE = struct.Struct("<3f3?ifB?IB")
_WALKER = struct.Struct("<4f?")
_LIGHT = struct.Struct("<32s4fI?B")
_OF_KIND = 54  # bytes of what only one kind of actor has


class Refused(Exception):  # noqa: N818 - an answer, not a fault
    """A call that is answered with a message in place of a value."""


def answered(value: Any) -> list[Any]:
    """The envelope of a value."""
    return [[1, value]]


def done() -> list[Any]:
    """The envelope of a call that has no value."""
    return [[False]]


def refused(message: str) -> list[Any]:
    """The envelope of an error; the client raises it as a RuntimeError with this message."""
    return [[0, [message]]]


def token(stream: int, port: int) -> bytes:
    """How a client finds a stream: on the host it already talks to."""
    return _TOKEN.pack(stream, port, _TCP, _HOST_OF_CLIENT, b"")


def sensor_header(kind: int, frame: int, time: float, pose: Sequence[float] = (0.0,) * 6) -> bytes:
    """What every message of a stream begins with.

    Args:
        kind: Position in the wheel's registry of sensors.
        frame: Number of the step.
        time: Simulated [s].
        pose: Location [m], then pitch, yaw, roll [degrees].
    """
    return _HEADER.pack(kind, frame, time, *pose)


def episode_state(episode: int, time: float, dt: float) -> bytes:
    """The head of a world frame; the platform's time is the simulated one, so that frames repeat."""
    return _EPISODE.pack(episode, time, dt, 0, 0, 0, 0)


def actor_state(actor: int, numbers: Sequence[float], of_kind: bytes) -> bytes:
    """One actor in a world frame.

    Args:
        actor: Its id.
        numbers: 15: location [m], pitch, yaw, roll [degrees], velocity [m/s], angular velocity [degrees/s],
            acceleration [m/s²].
        of_kind: What only its kind has.
    """
    return _ACTOR.pack(actor, 1, *numbers) + of_kind.ljust(_OF_KIND, b"\0")


def vehicle_state(control: Sequence[Any], speed_limit: float, light: tuple[int, int] | None) -> bytes:
    """What a vehicle has in a frame.

    Args:
        control: Throttle, steer, brake, hand brake, reverse, manual gears, gear.
        speed_limit: [km/h].
        light: The light it waits at, as (id, state); None for none, which the client shows as green.
    """
    state = (2, False, 0) if light is None else (light[1], True, light[0])
    return _VEHICLE.pack(*control, speed_limit, *state, 0)


def walker_state(control: Sequence[Any]) -> bytes:
    """What a walker has in a frame: direction, speed [m/s], whether it jumps."""
    direction, speed, jump = control
    return _WALKER.pack(*direction, speed, jump)


def light_state(sign: str, times: Sequence[float], elapsed: float, pole: int, frozen: bool, state: int) -> bytes:
    """What a traffic light has in a frame: OpenDRIVE id, green, yellow, red time [s], and where it is in them."""
    return _LIGHT.pack(sign.encode()[:31], *times, elapsed, pole, frozen, state)


def numbers(value: Any, count: int) -> list[float]:
    """`count` finite numbers out of a message.

    Raises:
        Refused: It is anything else.
    """
    if not isinstance(value, list | tuple) or len(value) < count:
        raise Refused(f"{count} numbers are needed")
    return [number(one) for one in value[:count]]


def number(value: Any) -> float:
    """One finite number out of a message.

    Raises:
        Refused: It is anything else.
    """
    if not isinstance(value, int | float) or not math.isfinite(value) or abs(value) > FARTHEST:
        raise Refused(f"a number between {-FARTHEST:g} and {FARTHEST:g} is needed")
    return float(value)


def whole(value: Any) -> int:
    """One whole number that is not negative out of a message.

    Raises:
        Refused: It is anything else.
    """
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < 2**32:
        raise Refused("a whole number is needed")
    return value


def text(value: Any) -> str:
    """A text out of a message.

    Raises:
        Refused: It is anything else.
    """
    if not isinstance(value, str):
        raise Refused("a text is needed")
    return value


def letter(value: Any) -> str:
    """One letter out of a message, which C++ may send as its number.

    Raises:
        Refused: It is anything else.
    """
    if isinstance(value, int) and not isinstance(value, bool) and 0 < value < 128:
        return chr(value)
    if isinstance(value, str) and len(value) == 1:
        return value
    raise Refused("one letter is needed")


def transform(value: Any) -> tuple[list[float], list[float]]:
    """Location [m] and pitch, yaw, roll [degrees] out of a message.

    Raises:
        Refused: It is anything else.
    """
    if not isinstance(value, list | tuple) or len(value) != 2:
        raise Refused("a transform is needed")
    return numbers(value[0], 3), numbers(value[1], 3)
