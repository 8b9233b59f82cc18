"""Queries for a way through a junction or a roundabout, the narrower first."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from chatscene.build.fitting import abreast
from chatscene.build.place import AT_CROSSWALKS, NEXT_LANE, arm_of, control_of, only_others_stop, rides_at_edge
from chatscene.maps.writing.rings import MOST_MINI
from chatscene.situations.check import TURNS
from chatscene.terms.routing import CONTROLS, PLACES, SHAPES, SIDES
from chatscene.terms.scenario import Control, Maneuver, Place, Site
from chatscene.terms.situation import Road, Situation
from chatscene.terms.vocabulary import EgoRoute, RoadKind, Side, Where

LESS, MORE = 0.84, 1.05  # of a roundabout's diameter, between which that of the circle round its lanes lies
_OF_ARMS = {3: {"place": Place.THREE_WAY.value}, 4: {"place": Place.FOUR_WAY.value}}


def at_crossing(
    situation: Situation, sides: dict[str, Side], base: dict[str, Any], lanes: list[str]
) -> Iterator[dict[str, Any]]:
    """Queries for a way through a junction, the narrower first."""
    road, others = situation.road, situation.others
    arms = [arm for one in others if (arm := arm_of(situation, one, sides))]
    if any(rides_at_edge(one, situation.ego.route) and one.starts.where in NEXT_LANE for one in others):
        arms.append("oncoming")  # an arm opposite, or there is no straight on
    query = base | _of_kind(situation)
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
    crossed = four | {"crossed": tuple(dict.fromkeys((*arms, "left", "right", "oncoming")))}
    asked = [*_first_at_junction(situation, query, four), query, four, crossed]
    if road.side_road is not None:
        asked = [query | {"place": Place.THREE_WAY.value, "shape": SIDES[road.side_road].value}, *asked]
    for one in asked:  # no query asks for what crossing traffic does there
        if road.two_way is not None:
            yield one | {"opposite": road.two_way}
        yield one


def _first_at_junction(situation: Situation, query: dict[str, Any], four: dict[str, Any]) -> tuple[dict[str, Any], ...]:
    """What is asked for before any junction, and before any with four arms."""
    if _of_side_road(situation):
        free = {"control": Control.NONE.value}
        return query | free | {"place": Place.THREE_WAY.value}, four | free
    if _on_foot_over(situation) and not {"lanes", "lane", "beside"} & query.keys():
        return query | {"beside": "none"}, four | {"beside": "none"}
    return ()


def _on_foot_over(situation: Situation) -> bool:
    """Whether somebody is at a crosswalk, which leads over few lanes unless more were said."""
    return any(one.starts.where in AT_CROSSWALKS for one in situation.others)


def _of_side_road(situation: Situation) -> bool:
    """Whether there is a junction only since somebody comes from a side: out of a lane, an alley, a field."""
    ruled = control_of(situation) is not None and not only_others_stop(situation)
    named = situation.road.kind not in (None, RoadKind.JUNCTION) or situation.ego.route in TURNS or ruled
    named = named or (situation.road.kind is not None and not only_others_stop(situation))
    return not named and any(one.starts.where is Where.ARM for one in situation.others)


def _of_kind(situation: Situation) -> dict[str, Any]:
    """What is asked for of a junction by its kind and the number of its arms."""
    road = situation.road
    asked: dict[str, Any] = {"place": PLACES.get(road.kind or RoadKind.JUNCTION, Place.JUNCTION).value}
    if road.arms is not None and asked["place"] == Place.JUNCTION:
        asked |= _OF_ARMS.get(road.arms, {"arms": road.arms})
    return asked | ({"shape": SHAPES[road.kind].value} if road.kind in SHAPES else {})


def round_about(situation: Situation, base: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Queries for a way through a roundabout; where no exit was said, for one behind the entries of others."""
    road, ego = situation.road, situation.ego
    there = base | {"site": Site.ROUNDABOUT.value}
    ways = (Maneuver.STRAIGHT, Maneuver.LEFT_TURN) if ego.route is EgoRoute.ROUNDABOUT else ()
    if ego.exit is not None:
        there["by_exit"] = ego.exit
        ways = (Maneuver.STRAIGHT, Maneuver.LEFT_TURN, Maneuver.RIGHT_TURN)
    arms, size = {} if road.arms is None else {"arms": road.arms}, _size(road)
    less = size if road.kind is RoadKind.MINI_ROUNDABOUT else {}
    for shaped in (arms | size, less) if arms | size != less else (less,):
        for way in dict.fromkeys((*ways, Maneuver(there["maneuver"]))):
            yield there | shaped | {"maneuver": way.value}


def _size(road: Road) -> dict[str, Any]:
    """What is asked for of the diameter of a roundabout."""
    if road.diameter is not None:
        return {"across": (round(LESS * road.diameter.least, 1), round(MORE * road.diameter.most, 1))}
    return {"across": (0.0, MOST_MINI)} if road.kind is RoadKind.MINI_ROUNDABOUT else {}
