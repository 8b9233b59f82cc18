"""A stranger's folder: a module for every name of Python and of an installed package, each of which leaves a mark."""

from __future__ import annotations

import sys
from dataclasses import dataclass
from importlib.metadata import packages_distributions
from pathlib import Path

NAMES = sorted(
    name for name in {*sys.stdlib_module_names, *packages_distributions(), "chatscene"} if name.isidentifier()
)


@dataclass(frozen=True, slots=True)
class Strange:
    """Such a folder.

    Attributes:
        path: Where it is.
        noted: Where a module leaves its mark.
    """

    path: Path
    noted: Path

    def imported(self) -> list[str]:
        """The names of its modules that were imported, sorted."""
        return sorted(mark.name for mark in self.noted.iterdir())


def strange(below: Path) -> Strange:
    """A new one below another folder."""
    made = Strange(below / "strange", below / "marks")
    made.path.mkdir()
    made.noted.mkdir()
    for name in NAMES:
        (made.path / f"{name}.py").write_text(f"open({str(made.noted / name)!r}, 'w').close()\n")
    return made
