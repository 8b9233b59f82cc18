"""What each value of a fact of the offline reader is in a situation: a row for each."""

from __future__ import annotations

from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.amount import Acceleration, Amount, Duration, Speed
from chatscene.terms.scenario import Control, EgoState, Maneuver, Occluder, Place, Position, QuantityKind, Site
from chatscene.terms.situation import Deed, Road
from chatscene.terms.vocabulary import (
    Act,
    EgoRoute,
    Feature,
    Manner,
    RightOfWay,
    RoadKind,
    Setting,
    Side,
    UserKind,
    Where,
)

WHO, BESIDE, HIDES, LEADS, BLOCKS = "A", "BCD", "H", "L", "P"
"""Ids: the adversary's, those of others who do something, and of who hides it, leads the ego, and is in its way."""

KINDS: dict[AdversaryKind | None, UserKind] = {
    **{
        one.row.body: one
        for one in reversed(UserKind)  # type: ignore[call-overload]
        if not (one.row.general or one.row.prop)
    },
    AdversaryKind.BOX: UserKind.OBJECT,
    None: UserKind.ROAD_USER,
}
ROUTES = {
    None: None,
    Maneuver.STRAIGHT: EgoRoute.STRAIGHT,
    Maneuver.LEFT_TURN: EgoRoute.LEFT_TURN,
    Maneuver.RIGHT_TURN: EgoRoute.RIGHT_TURN,
    Maneuver.LANE_CHANGE_LEFT: EgoRoute.LANE_CHANGE_LEFT,
    Maneuver.LANE_CHANGE_RIGHT: EgoRoute.LANE_CHANGE_RIGHT,
    Maneuver.BYPASS: EgoRoute.BYPASS,
}
ROADS = {
    Place.ROAD: RoadKind.ROAD,
    Place.CURVE: RoadKind.CURVE,
    Place.LEFT_CURVE: RoadKind.LEFT_CURVE,
    Place.RIGHT_CURVE: RoadKind.RIGHT_CURVE,
    Place.THREE_WAY: RoadKind.THREE_WAY,
    Place.FOUR_WAY: RoadKind.FOUR_WAY,
    Place.JUNCTION: RoadKind.JUNCTION,
}
SITES: dict[Site, Road] = {
    Site.ROUNDABOUT: Road(kind=RoadKind.ROUNDABOUT),
    Site.MOTORWAY: Road(kind=RoadKind.MOTORWAY),
    Site.ON_RAMP: Road(kind=RoadKind.RAMP),
    Site.OFF_RAMP: Road(kind=RoadKind.MOTORWAY),
    Site.PAST_ON_RAMP: Road(kind=RoadKind.MOTORWAY, has=(Feature.ON_RAMP,)),
    Site.PAST_OFF_RAMP: Road(kind=RoadKind.MOTORWAY, has=(Feature.OFF_RAMP,)),
    Site.WEAVING: Road(kind=RoadKind.MOTORWAY, has=(Feature.ON_RAMP, Feature.OFF_RAMP)),
    Site.LANE_DROP: Road(has=(Feature.LANE_DROP,)),
    Site.RURAL: Road(setting=Setting.RURAL),
    Site.CROSSWALK: Road(has=(Feature.CROSSWALK,)),
    Site.PARKING: Road(has=(Feature.PARKING_PLACES,)),
    Site.BUS_BAY: Road(has=(Feature.BUS_BAY,)),
    Site.RAIL_CROSSING: Road(kind=RoadKind.RAIL_CROSSING),
    Site.DRIVEWAY: Road(has=(Feature.DRIVEWAY,)),
    Site.DRIVEWAY_LEFT: Road(has=(Feature.DRIVEWAY,)),
    Site.PAST_LANE_DROP: Road(has=(Feature.LANE_DROP,)),
    Site.PAST_LANE_DROP_LEFT: Road(has=(Feature.LANE_DROP,)),
    Site.PAST_BEND: Road(kind=RoadKind.CURVE),
}
WAYS_OF_SITES = {Site.ROUNDABOUT: EgoRoute.ROUNDABOUT, Site.ON_RAMP: EgoRoute.MERGE, Site.OFF_RAMP: EgoRoute.EXIT}
RULES = {
    Control.SIGNAL: RightOfWay.SIGNAL,
    Control.STOP_SIGN: RightOfWay.STOP_SIGN,
    Control.NONE: RightOfWay.NONE,
    None: None,
}
STARTS = {
    Position.AHEAD: Where.AHEAD,
    Position.ROADSIDE: Where.ROADSIDE,
    Position.BESIDE: Where.BESIDE,
    Position.AHEAD_BESIDE: Where.AHEAD_BESIDE,
    Position.BEHIND: Where.BEHIND,
    Position.BEHIND_BESIDE: Where.BEHIND_BESIDE,
    Position.ONCOMING: Where.ONCOMING,
    Position.CROSSING: Where.ARM,
    Position.FAR_CORNER: Where.EXIT_CROSSING,
    Position.KERB: Where.KERB,
    Position.BEYOND: Where.EXIT,
}
HIDING: dict[Occluder, tuple[UserKind, Where]] = {
    Occluder.PARKED_CAR: (UserKind.CAR, Where.KERB),
    Occluder.PARKED_TRUCK: (UserKind.TRUCK, Where.KERB),
    Occluder.PARKED_BUS: (UserKind.BUS, Where.KERB),
    Occluder.BUS_STOP: (UserKind.BUS_SHELTER, Where.ROADSIDE),
    Occluder.VENDING_MACHINE: (UserKind.VENDING_MACHINE, Where.ROADSIDE),
    Occluder.KIOSK: (UserKind.KIOSK, Where.ROADSIDE),
    Occluder.CONTAINER: (UserKind.CONTAINER, Where.ROADSIDE),
    Occluder.HEDGE: (UserKind.HEDGE, Where.ROADSIDE),
    Occluder.BILLBOARD: (UserKind.BILLBOARD, Where.ROADSIDE),
}
EGO_DOES: dict[EgoState, tuple[Deed, ...]] = {
    EgoState.STANDS: (Deed(act=Act.STAND),),
    EgoState.SETS_OFF: (Deed(act=Act.STAND), Deed(act=Act.SET_OFF)),
    EgoState.SLOW: (Deed(act=Act.GO_ALONG, manner=Manner.SLOW),),
    EgoState.SLOWS_DOWN: (Deed(act=Act.SLOW_DOWN),),
    EgoState.BRAKES: (Deed(act=Act.BRAKE),),
    EgoState.STOPS: (Deed(act=Act.STOP),),
}
ACTS: dict[Action, Act] = {
    Action.CROSS: Act.CROSS,
    Action.DIAGONAL: Act.CROSS,
    Action.STOP: Act.STOP,
    Action.BRAKE: Act.BRAKE,
    Action.ACCELERATE: Act.ACCELERATE,
    Action.REVERSE: Act.REVERSE,
    Action.CUT_IN: Act.CUT_IN,
    Action.CHANGE_LANE: Act.LANE_CHANGE,
    Action.WEAVE: Act.WEAVE,
    Action.SWERVE: Act.SWERVE,
    Action.PACE: Act.KEEP_LEVEL,
    Action.TURN_LEFT: Act.TURN_LEFT,
    Action.TURN_RIGHT: Act.TURN_RIGHT,
    Action.HESITATE: Act.HESITATE,
    Action.TURN_BACK: Act.TURN_BACK,
    Action.OVERTAKE: Act.OVERTAKE,
    Action.TAILGATE: Act.TAILGATE,
    Action.PULL_OUT: Act.PULL_OUT,
    Action.U_TURN: Act.U_TURN,
    Action.STAND: Act.STAND,
    Action.BLOCK: Act.STAND,
    Action.NARROW: Act.STAND,
    Action.FOLLOW: Act.GO_ALONG,
    Action.ONCOMING: Act.GO_ALONG,
    Action.WRONG_WAY: Act.GO_ALONG,
    Action.SLOW: Act.GO_ALONG,
    Action.FAST: Act.GO_ALONG,
    Action.RUN_LIGHT: Act.GO_STRAIGHT,
}
"""What each act of the reader is."""
MANNERS = {Action.DIAGONAL: Manner.SLANTING, Action.SLOW: Manner.SLOW, Action.FAST: Manner.FAST}
AMOUNTS: dict[QuantityKind, tuple[str, type[Amount]]] = {
    QuantityKind.SPEED: ("speed", Speed),
    QuantityKind.TIME: ("time", Duration),
    QuantityKind.DECELERATION: ("acceleration", Acceleration),
}
"""Which amount of a deed each measure is, and its type."""


def aside_of(to: Side, where: Where) -> int:
    """To which side of its own somebody swerves who does so to a side of ours: 1 to its left, -1 to its right."""
    faces_us = where in (Where.ONCOMING, Where.ONCOMING_IN_OUR_LANE)
    return 1 if (to is Side.LEFT) is not faces_us else -1
