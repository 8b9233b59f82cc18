"""A scenario of another tool's format, as a program that runs here like any of a user."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from chatscene.errors import ForeignCodeRefused, ScenarioError, SettingsError
from chatscene.files.atomic import write_whole
from chatscene.imports.openscenario import read_openscenario
from chatscene.imports.written import written
from chatscene.search.generators.foreign import foreign_program


@dataclass(frozen=True, slots=True, kw_only=True)
class ImportedScenario:
    """What an import wrote.

    Attributes:
        program: The Scenic program.
        map_path: The map that it lies on.
        notes: What was taken otherwise than it is written, or left to others, each with its line.
    """

    program: Path
    map_path: Path
    notes: tuple[str, ...]

    @property
    def command(self) -> str:
        """How it is run."""
        return f"chatscene run --program {self.program} --map {self.map_path}"

    def __str__(self) -> str:
        """A line per note, and how it is run."""
        return "\n".join((*self.notes, f"{self.program}: run it with {self.command}"))


def import_scenario(path: Path, *, out: Path | None = None, map_name: str | None = None) -> ImportedScenario:
    """Write a scenario as a Scenic program; nothing of it is run.

    Args:
        path: An ``.xosc`` file, OpenSCENARIO XML.
        out: The ``.scenic`` file, a new one; None for one beside it with its name.
        map_name: A packaged map or an ``.xodr`` file; None for the one beside the file that it names.

    Raises:
        ScenarioError: It cannot be read, or says what cannot be said here; the message names each element and its line.
        MapError: The map is not there, or is broken.
        SettingsError: The program is there already.
    """
    out = out or path.with_suffix(".scenic")
    if out.suffix != ".scenic":
        raise SettingsError(f"a program's name ends in .scenic, and {str(out)!r} does not")
    if out.exists():
        raise SettingsError(f"{out} is there already; delete it, or give another name with --out")
    found = read_openscenario(path, map_name)
    text = written(found.board, path.name)
    try:
        foreign_program(out.stem, text)
    except ForeignCodeRefused as error:
        raise ScenarioError(f"{path} is more than a program of a user's may be: {error}; cut it down") from error
    try:
        write_whole(out, text.encode())
    except OSError as error:
        raise SettingsError(f"cannot write {out}: {error.strerror}") from error
    return ImportedScenario(program=out, map_path=found.map_path, notes=found.notes)
