"""Whom and what a story may speak of: road users by name, places, the lines that are followed."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from chatscene.imports.entities import Entities
from chatscene.imports.given import Given, Refused
from chatscene.imports.names import Names, plain
from chatscene.imports.positions import Pose, Positions
from chatscene.imports.shapes import Shape, shape_of, thinned_finely
from chatscene.imports.stranger_xml import Element
from chatscene.imports.written_story import Line, Told
from chatscene.terms.polyline import Polyline
from chatscene.terms.sums import Sum

_BESIDE = frozenset(("RelativeObjectPosition", "RelativeWorldPosition", "RelativeLanePosition", "RelativeRoadPosition"))


@dataclass(slots=True, kw_only=True)
class Cast:
    """Whom a story may speak of.

    Attributes:
        positions: Finds places; knows where everybody is at first.
        names: What the story calls each of the file's road users.
        mirrored: Whether metres count to the right of who drives, as in CARLA.
        called: What the story calls its parts and variables.
        lines: The lines that are followed, by name; more are added.
        refs: Names in the file of parts of the story that conditions ask about.
        texts: Names of parameters and variables that are set to a text.
        parts: The parts of the story: the type of each, and its name with none, some or all of those above it.
    """

    given: Given
    positions: Positions
    ego: str
    names: Mapping[str, str]
    entities: Entities
    route_of: Callable[[Element, Pose | None], Polyline]
    mirrored: bool
    called: Names
    lines: dict[str, Polyline] = field(default_factory=dict[str, Polyline])
    refs: frozenset[str] = frozenset()
    texts: frozenset[str] = frozenset()
    parts: frozenset[tuple[str, tuple[str, ...]]] = frozenset()

    @property
    def side(self) -> int:
        """1 where the file counts to the left, -1 where to the right."""
        return -1 if self.mirrored else 1

    def who(self, element: Element, attribute: str = "entityRef") -> str:
        """What the story calls somebody whom an element names.

        Raises:
            Refused: There is no such road user.
        """
        name = self.given.text(element, attribute)
        if name not in self.names:
            raise Refused(element, f"there is no {name[:40]!r}")
        return self.names[name]

    def several(self, elements: list[Element]) -> tuple[str, ...]:
        """The names in the file of all whom elements name, selections taken apart; each once."""
        found: dict[str, None] = {}
        for one in elements:
            name = self.given.text(one, "entityRef")
            found.update(dict.fromkeys(self.entities.groups.get(name, (name,))))
            if name not in self.entities.groups and name not in self.names:
                raise Refused(one, f"there is no {name[:40]!r}")
        return self.there(found)

    def there(self, names: Iterable[str]) -> tuple[str, ...]:
        """Those of names in the file who are there."""
        return tuple(name for name in names if name in self.names)

    def part(self, element: Element, *, told: bool = False) -> str:
        """The name of a part of the story; nothing where no condition asks about it, unless it is to be told."""
        name = element.attributes.get("name", "")
        return self.called.of(name) if told or name in self.refs else ""

    def value(self, element: Element, name: str, default: str | None = None) -> Any:
        """A number of the story, which may vary with parameters."""
        return told_number(self.given.sum(element, name, default))

    def at_first(self, asked: Element, name: str) -> str | float:
        """The value of a parameter or variable at first; an empty text where it is not declared.

        Raises:
            Refused: It is an expression that has no value.
        """
        if name not in self.given.values:
            return ""
        return text_or_number(self.given.text(replace(asked, attributes={"value": f"${name}"}), "value"))

    def place(self, position: Element) -> Told:
        """A place of the story.

        Raises:
            Refused: It cannot be told.
        """
        inner = position.inside[0] if len(position.inside) == 1 else None
        if inner is not None and inner.tag in _BESIDE and (name := self.given.text(inner, "entityRef")) in self.names:
            frame, turns = self.positions.known_of(inner, name), _turns(inner)
            x, y, _ = _in_frame(frame if turns[0] else (*frame[:2], 0.0), pose := self.positions.pose(position))
            told = (round(v, 4) for v in (x, y, pose[2] - frame[2] if turns[1] else pose[2]))
            if inner.tag in ("RelativeLanePosition", "RelativeRoadPosition"):
                self.given.note(inner, "it lies beside somebody as the road runs where that one is at first")
            return ("beside", self.names[name], *told, *(() if all(turns) else turns))
        return ("at", *(round(v, 4) for v in self.positions.pose(position)))

    def line(self, trajectory: Element, actor: str | None) -> tuple[Line | Told, Shape]:
        """The line of a trajectory, as it stands in the program; its shape.

        Args:
            trajectory: The element.
            actor: Who follows it; None where it is followed from the beginning on, when nobody has moved yet.
        """
        frames: set[tuple[str, bool]] = set()  # who, and whether the places turn with that one

        def place(position: Element) -> Pose:
            inner = position.inside[0] if len(position.inside) == 1 else None
            if inner is not None and inner.tag in _BESIDE:
                frames.add((self.given.text(inner, "entityRef"), _turns(inner)[0]))
            return self.positions.pose(position)

        shape = shape_of(trajectory, self.given, place)
        told = list(trajectory.walk())
        own = actor is not None and not any(one.tag in ("Position", "PositionStart") for one in told)
        if actor is not None and (own or len(frames) == 1):
            frame, turns = (actor, True) if own else frames.pop()
            if frame not in self.names:
                raise Refused(trajectory, f"it lies beside {frame[:40]!r}, who is not there")
            base = (0.0, 0.0, 0.0) if own else self.positions.known_of(trajectory, frame)
            base = base if turns else (*base[:2], 0.0)
            points = [_in_frame(base, (x, y, 0.0))[:2] for x, y in shape.points]
            kept = tuple((round(points[i][0], 3), round(points[i][1], 3)) for i in thinned_finely(points))
            return (("beside", self.names[frame], 0.0, 0.0, 0.0, *(() if turns else (False, False))), kept), shape
        if len(frames) > 1 and actor is not None:
            raise Refused(trajectory, "its places lie beside several road users, who move; put it beside one")
        return self.known(shape.line), shape

    def known(self, line: Polyline) -> Line:
        """A line by its name in the program."""
        for name, other in self.lines.items():
            if other.points.shape == line.points.shape and bool((abs(other.points - line.points) < 1e-6).all()):
                return Line(name)
        name = f"way{len(self.lines) + 1}"
        self.lines[name] = line
        return Line(name)


def text_or_number(text: str) -> str | float:
    """The value of a variable: a number where it is one, else a text."""
    try:
        return float(text)
    except ValueError:
        return {"true": 1.0, "false": 0.0}.get(text.lower(), plain(text))


def told_number(one: Sum) -> Any:
    """A number of the story: itself, or an expression of parameters."""
    return one.expression if one.number is None else one.number


def _turns(inner: Element) -> tuple[bool, bool]:
    """Whether a place beside somebody turns with that one, and whether its heading does."""
    orientation = inner.find("Orientation")
    absolute = orientation is not None and orientation.attributes.get("type", "absolute") != "relative"
    return inner.tag != "RelativeWorldPosition", not absolute


def _in_frame(frame: Pose, pose: Pose) -> Pose:
    """A pose on the map as it is seen from another."""
    fx, fy, turn = frame
    dx, dy = pose[0] - fx, pose[1] - fy
    c, s = math.cos(turn), math.sin(turn)
    return dx * c + dy * s, dy * c - dx * s, pose[2] - turn
