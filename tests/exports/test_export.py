"""Scenes leave a run as files, exactly as they are kept, or not at all."""

from __future__ import annotations

import csv
import io
import json
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from click.testing import CliRunner

import chatscene
from chatscene import pipeline, runs
from chatscene.commands.main import main
from chatscene.errors import MapError, MissingExtra, RunError, SettingsError
from chatscene.exports.export import export, kept_scenes
from chatscene.exports.exporter import EXPORTERS, KeptScene
from chatscene.exports.filled_program import FilledProgram
from chatscene.exports.opendrive import OpenDrive
from chatscene.maps.network import resolve_map
from chatscene.settings import SearchSettings, Settings
from chatscene.terms.episode import SignalTrack
from chatscene.testing.exporters import awkward_scenes
from chatscene.world.compilation import compile_program
from fake_run import finished, resealed, started
from plainly import STOPS


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("export") / "run"
    few = Settings(search=SearchSettings(scenes=2, block=1, routes=2))
    pipeline.run(runs.asked_run(STOPS, settings=few, ego="rule-based"), folder)
    return folder


def _ids(folder: Path, status: str = "ran") -> list[str]:
    return [row["scene_id"] for row in runs.read_scenes(runs.Workspace(folder)) if row["status"] == status]


def test_a_table_of_tracks_is_read_back_to_the_last_bit(whole: Path, tmp_path: Path) -> None:
    scene_id = _ids(whole)[0]
    done = export(whole, [scene_id], to="csv", out=tmp_path / "out")
    (name,) = done.files[scene_id]
    rows = list(csv.DictReader(io.StringIO((tmp_path / "out" / name).read_text())))
    for track in runs.read_episode(runs.open_run(whole), scene_id).tracks:
        own = [row for row in rows if row["actor"] == track.actor]
        for column, values in {
            "x_m": track.x,
            "y_m": track.y,
            "heading_rad": track.heading,
            "speed_m_per_s": track.speed,
        }.items():
            assert np.array_equal([float(row[column]) for row in own], values)
        assert {(row["kind"], float(row["length_m"])) for row in own} == {(track.kind, track.length)}


def test_an_exported_program_draws_nothing_and_places_everybody_where_the_drive_began(whole: Path) -> None:
    for kept in kept_scenes(whole, _ids(whole)):
        source = FilledProgram().files(kept)[f"{kept.stem}.scenic"].decode()
        assert "Range(" not in source
        # Scenic's own command takes map and route from the file, as the last line holds; here they are told.
        scene, _ = compile_program(source, map_path=resolve_map("town"), route=kept.route).generate(maxIterations=1)
        starts = sorted((float(thing.position.x), float(thing.position.y)) for thing in scene.objects)
        tracks = sorted((float(track.x[0]), float(track.y[0])) for track in kept.episode.tracks)
        assert np.allclose(starts, tracks, atol=1e-9, rtol=0)
        assert f"param map = localPath('town.xodr')\nparam route = {kept.route}\nmodel " in source


def test_a_program_that_lacks_a_value_or_draws_by_itself_is_refused() -> None:
    kept = awkward_scenes()[0]
    with pytest.raises(RunError, match="no value of OPT_GEO_Y"):
        FilledProgram().files(replace(kept, values={"OPT_SPEED": 1.0}))
    drawing = kept.program.replace("chatscene.world.model", "scenic.domains.driving.model")
    with pytest.raises(RunError, match=r"Scenic itself draws.*--to csv"):
        FilledProgram().files(replace(kept, program=drawing))


