"""Where in a program something went wrong: the line, and a caret under the place."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass
from types import TracebackType
from typing import Any

WIDEST = 100  # characters of a line that are shown


@dataclass(frozen=True, slots=True)
class SourcePlace:
    """A place in a text.

    Attributes:
        line: From 1.
        column: From 1; 0 for the line as a whole.
    """

    line: int
    column: int = 0
    width: int = 1


def pointed(source: str, place: SourcePlace) -> str:
    """The line of a place, and below it a caret under each of its characters; empty if there is no such line.

    It is safe to print: what nobody can see becomes a blank.
    """
    lines = source.split("\n")
    if not (0 < place.line <= len(lines)):
        return ""
    text = "".join(c if c.isprintable() else " " for c in lines[place.line - 1]).rstrip()
    at = min(max(place.column - 1, 0), len(text))
    first = max(0, at - WIDEST // 2) if len(text) > WIDEST else 0
    shown = text[first : first + WIDEST]
    if not place.column:
        return f"    {shown.strip()}" if shown.strip() else ""
    blank = len(shown) - len(shown.lstrip())
    carets = "^" * max(1, min(place.width, first + len(shown) - at))
    return f"    {shown.lstrip()}\n    {' ' * max(0, at - first - blank)}{carets}"


def nearest(name: str, known: Iterable[str], *, alike: float = 0.75) -> str:
    """The known name that is most like another; empty if none is as much alike as asked, in [0, 1]."""
    return next(iter(difflib.get_close_matches(name, sorted(known), n=1, cutoff=alike)), "")


def meant(name: str, known: Iterable[str], *, alike: float = 0.75) -> str:
    """The end of a sentence that says which name was meant; empty if none is near."""
    near = nearest(name, known, alike=alike)
    return f"; did you mean {near}?" if near else ""


def place_in(error: BaseException, filename: str) -> SourcePlace | None:
    """Where in a file an exception, or what caused it, was raised; None if not there."""
    seen: BaseException | None = error
    while seen is not None:
        line = getattr(seen, "lineno", None)
        if isinstance(line, int) and getattr(seen, "filename", None) == filename:
            column = getattr(seen, "offset", None)
            return SourcePlace(line, column if isinstance(column, int) else 0)
        if (place := _raised(seen.__traceback__, filename)) is not None:
            return place
        seen = seen.__cause__
    return None


def _raised(trace: TracebackType | None, filename: str) -> SourcePlace | None:
    """The last place in a file that a traceback goes through."""
    found: SourcePlace | None = None
    while trace is not None:
        code = trace.tb_frame.f_code
        if code.co_filename == filename and trace.tb_lineno:
            where = next((p for i, p in enumerate(code.co_positions()) if i == trace.tb_lasti // 2), None)
            line, end, column, end_column = where or (None, None, None, None)
            if line is not None and line == trace.tb_lineno and column is not None and end_column is not None:
                found = SourcePlace(line, column + 1, end_column - column if end == line else 1)
            else:
                found = SourcePlace(trace.tb_lineno)
        trace = trace.tb_next
    return found


def told(error: BaseException) -> str:
    """What an exception says, in one line, with the name that was meant where it is about a name."""
    text = f"{type(error).__name__}: {error}".replace("\n", " ")
    if isinstance(error, AttributeError):
        return text + _of_thing(error)
    if isinstance(error, NameError) and error.name and error.__traceback__ is not None:
        trace = error.__traceback__
        while trace.tb_next is not None:
            trace = trace.tb_next
        return text + meant(error.name, {*trace.tb_frame.f_locals, *trace.tb_frame.f_globals})
    if isinstance(error, KeyError) and error.args and isinstance(error.args[0], str):
        return f"{type(error).__name__}: there is no {error.args[0]!r}".replace("\n", " ")
    return text


def _of_thing(error: AttributeError) -> str:
    thing: Any = error.obj
    try:
        known = [one for one in dir(thing) if not one.startswith("_")]
    except Exception:  # noqa: BLE001 - a thing may say of itself what it likes
        return ""
    return meant(str(error.name), known) if thing is not None else ""


def fault(error: BaseException, filename: str, source: str) -> str:
    """What an exception says, with the line of a program where it was raised and a caret under the place."""
    place = place_in(error, filename)
    if place is None:
        return told(error)
    return f"line {place.line}: {told(error)}\n{pointed(source, place)}".rstrip()
