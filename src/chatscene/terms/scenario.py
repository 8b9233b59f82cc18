"""Base scenario, scenario, component, and the slots a sentence fills.

Paper: section 3.1 (notations), appendix A (components).
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass, field, fields
from enum import StrEnum
from typing import TYPE_CHECKING, cast

from chatscene.errors import OfferedReading
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.situation import Situation
from chatscene.terms.surroundings import Surroundings

if TYPE_CHECKING:
    from chatscene.terms.frame import Frame, Note, Word


class BaseScenario(StrEnum):
    """The eight base scenarios, in the column order of the paper's tables."""

    STRAIGHT_OBSTACLE = "straight-obstacle"
    TURNING_OBSTACLE = "turning-obstacle"
    LANE_CHANGING = "lane-changing"
    VEHICLE_PASSING = "vehicle-passing"
    RED_LIGHT_RUNNING = "red-light-running"
    UNPROTECTED_LEFT_TURN = "unprotected-left-turn"
    RIGHT_TURN = "right-turn"
    CROSSING_NEGOTIATION = "crossing-negotiation"


class Component(StrEnum):
    """The three parts of a scenario that are retrieved (paper, section 3.1)."""

    BEHAVIOR = "behavior"
    GEOMETRY = "geometry"
    SPAWN = "spawn"


class Side(StrEnum):
    """A side of the ego, in the ego's own frame at its start."""

    LEFT = "left"
    RIGHT = "right"


class Position(StrEnum):
    """Where the adversary starts, in the ego's frame."""

    AHEAD = "ahead"  # in front, in the ego's own lane
    ROADSIDE = "roadside"  # in front, beside the road
    BESIDE = "beside"  # level with the ego, in a neighbouring lane
    AHEAD_BESIDE = "ahead-beside"  # further on, in a neighbouring lane
    BEHIND = "behind"
    BEHIND_BESIDE = "behind-beside"
    ONCOMING = "oncoming"  # facing the ego, in an opposing lane or the opposite arm
    CROSSING = "crossing"  # on an arm to the side of a junction
    FAR_CORNER = "far-corner"  # at the side of the road the ego turns into
    KERB = "kerb"  # a vehicle standing at the edge of the road, ahead
    BEYOND = "beyond"  # in the lane that the ego comes into, just behind its junction


WAITING = (Position.ROADSIDE, Position.FAR_CORNER, Position.KERB)  # beside the road, until the ego comes near
NEAR, FAR = 20.0, 35.0  # [m] at most, at least
NEAR_ONCOMING = 2 * NEAR  # [m]: both close in


class Distance(StrEnum):
    """How far from the ego the adversary starts; where it waits, also where it sets out and comes into the lane."""

    NEAR = "near"
    FAR = "far"

    def bounds(self, position: Position | None) -> tuple[float, float]:
        """From where to where [m] an adversary that starts at a position counts as near or far."""
        if self is Distance.FAR:
            return FAR, math.inf
        return 0.0, NEAR_ONCOMING if position is Position.ONCOMING else NEAR


class Occluder(StrEnum):
    """What hides the adversary at first."""

    BUS_STOP = "bus-stop"
    VENDING_MACHINE = "vending-machine"
    PARKED_CAR = "parked-car"
    PARKED_TRUCK = "parked-truck"
    KIOSK = "kiosk"
    CONTAINER = "container"
    PARKED_BUS = "parked-bus"
    HEDGE = "hedge"  # or a fence, a wall
    BILLBOARD = "billboard"  # or an advertising column


class Maneuver(StrEnum):
    """What the ego's route does."""

    STRAIGHT = "straight"
    LEFT_TURN = "left-turn"
    RIGHT_TURN = "right-turn"
    LANE_CHANGE_LEFT = "lane-change-left"
    LANE_CHANGE_RIGHT = "lane-change-right"
    BYPASS = "bypass"  # around a blocker through the opposite lane


