"""The phrase of each word of a situation, one table for each enumeration: a new word is a row here, and no code.

A verb stands in brackets in its three forms, ``[stop/stops/stopping]``. Braces are filled in: ``{ego}`` is us or the
SV, ``{egos}`` our or the SV's, others are facts. What stands between ``<`` and ``>`` is told only where its fact was
said.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum

from chatscene.terms.actors import Manner as Moves
from chatscene.terms.actors import one_of_class
from chatscene.terms.nouns import plural, with_article
from chatscene.terms.surroundings import Light, Surface, Weather
from chatscene.terms.vocabulary import (
    Act,
    Breach,
    EgoLight,
    EgoRoute,
    Facing,
    Feature,
    Manner,
    Part,
    RightOfWay,
    RoadKind,
    Role,
    Setting,
    Side,
    Striker,
    UserKind,
    Where,
)

_DOUBLES = frozenset(
    ("step", "stop", "run", "cut", "set", "hit", "get", "jam", "slam", "zigzag", "sit", "begin", "travel", "drop")
)


def inflected(verb: str) -> tuple[str, str, str]:
    """A verb as several do it, as one does it, and as it is being done: *stop, stops, stopping*."""
    return verb, _third_person(verb), _going_on(verb)


def _third_person(verb: str) -> str:
    if verb == "have":
        return "has"
    if verb.endswith(("s", "sh", "ch", "x", "o", "z")):
        return verb + "es"
    return verb[:-1] + "ies" if verb.endswith("y") and verb[-2] not in "aeiou" else verb + "s"


def _going_on(verb: str) -> str:
    silent = verb.endswith("e") and not verb.endswith(("ee", "oe"))
    stem = verb + verb[-1] if verb in _DOUBLES else verb
    return (verb[:-1] if silent else stem) + "ing"


class Voice(StrEnum):
    """Who speaks."""

    PLAIN = "plain"
    """Somebody in the ego: we and a truck."""
    PROTOCOL = "protocol"
    """Somebody who writes down a test: the subject vehicle and target A."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Me:
    """What a voice calls the ego.

    Attributes:
        its: What is its own, of several of a kind.
        several: Whether its verbs are those of several.
        has: How it is told what the ego is; ``{kind}`` is that, with its article, ``{goes}`` the verb of who has it.
    """

    does: str
    object: str
    own: str
    its: str
    itself: str
    several: bool
    has: str


