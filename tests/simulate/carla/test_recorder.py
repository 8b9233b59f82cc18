"""The recorder of the stand-in for CARLA: what it writes, and what it tells of it."""

from __future__ import annotations

import os
import re
import socket
import tempfile
from collections.abc import Generator
from pathlib import Path
from typing import Any

import pytest
from standing_in import WALKER, connected, serving, spawned, ticked_until

carla: Any = pytest.importorskip("carla", reason="the extra 'carla' is not installed, or has no wheel for this Python")
pytest.importorskip("msgpack", reason="the extra 'carla' is not installed")
recorder: Any = pytest.importorskip("carla_stand_in.recorder")
files: Any = pytest.importorskip("carla_stand_in.files")


@pytest.fixture(scope="module")
def served(tmp_path_factory: pytest.TempPathFactory) -> Generator[tuple[int, Path]]:
    """A server whose clients' files are below a folder, and the folder."""
    folder = tmp_path_factory.mktemp("files")
    with serving("--files", str(folder)) as (port, _):
        yield port, folder


@pytest.fixture
def client_and_world(served: tuple[int, Path]) -> tuple[Any, Any]:
    return connected(served[0])


@pytest.fixture
def folder(served: tuple[int, Path]) -> Path:
    """A fresh folder below that one."""
    return Path(tempfile.mkdtemp(dir=served[1]))


def crash(client: Any, world: Any, file: Path) -> tuple[Any, Any, Any]:
    """A drive into a standing car is recorded; gives driver, stander and a walker."""
    assert client.start_recorder(str(file), True) == str(file)
    car, other, walker = spawned(world), spawned(world, ahead=12.0), spawned(world, WALKER, 3)
    car.apply_control(carla.VehicleControl(throttle=1.0))
    touch = car.bounding_box.extent.x + other.bounding_box.extent.x
    world.tick()
    ticked_until(world, lambda: car.get_location().distance(other.get_location()) < touch)
    walker.destroy()
    for _ in range(20):
        world.tick()
    client.stop_recorder()
    world.tick()
    return car, other, walker


def test_a_recording_is_the_text_that_is_told_of_it(client_and_world: tuple[Any, Any], folder: Path) -> None:
    client, world = client_and_world
    file = folder / "crash.log"
    car, other, walker = crash(client, world, file)
    text = client.show_recorder_file_info(str(file), True)
    assert text.startswith(file.read_text().rstrip())
    frames = re.split(r"^Frame ", text, flags=re.MULTILINE)[1:]
    assert text.endswith(f"\nFrames: {len(frames)}\nDuration: {(len(frames) - 1) * 0.05:.6g} seconds\n")
    assert f" Create {car.id}: vehicle.lincoln.mkz_2017 (1) at (" in frames[0]
    assert f" Destroy {walker.id}\n" in text
    assert len(re.findall(r"^ Collision id", text, re.MULTILINE)) == 1  # where it begins
    at = re.search(
        rf"^  Id: {car.id} Location: \((\S+), (\S+), \S+\) Rotation: \(0, 0, (\S+)\)", frames[-1], re.MULTILINE
    )
    assert at is not None
    x, y, yaw = (float(part) for part in at.groups())
    where = car.get_transform()
    went = carla.Location(x / 100, y / 100, where.location.z).distance(where.location)
    assert went < 2.0  # it rolled on for one tick after the recording
    assert yaw == pytest.approx(where.rotation.yaw, abs=1e-3)
    assert f"  Id: {car.id} Steering: 0 Throttle: 1 Brake: 0 Handbrake: 0 Gear: 0" in text
    brief = client.show_recorder_file_info(str(file), False)
    assert " Positions" not in brief
    assert brief.count("Frame ") == 3
    met = client.show_recorder_collisions(str(file), "v", "v")
    assert re.search(rf"v v +{car.id} vehicle\.\S+ +{other.id} vehicle\.\S+$", met, re.MULTILINE)
    assert "v v" not in client.show_recorder_collisions(str(file), "w", "a")
    stood = client.show_recorder_actors_blocked(str(file), 1.0, 10.0)
    assert [int(row.split()[1]) for row in stood.splitlines() if " vehicle." in row] == [other.id]


