"""Files of situations in the place of a TEXT, and their schema."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING

import click

from chatscene.commands.output import console, say

if TYPE_CHECKING:
    from chatscene.report.stated import Stated
    from chatscene.report.understood import Understood


def say_understood(understood: Stated | Understood, *, program: bool) -> None:
    """Say what becomes of a text, and its program if that is asked for."""
    from chatscene.report.stated import Stated
    from chatscene.report.terminal import print_understanding

    if not isinstance(understood, Stated):
        print_understanding(console(), understood, show_program=program)
        return
    understood = understood.as_shown if program else understood
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
