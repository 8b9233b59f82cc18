"""Options that a command has from the function of its name: a keyword with its line in the docstring is an option.

Who writes an option out, in the command's own module, has its type, its help and its place as it should be. A keyword
that no option is written for becomes one by itself: a flag, a text, a number or a path, as its type says.
"""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import click

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
