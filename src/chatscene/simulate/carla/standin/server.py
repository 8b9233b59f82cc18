"""The server: calls on one port, streams on the next, one world behind both."""

from __future__ import annotations

import asyncio
import itertools
import struct
import time
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from chatscene.errors import MissingExtra
from chatscene.simulate.carla.standin import wire
from chatscene.simulate.carla.standin.actors import Actor
from chatscene.simulate.carla.standin.batch import apply_batch
from chatscene.simulate.carla.standin.calls import CALLS, Call, load_new_episode
from chatscene.simulate.carla.standin.calls_actors import ACTOR_CALLS, described
from chatscene.simulate.carla.standin.streams import FIRST_CLIENT, Streams
from chatscene.simulate.carla.standin.traffic import PATIENCE, wake
from chatscene.simulate.carla.standin.wire import Refused
from chatscene.simulate.carla.standin.world import STEP, World

_MOST = 64 * 2**20  # bytes of one message; the largest maps have some ten million
_LONGEST_LIST = 100_000  # members, for which room is made before they are there
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
    """

    number: int
    host: str
    managers: list[int] = field(default_factory=list[int])
    ticked: float | None = None


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
        self._host, self._port, self._log = host, port, log
        self._streams = Streams(world, port + 1, self._pack)
        self._managers: dict[int, list[Any]] = {}  # traffic managers by their port
        self._clients: list[Client] = []
        self._world_streams = itertools.count(FIRST_CLIENT)
        self._own: dict[str, Call] = {
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
                    if not self._world.synchronous:
                        self._world.step()
                    for client in self._clients:
                        if client.ticked is not None and time.monotonic() - client.ticked > PATIENCE:
                            client.ticked = time.monotonic()
                            waking.create_task(self._wake(client))

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        client = Client(self._next_stream(), (writer.get_extra_info("peername") or ("",))[0])
        self._clients.append(client)
        unpacker = self._unpacker()
        known = False  # whether it began as a client of CARLA does
        try:
            while chunk := await reader.read(_AT_ONCE):
                unpacker.feed(chunk)
                for message in unpacker:
                    if not known and not _is_call(message):  # such as the letters of an HTTP request, each a number
                        raise TypeError("it does not begin with a call, so nothing of it is obeyed")
                    known = True
                    if _steps(message):
                        await self._streams.opened()
                    writer.write(self._reply(client, message))
                    await writer.drain()  # who does not read gets no more answers
        except ConnectionError:
            pass
        except (*_UNREADABLE, self._overflow) as error:
            self._log(f"a client is cut off, for what it sent is no msgpack: {type(error).__name__}: {error}")
        finally:
            self._clients.remove(client)
            for port in client.managers:
                self._managers.pop(port, None)
            writer.close()

    async def _wake(self, client: Client) -> None:
        """If a client's traffic manager should have begun with a step and has not, wake it."""
        for port in client.managers:
            self._log(f"the traffic manager on port {port} missed a step, as the wheel's do; it is woken")
            try:
                await wake(client.host, port, self._pack)
            except OSError as error:
                self._log(f"the traffic manager on port {port} cannot be reached and is forgotten: {error}")
                self._end_manager(client, port)

    def _reply(self, client: Client, message: Any) -> bytes:
        """The answer to a call, in whatever form it came; an error of the protocol's own would end the client."""
        match message:
            case [int(kind), int(number), str(method), [_, *arguments]] if kind == _REQUEST:
                pass  # what comes before the arguments says whether the client waits; it is answered anyway
            case _:
                number, method, arguments = _number_of(message), "a message", None
        try:
            answer = _no_call() if arguments is None else self._answer(client, method, arguments)
            return self._pack([1, number, None, answer])
        except Refused as error:
            why = str(error)
        except _UNREADABLE as error:
            why = f"the arguments cannot be read: {type(error).__name__}: {error}"
        why = f"{method[:100]}: {why}"[:_LONGEST].encode(errors="replace").decode()
        self._log(f"refused: {why}")
        return self._pack([1, number, None, wire.refused(why)])

    def _answer(self, client: Client, method: str, arguments: list[Any]) -> Any:
        self._streams.wake(client.number)
        client.ticked = time.monotonic() if method == "tick_cue" else None
        if method == "apply_batch":
            return apply_batch(self._world, *arguments)
        if method in self._own:
            value = self._own[method](client, *arguments)
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

    def _next_stream(self) -> int:
        return next(self._world_streams)

    def _token(self, stream: int) -> bytes:
        return wire.token(stream, self._streams.port)

    def _load(self, client: Client, *arguments: Any) -> None:
        load_new_episode(self._world, *arguments)
        anew = self._next_stream()
        self._streams.loaded(client.number, anew)
        client.number = anew

    def _spawn(self, _: Client, what: Any, place: Any, parent: Any = 0, *__: Any) -> list[Any]:
        return self._described(self._world.spawn(what, place, wire.whole(parent)))

    def _described(self, actor: Actor) -> list[Any]:
        return described(actor, self._streams.port)

    def _spectator(self, _: Client) -> list[Any]:
        return self._described(self._world.spectator)

    def _actors(self, _: Client, numbers: list[Any]) -> list[Any]:
        actors = self._world.actors
        return [self._described(actors[number]) for number in numbers if number in actors]

    def _is_managed(self, _: Client, port: Any) -> bool:
        return port in self._managers

    def _manager(self, _: Client, port: Any) -> list[Any]:
        return self._managers.get(port, ["", 0])

    def _add_manager(self, client: Client, place: Any) -> bool:
        host, port = wire.text(place[0]), wire.whole(place[1])
        if not 0 < port < 2**16:
            raise Refused(f"{port} is no port")
        if port in self._managers:
            return False
        self._managers[port] = [host, port]
        client.managers.append(port)
        return True

    def _end_manager(self, _: Client, port: Any) -> bool:
        for client in self._clients:
            client.managers = [other for other in client.managers if other != port]
        return self._managers.pop(port, None) is not None


def _no_call() -> Any:
    raise Refused("this is no call: [0, number, name, [mode, arguments...]] is needed")


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


def _codec() -> tuple[Callable[[Any], bytes], Callable[[], Any], type[Exception]]:
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

    def unpacker() -> Any:
        return msgpack.Unpacker(
            raw=False,
            strict_map_key=False,
            unicode_errors="surrogateescape",
            max_buffer_size=_MOST,
            max_array_len=_LONGEST_LIST,
            max_map_len=_LONGEST_LIST,
        )

    return pack, unpacker, msgpack.UnpackException
