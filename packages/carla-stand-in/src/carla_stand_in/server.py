"""The server: calls on one port, streams on the next, one world behind both."""

from __future__ import annotations

import asyncio
import struct
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from inspect import isawaitable
from typing import Any

from carla_stand_in import wire
from carla_stand_in.actors import Actor
from carla_stand_in.batch import apply_batch
from carla_stand_in.calls import CALLS, Call
from carla_stand_in.calls_actors import ACTOR_CALLS, described
from carla_stand_in.log import Bounded
from carla_stand_in.reading import read
from carla_stand_in.streams import Streams
from carla_stand_in.traffic import PATIENCE, wake
from carla_stand_in.wire import Refused
from carla_stand_in.world import FOLDER, OPENDRIVE, STEP, World
from chatscene.errors import MapError, MissingExtra

_MOST = 64 * 2**20  # bytes of one message; the largest maps have some ten million
_MOST_UNFINISHED = 256 * 2**20  # bytes of messages of all clients that have not come to their end
_LONGEST_LIST = 100_000  # members, for which room is made before they are there
_MOST_VALUES = 200_000  # of one message: a value of a byte takes a hundred here
MOST_CLIENTS = 128
_MOST_MANAGERS = 16  # of a client
_AT_A_TIME = 2  # maps that are read
_AT_ONCE = 2**16  # bytes of one client's calls that are answered before another's turn
_REQUEST = 0
_LONGEST = 400  # characters of a message
_UNREADABLE = (
    TypeError, ValueError, LookupError, AttributeError, ArithmeticError, RuntimeError, RecursionError, struct.error
)  # fmt: skip


@dataclass(slots=True)
class Client:
    """Who calls.

    Attributes:
        number: Of its stream of the world, another one after each loading of its own.
        host: Where it is.
        managers: Ports of its traffic managers, which live in its process and end with it.
        ticked: When a tick of its was answered [s, of a clock that only grows], if it has asked for nothing since.
        called: Whether it ever called.
        unfinished: Bytes of a message that has not come to its end.
    """

    number: int
    host: str
    writer: asyncio.StreamWriter
    managers: list[int] = field(default_factory=list[int])
    ticked: float | None = None
    called: bool = False
    unfinished: int = 0


