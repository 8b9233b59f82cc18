"""The command line, continued: how a text is read, and the snippets that serve it in the paper's way."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypedDict, Unpack

import click
from click.core import ParameterSource

from chatscene.settings import EXECUTOR, MOST_READINGS, PHYSICS, READERS, SimulationSettings

if TYPE_CHECKING:
    from rich.console import Console

JSON = click.option("--json", "as_json", is_flag=True, help="Print JSON for a script instead of text.")


def usable_map(ctx: click.Context, option: click.Parameter, name: str | None) -> str | None:
    """The map that the user names, held to what every map is before anything is made or begun for it.

    Raises:
        MapError: It is none, or cannot be used.
    """
    if name is not None and ctx.get_parameter_source(option.name or "") is ParameterSource.COMMANDLINE:
        from chatscene.maps.network import check_opendrive, resolve_map

        check_opendrive(resolve_map(name))
    return name


MAP = click.option(
    "--map",
    "map_name",
    default="town",
    show_default=True,
    callback=usable_map,
    help="The packaged 'town', 'outskirts' or 'region', or an .xodr file.",
)
MAP_WITH_SITE = click.option(
    "--map",
    "map_name",
    default=None,
    callback=usable_map,
    help="The packaged 'town', 'outskirts' or 'region', or an .xodr file.  "
    "[default: town; outskirts for motorways and the like]",
)
COMPONENT = click.Choice(["behavior", "geometry", "spawn"])
EXECUTOR_OPTION = click.option(
    "--executor",
    default=EXECUTOR,
    show_default=True,
    help="Where parts run: processes of this machine, or ray:HOST:PORT, a cluster. Results are the same.",
)
PHYSICS_OPTION = click.option(
    "--physics",
    type=click.Choice(PHYSICS),
    default=SimulationSettings().physics,
    show_default=True,
    help="How vehicles answer to pedals and wheel: kinematic, or lagged (delays and a friction circle).",
)


def WORKERS(command: Callable[..., Any]) -> Callable[..., Any]:  # noqa: N802 - a decorator, like those of click
    """Options that say who works."""
    jobs = click.option(
        "--jobs", default=1, show_default=True, type=click.IntRange(min=1), help="Number of parts that run at a time."
    )
    return jobs(EXECUTOR_OPTION(command))


class Reading(TypedDict):
    """The options that say how sentences are read; the names are those of `chatscene.settings.RetrievalSettings`."""

    library: str
    embedder: str
    language_model: str


def READING(command: Callable[..., Any]) -> Callable[..., Any]:  # noqa: N802 - a decorator, like those of click
    """Options that say how sentences are read."""
    own = click.option(
        "--library", default="", metavar="DIR", help="Folder of your own snippets. TEXT is then served by snippets."
    )
    embedder = click.option("--embedder", default="minilm", show_default=True, help="Text encoder.")
    model = click.option(
        "--language-model", default="offline", show_default=True, help="openai:MODEL, gguf:FILE, or offline."
    )
    return own(embedder(model(command)))


READER = click.option(
    "--reader",
    type=click.Choice(READERS),
    default=READERS[0],
    show_default=True,
    help="How TEXT is read: facts, of which a situation is made; or paper, by wording alone, with snippets and without "
    "refusals.",
)


class Chosen(Reading):
    """The options beside those that say which reading is meant; the names are those of `chatscene.run`."""

    reader: str
    reading: int
    set: dict[str, str]


def CHOOSING(command: Callable[..., Any]) -> Callable[..., Any]:  # noqa: N802 - a decorator, like those of click
    """Options that say which reading of a text is meant."""
    taken = click.option(
        "--reading",
        type=click.IntRange(0, MOST_READINGS),
        default=0,
        help="Use reading N of those that a refusal offers.",
    )
    stated = click.option(
        "--set",
        multiple=True,
        default=(),
        metavar="FACT=VALUE",
        callback=_facts,
        help="Force a fact, by name (side=left) or by path (others.A.starts.side=left). Repeatable.",
    )
    return READER(taken(stated(command)))


def _facts(_context: click.Context, _option: click.Parameter, said: tuple[str, ...]) -> dict[str, str]:
    """Facts by name, as they are said."""
    facts: dict[str, str] = {}
    for one in said:
        name, equals, value = one.partition("=")
        if not equals or name in facts:
            raise click.BadParameter(f"{one!r}; say each fact once, as FACT=VALUE, such as side=left")
        facts[name.strip()] = value.strip()
    return facts


def parameters(context: click.Context, option: click.Parameter, said: tuple[str, ...]) -> dict[str, object]:
    """Parameters of a program by name; what is no JSON is a text."""
    told: dict[str, object] = {}
    for name, value in _facts(context, option, said).items():
        try:
            told[name] = json.loads(value)
        except ValueError:
            told[name] = value
    return told


def param_option(told: str) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """The option that gives a program parameters.

    Args:
        told: What they are, for its help.
    """
    return click.option(
        "--param",
        multiple=True,
        default=(),
        metavar="NAME=VALUE",
        callback=parameters,
        help=f"{told} VALUE is JSON, or else text. Repeatable.",
    )


PARAM = param_option("Set a parameter that a program uses and does not define, or that an .xosc file declares.")
VARIANT = click.option(
    "--variant",
    default=0,
    type=click.IntRange(min=0),
    metavar="N",
    help="Set N of an .xosc file of parameter values.  [default: drives spread over all sets]",
)


# What the user says again of what a run names beyond what is packaged (`chatscene.runs.trust.Repeated`).
_AGAIN = "that the run uses, to confirm that you trust it."
LIBRARY_AGAIN = click.option("--library", multiple=True, metavar="DIR", help=f"The snippet folder {_AGAIN}")
GENERATOR_AGAIN = click.option("--generator", multiple=True, help=f"The generator {_AGAIN}")
SAMPLER_AGAIN = click.option("--sampler", multiple=True, help=f"The sampler {_AGAIN}")
SIMULATOR_AGAIN = click.option("--simulator", multiple=True, help=f"The simulator {_AGAIN}")
EMBEDDER_AGAIN = click.option("--embedder", multiple=True, help=f"The embedder {_AGAIN}")
MODEL_AGAIN = click.option("--language-model", multiple=True, help=f"The language model {_AGAIN}")
EGO_AGAIN = click.option(
    "--ego", multiple=True, help="The ego that the run uses, to confirm that you trust its code. Repeatable."
)


class Again(TypedDict):
    """What a record names and must be told again, since it may run code; the names are those of `chatscene.api.Run`."""

    ego: tuple[str, ...]
    generator: tuple[str, ...]
    sampler: tuple[str, ...]
    simulator: tuple[str, ...]
    library: tuple[str, ...]
    embedder: tuple[str, ...]
    language_model: tuple[str, ...]


def AGAIN(command: Callable[..., Any]) -> Callable[..., Any]:  # noqa: N802 - a decorator, like those of click
    """Options for everything that a record may name."""
    return EGO_AGAIN(
        GENERATOR_AGAIN(SAMPLER_AGAIN(SIMULATOR_AGAIN(LIBRARY_AGAIN(EMBEDDER_AGAIN(MODEL_AGAIN(command))))))
    )


class DrivenAgain(TypedDict):
    """The same where scenes of a record are driven again, and nothing is read or searched."""

    ego: tuple[str, ...]
    generator: tuple[str, ...]
    simulator: tuple[str, ...]
    library: tuple[str, ...]


def DRIVEN_AGAIN(command: Callable[..., Any]) -> Callable[..., Any]:  # noqa: N802
    """Options for what a record may name of a scene to be driven again."""
    return EGO_AGAIN(GENERATOR_AGAIN(SIMULATOR_AGAIN(LIBRARY_AGAIN(command))))


OWN = click.option("--library", "own", default="", metavar="DIR", help="Your own snippets, beside the packaged ones.")


def progress() -> Callable[[str, int, int], None]:
    """A progress line with an estimate of the time left; silent where nobody watches."""
    from chatscene.report.terminal import progress_line

    return progress_line(sys.stderr)


def console() -> Console:
    """Where tables are printed."""
    from rich.console import Console

    return Console(highlight=False, emoji=False)


def say(text: str, *, err: bool = False) -> None:
    """Print a line; what could steer the terminal is shown as its code."""
    from chatscene.report.terminal import visible

    click.echo(visible(text), err=err)


@click.group()
def library() -> None:
    """The snippets that serve TEXT with --library DIR and in the paper's way."""


