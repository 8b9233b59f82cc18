"""The command line, continued: whether a scene of anybody shows what was said."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Unpack

import click

from chatscene.commands.library import CHOOSING, JSON, PARAM, READING, VARIANT, Chosen, say
from chatscene.commands.refusal import complain, refusing
from chatscene.errors import ChatSceneError, MeansSomethingElse, NothingFits
from chatscene.settings import VerifySettings

NOT_JUDGED = 2  # exit status
_USUAL = VerifySettings()


@click.command()
@click.argument("what", metavar="WHAT", type=click.Path(path_type=Path))
@click.argument("said", metavar="[SAID]", required=False)
@click.option(
    "--draws", default=_USUAL.draws, show_default=True, type=click.IntRange(1, 1_000), help="Drives that are judged."
)
@click.option("--seed", default=_USUAL.seed, show_default=True, type=click.IntRange(min=0), help="Of their values.")
@click.option(
    "--least",
    default=_USUAL.least,
    show_default=True,
    type=click.FloatRange(0.0, 1.0),
    help="The share of the drives that must show a fact, of those that came to it.",
)
@click.option("--ego", default="", help="Who drives a program.  [default: its own ego; planner where it has none]")
@click.option("--map", "map_name", default="", help="The map of a program that names none: a packaged one, or a file.")
@click.option("--trust", is_flag=True, help="Run the program with all of Python, outside the sandbox.")
@click.option("--ego-id", default="", metavar="ID", help="Whose track of a recording is the ego's, if none is marked.")
@PARAM
@VARIANT
@click.option(
    "--budget",
    default=_USUAL.budget,
    show_default=True,
    metavar="SECONDS",
    help="Processor time for scenes that cannot be placed, over all drives; then no more are tried.",
)
@click.option("--scene", "scene_id", default="", metavar="ID", help="A scene of a run.  [default: those it keeps]")
@click.option(
    "--page", type=click.Path(path_type=Path), default=None, help="Write a page with the moment of each fact."
)
@READING
@CHOOSING
@JSON
def verify(
    what: Path,
    said: str | None,
    draws: int,
    seed: int,
    least: float,
    ego: str,
    map_name: str,
    trust: bool,
    ego_id: str,
    param: dict[str, object],
    variant: int,
    budget: float,
    scene_id: str,
    page: Path | None,
    as_json: bool,
    **reading: Unpack[Chosen],
) -> None:
    """Say whether WHAT shows what was SAID, fact by fact, from its tracks.

    WHAT is a Scenic program (.scenic), a file of OpenSCENARIO (.xosc), a run's folder, a table of tracks (.csv), or
    a trace of ASAM OSI (.mcap). SAID is a sentence, or a file: a situation (.yaml, .json), or a report (.txt, .md). Of
    a run it may be left out: it is then what the run was made of.

    Exit status: 0 all that could be judged is shown; 1 something is not, or happens unasked; 2 nothing could be
    judged, or WHAT or SAID cannot be read or driven; 3 the sentence was not understood.

    \b
    chatscene verify theirs.scenic "a cyclist crosses from the right"
    chatscene verify theirs.scenic situation.yaml --draws 20 --page verdict.html
    chatscene verify variations.xosc "the car ahead brakes hard" --variant 3
    chatscene verify drive.csv "the car ahead brakes hard" --json
    """
    from chatscene import api

    with refusing(said or "", reading["embedder"], as_json):
        try:
            verdict = api.verify(
                what,
                said,
                draws=draws,
                seed=seed,
                least=least,
                ego=ego or None,
                map=map_name or None,
                trust=trust,
                ego_id=ego_id or None,
                scene=scene_id or None,
                param=param or None,
                variant=variant or None,
                budget=budget,
                page=page,
                **reading,
            )
        except (NothingFits, MeansSomethingElse):
            raise
        except ChatSceneError as error:
            if as_json:
                say(
                    json.dumps(
                        {"what": str(what), "status": NOT_JUDGED, "error": type(error).__name__, "message": str(error)}
                    )
                )
            else:
                complain(error)
            sys.exit(NOT_JUDGED)
    say(json.dumps(verdict.as_dict(), indent=1) if as_json else str(verdict))
    sys.exit(verdict.status)
