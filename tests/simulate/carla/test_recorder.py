"""The recorder of the stand-in for CARLA: what it writes, and what it tells of it."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

import pytest
from standing_in import WALKER, spawned, ticked_until

carla: Any = pytest.importorskip("carla", reason="the extra 'carla' is not installed, or has no wheel for this Python")
pytest.importorskip("msgpack", reason="the extra 'carla' is not installed")


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


def test_a_recording_is_the_text_that_is_told_of_it(client_and_world: tuple[Any, Any], tmp_path: Path) -> None:
    client, world = client_and_world
    file = tmp_path / "crash.log"
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


def test_the_same_drive_gives_the_same_recording_but_for_ids(client_and_world: tuple[Any, Any], tmp_path: Path) -> None:
    client, _ = client_and_world
    texts: list[str] = []
    for name in ("one", "two"):
        world = client.reload_world(False)  # it stays synchronous, so nothing happens before the first tick
        crash(client, world, tmp_path / f"{name}.log")
        text = (tmp_path / f"{name}.log").read_text()
        texts.append(re.sub(r"(Create|Destroy|Id:|between|with) \d+", r"\1", text))
    assert texts[0] == texts[1]


def test_only_recordings_are_written_over_or_told_of(client_and_world: tuple[Any, Any], tmp_path: Path) -> None:
    client, world = client_and_world
    other = tmp_path / "mine.log"
    other.write_text("dear diary")
    for name, why in (
        (str(other), "is there and is no recording"),
        (str(tmp_path / "profile"), r"ends in \.log"),
        (str(tmp_path / "no" / "such.log"), "No such file or directory"),
    ):
        with pytest.raises(RuntimeError, match=why):
            client.start_recorder(name)
    assert other.read_text() == "dear diary"
    for ask in (client.show_recorder_file_info, client.show_recorder_actors_blocked, client.show_recorder_collisions):
        arguments = {client.show_recorder_file_info: (True,), client.show_recorder_collisions: ("a", "a")}.get(
            ask, (1.0, 1.0)
        )
        with pytest.raises(RuntimeError, match="is no recording of this stand-in"):
            ask(str(other), *arguments)
    assert client.start_recorder(str(tmp_path / "a.log"))
    assert client.start_recorder(str(tmp_path / "a.log"))
    client.reload_world()  # ends it
    assert world.get_map().name.endswith("town")
