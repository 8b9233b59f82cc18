"""Catalogs that a scenario names, and the parameters of its parts: all of it written out where it is used.

What comes out is one tree in which nothing refers to another file and `$name` means a parameter of the whole file. A
catalog is looked for in the folders that the file names, by paths from the file's own folder; a path that is no such
path is not opened.
"""

from __future__ import annotations

import os
import re
from collections import defaultdict
from collections.abc import Mapping, Sequence
from dataclasses import replace
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

from chatscene.errors import ScenarioError
from chatscene.imports.given import REFERENCE, Given, Refused
from chatscene.imports.stranger_xml import LARGEST, LONGEST, MOST, Element, TooMany, read_xml

MOST_FILES = 100  # catalogs of one scenario
DEEPEST = 8  # catalogs whose entries name entries of others
ABSOLUTE = re.compile(r"/|[A-Za-z]:")
_NOT_NEEDED = frozenset(("ObjectController", "AssignControllerAction", "Controller"))  # see `written_out`


def written_out(root: Element, path: Path, given: Given, catalogs: Catalogs) -> Element:
    """A scenario with every entry of a catalog in the place of the reference to it.

    Entries of controllers are not looked for, as controllers are not taken. Whatever cannot be found is refused by its
    line, among the refusals of the file.
    """
    return _Writer(root, path, given, catalogs).element(root, {}, 0, "")


def scope_of(
    declared: Element, outer: Mapping[str, str], assigned: Mapping[str, str] | None = None, most: int = LARGEST
) -> dict[str, str]:
    """The parameters that hold within an element: its own before those around it, whatever they are called.

    Raises:
        Refused: Some are made of one another.
        ValueError: A value is longer than an attribute may be, or all of them are too long together.
    """
    own = {d.attributes.get("name", "").removeprefix("$"): d.attributes.get("value", "") for d in declared.inside}
    told = {name: value for name, value in (assigned or {}).items() if name in own}
    made_of = {
        name: [] if name in told else [one for one in REFERENCE.findall(value) if one in own and one != name]
        for name, value in own.items()
    }
    found = dict(outer)
    try:
        for name in TopologicalSorter(made_of).static_order():
            found[name] = told[name] if name in told else bound(own[name], found)
            most -= len(found[name])
            if most < 0:
                raise ValueError(f"its values are longer than {LARGEST // 2**20} MB with those of the file")
    except CycleError as error:
        raise Refused(declared, f"${error.args[1][0]} is an expression of itself") from None
    return found


def relative(path: Path, named: str, within: Path | None = None) -> Path | None:
    """Where a file or folder lies that a scenario names by a path from its own folder.

    Returns:
        None of any other path.
    """
    text = named.replace("\\", "/").strip()
    if not text or ABSOLUTE.match(text) or "\0" in text:
        return None
    where = path.parent / text
    return where if lies_within(where, within) else None


def lies_within(where: Path, within: Path | None) -> bool:
    """Whether a file or folder lies in a folder, links followed; everything does where no folder is given."""
    return within is None or Path(os.path.realpath(where)).is_relative_to(os.path.realpath(within))


def bound(text: str, scope: Mapping[str, str]) -> str:
    """A text with the values of the parameters of a scope in it; all others stand as they are.

    Raises:
        ValueError: It is longer then than an attribute may be.
    """
    if "$" not in text or not scope:
        return text
    if len(text) + sum(len(scope.get(one[1], "")) for one in REFERENCE.finditer(text)) > LONGEST:
        raise ValueError(f"{text[:40]!r} has more than {LONGEST} characters with its parameters")
    if (whole := REFERENCE.fullmatch(text)) is not None:
        return scope.get(whole[1], text)
    return REFERENCE.sub(lambda one: _bracketed(scope[one[1]]) if one[1] in scope else one[0], text)


def _bracketed(value: str) -> str:
    """A value as a part of an expression."""
    inner = value.strip()
    if inner.startswith("${") and inner.endswith("}"):
        inner = inner[2:-1]
    return f"({inner})" if inner and not re.fullmatch(r"\$?\w+", inner) else inner


class Catalogs:
    """The catalogs in the folders that a scenario names; opened once, however often the scenario is read."""

    def __init__(self, root: Element, path: Path) -> None:
        self._root, self._path = root, path
        self._files: tuple[Path, ...] = ()
        self._found: Mapping[str, Sequence[Element]] = {}
        self._unread: tuple[str, ...] = ()

    def opened(self, given: Given) -> tuple[Mapping[str, Sequence[Element]], tuple[str, ...]]:
        """All catalogs by name, and by that of their file, as most players look for them; and what could not be read.

        Args:
            given: The parameters of the scenario, of which folders may be made.
        """
        files, unread = self._named(given)
        if files != self._files:
            self._files, (self._found, self._unread) = files, _read(files)
        return self._found, (*unread, *self._unread)

    def _named(self, given: Given) -> tuple[tuple[Path, ...], tuple[str, ...]]:
        files: dict[Path, None] = {}
        unread: list[str] = []
        locations = self._root.find("CatalogLocations")
        for one in (folder for kind in (locations.inside if locations else []) for folder in kind.all("Directory")):
            try:
                named = given.text(one, "path", "")
            except Refused as reason:
                unread.append(str(reason))
                continue
            where = relative(self._path, named, given.within)
            if where is None:
                unread.append(f"{one.where}: {named[:60]!r} is not a path from the file's own folder")
                continue
            inside = [where] if where.is_file() else sorted(where.glob("*.xosc"))
            files.update(dict.fromkeys(f for f in inside if relative(f, f.name, given.within) is not None))
        return tuple(files)[:MOST_FILES], tuple(unread)


