"""The way of somebody who leaves the ego's road by a ramp that the ego goes past."""

from __future__ import annotations

from typing import Any

from chatscene.errors import MapError
from chatscene.maps.kept import kept_with_network
from chatscene.maps.lane_runs import centre_line, lane_runs
from chatscene.maps.layout import JunctionKind, ramp_ways
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route

BESIDE = 8.0  # [m] from the ego's way at most to the nose of a ramp that leaves the lane beside its own


@kept_with_network(256)
def off_ramp_line(network: Any, route: Route) -> Polyline:
    """The middle of the lane that leads to the nearest ramp off the road beside a route, and on down that ramp.

    Raises:
        MapError: No ramp leads off its road.
    """
    runs, near = lane_runs(network), list[tuple[float, Any]]()
    for way in ramp_ways(network, JunctionKind.DIVERGE):
        lane = runs[way.startLane.uid].line
        at, aside, _ = route.line.project(*lane.point_at(lane.length))
        if 0.0 < at < route.line.length and abs(aside) < BESIDE:
            near.append((abs(at - route.event_at), way))
    if not near:
        raise MapError(f"route {route.id!r} leads past no ramp by which somebody could leave its road")
    _, way = min(near, key=lambda one: (one[0], one[1].endLane.uid))
    return Polyline.join(runs[way.startLane.uid].line, centre_line(way.connectingLane), runs[way.endLane.uid].line)
