"""Who there is in a scenario file: bodies, and which of them the ego is."""

from __future__ import annotations

import re
from collections.abc import Iterator

from chatscene.imports.given import DEEPEST, Given, Refused
from chatscene.imports.stranger_xml import Element
from chatscene.situations.phrases import one_seen
from chatscene.terms.actors import BY_CLASS, LIMITS, LOOSE
from chatscene.terms.nouns import with_article
from chatscene.terms.storyboard import THING
from chatscene.world.story.pace import UNBOUND

_ALIKE = {"semitrailer": "Truck", "trailer": "Truck", "train": "Tram", "motorcycle": "Motorcycle"}
_MOVED = "Load"  # as which a thing is shown that is moved
_LEAST = 0.1  # [m] that anything is long and wide
_LONGEST = 500.0  # [m] that a thing is long and wide
_ONE_OF = frozenset(("animal",))  # categories that say less than which of those here it is
_TYPES = {
    "vehicle": "Vehicle",
    "pedestrian": "Pedestrian",
    "miscellaneous": "MiscObject",
    "external": "ExternalObjectReference",
}
_NAMED = ("ego", "hero", "vut", "sut", "host")  # VUT: Euro NCAP's vehicle under test
_EGOS = re.compile(r"(?i)(ego|hero)")