class Server:
    """Answers any number of clients.

    Args:
        world: What they share.
        host: Where it listens.
        port: Of the calls; streams are on the next.
        log: Is told what clients are refused, and which are cut off or woken.

    Raises:
        MissingExtra: The package msgpack is not installed.
    """

    def __init__(self, world: World, host: str, port: int, log: Callable[[str], None]) -> None:
        self._pack, self._unpacker, self._overflow = _codec()
        self._world = world
        self._host, self._port, self._log = host, port, Bounded(log)
        self._streams = Streams(world, port + 1, self._pack, self._log)
        self._managers: dict[int, list[Any]] = {}  # traffic managers by their port
        self._clients: list[Client] = []
        self._loading, self._reading = asyncio.Lock(), asyncio.Semaphore(_AT_A_TIME)
        self._own: dict[str, Call] = {
            "copy_opendrive_to_file": self._take_map,
            "get_episode_info": self._episode,
            "get_sensor_token": self._sensor,
            "load_new_episode": self._load,
            "spawn_actor": self._spawn,
            "spawn_actor_with_parent": self._spawn,
            "get_spectator": self._spectator,
            "get_actors_by_id": self._actors,
            "is_traffic_manager_running": self._is_managed,
            "get_traffic_manager_running": self._manager,
            "add_traffic_manager_running": self._add_manager,
            "destroy_traffic_manager": self._end_manager,
        }

    async def run(self, ready: Callable[[], None]) -> None:
        """Listen until cancelled.

        Raises:
            OSError: A port is taken.
        """
        async with (
            await asyncio.start_server(self._serve, self._host, self._port),
            await asyncio.start_server(self._streams.serve, self._host, self._streams.port),
        ):
            ready()
            async with asyncio.TaskGroup() as waking:
                while True:
                    await asyncio.sleep(STEP)
                    if not self._world.synchronous and not self._loading.locked():
                        self._world.step()
                    for client in self._clients:
                        if client.ticked is not None and time.monotonic() - client.ticked > PATIENCE:
                            client.ticked = time.monotonic()
                            waking.create_task(self._wake(client))

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        if not self._has_room():
            self._log(f"a client is turned away: {MOST_CLIENTS} are there already")
            writer.close()
            return
        client = Client(self._streams.begin(), (writer.get_extra_info("peername") or ("",))[0], writer)
        self._clients.append(client)
        values = _Values()
        unpacker = self._unpacker(values)
        came = 0
        try:
            while chunk := await reader.read(_AT_ONCE):
                came += len(chunk)
                unpacker.feed(chunk)
                for message in unpacker:
                    values.count = 0
                    client.unfinished = 0
                    if not client.called and not _is_call(message):  # such as letters of HTTP, each a number
                        raise TypeError("it does not begin with a call, so nothing of it is obeyed")
                    client.called = True
                    if _steps(message):
                        await self._streams.opened()
                    writer.write(await self._reply(client, message))
                    await writer.drain()  # who does not read gets no more answers
                client.unfinished = came - unpacker.tell()
                self._cut_off_the_longest()
        except ConnectionError:
            pass
        except (*_UNREADABLE, self._overflow) as error:
            self._log(f"a client is cut off, for what it sent is not msgpack: {type(error).__name__}: {error}")
        finally:
            self._clients.remove(client)
            self._streams.end(client.number)
            for port in client.managers:
                self._managers.pop(port, None)
            writer.close()

    def _has_room(self) -> bool:
        """Whether one more client can be there; for its sake, the first of those that never called goes."""
        if len(self._clients) < MOST_CLIENTS:
            return True
        idle = next((client for client in self._clients if not client.called), None)
        if idle is None:
            return False
        self._log("a client that never called is cut off: another one needs its place")
        idle.called = True  # it goes, so it is not found again
        idle.writer.transport.abort()
        return True

    def _cut_off_the_longest(self) -> None:
        """If messages that have not come to their end take too much, cut off who sends the longest."""
        if sum(client.unfinished for client in self._clients) > _MOST_UNFINISHED:
            longest = max(self._clients, key=lambda client: client.unfinished)
            self._log("a client is cut off: all together have sent too much that has not come to its end")
            longest.unfinished = 0
            longest.writer.transport.abort()

    async def _wake(self, client: Client) -> None:
        """If a client's traffic manager should have begun with a step and has not, wake it."""
        for port in client.managers:
            self._log(f"the traffic manager on port {port} missed a step, as the wheel's do; it is woken")
            try:
                await wake(client.host, port, self._pack)
            except OSError as error:
                self._log(f"the traffic manager on port {port} cannot be reached and is forgotten: {error}")
                self._end_manager(client, port)

    async def _reply(self, client: Client, message: Any) -> bytes:
        """The answer to a call, in whatever form it came; an error of the protocol's own would end the client."""
        match message:
            case [int(kind), int(number), str(method), [_, *arguments]] if kind == _REQUEST:
                pass  # what comes before the arguments says whether the client waits; it is answered anyway
            case _:
                number, method, arguments = _number_of(message), "a message", None
        try:
            answer = _no_call() if arguments is None else await self._answer(client, method, arguments)
            return self._pack([1, number, None, answer])
        except Refused as error:
            why = str(error)
        except _UNREADABLE as error:
            why = f"the arguments cannot be read: {type(error).__name__}: {error}"
        why = f"{method[:100]}: {why}"[:_LONGEST].encode(errors="replace").decode()
        self._log(f"refused: {why}")
        return self._pack([1, number, None, wire.refused(why)])

    async def _answer(self, client: Client, method: str, arguments: list[Any]) -> Any:
        self._streams.wake(client.number)
        client.ticked = time.monotonic() if method == "tick_cue" else None
        if method == "apply_batch":
            return apply_batch(self._world, *arguments)
        if method in self._own:
            value = self._own[method](client, *arguments)
            if isawaitable(value):
                value = await value
        elif call := CALLS.get(method) or ACTOR_CALLS.get(method):
            value = call(self._world, *arguments)
        else:
            raise Refused("this stand-in for CARLA does not support it")
        return wire.done() if value is None else wire.answered(value)

    def _episode(self, client: Client) -> list[Any]:
        return [self._world.episode, [self._token(client.number)]]

    def _sensor(self, _: Client, number: Any) -> list[bytes]:
        self._streams.expect(wire.whole(number))
        return [self._token(number)]

    def _token(self, stream: int) -> bytes:
        return wire.token(stream, self._streams.port)

    async def _take_map(self, _: Client, text: Any, *__: Any) -> None:
        """A map by a client; it is read now, since the call that follows names none."""
        text = wire.text(text)
        await self._read(OPENDRIVE, text)
        self._world.opendrive = text

    async def _load(self, client: Client, name: Any, reset: Any = True, *_: Any) -> None:
        """Another map, or the same anew."""
        name = wire.text(name)
        await self._read(*self._world.wanted(name))
        async with self._loading:
            self._world.load(name, reset=bool(reset))
            client.number = await self._streams.loaded(client.number)

    async def _read(self, short: str, text: str) -> None:
        """Have a map at hand; others are answered meanwhile.

        Raises:
            Refused: It cannot be used.
        """
        if self._world.has_read(short, text):
            return
        async with self._reading:
            try:
                found = await read(f"{FOLDER}{short}", text, ours=short in self._world.maps)
            except MapError as error:
                raise Refused(str(error)) from error
        self._world.ready(short, text, found)

    def _spawn(self, _: Client, what: Any, place: Any, parent: Any = 0, *__: Any) -> list[Any]:
        return self._described(self._world.spawn(what, place, wire.whole(parent)))

    def _described(self, actor: Actor) -> list[Any]:
        return described(actor, self._streams.port)

    def _spectator(self, _: Client) -> list[Any]:
        return self._described(self._world.spectator)

    def _actors(self, _: Client, numbers: list[Any]) -> list[Any]:
        actors = self._world.actors
        return [self._described(actors[number]) for number in dict.fromkeys(numbers) if number in actors]

    def _is_managed(self, _: Client, port: Any) -> bool:
        return port in self._managers

    def _manager(self, _: Client, port: Any) -> list[Any]:
        return self._managers.get(port, ["", 0])

    def _add_manager(self, client: Client, place: Any) -> bool:
        host, port = wire.text(place[0]), wire.whole(place[1])
        if not 0 < port < 2**16:
            raise Refused(f"{port} is not a port")
        if port in self._managers:
            return False
        if len(client.managers) >= _MOST_MANAGERS:
            raise Refused(f"a client has {_MOST_MANAGERS} traffic managers at most")
        self._managers[port] = [host, port]
        client.managers.append(port)
        return True

    def _end_manager(self, _: Client, port: Any) -> bool:
        for client in self._clients:
            client.managers = [other for other in client.managers if other != port]
        return self._managers.pop(port, None) is not None


