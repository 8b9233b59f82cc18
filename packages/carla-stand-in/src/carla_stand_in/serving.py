"""Serve a map until told to stop."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from pathlib import Path

from carla_stand_in.files import Files
from carla_stand_in.server import Server
from carla_stand_in.wire import Refused
from carla_stand_in.world import World
from chatscene.errors import MapError, SettingsError
from chatscene.maps.network import PACKAGED, load_network, resolve_map
from chatscene.settings import SimulationSettings
from chatscene.simulate.physics import PhysicsOf
from chatscene.simulate.simulator import load_simulator


def serve(
    maps: Sequence[str],
    host: str,
    port: int,
    settings: SimulationSettings,
    *,
    files: Path | None = None,
    ready: Callable[[World], None],
    log: Callable[[str], None],
) -> None:
    """Answer CARLA's clients until cancelled.

    Args:
        maps: Names or files of maps (see `chatscene.maps.network.resolve_map`); the first is loaded, the others can be.
        host: Where to listen.
        port: Of the calls; streams are on the next.
        settings: Whose bodies move, and how; the simulator has to be one that is made of a physics.
        files: Below which folder clients may have files written and read; without one, a private one is made for them.
        ready: Called once clients can call.
        log: Is told what clients are refused, and which are cut off or woken.

    Raises:
        MapError: A map cannot be used.
        MissingExtra: The extra `carla` is not installed.
        SettingsError: The simulator brings no bodies, or the port cannot be had.
    """
    paths = [resolve_map(name) for name in maps]
    for path in paths:
        if path not in PACKAGED.values():
            load_network(path)  # refused here as everywhere, and within its time: the wheel's reading has none
    try:
        world = World({path.stem: path for path in paths}, paths[0].stem, _bodies_of(paths[0], settings), Files(files))
    except Refused as error:
        raise MapError(str(error)) from error
    try:
        asyncio.run(Server(world, host, port, log).run(lambda: ready(world)))
    except OSError as error:
        raise SettingsError(f"cannot listen on {host}, ports {port} and {port + 1}: {error.strerror}") from error


def _bodies_of(path: Path, settings: SimulationSettings) -> PhysicsOf:
    physics_of: PhysicsOf | None = getattr(load_simulator(path, settings), "physics_of", None)
    if physics_of is None:
        raise SettingsError(
            f"the simulator {settings.simulator!r} brings no bodies that a stand-in for CARLA could move"
        )
    return physics_of
