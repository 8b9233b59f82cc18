"""What plans of maps are made of beside single streets: the ring of a roundabout, the bends of ramps."""

from __future__ import annotations

import math
from dataclasses import dataclass

from chatscene.maps.opendrive import Node, Street
from chatscene.maps.reference_lines import Corner


@dataclass(frozen=True, slots=True, kw_only=True)
class RingDesign:
    """A roundabout without its arms, one for each quarter.

    Attributes:
        island: Radius of its central island [m].
        lane: Width of a lane that goes round [m].
        lanes: How many go round.
        flare: Radius by which one drives in and out of it, at the left edge of one's lane [m].
    """

    island: float
    lane: float
    lanes: int
    flare: float

    def streets(self, first: int, nodes: tuple[Node, Node, Node, Node], x: float, y: float) -> list[Street]:
        """Four quarters of a ring, driven counter-clockwise.

        Args:
            first: Id of the first street, from the east to the north.
            nodes: Its junctions in the east, north, west and south.
            x: Its centre [m].
            y: Its centre [m].
        """
        # From an arm to where the way in meets the island's circle.
        flare = math.asin(self.flare / (self.island + self.flare))
        quarters: list[Street] = []
        for number in range(4):
            begin, end = number * math.pi / 2 + flare, (number + 1) * math.pi / 2 - flare
            middle, out = (begin + end) / 2, self.island / math.cos((end - begin) / 2)
            quarters.append(
                Street(
                    id=first + number,
                    start=nodes[number],
                    end=nodes[(number + 1) % 4],
                    lanes=self.lanes,
                    back=0,
                    start_at=(x + self.island * math.cos(begin), y + self.island * math.sin(begin)),
                    end_at=(x + self.island * math.cos(end), y + self.island * math.sin(end)),
                    via=((x + out * math.cos(middle), y + out * math.sin(middle), self.island),),
                    lane=self.lane,
                    sidewalk=0.0,
                )
            )
        return quarters


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
