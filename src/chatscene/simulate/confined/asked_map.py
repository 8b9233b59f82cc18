"""Which map a program asks for, as in ``param map = localPath(f'../maps/{town}.xodr')``; a run has its own."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import Any


def map_of(tree: Any) -> tuple[str | None, frozenset[Any]]:
    """The path that a program names, and what of its syntax tree does nothing but name it.

    A path is a text, one in ``localPath(…)``, an f-string of such, or the name of one. What only names it need not
    keep to the rules for texts, since nothing else of the program sees it.

    Args:
        tree: Scenic's syntax tree of a program.
    """
    texts = _texts(tree)
    for node in tree.body:
        for parameter in node.elts if type(node).__name__ == "Param" else ():
            if parameter.identifier == "map" and (path := _text(parameter.value, texts)) is not None:
                used = set(_names(parameter.value))
                for name in [*used]:
                    used.update(_names(texts[name].value))
                only = {name for name in used if _uses(tree, name) == _uses(parameter, name, *map(texts.get, used))}
                return path, frozenset((parameter, *(texts[name] for name in only)))
    return None, frozenset()


def _texts(tree: Any) -> dict[str, ast.Assign]:
    """Where names are set, once, to what may be a part of a path."""
    stored = [n.id for n in ast.walk(tree) if isinstance(n, ast.Name) and isinstance(n.ctx, ast.Store)]
    found: dict[str, ast.Assign] = {}
    for node in tree.body:
        match node:
            case ast.Assign(targets=[ast.Name(id=name)]) if stored.count(name) == 1:
                if _text(node.value, found) is not None:
                    found[name] = node
            case _:
                pass
    return found


def _text(value: Any, texts: dict[str, ast.Assign]) -> str | None:
    """The text that an expression is, or None if it is anything else."""
    match value:
        case ast.Constant(value=str(text)):
            return text
        case ast.Name(id=name) if name in texts:
            return _text(texts[name].value, texts)
        case ast.Call(func=ast.Name(id="localPath"), args=[path], keywords=[]):
            return _text(path, texts)
        case ast.JoinedStr(values=parts):
            told = [_text(part, texts) for part in parts]
            return None if None in told else "".join(filter(None, told))
        case ast.FormattedValue(value=ast.Name() as name, conversion=-1, format_spec=None):
            return _text(name, texts)
        case _:
            return None


def _names(node: Any) -> Iterator[str]:
    return (one.id for one in ast.walk(node) if isinstance(one, ast.Name) and one.id != "localPath")


def _uses(tree: Any, name: str, *more: Any) -> int:
    return sum(list(_names(node)).count(name) for node in (tree, *more) if node is not None)
