"""What an OpenDRIVE file says and Scenic's network leaves out: crosswalks, where vehicles stand, lights on approaches.

Source: ASAM OpenDRIVE 1.7.0, sections 9.5 (lane types and access), 11 (objects), 12 (signals).
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np
import shapely

from chatscene.terms.polyline import Polyline

RAIL = "rail"
"""The subtype of an object that is a track: two rails in the road, or across it."""
DRIVEWAY = "driveway"
"""The subtype of an object that is a way off the road to a house, a yard or a field."""
TRAFFIC_LIGHT = "1000001"
_PEDESTRIANS_LIGHT = "1000002"
_LIGHTS = "10000"  # what OpenDRIVE's own types of signals begin with; all are lights
_BEFORE_END = 50.0  # [m], within which a light belongs to the junction at the end of its road
_BUS_BAY = 120.0  # [m]; a longer lane for buses is one to drive on


class Stand(StrEnum):
    """What a place beside the lanes is for."""

    PARKING = "parking"
    BUS = "bus"


@dataclass(frozen=True, slots=True)
class StandingPlace:
    """A strip beside the lanes where vehicles stand.

    Attributes:
        use: What for.
        road: OpenDRIVE id of its road.
        forward: Whether it lies on the side of the road's own direction.
        start: Where it begins [m along the road's reference line].
        end: Where it ends [m].
        depth: How wide it is where it is widest [m]: bays at a right angle are as deep as cars are long.
    """

    use: Stand
    road: int
    forward: bool
    start: float
    end: float
    depth: float = 0.0


@dataclass(frozen=True, slots=True)
class Furniture:
    """What stands and is marked on a map's roads.

    Attributes:
        crosswalks: By OpenDRIVE id of the road each lies on, its area [m], map frame.
        standing: Where vehicles stand beside the lanes.
        lights: OpenDRIVE's ids of traffic lights, by that of the road and whether they hold for its own direction.
            Those of a road outside junctions hold for the junction to which that direction leads.
        cycle_lanes: The areas [m] of lanes for bicycles, by OpenDRIVE's id of the road and whether on its right.
        tracks: By OpenDRIVE id of the road each lies on, the area of a track [m], and whether it leads across the road.
        bus_lanes: OpenDRIVE's ids of the roads with a lane to drive on for buses, and whether on its right.
        driveways: By OpenDRIVE id of the road that each leads off, its area [m], map frame.
    """

    crosswalks: tuple[tuple[int, shapely.Polygon], ...] = ()
    standing: tuple[StandingPlace, ...] = ()
    lights: Mapping[tuple[int, bool], tuple[str, ...]] = field(default_factory=dict[tuple[int, bool], tuple[str, ...]])
    cycle_lanes: Mapping[tuple[int, bool], shapely.Polygon] = field(
        default_factory=dict[tuple[int, bool], shapely.Polygon]
    )
    tracks: tuple[tuple[int, shapely.Polygon, bool], ...] = ()
    driveways: tuple[tuple[int, shapely.Polygon], ...] = ()
    bus_lanes: frozenset[tuple[int, bool]] = frozenset()


def furniture_of(network: Any) -> Furniture:
    """What stands on the roads of a network that `chatscene.maps.network.load_network` gave."""
    return getattr(network, "furniture", Furniture())


def read_furniture(root: Xml.Element, network: Any) -> Furniture:
    """What a map's file says of crosswalks, standing places and lights.

    Args:
        root: A map that has been checked, in the plain form.
        network: Scenic's road network of it.
    """
    roads = {road.id: road for road in network.roads}
    lines = {number: Polyline([p[:2] for p in road.centerline.points]) for number, road in roads.items()}
    crosswalks: list[tuple[int, shapely.Polygon]] = []
    standing: list[StandingPlace] = []
    cycle_lanes: dict[tuple[int, bool], shapely.Polygon] = {}
    tracks: list[tuple[int, shapely.Polygon, bool]] = []
    driveways: list[tuple[int, shapely.Polygon]] = []
    bus_lanes: set[tuple[int, bool]] = set()
    lights: dict[tuple[int, bool], list[str]] = {}
    for road in root.iter("road"):
        number = int(road.get("id", "0"))
        for light, forward in _lights(road, inside=number not in lines):
            lights.setdefault((number, forward), []).append(light)
        if number in lines:
            standing += _standing(road, number)
            crosswalks += [(number, area) for area in _areas(road, lines[number], "type", "crosswalk")]
            tracks += _tracks(road, number, lines[number])
            driveways += [(number, area) for area in _areas(road, lines[number], "subtype", DRIVEWAY)]
            bus_lanes |= {
                (number, int(lane.get("id", "0")) < 0) for lane in road.iter("lane") if _is_only_for(lane, "bus")
            }
            cycle_lanes |= _cycle_lanes(road, roads[number])
    return Furniture(
        tuple(crosswalks),
        tuple(standing),
        {where: tuple(ids) for where, ids in lights.items()},
        cycle_lanes,
        tuple(tracks),
        tuple(driveways),
        frozenset(bus_lanes),
    )


def _lights(road: Xml.Element, *, inside: bool) -> Iterator[tuple[str, bool]]:
    """The lights of a road, those that lie at its end, and whether each holds for its own direction."""
    length = float(road.get("length", "0"))
    for signal in road.iterfind("signals/signal"):
        kind = signal.get("type", "")
        dynamic = signal.get("dynamic") == "yes" and kind.startswith(_LIGHTS) and kind != _PEDESTRIANS_LIGHT
        if kind != TRAFFIC_LIGHT and not dynamic:
            continue
        s, orientation = float(signal.get("s", "0")), signal.get("orientation")
        if orientation != "-" and (inside or length - s < _BEFORE_END):
            yield signal.get("id", ""), True
        if orientation != "+" and (inside or s < _BEFORE_END):
            yield signal.get("id", ""), False


def _standing(road: Xml.Element, number: int) -> list[StandingPlace]:
    """The strips of a road, those that follow one another joined."""
    sections = road.findall("lanes/laneSection")
    starts = [float(section.get("s", "0")) for section in sections]
    ends = [*starts[1:], float(road.get("length", "0"))]
    found: dict[tuple[Stand, bool], list[tuple[float, float, float]]] = {}
    for section, start, end in zip(sections, starts, ends, strict=True):
        for lane in section.iter("lane"):
            use = _use(lane, end - start)
            if use is None:
                continue
            strips = found.setdefault((use, int(lane.get("id", "0")) < 0), [])
            depth = max((_number(width, "a") for width in lane.iter("width")), default=0.0)
            if strips and strips[-1][1] >= start:
                strips[-1] = (strips[-1][0], end, max(strips[-1][2], depth))
            else:
                strips.append((start, end, depth))
    return [StandingPlace(use, number, forward, *strip) for (use, forward), strips in found.items() for strip in strips]


def _use(lane: Xml.Element, length: float) -> Stand | None:
    kind = lane.get("type")
    if kind == "bus" and length <= _BUS_BAY:
        return Stand.BUS
    if kind != "parking":
        return None
    return Stand.BUS if _allows_only(lane, "bus") else Stand.PARKING


def _allows_only(lane: Xml.Element, who: str) -> bool:
    """Whether one kind of road user alone may be on a lane."""
    return {access.get("restriction") for access in lane.iter("access") if access.get("rule") == "allow"} == {who}


def _is_only_for(lane: Xml.Element, who: str) -> bool:
    """Whether a lane to drive on is for one kind of road user."""
    return lane.get("type") == "driving" and _allows_only(lane, who)


def _areas(road: Xml.Element, line: Polyline, name: str, value: str) -> Iterator[shapely.Polygon]:
    """The areas of the objects of a road that have a value."""
    for thing in road.iterfind("objects/object"):
        if thing.get(name) == value:
            area = shapely.Polygon(_corners(thing, line))
            if area.is_valid and area.area > 0:
                yield area


def _cycle_lanes(road: Xml.Element, there: Any) -> dict[tuple[int, bool], shapely.Polygon]:
    """The areas beside the lanes of cars that are for bicycles, all along the road."""
    found: dict[tuple[int, bool], shapely.Polygon] = {}
    for lane in road.iter("lane"):
        right = int(lane.get("id", "0")) < 0
        group = there.forwardLanes if right else there.backwardLanes
        beside = lane.get("type") == "biking"
        if group is not None and (beside or _is_only_for(lane, "bicycle")):
            edge = shapely.LineString(np.array(group.rightEdge.points)[:, :2])
            wide = max((_number(width, "a") for width in lane.iter("width")), default=0.0)
            found[int(road.get("id", "0")), right] = edge.buffer(-wide if beside else wide, single_sided=True)
    return found


def _tracks(road: Xml.Element, number: int, line: Polyline) -> Iterator[tuple[int, shapely.Polygon, bool]]:
    """The tracks of a road: those that lie across are at a place of it, the others as long as it is."""
    for area in _areas(road, line, "subtype", RAIL):
        x, y = (np.array(area.exterior.coords) - area.centroid.coords[0]).T
        turned = line.heading_at(line.project(area.centroid.x, area.centroid.y)[0])
        along, aside = x * math.cos(turned) + y * math.sin(turned), y * math.cos(turned) - x * math.sin(turned)
        yield number, area, bool(np.ptp(aside) > np.ptp(along))


def _corners(thing: Xml.Element, line: Polyline) -> list[tuple[float, float]]:
    """The corners of an object [m], map frame: of its outline, or of its box."""
    outline = next(thing.iter("outline"), None)
    if outline is not None and outline.find("cornerRoad") is not None:
        return [_beside(line, _number(c, "s"), _number(c, "t")) for c in outline.iter("cornerRoad")]
    if outline is not None:
        local = [(_number(c, "u"), _number(c, "v")) for c in outline.iter("cornerLocal")]
    else:
        u, v = _number(thing, "length") / 2, _number(thing, "width") / 2
        local = [(-u, -v), (u, -v), (u, v), (-u, v)]
    s = _number(thing, "s")
    (x, y), turned = _beside(line, s, _number(thing, "t")), line.heading_at(s) + _number(thing, "hdg")
    cos, sin = math.cos(turned), math.sin(turned)
    corners = [(x + u * cos - v * sin, y + u * sin + v * cos) for u, v in local]
    return corners if len(corners) > 2 else [(x, y)] * 3


def _beside(line: Polyline, s: float, t: float) -> tuple[float, float]:
    (x, y), heading = line.point_at(s), line.heading_at(s)
    return x - t * math.sin(heading), y + t * math.cos(heading)


def _number(element: Xml.Element, name: str) -> float:
    return float(element.get(name, "0"))
