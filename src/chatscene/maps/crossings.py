"""Other vehicles' ways through a junction that meet the ego's route."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from chatscene.maps.kept import kept_with_network
from chatscene.maps.lane_runs import centre_line, lane_runs
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.scenario import Maneuver

MEETING = 2.5  # [m], paths nearer than this meet: about a car's width and some
_BESIDE = 15.0  # [m] to the side of the ego's way at most that those pass it who come from the arm opposite
_CROSSED = 60  # [m] of another's way after it enters the junction that may meet the ego's
# Each query looks at all ways through all junctions. If fewer are kept than there are, each is gone when the next query
# asks for it. All catalogues together ask for 4900 ways of the packaged maps; they take 120 MB.
ALL_LEGS = 8192

TURNS = {
    "STRAIGHT": Maneuver.STRAIGHT,
    "LEFT_TURN": Maneuver.LEFT_TURN,
    "RIGHT_TURN": Maneuver.RIGHT_TURN,
}


@dataclass(frozen=True, slots=True, kw_only=True)
class CrossingPath:
    """The way of another vehicle that meets the ego's at a junction.

    Attributes:
        line: Its lane before the junction, through it, and after.
        from_side: Where it comes from, seen from the ego: ``left``, ``right`` or ``oncoming``.
        entry: Arc length [m] on `line` where it enters the junction.
        meets_at: Arc length [m] on `line` where it first comes near the ego's route.
        ego_meets_at: Arc length [m] on the ego's route of that place.
    """

    line: Polyline
    turn: Maneuver
    from_side: str
    entry: float
    meets_at: float
    ego_meets_at: float


@kept_with_network(ALL_LEGS)
def conflicting_paths(network: Any, route: Route) -> tuple[CrossingPath, ...]:
    """The ways of other vehicles through a route's junction that meet the route.

    Returns:
        Straight ways first, then left turns, then right turns; each at most once per pair of lanes.
    """
    if route.junction is None:
        return ()
    intersection = network.elements[route.junction]
    start = next(m.startLane for m in intersection.maneuvers if m.connectingLane.uid in route.lane_ids)
    found = [
        path
        for maneuver in sorted(intersection.maneuvers, key=lambda m: (m.startLane.uid, m.endLane.uid))
        if maneuver.startLane.road is not start.road or maneuver.startLane.group is not start.group
        if (path := _crossing(network, maneuver, route)) is not None
    ]
    order = list(TURNS.values())
    return tuple(sorted(found, key=lambda path: order.index(path.turn)))


def _crossing(network: Any, maneuver: Any, route: Route) -> CrossingPath | None:
    turn = TURNS.get(maneuver.type.name)
    if turn is None:
        return None
    line, enters = _way(network, maneuver)
    side = from_side_of(line.heading_at(enters - 1.0) - route.line.heading_at(route.event_at - 1.0))
    if side is None:
        return None
    entry, ego_entry = int(enters), int(route.event_at)
    other, own = line.points[entry : entry + _CROSSED], route.line.points[ego_entry:]
    distance = np.hypot(other[:, None, 0] - own[None, :, 0], other[:, None, 1] - own[None, :, 1])
    near = np.flatnonzero(distance.min(axis=1) < MEETING)
    if near.size == 0:
        return None
    first = int(near[0])
    return CrossingPath(
        line=line,
        turn=turn,
        from_side=side,
        entry=enters,
        meets_at=float(entry + first),
        ego_meets_at=float(ego_entry + distance[first].argmin()),
    )


@kept_with_network(256)
def passing_path(network: Any, route: Route) -> CrossingPath | None:
    """The way of who comes from the arm opposite the ego's, goes straight on, and passes it in the junction.

    The two are level with each other where they are said to meet. None if there is no such way beside the ego's.
    """
    if route.junction is None:
        return None
    best: CrossingPath | None = None
    nearest = _BESIDE
    for maneuver in sorted(network.elements[route.junction].maneuvers, key=lambda m: (m.startLane.uid, m.endLane.uid)):
        if maneuver.type.name != "STRAIGHT":
            continue
        line, enters = _way(network, maneuver)
        if from_side_of(line.heading_at(enters - 1.0) - route.line.heading_at(route.event_at - 1.0)) != "oncoming":
            continue
        at = enters + 0.5 * maneuver.connectingLane.centerline.length
        level, aside, _ = route.line.project(*line.point_at(at))
        if level > route.event_at and MEETING <= abs(aside) < nearest:
            nearest = abs(aside)
            best = CrossingPath(
                line=line,
                turn=Maneuver.STRAIGHT,
                from_side="oncoming",
                entry=enters,
                meets_at=at,
                ego_meets_at=level,
            )
    return best


@kept_with_network(4096)
def _way(network: Any, maneuver: Any) -> tuple[Polyline, float]:
    """The line of a vehicle that does a manoeuvre, from the junction before to the one after, and where it enters."""
    runs = lane_runs(network)
    before, after = runs[maneuver.startLane.uid].line, runs[maneuver.endLane.uid].line
    line = Polyline.join(before, centre_line(maneuver.connectingLane), after)
    return line.resampled(1.0), before.length


def from_side_of(difference: float) -> str | None:
    """Where somebody comes from whose heading differs from the ego's by so much [rad]."""
    turned = math.degrees((difference + math.pi) % (2 * math.pi) - math.pi)
    if abs(turned) > 135:
        return "oncoming"
    if turned >= 45:
        return "right"
    return "left" if turned <= -45 else None
