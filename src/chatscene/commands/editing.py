"""The command line, continued: situations that are changed in words, one edit at a time."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack

import click

import chatscene
from chatscene.commands.options import AGAIN, EGO_OPTION, JSON, MANY, MAP_WITH_SITE, READING, SEED, WORKERS, Reading
from chatscene.commands.output import progress, say
from chatscene.commands.situations import say_understood
from chatscene.errors import ChatSceneError, NothingFits

if TYPE_CHECKING:
    from chatscene.api.results import Run
    from chatscene.report.stated import Changed
    from chatscene.talk import Shown, Undone


@click.command()
@click.argument("folder", metavar="RUN", type=click.Path(path_type=Path))
@click.argument("text", metavar="EDIT", required=False)
@click.option("--undo", is_flag=True, help="Print the run from which RUN was edited.")
@click.option("--dry-run", is_flag=True, help="Only show the difference.")
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    default=None,
    help="Folder of the new run; default: a new one beside RUN.",
)
@WORKERS
@AGAIN
@JSON
def edit(
    folder: Path,
    text: str | None,
    undo: bool,
    dry_run: bool,
    out: Path | None,
    jobs: int,
    executor: str,
    as_json: bool,
    **again: Any,
) -> None:
    """Apply EDIT to the situation of RUN, show the difference, and run the new situation with the same settings.

    RUN is the folder of a finished run of a sentence or a situation. It does not change; the new run's run.json names
    it.

    \b
    chatscene edit runs/cyclist "make it a truck, from the right, and slower"
    chatscene edit runs/cyclist "hidden by a hedge" --dry-run
    chatscene edit runs/hidden-by-a-hedge --undo
    """
    if undo == (text is not None):
        raise click.UsageError("give an EDIT, or --undo")
    run = chatscene.Run(folder, **again)
    if text is None:
        say(json.dumps({"folder": str(run.edited_from.folder)}) if as_json else str(run.edited_from.folder))
        return
    edited = run.understood.edit(text)
    if not as_json:
        say(str(edited))
    done = None if dry_run else run.edit(text, out, jobs=jobs, executor=executor, progress=progress())
    if as_json:
        say(json.dumps({**edited.as_dict(), "folder": str(done.folder) if done else None}, indent=1))
    elif done:
        say(str(done))


@click.command()
@MAP_WITH_SITE
@EGO_OPTION
@click.option("--scenes", default=50, show_default=True, type=MANY, help="Simulations per run.")
@SEED
@READING
def chat(
    map: str | None,  # noqa: A002 - the name of the option
    ego: str,
    scenes: int,
    seed: int,
    **reading: Unpack[Reading],
) -> None:
    """Work on a situation line by line: the first line describes it, each further line changes it.

    Lines come from the keyboard or a pipe. Besides edits, a line may be: show (the situation and its facts), undo (the
    last edit), reading N (one of the offered readings), set FACT=VALUE, run [DIR] (search for scenes), new TEXT
    (another situation), or quit. A refused line changes nothing.

    \b
    chatscene chat
    printf 'the car ahead brakes hard\\nmake it a truck\\nat night\\nrun runs/truck\\n' | chatscene chat
    """
    from chatscene.ego.policy import load_ego
    from chatscene.interpret.readers import reader_of
    from chatscene.report.terminal import readings_in_words
    from chatscene.settings import RetrievalSettings
    from chatscene.talk import Talk

    load_ego(ego)  # what is not there is told at once, and not at the first line that needs it
    reader_of(RetrievalSettings(**reading))
    talk = Talk(reading, {"map": map, "ego": ego, "scenes": scenes, "seed": seed}, Path("runs"))
    for line in _lines():
        if line in ("quit", "exit"):
            break
        try:
            _tell(talk.hear(line, progress()))
        except ChatSceneError as error:
            say(f"{type(error).__name__}: {error}")
            for told in readings_in_words(error.readings if isinstance(error, NothingFits) else (), talk=True):
                say(told)


def _tell(heard: Shown | Changed | Undone | Run) -> None:
    """Say what came of a line."""
    from chatscene.talk import Shown, Undone

    match heard:
        case Shown():
            say(f"now: {heard.understood.told}")
            say_understood(heard.understood, program=False)
        case Undone():
            say(f"undone: {heard.edit}")
        case _:
            say(str(heard))


def _lines() -> Iterator[str]:
    """What is said, line by line, until the end of the input; a terminal is asked for each."""
    asks = sys.stdin.isatty()
    if asks:
        say("Describe a situation, then change it; or: undo, show, run [DIR], new TEXT, quit.")
    while True:
        if asks:
            click.echo("> ", nl=False)
        line = sys.stdin.readline()
        if not line:
            return
        if plain := " ".join(line.split()):
            yield plain
