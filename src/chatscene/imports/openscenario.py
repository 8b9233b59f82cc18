"""ASAM OpenSCENARIO XML, versions 1.0 to 1.3, as what happens in this world; what it says beyond that is refused.

A file becomes a storyboard of plans where plans can say it (`told_as_plan`), so that it can be changed, exported and
read as any other; else a story that is played event by event (`told_as_story`). What cannot be said is named with its
line, all of it at once.
"""

from __future__ import annotations

import os
import re
import shlex
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any, TypeVar

from chatscene.errors import MapError, ScenarioError, SettingsError, no_such
from chatscene.imports.catalogs import ABSOLUTE, Catalogs, lies_within, relative, written_out
from chatscene.imports.given import Given, Refused, finite
from chatscene.imports.open_ground import open_ground
from chatscene.imports.stranger_xml import Element, read_xml
from chatscene.imports.told_as_plan import PlanReader
from chatscene.imports.told_as_story import StoryReader
from chatscene.imports.written_story import StoryProgram, Told
from chatscene.maps.carla_towns import PACKAGE, carla_town, how_to_have
from chatscene.maps.left_hand import keeps_left, lanes_on_map
from chatscene.maps.network import PACKAGED, load_network, resolve_map
from chatscene.terms.actors import BY_CLASS, Manner
from chatscene.terms.carried import Row, carries, program_in, with_values
from chatscene.terms.mirrored_scenario import mirrored_attributes
from chatscene.terms.plan import Expression
from chatscene.terms.storyboard import Storyboard
from chatscene.terms.sums import valued
from chatscene.world.story.conditions import truth_of
from chatscene.world.story.entities import Bounds, Entity
from chatscene.world.story.places import Place, place_of


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


_T = TypeVar("_T")

VERSIONS = (0, 1, 2, 3)  # of 1.x
_Read = tuple[Storyboard | StoryProgram | None, Given, StoryProgram | None, tuple[str, ...], list[str]]


@dataclass(frozen=True, slots=True, kw_only=True)
class Imported:
    """A scenario of a file.

    Attributes:
        as_written: The same with what the ego does, event by event; None where the file says nothing of that.
        notes: What was taken otherwise than it is written, or left to others.
        not_as_written: Why its own ego cannot drive as the file says, each with its line; empty where it can, or where
            the file says nothing of it.
        notes_as_written: What was taken otherwise where it drives so.
    """

    board: Storyboard | StoryProgram
    map_path: Path
    notes: tuple[str, ...]
    as_written: StoryProgram | None = None
    not_as_written: tuple[str, ...] = ()
    notes_as_written: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Carried:
    """The program that a scenario carries, as no event of it was changed."""

    source: str
    map_path: Path
    notes: tuple[str, ...]


