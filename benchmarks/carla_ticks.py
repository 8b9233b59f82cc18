"""Ticks per second of the stand-in for CARLA, through the real wheel.

    python benchmarks/carla_ticks.py [TICKS]

A client in this process ticks a synchronous world with 1, 20 and 100 cars that drive; the server is a process of its
own. The opponent is the clock: how many times faster than real time a step of 50 ms is. Since others may keep the
machine busy, what the server itself needs of a processor is told, too, and the load. Needs the extra 'carla' and Linux.
"""

from __future__ import annotations

import os
import socket
import subprocess
import sys
import time
from pathlib import Path

import carla  # pyright: ignore[reportMissingImports]

DT = 0.05  # [s]


def free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port: int = probe.getsockname()[1]
        return port


def spent(process: int) -> float:
    """Seconds of a processor that a process had."""
    fields = Path(f"/proc/{process}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def measure(port: int, server: int, cars: int, ticks: int) -> tuple[float, float]:
    """Ticks per second with so many cars, and what the server needs of a processor for one [s]."""
    client = carla.Client("127.0.0.1", port)
    client.set_timeout(30.0)
    world = client.load_world("town")
    settings = world.get_settings()
    settings.synchronous_mode, settings.fixed_delta_seconds = True, DT
    world.apply_settings(settings)
    blueprint = world.get_blueprint_library().find("vehicle.lincoln.mkz_2017")
    command = carla.command
    drive = command.ApplyVehicleControl(command.FutureActor, carla.VehicleControl(throttle=0.4))
    points = world.get_map().get_spawn_points()[:cars]
    made = client.apply_batch_sync([command.SpawnActor(blueprint, point).then(drive) for point in points], True)
    assert len(made) == cars
    assert not any(answer.has_error() for answer in made)
    start, before = time.perf_counter(), spent(server)
    for _ in range(ticks):
        world.tick()
    return ticks / (time.perf_counter() - start), (spent(server) - before) / ticks


def main() -> None:
    ticks = int(sys.argv[1]) if len(sys.argv) > 1 else 500
    port = free_port()
    command = [sys.executable, "-m", "chatscene", "serve-carla", "--port", str(port)]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True) as server:
        try:
            assert server.stdout is not None
            print(server.stdout.readline().strip())
            print("cars  ticks/s  times real time  server's processor time per tick [ms]  load")
            for cars in (1, 20, 100):
                rate, needed = measure(port, server.pid, cars, ticks)
                load = os.getloadavg()[0]
                print(f"{cars:4}  {rate:7.0f}  {rate * DT:15.1f}  {1000 * needed:37.2f}  {load:4.1f}")
        finally:
            server.terminate()


if __name__ == "__main__":
    main()
