"""The region that comes with chatscene: roads that are long enough for 50, 80 and 120 km/h, as a plan, and its file.

In the middle a motorway of 3 km from west to east with three lanes each way, an off-ramp and an on-ramp on either side
with lanes of 250 m to slow down and to speed up. In the west it ends in a roundabout of two lanes, in the east at a
signalised junction. North of it a town whose junctions are 450 m apart: an arterial with two lanes each way, divided by
grass in the east, streets, a zone of 30 km/h, a compact roundabout, crosswalks between and at junctions, cycle lanes,
rails along a street and across one, a car park. South of it rural roads with long straights and bends of 150, 250 and
400 m, and rails across one. All of it is level, as in the outskirts.

``python -m making.maps.region`` writes the packaged file anew.
"""

from __future__ import annotations

import math
from dataclasses import replace

from chatscene.maps.network import PACKAGED
from chatscene.maps.writing.objects import Bay, Crosswalk, Use
from chatscene.maps.writing.opendrive import write_opendrive
from chatscene.maps.writing.rings import RingDesign
from chatscene.maps.writing.streets import Node, Street, Surroundings
from chatscene.terms.scenario import Control
from making.maps.designs import CarParkDesign
from making.maps.region_motorway import (
    DIVERGE_EAST,
    DIVERGE_WEST,
    EDGE,
    MERGE_EAST,
    MERGE_WEST,
    OFF_EAST,
    OFF_WEST,
    ON_EAST,
    ON_WEST,
    carriageways,
)

# Roundabouts
LARGE, LARGE_ARM = RingDesign(island=32.0, lane=4.5, lanes=2, flare=22.0), 52.0
COMPACT, COMPACT_ARM = RingDesign(island=10.0, lane=5.0, lanes=1, flare=12.0), 20.0

# Rows and columns of the town, and of the rural roads [m]
SOUTH_ROW, ARTERIAL, NORTH_ROW, ZONE = 350.0, 800.0, 1250.0, 1700.0
FIRST, SECOND, THIRD, FOURTH, FIFTH, EAST = 450.0, 900.0, 1350.0, 1900.0, 2450.0, 3600.0
RURAL, FARTHER, FARTHEST = -400.0, -1000.0, -1500.0
FORK, CROSSROADS, BYWAY = 850.0, 850.0, 1350.0
VERGE = 2.0  # [m], half of the arterial's median
PARTING = 600.0  # [m], radius of the bends by which its carriageways part
TURN = 20.0  # [m] from the middle of a junction to where its arms end


def _node(
    number: int, x: float, y: float, control: Control = Control.NONE, *, setback: float = TURN, abreast: bool = False
) -> Node:
    # CARLA takes the id of a junction for that of a road where there is such a road.
    return Node(id=100 + number, x=x, y=y, control=control, setback=setback, abreast=abreast)


def _ring_nodes(first: int, x: float, y: float, island: float) -> tuple[Node, Node, Node, Node]:
    east, north, west, south = (
        _node(first + i, x + island * math.cos(i * math.pi / 2), y + island * math.sin(i * math.pi / 2), abreast=True)
        for i in range(4)
    )
    return east, north, west, south


def _marked(number: int, x: float, y: float, control: Control = Control.NONE) -> Node:
    """A junction of the town, with a crosswalk across each of its arms."""
    return replace(_node(number, x, y, control), marked=True)


