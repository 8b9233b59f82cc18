"""A query for the ego's route, and a route of the map that has all the ways that others need."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from chatscene.build.coming import further
from chatscene.build.fitting import abreast, lacking_for, too_short
from chatscene.build.holding import SITES, as_said, lanes_there
from chatscene.build.ledger import Ledger
from chatscene.build.over_lanes import lanes_needed
from chatscene.build.place import (
    GOES_OVER,
    NEXT_LANE,
    PACKAGED,
    Found,
    arm_of,
    at_junction,
    at_roundabout,
    beside_lane,
    beside_ramp,
    control_of,
    from_left,
    only_others_stop,
    rides_at_edge,
    room_against,
)
from chatscene.build.relations import AGAINST
from chatscene.build.screening import side_hidden
from chatscene.errors import MapError, NotBuilt
from chatscene.maps.network import load_network, resolve_map
from chatscene.maps.routes import APPROACHES, BLOCKER_AT, CHANGE_AT, OPEN_ROAD
from chatscene.maps.sites import APPROACHED, PAST
from chatscene.situations.check import COMES_OVER, TURNS
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.backing import BACKWARDS, backs, turned_about
from chatscene.terms.pace import NOMINAL
from chatscene.terms.route import Beside
from chatscene.terms.routing import BEGINS, CONTROLS, ENDS, MANEUVERS, PLACES
from chatscene.terms.scenario import Control, Maneuver, Place, Site
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import Act, EgoRoute, Feature, RightOfWay, RoadKind, Setting, Side, Where
from chatscene.world.places import EgoRoute as Route
from chatscene.world.places import choose_route, lanesBeside

_CURVES = (RoadKind.CURVE, RoadKind.LEFT_CURVE, RoadKind.RIGHT_CURVE)


def find(ledger: Ledger, speed: float, road: float = 0.0) -> Found:
    """The first query that a map answers with a route on which all ways are that others need.

    Args:
        ledger: What was said.
        speed: What the ego drives at [m/s].
        road: How much road [m] is taken if there is as much.

    Raises:
        NotBuilt: No map has such a place; the message says what each lacks.
    """
    situation = ledger.situation
    if situation.ego.route not in MANEUVERS:
        raise NotBuilt(f"nothing builds yet: ego.route: {situation.ego.route}")
    for one in situation.others:
        if beside_lane(situation) and one.starts.where.row.junction and not from_left(situation, one):
            raise NotBuilt(
                f"nothing builds yet: others.{one.id}.starts.where: {one.starts.where}, where ego.route is"
                f" {situation.ego.route}"
            )
    lacking: list[str] = []
    rooms: dict[str, float] = {}
    for more in _lengths(situation, speed, road):
        lacking.clear()  # what is told is what the shortest road lacks
        for sides in _open_sides(situation):
            for name, query in _asked(situation, sides):
                if found := _answered(situation, speed, name, _longer(query, more), sides, lacking, rooms):
                    _take(ledger, found)
                    far = min(max(1.0, more), further(speed))
                    return replace(found, further=found.route.eventAt / BACKED if backs(situation) else far)
    if rooms:
        raise NotBuilt("; ".join(told.format(most) for told, most in rooms.items()))
    said = "; ".join(dict.fromkeys(lacking))
    raise NotBuilt(f"no map has such a place: {said}")


BACKED = 42.0  # [m] ahead of which others are about, in the middle, who are nearer to an ego that backs
_SLOW = 0.6  # of the usual road, of an ego that is slower than usual
_MORE = 1.15  # by which routes that are looked for get shorter, the longest first
_BEYOND = 2.5  # times as long as the way to somebody is an open road: as much leads on from there, and some is spare
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
    site = Site(query["site"]) if "site" in query else None
    if site is not None and site in APPROACHED:
        return APPROACHED[site]
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


def _longer(query: dict[str, Any], more: float) -> dict[str, Any]:
    """The same query, with so many times as much road as usual."""
    if more == 1.0 or (more < 1.0 and not _through(query)):
        return query
    return query | {"approach": round(more * _usual(query), 1)}


def _lengths(situation: Situation, speed: float, road: float) -> Iterator[float]:
    """How many times as much road as usual is looked for: as the ego's speed asks for, then less."""
    more = max(further(speed), road / OPEN_ROAD, *(_far(one) / OPEN_ROAD * _BEYOND for one in situation.others))
    while more > 1.0:
        yield more
        more /= _MORE
    yield 1.0
    if speed < NOMINAL.speed:  # else who comes to meet a slow ego would have to come from too far
        yield _SLOW


def _said_distance(one: Other) -> float:
    """How far away [m] somebody was said to be."""
    return one.starts.distance.low if one.starts.distance is not None else 0.0


