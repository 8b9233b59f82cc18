"""Runs below a folder, by name: no name leads out of it."""

from __future__ import annotations

from pathlib import Path

from chatscene.errors import RunError
from chatscene.runs.workspace import RECORD


def run_below(folder: Path, name: str) -> Path:
    """The folder of a run.

    Args:
        folder: The folder below which it is, or which it is.
        name: Its path below that folder, or the name of that folder itself, as `chatscene.report.index` has it.

    Raises:
        RunError: There is none of that name.
    """
    root = folder.resolve()
    try:
        path = (root / name).resolve()
        if name == root.name and not path.exists():
            path = root
        if path.is_relative_to(root) and (path / RECORD).is_file():
            return path
    except (OSError, ValueError):  # no path at all: too long, or with a null byte
        pass
    raise RunError(f"there is no run {name!r} below {folder}")
