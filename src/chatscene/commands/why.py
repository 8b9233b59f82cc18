"""The command line, continued: why a scene crashed."""

from __future__ import annotations

import json
from pathlib import Path

import click

from chatscene.commands.library import EGO_AGAIN, GENERATOR_AGAIN, JSON, LIBRARY_AGAIN, SIMULATOR_AGAIN, say


@click.command()
@click.argument("folder", metavar="DIR", type=click.Path(path_type=Path))
@click.argument("scene_id")
@EGO_AGAIN
@GENERATOR_AGAIN
@SIMULATOR_AGAIN
@LIBRARY_AGAIN
@JSON
def why(
    folder: Path,
    scene_id: str,
    ego: tuple[str, ...],
    generator: tuple[str, ...],
    simulator: tuple[str, ...],
    library: tuple[str, ...],
    as_json: bool,
) -> None:
    """Say why a scene of a run crashed: who struck whom, what it took, and how the ego avoids it.

    The scene is driven again and again: without things, with parameters set back to those of the nearest scene without
    a crash, with an ego that brakes earlier or goes slower. Takes seconds.

    \b
    chatscene why runs/cyclist cyclist-1f2e/route-00/scene-017
    """
    from chatscene import api

    found = api.why(folder, scene_id, ego=ego, generator=generator, simulator=simulator, library=library)
    say(json.dumps(found.as_dict()) if as_json else found.in_words())
