"""A scene that was exported as a program, made a program to search with again.

Such a program names its map and its route, and its parameters are numbers (`chatscene.exports.filled_program`). Here
they are put as programs of our world model have them, and nothing else is changed, so the rules for strangers stay as
narrow as they are: what is not of exactly this shape is left to them.
"""

from __future__ import annotations

import ast
import re
from collections import Counter
from typing import Any, NamedTuple

from chatscene.simulate.confined.allow_list import model_of, parse_foreign
from chatscene.simulate.confined.asked_map import map_of
from chatscene.simulate.confined.plain_text import Refusal, check_text
from chatscene.simulate.confined.rules import MAX_NUMBER
from chatscene.terms.scene import OWN_MODEL

_SEARCHED = re.compile(r"OPT_[A-Z0-9_]+\Z")


class _Change(NamedTuple):
    """What stands in place of a part of a text, which is from a line, from 1, and a column, from 0, to another."""

    line: int
    column: int
    end_line: int
    end_column: int
    text: str


class OneScene(NamedTuple):
    """A program without what only one of its scenes has.

    Attributes:
        source: It, with its lines where they were: a number is a range from it to itself, and the route is the only
            one.
        map: The map that it names; None if it names none so.
    """

    source: str
    map: str | None


def as_searched(source: str, *, trusted: bool = False) -> OneScene:
    """A program of our world model as a search has it; any other, and a text that is none, as it is."""
    tree = None if not trusted and check_text(source) else parse_foreign(source)
    if tree is None or isinstance(tree, Refusal) or model_of(tree) != OWN_MODEL:
        return OneScene(source, None)
    params = [node for node in tree.body if type(node).__name__ == "Param"]
    times = Counter(one.identifier for node in params for one in node.elts)
    asked, changes, named = map_of(tree)[0], list[_Change](), None
    for node in params:
        name, value = node.elts[0].identifier, node.elts[0].value
        text = None
        if len(node.elts) > 1 or times[name] > 1:
            continue
        if name == "map" and asked is not None and asked.endswith(".xodr"):
            text, named = "", asked
        elif name == "route" and (pinned := _pinned(tree, value)) is not None:
            text = ""
            changes += pinned
        elif _SEARCHED.match(name) and (number := _number(value)) is not None:
            text = f"param {name} = Range({number!r}, {number!r})"
        if text is not None:
            changes.append(_Change(node.lineno, node.col_offset, node.end_lineno, node.end_col_offset, text))
    return OneScene(_applied(source, changes), named)


def _pinned(tree: Any, value: Any) -> list[_Change] | None:
    """What has a program choose the one route of this number; None where it has none, or the value is no number."""
    route = _number(value)
    if not isinstance(route, int) or route < 0:
        return None
    found = list[_Change]()
    for node in ast.walk(tree):
        if not (isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "selectRoute"):
            continue
        if any(keyword.arg == "only" for keyword in node.keywords):
            if route:  # of one route there is none of a higher number
                return None
        elif node.keywords:
            first = node.keywords[0]
            found.append(_Change(first.lineno, first.col_offset, first.lineno, first.col_offset, f"only={route}, "))
        elif node.end_lineno is not None and node.end_col_offset is not None:
            line, column = node.end_lineno, node.end_col_offset - 1
            found.append(_Change(line, column, line, column, f", only={route}"))
    return found


def _applied(source: str, changes: list[_Change]) -> str:
    """A text with parts of it replaced; as many lines as before."""
    lines = source.split("\n")
    for line, column, end_line, end_column, text in sorted(changes, reverse=True):
        behind = lines[end_line - 1][end_column:]
        lines[line - 1] = f"{lines[line - 1][:column]}{text}{behind}"
        lines[line:end_line] = [""] * (end_line - line)
    return "\n".join(lines)


def _number(value: Any) -> int | float | None:
    """The number that is written there, with its sign; None of all else."""
    match value:
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant() as inner):
            number = _number(inner)
            return None if number is None else -number
        case ast.Constant(value=int() | float() as number) if (
            not isinstance(number, bool) and abs(number) <= MAX_NUMBER
        ):
            return number
        case _:
            return None
