"""Places in a scenario file: on the map, on its roads and lanes, beside others, along lines."""

from __future__ import annotations

import math
from functools import cached_property, lru_cache
from itertools import pairwise
from pathlib import Path
from typing import Any

from chatscene.imports.given import Given, Refused
from chatscene.imports.player import InLane
from chatscene.imports.shapes import Pose, line_through, shape_of
from chatscene.imports.stranger_xml import Element
from chatscene.maps.lane_curves import DrawnRoad, middle_line
from chatscene.maps.neighbours import number_beside, numbered_beside
from chatscene.maps.network import check_opendrive, load_network, map_digest
from chatscene.maps.road_ways import Stretch, reached, roads_between
from chatscene.terms.polyline import Polyline
from chatscene.world.places import laneLine

_ROUNDED = 0.1  # [m] beyond its end to which a place on a road may be told
_BEYOND = 300.0  # [m] beyond the last waypoint of a route, where a place may still be: it goes straight on


class Positions:
    """Finds places.

    Args:
        given: The parameters of the file.
        map_path: The map.
        mirrored: Whether y, t and headings count to the right, as in CARLA, and metres beside a lane to the right of
            whoever is put there, as ScenarioRunner counts them; else they count to the left of the road's line.
    """

    def __init__(self, given: Given, map_path: Path, *, mirrored: bool = False) -> None:
        self._given, self._map_path = given, map_path
        self._mirrored, self._left = mirrored, -1 if mirrored else 1
        self.known: dict[str, Pose] = {}

    @cached_property
    def network(self) -> Any:
        """Scenic's road network of the map."""
        return load_network(self._map_path)

    @cached_property
    def _roads(self) -> dict[str, DrawnRoad]:
        """The roads as they are written, by number; that the network can be made shows that they can be read."""
        assert self.network is not None
        return _roads_of(self._map_path, map_digest(self._map_path))

    def pose(self, position: Element) -> Pose:  # noqa: PLR0911
        """Where a Position is; its heading is that of its road or of whatever it is told beside, turned as it says."""
        if len(position.inside) != 1:
            raise Refused(position, "it names no one place")
        (one,) = position.inside
        g = self._given
        match one.tag:
            case "WorldPosition":
                return g.number(one, "x"), self._left * g.number(one, "y"), self._left * g.number(one, "h", "0")
            case "LanePosition":
                lane, offset = self._lane(one), g.number(one, "offset", "0")
                x, y, heading = self._on_road(one, g.number(one, "s"), lane, 0.0 if self._mirrored else offset)
                there = x, y, self._turned(one, heading + (math.pi if lane > 0 else 0.0))
                return _beside(there, -offset) if self._mirrored else there
            case "RoadPosition":
                x, y, heading = self._on_road(one, g.number(one, "s"), 0, self._left * g.number(one, "t", "0"))
                return x, y, self._turned(one, heading)
            case "RelativeObjectPosition" | "RelativeWorldPosition":
                x, y, heading = self._of(one)
                turn = heading if one.tag == "RelativeObjectPosition" else 0.0
                dx, dy = g.number(one, "dx"), self._left * g.number(one, "dy", "0")
                x, y = x + dx * math.cos(turn) - dy * math.sin(turn), y + dx * math.sin(turn) + dy * math.cos(turn)
                return x, y, self._turned(one, heading)
            case "RelativeLanePosition" | "RelativeRoadPosition":
                return self._relative(one)
            case "TrajectoryPosition":
                return self._on_trajectory(one)
            case "RoutePosition":
                return self._on_route(one)
            case _:
                raise Refused(one, "such a place is not read; write a WorldPosition or a LanePosition")

    def known_of(self, one: Element, name: str) -> Pose:
        """Where somebody is at first.

        Raises:
            Refused: It is not told.
        """
        if name not in self.known:
            raise Refused(one, f"the position of {name[:40]!r} is not given before")
        return self.known[name]

    def _of(self, one: Element) -> Pose:
        name = self._given.text(one, "entityRef")
        return self.known_of(one, name)

    def _on_trajectory(self, one: Element) -> Pose:
        """So far along a trajectory, and so far to its left."""
        trajectory = one.find("TrajectoryRef", "Trajectory")
        if trajectory is None:
            raise Refused(one, "its trajectory is not there")
        line = shape_of(trajectory, self._given, self.pose).line
        along, left = self._given.number(one, "s"), self._left * self._given.number(one, "t", "0")
        if not 0.0 <= along <= line.length:
            raise Refused(one, f"its trajectory is {line.length:.0f} m long, and {along:g} m is not on it")
        there = (*line.point_at(along), line.heading_at(along))
        x, y, heading = _beside(there, left)
        return x, y, self._turned(one, heading)

    def _on_route(self, one: Element) -> Pose:
        """So far along a route, as its roads' reference lines run, and in a lane or so far beside that line."""
        g = self._given
        route = one.find("RouteRef", "Route") or one.find("Route")
        inside = one.find("InRoutePosition")
        told = inside.inside[0] if inside is not None and inside.inside else None
        if route is None or told is None or told.tag not in ("FromLaneCoordinates", "FromRoadCoordinates"):
            raise Refused(one, "pathS does not give its place on the route")
        along, waypoints = g.number(told, "pathS"), [p for w in route.all("Waypoint") for p in w.all("Position")]
        if not all(p.find("LanePosition") or p.find("RoadPosition") for p in waypoints):
            return self._on_line(one, told, line_through(route, [self.pose(p) for p in waypoints]), along)
        way = self._way(route, [p.inside[0] for p in waypoints])
        length = sum(part.length for part in way)
        if not 0.0 <= along <= length + _BEYOND:
            raise Refused(told, f"its route is {length:.0f} m long, and {along:g} m is not on it")
        part, along = reached(way, along)
        road, way_on = self._roads[part.road], part.way
        s = min(max(part.first + way_on * along, 0.0), road.length)
        straight = along - abs(s - part.first)  # beyond the end of its last road
        if told.tag == "FromRoadCoordinates":
            left, against = way_on * self._left * g.number(told, "t", "0"), way_on < 0
        else:
            number, offset = g.count(told, "laneId"), g.number(told, "laneOffset", "0")
            if way_on < 0 and number < 0:
                number, offset = -number, -offset
                g.note(told, "its route runs against its road; its lane is taken to be counted as the route runs")
            left, against = self._middle(told, road, s, number) + offset, number > 0
        x, y, heading = road.place(s, left)
        onward = heading + (0.0 if way_on > 0 else math.pi)
        x, y = x + straight * math.cos(onward), y + straight * math.sin(onward)
        return x, y, self._turned(one, heading + (math.pi if against else 0.0))

    def _on_line(self, one: Element, told: Element, line: Polyline, along: float) -> Pose:
        """So far along a route through places that are told by no road, straight from one to the next."""
        if told.tag == "FromLaneCoordinates":
            raise Refused(told, "there are no lanes on its route; write its waypoints as LanePosition")
        if not 0.0 <= along <= line.length + _BEYOND:
            raise Refused(told, f"its route is {line.length:.0f} m long, and {along:g} m is not on it")
        there = (*line.point_at(along), line.heading_at(along))
        x, y, heading = _beside(there, self._left * self._given.number(told, "t", "0"))
        return x, y, self._turned(one, heading)

    def _way(self, route: Element, waypoints: list[Element]) -> list[Stretch]:
        """The roads between the waypoints of a route, whatever lanes they name."""
        places: list[tuple[str, float]] = []
        for one in waypoints:
            number, road = self._road(one, self._given.text(one, "roadId"))
            places.append((number, self._on_it(one, road, self._given.number(one, "s"))))
        way: list[Stretch] = []
        for first, last in pairwise(places):
            found = roads_between(self._roads, first, last)
            if found is None:
                raise Refused(route, "from one of its waypoints no road leads to the next")
            way += found
        if not way:
            raise Refused(route, "it is not a route of two waypoints or more")
        return way

    def _on_it(self, one: Element, road: DrawnRoad, s: float) -> float:
        """An arc length on a road; a little beyond its end is its end."""
        if not -_ROUNDED <= s <= road.length + _ROUNDED:
            raise Refused(
                one, f"road {self._given.text(one, 'roadId')} is {road.length:.0f} m long, and {s:g} m is not on it"
            )
        return min(max(s, 0.0), road.length)

    def _road(self, one: Element, name: str) -> tuple[str, DrawnRoad]:
        """A road by its name in the map, with its number."""
        found = next(((number, road) for number, road in self._roads.items() if road.name == name), None)
        if found is None:
            raise Refused(one, f"the map {self._map_path.name} has no road {name[:40]!r}; give another with --map")
        return found

    def _turned(self, one: Element, usual: float) -> float:
        turn = one.find("Orientation")
        if turn is None:
            return usual
        angle = self._left * self._given.number(turn, "h", "0")
        return usual + angle if turn.attributes.get("type") == "relative" else angle

    def _lane(self, one: Element) -> int:
        try:
            return int(self._given.text(one, "laneId"))
        except ValueError:
            raise Refused(one, f"the lane {self._given.text(one, 'laneId')[:40]!r} is not a number") from None

    def _on_road(self, one: Element, s: float, lane: int, aside: float) -> Pose:
        """A point by its arc length on a road; of lane 0, `aside` counts from the road's reference line."""
        _, road = self._road(one, self._given.text(one, "roadId"))
        s = self._on_it(one, road, s)
        return road.place(s, aside + (0.0 if lane == 0 else self._middle(one, road, s, lane)))

    def _middle(self, one: Element, road: DrawnRoad, s: float, lane: int) -> float:
        """How far to the left of a road's reference line the middle of a lane is."""
        if lane not in road.lanes_at(s):
            raise Refused(one, f"road {road.name} has no lane {lane} there, but {road.lanes_at(s)}")
        return road.middle_at(s, lane)

    def _relative(self, one: Element) -> Pose:
        """So far along the lanes from somebody, and so many lanes or metres beside."""
        x, y, facing = self._of(one)
        section = self.network.laneSectionAt((x, y))
        if section is None:
            raise Refused(one, "the entity that it refers to stands on no lane")
        lanes = self._given.count(one, "dLane", "0")
        if lanes:  # counted to the left of whom it is told beside
            of = self.in_lane(section, (x, y, facing))
            section = self.beside(one, section, number_beside(of.number, of.left * lanes))
        ahead = self._given.number(one, "ds" if "ds" in one.attributes else "dsLane", "0")
        line = laneLine(section.lane, 0.0, middle_line)
        along, aside, _ = line.project(x, y)
        backs = math.cos(facing - line.heading_at(along)) < 0.0  # who keeps to the other side of the road
        ahead = -ahead if backs else ahead
        line = laneLine(section.lane, along + ahead + 1.0, middle_line)
        against = int(section.openDriveID) > 0  # the lane's own line runs as it is driven, t counts left of the road's
        told = "offset" if one.tag == "RelativeLanePosition" else "dt"
        beside = self._given.number(one, told, "0")
        aside = 0.0 if told == "offset" else aside
        if not self._mirrored:
            aside += -beside if against else beside
        if against and ahead and not backs:
            self._given.note(one, "its lane is driven against the road's line; it lies so far on as the lane is driven")
        along += ahead
        if not 0.0 <= along <= line.length:
            raise Refused(one, "so far along, or back, there is no lane that the lane there leads to")
        heading = line.heading_at(along)
        px, py, _ = _beside((*line.point_at(along), heading), aside)
        there = px, py, self._turned(one, heading + math.pi if backs and one.find("Orientation") is None else heading)
        return _beside(there, -beside) if self._mirrored else there

    def in_lane(self, section: Any, pose: Pose) -> InLane:
        """The lane of a section, for somebody who stands in it and faces along or against it."""
        number = int(section.openDriveID)
        line = laneLine(section.lane, of=middle_line)
        turn = math.remainder(pose[2] - line.heading_at(line.project(pose[0], pose[1])[0]), math.tau)
        along = abs(turn) <= math.pi / 2
        return InLane(number, 1 if along == (number < 0) else -1)

    def beside(self, one: Element, section: Any, number: int) -> Any:
        """The lane section with a number in OpenDRIVE, beside another."""
        if (found := numbered_beside(section, number)) is not None:
            return found
        raise Refused(one, f"there is no lane {number} beside lane {section.openDriveID}")

    def lane_line(self, one: Element, pose: Pose, number: int | None = None) -> Polyline | None:
        """The line of the lane that somebody stands on and of those it leads to, or of a lane beside it by number.

        It runs the way that he faces; None where he stands on no lane or across one.
        """
        x, y, heading = pose
        section = self.network.laneSectionAt((x, y))
        if section is None:
            if number is None:
                return None
            section = min(self.network.laneSections, key=lambda s: s.distanceTo((x, y)))
        if number is not None:
            section = self.beside(one, section, number)
        line = laneLine(section.lane)
        turn = math.remainder(heading - line.heading_at(line.project(x, y)[0]), math.tau)
        if number is None and min(abs(turn), math.pi - abs(turn)) > math.pi / 4:
            return None
        return line if abs(turn) < math.pi / 2 else Polyline(line.points[::-1])


@lru_cache(maxsize=4)
def _roads_of(path: Path, digest: str) -> dict[str, DrawnRoad]:
    """The roads of a map as they are written, by number."""
    del digest  # tells one content of a file from another
    return {road.get("id", ""): DrawnRoad(road) for road in check_opendrive(path).iter("road")}


def _beside(pose: Pose, left: float) -> Pose:
    """A place so far [m] to the left of another, turned as that is."""
    x, y, heading = pose
    return x - left * math.sin(heading), y + left * math.cos(heading), heading
