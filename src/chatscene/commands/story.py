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
@click.option("--scene", default=None, metavar="ID", help="A scene of a run.  [default: the first kept scene]")
@click.option("--seed", default=0, show_default=True, type=SEEDS, help="Seed of a program's values.")
@JUDGED
@click.option(
    "--picture",
    type=click.Path(path_type=Path),
    default=None,
    help="Write a picture of one moment, from above, as PNG.",
)
@click.option(
    "--at",
    type=Finite(0.0),
    default=None,
    metavar="SECONDS",
    help="Time of the picture.  [default: when the ego and another road user are closest]",
)
@GENERATOR_AGAIN
@SIMULATOR_AGAIN
@LIBRARY_AGAIN
@JSON
def story(what: Path, picture: Path | None, at: float | None, as_json: bool, **options: Any) -> None:
    """Describe a drive of WHAT in words, with times and speeds. Judges nothing.

    WHAT is a run folder, a Scenic program (.scenic), an OpenSCENARIO file (.xosc), a table of tracks (.csv), or an ASAM
    OSI trace (.mcap), as for verify. A program is driven once.

    \b
    chatscene story runs/cyclist
    chatscene story theirs.scenic --picture moment.png
    chatscene story drive.csv --json
    """
    from chatscene.files.atomic import write_whole

    if at is not None and picture is None:
        raise click.UsageError("--at needs --picture")
    told = chatscene.story(what, **options)
    if picture is not None:
        try:
            write_whole(picture, told.picture(at))
        except OSError as error:
            raise SettingsError(f"cannot write {picture}: {error.strerror}") from error
    say(json.dumps(told.as_dict(), indent=1) if as_json else str(told))
