"""The command line, continued: what happened in a drive, in words."""

from __future__ import annotations

import json
from pathlib import Path

import click

from chatscene.commands.library import JSON, PARAM, VARIANT, say
from chatscene.errors import SettingsError


@click.command()
@click.argument("what", metavar="WHAT", type=click.Path(path_type=Path))
@click.option("--scene", "scene_id", default="", metavar="ID", help="A scene of a run.  [default: the first it keeps]")
@click.option("--seed", default=0, show_default=True, type=click.IntRange(min=0), help="Of a program's values.")
@click.option("--ego", default="", help="Who drives a program.  [default: its own ego; planner where it has none]")
@click.option("--map", "map_name", default="", help="The map of a program that names none: a packaged one, or a file.")
@click.option("--trust", is_flag=True, help="Run the program with all of Python, outside the sandbox.")
@click.option("--ego-id", default="", metavar="ID", help="Whose track of a recording is the ego's, if none is marked.")
@PARAM
@VARIANT
@click.option("--picture", type=click.Path(path_type=Path), default=None, help="Write a moment from above, as PNG.")
@click.option("--at", type=float, default=None, metavar="SECONDS", help="Which moment.  [default: the nearest one]")
@JSON
def story(
    what: Path,
    scene_id: str,
    seed: int,
    ego: str,
    map_name: str,
    trust: bool,
    ego_id: str,
    param: dict[str, object],
    variant: int,
    picture: Path | None,
    at: float | None,
    as_json: bool,
) -> None:
    """Say what happened in a drive of WHAT, in words, with times and speeds. Nothing is judged.

    WHAT is as with verify: a run's folder, a Scenic program (.scenic), a file of OpenSCENARIO (.xosc), a table of
    tracks (.csv), or a trace of ASAM OSI (.mcap). Of a program one drive is made.

    \b
    chatscene story runs/cyclist
    chatscene story theirs.scenic --picture moment.png
    chatscene story drive.csv --json
    """
    from chatscene import api
    from chatscene.files.atomic import write_whole

    if at is not None and picture is None:
        raise click.UsageError("--at needs --picture, which is of that moment")
    told = api.story(
        what,
        scene=scene_id or None,
        seed=seed,
        ego=ego or None,
        map=map_name or None,
        trust=trust,
        ego_id=ego_id or None,
        param=param or None,
        variant=variant or None,
    )
    if picture is not None:
        try:
            write_whole(picture, told.picture(at))
        except OSError as error:
            raise SettingsError(f"cannot write {picture}: {error.strerror}") from error
    say(json.dumps(told.as_dict(), indent=1) if as_json else str(told))
