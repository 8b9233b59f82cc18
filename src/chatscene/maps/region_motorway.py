"""The motorway of the region: two carriageways with an off-ramp and an on-ramp each, from a roundabout to lights."""

from __future__ import annotations

import math
from dataclasses import replace

from chatscene.maps.designs import RampDesign
from chatscene.maps.opendrive import LANE, Node, Street, Surroundings
from chatscene.terms.scenario import Control

MEDIAN = 2.0  # [m], half of what lies between the carriageways
EDGE = MEDIAN + 3 * LANE  # [m] from the middle of the motorway to where a fourth lane begins
HARD_SHOULDER = 2.5  # [m]
NOSE = 80.0  # [m], over which the hard shoulder gives way to a ramp
TAPER = (10.0, 70.0)  # [m], from where to where a fourth lane comes into being
SPEEDING_UP = (250.0, 320.0)  # [m] in it, from where to where it tapers out
SHIFT = 1200.0  # [m], radius of the bends by which the carriageways part
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
    slow = Surroundings.MOTORWAY_END
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
            surroundings=slow,
        ),
        Street(
            id=12,
            start=11,
            end=13,
            lanes=3,
            start_at=(180.0, east),
            end_at=(300.0, east),
            begins=TAPER,
            surroundings=slow,
        ),
        Street(id=13, start=12, end=14, lanes=3, start_at=(300.0, east), end_at=(950.0, east)),
        Street(id=14, start=13, end=DIVERGE_EAST, lanes=4, start_at=(950.0, east), end_at=(1270.0, east), begins=TAPER),
        Street(
            id=15,
            start=DIVERGE_EAST,
            end=MERGE_EAST,
            lanes=3,
            start_at=(1280.0, east),
            end_at=(1990.0, east),
            nose=(NOSE, NOSE),
        ),
        Street(
            id=16, start=MERGE_EAST, end=17, lanes=4, start_at=(2000.0, east), end_at=(2330.0, east), ceases=SPEEDING_UP
        ),
        Street(id=17, start=16, end=18, lanes=3, start_at=(2330.0, east), end_at=(3260.0, east)),
        Street(
            id=18,
            start=17,
            end=19,
            lanes=3,
            start_at=(3260.0, east),
            end_at=(3400.0, east),
            ceases=(20.0, 120.0),
            surroundings=slow,
        ),
        Street(
            id=19,
            start=18,
            end=end,
            lanes=2,
            start_at=(3400.0, east),
            end_at=at_end,
            via=((3440.0, east, SHIFT), (3500.0, 0.0, SHIFT)),
            surroundings=slow,
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
            surroundings=slow,
        ),
        Street(
            id=22,
            start=21,
            end=23,
            lanes=3,
            start_at=(3400.0, west),
            end_at=(3260.0, west),
            begins=TAPER,
            surroundings=slow,
        ),
        Street(id=23, start=22, end=24, lanes=3, start_at=(3260.0, west), end_at=(2610.0, west)),
        Street(
            id=24, start=23, end=DIVERGE_WEST, lanes=4, start_at=(2610.0, west), end_at=(2290.0, west), begins=TAPER
        ),
        Street(
            id=25,
            start=DIVERGE_WEST,
            end=MERGE_WEST,
            lanes=3,
            start_at=(2280.0, west),
            end_at=(1660.0, west),
            nose=(NOSE, NOSE),
        ),
        Street(
            id=26, start=MERGE_WEST, end=27, lanes=4, start_at=(1650.0, west), end_at=(1320.0, west), ceases=SPEEDING_UP
        ),
        Street(id=27, start=26, end=28, lanes=3, start_at=(1320.0, west), end_at=(400.0, west)),
        Street(
            id=28,
            start=27,
            end=29,
            lanes=3,
            start_at=(400.0, west),
            end_at=(260.0, west),
            ceases=(20.0, 120.0),
            surroundings=slow,
        ),
        Street(
            id=29,
            start=28,
            end=ring,
            lanes=2,
            start_at=(260.0, west),
            end_at=at_ring,
            via=((145.0, west, SHIFT), (90.0, 0.0, SHIFT)),
            surroundings=slow,
        ),
    )
    return [
        replace(
            part,
            back=0,
            shoulder=HARD_SHOULDER,
            sidewalk=0.0,
            surroundings=slow if part.surroundings is slow else Surroundings.SLOWER_MOTORWAY,
        )
        for part in (*eastbound, *westbound)
    ]
