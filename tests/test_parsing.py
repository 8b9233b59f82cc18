"""Scenic's parser with a quicker memory gives what it gives by itself."""

from __future__ import annotations

import ast
import importlib
import sys
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import scenic

from chatscene.parsing import parse_string
from places import ROOT, TESTS

FRESH = ("pegen.parser", "pegen.tokenizer", "scenic.syntax.parser")
PROGRAMS = [
    *sorted((TESTS / "golden").glob("*.scenic")),
    *sorted((ROOT / "src" / "chatscene").glob("world/*.scenic")),
    Path(scenic.__file__).parent / "domains" / "driving" / "model.scenic",
]
FAULTY = (
    "ego = new Car at",
    "ego = (1, 2",
    "x = 1\n  y = 2",
    "do Wait( for 3 seconds",
    "new Car on on road",
    "é = 'a",
    "",
)


@pytest.fixture(scope="module")
def by_itself() -> Iterator[Callable[[str], Any]]:
    """Scenic's parser as nobody has changed it."""
    with pytest.MonkeyPatch.context() as patch:
        for name in FRESH:
            patch.delitem(sys.modules, name)
        parser: Any = importlib.import_module("scenic.syntax.parser")
        yield lambda source: parser.parse_string(source, "exec")


def told(parse: Callable[[str], Any], source: str) -> str:
    """The tree of a text with its places, or how it fails."""
    try:
        return ast.dump(parse(source), include_attributes=True)
    except Exception as error:  # noqa: BLE001 - a parser that loses its way may raise anything
        return f"{type(error).__name__} {error} {vars(error)}"


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda path: path.name)
def test_a_program_has_the_same_tree(path: Path, by_itself: Callable[[str], Any]) -> None:
    source = path.read_text(encoding="utf-8")
    assert told(parse_string, source) == told(by_itself, source)


@pytest.mark.parametrize("source", FAULTY)
def test_a_faulty_text_is_refused_in_the_same_words(source: str, by_itself: Callable[[str], Any]) -> None:
    assert told(parse_string, source) == told(by_itself, source)
