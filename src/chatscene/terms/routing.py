"""What the words of a situation for ways, junctions and roads are for whoever finds a route on a map."""

from __future__ import annotations

from chatscene.terms.scenario import Control, Maneuver, Place
from chatscene.terms.vocabulary import EgoRoute, RightOfWay, RoadKind

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
}
"""What a route finder is asked for; for the ways of an ego that are not here, no map is asked."""

CONTROLS = {
    RightOfWay.SIGNAL: Control.SIGNAL,
    RightOfWay.STOP_SIGN: Control.STOP_SIGN,
    RightOfWay.NONE: Control.NONE,
}
PLACES = {
    RoadKind.JUNCTION: Place.JUNCTION,
    RoadKind.THREE_WAY: Place.THREE_WAY,
    RoadKind.FOUR_WAY: Place.FOUR_WAY,
    RoadKind.CURVE: Place.CURVE,
    RoadKind.LEFT_CURVE: Place.LEFT_CURVE,
    RoadKind.RIGHT_CURVE: Place.RIGHT_CURVE,
    RoadKind.ROAD: Place.ROAD,
}
