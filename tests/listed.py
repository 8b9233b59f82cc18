"""Where a Python file lists members of an enumeration."""

from __future__ import annotations

import ast
import re
from collections.abc import Collection, Iterator


def members(text: str, names: Collection[str]) -> Iterator[tuple[int, frozenset[str]]]:
    """The line of each list, set and table of a Python file with more than one member of an enumeration, and which.

    Args:
        text: The file.
        names: What the enumeration may be called in it.
    """
    if not re.search(rf"\b(?:{'|'.join(names)})\.", text):  # which takes less time than to parse it
        return
    for node in ast.walk(ast.parse(text)):
        elements = [*node.keys, *node.values] if isinstance(node, ast.Dict) else getattr(node, "elts", [])
        within = [inner for element in elements for inner in getattr(element, "elts", [element])]
        found = frozenset(one.attr for one in within if _is_member(one, names))
        if len(found) > 1:
            yield node.lineno, found  # type: ignore[attr-defined]


def _is_member(node: ast.expr | None, names: Collection[str]) -> bool:
    return isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id in names
