"""The command line, continued: situations that are changed in words, one edit at a time."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Unpack

import click

from chatscene.commands.library import (
    AGAIN,
    JSON,
    MAP_WITH_SITE,
    READING,
    Again,
    Reading,
    console,
    progress,
    say,
)
from chatscene.errors import ChatSceneError

if TYPE_CHECKING:
    from chatscene.report.understood import Understood

EDITS = click.option(
    "--edit", multiple=True, default=(), metavar="EDIT", help="What is to be another than TEXT says; repeat, in order."
)


@click.command()
@click.argument("folder", metavar="RUN", type=click.Path(path_type=Path))
@click.argument("text", metavar="EDIT", required=False)
@click.option("--undo", is_flag=True, help="Name the run of which RUN is an edit, in place of an EDIT.")
@click.option("--dry-run", is_flag=True, help="Only show the difference.")
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    default=None,
    help="Folder of the new run; default: a new one beside RUN.",
)
@click.option("--jobs", default=1, show_default=True, type=click.IntRange(min=1), help="Processes.")
@AGAIN
@JSON
def edit(
    folder: Path,
    text: str | None,
    undo: bool,
    dry_run: bool,
    out: Path | None,
    jobs: int,
    as_json: bool,
    **again: Unpack[Again],
) -> None:
    """Change what EDIT names in the situation of RUN, show the difference, and run it with the same settings.

    RUN is the folder of a finished run of a sentence, and stays as it is; run.json of the new one names it.

    \b
    chatscene edit runs/cyclist "make it a truck, from the right, and slower"
    chatscene edit runs/cyclist "hidden by a hedge" --dry-run
    chatscene edit runs/hidden-by-a-hedge --undo
    """
    from chatscene import api

    if undo == (text is not None):
        raise click.UsageError("say what to change, as an EDIT, or --undo")
    run = api.Run(
        folder,
        **again,
    )
    if text is None:
        say(json.dumps({"folder": str(run.edited_from.folder)}) if as_json else str(run.edited_from.folder))
        return
    edited = run.understood.edit(text)
    if not as_json:
        say(str(edited))
    done = None if dry_run else run.edit(text, out, jobs=jobs, progress=progress())
    if as_json:
        say(json.dumps({**edited.as_dict(), "folder": str(done.folder) if done else None}, indent=1))
    elif done:
        say(str(done))


@click.command()
@MAP_WITH_SITE
@click.option("--ego", default="sac", show_default=True, help="An ego by name, file or package.module:factory.")
@click.option("--scenes", default=50, show_default=True, help="Simulations of a run.")
@click.option("--seed", default=0, show_default=True, help="Everything random derives from it.")
@READING
def chat(map_name: str | None, ego: str, scenes: int, seed: int, **reading: Unpack[Reading]) -> None:
    """Talk about a situation: the first line says it, each further line changes it.

    Lines come from the keyboard or a pipe. Besides edits they may be: show (the facts and the snippets), undo (the last
    edit), run [DIR] (search it for scenes), new TEXT (another situation), quit. What is refused changes nothing.

    \b
    chatscene chat
    printf 'the car ahead brakes hard\\nmake it a truck\\nat night\\nrun runs/truck\\n' | chatscene chat
    """
    from chatscene import api

    said: list[Understood] = []
    edits: list[str] = []
    text = ""
    for line in _lines():
        verb, _, rest = line.partition(" ")
        try:
            if verb in ("quit", "exit") and not rest:
                break
            if not said or verb == "new":
                text = rest if verb == "new" else line
                first = api.explain(text, **reading)
                said, edits = [first], []
                _show(first)
            elif line == "undo":
                _undo(said, edits)
            elif line == "show":
                _show(said[-1])
            elif verb == "run" and len(rest.split()) <= 1:
                done = api.run(
                    text,
                    rest or _free(edits[-1] if edits else text),
                    edit=edits,
                    map=map_name,
                    ego=ego,
                    scenes=scenes,
                    seed=seed,
                    progress=progress(),
                    **reading,
                )
                say(str(done))
            else:
                said.append(said[-1].edit(line))
                edits.append(line)
                say(str(said[-1]))
        except ChatSceneError as error:
            say(f"{type(error).__name__}: {error}")


def _lines() -> Iterator[str]:
    """What is said, line by line, until the end of the input; a terminal is asked for each."""
    asks = sys.stdin.isatty()
    if asks:
        say("Say a situation, then what is to be another one; undo, show, run [DIR], new TEXT, quit.")
    while True:
        if asks:
            click.echo("> ", nl=False)
        line = sys.stdin.readline()
        if not line:
            return
        if plain := " ".join(line.split()):
            yield plain


def _undo(said: list[Understood], edits: list[str]) -> None:
    """Take the last edit back."""
    if not edits:
        say("nothing to undo: this is what was said first")
        return
    said.pop()
    say(f"undone: {edits.pop()}")


def _show(understood: Understood) -> None:
    from chatscene.report.terminal import print_understanding

    say(f"now: {understood.told}")
    print_understanding(console(), understood, show_program=False)


def _free(text: str) -> Path:
    from chatscene import runs

    return runs.free_folder(Path("runs"), text)
