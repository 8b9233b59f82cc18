"""The command line, continued: a skill for agents, which teaches them to make scenes and to judge them."""

from __future__ import annotations

from collections.abc import Iterator
from importlib.resources import files
from importlib.resources.abc import Traversable
from pathlib import Path

import click

from chatscene.commands.output import say
from chatscene.errors import SettingsError
from chatscene.files.atomic import write_whole

NAME = "chatscene"


@click.command()
@click.argument("folder", metavar="DIR", type=click.Path(path_type=Path, file_okay=False))
@click.option("--replace", is_flag=True, help="Replace the files of an earlier version.")
def skill(folder: Path, replace: bool) -> None:
    """Install the skill for agents into DIR, where an agent looks for skills.

    It teaches an agent the loop: write a situation, build, verify, read the story, fix, keep, test.

    \b
    chatscene skill .claude/skills
    chatscene skill .claude/skills --replace
    """
    where = folder / NAME
    parts = dict(_parts(files("chatscene") / "skills" / NAME))
    there = [path for path in parts if (where / path).exists()]
    if there and not replace:
        raise SettingsError(f"{where / there[0]} is there already; use --replace to overwrite it")
    for path, content in parts.items():
        try:
            (where / path).parent.mkdir(parents=True, exist_ok=True)
            write_whole(where / path, content)
        except OSError as error:
            raise SettingsError(f"cannot write {where / path}: {error.strerror}") from error
        say(str(where / path))


def _parts(folder: Traversable, above: str = "") -> Iterator[tuple[str, bytes]]:
    """The files of a folder of the package, by their paths in it."""
    for one in sorted(folder.iterdir(), key=lambda part: part.name):
        if one.is_dir():
            yield from _parts(one, f"{above}{one.name}/")
        else:
            yield f"{above}{one.name}", one.read_bytes()
