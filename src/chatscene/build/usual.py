"""How fast a road is driven where nothing was said of it, by what kind of road that is."""

from __future__ import annotations

from chatscene.maps.limits import KMH, MOTORWAY, RURAL, SLOW, TOWN
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import EgoRoute, RoadKind, Setting, Where

RAMP, PARKING_LOT = 60 * KMH, 10 * KMH
"""On a ramp [m/s], and between parking places, where one drives little faster than one walks.

Ramps have bends of 80 to 130 m at most junctions of motorways (RAA 2008, section 6.4.2), which are driven at 50 to 70
km/h.
"""
_OF_KIND: dict[RoadKind | None, float] = {
    RoadKind.MOTORWAY: MOTORWAY,
    RoadKind.RAMP: RAMP,
    RoadKind.PARKING_LOT: PARKING_LOT,
}
_OF_SETTING = {Setting.TOWN: TOWN, Setting.RESIDENTIAL: SLOW, Setting.RURAL: RURAL}
_OF_ROUTE: dict[EgoRoute | None, float] = {EgoRoute.MERGE: RAMP, EgoRoute.EXIT: MOTORWAY}


def speed_of_road(situation: Situation) -> float:
    """What is driven on the ego's road [m/s], by what was said of it; of a road of which nothing was, as in a town."""
    road = situation.road
    if (limit := road.speed_limit) is not None:
        return limit.most
    if road.kind in _OF_KIND:
        return _OF_KIND[road.kind]
    if situation.ego.route in _OF_ROUTE:
        return _OF_ROUTE[situation.ego.route]
    if any(one.starts.where is Where.ON_RAMP for one in situation.others):
        return MOTORWAY
    return _OF_SETTING[road.setting or Setting.TOWN]
