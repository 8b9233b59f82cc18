"""The lane beside the ego's."""

from __future__ import annotations

from typing import Any

from chatscene.errors import MapError
from chatscene.maps.lane_runs import lane_runs
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route


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
    beside = section._laneToLeft if side == "left" else section._laneToRight
    if beside is None:
        raise MapError(f"route {route.id!r} on map {route.map_name!r} has no lane to its {side}")
    line = lane_runs(network)[beside.lane.uid].line
    if beside.isForward != section.isForward:
        return line
    level, _, _ = line.project(x, y)
    return line.between(level, line.length)
