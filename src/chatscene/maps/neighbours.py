"""The lane beside a lane, whichever road the map has it in."""

from __future__ import annotations

import math
from typing import Any

import shapely

from chatscene.errors import MapError
from chatscene.maps.kept import kept
from chatscene.maps.lane_runs import lane_runs
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route

_TOGETHER = 0.2  # [m] at most between the left edges of two lanes that are one line


def section_beside(section: Any, side: int) -> Any:
    """The section of a lane that lies directly beside another: left for side 1, right for -1; None if there is none.

    Some maps have a road for each direction of a street, SUMO's among them. There the lane to the left of the
    innermost is the innermost of the road whose left edge is the same line from end to end, the other way round.
    Where lanes of two roads only meet, or run together for a while, they are not beside each other.

    Args:
        section: Scenic's lane section.
        side: Seen in its own driving direction.
    """
    own = section._laneToLeft if side > 0 else section._laneToRight
    if own is not None or side < 0 or not _one_way(section.road):
        return own
    edge = section.leftEdge.lineString
    begin, end = (shapely.Point(edge.coords[i]) for i in (0, -1))
    begins, innermost = kept(section.network, "innermost", _innermost_of_one_way)
    for i in sorted(begins.query(end, predicate="dwithin", distance=_TOGETHER).tolist()):
        other = innermost[i].leftEdge.lineString
        back = shapely.Point(other.coords[-1]).distance(begin) < _TOGETHER
        if back and innermost[i].road is not section.road and edge.hausdorff_distance(other) < _TOGETHER:
            return innermost[i]
    return None


_ACROSS = 40.0  # [m] to a lane that runs against a route, over its own direction and the widest median
_AGAINST = math.radians(30)
_LANES_ACROSS = 12  # of a road, at most


def numbered_beside(section: Any, number: int) -> Any:
    """The lane section with a number in OpenDRIVE, beside another or the same; None if there is none."""
    for turn in (1, -1):
        found = section
        for _ in range(_LANES_ACROSS):
            if found is None or int(found.openDriveID) == number:
                break
            found = section_beside(found, turn if found.isForward == section.isForward else -turn)
        if found is not None and int(found.openDriveID) == number:
            return found
    return None


def number_beside(of: int, lanes: int) -> int:
    """The number of the lane so many lanes beside another, as OpenDRIVE counts: there is no lane 0."""
    to = of + lanes
    return to if lanes == 0 or of * to > 0 else to + (1 if lanes > 0 else -1)


def opposes(lane: Any, other: Any) -> bool:
    """Whether a lane beside another runs against it."""
    return lane.group is not other.group


def _one_way(road: Any) -> bool:
    return road.forwardLanes is None or road.backwardLanes is None


def _innermost_of_one_way(network: Any) -> tuple[Any, list[Any]]:
    """Where the left edges of the innermost lanes of one-way roads begin, to be searched, and their sections."""
    lanes = [lane for road in network.roads if _one_way(road) for lane in road.lanes]
    found = [section for lane in lanes for section in lane.sections if section._laneToLeft is None]
    return shapely.STRtree([shapely.Point(s.leftEdge.lineString.coords[0]) for s in found]), found


def oncoming_line(network: Any, route: Route) -> Polyline | None:
    """The centre line of the nearest lane that runs against a route on its left, in its own driving order.

    Lanes of the route's own direction, and a median, may lie between.

    Args:
        network: Scenic's road network.
        route: The ego's route.
    """
    x, y = route.line.point_at(0.0)
    heading = route.line.heading_at(0.0)
    found: tuple[float, Polyline] | None = None
    for run in dict.fromkeys(lane_runs(network).values()):
        s, _, _ = run.line.project(x, y)
        px, py = run.line.point_at(s)
        near = math.hypot(px - x, py - y)
        left = (py - y) * math.cos(heading) - (px - x) * math.sin(heading)
        turned = abs(math.remainder(run.line.heading_at(s) - heading, 2 * math.pi))
        against = left > 0.0 and turned > math.pi - _AGAINST
        if against and near < _ACROSS and (found is None or near < found[0]):
            found = near, run.line
    return None if found is None else found[1]


def neighbour_line(network: Any, route: Route, side: str) -> Polyline:
    """The centre line of the lane beside the one a route starts in, in its own driving order.

    Args:
        network: Scenic's road network.
        route: The ego's route.
        side: ``left`` or ``right``, seen from the ego.

    Returns:
        For a lane of the same direction, the line from level with the route's start on. For an opposing lane,
        the whole lane, which runs against the route.

    Raises:
        MapError: No lane of cars lies directly on that side.
    """
    lane = network.elements[route.lane_ids[0]]
    x, y = route.line.point_at(0.0)
    section = network.laneSectionAt((x, y)) or lane.sections[0]
    # Scenic's left and right are those of the lane's own driving direction, as are the ego's.
    there = section_beside(section, 1 if side == "left" else -1)
    if there is None:
        raise MapError(f"route {route.id!r} on map {route.map_name!r} has no lane to its {side}")
    line = lane_runs(network)[there.lane.uid].line
    if opposes(section.lane, there.lane):
        return line
    level, _, _ = line.project(x, y)
    return line.between(level, line.length)
