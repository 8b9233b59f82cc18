"""A CARLA server as one client has it: reached, checked, loaded for each scene, and given back as it is used to run.

The wheel ends a process that it cannot talk sense with, so whoever listens is asked for the version by hand first.
"""

from __future__ import annotations

import logging
import math
import re
import socket
from collections.abc import Generator
from contextlib import contextmanager
from dataclasses import dataclass
from importlib.metadata import version
from pathlib import Path
from typing import Any

import carla  # pyright: ignore[reportMissingTypeStubs]

from chatscene.errors import ServerError, SettingsError
from chatscene.simulate.carla.served import as_served, same_roads
from chatscene.simulate.watchdog import unlimited

HOST, PORT = "127.0.0.1", 2000
PATIENCE = 10.0  # [s] for an answer
LOADING = 120.0  # [s] for a map
SUBSTEP = 0.01  # [s]
MOST_SUBSTEPS = 16  # CARLA's own limit
SMALLEST = 0.05  # [m], half of what has a size
_FAR_ABOVE = 500.0  # [m], where nothing is in the way of what is measured
_ASK_VERSION = b"\x94\x00\x01\xa7version\x91\x91\xc2"  # msgpack-rpc: [0, 1, "version", [[false]]]
_VERSION = re.compile(rb"\A\x94\x01.*?(\d+\.\d+[\w.-]*)", re.DOTALL)  # [1, 1, nil, …]: the version is in it somewhere
_TIMED_OUT = "time-out"  # in the wheel's message
_FLAT = carla.OpendriveGenerationParameters(wall_height=0.0)
_log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True, kw_only=True)
class Measured:
    """What a blueprint is on this server.

    Attributes:
        length, width, height: Of its box [m].
        ahead, left: Where the middle of its box lies, seen from its origin [m].
        above: How far the bottom of its box lies below its origin [m].
        wheel_angle: Largest angle of its front wheels [rad]; 0 for what has none.
    """

    length: float
    width: float
    height: float
    ahead: float
    left: float
    above: float
    wheel_angle: float


def address(simulator: str) -> tuple[str, int]:
    """Host and port of a simulator's name: ``carla``, ``carla:HOST`` or ``carla:HOST:PORT``.

    Raises:
        SettingsError: It is no such name.
    """
    _, _, place = simulator.partition(":")
    host, _, port = place.partition(":")
    if (port and not port.isdigit()) or not 0 < int(port or PORT) < 65535 or (port and not host):
        raise SettingsError(f"{simulator!r} names no CARLA server; write carla, carla:HOST or carla:HOST:PORT")
    return host or HOST, int(port or PORT)


_connections: dict[tuple[str, int], Connection] = {}


def connected(host: str, port: int) -> Connection:
    """This process's connection to a server; a new one if there is none, or if the last was lost.

    Raises:
        ServerError: No CARLA server of the wheel's version answers there.
    """
    held = _connections.get((host, port))
    if held is None or held.lost:
        held = _connections[host, port] = Connection(host, port)
    return held


