"""What the words of a situation for ways, junctions and roads are for whoever finds a route on a map."""

from __future__ import annotations

from chatscene.terms.route import Beside, Shape
from chatscene.terms.scenario import Control, Maneuver, Place
from chatscene.terms.vocabulary import EgoRoute, RightOfWay, RoadKind, Side

MANEUVERS: dict[EgoRoute | None, Maneuver] = {
    None: Maneuver.STRAIGHT,
    EgoRoute.STRAIGHT: Maneuver.STRAIGHT,
    EgoRoute.LEFT_TURN: Maneuver.LEFT_TURN,
    EgoRoute.RIGHT_TURN: Maneuver.RIGHT_TURN,
    EgoRoute.TURN: Maneuver.LEFT_TURN,
    EgoRoute.LANE_CHANGE_LEFT: Maneuver.LANE_CHANGE_LEFT,
    EgoRoute.LANE_CHANGE_RIGHT: Maneuver.LANE_CHANGE_RIGHT,
    EgoRoute.LANE_CHANGE: Maneuver.LANE_CHANGE_LEFT,
    EgoRoute.BYPASS: Maneuver.BYPASS,
    EgoRoute.OVERTAKE: Maneuver.BYPASS,
    EgoRoute.ROUNDABOUT: Maneuver.STRAIGHT,
    EgoRoute.MERGE: Maneuver.LANE_CHANGE_LEFT,
    EgoRoute.EXIT: Maneuver.LANE_CHANGE_RIGHT,
    EgoRoute.LEAVE_PARKING: Maneuver.STRAIGHT,
    EgoRoute.LEAVE_DRIVEWAY: Maneuver.STRAIGHT,
    EgoRoute.PARK: Maneuver.STRAIGHT,
    EgoRoute.ENTER_DRIVEWAY: Maneuver.STRAIGHT,
    EgoRoute.ENTER_DRIVEWAY_ACROSS: Maneuver.STRAIGHT,
    EgoRoute.U_TURN: Maneuver.STRAIGHT,
    EgoRoute.REVERSE: Maneuver.STRAIGHT,
}
"""What a route finder is asked for; for the ways of an ego that are not here, no map is asked."""

BEGINS: dict[EgoRoute | None, Beside] = {EgoRoute.LEAVE_PARKING: Beside.KERB, EgoRoute.LEAVE_DRIVEWAY: Beside.DRIVEWAY}
ENDS: dict[EgoRoute | None, Beside] = {
    EgoRoute.PARK: Beside.KERB,
    EgoRoute.ENTER_DRIVEWAY: Beside.DRIVEWAY,
    EgoRoute.ENTER_DRIVEWAY_ACROSS: Beside.DRIVEWAY_ACROSS,
    EgoRoute.U_TURN: Beside.BACK,
}
"""Where the ego's way begins or ends beside its lane."""

CONTROLS = {
    RightOfWay.SIGNAL: Control.SIGNAL,
    RightOfWay.STOP_SIGN: Control.STOP_SIGN,
    RightOfWay.NONE: Control.NONE,
}
PLACES = {
    RoadKind.JUNCTION: Place.JUNCTION,
    RoadKind.THREE_WAY: Place.THREE_WAY,
    RoadKind.T_END: Place.THREE_WAY,
    RoadKind.FORK: Place.THREE_WAY,
    RoadKind.FOUR_WAY: Place.FOUR_WAY,
    RoadKind.CURVE: Place.CURVE,
    RoadKind.LEFT_CURVE: Place.LEFT_CURVE,
    RoadKind.RIGHT_CURVE: Place.RIGHT_CURVE,
    RoadKind.ROAD: Place.ROAD,
}
SHAPES: dict[RoadKind | None, Shape] = {RoadKind.T_END: Shape.STEM, RoadKind.FORK: Shape.FORK}
SIDES = {Side.LEFT: Shape.SIDE_LEFT, Side.RIGHT: Shape.SIDE_RIGHT}
"""The shape of a junction of three arms, by its kind or by where its side road is."""
