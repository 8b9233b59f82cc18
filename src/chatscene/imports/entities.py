"""Who there is in a scenario file: bodies, and which of them the ego is."""

from __future__ import annotations

import re

from chatscene.imports.given import Given, Refused
from chatscene.imports.stranger_xml import Element
from chatscene.terms.actors import BY_CLASS, LIMITS
from chatscene.terms.storyboard import THING

_ALIKE = {"semitrailer": "Truck", "trailer": "Truck"}
_ONE_OF = frozenset(("animal",))  # categories that say less than which of those here it is
_EGOS = re.compile(r"(?i)(ego|hero)")


class Entities:
    """The entities of a file.

    Attributes:
        objects: Their elements, by name.
    """

    def __init__(self, root: Element, given: Given) -> None:
        self._root, self._given = root, given
        self.objects = self._found(root)

    def _found(self, root: Element) -> dict[str, Element]:
        entities = root.find("Entities")
        assert entities is not None
        found: dict[str, Element] = {}
        for one in entities.inside:
            if one.tag == "ScenarioObject" and one.attributes.get("name"):
                found[one.attributes["name"]] = one
            else:
                self._given.refusals.append(str(Refused(one, "only single road users with a name are read")))
        return found

    def ego(self) -> str:
        """The name of the ego.

        Raises:
            Refused: It is not told which one that is.
        """
        roles = {name: self._properties(one).get("chatscene.role") for name, one in self.objects.items()}
        types = {name: self._properties(one).get("type") for name, one in self.objects.items()}
        for said in (
            [name for name, role in roles.items() if role == "ego"],
            [name for name, kind in types.items() if kind == "ego_vehicle"],
            [name for name in self.objects if _EGOS.match(name)],
            [name for name, one in self.objects.items() if one.find("ObjectController")],
        ):
            if len(said) == 1:
                return said[0]
            if said:
                raise Refused(self.objects[said[1]], f"there is more than one ego: {', '.join(said)[:80]}")
        there = ", ".join(map(repr, self.objects))[:80] or "nobody"
        raise Refused(self._root, f"which one the ego is, is not told; there is {there}: call one of them ego")

    def _properties(self, one: Element) -> dict[str, str]:
        return {p.attributes.get("name", ""): p.attributes.get("value", "") for p in one.walk() if p.tag == "Property"}

    def body(self, one: Element) -> tuple[str, float, float, float]:
        """The class of somebody, its length and width, and how far its centre lies before its origin [m]."""
        if not one.inside or one.inside[0].tag == "CatalogReference":
            raise Refused(
                one.inside[0] if one.inside else one, "catalogs lie in other files, which are not opened; write it here"
            )
        body = one.inside[0]
        category = next((value for name, value in body.attributes.items() if name.endswith("Category")), "")
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
                raise Refused(body, f"nobody here is a {category[:40]!r}")
            kind = alike or fits[0]
            if kind.lower() != category and (alike or category in _ONE_OF):
                self._given.notes.append(f"line {body.line}: a {category} is shown as a {kind.lower()} of its size")
        if kind in LIMITS and not (length and width):
            length, width = LIMITS[kind].length, LIMITS[kind].width
        if not (0.1 <= length <= 30 and 0.1 <= width <= 10):
            raise Refused(body, f"a body of {length:g} m by {width:g} m is not made here")
        return kind, length, width, ahead
