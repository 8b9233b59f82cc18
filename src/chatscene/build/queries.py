"""What a map is asked for: queries for the ego's route, the narrower first."""

from __future__ import annotations

from collections.abc import Iterator
from math import ceil
from typing import Any

from chatscene.build.holding import SITES, equipment_of
from chatscene.build.meeting_queries import at_crossing, round_about
from chatscene.build.over_lanes import lanes_needed
from chatscene.build.place import (
    DRIVEWAYS,
    DROPS,
    GOES_OVER,
    NEXT_LANE,
    PACKAGED,
    at_junction,
    at_roundabout,
    beside_lane,
    beside_ramp,
    ending_lane,
    in_bus_lane,
    leaves_by_ramp,
    rides_at_edge,
    turns_in,
)
from chatscene.build.relations import AGAINST
from chatscene.maps.open_road import SHORT_ROAD
from chatscene.maps.road_spec import LaidRoad, Sides, is_laid, road_of
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.backing import BACKWARDS, backs
from chatscene.terms.changing import waits_for_another
from chatscene.terms.route import Beside, Equipment
from chatscene.terms.routing import BEGINS, ENDS, MANEUVERS, PLACES
from chatscene.terms.scenario import Maneuver, Place, Site
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import Act, EgoRoute, Feature, Heads, RoadKind, Setting, Side, Where, acts_of

IN_BEND = 0.29  # of its radius: so much of a bend before and beyond the middle of a route turns by 33°
BEYOND_BEND = 0.8  # of its radius: so far on a route turns that ends just beyond a bend
_CURVES = (RoadKind.CURVE, RoadKind.LEFT_CURVE, RoadKind.RIGHT_CURVE)


