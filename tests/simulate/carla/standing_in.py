"""A stand-in for CARLA in a process of its own, on loopback, and clients of it."""

from __future__ import annotations

import socket
import subprocess
import sys
from collections.abc import Callable, Generator
from contextlib import contextmanager
from typing import Any

DT = 0.05  # [s]


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
def serving(*options: str) -> Generator[tuple[int, subprocess.Popen[str]]]:
    """A server on a free port, which says that it is ready, and is gone afterwards."""
    port = free_port()
    command = [sys.executable, "-m", "chatscene", "serve-carla", "--port", str(port), *options]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as server:
        try:
            assert server.stdout is not None
            said = server.stdout.readline()
            assert "not CARLA" in said, said
            yield port, server
        finally:
            server.terminate()


def connected(port: int, dt: float | None = DT) -> tuple[Any, Any]:
    """A client and a fresh world, synchronous with a step of `dt` [s] unless that is None."""
    import carla

    client: Any = carla.Client("127.0.0.1", port)
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
