"""The files that an answer refers to: its map, its catalogs, the scenario whose parameters it gives values for."""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Iterator
from pathlib import Path

from chatscene.errors import ScenarioError
from chatscene.imports.catalogs import relative
from chatscene.imports.stranger_xml import read_xml

_QUOTED = re.compile(r"""(["'])((?:(?!\1)[^\\\n])*\.xodr)\1""")
_NAMED = {"LogicFile": "filepath", "ScenarioFile": "filepath", "Directory": "path"}
"""Elements of OpenSCENARIO that name a file or a folder, and by which attribute."""


def digest(answer: Path) -> bytes:
    """What stands in all files that an answer refers to, in short: another once one is edited; empty of none."""
    found, files = hashlib.sha256(), sorted(referred(answer))
    for path in files:
        found.update(os.path.relpath(path, answer.parent).encode() + b"\0")
        found.update(hashlib.sha256(path.read_bytes()).digest())
    return found.digest() if files else b""


def referred(answer: Path) -> set[Path]:
    """The files that an answer refers to and that are there, with those that they refer to; itself is none of them.

    A name that is computed or a parameter's may be of any map, and of any file of OpenSCENARIO, below its folder.
    """
    folder, found, waiting = answer.parent, set[Path](), [answer]
    while waiting:
        for path in _named(waiting.pop(), folder):
            if path not in found and path != answer:
                found.add(path)
                waiting.append(path)
    return found


def _named(path: Path, folder: Path) -> Iterator[Path]:
    if path.suffix.lower() == ".scenic":
        text = path.read_text(encoding="utf-8", errors="replace")
        names = [one[2] for one in _QUOTED.finditer(text)]
        computed = text.count(".xodr") > len(names) or any("{" in name for name in names)
        yield from _everything(folder, ".xodr") if computed else _there(path, names, folder)
    elif path.suffix.lower() == ".xosc":
        try:
            root = read_xml(path)
        except ScenarioError:
            return  # which refuses it by itself
        names = [one.attributes.get(_NAMED[one.tag], "") for one in root.walk() if one.tag in _NAMED]
        computed = any("$" in name for name in names)
        yield from _everything(folder, ".xodr", ".xosc") if computed else _there(path, names, folder)


def _everything(folder: Path, *suffixes: str) -> Iterator[Path]:
    return (one for one in folder.rglob("*") if one.suffix.lower() in suffixes and one.is_file())


def _there(path: Path, names: list[str], folder: Path) -> Iterator[Path]:
    """Files of such names from a file's folder: a map by its name alone, and those of OpenSCENARIO in a folder."""
    for name in names:
        for one in (name, f"{name}.xodr"):
            where = relative(path, one, folder)
            if where is not None and where.is_dir():
                yield from sorted(where.glob("*.xosc"))
            elif where is not None and where.is_file():
                yield where
