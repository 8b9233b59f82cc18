from __future__ import annotations

import sys
from pathlib import Path

import pytest

from chatscene.errors import DoesNotCompile, SnippetError
from chatscene.library.load import load_library, load_snippet, names_of
from chatscene.library.snippet_file import names_in
from chatscene.maps.network import resolve_map
from chatscene.simulate.confined.allow_list import check_foreign
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Component, Place
from chatscene.terms.snippet import Snippet
from chatscene.world.compilation import compile_program
from places import FIXTURES

SMALL = FIXTURES / "library"
GOOD = (SMALL / "behavior" / "cross.scenic").read_text(encoding="utf-8")
NAMES = """
    ego selectRoute startOf trafficFrom wayOf besideRoad pointOn headway MoveAhead DrivePath Range globalParameters self
"""
WORLD = frozenset(NAMES.split())


def broken(tmp_path: Path, old: str, new: str) -> Path:
    assert GOOD.count(old) >= 1
    path = tmp_path / "behavior" / "broken.scenic"
    path.parent.mkdir()
    path.write_text(GOOD.replace(old, new, 1), encoding="utf-8")
    return path


def test_a_library_is_sorted_and_knows_its_snippets_by_id_and_by_component() -> None:
    library = load_library(SMALL)
    ids = [snippet.id for snippet in library]
    assert ids == sorted(ids)
    assert len(library) == len(ids) == sum(len(library.of(component)) for component in Component)
    assert library.get("behavior/cross").component is Component.BEHAVIOR


def test_a_file_becomes_a_snippet_with_its_header_and_its_code() -> None:
    snippet = load_snippet(SMALL / "behavior" / "cross.scenic")
    assert snippet.slots.actions == (Action.CROSS,)
    assert snippet.adversaries == (AdversaryKind.PEDESTRIAN, AdversaryKind.BICYCLE)
    assert [(p.name, p.low, p.high, p.unit) for p in snippet.parameters] == [("OPT_ADV_SPEED", 1.0, 4.0, "m/s")]
    assert "#:" not in snippet.source
    assert "behavior AdvBehavior():" in snippet.source
    assert load_snippet(SMALL / "spawn" / "oncoming.scenic").slots.place is Place.JUNCTION


def test_what_stands_behind_a_mark_is_no_code_and_the_rest_is_kept_as_it_is() -> None:
    snippet = load_snippet(SMALL / "behavior" / "cross.scenic")
    assert snippet.source.splitlines()[:2] == ["", "param OPT_ADV_SPEED = Range(1.0, 4.0)"]
    assert snippet.parameters[0].meaning == "how fast it goes"


CODE_AND_NAMES = [
    ('x = "advTrajectory"  # advKerb', (), ("x",)),
    ("AdvAgent = new AdvClass at p, with behavior AdvBehavior()", ("AdvBehavior", "p"), ("AdvAgent",)),
    ("AdvAgent = new Car with behavior DrivePath(way), with speed 3", ("way",), ("AdvAgent",)),
    ("route = selectRoute(lanes=2, opposite=advSide)", ("advSide",), ("route",)),
    ("x = advTrajectory.entry - globalParameters.OPT_Y", ("advTrajectory",), ("x",)),
    ("behavior AdvBehavior():\n    speed = limit\n    for n in range(3):\n        wait", ("limit",), ("AdvBehavior",)),
    ("behavior AdvBehavior():\n    do Halt() until advX == 1 for 2 seconds", ("advX",), ("AdvBehavior",)),
]


@pytest.mark.parametrize(("code", "requires", "provides"), CODE_AND_NAMES)
def test_names_are_read_off_the_words_of_the_code(
    code: str, requires: tuple[str, ...], provides: tuple[str, ...]
) -> None:
    assert names_in(code) == (requires, provides)


def test_wordings_stand_beside_a_snippet_one_a_line_and_are_not_needed(tmp_path: Path) -> None:
    path = tmp_path / "behavior" / "mine.scenic"
    path.parent.mkdir()
    path.write_text(GOOD, encoding="utf-8")
    assert load_snippet(path).rephrasings == ()
    beside = tmp_path / "wordings" / "behavior" / "mine.txt"
    beside.parent.mkdir(parents=True)
    beside.write_text("It goes.\n\n  He walks. \n", encoding="utf-8")
    assert load_snippet(path).rephrasings == ("It goes.", "He walks.")
    beside.write_text("It goes.\nHe walks.\nIT GOES.\n", encoding="utf-8")
    with pytest.raises(SnippetError, match=r"mine\.txt, line 3: 'IT GOES\.' stands there already"):
        load_snippet(path)
    beside.write_text("The pedestrian crosses the road.\n", encoding="utf-8")
    with pytest.raises(SnippetError, match=r"mine\.txt: .* is the description"):
        load_snippet(path)


