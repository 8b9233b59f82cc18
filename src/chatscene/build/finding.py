"""A query for the ego's route, and a route of the map that has all the ways that others need."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from pathlib import Path
from typing import Any

from chatscene.build.asked import stands_first
from chatscene.build.coming import further, keeps_limits
from chatscene.build.fitting import lacking_for, too_short
from chatscene.build.holding import as_said, lanes_there
from chatscene.build.ledger import Ledger
from chatscene.build.place import (
    DRIVEWAYS,
    GOES_OVER,
    NEXT_LANE,
    Found,
    at_roundabout,
    beside_lane,
    control_of,
    from_left,
    in_bus_lane,
    in_cycle_lane,
    only_others_stop,
    only_side_signs,
    room_against,
    shares_driveway,
    turns_in,
)
from chatscene.build.queries import queries_for
from chatscene.build.screening import from_its_lane, side_hidden
from chatscene.errors import MapError, NoSuchPlace, NoSuchRoad, NotBuilt, NothingBuilds
from chatscene.maps.loading import load_roads
from chatscene.maps.network import resolve_map
from chatscene.maps.open_road import BLOCKER_AT, CHANGE_AT, OPEN_ROAD, PASSING, SWING
from chatscene.maps.road_spec import Signs
from chatscene.maps.routes import APPROACHES, ELSEWHERE
from chatscene.maps.sites import APPROACHED, PASSED, PAST
from chatscene.maps.ways_off import NARROWEST
from chatscene.situations.check import goes_over
from chatscene.situations.facts import said_in
from chatscene.terms.amount import Length
from chatscene.terms.backing import backs, turned_about
from chatscene.terms.pace import NOMINAL
from chatscene.terms.route import Equipment
from chatscene.terms.routing import MANEUVERS
from chatscene.terms.scenario import Control, Maneuver, Place, Site
from chatscene.terms.situation import Other, Road, Situation
from chatscene.terms.vocabulary import (
    ASIDE,
    HALTS,
    Act,
    Breach,
    EgoRoute,
    Heads,
    RightOfWay,
    RoadKind,
    Role,
    Side,
    Where,
    acts_of,
)
from chatscene.world.ego_route import EgoRoute as Route
from chatscene.world.ego_route import choose_route, has_route
from chatscene.world.places import lanesBeside, timetable

_Load = Callable[[str], tuple[Any, str]]
"""The roads of a map by its name, and its file."""


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
        raise NothingBuilds(f"cannot be built yet: ego.route: {situation.ego.route}")
    for one in situation.others:
        if beside_lane(situation) and one.starts.where.row.junction and not from_left(situation, one):
            raise NothingBuilds(
                f"cannot be built yet: others.{one.id}.starts.where: {one.starts.where}, with ego.route:"
                f" {situation.ego.route}"
            )
    rooms: dict[str, float] = {}
    lacking, load = _Lacking(), cache(_map)
    for more in _worth_looking_for(situation, tuple(_lengths(situation, speed, road)), rooms, load):
        lacking = _Lacking()  # what is told is what the shortest road lacks
        if found := _found(situation, speed, more, road, lacking, rooms, load):
            _take(ledger, found)
            far = min(max(1.0, more), further(speed))
            far = found.route.eventAt / BACKED if backs(situation) else far
            return replace(found, further=far, sought=road > 0.0)
    if rooms:
        raise NotBuilt("; ".join(told.format(most) for told, most in rooms.items()))
    first, *others = dict.fromkeys((*lacking.unfit, *lacking.nowhere))
    more_alike = f" ({len(others)} similar places were tried, too)" if others else ""
    refusal = NoSuchPlace if lacking.unfit else NoSuchRoad  # the shortest was looked for last
    raise refusal(f"no map has such a place: {first}{more_alike}")


@dataclass(frozen=True, slots=True)
class _Lacking:
    """What maps lack, in words.

    Attributes:
        unfit: Of those that have such a road, which is told first.
        nowhere: Of those that have none.
    """

    unfit: list[str] = field(default_factory=list[str])
    nowhere: list[str] = field(default_factory=list[str])


def _worth_looking_for(
    situation: Situation, lengths: tuple[float, ...], rooms: Mapping[str, float], load: _Load
) -> Iterator[float]:
    """The lengths of road, but those between where not even the shortest is anywhere, once the longest is not found."""
    yield lengths[0]
    if between := lengths[1:-1]:
        yield from between if rooms or _is_somewhere(situation, lengths[-1], load) else ()
    yield from lengths[1:][-1:]


def _found(
    situation: Situation,
    speed: float,
    more: float,
    road: float,
    lacking: _Lacking,
    rooms: dict[str, float],
    load: _Load,
) -> Found | None:
    """The first route on so many times the usual road; what each map lacks goes into `lacking` and `rooms`."""
    for sides in _open_sides(situation):
        for name, query in queries_for(situation, sides):
            if found := _answered(
                situation, speed, name, load(name), _longer(situation, query, more), sides, lacking, rooms, road
            ):
                return found
    return None


def _is_somewhere(situation: Situation, more: float, load: _Load) -> bool:
    """Whether any map has any of the roads that are asked for, so many times as long as usual."""
    asked = ((name, query) for sides in _open_sides(situation) for name, query in queries_for(situation, sides))
    return any(has_route(*load(name), **_longer(situation, query, more)) for name, query in asked)


def without_one_fact(situation: Situation, speed: float) -> str:
    """Which facts, each left out alone, would let a place be found, in words; else which distance, or that none would.

    They are the facts of the road, the ego's route, and everybody but who is met or hides somebody.

    Args:
        situation: What was said, for which no map has a place.
        speed: What the ego drives at [m/s].
    """
    said = [(path, str(value)) for path, value in said_in(situation) if path.startswith("road.")]
    if situation.road.ego_light is not None:  # which there is only where there is a light
        said = [(path, value) for path, value in said if path != "road.control"]
    less = {f"{path}: {value}": replace(situation, road=_without(situation.road, path)) for path, value in said}
    if situation.ego.route not in (None, EgoRoute.STRAIGHT):
        less[f"ego.route: {situation.ego.route}"] = replace(situation, ego=replace(situation.ego, route=None))
    named = {one.hidden_by for one in situation.others} | {one.id for one in situation.adversaries}
    for one in situation.others:
        if one.id not in named:
            less[f"others.{one.id}"] = replace(
                situation, others=tuple(other for other in situation.others if other is not one)
            )
    load = cache(_map)
    helps = [told for told, one in less.items() if _found(one, speed, 1.0, 0.0, _Lacking(), {}, load)]
    if helps:
        return f"leave out {' or '.join(helps)}, and a place is found"
    several = "leaving out one fact of the road is not enough: leave out several"
    return _nearer(situation, speed) or (several if len(said) > 1 else "")


def _nearer(situation: Situation, speed: float) -> str:
    """Which distance that was said, said shorter, would let a place be found, in words; empty if none would.

    Args:
        situation: What was said, for which no map has a place.
        speed: What the ego drives at [m/s].
    """
    load = cache(_map)
    for n, one in enumerate(situation.others):
        if (said := one.starts.distance) is None:
            continue
        for share in _SHORTER:
            far = max(1, math.floor(share * said.least))
            starts = replace(one.starts, distance=Length(far, far))
            others = (*situation.others[:n], replace(one, starts=starts), *situation.others[n + 1 :])
            if _found(replace(situation, others=others), speed, 1.0, 0.0, _Lacking(), {}, load):
                return f"others.{one.id}.starts.distance: {said}: say {far} m, and a place is found"
    return ""


def _without(road: Road, path: str) -> Road:
    """What was said of a road but for the fact at a path, such as ``road.lanes`` or ``road.has.0``."""
    _, field, *number = path.split(".")
    if number:
        return replace(road, has=tuple(one for k, one in enumerate(road.has) if k != int(number[0])))
    return replace(road, **{field: None})


BACKED = 42.0  # [m] ahead of which others are about, in the middle, who are nearer to an ego that backs
_OVER_AT = 60.0  # [m] on the usual road, after which an ego from a ramp is in the next lane
_SLOW = 0.6  # of the usual road, of an ego that is slower than usual
_AS_FAST = 0.95  # of its usual speed, that a road allows which is looked for since much is done along it
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


_WHERE_IN = {
    Site.BUS_BAY: (Where.BUS_BAY, 10.0),
    Site.CROSSWALK: (Where.CROSSING, 2.0),
    Site.DRIVEWAY: (Where.DRIVEWAY, 2.5),
    Site.DRIVEWAY_LEFT: (Where.DRIVEWAY, 2.5),
}
_BEFORE_JUNCTION = (Where.CROSSING, -4.0)
"""Who is at a site, or before a junction, and how far beyond where it begins [m]."""
_SHORTER = tuple(n / 10 for n in range(9, 0, -1))  # of a distance, for which a place is looked for
_OFF = 4.0  # [m] by which a site may be nearer or farther than was asked for
_NEAREST = 5.0  # [m] of road at least before a site


def _usual(query: Mapping[str, Any]) -> float:
    """How far [m] a route usually leads up to what happens."""
    site = Site(query["site"]) if "site" in query else None
    if site is not None and site in APPROACHED:
        return APPROACHED[site]
    if site in PASSED:
        return PAST[0]
    if _through(query):
        return APPROACHES[0]
    if query["maneuver"] == Maneuver.BYPASS:
        return BLOCKER_AT
    return OPEN_ROAD / 2 if query["maneuver"] == Maneuver.STRAIGHT else CHANGE_AT


def _through(query: Mapping[str, Any]) -> bool:
    """Whether a route is asked for that leads through a junction."""
    return query.get("place") in (Place.JUNCTION, Place.THREE_WAY, Place.FOUR_WAY) or "crossed" in query


def _longer(situation: Situation, query: dict[str, Any], more: float) -> dict[str, Any]:
    """The same query, with so many times as much road as usual, or as much as somebody was said to be ahead there.

    An ego swings out where somebody was said to stand; a bay or a crosswalk is where who is there was said to be.
    """
    if query["maneuver"] == Maneuver.BYPASS and (at := _stands_at(situation)) > 0.0:
        return query | {"approach": round(max(at, SWING + PASSING + 1.0), 1)}
    if (before := _road_to(situation, query)) > 0.0:
        return query | {"approach": round(before, 1)}
    if more == 1.0 or (more < 1.0 and not _through(query)):
        return query
    return query | {"approach": round(more * _usual(query), 1)}


def _lengths(situation: Situation, speed: float, road: float) -> Iterator[float]:
    """How many times as much road as usual is looked for: as the ego's speed asks for, then less."""
    more = max(further(speed), road / OPEN_ROAD, *(_far(one) / OPEN_ROAD * _BEYOND for one in situation.others))
    more = min(more, _over_within(situation))
    while more > 1.0:
        yield more
        more /= _MORE
    yield 1.0
    if speed < NOMINAL.speed:  # else who comes to meet a slow ego would have to come from too far
        yield _SLOW


