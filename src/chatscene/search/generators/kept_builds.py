"""Programs that were built of situations, kept so that who drives one again need not build and rehearse it anew.

A kept program is what the code that is installed made of the same words before; it lies where nobody but this user can
write, sealed. Who builds for the first time takes none.
"""

from __future__ import annotations

import hashlib
import json
import os
import sys
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import asdict
from functools import cache
from pathlib import Path
from typing import Any

from chatscene.files.caches import cache_folder, installed, keep, keep_latest, kept, only_mine, sealed
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import ParameterRange

PROGRAMS = 256  # that are kept, some 10 kB each
_STATED = ("scenario_id", "source", "snippet_ids", "model", "as_written", "own")
_RESTS_ON = ("numpy", "scenic", "scipy", "shapely")


def keep_program(program: ScenicProgram, *made_of: str) -> None:
    """Keep a program for the next process."""
    content = json.dumps({**{name: getattr(program, name) for name in _STATED}, "parameters": _plain(program)})
    if (folder := only_mine(cache_folder("builds"))) is not None and _program(content) == program:
        keep(folder / _name(made_of), sealed(content.encode()), lasting=False)
        keep_latest(folder, PROGRAMS)


def kept_program(*made_of: str) -> ScenicProgram | None:
    """A program that was built of the same by the same code; None where there is none that is whole."""
    folder = only_mine(cache_folder("builds"))
    content = None if folder is None else kept(folder / _name(made_of))
    return None if content is None else _program(content.decode())


def _plain(program: ScenicProgram) -> list[dict[str, object]]:
    return [asdict(one) for one in program.parameters]


def _program(content: str) -> ScenicProgram:
    told: dict[str, Any] = json.loads(content)
    parameters = tuple(ParameterRange(**one) for one in told.pop("parameters"))
    snippets = tuple(told.pop("snippet_ids"))
    return ScenicProgram(**told, snippet_ids=snippets, parameters=parameters)


def _name(made_of: tuple[str, ...]) -> str:
    return hashlib.blake2b(repr(made_of).encode() + _code(), digest_size=16).hexdigest()


@cache
def _code() -> bytes:
    """What tells the installed code from another: as for compiled modules, the size and time of each of its files."""
    told = [sys.version, *(f"{name} {installed(name)}" for name in _RESTS_ON), *sorted(_files())]
    return hashlib.blake2b("\n".join(told).encode()).digest()


def _files() -> Iterator[str]:
    for folder, inner, names in os.walk(Path(__file__).parents[2]):
        inner[:] = [name for name in inner if name != "__pycache__"]
        for name in names:
            with suppress(FileNotFoundError):  # an editor's, such as a link to nothing by which it locks a file
                state = os.stat(path := os.path.join(folder, name))  # noqa: PTH116, PTH118 - of a thousand files
                yield f"{path} {state.st_size} {state.st_mtime_ns}"