def _far(one: Other) -> float:
    """How far ahead [m] on the ego's own way somebody was said to be."""
    return _said_distance(one) if one.starts.where in _BEFORE else 0.0


def _room(route: Route, one: Other) -> float:
    """How far ahead [m] somebody can be on a route at most, in a place that lies ahead."""
    if one.starts.where is Where.ONCOMING and route.route.junction is None:
        if not any(against for _, against in lanesBeside(route)):
            return math.inf  # which the map is asked for elsewhere
        return room_against(route)
    if one.starts.where not in _BEFORE:
        return math.inf
    return route.eventAt if route.route.junction is not None else route.line.length - _ROOM_BEYOND


def _open_sides(situation: Situation) -> Iterator[dict[str, Side]]:
    """Ways to choose the sides that were left open: where two lanes have one side, all are tried on that first."""
    others = situation.others
    open_ones = [one.id for one in others if one.starts.where.row.sided and one.starts.side is None]
    told = {one.id: side for one in others if (side := side_hidden(situation, one)) is not None}
    told |= {one.id: side for one in others if (side := comes_from(one)) is not None}
    told |= {one.id: Side.LEFT for one in others if from_left(situation, one)}
    told = {name: side for name, side in told.items() if name in open_ones}
    for first in (Side.RIGHT, Side.LEFT) if len(open_ones) > len(told) else (Side.RIGHT,):
        yield dict.fromkeys(open_ones, first) | told


def comes_from(one: Other) -> Side | None:
    """From which side somebody comes of whom the side was said to which it goes."""
    to = next((deed.to for deed in one.does if deed.act in COMES_OVER and deed.to is not None), None)
    return None if to is None else Side.LEFT if to is Side.RIGHT else Side.RIGHT


def _answered(
    situation: Situation,
    speed: float,
    name: str,
    query: dict[str, Any],
    sides: dict[str, Side],
    lacking: list[str],
    rooms: dict[str, float],
) -> Found | None:
    """The first route of a map that answers a query, if all whom it is for can be there.

    Args:
        situation: What was said.
        speed: What the ego drives at [m/s].
        name: The map's name or file.
        query: What it is asked for.
        sides: Those that were chosen.
        lacking: Takes what the map lacks, in words.
        rooms: Takes what is the most that a place has room for, by what is told of it, where more was said.
    """
    path = str(resolve_map(name))
    network = load_network(path)
    try:
        route = choose_route(network, path, 0, **query)
    except MapError as error:
        lacking.append(str(error))
        return None
    beside = backs(situation) and situation.ego.route is not EgoRoute.REVERSE  # along the road, that it backs onto
    for one in () if beside else situation.others:
        if _said_distance(one) > (room := _room(route, one)):
            fact = f"others.{one.id}.starts.distance: {one.starts.distance}: the longest road there is leads {{:.0f}} m"
            rooms[fact] = max(room, rooms.get(fact, 0.0))
            return None
    found = Found(name, query, route, sides)
    if (lacks := lacking_for(situation, found)) is not None:
        lacking.append(f"on map {Path(path).stem!r} {lacks}")
        return None
    for told, most in too_short(situation, found, speed):
        rooms[told] = max(most, rooms.get(told, 0.0))
        return None
    return found


