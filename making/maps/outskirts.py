"""The outskirts that come with chatscene: what lies around a town, as a plan, and the map file made from it.

A motorway from west to east with three lanes each way: eastbound an off-ramp and an on-ramp whose acceleration lane
tapers out, westbound an on-ramp and an off-ramp with a weaving section between them. Westbound its lanes are dropped
one by one before a roundabout with four arms; in the east it ends at a signalised crossing. South of it a rural road
with bends; north of it a street with sidewalks, a crosswalk between junctions, bus bays and parking places. All of it
is level: the world is flat, and a bridge would lay lanes of one road on those of another.

``python -m making.maps.outskirts`` writes the packaged file anew.
"""

from __future__ import annotations

import math
from dataclasses import replace

from chatscene.maps.network import PACKAGED
from chatscene.maps.writing.objects import Bay, Crosswalk, Use
from chatscene.maps.writing.opendrive import write_opendrive
from chatscene.maps.writing.rings import RingDesign
from chatscene.maps.writing.streets import LANE, Node, Street, Surroundings
from chatscene.terms.scenario import Control
from making.maps.designs import RampDesign

ISLAND = 20.0  # [m], radius of the roundabout's central island
RING = RingDesign(island=ISLAND, lane=4.5, lanes=1, flare=16.0)
ARM = 34.0  # [m] from its centre to where its arms end

MEDIAN = 2.0  # [m], half of what lies between the carriageways
EDGE = MEDIAN + 3 * LANE  # [m] from the middle of the motorway to where a fourth lane begins
HARD_SHOULDER = 2.5  # [m]
NOSE = 80.0  # [m], over which the hard shoulder gives way to a ramp
SHIFT = 1200.0  # [m], radius of the bends by which the carriageways part

EAST_END = 1160.0  # [m], where the motorway ends at a crossing
STREET, RURAL = 170.0, -170.0  # [m], where the street and the rural road run, north and south of the motorway

LEAVES, JOINS = math.radians(60), math.radians(55)  # how far ramps turn at the motorway
LEAVING, JOINING, FOOT = 110.0, 85.0, 50.0  # [m], radii of their bends there, and at the road they lead to
FOOT_AT = 100.0  # [m] from the middle of the motorway to the second bend


_OFF = RampDesign(edge=EDGE, turn=LEAVES, radius=LEAVING, foot_at=FOOT_AT, foot=FOOT)
_ON = RampDesign(edge=EDGE, turn=JOINS, radius=JOINING, foot_at=FOOT_AT, foot=FOOT)
OFF_EASTBOUND, ON_EASTBOUND = _OFF.leaves(410.0, -1), _ON.joins(760.0, -1)
ON_WESTBOUND, OFF_WESTBOUND = _ON.joins(890.0, 1), _OFF.leaves(630.0, 1)


def _node(number: int, x: float, y: float, control: Control = Control.NONE, setback: float = 20.0) -> Node:
    # CARLA takes the id of a junction for that of a road where there is such a road.
    return Node(id=100 + number, x=x, y=y, control=control, setback=setback)


RING_EAST, RING_NORTH = _node(1, ISLAND, 0.0), _node(2, 0.0, ISLAND)
RING_WEST, RING_SOUTH = _node(3, -ISLAND, 0.0), _node(4, 0.0, -ISLAND)
CROSSING = _node(5, EAST_END, 0.0, Control.SIGNAL, 26.0)
DIVERGE_EASTBOUND, MERGE_EASTBOUND = _node(6, 405.0, -MEDIAN), _node(7, 765.0, -MEDIAN)
MERGE_WESTBOUND, DIVERGE_WESTBOUND = _node(8, 885.0, MEDIAN), _node(9, 635.0, MEDIAN)
FROM_WESTBOUND, TO_WESTBOUND = _node(10, OFF_WESTBOUND[1][0], STREET), _node(11, ON_WESTBOUND[0][0], STREET)
FROM_EASTBOUND = _node(12, OFF_EASTBOUND[1][0], RURAL, Control.STOP_SIGN)
TO_EASTBOUND = _node(13, ON_EASTBOUND[0][0], RURAL)
CORNER = _node(14, EAST_END, STREET)
FORK = _node(15, 0.0, RURAL, Control.STOP_SIGN)