FAMILY = """#: description = "It waits behind a $occluder on the $side."
#: adversaries = ["pedestrian"]
#: origin = "test"
#: [slots]
#: position = "roadside"
#: [variants]
#: behind-kiosk = { side = "left", occluder = "kiosk", Thing = "Kiosk", x = [1.5, 2], group = true, sides = ["left"] }
#: behind-hedge = { side = "right", occluder = "hedge", Thing = "Hedge", x = [1, 2.5], origin = "a dream" }
#: [descriptions]
#: behind-hedge = "A hedge hides it."

param OPT_GEO_X = Range$x  #: [m] how far from the $side edge
new $Thing at besideRoad(egoRoute, 20, "$side", 1)
AdvAgent = new AdvClass at besideRoad(egoRoute, 22, "$side", globalParameters.OPT_GEO_X)
new AdvClass at besideRoad(egoRoute, 24, crossed=$sides)  #: if group
clear = 1  #: unless group
kiosk = 2  #: if occluder kiosk  #: if sides left
"""


def family(folder: Path, old: str = "", new: str = "") -> Path:
    assert old in FAMILY
    path = folder / "spawn" / "behind.scenic"
    path.parent.mkdir(exist_ok=True)
    path.write_text(FAMILY.replace(old, new, 1), encoding="utf-8")
    return path


def test_each_row_of_a_family_is_a_snippet_of_its_own(tmp_path: Path) -> None:
    family(tmp_path)
    hedge, kiosk = load_library(tmp_path)
    assert (hedge.id, kiosk.id, kiosk.file) == ("spawn/behind-hedge", "spawn/behind-kiosk", "spawn/behind.scenic")
    assert (kiosk.description, hedge.description) == ("It waits behind a kiosk on the left.", "A hedge hides it.")
    assert (kiosk.origin, hedge.origin) == ("test", "a dream")
    assert kiosk.slots.said() == {"side": "left", "position": "roadside", "occluder": "kiosk", "group": True}
    assert (kiosk.parameters[0].low, kiosk.parameters[0].high) == (1.5, 2.0)
    assert kiosk.parameters[0].meaning == "how far from the left edge"
    assert kiosk.source.splitlines() == [
        "",
        "param OPT_GEO_X = Range(1.5, 2)",
        'new Kiosk at besideRoad(egoRoute, 20, "left", 1)',
        'AdvAgent = new AdvClass at besideRoad(egoRoute, 22, "left", globalParameters.OPT_GEO_X)',
        'new AdvClass at besideRoad(egoRoute, 24, crossed=("left",))',
        "kiosk = 2",
    ]
    assert hedge.source.splitlines()[-1] == "clear = 1"
    assert hedge.provides == ("AdvAgent", "clear")


@pytest.mark.parametrize(
    ("old", "new", "named"),
    [
        ("$Thing", "$Thin", "line 13: behind-kiosk has no value for $Thin"),
        ("$Thing", "$ Thing", "line 13: a $ begins the name of a value"),
        ("$Thing", "Car", "variants.behind-kiosk: nothing uses Thing"),
        ("if group", "if alone", "line 15: 'if alone': no row of variants has alone"),
        ("behind-kiosk =", "Behind_Kiosk =", "variants.Behind_Kiosk: a name has letters"),
        ("Range$x", "Range($x)", "line 12: a parameter has a line of its own"),
        ('side = "left"', 'side = "above"', "variants.behind-kiosk: slots.side"),
        ("group = true", "group = { a = 1 }", "group is a text, a number"),
        ('behind-hedge = "', 'behind-edge = "', "with names that variants has"),
        ('#: description = "It waits behind a $occluder on the $side."', "#:", "behind-kiosk: the header lacks its"),
        ("#: [variants]", "#: [more]", "descriptions are for the variants of a family"),
    ],
)  # fmt: skip
def test_a_fault_in_a_family_names_the_line_or_the_row(tmp_path: Path, old: str, new: str, named: str) -> None:
    path = family(tmp_path, old, new)
    with pytest.raises(SnippetError) as error:
        load_library(tmp_path)
    assert str(path) in str(error.value)
    assert named in str(error.value)


def test_two_files_of_a_folder_cannot_hold_the_same_snippet(tmp_path: Path) -> None:
    family(tmp_path)
    (tmp_path / "spawn" / "behind-hedge.scenic").write_text(GOOD, encoding="utf-8")
    with pytest.raises(SnippetError, match=r"behind\.scenic: spawn/behind-hedge stands in .*behind-hedge\.scenic"):
        load_library(tmp_path)


def test_an_unknown_id_is_refused_with_the_nearest_one() -> None:
    with pytest.raises(SnippetError, match="did you mean 'behavior/cross'"):
        load_library(SMALL).get("behavior/crosss")


def test_a_folder_without_snippets_is_refused(tmp_path: Path) -> None:
    with pytest.raises(SnippetError, match="holds no snippet"):
        load_library(tmp_path)


