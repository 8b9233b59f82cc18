"""A map's roads as plain objects: what of Scenic's network is asked by those who need no Scenic.

Names and meanings are Scenic's (`scenic.domains.driving.roads`), so that either network serves whoever looks for routes
or draws a map. Shapes are made of bytes once something asks for them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from enum import Enum
from functools import cached_property
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

TRAFFIC_LIGHT = "1000001"
Point = Sequence[float]


class ManeuverType(Enum):
    """What a way does, by Scenic's names."""

    STRAIGHT = "STRAIGHT"
    LEFT_TURN = "LEFT_TURN"
    RIGHT_TURN = "RIGHT_TURN"
    U_TURN = "U_TURN"


class Area:
    """An area of the map.

    Attributes:
        polygons: Shapely's, map frame [m].
    """

    def __init__(self, shape: memoryview) -> None:
        self._shape = shape

    @cached_property
    def polygons(self) -> Any:
        """The area, as shapely has it [m]."""
        return shapely.from_wkb(bytes(self._shape))


class Line:
    """A line of the map, in driving order.

    Attributes:
        points: Triples [m], map frame, the last of each 0.
    """

    def __init__(self, points: NDArray[np.float64], shape: memoryview | None = None) -> None:
        self._points = points
        self._shape = shape

    @cached_property
    def points(self) -> tuple[tuple[float, float, float], ...]:
        """Its points [m]."""
        return tuple((x, y, z) for x, y, z in self._points.tolist())

    @cached_property
    def lineString(self) -> Any:  # noqa: N802 - Scenic's name, as all below
        """The line, as shapely has it [m]."""
        return shapely.LineString(self._points) if self._shape is None else shapely.from_wkb(bytes(self._shape))

    @property
    def length(self) -> float:
        """Its length [m]."""
        return float(self.lineString.length)


class Element(Area):
    """A part of the network: a road, a lane, or another.

    Attributes:
        id: That of the map's file, where it has one.
    """

    network: Roads

    def __init__(self, uid: str, number: Any, shape: memoryview) -> None:
        super().__init__(shape)
        self.uid, self.id = uid, number

    def __repr__(self) -> str:
        return f"{type(self).__name__}({self.uid!r})"

    def containsPoint(self, point: Point) -> bool:  # noqa: N802
        """Whether it has a point [m]."""
        shapely.prepare(self.polygons)
        return bool(shapely.intersects_xy(self.polygons, point[0], point[1]))

    def distanceTo(self, point: Point) -> float:  # noqa: N802
        """How far [m] it is from a point [m]."""
        return float(shapely.distance(self.polygons, shapely.Point(point[0], point[1])))


class _Linear(Element):
    """A part that leads somewhere, with its middle and its edges."""

    centerline: Line
    leftEdge: Line  # noqa: N815
    rightEdge: Line  # noqa: N815


class Road(_Linear):
    """A road: its lanes, by direction and by stretch."""

    lanes: tuple[Lane, ...] = ()
    forwardLanes: LaneGroup | None = None  # noqa: N815
    backwardLanes: LaneGroup | None = None  # noqa: N815
    sections: tuple[RoadSection, ...] = ()
    signals: tuple[Signal, ...] = ()


class RoadSection(_Linear):
    """A stretch of a road on which the number of lanes is one."""

    lanes: tuple[LaneSection, ...] = ()


class LaneGroup(_Linear):
    """The lanes of one road in one direction, the outermost first."""

    road: Road
    lanes: tuple[Lane, ...] = ()
    _opposite: LaneGroup | None = None
    _sidewalk: Sidewalk | None = None


class Lane(_Linear):
    """A lane, whose sections lie in driving order."""

    group: LaneGroup
    road: Road
    sections: tuple[LaneSection, ...] = ()
    maneuvers: tuple[Maneuver, ...] = ()


class LaneSection(_Linear):
    """A lane on one stretch of its road; left and right are seen in its own driving direction."""

    lane: Lane
    group: LaneGroup
    road: Road
    isForward: bool = True  # noqa: N815
    openDriveID: int = 0  # noqa: N815
    _laneToLeft: LaneSection | None = None  # noqa: N815
    _laneToRight: LaneSection | None = None  # noqa: N815


class Sidewalk(_Linear):
    """A sidewalk."""


class Shoulder(_Linear):
    """A shoulder."""


class Intersection(Element):
    """A junction, with all ways through it."""

    incomingLanes: tuple[Lane, ...] = ()  # noqa: N815
    outgoingLanes: tuple[Lane, ...] = ()  # noqa: N815
    maneuvers: tuple[Maneuver, ...] = ()
    signals: tuple[Signal, ...] = ()


class Maneuver:
    """A way from the end of a lane into another, through a junction if it has a lane there."""

    type: ManeuverType
    startLane: Lane  # noqa: N815
    endLane: Lane  # noqa: N815
    connectingLane: Lane | None = None  # noqa: N815
    intersection: Intersection | None = None


class Signal:
    """A light or a sign, by its number and its kind in OpenDRIVE."""

    uid: Any = None
    openDriveID: Any = None  # noqa: N815
    country: Any = None
    type: Any = None

    @property
    def isTrafficLight(self) -> bool:  # noqa: N802
        """Whether it is a light."""
        return bool(self.type == TRAFFIC_LIGHT)


KINDS: Mapping[str, type[Element]] = {
    one.__name__: one for one in (Road, RoadSection, LaneGroup, Lane, LaneSection, Sidewalk, Shoulder, Intersection)
}


class Roads:
    """A network.

    Attributes:
        tolerance: How far [m] a point may lie outside what it is said to lie in.
        mirrored: Whether it is the mirror image of its map, which is of left-hand traffic.
        intersectionRegion: All junctions, where there are any.
        furniture: See `chatscene.maps.furniture.furniture_of`.
        speed_limits: See `chatscene.maps.limits.limits_of`.
    """

    elements: dict[str, Element]
    roads: tuple[Road, ...] = ()
    connectingRoads: tuple[Road, ...] = ()  # noqa: N815
    lanes: tuple[Lane, ...] = ()
    intersections: tuple[Intersection, ...] = ()
    sidewalks: tuple[Sidewalk, ...] = ()
    shoulders: tuple[Shoulder, ...] = ()
    laneSections: tuple[LaneSection, ...] = ()  # noqa: N815
    tolerance: float = 0.0
    mirrored: bool = False
    drivableRegion: Area  # noqa: N815
    intersectionRegion: Area  # noqa: N815
    furniture: Any
    speed_limits: Any

    @cached_property
    def _found(self) -> shapely.STRtree:
        return shapely.STRtree([lane.polygons for lane in self.lanes])

    def _at(self, point: Point, among: Sequence[Element], tree: shapely.STRtree) -> Any:
        """The first of some parts that has a point [m], else the first that is as near as is tolerated."""
        there = shapely.Point(point[0], point[1])
        for within in (0.0, self.tolerance)[: 1 + (self.tolerance > 0)]:
            found = tree.query(there.buffer(within) if within else there, predicate="intersects")
            if len(found):
                return among[int(found.min())]
        return None

    def laneAt(self, point: Point) -> Lane | None:  # noqa: N802
        """The lane at a point [m]."""
        return self._at(point, self.lanes, self._found)

    def laneSectionAt(self, point: Point) -> LaneSection | None:  # noqa: N802
        """The section of a lane at a point [m]."""
        lane = self.laneAt(point)
        if lane is None:
            return None
        return self._at(point, lane.sections, shapely.STRtree([section.polygons for section in lane.sections]))
