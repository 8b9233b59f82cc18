"""The map that a scenario of OpenSCENARIO XML names."""

from __future__ import annotations

import os
import re
import shlex
from pathlib import Path

from chatscene.errors import MapError, ScenarioError
from chatscene.imports.catalogs import ABSOLUTE, lies_within, relative
from chatscene.imports.given import Given, Refused
from chatscene.imports.open_ground import open_ground
from chatscene.imports.stranger_xml import Element
from chatscene.maps.carla_towns import PACKAGE, carla_town, how_to_have
from chatscene.maps.network import PACKAGED, load_network, resolve_map


class Maps:
    """Finds the map of a scenario, each once: the one that is asked for, else the one that the scenario names."""

    def __init__(self, path: Path, map_name: str | None) -> None:
        self._path, self._asked = path, map_name
        self._found: dict[str | None, Path] = {}
        self._broken: dict[str | None, MapError | ScenarioError] = {}

    def of(self, given: Given, root: Element) -> Path:
        """The map, where parameters have these values.

        Raises:
            ScenarioError: The scenario names one that does not lie there, or none, and its places are told by roads.
            MapError: The map is broken.
        """
        logic = root.find("RoadNetwork", "LogicFile")
        named = self._named(logic, given) if self._asked is None else None
        if named == "":
            given.note(root, "it names no road network; a straight road lies under its ego, with open ground about")
            return open_ground(root, given, self._path)  # wherever its ego begins
        if named in self._broken:
            raise self._broken[named]
        if named not in self._found:
            try:
                found = resolve_map(self._asked or "") if named is None else _map_at(named, self._path, given)
                load_network(found)  # whatever is the matter with the map, is no fault of a place in the file
            except (MapError, ScenarioError) as error:
                self._broken[named] = error
                raise
            self._found[named] = found
        found = self._found[named]
        if logic and named is not None and found == carla_town(found.stem):
            given.note(
                logic,
                f"the map that it names is not there; it lies on CARLA's {found.stem} of the package {PACKAGE}",
            )
        return found

    def _named(self, logic: Element | None, given: Given) -> str:
        try:
            named = given.text(logic, "filepath", "") if logic else ""
        except Refused as reason:
            raise ScenarioError(f"{self._path}: {reason}; name the map with --map") from reason
        return named.replace("\\", "/")


def _map_at(named: str, path: Path, given: Given) -> Path:
    """The map that a scenario names: a file, or CARLA's town of that name where no such file is opened."""
    try:
        return _file_at(named, path, given)
    except ScenarioError as error:
        name = Path(named).stem
        if (town := carla_town(name)) is not None:
            return town
        raise ScenarioError(f"{error}{how_to_have(name)}") from error


def _file_at(named: str, path: Path, given: Given) -> Path:
    """The map that a scenario names by a path from its own folder."""
    if re.fullmatch(r"\w+", named):  # a name, and no file
        if named in PACKAGED and not (path.parent / f"{named}.xodr").is_file():
            return PACKAGED[named]
        named += ".xodr"
    if not named.endswith(".xodr"):
        raise ScenarioError(f"{path}: its map {named[:60]!r} is not an .xodr file; name one with --map")
    if ABSOLUTE.match(named):
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
        return where
    raise ScenarioError(
        f"{path}: its map {str(where)[-200:]!r} does not lie there; put it there, or name one with --map"
    )