VOICES: Mapping[Voice, Me] = {
    Voice.PLAIN: Me(
        does="we", object="us", own="our", its="ours", itself="ourselves", several=True, has="{goes} {kind}"
    ),
    Voice.PROTOCOL: Me(
        does="the SV",
        object="the SV",
        own="the SV's",
        its="the one of the SV",
        itself="itself",
        several=False,
        has="[are/is] {kind}",
    ),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Way:
    """How a route is told.

    Attributes:
        does: What the ego does; ``{goes}`` is the verb for its way of moving.
        paced: Whether a speed stands behind it; else it drives at that speed, and does this.
        at: The place that the words name already.
    """

    does: str
    paced: bool = False
    at: RoadKind | None = None


ROUTES: Mapping[EgoRoute, Way] = {
    EgoRoute.STRAIGHT: Way(does="{goes} straight ahead", paced=True),
    EgoRoute.LEFT_TURN: Way(does="[turn/turns/turning] left"),
    EgoRoute.RIGHT_TURN: Way(does="[turn/turns/turning] right"),
    EgoRoute.TURN: Way(does="[make/makes/making] a turn"),
    EgoRoute.U_TURN: Way(does="[make/makes/making] a U-turn"),
    EgoRoute.LANE_CHANGE_LEFT: Way(does="[change/changes/changing] lanes to the left"),
    EgoRoute.LANE_CHANGE_RIGHT: Way(does="[change/changes/changing] lanes to the right"),
    EgoRoute.LANE_CHANGE: Way(does="[change/changes/changing] lanes"),
    EgoRoute.BYPASS: Way(does="[swing/swings/swinging] out round what stands in {egos} lane"),
    EgoRoute.OVERTAKE: Way(does="[overtake/overtakes/overtaking]"),
    EgoRoute.MERGE: Way(does="[merge/merges/merging]"),
    EgoRoute.EXIT: Way(does="[leave/leaves/leaving] the road by a ramp", at=RoadKind.RAMP),
    EgoRoute.ROUNDABOUT: Way(does="{goes} through a roundabout", paced=True, at=RoadKind.ROUNDABOUT),
    EgoRoute.REVERSE: Way(does="{goes} backwards", paced=True),
    EgoRoute.LEAVE_PARKING: Way(does="[leave/leaves/leaving] a parking place"),
    EgoRoute.PARK: Way(does="[park/parks/parking]"),
    EgoRoute.ENTER_DRIVEWAY: Way(does="[turn/turns/turning] into a driveway"),
    EgoRoute.ENTER_DRIVEWAY_ACROSS: Way(does="[turn/turns/turning] across the road into a driveway"),
    EgoRoute.LEAVE_DRIVEWAY: Way(does="[come/comes/coming] out of a driveway"),
}

ROADS: Mapping[RoadKind, str] = {
    RoadKind.ROAD: "on a road between junctions",
    RoadKind.CURVE: "in a bend",
    RoadKind.LEFT_CURVE: "in a left-hand bend",
    RoadKind.RIGHT_CURVE: "in a right-hand bend",
    RoadKind.JUNCTION: "at a junction",
    RoadKind.THREE_WAY: "at a three-way junction",
    RoadKind.FOUR_WAY: "at a four-way junction",
    RoadKind.T_END: "on a road that ends at a junction",
    RoadKind.FORK: "at a fork",
    RoadKind.ROUNDABOUT: "at a roundabout",
    RoadKind.MINI_ROUNDABOUT: "at a mini roundabout",
    RoadKind.MOTORWAY: "on a motorway",
    RoadKind.RAMP: "on a ramp",
    RoadKind.PARKING_LOT: "in a car park",
    RoadKind.RAIL_CROSSING: "at a railway crossing",
}

SETTINGS: Mapping[Setting, str] = {
    Setting.TOWN: "in a town",
    Setting.RESIDENTIAL: "in a residential area",
    Setting.RURAL: "in the country",
}

CONTROLS: Mapping[RightOfWay, str] = {
    RightOfWay.SIGNAL: "there are traffic lights",
    RightOfWay.STOP_SIGN: "there is a stop sign",
    RightOfWay.YIELD_SIGN: "there is a give-way sign",
    RightOfWay.PRIORITY: "the side roads alone have signs",
    RightOfWay.NONE: "there are neither traffic lights nor signs",
}

EGO_LIGHTS: Mapping[EgoLight, str] = {
    EgoLight.GREEN: "is green",
    EgoLight.RED: "is red",
    EgoLight.YELLOW: "is yellow",
    EgoLight.TURNS_GREEN: "turns from red to green",
    EgoLight.TURNS_RED: "turns from green to red",
}

FEATURES: Mapping[Feature, str] = {
    Feature.CROSSWALK: "a crosswalk",
    Feature.BUS_STOP: "a bus stop",
    Feature.BUS_BAY: "a bus bay",
    Feature.PARKED_CARS: "parked cars along the kerb",
    Feature.PARKED_BOTH_SIDES: "parked cars along both kerbs",
    Feature.PARKING_PLACES: "parking places beside the lane",
    Feature.CYCLE_LANE: "a cycle lane",
    Feature.BUS_LANE: "a bus lane",
    Feature.TRAM_TRACK: "tram tracks",
    Feature.MEDIAN: "a median",
    Feature.SHOULDER: "a hard shoulder",
    Feature.DRIVEWAY: "a driveway",
    Feature.NARROW: "no room for two cars to pass each other",
    Feature.ROADWORKS: "roadworks",
    Feature.CLOSED_LANE: "cones that close our lane",
    Feature.LANE_DROP: "a lane that ends",
    Feature.ON_RAMP: "an on-ramp",
    Feature.OFF_RAMP: "an off-ramp",
    Feature.TURN_LANE: "a lane for turning",
    Feature.HILL: "a hill",
    Feature.SCHOOL: "a school beside it",
}

LIGHTS: Mapping[Light, str] = {
    Light.DAY: "it is daytime",
    Light.DUSK: "it is dusk",
    Light.NIGHT: "it is night",
}
WEATHERS: Mapping[Weather, str] = {
    Weather.CLEAR: "the weather is clear",
    Weather.RAIN: "it is raining",
    Weather.SNOW: "it is snowing",
    Weather.FOG: "it is foggy",
    Weather.OVERCAST: "the sky is overcast",
    Weather.DUST: "dust is in the air",
}
SURFACES: Mapping[Surface, str] = {
    Surface.DRY: "the road is dry",
    Surface.WET: "the road is wet",
    Surface.SNOW: "the road is covered with snow",
    Surface.ICE: "the road is icy",
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Noun:
    """What a kind is called.

    Attributes:
        somebody: Whether it is a person, whom nobody calls *it*.
        vehicle: Of such a person, what is driven or ridden, with its article.
    """

    one: str
    many: str
    goes: str
    somebody: bool = False
    vehicle: str = ""


_DRIVES, _RIDES = "[drive/drives/driving]", "[ride/rides/riding]"
_WALKS, _RUNS, _MOVES = "[walk/walks/walking]", "[run/runs/running]", "[move/moves/moving]"

_KINDS: Mapping[UserKind, Noun] = {
    UserKind.BUS: Noun(one="a bus", many="buses", goes=_DRIVES),
    UserKind.TRAM: Noun(one="a tram", many="trams", goes=_RUNS),
    UserKind.MOTORCYCLE: Noun(
        one="a motorcyclist", many="motorcyclists", goes=_RIDES, somebody=True, vehicle="a motorcycle"
    ),
    UserKind.BICYCLE: Noun(one="a cyclist", many="cyclists", goes=_RIDES, somebody=True, vehicle="a bicycle"),
    UserKind.E_SCOOTER: Noun(
        one="an e-scooter rider", many="e-scooter riders", goes=_RIDES, somebody=True, vehicle="an e-scooter"
    ),
    UserKind.CARGO_BIKE: Noun(
        one="a cargo-bike rider", many="cargo-bike riders", goes=_RIDES, somebody=True, vehicle="a cargo bike"
    ),
    UserKind.QUAD: Noun(one="a quad rider", many="quad riders", goes=_RIDES, somebody=True, vehicle="a quad bike"),
    UserKind.EMERGENCY_VEHICLE: Noun(one="an emergency vehicle", many="emergency vehicles", goes=_DRIVES),
    UserKind.VEHICLE: Noun(one="a vehicle", many="vehicles", goes=_DRIVES),
    UserKind.PEDESTRIAN: Noun(one="a pedestrian", many="pedestrians", goes=_WALKS, somebody=True),
    UserKind.CHILD: Noun(one="a child", many="children", goes=_WALKS, somebody=True),
    UserKind.WHEELCHAIR: Noun(one="a wheelchair user", many="wheelchair users", goes=_MOVES, somebody=True),
    UserKind.CAR_AND_TRAILER: Noun(one="a car with a trailer", many="cars with trailers", goes=_DRIVES),
    UserKind.TRACTOR_AND_TRAILER: Noun(one="a tractor with a trailer", many="tractors with trailers", goes=_DRIVES),
    UserKind.PRAM: Noun(one="a pram", many="prams", goes=_MOVES),
    UserKind.HORSE_RIDER: Noun(one="a horse rider", many="horse riders", goes=_RIDES, somebody=True),
    UserKind.SHEEP: Noun(one="a sheep", many="sheep", goes=_WALKS),
    UserKind.MOOSE: Noun(one="a moose", many="moose", goes=_RUNS),
    UserKind.DOG: Noun(one="a dog", many="dogs", goes=_RUNS),
    UserKind.DEER: Noun(one="a deer", many="deer", goes=_RUNS),
    UserKind.ANIMAL: Noun(one="an animal", many="animals", goes=_MOVES),
    UserKind.BALL: Noun(one="a ball", many="balls", goes="[roll/rolls/rolling]"),
    UserKind.OBJECT: Noun(one="an object", many="objects", goes=_MOVES),
    UserKind.DEBRIS: Noun(one="a piece of debris", many="pieces of debris", goes=_MOVES),
    UserKind.CONE: Noun(one="a traffic cone", many="traffic cones", goes=_MOVES),
    UserKind.BUS_SHELTER: Noun(one="a bus shelter", many="bus shelters", goes=_MOVES),
    UserKind.VENDING_MACHINE: Noun(one="a vending machine", many="vending machines", goes=_MOVES),
    UserKind.KIOSK: Noun(one="a kiosk", many="kiosks", goes=_MOVES),
    UserKind.CONTAINER: Noun(one="a container", many="containers", goes=_MOVES),
    UserKind.HEDGE: Noun(one="a hedge", many="hedges", goes=_MOVES),
    UserKind.BILLBOARD: Noun(one="a billboard", many="billboards", goes=_MOVES),
    UserKind.ROAD_USER: Noun(one="a road user", many="road users", goes=_MOVES, somebody=True),
}
_GOES = {Moves.DRIVES: _DRIVES, Moves.RIDES: _RIDES, Moves.WALKS: _WALKS, Moves.LIES: _MOVES}


def _as_its_body(kind: UserKind) -> Noun:
    """A kind as its body is called; who rides is a person."""
    noun = kind.row.body.row.noun
    rides = kind.moves is Moves.RIDES
    return Noun(one=with_article(noun), many=plural(noun), goes=_GOES[kind.moves], somebody=rides)


KINDS: Mapping[UserKind, Noun] = {kind: _KINDS.get(kind) or _as_its_body(kind) for kind in UserKind}

_BY_CLASS: Mapping[str, str] = {kind.scenic: noun.one for kind, noun in KINDS.items() if not kind.row.general}


def one_of(kind: UserKind) -> str:
    """One of a kind as messages call it: *a cyclist*, *an emergency vehicle*."""
    return KINDS[kind].one


def one_seen(kind: str) -> str:
    """One of what a track is of, by its class, in the same words: *an emergency vehicle*, *a phone box*."""
    return _BY_CLASS.get(kind) or one_of_class(kind)


def road_named(kind: RoadKind) -> str:
    """What a kind of road is called: *a motorway*, *a bend*."""
    return ROADS[kind].partition(" ")[2]


ROLES: Mapping[Role, str | None] = {
    Role.ADVERSARY: None,  # as everybody is of whom nothing else is told
    Role.SUPPORTING: "[are/is] not the danger",
    Role.HIDES: "only [block/blocks] the view",
}

NUMBERS = ("no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")
"""Numbers in words, from 0 on."""

SIDES: Mapping[Side, str] = {Side.LEFT: "left", Side.RIGHT: "right"}

_ON = "< on {egos} {side}>"
AHEAD, AWAY = "{distance} ahead", "{distance} away"
_AWAY, _IN_FRONT = f"<, {AWAY}>", f"<, {AHEAD}>"

PLACES: Mapping[Where, str] = {
    Where.AHEAD: "<{distance} >ahead of {ego} in {egos} lane",
    Where.AHEAD_BESIDE: f"<{{distance}} >ahead of {{ego}} in the next lane{_ON}",
    Where.BESIDE: f"beside {{ego}}{_ON}{_AWAY}",
    Where.BEHIND: "<{distance} >behind {ego} in {egos} lane",
    Where.BEHIND_BESIDE: f"<{{distance}} >behind {{ego}} in the next lane{_ON}",
    Where.ONCOMING: f"coming the other way{_AWAY}",
    Where.ONCOMING_IN_OUR_LANE: f"coming the other way in {{egos}} lane{_AWAY}",
    Where.ARM: f"on a side road of the junction{_ON}{_AWAY}",
    Where.ROADSIDE: f"at the roadside{_ON}{_IN_FRONT}",
    Where.KERB: f"at the kerb{_ON}{_IN_FRONT}",
    Where.DRIVEWAY: f"in a driveway{_ON}{_IN_FRONT}",
    Where.CROSSING: f"at a crosswalk in front of {{ego}}{_ON}{_AWAY}",
    Where.EXIT: "in {egos} new lane <{distance} >beyond the junction",
    Where.EXIT_CROSSING: f"at the crosswalk just after {{egos}} turn{_ON}<, {{distance}} beyond the junction>",
    Where.MEDIAN: f"on the median{_IN_FRONT}",
    Where.ON_RAMP: f"on an on-ramp{_ON}{_AWAY}",
    Where.OFF_RAMP: f"on an off-ramp{_AWAY}",
    Where.IN_ROUNDABOUT: f"in the roundabout{_AWAY}",
    Where.ROUNDABOUT_ENTRY: f"at another entry of the roundabout{_ON}{_AWAY}",
    Where.BUS_BAY: f"in a bus bay{_ON}{_IN_FRONT}",
}

FACINGS: Mapping[Facing, str] = {
    Facing.ALONG: "facing the same way as {ego}",
    Facing.AGAINST: "facing {ego}",
    Facing.ACROSS: "facing {egos} lane",
}

LATERAL_PHRASES = (
    "{offset} from the middle of its lane< on {egos} {side}>",
    "{edge} inside the edge of its lane< on {egos} {side}>",
    "in line with {overlap} of {egos} width< on {egos} {side}>",
    "{beyond} beside the lanes< on {egos} {side}>",
    "with {clearance} between it and {egos} side< on {egos} {side}>",
    "toward {egos} {side} of its lane",
)
"""Where across the road somebody is."""

MANNERS: Mapping[Manner, str] = {
    Manner.SUDDEN: "suddenly {does}",
    Manner.SLOW: "slowly {does}",
    Manner.FAST: "{does} fast",
    Manner.HARD: "{does} hard",
    Manner.SLIGHT: "{does} slightly",
    Manner.SLANTING: "{does} at a slant",
}
"""Before or behind what is done."""

BREACHES: Mapping[Breach, str] = {
    Breach.RED_LIGHT: "against a red light",
    Breach.STOP_SIGN: "without stopping at the stop sign",
    Breach.RIGHT_OF_WAY: "without giving way",
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Doing:
    """How an act is told; what was not said of it is left out.

    Attributes:
        does: The act itself, also where another deed waits for it.
        whom: Whom it is done to, where that stands behind the manner.
        speed: Its speed: ``{pace}`` is *at 50 km/h*, ``{speed}`` *50 km/h*.
    """

    does: str
    to: str = " to {egos} {to}"
    whom: str = ""
    speed: str = " {pace}"
    acceleration: str = " at {acceleration}"
    distance: str = " over {distance}"
    time: str = " for {time}"


_TO, _OVER, _BY = " to {speed}", " over {time}", " by {distance}"
_NEEDS = ", {time} from where {ego} [meet/meets/meeting] it"
_GAP, _GAP_IN_TIME = " with a gap of {distance}", " with a gap of {time}"

_ACTS: Mapping[Act, Doing] = {
    Act.STAND: Doing(does="[stand/stands/standing] still"),
    Act.GO_ALONG: Doing(does="{goes} along the road"),
    Act.GO_STRAIGHT: Doing(does="[go/goes/going] straight on", time=_NEEDS),
    Act.TURN_LEFT: Doing(does="[turn/turns/turning] left", time=_NEEDS),
    Act.TURN_RIGHT: Doing(does="[turn/turns/turning] right", time=_NEEDS),
    Act.U_TURN: Doing(does="[make/makes/making] a U-turn"),
    Act.CROSS: Doing(does="[cross/crosses/crossing] {egos} path"),
    Act.ENTER: Doing(does="[come/comes/coming] into {egos} lane"),
    Act.SET_OFF: Doing(does="[set/sets/setting] off", speed=" and [reach/reaches/reaching] {speed}"),
    Act.ACCELERATE: Doing(does="[accelerate/accelerates/accelerating]", speed=_TO, time=_OVER),
    Act.SLOW_DOWN: Doing(does="[slow/slows/slowing] down", speed=_TO, time=_OVER),
    Act.BRAKE: Doing(does="[brake/brakes/braking]", speed=_TO, time=_OVER),
    Act.STOP: Doing(does="[stop/stops/stopping]", distance=" within {distance}"),
    Act.HESITATE: Doing(does="[hesitate/hesitates/hesitating]"),
    Act.REVERSE: Doing(does="[back/backs/backing] up"),
    Act.PULL_OUT: Doing(does="[pull/pulls/pulling] out into {egos} lane"),
    Act.CUT_IN: Doing(does="[cut/cuts/cutting] in", whom=" ahead of {whom}", distance=_GAP, time=_GAP_IN_TIME),
    Act.LANE_CHANGE: Doing(does="[change/changes/changing] lanes", time=_OVER, distance=" within {distance}"),
    Act.CUT_OUT: Doing(does="[move/moves/moving] out of {egos} lane", time=_OVER),
    Act.MERGE: Doing(does="[merge/merges/merging] into {egos} lane", distance=_GAP, time=_GAP_IN_TIME),
    Act.OVERTAKE: Doing(does="[overtake/overtakes/overtaking] {whom}", distance=_GAP),
    Act.DRIFT: Doing(does="[drift/drifts/drifting]", time=_OVER, distance=_BY),
    Act.SWERVE: Doing(does="[swerve/swerves/swerving]", whom=" round {whom}", time=_OVER, distance=_BY),
    Act.WEAVE: Doing(does="[weave/weaves/weaving] from side to side"),
    Act.KEEP_LEVEL: Doing(does="[stay/stays/staying] level with {whom}"),
    Act.FOLLOW: Doing(
        does="[follow/follows/following] {whom}", distance=" at a distance of {distance}", time=_GAP_IN_TIME
    ),
    Act.TAILGATE: Doing(does="[tailgate/tailgates/tailgating] {whom}", distance=" at a distance of {distance}"),
    Act.TURN_BACK: Doing(does="[turn/turns/turning] back"),
    Act.PARK: Doing(does="[park/parks/parking]"),
    Act.LEAVE_ROAD: Doing(does="[leave/leaves/leaving] the road"),
    Act.EXIT: Doing(does="[take/takes/taking] the exit"),
    Act.YIELD: Doing(does="[give/gives/giving] way to {whom}"),
    Act.OPEN_DOOR: Doing(does="[open/opens/opening] a door", whom=" into the way of {whom}"),
    Act.DROP_LOAD: Doing(does="[drop/drops/dropping] something onto the road"),
    Act.LOSE_CONTROL: Doing(does="[lose/loses/losing] control and [spin/spins/spinning]"),
    Act.FALL: Doing(does="[fall/falls/falling] over"),
}


def _as_named(act: Act) -> Doing:
    """An act as it is named: a verb, and what follows it, as *flashes lights* of ``flash-lights``, or one verb."""
    verb, *others = (act.value,) if act.row.one_verb else act.value.split("-")
    forms = "/".join(inflected(verb))
    return Doing(does=" ".join((f"[{forms}]", *others, *(("{whom}",) if act.row.whom else ()))))


ACTS: Mapping[Act, Doing] = {act: _ACTS.get(act) or _as_named(act) for act in Act}

PARTS: Mapping[Part, str] = {
    Part.FRONT: "front",
    Part.LEFT_FRONT: "left front",
    Part.RIGHT_FRONT: "right front",
    Part.LEFT: "left side",
    Part.RIGHT: "right side",
    Part.REAR: "rear",
    Part.LEFT_REAR: "left rear",
    Part.RIGHT_REAR: "right rear",
}

STRIKERS: Mapping[Striker | None, str] = {
    Striker.EGO: "[run/runs/running] into",
    Striker.OTHER: "[run/runs/running] into",
    None: "[touch/touches/touching]",
}
"""What who runs into the other does; else what the ego does."""
