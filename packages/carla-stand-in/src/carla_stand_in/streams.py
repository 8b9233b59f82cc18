"""Streams: frames of the world for each client, and what sensors tell for whoever listens."""

from __future__ import annotations

import asyncio
import math
import struct
import time
from collections.abc import Callable
from typing import Any

from carla_stand_in import wire
from carla_stand_in.actors import Actor, BodyActor
from carla_stand_in.sensors import Sensors
from carla_stand_in.world import SPEED_LIMIT, Contact, World

FIRST_CLIENT = 2**31  # streams of worlds are above, those of sensors, which have an actor's id, below
_MOST_WAITING = 32 * 2**20  # bytes that a client has not read; it misses frames beyond
_MOST_WAITING_IN_ALL, _LITTLE_WAITING = 256 * 2**20, 2**16  # bytes of all, beyond which only who reads hears on
_MOST_CONNECTIONS = 512
_SAYING = 30.0  # [s], after which who has not said which stream is to be opened is gone
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
        log: Is told who is turned away.
    """

    def __init__(self, world: World, port: int, pack: Callable[[Any], bytes], log: Callable[[str], None]) -> None:
        self.port = port
        self._log = log
        self._world = world
        self._next = FIRST_CLIENT
        self._alive: set[int] = set()  # streams of worlds that a client has now
        self._connections = 0
        self._waiting = 0  # bytes that nobody has read yet
        self._sensors = Sensors(world, port, pack)
        self._open: dict[int, list[asyncio.StreamWriter]] = {}
        self._expected: dict[int, float] = {}
        self._loaders: set[int] = set()
        self._resting: set[int] = set()
        self._told = -math.inf  # when a sensor last told something [s, of a clock that only grows]
        world.on_step = self._publish
        world.on_spawn = Sensors.check

    async def serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        """One connection: a client says which stream it wants, and reads it from then on."""
        number = -1
        self._connections += 1
        try:
            if self._connections > _MOST_CONNECTIONS:
                self._log(f"a stream is not opened: {_MOST_CONNECTIONS} are open already")
                return
            async with asyncio.timeout(_SAYING):
                (number,) = _LENGTH.unpack(await reader.readexactly(_LENGTH.size))
            if not self._was_named(number):  # such as the letters of an HTTP request
                self._log(f"a stream is not opened: there was never one of the number {number}")
                return
            if number < FIRST_CLIENT or number in self._alive:
                self._open.setdefault(number, []).append(writer)
                self._expected.pop(number, None)
                if number >= FIRST_CLIENT:
                    self._send([writer], self._frame())
            await reader.read(1)  # clients send nothing more; this ends when they go
        except (ConnectionError, TimeoutError, asyncio.IncompleteReadError):
            pass
        finally:
            self._connections -= 1
            if writer in (writers := self._open.get(number, [])):
                writers.remove(writer)
                if not writers:
                    del self._open[number]
            writer.close()

    def _was_named(self, number: int) -> bool:
        """Whether a client can know of a stream, also of one that is gone: the wheel asks again for what is closed."""
        return FIRST_CLIENT <= number < self._next or self._world.was(number) is not None

    def begin(self) -> int:
        """A stream of the world for a client."""
        self._next += 1
        self._alive.add(self._next - 1)
        return self._next - 1

    def end(self, number: int) -> None:
        """A client is gone; so is its stream."""
        for numbers in (self._alive, self._loaders, self._resting):
            numbers.discard(number)

    def expect(self, number: int) -> None:
        """A client asks where a stream is; if it is a sensor's, it is about to open it."""
        sensor = self._world.actors.get(number)
        if sensor is not None and sensor.blueprint.group == "sensor":
            self._expected.setdefault(number, time.monotonic())

    async def opened(self) -> None:
        """Wait until the streams of sensors that were asked for are open, so that the next step is heard; not for long.

        The wheel opens them in a thread of its own, and a client that listens and ticks at once would miss the step.
        """
        while any(time.monotonic() - since < _OPENING for since in self._expected.values()):
            await asyncio.sleep(_POLL)
        self._expected.clear()

    async def loaded(self, client: int) -> int:
        """A client loaded a map: it gets another stream, and those of others that once loaded one rest until they call.

        The wheel ends in a segmentation fault where a frame arrives while it takes a stream down, and where a thread of
        it still looks at a picture then. So the old stream of the client is dropped, not closed, also if it is only
        opened now; what is under way has time to arrive, and a sensor's reading to be looked at; and
        a client whose world this was before, which may be gone but not yet collected by its process and then never
        calls again, is sent nothing. Who only looks on, or drives in another's world, goes on hearing.

        Args:
            client: Its stream until now.

        Returns:
            Its stream from now on.
        """
        self._sensors.forget()
        self._open = {number: writers for number, writers in self._open.items() if number >= FIRST_CLIENT}
        self._open.pop(client, None)
        self.end(client)
        self._resting = self._loaders & set(self._open)
        anew = self.begin()
        self._loaders.add(anew)
        await asyncio.sleep(max(_UNDER_WAY, self._told + _LOOKED_AT - time.monotonic()))
        return anew

    def wake(self, client: int) -> None:
        """A client called: if its stream rests, it goes on."""
        if client in self._resting:
            self._resting.remove(client)
            self._send(self._open.get(client, []), self._frame())

    def _publish(self, contacts: list[Contact]) -> None:
        everybody = (writer for writers in self._open.values() for writer in writers)
        self._waiting = sum(writer.transport.get_write_buffer_size() for writer in everybody)
        self._to_worlds(self._frame())
        for reading in self._sensors.readings(contacts, set(self._open)):
            sensor = reading.sensor
            pose = (*sensor.location, *sensor.rotation)
            head = wire.sensor_header(reading.kind, self._world.frame, self._world.time, pose)
            self._send(self._open[sensor.id], head + reading.content)
            self._told = time.monotonic()

    def _to_worlds(self, frame: bytes) -> None:
        for number, writers in self._open.items():
            if number >= FIRST_CLIENT and number not in self._resting:
                self._send(writers, frame)

    def _send(self, writers: list[asyncio.StreamWriter], body: bytes) -> None:
        most = _MOST_WAITING if self._waiting < _MOST_WAITING_IN_ALL else _LITTLE_WAITING
        for writer in writers:
            if not writer.is_closing() and (waiting := writer.transport.get_write_buffer_size()) < most:
                writer.write(_LENGTH.pack(len(body)) + body)
                self._waiting += writer.transport.get_write_buffer_size() - waiting

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
