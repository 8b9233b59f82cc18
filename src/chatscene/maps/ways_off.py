"""Ways off the ego's road, and out of a driveway onto it: what one drives along, as roads are made for it.

A driveway is no junction of a map, so that its ways are made here: an arc that the lane touches, and a straight line.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

import numpy as np

from chatscene.maps.crossings import MEETING, CrossingPath
from chatscene.maps.furniture import furniture_of
from chatscene.maps.kept import kept_with_network
from chatscene.maps.lane_runs import centre_line, lane_runs
from chatscene.maps.neighbours import oncoming_line
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.scenario import Maneuver

NARROWEST = 5.5  # [m] of a driveway at least in which two pass each other
IN_AT, OUT_AT = 0.3, 0.7  # of its width, from where the ego comes to it on its right, at which one turns in, comes out
RADIUS, OVER_RADIUS = 5.5, 7.5  # [m] of a turn at the edge of the road, and of one over a lane
_FAR = 20.0  # [m] from a route's event at most that the driveway lies which it leads past
_STEP = math.radians(5)
_TURNS = {"right": "RIGHT_TURN", "left": "LEFT_TURN"}
_SIDES = {"left": 1.0, "right": -1.0}
_BEYOND = 150.0  # [m] of the lane that somebody comes into

_Point = tuple[float, float]


@kept_with_network(256)
def way_off(network: Any, route: Route, side: str) -> Polyline | None:
    """The way off the ego's road to a side: into the arm of its junction, or into the driveway; None if none is there.

    It begins where the ego's lane does.

    Args:
        network: Scenic's road network.
        route: The ego's route.
        side: ``left`` or ``right``.
    """
    if route.junction is not None:
        return _into_arm(network, route, side)
    if (mouth := _mouth(network, route, side)) is None:
        return None
    near, far, edge, depth = mouth
    radius = RADIUS if side == "right" else OVER_RADIUS
    at = _through(near, far, IN_AT if side == "right" else OUT_AT)
    sign = _SIDES[side]
    ends = _seen(route, [*_arc(at - radius, 0.0, radius, 1.0, sign), (at, sign * (edge + depth))])
    begins = max(at - radius, 1.0)
    return Polyline.join(route.line.between(0.0, begins), Polyline(ends)).resampled(1.0)


def turns_at(network: Any, route: Route, side: str) -> float | None:
    """Where [m] on the ego's route the way off it to a side begins to turn; None where there is none."""
    if way_off(network, route, side) is None:
        return None
    if route.junction is not None:
        return float(route.event_at)
    mouth = _mouth(network, route, side)
    assert mouth is not None
    near, far, *_ = mouth
    at = _through(near, far, IN_AT if side == "right" else OUT_AT)
    return at - (RADIUS if side == "right" else OVER_RADIUS)


def _through(near: float, far: float, share: float) -> float:
    """Where [m] one goes through a driveway: in the middle, or on its own side of one that is wide enough for two."""
    return near + share * (far - near) if far - near > NARROWEST else 0.5 * (near + far)


def _into_arm(network: Any, route: Route, side: str) -> Polyline | None:
    """From the ego's lane through its junction into the arm on a side, or from a lane beside it that leads there."""
    runs, turns = lane_runs(network), network.elements[route.junction].maneuvers
    start = next((one.startLane for one in turns if one.connectingLane.uid in route.lane_ids), None)
    if start is None:
        return None
    there = (one for one in turns if one.type.name == _TURNS[side] and one.startLane.group is start.group)
    first = min(there, key=lambda one: (one.startLane is not start, one.startLane.uid, one.endLane.uid), default=None)
    if first is None:
        return None
    before, after = runs[first.startLane.uid].line, runs[first.endLane.uid].line
    return Polyline.join(before, centre_line(first.connectingLane), after).resampled(1.0)


