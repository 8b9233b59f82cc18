"""The blocks of a page that stand for something to do: commands to say in a shell, and files to write before.

A comment above a block says what is not to be seen from it: `<!-- not run: REASON -->`, `<!-- file: NAME -->`.
"""

from __future__ import annotations

import re
import shlex
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import click

from chatscene.commands.main import main
from chatscene.errors import MapError

_BLOCK = re.compile(r"(?:^<!-- (not run|file): (.*?) -->\n)?^```(\w+)\n(.*?)^```$", re.DOTALL | re.MULTILINE)
_SHELLS = ("console", "bash")


@dataclass(frozen=True)
class Step:
    """A command of a page.

    Attributes:
        command: As it is said in a shell.
        status: The status it should end with.
        said: The lines that the page shows below it.
        not_run: Why it is not run; empty if it is.
    """

    command: str
    status: int
    said: tuple[str, ...]
    not_run: str


@dataclass(frozen=True)
class Written:
    """A file that a page has whoever follows it write."""

    name: str
    content: str


def steps_of(page: Path) -> list[Step | Written]:
    """What a page has its reader do, in order."""
    found: list[Step | Written] = []
    for mark, told, language, content in _BLOCK.findall(page.read_text(encoding="utf-8")):
        if mark == "file":
            found.append(Written(told, content))
        elif language in _SHELLS:
            found += _commands(content, told, prompted=language == "console")
    return found


def _commands(content: str, not_run: str, *, prompted: bool) -> list[Step]:
    lines = [line for line in content.splitlines() if line.strip() and (prompted or not line.startswith("#"))]
    said_at = [at for at, line in enumerate(lines) if line.startswith("$ ") or not prompted]
    found: list[Step] = []
    for at, after in zip(said_at, [*said_at[1:], len(lines)], strict=True):
        command, _, comment = lines[at].removeprefix("$ ").partition("  #")
        status = re.search(r"status (\d)", comment)
        said = tuple(line for line in lines[at + 1 : after] if line.strip() != "…")
        found.append(Step(command.strip(), int(status[1]) if status else 0, said, not_run))
    return found


def check_options(command: str) -> None:
    """Let the command line read a command that is not run.

    Raises:
        click.UsageError: There is no such command or option, or an argument is missing or none.
    """
    name, *words = shlex.split(command.rstrip("& "))
    assert name == "chatscene"
    found: click.Command | None = main
    context = click.Context(main, info_name=name)
    while isinstance(found, click.Group):
        verb, *words = words
        found = found.get_command(context, verb)
        if found is None:
            raise click.UsageError(f"no command {verb!r}")
        if not isinstance(found, click.Group):
            try:
                with suppress(MapError):  # its map is one of whoever follows the page
                    found.make_context(verb, words, parent=context)
            except click.BadParameter as error:
                if "does not exist" not in error.message:  # a file of whoever follows the page
                    raise
