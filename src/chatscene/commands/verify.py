"""The command line, continued: whether a scene of anybody shows what was said."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Any

import click

import chatscene
from chatscene.commands.options import CHOOSING, GENERATOR_AGAIN, JSON, JUDGED, READING, SEEDS, SIMULATOR_AGAIN, Finite
from chatscene.commands.output import say
from chatscene.commands.refusal import complain, refusing
from chatscene.errors import ChatSceneError, MeansSomethingElse, NothingFits
from chatscene.settings import VerifySettings

NOT_JUDGED = 2  # exit status
_USUAL = VerifySettings()


@click.command()
@click.argument("what", metavar="WHAT", type=click.Path(path_type=Path))
@click.argument("said", metavar="[SAID]", required=False)
@click.option(
    "--draws", default=_USUAL.draws, show_default=True, type=click.IntRange(1, 1_000), help="Number of drives to judge."
)
@click.option("--seed", default=_USUAL.seed, show_default=True, type=SEEDS, help="Seed for the drawn values.")
@click.option(
    "--least",
    default=_USUAL.least,
    show_default=True,
    type=Finite(0.0, 1.0),
    help="The share of the drives reaching a fact that must show it.",
)
@JUDGED
@click.option(
    "--budget",
    default=_USUAL.budget,
    show_default=True,
    type=Finite(0.0, 1e6),
    metavar="SECONDS",
    help="Processor time for scenes that cannot be driven, over all drives.",
)
@click.option("--scene", default=None, metavar="ID", help="A scene of a run.  [default: all kept scenes]")
@click.option(
    "--page", type=click.Path(path_type=Path), default=None, help="Write a page with a picture of each fact's moment."
)
@GENERATOR_AGAIN
@SIMULATOR_AGAIN
@READING
@CHOOSING
@JSON
def verify(what: Path, said: str | None, as_json: bool, **options: Any) -> None:
    """Check from the tracks whether WHAT shows what was SAID, fact by fact.

    WHAT is a Scenic program (.scenic), an OpenSCENARIO file (.xosc), a run folder, a table of tracks (.csv), or an ASAM
    OSI trace (.mcap). SAID is a sentence, or a file with a situation (.yaml, .json) or a report (.txt, .md). For a run
    it may be left out; the run's own text is then used.

    Exit status: 0 everything that could be judged is shown; 1 something is not shown, or something happens that
    SAID does not state; 2 nothing could be judged, or WHAT or SAID cannot be read or driven; 3 the sentence was not
    understood.

    \b
    chatscene verify theirs.scenic "a cyclist crosses from the right"
    chatscene verify theirs.scenic situation.yaml --draws 20 --page verdict.html
    chatscene verify variations.xosc "the car ahead brakes hard" --variant 3
    chatscene verify drive.csv "the car ahead brakes hard" --json
    """
    with refusing(said or "", options["embedder"], as_json):
        try:
            verdict = chatscene.verify(what, said, **options)
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
