"""The command line: one verb per command, the same words as the Python functions.

Exit status: 0 done, 1 error, 2 usage, 3 refused because a text or an edit was not understood, or cannot be built.
"""

from __future__ import annotations

import gc
import inspect
import re
import warnings
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import click

import chatscene
from chatscene.commands.coverage import coverage
from chatscene.commands.doctor import doctor
from chatscene.commands.editing import chat, edit
from chatscene.commands.exchange import export, import_scenario
from chatscene.commands.learn import finetune, train
from chatscene.commands.library import library
from chatscene.commands.look import check, replay, why
from chatscene.commands.make import explain, resume, run
from chatscene.commands.maps import map_group
from chatscene.commands.mcp import mcp
from chatscene.commands.measure import benchmark, drive, evaluate
from chatscene.commands.output import say
from chatscene.commands.proposal import COMMANDS, describe
from chatscene.commands.rate import rate
from chatscene.commands.refusal import REFUSED, complain, no_such_name
from chatscene.commands.reproduce import reproduce
from chatscene.commands.sections import write_sections
from chatscene.commands.serve_carla import serve_carla
from chatscene.commands.situations import schema
from chatscene.commands.skill import skill
from chatscene.commands.sql import runs_below, sql
from chatscene.commands.story import story
from chatscene.commands.verify import verify
from chatscene.commands.view import open_report, view
from chatscene.errors import ChatSceneError, EditRefused, MeansSomethingElse, NothingFits
from chatscene.memory import lack_of_memory, require_memory

NO_OPTIONS = frozenset(("settings", "progress", "within"))
"""Keywords that are for Python alone."""
_TYPES: dict[str, Any] = {"str": str, "int": int, "float": float, "Name": click.Path(path_type=Path)}


def add_keywords(command: click.Command, function: Any) -> None:
    """Give a command an option for each keyword of its function that it has none for; those are added once.

    Raises:
        TypeError: A keyword's type or docstring does not say what its option is.
    """
    there = {name for option in command.params if option.name for name in (option.name, option.name.rstrip("_"))}
    missing = [one for one in _keywords(function) if one.name not in there]
    command.params += [_option(function, one) for one in missing]


def _keywords(function: Any) -> Iterator[inspect.Parameter]:
    for one in inspect.signature(function).parameters.values():
        if one.kind is inspect.Parameter.KEYWORD_ONLY and one.name not in NO_OPTIONS:
            yield one


def _option(function: Any, one: inspect.Parameter) -> click.Option:
    told = re.search(rf"^    {one.name}: (.+(?:\n     .+)*)", inspect.getdoc(function) or "", re.MULTILINE)
    name = f"{function.__module__}.{function.__name__}: {one.name}"
    if told is None:
        raise TypeError(f"{name} has no line in the docstring, which is to be the help of its option")
    said = " ".join(told[1].split()).replace("``", "")
    spelled = f"--{one.name.rstrip('_').replace('_', '-')}"
    kind = str(one.annotation).removesuffix(" | None")
    if kind == "bool" and one.default is False:
        return click.Option([spelled, one.name], is_flag=True, help=said)
    if kind not in _TYPES:
        raise TypeError(f"{name} is {one.annotation}: write its option in the command's module, below commands/")
    return click.Option([spelled, one.name], type=_TYPES[kind], default=one.default, show_default=True, help=said)


def _warn(otherwise: Callable[..., None], message: Warning | str, kind: type[Warning], file: str, *more: Any) -> None:
    """Say a warning of ours as a line; where in our code it stands is nothing to a user."""
    if Path(file).is_relative_to(Path(__file__).parents[1]):
        say(f"warning: {message}", err=True)
    else:
        otherwise(message, kind, file, *more)


_AS_JSON = "chatscene.as_json"


class _Errors(click.Group):
    """Shows our own errors as one message and turns them into the exit status."""

    def make_context(self, info_name: str | None, args: list[str], *more: Any, **extra: Any) -> click.Context:
        """Refuse what no path, no name and no text holds, before anything takes it for one."""
        if odd := next((one for one in args if "\0" in one), None):
            raise click.UsageError(f"{odd!r} holds a NUL character")
        as_json = "--json" in args
        made = super().make_context(info_name, args, *more, **extra)
        made.meta[_AS_JSON] = as_json
        return made

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:  # noqa: ARG002 - as in click
        """List the commands by what one wants to do."""
        write_sections(self.commands, formatter)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        """A command, with the options that the function of its name has beyond those that are written out."""
        command = super().get_command(ctx, cmd_name)
        if command is not None and (function := FUNCTIONS.get(cmd_name)) is not None:
            add_keywords(command, getattr(chatscene, function))
        return command

    def invoke(self, ctx: click.Context) -> Any:
        try:
            with warnings.catch_warnings():
                warnings.showwarning = partial(_warn, warnings.showwarning)
                require_memory()
                return super().invoke(ctx)
        except (NothingFits, MeansSomethingElse, EditRefused) as error:
            complain(error, as_json=ctx.meta[_AS_JSON])
            ctx.exit(REFUSED)
        except (click.ClickException, click.exceptions.Exit, click.Abort):
            raise
        except Exception as error:
            told = lack_of_memory(error) or no_such_name(error) or error
            if not isinstance(told, ChatSceneError):
                raise
            complain(told, as_json=ctx.meta[_AS_JSON])
            ctx.exit(1)
        except KeyboardInterrupt as error:
            kept = getattr(error, "__notes__", [])[-1:]  # the last: of the folder that holds the others
            say("; ".join(["\ninterrupted", *kept]), err=True)
            ctx.exit(130)


@click.group(cls=_Errors, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(package_name="chatscene")
def main() -> None:
    """Turn a sentence about a dangerous traffic situation into crash scenes for testing.

    \b
    chatscene run "a cyclist crosses from the left in front of us" --out runs/cyclist
    chatscene explain "the car ahead brakes hard"
    chatscene edit runs/cyclist "make it a truck, from the right"
    chatscene replay runs/cyclist SCENE_ID
    """
    gc.set_threshold(YOUNG)


FUNCTIONS = {
    "describe": "describe", "evaluate": "evaluate", "explain": "explain", "export": "export", "finetune": "finetune",
    "import": "import_scenario", "rate": "rate", "replay": "replay", "resume": "resume", "run": "run", "train": "train",
    "story": "story", "verify": "verify", "why": "why",
}  # fmt: skip
"""The function of each command that does what the command does."""
YOUNG = 30_000
"""New objects after which Python looks for garbage. At its own 700, a tenth of the time that a command takes to begin
goes into looking through what has just been loaded and stays."""

for command in COMMANDS:
    library.add_command(command)
for command in (
    benchmark, chat, check, coverage, describe, doctor, drive, edit, evaluate, explain, export, finetune,
    import_scenario, library, map_group, mcp, open_report, rate, replay, reproduce, resume, run, runs_below, schema,
    serve_carla, skill, sql, story, train, verify, view, why,
):  # fmt: skip
    main.add_command(command)
