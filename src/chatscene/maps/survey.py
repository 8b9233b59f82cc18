"""What a map offers, and what is wrong with it."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from xml.etree import ElementTree as Xml

from chatscene.errors import MapError
from chatscene.maps.furniture import Stand, furniture_of
from chatscene.maps.junctions import junction_control
from chatscene.maps.lane_curves import DrawnRoad
from chatscene.maps.lane_links import DRIVEN
from chatscene.maps.layout import (
    JunctionKind,
    arms,
    junction_kinds,
    motorway_groups,
    roundabouts,
    weaving_sections,
)
from chatscene.maps.left_hand import lanes_on_map
from chatscene.maps.line_pieces import MISFIT
from chatscene.maps.network import check_opendrive, load_network, put_right
from chatscene.maps.open_road import SHORT_ROAD
from chatscene.maps.routes import APPROACHES, BASE_SCENARIO_QUERIES, find_routes, lacking
from chatscene.maps.scenic_parser import outside
from chatscene.terms.mirroring import mirrored_words
from chatscene.terms.route import RouteQuery

ROUTES = 10  # per base scenario, as in the paper (section 4.2)
_ASIDE_OF_TRAFFIC = frozenset(
    ("none", "sidewalk", "walking", "shoulder", "parking", "stop", "border", "biking", "median", "curb", "restricted")
)
_TORN = 2.0  # [m], half a lane; a lane that leads on farther from its end is a fault of the map
_BENT = math.radians(15.0)  # a corner in a reference line that is more is a fault of the map
_ASIDE = 0.5  # [m]; a middle farther outside its lane is a fault of the map
_SHARED = 0.5  # [m]; lanes of one road that overlap more widely than this are a fault of the map


@dataclass(frozen=True, slots=True, kw_only=True)
class MapDescription:
    """What a map offers.

    Attributes:
        keeps: To which side traffic keeps: ``left`` or ``right``.
        lane_kilometres: Their length together [km].
        sidewalks: Sidewalks along roads and round corners.
        junctions: How many junctions there are by arms and control, e.g. ``4-way signal``; those at which roads
            merge or part and those of roundabouts are not among them.
        merges: Where roads become one, as at an on-ramp.
        diverges: Where one road becomes several, as at an off-ramp.
        weaving_sections: Where an on-ramp and an off-ramp share a lane.
        motorway_kilometres: Length of all carriageways of motorways together [km].
        left_out: Lanes of types that nobody drives or walks on here, such as ``bus``, by type.
        routes: How many routes each base scenario finds, ten being all that are asked for; where it is made of
            several manoeuvres, all of them together, ten each.
        lacking: By base scenario that finds none, what the map has not.
    """

    name: str
    file: str
    keeps: str
    roads: int
    lanes: int
    lane_kilometres: float
    sidewalks: int
    shoulders: int
    junctions: dict[str, int]
    roundabouts: int
    merges: int
    diverges: int
    weaving_sections: int
    motorway_kilometres: float
    crosswalks: int
    parking_strips: int
    bus_bays: int
    left_out: dict[str, int]
    routes: dict[str, int]
    lacking: dict[str, str]


def describe_map(path: Path) -> MapDescription:
    """Count what a map offers.

    Raises:
        MapError: It cannot be loaded.
    """
    network = load_network(path)
    lanes = [lane for road in network.roads for lane in road.lanes]
    kinds = Counter(junction_kinds(network).values())
    furniture = furniture_of(network)
    standing = Counter(place.use for place in furniture.standing)
    routes = {
        base: sum(_count(network, path.stem, query) for query in queries)
        for base, queries in BASE_SCENARIO_QUERIES.items()
    }
    turned = mirrored_words if network.mirrored else str
    return MapDescription(
        name=path.stem,
        file=str(path),
        keeps="left" if network.mirrored else "right",
        roads=len(network.roads),
        lanes=len(lanes),
        lane_kilometres=round(sum(lane.centerline.length for lane in lanes) / 1000, 2),
        sidewalks=len(network.sidewalks),
        shoulders=len(network.shoulders),
        junctions=_junctions(network),
        roundabouts=len(roundabouts(network)),
        merges=kinds[JunctionKind.MERGE],
        diverges=kinds[JunctionKind.DIVERGE],
        weaving_sections=len(weaving_sections(network)),
        motorway_kilometres=round(sum(g.centerline.length for g in motorway_groups(network)) / 1000, 2),
        crosswalks=len(furniture.crosswalks),
        parking_strips=standing[Stand.PARKING],
        bus_bays=standing[Stand.BUS],
        left_out=_left_out(path),
        routes={base.value: count for base, count in routes.items()},
        lacking={
            base.value: turned(" or ".join(lacking(network, path.stem, query) for query in BASE_SCENARIO_QUERIES[base]))
            for base, count in routes.items()
            if count == 0
        },
    )


def check_map(path: Path) -> tuple[str, ...]:
    """What is wrong with a map, in words; empty if nothing is.

    That a map lacks some geometry is not a fault of the map; `describe_map` shows it.
    """
    try:
        network = load_network(path)
    except MapError as error:
        return (str(error),)
    jumps = map(lanes_on_map, _jumps(path)) if network.mirrored else _jumps(path)
    problems = [*put_right(path), *jumps, *_dead_lanes(network), *_overlaps(network), *_strays(network)]
    if not any(_count(network, path.stem, query) for queries in BASE_SCENARIO_QUERIES.values() for query in queries):
        problems.append(
            f"no base scenario finds a route: there is neither a lane that is straight for {SHORT_ROAD:.0f} m without "
            f"a junction, nor one of {min(APPROACHES):.0f} m that leads to a junction where the ego turns"
        )
    return tuple(problems)


def _left_out(path: Path) -> dict[str, int]:
    """How many lanes, of all sections, are of types of traffic that is not here."""
    kinds = Counter(lane.get("type", "none") for lane in check_opendrive(path).iter("lane"))
    return {kind: count for kind, count in sorted(kinds.items()) if kind not in DRIVEN | _ASIDE_OF_TRAFFIC}


def _junctions(network: Any) -> dict[str, int]:
    kinds = junction_kinds(network)
    crossings = [j for j in network.intersections if kinds[j.uid] is JunctionKind.CROSSING]
    return dict(sorted(Counter(f"{arms(j)}-way {junction_control(j).value}" for j in crossings).items()))


def _count(network: Any, name: str, query: RouteQuery) -> int:
    try:
        return len(find_routes(network, name, query, ROUTES))
    except MapError:
        return 0


def _dead_lanes(network: Any) -> list[str]:
    """Lanes that reach a junction from which they lead nowhere."""
    into = {lane.uid for junction in network.intersections for lane in junction.incomingLanes}
    found: list[str] = []
    for road in network.roads:
        for group in (road.forwardLanes, road.backwardLanes):
            if group is None or not any(lane.uid in into for lane in group.lanes):
                continue
            stuck = sorted(lane.uid for lane in group.lanes if lane.uid not in into and not lane.maneuvers)
            found += [f"lane {uid} of road {road.id} ends at a junction without a way through it" for uid in stuck]
    return found


def _overlaps(network: Any) -> list[str]:
    """Neighbouring lanes that lie on one another."""
    found: list[str] = []
    for road in network.roads:
        for section in road.sections:
            for a, b in zip(section.lanes, section.lanes[1:], strict=False):
                shared = a.polygons.intersection(b.polygons).area
                if shared > _SHARED * a.centerline.length:
                    found.append(f"lanes {a.openDriveID} and {b.openDriveID} of road {road.id} overlap")
    return list(map(lanes_on_map, found)) if network.mirrored else found


def _jumps(path: Path) -> list[str]:
    """Lines and lanes that do not go on where what leads to them ends, and lines that turn there."""
    found: list[str] = []
    elements = {element.get("id", ""): element for element in check_opendrive(path).iter("road")}
    roads = {number: DrawnRoad(element) for number, element in elements.items()}
    for number, road in roads.items():
        found += _torn(road, elements[number], roads)
        for s, gap, turn in road.joints():
            if gap > MISFIT:
                found.append(f"road {road.name!r}: its reference line leaps {gap:.2f} m at s={s:g}")
            elif turn > _BENT:
                found.append(f"road {road.name!r}: its reference line bends by {math.degrees(turn):.0f}° at s={s:g}")
    return found


def _torn(road: DrawnRoad, element: Xml.Element, roads: Mapping[str, DrawnRoad]) -> Iterator[str]:
    """Lanes that lead to one of the next road that does not begin where they end."""
    sections = element.findall("lanes/laneSection")
    for at, tag, section in (("start", "predecessor", sections[0]), ("end", "successor", sections[-1])):
        beyond = road.ends.get(at)
        other = roads.get(beyond.number) if beyond is not None and beyond.kind == "road" else None
        if beyond is None or other is None or not beyond.contact:
            continue
        ends = [(one, 0.0 if where == "start" else one.length) for one, where in ((road, at), (other, beyond.contact))]
        for lane in section.iter("lane"):
            if lane.get("type") not in DRIVEN or (link := lane.find(f"link/{tag}")) is None:
                continue
            both = zip(ends, (int(lane.get("id", "0")), int(link.get("id", "0"))), strict=True)
            there = [
                (number, one.place(s, one.middle_at(s, number)))
                for (one, s), number in both
                if number in one.lanes_at(s)
            ]
            if len(there) == 2 and (gap := math.dist(there[0][1][:2], there[1][1][:2])) > _TORN:
                named = f"lane {there[0][0]} ends {gap:.1f} m from lane {there[1][0]} of road {other.name!r}"
                yield f"road {road.name!r}: {named}, to which it leads"


def _strays(network: Any) -> list[str]:
    """Lanes whose middle runs outside their area."""
    found: list[str] = []
    for lane in network.lanes:
        if not lane.containsRegion(lane.centerline, tolerance=_ASIDE):
            far = outside(lane, lane.centerline)
            found.append(f"lane {lane.uid}: its middle runs up to {far:.1f} m outside its area")
    return found
