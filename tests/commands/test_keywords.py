"""A keyword of a function is an option of its command, written out or not."""

from __future__ import annotations

from typing import Any

import click
import pytest
from click.testing import CliRunner

import chatscene
from chatscene.commands import main as commands
from chatscene.commands.main import add_keywords


def exports(folder: Any, scenes: Any = (), *, to: str, only_crashes: bool = False, most: int = 3) -> str:
    """Write scenes.

    Args:
        folder: A run.
        scenes: Ids.
        to: A format.
        only_crashes: Leave out scenes
            without a collision.
        most: The most scenes that are written.
    """
    return f"{folder} {to} {only_crashes} {most}"


def test_a_keyword_and_its_line_are_an_option_and_its_help() -> None:
    @click.command()
    @click.argument("folder")
    @click.option("--to")
    def command(folder: str, **options: Any) -> None:
        click.echo(exports(folder, **options))

    add_keywords(command, exports)
    add_keywords(command, exports)
    told = " ".join(CliRunner().invoke(command, ["--help"]).output.split())
    assert told.count("--only-crashes Leave out scenes without a collision.") == 1
    assert "The most scenes that are written. [default: 3]" in told
    done = CliRunner().invoke(command, ["r", "--to", "csv", "--only-crashes", "--most", "4"])
    assert done.output == "r csv True 4\n"


def test_a_command_is_asked_for_with_the_keywords_of_its_function(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[tuple[click.Command, Any]] = []

    def ask(command: click.Command, function: Any) -> None:
        asked.append((command, function))

    monkeypatch.setattr(commands, "add_keywords", ask)
    CliRunner().invoke(commands.main, ["export", "--help"])
    assert asked == [(commands.main.commands["export"], chatscene.export)]


@pytest.mark.parametrize(
    ("kind", "line", "lacks"), [("int", "", "no line in the docstring"), ("Names", "x: y", "below")]
)
def test_a_keyword_that_does_not_say_what_its_option_is_is_refused_by_name(kind: str, line: str, lacks: str) -> None:
    def does(*, x: Any = None) -> None: ...

    does.__annotations__["x"], does.__doc__ = kind, f"Does.\n\n    Args:\n        {line}\n    "
    with pytest.raises(TypeError, match=f"does: x .*{lacks}"):
        add_keywords(click.Command("does"), does)
