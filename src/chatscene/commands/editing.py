"""The command line, continued: situations that are changed in words, one edit at a time."""

from __future__ import annotations

import json
import sys
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypedDict, Unpack

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
from chatscene.errors import ChatSceneError, NothingFits
from chatscene.settings import EGO

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
@click.option("--ego", default=EGO, show_default=True, help="An ego by name, file or package.module:factory.")
@click.option("--scenes", default=50, show_default=True, help="Simulations of a run.")
@click.option("--seed", default=0, show_default=True, help="Everything random derives from it.")
@READING
def chat(map_name: str | None, ego: str, scenes: int, seed: int, **reading: Unpack[Reading]) -> None:
    """Talk about a situation: the first line says it, each further line changes it.

    Lines come from the keyboard or a pipe. Besides edits they may be: show (the facts and the snippets), undo (the last
    edit), reading N (of those that are offered), set SLOT=VALUE (a fact), run [DIR] (search it for scenes), new TEXT
    (another situation), quit. What is refused changes nothing.

    \b
    chatscene chat
    printf 'the car ahead brakes hard\\nmake it a truck\\nat night\\nrun runs/truck\\n' | chatscene chat
    """
    talk = Talk(reading, {"map": map_name, "ego": ego, "scenes": scenes, "seed": seed})
    for line in _lines():
        if line in ("quit", "exit"):
            break
        try:
            talk.hear(line)
        except ChatSceneError as error:
            from chatscene.report.terminal import readings_in_words

            say(f"{type(error).__name__}: {error}")
            for told in readings_in_words(error.readings if isinstance(error, NothingFits) else (), talk=True):
                say(told)


class Talk:
    """A situation that is talked about.

    Args:
        reading: How sentences are read.
        search: How a run is searched.
    """

    def __init__(self, reading: Reading, search: Mapping[str, Any]) -> None:
        self._reading, self._search = reading, search
        self._text, self._answer = "", Answer()
        self._asked = self._text, self._answer  # what is answered for: the text last said, understood or not
        self._said: list[Understood] = []
        self._edits: list[str] = []

    def hear(self, line: str) -> None:
        """Do what a line says, and say what came of it.

        Raises:
            ChatSceneError: The line is refused; the situation is as it was.
        """
        verb, _, rest = line.partition(" ")
        text, before = self._asked
        if text and (answer := before.further(verb, rest)):
            self._understand(text, answer, self._edits if self._said and text == self._text else [])
        elif not self._said or verb == "new":
            self._understand(rest if verb == "new" else line, Answer(), [])
        elif line == "undo":
            self._undo()
        elif line == "show":
            self._show()
        elif verb == "run" and len(rest.split()) <= 1:
            self._run(rest)
        else:
            self._said.append(self._said[-1].edit(line))
            self._edits.append(line)
            say(str(self._said[-1]))

    def _understand(self, text: str, answer: Answer, edits: list[str]) -> None:
        from chatscene import api

        try:
            said = [api.explain(text, **self._reading, **answer.options())]
        except NothingFits:
            self._asked = text, answer  # one fact may not be enough
            raise
        for edit in edits:
            said.append(said[-1].edit(edit))
        self._asked = text, answer
        self._text, self._answer, self._said, self._edits = text, answer, said, edits
        self._show()

    def _undo(self) -> None:
        if not self._edits:
            say("nothing to undo: this is what was said first")
            return
        self._said.pop()
        say(f"undone: {self._edits.pop()}")

    def _show(self) -> None:
        from chatscene.report.terminal import print_understanding

        say(f"now: {self._said[-1].told}")
        print_understanding(console(), self._said[-1], show_program=False)

    def _run(self, folder: str) -> None:
        from chatscene import api, runs

        done = api.run(
            self._text,
            folder or runs.free_folder(Path("runs"), self._edits[-1] if self._edits else self._text),
            edit=self._edits,
            progress=progress(),
            **self._search,
            **self._reading,
            **self._answer.options(),
        )
        say(str(done))


@dataclass(frozen=True, slots=True)
class Answer:
    """What was answered to what was asked back of a text.

    Attributes:
        reading: The number of the one taken, of those that were offered; 0 for none.
        facts: What was stated, by slot.
    """

    reading: int = 0
    facts: tuple[tuple[str, str], ...] = ()

    def further(self, verb: str, rest: str) -> Answer | None:
        """The same with what a line answers; None if it answers nothing."""
        if verb == "reading" and rest.isdecimal():
            return replace(self, reading=int(rest))
        name, equals, value = rest.partition("=")
        if verb == "set" and equals:
            return replace(self, facts=(*self.facts, (name.strip(), value.strip())))
        return None

    def options(self) -> Answered:
        """The same as options of `chatscene.explain` and `chatscene.run`."""
        return {"reading": self.reading, "set": dict(self.facts)}


class Answered(TypedDict):
    """An answer, as options of `chatscene.explain` and `chatscene.run`."""

    reading: int
    set: dict[str, str]


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
