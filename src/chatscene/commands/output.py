"""What a command prints: lines, tables, and how far it is."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Generator, Mapping
from contextlib import ExitStack, contextmanager, redirect_stdout
from contextvars import ContextVar
from typing import IO, TYPE_CHECKING

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

    click.echo(visible(text), file=None if err else _answers.get(), err=err)


def say_failures(failures: Mapping[str, str]) -> None:
    """Say why egos were given up, in the order of egos; ends with status 1 if one was."""
    for ego, reason in failures.items():
        say(f"EgoError: {ego}: {reason}", err=True)
    if failures:
        sys.exit(1)


_answers: ContextVar[IO[str] | None] = ContextVar("answers", default=None)


@contextmanager
def only_answers() -> Generator[None]:
    """Keep standard output for what `say` says; whatever else is printed, here or in a worker, goes to standard error.

    Code of a user's own, such as an ego, prints what it likes, and a script reads the rest.
    """
    out = sys.stdout
    with ExitStack() as stack:
        answers = stack.enter_context(_apart(out)) or out
        stack.callback(_answers.reset, _answers.set(answers))
        stack.enter_context(redirect_stdout(sys.stderr))
        yield


@contextmanager
def _apart(out: IO[str]) -> Generator[IO[str] | None]:
    """A stream to where file 1 led, which leads to where file 2 does meanwhile; None if `out` is not that file."""
    try:
        is_the_process = out.fileno() == 1
        kept = os.dup(1) if is_the_process else -1
    except (OSError, ValueError, AttributeError):  # a test's, or closed
        kept = -1
    if kept < 0:
        yield None
        return
    out.flush()
    try:
        os.dup2(2, 1)
        with os.fdopen(os.dup(kept), "w", encoding=sys.stdout.encoding, errors=sys.stdout.errors) as answers:
            yield answers
    finally:
        os.dup2(kept, 1)
        os.close(kept)
