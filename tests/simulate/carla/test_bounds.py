"""What strangers can take of the stand-in for CARLA: it is bounded, and the others are served meanwhile."""

from __future__ import annotations

import asyncio
import select
import socket
import struct
from collections.abc import Generator
from contextlib import ExitStack
from typing import Any

import pytest
from standing_in import connected, serving, spawned

from chatscene.errors import MapError
from chatscene.maps.network import PACKAGED

carla: Any = pytest.importorskip("carla", reason="the extra 'carla' is not installed, or has no wheel for this Python")
msgpack: Any = pytest.importorskip("msgpack", reason="the extra 'carla' is not installed")
standin = "carla_stand_in"
log, reading, server, worlds = (
    pytest.importorskip(f"{standin}.{name}") for name in ("log", "reading", "server", "world")
)
TOWN = PACKAGED["town"].read_text()


@pytest.fixture
def fresh() -> Generator[int]:
    """A server that is spoilt."""
    with serving() as (port, _):
        yield port


def opened(port: int) -> socket.socket:
    return socket.create_connection(("127.0.0.1", port), timeout=60)


def asked(connection: socket.socket, name: str, *arguments: Any) -> None:
    connection.sendall(msgpack.packb([0, 1, name, [[False], *arguments]]))


def answer(connection: socket.socket) -> Any:
    reader = msgpack.Unpacker(raw=False)
    while chunk := connection.recv(2**20):
        reader.feed(chunk)
        for message in reader:
            return message[3]
    return None


def refusal(port: int, name: str, *arguments: Any) -> str:
    with opened(port) as connection:
        asked(connection, name, *arguments)
        return answer(connection)[0][1][0]


def is_closed(connection: socket.socket) -> bool:
    try:
        return connection.recv(100) == b""
    except ConnectionResetError:
        return True


def test_who_never_called_gives_way_to_others_and_beyond_a_number_nobody_is_let_in(fresh: int) -> None:
    with ExitStack() as held:
        idle = [held.enter_context(opened(fresh)) for _ in range(server.MOST_CLIENTS)]
        callers = [held.enter_context(opened(fresh)) for _ in range(server.MOST_CLIENTS)]
        for caller in callers:
            asked(caller, "version")
            assert answer(caller) == [[1, "0.9.16"]]
        assert all(is_closed(connection) for connection in idle)
        with opened(fresh) as late:
            assert is_closed(late)
    _, world = connected(fresh)
    assert world.tick() > 0


def test_unfinished_messages_of_all_together_have_a_bounded_size(port: int) -> None:
    part = b"\xc6" + struct.pack(">I", 60 * 2**20) + b"\0" * (55 * 2**20)
    with ExitStack() as held:
        senders = [held.enter_context(opened(port)) for _ in range(5)]
        for sender in senders:
            sender.sendall(b"\x94\x00\x01\xa1x" + part)
        assert len(select.select(senders, [], [], 60)[0]) == 1, "one of them is cut off"
        _, world = connected(port)
        assert world.tick() > 0


def test_a_message_of_very_many_small_values_is_cut_off(port: int) -> None:
    small = b"\xdd" + struct.pack(">I", 99_999) + b"\x90" * 99_999
    with opened(port) as connection:
        connection.sendall(b"\x94\x00\x01\xa7version\x94" + small * 4)
        assert is_closed(connection)


def test_actors_their_attributes_and_commands_at_a_time_are_bounded(port: int) -> None:
    client, world = connected(port)
    car = spawned(world)
    world.tick()  # until then the wheel does not know that it is alive
    place = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]
    sensor = [0, "sensor.other.gnss", []]
    with opened(port) as connection:
        asked(connection, "apply_batch", [[0, [sensor, place, [False], []]]] * (worlds.MOST_ACTORS + 10))
        answers = answer(connection)
    assert client.get_server_version() == "0.9.16"
    refused = [one for one in answers if one[0][0] == 0]
    assert len(answers) - len(refused) == worlds.MOST_ACTORS - 1
    assert "at most; destroy some" in str(refused[0])
    assert car.destroy()
    too_many = [[f"k{i}", 1, ""] for i in range(101)]
    for attributes in (too_many, [["k", 1, "x" * 2000]], [[f"k{i}", 1, "x" * 900] for i in range(20)]):
        assert "an actor has at most" in refusal(port, "spawn_actor", [0, "sensor.other.gnss", attributes], place)
    assert "10000 at most" in refusal(port, "apply_batch", [[1, [0]]] * 10_001)


