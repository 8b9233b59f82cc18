"""Files of situations in the place of a TEXT, and their schema."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import click

import chatscene
from chatscene.commands.output import console, say
from chatscene.errors import SettingsError
from chatscene.files.bounded import is_there

if TYPE_CHECKING:
    from chatscene.report.stated import Stated
    from chatscene.report.understood import Understood
    from chatscene.terms.situation import Situation

SUFFIXES = (".yaml", ".yml", ".json")


def situation_file(text: str) -> Situation | None:
    """The situation in the file that a TEXT names; None for a sentence.

    Raises:
        SituationError: It cannot be read, or is none.
        SettingsError: It is a file of another kind.
    """
    there = is_there(Path(text))
    if text.lower().endswith(SUFFIXES) and (there or " " not in text):
        return chatscene.read_situation(text)
    if there:
        raise SettingsError(
            f"{text!r} is a file, but not of a situation (.yaml, .json); give a report with --report, and a program "
            "with --program"
        )
    return None


def say_understood(understood: Stated | Understood, *, program: bool) -> None:
    """Say what becomes of a text, and its program if that is asked for."""
    from chatscene.report.stated import Stated
    from chatscene.report.terminal import print_understanding

    if not isinstance(understood, Stated):
        print_understanding(console(), understood, show_program=program)
        return
    for one in understood.unseen if program else ():
        say(one)
    say(str(understood))
    if program:
        say("\n".join((*understood.shifted, understood.program.source)))


@click.command()
def schema() -> None:
    """Print the JSON schema of situations: what a file or a language model may say, and what each word means.

    \b
    chatscene schema > situation.schema.json
    """
    from chatscene.situations.form import schema as made

    say(json.dumps(made(), indent=1, ensure_ascii=False))
