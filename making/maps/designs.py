"""What plans of maps are made of beside single streets and rings: the bends of ramps, a car park."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from chatscene.maps.writing.objects import Bay, Use
from chatscene.maps.writing.reference_lines import Corner
from chatscene.maps.writing.streets import Node, Street, Surroundings


@dataclass(frozen=True, slots=True, kw_only=True)
class RampDesign:
    """The two bends of a ramp between a motorway along the x axis and a road beside it.

    Attributes:
        edge: From the middle of the motorway to the ramp's left edge where they part or meet [m].
        turn: By how much it turns there [rad]; by the rest of a right angle at its foot.
        radius: Of the bend there [m].
        foot_at: From the middle of the motorway to the second bend [m].
        foot: Radius of that [m].
    """

    edge: float
    turn: float
    radius: float
    foot_at: float
    foot: float

    def leaves(self, x: float, side: int) -> tuple[Corner, Corner]:
        """The corners of a ramp that leaves the motorway at `x`; `side` is +1 for north and westbound."""
        first = x - side * self.radius * math.tan(self.turn / 2)
        last = first - side * (self.foot_at - self.edge) / math.tan(self.turn)
        return (first, side * self.edge, self.radius), (last, side * self.foot_at, self.foot)

    def joins(self, x: float, side: int) -> tuple[Corner, Corner]:
        """The corners of a ramp that has joined the motorway at `x`."""
        last = x + side * self.radius * math.tan(self.turn / 2)
        first = last + side * (self.foot_at - self.edge) / math.tan(self.turn)
        return (first, side * self.foot_at, self.foot), (last, side * self.edge, self.radius)


AISLE, DEEP = 6.0, 5.0  # [m], width of an aisle with bays at a right angle, and depth of these (EAR 05, section 4.2.1)
EDGE, CORNER, ROOM = 1.0, 12.0, 8.0  # [m] of verge beside an aisle, of radius at its corners, before and behind bays


@dataclass(frozen=True, slots=True, kw_only=True)
class CarParkDesign:
    """A car park south of a street: a drive, two aisles that join in the west and in the east, and a way between them.

    Bays are set at a right angle on both sides of each aisle, as wide as that asks.

    Attributes:
        x: Of the drive [m].
        north: Of the aisle to which the drive leads [m].
        south: Of the other [m].
        half: From the drive to the ends of the aisles [m].
        setback: From the middle of its junctions to where aisles begin [m].
    """

    x: float
    north: float
    south: float
    half: float
    setback: float

    def streets(self, first: int, nodes: tuple[Node, ...]) -> list[Street]:
        """The drive, the way between the aisles, and both loops of aisles.

        Args:
            first: Id of the first street.
            nodes: Where the drive leaves its street, and where it meets the aisles.
        """
        entry, north, south = nodes
        aisle = self.half - self.setback - CORNER
        length = 2 * aisle + math.pi * CORNER + self.north - self.south - 2 * CORNER
        spans = (ROOM, aisle - ROOM), (length - aisle + ROOM, length - ROOM)
        bays = tuple(
            Bay(use=Use.PARKING, right=right, start=start, end=end, width=DEEP)
            for start, end in spans
            for right in (False, True)
        )
        parts = [
            Street(id=first, start=entry, end=north, lanes=1),
            Street(id=first + 1, start=north, end=south, lanes=1),
        ]
        for number, side in enumerate((-1, 1)):
            end = self.x + side * self.half
            via = ((end, self.north, CORNER), (end, self.south, CORNER))
            parts.append(Street(id=first + 2 + number, start=north, end=south, lanes=1, via=via, bays=bays))
        return [
            replace(part, lane=AISLE / 2, shoulder=EDGE, sidewalk=0.0, surroundings=Surroundings.LOT) for part in parts
        ]