def _over_within(situation: Situation) -> float:
    """How many times as much road as usual an ego may have that is to be over within a way that was said."""
    merges = situation.ego.route is EgoRoute.MERGE
    along = acts_of(Heads.OVER, Heads.ALONG)
    said = (deed.distance for deed in situation.ego.does if merges and deed.act in along)
    return min((one.most / _OVER_AT for one in said if one is not None), default=math.inf)


def _said_distance(one: Other) -> float:
    """How far away [m] somebody was said to be."""
    return one.starts.distance.least if one.starts.distance is not None else 0.0


def _stands_at(situation: Situation) -> float:
    """How far [m] ahead of the ego, middle to middle, the first was said to stand that it passes; 0 of none."""

    def middle(one: Other) -> float:
        both = situation.ego.body.row.limits.length + one.kind.row.body.row.limits.length
        return _said_distance(one) + (0.5 * both if one.starts.where is Where.AHEAD else 0.0)  # else it is to there

    passed = (one for one in situation.others if one.starts.where in (Where.AHEAD, Where.KERB) and stands_first(one))
    return min((middle(one) for one in passed if one.starts.distance is not None), default=0.0)


def _road_to(situation: Situation, query: Mapping[str, Any]) -> float:
    """How much road [m] leads up to what the road has, since somebody there was said to be so far; 0 if not said."""
    reach = _WHERE_IN.get(Site(query["site"])) if "site" in query else _BEFORE_JUNCTION if _through(query) else None
    for one in situation.others:
        if reach is not None and one.starts.where is reach[0] and one.starts.distance is not None:
            return max(_said_distance(one) - reach[1], _NEAREST)
    return 0.0


