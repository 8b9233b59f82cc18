"""A user's own programs: what is read from them, and how they are put right."""

import os
from collections.abc import Iterator
from pathlib import Path

import pytest

from chatscene.commands.make import _programs  # pyright: ignore[reportPrivateUsage]
from chatscene.ego.rule_based import RuleBased
from chatscene.errors import ForeignCodeRefused, ProgramError
from chatscene.maps.network import resolve_map
from chatscene.program.check import probe_scenes
from chatscene.search.explore import explore
from chatscene.search.generators.foreign import ADVERSARY_BEHAVIOR, foreign_files, foreign_program, read_foreign
from chatscene.settings import SearchSettings, SimulationSettings
from chatscene.simulate.confined.allow_list import check_foreign
from chatscene.simulate.confined.plain_text import TRUST
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.simulate.simulator import load_simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.scenario import Slots
from red_team.corpus import ATTACKS

MINE = """# My own: a van pulls out.
model chatscene.world.model

param OPT_DISTANCE = Range(10, 30)
param OPT_SPEED = Range(3, 8)

egoRoute = selectRoute(maneuver="straight", lanes=2)
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute

behavior PullOut(way):
    do Halt() until headway(egoRoute, ego, self) < globalParameters.OPT_DISTANCE
    do DrivePath(way, globalParameters.OPT_SPEED)

van = new Truck at besideRoad(egoRoute, 45, "right", 0.5), facing directionOn(egoRoute, 45),
    with behavior PullOut(egoRoute)
"""


@pytest.fixture(scope="module")
def simulator() -> Iterator[ConfinedSimulator]:
    with ConfinedSimulator(resolve_map("town"), SimulationSettings()) as simulator:
        yield simulator


def written(folder: Path, text: str, name: str = "My scene.scenic") -> Path:
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path


def test_a_file_becomes_a_program_with_the_ranges_it_declares(tmp_path: Path) -> None:
    read = read_foreign(written(tmp_path, MINE))
    assert read.program.scenario_id == "my-scene"
    assert [(p.name, p.low, p.high) for p in read.program.parameters] == [
        ("OPT_DISTANCE", 10.0, 30.0),
        ("OPT_SPEED", 3.0, 8.0),
    ]
    assert read.program.snippet_ids == ()


def test_the_only_behavior_is_the_adversarys_whatever_it_is_called(tmp_path: Path) -> None:
    read = read_foreign(written(tmp_path, MINE))
    assert read.renamed == "PullOut"
    assert read.program.source == MINE.replace("PullOut", ADVERSARY_BEHAVIOR)
    named = read_foreign(written(tmp_path, read.program.source))
    assert named.renamed == ""
    assert named.program.digest == read.program.digest


def test_a_behavior_is_given_with_brackets_or_without(tmp_path: Path) -> None:
    bare = MINE.replace("PullOut(way)", "PullOut()").replace("with behavior PullOut(egoRoute)", "with behavior PullOut")
    read = read_foreign(written(tmp_path, bare.replace("DrivePath(way", "DrivePath(egoRoute")))
    assert read.renamed == "PullOut"


def test_a_folder_is_read_in_order_of_names(tmp_path: Path) -> None:
    for name in ("b.scenic", "a.scenic", "note.txt"):
        written(tmp_path, MINE, name)
    (tmp_path / "more").mkdir()
    written(tmp_path / "more", "import library\n" + MINE, "c.scenic")
    written(tmp_path / "more", "x = 3\n", "library.scenic")
    assert [file.name for file in foreign_files(tmp_path)] == ["a.scenic", "b.scenic", "c.scenic"]


def test_line_ends_and_marks_of_windows_are_understood(tmp_path: Path) -> None:
    path = tmp_path / "w.scenic"
    path.write_bytes(b"\xef\xbb\xbf" + MINE.replace("\n", "\r\n").encode())
    assert read_foreign(path).program.digest == foreign_program("w", MINE).digest