_STOP, _SIGNAL = Control.STOP_SIGN, Control.SIGNAL
LARGE_NODES = _ring_nodes(1, 0.0, 0.0, LARGE.island)
COMPACT_NODES = _ring_nodes(5, FIRST, NORTH_ROW, COMPACT.island)
MOTORWAY_END = _node(15, EAST, 0.0, _SIGNAL, setback=26.0, abreast=True)  # two lanes turn each way
# Along the arterial: four arms with lights, stop signs and nothing, then three, then four with a median, then three.
ARTERIAL_NODES = (
    _marked(21, FIRST, ARTERIAL, _SIGNAL),
    _marked(22, SECOND, ARTERIAL, _STOP),
    _marked(23, THIRD, ARTERIAL),
    _marked(24, FOURTH, ARTERIAL, _SIGNAL),
    _marked(25, FIFTH, ARTERIAL, _SIGNAL),
    _marked(26, EAST, ARTERIAL, _STOP),
)
NORTH_NODES = (
    _marked(31, SECOND, NORTH_ROW),
    _marked(32, THIRD, NORTH_ROW, _STOP),
    _marked(33, FOURTH, NORTH_ROW, _SIGNAL),
    _marked(34, FIFTH, NORTH_ROW, _STOP),
)
SOUTH_NODES = (
    _marked(41, SECOND, SOUTH_ROW),
    _marked(42, THIRD, SOUTH_ROW, _SIGNAL),
    _node(43, ON_WEST[0][0], SOUTH_ROW),
    _node(44, OFF_WEST[1][0], SOUTH_ROW, _STOP),
    _marked(45, FIFTH, SOUTH_ROW, _STOP),
    _marked(46, EAST, SOUTH_ROW),
)
RURAL_FORK, RURAL_CROSSROADS, RURAL_BYWAY = (
    _node(51, FORK, RURAL, _STOP),
    _node(52, CROSSROADS, FARTHER),
    _node(53, BYWAY, FARTHER),
)
RURAL_OFF, RURAL_ON = _node(54, OFF_EAST[1][0], RURAL, _STOP), _node(55, ON_EAST[0][0], RURAL)

CAR_PARK = CarParkDesign(x=225.0, north=1640.0, south=1600.0, half=160.0, setback=8.0)
LOT_NODES = (
    _node(61, CAR_PARK.x, ZONE),
    _node(62, CAR_PARK.x, CAR_PARK.north, setback=CAR_PARK.setback),
    _node(63, CAR_PARK.x, CAR_PARK.south, setback=CAR_PARK.setback),
)


def plan() -> tuple[Street, ...]:
    """The streets of the region."""
    large = LARGE.streets(1, LARGE_NODES, 0.0, 0.0)
    compact = COMPACT.streets(5, COMPACT_NODES, FIRST, NORTH_ROW)
    return (
        *large,
        *compact,
        *carriageways(LARGE_NODES[0], LARGE_ARM, MOTORWAY_END),
        *_ramps(),
        *_arterial(),
        *_divided(),
        *_columns(),
        *_rows(),
        *_rural_roads(),
        *CAR_PARK.streets(201, LOT_NODES),
    )


def _ramps() -> list[Street]:
    _, _, to_west, from_west, *_ = SOUTH_NODES
    ramps = (
        Street(id=31, start=DIVERGE_EAST, end=RURAL_OFF, lanes=1, via=OFF_EAST, start_at=(1280.0, -EDGE)),
        Street(id=32, start=RURAL_ON, end=MERGE_EAST, lanes=1, via=ON_EAST, end_at=(1990.0, -EDGE)),
        Street(id=33, start=to_west, end=MERGE_WEST, lanes=1, via=ON_WEST, end_at=(1660.0, EDGE)),
        Street(id=34, start=DIVERGE_WEST, end=from_west, lanes=1, via=OFF_WEST, start_at=(2280.0, EDGE)),
    )
    return [replace(ramp, back=0, sidewalk=0.0, surroundings=Surroundings.RAMP) for ramp in ramps]


def _arterial() -> list[Street]:
    """Two lanes each way: from the large roundabout north and east, and from the motorway's end north."""
    first, second, third, fourth, _, last = ARTERIAL_NODES
    return [
        Street(
            id=41,
            start=LARGE_NODES[1],
            end=first,
            lanes=2,
            start_at=(0.0, LARGE_ARM),
            via=((0.0, ARTERIAL, 100.0),),
        ),
        Street(id=42, tram=True, start=first, end=second, lanes=2, crosswalks=(Crosswalk(at=260.0),)),
        Street(id=43, tram=True, start=second, end=third, lanes=2),
        Street(id=44, tram=True, start=third, end=fourth, lanes=2),
        Street(id=45, start=MOTORWAY_END, end=SOUTH_NODES[-1], lanes=2),
        Street(id=46, start=SOUTH_NODES[-1], end=last, lanes=2),
        Street(id=47, start=last, end=48, lanes=2, end_at=(EAST, 1000.0), ceases=(20.0, 80.0)),
        Street(
            id=48,
            start=47,
            end=NORTH_NODES[-1],
            lanes=1,
            start_at=(EAST, 1000.0),
            via=((EAST, NORTH_ROW, 100.0),),
        ),
    ]


