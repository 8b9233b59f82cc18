"""The code that `dataclasses` writes for a class, compiled once for all processes of a user.

Python's module writes some six functions of each class as text and compiles them whenever a process makes the class: a
tenth of what a short command takes. Text that was compiled before is taken from a cache, which is read whole: it loses
what no class has any more, once that is as much as what this process needs.
"""

from __future__ import annotations

import atexit
import builtins
import dataclasses
import marshal
import sys
from pathlib import Path
from types import CodeType
from typing import Any

from chatscene.files.caches import cache_folder, keep, kept, only_mine, sealed


def keep_class_code() -> None:
    """Have the classes that this process makes from now on, anybody's, take their code from the cache.

    For a process of our own alone.
    """
    if (folder := only_mine(cache_folder("code"))) is None:
        return
    path = folder / f"classes-{sys.implementation.cache_tag}-{sys.flags.optimize}"
    content = kept(path)  # `marshal` may break the interpreter with what is damaged
    known: dict[str, CodeType] = {} if content is None else marshal.loads(content)
    used: dict[str, CodeType] = {}

    def run(text: str, names: dict[str, Any] | None, found: dict[str, Any]) -> None:
        code = used[text] = used.get(text) or known.get(text) or compile(text, "<string>", "exec")
        builtins.exec(code, names, found)  # noqa: S102 - as the module does

    # What the module finds under this name before Python's own.
    setattr(dataclasses, "exec", run)  # noqa: B010 - it has none so far
    atexit.register(lambda: _write(path, used, known) if used.keys() - known.keys() else None)


def _write(path: Path, used: dict[str, CodeType], known: dict[str, CodeType]) -> None:
    """Keep what a process needed, beside what was known if most of that is still needed."""
    every = known | used
    keep(path, sealed(marshal.dumps(every if len(every) <= 2 * len(used) else used)), lasting=False)
