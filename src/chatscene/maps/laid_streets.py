"""The plan of a road that is laid to order: its streets, and what lies along them."""

from __future__ import annotations

import math
from dataclasses import replace
from itertools import pairwise

from chatscene.maps.road_spec import HARD_SHOULDER, SIDEWALK, Along, LaidRoad, Ramp, Sides
from chatscene.maps.writing.objects import Bay, Crosswalk, Driveway, Use
from chatscene.maps.writing.streets import SHOULDER, Node, Street, Surroundings
from chatscene.terms.scenario import Control

STRIP = 2.2  # [m], a lane to park in
DRIVEN = 15.0  # [m] before the middle of the road, where a bay for buses begins
TURNS_LEAST, TURNS_MOST = math.radians(40), math.radians(150)
_DROPS = 80.0  # [m] over which a lane tapers out
_BUS = 65.0  # [m] of a bay for buses
_NOSE, _AT_NODE = 80.0, 5.0  # [m] beside a ramp in which the hard shoulder gives way; to where the two part or meet
_WITH_LANE = 330.0  # [m] of the lane for those who come from a ramp, or leave by it
_RAMP_LONG, _RAMP_TURN, _RAMP_RADIUS = 400.0, math.radians(12), 400.0  # [m], [rad], [m]

_SURROUNDINGS = {
    Along.TOWN: Surroundings.TOWN,
    Along.RESIDENTIAL: Surroundings.ZONE,
    Along.RURAL: Surroundings.COUNTRY,
    Along.MOTORWAY: Surroundings.SLOWER_MOTORWAY,
}

_USUAL = {Along.TOWN: 110, Along.RESIDENTIAL: 30, Along.RURAL: 80, Along.MOTORWAY: 110}  # [km/h] at most on such

Point = tuple[float, float]


def _surroundings(road: LaidRoad) -> Surroundings:
    """What a road is called: nothing of which its speed is more than counts."""
    faster = road.speed is not None and road.speed > _USUAL[road.along]
    return Surroundings.ANY if faster and road.along is not Along.MOTORWAY else _SURROUNDINGS[road.along]


def open_road(road: LaidRoad) -> tuple[Street, ...]:
    """The plan of a road without a junction: its streets, in the middle of which what it has lies."""
    a, corner, b, length = _line(road)
    parts = _directions(road, (a, corner, b), length)
    return tuple(part for street in parts for part in (_changing(road, street) if street.id == 1 else (street,)))


def _line(road: LaidRoad) -> tuple[Point, Point | None, Point, float]:
    """Where its middle line begins, where it would have its corner, where it ends, and how long it is [m]."""
    if (bend := road.bend) is None:
        return (-road.length / 2, 0.0), None, (road.length / 2, 0.0), float(road.length)
    angle = min(max(road.length / 2 / bend.radius, TURNS_LEAST), TURNS_MOST)
    straight = max((road.length - angle * bend.radius) / 2, 150.0)
    reach = straight + bend.radius * math.tan(angle / 2)
    up = math.copysign(reach * math.sin(angle), 1.0 if bend.left else -1.0)
    return (-reach, 0.0), (0.0, 0.0), (reach * math.cos(angle), up), 2 * straight + angle * bend.radius


def _directions(road: LaidRoad, line: tuple[Point, Point | None, Point], length: float) -> list[Street]:
    """One street along a line, or one for each direction where grass lies between them or there is only one."""
    a, corner, b = line
    via = () if corner is None or road.bend is None else ((*corner, road.bend.radius),)
    whole = street_of(road, Street(id=1, start=None, end=None, lanes=road.ahead, start_at=a, end_at=b, via=via), length)
    if not road.back:
        return [replace(whole, back=0, kerbs=True)]
    if not road.median:
        return [replace(whole, back=road.back)]
    half = road.median / 2
    ahead = replace(whole, back=0, median=half)
    return both_ways(ahead, replace(ahead, id=2, lanes=road.back, start_at=b, end_at=a), half, length)


def both_ways(ahead: Street, other: Street, half: float, length: float) -> list[Street]:
    """The two directions of a divided road, each half a median to the right of its middle."""
    sides = ((_aside(ahead, half), False), (_aside(other, half), True))
    return [_one_side(street, length, turned=turned) for street, turned in sides]


def _aside(street: Street, right: float) -> Street:
    """A street so far [m] to the right of the line that it is given."""
    assert street.start_at is not None and street.end_at is not None
    points = [street.start_at, *((x, y) for x, y, _ in street.via), street.end_at]
    ways = [math.atan2(q[1] - p[1], q[0] - p[0]) for p, q in pairwise(points)]

    def moved(at: Point, first: float, last: float) -> Point:
        middle = math.remainder(last - first, 2 * math.pi) / 2
        far, way = right / math.cos(middle), first + middle
        return at[0] + far * math.sin(way), at[1] - far * math.cos(way)

    corners = tuple(
        (*moved((x, y), *ways), radius + math.copysign(right, math.remainder(ways[1] - ways[0], 2 * math.pi)))
        for x, y, radius in street.via
    )
    return replace(
        street, start_at=moved(points[0], ways[0], ways[0]), end_at=moved(points[-1], ways[-1], ways[-1]), via=corners
    )