def _read(files: tuple[Path, ...]) -> tuple[Mapping[str, Sequence[Element]], tuple[str, ...]]:
    """The catalogs in files, by name, then by that of their file, and what could not be read."""
    named, filed = defaultdict[str, list[Element]](list), defaultdict[str, list[Element]](list)
    unread: list[str] = []
    count = 0
    for file in files:
        try:
            root = read_xml(file, file=file.name, most=MOST - count)
        except TooMany as error:  # the catalogs of a file have one bound together
            unread.append(str(error))
            break
        except ScenarioError as error:
            unread.append(str(error))
            continue
        count += sum(1 for _ in root.walk())
        catalog = root.find("Catalog")
        if catalog is not None:
            named[catalog.attributes.get("name", "")].append(catalog)
            filed[file.stem].append(catalog)
    return {name: [*named[name], *filed[name]] for name in (*named, *filed)}, tuple(unread)


class _Writer:
    def __init__(self, root: Element, path: Path, given: Given, catalogs: Catalogs) -> None:
        self._root, self._path, self._given, self._catalogs = root, path, given, catalogs
        self._known: Mapping[str, Sequence[Element]] | None = None
        self._unread: tuple[str, ...] = ()
        self._count = self._characters = 0

    def element(
        self,
        one: Element,
        scope: Mapping[str, str],
        depth: int,
        within: str,
        assigned: Mapping[str, str] | None = None,
    ) -> Element:
        """An element with the parameters of its scope, its catalogs' entries and its own parameters written out."""
        self._count += 1
        if self._count > MOST:
            raise ScenarioError(f"{self._path} has more than {MOST} elements with its catalogs; cut it down")
        if one.tag == "CatalogReference" and within not in _NOT_NEEDED:
            return self._entry(one, scope, depth, within)
        declared = one.find("ParameterDeclarations") if one is not self._root else None
        if declared is not None:
            scope = self._scope(declared, scope, assigned)
        attributes = self._bound(one, scope)
        inside = [self.element(below, scope, depth, one.tag) for below in one.inside]
        return replace(one, attributes=attributes, inside=inside)

    def _scope(
        self, declared: Element, outer: Mapping[str, str], assigned: Mapping[str, str] | None
    ) -> Mapping[str, str]:
        try:
            found = scope_of(declared, outer, assigned, LARGEST - self._characters)
        except Refused as reason:
            self._given.refusals.append(str(reason))
            return outer
        except ValueError as error:
            raise ScenarioError(f"{self._path}: {Refused(declared, str(error))}") from error
        self._characters += sum(len(found[d.attributes.get("name", "").removeprefix("$")]) for d in declared.inside)
        return found

    def _bound(self, one: Element, scope: Mapping[str, str]) -> dict[str, str]:
        """The attributes of an element with the values of the parameters of a scope."""
        try:
            found = {name: bound(value, scope) for name, value in one.attributes.items()}
        except ValueError as error:
            raise ScenarioError(f"{self._path}: {Refused(one, str(error))}") from error
        self._characters += sum(map(len, found.values()))
        if self._characters > LARGEST:
            raise ScenarioError(
                f"{self._path} has more than {LARGEST // 2**20} MB with its catalogs and parameters; cut it down"
            )
        return found

    def _entry(self, one: Element, scope: Mapping[str, str], depth: int, within: str) -> Element:
        here = replace(one, attributes=self._bound(one, scope))
        try:
            catalog, entry = self._given.text(here, "catalogName"), self._given.text(here, "entryName")
            found = self._found(here, catalog, entry, depth)
        except Refused as reason:
            if within == "EnvironmentAction":  # what happens does not hang on it
                self._given.note(one, f"{reason.why}; light and weather stay as they are")
            else:
                self._given.refusals.append(str(reason))
            return replace(here, inside=[])
        own = {
            d.attributes.get("name", "").removeprefix("$")
            for group in found.all("ParameterDeclarations")
            for d in group.inside
        }
        told: dict[str, str] = {}
        for p in (p for group in one.all("ParameterAssignments") for p in group.inside):
            name = p.attributes.get("parameterRef", "").lstrip("$")
            told[name] = self._bound(p, scope).get("value", "")
            if name not in own:
                self._given.note(
                    p, f"the entry {entry[:60]!r} declares no parameter {name[:40]!r}; its value is left out"
                )
        return self.element(found, {}, depth + 1, "", told)

    def _found(self, one: Element, catalog: str, entry: str, depth: int) -> Element:
        if depth >= DEEPEST:
            raise Refused(one, f"entries of catalogs name one another more than {DEEPEST} deep")
        if self._known is None:
            self._known, self._unread = self._catalogs.opened(self._given)
        if catalog not in self._known:
            told = f"; could not be read: {'; '.join(self._unread)[:300]}" if self._unread else ""
            known = ", ".join(sorted(self._known)) or "none"
            raise Refused(one, f"no folder that the file names has a catalog {catalog[:60]!r}; there is {known}{told}")
        inside = (part for known in self._known[catalog] for part in known.inside)
        found = next((part for part in inside if part.attributes.get("name") == entry), None)
        if found is None:
            raise Refused(one, f"the catalog {catalog[:60]!r} has no entry {entry[:60]!r}")
        return found