class ScenarioFile:
    """A scenario in a file, which is opened once, whatever values its parameters are given then.

    Raises:
        ScenarioError: It cannot be read, or tells no scenario.
    """

    def __init__(
        self,
        path: Path,
        map_name: str | None = None,
        *,
        ego: str | None = None,
        within: Path | None = None,
        root: Element | None = None,
    ) -> None:
        self._path, self._ego, self._within = path, ego, within
        self._root = root = root or read_xml(path)
        if root.tag != "OpenSCENARIO":
            raise ScenarioError(f"{path} is not OpenSCENARIO XML: its root is <{root.tag[:40]}>")
        header = root.find("FileHeader")
        version = (header.attributes.get("revMajor"), header.attributes.get("revMinor")) if header else (None, None)
        if version[0] != "1" or str(version[1]) not in map(str, VERSIONS):
            raise ScenarioError(f"{path} is of version {'.'.join(str(part) for part in version)}; known are 1.0 to 1.3")
        if root.find("Entities") is None or root.find("Storyboard", "Init", "Actions") is None:
            raise ScenarioError(f"{path} is not a scenario: it has no Entities, or no Storyboard with an Init")
        self._maps, self._catalogs = Maps(path, map_name), Catalogs(root, path)

    def check_declared(self, names: Iterable[str]) -> None:
        """Hold parameters that are told from outside to those that the scenario declares.

        Raises:
            SettingsError: It does not declare one.
        """
        declared = {
            one.attributes.get("name", "").removeprefix("$")
            for group in self._root.all("ParameterDeclarations")
            for one in group.inside
        }
        if odd := sorted(set(names) - declared):
            raise SettingsError(f"{self._path}: {no_such('parameter', odd[0], declared)}")

    def said(
        self, told: Mapping[str, str] | None = None, spans: Mapping[str, tuple[float, float]] | None = None
    ) -> Imported:
        """What the scenario says.

        Raises:
            ScenarioError: It says what cannot be said here; the message names elements and lines.
            MapError: The map is not there, or is broken.
        """
        fixed: frozenset[str] = frozenset()
        while True:  # once more where a parameter varies that stands where nothing may vary
            given = Given(fixed=fixed, told=told or {}, spans=spans or {}, within=self._within)
            given.declare(self._root)
            written = written_out(self._root, self._path, given, self._catalogs)
            map_path = self._maps.of(given, written)
            board, given, whole, not_as_written, of_story = self._read(written, given, map_path)
            if given.wanted <= fixed:
                break
            fixed |= given.wanted
        if keeps_left(map_path):
            given.notes[:] = map(lanes_on_map, given.notes)
            of_story = [*map(lanes_on_map, of_story)]
            given.refusals[:] = map(lanes_on_map, given.refusals)
            not_as_written = tuple(map(lanes_on_map, not_as_written))
        given.raise_refusals(self._path)
        assert board is not None
        return Imported(
            board=board,
            map_path=map_path,
            notes=tuple(dict.fromkeys(given.notes)),
            as_written=whole,
            not_as_written=not_as_written,
            notes_as_written=tuple(dict.fromkeys(of_story)),
        )

    @property
    def carries_program(self) -> bool:
        """Whether a program travels in its head, whatever the events say now."""
        return carries(self._properties())

    def _properties(self) -> dict[str, str]:
        head = self._root.find("FileHeader", "Properties")
        told = head.inside if head else []
        return {one.attributes.get("name", ""): one.attributes.get("value", "") for one in told}

    def carried(
        self, told: Mapping[str, str] | None = None, spans: Mapping[str, tuple[float, float]] | None = None
    ) -> Carried | None:
        """The program that the scenario carries; None where it carries none, or its events or map were changed since.

        Nor is it taken where somebody is named as the ego: then what the events say of that one is asked for.

        Raises:
            ScenarioError: A parameter has a range or a value that cannot be.
            MapError: The map is not there, or is broken.
        """
        if self._ego is not None or not self.carries_program:
            return None
        given = Given(told=told or {}, spans=spans or {}, within=self._within)
        given.declare(self._root)
        map_path = self._maps.of(given, self._root)
        given.raise_refusals(self._path)
        source = program_in(self._properties(), map_path.read_bytes(), _rows(self._root))
        if source is None:
            return None
        values = {one.name: (one.low, one.high) for one in given.ranges.values()}
        for name, value in given.values.items():
            if name not in given.ranges:
                try:
                    values[name] = (finite(self._root, value), finite(self._root, value))
                except Refused as reason:
                    given.refusals.append(str(reason))
        given.raise_refusals(self._path)
        return Carried(source=with_values(source, values), map_path=map_path, notes=tuple(given.notes))

    def _read(self, whole: Element, given: Given, map_path: Path) -> _Read:
        """What a file says, and what was noted: as plans, where nothing of it is refused; else as a story."""
        if keeps_left(map_path):
            whole = _in_the_mirror(whole)
        as_story = given.copied()
        plans: Storyboard | None = None
        if not given.refusals:
            plans = _unless_refused(lambda: PlanReader(whole, given, map_path, self._ego).board(), given)
        reader = _unless_refused(lambda: StoryReader(whole, as_story, map_path, self._ego), as_story)
        story = _unless_refused(reader.program, as_story) if reader is not None else None
        said = story is not None and not as_story.refusals and story.members[0].acts
        for_plans = plans is not None and not given.refusals
        if for_plans and story is not None and not as_story.refusals:
            # What holds from the beginning on never begins to hold, and a plan would not wait.
            for_plans = not holds_at_first(story, load_network(map_path), given.nominal)
        untold = reader.untold if reader is not None else []
        told = given if for_plans else as_story
        of_story = list(as_story.notes)
        told.notes += [f"{why}; so it cannot be driven with --as-written" for why in untold]
        why_not = tuple(dict.fromkeys((*untold, *as_story.refusals)))  # of a story, refusals refuse the file
        return plans if for_plans else story, told, story if said else None, why_not, of_story