def street_of(road: LaidRoad, street: Street, length: float) -> Street:
    """A street of a road with what lies along and beside it."""
    outside = road.along in (Along.RURAL, Along.MOTORWAY)
    strip = HARD_SHOULDER if road.along is Along.MOTORWAY else SHOULDER
    bays = tuple(
        Bay(use=Use.PARKING, right=right, start=10.0, end=length - 10.0, width=STRIP) for right in _on(road.parking)
    )
    middle = length / 2
    if road.bus_bay:
        bays = (Bay(use=Use.BUS, right=True, start=middle - DRIVEN, end=middle - DRIVEN + _BUS, width=3.0),)
    return replace(
        street,
        lane=road.lane,
        shoulder=road.shoulder or strip,
        sidewalk=0.0 if outside else SIDEWALK,
        surroundings=_surroundings(road),
        allowed=road.speed,
        bays=bays,
        cycle=road.cycle_lane,
        tram=road.tram,
        bus_lane=road.bus_lane and street.id in (1, 2) and street.lanes > 1,
        ridden=road.ridden and street.id in (1, 2) and street.lanes > 1,
        crosswalks=(Crosswalk(at=middle),) if road.crosswalk and road.junction is None else (),
        driveways=tuple(Driveway(right=right, at=middle, width=road.mouth) for right in _on(road.driveway)),
    )


def _on(sides: Sides | None) -> tuple[bool, ...]:
    """For each of some sides, whether it is the right one."""
    return {None: (), Sides.LEFT: (False,), Sides.RIGHT: (True,), Sides.BOTH: (True, False)}[sides]


def _one_side(street: Street, length: float, *, turned: bool) -> Street:
    """One direction of a road with what lies on the right of it, seen from its own start."""
    bays = tuple(
        replace(one, right=True, start=length - one.end, end=length - one.start) if turned else one
        for one in street.bays
        if one.right is not turned
    )
    ways = tuple(replace(one, right=True) for one in street.driveways if one.right is not turned)
    return replace(street, bays=bays, driveways=ways)


def _changing(road: LaidRoad, street: Street) -> tuple[Street, ...]:
    """A street of which the lanes change on the way, in parts that follow each other."""
    return _dropping(road, street) if road.ramp is None else _with_ramp(road, street)


def _with_ramp(road: LaidRoad, street: Street) -> tuple[Street, ...]:
    """The carriageway ahead with a ramp at its middle, and a lane that leads to it or that ends beyond it."""
    assert street.start_at is not None and street.end_at is not None
    lane, y = street.lane, street.start_at[1]
    edge = y - street.lanes * lane
    node = Node(id=101, x=0.0, y=y, control=Control.NONE)
    leads = replace(street, lanes=1, sidewalk=0.0, median=0.0, nose=(0.0, 0.0), via=())
    aside = (_RAMP_LONG * math.cos(_RAMP_TURN), _RAMP_LONG * math.sin(_RAMP_TURN))
    if road.ramp is Ramp.ON:
        joint = (_WITH_LANE + 10.0, y)
        ramp = replace(
            leads,
            id=5,
            end=node,
            start_at=(-_NOSE - aside[0], edge - aside[1]),
            via=((-_NOSE, edge, _RAMP_RADIUS),),
            end_at=(-_AT_NODE, edge),
        )
        before = replace(street, end=node, end_at=(-_AT_NODE, y), nose=(0.0, _NOSE))
        beside = replace(street, id=3, start=node, end=4, start_at=(_AT_NODE, y), end_at=joint, lanes=street.lanes + 1)
        length = joint[0] - _AT_NODE
        return (
            ramp,
            before,
            replace(beside, ceases=(length - 80.0, length - 10.0)),
            replace(street, id=4, start=3, start_at=joint),
        )
    joint = (-_WITH_LANE - 10.0, y)
    ramp = replace(
        leads,
        id=5,
        start=node,
        start_at=(_AT_NODE, edge),
        via=((_NOSE, edge, _RAMP_RADIUS),),
        end_at=(_NOSE + aside[0], edge - aside[1]),
    )
    before = replace(street, end=3, end_at=joint)
    beside = replace(street, id=3, start=1, end=node, start_at=joint, end_at=(-_AT_NODE, y), lanes=street.lanes + 1)
    beyond = replace(street, id=4, start=node, start_at=(_AT_NODE, y), nose=(_NOSE, 0.0))
    return ramp, before, replace(beside, begins=(10.0, 80.0)), beyond


def _dropping(road: LaidRoad, street: Street) -> tuple[Street, ...]:
    """A street whose outermost lane ends before its middle: two, that follow each other."""
    if not road.drops:
        return (street,)
    first = road.length * 0.6
    ends = (first - _DROPS - 20.0, first - 20.0)
    if road.drop_left:
        return (replace(street, inner=ends),)
    assert street.start_at is not None and street.end_at is not None
    joint = (street.start_at[0] + first, street.start_at[1])
    before = replace(street, end=3, end_at=joint, ceases=ends, one_sided=True)
    beyond = replace(street, id=3, start=1, start_at=joint, lanes=road.ahead - 1)
    return before, beyond
