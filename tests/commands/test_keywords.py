"""A keyword of a function is an option of its command, written out or not."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import click
import pytest
from click.testing import CliRunner

import chatscene
from chatscene.commands import main as commands
from chatscene.commands.keywords import add_keywords


def exports(
    folder: Any, scenes: Any = (), *, to: str, out: Any = None, only_crashes: bool = False, most: int = 3
) -> str:
    """Write scenes.

    Args:
        folder: A run.
        scenes: Ids.
        to: A format.
        out: A folder.
        only_crashes: Leave out scenes
            without a collision.
        most: The most scenes that are written.
    """
    return f"{folder} {to} {only_crashes} {most}"


def test_a_keyword_and_its_line_are_an_option_and_its_help(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(chatscene, "export", exports)
    before = list(commands.main.commands["export"].params)
    monkeypatch.setattr(commands.main.commands["export"], "params", before)
    told = " ".join(CliRunner().invoke(commands.main, ["export", "--help"]).output.split())
    assert "--only-crashes Leave out scenes without a collision." in told
    assert "[default: 3]" in told
    done = CliRunner().invoke(
        commands.main, ["export", "r", "--to", "csv", "--out", "o", "--only-crashes", "--most", "4"]
    )
    assert done.output == f"{Path('r')} csv True 4\n"


@pytest.mark.parametrize(
    ("kind", "line", "lacks"), [("int", "", "no line in the docstring"), ("Names", "x: y", "below")]
)
def test_a_keyword_that_does_not_say_what_its_option_is_is_refused_by_name(kind: str, line: str, lacks: str) -> None:
    def does(*, x: Any = None) -> None: ...

    does.__annotations__["x"], does.__doc__ = kind, f"Does.\n\n    Args:\n        {line}\n    "
    with pytest.raises(TypeError, match=f"does: x .*{lacks}"):
        add_keywords(click.Command("does"), does)
