"""The map that a scenario of OpenSCENARIO XML names."""

from __future__ import annotations

import os
import re
import shlex
from pathlib import Path

from chatscene.errors import ScenarioError
from chatscene.imports.catalogs import lies_within, relative
from chatscene.imports.given import Given, Refused
from chatscene.imports.stranger_xml import Element
from chatscene.maps.network import PACKAGED, check_opendrive, resolve_map

_ABSOLUTE = re.compile(r"/|[A-Za-z]:/")


def map_of(root: Element, path: Path, given: Given, map_name: str | None) -> Path:
    """The map of a scenario: the one that is asked for, else the one that it names by a path from its own folder.

    Raises:
        ScenarioError: It names none, or one that does not lie there.
        MapError: The map is broken.
    """
    if map_name is not None:
        return resolve_map(map_name)
    logic = root.find("RoadNetwork", "LogicFile")
    try:
        named = given.text(logic, "filepath", "").replace("\\", "/") if logic else ""
    except Refused as reason:
        raise ScenarioError(f"{path}: {reason}; name the map with --map") from reason
    if not named:
        raise ScenarioError(f"{path} names no map; name one with --map")
    if re.fullmatch(r"\w+", named):  # as CARLA's towns are named
        if named in PACKAGED and not (path.parent / f"{named}.xodr").is_file():
            return PACKAGED[named]
        named += ".xodr"
    if not named.endswith(".xodr"):
        raise ScenarioError(f"{path}: its map {named[:60]!r} is no .xodr file; name one with --map")
    if _ABSOLUTE.match(named):
        beside = path.parent / Path(named).name
        if os.path.normpath(Path.cwd() / named) != os.path.normpath(Path.cwd() / beside):
            raise ScenarioError(
                f"{path}: its map is named by a whole path, and none but one from the file's own folder is opened; "
                f"name it with --map {shlex.quote(named[:200])}"
            )
        named = beside.name
    where = relative(path, named, given.within)
    plain = Path(os.path.normpath(where or path.parent / named))
    if where is None or not lies_within(plain, given.within):
        raise ScenarioError(f"{path}: its map {named[:60]!r} lies where nothing is opened; name one with --map")
    return _checked(where, plain, path)


def _checked(where: Path, plain: Path, path: Path) -> Path:
    where = plain if plain.is_file() or not where.is_file() else where  # links may lead up another way
    if where.is_file():
        check_opendrive(where)
        return where
    raise ScenarioError(
        f"{path}: its map {str(where)[-200:]!r} does not lie there; put it there, or name one with --map"
    )
