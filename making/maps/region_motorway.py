"""The motorway of the region: two carriageways with an off-ramp and an on-ramp each, from a roundabout to lights."""

from __future__ import annotations

import math
from dataclasses import replace

from chatscene.maps.writing.streets import LANE, Node, Street, Surroundings
from chatscene.terms.scenario import Control
from making.maps.designs import RampDesign

MEDIAN = 2.0  # [m], half of what lies between the carriageways
EDGE = MEDIAN + 3 * LANE  # [m] from the middle of the motorway to where a fourth lane begins
HARD_SHOULDER = 2.5  # [m]
NOSE = 80.0  # [m], over which the hard shoulder gives way to a ramp
TAPER = (10.0, 70.0)  # [m], from where to where a third or fourth lane comes into being
SPEEDING_UP = (250.0, 320.0)  # [m] in it, from where to where it tapers out
DROP = (20.0, 120.0)  # [m], from where to where a third lane tapers out
SHIFT = 1200.0  # [m], radius of the bends by which the carriageways part
GORE = 5.0  # [m] from the middle of the junction of a ramp to where its streets end
SLOW = Surroundings.MOTORWAY_END  # where they begin and end
RAMP = RampDesign(edge=EDGE, turn=math.radians(60), radius=150.0, foot_at=250.0, foot=100.0)
OFF_EAST, ON_EAST = RAMP.leaves(1280.0, -1), RAMP.joins(1990.0, -1)
ON_WEST, OFF_WEST = RAMP.joins(1660.0, 1), RAMP.leaves(2280.0, 1)

DIVERGE_EAST, MERGE_EAST, DIVERGE_WEST, MERGE_WEST = (
    Node(id=100 + number, x=x, y=y, control=Control.NONE, setback=20.0)
    for number, x, y in ((11, 1275.0, -MEDIAN), (12, 1995.0, -MEDIAN), (13, 2285.0, MEDIAN), (14, 1655.0, MEDIAN))
)


def carriageways(ring: Node, out: float, end: Node) -> list[Street]:
    """Both carriageways, cut where lanes begin or cease; the limit is lower where they come to an end.

    Args:
        ring: The junction of the roundabout in which they end in the west, in the middle of the map's height.
        out: From the middle of the roundabout to where they begin [m].
        end: The junction in which they end in the east.
    """
    east, west = -MEDIAN, MEDIAN
    at_ring, at_end = (out, 0.0), (end.x - end.setback, end.y)
    eastbound = (
        Street(
            id=11,
            start=ring,
            end=12,
            lanes=2,
            start_at=at_ring,
            end_at=(180.0, east),
            via=((90.0, 0.0, SHIFT), (145.0, east, SHIFT)),
            surroundings=SLOW,
        ),
        *_past_ramps(12, east, (DIVERGE_EAST, MERGE_EAST), (180.0, 300.0, 950.0, 2330.0, 3260.0, 3400.0)),
        Street(
            id=19,
            start=18,
            end=end,
            lanes=2,
            start_at=(3400.0, east),
            end_at=at_end,
            via=((3440.0, east, SHIFT), (3500.0, 0.0, SHIFT)),
            surroundings=SLOW,
        ),
    )
    westbound = (
        Street(
            id=21,
            start=end,
            end=22,
            lanes=2,
            start_at=at_end,
            end_at=(3400.0, west),
            via=((3500.0, 0.0, SHIFT), (3440.0, west, SHIFT)),
            surroundings=SLOW,
        ),
        *_past_ramps(22, west, (DIVERGE_WEST, MERGE_WEST), (3400.0, 3260.0, 2610.0, 1320.0, 400.0, 260.0)),
        Street(
            id=29,
            start=28,
            end=ring,
            lanes=2,
            start_at=(260.0, west),
            end_at=at_ring,
            via=((145.0, west, SHIFT), (90.0, 0.0, SHIFT)),
            surroundings=SLOW,
        ),
    )
    return [
        replace(
            part,
            back=0,
            shoulder=HARD_SHOULDER,
            sidewalk=0.0,
            surroundings=SLOW if part.surroundings is SLOW else Surroundings.SLOWER_MOTORWAY,
        )
        for part in (*eastbound, *westbound)
    ]


def _past_ramps(first: int, y: float, ramps: tuple[Node, Node], cuts: tuple[float, ...]) -> tuple[Street, ...]:
    """One carriageway from where a third lane begins to where it has ceased, past an off-ramp and an on-ramp.

    Args:
        first: Id of its first street; those before and after it have the ids before and after its own.
        y: Of the carriageway [m].
        ramps: The junctions of the off-ramp and of the on-ramp.
        cuts: Where it is cut [m] beside these junctions, in driving order.
    """
    third, wide, fourth, merged, narrow, last = ((x, y) for x in cuts)
    diverge, merge = ramps
    gore = math.copysign(GORE, cuts[-1] - cuts[0])
    leaves, left = (diverge.x - gore, y), (diverge.x + gore, y)
    joins, joined = (merge.x - gore, y), (merge.x + gore, y)
    parts = (
        Street(id=first, start=first - 1, end=first + 1, lanes=3, start_at=third, end_at=wide, begins=TAPER),
        Street(id=first + 1, start=first, end=first + 2, lanes=3, start_at=wide, end_at=fourth),
        Street(id=first + 2, start=first + 1, end=diverge, lanes=4, start_at=fourth, end_at=leaves, begins=TAPER),
        Street(id=first + 3, start=diverge, end=merge, lanes=3, start_at=left, end_at=joins, nose=(NOSE, NOSE)),
        Street(id=first + 4, start=merge, end=first + 5, lanes=4, start_at=joined, end_at=merged, ceases=SPEEDING_UP),
        Street(id=first + 5, start=first + 4, end=first + 6, lanes=3, start_at=merged, end_at=narrow),
        Street(id=first + 6, start=first + 5, end=first + 7, lanes=3, start_at=narrow, end_at=last, ceases=DROP),
    )
    return (replace(parts[0], surroundings=SLOW), *parts[1:-1], replace(parts[-1], surroundings=SLOW))
