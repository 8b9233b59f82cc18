"""The stand-in for CARLA among many: several clients, much nonsense, loads and spawns in a row."""

from __future__ import annotations

import os
import random
import socket
import time
from collections.abc import Generator
from pathlib import Path
from typing import Any

import pytest
from standing_in import connected, serving, ticked_until

from carla_stand_in.calls import CALLS
from carla_stand_in.calls_actors import ACTOR_CALLS

carla: Any = pytest.importorskip("carla", reason="the extra 'carla' is not installed, or has no wheel for this Python")
msgpack: Any = pytest.importorskip("msgpack", reason="the extra 'carla' is not installed")

MKZ = "vehicle.lincoln.mkz_2017"
OF_THE_SERVER = (
    "add_traffic_manager_running",
    "apply_batch",
    "destroy_traffic_manager",
    "get_actors_by_id",
    "get_episode_info",
    "get_sensor_token",
    "get_spectator",
    "get_traffic_manager_running",
    "is_traffic_manager_running",
    "load_new_episode",
    "spawn_actor",
    "spawn_actor_with_parent",
)
NAMES = (*CALLS, *ACTOR_CALLS, *OF_THE_SERVER, "nonsense", "")
NUMBERS = (0, 1, -1, 41, 42, 2**31, 2**32 - 1, 2**63, -(2**63), 0.5, 1e300, float("nan"), float("inf"))
TEXTS = ("", "town", MKZ, "sensor.lidar.ray_cast", "x" * 1000)


@pytest.fixture(scope="module")
def server() -> Generator[tuple[int, Any]]:
    with serving() as (port, process):
        yield port, process


@pytest.fixture(scope="module")
def port(server: tuple[int, Any]) -> int:
    return server[0]


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


def test_every_call_answers_whatever_it_is_given(port: int) -> None:
    client, world = connected(port)
    car = world.spawn_actor(world.get_blueprint_library().find(MKZ), world.get_map().get_spawn_points()[0])
    chance = random.Random(0)
    deep: Any = []
    for _ in range(500):
        deep = [deep]
    whatever = (
        car.id,
        None,
        True,
        -1,
        2**64 - 1,
        1e308,
        float("nan"),
        "",
        "é",
        b"\xff",
        [],
        [1.0, 2.0, 3.0],
        [[]],
        {},
        deep,
    )
    reader = msgpack.Unpacker(raw=False, strict_map_key=False, unicode_errors="surrogateescape")
    with socket.create_connection(("127.0.0.1", port), timeout=60) as connection:
        for name in NAMES:
            for _ in range(30):
                arguments = [car.id] * chance.randrange(2) + [
                    chance.choice(whatever) for _ in range(chance.randrange(5))
                ]
                connection.sendall(said([0, 1, name, [[False], *arguments]]))
                assert heard(connection, reader)[:3] == [1, 1, None], (name, arguments)
        # No port is one that a traffic manager could be woken at.
        for place in (["127.0.0.1", 0], ["127.0.0.1", 70_000], ["127.0.0.1", 1]):
            connection.sendall(said([0, 1, "add_traffic_manager_running", [[False], place]]))
            heard(connection, reader)
        connection.sendall(said([0, 1, "tick_cue", [[False]]]))
        heard(connection, reader)
        time.sleep(1.2)  # it is looked for at port 1 now
    assert client.get_server_version() == "0.9.16"


def memory(process: int) -> float:
    """[MiB] that a process holds."""
    return int(Path(f"/proc/{process}/statm").read_text().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20


HUGE = {
    "binary": b"\xc6\xff\xff\xff\xff",
    "text": b"\xdb\xff\xff\xff\xff",
    "list": b"\xdd\xff\xff\xff\xff",
    "map": b"\xdf\xff\xff\xff\xff",
    "lists in lists": b"\xdd\x00\x01\x86\xa0" * 500,
    "longer lists in lists": b"\xdd\x03\x93\x87\x00" * 500,
    "extension": b"\xc9\xff\xff\xff\xff\x01",
}


@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="what a process holds is read from /proc")
def test_room_is_made_for_what_came_and_not_for_what_was_announced(server: tuple[int, Any]) -> None:
    port, process = server
    before = memory(process.pid)
    calls = [socket.create_connection(("127.0.0.1", port), timeout=60) for _ in range(20)]
    for number, connection in enumerate(calls):
        connection.sendall(list(HUGE.values())[number % len(HUGE)] + b"x" * 100)
    streams = [socket.create_connection(("127.0.0.1", port + 1), timeout=60) for _ in range(20)]
    for connection in streams:
        connection.sendall(b"\xff\xff\xff\xff" * 100)
    _, world = connected(port)
    assert world.tick() > 0
    assert memory(process.pid) - before < 200
    for connection in calls + streams:
        connection.close()


def test_clients_that_dawdle_stop_halfway_or_never_read_hold_up_nobody(server: tuple[int, Any]) -> None:
    port, process = server
    before = memory(process.pid)
    call = said([0, 1, "get_map_data", [[False]]])
    held: list[socket.socket] = []
    for place in (port, port + 1):
        for sent in (b"", call[:7], b"\x01"):
            for shut in (False, True):
                connection = socket.create_connection(("127.0.0.1", place), timeout=60)
                connection.sendall(sent)
                if shut:
                    connection.shutdown(socket.SHUT_WR)
                held.append(connection)
    greedy = socket.create_connection(("127.0.0.1", port), timeout=60)
    greedy.sendall(call * 2000)  # it never reads the answers, some 400 MB
    _, world = connected(port)
    for place in (port, port + 1):  # byte after byte
        slow = socket.create_connection(("127.0.0.1", place), timeout=60)
        held.append(slow)
        for byte in call[:5]:
            slow.sendall(bytes([byte]))
            assert world.tick() > 0
    assert process.poll() is None
    assert memory(process.pid) - before < 200
    for connection in [*held, greedy]:
        connection.close()


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


def test_a_traffic_manager_that_misses_a_step_is_woken(port: int) -> None:
    with (
        socket.create_connection(("127.0.0.1", port), timeout=60) as client,
        socket.create_server(("127.0.0.1", 0)) as it,
    ):
        it.settimeout(60)
        place = ["127.0.0.1", it.getsockname()[1]]
        calls = [["add_traffic_manager_running", [[False], place]], ["tick_cue", [[False]]]]
        for number, call in enumerate(calls):
            client.sendall(said([0, number, *call]))
        woken, _ = it.accept()
        reader = msgpack.Unpacker(raw=False)
        with woken:
            modes = [heard(woken, reader)[2:] for _ in range(2)]
    assert modes == [["set_synchronous_mode", [False]], ["set_synchronous_mode", [True]]]