def test_a_foreign_program_is_driven_and_searched_like_our_own(simulator: ConfinedSimulator) -> None:
    program = foreign_program("mine", MINE)
    episode = simulate(simulator, program, probe_scenes(program, 0)[0], RuleBased(), through_collisions=True)
    assert isinstance(episode, Episode)
    assert [track.kind for track in episode.adversaries] == ["Truck"]
    assert episode.adversaries[0].speed.max() > 2.0
    settings = SearchSettings(scenes=4, block=2, keep=1)
    first, second = explore(program, Slots(), 0, simulator=simulator, ego=RuleBased(), settings=settings)
    assert len(first.ran) == len(second.ran) == 2


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "is empty"),
        ("ego = new Car\n", "begins with one line `model chatscene.world.model`"),
        (MINE.replace("chatscene.world.model", "scenic.simulators.webots.model"), "and no other"),
        (MINE.replace("ego = new", "other = new"), "has no ego; add: ego = new Car"),
        (MINE.replace(", with route egoRoute", ""), "the ego at line 8 has no route"),
        (MINE.replace(",\n    with behavior PullOut(egoRoute)", ""), "which road user is the adversary?"),
        (MINE + "new Car at pointOn(egoRoute, 60), with behavior Park()\n", "found: Park, PullOut"),
        (
            MINE.replace("with route", "with behavior FollowLaneBehavior(), with route"),
            "leave out its `with behavior …`",
        ),
        (MINE + "scenario Main():\n    setup:\n        x = 1\n", "line 16: a scenario: modular scenarios are not"),
        (MINE + "scenario Main():\n    compose:\n        do Sub()\n", "modular scenarios are not supported"),
        (MINE.replace("do Halt()", "override self with width 3\n    do Halt()"), "override: modular scenarios are not"),
        (MINE + "record final van.speed as fastest\n", "a program records nothing"),
        (MINE + "monitor M():\n    wait\nrequire monitor M()\n", "there are no monitors; say it with"),
        (MINE + "mutate van\n", "make what varies a parameter"),
        (MINE + "class Van(Truck):\n    length: 6\n", "size and speed are set with `with`"),
        (MINE + "new Car on road\n", "a thing stands at a place"),
        (MINE.replace("do Halt()", "do choose Halt(), Park()\n    do Halt()"), "let a parameter decide"),
        (MINE.replace("do Halt()", "require always 1 < 2\n    do Halt()"), "over time in a behavior"),
        (MINE.replace("Range(10, 30)", "Range(30, 10)"), "the lower first"),
        (MINE.replace("Range(10, 30)", "3 * 4"), "Range"),
        (MINE + "import os\n", "line 16: import"),
        ("model chatscene.world.model\nx = (\n", "line 2, column 5: not Scenic: this ( is never closed"),
        ("x" * 50_000, "at most 20000"),
    ],
)
def test_what_is_wrong_is_said_with_the_way_to_put_it_right(text: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(ForeignCodeRefused) as refusal:
        read_foreign(written(tmp_path, text))
    assert message in str(refusal.value)


THEIRS = """param map = localPath('../maps/Town01.xodr')
model scenic.simulators.carla.model
ego = new Car
"""


def test_a_program_for_another_world_model_is_read_with_the_map_that_it_names(tmp_path: Path) -> None:
    read = read_foreign(written(tmp_path, THEIRS))
    assert read.program.model == "scenic.simulators.carla.model"
    assert read.program.drawn
    assert read.map_path == tmp_path.parent / "maps" / "Town01.xodr"
    assert not read_foreign(written(tmp_path, MINE)).program.drawn


@pytest.mark.parametrize(
    ("text", "message"),
    [
        (THEIRS.replace("ego = ", "other = "), "has no ego; add: ego = new Car"),
        (THEIRS + "import os\n", "line 4: import"),
        (THEIRS + "x = ego.__class__\n", "line 4: .__class__"),
        (THEIRS + "x = open('a')\n", "line 4: the name open"),
        (THEIRS + "x = simulation().scene\n", "line 4: .scene"),
        (THEIRS + "record ego.speed as v to videos\n", "nothing is written while a drive goes on"),
        (THEIRS + "def f(x):\n    return x\n@f\ndef g():\n    return 1\n", "a decorator or an annotation"),
        (THEIRS + "globalParameters = 3\n", "in the place of what is given"),
        (THEIRS + "model chatscene.world.model\n", "the beginning"),
    ],
)
def test_what_a_strangers_program_for_another_model_may_not_is_said(text: str, message: str, tmp_path: Path) -> None:
    with pytest.raises(ForeignCodeRefused) as refusal:
        read_foreign(written(tmp_path, text))
    assert message in str(refusal.value)


def test_what_is_tried_against_the_sandbox_is_refused_in_a_program_for_another_model_too() -> None:
    tried = [attack.source for attack in ATTACKS if "model chatscene.world.model" in attack.source]
    assert len(tried) > 80
    for source in tried:
        other = source.replace("model chatscene.world.model", "model scenic.simulators.carla.model")
        assert check_foreign(other) or not check_foreign(source)


def test_what_is_no_text_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "empty").mkdir()
    os.mkfifo(tmp_path / "pipe.scenic")
    (tmp_path / "latin.scenic").write_bytes("# Fußgänger".encode("latin-1"))
    for name, message in (
        ("none.scenic", "there is no file"),
        ("pipe.scenic", "there is no file"),
        ("latin.scenic", "not UTF-8 text"),
    ):
        with pytest.raises(ForeignCodeRefused, match=message):
            read_foreign(tmp_path / name)
    with pytest.raises(ForeignCodeRefused, match=r"holds no \.scenic file"):
        foreign_files(tmp_path / "empty")


