"""Other vehicles' ways into and round a roundabout that meet the ego's route."""

from __future__ import annotations

from functools import lru_cache
from typing import Any

import numpy as np

from chatscene.maps.crossings import MEETING, CrossingPath, from_side_of
from chatscene.maps.lane_runs import centre_line, lane_runs
from chatscene.maps.layout import roundabouts
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.scenario import Maneuver

ROUND = "round"
"""From where somebody comes who goes round in the roundabout already."""
_ENTERS = 10.0  # [m] before the ego is in the ring, where others may meet it
_LAP = 0.3  # of the ring, behind which it leads back to the ego's entry


@lru_cache(maxsize=256)
def ring_ways(network: Any, route: Route) -> tuple[CrossingPath, ...]:
    """The ways of others in the roundabout that a route leads through, that meet it.

    Args:
        network: Scenic's road network.
        route: The ego's; one that leads through no roundabout meets nobody.

    Returns:
        By where they come from: ``round``, who is in the ring when it begins and comes to the ego's entry; then who
        enters from the arms to the ``left``, ``right`` and ``oncoming``, as the ego sees them from its entry.
    """
    ring = next((one for one in roundabouts(network) if route.junction in one.junctions), None)
    if ring is None:
        return ()
    on = set(ring.lanes)
    into = next(m for m in network.elements[route.junction].maneuvers if m.connectingLane.uid in route.lane_ids)
    entries = [
        maneuver
        for junction in sorted(ring.junctions)
        for maneuver in network.elements[junction].maneuvers
        if maneuver.startLane.uid not in on and maneuver.endLane.uid in on
    ]
    inside = route.line.project(*centre_line(into.endLane).point_at(0.0))[0]
    lap = _lap(network, ring.lanes, into.endLane.uid)
    found = [_met(Polyline.join(lap, lap), 0.0, ROUND, route, inside, lap.length * _LAP)]
    for entry in entries:
        if entry.startLane.group is into.startLane.group:
            continue
        before = lane_runs(network)[entry.startLane.uid].line
        line = Polyline.join(before, centre_line(entry.connectingLane), _lap(network, ring.lanes, entry.endLane.uid))
        side = from_side_of(before.heading_at(before.length - 1.0) - route.line.heading_at(route.event_at - 1.0))
        if side is not None:
            found.append(_met(line, before.length, side, route, inside, before.length))
    order = (ROUND, "left", "right", "oncoming")
    return tuple(sorted((one for one in found if one is not None), key=lambda one: order.index(one.from_side)))


def _lap(network: Any, lanes: tuple[str, ...], first: str) -> Polyline:
    """Once round a ring from the beginning of one of its lanes on."""
    at = lanes.index(first)
    return Polyline.join(*(centre_line(network.elements[uid]) for uid in (*lanes[at:], *lanes[:at])))


def _met(line: Polyline, entry: float, side: str, route: Route, inside: float, after: float) -> CrossingPath | None:
    """A way as far as it meets the ego's, which is in the ring from `inside` [m] on; nothing before `after` [m]."""
    line = line.resampled(1.0)
    own_from = max(int(inside - _ENTERS), 0)
    own_to = int(inside + 1.0) if side == ROUND else len(route.line.points)
    other, own = line.points[int(after) :], route.line.points[own_from:own_to]
    distance = np.hypot(other[:, None, 0] - own[None, :, 0], other[:, None, 1] - own[None, :, 1])
    near = np.flatnonzero(distance.min(axis=1) < MEETING)
    if near.size == 0:
        return None
    first = int(near[0])
    return CrossingPath(
        line=line,
        turn=Maneuver.STRAIGHT,
        from_side=side,
        entry=entry,
        meets_at=float(int(after) + first),
        ego_meets_at=float(own_from + distance[first].argmin()),
    )
