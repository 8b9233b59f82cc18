"""Direct junctions: roads that part or join with no connecting road between them.

Lanes lead on in those of the linked roads, as their links say; there is no area of a junction. Scenic's parser knows
none, so they are set aside while it reads, and its network is joined afterwards.
Source: ASAM OpenDRIVE 1.8.1, section 12.5 (direct junctions).
"""

from __future__ import annotations

from typing import Any
from xml.etree import ElementTree as Xml

SET_ASIDE = "directJunction"
"""The name that their elements have meanwhile."""


def set_aside(root: Xml.Element, *, again: bool) -> None:
    """Set the direct junctions of a map aside; each connection then says at which end its road lies.

    Args:
        root: The map, which is changed.
        again: Whether junctions that lie at one another, with no road between them, are set aside too.
    """
    roads = {road.get("id"): road for road in root.iterfind("road")}
    for junction in root.findall("junction"):
        connections = junction.findall("connection")
        direct = junction.get("type") == "direct" or (
            connections and all(one.get("linkedRoad") and one.get("connectingRoad") is None for one in connections)
        )
        if not direct and not (again and any(_lies_at_another(roads, one) for one in connections)):
            continue
        junction.tag = SET_ASIDE
        for connection in connections:
            connection.set("linkedRoad", connection.get("linkedRoad") or connection.get("connectingRoad", ""))
            road = roads.get(connection.get("incomingRoad"))
            for end, contact in (("predecessor", "start"), ("successor", "end")):
                link = None if road is None else road.find(f"link/{end}")
                if link is not None and (link.get("elementType"), link.get("elementId")) == (
                    "junction",
                    junction.get("id"),
                ):
                    connection.set("incomingEnd", contact)


def _lies_at_another(roads: dict[str | None, Xml.Element], connection: Xml.Element) -> bool:
    """Whether a road of another junction comes in, or the connecting road leads to another junction."""
    road, through = (roads.get(connection.get(name)) for name in ("incomingRoad", "connectingRoad"))
    comes = road is not None and road.get("junction", "-1") != "-1"
    ends = () if through is None else through.findall("link/*")
    return comes or any(link.get("elementType") == "junction" for link in ends)


def join_directly(network: Any, root: Xml.Element) -> None:
    """Let the lanes of a network lead on as the direct junctions that were set aside say."""
    from scenic.domains.driving.roads import Maneuver, ManeuverType

    roads = {road.id: road for road in network.allRoads}
    for connection in root.iterfind(f"{SET_ASIDE}/connection"):
        ends = (("incomingRoad", "incomingEnd"), ("linkedRoad", "contactPoint"))
        one, other = (_section(roads, connection.get(road), connection.get(end)) for road, end in ends)
        if one is None or other is None:
            continue
        for link in connection.iterfind("laneLink"):
            here = one.lanesByOpenDriveID.get(int(link.get("from", "0")))
            there = other.lanesByOpenDriveID.get(int(link.get("to", "0")))
            if here is None or there is None:
                continue
            leaves = here.isForward == (connection.get("incomingEnd") == "end")
            first, then = (here, there) if leaves else (there, here)
            for a, b in ((first, then), (first.lane, then.lane), (first.group, then.group)):
                a._successor = a._successor or b
                b._predecessor = b._predecessor or a
            if any(maneuver.endLane is then.lane for maneuver in first.lane.maneuvers):
                continue
            straight = Maneuver(type=ManeuverType.STRAIGHT, startLane=first.lane, endLane=then.lane)
            first.lane.maneuvers = (*first.lane.maneuvers, straight)


def _section(roads: dict[int, Any], number: str | None, end: str | None) -> Any:
    """The section at an end of a road, if both are there."""
    road = roads.get(int(number)) if number else None
    if road is None or end not in ("start", "end"):
        return None
    return road.sections[0 if end == "start" else -1]
