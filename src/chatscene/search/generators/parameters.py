"""Parameters that a program reads and whoever runs it states, as `scenic --param` does for Scenic's own command."""

from __future__ import annotations

import ast
import io
import pprint
import re
import tokenize
from collections.abc import Iterator, Mapping
from functools import lru_cache
from importlib.resources import files
from typing import Any

from chatscene.errors import SettingsError

_NAME = re.compile(r"[A-Za-z]\w{0,63}\Z", re.ASCII)
_PARAM = re.compile(r"^param +(\w+)", re.MULTILINE)
_BEFORE = frozenset((tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE))
_WIDTH = 100  # characters of a line of values
_BY_SCENIC = frozenset(("map", "map_options", "route", "use2DMap", "snapToGroundDefault"))  # which its models state


def stated(source: str, values: Mapping[str, object]) -> str:
    """A program with `param` lines for some parameters before all other code.

    Raises:
        SettingsError: One has an odd name, or a value of another kind.
    """
    for name, value in values.items():
        if not _NAME.match(name):
            raise SettingsError(f"a parameter of a program has a name such as spawnPt, not {name!r}")
        if (odd := next(_odd(value), None)) is not None:
            raise SettingsError(f"the parameter {name} is given {odd!r}; it is a number, a text, or a list of such")
    told = [
        f"param {name} = {pprint.pformat(v, width=_WIDTH, compact=True, sort_dicts=False)}"
        for name, v in values.items()
    ]
    at = _first_code(source)
    lines = source.split("\n")
    return "\n".join((*lines[:at], *told, *lines[at:]))


def unstated(tree: Any) -> tuple[str, ...]:
    """The parameters that a program reads and neither it nor its world model states, in order of their names."""
    every: list[Any] = list(ast.walk(tree))
    states = {one.identifier for node in every if type(node).__name__ == "Param" for one in node.elts}
    return tuple(sorted(set(_read(tree)) - states - _BY_SCENIC - _of_models()))


def _read(tree: Any) -> Iterator[str]:
    for node in ast.walk(tree):
        match node:
            case ast.Attribute(value=ast.Name(id="globalParameters"), attr=name):
                yield name
            case _:
                pass


@lru_cache(maxsize=1)
def _of_models() -> frozenset[str]:
    texts = (
        files("chatscene.world").joinpath(name).read_text("utf-8") for name in ("driving.scenic", "carla_model.scenic")
    )
    return frozenset(name for text in texts for name in _PARAM.findall(text)) | {"simulator"}


def _odd(value: object) -> Iterator[object]:
    """Whatever in a value no text of a program can be."""
    match value:
        case str() | int() | float() | None:
            return
        case list() | tuple():
            for one in value:
                yield from _odd(one)
        case dict():
            for key, one in value.items():
                yield from (*_odd(key), *_odd(one))
        case _:
            yield value


def _first_code(source: str) -> int:
    """How many lines stand before the first statement, beyond comments and a docstring."""
    lines = 0
    try:
        for token in tokenize.generate_tokens(io.StringIO(source).readline):
            if token.type in _BEFORE or (token.type == tokenize.STRING and token.start[1] == 0):
                lines = token.end[0] if token.type != tokenize.NEWLINE or token.string else lines
            else:
                return token.start[0] - 1
    except (tokenize.TokenError, SyntaxError):
        pass  # the parser says what is wrong
    return lines