def _rows(one: Element) -> Iterator[Row]:
    return ((inner.tag, inner.attributes, _rows(inner)) for inner in one.inside)


def _in_the_mirror(one: Element) -> Element:
    """What a file says of a map of left-hand traffic, which is read as its mirror image."""
    inside = list(map(_in_the_mirror, one.inside))
    return replace(one, attributes=mirrored_attributes(one.tag, one.attributes), inside=inside)


def read_openscenario(
    path: Path, map_name: str | None = None, *, ego: str | None = None, within: Path | None = None
) -> Imported:
    """Read a scenario; arguments and errors are those of a `ScenarioFile` and of what it says."""
    return ScenarioFile(path, map_name, ego=ego, within=within).said()


def _unless_refused(reading: Callable[[], _T], given: Given) -> _T | None:
    """What a reading gives; None where it ends at something that is refused, which is among the refusals then."""
    try:
        return reading()
    except Refused as reason:
        given.refusals.append(str(reason))
        return None


# Edges that do not rise: what a story waits for holds from the beginning on, so that it never begins to hold


_OF_THE_WORLD = frozenset(("time", "value", "number", "element", "never", "always"))


class _First:
    """A story before anything has happened in it."""

    def __init__(self, story: StoryProgram, network: Any) -> None:
        self.time, self.variables = 0.0, dict[str, Any]()
        self._who = {
            one.name: Entity(
                SimpleNamespace(
                    pose=(one.x, one.y, one.heading, one.speed),
                    length=one.length,
                    width=one.width,
                    isWalker=one.kind in BY_CLASS and BY_CLASS[one.kind].row.manner is Manner.WALKS,
                ),
                one.name,
                one.ahead,
                network,
                led=True,
                bounds=Bounds(*one.bounds),
            )
            for one in story.members
        }

    def entity(self, name: str) -> Entity:
        """Somebody by name."""
        return self._who[name]

    def place(self, told: tuple[Any, ...]) -> Place:
        """A place."""
        return place_of(told, self.entity)

    def is_in(self, kind: str, name: str, state: str) -> bool:
        """No part has begun."""
        del kind, name, state
        return False


def holds_at_first(story: StoryProgram, network: Any, values: Mapping[str, float]) -> bool:
    """Whether somebody but the ego waits for an edge to rise of what holds from the beginning on."""
    asked = [what for edge, _, *what in _conditions(story) if edge == "rising" and what[0] not in _OF_THE_WORLD]
    if not asked:
        return False
    world = _First(story, network)
    return any(truth_of(tuple(_valued(part, values) for part in what), world)() for what in asked)


def _conditions(story: StoryProgram) -> Iterator[Any]:
    """All conditions by which acts begin, and events of others than the ego."""
    for _, start, _, groups in story.acts:  # type: ignore[misc]
        yield from (condition for group in start or () for condition in group)  # type: ignore[union-attr]
        for _, _, actors, events in groups:  # type: ignore[misc, union-attr]
            for event in events if actors != ("ego",) else ():  # type: ignore[union-attr]
                yield from (condition for group in event[4] or () for condition in group)  # type: ignore[index, union-attr]


def _valued(told: Told | Any, values: Mapping[str, float]) -> Any:
    """A part of a story with a number in the place of each expression."""
    if isinstance(told, tuple):
        return tuple(_valued(one, values) for one in told)  # type: ignore[reportUnknownVariableType]
    return valued(told, values) if isinstance(told, Expression) else told
