"""What may be judged, by what it is: each kind has a row, and adding one is a row."""

from __future__ import annotations

import os
from collections.abc import Callable, Sequence
from pathlib import Path

from chatscene.errors import SettingsError
from chatscene.files.bounded import is_there
from chatscene.imports.osi_trace import read_trace
from chatscene.imports.recording import Poses, recording
from chatscene.imports.tracks_table import read_table
from chatscene.runs.trust import Repeated
from chatscene.settings import VerifySettings
from chatscene.verdict.programs import watch_openscenario, watch_program
from chatscene.verdict.recorded import watch_recording
from chatscene.verdict.watched import Watching


def watching(what: Path, settings: VerifySettings, repeated: Repeated | None = None) -> Watching:
    """The drives of what is to be judged.

    Raises:
        SettingsError: There is no such file, or it is of no kind that is known.
        ChatSceneError: It cannot be read or driven.
    """
    check_there(what)
    kind = what.suffix.lower() if not what.is_dir() else ""
    if settings.given and kind not in (".scenic", ".xosc"):
        raise SettingsError(f"parameters are given to a program or to a file of OpenSCENARIO, and {what} is neither")
    if settings.as_written and kind not in (".scenic", ".xosc"):
        raise SettingsError(
            f"--as-written is for a program or a file of OpenSCENARIO, and {what} is neither; leave it out"
        )
    if settings.variant and kind != ".xosc":
        raise SettingsError(f"variants are of a file of OpenSCENARIO, and {what} is none")
    if what.is_dir() and what.suffix.lower() in KINDS and not (what / "run.json").exists():
        raise SettingsError(f"{what} is a folder; give a file that ends in {what.suffix}, or a run folder")
    if what.is_dir():
        from chatscene.verdict.runs_of_ours import watch_run

        if settings.ego or settings.map_name:
            raise SettingsError(f"{what} is a run, which was driven already: leave out --ego and --map")
        return watch_run(what, settings, repeated)
    if (watch := KINDS.get(kind)) is None:
        ends = f"the file '{what}' ends in {what.suffix!r}" if what.suffix else f"the file '{what}' has no ending"
        raise SettingsError(f"{ends}, which is not a kind that can be read: {', '.join(KINDS)}")
    return watch(what, settings)


def check_there(what: Path) -> None:
    """Hold a path to there being something.

    Raises:
        SettingsError: There is nothing.
    """
    if not (is_there(what) or os.path.isdir(what)):  # noqa: PTH112 - Path.is_dir() raises for what is too long
        raise SettingsError(
            f"no file or run folder '{what}'; give a run folder, or a file that ends in {', '.join(KINDS)}"
        )


def watch_table(path: Path, settings: VerifySettings) -> Watching:
    """A drive that stands in a table.

    Raises:
        ScenarioError: It cannot be read.
    """
    return _recorded(read_table(path), "table of tracks", path, settings)


def watch_trace(path: Path, settings: VerifySettings) -> Watching:
    """A drive that stands in a trace of OSI.

    Raises:
        ScenarioError: It cannot be read.
        MissingExtra: The package of the format is not installed.
    """
    return _recorded(read_trace(path), "trace of OSI", path, settings)


def _recorded(poses: Sequence[Poses], kind: str, path: Path, settings: VerifySettings) -> Watching:
    found = recording(poses, path, settings.ego_id)
    return Watching(kind=kind, drives=(watch_recording(found, path.stem),), notes=found.notes)


KINDS: dict[str, Callable[[Path, VerifySettings], Watching]] = {
    ".scenic": watch_program,
    ".xosc": watch_openscenario,
    ".csv": watch_table,
    ".mcap": watch_trace,
}
"""By how its name ends."""
