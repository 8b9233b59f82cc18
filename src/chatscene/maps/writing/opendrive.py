"""Write OpenDRIVE 1.7 from a short plan of junctions and streets.

The form is the one that parsers agree on: one road per two-way street or per carriageway, one connecting road per
lane-to-lane manoeuvre, lines and arcs only, signals on the connecting roads they control, shoulder and sidewalk
carried round corners by the right-turn connectors and along the flat side of a T.
Source: ASAM OpenDRIVE 1.7.0, sections 8 (roads), 9 (lanes), 10 (junctions), 11 (objects), 12 (signals).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from xml.etree import ElementTree as Xml

from chatscene.maps.furniture import TRAFFIC_LIGHT
from chatscene.maps.writing.objects import GIVE_WAY_SIGN, STOP_SIGN, Bay, Use, decimal, furnish, signal_on
from chatscene.maps.writing.reference_lines import (
    Piece,
    Pose,
    after,
    end_of,
    line_arc_line,
    rounded_line,
    wrapped,
)
from chatscene.maps.writing.streets import LANE, RIDDEN, Node, Street
from chatscene.terms.scenario import Control

NOWHERE = "+proj=tmerc +lat_0=0 +lon_0=0 +k=1 +x_0=0 +y_0=0 +datum=WGS84 +units=m +no_defs"  # in the Gulf of Guinea
_MARGIN = 30.0  # [m] between reference lines and the bounds in the header: the widest half of a road, and some
_IN_LINE = 1e-3  # [rad]


@dataclass(frozen=True, slots=True)
class _Arm:
    """A street where it meets a junction; `pose` looks out of the junction, along the street."""

    street: Street
    at_start: bool
    pose: Pose

    @property
    def lanes_in(self) -> int:
        return self.street.lanes_back if self.at_start else self.street.lanes

    @property
    def lanes_out(self) -> int:
        return self.street.lanes if self.at_start else self.street.lanes_back

    @property
    def ridden_in(self) -> bool:
        """Whether the outermost lane that leads into the junction is for bicycles."""
        return self.street.ridden and not self.at_start

    @property
    def ridden_out(self) -> bool:
        """Whether the outermost lane that leads out of it is."""
        return self.street.ridden and self.at_start

    def incoming(self, lane: int) -> int:
        """OpenDRIVE id of the `lane`-th lane (from 1, innermost first) that leads into the junction."""
        return lane if self.at_start else -lane

    def outgoing(self, lane: int) -> int:
        """OpenDRIVE id of the `lane`-th lane that leads out of the junction."""
        return -self.incoming(lane)

    def before(self, lane: int) -> Pose:
        """Left end of the `lane`-th lane that leads into the junction, in driving direction."""
        return self.pose.turned(math.pi).moved(0.0, -self.street.lane * (lane - 1))

    def beyond(self, lane: int) -> Pose:
        """Left end of the `lane`-th lane that leads out of the junction, in driving direction."""
        return self.pose.moved(0.0, -self.street.lane * (lane - 1))

    @property
    def strips(self) -> tuple[float, float]:
        """Widths [m] of shoulder and sidewalk at the junction."""
        nose = self.street.nose[0 if self.at_start else 1]
        return 0.0 if nose else self.street.shoulder, self.street.sidewalk


def write_opendrive(name: str, streets: Sequence[Street], *, located: bool = False) -> str:
    """The map as text; the same plan gives the same bytes.

    Args:
        name: The map's name.
        streets: All streets; their junctions are taken from them.
        located: Whether the header has bounds and a place on Earth, one where nobody lives.

    Returns:
        OpenDRIVE XML.
    """
    root = Xml.Element("OpenDRIVE")
    header = Xml.SubElement(root, "header", revMajor="1", revMinor="7", name=name, version="1.0", vendor="chatscene")
    arms: dict[int, list[_Arm]] = {}
    ends = (end for street in streets for end in (street.start, street.end))
    nodes = {node.id: node for node in ends if isinstance(node, Node)}
    plan = {street.id: street for street in streets}
    lines = {street.id: _street_line(street) for street in streets}
    for street in streets:
        start, pieces = lines[street.id]
        _street_road(root, street, plan, start, pieces)
        if isinstance(street.start, Node):
            arms.setdefault(street.start.id, []).append(_Arm(street, True, start))
        if isinstance(street.end, Node):
            arms.setdefault(street.end.id, []).append(_Arm(street, False, end_of(start, pieces).turned(math.pi)))
    if located:
        _locate(header, list(lines.values()))
    junctions: list[Xml.Element] = []
    next_id = 1000
    for node_id in sorted(nodes):
        connections = _connections(arms[node_id], abreast=nodes[node_id].abreast)
        junction = Xml.Element("junction", id=str(node_id), name=f"junction{node_id}")
        for number, connection in enumerate(connections):
            _connecting_road(root, nodes[node_id], connection, next_id)
            entry = Xml.SubElement(
                junction,
                "connection",
                id=str(number),
                incomingRoad=str(connection.source.street.id),
                connectingRoad=str(next_id),
                contactPoint="start",
            )
            Xml.SubElement(entry, "laneLink", {"from": str(connection.source.incoming(connection.lane_in)), "to": "-1"})
            next_id += 1
        junctions.append(junction)
    root.extend(junctions)
    Xml.indent(root, " ")
    return '<?xml version="1.0" encoding="UTF-8"?>\n' + Xml.tostring(root, encoding="unicode") + "\n"


def _locate(header: Xml.Element, lines: Sequence[tuple[Pose, list[Piece]]]) -> None:
    """Bounds of the map and its place on Earth."""
    poses = [pose for start, pieces in lines for pose in _along(start, pieces)]
    header.set("north", decimal(math.ceil(max(pose.y for pose in poses) + _MARGIN)))
    header.set("south", decimal(math.floor(min(pose.y for pose in poses) - _MARGIN)))
    header.set("east", decimal(math.ceil(max(pose.x for pose in poses) + _MARGIN)))
    header.set("west", decimal(math.floor(min(pose.x for pose in poses) - _MARGIN)))
    Xml.SubElement(header, "geoReference").text = NOWHERE


def _along(start: Pose, pieces: Sequence[Piece]) -> Iterator[Pose]:
    """Poses along a reference line, ten for each piece."""
    for piece in pieces:
        yield from (after(start, Piece(piece.length * part / 10, piece.curvature)) for part in range(10))
        start = after(start, piece)
    yield start


# Streets


def _street_line(street: Street) -> tuple[Pose, list[Piece]]:
    (a, first), (b, last) = _end_at(street.start, street.start_at), _end_at(street.end, street.end_at)
    return rounded_line(a, b, street.via, (first, last))


def _end_at(end: Node | int | None, at: tuple[float, float] | None) -> tuple[tuple[float, float], float]:
    """A street's end or the junction's centre behind it, and how much [m] is left out before that."""
    if at is not None:
        return at, 0.0
    if isinstance(end, Node):
        return (end.x, end.y), end.setback
    leads = "ends in no junction" if end is None else f"goes on in street {end}"
    raise ValueError(f"a street that {leads} needs the place where it does")


def _street_road(root: Xml.Element, street: Street, plan: dict[int, Street], start: Pose, pieces: list[Piece]) -> None:
    road = _road(root, street.id, f"street{street.id}", start, pieces, "-1", street)
    link = Xml.Element("link")
    for name, beyond, contact in (("predecessor", street.start, "end"), ("successor", street.end, "start")):
        if isinstance(beyond, Node):
            Xml.SubElement(link, name, elementType="junction", elementId=str(beyond.id))
        elif beyond is not None:
            Xml.SubElement(link, name, elementType="road", elementId=str(beyond), contactPoint=contact)
    road.insert(0, link)
    length = sum(piece.length for piece in pieces)
    cuts = sorted({0.0, *(s for bay in street.bays for s in (bay.start, bay.end))})
    lanes = Xml.SubElement(road, "lanes")
    for s, here, there, over in _parts(_inner(street, 0.0, -street.lane, length)) if street.inner else ():
        _cubic(lanes, "laneOffset", "s", s, here, there, over)
    for begin, end in pairwise((*cuts, length)):
        before = street if begin else _joined(street.start, plan)
        beyond = street if end < length else _joined(street.end, plan)
        section = Xml.SubElement(lanes, "laneSection", s=decimal(begin))
        _lane_section(section, street, (before, beyond), (begin, end, length))
    furnish(road, street, length)


def _lane_section(
    section: Xml.Element,
    street: Street,
    joined: tuple[Street | None, Street | None],
    span: tuple[float, float, float],
) -> None:
    """All lanes of a street between two of its arc lengths, joined to those of the streets before and beyond.

    `span` has both arc lengths and that of the whole street [m].
    """
    sides = [("left", bool(street.lanes_back or street.median or street.kerbs)), ("center", True), ("right", True)]
    left, centre, right = (Xml.SubElement(section, name) if there else None for name, there in sides)
    assert centre is not None
    if left is not None and street.median:
        _grass(left, street, span[-1])
        left = None
    narrow = street.lanes == street.lanes_back == 1
    _mark(Xml.SubElement(centre, "lane", id="0", type="none", level="false"), "broken" if narrow else "solid")
    for side in (left, right):
        if side is None:
            continue
        on_right = side is right
        numbers = range(1, _strips(street, right=on_right) + 1)
        for number in numbers if on_right else reversed(numbers):
            element = _lane(side, street, number, on_right, *span)
            ends = [
                None
                if other is None or _vanishes(street, number, end, right=on_right)
                else _same_lane(street, other, number, right=on_right)
                for end, other in zip(("start", "end"), joined, strict=True)
            ]
            _lane_links(element, *ends)


def _grass(side: Xml.Element, street: Street, length: float) -> None:
    """The half of a median that belongs to a carriageway, and what becomes of a lane that tapers out into it."""
    lane = Xml.SubElement(side, "lane", id="1", type="median", level="false")
    wide = street.median
    for part in _parts(_inner(street, wide, wide + street.lane, length)) if street.inner else ((0.0, wide, wide, 1.0),):
        _width(lane, *part)
    _mark(lane, "none")


def _joined(end: Node | int | None, plan: dict[int, Street]) -> Street | None:
    return plan[end] if isinstance(end, int) else None


def _strips(street: Street, *, right: bool) -> int:
    """How many lanes lie on a side, shoulder and sidewalk among them."""
    return (street.lanes if right else street.lanes_back) + bool(street.shoulder) + bool(street.sidewalk)


def _vanishes(street: Street, number: int, end: str, *, right: bool) -> bool:
    """Whether a lane has no width at an end of its street."""
    return _outermost(street, number, right=right) and (street.begins if end == "start" else street.ceases) is not None


def _outermost(street: Street, number: int, *, right: bool) -> bool:
    """Whether a lane is one that tapers, where the outermost lanes of a street do."""
    return (right or not street.one_sided) and number == (street.lanes if right else street.lanes_back)


def _same_lane(street: Street, other: Street, number: int, *, right: bool) -> int:
    """OpenDRIVE id, in the street before or after, of what goes on there."""
    own = street.lanes if right else street.lanes_back
    there = other.lanes if right else other.lanes_back
    found = number if number <= own else there + number - own
    return -found if right else found


def _lane(
    side: Xml.Element, street: Street, number: int, right: bool, begin: float, end: float, length: float
) -> Xml.Element:
    driving = street.lanes if right else street.lanes_back
    bay = next((b for b in street.bays if b.right is right and (b.start, b.end) == (begin, end)), None)
    kind = "driving" if number <= driving else "sidewalk" if number > driving + bool(street.shoulder) else "shoulder"
    if kind == "shoulder" and (bay is not None or (street.cycle and not (street.ridden and right))):
        kind = "parking" if bay is not None else "biking"
    element = Xml.SubElement(side, "lane", id=str(-number if right else number), type=kind, level="false")
    for s, here, there, over in _profile(street, number, right, bay, length):
        if begin <= s < end or (s < begin and here == there and s + over > begin):
            _width(element, max(s - begin, 0.0), here, there, over)
    _mark(element, "broken" if number < driving else "solid" if number == driving else "none")
    buses = kind == "parking" and bay is not None and bay.use is Use.BUS
    outermost = right and number == driving
    if buses or (street.bus_lane and outermost):
        Xml.SubElement(element, "access", sOffset="0", rule="allow", restriction="bus")
    elif street.ridden and outermost:
        Xml.SubElement(element, "access", sOffset="0", rule="allow", restriction="bicycle")
    return element


def _profile(
    street: Street, number: int, right: bool, bay: Bay | None, length: float
) -> list[tuple[float, float, float, float]]:
    """How wide a lane is: where each part starts, its width there and at its end, and how long it is, all [m]."""
    driving = street.lanes if right else street.lanes_back
    if _outermost(street, number, right=right) and (street.begins or street.ceases):
        (b0, b1), (c0, c1) = street.begins or (0.0, 0.0), street.ceases or (length, length)
        none, full = 0.0 if street.begins else street.lane, street.lane
        knots = [(0.0, none), (b0, none), (b1, full), (c0, full), (c1, 0.0 if street.ceases else full)]
        knots.append((length, knots[-1][1]))
    elif street.inner and right and number == 1:
        knots = _inner(street, street.lane, 0.0, length)
    elif number <= driving:
        knots = [(0.0, wide := street.width_of(number, right=right)), (length, wide)]
    elif number > driving + bool(street.shoulder):
        knots = [(0.0, street.sidewalk), (length, street.sidewalk)]
    elif bay is not None:
        over, most = bay.use.value, bay.width
        knots = [(bay.start, street.shoulder), (bay.start + over, most), (bay.end - over, most)]
        knots.append((bay.end, street.shoulder))
    else:
        first, last = street.nose
        full = street.shoulder
        knots = [(0.0, 0.0 if first else full), (first, full), (length - last, full), (length, 0.0 if last else full)]
    return _parts(knots)


def _inner(street: Street, before: float, beyond: float, length: float) -> list[tuple[float, float]]:
    """Where what tapers with the innermost lane begins and ends to do so, and how wide [m] it is there."""
    assert street.inner is not None
    return [(0.0, before), (street.inner[0], before), (street.inner[1], beyond), (length, beyond)]


def _parts(knots: list[tuple[float, float]]) -> list[tuple[float, float, float, float]]:
    """Where each part between knots starts, its width there and at its end, and how long it is, all [m]."""
    parts = [(s, here, there, beyond - s) for (s, here), (beyond, there) in pairwise(knots) if beyond - s > 1e-9]
    joined = parts[:1]
    for part in parts[1:]:  # one part for what stays as wide as it is
        s, here, there, over = joined[-1]
        if here == there == part[1] == part[2]:
            joined[-1] = (s, here, there, over + part[3])
        else:
            joined.append(part)
    return joined


def _width(element: Xml.Element, s: float, here: float, there: float, over: float) -> None:
    """A width that goes from one value to another without a kink."""
    _cubic(element, "width", "sOffset", s, here, there, over)


def _cubic(element: Xml.Element, name: str, at: str, s: float, here: float, there: float, over: float) -> None:
    change = there - here
    Xml.SubElement(
        element,
        name,
        {at: decimal(s)},
        a=decimal(here),
        b="0",
        c=decimal(3 * change / over**2) if change else "0",
        d=decimal(-2 * change / over**3, 12) if change else "0",
    )


def _mark(element: Xml.Element, kind: str) -> None:
    Xml.SubElement(element, "roadMark", sOffset="0", type=kind, weight="standard", color="standard", width="0.12")


def _lane_links(lane: Xml.Element, predecessor: int | None, successor: int | None) -> None:
    if predecessor is None and successor is None:
        return
    link = Xml.Element("link")
    for name, beyond in (("predecessor", predecessor), ("successor", successor)):
        if beyond is not None:
            Xml.SubElement(link, name, id=str(beyond))
    lane.insert(0, link)


# Junctions


@dataclass(frozen=True, slots=True)
class _Connection:
    source: _Arm
    target: _Arm
    lane_in: int
    lane_out: int
    kerb: bool  # whether it carries what shoulder and sidewalk both of its streets have


def _connections(arms: list[_Arm], *, abreast: bool) -> list[_Connection]:
    found: list[_Connection] = []
    for source in arms:
        turns = [wrapped(target.pose.heading - source.pose.heading - math.pi) for target in arms]
        others = [i for i, turn in enumerate(turns) if abs(abs(turn) - math.pi) > _IN_LINE]  # nobody turns round
        anyone_right = any(turns[i] < -math.pi / 4 for i in others)
        for i in others:
            target, turn = arms[i], turns[i]
            n, m = source.lanes_in, target.lanes_out
            straight = abs(turn) <= math.pi / 4
            found += [
                _Connection(
                    source,
                    target,
                    lane_in,
                    lane_out,
                    lane_in == n and (turn < -math.pi / 4 or (straight and not anyone_right and lane_out == m)),
                )
                for lane_in, lane_out in (
                    _straight_pairs(source, target, turn) if straight else _turns(source, target, turn, abreast=abreast)
                )
            ]
    return found


def _straight_pairs(source: _Arm, target: _Arm, turn: float) -> list[tuple[int, int]]:
    """Lanes in line with one another; where the road bends in the junction, those of the same number."""
    n, m = source.lanes_in, target.lanes_out
    if abs(turn) > _IN_LINE:
        return [(lane, lane) for lane in range(1, min(n, m) + 1)]
    return [
        (i, j)
        for i in range(1, n + 1)
        for j in range(1, m + 1)
        if abs(source.before(i).left_of(target.beyond(j).x, target.beyond(j).y)) < source.street.lane / 2
    ]


def _turns(source: _Arm, target: _Arm, turn: float, *, abreast: bool) -> Iterator[tuple[int, int]]:
    """Lanes from which one turns, with those into which one does: cars beside lanes for bicycles, these beside cars."""
    n, m = source.lanes_in - source.ridden_in, target.lanes_out - target.ridden_out
    yield from _turning_pairs(n, m, left=turn > 0, abreast=abreast)
    if source.ridden_in and turn < 0:
        yield source.lanes_in, target.lanes_out


def _turning_pairs(n: int, m: int, *, left: bool, abreast: bool) -> list[tuple[int, int]]:
    """Innermost lanes into innermost ones to the left, outermost into outermost to the right: one, or all there are."""
    many = min(n, m) if abreast else min(n, m, 1)
    return [(1 + i, 1 + i) if left else (n - i, m - i) for i in range(many)]


_SIGNALS = {
    (True, False): ("traffic light", TRAFFIC_LIGHT),
    (False, False): ("stop sign", STOP_SIGN),
    (False, True): ("give-way sign", GIVE_WAY_SIGN),
}
"""What stands at a junction, by whether it is a light, and whether one gives way."""


def _connecting_road(root: Xml.Element, node: Node, connection: _Connection, road_id: int) -> None:
    source, target = connection.source, connection.target
    # The reference line is the left edge of the lane, in driving direction.
    start, goal = source.before(connection.lane_in), target.beyond(connection.lane_out)
    pieces = line_arc_line(start, goal)
    name = f"junction{node.id} {road_id}"
    road = _road(root, road_id, name, start, pieces, str(node.id), source.street)
    link = Xml.Element("link")
    for name, arm in (("predecessor", source), ("successor", target)):
        Xml.SubElement(
            link,
            name,
            elementType="road",
            elementId=str(arm.street.id),
            contactPoint="start" if arm.at_start else "end",
        )
    road.insert(0, link)
    section = Xml.SubElement(Xml.SubElement(road, "lanes"), "laneSection", s="0")
    centre = Xml.SubElement(section, "center")
    _mark(Xml.SubElement(centre, "lane", id="0", type="none", level="false"), "none")
    right = Xml.SubElement(section, "right")
    length = sum(piece.length for piece in pieces)
    kerb = zip(source.strips, target.strips, strict=True) if connection.kerb else ()
    before = RIDDEN if source.ridden_in and connection.lane_in == source.lanes_in else source.street.lane
    beyond = RIDDEN if target.ridden_out and connection.lane_out == target.lanes_out else target.street.lane
    widths = [(before, beyond), *(ends for ends in kerb if all(ends))]
    for strip, (here, there) in enumerate(widths):
        lane = Xml.SubElement(
            right,
            "lane",
            id=str(-1 - strip),
            type=("driving", "shoulder", "sidewalk")[strip],
            level="false",
        )
        _width(lane, 0.0, here, there, length)
        _mark(lane, "none")
        _lane_links(lane, source.incoming(connection.lane_in + strip), target.outgoing(connection.lane_out + strip))
    if node.control is not Control.NONE and (not node.minor or source.street.id in node.minor):
        named, kind = _SIGNALS[node.control is Control.SIGNAL, node.gives_way]
        signal_on(
            Xml.SubElement(road, "signals"),
            str(road_id),
            named,
            kind,
            s=0.0,
            t=-LANE - 0.5,
            orientation="+",
        )


# Roads


def _road(
    root: Xml.Element,
    road_id: int,
    name: str,
    start: Pose,
    pieces: list[Piece],
    junction: str,
    street: Street,
) -> Xml.Element:
    length = sum(piece.length for piece in pieces)
    road = Xml.SubElement(
        root, "road", name=name, length=decimal(length), id=str(road_id), junction=junction, rule="RHT"
    )
    where, speed = street.surroundings.value
    kind = Xml.SubElement(road, "type", s="0", type=where)
    Xml.SubElement(kind, "speed", max=str(street.allowed or speed), unit="km/h")
    view = Xml.SubElement(road, "planView")
    s, pose = 0.0, start
    for piece in pieces:
        geometry = Xml.SubElement(
            view,
            "geometry",
            s=decimal(s),
            x=decimal(pose.x),
            y=decimal(pose.y),
            hdg=decimal(pose.heading),
            length=decimal(piece.length),
        )
        if piece.curvature:
            Xml.SubElement(geometry, "arc", curvature=decimal(piece.curvature))
        else:
            Xml.SubElement(geometry, "line")
        s, pose = s + piece.length, after(pose, piece)
    return road