@library.command("list")
@click.option("--component", type=COMPONENT, default=None)
@OWN
@JSON
def list_snippets(component: str | None, own: str, as_json: bool) -> None:
    """List the snippets, a line each, and how many there are.

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
    """Print one snippet: what it says, what it needs and gives, its code.

    \b
    chatscene library show behavior/cross-and-stop
    """
    from chatscene.library.load import library_with
    from chatscene.report.terminal import print_snippet

    print_snippet(console(), library_with(own).get(snippet_id))


@library.command()
@click.argument("text")
@click.option("--component", type=COMPONENT, default="behavior", show_default=True)
@click.option("--top", default=5, show_default=True)
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

    found = nearest(text, Component(component), library_with(own), load_embedder(), count=top)
    if as_json:
        say(json.dumps([{"id": s.id, "similarity": similarity} for s, similarity in found]))
        return
    for snippet, similarity in found:
        say(f"{similarity:5.2f}  {snippet.id:<44} {snippet.description}")


@library.command()
@OWN
@click.option("--scenes", default=10, show_default=True, help="Scenes per program.")
@WORKERS
@JSON
def lint(own: str, scenes: int, jobs: int, executor: str, as_json: bool) -> None:
    """Check every snippet: header against code, compiles, samples, runs, does what it says, differs from the others.

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
@click.option("--out", type=click.Path(path_type=Path, file_okay=False), default=None, help="For tables and sentences.")
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
