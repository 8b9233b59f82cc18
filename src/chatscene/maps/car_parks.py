"""Which roads of a map are the ways of a car park: between bays at a right angle, and those that lead there."""

from __future__ import annotations

from typing import Any

from chatscene.maps.furniture import Stand, furniture_of
from chatscene.maps.kept import kept_with_network
from chatscene.maps.limits import limits_of

DEEP = 4.0  # [m] from which on a strip for parking has bays at a right angle: along the road it is as wide as a car


@kept_with_network()
def car_parks(network: Any) -> frozenset[int]:
    """OpenDRIVE's ids of the roads of a network that are ways of a car park."""
    bays = {(place.road, place.forward) for place in furniture_of(network).standing if _deep(place)}
    aisles = {road for road, _ in bays if {(road, True), (road, False)} <= bays}
    allowed = {road: limit.at(0.0) for road, limit in limits_of(network).items()}
    slow = max((allowed[road] for road in aisles if road in allowed), default=0.0)
    found = set(aisles)
    for junction in network.intersections if aisles else ():
        roads = {lane.road.id for lane in (*junction.incomingLanes, *junction.outgoingLanes)}
        if roads & aisles:
            found |= {road for road in roads if allowed.get(road, float("inf")) <= slow}
    return frozenset(found)


def _deep(place: Any) -> bool:
    return place.use is Stand.PARKING and place.depth >= DEEP