def test_a_long_chain_of_actors_on_actors_goes_at_once(port: int) -> None:
    _, world = connected(port)
    car = spawned(world)
    place = [[0.0, 0.0, 0.0], [0.0, 0.0, 0.0]]
    last = car.id
    with opened(port) as connection:
        for _ in range(1500):
            asked(connection, "spawn_actor_with_parent", [0, "sensor.other.gnss", []], place, last)
            last = answer(connection)[0][1][0]
        asked(connection, "destroy_actor", car.id)
        assert answer(connection) == [[1, True]]
        asked(connection, "destroy_actor", last)
        assert answer(connection) == [[1, False]]


@pytest.mark.parametrize(
    "first", [b"GET / HTTP/1.1\r\n\r\n", b"POST / HTTP/1.1\r\n\r\n", b"\xff\xff\xff\xff", b"\x40\x42\x0f\x00"]
)
def test_a_stream_that_there_never_was_is_closed(port: int, first: bytes) -> None:
    with opened(port + 1) as connection:
        connection.sendall(first)
        assert is_closed(connection)


def test_others_are_answered_while_a_clients_map_is_read(port: int) -> None:
    connected(port)
    with opened(port) as reader, opened(port) as other:
        asked(reader, "copy_opendrive_to_file", TOWN.replace(' name="town"', ' name="another"'))
        for _ in range(20):
            asked(other, "tick_cue")
            assert answer(other)[0][0] == 1
        assert select.select([reader], [], [], 0)[0] == [], "it was answered first"
        assert answer(reader) == [[False]]


def test_a_map_for_which_others_would_wait_long_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reading, "READING", 0.0)
    with pytest.raises(MapError, match=r"map 'mine' takes .* others wait meanwhile"):
        asyncio.run(reading.read("mine", TOWN))


def test_what_another_process_found_in_a_map_is_what_is_in_it() -> None:
    roads: Any = pytest.importorskip(f"{standin}.roads").Roads("town", TOWN)
    found = asyncio.run(reading.read("town", TOWN))
    assert found.text == roads.text
    assert found.spawn_points == roads.spawn_points
    assert found.signals == roads.signals


def test_few_maps_stay_at_hand() -> None:
    world = worlds.World({"town": PACKAGED["town"]}, "town", None)
    for number in range(4):
        world.ready(f"map{number}", TOWN)
    assert [world.has_read(name, TOWN) for name in ("town", "map0", "map3")] == [False, True, True]
    world.load("", reset=True)
    assert world.roads.name == "Carla/Maps/town"


def test_what_is_said_is_bounded_and_what_was_left_out_is_counted() -> None:
    said: list[str] = []
    now = [0.0]
    bounded = log.Bounded(said.append, lambda: now[0])
    for number in range(1000):
        bounded(f"line {number}")
    now[0] = 11.0
    bounded("later")
    assert len(said) == log.MOST + 2
    assert said[-2:] == ["800 more lines within 10 s were left out", "later"]


@pytest.mark.parametrize("encoding", ["UTF-7", "rot13", "idna", "no-such"])
def test_a_map_in_an_encoding_that_is_none_is_no_xml(encoding: str) -> None:
    with pytest.raises(MapError, match="the map is not XML"):
        asyncio.run(reading.read("mine", f"<?xml version='1.0' encoding='{encoding}'?><OpenDRIVE/>"))


def test_a_map_that_breaks_its_reader_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(reading.sys, "executable", "/bin/false")
    with pytest.raises(MapError, match="map 'mine' cannot be read: that takes more than 30 s"):
        asyncio.run(reading.read("mine", TOWN))
