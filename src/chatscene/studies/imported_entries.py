"""A folder that was imported as a catalogue: an entry for each program, and for each file that became none."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from chatscene import runs
from chatscene.errors import ForeignCodeRefused, SettingsError
from chatscene.files.alone import UNFINISHED
from chatscene.imports.collection import CollectedProgram, is_collection, read_collection
from chatscene.maps.network import name_of, resolve_map
from chatscene.search.generators.foreign import read_foreign
from chatscene.search.generators.own_program import generator_for
from chatscene.settings import Settings
from chatscene.studies.collection import Driver
from chatscene.terms.coverage import Answer, Catalogue, Covered, Entry, Fared


def catalogue_of(folder: Path) -> Catalogue:
    """The catalogue of a folder that was imported.

    Raises:
        SettingsError: The folder was not imported.
        RunError: It was changed.
    """
    if (folder / UNFINISHED).exists():
        raise SettingsError(
            f"the import into {folder} has not come to its end; wait for it, or delete it and import again"
        )
    if not is_collection(folder):
        raise SettingsError(
            f"{folder} is no folder that was imported; import it first: chatscene import {folder} --out NEW"
        )
    found = read_collection(folder)
    programs = [
        Entry(name=one.name, sentence=one.about, program=str(one.path), map_name=name_of(one.map_path))
        for one in found.programs
    ]
    refused = [
        Entry(name=file, reason=" ".join(line.strip() for line in why.splitlines()))
        for file, why in found.refused.items()
    ]
    return Catalogue(name=folder.resolve().name, title=f"Imported into {folder}", entries=(*programs, *refused))


def covered(row: Covered, driver: Driver | None, egos: Sequence[str]) -> Covered:
    """The row of a program that was imported: whether it runs, whether its events happen, how egos fare."""
    entry = row.entry
    if driver is None:
        try:
            read_foreign(Path(entry.program), searched_with=False)
        except ForeignCodeRefused as error:
            return replace(row, answer=Answer.FAILED, reasons=(str(error),))
        return replace(row, answer=Answer.SERVED, reasons=())
    program = CollectedProgram(
        name=entry.name, path=Path(entry.program), map_path=resolve_map(entry.map_name), file="", about=entry.sentence
    )
    drives = driver(program)
    failures = {one["ego"]: one["reason"] for one in drives if one["status"] == "ego failed"}
    drives = [one for one in drives if one["ego"] not in failures]
    if failures and not drives:
        return replace(row, answer=Answer.SERVED, reasons=(), failures=failures)
    ran = [one for one in drives if one["status"] == "ran"]
    if not ran:
        return replace(row, answer=Answer.FAILED, reasons=tuple(dict.fromkeys(one["reason"] for one in drives)))
    missed = Counter(told for one in ran for told in one["unplayed"])
    missed += Counter(f"not driven: {one['reason']}" for one in drives if one["status"] != "ran")
    return replace(
        row,
        answer=Answer.SERVED,
        reasons=(),
        fared=tuple(_fared(ego, [one for one in drives if one["ego"] == ego]) for ego in egos if ego not in failures),
        failures=failures,
        missed=tuple(missed.most_common()),
    )


def _fared(ego: str, drives: Sequence[Mapping[str, Any]]) -> Fared:
    """How an ego fared in its drives; one that failed shows nothing, and a scene that cannot be placed is no drive."""
    ran = [one for one in drives if one["status"] == "ran"]
    return Fared(
        ego=ego,
        scenes=sum(one["status"] != "rejected" for one in drives),
        shown=sum(not one["unplayed"] for one in ran),
        collisions=sum(bool(one["collision"]) for one in ran),
        avoidable=sum(one["avoidable"] is True for one in ran),
    )


def asked_of(entry: Entry, settings: Settings, ego: str) -> runs.RunRecord:
    """The run of a program that was imported."""
    own = read_foreign(Path(entry.program), searched_with=False).program
    return runs.asked_run(
        program=runs.ProgramRecord(name=own.scenario_id, source=own.source),
        generator=generator_for(trusted=False, as_written=False),
        settings=settings,
        map_name=entry.map_name,
        ego=ego,
    )
