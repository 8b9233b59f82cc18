"""A scene that was exported as a program is a program of the user's like any other, and drives as the scene did."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import chatscene
from chatscene import runs
from chatscene.commands.main import main
from chatscene.errors import ForeignCodeRefused, SettingsError
from chatscene.exports.export import export
from chatscene.search.generators.foreign import read_foreign
from chatscene.simulate.confined.allow_list import check_foreign
from chatscene.terms.episode import Episode
from plainly import CUTS_IN, STOPS
from red_team.corpus import ATTACKS, Attack

EXPORTED = """# scene mine/route-02/scene-004
param map = localPath('town.xodr')
param route = 2
model chatscene.world.model
param OPT_X = -1.25
param OPT_SPEED = Range(3, 8)

egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
behavior AdvBehavior():
    do MoveAhead(globalParameters.OPT_SPEED)
A = new Pedestrian at besideRoad(egoRoute, 45, "right", 2 + globalParameters.OPT_X), with behavior AdvBehavior()
"""


def _written(folder: Path, text: str) -> Path:
    path = folder / "one.scenic"
    path.write_text(text)
    return path


def _same(ours: Episode, theirs: Episode) -> bool:
    return len(ours.tracks) == len(theirs.tracks) and all(
        (one.role, one.kind) == (other.role, other.kind)
        and all(np.array_equal(getattr(one, name), getattr(other, name)) for name in ("x", "y", "heading", "speed"))
        for one, other in zip(ours.tracks, theirs.tracks, strict=True)
    )


@pytest.mark.parametrize(
    ("text", "on", "ego"),
    [
        (STOPS, None, "rule-based"),
        (CUTS_IN, "outskirts", "planner"),
        ("A car comes the other way.", "region", "idm"),
        (STOPS, "road:1+1,length=600", "planner"),
        ("A cyclist ahead brakes.", "road:2+2,median=4,length=900", "idm"),
    ],
)
def test_an_exported_scene_is_run_again_with_the_same_tracks_to_the_last_bit(
    text: str, on: str | None, ego: str, tmp_path: Path
) -> None:
    chatscene.run(text, tmp_path / "run", map=on, ego=ego, scenes=2, routes=2)
    _check_again(tmp_path, ego)


@pytest.mark.parametrize("as_written", [True, False])
def test_so_is_one_of_an_imported_file(as_written: bool, tmp_path: Path) -> None:
    chatscene.run(CUTS_IN, tmp_path / "first", ego="idm", scenes=1, routes=1)
    export(tmp_path / "first", to="openscenario", out=tmp_path / "theirs")
    (file,) = (tmp_path / "theirs").glob("*.xosc")
    program = chatscene.import_scenario(file).program
    chatscene.run(program=program, folder=tmp_path / "run", ego="idm", as_written=as_written, scenes=1)
    _check_again(tmp_path, "idm", as_written=as_written)


def _check_again(folder: Path, ego: str, *, as_written: bool = False) -> None:
    """Export the scenes that a run keeps, run two of them, and compare what was driven."""
    first = runs.open_run(folder / "run")
    done = export(folder / "run", to="scenic", out=folder / "out")
    for number, scene_id in enumerate(sorted(done.files, reverse=True)[:2]):
        (program,) = (name for name in done.files[scene_id] if name.endswith(".scenic"))
        again = folder / f"again-{number}"
        chatscene.run(program=folder / "out" / program, folder=again, ego=ego, as_written=as_written, scenes=3)
        (only,) = runs.read_scenes(runs.Workspace(again))
        assert _same(runs.read_episode(first, scene_id), runs.read_episode(runs.open_run(again), only["scene_id"]))


def test_it_is_read_with_its_lines_where_they_were_its_map_and_its_one_route(tmp_path: Path) -> None:
    read = read_foreign(_written(tmp_path, EXPORTED))
    source = read.program.source
    assert read.map_path == tmp_path.resolve() / "town.xodr"
    assert [(p.name, p.low, p.high) for p in read.program.parameters] == [("OPT_SPEED", 3, 8), ("OPT_X", -1.25, -1.25)]
    assert source.count("\n") == EXPORTED.count("\n")
    assert 'selectRoute(only=2, maneuver="straight")' in source
    assert read.varies()


@pytest.mark.parametrize("call", ['"straight"', '"straight", lanes=1', 'maneuver="straight",', 'maneuver=("straight")'])
def test_wherever_the_route_is_chosen_it_is_that_one(call: str, tmp_path: Path) -> None:
    source = read_foreign(_written(tmp_path, EXPORTED.replace('maneuver="straight"', call))).program.source
    assert "only=2" in source
    assert check_foreign(source) == ()


def test_its_lines_may_stand_behind_the_model(tmp_path: Path) -> None:
    place = "param map = localPath('town.xodr')\nparam route = 2\n"
    moved = EXPORTED.replace(place, "").replace(
        "model chatscene.world.model\n", f"model chatscene.world.model\n{place}"
    )
    read = read_foreign(_written(tmp_path, moved))
    assert read.map_path == tmp_path.resolve() / "town.xodr"
    assert "only=2" in read.program.source


@pytest.mark.parametrize(
    ("was", "now"),
    [
        ("param route = 2", "param route = -1"),
        ("param route = 2", "param route = 1.5"),
        ("param route = 2", "param route = True"),
        ("param route = 2", "param route = Range(0, 3)"),
        ("param route = 2", "param route = 2\nparam route = 3"),
        ("param route = 2", "param route = 9999999"),
        ("selectRoute(", "selectRoute(only=1, "),
        ("localPath('town.xodr')", "'/etc/passwd'"),
        ("localPath('town.xodr')", "open('town.xodr')"),
        ("localPath('town.xodr')", "localPath('town.xodr', 1)"),
        ("-1.25", "1" + 400 * "0"),
        ("-1.25", "1e300"),
        ("-1.25", "1e999"),
        ("-1.25", "1j"),
        ("-1.25", "'text'"),
        ("-1.25", "globalParameters.OPT_SPEED"),
        ("-1.25", "open('x')"),
        ("param OPT_X", "param OPT_SPEED"),
        ("param route", "param simulator"),
    ],
)
def test_what_is_not_of_that_shape_is_refused_as_before(was: str, now: str, tmp_path: Path) -> None:
    with pytest.raises(ForeignCodeRefused):
        read_foreign(_written(tmp_path, EXPORTED.replace(was, now, 1)))


@pytest.mark.parametrize("attack", [one for one in ATTACKS if not one.listed], ids=lambda one: one.name)
def test_no_attack_passes_as_an_exported_scene(attack: Attack, tmp_path: Path) -> None:
    path = tmp_path / "one.scenic"
    text = f"param map = localPath('town.xodr')\nparam route = 0\n{attack.source}"
    path.write_bytes(text.encode(errors="surrogatepass"))
    with pytest.raises(ForeignCodeRefused):
        read_foreign(path)


def test_its_map_lies_in_the_folder_that_is_allowed(tmp_path: Path) -> None:
    (tmp_path / "in").mkdir()
    (tmp_path / "out.xodr").write_text("<OpenDRIVE/>")
    read = read_foreign(_written(tmp_path / "in", EXPORTED.replace("town.xodr", "../out.xodr")))
    with pytest.raises(SettingsError, match="a map that lies outside the folder"):
        read.check_map(tmp_path / "in")


def test_what_draws_by_itself_is_driven_as_often_as_was_asked(tmp_path: Path) -> None:
    fixed = EXPORTED.replace("Range(3, 8)", "4")
    assert not read_foreign(_written(tmp_path, fixed)).varies()
    assert read_foreign(_written(tmp_path, fixed.replace("45", "Range(40, 45)"))).varies()
    assert read_foreign(_written(tmp_path, f"import random\n{fixed}"), trusted=True).varies()


def test_it_is_verified_with_one_drive(tmp_path: Path) -> None:
    chatscene.run(STOPS, tmp_path / "run", ego="rule-based", scenes=1, routes=1)
    done = export(tmp_path / "run", to="scenic", out=tmp_path / "out")
    program = next(name for files in done.files.values() for name in files if name.endswith(".scenic"))
    said = CliRunner().invoke(main, ["verify", str(tmp_path / "out" / program), STOPS, "--ego", "rule-based"])
    assert said.exit_code in (0, 1), said.output
    assert "1 drive" in said.output