def plan() -> tuple[Street, ...]:
    """The streets of the outskirts."""
    ring = RING.streets(1, (RING_EAST, RING_NORTH, RING_WEST, RING_SOUTH), 0.0, 0.0)
    return (*ring, *_motorway(), *_ramps(), *_street(), *_rural_road())


def _motorway() -> list[Street]:
    """Both carriageways, cut where lanes begin or cease."""
    east, west = -MEDIAN, MEDIAN
    parting, meeting = (1010.0, 1090.0)
    eastbound = (
        Street(id=11, start=RING_EAST, end=12, lanes=1, start_at=(ARM, 0.0), end_at=(70.0, 0.0)),
        Street(id=12, start=11, end=13, lanes=2, start_at=(70.0, 0.0), end_at=(150.0, 0.0), begins=(10.0, 70.0)),
        Street(
            id=13,
            start=12,
            end=14,
            lanes=3,
            start_at=(150.0, 0.0),
            end_at=(270.0, east),
            via=((170.0, 0.0, SHIFT), (250.0, east, SHIFT)),
            begins=(10.0, 70.0),
        ),
        Street(
            id=14,
            start=13,
            end=DIVERGE_EASTBOUND,
            lanes=4,
            start_at=(270.0, east),
            end_at=(400.0, east),
            begins=(10.0, 60.0),
        ),
        Street(
            id=15,
            start=DIVERGE_EASTBOUND,
            end=MERGE_EASTBOUND,
            lanes=3,
            start_at=(410.0, east),
            end_at=(760.0, east),
            nose=(NOSE, NOSE),
        ),
        Street(
            id=16,
            start=MERGE_EASTBOUND,
            end=17,
            lanes=4,
            start_at=(770.0, east),
            end_at=(985.0, east),
            ceases=(140.0, 205.0),
        ),
        Street(
            id=17,
            start=16,
            end=CROSSING,
            lanes=3,
            start_at=(985.0, east),
            end_at=(EAST_END - CROSSING.setback, 0.0),
            via=((parting, east, SHIFT), (meeting, 0.0, SHIFT)),
        ),
    )
    westbound = (
        Street(
            id=21,
            start=CROSSING,
            end=MERGE_WESTBOUND,
            lanes=3,
            start_at=(EAST_END - CROSSING.setback, 0.0),
            end_at=(890.0, west),
            via=((meeting, 0.0, SHIFT), (parting, west, SHIFT)),
            nose=(0.0, NOSE),
        ),
        Street(
            id=22, start=MERGE_WESTBOUND, end=DIVERGE_WESTBOUND, lanes=4, start_at=(880.0, west), end_at=(640.0, west)
        ),
        Street(
            id=23,
            start=DIVERGE_WESTBOUND,
            end=24,
            lanes=3,
            start_at=(630.0, west),
            end_at=(330.0, 0.0),
            via=((470.0, west, SHIFT), (390.0, 0.0, SHIFT)),
            nose=(NOSE, 0.0),
        ),
        Street(id=24, start=23, end=25, lanes=3, start_at=(330.0, 0.0), end_at=(220.0, 0.0), ceases=(20.0, 100.0)),
        Street(id=25, start=24, end=26, lanes=2, start_at=(220.0, 0.0), end_at=(120.0, 0.0), ceases=(20.0, 90.0)),
        Street(id=26, start=25, end=RING_EAST, lanes=1, start_at=(120.0, 0.0), end_at=(ARM, 0.0)),
    )
    return [
        replace(part, back=0, shoulder=HARD_SHOULDER, sidewalk=0.0, surroundings=Surroundings.MOTORWAY)
        for part in (*eastbound, *westbound)
    ]


