"""Routes through a roundabout: into it, round in it, and out by an exit; and what is asked of the roundabout itself."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from chatscene.maps.kept import kept
from chatscene.maps.lane_runs import centre_line, lane_runs
from chatscene.maps.layout import Ring, arm_poses, roundabouts
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import RouteQuery
from chatscene.terms.scenario import Maneuver

ENTRIES = (42.0, 36.0, 48.0, 30.0)  # [m] from a route's start to the roundabout
EXIT = 45.0  # [m] driven after it
_SHORTEST = 15.0  # [m] of that
_TURN = math.radians(45)
_NO_TURN = math.radians(135)  # and beyond: one turns round

Way = tuple[str, Maneuver, Polyline, tuple[str, ...], float, Any]
"""What to spread over, what a way does, its line and its lanes, where [m] its junction is, and that."""


def ways_round(network: Any, query: RouteQuery, approach: float) -> Iterator[Way]:
    """Into each roundabout that is asked for, round it, and out at each exit, or at the one that is asked for.

    That of the entry's own arm is one only if it is asked for.
    """
    runs = lane_runs(network)
    for ring in roundabouts(network):
        if not _is_asked_for(network, ring, query):
            continue
        on = set(ring.lanes)
        for entry in sorted(ring.entries(network), key=lambda m: (m.startLane.uid, m.endLane.uid)):
            before = runs[entry.startLane.uid]
            if before.line.length < approach + 2:
                continue
            head = before.line.between(before.line.length - approach, before.line.length)
            ids = before.ids_between(before.line.length - approach, before.line.length)
            for number, ways, last in _exits(entry, on):
                after = runs[last.uid]
                end = min(EXIT, after.line.length)
                line = Polyline.join(head, *(centre_line(lane) for lane in ways), after.line.between(0.0, end))
                maneuver = _turn_of(line, round_too=query.by_exit is not None)
                if maneuver is not None and end >= _SHORTEST and query.by_exit in (None, number):
                    lanes = (*ids, *(lane.uid for lane in ways), *after.ids_between(0.0, end))
                    yield entry.startLane.uid, maneuver, line, lanes, approach, entry.intersection


def _is_asked_for(network: Any, ring: Ring, query: RouteQuery) -> bool:
    """Whether a roundabout has the arms, the size and the lanes of a query."""
    if query.arms not in (None, arms_of(network, ring)):
        return False
    if query.across is not None and not query.across[0] <= across(network, ring) <= query.across[1]:
        return False
    return query.lanes_same_way <= len(ring.tracks) <= (query.most_lanes or len(ring.tracks))


def arms_of(network: Any, ring: Ring) -> int:
    """How many arms a roundabout has."""
    on = {network.elements[lane].road.uid for lane in ring.lanes}
    return len(arm_poses([network.elements[junction] for junction in sorted(ring.junctions)], without=on))


def across(network: Any, ring: Ring) -> float:
    """The diameter [m] of the circle round the lanes of a roundabout."""
    inner = np.concatenate([centre_line(network.elements[lane]).points for lane in ring.tracks[0]])
    x, y = (inner.min(axis=0) + inner.max(axis=0)) / 2
    edges = [point[:2] for lane in ring.tracks[-1] for point in network.elements[lane].rightEdge.points]
    return 2.0 * float(np.median(np.hypot(*(np.array(edges) - (x, y)).T)))


def left_at(network: Any, route: Any) -> Any:
    """The junction at which a route leaves its roundabout; that to which it comes, if it leads through none.

    Args:
        network: Scenic's road network.
        route: A route through a junction.
    """
    ring = next((one for one in roundabouts(network) if route.junction in one.junctions), None)
    if ring is None:
        return network.elements[route.junction]
    through = kept(network, "ways of rings", _junction_of_ways)
    return network.elements[through[next(uid for uid in reversed(route.lane_ids) if uid in through)]]


def _junction_of_ways(network: Any) -> dict[str, str]:
    """By each lane inside a junction of a roundabout, that junction."""
    at = (network.elements[junction] for ring in roundabouts(network) for junction in ring.junctions)
    return {m.connectingLane.uid: junction.uid for junction in at for m in junction.maneuvers if m.connectingLane}


def _exits(entry: Any, on: set[str]) -> Iterator[tuple[int, list[Any], Any]]:
    """From an entry on, once round: the number of each exit, the lanes up to it, and the lane beyond it."""
    ways, lane, seen, number = [entry.connectingLane], entry.endLane, set[str](), 0
    while lane.uid not in seen:
        seen.add(lane.uid)
        ways = [*ways, lane]
        number += _leads_out(lane, on)
        for maneuver in sorted(lane.maneuvers, key=lambda m: m.endLane.uid):
            if maneuver.endLane.uid not in on and maneuver.connectingLane is not None:
                yield number, [*ways, maneuver.connectingLane], maneuver.endLane
        onward = next((m for m in lane.maneuvers if m.endLane.uid in on), None)
        if onward is None:
            return
        ways = [*ways, onward.connectingLane] if onward.connectingLane is not None else ways
        lane = onward.endLane


def _leads_out(lane: Any, on: set[str]) -> bool:
    """Whether a ring has an exit where one of its lanes ends, be it by another of them."""
    junctions = (m.intersection for m in lane.maneuvers if m.intersection is not None)
    ways = (way for junction in dict.fromkeys(junctions) for way in junction.maneuvers)
    return any(way.startLane.uid in on and way.endLane.uid not in on for way in ways)


def _turn_of(line: Polyline, *, round_too: bool) -> Maneuver | None:
    """What a way through a roundabout amounts to; to turn round, which does so to the left, only if that counts."""
    turned = math.remainder(line.heading_at(line.length) - line.heading_at(0.0), 2 * math.pi)
    if abs(turned) >= _NO_TURN:
        return Maneuver.LEFT_TURN if round_too else None
    return Maneuver.STRAIGHT if abs(turned) < _TURN else Maneuver.LEFT_TURN if turned > 0 else Maneuver.RIGHT_TURN