class Entities:
    """The entities of a file.

    Attributes:
        groups: The names of those that a selection holds, by its name.
        types: The names of those of a type, by what a file calls it.
    """

    def __init__(self, root: Element, given: Given, ego: str | None = None) -> None:
        self._root, self._given, self._asked = root, given, ego
        self._selections: dict[str, Element] = {}
        self.objects = self._found(root)
        self.types: dict[str, tuple[str, ...]] = {
            kind: tuple(name for name, one in self.objects.items() if one.find(tag) is not None)
            for kind, tag in _TYPES.items()
        }
        self.groups: dict[str, tuple[str, ...]] = {}
        for name in self._selections:
            self._group(name, ())

    def _found(self, root: Element) -> dict[str, Element]:
        entities = root.find("Entities")
        assert entities is not None
        found: dict[str, Element] = {}
        for one in entities.inside:
            if one.tag == "ScenarioObject" and one.attributes.get("name"):
                found[one.attributes["name"]] = one
            elif one.tag == "EntitySelection" and one.attributes.get("name"):
                self._selections[one.attributes["name"]] = one
            else:
                self._given.refusals.append(str(Refused(one, "only single road users with a name are read")))
        return found

    def _group(self, name: str, within: tuple[str, ...]) -> tuple[str, ...]:
        """Those that a selection holds, each once."""
        if name not in self.groups:
            self.groups[name] = tuple(dict.fromkeys(self._members(self._selections[name], (*within, name))))
        return self.groups[name]

    def _members(self, selection: Element, within: tuple[str, ...]) -> Iterator[str]:
        """The names of those that a selection holds, of whatever selections it holds in turn."""
        if len(within) > DEEPEST:
            raise Refused(selection, f"selections hold one another more than {DEEPEST} deep")
        held = [one for one in selection.walk() if one.tag in ("EntityRef", "ByType")]
        if not held:
            raise Refused(selection, "it is empty; write EntityRef or ByType")
        for one in held:
            if one.tag == "ByType":
                yield from self.of_type(one, "objectType")
                continue
            name = self._given.text(one, "entityRef")
            if name in within or name not in self.objects.keys() | self._selections.keys():
                raise Refused(one, f"{name[:40]!r} is not an entity that it can contain")
            yield from [name] if name in self.objects else self._group(name, within)

    def of_type(self, one: Element, attribute: str) -> tuple[str, ...]:
        """The names of those of the type that an element names.

        Raises:
            Refused: There is no such type.
        """
        kind = self._given.text(one, attribute)
        if kind not in self.types:
            raise Refused(one, f"the type {kind[:40]!r} is not known; known are {', '.join(self.types)}")
        if not self.types[kind]:
            self._given.note(one, f"there is nobody of the type {kind}")
        return self.types[kind]

    def ego(self) -> str:
        """The name of the ego.

        Raises:
            Refused: It is not told which one that is.
        """
        if self._asked is not None:
            if self._asked in self.objects:
                return self._asked
            known = ", ".join(map(repr, self.objects))[:200]
            raise Refused(self._root, f"there is no {self._asked[:40]!r} that could be the ego; there is {known}")
        roles = {name: self._properties(one).get("chatscene.role") for name, one in self.objects.items()}
        types = {name: self._properties(one).get("type") for name, one in self.objects.items()}
        for said in (
            [name for name, role in roles.items() if role == "ego"],
            [name for name, kind in types.items() if kind == "ego_vehicle"],
            [name for name in self.objects if name.lower() in _NAMED],
            [name for name in self.objects if _EGOS.match(name)],
        ):
            if len(said) == 1:
                return said[0]
            if said:
                return self._first(said)
        led = [name for name, one in self.objects.items() if one.find("ObjectController")]
        if len(led) == 1:
            return led[0]
        drive = [name for name, one in self.objects.items() if one.inside and one.inside[0].tag == "Vehicle"]
        if drive:
            return self._first(drive)
        there = ", ".join(map(repr, self.objects))[:80] or "nobody"
        raise Refused(self._root, f"there is no vehicle that could be the ego; there is {there}")

    def _first(self, names: list[str]) -> str:
        """The first of several that could be the ego, and a note of it where there are several."""
        if len(names) > 1:
            others = ", ".join(names[1:])[:120]
            self._given.note(
                self.objects[names[0]], f"the file does not name its ego, so {names[0]} is used; name another with "
                f"--ego: {others}"
            )  # fmt: skip
        return names[0]

    def _properties(self, one: Element) -> dict[str, str]:
        return {p.attributes.get("name", ""): p.attributes.get("value", "") for p in one.walk() if p.tag == "Property"}

    def body(self, one: Element) -> tuple[str, float, float, float]:
        """The class of somebody, its length and width, and how far its centre lies before its origin [m]."""
        if not one.inside or one.inside[0].tag in ("CatalogReference", "ExternalObjectReference"):
            raise Refused(one.inside[0] if one.inside else one, "its body is not given; write a Vehicle here")
        body = one.inside[0]
        named = next((name for name in body.attributes if name.endswith("Category")), "")
        category = self._given.text(body, named) if named else ""
        dimensions, centre = body.find("BoundingBox", "Dimensions"), body.find("BoundingBox", "Center")
        length = self._given.number(dimensions, "length") if dimensions else 0.0
        width = self._given.number(dimensions, "width") if dimensions else 0.0
        ahead = self._given.number(centre, "x", "0") if centre else 0.0
        named = self._properties(one).get("chatscene.kind", "")
        if named in BY_CLASS:
            kind = named
        elif body.tag == "MiscObject":
            kind = THING
        else:
            known = {name: kind.row for name, kind in BY_CLASS.items() if not kind.lies}
            fits = [name for name, row in known.items() if row.openscenario == category and not row.role]
            alike = _ALIKE.get(category)
            if not fits and alike is None:
                raise Refused(body, f"no road user is known as {category[:40]!r}")
            kind = alike or fits[0]
            if kind.lower() != category and (alike or category in _ONE_OF) and category != "motorcycle":
                self._given.note(body, f"{with_article(category)} is shown as {one_seen(kind)} of its size")
        if kind in LIMITS and not (length and width):
            length, width = LIMITS[kind].length, LIMITS[kind].width
        if kind == THING and not (length >= _LEAST and width >= _LEAST):
            length, width = max(length, _LEAST), max(width, _LEAST)
            self._given.note(body, f"a thing of no size is shown as one of {length:g} m by {width:g} m")
        most = (_LONGEST, _LONGEST) if kind == THING else (30.0, 10.0)  # as a barrier along a road is
        if not (_LEAST <= length <= most[0] and _LEAST <= width <= most[1]):
            raise Refused(body, f"a body of {length:g} m by {width:g} m is not made here")
        return kind, length, width, ahead

    def moving(self, one: Element) -> str:
        """The class of a thing that is moved."""
        named = self._properties(one).get("chatscene.kind", "")
        return named if named in LOOSE else _MOVED

    def bounds(self, one: Element) -> tuple[float, ...]:
        """The largest speed [m/s], acceleration and deceleration [m/s²] of somebody; nothing where none is told."""
        told = one.inside[0].find("Performance") if one.inside else None
        if told is None:
            return ()
        names = ("maxSpeed", "maxAcceleration", "maxDeceleration")
        found = [self._given.limit(told, name) for name in names]
        return tuple(value if 0.0 < value < UNBOUND else UNBOUND for value in found)
