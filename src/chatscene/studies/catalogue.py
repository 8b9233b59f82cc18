"""Catalogues of traffic situations: the packaged ones, and a user's own.

A catalogue is a TOML file with a table ``[[entry]]`` for each situation, which has a ``name`` and either a ``sentence``
or, where none can say it, a ``reason``; above them it may have a ``title``. Of the packaged ones the names are those of
the catalogue that is meant, and the sentences ours.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Mapping
from importlib.resources import files
from pathlib import Path
from typing import Any

from chatscene.errors import SettingsError, no_such
from chatscene.files.bounded import check_file
from chatscene.read.reader import LONGEST
from chatscene.terms.coverage import Catalogue, Entry

PACKAGED = ("nhtsa", "ncap", "r157", "iso34502", "leaderboard", "challenge")
_KEYS = ("name", "sentence", "reason")
_LIKE_THIS = 'such as:\n\n[[entry]]\nname = "lead vehicle stopped"\nsentence = "A car stands still in our lane ahead."'


def load_catalogue(name: str) -> Catalogue:
    """A packaged catalogue by its name, a user's own by its file, or that of a folder that was imported.

    Raises:
        SettingsError: There is none, or its file is not a catalogue; the message says what to change.
        RunError: It is a folder that was imported, and changed since.
    """
    if name in PACKAGED:
        text = files("chatscene.studies").joinpath("catalogues", f"{name}.toml").read_text(encoding="utf-8")
        return _parsed(f"{name}.toml", text)
    path = Path(name)
    if path.is_dir() and path.suffix != ".toml":
        from chatscene.studies.imported_entries import catalogue_of

        return catalogue_of(path)
    if path.suffix != ".toml":
        others = "a file of your own that ends in .toml, or a folder that was imported"
        raise SettingsError(f"{no_such('catalogue', name, PACKAGED)}, {others}")
    try:
        check_file(path)
        return _parsed(name, path.read_text(encoding="utf-8-sig"))
    except FileNotFoundError as error:
        raise SettingsError(f"there is no file {name}; the packaged catalogues are {', '.join(PACKAGED)}") from error
    except (OSError, ValueError) as error:
        raise SettingsError(f"the catalogue {name} cannot be read: {error}") from error


def slug(name: str) -> str:
    """A name for a folder; two entries of a catalogue never share one."""
    return re.sub(r"[^a-z0-9]+", "-", name.lower()).strip("-")


def _parsed(file: str, text: str) -> Catalogue:
    try:
        content = tomllib.loads(text)
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise SettingsError(f"{file} is not TOML: {error}") from error
    _known(file, content, ("title", "entry"))
    title, tables = content.get("title", Path(file).stem), content.get("entry", [])
    if not isinstance(title, str):
        raise SettingsError(f"{file}: title must be text, not {title!r}")
    if not isinstance(tables, list) or not all(isinstance(table, dict) for table in tables):
        raise SettingsError(f"{file}: an entry is a table under [[entry]], {_LIKE_THIS}")
    if not tables:
        raise SettingsError(f"{file} has no entry; write one, {_LIKE_THIS}")
    entries: dict[str, Entry] = {}
    for number, table in enumerate(tables, 1):
        entry = _entry(file, number, table)
        if (before := entries.get(slug(entry.name))) is not None:
            alike = "" if before.name == entry.name else f" and {before.name!r}, which differ in signs only"
            raise SettingsError(f"{file} has two entries {entry.name!r}{alike}; give one of them another name")
        entries[slug(entry.name)] = entry
    return Catalogue(name=Path(file).stem, title=title, entries=tuple(entries.values()))


def _entry(file: str, number: int, table: Mapping[str, Any]) -> Entry:
    name = table.get("name")
    where = f"{file}, entry {number}" + (f" ({name!r})" if isinstance(name, str) and name.strip() else "")
    _known(where, table, _KEYS)
    for key, value in table.items():
        if not isinstance(value, str):
            raise SettingsError(f"{where}: {key} must be text, not {value!r}")
    given = {key: " ".join(value.split()) for key, value in table.items()}
    if not slug(given.get("name", "")):
        raise SettingsError(f"{where} has no name; a name has letters or digits")
    if not given.get("sentence") and not given.get("reason"):
        raise SettingsError(f"{where} has no sentence; write one, or a reason why there can be none")
    if given.get("sentence") and given.get("reason"):
        raise SettingsError(f"{where} has a sentence and a reason why it has none; remove one of them")
    if len(given.get("sentence", "")) > LONGEST:
        raise SettingsError(f"{where}: the sentence has more than {LONGEST} characters; describe one situation")
    return Entry(**given)


def _known(where: str, table: Mapping[str, Any], keys: tuple[str, ...]) -> None:
    for key in table:
        if key not in keys:
            raise SettingsError(f"{where}: {no_such('key', key, keys)}")