class EgoState(StrEnum):
    """What the ego does at the pedals while it drives its route, as a text says it; else its policy decides."""

    STANDS = "stands"  # at a light, in a queue, broken down: all the time
    SETS_OFF = "sets-off"  # stands at first, and drives then
    SLOW = "slow"  # drives slowly all the time
    SLOWS_DOWN = "slows-down"  # on its way
    BRAKES = "brakes"  # hard
    STOPS = "stops"  # on its way, and stands from then on


AT_REST = (EgoState.STANDS, EgoState.SETS_OFF)  # it stands at first


class Place(StrEnum):
    """Where it happens."""

    ROAD = "road"
    CURVE = "curve"  # to either side
    LEFT_CURVE = "left-curve"
    RIGHT_CURVE = "right-curve"
    THREE_WAY = "three-way"
    FOUR_WAY = "four-way"
    JUNCTION = "junction"  # any number of arms


_KINDS_OF = {
    Place.CURVE: (Place.LEFT_CURVE, Place.RIGHT_CURVE),
    Place.JUNCTION: (Place.THREE_WAY, Place.FOUR_WAY),
}


def includes(general: Place, place: Place) -> bool:
    """Whether every place of the second kind is one of the first: a junction may have three arms, a curve bend left."""
    return general is place or place in _KINDS_OF.get(general, ())


class Site(StrEnum):
    """What the ego's way leads along or through, beyond what a `Place` says."""

    ROUNDABOUT = "roundabout"  # in, round, and out
    MOTORWAY = "motorway"
    ON_RAMP = "on-ramp"  # by it onto another road
    OFF_RAMP = "off-ramp"
    PAST_ON_RAMP = "past-on-ramp"  # along the road that it joins
    PAST_OFF_RAMP = "past-off-ramp"
    WEAVING = "weaving"  # between an on-ramp and an off-ramp that share a lane
    LANE_DROP = "lane-drop"  # in a lane that tapers out
    RURAL = "rural"  # a two-way road with a lane each way and no sidewalk
    CROSSWALK = "crosswalk"  # between junctions
    PARKING = "parking"  # beside parking places
    BUS_BAY = "bus-bay"
    RAIL_CROSSING = "rail-crossing"  # rails lead across the road
    DRIVEWAY = "driveway"  # on its right, a way off the road to a house, a yard or a field
    DRIVEWAY_LEFT = "driveway-left"  # the same on its left
    PAST_LANE_DROP = "past-lane-drop"  # beside a lane on its right that tapers out
    PAST_LANE_DROP_LEFT = "past-lane-drop-left"  # the same on its left
    PAST_BEND = "past-bend"  # through a bend, or its last part, and on where the road is straight again


class Control(StrEnum):
    """How a junction is controlled."""

    SIGNAL = "signal"
    STOP_SIGN = "stop-sign"
    NONE = "none"


@dataclass(frozen=True, slots=True, kw_only=True)
class Slots:
    """Typed facts: of a sentence, what it says; of a snippet, what it does.

    ``None`` and the empty tuple mean *not said*. Sides and positions are in the ego's frame at its start.
    """

    adversary: AdversaryKind | None = None
    actions: tuple[Action, ...] = ()
    side: Side | None = None
    position: Position | None = None
    occluder: Occluder | None = None
    maneuver: Maneuver | None = None
    place: Place | None = None
    control: Control | None = None
    leader: bool | None = None  # a slow vehicle leads the ego
    blocker: bool | None = None  # a parked vehicle stands in the ego's lane
    distance: Distance | None = None
    group: bool | None = None  # others of its kind stand or go with it
    lanes: int | None = None  # of the ego's direction; on a road
    two_way: bool | None = None  # a lane of the opposite direction lies beside the ego's
    ego: EgoState | None = None
    site: Site | None = None
    others: tuple[Slots, ...] = ()  # each who does something beside the adversary, where the text is read whole

    def __str__(self) -> str:
        """What is filled, in words."""
        return ", ".join(f"{name}: {_words(value)}" for name, value in self.said().items())

    def said(self) -> dict[str, object]:
        """The slots that are filled, by name."""
        filled = {f.name: getattr(self, f.name) for f in fields(self)}
        return {name: value for name, value in filled.items() if value not in (None, ())}