def queries_for(situation: Situation, sides: dict[str, Side]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Each map with what it is asked for: all of them for a site that was said, before any for a place without it."""
    maps = (situation.map,) if situation.map else PACKAGED
    if situation.road.setting is Setting.RURAL:
        maps = (*maps[1:], *maps[:1])  # the town last, which has no such road
    counted = [_counting_the_ramps(query) for query in _queries(situation, sides)]
    if situation.map is not None and is_laid(situation.map):
        laid = road_of(situation.map)
        counted = [_on_laid(situation, laid, query) for query in counted]
    for queries in _freer(situation, counted):
        yield from ((name, query) for query in queries if "site" in query for name in maps)
        yield from ((name, query) for name in maps for query in queries if "site" not in query)


def _on_laid(situation: Situation, laid: LaidRoad, query: dict[str, Any]) -> dict[str, Any]:
    """The same query as a road that was laid answers it: on enough of its bend, and not counting its bus lane."""
    asked = dict(query)
    if laid.median:
        asked["divided"] = True
    if asked.get("opposite") and (laid.median or asked.get("lane", laid.ahead) < laid.ahead):
        asked.pop("opposite")  # who comes the other way does so beyond what lies between
        asked.pop("beside") if asked.get("beside") == "none" else None
    straight = asked["maneuver"] == Maneuver.STRAIGHT
    innermost = laid.median and laid.ahead > 1 and situation.road.ego_lane is None
    if straight and innermost and any(map(_comes_over_median, situation.others)):
        asked |= {"lanes": laid.ahead, "lane": laid.ahead}
        asked.pop("beside") if asked.get("beside") == "none" else None
    if laid.drops and straight and "lane" not in asked:  # beside that which ends
        asked |= {"lanes": max(2, asked.get("lanes", 1)), "lane": 2 if laid.drop else -2}
        asked.pop("beside") if asked.get("beside") == "none" else None
    if laid.bend is not None and "approach" not in asked:
        share = IN_BEND if straight else BEYOND_BEND
        asked["approach"] = max(SHORT_ROAD / 2, ceil(share * laid.bend.radius))
    if laid.turn_lane is not None:  # which is none of those that were counted
        asked |= {name: asked[name] + 1 for name in ("most", "lanes") if name in asked}
        asked.pop("beside") if asked.get("beside") == "none" else None
        if not straight:
            asked.pop("lane", None)
        elif laid.turn_lane is Sides.RIGHT and asked.get("lane", 0) > 0:
            asked["lane"] += 1
    if laid.bus_lane or laid.ridden:  # the outermost, which is none of those that were counted
        beside = not (laid.ridden or in_bus_lane(situation))
        more = int(beside or situation.road.lanes is not None)  # else the ego's own is it
        asked |= {name: asked[name] + more for name in ("most", "lanes") if name in asked}
        lane = asked.get("lane", 1)
        asked |= {"lanes": max(2, asked.get("lanes", 2)), "lane": lane + (beside and lane > 0)}
        asked.pop("beside", None) if asked.get("beside") == "none" else None
    return asked


def _comes_over_median(one: Other) -> bool:
    """Whether somebody comes onto the ego's side of a road from between the two, or from beyond that."""
    over = acts_of(Heads.TURNS, Heads.ROUND, Heads.BACK, Heads.ACROSS, Heads.IN)
    from_beyond = one.starts.where is Where.ONCOMING and any(deed.act in over for deed in one.does)
    return one.starts.where is Where.MEDIAN or from_beyond


def _freer(situation: Situation, queries: list[dict[str, Any]]) -> Iterator[list[dict[str, Any]]]:
    """The same queries with what the road has and the setting that was said, then without the one or the other.

    On roads that need no median last of all.
    """
    setting, has = situation.road.setting, tuple(dict.fromkeys(equipment_of(situation)))
    if has:
        equipped = [query | {"has": (*query.get("has", ()), *has)} for query in queries]
        yield from _in_setting(setting, equipped)
    yield from _in_setting(setting, queries)
    if any("divided" in query for query in queries):
        yield [{name: value for name, value in query.items() if name != "divided"} for query in queries]


def _in_setting(setting: Setting | None, queries: list[dict[str, Any]]) -> Iterator[list[dict[str, Any]]]:
    """The same queries in a setting, then in any."""
    if setting is not None:
        yield [query | ({} if query.get("site") == Site.RURAL else {"setting": setting.value}) for query in queries]
    yield queries


def _counting_the_ramps(query: dict[str, Any]) -> dict[str, Any]:
    """The same query; past a ramp the map counts the ramp's lane, too, which nobody does who tells of the road."""
    more = beside_ramp(query)
    return query | {name: query[name] + more for name in ("lanes", "most", "lane") if query.get(name, 0) > 0}


def _queries(situation: Situation, sides: dict[str, Side]) -> Iterator[dict[str, Any]]:
    """Arguments of `selectRoute`, the narrower first where a map cannot be asked for all that is needed."""
    road, others = situation.road, situation.others
    base: dict[str, Any] = {"maneuver": MANEUVERS[situation.ego.route].value}
    lanes = [
        str(one.starts.side or sides[one.id])
        for one in others
        if one.starts.where in NEXT_LANE and not rides_at_edge(one, situation.ego.route)
    ]
    if beside := _beside(situation):
        base, lanes = base | beside, []  # beside the ego is its own lane, if it is in none
    exactly = {} if road.lanes is None else {"most": road.lanes}
    if road.lanes is not None:
        base["lanes"] = road.lanes
    if road.ego_lane is not None:
        base["lane"] = road.ego_lane
        if road.ego_lane < 0:  # of several
            base["lanes"] = max(2, -road.ego_lane, road.lanes or 2)
    if road.two_way is not None and not at_junction(situation):
        base |= {"opposite": road.two_way} | ({} if road.two_way else {"divided": True})
    base |= _divided(situation)
    base |= _many_lanes(situation, sides)
    over: list[str] = []
    against = any(one.starts.where in AGAINST for one in others)  # for whom that lane is
    if not (against or lanes or beside_lane(situation) or road.lanes == 1):
        over = [str(side) for one in others if (side := _goes_over(one)) is not None]
        over = [*dict.fromkeys(_lanes_of_ego(situation)), *over]
    places = [*(base | only for only in _sites(situation, sides)), base | _only_there(situation)]
    for here in (*(place | exactly for place in places), *(places if road.lanes not in (None, 1) else ())):
        if over:
            yield from _on_road(situation, sides, here, over)
        yield from _on_road(situation, sides, here, lanes)  # who goes over then goes where others come


def _only_there(situation: Situation) -> dict[str, Any]:
    """What a map must have for the kind of road, or for where somebody is, without which there is nothing to show."""
    bay = any(one.starts.where is Where.BUS_BAY for one in situation.others) and not at_junction(situation)
    if situation.road.kind is RoadKind.PARKING_LOT:
        return {"has": (Equipment.BAYS.value,)}
    if situation.road.kind is RoadKind.RAIL_CROSSING:
        return {"site": Site.RAIL_CROSSING.value}
    return {"site": Site.BUS_BAY.value} if bay else {}


def _sites(situation: Situation, sides: dict[str, Side]) -> Iterator[dict[str, Any]]:
    """What a map is asked for first, by what the road was said to have, if nothing else must be there."""
    if at_junction(situation) or _only_there(situation):
        return
    out = (one for one in situation.others if one.starts.where is Where.DRIVEWAY)
    yield from ({"site": DRIVEWAYS[one.starts.side or sides.get(one.id, Side.RIGHT)].value} for one in out)
    yield from ({"site": DRIVEWAYS[side].value} for side in turns_in(situation))
    if situation.ego.route is EgoRoute.ENTER_DRIVEWAY_ACROSS:
        yield {"site": Site.DRIVEWAY_LEFT.value}
    if (side := ending_lane(situation)) is not None and situation.ego.route is not EgoRoute.MERGE:
        over = situation.ego.route in (EgoRoute.LANE_CHANGE_LEFT, EgoRoute.LANE_CHANGE_RIGHT)
        yield {"site": (Site.LANE_DROP if over else DROPS[side]).value}
    at_crosswalk = (one.starts.where is Where.CROSSING for one in situation.others)
    has = [*situation.road.has, *(Feature.CROSSWALK for marked in at_crosswalk if marked)]
    yield from ({"site": SITES[one].value} for one in dict.fromkeys(has) if one in SITES)


def _many_lanes(situation: Situation, sides: dict[str, Side]) -> dict[str, Any]:
    """How many lanes there must be for those who change several of them, and in which the ego is then."""
    left, right = lanes_needed(situation, sides)
    straight = situation.ego.route in (None, EgoRoute.STRAIGHT)
    by_ramp = any(leaves_by_ramp(situation, one) for one in situation.others)  # whose lane is one of them
    if left + right < 2 or by_ramp or not straight or at_junction(situation) or at_roundabout(situation):
        return {}
    lane = {} if situation.road.ego_lane is not None else {"lane": 1 + right}
    return {"lanes": max(1 + left + right, situation.road.lanes or 0), **lane}


def _beside(situation: Situation) -> dict[str, Any]:
    """How the ego's way begins or ends that does not do so along its lane."""
    route = situation.ego.route
    edges = {"begins": BACKWARDS if backs(situation) else BEGINS, "ends": ENDS}
    return {name: rows[route].value for name, rows in edges.items() if route in rows}


_GOES_OVER = {
    Heads.OUT: frozenset((Where.AHEAD,)),
    Heads.OVER: frozenset((Where.AHEAD, Where.BEHIND)),
    Heads.BY: frozenset((Where.BEHIND,)),
}


def _divided(situation: Situation) -> dict[str, Any]:
    """That something lies between the directions, and in which lane the ego is beside which somebody comes along it."""
    road = situation.road
    if Feature.MEDIAN not in road.has:
        return {}
    free = road.ego_lane is None and not at_junction(situation)
    innermost = {"lane": -1, "lanes": max(2, road.lanes or 2)}
    return {"divided": True} | (innermost if free and any(map(_by_divider, situation.others)) else {})


def _by_divider(one: Other) -> bool:
    """Whether somebody comes the wrong way along what divides the directions, where the innermost lane is the ego's."""
    lateral, where = one.starts.lateral, one.starts.where
    return where is Where.ONCOMING_IN_OUR_LANE and lateral is not None and lateral.side is Side.LEFT


def _lanes_of_ego(situation: Situation) -> Iterator[str]:
    """On which sides of its lane the ego is once it has changed lanes because of what another did."""
    changes = [deed for deed in situation.ego.does if deed.act is Act.LANE_CHANGE]
    left = 0
    for deed in changes if any(map(waits_for_another, changes)) else ():
        left += -1 if deed.to is Side.RIGHT else 1
        if left:
            yield str(Side.LEFT if left > 0 else Side.RIGHT)


def _goes_over(one: Other) -> Side | None:
    """On which side of the ego's lane there must be one of its direction, since somebody goes over there."""
    sides = (deed.to or Side.LEFT for deed in one.does if one.starts.where in _GOES_OVER.get(deed.act.row.heads, ()))
    return next(sides, None) if one.kind.moves is not Moves.LIES else None


def _on_road(
    situation: Situation, sides: dict[str, Side], base: dict[str, Any], lanes: list[str]
) -> Iterator[dict[str, Any]]:
    """Queries for the kind of road."""
    road, route, others = situation.road, situation.ego.route, situation.others
    if at_junction(situation):
        yield from at_crossing(situation, sides, base, lanes)
    elif at_roundabout(situation):
        yield from round_about(situation, base | ({"beside": lanes[0]} if lanes else {}))
    elif any(one.starts.where is Where.ON_RAMP for one in others):
        yield base | {"site": Site.PAST_ON_RAMP.value, "beside": "right"}
    elif any(leaves_by_ramp(situation, one) for one in others):  # in the lane beside that which leads there
        left = any(side != Side.RIGHT for side in lanes)
        against = any(one.starts.where in AGAINST for one in others)
        beside = {"beside": str(Side.LEFT)} if left else {}
        yield base | {"site": Site.PAST_OFF_RAMP.value} | beside | ({"opposite": True} if against else {})
    elif route is EgoRoute.EXIT:
        yield base | {"site": Site.OFF_RAMP.value}
    elif route is EgoRoute.MERGE and Feature.LANE_DROP in road.has and not _by_a_ramp(situation):
        yield base | {"site": Site.LANE_DROP.value, "lanes": max(2, road.lanes or 2)}
    elif route is EgoRoute.MERGE or road.kind is RoadKind.RAMP:
        yield base | {"site": Site.ON_RAMP.value} | ({"lanes": max(2, road.lanes or 2)} if lanes else {})
    elif road.kind is RoadKind.MOTORWAY:
        yield from _along(situation, base | {"site": base.get("site", Site.MOTORWAY.value)}, lanes)
    else:
        if road.setting is Setting.RURAL and "site" not in base and not lanes:
            yield from _along(situation, base | {"site": Site.RURAL.value}, lanes)
        yield from _along(situation, base, lanes)


def _by_a_ramp(situation: Situation) -> bool:
    """Whether an ego merges from a ramp, whose lane ends, and not out of a lane of the road itself."""
    return Feature.ON_RAMP in situation.road.has or situation.road.kind in (RoadKind.MOTORWAY, RoadKind.RAMP)


def _along(situation: Situation, base: dict[str, Any], lanes: list[str]) -> Iterator[dict[str, Any]]:
    """Queries for a way between junctions."""
    road, others = situation.road, situation.others
    straight = base["maneuver"] == Maneuver.STRAIGHT
    query = base | _place_along(road.kind, base, straight=straight)
    places = {one.starts.where for one in others}
    wrong_way = Where.ONCOMING_IN_OUR_LANE in places
    against = Where.ONCOMING in places or (wrong_way and query.get("opposite", True))
    against = against or any(_turns_round(one) for one in others)
    against = against and query.get("ends") != Beside.BACK  # who turns round has them anyway, some lanes away
    if query["maneuver"] == Maneuver.BYPASS:
        several = (road.lanes or 1) > 1 or (bool(lanes) and not against) or road.kind is RoadKind.MOTORWAY
        query |= {"lanes": max(2, road.lanes or 2), "opposite": False} if several else {"opposite": True}
    elif lanes:
        query |= {"beside": lanes[0]} if straight else _lanes_to_change(situation, lanes)
        if against:
            query["opposite"] = True
        if len(set(lanes)) > 1:
            query["lanes"] = max(3, road.lanes or 3)
    elif against:
        query |= {"opposite": True} | ({"beside": "none"} if straight and road.lanes in (None, 1) else {})
    elif straight and road.lanes in (None, 1) and any(_at_kerb(one) for one in others):
        yield query | {"beside": "none"}  # the outermost lane, or there is no kerb beside it
    yield query
    if wrong_way and Where.ONCOMING not in places:  # who needs no lane of its own
        yield {name: value for name, value in query.items() if name != "opposite"}
        beside = {} if not lanes else {"beside": lanes[0]} if straight else _lanes_to_change(situation, lanes)
        yield base | beside


def _place_along(kind: RoadKind | None, base: dict[str, Any], *, straight: bool) -> dict[str, Any]:
    """What is asked for of the road's shape: who swings out or changes lanes does so just after its bend."""
    if kind is not None and kind in _CURVES:
        past = {"site": Site.PAST_BEND.value} if not straight and "site" not in base else {}
        return past | ({"place": PLACES[kind].value} if straight or past else {})
    return {"place": PLACES.get(kind or RoadKind.ROAD, Place.ROAD).value} if straight and "site" not in base else {}


def _lanes_to_change(situation: Situation, taken: list[str]) -> dict[str, Any]:
    """How many lanes a road must have on which the ego changes lanes, with others in those next to it."""
    road, route = situation.road, situation.ego.route
    to = GOES_OVER.get(route) if route is not None else None
    if to is None or set(taken) <= {str(to)}:
        return {"lanes": max(2, road.lanes or 2)}
    return {"lanes": max(3, road.lanes or 3), "lane": road.ego_lane or 2}  # with a lane on either side


def _turns_round(one: Other) -> bool:
    """Whether somebody turns round into the lane beside the ego's."""
    there = one.starts.where in (Where.AHEAD, Where.BEHIND, Where.KERB)
    return there and any(deed.act is Act.U_TURN for deed in one.does)


def _at_kerb(one: Other) -> bool:
    return one.starts.where in (Where.KERB, Where.ROADSIDE, Where.DRIVEWAY, Where.CROSSING, Where.BUS_BAY)
