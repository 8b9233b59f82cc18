"""A program that travels in the head of a scenario, and how one knows that the rest still says the same.

A logical scenario tells others what a program does, in the words of the format. To us the program itself comes back,
with the parameters that the scenario declares, as long as nobody changed the scenario or its map.
"""

from __future__ import annotations

import hashlib
import json
import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from chatscene.terms.scene import OWN_MODEL

_LINE, _PROGRAM, _STORY, _MAP = "chatscene.program.", "chatscene.digest", "chatscene.story", "chatscene.map"
_OF_ITS_OWN = frozenset(("FileHeader", "ParameterDeclarations"))
"""Elements that may be changed: who made the file, and the values of its parameters."""
_ROUTE = re.compile(r"\bselectRoute\(")
_DECLARED = re.compile(r"^param[ \t]+(OPT_\w+)[ \t]*=[^#\n]*?(?=[ \t]*(?:#|$))", re.MULTILINE)
_OWN = re.compile(rf"^model[ \t]+{re.escape(OWN_MODEL)}[ \t]*$", re.MULTILINE)

Row = tuple[str, Mapping[str, str], "Iterable[Row]"]
"""An element: its tag, its attributes, and the elements inside."""


def properties_of(source: str, route: int, map_content: bytes, story: Iterable[Row]) -> Iterator[tuple[str, str]]:
    """The properties by which a program travels: a name and a value each.

    Args:
        source: The program.
        route: Which of the routes that it asks for is the scene's.
        map_content: The map's file.
        story: The elements inside the scenario.
    """
    pinned = _ROUTE.sub(f"selectRoute(only={route}, ", source, count=1) if route else source
    yield _PROGRAM, _hash("\n".join((*pinned.splitlines(), "")).encode())
    yield _STORY, _digest(story)
    yield _MAP, _hash(map_content)
    for number, line in enumerate(pinned.splitlines(), 1):
        yield f"{_LINE}{number:04}", line


def program_in(properties: Mapping[str, str], map_content: bytes, story: Iterable[Row]) -> str | None:
    """The program that travels in properties; None where there is none, or it, the rest or the map was changed since.

    Whoever changes it on purpose can seal it anew; it is a stranger's program like any other.
    """
    lines = [properties[name] for name in sorted(properties) if name.startswith(_LINE)]
    source = "\n".join((*lines, ""))
    if not lines or _OWN.search(source) is None:
        return None
    sealed = {_PROGRAM: _hash(source.encode()), _STORY: _digest(story), _MAP: _hash(map_content)}
    return source if all(properties.get(name) == one for name, one in sealed.items()) else None


def carries(properties: Mapping[str, str]) -> bool:
    """Whether a program travels in properties, be it that of the rest or not."""
    return any(name.startswith(_LINE) for name in properties)


def with_values(source: str, values: Mapping[str, tuple[float, float]]) -> str:
    """A program whose parameters vary within other ends; one whose ends are one number is that number."""
    for name in (name for name, (low, high) in values.items() if low == high):
        source = re.sub(rf"^param[ \t]+{name}\b[^\n]*\n", "", source, flags=re.MULTILINE)
        source = re.sub(rf"\bglobalParameters\.{name}\b", f"({values[name][0]!r})", source)

    def declared(found: re.Match[str]) -> str:
        span = values.get(found[1])
        return found[0] if span is None else f"param {found[1]} = Range({span[0]!r}, {span[1]!r})"

    return _DECLARED.sub(declared, source)


def _digest(story: Iterable[Row]) -> str:
    def plain(rows: Iterable[Row]) -> list[Any]:
        return [
            [tag, dict(sorted(said.items())), plain(inside)] for tag, said, inside in rows if tag not in _OF_ITS_OWN
        ]

    return _hash(json.dumps(plain(story)).encode())


def _hash(content: bytes) -> str:
    return hashlib.blake2b(content, digest_size=16).hexdigest()