def _divided() -> list[Street]:
    """The arterial in the east: two carriageways with grass between them, which is open at a junction."""
    *_, fourth, fifth, last = ARTERIAL_NODES
    south, north = ARTERIAL - VERGE, ARTERIAL + VERGE
    parted = FOURTH + 130.0, EAST - 130.0  # between which they run side by side
    west_bends = ((FOURTH + 45.0, ARTERIAL, PARTING), (FOURTH + 105.0, south, PARTING))
    east_bends = ((EAST - 105.0, south, PARTING), (EAST - 45.0, ARTERIAL, PARTING))
    back_east = ((EAST - 45.0, ARTERIAL, PARTING), (EAST - 105.0, north, PARTING))
    back_west = ((FOURTH + 105.0, north, PARTING), (FOURTH + 45.0, ARTERIAL, PARTING))
    before, beyond = FIFTH - TURN, FIFTH + TURN
    far = 500.0  # [m] from the opening to a crosswalk
    parts = (
        Street(id=51, start=fourth, end=52, lanes=2, via=west_bends, end_at=(parted[0], south)),
        Street(id=52, start=51, end=fifth, lanes=2, start_at=(parted[0], south), end_at=(before, south), median=VERGE),
        Street(
            id=53,
            start=fifth,
            end=54,
            lanes=2,
            start_at=(beyond, south),
            end_at=(parted[1], south),
            median=VERGE,
            crosswalks=(Crosswalk(at=far),),
        ),
        Street(id=54, start=53, end=last, lanes=2, start_at=(parted[1], south), via=east_bends),
        Street(id=55, start=last, end=56, lanes=2, via=back_east, end_at=(parted[1], north)),
        Street(
            id=56,
            start=55,
            end=fifth,
            lanes=2,
            start_at=(parted[1], north),
            end_at=(beyond, north),
            median=VERGE,
            crosswalks=(Crosswalk(at=parted[1] - beyond - far),),
        ),
        Street(id=57, start=fifth, end=58, lanes=2, start_at=(before, north), end_at=(parted[0], north), median=VERGE),
        Street(id=58, start=57, end=fourth, lanes=2, start_at=(parted[0], north), via=back_west),
    )
    return [replace(part, back=0) for part in parts]


def _columns() -> list[Street]:
    """Streets from south to north."""
    return [
        Street(
            id=61,
            start=ARTERIAL_NODES[0],
            end=SOUTH_NODES[0],
            lanes=1,
            via=((FIRST, SOUTH_ROW, 60.0),),
        ),
        Street(id=62, start=SOUTH_NODES[0], end=ARTERIAL_NODES[1], lanes=1),
        Street(id=63, cycle=True, start=SOUTH_NODES[1], end=ARTERIAL_NODES[2], lanes=1),
        Street(id=64, start=SOUTH_NODES[4], end=ARTERIAL_NODES[4], lanes=1),
        Street(
            id=65,
            start=ARTERIAL_NODES[0],
            end=COMPACT_NODES[3],
            lanes=1,
            end_at=(FIRST, NORTH_ROW - COMPACT_ARM),
        ),
        Street(id=66, cycle=True, start=ARTERIAL_NODES[1], end=NORTH_NODES[0], lanes=1),
        Street(id=67, cycle=True, start=ARTERIAL_NODES[2], end=NORTH_NODES[1], lanes=1),
        Street(id=68, cycle=True, start=ARTERIAL_NODES[3], end=NORTH_NODES[2], lanes=1),
        Street(id=69, start=ARTERIAL_NODES[4], end=NORTH_NODES[3], lanes=1),
    ]


