"""A map's roads as a file: Scenic's network, its furniture and its limits as JSON, numbers and shapes.

What is read is data alone, whoever wrote it: JSON, floats, and shapes in OGC's well-known binary form. The file is
kept sealed, and named by the map and by all that makes roads of one.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Iterable, Mapping
from dataclasses import fields
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from chatscene.files.caches import installed
from chatscene.maps.furniture import Furniture, Stand, StandingPlace
from chatscene.maps.limits import RoadLimits
from chatscene.maps.roads import KINDS, Area, Line, Maneuver, ManeuverType, Roads, Signal

_LINES = ("centerline", "leftEdge", "rightEdge")
_LISTS = ("roads", "connectingRoads", "lanes", "intersections", "sidewalks", "shoulders", "laneSections")
_ONE = (
    "forwardLanes",
    "backwardLanes",
    "road",
    "group",
    "lane",
    "_opposite",
    "_sidewalk",
    "_laneToLeft",
    "_laneToRight",
)
_MANY = ("lanes", "sections", "incomingLanes", "outgoingLanes")
_PLAIN = ("isForward", "openDriveID")
_SIGNAL = ("uid", "openDriveID", "country", "type")
_WAY = ("startLane", "endLane", "connectingLane", "intersection")
_AREAS = ("drivableRegion", "intersectionRegion")


@cache
def made_by() -> bytes:
    """What roads depend on besides their map: Scenic, shapely and our reading of maps."""
    own = (path.read_bytes() for path in sorted(Path(__file__).parent.glob("*.py")))
    return hashlib.blake2b(b"".join((installed("scenic").encode(), installed("shapely").encode(), *own))).digest()


class _Writer:
    def __init__(self) -> None:
        self._shapes: list[bytes] = []
        self._size = 0
        self._points: list[NDArray[np.float64]] = []
        self._count = 0
        self._ways: dict[int, int] = {}
        self.ways: list[list[Any]] = []

    def shape(self, shape: Any) -> tuple[int, int]:
        """Where the bytes of a shape lie: from, to."""
        found = shapely.to_wkb(shape)
        self._shapes.append(found)
        self._size += len(found)
        return self._size - len(found), self._size

    def line(self, line: Any) -> list[int]:
        """Where the points of a line lie, and its shape if that is another than these points."""
        points = np.array(line.points, np.float64)
        self._points.append(points)
        self._count += len(points)
        where = [self._count - len(points), self._count]
        same = shapely.to_wkb(shapely.LineString(points)) == shapely.to_wkb(line.lineString)
        return where if same else [*where, *self.shape(line.lineString)]

    def way(self, maneuver: Any) -> int:
        """The number of a manoeuvre."""
        if id(maneuver) not in self._ways:
            self._ways[id(maneuver)] = len(self.ways)
            self.ways.append([maneuver.type.name, *(_uid(getattr(maneuver, name)) for name in _WAY)])
        return self._ways[id(maneuver)]

    def element(self, element: Any) -> list[Any]:
        """A part of the network: kind, ids, where its shapes lie, and what else is known of it."""
        about: dict[str, Any] = {}
        kind = KINDS[type(element).__name__]
        known = {name for one in kind.__mro__ for name in vars(one).get("__annotations__", ())}
        about |= {name: getattr(element, name) for name in _PLAIN if name in known}
        about |= {name: _uid(getattr(element, name)) for name in _ONE if name in known}
        about |= {name: [_uid(one) for one in getattr(element, name)] for name in _MANY if name in known}
        if "maneuvers" in known:
            about["maneuvers"] = [self.way(one) for one in element.maneuvers]
        if "signals" in known:
            about["signals"] = [[getattr(one, name) for name in _SIGNAL] for one in element.signals]
        lines = [self.line(getattr(element, name)) for name in _LINES if name in known]
        return [kind.__name__, element.uid, element.id, self.shape(element.polygons), lines, about]

    def content(self, structure: dict[str, Any]) -> bytes:
        """The whole file."""
        points = np.concatenate([np.zeros((0, 3)), *self._points]).astype("<f8").tobytes()
        head = json.dumps(structure | {"points": len(points)}).encode()
        return b"".join((len(head).to_bytes(4, "little"), head, points, *self._shapes))


def _uid(element: Any) -> str | None:
    return None if element is None else str(element.uid)


def written(network: Any) -> bytes:
    """A network as a file.

    Args:
        network: Scenic's, with furniture and limits, as `chatscene.maps.network.load_network` gives it.
    """
    to = _Writer()
    furniture: Furniture = network.furniture
    parts = [one for one in network.elements.values() if type(one).__name__ in KINDS]
    return to.content(
        {
            "elements": [to.element(one) for one in parts],
            "ways": to.ways,
            "lists": {name: [_uid(one) for one in getattr(network, name)] for name in _LISTS},
            "areas": {
                name: to.shape(area.polygons)
                for name in _AREAS
                if hasattr(area := getattr(network, name), "polygons")  # else Scenic's `nowhere`
            },
            "tolerance": network.tolerance,
            "mirrored": network.mirrored,
            "crosswalks": [(road, to.shape(area)) for road, area in furniture.crosswalks],
            "standing": [[getattr(one, name.name) for name in fields(one)] for one in furniture.standing],
            "lights": [(*where, ids) for where, ids in furniture.lights.items()],
            "cycle_lanes": [(*where, to.shape(area)) for where, area in furniture.cycle_lanes.items()],
            "tracks": [(road, to.shape(area), across) for road, area, across in furniture.tracks],
            "driveways": [(road, to.shape(area)) for road, area in furniture.driveways],
            "bus_lanes": sorted(furniture.bus_lanes),
            "limits": [
                (road, one.allowed, one.most, list(one.lanes.items()), one.kind)
                for road, one in network.speed_limits.items()
            ],
        }
    )


def read(body: bytes) -> Roads:
    """The roads of a file, which is as it was written."""
    size = 4 + int.from_bytes(body[:4], "little")
    told = json.loads(body[4:size])
    points = np.frombuffer(body, "<f8", told["points"] // 8, size).reshape(-1, 3)
    shapes = memoryview(body)[size + told["points"] :]
    return _Reader(told, points, shapes).roads()


class _Reader:
    def __init__(self, told: dict[str, Any], points: NDArray[np.float64], shapes: memoryview) -> None:
        self._told, self._points, self._shapes = told, points, shapes

    def _shape(self, where: Iterable[int]) -> memoryview:
        first, last = where
        return self._shapes[first:last]

    def _line(self, where: list[int]) -> Line:
        return Line(self._points[where[0] : where[1]], self._shape(where[2:]) if where[2:] else None)

    def roads(self) -> Roads:
        """The network, all its parts joined."""
        told, roads = self._told, Roads()
        roads.elements = {}
        for kind, uid, number, where, lines, _ in told["elements"]:
            made = roads.elements[uid] = KINDS[kind](uid, number, self._shape(where))
            made.network = roads
            made.__dict__.update(zip(_LINES, map(self._line, lines), strict=False))
        there = roads.elements
        ways = [self._way(one, there) for one in told["ways"]]
        for _, uid, *_, about in told["elements"]:
            of = there[uid].__dict__
            of.update((name, about[name]) for name in _PLAIN if name in about)
            of.update((name, there.get(about[name])) for name in _ONE if name in about)
            of.update((name, tuple(there[one] for one in about[name])) for name in _MANY if name in about)
            if "maneuvers" in about:
                of["maneuvers"] = tuple(ways[number] for number in about["maneuvers"])
            if "signals" in about:
                of["signals"] = tuple(map(_signal, about["signals"]))
        for name, uids in told["lists"].items():
            setattr(roads, name, tuple(there[uid] for uid in uids))
        for name, where in told["areas"].items():
            setattr(roads, name, Area(self._shape(where)))
        roads.tolerance, roads.mirrored = told["tolerance"], told["mirrored"]
        roads.furniture, roads.speed_limits = self._furniture(), _limits(told["limits"])
        return roads

    @staticmethod
    def _way(told: list[Any], there: Mapping[str, Any]) -> Maneuver:
        kind, *uids = told
        way = Maneuver()
        way.type = ManeuverType[kind]
        vars(way).update(zip(_WAY, map(there.get, uids), strict=True))
        return way

    def _furniture(self) -> Furniture:
        told = self._told

        def area(where: Iterable[int]) -> Any:
            return shapely.from_wkb(bytes(self._shape(where)))

        return Furniture(
            crosswalks=tuple((road, area(where)) for road, where in told["crosswalks"]),
            standing=tuple(_standing(one) for one in told["standing"]),
            lights={(road, forward): tuple(ids) for road, forward, ids in told["lights"]},
            cycle_lanes={(road, right): area(where) for road, right, where in told["cycle_lanes"]},
            tracks=tuple((road, area(where), across) for road, where, across in told["tracks"]),
            driveways=tuple((road, area(where)) for road, where in told["driveways"]),
            bus_lanes=frozenset((road, right) for road, right in told["bus_lanes"]),
        )


def _standing(told: list[Any]) -> StandingPlace:
    use, *rest = told
    return StandingPlace(Stand(use), *rest)


def _signal(told: list[Any]) -> Signal:
    signal = Signal()
    vars(signal).update(zip(_SIGNAL, told, strict=True))
    return signal


def _limits(told: list[Any]) -> dict[int, RoadLimits]:
    def steps(given: list[list[float]]) -> tuple[tuple[float, float], ...]:
        return tuple((s, speed) for s, speed in given)

    return {
        road: RoadLimits(steps(allowed), steps(most), {lane: steps(own) for lane, own in lanes}, kind)
        for road, allowed, most, lanes, kind in told
    }