@kept_with_network(256)
def ways_out(network: Any, route: Route, side: str) -> tuple[CrossingPath, ...]:
    """The ways of those who come out of the driveway beside a route and turn onto its road.

    Args:
        network: Scenic's road network.
        route: The ego's route.
        side: On which side of it the driveway is, ``left`` or ``right``.
    """
    return tuple(_ways_out(network, route, side))


def _ways_out(network: Any, route: Route, side: str) -> Iterator[CrossingPath]:
    if route.junction is not None or (mouth := _mouth(network, route, side)) is None:
        return
    near, far, edge, depth = mouth
    at = _through(near, far, OUT_AT if side == "right" else IN_AT)
    sign = _SIDES[side]
    own, against = lane_runs(network)[route.lane_ids[0]].line, oncoming_line(network, route)
    for turn, onto, along in (
        (Maneuver.RIGHT_TURN if side == "right" else Maneuver.LEFT_TURN, own, 1.0),
        (Maneuver.LEFT_TURN if side == "right" else Maneuver.RIGHT_TURN, against, -1.0),
    ):
        if onto is None:
            continue
        x, y = route.line.point_at(at)
        level = onto.project(x, y)[0]
        aside = route.line.project(*onto.point_at(level))[1]
        radius = RADIUS if (along > 0.0) is (side == "right") else OVER_RADIUS
        arc = _arc(at + along * radius, aside, radius, -along, sign)[::-1]
        out = _seen(route, [(at, sign * (edge + depth)), *arc])
        joins = onto.project(*out[-1])[0]
        line = Polyline.join(Polyline(out), onto.between(joins + 1.0, min(joins + _BEYOND, onto.length)))
        line = line.resampled(1.0)
        entry = depth - 0.5
        if (met := _meets(line, route, entry)) is not None:
            yield CrossingPath(line=line, turn=turn, from_side=side, entry=entry, meets_at=met[0], ego_meets_at=met[1])


def _meets(line: Polyline, route: Route, entry: float) -> tuple[float, float] | None:
    """Where [m] on a way, and on the ego's route, the two first come near each other."""
    other, own = line.points[int(entry) :], route.line.points
    distance = np.hypot(other[:, None, 0] - own[None, :, 0], other[:, None, 1] - own[None, :, 1])
    near = np.flatnonzero(distance.min(axis=1) < MEETING)
    if not near.size:
        return None
    return float(int(entry) + near[0]), float(distance[near[0]].argmin())


def _arc(begins: float, aside: float, radius: float, along: float, sign: float) -> list[_Point]:
    """An arc out of the ego's way to a side, in metres along that and to its left."""
    turns = np.arange(0.0, 0.5 * math.pi + 0.5 * _STEP, _STEP)
    return [
        (begins + along * radius * math.sin(turned), aside + sign * radius * (1.0 - math.cos(turned)))
        for turned in turns
    ]


def _seen(route: Route, points: list[_Point]) -> list[_Point]:
    """Points along the ego's way and to its left as points of the map, where that way is straight."""
    at = float(np.clip(np.mean([s for s, _ in points]), 0.0, route.line.length))
    (x, y), heading = route.line.point_at(at), route.line.heading_at(at)
    c, s = math.cos(heading), math.sin(heading)
    return [(x + (u - at) * c - v * s, y + (u - at) * s + v * c) for u, v in points]


def _mouth(network: Any, route: Route, side: str) -> tuple[float, float, float, float] | None:
    """Of the driveway at a route's event: from where to where it lies, how far aside its edge is, and its depth [m]."""
    found: tuple[float, tuple[float, float, float, float]] | None = None
    for _, area in furniture_of(network).driveways:
        seen = [route.line.project(x, y)[:2] for x, y, *_ in area.exterior.coords]
        along, aside = [s for s, _ in seen], [_SIDES[side] * t for _, t in seen]
        off = abs(min(along) - route.event_at)
        if min(aside) > 0.0 and off < _FAR and (found is None or off < found[0]):
            found = off, (min(along), max(along), min(aside), max(aside) - min(aside))
    return None if found is None else found[1]