def _no_call() -> Any:
    raise Refused("this is not a call: [0, number, name, [mode, arguments...]] is needed")


def _is_call(message: Any) -> bool:
    """Whether a message is a call, whatever its arguments are."""
    match message:
        case [int(kind), int(), str(), [*_]] if kind == _REQUEST:
            return True
        case _:
            return False


def _steps(message: Any) -> bool:
    """Whether a message makes the world go on."""
    match message:
        case [_, _, "tick_cue" | "apply_batch", *_]:
            return True
        case _:
            return False


def _number_of(message: Any) -> int:
    """The number that a reply to nonsense bears."""
    match message:
        case [_, int(number), *_] if 0 <= number < 2**32:
            return number
        case _:
            return 0


class _Values:
    """How many values of a message have come.

    Attributes:
        count: So many.
    """

    count = 0

    def __call__(self, values: Any) -> Any:
        """Called for each list and each map, once it is complete.

        Raises:
            ValueError: They are too many.
        """
        self.count += 1 + len(values)
        if self.count > _MOST_VALUES:
            raise ValueError(f"a message has more than {_MOST_VALUES} values")
        return values


def _codec() -> tuple[Callable[[Any], bytes], Callable[[_Values], Any], type[Exception]]:
    """How messages are written, a new reader of them, and what it raises where one is too long.

    Raises:
        MissingExtra: The package msgpack is not installed.
    """
    try:
        import msgpack
    except ImportError:
        raise MissingExtra("a stand-in for CARLA needs msgpack", extra="carla") from None

    def pack(value: Any) -> bytes:
        packed: bytes | None = msgpack.packb(value, use_bin_type=True, unicode_errors="surrogateescape")
        assert packed is not None  # it gives None only where it writes to a stream
        return packed

    def unpacker(values: _Values) -> Any:
        return msgpack.Unpacker(
            raw=False,
            strict_map_key=False,
            unicode_errors="surrogateescape",
            max_buffer_size=_MOST,
            max_array_len=_LONGEST_LIST,
            max_map_len=_LONGEST_LIST,
            list_hook=values,
            object_hook=values,
        )

    return pack, unpacker, msgpack.UnpackException
