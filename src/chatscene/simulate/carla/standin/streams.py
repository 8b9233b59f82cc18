"""Streams: frames of the world for each client, and what sensors tell for whoever listens."""

from __future__ import annotations

import asyncio
import math
import struct
import time
from collections.abc import Callable
from typing import Any

from chatscene.simulate.carla.standin import wire
from chatscene.simulate.carla.standin.actors import Actor, BodyActor
from chatscene.simulate.carla.standin.sensors import Sensors
from chatscene.simulate.carla.standin.world import SPEED_LIMIT, Contact, World

FIRST_CLIENT = 2**31  # streams of worlds are above, those of sensors, which have an actor's id, below
_MOST_WAITING = 32 * 2**20  # bytes that a client has not read; it misses frames beyond
_UNDER_WAY = 0.05  # [s]
_LOOKED_AT = 0.4  # [s], after which a client has done with what a sensor told
_OPENING, _POLL = 0.5, 0.001  # [s]
_LENGTH = struct.Struct("<I")


class Streams:
    """All open streams.

    Each client has a stream of the world to itself, so that those of the others go on where one loads a map.

    Args:
        world: What they tell of.
        port: Where they are.
        pack: Msgpack.
    """

    def __init__(self, world: World, port: int, pack: Callable[[Any], bytes]) -> None:
        self.port = port
        self._world = world
        self._sensors = Sensors(world, port, pack)
        self._open: dict[int, list[asyncio.StreamWriter]] = {}
        self._expected: dict[int, float] = {}
        self._loaders: set[int] = set()
        self._resting: set[int] = set()
        self._dropped: set[int] = set()
        self._told = -math.inf  # when a sensor last told something [s, of a clock that only grows]
        world.on_step = self._publish
        world.on_spawn = Sensors.check

    async def serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        """One connection: a client says which stream it wants, and reads it from then on."""
        number = -1
        try:
            (number,) = _LENGTH.unpack(await reader.readexactly(_LENGTH.size))
            if number not in self._dropped:
                self._open.setdefault(number, []).append(writer)
                self._expected.pop(number, None)
                if number >= FIRST_CLIENT:
                    _send([writer], self._frame())
            await reader.read(1)  # clients send nothing more; this ends when they go
        except (ConnectionError, asyncio.IncompleteReadError):
            pass
        finally:
            if writer in self._open.get(number, []):
                self._open[number].remove(writer)
            writer.close()

    def expect(self, number: int) -> None:
        """A client asks where a stream is; if it is a sensor's, it is about to open it."""
        if number in self._world.actors:
            self._expected[number] = time.monotonic()

    async def opened(self) -> None:
        """Wait until the streams of sensors that were asked for are open, so that the next step is heard; not for long.

        The wheel opens them in a thread of its own, and a client that listens and ticks at once would miss the step.
        """
        while any(time.monotonic() - since < _OPENING for since in self._expected.values()):
            await asyncio.sleep(_POLL)
        self._expected.clear()

    def loaded(self, client: int, anew: int) -> None:
        """A client loaded a map: it gets another stream, and those of others that once loaded one rest until they call.

        The wheel ends in a segmentation fault where a frame arrives while it takes a stream down, and where a thread of
        it still looks at a picture then. So the old stream of the client is dropped, not closed, also if it is only
        opened now; what is under way has time to arrive, and a sensor's reading to be looked at; and
        a client whose world this was before, which may be gone but not yet collected by its process and then never
        calls again, is sent nothing. Who only looks on, or drives in another's world, goes on hearing.

        Args:
            client: Its stream until now.
            anew: Its stream from now on.
        """
        self._sensors.forget()
        self._open = {number: writers for number, writers in self._open.items() if number >= FIRST_CLIENT}
        self._open.pop(client, None)
        self._dropped.add(client)
        self._loaders.discard(client)
        self._resting = self._loaders & set(self._open)
        self._loaders.add(anew)
        time.sleep(max(_UNDER_WAY, self._told + _LOOKED_AT - time.monotonic()))

    def wake(self, client: int) -> None:
        """A client called: if its stream rests, it goes on."""
        if client in self._resting:
            self._resting.remove(client)
            _send(self._open.get(client, []), self._frame())

    def _publish(self, contacts: list[Contact]) -> None:
        self._to_worlds(self._frame())
        heard = {number for number, writers in self._open.items() if writers}
        for reading in self._sensors.readings(contacts, heard):
            sensor = reading.sensor
            pose = (*sensor.location, *sensor.rotation)
            head = wire.sensor_header(reading.kind, self._world.frame, self._world.time, pose)
            _send(self._open[sensor.id], head + reading.content)
            self._told = time.monotonic()

    def _to_worlds(self, frame: bytes) -> None:
        for number, writers in self._open.items():
            if number >= FIRST_CLIENT and number not in self._resting:
                _send(writers, frame)

    def _frame(self) -> bytes:
        world = self._world
        parts = [
            wire.sensor_header(wire.WORLD_OBSERVER, world.frame, world.time),
            wire.episode_state(world.episode, world.time, world.dt),
        ]
        parts += [self._state(actor) for actor in world.actors.values()]
        return b"".join(parts)

    def _state(self, actor: Actor) -> bytes:
        turning = (0.0, 0.0, actor.turning)
        numbers = (*actor.location, *actor.rotation, *actor.velocity, *turning, *actor.acceleration)
        return wire.actor_state(actor.id, numbers, self._of_kind(actor))

    def _of_kind(self, actor: Actor) -> bytes:
        lights = self._world.lights
        if isinstance(actor, BodyActor):
            if actor.blueprint.group == "vehicle":
                waits = None if actor.light is None else (actor.light, lights.by_actor[actor.light].state)
                return wire.vehicle_state(actor.control, SPEED_LIMIT, waits)
            return wire.walker_state(actor.control) if actor.blueprint.group == "walker" else b""
        light = lights.by_actor.get(actor.id)
        if light is None:
            return b""
        return wire.light_state(light.signal.id, light.times, light.elapsed, 0, lights.frozen, light.state)


def _send(writers: list[asyncio.StreamWriter], body: bytes) -> None:
    for writer in writers:
        if not writer.is_closing() and writer.transport.get_write_buffer_size() < _MOST_WAITING:
            writer.write(_LENGTH.pack(len(body)) + body)
