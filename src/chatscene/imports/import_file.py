"""A scenario of another tool's format, as a program that runs here like any of a user."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from chatscene.errors import ForeignCodeRefused, ScenarioError, SettingsError
from chatscene.files.atomic import write_whole
from chatscene.imports.openscenario import Imported, read_openscenario
from chatscene.imports.stranger_xml import read_xml
from chatscene.imports.variants import Variants, variants_of
from chatscene.imports.written import written
from chatscene.imports.written_story import StoryProgram, written_story
from chatscene.search.generators.foreign import foreign_program

MOST_PROGRAMS = 100  # written at once
_TOLD = 3  # parameters named in a note


@dataclass(frozen=True, slots=True, kw_only=True)
class ImportedScenario:
    """What an import wrote.

    Attributes:
        program: The Scenic program; of several variants the first.
        map_path: The map that it lies on.
        notes: What was taken otherwise than it is written, or left to others, each with its line.
        programs: All programs, one for each variant that was asked for.
    """

    program: Path
    map_path: Path
    notes: tuple[str, ...]
    programs: tuple[Path, ...] = ()

    @property
    def command(self) -> str:
        """How it is run."""
        return f"chatscene run --program {self.program} --map {self.map_path}"

    def __str__(self) -> str:
        """A line per note, and how it is run."""
        more = f" and {len(self.programs) - 1} more" if len(self.programs) > 1 else ""
        return "\n".join((*self.notes, f"{self.program}{more}: run it with {self.command}"))


def import_scenario(
    path: Path,
    *,
    out: Path | None = None,
    map_name: str | None = None,
    ego: str | None = None,
    variant: int | None = None,
    within: Path | None = None,
) -> ImportedScenario:
    """Write a scenario as a Scenic program; nothing of it is run.

    A file of parameter values for a scenario gives a program for each of its variants, with a number behind its name.

    Args:
        path: An ``.xosc`` file, OpenSCENARIO XML: a scenario, or parameter values for one.
        out: The ``.scenic`` file, a new one; None for one beside it with its name.
        map_name: A packaged map or an ``.xodr`` file; None for the one that the file names by a path from its folder.
        ego: What the file calls the ego; None where that is told by the file.
        variant: The number of one variant, from 1; None for all of them.
        within: The folder in which catalogs, scenario and map lie, if they may lie nowhere else.

    Raises:
        ScenarioError: It cannot be read, or says what cannot be said here; the message names each element and its line.
        MapError: The map is not there, or is broken.
        SettingsError: A program is there already, or there is no such variant.
    """
    out = out or path.with_suffix(".scenic")
    if out.suffix != ".scenic":
        raise SettingsError(f"a program's name ends in .scenic, and {str(out)!r} does not")
    found = variants_of(read_xml(path), path, within)
    if found is None:
        if variant is not None:
            raise SettingsError(f"{path} is one scenario and has no variants; leave --variant away")
        read = read_openscenario(path, map_name, ego=ego, within=within)
        return ImportedScenario(
            program=out, map_path=read.map_path, notes=read.notes, programs=(_written(read, path, out),)
        )
    if variant is None and found.count > MOST_PROGRAMS:
        found = found.searched()
    chosen = _chosen(found, variant, path)
    programs: list[Path] = []
    notes: dict[str, None] = dict.fromkeys(found.notes)
    read = None
    for number, values in chosen.items():
        where = out if len(chosen) == 1 else out.with_name(f"{out.stem}-{number}.scenic")
        read = read_openscenario(found.scenario, map_name, ego=ego, told=values, spans=found.spans, within=within)
        programs.append(_written(read, path, where, checked=bool(programs)))
        notes.update(dict.fromkeys(read.notes))
    assert read is not None
    told = f"{found.count} variants of {found.scenario.name}"
    if len(chosen) == 1:
        ((number, values),) = chosen.items()
        told = f"variant {number} of {found.count} of {found.scenario.name}: {_said(values)}"
    return ImportedScenario(program=programs[0], map_path=read.map_path, notes=(told, *notes), programs=tuple(programs))


def _chosen(found: Variants, variant: int | None, path: Path) -> dict[int, Mapping[str, str]]:
    if variant is None:
        if found.count > MOST_PROGRAMS:
            raise SettingsError(f"{path} has {found.count} variants, too many programs; choose one with --variant N")
        return {number: found.number(number) for number in range(1, found.count + 1)}
    if variant > found.count:
        raise SettingsError(f"{path} has variants 1 to {found.count}, and no {variant}")
    return {variant: found.number(variant)}


def _said(values: Mapping[str, str]) -> str:
    told = [f"{name} = {value}" for name, value in values.items()]
    return ", ".join(told[:_TOLD]) + (f" and {len(told) - _TOLD} more" if len(told) > _TOLD else "")


def _written(read: Imported, path: Path, out: Path, *, checked: bool = False) -> Path:
    """Write a program.

    Args:
        read: What was read.
        path: Of what it is made.
        out: Where to.
        checked: Whether one that differs from it in numbers alone was found to be a program already.

    Raises:
        ScenarioError: It is more than a program of a user's may be.
        SettingsError: It is there already, or cannot be written.
    """
    if out.exists():
        raise SettingsError(f"{out} is there already; delete it, or give another name with --out")
    board = read.board
    text = written_story(board, path.name) if isinstance(board, StoryProgram) else written(board, path.name)
    try:
        if not checked:
            foreign_program(out.stem, text)
    except ForeignCodeRefused as error:
        raise ScenarioError(f"{path} is more than a program of a user's may be: {error}; cut it down") from error
    try:
        write_whole(out, text.encode())
    except OSError as error:
        raise SettingsError(f"cannot write {out}: {error.strerror}") from error
    return out
