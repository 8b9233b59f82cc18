"""Which arms a junction or a roundabout has that is laid to order, by what was said of it and who comes from where."""

from __future__ import annotations

from collections.abc import Iterator

from chatscene.build.place import arm_of, at_roundabout, only_side_signs, ring_arms, says_way, way_of
from chatscene.maps.road_spec import Meets, Sides, Signs
from chatscene.maps.writing.rings import MINI
from chatscene.situations.check import arms_said
from chatscene.terms.scenario import Maneuver
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import (
    Breach,
    EgoRoute,
    Feature,
    Heads,
    RightOfWay,
    RoadKind,
    Side,
    Where,
    acts_of,
)

_OWN, _RIGHT, _AHEAD, _LEFT = 0, 1, 2, 3
"""Arms, counter-clockwise from the ego's own: who turns right leaves by the next, who goes straight by two on."""
_AT = {"right": _RIGHT, "oncoming": _AHEAD, "left": _LEFT}
_ON = {Maneuver.RIGHT_TURN: 1, Maneuver.STRAIGHT: 2, Maneuver.LEFT_TURN: 3}
_TURNS = {EgoRoute.LEFT_TURN: Side.LEFT, EgoRoute.TURN: Side.LEFT, EgoRoute.RIGHT_TURN: Side.RIGHT}
_TAKES = {EgoRoute.STRAIGHT: _AHEAD, EgoRoute.LEFT_TURN: _LEFT, EgoRoute.TURN: _LEFT, EgoRoute.RIGHT_TURN: _RIGHT}
_OF_THREE = {
    Meets.RIGHT: {_AHEAD, _RIGHT},
    Meets.LEFT: {_AHEAD, _LEFT},
    Meets.STEM: {_LEFT, _RIGHT},
}
"""The arms of each T beside the ego's own."""
_OF_SIDE = {Side.LEFT: Meets.LEFT, Side.RIGHT: Meets.RIGHT}
_OF_KIND: dict[RoadKind | None, Meets] = {RoadKind.T_END: Meets.STEM, RoadKind.FORK: Meets.FORK}
_OFF = acts_of(Heads.TURNS, Heads.IN)
_SIGNS = {RightOfWay.SIGNAL: Signs.SIGNAL, RightOfWay.STOP_SIGN: Signs.STOP, RightOfWay.YIELD_SIGN: Signs.YIELD}


def meets(situation: Situation) -> Meets:
    """Which arms there are beside the ego's road: as was said, else those that somebody comes from or takes."""
    road = situation.road
    arms = arms_said(road)
    if road.side_road is not None:
        return _OF_SIDE[road.side_road]
    if road.kind in _OF_KIND:
        return _OF_KIND[road.kind]
    if arms is None and at_roundabout(situation) and (situation.ego.exit or 0) > 4:
        return Meets.FIVE
    if arms is not None and arms != 3:
        return Meets.FIVE if arms == 5 else Meets.FOUR
    if arms == 3:
        return _of_three(situation)
    return Meets.FOUR if at_roundabout(situation) else _by_who_comes(situation)


def _of_three(situation: Situation) -> Meets:
    """Which three arms: those of a T with all that somebody comes from or takes; of a roundabout, all as far apart."""
    needed = {*_needed(situation)} - {_OWN}
    if at_roundabout(situation) and needed <= _OF_THREE[Meets.STEM]:
        return Meets.FORK
    fits = (shape for shape, arms in _OF_THREE.items() if needed <= arms)
    return next(fits, Meets.RIGHT)


def _needed(situation: Situation) -> Iterator[int]:
    """The arms that the ego takes, and others come from and take, as far as that was said."""
    route = situation.ego.route
    if route in _TAKES or (route is None and not at_roundabout(situation)):
        yield _TAKES[route] if route is not None else _AHEAD
    sides = {one.id: Side.RIGHT for one in situation.others if one.starts.side is None}
    for one in situation.others:
        for arm in ring_arms(one, sides)[:1] if at_roundabout(situation) else (arm_of(situation, one, sides),):
            if arm not in _AT:
                continue
            open_side = one.starts.side is None and one.starts.where is not Where.ONCOMING
            yield from () if open_side else (_AT[arm],)
            if says_way(one) and not open_side and not at_roundabout(situation):
                yield (_AT[arm] + _ON[way_of(situation, one, arm)]) % 4


def _by_who_comes(situation: Situation) -> Meets:
    """Which arms a junction has of which no number was said."""
    sides = {one.starts.side or Side.RIGHT for one in situation.others if one.starts.where is Where.ARM}
    if situation.ego.route is not None and situation.ego.route in _TURNS:
        sides.add(_TURNS[situation.ego.route])
    if len(sides) != 1 or any(_through(one) for one in situation.others):
        return Meets.FOUR
    (side,) = sides
    return _OF_SIDE[side]


def _through(one: Other) -> bool:
    """Whether somebody from an arm goes straight on over the ego's road."""
    return one.starts.where is Where.ARM and not any(deed.act in _OFF for deed in one.does)


def turn_lane(situation: Situation) -> Sides | None:
    """On which side the lane for turning lies that the road has: that to which the ego turns, else the left."""
    if Feature.TURN_LANE not in situation.road.has:
        return None
    side = _TURNS.get(situation.ego.route, Side.LEFT) if situation.ego.route is not None else Side.LEFT
    return Sides(str(side))


def diameter(situation: Situation) -> float:
    """The diameter [m] of a roundabout: as was said, else that of a usual mini one, or 0 for what is usual."""
    road = situation.road
    if road.diameter is not None:
        return float(road.diameter.near(road.diameter.least))
    return MINI if road.kind is RoadKind.MINI_ROUNDABOUT else 0.0


def signs(situation: Situation) -> Signs | None:
    """What rules the junction, and for whom."""
    broken = {deed.breaks for one in situation.others for deed in one.does}
    ends = situation.road.kind in _OF_KIND  # where the ego's own is the minor road
    if only_side_signs(situation) and not ends:
        gives_way = situation.road.control is RightOfWay.PRIORITY and Breach.STOP_SIGN not in broken
        return Signs.SIDE_YIELD if gives_way else Signs.SIDE_STOP
    ruled = situation.road.control
    if situation.road.ego_light is not None or Breach.RED_LIGHT in broken:
        ruled = RightOfWay.SIGNAL
    found = None if ruled is None else _SIGNS.get(ruled)
    return Signs.SIDE_STOP if ends and found is Signs.STOP else found
