from __future__ import annotations

import sys
from pathlib import Path

import pytest

from chatscene.errors import DoesNotCompile, SnippetError
from chatscene.maps.network import resolve_map
from chatscene.sandbox.allow_list import check_foreign
from chatscene.snippets.library import load_library, load_snippet, names_of
from chatscene.terms.scenario import Action, AdversaryKind, Component, Place
from chatscene.terms.snippet import Snippet
from chatscene.world.compilation import compile_program

SMALL = Path(__file__).parent / "fixtures" / "library"
GOOD = (SMALL / "behavior" / "cross.scenic").read_text(encoding="utf-8")
NAMES = """
    selectRoute startOf trafficFrom wayOf besideRoad pointOn headway MoveAhead DrivePath Range globalParameters self
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
        ('#: unit', '#: units', "parameters.0 has unknown keys units"),
        ('adversaries = ["pedestrian"', 'adversaries = ["dragon"', "adversaries"),
        ('#:   "He crosses without stopping.",\n', "", "at least 5 rephrasings"),
        ("He crosses without stopping.", "A PERSON goes to the other side.", "each different"),
        ("low = 1.0", "low = 9.0", "runs from 9 to 4"),
        ("low = 1.0", 'low = "one"', "parameters.0.low"),
        ('unit = "m/s"', 'unit = "mph"', "unit 'mph'"),
        ('name = "OPT_ADV_SPEED"', 'name = "ADV_SPEED"', "must start with OPT_"),
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
def test_the_contract_in_a_header_is_the_one_the_code_keeps(snippet: Snippet) -> None:
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
    assert acted == set(AdversaryKind)
    assert all(not snippet.adversaries for snippet in library.of(Component.GEOMETRY))
