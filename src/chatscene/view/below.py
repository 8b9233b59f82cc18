"""Runs below a folder, and the pages of them, by name: no name leads out of it."""

from __future__ import annotations

from pathlib import Path

from chatscene.errors import RunError
from chatscene.runs.workspace import RECORD

REPORT, COVERAGE = "report.html", "coverage.html"


def run_below(folder: Path, name: str) -> Path:
    """The folder of a run.

    Raises:
        RunError: There is none of that name.
    """
    path = _below(folder, name)
    if path and (path / RECORD).is_file():
        return path
    raise RunError(f"there is no run {name!r} below {folder}")


def page_below(folder: Path, path: str) -> Path:
    """The page of a run, of an evaluation or of catalogues.

    Raises:
        RunError: There is none of that name.
    """
    name, _, file = path.rpartition("/")
    where = _below(folder, name) if file == COVERAGE else run_below(folder, name)
    page = where / file if where and file in (REPORT, COVERAGE) else None
    if page and page.is_file() and not page.is_symlink():
        return page
    raise RunError(f"{name} has no report")


def _below(folder: Path, name: str) -> Path | None:
    root = folder.resolve()
    try:
        path = (root / name).resolve()
        if name == root.name and not path.exists():
            path = root
        return path if path.is_relative_to(root) and path.is_dir() else None
    except (OSError, ValueError):  # no path at all: too long, or with a null byte
        return None
