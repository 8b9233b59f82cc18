"""The stand-in for CARLA under load: whether it or its clients hang or crash, and whether places repeat.

    python benchmarks/carla_stress.py [CYCLES] [PROCESSES]

1. Two clients at once: one drives and loads a map every 50 ticks, the other only looks on, for 20 loads.
2. CYCLES times (1000): load a map, spawn ten cars, ten ticks, destroy five of them.
3. PROCESSES clients (50), each a process that loads, spawns twelve cars that drive, and ticks 200 times: one after the
   other, then eight at a time, each of the eight with a server of its own. All of them have to find the same places.
4. The same number of processes with twelve cars of a seeded traffic manager of the wheel, one after the other.

A process that does not end within 60 s hangs; one with another exit status than 0 crashed. The machine's load is told
behind each. Needs the extra 'carla', and Linux for what a server holds of memory.
"""

from __future__ import annotations

import hashlib
import os
import socket
import subprocess
import sys
import threading
import time
from collections import Counter
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import carla  # pyright: ignore[reportMissingImports]

DT = 0.05  # [s]
LONGEST = 60.0  # [s] of a process
CHILD = "--child"


def free_port() -> int:
    """A port that is free, as is the next."""
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
def serving() -> Generator[tuple[int, int]]:
    """A server: its port and its process."""
    port = free_port()
    command = [sys.executable, "-m", "chatscene", "serve-carla", "--port", str(port)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as server:
        try:
            assert server.stdout is not None
            assert "not CARLA" in server.stdout.readline()
            yield port, server.pid
            assert server.poll() is None, "the server is gone"
        finally:
            server.terminate()


def memory(process: int) -> float:
    """[MiB] that a process holds."""
    return int(Path(f"/proc/{process}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


def connected(port: int) -> tuple[Any, Any]:
    """A client, and a fresh synchronous world."""
    client = carla.Client("127.0.0.1", port)
    client.set_timeout(30.0)
    return client, loaded(client)


def loaded(client: Any) -> Any:
    """A fresh synchronous world."""
    world = client.load_world("town")
    settings = world.get_settings()
    settings.synchronous_mode, settings.fixed_delta_seconds = True, DT
    world.apply_settings(settings)
    return world


def spawned(world: Any, cars: int) -> list[Any]:
    """Cars at the first places."""
    blueprint = world.get_blueprint_library().find("vehicle.lincoln.mkz_2017")
    return [world.spawn_actor(blueprint, point) for point in world.get_map().get_spawn_points()[:cars]]


def child(port: int, manager: int) -> None:
    """Drive, with pedals or by a traffic manager on a port, and say where everybody ended."""
    client, world = connected(port)
    if manager:
        traffic = client.get_trafficmanager(manager)
        traffic.set_synchronous_mode(True)
        traffic.set_random_device_seed(7)
    cars = spawned(world, 12)
    world.reset_all_traffic_lights()  # before it was synchronous, the world went by the clock
    world.tick()
    for number, car in enumerate(cars):
        if manager:
            car.set_autopilot(True, manager)
        else:
            car.apply_control(carla.VehicleControl(throttle=0.3 + 0.05 * number, steer=0.002 * number))
    for _ in range(200):
        world.tick()
    places = [(at.x, at.y) for at in (car.get_location() for car in cars)]
    print(hashlib.sha256(repr(places).encode()).hexdigest()[:12], flush=True)


def outcome(port: int, *, managed: bool) -> str:
    """What a process of its own ends in: its places, or how it failed."""
    manager = free_port() if managed else 0
    try:
        done = subprocess.run(
            [sys.executable, __file__, CHILD, str(port), str(manager)],
            capture_output=True, text=True, timeout=LONGEST, check=False,
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return "hangs"
    return done.stdout.split()[-1] if done.returncode == 0 else f"crashes with {done.returncode}"


def two_at_once() -> str:
    """One drives and loads, one looks on."""
    with serving() as (port, _):
        client, world = connected(port)
        onlooker = carla.Client("127.0.0.1", port)
        onlooker.set_timeout(30.0)
        seen: set[int] = set()
        onlooker.get_world().on_tick(lambda snapshot: seen.add(snapshot.frame))
        time.sleep(0.5)
        frames: set[int] = set()
        for _ in range(20):
            world = loaded(client)
            spawned(world, 5)
            frames |= {world.tick() for _ in range(50)}
        time.sleep(1.0)
        return f"{len(frames)} ticks, {len(frames - seen)} of them not seen by the onlooker"


def cycles(count: int) -> str:
    """Load, spawn, tick, destroy, again and again."""
    with serving() as (port, process):
        client, world = connected(port)
        before, kept, start = memory(process), len(world.get_actors()), time.perf_counter()
        for _ in range(count):
            world = loaded(client)
            assert len(world.get_actors()) == kept, "something of the last world is left"
            cars = spawned(world, 10)
            for _ in range(10):
                world.tick()
            for car in cars[:5]:
                assert car.destroy()
        took, after = time.perf_counter() - start, memory(process)
        return f"{count} in {took:.0f} s; the server held {before:.0f} MiB, then {after:.0f} MiB"


def one_after_another(count: int, *, managed: bool) -> Counter[str]:
    """What so many processes end in."""
    with serving() as (port, _):
        return Counter(outcome(port, managed=managed) for _ in range(count))


def eight_at_a_time(count: int) -> Counter[str]:
    """The same, eight servers and their clients at once."""
    found: Counter[str] = Counter()

    def several(runs: int) -> None:
        with serving() as (port, _):
            for _ in range(runs):
                found[outcome(port, managed=False)] += 1

    threads = [threading.Thread(target=several, args=(len(range(first, count, 8)),)) for first in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return found


def told(found: Counter[str]) -> str:
    return ", ".join(f"{count} x {result}" for result, count in found.most_common())


def main() -> None:
    if sys.argv[1:2] == [CHILD]:
        child(int(sys.argv[2]), int(sys.argv[3]))
        return
    count, processes = (int(sys.argv[i]) if len(sys.argv) > i else most for i, most in ((1, 1000), (2, 50)))
    for name, result in (
        ("two clients at once", two_at_once),
        ("load, spawn, tick, destroy", lambda: cycles(count)),
        ("processes one after another", lambda: told(one_after_another(processes, managed=False))),
        ("processes eight at a time", lambda: told(eight_at_a_time(processes))),
        ("with a traffic manager", lambda: told(one_after_another(processes, managed=True))),
    ):
        print(f"{name}: {result()} (load {os.getloadavg()[0]:.1f})", flush=True)


if __name__ == "__main__":
    main()