def _words(value: object) -> str:
    if isinstance(value, tuple):
        return " then ".join(map(str, cast("tuple[object, ...]", value)))
    return str(value)


class QuantityKind(StrEnum):
    """What a number in a sentence measures."""

    DISTANCE = "distance"  # from the ego to where the adversary starts [m]
    SPEED = "speed"  # of the adversary [m/s]
    EGO_SPEED = "ego-speed"  # of the ego [m/s]
    TIME = "time"  # for which it stands [s]
    TRIGGER = "trigger"  # how far the ego still is when it acts [m]
    DECELERATION = "deceleration"  # of the adversary when it brakes [m/s²]
    ASIDE = "aside"  # to which side of its line it swerves: 1 to its left, -1 to its right


@dataclass(frozen=True, slots=True, kw_only=True)
class Quantity:
    """A number that was said.

    Attributes:
        measure: Of what.
        value: In SI units.
        said: The words.
    """

    measure: QuantityKind
    value: float
    said: str

    def __str__(self) -> str:
        """The words."""
        return self.said


class Why(StrEnum):
    """Why something that was said is not in the program, in the order in which that is listed."""

    NUMBER = "no parameter of the program fits it"
    WORDS = "gave no fact"


@dataclass(frozen=True, slots=True, kw_only=True)
class Unused:
    """Something that was said and that the program does not hold.

    Attributes:
        said: The words, in lower case.
        why: Why not.
    """

    said: str
    why: Why


def grouped(unused: Iterable[Unused]) -> dict[Why, str]:
    """What was not used, a line for every reason."""
    said: dict[Why, list[str]] = {}
    for one in unused:
        said.setdefault(one.why, []).append(repr(one.said))
    return {why: f"{', '.join(words)}: {why}" for why, words in said.items()}


@dataclass(frozen=True, slots=True, kw_only=True)
class SubDescriptions:
    """One text per component, cut from the sentence (paper, section 3.3, step ii)."""

    behavior: str
    geometry: str
    spawn: str

    def __getitem__(self, component: Component) -> str:
        return getattr(self, component.value)


@dataclass(frozen=True, slots=True, kw_only=True)
class Scenario:
    """A sentence about a dangerous situation, understood.

    Attributes:
        id: Readable and stable: derived from the sentence's text.
        text: What the user wrote.
        base: The base scenario it belongs to, or None where it fits none of the eight.
        parts: A sub-description per component.
        slots: The typed facts found in it.
        notes: What the reader of the sentence was unsure about.
        unused: What was said and is in no slot and no quantity.
        frame: What the sentence says and how sure that is; None for what nobody read from a sentence, such as a
            program of one's own.
        surroundings: Light, weather and the state of the road, as it says them.
        readings: What it may say beside this, the likeliest first.
        situation: All that was said, where that is a situation; `slots` then has what is in slots of it.
    """

    id: str
    text: str
    base: BaseScenario | None
    parts: SubDescriptions
    slots: Slots
    notes: tuple[Note, ...] = ()
    unused: tuple[Unused, ...] = ()
    frame: Frame | None = None
    surroundings: Surroundings = field(default_factory=Surroundings)
    readings: tuple[OfferedReading, ...] = ()
    situation: Situation | None = None

    @property
    def words(self) -> tuple[Word, ...]:
        """What became of each word of its text; none where nobody read it."""
        return self.frame.words if self.frame is not None else ()

    @property
    def said(self) -> Said:
        """What drives are to show."""
        return self.slots if self.situation is None else self.situation


Said = Slots | Situation
"""What drives are held against: what a sentence gave, or a situation."""