@pytest.mark.parametrize(
    ("old", "new", "named"),
    [
        ('description = "', 'description = ', "not TOML"),
        ('#: description', '#: descriptoin', "lacks description"),
        ('#: origin = "test"', '#: origin = "test"\n#: colour = "red"', "colour"),
        ('actions = ["cross"]', 'actions = ["fly"]', "slots.actions"),
        ('actions = ["cross"]', 'acts = ["cross"]', "slots has unknown keys acts"),
        ('adversaries = ["pedestrian"', 'adversaries = ["dragon"', "adversaries"),
        ("Range(1.0", "Range(9.0", "line 7: OPT_ADV_SPEED runs from 9 to 4"),
        ("Range(1.0", "Range(ego.speed", "line 7: a parameter has a line of its own"),
        ("4.0)  #:", "4.0), OPT_ADV_X = Range(1, 2)  #:", "line 7: a parameter has a line of its own"),
        ("[m/s]", "[mph]", "line 7: OPT_ADV_SPEED has unit 'mph'"),
        ("#: [m/s] how fast it goes", "", "line 7: OPT_ADV_SPEED lacks its unit and meaning"),
        ("behavior AdvBehavior():", "behavior AdvBehavior():  #: goes", "line 8: what follows '#:' says"),
        ("behavior AdvBehavior():", "behavior AdvBehavior():  #: if fast", "line 8: 'if fast': no row"),
        ('#: origin', '#: requires = ["ego"]\n#: origin', "no requires any more: it is read off the code"),
        ('#: origin', '#: rephrasings = ["It goes."]\n#: origin', "they stand in"),
        ('actions = ["cross"]', 'actions = ["cross"]\n#: [[parameters]]\n#: low = 1.0', "no parameters any more"),
        ("#: description", "# description", "header"),
    ],
)  # fmt: skip
def test_a_fault_in_a_header_names_the_file_and_what_is_wrong(tmp_path: Path, old: str, new: str, named: str) -> None:
    path = broken(tmp_path, old, new)
    with pytest.raises(SnippetError) as error:
        load_library(tmp_path)
    assert str(path) in str(error.value)
    assert named in str(error.value)


def test_a_file_that_is_not_text_is_named(tmp_path: Path) -> None:
    path = tmp_path / "spawn" / "noise.scenic"
    path.parent.mkdir()
    path.write_bytes(b"\xff\xfe\x00")
    with pytest.raises(SnippetError, match="cannot be read"):
        load_library(tmp_path)


@pytest.mark.parametrize("snippet", load_library(SMALL).snippets, ids=[s.id for s in load_library(SMALL)])
def test_what_a_snippet_requires_and_provides_is_what_scenics_parser_finds(snippet: Snippet) -> None:
    found = names_of(snippet.source, WORLD)
    assert found.requires == snippet.requires
    assert found.provides == snippet.provides
    assert found.parameters == {p.name: (p.low, p.high) for p in snippet.parameters}


def test_names_inside_a_behavior_are_its_own() -> None:
    found = names_of("behavior AdvBehavior():\n    speed = limit\n    for n in range(3):\n        wait\n", {"range"})
    assert found.requires == ("limit",)
    assert found.provides == ("AdvBehavior",)


LOST = {  # each a text at which Scenic's parser raises something other than its own error
    "KeyError": "x = (y\n\nz)\n",
    "ValueError": "x@y = 1\n",
}
if sys.version_info < (3, 12):  # from then on Python's own tokenizer refuses what is no text
    LOST["TypeError"] = "f'{' \"r\0ght\"\n"


@pytest.mark.parametrize("error", LOST)
def test_code_in_which_scenics_parser_loses_its_way_is_refused_with_a_remedy(error: str) -> None:
    with pytest.raises(SnippetError, match=rf"parser breaks off with {error}: .*; look for an unclosed bracket"):
        names_of(LOST[error], set())
    with pytest.raises(
        DoesNotCompile, match=rf"breaks off in <lost> with {error}: .*; look .*; chatscene library lint"
    ):
        compile_program(LOST[error], map_path=resolve_map("town"), route=0, filename="<lost>")
    assert check_foreign(LOST[error], whole=False)


def test_code_that_is_not_scenic_is_refused() -> None:
    with pytest.raises(SnippetError, match="line"):
        names_of("behavior :\n", set())


def test_the_packaged_library_covers_every_component_and_kind() -> None:
    library = load_library()
    assert len(library) >= 60
    assert all(library.of(component) for component in Component)
    acted = {kind for snippet in library.of(Component.BEHAVIOR) for kind in snippet.adversaries}
    assert acted == {kind.acts_as for kind in AdversaryKind if not kind.lies}  # what things do is composed
    assert all(not snippet.adversaries for snippet in library.of(Component.GEOMETRY))
