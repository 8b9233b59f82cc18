"""What an import of a folder leaves in it: a record of what each file became, by which its programs find their maps."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field, ValidationError, model_validator

from chatscene.errors import MapError, RunError
from chatscene.maps.carla_towns import is_town
from chatscene.maps.network import is_named, name_of, resolve_map
from chatscene.runs.atomic import read_json, write_json
from chatscene.runs.digests import digest_of
from chatscene.search.generators.foreign import ForeignProgram

RECORD = "imported.json"
MOST_ABOUT = 300  # characters of what a file says of itself


class _Frozen(BaseModel):
    model_config = ConfigDict(frozen=True, extra="ignore")


class FileRecord(_Frozen):
    """What a file became.

    Attributes:
        file: Its path from the folder that was imported.
        programs: The programs that it became, by paths from the folder of the record.
        maps: The map of each: a packaged one or a town by its name, any other by its path from that folder.
        refused: Why it became none; empty where it became one, or is a catalog.
    """

    file: str
    about: Annotated[str, Field(max_length=MOST_ABOUT)] = ""
    programs: list[str] = []
    maps: list[str] = []
    refused: str = ""

    @model_validator(mode="after")
    def _each_on_its_map(self) -> FileRecord:
        if len(self.programs) != len(self.maps):
            raise ValueError(f"{self.file} became {len(self.programs)} programs on {len(self.maps)} maps")
        return self


class _Record(_Frozen):
    """The record, as its file has it.

    Attributes:
        schema_version: What the fields mean; a record without it is of the first version.
        files: What each file became, in the order of their paths.
        map_digests: The digest of each map, by the name that the files' records give it.
    """

    schema_version: Literal[1] = 1
    files: list[FileRecord]
    map_digests: dict[str, str] = {}


@dataclass(frozen=True, slots=True, kw_only=True)
class CollectedProgram:
    """A program of a collection."""

    name: str
    path: Path
    map_path: Path
    file: str
    about: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Collection:
    """A folder of programs that were imported."""

    folder: Path
    programs: tuple[CollectedProgram, ...]
    refused: dict[str, str]


def write_record(folder: Path, files: Sequence[FileRecord], maps: Sequence[Path]) -> None:
    """Leave the record in the folder of the programs.

    Raises:
        RunError: It cannot be written.
    """
    digests = {map_named(folder, path): digest_of(path) for path in sorted(set(maps))}
    write_json(folder / RECORD, _Record(files=list(files), map_digests=digests).model_dump())


def map_named(folder: Path, path: Path) -> str:
    """What a record in a folder calls a map."""
    name = name_of(path)
    return name if is_named(name) or is_town(name) else os.path.relpath(path.resolve(), folder.resolve())


def is_collection(folder: Path) -> bool:
    """Whether the import of a folder left its record there."""
    return (folder / RECORD).is_file()


def read_collection(folder: Path) -> Collection:
    """The programs of a folder that an import left.

    Raises:
        RunError: There is no such record, it was changed, or a program or a map is not what it was.
    """
    where, record = folder / RECORD, _record(folder)
    maps = {name: _map_at(folder, name, record) for one in record.files for name in one.maps}
    found = list[CollectedProgram]()
    for one in record.files:
        for name, map_name in zip(one.programs, one.maps, strict=True):
            path = folder / name
            if not path.resolve().is_relative_to(folder.resolve()) or not path.is_file():
                raise RunError(f"{where} names the program {name!r}, which is not in {folder}; import the folder anew")
            found.append(
                CollectedProgram(name=name, path=path, map_path=maps[map_name], file=one.file, about=one.about)
            )
    refused = {one.file: one.refused for one in record.files if one.refused}
    return Collection(folder=folder, programs=tuple(found), refused=refused)


def _record(folder: Path) -> _Record:
    where = folder / RECORD
    try:
        return _Record.model_validate(read_json(where))
    except ValidationError as error:
        first = error.errors()[0]
        at = ".".join(map(str, first["loc"]))
        raise RunError(
            f"{where} is not the record of an import that this version reads: {at}: {first['msg']}; import the"
            " folder again"
        ) from error


def map_for(own: ForeignProgram, chosen: str | None, *, shut_in: bool) -> str | None:
    """The map that a program's user names, else the one that it was imported with, where it names none itself.

    Raises:
        RunError: The map was changed.
    """
    if chosen is None and own.map_path is None and not shut_in:
        return map_beside(own.path)
    return chosen


def map_beside(program: Path) -> str | None:
    """The map of a program that lies in a folder that was imported, as ``--map`` takes it; None for any other.

    A file of that name that is no record, as it may lie in any folder above, says nothing of the program.

    Raises:
        RunError: The map was changed.
    """
    path = program.resolve()
    for folder in path.parents:
        if not is_collection(folder):
            continue
        try:
            record = _record(folder)
        except RunError:
            continue
        for one in record.files:
            for name, map_name in zip(one.programs, one.maps, strict=True):
                if folder / name == path:
                    return name_of(_map_at(folder, map_name, record))
    return None


def _map_at(folder: Path, name: str, record: _Record) -> Path:
    packaged = is_named(name) or is_town(name)
    try:
        path = resolve_map(name if packaged else os.path.normpath(folder.resolve() / name))
    except MapError as error:
        raise RunError(
            f"{folder} was imported with the map {name}, which is not there any more; put it back"
        ) from error
    if record.map_digests.get(name) != digest_of(path):
        raise RunError(f"the map {name} is not the file that {folder} was imported with; import the folder anew")
    return path
