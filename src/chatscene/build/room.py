"""How much road leads up to what happens: as far as a route usually does, farther for a fast ego or who is far away."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from typing import Any

from chatscene.build.coming import further
from chatscene.maps.routes import APPROACHES, BLOCKER_AT, CHANGE_AT, OPEN_ROAD
from chatscene.maps.sites import AT_JUNCTIONS, ENTRIES, PAST
from chatscene.terms.scenario import Maneuver, Place, Site
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import Where
from chatscene.world.places import EgoRoute as Route
from chatscene.world.places import lanesBeside, neighbourPath, ownLane

_MORE = 1.15  # by which routes that are looked for get shorter, the longest first
_ROOM_BEYOND = 10.0  # [m] of road beyond somebody whose distance was said
_BEFORE = frozenset(
    (
        Where.AHEAD,
        Where.AHEAD_BESIDE,
        Where.ROADSIDE,
        Where.KERB,
        Where.DRIVEWAY,
        Where.MEDIAN,
        Where.BUS_BAY,
        Where.ONCOMING_IN_OUR_LANE,
    )
)


def _usual(query: Mapping[str, Any]) -> float:
    """How far [m] a route usually leads up to what happens."""
    site = query.get("site")
    if site == Site.ROUNDABOUT:
        return ENTRIES[0]
    if site in (Site.CROSSWALK, Site.PARKING, Site.BUS_BAY):
        return PAST[0]
    if _through(query):
        return APPROACHES[0]
    if query["maneuver"] == Maneuver.BYPASS:
        return BLOCKER_AT
    return OPEN_ROAD / 2 if query["maneuver"] == Maneuver.STRAIGHT else CHANGE_AT


def _through(query: Mapping[str, Any]) -> bool:
    """Whether a route is asked for that leads through a junction."""
    return query.get("place") in (Place.JUNCTION, Place.THREE_WAY, Place.FOUR_WAY) or "crossed" in query


def longer(query: dict[str, Any], more: float) -> dict[str, Any]:
    """The same query, with so many times as much road as usual."""
    if more <= 1.0 or (query.get("site") in AT_JUNCTIONS and query["site"] != Site.ROUNDABOUT):
        return query
    return query | {"approach": round(more * _usual(query), 1)}


def lengths(situation: Situation) -> Iterator[float]:
    """How many times as much road as usual is looked for: as the ego's speed asks for, then less."""
    more = max(further(situation), *(_far(one) / OPEN_ROAD * 2.5 for one in situation.others), 1.0)
    while more > 1.0:
        yield more
        more /= _MORE
    yield 1.0


def said_distance(one: Other) -> float:
    """How far away [m] somebody was said to be."""
    return one.starts.distance.low if one.starts.distance is not None else 0.0


def _far(one: Other) -> float:
    """How far ahead [m] on the ego's own way somebody was said to be."""
    return said_distance(one) if one.starts.where in _BEFORE else 0.0


def room(route: Route, one: Other) -> float:
    """How far ahead [m] somebody can be on a route at most, in a place that lies ahead."""
    if one.starts.where is Where.ONCOMING and route.route.junction is None:
        if not any(against for _, against in lanesBeside(route)):
            return math.inf  # which the map is asked for elsewhere
        return ownLane(route).project(*neighbourPath(route, "left").point_at(0.0))[0]
    if one.starts.where not in _BEFORE:
        return math.inf
    return route.eventAt if route.route.junction is not None else route.line.length - _ROOM_BEYOND
