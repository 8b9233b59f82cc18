"""What of the road is as it was said, on a route that was found."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any

from chatscene.build.place import (
    AT_CROSSWALKS,
    DROPS,
    Found,
    at_junction,
    at_roundabout,
    at_signed_driveway,
    beside_ramp,
)
from chatscene.maps.limits import is_called
from chatscene.maps.road_spec import Along, LaidRoad
from chatscene.maps.settings import is_two_way, lies_in
from chatscene.maps.sites import AT_JUNCTIONS
from chatscene.terms.amount import Speed
from chatscene.terms.route import Equipment
from chatscene.terms.routing import CONTROLS, PLACES, SHAPES, SIDES
from chatscene.terms.scenario import Site
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import ARMS_OF, ROUNDABOUTS, EgoRoute, Feature, RightOfWay, RoadKind

NARROW = 3.2  # [m], up to which two cars do not pass each other in a lane
ROUNDED = 0.3  # [m/s], by which limits are rounded
SITES = {
    Feature.CROSSWALK: Site.CROSSWALK,
    Feature.PARKING_PLACES: Site.PARKING,
    Feature.BUS_BAY: Site.BUS_BAY,
    Feature.OFF_RAMP: Site.PAST_OFF_RAMP,
    Feature.ON_RAMP: Site.PAST_ON_RAMP,
    Feature.DRIVEWAY: Site.DRIVEWAY,
}
EQUIPMENT = {
    Feature.CROSSWALK: Equipment.CROSSWALKS,
    Feature.CYCLE_LANE: Equipment.CYCLE_LANE,
    Feature.TRAM_TRACK: Equipment.TRAM_TRACK,
    Feature.BUS_LANE: Equipment.BUS_LANE,
}
"""What a map is asked for besides, by what the road was said to have."""
_AT_PLACE = EQUIPMENT | {Feature.PARKING_PLACES: Equipment.BAYS}
_AT_SITE: dict[Feature, frozenset[Site]] = {
    **{one: frozenset((site,)) for one, site in SITES.items()},
    Feature.DRIVEWAY: frozenset((Site.DRIVEWAY, Site.DRIVEWAY_LEFT)),
    Feature.LANE_DROP: frozenset((Site.LANE_DROP, *DROPS.values(), Site.ON_RAMP, Site.PAST_ON_RAMP)),  # whose lane ends
    Feature.ON_RAMP: frozenset((Site.ON_RAMP, Site.PAST_ON_RAMP, Site.WEAVING)),
    Feature.OFF_RAMP: frozenset((Site.OFF_RAMP, Site.PAST_OFF_RAMP, Site.WEAVING)),
}
"""Where the road has what was said of it."""
_MOTORWAYS = (Site.MOTORWAY, *(one for one in AT_JUNCTIONS if one is not Site.ROUNDABOUT))
_OF_KIND: dict[RoadKind | None, tuple[Site, ...]] = {
    **dict.fromkeys(ROUNDABOUTS, (Site.ROUNDABOUT,)),
    RoadKind.MOTORWAY: _MOTORWAYS,
    RoadKind.RAMP: _MOTORWAYS,
    RoadKind.RAIL_CROSSING: (Site.RAIL_CROSSING,),
}
_SITES_OF: dict[EgoRoute | None, tuple[Site, ...]] = {
    EgoRoute.ROUNDABOUT: (Site.ROUNDABOUT,),
    EgoRoute.MERGE: (Site.ON_RAMP, Site.LANE_DROP),
    EgoRoute.EXIT: (Site.OFF_RAMP,),
}


def equipment_of(situation: Situation) -> Iterator[str]:
    """What the road is to have for what was said of it, if a map has it there."""
    junction = at_junction(situation) or at_roundabout(situation)
    has = {*situation.road.has, *(Feature.CROSSWALK for one in situation.others if one.starts.where in AT_CROSSWALKS)}
    if not junction:
        has.discard(Feature.CROSSWALK)  # which is a site of its own there
    if junction and situation.road.control is RightOfWay.YIELD_SIGN:
        yield Equipment.GIVE_WAY.value
    yield from (EQUIPMENT[one].value for one in Feature if one in has and one in EQUIPMENT)


def as_said(situation: Situation, found: Found) -> Iterator[str]:
    """The paths of facts that hold on the route that was found."""
    road, query = situation.road, found.query
    site = query.get("site")
    network = found.route.network
    first = network.elements[found.route.route.lane_ids[0]]
    holds = {
        "ego.exit": "by_exit" in query,
        "road.arms": road.arms is not None and _has_arms(road.arms, query),
        "road.side_road": road.side_road is not None and query.get("shape") == SIDES[road.side_road],
        "road.diameter": "across" in query,
        "ego.route": situation.ego.route not in _SITES_OF or site in _SITES_OF[situation.ego.route],
        "road.lanes": road.lanes == lanes_there(found),
        "road.ego_lane": query.get("lane", 0) in (road.ego_lane, (road.ego_lane or 0) + beside_ramp(query)),
        "road.kind": _is_kind(road.kind, found),
        "road.control": (road.control in CONTROLS and "control" in query)
        or (road.control is RightOfWay.YIELD_SIGN and (site == Site.ROUNDABOUT or "control" in query))
        or (road.control is RightOfWay.NONE and site == Site.CROSSWALK)
        or (road.control is RightOfWay.PRIORITY and ("control" in query or at_signed_driveway(situation))),
        "road.two_way": road.two_way is is_two_way(first),
        "road.speed_limit": road.speed_limit is not None and _is_limit(road.speed_limit, found),
        "road.radius": found.laid is not None and found.laid.bend is not None and _is_kind(road.kind, found),
        "road.setting": road.setting is not None and lies_in(network, first, road.setting),
    }
    yield from (path for path, right in holds.items() if right)
    yield from (f"road.has.{i}" for i, one in enumerate(road.has) if _is_there(one, found))


def _is_there(feature: Feature, found: Found) -> bool:
    """Whether the road has something where the route leads."""
    laid = found.laid
    if feature is Feature.MEDIAN:
        return bool(found.query.get("divided")) and not (laid is not None and not laid.median)
    if feature is Feature.TRAM_TRACK and found.query.get("site") == Site.RAIL_CROSSING:
        return True
    if laid is not None and _IN_LAID.get(feature, _nothing)(laid):
        return True
    equipped = _AT_PLACE.get(feature) in found.query.get("has", ())
    return equipped or found.query.get("site") in _AT_SITE.get(feature, ())


def _nothing(laid: LaidRoad) -> bool:  # noqa: ARG001
    return False


_IN_LAID: dict[Feature, Callable[[LaidRoad], bool]] = {
    Feature.SHOULDER: lambda laid: laid.shoulder > 0.0 or laid.along is Along.MOTORWAY,
    Feature.NARROW: lambda laid: laid.lane <= NARROW,
    Feature.PARKING_PLACES: lambda laid: laid.parking is not None,
    Feature.CYCLE_LANE: lambda laid: laid.cycle_lane,
    Feature.CROSSWALK: lambda laid: laid.crosswalk,
    Feature.TURN_LANE: lambda laid: laid.turn_lane is not None,
}
"""What a road has all along, or in its middle, if it was laid so."""


def _is_limit(said: Speed, found: Found) -> bool:
    """Whether the speed that is allowed where something happens is that which was said."""
    there = found.route.limits[min(int(found.route.eventAt), len(found.route.limits) - 1)]
    return not said.than_ego and abs(float(there) - said.most) < ROUNDED


def _has_arms(arms: int, query: Mapping[str, Any]) -> bool:
    """Whether a route was asked for whose junction has so many arms."""
    return arms in (query.get("arms"), *(ARMS_OF[kind] for kind in ARMS_OF if PLACES[kind] == query.get("place")))


def lanes_there(found: Found) -> int:
    """How many lanes go the ego's way where its route begins; of a ramp, on the road that it joins."""
    joins = found.query.get("site") == Site.ON_RAMP
    group = found.route.network.elements[found.route.route.lane_ids[-1 if joins else 0]].group
    laid = found.laid  # of which nobody speaks:
    others = laid is not None and (laid.bus_lane or laid.ridden or laid.turn_lane is not None)
    return len(group.lanes) - beside_ramp(found.query) - others


def _is_kind(kind: RoadKind | None, found: Found) -> bool:
    """Whether the route lies on a road of a kind."""
    if kind is RoadKind.ROAD:
        return found.route.route.junction is None
    if kind is RoadKind.MOTORWAY and found.query.get("site") in DROPS.values():
        return is_called(
            found.route.network, found.route.network.elements[found.route.route.lane_ids[0]].road.id, "motorway"
        )
    if kind in SHAPES:
        return found.query.get("shape") == SHAPES[kind]
    if kind in _OF_KIND:
        return found.query.get("site") in _OF_KIND[kind]
    if kind is RoadKind.PARKING_LOT:
        return Equipment.BAYS in found.query.get("has", ())
    return kind in PLACES and "place" in found.query
