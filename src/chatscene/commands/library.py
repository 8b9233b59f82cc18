"""The command line, continued: the snippets that serve a text with a library of one's own, and in the paper's way."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import Unpack

import click

from chatscene.commands.options import JSON, MANY, READER, READING, WORKERS, Reading
from chatscene.commands.output import console, progress, say

COMPONENT = click.Choice(["behavior", "geometry", "spawn"])
OWN = click.option(
    "--library", "own", default="", metavar="DIR", help="Folder of your own snippets, in addition to the packaged ones."
)


@click.group()
def library() -> None:
    """The snippets that --library DIR and --reader paper build programs from."""


@library.command("list")
@click.option("--component", type=COMPONENT, default=None)
@OWN
@JSON
def list_snippets(component: str | None, own: str, as_json: bool) -> None:
    """List the snippets, one per line, and how many there are.

    \b
    chatscene library list --component spawn
    """
    from chatscene.library.load import library_with

    snippets = [s for s in library_with(own) if component in (None, s.component.value)]
    if as_json:
        say(json.dumps([{"id": s.id, "description": s.description} for s in snippets], indent=1))
        return
    for snippet in snippets:
        say(f"{snippet.id:<48} {snippet.description}")


@library.command()
@click.argument("snippet_id", metavar="ID")
@OWN
def show(snippet_id: str, own: str) -> None:
    """Print one snippet: its description, what it requires and provides, its code.

    \b
    chatscene library show behavior/cross-and-stop
    """
    from chatscene.library.load import library_with
    from chatscene.report.terminal import print_snippet

    print_snippet(console(), library_with(own).get(snippet_id))


@library.command()
@click.argument("text")
@click.option("--component", type=COMPONENT, default="behavior", show_default=True)
@click.option("--top", default=5, show_default=True, type=MANY, help="How many.")
@OWN
@JSON
def search(text: str, component: str, top: int, own: str, as_json: bool) -> None:
    """Find the snippets of one component nearest to TEXT.

    \b
    chatscene library search "slams on the brakes"
    """
    from chatscene.interpret.nearest import nearest
    from chatscene.library.load import library_with
    from chatscene.models.encoders.embedding import load_embedder
    from chatscene.terms.scenario import Component

    if not text.strip():
        raise click.UsageError("nothing to search for: say what the snippet does")
    found = nearest(text, Component(component), library_with(own), load_embedder(), count=top)
    if as_json:
        say(json.dumps([{"id": s.id, "similarity": similarity} for s, similarity in found]))
        return
    for snippet, similarity in found:
        say(f"{similarity:5.2f}  {snippet.id:<44} {snippet.description}")


@library.command()
@OWN
@click.option("--scenes", default=10, show_default=True, type=MANY, help="Scenes per program.")
@WORKERS
@JSON
def lint(own: str, scenes: int, jobs: int, executor: str, as_json: bool) -> None:
    """Check that every snippet matches its header, compiles, samples, runs, does what it says, and is not a duplicate.

    With --library, your own snippets are checked, with partners from both libraries.

    \b
    chatscene library lint --jobs 2
    chatscene library lint --library my-snippets
    """
    from chatscene.grow.curation import lint_library
    from chatscene.runs.executor import Workers

    checked, findings = lint_library(own, scenes=scenes, workers=Workers(jobs, executor), progress=progress())
    if as_json:
        say(json.dumps([{"id": f.snippet_id, "rung": f.rung, "message": f.message} for f in findings]))
    else:
        for finding in findings:
            say(str(finding))
        counts = ", ".join(f"{count} {component}" for component, count in checked.items())
        say(f"{sum(checked.values())} snippets ({counts}), {len(findings)} findings")
    if findings:
        sys.exit(1)


@library.command()
@click.option("--sentences", default="held-out", show_default=True, help="A packaged set, or a file of JSON lines.")
@click.option("--no-drive", is_flag=True, help="Do not run the programs.")
@click.option(
    "--out", type=click.Path(path_type=Path, file_okay=False), default=None, help="Folder for tables and sentences."
)
@WORKERS
@READING
@READER
def evaluate(
    sentences: str,
    no_drive: bool,
    out: Path | None,
    jobs: int,
    executor: str,
    reader: str,
    **reading: Unpack[Reading],
) -> None:
    """Measure how well sentences are understood, against facts that people wrote down for them.

    \b
    chatscene library evaluate --jobs 2
    chatscene library evaluate --sentences mine.jsonl --library my-snippets --out runs/reading
    """
    from chatscene.report.tables import as_text, write_tables
    from chatscene.runs.executor import Workers
    from chatscene.settings import RetrievalSettings
    from chatscene.studies import reading as understanding

    settings = RetrievalSettings(**reading, reader=reader)
    found = understanding.load_sentences(sentences)
    judged = understanding.measure(
        found, settings=settings, drive=not no_drive, workers=Workers(jobs, executor), progress=progress()
    )
    tables = {"understanding": understanding.summary_table(judged), "facts": understanding.slot_table(judged)}
    for table in tables.values():
        say(as_text(table))
    for confusion, times in understanding.confusions(judged):
        say(f"{times:4d}  {confusion}")
    if out is not None:
        write_tables(out, tables)
        lines = (json.dumps(row, ensure_ascii=False) for row in understanding.as_rows(judged))
        (out / "sentences.jsonl").write_text("\n".join(lines) + "\n", encoding="utf-8")
        say(f"tables and every sentence: {out}")