def test_the_same_drive_gives_the_same_recording_but_for_ids(client_and_world: tuple[Any, Any], folder: Path) -> None:
    client, _ = client_and_world
    texts: list[str] = []
    for name in ("one", "two"):
        world = client.reload_world(False)  # it stays synchronous, so nothing happens before the first tick
        crash(client, world, folder / f"{name}.log")
        text = (folder / f"{name}.log").read_text()
        texts.append(re.sub(r"(Create|Destroy|Id:|between|with) \d+", r"\1", text))
    assert texts[0] == texts[1]


def test_only_recordings_are_written_over_or_told_of(client_and_world: tuple[Any, Any], folder: Path) -> None:
    client, world = client_and_world
    other = folder / "mine.log"
    other.write_text("dear diary")
    for name, why in (
        (str(other), "exists and is not a recording"),
        (str(folder / "profile"), r"ends in \.log"),
        (str(folder / "no" / "such.log"), "No such file or directory"),
    ):
        with pytest.raises(RuntimeError, match=why):
            client.start_recorder(name)
    assert other.read_text() == "dear diary"
    for ask in (client.show_recorder_file_info, client.show_recorder_actors_blocked, client.show_recorder_collisions):
        arguments = {client.show_recorder_file_info: (True,), client.show_recorder_collisions: ("a", "a")}.get(
            ask, (1.0, 1.0)
        )
        with pytest.raises(RuntimeError, match="is not a recording of this stand-in"):
            ask(str(other), *arguments)
    assert client.start_recorder(str(folder / "a.log"))
    assert client.start_recorder(str(folder / "a.log"))
    client.reload_world()  # ends it
    assert world.get_map().name.endswith("town")


def test_no_name_leads_out_of_the_folder(client_and_world: tuple[Any, Any], folder: Path, tmp_path: Path) -> None:
    client, _ = client_and_world
    secret = tmp_path / "secret.log"
    secret.write_text("Version: 1\nMap: secret\n")
    (folder / "link.log").symlink_to(secret)
    (folder / "dangling.log").symlink_to(tmp_path / "new.log")
    (folder / "inner").symlink_to(tmp_path)
    os.mkfifo(folder / "pipe.log")
    with socket.socket(socket.AF_UNIX) as open_socket:
        open_socket.bind(str(folder / "socket.log"))
    (folder / "folder.log").mkdir()
    for name in (
        str(secret), str(tmp_path / "new.log"), f"{folder}/../../{tmp_path.name}/new.log", "../new.log", "/new.log",
        str(folder / "link.log"), str(folder / "dangling.log"), str(folder / "inner" / "new.log"),
        str(folder / "inner" / "secret.log"), str(folder / "pipe.log"), str(folder / "socket.log"),
        str(folder / "folder.log"), f"{folder}/{'a' * 5000}.log", f"~{folder}.log", f"/proc/self/cwd{folder}/new.log",
    ):  # fmt: skip
        for ask, arguments in ((client.start_recorder, (name,)), (client.show_recorder_file_info, (name, True))):
            with pytest.raises(RuntimeError, match=r"below .+ and .+ is not|cannot be opened|is not a recording"):
                ask(*arguments)
    assert secret.read_text() == "Version: 1\nMap: secret\n"
    assert [path.name for path in tmp_path.iterdir()] == ["secret.log"]


def test_a_name_below_the_folder_needs_not_begin_with_it(client_and_world: tuple[Any, Any], folder: Path) -> None:
    client, _ = client_and_world
    assert client.start_recorder(f"{folder.name}/a.log") == str(folder / "a.log")
    client.stop_recorder()
    assert "Frames: 0" in client.show_recorder_file_info(str(folder / "a.log"), True)


def test_without_a_folder_recordings_are_private_and_a_name_elsewhere_says_where(port: int, tmp_path: Path) -> None:
    client, _ = connected(port)
    with pytest.raises(RuntimeError, match=r"files of clients are below .*chatscene-carla-.*serve-carla --files"):
        client.start_recorder(str(tmp_path / "a.log"))
    made = Path(client.start_recorder("a.log"))
    client.stop_recorder()
    assert made.parent.stat().st_mode & 0o077 == 0
    made.unlink()
    assert not list(tmp_path.iterdir())


def test_recordings_of_a_server_have_a_bounded_size(tmp_path: Path) -> None:
    writes = recorder.Recorder(files.Files(tmp_path), most=200)
    writes.start("a.log", "town")
    for _ in range(10):
        writes.write(0.0, {}, {}, False, [])
    with pytest.raises(recorder.Refused, match="ended early: recordings of this server have no more room"):
        writes.stop()
    assert 0 < (tmp_path / "a.log").stat().st_size <= 200
