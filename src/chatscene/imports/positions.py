"""Places in a scenario file: on the map, on its roads and lanes, beside others, along lines."""

from __future__ import annotations

import math
from functools import cached_property
from pathlib import Path
from typing import Any

from chatscene.imports.given import Given, Refused
from chatscene.imports.player import InLane, lane_beside
from chatscene.imports.stranger_xml import Element
from chatscene.maps.neighbours import section_beside
from chatscene.maps.network import load_network
from chatscene.terms.polyline import Polyline
from chatscene.world.places import laneLine

Pose = tuple[float, float, float]  # x, y [m], heading [rad]
_LANES_ACROSS = 12


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
    def _roads(self) -> Any:
        """The roads as they are written, by number; that the network can be made shows that they can be read."""
        assert self.network is not None
        from scenic.formats.opendrive.xodr_parser import RoadMap

        roads = RoadMap()
        roads.parse(str(self._map_path))
        return roads.roads

    def pose(self, position: Element) -> Pose:
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
            case _:
                raise Refused(one, "such a place is not read; write a WorldPosition or a LanePosition")

    def _of(self, one: Element) -> Pose:
        name = self._given.text(one, "entityRef")
        if name not in self.known:
            raise Refused(one, f"where {name[:40]!r} is, is not told before")
        return self.known[name]

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
            raise Refused(one, f"the lane {self._given.text(one, 'laneId')[:40]!r} is no number") from None

    def _on_road(self, one: Element, s: float, lane: int, aside: float) -> Pose:
        """A point by its arc length on a road; of lane 0, `aside` counts from the road's reference line."""
        number = self._given.text(one, "roadId")
        road = next((road for key, road in self._roads.items() if str(key) == number), None)
        if road is None:
            raise Refused(one, f"the map {self._map_path.name} has no road {number[:40]!r}; give another with --map")
        length = sum(piece.length for piece in road.ref_line)
        if not 0.0 <= s <= length:
            raise Refused(one, f"road {number} is {length:.0f} m long, and {s:g} m is not on it")
        (x, y), heading = _reference(road, s)
        left = aside + (0.0 if lane == 0 else self._middle(one, road, s, lane))
        return x - left * math.sin(heading), y + left * math.cos(heading), heading

    def _middle(self, one: Element, road: Any, s: float, lane: int) -> float:
        """How far to the left of a road's reference line the middle of a lane is."""
        section = [part for part in road.lane_secs if part.s0 <= s][-1]
        if lane not in section.lanes:
            raise Refused(one, f"road {road.id_} has no lane {lane} there, but {sorted(section.lanes)}")
        outer = section.get_offsets(s)
        inner = outer.get(lane - 1 if lane > 0 else lane + 1, 0.0)
        return float(road.get_ref_line_offset(s) + (outer[lane] + inner) / 2)

    def _relative(self, one: Element) -> Pose:
        """So far along the lanes from somebody, and so many lanes or metres beside."""
        x, y, facing = self._of(one)
        section = self.network.laneSectionAt((x, y))
        if section is None:
            raise Refused(one, "whom it is told beside stands on no lane")
        lanes = int(self._given.number(one, "dLane", "0"))
        if lanes:  # counted to the left of whom it is told beside
            of = self.in_lane(section, (x, y, facing))
            section = self.beside(one, section, lane_beside(of.number, of.left * lanes))
        line = laneLine(section.lane)
        along, aside, _ = line.project(x, y)
        against = int(section.openDriveID) > 0  # the lane's own line runs as it is driven, t counts left of the road's
        told = "offset" if one.tag == "RelativeLanePosition" else "dt"
        beside = self._given.number(one, told, "0")
        aside = 0.0 if told == "offset" else aside
        if not self._mirrored:
            aside += -beside if against else beside
        ahead = self._given.number(one, "ds" if "ds" in one.attributes else "dsLane", "0")
        if against and ahead:
            self._given.notes.append(
                f"line {one.line}: its lane is driven against the road's line; it lies so far on as the lane is driven"
            )
        along += ahead
        if not 0.0 <= along <= line.length:
            raise Refused(one, "so far along, or back, there is no lane that the lane there leads to")
        heading = line.heading_at(along)
        px, py, _ = _beside((*line.point_at(along), heading), aside)
        there = px, py, self._turned(one, heading)
        return _beside(there, -beside) if self._mirrored else there

    def in_lane(self, section: Any, pose: Pose) -> InLane:
        """The lane of a section, for somebody who stands in it and faces along or against it."""
        number = int(section.openDriveID)
        line = laneLine(section.lane)
        turn = math.remainder(pose[2] - line.heading_at(line.project(pose[0], pose[1])[0]), math.tau)
        along = abs(turn) <= math.pi / 2
        return InLane(number, 1 if along == (number < 0) else -1)

    def beside(self, one: Element, section: Any, number: int) -> Any:
        """The lane section with a number in OpenDRIVE, beside another."""
        for turn in (1, -1):
            found = section
            for _ in range(_LANES_ACROSS):
                if found is None or int(found.openDriveID) == number:
                    break
                found = section_beside(found, turn if found.isForward == section.isForward else -turn)
            if found is not None and int(found.openDriveID) == number:
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


def _beside(pose: Pose, left: float) -> Pose:
    """A place so far [m] to the left of another, turned as that is."""
    x, y, heading = pose
    return x - left * math.sin(heading), y + left * math.cos(heading), heading


def _reference(road: Any, s: float) -> tuple[tuple[float, float], float]:
    """A point on a road's reference line and its heading."""
    before = 0.0
    for piece in road.ref_line:
        if s <= before + piece.length or piece is road.ref_line[-1]:
            at = min(s - before, piece.length)
            x, y, _ = piece.point_at(at)
            step = min(0.01, piece.length)
            start = min(max(at - step / 2, 0.0), piece.length - step)
            x0, y0, _ = piece.point_at(start)
            x1, y1, _ = piece.point_at(start + step)
            return (float(x), float(y)), math.atan2(y1 - y0, x1 - x0)
        before += piece.length
    raise AssertionError("a road has a reference line")