def _elsewhere(situation: Situation, found: Found) -> str | None:
    """That what the road has is not so far ahead there as somebody was said to be, in words; None if it is."""
    before = _road_to(situation, found.query)
    off = before > 0.0 and abs(found.route.eventAt - before) > _OFF
    return f"there is nothing of that kind after {before:.0f} m of road" if off else None


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
    told = dict(_beside_whom(situation))
    told |= {one.id: side for one in others if (side := side_hidden(situation, one)) is not None}
    told |= {one.id: side for one in others if (side := comes_from(one)) is not None}
    told |= {one.id: Side.LEFT for one in others if from_left(situation, one) or _without_priority(situation, one)}
    told |= {one.id: side for one in others if (side := _out_of_the_way(situation, one)) is not None}
    told = {name: side for name, side in told.items() if name in open_ones}
    for first in (Side.RIGHT, Side.LEFT) if len(open_ones) > len(told) else (Side.RIGHT,):
        yield dict.fromkeys(open_ones, first) | told


def _beside_whom(situation: Situation) -> Iterator[tuple[str, Side]]:
    """The side of who hides somebody from beside the road, and of whom it hides, by that of the other."""
    for one in situation.others:
        by = situation[one.hidden_by] if one.hidden_by is not None else None
        if by is None or from_its_lane(situation, by, one):
            continue
        for mine, theirs in ((one, by), (by, one)):
            if theirs.starts.side is not None:
                yield mine.id, theirs.starts.side


