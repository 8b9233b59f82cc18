"""The stand-in for CARLA among many: several clients, much nonsense, loads and spawns in a row."""

from __future__ import annotations

import random
import socket
from collections.abc import Generator
from typing import Any

import pytest
from standing_in import connected, serving, ticked_until

from chatscene.simulate.carla.standin.calls import CALLS
from chatscene.simulate.carla.standin.calls_actors import ACTOR_CALLS

carla: Any = pytest.importorskip("carla", reason="the extra 'carla' is not installed, or has no wheel for this Python")
msgpack: Any = pytest.importorskip("msgpack", reason="the extra 'carla' is not installed")

MKZ = "vehicle.lincoln.mkz_2017"
NAMES = (*CALLS, *ACTOR_CALLS, "apply_batch", "spawn_actor", "load_new_episode", "get_actors_by_id", "nonsense", "")
NUMBERS = (0, 1, -1, 41, 42, 2**31, 2**32 - 1, 2**63, -(2**63), 0.5, 1e300, float("nan"), float("inf"))
TEXTS = ("", "town", MKZ, "sensor.lidar.ray_cast", "x" * 1000)


@pytest.fixture(scope="module")
def port() -> Generator[int]:
    with serving() as (port, _):
        yield port


def nonsense(chance: random.Random, depth: int = 0) -> Any:
    """Anything that msgpack can say."""
    kind = chance.randrange(9)
    if kind < 3 or (kind > 5 and depth > 3):
        return chance.choice(NUMBERS)
    if kind == 3:
        return chance.choice(TEXTS)
    if kind == 4:
        return chance.choice((True, False, None, {"a": 1}))
    if kind == 5:
        return chance.randbytes(chance.randrange(30))
    return [nonsense(chance, depth + 1) for _ in range(chance.randrange(8))]


def said(message: Any) -> bytes:
    """As it is sent."""
    packed: bytes = msgpack.packb(message)
    return packed


def heard(connection: socket.socket, reader: Any) -> Any:
    """The next message of the server."""
    while True:
        for message in reader:
            return message
        chunk = connection.recv(2**20)
        assert chunk, "the server cut the connection"
        reader.feed(chunk)


def test_ten_thousand_nonsense_messages_get_an_answer_each_and_the_server_goes_on(port: int) -> None:
    chance = random.Random(0)
    reader = msgpack.Unpacker(raw=False, strict_map_key=False, unicode_errors="surrogateescape")
    refusals = 0
    with socket.create_connection(("127.0.0.1", port), timeout=60) as connection:
        for number in range(10_000):
            arguments = [nonsense(chance) for _ in range(chance.randrange(5))]
            call = [0, number, chance.choice(NAMES), [[False], *arguments]]
            connection.sendall(said(call if chance.random() < 0.9 else nonsense(chance)))
            kind, _, fault, answer = heard(connection, reader)
            assert (kind, fault) == (1, None)  # a fault of the protocol would end a client
            if answer and isinstance(answer[0], list) and answer[0][:1] == [0] and answer[0][0] is not False:
                refusals += 1
                assert len(answer[0][1][0]) > 10
    assert refusals > 5_000
    _, world = connected(port)
    assert world.tick() > 0


def test_what_is_no_message_at_all_cuts_off_nobody_else(port: int) -> None:
    _, world = connected(port)
    chance = random.Random(0)
    for place in (port, port + 1):
        for _ in range(100):
            with socket.create_connection(("127.0.0.1", place)) as connection:
                connection.sendall(chance.randbytes(200))
    assert world.tick() > 0


def test_a_second_client_sees_the_same_world_and_outlives_a_load_of_the_first(port: int) -> None:
    first, world = connected(port)
    second: Any = carla.Client("127.0.0.1", port)
    second.set_timeout(60.0)
    other = second.get_world()
    car = world.spawn_actor(world.get_blueprint_library().find(MKZ), world.get_map().get_spawn_points()[0])
    frame = world.tick()
    ticked_until(world, lambda: other.get_snapshot().frame >= frame)  # its stream may have begun after that tick
    other.get_actor(car.id).apply_control(carla.VehicleControl(throttle=1.0))
    for _ in range(20):
        world.tick()
    assert car.get_velocity().length() > 2.0
    first.load_world("town")
    again = second.get_world()
    again.wait_for_tick(60.0)
    assert not list(again.get_actors().filter("vehicle.*"))


def test_who_only_looks_on_hears_every_tick_of_another_clients_new_world(port: int) -> None:
    first, _ = connected(port)
    onlooker: Any = carla.Client("127.0.0.1", port)
    onlooker.set_timeout(60.0)
    seen: list[int] = []

    def hear(snapshot: Any) -> None:
        seen.append(snapshot.frame)

    onlooker.get_world().on_tick(hear)
    for _ in range(3):
        _, world = connected(port, client=first)
        frames = [world.tick() for _ in range(5)]
        ticked_until(world, lambda: set(frames[1:]) <= set(seen))  # noqa: B023 - it is called at once


def test_loads_and_spawns_in_a_row_leave_nothing_behind(port: int) -> None:
    client, world = connected(port)
    kept = len(world.get_actors())
    for _ in range(8):
        library, points = world.get_blueprint_library(), world.get_map().get_spawn_points()
        made = client.apply_batch_sync([carla.command.SpawnActor(library.find(MKZ), p) for p in points[:20]], True)
        assert not any(answer.has_error() for answer in made)
        gone = client.apply_batch_sync([carla.command.DestroyActor(answer.actor_id) for answer in made[:10]], True)
        assert not any(answer.has_error() for answer in gone)
        assert len(world.get_actors()) == kept + 10
        world = client.reload_world(False)
        assert len(world.get_actors()) == kept