@pytest.mark.parametrize(
    ("right", "wrong", "message"),
    [
        ("do Halt()", "do Hallt()", "line 11: the name Hallt: neither the program nor the world model defines it"),
        ("do Halt()", "do Hallt()", "did you mean Halt?\n    do Hallt() until"),
        ("do Halt()", "do Hallt()", "\n       ^^^^^"),
        ("new Truck", "new Truk", "did you mean Truck?"),
        ("with route", "with rout", "with rout: there is no such property; did you mean route?"),
        ("facing directionOn(egoRoute, 0)", "facng directionOn(egoRoute, 0)", "line 8, column 37: not Scenic"),
        ("facing directionOn(egoRoute, 0)", "facng directionOn(egoRoute, 0)", "specifier facng; did you mean facing?"),
        ("OPT_SPEED)", "OPT_SPED)", "the program has no such parameter; did you mean OPT_SPEED?"),
        ("chatscene.world.model", "chatscene.wrld.model", "did you mean chatscene.world.model?"),
        ("startOf(egoRoute)", "startOf(egoRoute", "line 8, column 25: not Scenic: this ( is never closed"),
        ("startOf(egoRoute)", "startOf(egoRoute))", "line 8, column 35: not Scenic: this ) closes nothing"),
        ('"right"', '"right', "line 14, column 45: not Scenic: this quote is never closed"),
        ('"right"', '"""right', "line 14, column 45: not Scenic: this quote is never closed"),
        ('"right"', "r'right", "line 14, column 46: not Scenic: this quote is never closed"),
        ('"right"', "'ri(ght'(", "line 14, column 30: not Scenic: this ( is never closed"),
        ("startOf(egoRoute)", "startOf(egoRoute]", "line 8, column 34: not Scenic: this ] closes nothing"),
        ("new Truck", "new Truck  # isn't (", "line 15, column 1: not Scenic"),
        ("    do DrivePath", "\tdo DrivePath", "lines are indented with tabs and with blanks"),
        ("ego = new Car", "ego = Car", "line 8: Car without new: this is Scenic 2; Scenic 3 needs `new`"),
        ("new ", "", "write `new Car` (so too in line 14)"),
    ],
)
def test_a_mistake_is_shown_where_it_is_with_what_was_meant(
    right: str, wrong: str, message: str, tmp_path: Path
) -> None:
    path = written(tmp_path, MINE.replace(right, wrong))
    with pytest.raises(ForeignCodeRefused) as refusal:
        read_foreign(path)
    assert str(refusal.value).startswith(f"your program {path}: line ")
    assert message in str(refusal.value)
    assert "--trust" not in str(refusal.value)  # which would not help