def _without_priority(situation: Situation, one: Other) -> bool:
    """Whether somebody does not give way where nothing rules the junction, so that it comes from our left.

    Who comes from our right has priority there, where traffic keeps right (Vienna Convention on Road Traffic, 18.4).
    """
    takes = one.starts.where is Where.ARM and any(deed.breaks is Breach.RIGHT_OF_WAY for deed in one.does)
    return takes and not at_roundabout(situation) and control_of(situation) is RightOfWay.NONE


def _out_of_the_way(situation: Situation, one: Other) -> Side | None:
    """On which side somebody beside the ego is who is not met, if the ego goes over to one side."""
    if one.role is not Role.SUPPORTING or one.starts.where is not Where.BESIDE:
        return None
    over = [deed.to for deed in situation.ego.does if deed.act in ASIDE | acts_of(Heads.OVER)]
    over.append(GOES_OVER.get(situation.ego.route) if situation.ego.route is not None else None)
    to = next((side for side in over if side is not None), None)
    return {Side.LEFT: Side.RIGHT, Side.RIGHT: Side.LEFT, None: None}[to]


def comes_from(one: Other) -> Side | None:
    """From which side somebody comes of whom the side was said to which it goes, or on which it goes past."""
    past = next((deed.to for deed in one.does if deed.act is Act.OVERTAKE and deed.to is not None), None)
    if past is not None and one.starts.where in NEXT_LANE:
        return past
    to = next((deed.to for k, deed in enumerate(one.does) if goes_over(one, k) and deed.to is not None), None)
    return None if to is None else Side.LEFT if to is Side.RIGHT else Side.RIGHT


def _answered(
    situation: Situation,
    speed: float,
    name: str,
    there: tuple[Any, str],
    query: dict[str, Any],
    sides: dict[str, Side],
    lacking: _Lacking,
    rooms: dict[str, float],
    road: float,
) -> Found | None:
    """The first route of a map that answers a query, if all whom it is for can be there.

    Args:
        situation: What was said.
        speed: What the ego drives at [m/s].
        name: The map's name or file.
        there: Its network and its path.
        query: What it is asked for.
        sides: Those that were chosen.
        lacking: Takes what the map lacks.
        rooms: Takes what is the most that a place has room for, by what is told of it, where more was said.
        road: How much road [m] the ego drives along while all is done; 0 where that is not known yet.
    """
    network, path = there
    try:
        route = choose_route(network, path, 0, **query)
    except MapError as error:
        lacking.nowhere.append(str(error) if situation.map else str(error).partition(ELSEWHERE)[0])
        return None
    beside = backs(situation) and situation.ego.route is not EgoRoute.REVERSE  # along the road, that it backs onto
    for one in () if beside else situation.others:
        if _said_distance(one) > (room := _room(route, one)):
            fact = f"others.{one.id}.starts.distance: {one.starts.distance}: the longest road has {{:.0f}} m"
            rooms[fact] = max(room, rooms.get(fact, 0.0))
            return None
    if road and keeps_limits(situation) and timetable(route, speed, keeps_limits=True).speed_at(0.0) < _AS_FAST * speed:
        lacking.unfit.append(f"on map {Path(path).stem!r} so long a road with its usual limit")
        return None
    found = Found(name, query, route, sides)
    if (lacks := _elsewhere(situation, found) or lacking_for(situation, found)) is not None:
        lacking.unfit.append(f"on map {Path(path).stem!r} {lacks}")
        return None
    for told, most in too_short(situation, found, speed):
        rooms[told] = max(most, rooms.get(told, 0.0))
        return None
    return found


