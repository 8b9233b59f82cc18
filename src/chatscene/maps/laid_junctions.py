"""The plan of a junction or a roundabout that is laid to order: its arms, and what they meet in."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from chatscene.maps.laid_streets import Point, both_ways, street_of
from chatscene.maps.road_spec import SIDEWALK, LaidRoad, Sides, Signs
from chatscene.maps.writing.objects import MARKED, Crosswalk
from chatscene.maps.writing.rings import RingDesign
from chatscene.maps.writing.streets import SETBACK, Node, Street
from chatscene.terms.scenario import Control

_OWN, _BEYOND = 1, 2  # the numbers of the road's own arm, and of that straight on
_BACK = 10  # by which the id of a street is greater that leads the other way, with grass between
_RING = 21  # the id of the first street of a ring
_NODE = 100  # by which the id of a junction is greater than the number of its arm, or than 1
_KERB = 6.0  # [m] between the lanes of a crossing road and where the arms of a junction end
_CONTROL = {None: Control.NONE, Signs.SIGNAL: Control.SIGNAL}


def meeting(road: LaidRoad) -> tuple[Street, ...]:
    """A road with a junction in its middle, and the other arms of that."""
    assert road.junction is not None
    if (ring := road.design) is not None:
        nodes = _nodes_of_ring(road, ring)
        return (*_ring_streets(road, ring, nodes), *_arms(road, nodes, ring.reach))
    node = _node(road)
    return tuple(_arms(road, dict.fromkeys((_OWN, *road.junction.arms), node), node.setback))


def _node(road: LaidRoad) -> Node:
    """The junction of all arms, whose minor ones have its signs where not all have."""
    assert road.junction is not None
    arms = tuple(number for number in road.junction.arms if number != _BEYOND)
    own = (_OWN, _OWN + _BACK) if _BEYOND not in road.junction.arms else (1, 2, 1 + _BACK, 2 + _BACK)
    side = arms if _BEYOND in road.junction.arms else own  # of a T or a Y, the stem
    minor = {Signs.SIDE_STOP: side, Signs.SIDE_YIELD: side, Signs.YIELD: own}.get(road.signs, ()) if road.signs else ()
    lanes = max(road.ahead + (road.turn_lane is not None), road.back, road.side)
    wide = lanes * road.lane + road.median / 2 + _KERB + SIDEWALK
    return Node(
        id=_NODE + 1,
        x=0.0,
        y=0.0,
        control=_CONTROL.get(road.signs, Control.STOP_SIGN),
        setback=max(SETBACK, wide / min(1.0, math.tan(math.radians(road.junction.narrowest) / 2))),
        marked=road.crosswalk,
        minor=minor,
        gives_way=road.signs in (Signs.YIELD, Signs.SIDE_YIELD),
    )


def _nodes_of_ring(road: LaidRoad, ring: RingDesign) -> dict[int, Node]:
    """The junctions of a ring, one at each arm, which has the sign, counter-clockwise from the road's own."""
    assert road.junction is not None
    angles = {_OWN: 180.0} | {number: angle % 360.0 for number, angle in road.junction.arms.items()}
    return {
        number: Node(
            id=_NODE + number,
            x=ring.island * (toward := _toward(angles[number]))[0],
            y=ring.island * toward[1],
            control=Control.STOP_SIGN,
            abreast=True,
            minor=(number, number + _BACK),
            gives_way=True,
        )
        for number in sorted(angles, key=lambda number: (angles[number] - 180.0) % 360.0)
    }


def _ring_streets(road: LaidRoad, ring: RingDesign, nodes: Mapping[int, Node]) -> list[Street]:
    assert road.junction is not None
    angles = [math.pi, *(math.radians(road.junction.arms[number] % 360.0) for number in nodes if number != _OWN)]
    angles = [angle if angle >= math.pi else angle + 2 * math.pi for angle in angles]
    plain = replace(road, parking=None, cycle_lane=False, ridden=False, bus_lane=False, driveway=None)
    return [
        replace(
            street_of(plain, part, 1.0),
            lane=ring.lane,
            shoulder=ring.shoulder,
            sidewalk=ring.sidewalk,
            crosswalks=(),
        )
        for part in ring.streets(_RING, [*nodes.values()], 0.0, 0.0, angles)
    ]


def _toward(angle: float) -> Point:
    """A direction [degrees] as a vector."""
    return round(math.cos(math.radians(angle)), 12), round(math.sin(math.radians(angle)), 12)


def _arms(road: LaidRoad, nodes: Mapping[int, Node], near: float) -> list[Street]:
    """The arms of a junction, each as one street, or as two with grass between them, from `near` [m] its middle on."""
    assert road.junction is not None
    main = replace(road, driveway=None)
    own = {"parking": None, "bus_lane": False, "cycle_lane": False, "ridden": False, "tram": False}
    side = replace(main, ahead=road.side, back=road.side, median=0.0, turn_lane=None, **own)
    length = road.length / 2 - near
    streets: list[Street] = []
    for number, angle in {_OWN: 180.0, **road.junction.arms}.items():
        part = main if number in (_OWN, _BEYOND) else side
        x, y = _toward(angle)
        inner, outer = (near * x, near * y), (road.length / 2 * x, road.length / 2 * y)
        comes = number == _OWN
        street = Street(
            id=number,
            start=None if comes else nodes[number],
            end=nodes[number] if comes else None,
            lanes=part.ahead + (comes and road.turn_lane is not None),
            back=part.back,
            start_at=outer if comes else inner,
            end_at=inner if comes else outer,
        )
        made = street_of(part, street, length)
        if road.crosswalk and road.ring:  # across the arms, and not across the ring
            made = replace(made, crosswalks=(Crosswalk(at=length - MARKED if comes else MARKED),))
        streets += _parted(part, made, length)
    return streets


def _parted(road: LaidRoad, street: Street, length: float) -> list[Street]:
    """An arm of a junction as one street, or as one for each direction with grass between them.

    Opposite a lane for who turns left, grass as wide as that lies on the right of the middle.
    """
    left = road.turn_lane is Sides.LEFT and street.id == _BEYOND
    if not (road.median or left):
        return [street]
    half = (road.lane if left else road.median) / 2
    assert street.start_at is not None and street.end_at is not None
    ahead = replace(street, back=0, median=half)
    marked = tuple(replace(one, at=length - one.at) for one in street.crosswalks)
    turned = replace(
        ahead, crosswalks=marked, start=street.end, end=street.start, start_at=street.end_at, end_at=street.start_at
    )
    other = replace(turned, id=street.id + _BACK, lanes=road.back)
    parts = both_ways(ahead, other, half, length)
    return [_beside(part, half) for part in parts] if left else parts


def _beside(street: Street, right: float) -> Street:
    """A street of the arm straight on, so far [m] to the right of where it is, seen along the road."""
    (x0, y0), (x1, y1) = street.start_at or (0.0, 0.0), street.end_at or (0.0, 0.0)
    return replace(street, start_at=(x0, y0 - right), end_at=(x1, y1 - right))
