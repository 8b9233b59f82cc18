"""Where it happens, by what was said: at a junction, a roundabout or on a road, and on which arm of it somebody is."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from chatscene.maps.ring_ways import ROUND
from chatscene.situations.check import RULED_BY, TURNS
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.routing import BEGINS, CONTROLS, ENDS
from chatscene.terms.scenario import Maneuver
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import Act, EgoRoute, RightOfWay, RoadKind, Side, Where
from chatscene.world.places import EgoRoute as Route
from chatscene.world.places import neighbourPath, ownLane

NEXT_LANE = frozenset((Where.AHEAD_BESIDE, Where.BESIDE, Where.BEHIND_BESIDE))
ROUNDABOUT_PLACES = frozenset((Where.IN_ROUNDABOUT, Where.ROUNDABOUT_ENTRY))
WAYS = {Act.TURN_LEFT: Maneuver.LEFT_TURN, Act.TURN_RIGHT: Maneuver.RIGHT_TURN}
PACKAGED = ("town", "outskirts")
_TO_SIDE = {EgoRoute.LEFT_TURN: Side.LEFT, EgoRoute.RIGHT_TURN: Side.RIGHT}
GOES_OVER = _TO_SIDE | {EgoRoute.LANE_CHANGE_LEFT: Side.LEFT, EgoRoute.LANE_CHANGE_RIGHT: Side.RIGHT}
"""The side on which the ego goes over the way of who goes on beside it."""


@dataclass(frozen=True, slots=True)
class Found:
    """Where it happens.

    Attributes:
        map: The map's name or file.
        query: What the program asks the map for, as `selectRoute` takes it.
        route: The first route that the map answers with.
        sides: For each of others whose side was left open, the one that was chosen.
        further: How many times as much road as usual leads up to what happens.
    """

    map: str
    query: dict[str, Any]
    route: Route
    sides: dict[str, Side]
    further: float = 1.0


def at_junction(situation: Situation) -> bool:
    """Whether it happens at a junction."""
    road, others = situation.road, situation.others
    return not (at_roundabout(situation) or beside_lane(situation)) and (
        road.kind in (RoadKind.JUNCTION, RoadKind.THREE_WAY, RoadKind.FOUR_WAY)
        or situation.ego.route in TURNS
        or control_of(situation) in CONTROLS
        or any(one.starts.where.row.junction for one in others if one.starts.where not in ROUNDABOUT_PLACES)
        or any(deed.act is Act.GO_STRAIGHT for one in others for deed in one.does)
    )


def beside_lane(situation: Situation) -> bool:
    """Whether the ego's way begins or ends beside its lane."""
    return situation.ego.route in BEGINS or situation.ego.route in ENDS


def control_of(situation: Situation) -> RightOfWay | None:
    """What rules the junction: as was said, else what is there since somebody has it or breaks its rule."""
    if situation.road.control is not None:
        return situation.road.control
    if situation.road.ego_light is not None:
        return RightOfWay.SIGNAL
    broken = (deed.breaks for one in situation.others for deed in one.does)
    return next((RULED_BY[breach] for breach in broken if breach is not None and breach in RULED_BY), None)


def at_roundabout(situation: Situation) -> bool:
    """Whether it happens at a roundabout."""
    named = situation.road.kind is RoadKind.ROUNDABOUT or situation.ego.route is EgoRoute.ROUNDABOUT
    return named or any(one.starts.where in ROUNDABOUT_PLACES for one in situation.others)


def rides_at_edge(one: Other, route: EgoRoute | None = None) -> bool:
    """Whether it is on two wheels, and beside the ego at the edge of the ego's own lane.

    Who has no motor always is; who has one is where the ego turns to that side, out of the lane at the edge.

    Args:
        one: Who.
        route: The ego's.
    """
    if one.kind.moves is not Moves.RIDES:
        return False
    turned_to = route is not None and one.starts.side is not None and one.starts.side is _TO_SIDE.get(route)
    return turned_to or not one.kind.row.body.row.motorised


def arm_of(situation: Situation, one: Other, sides: dict[str, Side]) -> str:
    """From where traffic through the ego's junction comes; empty for who comes from none of its arms."""
    if at_roundabout(situation) or from_left(situation, one):
        return ""
    if one.starts.where is Where.ARM:
        return str(one.starts.side or sides[one.id])
    return "oncoming" if one.starts.where is Where.ONCOMING and at_junction(situation) else ""


def ring_arms(one: Other, sides: dict[str, Side]) -> tuple[str, ...]:
    """From where traffic in the ego's roundabout comes, best first; nothing for who is elsewhere."""
    match one.starts.where:
        case Where.IN_ROUNDABOUT:
            return (ROUND,)
        case Where.ROUNDABOUT_ENTRY:
            side = one.starts.side
            return (str(side),) if side is not None else ("right", "left", "oncoming")  # the ego comes past, or it does
        case Where.ARM:
            return (str(one.starts.side or sides[one.id]),)
        case Where.ONCOMING:
            return ("oncoming",)
        case _:
            return ()


def from_left(situation: Situation, one: Other) -> bool:
    """Whether somebody comes along the road that the ego drives onto out of a driveway, in the lane that it takes."""
    out = situation.ego.route is EgoRoute.LEAVE_DRIVEWAY
    return out and one.starts.where is Where.ARM and one.starts.side in (Side.LEFT, None)


def way_of(one: Other) -> Maneuver:
    """What somebody who comes through a junction does there."""
    return next((WAYS[deed.act] for deed in one.does if deed.act in WAYS), Maneuver.STRAIGHT)


def room_against(route: Route) -> float:
    """How far ahead [m] of the ego somebody can be at most who comes against it in the lane to its left."""
    return ownLane(route).project(*neighbourPath(route, "left").point_at(0.0))[0]
