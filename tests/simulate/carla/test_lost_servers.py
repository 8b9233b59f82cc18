"""What a user is told where there is not a CARLA server, another one, or none any more; and that nothing is lost."""

from __future__ import annotations

import re
import shutil
import socket
import sys
import threading
from collections.abc import Generator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner
from standing_in import free_port, serving

from chatscene import pipeline, runs
from chatscene.commands.main import main
from chatscene.errors import MapError, RunError, ServerError, SettingsError
from chatscene.maps.network import resolve_map
from chatscene.runs.executor import Workers
from chatscene.runs.progress import silent
from chatscene.runs.replay import replay
from chatscene.runs.trust import Repeated
from chatscene.search.climb import simulator_of
from chatscene.search.generator import load_generator
from chatscene.settings import SearchSettings, Settings, SimulationSettings
from chatscene.simulate.simulator import check_jobs, load_simulator
from chatscene.studies.driving import drive
from chatscene.studies.evaluation import evaluate
from chatscene.terms.results import ResultTable
from chatscene.terms.scene import Scene, ScenicProgram

pytest.importorskip("carla", reason="the extra 'carla' is not installed, or has no wheel for this Python")
pytest.importorskip("msgpack", reason="the extra 'carla' is not installed")

from chatscene.simulate.carla import connection

TOWN = resolve_map("town")


def load(name: str) -> Any:
    return load_simulator(TOWN, SimulationSettings(simulator=name))


def asked(simulator: str, scenes: int = 2) -> runs.RunRecord:
    few = Settings(
        search=SearchSettings(scenes=scenes, block=1, keep=1), simulation=SimulationSettings(simulator=simulator)
    )
    return runs.asked_run("AdvSim: straight-obstacle", settings=few, ego="rule-based", generator="advsim")


@contextmanager
def listening(answer: bytes) -> Generator[int]:
    """Somebody who answers everything with the same bytes."""
    with socket.socket() as door:
        door.bind(("127.0.0.1", 0))
        door.listen()

        def serve() -> None:
            try:
                while True:
                    line, _ = door.accept()
                    with line:
                        line.recv(1024)
                        line.sendall(answer)
            except OSError:
                return

        threading.Thread(target=serve, daemon=True).start()
        yield door.getsockname()[1]


def test_where_nobody_listens_the_place_and_the_remedy_are_named() -> None:
    port = free_port()
    done = CliRunner().invoke(main, ["run", "the car ahead brakes", "--simulator", f"carla:127.0.0.1:{port}"])
    assert done.exit_code == 1
    assert f"ServerError: no CARLA server is at 127.0.0.1:{port}" in done.output
    assert f"chatscene serve-carla --port {port}" in done.output
    assert len(done.output.strip().splitlines()) == 1


@pytest.mark.parametrize("answer", [b"HTTP/1.1 400 Bad Request\r\n\r\n", b"", b"\x94\x01\x01\xc0\x91\x92\x00\xa10"])
def test_a_port_that_somebody_else_has_is_no_carla_server(answer: bytes) -> None:
    with listening(answer) as port, pytest.raises(ServerError, match=f"127.0.0.1:{port} is not a CARLA server"):
        load(f"carla:127.0.0.1:{port}")