@pytest.mark.parametrize(
    "text",
    [
        "model scenic.domains.driving.model\nego = Car\n",
        "model scenic.domains.driving.model\nego = Pedestrian at (-36, 118)\n",
        "model scenic.domains.driving.model\nego = new Car\nother = Car at (1, 2)\n",
        "model scenic.domains.driving.model\nego = new Car at (OrientedPoint in network.lanes[0])\n",
    ],
)
def test_a_program_for_scenic_2_is_told_as_one_even_if_its_lines_mean_something_to_scenic_3(text: str) -> None:
    with pytest.raises(ForeignCodeRefused, match="this is Scenic 2; Scenic 3 needs `new`"):
        foreign_program("x", text)


@pytest.mark.parametrize(
    ("line", "message"),
    [
        ("x = f'{ego}'", "an f-string: the sandbox does not allow it"),
        ("x = [y for y in (1, 2)]", "a list comprehension: the sandbox"),
        ("x = 1 << 2", "the operator <<: the sandbox does not allow it\n    x = 1 << 2\n          ^^"),
        ("print('x')", "the name print: the sandbox does not allow it"),
        ("x = 'a/b'", "a text may not hold '/'"),
        (f"x = '{'a' * 130}'", "it has 130 characters, and a text has at most 120"),
        ("x = b'a'", "a constant is a real number, a text, True, False or None"),
        ("x = 1e9", "numbers lie between ±1000000"),
        ("workspace = 3", "workspace: the sandbox does not allow it"),
    ],
)
def test_what_only_the_sandbox_forbids_is_said_in_words_with_the_way_round_it(line: str, message: str) -> None:
    with pytest.raises(ForeignCodeRefused) as refusal:
        foreign_program("x", MINE + line + "\n")
    assert message in str(refusal.value)
    assert str(refusal.value).endswith("\n" + TRUST)


@pytest.mark.parametrize(
    "lines",
    [
        "town = 'Town05'\nparam map = localPath(f'../maps/{town}.xodr')\n",
        "param map = f'../maps/Town05.xodr'\n",
        "where = localPath('../maps/Town05.xodr')\nparam map = where\n",
        "param town = 'Town05'\nparam map = localPath('../maps/' + globalParameters.town + '.xodr')\n",
    ],
)
def test_the_path_of_a_map_may_be_put_together_of_texts(lines: str, tmp_path: Path) -> None:
    read = read_foreign(written(tmp_path, f"{lines}model scenic.domains.driving.model\nego = new Car\n"))
    assert read.map_path == tmp_path.parent / "maps" / "Town05.xodr"


def test_a_path_that_the_program_uses_elsewhere_keeps_to_the_rules_for_texts() -> None:
    text = (
        "where = '/etc/passwd'\nparam map = where\nmodel scenic.domains.driving.model\nego = new Car with name where\n"
    )
    assert [refusal.what for refusal in check_foreign(text)] == ["the text /etc/passwd"]


def test_a_name_that_only_names_the_map_keeps_to_the_rules_for_names() -> None:
    rest = "model scenic.domains.driving.model\nego = new Car\n"
    for name in ("range", "__builtins__"):
        refusals = check_foreign(f"{name} = '../Town05'\nparam map = localPath({name})\n{rest}")
        assert [refusal.what for refusal in refusals] == [f"the name {name}"]


@pytest.mark.parametrize("part", ["{a%d}{a%d}", "{a%d}"], ids=["grows with every name", "deep"])
def test_a_path_that_is_longer_or_deeper_than_any_is_read_in_no_time(part: str) -> None:
    names = "".join(f"a{n + 1} = f'{part.replace('%d', str(n))}'\n" for n in range(400))
    refusals = check_foreign(
        f"a0 = 'x'\n{names}param map = localPath(a400)\nmodel scenic.domains.driving.model\nego = new Car\n"
    )
    assert {refusal.what for refusal in refusals} <= {"an f-string"}


@pytest.mark.parametrize("path", ["a\\x00.xodr", "a\\ud800.xodr"], ids=["a null byte", "half a character"])
def test_a_path_that_no_file_can_have_is_no_map(path: str, tmp_path: Path) -> None:
    text = f"param map = localPath('{path}')\nmodel scenic.domains.driving.model\nego = new Car\n"
    assert read_foreign(written(tmp_path, text), trusted=True).map_path is None


