"""Which map a program asks for, as in ``param map = localPath(f'../maps/{town}.xodr')``; a run has its own."""

from __future__ import annotations

import ast
from collections import Counter
from collections.abc import Iterator, Mapping
from typing import Any, NamedTuple

_BESIDE = frozenset(("carla_map", "lgsvl_map", "sumo_map"))
LONGEST_PATH = 4096  # characters; Linux takes no more


class _Named(NamedTuple):
    """A name that is set, once, to what may be a part of a path: what it is set to, and the text that this is."""

    value: Any
    text: str


def map_of(tree: Any) -> tuple[str | None, frozenset[Any]]:
    """The path that a program names, and what of its syntax tree does nothing but name it.

    A path is a text, one in ``localPath(…)``, an f-string or a sum of such, or the name of one. What only names it need
    not keep to the rules for texts, since nothing else of the program sees it; the names themselves keep to theirs.
    """
    texts = _texts(tree)
    beside = [value for value in _unread(tree) if _text(value, texts) is not None]
    for node in tree.body:
        for parameter in node.elts if type(node).__name__ == "Param" else ():
            if parameter.identifier == "map" and (path := _text(parameter.value, texts)) is not None:
                used = set(_names(parameter.value))
                for name in reversed(texts):  # each is made of those before it
                    if name in used:
                        used.update(_names(texts[name].value))
                values = {name: texts[name].value for name in used & texts.keys()}
                naming = (parameter.value, *values.values(), *_unread(tree))
                here = Counter(name for value in naming for name in _names(value))
                all_over = Counter(_names(tree))
                return path, frozenset(
                    (
                        parameter.value,
                        *beside,
                        *(value for name, value in values.items() if all_over[name] == here[name] + 1),
                    )
                )
    return None, frozenset(beside)


def _unread(tree: Any) -> Iterator[Any]:
    """What parameters are set to that name a simulator's own map, and that the program does not read."""
    read = {node.attr for node in ast.walk(tree) if isinstance(node, ast.Attribute)}
    for node in tree.body:
        for parameter in node.elts if type(node).__name__ == "Param" else ():
            if parameter.identifier in _BESIDE - read:
                yield parameter.value


def _texts(tree: Any) -> dict[str, _Named]:
    """Where names are set, once, to what may be a part of a path, in order."""
    stored = Counter(n.id for n in ast.walk(tree) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store))
    found: dict[str, _Named] = {}
    for node in tree.body:
        for parameter in node.elts if type(node).__name__ == "Param" else ():
            if isinstance(parameter.value, ast.Constant) and (text := _text(parameter.value, found)) is not None:
                found[_parameter(parameter.identifier)] = _Named(parameter.value, text)
        match node:
            case ast.Assign(targets=[ast.Name(id=name)]) if stored[name] == 1:
                if (text := _text(node.value, found)) is not None:
                    found[name] = _Named(node.value, text)
            case _:
                pass
    return found


def _text(value: Any, texts: Mapping[str, _Named]) -> str | None:
    """The text that an expression is; None if it is anything else, or no path of a file."""
    match value:
        case ast.Constant(value=str(text)):
            return _path(text)
        case ast.Name() | ast.Attribute():
            named = texts.get(_name(value))
            return named.text if named else None
        case ast.Call(func=ast.Name(id="localPath"), args=[path], keywords=[]):
            return _text(path, texts)
        case ast.JoinedStr() | ast.BinOp(op=ast.Add()):
            parts = value.values if isinstance(value, ast.JoinedStr) else (value.left, value.right)
            told = [_text(part, texts) for part in parts]
            return None if None in told else _path("".join(filter(None, told)))
        case ast.FormattedValue(value=(ast.Name() | ast.Attribute()) as name, conversion=-1, format_spec=None):
            return _text(name, texts)
        case _:
            return None


def _path(text: str) -> str | None:
    return text if len(text) <= LONGEST_PATH and text.isprintable() else None


def _name(node: ast.Name | ast.Attribute) -> str:
    """How a name, or a parameter that is read, is called; empty for anything else."""
    if isinstance(node, ast.Name):
        return node.id
    return _parameter(node.attr) if isinstance(node.value, ast.Name) and node.value.id == "globalParameters" else ""


def _parameter(name: str) -> str:
    return f"globalParameters.{name}"


def _names(node: Any) -> Iterator[str]:
    return (one.id for one in ast.walk(node) if isinstance(one, ast.Name) and one.id != "localPath")
