"""Code of the library is kept between processes, and is that of its text."""

from __future__ import annotations

import ast
import importlib
import sys
from pathlib import Path
from typing import Any

import pytest

from chatscene.errors import DoesNotCompile, StuckBehavior
from chatscene.library.load import load_library
from chatscene.maps.network import resolve_map
from chatscene.terms.scenario import Component

compilation: Any = importlib.import_module("chatscene.world.compilation")

TEXT = "behavior Waits():\n    wait\nparam STEPS = 3\n"


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Where code is kept, nothing yet."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return tmp_path / "chatscene" / "code"


@pytest.fixture
def parsed(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The texts that were parsed."""
    texts: list[str] = []
    parse = compilation.translator.parse_string

    def noted(text: str, *arguments: Any, **named: Any) -> Any:
        texts.append(text)
        return parse(text, *arguments, **named)

    monkeypatch.setattr(compilation.translator, "parse_string", noted)
    return texts


def test_a_text_is_parsed_once_and_its_code_is_the_same_afterwards(folder: Path, parsed: list[str]) -> None:
    first, again = (compilation._kept(TEXT, "/library/waits.scenic") for _ in range(2))
    assert again == first == compilation._translate(TEXT, "/library/waits.scenic")
    assert again[0].co_filename == "/library/waits.scenic"
    assert parsed == [TEXT, TEXT]
    (kept,) = folder.iterdir()
    assert kept.stat().st_mode & 0o077 == 0


def test_another_text_or_place_has_code_of_its_own(folder: Path) -> None:
    for text, place in ((TEXT, "one"), (TEXT, "other"), (TEXT + "\n", "one")):
        compilation._kept(text, place)
    assert len(list(folder.iterdir())) == 3


def test_what_is_damaged_is_not_run_but_parsed_again(folder: Path, parsed: list[str]) -> None:
    first = compilation._kept(TEXT, "place")
    (kept,) = folder.iterdir()
    whole = kept.read_bytes()
    for damaged in (whole[:-1], whole[:40] + b"?" + whole[41:], b""):
        kept.write_bytes(damaged)
        for _ in range(2):
            assert compilation._kept(TEXT, "place") == first
    assert len(parsed) == 4


def test_code_is_taken_from_no_folder_that_others_can_write_to(folder: Path, parsed: list[str]) -> None:
    compilation._kept(TEXT, "place")
    folder.chmod(0o777)
    compilation._kept(TEXT, "place")
    assert parsed == [TEXT, TEXT]


def test_code_with_requirements_is_not_kept(folder: Path) -> None:
    compilation._kept("require True\n", "place")
    assert not folder.exists() or not list(folder.iterdir())


def test_a_program_is_parsed_in_parts_to_the_same_tree_with_the_same_lines(parsed: list[str]) -> None:
    library, text = load_library(), ""
    for parts in zip(*(library.of(component)[:12] for component in Component), strict=True):
        text = "# A text\n\n" + "\n\n".join(f"## {part.id}\n{part.source}" for part in parts)
        for _ in range(2):
            found = compilation._parsed(text, "place")
            whole = compilation.translator.parse_string(text, "exec", filename="place")
            assert ast.dump(found, include_attributes=True) == ast.dump(whole, include_attributes=True)
    parsed.clear()
    compilation._parsed(text, "place")
    assert not parsed


@pytest.mark.parametrize(
    "text",
    [
        'param word = """\n## no part\n"""\n',
        "param numbers = (1,\n## of two\n2)\n",
        "if True:\n    x = 1\n## else\nelse:\n    x = 2\n",
        "behavior Waits():\n    wait\n## twice\n    wait\n",
    ],
)
def test_what_only_looks_like_a_part_is_parsed_with_the_whole(text: str) -> None:
    whole = compilation.translator.parse_string(text, "exec", filename="place")
    assert ast.dump(compilation._parsed(text, "place"), include_attributes=True) == ast.dump(
        whole, include_attributes=True
    )


