"""Options that several commands take, each said once; they are named as the keywords of the Python functions."""

from __future__ import annotations

import json
import math
import shlex
from collections.abc import Callable
from functools import reduce
from importlib import import_module
from itertools import takewhile
from pathlib import Path
from typing import Any, TypedDict

import click
from click.core import ParameterSource

from chatscene import settings
from chatscene.commands.output import only_answers
from chatscene.errors import ChatSceneError
from chatscene.plugins import Kind, Packaged, check_name
from chatscene.settings import EGO, EXECUTOR, MOST_READINGS, PHYSICS, READ_AS, SIMULATOR, SimulationSettings

Decorator = Callable[[Callable[..., Any]], Callable[..., Any]]


class Finite(click.FloatRange):
    """A finite number in a range; click takes NaN for one of any range."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The number."""
        if not _is_a(float, value):
            self.fail(f"{value!r} is not a number; write it without a unit, such as {_such_as(self)}", param, ctx)
        number = super().convert(value, param, ctx)
        if not math.isfinite(number):
            self.fail(f"{value!r} is not a finite number.", param, ctx)
        return number


class Whole(click.IntRange):
    """A whole number in a range."""

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """The number."""
        if not _is_a(int, value):
            self.fail(f"{value!r} is not a whole number; write it in digits, such as {_such_as(self)}", param, ctx)
        return super().convert(value, param, ctx)


def _is_a(kind: type[int] | type[float], value: Any) -> bool:
    try:
        kind(value)
    except (TypeError, ValueError):
        return False
    return True


def _such_as(limits: click.IntRange | click.FloatRange) -> int:
    """A number of a range: fifty, if that is one."""
    return int(min(max(50, math.ceil(limits.min or 0)), limits.max if limits.max is not None else 50))


class OneText(click.Command):
    """A command of one text, which a shell parts into words unless it is in quotes."""

    def parse_args(self, ctx: click.Context, args: list[str]) -> list[str]:
        """Say how a text is given that is not in quotes."""
        words = list(takewhile(lambda one: not one.startswith("-"), args))
        if len(words) > 1:
            raise click.UsageError(f"put the text in quotes: {ctx.command_path} {shlex.quote(' '.join(words))}", ctx)
        return super().parse_args(ctx, args)


MANY = Whole(*settings.MANY)
SEEDS = Whole(*settings.SEEDS)
KMH = Finite(*settings.SPEEDS)


NAMES = "{names}"
TOLD = "{names with what they are}"


# Where the table of each kind of plug-in is: read only when a name is looked up.
EGOS = "chatscene.ego.policy:EGOS"
SIMULATORS = "chatscene.simulate.simulator:SIMULATORS"
EXECUTORS = "chatscene.runs.executor:EXECUTORS"
EMBEDDERS = "chatscene.models.encoders.embedding:EMBEDDERS"
READERS = "chatscene.read.reader:READERS"
EXPORTERS = "chatscene.exports.exporter:EXPORTERS"
GENERATORS = "chatscene.search.generator:GENERATORS"
SAMPLERS = "chatscene.search.sampler:SAMPLERS"


class Named(click.Option):
    """An option that names a plug-in: a name that leads nowhere is refused before anything is begun.

    Its help lists what is built in, where it asks for `NAMES`, or with what each is, for `TOLD`. The table is read only
    when it is needed.
    """

    def __init__(self, *arguments: Any, kind: str, **named: Any) -> None:
        """An option of click's, and where the table of its kind is: ``module:TABLE``."""
        super().__init__(*arguments, **named)
        self.kind = kind

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        """What click shows of it."""
        if NAMES in (self.help or ""):
            self.help = (self.help or "").replace(NAMES, ", ".join(self._table().built_in))
        if TOLD in (self.help or ""):
            known = self._table().built_in
            rows = known.rows.items() if isinstance(known, Packaged) else ()
            self.help = (self.help or "").replace(TOLD, ", ".join(f"{name} ({row['what']})" for name, row in rows))
        return super().get_help_record(ctx)

    def process_value(self, ctx: click.Context, value: Any) -> Any:
        """What is typed, or the default, which is not looked up."""
        names = super().process_value(ctx, value)
        if ctx.get_parameter_source(self.name or "") is ParameterSource.COMMANDLINE:
            for name in (names,) if isinstance(names, str) else names:
                try:
                    check_name(self._table(), name)
                except ChatSceneError as error:
                    raise click.BadParameter(str(error), ctx, self) from error
        return names

    def _table(self) -> Kind[Any]:
        module, _, table = self.kind.partition(":")
        return getattr(import_module(module), table)


def together(*options: Decorator) -> Decorator:
    """Several options as one decorator, listed in this order."""
    return lambda command: reduce(lambda done, option: option(done), reversed(options), command)


def _as_json(context: click.Context, _option: click.Parameter, asked: bool) -> bool:
    """Whether a script reads what is printed; then nobody else prints there."""
    if asked:
        context.with_resource(only_answers())
    return asked


