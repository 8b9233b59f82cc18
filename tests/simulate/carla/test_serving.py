"""The command that stands in for CARLA: where it listens, and how it ends where it cannot."""

from __future__ import annotations

import re
import socket
import sys
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from standing_in import connected, serving, spawned, speed

from chatscene.commands.main import main
from chatscene.maps.network import PACKAGED
from strange_folder import strange

carla: Any = pytest.importorskip("carla", reason="the extra 'carla' is not installed, or has no wheel for this Python")
pytest.importorskip("msgpack", reason="the extra 'carla' is not installed")


def test_it_listens_on_loopback_and_on_no_other_address() -> None:
    with serving() as (port, _):
        for place in (port, port + 1):
            socket.create_connection(("127.0.0.1", place)).close()
            with pytest.raises(OSError):
                socket.create_connection(("127.0.0.2", place), timeout=5)


def test_bodies_answer_with_delay_where_that_is_asked_for() -> None:
    reached: list[float] = []
    for physics in ("kinematic", "lagged"):
        with serving("--physics", physics) as (port, _):
            _, world = connected(port)
            car = spawned(world)
            car.apply_control(carla.VehicleControl(throttle=1.0))
            for _ in range(6):
                world.tick()
            reached.append(speed(car))
    assert 0.0 < reached[1] < 0.9 * reached[0]


def test_a_port_that_is_taken_is_named() -> None:
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        done = CliRunner().invoke(main, ["serve-carla", "--port", str(port)])
    assert done.exit_code == 1
    assert f"cannot listen on 127.0.0.1, ports {port} and {port + 1}" in done.output


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (["--map", "twon"], "did you mean 'town'?"),
        (["--map", "no/such.xodr"], "no/such.xodr"),
        (["--simulator", "confined"], "brings no bodies that a stand-in for CARLA could move"),
    ],
)
def test_what_cannot_be_served_is_said_before_anybody_calls(options: list[str], says: str) -> None:
    done = CliRunner().invoke(main, ["serve-carla", *options])
    assert done.exit_code == 1
    assert says in done.output


def test_another_version_of_the_wheel_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    def version(_: str) -> str:
        return "0.9.15"

    monkeypatch.setattr("carla_stand_in.roads.version", version)
    done = CliRunner().invoke(main, ["serve-carla"])
    assert done.exit_code == 1
    assert "needs the wheel carla 0.9.16, not 0.9.15" in done.output


def test_without_the_wheel_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "carla", None)
    done = CliRunner().invoke(main, ["serve-carla"])
    assert done.exit_code == 1
    assert re.search(r'pip install .*\[carla\]"', done.output)


def test_without_the_package_of_the_stand_in_its_place_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in [name for name in sys.modules if name.partition(".")[0] == "carla_stand_in"]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.setattr(sys, "path", [entry for entry in sys.path if "carla-stand-in" not in entry])
    done = CliRunner().invoke(main, ["serve-carla"])
    assert done.exit_code == 1
    assert "pip install ./packages/carla-stand-in" in done.output


def test_a_web_page_that_posts_a_call_is_closed_and_not_obeyed(tmp_path: Path) -> None:
    msgpack = pytest.importorskip("msgpack")
    made = tmp_path / "made.log"
    call: bytes = msgpack.packb([0, 1, "start_recorder", [[0, False], str(made), False]])
    request = b"POST / HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Length: %d\r\n\r\n" % len(call) + call
    with serving() as (port, _), socket.create_connection(("127.0.0.1", port), timeout=60) as page:
        page.sendall(request)
        assert page.recv(100) == b""
    assert not made.exists()


def test_a_map_of_left_hand_traffic_is_refused_before_anybody_calls(tmp_path: Path) -> None:
    left = tmp_path / "left.xodr"
    left.write_text(PACKAGED["town"].read_text().replace('rule="RHT"', 'rule="LHT"'))
    done = CliRunner().invoke(main, ["serve-carla", "--map", str(left)])
    assert done.exit_code == 1
    assert "of left-hand traffic: road" in done.output
    assert done.output.count("\n") == 1


def test_a_client_that_sends_a_map_of_left_hand_traffic_is_refused() -> None:
    with serving() as (port, _):
        client, _ = connected(port)
        with pytest.raises(RuntimeError, match="left-hand traffic"):
            client.generate_opendrive_world(PACKAGED["town"].read_text().replace('rule="RHT"', 'rule="LHT"'))


def test_neither_it_nor_its_reader_of_maps_imports_a_module_of_the_working_folder(tmp_path: Path) -> None:
    folder = strange(tmp_path)
    with serving("--map", "town", "--map", "outskirts", folder=folder.path) as (port, _):
        client, world = connected(port)
        spawned(world)
        world.tick()
        client.load_world("outskirts")
        client.generate_opendrive_world(PACKAGED["outskirts"].read_text())
    assert folder.imported() == []