def test_a_fault_in_a_part_is_told_with_its_line_in_the_program() -> None:
    text = "model chatscene.world.model\n\n## one\nx = 1\n\n## two\ny = = 1\n"
    with pytest.raises(DoesNotCompile, match="line 7 of"):
        compilation.compile_program(text, map_path=resolve_map("town"), route=0)


def test_a_parser_whose_time_is_up_does_not_begin_again(monkeypatch: pytest.MonkeyPatch) -> None:
    begun: list[str] = []

    def stuck(text: str, *_: Any, **_named: Any) -> Any:
        begun.append(text)
        raise StuckBehavior("its time is up")

    monkeypatch.setattr(compilation.translator, "parse_string", stuck)
    with pytest.raises(StuckBehavior):
        compilation._parsed("x = 1\n\n## never parsed before\ny = 2\n", "place")
    assert len(begun) == 1


def test_nothing_is_imported_from_the_working_folder_while_a_program_is_compiled(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    paths: list[list[str]] = []
    stream = compilation._compile_stream

    def noted(*arguments: Any) -> Any:
        paths.append(list(sys.path))
        return stream(*arguments)

    monkeypatch.setattr(compilation, "_compile_stream", noted)
    program = (
        'model chatscene.world.model\negoRoute = selectRoute(maneuver="straight")\n'
        "ego = new Car at startOf(egoRoute), with route egoRoute\n"
    )
    compilation.compile_program(program, map_path=resolve_map("town"), route=0)
    assert paths
    assert not [path for one in paths for path in one if path in ("", ".", str(tmp_path))]


CROSSES = """param weather = '{weather}'
model chatscene.world.model
param OPT_{name} = Range(2, 3)
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), with route egoRoute
AdvAgent = new {kind} at pointOn(egoRoute, 10 + globalParameters.OPT_{name}), facing directionOn(egoRoute, 10)
"""


def _placed(text: str, **named: Any) -> tuple[Any, Any]:
    scenario = compilation.compile_program(text, map_path=resolve_map("town"), **named)
    scenario.conditionOn(params={name: 2.5 for name in scenario.params if name.startswith("OPT_")})
    return scenario, scenario.generate(maxIterations=1)[0]


@pytest.mark.parametrize(("weather", "kind", "route"), [("clear", "Pedestrian", 1), ("rain", "Truck", 0)])
def test_a_program_after_another_has_its_world_model_and_is_as_one_that_has_its_own(
    weather: str, kind: str, route: int
) -> None:
    _placed(CROSSES.format(weather="clear", name="BEFORE", kind="Bus"), route=0)
    text = CROSSES.format(weather=weather, name="AFTER", kind=kind)
    _, first = _placed(text, route=route)
    scenario, shared = _placed(text, route=route)
    alone, own = _placed(text, route=route, own=True)
    assert type(first.egoObject) is type(shared.egoObject) is not type(own.egoObject)
    assert scenario.params.keys() == alone.params.keys()
    assert shared.params == own.params
    assert [(one.position, one.heading, one.length, type(one).__name__) for one in shared.objects] == [
        (one.position, one.heading, one.length, type(one).__name__) for one in own.objects
    ]
    assert scenario.behaviorNamespaces.keys() == alone.behaviorNamespaces.keys()
    assert "chatscene.world.model" not in sys.modules


def test_a_program_of_another_map_or_that_says_other_things_before_its_model_has_another_one() -> None:
    text = CROSSES.format(weather="clear", name="X", kind="Car")
    kinds = {type(_placed(one, route=0)[1].egoObject) for one in (text, text, text.replace("clear", "fog"))}
    assert len(kinds) == 2
    elsewhere = compilation.compile_program(text, map_path=resolve_map("outskirts"), route=0)
    assert type(elsewhere.egoObject) not in kinds