JSON = click.option(
    "--json", "as_json", is_flag=True, callback=_as_json, help="Print JSON for a script instead of text."
)
SEED = click.option("--seed", default=0, show_default=True, type=SEEDS, help="Seed for all random choices.")
NEW_FOLDER = click.option(
    "--out", type=click.Path(path_type=Path, file_okay=False), required=True, help="A new folder, or one to continue."
)

# Where and in what scenes run.


def usable_map(ctx: click.Context, option: click.Parameter, name: str | None) -> str | None:
    """The map that the user names, held to what every map is before anything is made or begun for it.

    Raises:
        MapError: It is none, or cannot be used.
    """
    if name is not None and ctx.get_parameter_source(option.name or "") is ParameterSource.COMMANDLINE:
        from chatscene.maps.network import check_given, resolve_map

        check_given(resolve_map(name))
    return name


def usable_library(_context: click.Context, _option: click.Parameter, folder: str) -> str:
    """The folder of own snippets that the user names, held to what every one is before anything is begun with it.

    Raises:
        SnippetError: It has no snippets, or one that is broken.
    """
    if folder:
        from chatscene.library.load import library_with

        library_with(folder)
    return folder


MAP = click.option(
    "--map",
    default="town",
    show_default=True,
    callback=usable_map,
    help="The packaged 'town', 'outskirts' or 'region', a road such as 'road:2+1', or an .xodr file.",
)
MAP_WITH_SITE = click.option(
    "--map",
    default=None,
    callback=usable_map,
    help="The packaged 'town', 'outskirts' or 'region', a road such as 'road:2+1', or an .xodr file.  "
    "[default: town; outskirts for motorways and the like]",
)
SIMULATOR_OPTION = click.option(
    "--simulator",
    cls=Named,
    kind=SIMULATORS,
    default=SIMULATOR,
    show_default=True,
    help="Simulator: native (C, same numbers as embedded, which takes over where needed), embedded, "
    "confined (in the sandbox), carla[:HOST[:PORT]] (a CARLA server), or package.module:factory.",
)
SIMULATOR_THERE = click.option(
    "--simulator", cls=Named, kind=SIMULATORS, default=None, help="Simulator.  [default: that of the runs]"
)
PHYSICS_OPTION = click.option(
    "--physics",
    type=click.Choice(PHYSICS),
    default=SimulationSettings().physics,
    show_default=True,
    help="How vehicles respond to pedals and steering: kinematic, or lagged (delays and a friction circle).",
)
PHYSICS_THERE = click.option(
    "--physics", type=click.Choice(PHYSICS), default=None, help="Physics of the drives.  [default: that of the runs]"
)
OCCLUSION = click.option(
    "--occlusion/--no-occlusion",
    default=SimulationSettings().occlusion,
    show_default=True,
    help="Whether bodies hide other road users from the ego.",
)
EXECUTOR_OPTION = click.option(
    "--executor",
    cls=Named,
    kind=EXECUTORS,
    default=EXECUTOR,
    show_default=True,
    help="Where parts run: processes on this machine, or ray:HOST:PORT, a Ray cluster, with the same results.",
)
WORKERS = together(
    click.option("--jobs", default=1, show_default=True, type=MANY, help="Number of parts that run at a time."),
    EXECUTOR_OPTION,
)

# Who drives, how fast, and what is searched for.

EGO_OPTION = click.option(
    "--ego",
    cls=Named,
    kind=EGOS,
    default=EGO,
    show_default=True,
    help="An ego by name, file or package.module:factory.",
)
SPEED = click.option(
    "--speed",
    type=KMH,
    default=None,
    metavar="KMH",
    help="Speed of the ego [km/h] if the text gives none.  [default: the speed of the road]",
)
AVOIDABLE = click.option(
    "--avoidable", is_flag=True, help="Keep only crashes that a careful driver would have avoided."
)
ROAD = "road"


def _road_speed(context: click.Context, parameter: click.Parameter, value: str | None) -> float | None:
    """A speed [km/h], as it is typed; as fast as any road allows where it is that of the road."""
    from chatscene.maps import limits

    if value is None or value == ROAD:
        return None if value is None else round(limits.MOTORWAY / limits.KMH, 6)
    return KMH(value, parameter, context)


def road_speed(said: str) -> Decorator:
    """The option that says how fast egos drive on ordinary roads [km/h]."""
    return click.option("--speed", default=None, callback=_road_speed, metavar="KMH|road", help=said)


def sampler_option(default: str) -> Decorator:
    """The option that says where a search looks next."""
    return click.option(
        "--sampler",
        default=default,
        show_default=True,
        cls=Named,
        kind=SAMPLERS,
        help=f"How to search: {NAMES}, or package.module:factory.",
    )


# What is said, and how it is read.


def _facts(_context: click.Context, _option: click.Parameter, said: tuple[str, ...]) -> dict[str, str]:
    """Facts by name, as they are said."""
    facts: dict[str, str] = {}
    for one in said:
        name, equals, value = one.partition("=")
        if not equals or name in facts:
            raise click.BadParameter(f"{one!r}; give each fact once, as FACT=VALUE, such as side=left")
        facts[name.strip()] = value.strip()
    return facts


