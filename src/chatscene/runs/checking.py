"""Whether a run folder is as it was left: which files are damaged, missing, or were added."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from chatscene.errors import RunError
from chatscene.runs.blocks import damaged_parts
from chatscene.runs.digests import CHANGED, MISSING, damage, is_drawn
from chatscene.runs.record import Record
from chatscene.runs.workspace import RECORD, Workspace, inside, read_guarded


@dataclass(frozen=True, slots=True, kw_only=True)
class Condition:
    """What became of a run folder since it was written.

    Attributes:
        damaged: What is wrong, by the path of the file in the folder.
        added: Files that nobody wrote who worked on the run; they change nothing.
        unknown: Why nothing can be said of it, or of its blocks; empty if all of it was checked.
    """

    folder: Path
    damaged: Mapping[str, str]
    missing: tuple[str, ...] = ()
    added: tuple[str, ...] = ()
    unknown: str = ""

    @property
    def whole(self) -> bool:
        """Whether everything that was written is there and unchanged."""
        return not (self.damaged or self.missing or self.unknown)

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        return {
            "folder": str(self.folder),
            "whole": self.whole,
            "damaged": dict(self.damaged),
            "missing": list(self.missing),
            "added": list(self.added),
            "unknown": self.unknown,
        }

    def in_words(self) -> str:
        """A line for each file that is not as it was left, and one for the folder."""
        lines = [f"damaged  {name}: {reason}" for name, reason in self.damaged.items()]
        lines += [f"missing  {name}{_REMADE if is_drawn(name) else ''}" for name in self.missing]
        lines += [f"added    {name}" for name in self.added]
        verdict = "whole" if self.whole else self.unknown or "not as it was written"
        return "\n".join([*lines, f"{self.folder}: {verdict}"])


_REMADE = "; chatscene resume makes it again"


def check(folder: Path) -> Condition:
    """Compare every file of a folder with what is known of it; the folders in it with a record of their own as well.

    Of finished work that is a digest of each file; of an unfinished run, what its finished blocks say of themselves.

    Raises:
        RunError: There is no record in the folder.
    """
    own = _check(folder)
    inner = {name: check(folder / name) for name in inside(folder)}
    damaged = dict(own.damaged)
    for name, one in inner.items():
        damaged |= {f"{name}/{file}": why for file, why in one.damaged.items()}
    added = [file for file in own.added if not any(Path(file).is_relative_to(name) for name in inner)]
    return Condition(
        folder=folder,
        damaged=damaged,
        missing=(*own.missing, *(f"{name}/{file}" for name, one in inner.items() for file in one.missing)),
        added=(*added, *(f"{name}/{file}" for name, one in inner.items() for file in one.added)),
        unknown=next((one.unknown for one in (own, *inner.values()) if one.unknown), ""),
    )


def _check(folder: Path) -> Condition:
    """The condition of a folder but for those in it."""
    run = Workspace(folder)
    try:
        record, as_written = read_guarded(run)
    except RunError as error:
        if not run.file(RECORD).is_file():
            raise
        return Condition(folder=folder, damaged={RECORD: str(error)}, unknown="its record cannot be read")
    damaged = {} if as_written else {RECORD: CHANGED}
    gone = tuple(f"{name}/{RECORD}" for name in record.inside if not (folder / name / RECORD).is_file())
    if not record.files:
        found = {one.file.relative_to(folder).as_posix(): one.why for one in damaged_parts(run)}
        damaged |= {name: why for name, why in found.items() if why != MISSING}
        missing = (*gone, *(name for name in found if name not in damaged))
        return Condition(folder=folder, damaged=damaged, missing=missing)
    wrong = dict(damage(folder, record.files))
    damaged |= {name: CHANGED + (_REMADE if is_drawn(name) else "") for name, how in wrong.items() if how == "damaged"}
    return Condition(
        folder=folder,
        damaged=damaged,
        missing=(*gone, *(name for name, how in wrong.items() if how == "missing")),
        added=_added(folder, record),
    )


def _added(folder: Path, record: Record) -> tuple[str, ...]:
    names = (path.relative_to(folder).as_posix() for path in sorted(folder.rglob("*")) if path.is_file())
    return tuple(name for name in names if name != RECORD and name not in record.files)
