"""Write OpenDRIVE 1.7 from a short plan of junctions and streets.

The form is the one that parsers agree on: one road per two-way street, one connecting road per lane-to-lane
manoeuvre, lines and arcs only, signals on the connecting roads they control, shoulder and sidewalk carried round
corners by the right-turn connectors and along the flat side of a T.
Source: ASAM OpenDRIVE 1.7.0, sections 8 (roads), 9 (lanes), 10 (junctions), 12 (signals).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from xml.etree import ElementTree as Xml

from chatscene.terms.scenario import Control

LANE = 3.5  # [m]
SHOULDER = 1.5  # [m]
SIDEWALK = 2.5  # [m]
SETBACK = 20.0  # [m], from a junction's centre to where its arms end: corner sidewalks must not overlap

TRAFFIC_LIGHT = "1000001"  # signal types of the German catalogue, which Scenic and CARLA know
STOP_SIGN = "206"


@dataclass(frozen=True, slots=True, kw_only=True)
class Node:
    """A junction.

    Attributes:
        id: From 1 up.
        x: Centre [m].
        y: Centre [m].
        control: How it is controlled.
    """

    id: int
    x: float
    y: float
    control: Control


@dataclass(frozen=True, slots=True, kw_only=True)
class Street:
    """A two-way street between two junctions.

    Attributes:
        id: Unique among streets, from 1 up.
        start: Junction at its start.
        end: Junction at its end.
        lanes: Lanes per direction.
        corner: For a street with one bend, where its two straight parts would meet [m].
        radius: Of the bend [m].
    """

    id: int
    start: Node
    end: Node
    lanes: int
    corner: tuple[float, float] | None = None
    radius: float = 0.0


@dataclass(frozen=True, slots=True)
class _Pose:
    x: float
    y: float
    heading: float

    def moved(self, ahead: float, left: float) -> _Pose:
        c, s = math.cos(self.heading), math.sin(self.heading)
        return _Pose(self.x + ahead * c - left * s, self.y + ahead * s + left * c, self.heading)

    def turned(self, angle: float) -> _Pose:
        return _Pose(self.x, self.y, self.heading + angle)


@dataclass(frozen=True, slots=True)
class _Piece:
    """A line (curvature 0) or an arc of a reference line."""

    length: float
    curvature: float


@dataclass(frozen=True, slots=True)
class _Arm:
    """A street where it meets a junction; `pose` looks out of the junction, along the street."""

    street: Street
    at_start: bool
    pose: _Pose

    def incoming(self, lane: int) -> int:
        """OpenDRIVE id of the `lane`-th lane (from 1, innermost first) that leads into the junction."""
        return lane if self.at_start else -lane

    def outgoing(self, lane: int) -> int:
        """OpenDRIVE id of the `lane`-th lane that leads out of the junction."""
        return -self.incoming(lane)


def write_opendrive(name: str, streets: Sequence[Street]) -> str:
    """The map as text; the same plan gives the same bytes.

    Args:
        name: The map's name.
        streets: All streets; their junctions are taken from them.

    Returns:
        OpenDRIVE XML.
    """
    root = Xml.Element("OpenDRIVE")
    Xml.SubElement(root, "header", revMajor="1", revMinor="7", name=name, version="1.0", vendor="chatscene")
    arms: dict[int, list[_Arm]] = {}
    nodes = {node.id: node for street in streets for node in (street.start, street.end)}
    for street in streets:
        start, pieces = _street_line(street)
        _street_road(root, street, start, pieces)
        arms.setdefault(street.start.id, []).append(_Arm(street, True, start))
        arms.setdefault(street.end.id, []).append(_Arm(street, False, _end(start, pieces).turned(math.pi)))
    junctions: list[Xml.Element] = []
    next_id = 1000
    for node_id in sorted(nodes):
        connections = _connections(arms[node_id])
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


# Streets


def _street_line(street: Street) -> tuple[_Pose, list[_Piece]]:
    a, b = (street.start.x, street.start.y), (street.end.x, street.end.y)
    via = street.corner
    if via is None:
        heading = math.atan2(b[1] - a[1], b[0] - a[0])
        start = _Pose(*a, heading).moved(SETBACK, 0.0)
        return start, [_Piece(math.dist(a, b) - 2 * SETBACK, 0.0)]
    first = math.atan2(via[1] - a[1], via[0] - a[0])
    second = math.atan2(b[1] - via[1], b[0] - via[0])
    turn = _wrapped(second - first)
    tangent = street.radius * math.tan(abs(turn) / 2)
    start = _Pose(*a, first).moved(SETBACK, 0.0)
    return start, [
        _Piece(math.dist(a, via) - SETBACK - tangent, 0.0),
        _Piece(street.radius * abs(turn), math.copysign(1 / street.radius, turn)),
        _Piece(math.dist(via, b) - SETBACK - tangent, 0.0),
    ]


def _street_road(root: Xml.Element, street: Street, start: _Pose, pieces: list[_Piece]) -> None:
    road = _road(root, street.id, f"street{street.id}", start, pieces, junction="-1")
    link = Xml.Element("link")
    Xml.SubElement(link, "predecessor", elementType="junction", elementId=str(street.start.id))
    Xml.SubElement(link, "successor", elementType="junction", elementId=str(street.end.id))
    road.insert(0, link)
    section = _lane_section(road)
    left = Xml.SubElement(section, "left")
    centre = Xml.SubElement(section, "center")
    right = Xml.SubElement(section, "right")
    n = street.lanes
    for lane in range(n + 2, 0, -1):
        _lane(left, lane, n)
    _mark(Xml.SubElement(centre, "lane", id="0", type="none", level="false"), "broken" if n == 1 else "solid")
    for lane in range(1, n + 3):
        _lane(right, -lane, n)


def _lane(side: Xml.Element, lane: int, driving: int) -> Xml.Element:
    number = abs(lane)
    kind, width = (
        ("driving", LANE)
        if number <= driving
        else ("shoulder", SHOULDER)
        if number == driving + 1
        else ("sidewalk", SIDEWALK)
    )
    element = Xml.SubElement(side, "lane", id=str(lane), type=kind, level="false")
    _width(element, width)
    _mark(element, "broken" if number < driving else "solid" if number == driving else "none")
    return element


def _width(element: Xml.Element, width: float) -> None:
    Xml.SubElement(element, "width", sOffset="0", a=_number(width), b="0", c="0", d="0")


def _mark(element: Xml.Element, kind: str) -> None:
    Xml.SubElement(element, "roadMark", sOffset="0", type=kind, weight="standard", color="standard", width="0.12")


# Junctions


@dataclass(frozen=True, slots=True)
class _Connection:
    source: _Arm
    target: _Arm
    lane_in: int
    lane_out: int
    turn: float
    kerb: bool  # whether it carries shoulder and sidewalk


def _connections(arms: list[_Arm]) -> list[_Connection]:
    found: list[_Connection] = []
    for source in arms:
        turns = {
            id(target): _wrapped(target.pose.heading - source.pose.heading - math.pi)
            for target in arms
            if target is not source
        }
        anyone_right = any(turn < -math.pi / 4 for turn in turns.values())
        for target in arms:
            if target is source:
                continue
            turn = turns[id(target)]
            n, m = source.street.lanes, target.street.lanes
            if abs(turn) <= math.pi / 4:
                pairs = [(lane, lane) for lane in range(1, min(n, m) + 1)]
            else:
                pairs = [(1, 1)] if turn > 0 else [(n, m)]
            found += [
                _Connection(
                    source,
                    target,
                    lane_in,
                    lane_out,
                    turn,
                    lane_in == n and (turn < -math.pi / 4 or (abs(turn) <= math.pi / 4 and not anyone_right)),
                )
                for lane_in, lane_out in pairs
            ]
    return found


def _connecting_road(root: Xml.Element, node: Node, connection: _Connection, road_id: int) -> None:
    source, target = connection.source, connection.target
    # The reference line is the left edge of the lane, in driving direction.
    start = source.pose.turned(math.pi).moved(0.0, -LANE * (connection.lane_in - 1))
    goal = target.pose.moved(0.0, -LANE * (connection.lane_out - 1))
    pieces = _line_arc_line(start, goal)
    road = _road(root, road_id, f"junction{node.id} {road_id}", start, pieces, junction=str(node.id))
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
    section = _lane_section(road)
    centre = Xml.SubElement(section, "center")
    _mark(Xml.SubElement(centre, "lane", id="0", type="none", level="false"), "none")
    right = Xml.SubElement(section, "right")
    for number in range(1, 4 if connection.kerb else 2):
        lane = Xml.SubElement(
            right,
            "lane",
            id=str(-number),
            type=("driving", "shoulder", "sidewalk")[number - 1],
            level="false",
        )
        ends = Xml.SubElement(lane, "link")
        beyond = number - 1
        Xml.SubElement(ends, "predecessor", id=str(source.incoming(connection.lane_in + beyond)))
        Xml.SubElement(ends, "successor", id=str(target.outgoing(connection.lane_out + beyond)))
        _width(lane, (LANE, SHOULDER, SIDEWALK)[number - 1])
        _mark(lane, "none")
    if node.control is not Control.NONE:
        _signal(road, road_id, node.control)


def _signal(road: Xml.Element, road_id: int, control: Control) -> None:
    light = control is Control.SIGNAL
    signals = Xml.SubElement(road, "signals")
    Xml.SubElement(
        signals,
        "signal",
        s="0",
        t=_number(-LANE - 0.5),
        id=str(road_id),
        name="traffic light" if light else "stop sign",
        dynamic="yes" if light else "no",
        orientation="+",
        zOffset="3" if light else "2",
        country="OpenDRIVE" if light else "DE",
        type=TRAFFIC_LIGHT if light else STOP_SIGN,
        subtype="-1",
        value="-1",
        height="0.9",
        width="0.5",
    )


def _line_arc_line(start: _Pose, goal: _Pose) -> list[_Piece]:
    """A line, an arc and a line that lead from one pose to another."""
    turn = _wrapped(goal.heading - start.heading)
    dx, dy = goal.x - start.x, goal.y - start.y
    if abs(turn) < 1e-6:
        return [_Piece(math.hypot(dx, dy), 0.0)]
    # Both tangents meet `first` ahead of the start and `second` before the goal.
    second = (dy * math.cos(start.heading) - dx * math.sin(start.heading)) / math.sin(turn)
    first = dx * math.cos(start.heading) + dy * math.sin(start.heading) - second * math.cos(turn)
    tangent = min(first, second)
    radius = tangent / math.tan(abs(turn) / 2)
    pieces = [
        _Piece(first - tangent, 0.0),
        _Piece(radius * abs(turn), math.copysign(1 / radius, turn)),
        _Piece(second - tangent, 0.0),
    ]
    return [piece for piece in pieces if piece.length > 1e-6]


# Roads


def _road(root: Xml.Element, road_id: int, name: str, start: _Pose, pieces: list[_Piece], junction: str) -> Xml.Element:
    length = sum(piece.length for piece in pieces)
    road = Xml.SubElement(
        root, "road", name=name, length=_number(length), id=str(road_id), junction=junction, rule="RHT"
    )
    kind = Xml.SubElement(road, "type", s="0", type="town")
    Xml.SubElement(kind, "speed", max="50", unit="km/h")
    view = Xml.SubElement(road, "planView")
    s, pose = 0.0, start
    for piece in pieces:
        geometry = Xml.SubElement(
            view,
            "geometry",
            s=_number(s),
            x=_number(pose.x),
            y=_number(pose.y),
            hdg=_number(pose.heading),
            length=_number(piece.length),
        )
        if piece.curvature:
            Xml.SubElement(geometry, "arc", curvature=_number(piece.curvature))
        else:
            Xml.SubElement(geometry, "line")
        s, pose = s + piece.length, _after(pose, piece)
    return road


def _lane_section(road: Xml.Element) -> Xml.Element:
    return Xml.SubElement(Xml.SubElement(road, "lanes"), "laneSection", s="0")


def _after(pose: _Pose, piece: _Piece) -> _Pose:
    if not piece.curvature:
        return pose.moved(piece.length, 0.0)
    radius, angle = 1 / piece.curvature, piece.length * piece.curvature
    moved = pose.moved(radius * math.sin(angle), radius * (1 - math.cos(angle)))
    return moved.turned(angle)


def _end(start: _Pose, pieces: list[_Piece]) -> _Pose:
    for piece in pieces:
        start = _after(start, piece)
    return start


def _wrapped(angle: float) -> float:
    return (angle + math.pi) % (2 * math.pi) - math.pi


def _number(value: float) -> str:
    text = f"{value:.9f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