class Connection:
    """A server and its world.

    Attributes:
        stands_in: Whether it is `chatscene serve-carla` and not CARLA.
        ground: The wheel's map of the world that is loaded.

    Raises:
        ServerError: No CARLA server of the wheel's version answers there.
    """

    def __init__(self, host: str, port: int) -> None:
        self.place = f"{host}:{port}"
        self._address = host, port
        self.lost = False
        self.version = _version_at(host, port)
        if self.version != version("carla"):
            raise ServerError(
                f"the server at {self.place} is CARLA {self.version}, and the installed wheel speaks to CARLA "
                f"{version('carla')} only; start a server of that version"
            )
        with self.asking("let a client in"):
            self.client: Any = carla.Client(host, port)
            self.client.set_timeout(PATIENCE)
            self.stands_in = "stands_in_for" in self.client.get_world().get_spectator().attributes
            self._library: Any = self.client.get_world().get_blueprint_library()
        self.ground: Any = None
        self._loaded: Path | None = None
        self._measured: dict[str, Measured] = {}

    @contextmanager
    def asking(self, what: str) -> Generator[None]:
        """Ask the server to do something.

        Raises:
            ServerError: It was lost, or refuses.
        """
        try:
            yield
        except RuntimeError as error:
            if _TIMED_OUT not in str(error):
                raise ServerError(f"the CARLA server at {self.place} did not {what}: {error}") from error
            raise self._gone(what) from error

    def _gone(self, what: str) -> ServerError:
        self.lost = True
        return ServerError(
            f"the CARLA server at {self.place} was lost: it was to {what}, and did not answer. What is finished is "
            "kept; start it again, then go on: chatscene resume DIR"
        )

    def begin(self, map_path: Path, dt: float) -> Any:
        """A fresh world on a map, which waits for ticks of `dt` [s].

        Raises:
            ServerError: The server was lost, or cannot use the map.
        """
        what = f"load the map {map_path.stem!r}"
        try:
            _version_at(*self._address)  # for the wheel would wait for a dead server as long as a map may take
        except ServerError as error:
            raise self._gone(what) from error
        with unlimited(), self.asking(what):  # no program is to blame for a map that takes long
            world = self._load(map_path)
            settings = world.get_settings()
            settings.synchronous_mode = True
            settings.fixed_delta_seconds = dt
            settings.substepping = True
            settings.max_substeps = min(MOST_SUBSTEPS, max(1, math.ceil(dt / SUBSTEP - 1e-9)))
            settings.max_substep_delta_time = dt / settings.max_substeps
            settings.deterministic_ragdolls = True
            world.apply_settings(settings)
            world.freeze_all_traffic_lights(True)
        return world

    def tick(self, world: Any) -> Any:
        """Go on by a step; gives the snapshot after it.

        Raises:
            ServerError: The server was lost.
        """
        with self.asking("go on by a tick"):
            world.tick(PATIENCE)
            return world.get_snapshot()

    def end(self, world: Any) -> None:
        """Let the world run by itself again, for a server that waits for ticks stands still for everybody."""
        with self.asking("run by itself again"):
            settings = world.get_settings()
            settings.synchronous_mode = False
            settings.fixed_delta_seconds = None
            world.apply_settings(settings)

    def take_away(self, *actors: int) -> None:
        """Take actors away, by their ids; one that is gone already is no error.

        The server is asked itself. The wheel's `Actor.destroy` asks only for an actor that it takes for alive, and of
        one that is in no snapshot yet it reads a state that nobody wrote.

        Raises:
            ServerError: The server was lost.
        """
        with self.asking("take actors away"):
            self.client.apply_batch_sync([carla.command.DestroyActor(actor) for actor in actors])

    def measured(self, blueprint: str) -> Measured:
        """What a blueprint is; one of it is made far above the roads for that, the first time.

        Raises:
            ServerError: The server has no such blueprint, or one without a size; or it was lost.
        """
        if blueprint not in self._measured:
            with self.asking(f"measure {blueprint}"):
                above = carla.Transform(carla.Location(z=_FAR_ABOVE))
                actor = self.client.get_world().spawn_actor(self.blueprint(blueprint), above)
                box = actor.bounding_box
                wheels = actor.get_physics_control().wheels if blueprint.startswith("vehicle.") else ()
                self.take_away(actor.id)
            if not all(SMALLEST < size < math.inf for size in (box.extent.x, box.extent.y, box.extent.z)):
                raise ServerError(f"on the CARLA server at {self.place}, {blueprint} has no size")
            self._measured[blueprint] = Measured(
                length=2 * box.extent.x,
                width=2 * box.extent.y,
                height=2 * box.extent.z,
                ahead=box.location.x,
                left=-box.location.y,
                above=box.extent.z - box.location.z,
                wheel_angle=math.radians(max((wheel.max_steer_angle for wheel in wheels), default=0.0)),
            )
        return self._measured[blueprint]

    def blueprint(self, name: str) -> Any:
        """A blueprint of the server's.

        Raises:
            ServerError: It has none of that name.
        """
        try:
            return self._library.find(name)
        except IndexError:
            raise ServerError(f"the CARLA server at {self.place} has no blueprint {name!r}") from None

    def _load(self, map_path: Path) -> Any:
        """A fresh world: the same map anew, or the server's own of that name and with our roads, or else ours.

        The engine's state outlives its actors, so that only a world that was loaded anew repeats a scene.
        """
        self.client.set_timeout(LOADING)
        try:
            if self._loaded == map_path:
                return self.client.reload_world()
            text = map_path.read_text(encoding="utf-8")
            world = self._own(map_path.stem, text)
            world = world or self.client.generate_opendrive_world(as_served(text, map_path.stem), _FLAT)
            self.ground, self._loaded = world.get_map(), map_path
            return world
        finally:
            self.client.set_timeout(PATIENCE)

    def _own(self, name: str, text: str) -> Any | None:
        """A fresh world on the server's own map of that name, if it has one with the same roads."""
        if name not in {place.rpartition("/")[2] for place in self.client.get_available_maps()}:
            return None
        world = self.client.load_world(name)
        if same_roads(text, world.get_map().to_opendrive()):
            return world
        _log.warning(
            "the map %r of the CARLA server at %s has other roads than ours: it is given ours", name, self.place
        )
        return None


def _version_at(host: str, port: int) -> str:
    """The version of the server that listens somewhere."""
    answer = b""
    try:
        with socket.create_connection((host, port), timeout=PATIENCE) as line:
            line.sendall(_ASK_VERSION)
            while (found := _VERSION.search(answer)) is None and (more := line.recv(1024)):
                answer += more
    except TimeoutError:
        found = None
    except OSError as error:
        if not answer and not isinstance(error, ConnectionResetError):
            raise ServerError(
                f"no CARLA server is at {host}:{port} ({error.strerror or error}); start one, or the stand-in: "
                f"chatscene serve-carla --port {port}; one elsewhere is named so: --simulator carla:HOST:PORT"
            ) from error
        found = None
    if found is None:
        raise ServerError(f"what listens at {host}:{port} is not a CARLA server: it does not answer with its version")
    return found[1].decode()
