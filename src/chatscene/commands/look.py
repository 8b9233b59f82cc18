"""The command line, continued: scenes of a run simulated again, why they crashed, and whether folders are whole."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import click

import chatscene
from chatscene.commands.options import DRIVEN_AGAIN, JSON
from chatscene.commands.output import say
from chatscene.errors import RunError


@click.command()
@click.argument("folder", metavar="DIR", type=click.Path(path_type=Path))
@click.argument("scene_id", required=False)
@DRIVEN_AGAIN
@click.option("--watch", is_flag=True, help="Keep a CARLA server's spectator above the ego.")
@click.option("--record", is_flag=True, help="Let a CARLA server's recorder write a file to DIR/recordings.")
@JSON
def replay(folder: Path, scene_id: str | None, as_json: bool, **options: Any) -> None:
    """Simulate one scene of a run again from its stored values, and check whether the tracks are identical.

    Without SCENE_ID, the first scene of the report is taken. A CARLA server does not repeat itself exactly, so there
    the tracks may differ by half a metre.

    \b
    chatscene replay runs/cyclist cyclist-1f2e/route-00/scene-017
    chatscene replay runs/brakes brakes-8c1f/route-00/scene-004 --simulator carla --watch --record
    """
    outcome = chatscene.replay(folder, scene_id, **options)
    say(json.dumps(outcome.as_dict()) if as_json else outcome.in_words())
    if not outcome.identical:
        sys.exit(1)


@click.command()
@click.argument("folder", metavar="DIR", type=click.Path(path_type=Path))
@click.argument("scene_id", required=False)
@DRIVEN_AGAIN
@JSON
def why(folder: Path, scene_id: str | None, as_json: bool, **again: Any) -> None:
    """Explain why a scene of a run crashed: who struck whom, what the crash depends on, and what avoids it.

    Without SCENE_ID, the first scene of the report is taken.

    The scene is driven again many times: without one of the other road users, with parameters from the nearest
    scene without a crash, and with an ego that brakes earlier or drives slower. This takes seconds.

    \b
    chatscene why runs/cyclist
    chatscene why runs/cyclist cyclist-1f2e/route-00/scene-017
    """
    found = chatscene.why(folder, scene_id, **again)
    say(json.dumps(found.as_dict()) if as_json else found.in_words())


@click.command()
@click.argument("folders", metavar="DIR...", nargs=-1, required=True, type=click.Path(path_type=Path))
@JSON
def check(folders: tuple[Path, ...], as_json: bool) -> None:
    """List the damaged, missing and added files of the folders DIR....

    DIR is a folder that run, evaluate, benchmark, reproduce, finetune or train wrote. Folders in it are checked as
    well.

    Every file of a finished folder is compared with its digest in run.json, and run.json with its own. Exit status 0:
    everything is there and unchanged; 1: something is not, or cannot be checked.

    \b
    chatscene check runs/cyclist
    chatscene check runs/* --json
    """
    from chatscene import runs

    found: list[runs.Condition] = []
    for folder in folders:
        try:
            found.append(runs.check(folder))
        except RunError as error:
            if len(folders) == 1:
                raise
            # The others are checked all the same.
            found.append(runs.Condition(folder=folder, damaged={}, unknown=str(error)))
    if as_json:
        say(json.dumps([condition.as_dict() for condition in found], indent=1))
    else:
        for condition in found:
            say(condition.in_words())
    if not all(condition.whole for condition in found):
        sys.exit(1)
