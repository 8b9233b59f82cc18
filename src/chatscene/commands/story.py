"""The command line, continued: what happened in a drive, in words."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import click

import chatscene
from chatscene.commands.options import GENERATOR_AGAIN, JSON, JUDGED, LIBRARY_AGAIN, SEEDS, SIMULATOR_AGAIN, Finite
from chatscene.commands.output import say
from chatscene.errors import SettingsError


@click.command()
@click.argument("what", metavar="WHAT", type=click.Path(path_type=Path))
@click.option("--scene", default=None, metavar="ID", help="A scene of a run.  [default: the first it keeps]")
@click.option("--seed", default=0, show_default=True, type=SEEDS, help="Of a program's values.")
@JUDGED
@click.option("--picture", type=click.Path(path_type=Path), default=None, help="Write a moment from above, as PNG.")
@click.option(
    "--at", type=Finite(0.0), default=None, metavar="SECONDS", help="Which moment.  [default: the nearest one]"
)
@GENERATOR_AGAIN
@SIMULATOR_AGAIN
@LIBRARY_AGAIN
@JSON
def story(what: Path, picture: Path | None, at: float | None, as_json: bool, **options: Any) -> None:
    """Say what happened in a drive of WHAT, in words, with times and speeds. Nothing is judged.

    WHAT is as with verify: a run's folder, a Scenic program (.scenic), a file of OpenSCENARIO (.xosc), a table of
    tracks (.csv), or a trace of ASAM OSI (.mcap). Of a program one drive is made.

    \b
    chatscene story runs/cyclist
    chatscene story theirs.scenic --picture moment.png
    chatscene story drive.csv --json
    """
    from chatscene.files.atomic import write_whole

    if at is not None and picture is None:
        raise click.UsageError("--at needs --picture, which is of that moment")
    told = chatscene.story(what, **options)
    if picture is not None:
        try:
            write_whole(picture, told.picture(at))
        except OSError as error:
            raise SettingsError(f"cannot write {picture}: {error.strerror}") from error
    say(json.dumps(told.as_dict(), indent=1) if as_json else str(told))
