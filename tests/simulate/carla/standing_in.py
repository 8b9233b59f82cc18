"""A stand-in for CARLA in a process of its own, on loopback, and clients of it."""

from __future__ import annotations

import socket
import subprocess
import sys
import time
from collections.abc import Callable, Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

DT = 0.05  # [s]
MKZ, WALKER = "vehicle.lincoln.mkz_2017", "walker.pedestrian.0001"


def free_port() -> int:
    """A port of loopback that is free, as is the next."""
    while True:
        with socket.socket() as first, socket.socket() as second:
            first.bind(("127.0.0.1", 0))
            port: int = first.getsockname()[1]
            try:
                second.bind(("127.0.0.1", port + 1))
            except (OSError, OverflowError):
                continue
            return port


@contextmanager
def serving(*options: str, port: int = 0, folder: Path | None = None) -> Generator[tuple[int, subprocess.Popen[str]]]:
    """A server, on a free port unless one is named, which says that it is ready, and is gone afterwards.

    It begins in `folder`; None for that of the tests.
    """
    port = port or free_port()
    command = [sys.executable, "-P", "-m", "chatscene", "serve-carla", "--port", str(port), *options]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, cwd=folder) as server:
        try:
            assert server.stdout is not None
            said = server.stdout.readline()
            assert "not CARLA" in said, said
            yield port, server
        finally:
            server.terminate()


def connected(port: int, dt: float | None = DT, client: Any = None) -> tuple[Any, Any]:
    """A client, another one unless it is given, and a fresh world, synchronous with a step of `dt` [s] or None."""
    import carla

    if client is None:
        client = carla.Client("127.0.0.1", port)
        client.set_timeout(60.0)
    world = client.load_world("town")
    if dt is not None:
        settings = world.get_settings()
        settings.synchronous_mode, settings.fixed_delta_seconds = True, dt
        world.apply_settings(settings)
    return client, world


def ticked_until(world: Any, true: Callable[[], bool], most: int = 400) -> int:
    """Tick until something is true; gives how often."""
    for ticks in range(most):
        if true():
            return ticks
        world.tick()
    raise AssertionError(f"not true after {most} ticks")


def spawned(world: Any, blueprint: str = MKZ, point: int = 0, ahead: float = 0.0) -> Any:
    """An actor at a place to begin at, or so far ahead of it [m]."""
    place = world.get_map().get_spawn_points()[point]
    place.location += place.get_forward_vector() * ahead
    return world.spawn_actor(world.get_blueprint_library().find(blueprint), place)


def speed(actor: Any) -> float:
    """[m/s]."""
    return actor.get_velocity().length()


def listened(world: Any, name: str, parent: Any, height: float = 0.0, **attributes: str) -> list[Any]:
    """What a sensor on `parent` tells, as it comes; it hears the next tick."""
    import carla

    blueprint = world.get_blueprint_library().find(name)
    for key, value in attributes.items():
        blueprint.set_attribute(key, value)
    place: Any = carla.Transform(carla.Location(z=height))
    sensor = world.spawn_actor(blueprint, place, attach_to=parent)
    heard: list[Any] = [sensor]  # kept alive with what it tells
    sensor.listen(heard.append)
    return heard


def settled(heard: list[Any], count: int) -> list[Any]:
    """The first messages of a sensor, once there are as many."""
    for _ in range(200):
        if len(heard) > count:
            break
        time.sleep(0.02)
    return heard[1 : count + 1]
