"""What a command prints: lines, tables, and how far it is."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import TYPE_CHECKING

import click

if TYPE_CHECKING:
    from rich.console import Console


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
