"""The words of a situation, each with its meaning: the tables from which schema, prompt and page are made.

A new word is a row here. What can be built of the words is a matter of `chatscene.build`; a word that cannot be built
yet is refused there by name.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import Enum, StrEnum
from functools import cache
from typing import TYPE_CHECKING, Any, Self, TypeVar

from chatscene.terms.actors import AdversaryKind
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.nouns import with_article

if TYPE_CHECKING:
    from collections.abc import Mapping

    from pydantic import GetJsonSchemaHandler
    from pydantic.json_schema import JsonSchemaValue
    from pydantic_core import CoreSchema


Fact = TypeVar("Fact")


class Word(StrEnum):
    """A word with its meaning.

    Attributes:
        meaning: What it says, in plain English, seen from the ego.
    """

    _value_: str
    meaning: str

    def __new__(cls, value: str, meaning: str = "") -> Self:
        """A member of a name, with its meaning."""
        word = str.__new__(cls, value)
        word._value_, word.meaning = value, meaning
        return word

    @classmethod
    def __get_pydantic_json_schema__(cls, schema: CoreSchema, handler: GetJsonSchemaHandler) -> JsonSchemaValue:
        """The words, and below them what they mean."""
        made = handler(schema)
        made["description"] = "\n".join(
            ((cls.__doc__ or "").split("\n", 1)[0], *(f"{word}: {word.meaning}" for word in cls if word.meaning))
        )
        return made


class RowWord(Word):
    """A word with its meaning and a row of what else holds of it."""

    row: Any

    def __new__(cls, value: str, meaning: str, row: Any) -> Self:
        """A member of a name, with its meaning and its row."""
        word = str.__new__(cls, value)
        word._value_, word.meaning, word.row = value, meaning, row
        return word


class Side(Word):
    """A side, as the ego sees it at its start."""

    LEFT = "left"
    RIGHT = "right"


# The ego and the road


class EgoRoute(Word):
    """The way the ego goes."""

    STRAIGHT = ("straight", "keeps its lane, and goes straight on at a junction")
    LEFT_TURN = ("left-turn", "turns left at a junction")
    RIGHT_TURN = ("right-turn", "turns right at a junction")
    TURN = ("turn", "turns at a junction, to a side not said")
    U_TURN = ("u-turn", "turns round")
    LANE_CHANGE_LEFT = ("lane-change-left", "changes to the lane on its left")
    LANE_CHANGE_RIGHT = ("lane-change-right", "changes to the lane on its right")
    LANE_CHANGE = ("lane-change", "changes lanes, to a side not said")
    BYPASS = ("bypass", "swings out round what stands in its lane, and comes back")
    OVERTAKE = ("overtake", "swings out, passes somebody who moves, and comes back")
    MERGE = ("merge", "comes onto a road from a ramp or from a lane that ends")
    EXIT = ("exit", "leaves a road by a ramp")
    ROUNDABOUT = ("roundabout", "goes through a roundabout")
    REVERSE = ("reverse", "drives backwards")
    LEAVE_PARKING = ("leave-parking", "leaves a parking place")
    PARK = ("park", "drives into a parking place")
    ENTER_DRIVEWAY = ("enter-driveway", "turns off the road into a driveway")
    ENTER_DRIVEWAY_ACROSS = ("enter-driveway-across", "the same, over the oncoming lane")
    LEAVE_DRIVEWAY = ("leave-driveway", "comes out of a driveway; with reverse, backwards")


CHANGES = frozenset((EgoRoute.LANE_CHANGE_LEFT, EgoRoute.LANE_CHANGE_RIGHT))
"""Ways that lead into the next lane."""


class RoadKind(Word):
    """What kind of road it is where the danger is."""

    ROAD = ("road", "a road between junctions, straight or nearly so")
    CURVE = ("curve", "a bend to a side not said, or just after it")
    LEFT_CURVE = ("left-curve", "a bend to the left")
    RIGHT_CURVE = ("right-curve", "a bend to the right")
    JUNCTION = ("junction", "a junction")
    THREE_WAY = ("three-way", "one with three arms")
    FOUR_WAY = ("four-way", "one with four arms")
    T_END = ("t-end", "a T; the ego comes up its stem")
    FORK = ("fork", "a fork")
    ROUNDABOUT = ("roundabout", "a roundabout")
    MINI_ROUNDABOUT = ("mini-roundabout", "a mini roundabout")
    MOTORWAY = ("motorway", "a road like one, too: several lanes one way, no junctions")
    RAMP = ("ramp", "a road that leads onto a motorway or off it")
    PARKING_LOT = ("parking-lot", "ways between parking places")
    RAIL_CROSSING = ("rail-crossing", "where rails cross the road")


ROUNDABOUTS = frozenset((RoadKind.ROUNDABOUT, RoadKind.MINI_ROUNDABOUT))
ENDS_THERE = frozenset((RoadKind.T_END, RoadKind.FORK))
"""Junctions at which one cannot go straight on."""
ARMS_OF = {RoadKind.THREE_WAY: 3, RoadKind.T_END: 3, RoadKind.FORK: 3, RoadKind.FOUR_WAY: 4}
"""How many arms a kind of junction has."""


class Setting(Word):
    """What lies about the road."""

    TOWN = ("town", "houses; about 50 km/h")
    RESIDENTIAL = ("residential", "a quiet street between houses; about 30 km/h")
    RURAL = ("rural", "fields or woods; a lane each way, no sidewalk, about 100 km/h")


class RightOfWay(Word):
    """What rules a junction."""

    SIGNAL = ("signal", "traffic lights")
    STOP_SIGN = ("stop-sign", "a stop sign")
    YIELD_SIGN = ("yield-sign", "a sign to give way")
    PRIORITY = ("priority", "signs on the side roads alone")
    NONE = ("none", "neither lights nor signs")


class EgoLight(Word):
    """The traffic light that the ego has, as it comes near."""

    GREEN = ("green", "green")
    RED = ("red", "red")
    YELLOW = ("yellow", "yellow")
    TURNS_GREEN = ("turns-green", "red, and green while it happens")
    TURNS_RED = ("turns-red", "green, and red while it happens")


class Feature(Word):
    """Something that the road has there."""

    CROSSWALK = ("crosswalk", "a marked crossing for people on foot")
    BUS_STOP = ("bus-stop", "a bus stop at the edge of the lane")
    BUS_BAY = ("bus-bay", "a bus stop in a bay beside the lane")
    PARKED_CARS = ("parked-cars", "a row of parked cars along the kerb")
    PARKED_BOTH_SIDES = ("parked-both-sides", "the same along both kerbs")
    PARKING_PLACES = ("parking-places", "places to park in, beside the lane")
    CYCLE_LANE = ("cycle-lane", "a lane for bicycles")
    BUS_LANE = ("bus-lane", "a bus lane")
    TRAM_TRACK = ("tram-track", "rails in the road")
    MEDIAN = ("median", "grass or a barrier between the directions")
    SHOULDER = ("shoulder", "a hard shoulder")
    DRIVEWAY = ("driveway", "a driveway, an alley, a gate or a track off the road")
    NARROW = ("narrow", "no room for two cars abreast")
    ROADWORKS = ("roadworks", "a work zone that narrows the road")
    CLOSED_LANE = ("closed-lane", "cones that close the ego's lane ahead, or the lane in which it stands")
    LANE_DROP = ("lane-drop", "a lane that ends")
    ON_RAMP = ("on-ramp", "a ramp that joins the road")
    OFF_RAMP = ("off-ramp", "a ramp that leaves the road")
    TURN_LANE = ("turn-lane", "a turn lane")
    HILL = ("hill", "a slope or a crest")
    SCHOOL = ("school", "a school, or a sign for one")


# Who there is

WHEELS = frozenset((Moves.DRIVES, Moves.RIDES))


@dataclass(frozen=True, slots=True, kw_only=True)
class KindRow:
    """What a kind of road user is built as.

    Attributes:
        body: The kind of the world that is built.
        general: Whether the word leaves open what it is.
        prop: The class of the world that is built in place of that of its body, which says how it moves.
        rolls: Whether it is a thing that may roll or be blown.
    """

    body: AdversaryKind
    general: bool = False
    prop: str = ""
    rolls: bool = False


def _is(kind: AdversaryKind) -> KindRow:
    return KindRow(body=kind)


def _as_body(kind: AdversaryKind) -> tuple[str, str, KindRow]:
    """A kind that is called as its body is."""
    return (kind.value, with_article(kind.row.noun), _is(kind))


def _thing(prop: str) -> KindRow:
    return KindRow(body=AdversaryKind.BOX, prop=prop)


class UserKind(RowWord):
    """What kind of road user it is."""

    row: KindRow

    CAR = ("car", "a passenger car, an SUV, a taxi", _is(AdversaryKind.CAR))
    VAN = ("van", "a van, a camper", _is(AdversaryKind.VAN))
    TRUCK = ("truck", "a lorry without a trailer", _is(AdversaryKind.TRUCK))
    SEMI_TRAILER = ("semi-trailer", "a truck with a trailer", _is(AdversaryKind.SEMI_TRAILER))
    BUS = ("bus", "a bus or a coach", _is(AdversaryKind.BUS))
    ARTICULATED_BUS = _as_body(AdversaryKind.ARTICULATED_BUS)
    PICKUP = _as_body(AdversaryKind.PICKUP)
    CAR_AND_TRAILER = (
        "car-and-trailer",
        "a caravan, a car with a trailer",
        _is(AdversaryKind.CAR_AND_TRAILER),
    )
    MINIBUS = ("minibus", "a matatu, a jeepney", _is(AdversaryKind.MINIBUS))
    TRACTOR = ("tractor", "a farm tractor", _is(AdversaryKind.TRACTOR))
    TRACTOR_AND_TRAILER = (
        "tractor-and-trailer",
        "a tractor and trailer",
        _is(AdversaryKind.TRACTOR_AND_TRAILER),
    )
    HARVESTER = ("harvester", "a harvester", _is(AdversaryKind.HARVESTER))
    CART = ("cart", "a cart that an animal draws", _is(AdversaryKind.CART))
    TRAM = _as_body(AdversaryKind.TRAM)
    MOTORCYCLE = ("motorcycle", "a motorcycle, a moped, a motor scooter", _is(AdversaryKind.MOTORCYCLE))
    AUTO_RICKSHAW = (
        "auto-rickshaw",
        "a tuk-tuk, a motor tricycle",
        _is(AdversaryKind.AUTO_RICKSHAW),
    )
    QUAD = ("quad", "a quad", _is(AdversaryKind.QUAD))
    BICYCLE = ("bicycle", "somebody on a bicycle, electric or not", _is(AdversaryKind.BICYCLE))
    CARGO_BIKE = ("cargo-bike", "a cargo bike, a cycle rickshaw", _is(AdversaryKind.CARGO_BIKE))
    E_SCOOTER = ("e-scooter", "somebody who stands on an electric scooter", _is(AdversaryKind.E_SCOOTER))
    EMERGENCY_VEHICLE = (
        "emergency-vehicle",
        "an ambulance, another with a siren",
        _is(AdversaryKind.EMERGENCY_VEHICLE),
    )
    POLICE_CAR = _as_body(AdversaryKind.POLICE_CAR)
    FIRE_ENGINE = _as_body(AdversaryKind.FIRE_ENGINE)
    VEHICLE = ("vehicle", "a motor vehicle, not said of which kind", KindRow(body=AdversaryKind.CAR, general=True))
    PEDESTRIAN = ("pedestrian", "a grown-up on foot", _is(AdversaryKind.PEDESTRIAN))
    CHILD = ("child", "a child on foot", _is(AdversaryKind.CHILD))
    PRAM = ("pram", "somebody with a pram, a trolley", _is(AdversaryKind.PRAM))
    WHEELCHAIR = ("wheelchair", "somebody in a wheelchair", _is(AdversaryKind.WHEELCHAIR))
    HORSE_RIDER = ("horse-rider", "a rider on a horse", _is(AdversaryKind.HORSE_RIDER))
    HORSE = ("horse", "a horse", _is(AdversaryKind.HORSE))
    COW = ("cow", "a cow, a bull, a buffalo", _is(AdversaryKind.COW))
    SHEEP = ("sheep", "a sheep, a goat", _is(AdversaryKind.SHEEP))
    DOG = _as_body(AdversaryKind.DOG)
    SMALL_ANIMAL = ("small-animal", "a cat, a fox, a bird", _is(AdversaryKind.SMALL_ANIMAL))
    DEER = ("deer", "a deer", _is(AdversaryKind.DEER))
    MOOSE = ("moose", "a moose, a camel", _is(AdversaryKind.MOOSE))
    BOAR = ("boar", "a wild boar, a pig", _is(AdversaryKind.BOAR))
    KANGAROO = _as_body(AdversaryKind.KANGAROO)
    ANIMAL = ("animal", "an animal, not said of which kind", KindRow(body=AdversaryKind.DEER, general=True))
    BALL = ("ball", "a ball that rolls", KindRow(body=AdversaryKind.DOG, prop="Ball"))
    OBJECT = (
        "object",
        "a thing on the road, not said which",
        KindRow(body=AdversaryKind.BOX, general=True, rolls=True),
    )
    DEBRIS = ("debris", "a lost load, a branch, rubble", KindRow(body=AdversaryKind.DEBRIS, rolls=True))
    CONE = ("cone", "a traffic cone or a barrier", _is(AdversaryKind.CONE))
    BUS_SHELTER = ("bus-shelter", "a bus stop with a roof", _thing("BusStop"))
    VENDING_MACHINE = ("vending-machine", "a vending machine, a cabinet", _thing("VendingMachine"))
    KIOSK = ("kiosk", "a kiosk, a booth, a hut", _thing("Kiosk"))
    CONTAINER = ("container", "a container, a skip", _thing("Container"))
    HEDGE = ("hedge", "a hedge, a fence, a wall", _thing("Hedge"))
    BILLBOARD = ("billboard", "a billboard, an advertising column", _thing("Billboard"))
    ROAD_USER = ("road-user", "somebody, not said on what", KindRow(body=AdversaryKind.CAR, general=True))

    @property
    def moves(self) -> Moves:
        """How it moves."""
        return self.row.body.row.manner

    @property
    def may_be_ego(self) -> bool:
        """Whether an ego may be said to be one: it drives or rides, and the word says what it is."""
        return self.moves in WHEELS and not self.row.general

    @property
    def is_animal(self) -> bool:
        """Whether it is an animal, and nobody on one."""
        return self.row.body.row.openscenario == "animal" and not self.row.prop

    def can(self, act: Act) -> bool:
        """Whether one of the kind can do something."""
        return self.moves in act.row.by or (self.row.rolls and act in ROLLING)

    @property
    def scenic(self) -> str:
        """The class of the world that it is built as."""
        return self.row.prop or self.row.body.row.scenic


class Role(Word):
    """What somebody is there for."""

    ADVERSARY = ("adversary", "who meets the ego, or would; one at least")
    SUPPORTING = ("supporting", "who is needed for it, but is not met: a leader, traffic that closes the way")
    HIDES = ("hides", "what only hides somebody at first, also traffic that queues or passes")


@dataclass(frozen=True, slots=True, kw_only=True)
class WhereRow:
    """What holds of a start.

    Attributes:
        sided: Whether it has a side, said or not.
        sides: Of a place that need not have one, the sides that may be said of it.
        junction: Whether it is one of a junction.
    """

    sided: bool = False
    sides: tuple[Side, ...] = ()
    junction: bool = False


class Where(RowWord):
    """Where somebody is when it begins, seen from the ego."""

    row: WhereRow

    AHEAD = ("ahead", "in the ego's own lane, in front of it", WhereRow())
    AHEAD_BESIDE = ("ahead-beside", "in the next lane of the same direction, in front", WhereRow(sided=True))
    BESIDE = ("beside", "level with the ego, in the next lane or at the edge of its own", WhereRow(sided=True))
    BEHIND = ("behind", "in the ego's own lane, behind it", WhereRow())
    BEHIND_BESIDE = ("behind-beside", "in the next lane of the same direction, behind", WhereRow(sided=True))
    ONCOMING = ("oncoming", "comes the other way, in its own lane or, at a junction, from the arm opposite", WhereRow())
    ONCOMING_IN_OUR_LANE = ("oncoming-in-our-lane", "comes the other way in the ego's own lane", WhereRow())
    ARM = ("arm", "on an arm to the side of the junction", WhereRow(sided=True, junction=True))
    ROADSIDE = ("roadside", "beside the road in front, on foot, on two wheels or an animal", WhereRow(sided=True))
    KERB = ("kerb", "a vehicle that stands at the edge of the road (kerb, curb), in front", WhereRow(sided=True))
    DRIVEWAY = ("driveway", "in a driveway, an alley or a gate, in front", WhereRow(sided=True))
    CROSSING = ("crossing", "at a crosswalk over the ego's own road, in front", WhereRow(sided=True))
    EXIT = ("exit", "in the lane that the ego turns into, behind the junction", WhereRow(junction=True))
    EXIT_CROSSING = (
        "exit-crossing",
        "at the crosswalk of the road that the ego turns into; the side as the ego comes to it",
        WhereRow(sided=True, junction=True),
    )
    MEDIAN = ("median", "between the two directions, in front", WhereRow())
    ON_RAMP = ("on-ramp", "on a ramp that joins the ego's road", WhereRow(sides=(Side.RIGHT,)))
    OFF_RAMP = ("off-ramp", "on a ramp that leaves the ego's road", WhereRow())
    IN_ROUNDABOUT = ("in-roundabout", "goes round in the roundabout", WhereRow(junction=True))
    ROUNDABOUT_ENTRY = (
        "roundabout-entry",
        "at another entry of the roundabout",
        WhereRow(sides=(Side.LEFT, Side.RIGHT), junction=True),
    )
    BUS_BAY = ("bus-bay", "in a bus bay beside the lane, in front", WhereRow(sides=(Side.RIGHT,)))


NOSE_TO_TAIL = frozenset((Where.AHEAD, Where.AHEAD_BESIDE, Where.BEHIND, Where.BEHIND_BESIDE))
"""Places of which a distance is the gap between the two bodies; of all others it is between their middles."""
BEYOND_JUNCTION = frozenset((Where.EXIT, Where.EXIT_CROSSING))
"""Places that are named by the junction behind which they lie: a distance is from there, and not from the ego."""


class Facing(Word):
    """Which way somebody faces who is beside or on the road."""

    ALONG = ("along", "the way the ego goes")
    AGAINST = ("against", "the other way, toward the ego")
    ACROSS = ("across", "toward the ego's lane")


class Breach(Word):
    """A rule that somebody breaks by what is done."""

    RED_LIGHT = ("red-light", "goes on red")
    STOP_SIGN = ("stop-sign", "does not stop at a stop sign")
    RIGHT_OF_WAY = ("right-of-way", "does not give way")


class Tempo(Enum):
    """What comes of the speed of somebody by an act."""

    ANY = "nothing that holds of every such act"
    STANDS = "it stands from the beginning"
    WAITS = "it stands until another has gone by"
    HALTS = "it comes to a stand"
    LIES = "it comes to lie"
    BRAKES = "it loses speed hard, and may come to a stand"
    SLOWS = "it loses speed, and drives on"
    PAUSES = "it stands or nearly so for a while, and goes on"
    BACKS = "it moves backwards"
    GAINS = "it gains speed"
    SETS_OFF = "it begins to move"


class Heads(Enum):
    """Where somebody heads by an act: along the road, or across its lanes."""

    ANY = "where it was going"
    ALONG = "along the road"
    THROUGH = "straight on through a junction"
    BEHIND = "behind another, at a distance"
    CLOSE = "close behind another"
    LEVEL = "level with another"
    BY = "past another"
    ACROSS = "from beside the ego's way to the other side of it"
    IN = "from beside the ego's lane into that"
    FROM_EDGE = "from where it stood at the edge into the ego's lane"
    BEFORE = "from the next lane into the ego's, close in front"
    MERGES = "from a ramp or a lane that ends into the ego's lane"
    OVER = "from one lane into the next"
    OUT = "out of the ego's lane"
    OFF = "off the road"
    EDGE = "to a stand at the edge of the road, or beside it"
    ASIDE = "aside of its line, abruptly"
    DRIFTS = "aside of its line, gradually"
    SWINGS = "to one side of its line and to the other"
    TURNS = "to a side, off the road or at a junction"
    ROUND = "round, to the other direction"
    BACK = "back to where it came from"


@dataclass(frozen=True, slots=True, kw_only=True)
class ActRow:
    """What holds of an act.

    What holds of every act of a tempo or a heading holds of this one: what it is told from, where it can begin, what a
    contact with it is like. `acts_of` gives them.

    Attributes:
        by: How those move who may do it.
        ego: Whether the ego may be told to.
        sided: Whether it may be to a side.
        whom: Whether it is done to somebody, who is the ego unless another is named.
        takes: The amounts that it may have, by their names in `Deed`.
        placed: Whether it may be said where across the road it then goes on.
        lasting: Whether it goes on until something else begins, so that nothing shows when it is done.
        tempo: What comes of its speed.
        heads: Where somebody heads by it.
        lets_go: Whether it lets go of a body of its own by it: what that is called. It is named so: ``A-door``.
        one_verb: Whether all of its name is the verb, as *brake-checks* of ``brake-check`` would be; else its first
            word is, as *pumps brakes* of ``pump-brakes``. It is told so if it has no phrase.
    """

    by: frozenset[Moves]
    ego: bool = False
    sided: bool = False
    whom: bool = False
    takes: frozenset[str] = frozenset()
    placed: bool = False
    lasting: bool = False
    tempo: Tempo = Tempo.ANY
    heads: Heads = Heads.ANY
    lets_go: str = ""
    one_verb: bool = False


_FEET = frozenset((Moves.WALKS,))
_ALL = WHEELS | _FEET
_THINGS = _ALL | {Moves.LIES}


def _act(by: frozenset[Moves], takes: str, how: Tempo | Heads | None, **flags: Any) -> ActRow:
    if how is not None:
        flags["tempo" if isinstance(how, Tempo) else "heads"] = how
    return ActRow(by=by, takes=frozenset(takes.split()), **flags)


class Act(RowWord):
    """What somebody does."""

    row: ActRow

    STAND = ("stand", "stands from the beginning", _act(_THINGS, "time", Tempo.STANDS, ego=True, lasting=True))
    GO_ALONG = (
        "go-along",
        "goes along the road: in its lane, at its edge, on foot as well",
        _act(_ALL, "speed time distance", Heads.ALONG, ego=True, lasting=True, placed=True),
    )
    GO_STRAIGHT = (
        "go-straight",
        "goes straight on through a junction",
        _act(WHEELS, "speed acceleration time", Heads.THROUGH, lasting=True),
    )
    TURN_LEFT = (
        "turn-left",
        "turns to its own left at a junction, off the road, out of a driveway",
        _act(WHEELS, "speed acceleration time", Heads.TURNS),
    )
    TURN_RIGHT = (
        "turn-right",
        "the same to its own right",
        _act(WHEELS, "speed acceleration time", Heads.TURNS),
    )
    U_TURN = ("u-turn", "turns round on the road", _act(WHEELS, "speed", Heads.ROUND))
    CROSS = (
        "cross",
        "crosses the ego's way from beside the road to the other side",
        _act(_ALL, "speed", Heads.ACROSS, sided=True),
    )
    ENTER = (
        "enter",
        "comes into the ego's lane from beside the road, and stays in it",
        _act(_ALL, "speed", Heads.IN, placed=True),
    )
    SET_OFF = ("set-off", "starts to move after it stood", _act(_ALL, "speed acceleration", Tempo.SETS_OFF, ego=True))
    ACCELERATE = ("accelerate", "gains speed", _act(_ALL, "speed acceleration time distance", Tempo.GAINS, ego=True))
    SLOW_DOWN = ("slow-down", "loses speed gently", _act(_ALL, "speed acceleration time", Tempo.SLOWS, ego=True))
    BRAKE = ("brake", "loses speed hard", _act(_ALL, "speed acceleration time", Tempo.BRAKES, ego=True))
    STOP = (
        "stop",
        "was moving, and comes to a standstill",
        _act(_ALL, "acceleration time distance", Tempo.HALTS, ego=True),
    )
    HESITATE = ("hesitate", "pauses, and goes on", _act(_ALL, "time", Tempo.PAUSES))
    REVERSE = ("reverse", "moves backwards", _act(_ALL, "speed time distance", Tempo.BACKS, ego=True))
    PULL_OUT = (
        "pull-out",
        "leaves where it stood at the edge for the ego's lane",
        _act(WHEELS, "speed acceleration", Heads.FROM_EDGE, placed=True),
    )
    CUT_IN = (
        "cut-in",
        "comes from the next lane into the ego's, close in front",
        _act(WHEELS, "speed distance time", Heads.BEFORE, sided=True, whom=True, placed=True),
    )
    LANE_CHANGE = (
        "lane-change",
        "changes lanes in any other way",
        _act(WHEELS, "speed time distance", Heads.OVER, ego=True, sided=True, placed=True),
    )
    CUT_OUT = (
        "cut-out",
        "leaves the ego's lane, and so shows what is ahead",
        _act(WHEELS, "speed time", Heads.OUT, sided=True),
    )
    MERGE = (
        "merge",
        "comes from a ramp or a lane that ends into the ego's lane",
        _act(WHEELS, "speed distance time", Heads.MERGES, placed=True),
    )
    OVERTAKE = (
        "overtake",
        "passes somebody and is ahead then",
        _act(WHEELS, "speed distance", Heads.BY, ego=True, sided=True, whom=True, placed=True),
    )
    DRIFT = (
        "drift",
        "leaves its line gradually, not meaning to",
        _act(WHEELS, "speed time distance", Heads.DRIFTS, ego=True, sided=True, placed=True),
    )
    SWERVE = (
        "swerve",
        "leaves its line abruptly",
        _act(_ALL, "speed time distance", Heads.ASIDE, ego=True, sided=True, placed=True),
    )
    WEAVE = ("weave", "swings from side to side", _act(_ALL, "speed time", Heads.SWINGS))
    KEEP_LEVEL = (
        "keep-level",
        "stays level with somebody",
        _act(WHEELS, "time", Heads.LEVEL, whom=True, lasting=True),
    )
    FOLLOW = (
        "follow",
        "drives behind somebody at a distance",
        _act(WHEELS, "speed distance time", Heads.BEHIND, ego=True, whom=True, lasting=True),
    )
    TAILGATE = (
        "tailgate",
        "drives close behind somebody",
        _act(WHEELS, "distance time", Heads.CLOSE, whom=True, lasting=True),
    )
    TURN_BACK = ("turn-back", "goes back to where it came from", _act(_ALL, "speed", Heads.BACK))
    PARK = (
        "park",
        "comes to a stand at the edge of the road or in a parking place",
        _act(WHEELS, "speed", Heads.EDGE, ego=True),
    )
    LEAVE_ROAD = (
        "leave-road",
        "goes off the road to a stand: onto its shoulder or verge, into a ditch",
        _act(WHEELS, "", Heads.EDGE, ego=True, sided=True),
    )
    EXIT = ("exit", "leaves the road by a ramp, or a roundabout", _act(WHEELS, "speed", Heads.OFF))
    YIELD = ("yield", "waits until somebody has gone by", _act(_ALL, "", Tempo.WAITS, ego=True, whom=True))
    OPEN_DOOR = (
        "open-door",
        "opens a door into somebody's way",
        _act(frozenset((Moves.DRIVES,)), "", None, sided=True, whom=True, lets_go="door"),
    )
    DROP_LOAD = (
        "drop-load",
        "loses something onto the road",
        _act(frozenset((Moves.DRIVES,)), "", None, lets_go="load"),
    )
    LOSE_CONTROL = (
        "lose-control",
        "spins or skids to a stand",
        _act(WHEELS, "", Tempo.LIES, sided=True),
    )
    FALL = (
        "fall",
        "falls, on foot or on two wheels, and lies there",
        _act(_FEET | {Moves.RIDES}, "", Tempo.LIES),
    )


@cache
def acts_of(*traits: Tempo | Heads) -> frozenset[Act]:
    """The acts of which one of some traits holds."""
    return frozenset(act for act in Act if act.row.tempo in traits or act.row.heads in traits)


def by_act(rows: Mapping[Any, Fact]) -> dict[Act, Fact]:
    """What holds of acts: of each what its own row says, else that of its heading, else that of its tempo.

    Args:
        rows: What holds of an act, a heading or a tempo. Acts of which no row says anything are left out.
    """
    found = ((act, next((key for key in (act, act.row.heads, act.row.tempo) if key in rows), None)) for act in Act)
    return {act: rows[key] for act, key in found if key is not None}


LETS_GO = {act: act.row.lets_go for act in Act if act.row.lets_go}
"""Acts by which somebody lets go of a body of its own, which is named after it: ``A-door``."""
SLOWS = acts_of(Tempo.SLOWS, Tempo.BRAKES, Tempo.HALTS)
"""What is done to be slower, or to stand."""
LOSES = SLOWS | acts_of(Tempo.PAUSES)
"""The same, with what is done for a while."""
STOPS = acts_of(Tempo.HALTS, Tempo.BRAKES)
"""What may bring somebody to a stand who is under way."""
HALTS = acts_of(Tempo.STANDS, Tempo.HALTS)
"""By what somebody stands, and nothing else."""
RESTS = HALTS | acts_of(Tempo.PAUSES)
"""The same, with what is done for a while."""
ENDS = STOPS | acts_of(Tempo.LIES)
"""By which somebody who is under way comes to rest where it then is."""
WAITING = acts_of(Tempo.STANDS, Tempo.WAITS)
"""What somebody does who stands as it begins, for good or until something happens."""
GOES_ON = acts_of(Heads.ALONG, Heads.BEHIND)
"""What somebody does who drives on in its lane."""
PLAIN = acts_of(Heads.ALONG, Heads.THROUGH)
"""What somebody does of whom nothing else is said."""
ASIDE = acts_of(Heads.ASIDE, Heads.DRIFTS)
"""What leads somebody aside of its line."""
SWINGS = acts_of(Heads.SWINGS)
"""What leads somebody to both sides of its line."""
SIDEWAYS = ASIDE | SWINGS | acts_of(Heads.BEFORE, Heads.MERGES, Heads.OVER, Heads.OUT)
"""What is done by moving to a side on the road."""
GLIDES = SIDEWAYS - SWINGS - acts_of(Heads.ASIDE)
"""The same, with what is not abrupt."""
ALONG_THE_ROAD = SIDEWAYS | LOSES | acts_of(Heads.BY, Tempo.GAINS)
"""What somebody does who stays on its road: how near one is then who comes against the ego, is how soon they meet."""
ROLLING = acts_of(Heads.ACROSS, Heads.IN)
"""What a thing does that rolls or is blown."""
COMES_IN = acts_of(Heads.ACROSS, Heads.IN, Heads.FROM_EDGE)
"""What is done by whoever is outside the ego's lane and comes into it: begun before, and done when it is in."""
KEEPS_UP = acts_of(Heads.BY, Heads.BEFORE, Heads.LEVEL, Heads.BEHIND, Heads.CLOSE)
"""What somebody does who is as fast as another, or faster."""
OVER_A_LINE = acts_of(Heads.OVER, Heads.OUT)
"""What leads from a lane to another one, whoever is in that."""
COMES_OVER = acts_of(Heads.OVER, Heads.BEFORE, Heads.MERGES, Heads.IN)
"""How somebody comes over to another lane; who gets out of a lane does so before what stands in it."""
INTO_OURS = COMES_OVER | acts_of(Heads.FROM_EDGE)
"""The same, also from the side of the road."""
FOR_SOMEBODY = (
    SLOWS
    | ASIDE
    | GOES_ON
    | OVER_A_LINE
    | acts_of(Tempo.STANDS, Tempo.PAUSES, Tempo.BACKS, Tempo.GAINS, Tempo.SETS_OFF, Heads.BACK)
) - frozenset(act for act in Act if act.row.whom)
"""Acts that are done to nobody, and may be done for somebody who is named: who is let by, or gone round."""


