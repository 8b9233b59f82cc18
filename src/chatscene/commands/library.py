"""The command line, continued: the snippets that serve a text with a library of one's own, and in the paper's way."""

from __future__ import annotations

import json
import sys

import click

from chatscene.commands.options import JSON, MANY, WORKERS
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
