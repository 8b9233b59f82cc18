"""The ring of a roundabout, as streets of a plan."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

from chatscene.maps.writing.streets import SHOULDER, Node, Street

USUAL = {1: 38.0, 2: 56.0, 3: 76.0}
"""Diameters [m] of the circle round one, two and three lanes (NCHRP 672, exhibit 6-9: 27 to 55, 46 to 67, 61 to 91)."""
MINI, MOST_MINI = 18.0, 28.0  # [m], a usual mini roundabout and the largest (DMRB CD 116; NCHRP 672: 14 to 27)
_WIDE, _NARROW = 5.0, 4.5  # [m], a lane alone, and one of several (NCHRP 672, section 6.4.3)
_MINI_LANE, _MINI_SHOULDER = 4.0, 0.5  # [m]: long vehicles drive over its island, which is flush or domed (CD 116)
_KERB = 15.0  # [m] of radius by which the kerb leads in and out (NCHRP 672, section 6.4.5), where there is room
_LEAST_KERB, _LEAST_ISLAND = 1.0, 2.5  # [m]
_STEEPEST = math.radians(43)  # from an arm to where the way in meets the island: one turns to the right there
_OF_ARMS = 0.95  # of half the angle between two arms, that the ways in and out take at most
_TO_ARM = 2.0  # [m] from where a way in leaves its arm to where that ends


@dataclass(frozen=True, slots=True, kw_only=True)
class RingDesign:
    """A roundabout without its arms.

    Attributes:
        island: Radius of its central island [m].
        lane: Width of a lane that goes round [m].
        lanes: How many go round.
        flare: Radius by which one drives in and out of it, at the left edge of one's lane [m].
        shoulder: Width of the shoulder outside of them [m].
        sidewalk: Width of the sidewalk outside of that [m].
    """

    island: float
    lane: float
    lanes: int
    flare: float
    shoulder: float = SHOULDER
    sidewalk: float = 0.0

    @classmethod
    def of(cls, lanes: int, diameter: float, apart: float, sidewalk: float) -> RingDesign:
        """The ring of a circle that is to hold so many lanes, by the figures of design guides.

        Args:
            lanes: How many go round.
            diameter: Of the circle round them and the shoulder [m].
            apart: The smallest angle between two arms [rad].
            sidewalk: How wide it is [m] if there is room for one round the corners of the arms.

        Raises:
            ValueError: The circle is too small for so many lanes, or for arms that are so near to each other.
        """
        mini = lanes == 1 and diameter <= MOST_MINI
        lane, shoulder = (_WIDE if lanes == 1 else _NARROW), SHOULDER
        if mini:
            lane, shoulder = _MINI_LANE, _MINI_SHOULDER
        across = lanes * lane + shoulder
        island = diameter / 2 - across
        steep = math.sin(min(_STEEPEST, _OF_ARMS * apart / 2))
        flare = min(_KERB + across, island * steep / (1.0 - steep))
        if island < _LEAST_ISLAND or flare < across + _LEAST_KERB:
            raise ValueError(f"a circle of {diameter:g} m is too small for {lanes} lanes round it, and its arms")
        walked = sidewalk if flare - across - sidewalk >= _LEAST_KERB else 0.0
        return cls(island=island, lane=lane, lanes=lanes, flare=flare, shoulder=shoulder, sidewalk=walked)

    @property
    def reach(self) -> float:
        """From its centre to where its arms end [m]."""
        return math.sqrt(self.island**2 + 2 * self.island * self.flare) + _TO_ARM

    @property
    def half(self) -> float:
        """The angle [rad] from an arm to where the way in meets the island's circle."""
        return math.asin(self.flare / (self.island + self.flare))

    def streets(
        self, first: int, nodes: Sequence[Node], x: float, y: float, angles: Sequence[float] | None = None
    ) -> list[Street]:
        """The parts of a ring between its arms, driven counter-clockwise.

        Args:
            first: Id of the first street, from the first arm to the second.
            nodes: Its junctions, counter-clockwise.
            x: Its centre [m].
            y: Its centre [m].
            angles: In which direction each of them lies [rad]; in the east, north, west and south if left out.
        """
        at = [number * math.pi / 2 for number in range(len(nodes))] if angles is None else list(angles)
        at.append(at[0] + 2 * math.pi)
        parts: list[Street] = []
        for number, node in enumerate(nodes):
            begin, end = at[number] + self.half, at[number + 1] - self.half
            middle, out = (begin + end) / 2, self.island / math.cos((end - begin) / 2)
            parts.append(
                Street(
                    id=first + number,
                    start=node,
                    end=nodes[(number + 1) % len(nodes)],
                    lanes=self.lanes,
                    back=0,
                    start_at=(x + self.island * math.cos(begin), y + self.island * math.sin(begin)),
                    end_at=(x + self.island * math.cos(end), y + self.island * math.sin(end)),
                    via=((x + out * math.cos(middle), y + out * math.sin(middle), self.island),),
                    lane=self.lane,
                    shoulder=self.shoulder,
                    sidewalk=self.sidewalk,
                )
            )
        return parts
