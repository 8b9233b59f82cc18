"""The command line, continued: why a scene crashed."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Unpack

import click

from chatscene.commands.library import DRIVEN_AGAIN, JSON, DrivenAgain, say


@click.command()
@click.argument("folder", metavar="DIR", type=click.Path(path_type=Path))
@click.argument("scene_id", required=False)
@DRIVEN_AGAIN
@JSON
def why(folder: Path, scene_id: str | None, as_json: bool, **again: Unpack[DrivenAgain]) -> None:
    """Say why a scene of a run crashed: who struck whom, what it took, and how the ego avoids it.

    Without SCENE_ID it is the first scene that the report shows.

    The scene is driven again and again: without things, with parameters set back to those of the nearest scene without
    a crash, with an ego that brakes earlier or goes slower. Takes seconds.

    \b
    chatscene why runs/cyclist
    chatscene why runs/cyclist cyclist-1f2e/route-00/scene-017
    """
    from chatscene import api

    found = api.why(folder, scene_id, **again)
    say(json.dumps(found.as_dict()) if as_json else found.in_words())