def test_whoever_listens_and_says_nothing_is_no_carla_server(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(connection, "PATIENCE", 0.2)
    with socket.socket() as door, pytest.raises(ServerError, match="is not a CARLA server"):
        door.bind(("127.0.0.1", 0))
        door.listen()
        load(f"carla:127.0.0.1:{door.getsockname()[1]}")


def test_a_server_of_another_version_is_named_beside_the_wheel_s() -> None:
    with (
        listening(b"\x94\x01\x01\xc0\x91\x92\x01\xa60.9.15") as port,
        pytest.raises(ServerError, match=r"is CARLA 0\.9\.15, and the installed wheel speaks to CARLA 0\.9\.16 only"),
    ):
        load(f"carla:127.0.0.1:{port}")


@pytest.mark.parametrize("name", ["carla:127.0.0.1:http", "carla::2000", "carla:127.0.0.1:70000", "carla:a:1:2"])
def test_what_is_no_address_is_refused(name: str) -> None:
    with pytest.raises(SettingsError, match="write carla, carla:HOST or carla:HOST:PORT"):
        load(name)


def test_an_address_may_be_left_away() -> None:
    assert connection.address("carla") == ("127.0.0.1", 2000)
    assert connection.address("carla:gpu") == ("gpu", 2000)
    assert connection.address("carla:gpu:3000") == ("gpu", 3000)


def test_without_the_wheel_the_extra_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    for module in [name for name in sys.modules if name.startswith("chatscene.simulate.carla.")]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setitem(sys.modules, "carla", None)
    done = CliRunner().invoke(main, ["run", "the car ahead brakes", "--simulator", "carla"])
    assert done.exit_code == 1
    assert re.search(r'pip install .*\[carla\]"', done.output)


def test_a_map_that_is_missing_is_named() -> None:
    with pytest.raises(MapError, match="Town77"):
        resolve_map("Town77")


def test_more_processes_than_worlds_are_refused(tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="has one world, so that 2 processes"):
        check_jobs(SimulationSettings(simulator="carla:127.0.0.1:2000"), 2)
    check_jobs(SimulationSettings(simulator="carla"), 1)
    check_jobs(SimulationSettings(), 2)
    with pytest.raises(SettingsError, match="use --jobs 1"):
        drive(["idm"], simulation=SimulationSettings(simulator="carla"), workers=Workers(2), progress=silent)
    done = CliRunner().invoke(
        main, ["benchmark", "--simulator", "carla", "--jobs", "2", "--out", str(tmp_path / "benchmark")]
    )
    assert (done.exit_code, "use --jobs 1" in done.output) == (1, True)


@pytest.fixture(scope="module")
def finished(tmp_path_factory: pytest.TempPathFactory) -> Generator[tuple[str, Path, Path]]:
    """A server, the folder of a run in it, and that of the same run, whose server was killed and started again."""
    folder = tmp_path_factory.mktemp("carla")
    through, cut = folder / "through", folder / "cut"
    with serving() as (port, server):
        simulator = f"carla:127.0.0.1:{port}"
        pipeline.run(asked(simulator), through)

        def kill(_: str, done: int, total: int) -> None:
            if (done, total) == (1, 2):
                server.kill()
                server.wait()

        with pytest.raises(ServerError, match=r"was lost: .* chatscene resume DIR"):
            pipeline.run(asked(simulator), cut, progress=kill)
        shutil.copytree(cut, folder / "left")
    with serving("--files", str(folder), port=port):
        pipeline.resume(cut, repeated=Repeated(simulator=(simulator,)))
        yield simulator, through, cut


def test_a_run_whose_server_was_killed_keeps_what_was_finished(finished: tuple[str, Path, Path]) -> None:
    left = runs.Workspace(finished[1].parent / "left")
    record = runs.read_record(left)
    assert record.status is runs.Status.FAILED
    assert len(runs.done_blocks(left)) == 1


def test_a_server_that_is_killed_within_a_scene_ends_it_with_one_message() -> None:
    source = "model chatscene.world.model\negoRoute = selectRoute(maneuver='straight')\n"
    source += "ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute\n"
    program = ScenicProgram(scenario_id="road", source=source, parameters=(), snippet_ids=())
    scene = Scene(id="road/0", scenario_id="road", route=0, block=0, seed=0, values={})
    with serving() as (port, server):
        simulator = load(f"carla:127.0.0.1:{port}")
        session = simulator.open(program, scene)
        session.step((1.0, 0.0))
        server.kill()
        server.wait()
        connection.connected("127.0.0.1", port).client.set_timeout(0.5)  # nobody is left to wait for
        with pytest.raises(ServerError, match=r"was lost: it was to obey controls"):
            session.step((1.0, 0.0))
        session.close()
    with pytest.raises(ServerError, match="no CARLA server is at"):
        load(f"carla:127.0.0.1:{port}")


def test_a_run_goes_on_once_its_server_is_there_again(finished: tuple[str, Path, Path]) -> None:
    simulator, through, cut = finished
    record = runs.read_record(runs.Workspace(cut))
    assert (record.status, record.simulator.name, record.simulator.version) == (runs.Status.DONE, "carla", "0.9.16")
    assert runs.settings_of(record).simulation.simulator == simulator
    one, other = (runs.read_scenes(runs.Workspace(folder)) for folder in (through, cut))
    assert [row["scene_id"] for row in one] == [row["scene_id"] for row in other]
    assert [row["collision"] for row in one] == [row["collision"] for row in other]


def test_a_replay_is_the_same_within_a_tolerance(finished: tuple[str, Path, Path]) -> None:
    simulator, through, _ = finished
    scene = next(row["scene_id"] for row in runs.read_scenes(runs.Workspace(through)) if row["status"] == "ran")
    again = replay(through, scene, repeated=Repeated(simulator=(simulator,)))
    assert again.identical
    assert again.in_words().startswith(f"{scene}: the same within 0.5 m; actors are 0.0")


def test_a_replay_can_be_recorded_into_the_run_folder_and_watched(finished: tuple[str, Path, Path]) -> None:
    simulator, _, cut = finished
    scene = next(row["scene_id"] for row in runs.read_scenes(runs.Workspace(cut)) if row["status"] == "ran")
    done = CliRunner().invoke(main, ["replay", str(cut), scene, "--simulator", simulator, "--record", "--watch"])
    assert done.exit_code == 0, done.output
    (recording,) = (cut / "recordings").iterdir()
    assert recording.name == f"{scene.replace('/', '-')}.log"
    text = recording.read_text()
    assert "vehicle.lincoln.mkz_2017" in text
    assert "Positions" in text
    assert runs.check(cut).whole


def test_a_server_that_keeps_its_files_elsewhere_refuses_to_record_and_says_where(
    finished: tuple[str, Path, Path], tmp_path: Path
) -> None:
    simulator, through, _ = finished
    elsewhere = tmp_path / "run"
    shutil.copytree(through, elsewhere)
    scene = next(row["scene_id"] for row in runs.read_scenes(runs.Workspace(through)) if row["status"] == "ran")
    done = CliRunner().invoke(main, ["replay", str(elsewhere), scene, "--simulator", simulator, "--record"])
    assert done.exit_code == 1
    assert "did not record" in done.output
    assert f"files of clients are below {through.parent}," in done.output
    assert not list((elsewhere / "recordings").iterdir())


def test_a_simulator_without_a_window_says_so(tmp_path: Path) -> None:
    pipeline.run(asked("embedded", scenes=1), tmp_path / "run")
    scene = runs.read_scenes(runs.Workspace(tmp_path / "run"))[0]["scene_id"]
    with pytest.raises(SettingsError, match="'embedded' has no window and no recorder"):
        replay(tmp_path / "run", scene, watch=True)


def test_a_replay_that_strays_is_told(finished: tuple[str, Path, Path], monkeypatch: pytest.MonkeyPatch) -> None:
    simulator, through, _ = finished
    scene = next(row["scene_id"] for row in runs.read_scenes(runs.Workspace(through)) if row["status"] == "ran")
    carla: Any = sys.modules["carla"]
    control = carla.VehicleControl

    def weaker(*, throttle: float = 0.0, **given: Any) -> Any:
        return control(throttle=throttle / 4, **given)

    monkeypatch.setattr(carla, "VehicleControl", weaker)
    again = replay(through, scene, repeated=Repeated(simulator=(simulator,)))
    assert not again.identical
    assert again.difference


def test_an_address_in_a_record_is_called_only_if_the_user_names_it_too(finished: tuple[str, Path, Path]) -> None:
    simulator, through, _ = finished
    with pytest.raises(RunError, match=f"names the simulator '{simulator}'.* say so: --simulator {simulator}"):
        replay(through, "any")


def test_egos_are_measured_in_a_server(finished: tuple[str, Path, Path], tmp_path: Path) -> None:
    simulator, through, _ = finished
    with pytest.raises(SettingsError, match="use --jobs 1"):
        evaluate([through], tmp_path / "two", egos=["idm"], simulator=simulator, workers=Workers(2), progress=silent)
    done = evaluate([through], tmp_path / "one", egos=["idm"], simulator=simulator, progress=silent)
    assert not done.failures
    assert all(isinstance(table, ResultTable) for table in done.tables.values())
    assert runs.read_record(runs.Workspace(tmp_path / "one"), runs.EvaluationRecord).simulator.name == "carla"


def test_programs_run_in_a_server_only_if_they_are_packaged_or_trusted(finished: tuple[str, Path, Path]) -> None:
    there = Settings(simulation=SimulationSettings(simulator=finished[0]))
    with pytest.raises(SettingsError, match="cannot run in the sandbox, and only there is run what is not packaged"):
        simulator_of(load_generator("program"), TOWN, there)
    trusted = load_generator("chatscene.search.generators.own_program:trusted")
    assert simulator_of(trusted, TOWN, there).identity.name == "carla"