class Reading(TypedDict):
    """The options that say how sentences are read; the names are those of `chatscene.settings.RetrievalSettings`."""

    library: str
    embedder: str
    language_model: str


READING = together(
    click.option(
        "--library",
        default="",
        metavar="DIR",
        callback=usable_library,
        help="Folder of your own snippets. A text that one of them serves is run as a program of snippets.",
    ),
    click.option("--embedder", cls=Named, kind=EMBEDDERS, default="minilm", show_default=True, help="Text encoder."),
    click.option(
        "--language-model",
        cls=Named,
        kind=READERS,
        default="offline",
        show_default=True,
        help="Reader of TEXT: offline, openai:MODEL, gguf:FILE, or package.module:factory.",
    ),
)
READER = click.option(
    "--reader",
    type=click.Choice(READ_AS),
    default=READ_AS[0],
    show_default=True,
    help="situation: build a program from the facts in TEXT. paper: choose snippets by wording alone, as the paper "
    "does, and refuse nothing.",
)
CHOOSING = together(
    READER,
    click.option(
        "--reading",
        type=click.IntRange(0, MOST_READINGS),
        default=0,
        help="Use reading N of those that a refusal lists.",
    ),
    click.option(
        "--set",
        multiple=True,
        default=(),
        metavar="FACT=VALUE",
        callback=_facts,
        help="Force a fact, by name (side=left) or by path (others.A.starts.side=left). Repeatable.",
    ),
)
EDITS = click.option(
    "--edit",
    multiple=True,
    default=(),
    metavar="EDIT",
    help="Apply an edit to TEXT, such as 'at night'. Repeatable; applied in order.",
)
REPORT = click.option(
    "--report",
    type=click.Path(path_type=Path),
    default=None,
    metavar="FILE",
    help="A report of any length instead of TEXT, with one conflict or several.",
)

# Programs and recordings of others.


def parameters(context: click.Context, option: click.Parameter, said: tuple[str, ...]) -> dict[str, object]:
    """Parameters of a program by name; what is no JSON is a text."""
    told: dict[str, object] = {}
    for name, value in _facts(context, option, said).items():
        try:
            told[name] = json.loads(value)
        except ValueError:
            told[name] = value
    return told


def param_option(told: str) -> Decorator:
    """The option that gives a program parameters."""
    return click.option(
        "--param",
        multiple=True,
        default=(),
        metavar="NAME=VALUE",
        callback=parameters,
        help=f"{told} VALUE is read as JSON if possible, else as text. Repeatable.",
    )


TRUST = click.option("--trust", is_flag=True, help="Run the program with all of Python, outside the sandbox.")
AS_WRITTEN = click.option(
    "--as-written",
    is_flag=True,
    help="Let the program's own ego drive; the ego of an imported file drives as that file says.",
)
JUDGED = together(
    click.option(
        "--ego",
        cls=Named,
        kind=EGOS,
        default=None,
        help="The ego that drives a program.  [default: its own; planner if it has none or was imported]",
    ),
    click.option("--map", default=None, help="Map of a program, in place of its own: a packaged map, or a file."),
    TRUST,
    AS_WRITTEN,
    click.option("--ego-id", default=None, metavar="ID", help="Id of the ego in a recording that does not mark it."),
    param_option("Set a parameter that a program uses but does not define, or that an .xosc file declares."),
    click.option(
        "--variant",
        default=None,
        type=click.IntRange(min=1),
        metavar="N",
        help="Use only set N of an .xosc file of parameter values.  [default: drives spread over all sets]",
    ),
)

# What the user says again of what a run names beyond what is packaged (`chatscene.runs.trust.Repeated`).

_AGAIN = "that the run uses; name it to confirm that you trust it."
LIBRARY_AGAIN = click.option("--library", multiple=True, metavar="DIR", help=f"The snippet folder {_AGAIN}")
GENERATOR_AGAIN = click.option("--generator", multiple=True, help=f"The generator {_AGAIN}")
SAMPLER_AGAIN = click.option("--sampler", multiple=True, help=f"The sampler {_AGAIN}")
SIMULATOR_AGAIN = click.option("--simulator", multiple=True, help=f"The simulator {_AGAIN}")
EMBEDDER_AGAIN = click.option("--embedder", multiple=True, help=f"The embedder {_AGAIN}")
MODEL_AGAIN = click.option("--language-model", multiple=True, help=f"The language model {_AGAIN}")
EGO_AGAIN = click.option(
    "--ego", multiple=True, help="The ego that the run uses; name it to confirm that you trust its code. Repeatable."
)
AGAIN = together(EGO_AGAIN, GENERATOR_AGAIN, SAMPLER_AGAIN, SIMULATOR_AGAIN, LIBRARY_AGAIN, EMBEDDER_AGAIN, MODEL_AGAIN)
DRIVEN_AGAIN = together(EGO_AGAIN, GENERATOR_AGAIN, SIMULATOR_AGAIN, LIBRARY_AGAIN)