def _map(name: str) -> tuple[Any, str]:
    """The roads of a map, and its file."""
    path = str(resolve_map(name))
    return load_roads(path), path


def _take(ledger: Ledger, found: Found) -> None:
    """What of the road is as it was said, once a route is found; and what was chosen."""
    situation = ledger.situation
    ledger.take(*as_said(situation, found))
    gives_way = Equipment.GIVE_WAY in found.query.get("has", ())
    if situation.road.control is RightOfWay.YIELD_SIGN and "control" in found.query and not gives_way:
        ledger.lack("the junction has no give-way sign, since no map has one")
    if situation.road.kind is RoadKind.RAIL_CROSSING and situation.road.control is RightOfWay.SIGNAL:
        ledger.assume("the rail crossing has no lights, since no map has any there")
        ledger.take("road.control")
    _lack_own_lane(ledger, found)
    for one in situation.others if found.laid is not None and found.laid.median else ():
        if any(deed.act is Act.U_TURN for deed in one.does):
            ledger.assume(f"{one.id} turns through a gap in the median, which is not drawn")
    _lack_signs_and_ways(ledger, found)
    for name, side in found.sides.items():
        if comes_from(situation[name]) is side:
            continue  # which was said
        own = turned_about(side) if backs(situation) else side
        ledger.assume(f"{name} is on the {own}")
    if situation.ego.route in (EgoRoute.TURN, EgoRoute.LANE_CHANGE):
        ledger.assume(f"the ego's {situation.ego.route} goes to the left")
    said, there = situation.road.lanes, lanes_there(found)
    if said is not None and 1 < said < there:  # what lies beyond is used by nobody
        ledger.lack(f"the road has {there} lanes in the ego's direction, since no suitable road has {said}")
        ledger.take("road.lanes")


def _lack_own_lane(ledger: Ledger, found: Found) -> None:
    """Whether the ego drives beside the lane that is for such as it."""
    if in_cycle_lane(ledger.situation) and not (found.laid is not None and found.laid.ridden):
        ledger.lack("the ego rides beside the cycle lane, not in it")
    if in_bus_lane(ledger.situation) and not (found.laid is not None and found.laid.bus_lane):
        ledger.lack("the ego drives in no bus lane, since no suitable road has one")


def _lack_signs_and_ways(ledger: Ledger, found: Found) -> None:
    """Which signs the roads of others lack, and which way off the road."""
    situation = ledger.situation
    if any(found.query.get("site") != DRIVEWAYS[side] for side in turns_in(situation)):
        ledger.lack("the road has no driveway to turn into, since no suitable one has")
    if shares_driveway(situation) and not (found.laid is not None and found.laid.mouth > NARROWEST):
        ledger.lack("the driveway is too narrow for two, since no suitable road has a wider one")
    signed = found.laid is not None and found.laid.signs in (Signs.SIDE_STOP, Signs.SIDE_YIELD)
    if only_others_stop(situation) and not signed:
        ledger.lack("the others' stop sign is not shown, since no map has one for the others only")
    if situation.road.control is RightOfWay.PRIORITY and not signed:
        ledger.lack("the signs of the side roads are not shown, since no map has them on these only")
    stops = any(deed.act in HALTS for deed in situation.ego.does)
    if found.query.get("control") == Control.STOP_SIGN and not stops:
        told = "the ego has a stop sign too, since no map has a junction where only the others have one"
        ledger.lack(told) if only_side_signs(situation) else ledger.assume(told)


def started(one: Other, sides: dict[str, Side]) -> Other:
    """Somebody with the side that was chosen where none was said."""
    if one.id not in sides:
        return one
    return replace(one, starts=replace(one.starts, side=sides[one.id]))