def _ramps() -> list[Street]:
    ramps = (
        Street(id=31, start=DIVERGE_EASTBOUND, end=FROM_EASTBOUND, lanes=1, via=OFF_EASTBOUND, start_at=(410.0, -EDGE)),
        Street(id=32, start=TO_EASTBOUND, end=MERGE_EASTBOUND, lanes=1, via=ON_EASTBOUND, end_at=(760.0, -EDGE)),
        Street(id=33, start=TO_WESTBOUND, end=MERGE_WESTBOUND, lanes=1, via=ON_WESTBOUND, end_at=(890.0, EDGE)),
        Street(id=34, start=DIVERGE_WESTBOUND, end=FROM_WESTBOUND, lanes=1, via=OFF_WESTBOUND, start_at=(630.0, EDGE)),
    )
    return [replace(ramp, back=0, sidewalk=0.0, surroundings=Surroundings.RAMP) for ramp in ramps]


def _street() -> list[Street]:
    """The street in the north, and the loop that brings the avenue east of the crossing back to it."""
    bays = (
        Bay(use=Use.BUS, right=False, start=30.0, end=95.0, width=3.0),
        Bay(use=Use.BUS, right=True, start=145.0, end=210.0, width=3.0),
        Bay(use=Use.PARKING, right=False, start=260.0, end=400.0, width=2.5),
        Bay(use=Use.PARKING, right=True, start=260.0, end=400.0, width=2.5),
    )
    joint = (1260.0, 0.0)
    far = 1340.0
    return [
        Street(
            id=41,
            start=RING_NORTH,
            end=FROM_WESTBOUND,
            lanes=1,
            start_at=(0.0, ARM),
            via=((0.0, STREET, 90.0),),
            sidewalk=0.0,
        ),
        Street(
            id=42,
            start=FROM_WESTBOUND,
            end=TO_WESTBOUND,
            lanes=1,
            bays=bays,
            crosswalks=(Crosswalk(at=120.0),),
        ),
        Street(id=43, start=TO_WESTBOUND, end=CORNER, lanes=1),
        Street(id=44, start=CROSSING, end=CORNER, lanes=1),
        Street(id=45, start=CROSSING, end=46, lanes=2, end_at=joint, ceases=(20.0, 64.0)),
        Street(id=46, start=45, end=CORNER, lanes=1, start_at=joint, via=((far, 0.0, 60.0), (far, STREET, 60.0))),
    ]


def _rural_road() -> list[Street]:
    """Two lanes with bends to both sides, from the roundabout to the crossing, and a short cut at the fork."""
    first = ((-160.0, 0.0, 120.0), (-290.0, -98.0, 100.0), (-290.0, -290.0, 60.0), (-190.0, -290.0, 80.0))
    second = ((150.0, RURAL, 150.0), (270.0, -230.0, 150.0), (390.0, RURAL, 150.0))
    third = ((770.0, RURAL, 150.0), (890.0, -240.0, 150.0), (EAST_END, -240.0, 100.0))
    parts = (
        Street(id=51, start=RING_WEST, end=FORK, lanes=1, start_at=(-ARM, 0.0), via=(*first, (-90.0, RURAL, 80.0))),
        Street(id=52, start=RING_SOUTH, end=FORK, lanes=1, start_at=(0.0, -ARM)),
        Street(id=53, start=FORK, end=FROM_EASTBOUND, lanes=1, via=second),
        Street(id=54, start=FROM_EASTBOUND, end=TO_EASTBOUND, lanes=1),
        Street(id=55, start=TO_EASTBOUND, end=CROSSING, lanes=1, via=third),
    )
    return [replace(part, sidewalk=0.0, surroundings=Surroundings.RURAL) for part in parts]


if __name__ == "__main__":
    PACKAGED["outskirts"].write_text(write_opendrive("outskirts", plan(), located=True), encoding="utf-8")