class Manner(Word):
    """How a deed is done, where that is said without a number."""

    SUDDEN = ("sudden", "without warning")
    SLOW = ("slow", "slowly")
    FAST = ("fast", "fast")
    HARD = ("hard", "with force")
    SLIGHT = ("slight", "a little")
    SLANTING = ("slanting", "at a slant, forward as well as across")


class Part(Word):
    """A part of a road user, seen from its own seat."""

    FRONT = "front"
    LEFT_FRONT = "left-front"
    RIGHT_FRONT = "right-front"
    LEFT = "left"
    RIGHT = "right"
    REAR = "rear"
    LEFT_REAR = "left-rear"
    RIGHT_REAR = "right-rear"


NOSE = 0.5  # [m] behind the foremost point of somebody that are its nose
SIDES_OF: dict[Part, tuple[str, ...]] = {
    Part.FRONT: ("front",),
    Part.REAR: ("rear",),
    Part.LEFT: ("left",),
    Part.RIGHT: ("right",),
    Part.LEFT_FRONT: ("front", "left"),
    Part.RIGHT_FRONT: ("front", "right"),
    Part.LEFT_REAR: ("rear", "left"),
    Part.RIGHT_REAR: ("rear", "right"),
}
"""For each part of somebody, the sides on which a contact with it may be."""


class Striker(Word):
    """Who runs into whom."""

    EGO = ("ego", "the ego runs into the other")
    OTHER = ("other", "the other runs into the ego")
