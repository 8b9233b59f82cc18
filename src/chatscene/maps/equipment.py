"""Whether the roads of a route have what is asked for: crosswalks at its junction, a cycle lane, rails, bays."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

import shapely

from chatscene.maps.car_parks import car_parks
from chatscene.maps.furniture import Stand, furniture_of
from chatscene.maps.junctions import GIVE_WAY_SIGN
from chatscene.maps.kept import kept
from chatscene.maps.ring_routes import left_at
from chatscene.terms.route import Equipment, Route

NEAR = 10.0  # [m] before or beyond a junction: a crosswalk that is nearer is one of its own


def is_equipped(network: Any, route: Route, has: tuple[Equipment, ...]) -> bool:
    """Whether a route has all of some equipment, and leads through a car park only if it is to have bays.

    Args:
        network: Scenic's road network.
        route: Which.
        has: What is asked for.
    """
    lot = car_parks(network)
    if lot and (_road(network, route) in lot) != (Equipment.BAYS in has):
        return False
    return all(_HAS[one](network, route) for one in has)


def _road(network: Any, route: Route) -> int:
    return network.elements[route.lane_ids[0]].road.id


def _crosswalks(network: Any, route: Route) -> bool:
    if route.junction is None:
        return False
    junctions = dict.fromkeys((network.elements[route.junction], left_at(network, route)))
    near = [
        one
        for junction in junctions
        for one in kept(junction, "crosswalks", lambda junction: _crosswalks_near(network, junction))
    ]
    arms = (_road(network, route), network.elements[route.lane_ids[-1]].road.id)
    before, beyond = ([area for road, area in near if road == arm] for arm in arms)
    if not (before and beyond):
        return False
    line = shapely.LineString(route.line.points)
    return all(any(line.intersects(area) for area in on) for on in (before, beyond))


def _crosswalks_near(network: Any, junction: Any) -> list[tuple[int, shapely.Polygon]]:
    """The crosswalks at a junction, each with the road it lies on."""
    inside = junction.polygons
    return [(road, area) for road, area in furniture_of(network).crosswalks if inside.distance(area) < NEAR]


def _cycle_lane(network: Any, route: Route) -> bool:
    lane = network.elements[route.lane_ids[0]]
    return (lane.road.id, lane.group is lane.road.forwardLanes) in furniture_of(network).cycle_lanes


def _tram_track(network: Any, route: Route) -> bool:
    along = {road for road, _, across in furniture_of(network).tracks if not across}
    if route.junction is None:
        return _road(network, route) in along
    return any(lane.road.id in along for lane in network.elements[route.junction].incomingLanes)


def _bays(network: Any, route: Route) -> bool:
    return _road(network, route) in car_parks(network)


def _gives_way(network: Any, route: Route) -> bool:
    ways = (network.elements[uid] for uid in route.lane_ids)
    return any(signal.type == GIVE_WAY_SIGN for way in ways for signal in way.road.signals)


def _bus_lane(network: Any, route: Route) -> bool:
    lane = network.elements[route.lane_ids[0]]
    return (lane.road.id, lane.group is lane.road.forwardLanes) in furniture_of(network).bus_lanes


def bus_bay(network: Any, route: Route) -> float:
    """How long [m] the bay for buses is that a route leads past, the longest of its road; 0 where there is none."""
    road, standing = _road(network, route), furniture_of(network).standing
    there = (one.end - one.start for one in standing if one.use is Stand.BUS and one.road == road)
    return max(there, default=0.0)


_HAS: Mapping[Equipment, Callable[[Any, Route], bool]] = {
    Equipment.CROSSWALKS: _crosswalks,
    Equipment.CYCLE_LANE: _cycle_lane,
    Equipment.TRAM_TRACK: _tram_track,
    Equipment.BAYS: _bays,
    Equipment.GIVE_WAY: _gives_way,
    Equipment.BUS_LANE: _bus_lane,
}
