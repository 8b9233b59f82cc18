"""Which road is laid to order for a situation, where no packaged map has all that was said of it."""

from __future__ import annotations

import math
from collections.abc import Iterator

from chatscene.build.arms import diameter, meets, signs, turn_lane
from chatscene.build.coming import further, wanted_by
from chatscene.build.fitting import abreast
from chatscene.build.holding import NARROW
from chatscene.build.over_lanes import lanes_needed
from chatscene.build.place import (
    AT_CROSSWALKS,
    NEXT_LANE,
    at_junction,
    at_roundabout,
    ending_lane,
    in_bus_lane,
    in_cycle_lane,
    leaves_by_ramp,
    rides_at_edge,
    shares_driveway,
    turns_in,
)
from chatscene.errors import MapError
from chatscene.maps.limits import KMH
from chatscene.maps.road_spec import LENGTH, LONGEST, MOUTH, Along, Bend, LaidRoad, Ramp, Sides
from chatscene.terms.amount import Speed
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import (
    EgoRoute,
    Feature,
    RoadKind,
    Setting,
    Side,
    Where,
)

MEDIAN, MOTORWAY_MEDIAN = 3.0, 4.0  # [m]
PASSABLE = 2.6  # [m], each of two lanes in which cars pass each other at a creep
HARD_SHOULDER = 3.0  # [m]
WIDE = 8.0  # [m] of a driveway in which somebody waits while another turns in
BENDS_AT = 2.5  # [m/s²] across, that a bend takes whose radius was not said
OUTSIDE_TOWN = 60 * KMH  # [m/s], from which on a road of which no setting was said lies outside a town
RAMPS_LONG = 1500  # [m] of a motorway with a ramp in its middle
_UNLAID_KINDS = frozenset((RoadKind.PARKING_LOT, RoadKind.RAIL_CROSSING))
_OF_SETTING = {Setting.TOWN: Along.TOWN, Setting.RESIDENTIAL: Along.RESIDENTIAL, Setting.RURAL: Along.RURAL}
_BESIDE_TOWN = frozenset((Feature.PARKED_CARS, Feature.PARKED_BOTH_SIDES, Feature.PARKING_PLACES, Feature.BUS_STOP))
_BENDS = {RoadKind.CURVE: True, RoadKind.LEFT_CURVE: True, RoadKind.RIGHT_CURVE: False}
_OVER = {EgoRoute.LANE_CHANGE_LEFT, EgoRoute.LANE_CHANGE_RIGHT, EgoRoute.LANE_CHANGE}


def roads_for(situation: Situation) -> Iterator[LaidRoad]:
    """The roads that have all that was said of it, as far as roads are laid, best first.

    An ego that rides in no lane for bicycles, since others are beside it, rides beside one.

    Args:
        situation: What was said, as it is built.
    """
    for rides in (True, False) if in_cycle_lane(situation) else (False,):
        if (road := _road_for(situation, rides=rides)) is not None:
            yield road


def _road_for(situation: Situation, *, rides: bool) -> LaidRoad | None:
    road, others = situation.road, situation.others
    places = {one.starts.where for one in others}
    ramps = [*_ramps(situation)]
    if road.kind in _UNLAID_KINDS or len(ramps) > 1:
        return None
    ramp = next(iter(ramps), None)
    ahead = _ahead(situation)
    own = situation.road.lanes is None and (rides or in_bus_lane(situation))  # which is one that others need not have
    ahead = max(1, ahead - own)
    back = _back(situation, ahead)
    along = Along.MOTORWAY if ramp is not None else _along(situation)
    has = {*road.has}
    narrow = Feature.NARROW in has and ahead == 1
    ring = ahead if at_roundabout(situation) else 0
    junction = meets(situation) if ring or at_junction(situation) else None
    ends = ending_lane(situation) if junction is None else None
    ends = ends if ramp is None else None  # else it is that of the ramp
    drop = ends is not None or (junction is None and ramp is None and situation.ego.route is EgoRoute.MERGE)
    bay = junction is None and not drop and (Feature.BUS_BAY in has or Where.BUS_BAY in places)
    divided = bool(back) and (_is_divided(situation) or along is Along.MOTORWAY or ends is Side.LEFT)
    try:
        return LaidRoad(
            ahead=ahead + (Feature.BUS_LANE in has) + rides,
            back=back,
            lane=(PASSABLE if back else NARROW) if narrow else 3.5,
            along=along,
            speed=_speed(situation),
            median=(MOTORWAY_MEDIAN if along is Along.MOTORWAY else MEDIAN) if divided else 0.0,
            shoulder=HARD_SHOULDER if Feature.SHOULDER in has and along is not Along.MOTORWAY else 0.0,
            parking=None if drop or bay else _parking(has),
            cycle_lane=Feature.CYCLE_LANE in has,
            ridden=rides,
            tram=Feature.TRAM_TRACK in has,
            bus_lane=Feature.BUS_LANE in has,
            bend=_bend(situation) if road.kind in _BENDS and junction is None else None,
            crosswalk=not drop and (Feature.CROSSWALK in has or bool(places & AT_CROSSWALKS)),
            bus_bay=bay,
            driveway=(driveway := _driveway(situation) if junction is None and not drop else None),
            mouth=WIDE if driveway is not None and shares_driveway(situation) else MOUTH,
            drop=drop and ends is not Side.LEFT,
            drop_left=ends is Side.LEFT,
            ramp=ramp,
            junction=junction,
            side=max(1, ring),
            ring=ring,
            diameter=diameter(situation) if ring else 0.0,
            turn_lane=turn_lane(situation) if junction is not None else None,
            signs=signs(situation) if junction is not None and not ring else None,
            length=max(_length(situation, junction=junction is not None), RAMPS_LONG if ramp is not None else 0),
        )
    except MapError:  # what was said of it does not go together
        return None


