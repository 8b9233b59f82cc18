"""What callers pass, and what becomes of it: paths, names, settings."""

from __future__ import annotations

import os
import tempfile
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from chatscene.errors import SettingsError
from chatscene.settings import RetrievalSettings, VerifySettings

if TYPE_CHECKING:
    from chatscene.runs.trust import Repeated

Name = str | Path
Names = Name | Sequence[Name]


def changed(settings: Any, **given: Any) -> Any:
    """Settings with those replaced that were given."""
    return replace(settings, **{name: value for name, value in given.items() if value is not None})


def read_by(
    settings: RetrievalSettings,
    library: Name | None = None,
    embedder: str | None = None,
    language_model: str | None = None,
    reader: str | None = None,
    reading: int | None = None,
    stated: Mapping[str, object] | None = None,
) -> RetrievalSettings:
    """Settings of how a text is read, with those replaced that were given."""
    from chatscene.interpret.stated import in_text

    own = str(path_of(library)) if library else None
    facts = in_text(stated) if stated else None
    return changed(
        settings,
        library=own,
        embedder=embedder,
        language_model=language_model,
        reader=reader,
        reading=reading,
        stated=facts,
    )


def again(**named: Names) -> Repeated:
    """What the user names beside a record, by the fields of `Repeated`."""
    from chatscene.runs.trust import Repeated

    return Repeated(**{field: names_of(names) for field, names in named.items()})


def path_of(name: object) -> Path:
    """A path that a user names.

    Raises:
        SettingsError: It can be none.
    """
    if not isinstance(name, str | os.PathLike):
        raise SettingsError(f"{name!r} is not a path: give a str or a Path")
    if "\0" in str(name):
        raise SettingsError(f"{str(name)!r} is not a path: it holds a NUL character")
    return Path(name)


def folder_for(folder: Name | None) -> Path:
    """The folder that a user names, or a new temporary one."""
    return Path(tempfile.mkdtemp(prefix="chatscene-")) if folder is None else path_of(folder)


def names_of(names: Names) -> tuple[str, ...]:
    """One name, or several, as texts.

    Raises:
        SettingsError: One is none.
    """
    every: tuple[object, ...] = tuple(names) if isinstance(names, Iterable) else (names,)
    return tuple(map(name_of, (names,) if isinstance(names, str) else every))


def name_of(given: object) -> str:
    """A name that a user gives, as a text.

    Raises:
        SettingsError: It is none.
    """
    if not isinstance(given, str | Path):
        raise SettingsError(
            f"{given!r} is no name: give a name, a file or package.module:factory; only `branch` and `scene` take an "
            "ego object"
        )
    return str(given)


def judging(
    *,
    trust: bool,
    map_name: Name | None,
    ego: Name | None,
    within: Name | None,
    **given: Any,
) -> VerifySettings:
    """How a program, a run or a recording is driven or read to be judged, from what was given.

    Args:
        trust: Whether a program may use all of Scenic and Python, in this process.
        map_name: The map of a program, in place of the one that it names.
        ego: Who drives a program.
        within: The folder in which map and catalogs lie that a program names.
        given: Other fields of `VerifySettings`; None for what was not given.

    Raises:
        MapError: The map is none, or cannot be used.
    """
    if map_name is not None:
        from chatscene.maps.network import check_given, resolve_map

        check_given(resolve_map(str(map_name)))
    return changed(
        VerifySettings(trust=trust),
        map_name=None if map_name is None else str(map_name),
        ego=None if ego is None else name_of(ego),
        within=None if within is None else str(path_of(within)),
        **given,
    )