def _asked(situation: Situation, sides: dict[str, Side]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Each map with what it is asked for: all of them for a site that was said, before any for a place without it."""
    maps = (situation.map,) if situation.map else PACKAGED
    if situation.road.setting is Setting.RURAL:
        maps = (*maps[1:], *maps[:1])  # the town last, which has no such road
    for queries in _freer(situation, [_counting_the_ramps(query) for query in _queries(situation, sides)]):
        yield from ((name, query) for query in queries if "site" in query for name in maps)
        yield from ((name, query) for name in maps for query in queries if "site" not in query)


def _freer(situation: Situation, queries: list[dict[str, Any]]) -> Iterator[list[dict[str, Any]]]:
    """The same queries in the setting that was said, then in any, then on roads that need no median."""
    setting = situation.road.setting
    if setting is not None:
        yield [query | ({} if query.get("site") == Site.RURAL else {"setting": setting.value}) for query in queries]
    yield queries
    if any("divided" in query for query in queries):
        yield [{name: value for name, value in query.items() if name != "divided"} for query in queries]


def _counting_the_ramps(query: dict[str, Any]) -> dict[str, Any]:
    """The same query; past a ramp the map counts the ramp's lane, too, which nobody does who tells of the road."""
    more = beside_ramp(query)
    return query | {name: query[name] + more for name in ("lanes", "most", "lane") if name in query}


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
    if road.two_way is not None and not at_junction(situation):
        base |= {"opposite": road.two_way} | ({} if road.two_way else {"divided": True})
    base |= _many_lanes(situation, sides)
    over: list[str] = []
    against = any(one.starts.where in AGAINST for one in others)  # for whom that lane is
    if not (against or lanes or beside_lane(situation) or road.lanes == 1):
        over = [str(side) for one in others if (side := _goes_over(one)) is not None]
    has = [*road.has, *(Feature.CROSSWALK for one in others if one.starts.where is Where.CROSSING)]
    sites = [SITES[one].value for one in dict.fromkeys(has) if one in SITES and not at_junction(situation)]
    if any(one.starts.where is Where.BUS_BAY for one in others) and not at_junction(situation):
        sites = [Site.BUS_BAY.value]
        base = base | {"site": Site.BUS_BAY.value}
    places = [*(base | {"site": site} for site in sites), base]
    for here in (*(place | exactly for place in places), *(places if road.lanes not in (None, 1) else ())):
        if over:
            yield from _on_road(situation, sides, here, over)
        yield from _on_road(situation, sides, here, lanes)  # who goes over then goes where others come


def _many_lanes(situation: Situation, sides: dict[str, Side]) -> dict[str, Any]:
    """How many lanes there must be for those who change several of them, and in which the ego is then."""
    left, right = lanes_needed(situation, sides)
    straight = situation.ego.route in (None, EgoRoute.STRAIGHT)
    if left + right < 2 or not straight or at_junction(situation) or at_roundabout(situation):
        return {}
    lane = {} if situation.road.ego_lane is not None else {"lane": 1 + right}
    return {"lanes": max(1 + left + right, situation.road.lanes or 0), **lane}


def _beside(situation: Situation) -> dict[str, Any]:
    """How the ego's way begins or ends that does not do so along its lane."""
    route = situation.ego.route
    edges = {"begins": BACKWARDS if backs(situation) else BEGINS, "ends": ENDS}
    return {name: rows[route].value for name, rows in edges.items() if route in rows}


_GOES_OVER = {
    Act.CUT_OUT: frozenset((Where.AHEAD,)),
    Act.LANE_CHANGE: frozenset((Where.AHEAD, Where.BEHIND)),
    Act.OVERTAKE: frozenset((Where.BEHIND,)),
}


def _goes_over(one: Other) -> Side | None:
    """On which side of the ego's lane there must be one of its direction, since somebody goes over there."""
    sides = (deed.to or Side.LEFT for deed in one.does if one.starts.where in _GOES_OVER.get(deed.act, ()))
    return next(sides, None) if one.kind.moves is not Moves.LIES else None


def _on_road(
    situation: Situation, sides: dict[str, Side], base: dict[str, Any], lanes: list[str]
) -> Iterator[dict[str, Any]]:
    """Queries for the kind of road."""
    road, route, others = situation.road, situation.ego.route, situation.others
    if at_junction(situation):
        yield from _at_junction(situation, sides, base, lanes)
    elif at_roundabout(situation):
        yield from _round(situation, base | ({"beside": lanes[0]} if lanes else {}))
    elif any(one.starts.where is Where.ON_RAMP for one in others):
        yield base | {"site": Site.PAST_ON_RAMP.value, "beside": "right"}
    elif route is EgoRoute.EXIT:
        yield base | {"site": Site.OFF_RAMP.value}
    elif route is EgoRoute.MERGE or road.kind is RoadKind.RAMP:
        yield base | {"site": Site.ON_RAMP.value} | ({"lanes": max(2, road.lanes or 2)} if lanes else {})
    elif road.kind is RoadKind.MOTORWAY:
        yield from _along(situation, base | {"site": base.get("site", Site.MOTORWAY.value)}, lanes)
    else:
        if road.setting is Setting.RURAL and "site" not in base and not lanes:
            yield from _along(situation, base | {"site": Site.RURAL.value}, lanes)
        yield from _along(situation, base, lanes)


def _at_junction(
    situation: Situation, sides: dict[str, Side], base: dict[str, Any], lanes: list[str]
) -> Iterator[dict[str, Any]]:
    road, others = situation.road, situation.others
    arms = [arm for one in others if (arm := arm_of(situation, one, sides))]
    if any(rides_at_edge(one, situation.ego.route) and one.starts.where in NEXT_LANE for one in others):
        arms.append("oncoming")  # an arm opposite, or there is no straight on
    query = base | {"place": PLACES.get(road.kind or RoadKind.JUNCTION, Place.JUNCTION).value}
    if (control := control_of(situation)) is not None:
        query["control"] = CONTROLS.get(control, Control.NONE).value
    if arms:
        query["crossed"] = tuple(dict.fromkeys(arms))
    if lanes:
        query |= {"lanes": max(2, query.get("lanes", 1)), "beside": lanes[0]}
    if abreast(situation):  # and the ego in the lane beside theirs
        query["lanes"] = max(2, query.get("lanes", 1))
        if road.lanes is None and road.ego_lane is None:
            query |= {"most": query["lanes"], "lane": query["lanes"]}
    four = query | {"place": Place.FOUR_WAY.value} if query["place"] == Place.JUNCTION else query
    asked = [query, four, four | {"crossed": tuple(dict.fromkeys((*arms, "left", "right", "oncoming")))}]
    if _of_side_road(situation):
        free = {"control": Control.NONE.value}
        asked[:0] = [query | free | {"place": Place.THREE_WAY.value}, four | free]
    for one in asked:  # no query asks for what crossing traffic does there
        if road.two_way is not None:
            yield one | {"opposite": road.two_way}
        yield one


def _of_side_road(situation: Situation) -> bool:
    """Whether there is a junction only since somebody comes from a side: out of a lane, an alley, a field."""
    ruled = control_of(situation) is not None and not only_others_stop(situation)
    named = situation.road.kind not in (None, RoadKind.JUNCTION) or situation.ego.route in TURNS or ruled
    named = named or (situation.road.kind is not None and not only_others_stop(situation))
    return not named and any(one.starts.where is Where.ARM for one in situation.others)


def _along(situation: Situation, base: dict[str, Any], lanes: list[str]) -> Iterator[dict[str, Any]]:
    """Queries for a way between junctions."""
    road, others = situation.road, situation.others
    straight = base["maneuver"] == Maneuver.STRAIGHT
    query = dict(base)
    if straight and "site" not in query:
        query["place"] = PLACES.get(road.kind or RoadKind.ROAD, Place.ROAD).value
    elif straight and road.kind is not None and road.kind in _CURVES:
        query["place"] = PLACES[road.kind].value
    places = {one.starts.where for one in others}
    wrong_way = Where.ONCOMING_IN_OUR_LANE in places
    against = Where.ONCOMING in places or (wrong_way and query.get("opposite", True))
    against = against or any(_turns_round(one) for one in others)
    against = against and query.get("ends") != Beside.BACK  # who turns round has them anyway, some lanes away
    if query["maneuver"] == Maneuver.BYPASS:
        several = (road.lanes or 1) > 1 or (bool(lanes) and not against)
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
    if wrong_way and Where.ONCOMING not in places and straight:  # who needs no lane of its own
        yield dict(base) if not lanes else base | {"beside": lanes[0]}


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


def _round(situation: Situation, base: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Queries for a way through a roundabout; where no exit was said, one behind the entries of others."""
    for way in (Maneuver.STRAIGHT, Maneuver.LEFT_TURN) if situation.ego.route is EgoRoute.ROUNDABOUT else ():
        yield base | {"site": Site.ROUNDABOUT.value, "maneuver": way.value}
    yield base | {"site": Site.ROUNDABOUT.value}


def _at_kerb(one: Other) -> bool:
    return one.starts.where in (Where.KERB, Where.ROADSIDE, Where.DRIVEWAY, Where.CROSSING, Where.BUS_BAY)


def _take(ledger: Ledger, found: Found) -> None:
    """What of the road is as it was said, once a route is found; and what was chosen."""
    situation = ledger.situation
    ledger.take(*as_said(situation, found))
    if situation.road.control is RightOfWay.YIELD_SIGN and "control" in found.query:
        ledger.assume("no sign at the junction says who gives way, since no map has such signs")
    for name, side in found.sides.items():
        if comes_from(situation[name]) is side:
            continue  # which was said
        own = turned_about(side) if backs(situation) else side
        ledger.assume(f"{name} is on the {own}, which was not said")
    if only_others_stop(situation):
        ledger.assume("no sign is seen where others do not stop, since no map has one that only others have")
    stops = any(deed.act in (Act.STOP, Act.STAND) for deed in situation.ego.does)
    if found.query.get("control") == Control.STOP_SIGN and not stops:
        ledger.assume("the ego has a stop sign as well, since no map has a junction where only others have one")
    if situation.ego.route in (EgoRoute.TURN, EgoRoute.LANE_CHANGE):
        ledger.assume(f"the ego's {situation.ego.route} is to the left, which was not said")
    said, there = situation.road.lanes, lanes_there(found)
    if said is not None and 1 < said < there:  # what lies beyond is used by nobody
        ledger.assume(f"{there} lanes go the ego's way, since no road of the maps at hand fits that has {said}")
        ledger.take("road.lanes")


def started(one: Other, sides: dict[str, Side]) -> Other:
    """Somebody with the side that was chosen where none was said."""
    if one.id not in sides:
        return one
    return replace(one, starts=replace(one.starts, side=sides[one.id]))