def _ramps(situation: Situation) -> Iterator[Ramp]:
    """Which ramps the road has, since they were said, or somebody comes from one or leaves by one."""
    road, route, others = situation.road, situation.ego.route, situation.others
    by_ramp = route is EgoRoute.MERGE and (road.kind is RoadKind.MOTORWAY or Feature.LANE_DROP not in road.has)
    places = {one.starts.where for one in others}
    if by_ramp or Feature.ON_RAMP in road.has or Where.ON_RAMP in places or road.kind is RoadKind.RAMP:
        yield Ramp.ON
    leaves = any(leaves_by_ramp(situation, one) for one in others)
    if route is EgoRoute.EXIT or Feature.OFF_RAMP in road.has or Where.OFF_RAMP in places or leaves:
        yield Ramp.OFF


def _ahead(situation: Situation) -> int:
    """Lanes the ego's way: as many as were said, else as many as there must be for all."""
    road = situation.road
    if road.lanes is not None:
        return max(1, road.lanes)
    sides = {
        one.starts.side or Side.RIGHT
        for one in situation.others
        if one.starts.where in NEXT_LANE and not rides_at_edge(one, situation.ego.route)
    }
    left, right = lanes_needed(situation, {})
    beside = Feature.LANE_DROP in road.has or situation.ego.route in {*_OVER, EgoRoute.MERGE}
    wide = road.kind is RoadKind.MOTORWAY or (_is_divided(situation) and not at_junction(situation))
    two = beside or wide or abreast(situation) or road.ego_lane == -1
    return max(1 + len(sides), 1 + left + right, abs(road.ego_lane or 1), 2 if two else 1)


def _back(situation: Situation, ahead: int) -> int:
    """Lanes the other way: as many, but where the road is one-way or there is room for one car only."""
    road, places = situation.road, {one.starts.where for one in situation.others}
    comes = Where.ONCOMING in places
    if at_junction(situation) or at_roundabout(situation):
        return ahead
    if road.two_way is False and not comes and road.kind is not RoadKind.MOTORWAY and not _is_divided(situation):
        return 0
    if Feature.NARROW in road.has and not comes and road.two_way is None:
        return 0
    return ahead


def _is_divided(situation: Situation) -> bool:
    """Whether something lies between the two directions."""
    told = Feature.MEDIAN in situation.road.has or any(one.starts.where is Where.MEDIAN for one in situation.others)
    comes = any(one.starts.where is Where.ONCOMING for one in situation.others)
    return told or (situation.road.two_way is False and comes)


def _along(situation: Situation) -> Along:
    """What lies about the road: as was said, else what goes with how fast one drives there."""
    road = situation.road
    if road.kind is RoadKind.MOTORWAY:
        return Along.MOTORWAY
    if road.setting is not None:
        return _OF_SETTING[road.setting]
    said = max((one.most for one in (situation.ego.speed, road.speed_limit) if one is not None), default=0.0)
    walks = any(one.starts.where in AT_CROSSWALKS for one in situation.others)
    return Along.RURAL if said > OUTSIDE_TOWN and not walks and not _BESIDE_TOWN & {*road.has} else Along.TOWN


def _speed(situation: Situation) -> int | None:
    """The speed allowed [km/h] that was said; None for what is usual there."""
    limit: Speed | None = situation.road.speed_limit
    if limit is None or limit.than_ego:
        return None
    return min(max(5, round(limit.most / KMH)), 130)


def _parking(has: set[Feature]) -> Sides | None:
    if Feature.PARKED_BOTH_SIDES in has or Feature.PARKING_PLACES in has:
        return Sides.BOTH
    return Sides.RIGHT if Feature.PARKED_CARS in has else None


def _bend(situation: Situation) -> Bend:
    """The bend: with the radius that was said, else as flat as its speed asks for."""
    kind, radius = situation.road.kind, situation.road.radius
    usual = max(60.0, math.ceil(wanted_by(situation) ** 2 / BENDS_AT / 10.0) * 10.0)
    return Bend(
        left=_BENDS.get(kind, True) if kind is not None else True,
        radius=usual if radius is None else radius.near(usual),
    )


def _driveway(situation: Situation) -> Sides | None:
    """On which sides driveways lead off the road: where somebody is in one, else where the ego turns off."""
    there = {one.starts.side or Side.RIGHT for one in situation.others if one.starts.where is Where.DRIVEWAY}
    there |= {*turns_in(situation)}
    if situation.ego.route is EgoRoute.ENTER_DRIVEWAY_ACROSS:
        there.add(Side.LEFT)
    if not there and Feature.DRIVEWAY in situation.road.has:
        there = {Side.RIGHT}
    if len(there) > 1:
        return Sides.BOTH
    return next((Sides(str(side)) for side in there), None)


def _length(situation: Situation, *, junction: bool) -> int:
    """How long the road is [m]: as speed and distances ask for, by hundreds."""
    speed = wanted_by(situation)
    far = max((one.starts.distance.least for one in situation.others if one.starts.distance is not None), default=0.0)
    metres = LENGTH * max(1.0, 0.6 * further(speed)) + 5.0 * far
    return min(LONGEST, math.ceil(metres * (1.5 if junction else 1.0) / 100.0) * 100)