def test_a_path_whose_links_lead_round_in_a_circle_is_a_map_that_is_not_there(tmp_path: Path) -> None:
    (tmp_path / "a.xodr").symlink_to("a.xodr")
    text = "param map = localPath('a.xodr')\nmodel scenic.domains.driving.model\nego = new Car\n"
    assert read_foreign(written(tmp_path, text)).map_path == tmp_path / "a.xodr"


def test_a_text_too_deep_for_the_parser_is_called_so() -> None:
    deep = "x = " + "f(a=" * 19 + "[1 1]" + ")" * 19
    why = " ".join(map(str, check_foreign("".join(f"{'  ' * n}if 1 < 2:\n" for n in range(40)) + "  " * 40 + deep)))
    assert "recursion" not in why


def test_a_program_longer_than_any_is_refused_whole_even_if_it_is_trusted(tmp_path: Path) -> None:
    path = written(tmp_path, MINE + "# more\n" * 20_000)
    with pytest.raises(ForeignCodeRefused, match="has more than 80000 bytes"):
        read_foreign(path, trusted=True)


@pytest.mark.parametrize("confined", [True, False], ids=["in the sandbox", "trusted"])
def test_what_fails_while_it_runs_is_shown_where_it_does(confined: bool, simulator: ConfinedSimulator) -> None:
    program = foreign_program("mine", MINE.replace("    do Halt()", "    speed = ego.position[7]\n    do Halt()"))
    where = simulator if confined else load_simulator(resolve_map("town"), SimulationSettings())
    with pytest.raises(ProgramError) as failure:
        simulate(where, program, probe_scenes(program, 0)[0], RuleBased())
    assert str(failure.value).startswith("your program mine, scene ")
    assert "line 11: IndexError" in str(failure.value)
    assert str(failure.value).endswith("    speed = ego.position[7]\n            ^^^^^^^^^^^^^^^")


def test_an_unknown_name_of_a_trusted_program_is_told_with_the_one_that_was_meant() -> None:
    program = foreign_program("mine", MINE.replace("do Halt()", "do Hallt()"), trusted=True)
    with pytest.raises(ProgramError, match=r"line 11: NameError: name 'Hallt' is not defined; did you mean Halt\?"):
        simulate(
            load_simulator(resolve_map("town"), SimulationSettings()), program, probe_scenes(program, 0)[0], RuleBased()
        )


@pytest.mark.parametrize("value", ["Normal(20, 5)", "Range(LOW, 30)", "Range(10, 30) + 1", "Uniform(10, 30)"])
def test_a_parameter_that_is_drawn_and_cannot_be_searched_is_refused_by_its_line(value: str) -> None:
    source = MINE.replace(
        "model chatscene.world.model\n", f"model chatscene.world.model\nLOW = 10\nparam OPT_Z = {value}\n"
    )
    assert source != MINE
    with pytest.raises(ForeignCodeRefused, match=r"the parameter OPT_Z at line \d+ is drawn"):
        foreign_program("mine", source, trusted=True)


def test_a_parameter_that_is_searched_is_named_as_such() -> None:
    source = MINE.replace("param OPT_SPEED", "param AWAY = Range(10, 30)\nparam OPT_SPEED")
    with pytest.raises(ForeignCodeRefused, match="write `param OPT_AWAY = Range"):
        foreign_program("mine", source, trusted=True)


def test_two_programs_of_a_folder_whose_names_join_to_one_are_both_run(tmp_path: Path) -> None:
    (tmp_path / "a").mkdir()
    for name in ("a-b.scenic", "a/b.scenic"):
        (tmp_path / name).write_text(MINE)
    assert set(_programs(tmp_path)) == {"a-b", "a-b-2"}


def test_a_word_in_a_text_imports_nothing(tmp_path: Path) -> None:
    (tmp_path / "cut.scenic").write_text('"""A car comes\nfrom behind and cuts in.\n"""\n' + MINE)
    (tmp_path / "behind.scenic").write_text(MINE)
    assert [file.stem for file in foreign_files(tmp_path)] == ["behind", "cut"]