# A logical scenario is of packaged snippets, and this run's are made for tests: `test_openscenario_logical.py`.
@pytest.mark.parametrize("name", sorted({*EXPORTERS.built_in} - {"openscenario-logical"}))
def test_without_a_scene_those_are_exported_that_the_run_keeps(name: str, tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    try:
        done = export(run.path, to=name, out=tmp_path / "out")
    except MissingExtra as error:
        pytest.skip(str(error))
    assert list(done.files) == [row["scene_id"] for row in runs.read_scenes(run) if row["selected"]]
    there = {path.name for path in (tmp_path / "out").iterdir()}
    assert there == {file for files in done.files.values() for file in files}


def test_an_export_simulates_and_changes_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    run = finished(tmp_path / "run", count=1)

    def refuse(*_: object, **__: object) -> None:
        raise AssertionError("a kept scene is copied")

    monkeypatch.setattr("chatscene.simulate.simulator.simulate", refuse)
    for name in ("openscenario", "csv", "scenic"):
        export(run.path, to=name, out=tmp_path / name)
    assert runs.check(run.path).whole


def test_what_cannot_be_exported_is_told_and_leaves_nothing_behind(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    out = tmp_path / "out"
    for error, match, scenes, to in [
        (SettingsError, "no exporter 'openscenari'; did you mean 'openscenario'", [], "openscenari"),
        (RunError, "has no scene 'nobody'", ["nobody"], "csv"),
        (RunError, "rejected and never driven: bus-stop overlaps", _ids(run.path, "rejected"), "csv"),
    ]:
        with pytest.raises(error, match=match):
            export(run.path, scenes, to=to, out=out)
    assert not out.exists()
    out.mkdir()
    (out / "mine.txt").write_text("mine")
    with pytest.raises(SettingsError, match="is not empty, and an export overwrites nothing"):
        export(run.path, to="csv", out=out)
    with pytest.raises(SettingsError, match="is a file"):
        export(run.path, to="csv", out=out / "mine.txt")
    assert [path.name for path in out.iterdir()] == ["mine.txt"]


def test_a_run_that_is_not_done_keeps_no_scenes_yet(tmp_path: Path) -> None:
    with pytest.raises(RunError, match="was interrupted; continue with"):
        export(started(tmp_path / "run").path, to="csv", out=tmp_path / "out")


def test_a_run_folder_chooses_no_file_but_a_map(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    (tmp_path / "key.pem").write_text("secret")
    resealed(run, map_name=str(tmp_path / "key.pem"))
    with pytest.raises(MapError, match="is not complete XML"):
        export(run.path, to="openscenario", out=tmp_path / "out")


class Exporter:
    """One that does what it is told."""

    def __init__(self, given: Mapping[str, bytes] | Exception) -> None:
        self._given = given

    def files(self, scene: KeptScene) -> Mapping[str, bytes]:
        if isinstance(self._given, Exception):
            raise self._given
        return self._given


@pytest.mark.parametrize(
    ("given", "match"),
    [
        (ValueError("no more"), "exporter 'mine' fails on .*: ValueError: no more"),
        ({"../up": b"x"}, "which is not the plain name of a file"),
    ],
)
def test_an_exporter_that_fails_is_told_by_its_name(
    given: Any, match: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = finished(tmp_path / "run", count=1)

    def load(name: str) -> Exporter:
        return Exporter(given)

    monkeypatch.setattr("chatscene.exports.export.load_exporter", load)
    with pytest.raises(SettingsError, match=match):
        export(run.path, to="mine", out=tmp_path / "out")
    assert not (tmp_path / "out").exists()


def test_the_command_and_the_function_name_what_they_wrote(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    told = CliRunner().invoke(main, ["export", str(run.path), "--to", "csv", "--out", str(tmp_path / "a")])
    assert told.exit_code == 0
    assert all(Path(line).is_file() for line in told.output.split())
    command = ["export", str(run.path), "--to", "openscenario", "--out", str(tmp_path / "b"), "--json"]
    files = json.loads(CliRunner().invoke(main, command).output)["files"]
    assert files == {k: list(v) for k, v in chatscene.export(run.path, to="openscenario").files.items()}
    wrong = CliRunner().invoke(main, ["export", str(run.path), "--to", "csv", "--out", str(tmp_path / "a")])
    assert wrong.exit_code == 1
    assert "is not empty" in wrong.output


def test_the_map_leaves_as_it_is_and_lights_say_when_they_change() -> None:
    kept = awkward_scenes()[1]
    assert OpenDrive().files(kept) == {kept.map.name: kept.map.content}
    light = SignalTrack(x0=1.0, y0=2.0, x1=3.0, y1=4.0, state="rrgy", role="ego")
    lit = replace(kept, episode=replace(kept.episode, signals=(light,)))
    files = OpenDrive().files(lit)
    rows = list(csv.DictReader(io.StringIO(files[f"{kept.stem}_signals.csv"].decode())))
    told = [(float(row["time_s"]), row["state"], row["role"], float(row["y1_m"])) for row in rows]
    assert told == [
        (0.0, "red", "ego", 4.0),
        (pytest.approx(0.2), "green", "ego", 4.0),
        (pytest.approx(0.3), "yellow", "ego", 4.0),
    ]