def _rows() -> list[Street]:
    """Streets from west to east: the north row from the compact roundabout, the south row past the ramps."""
    zone_bays = (
        Bay(use=Use.PARKING, right=True, start=480.0, end=800.0, width=2.5),
        Bay(use=Use.PARKING, right=False, start=480.0, end=800.0, width=2.5),
    )
    bus_bays = (
        Bay(use=Use.BUS, right=False, start=240.0, end=310.0, width=3.0),
        Bay(use=Use.BUS, right=True, start=330.0, end=400.0, width=3.0),
    )
    return [
        Street(
            id=71,
            cycle=True,
            start=COMPACT_NODES[0],
            end=NORTH_NODES[0],
            lanes=1,
            start_at=(FIRST + COMPACT_ARM, NORTH_ROW),
        ),
        Street(
            id=72,
            start=COMPACT_NODES[1],
            end=LOT_NODES[0],
            lanes=1,
            start_at=(FIRST, NORTH_ROW + COMPACT_ARM),
            via=((FIRST, ZONE, 60.0),),
        ),
        Street(
            id=77,
            start=LOT_NODES[0],
            end=COMPACT_NODES[2],
            lanes=1,
            end_at=(FIRST - COMPACT_ARM, NORTH_ROW),
            via=((0.0, ZONE, 60.0), (0.0, NORTH_ROW, 60.0)),
        ),
        Street(id=73, cycle=True, start=NORTH_NODES[0], end=NORTH_NODES[1], lanes=1),
        Street(id=74, cycle=True, start=NORTH_NODES[1], end=NORTH_NODES[2], lanes=1),
        Street(id=75, cycle=True, start=NORTH_NODES[2], end=NORTH_NODES[3], lanes=1),
        Street(
            id=76,
            start=NORTH_NODES[1],
            end=NORTH_NODES[2],
            lanes=1,
            via=((THIRD, ZONE, 40.0), (FOURTH, ZONE, 40.0)),
            surroundings=Surroundings.ZONE,
            bays=zone_bays,
            crosswalks=(Crosswalk(at=300.0),),
        ),
        Street(id=81, start=SOUTH_NODES[0], end=SOUTH_NODES[1], lanes=1),
        Street(id=82, start=SOUTH_NODES[1], end=SOUTH_NODES[2], lanes=1, bays=bus_bays),
        Street(id=83, start=SOUTH_NODES[2], end=SOUTH_NODES[3], lanes=1),
        Street(id=84, start=SOUTH_NODES[3], end=SOUTH_NODES[4], lanes=1),
        Street(
            id=85, start=SOUTH_NODES[4], end=SOUTH_NODES[5], lanes=1, crosswalks=(Crosswalk(at=550.0),), rails=(850.0,)
        ),
    ]


def _rural_roads() -> list[Street]:
    """From the large roundabout to the motorway's end, and round by the south."""
    joint = (-430.0, 0.0)
    bends = ((2450.0, RURAL, 250.0), (2850.0, -735.0, 250.0), (EAST, -735.0, 400.0))
    parts = (
        Street(
            id=91,
            start=LARGE_NODES[3],
            end=RURAL_FORK,
            lanes=1,
            start_at=(0.0, -LARGE_ARM),
            via=((0.0, RURAL, 150.0),),
            crosswalks=(Crosswalk(at=850.0),),
        ),
        Street(id=92, start=RURAL_FORK, end=RURAL_OFF, lanes=1),
        Street(id=93, start=RURAL_OFF, end=RURAL_ON, lanes=1),
        Street(id=94, start=RURAL_ON, end=MOTORWAY_END, lanes=1, via=bends),
        Street(
            id=95,
            start=LARGE_NODES[2],
            end=96,
            lanes=2,
            start_at=(-LARGE_ARM, 0.0),
            end_at=joint,
            ceases=(310.0, 370.0),
        ),
        Street(
            id=96,
            start=95,
            end=RURAL_CROSSROADS,
            lanes=1,
            start_at=joint,
            via=((-800.0, 0.0, 250.0), (-800.0, FARTHER, 150.0)),
        ),
        Street(id=97, rails=(300.0,), start=RURAL_FORK, end=RURAL_CROSSROADS, lanes=1),
        Street(id=98, start=RURAL_CROSSROADS, end=RURAL_BYWAY, lanes=1),
        Street(id=99, start=RURAL_BYWAY, end=RURAL_ON, lanes=1, via=((ON_EAST[0][0], FARTHER, 250.0),)),
        Street(
            id=90,
            start=RURAL_CROSSROADS,
            end=RURAL_BYWAY,
            lanes=1,
            via=((CROSSROADS, FARTHEST, 150.0), (BYWAY, FARTHEST, 150.0)),
        ),
    )
    return [replace(part, sidewalk=0.0, surroundings=Surroundings.COUNTRY) for part in parts]


if __name__ == "__main__":
    PACKAGED["region"].write_text(write_opendrive("region", plan(), located=True), encoding="utf-8")
