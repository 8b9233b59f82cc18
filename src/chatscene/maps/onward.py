"""The route of an ego of which only is known where it stands and perhaps by which lanes it goes.

A user's program draws where its ego stands and says with a behavior where it goes; the ego under test, which is to
drive in that one's place, needs a line to follow.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from itertools import accumulate
from typing import Any

from chatscene.errors import MapError
from chatscene.maps.crossings import TURNS
from chatscene.maps.junctions import junction_control
from chatscene.maps.lane_runs import centre_line
from chatscene.maps.routes import place_of
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.scenario import Control, Maneuver, Place

LENGTH = 150.0  # [m] of a route that nothing else ends
SHORTEST = 15.0  # [m], less than which is no route


def route_onward(
    network: Any, map_name: str, start: tuple[float, float], lanes: Sequence[Any] = (), length: float = LENGTH
) -> Route:
    """The route from a place on, by given lanes, then by the straightest ones.

    Args:
        network: Scenic's road network.
        map_name: Goes into the route.
        start: Where it begins [m], map frame.
        lanes: Scenic's lanes by which it goes, in driving order; none for the lane at its start.
        length: At most [m].

    Raises:
        MapError: There is no lane at its start, or the lanes end too soon.
    """
    way = list(lanes) or [network.laneAt(start)]
    if way[0] is None:
        raise MapError(f"the ego stands on no lane, at ({start[0]:.1f}, {start[1]:.1f}), so it has no route")
    line = Polyline.join(*(centre_line(lane) for lane in way)) if len(way) > 1 else centre_line(way[0])
    begin = line.project(*start)[0]
    while line.length - begin < length and (more := _next(way[-1])):
        way += more
        line = Polyline.join(line, *(centre_line(lane) for lane in more))
    end = min(line.length, begin + length)
    line, used = line.between(begin, end), _used(way, begin, end)
    if line.length < SHORTEST:
        raise MapError(f"the ego's lane ends {line.length:.0f} m ahead of it; a route has at least {SHORTEST:.0f} m")
    return _route(map_name, line, used)


def route_through(network: Any, map_name: str, points: Sequence[tuple[float, float]]) -> Route:
    """The route along a line that is given.

    Args:
        network: Scenic's road network.
        map_name: Goes into the route.
        points: The line, in driving order [m], map frame.

    Raises:
        MapError: It is too short.
    """
    line = Polyline(points)
    if line.length < SHORTEST:
        raise MapError(f"the ego's way is {line.length:.0f} m long; a route has at least {SHORTEST:.0f} m")
    found = [lane for point in line.resampled(1.0).points.tolist() if (lane := network.laneAt(point)) is not None]
    return _route(map_name, line, list(dict.fromkeys(found or [_nearest(network, line.point_at(0.0))])))


def _nearest(network: Any, point: tuple[float, float]) -> Any:
    """The lane nearest to a point that lies on none, as in a car park."""
    return min(network.lanes, key=lambda lane: (lane.distanceTo(point), lane.uid))


def _route(map_name: str, line: Polyline, lanes: list[Any]) -> Route:
    maneuver, turn, event = _first_turn(lanes, line)
    ends = (*line.point_at(0.0), *line.point_at(line.length))
    return Route(
        id=f"onward-{hashlib.blake2b(repr((map_name, ends)).encode(), digest_size=6).hexdigest()}",
        map_name=map_name,
        maneuver=Maneuver.STRAIGHT if turn is None else TURNS[turn.type.name],
        place=Place.ROAD if maneuver is None else place_of(maneuver.intersection),
        control=Control.NONE if maneuver is None else junction_control(maneuver.intersection),
        line=line.resampled(1.0),
        lane_ids=tuple(lane.uid for lane in lanes),
        event_at=event,
        junction=None if maneuver is None else str(maneuver.intersection.uid),
    )


def _next(lane: Any) -> list[Any]:
    """The lanes that lead on from one, straight on if they can."""
    if not lane.maneuvers:
        return []
    maneuver = min(lane.maneuvers, key=lambda m: (m.type.name != "STRAIGHT", str(m.endLane.uid)))
    return [part for part in (maneuver.connectingLane, maneuver.endLane) if part is not None]


def _used(way: list[Any], begin: float, end: float) -> list[Any]:
    """The lanes of a way that lie between two arc lengths on it [m]."""
    ends = list(accumulate(centre_line(lane).length for lane in way))
    return [lane for lane, start, stop in zip(way, (0.0, *ends), ends, strict=False) if start < end and stop > begin]


def _first_turn(lanes: list[Any], line: Polyline) -> tuple[Any, Any, float]:
    """The first junction on a way, as the manoeuvre through it; it again if it turns; where it begins [m]."""
    for lane in lanes:
        through = [m for m in lane.maneuvers if m.connectingLane in lanes and m.intersection is not None]
        if through:  # within a junction lanes lie over one another, and a line is on several
            maneuver = next((m for m in through if m.endLane in lanes), through[0])
            event = line.project(*centre_line(maneuver.connectingLane).point_at(0.0))[0]
            turn = maneuver if maneuver.type.name in TURNS else None
            return maneuver, turn, max(event, 0.0)
    return None, None, line.length / 2
