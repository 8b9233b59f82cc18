"""A folder of scenarios of another tool's format, as a folder of programs: what each file became, or why it did not."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from chatscene.errors import MapError, ScenarioError, SettingsError
from chatscene.files.alone import alone_in
from chatscene.imports.collection import MOST_ABOUT, FileRecord, map_named, write_record
from chatscene.imports.import_file import import_scenario
from chatscene.imports.names import Apart
from chatscene.imports.stranger_xml import read_xml
from chatscene.maps.network import name_of


@dataclass(frozen=True, slots=True, kw_only=True)
class ImportedFile:
    """What a file of the folder became.

    Attributes:
        without: Why variants of it became none, where others did.
        catalog: Whether it is a catalog, which others refer to.
    """

    file: Path
    about: str = ""
    programs: tuple[Path, ...] = ()
    maps: tuple[Path, ...] = ()
    notes: tuple[str, ...] = ()
    refused: str = ""
    without: tuple[str, ...] = ()
    catalog: bool = False

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        return {
            "file": str(self.file),
            "became": "catalog" if self.catalog else "refused" if self.refused else "programs",
            "programs": [str(one) for one in self.programs],
            "maps": list(map(name_of, self.maps)),
            "notes": list(self.notes),
            "refused": self.refused or None,
            "without": list(self.without),
        }

    def __str__(self) -> str:
        """A row of the table."""
        if self.catalog:
            return f"{self.file}: a catalog, read with the files that name it"
        if self.refused:
            return f"{self.file}: REFUSED: {_first(self.refused)}"
        many = f" and {len(self.programs) - 1} more" * (len(self.programs) > 1)
        if self.without:
            many += f", WITHOUT {len(self.without)} variant{'s' * (len(self.without) != 1)}: {_first(self.without[0])}"
        noted = f", {len(self.notes)} note{'s' * (len(self.notes) != 1)}" * bool(self.notes)
        return f"{self.file}: {self.programs[0]}{many} on map {name_of(self.maps[0])}{noted}"


def _first(refused: str) -> str:
    """The first reason of a refusal, and how many there are besides."""
    first, *more = refused.splitlines()
    reasons = [line.strip() for line in more]
    return f"{reasons[0]}{f' and {len(reasons) - 1} more' * (len(reasons) > 1)}" if reasons else first


@dataclass(frozen=True, slots=True, kw_only=True)
class ImportedFolder:
    """What the files of a folder became."""

    out: Path
    files: tuple[ImportedFile, ...]

    def __str__(self) -> str:
        """A row for each file, and how many there are of each kind."""
        count = Counter(one.as_dict()["became"] for one in self.files)
        programs = sum(len(one.programs) for one in self.files)
        end = (
            f"{len(self.files)} files: {count['programs']} became {programs} programs in {self.out}, "
            f"{count['refused']} were refused, {count['catalog']} are catalogs"
        )
        return "\n".join((*map(str, self.files), end))


def import_folder(
    folder: Path, out: Path, *, map_name: str | None = None, ego: str | None = None, within: Path | None = None
) -> ImportedFolder:
    """Write each scenario below a folder as a Scenic program below another, and a record; nothing of them is run.

    Raises:
        SettingsError: There is no such file, or the folder of programs has something in it.
        RunError: The record cannot be written.
    """
    files = sorted(one for one in folder.rglob("*") if one.suffix.lower() == ".xosc" and one.is_file())
    if not files:
        raise SettingsError(f"{folder} holds no .xosc file, and neither does any folder in it")
    if out.exists() and (not out.is_dir() or any(out.iterdir())):
        raise SettingsError(
            f"{out} exists and is not an empty folder; give another with --out, or delete it, if an import was "
            "interrupted there"
        )
    programs = _programs(folder, files)
    rows = list[ImportedFile]()
    with alone_in(out):
        for path, (named, program) in zip(files, programs.items(), strict=True):
            rows.append(_row(path, named, out / program, out, map_name, ego, within))
        write_record(out, [_recorded(one, out) for one in rows], [path for one in rows for path in one.maps])
    return ImportedFolder(out=out, files=tuple(rows))


def _programs(folder: Path, files: Sequence[Path]) -> dict[Path, Path]:
    """The program of each file, by paths from both folders: no two the same, and none a variant of another."""
    apart, stems = Apart("_"), {file.relative_to(folder).with_suffix("") for file in files}
    found: dict[Path, Path] = {}
    for file in files:
        named = file.relative_to(folder)
        stem = named.with_suffix("")
        numbered = re.compile(rf"{re.escape(stem.name)}-\d+")
        taken = any(numbered.fullmatch(other.name) and other.parent == stem.parent for other in stems)
        behind = "_" if taken and _tells_variants(file) else ""
        found[named] = Path(f"{apart.of(f'{stem}{behind}')}.scenic")
    return found


def _tells_variants(file: Path) -> bool:
    """Whether a file tells parameter values, and so becomes programs with a number behind its name."""
    try:
        return b"ParameterValueDistribution" in file.read_bytes()
    except OSError:  # which its row tells
        return False


def _recorded(row: ImportedFile, out: Path) -> FileRecord:
    return FileRecord(
        file=row.file.as_posix(),
        about=row.about,
        programs=[one.as_posix() for one in row.programs],
        maps=[map_named(out, one) for one in row.maps],
        refused=row.refused,
    )


def _row(
    path: Path, named: Path, program: Path, out: Path, map_name: str | None, ego: str | None, within: Path | None
) -> ImportedFile:
    about = ""
    try:
        root = read_xml(path)
        header = root.find("FileHeader")
        about = " ".join((header.attributes.get("description", "") if header else "").split())[:MOST_ABOUT]
        if root.find("Catalog") is not None:
            return ImportedFile(file=named, catalog=True)
        done = import_scenario(path, out=program, map_name=map_name, ego=ego, within=within, partly=True)
    except (ScenarioError, MapError, SettingsError) as error:
        return ImportedFile(file=named, about=about, refused=str(error))
    return ImportedFile(
        file=named,
        about=about,
        programs=tuple(one.relative_to(out) for one in done.programs),
        maps=done.maps,
        notes=done.notes,
        without=done.refused,
    )
