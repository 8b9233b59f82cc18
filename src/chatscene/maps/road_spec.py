"""What can be said of a road that is laid to order, and its name, which says all of it."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from enum import StrEnum
from typing import Any

from chatscene.errors import MapError
from chatscene.maps.writing.rings import USUAL, RingDesign
from chatscene.maps.writing.streets import LANE

PREFIX = "road:"
LENGTH = 600  # [m]
MOUTH = 5.0  # [m] of a driveway
MOST_LANES, WIDEST, NARROWEST = 6, 6.0, 2.5
LONGEST, SHORTEST = 5000, 300  # [m]
TIGHTEST, FLATTEST = 30, 3000  # [m] of radius
SIDEWALK, HARD_SHOULDER = 2.5, 3.0  # [m]


class Along(StrEnum):
    """What lies about a road that is laid, which says its sidewalks and its usual speed."""

    TOWN = "town"
    RESIDENTIAL = "residential"
    RURAL = "rural"
    MOTORWAY = "motorway"


class Sides(StrEnum):
    """On which sides of a road something lies, seen from its start."""

    LEFT = "left"
    RIGHT = "right"
    BOTH = "both"


class Meets(StrEnum):
    """Which arms the junction has that a road leads to in its middle, beside that by which the road comes."""

    LEFT = "left"  # straight on and left
    RIGHT = "right"  # straight on and right
    FOUR = "four"  # straight on, left and right
    STEM = "stem"  # left and right: the road ends there, as the stem of a T
    FORK = "fork"  # half left and half right, all three as far apart
    FIVE = "five"  # all five as far apart

    @property
    def arms(self) -> Mapping[int, float]:
        """By the number of each other arm, in which direction it lies [degrees], seen from the road: 0 is straight on.

        The road's own is 1; that straight on is 2, 3 is on the left and 4 on the right.
        """
        return _ARMS[self]

    @property
    def narrowest(self) -> float:
        """The smallest angle between two arms [degrees]."""
        at = sorted((180.0, *(angle % 360.0 for angle in self.arms.values())))
        return min(beyond - one for one, beyond in zip(at, (*at[1:], at[0] + 360.0), strict=True))


_ARMS: Mapping[Meets, Mapping[int, float]] = {
    Meets.LEFT: {2: 0.0, 3: 90.0},
    Meets.RIGHT: {2: 0.0, 4: -90.0},
    Meets.FOUR: {2: 0.0, 3: 90.0, 4: -90.0},
    Meets.STEM: {3: 90.0, 4: -90.0},
    Meets.FORK: {3: 60.0, 4: -60.0},
    Meets.FIVE: {3: 108.0, 4: -108.0, 5: 36.0, 6: -36.0},
}


class Signs(StrEnum):
    """What rules that junction. The side is the minor road: that which crosses, or the stem of a T or a Y."""

    SIGNAL = "signal"
    STOP = "stop"  # on every arm
    YIELD = "yield"  # on the road itself
    SIDE_STOP = "side-stop"
    SIDE_YIELD = "side-yield"


class Ramp(StrEnum):
    """Which ramp a motorway has ahead, in its middle."""

    ON = "on"
    OFF = "off"


@dataclass(frozen=True, slots=True)
class Bend:
    """A bend in the middle of a road.

    Attributes:
        left: Whether it bends to the left.
        radius: Of its middle line [m].
    """

    left: bool
    radius: float

    def __str__(self) -> str:
        """As a name says it."""
        return f"{'left' if self.left else 'right'}-{self.radius:g}"


@dataclass(frozen=True, slots=True, kw_only=True)
class LaidRoad:
    """A road, or three to five roads that meet, at a junction or a roundabout.

    It begins at the ego's back, and all its sides are those of its start.

    Attributes:
        ahead: Lanes from its start to its end.
        back: Lanes the other way.
        lane: Width of a lane [m].
        along: What lies about it.
        speed: The speed allowed [km/h], if not what is usual.
        median: Width of the grass between the two directions [m], 0 for none.
        shoulder: Width of a hard shoulder on each side [m], 0 for none.
        parking: On which sides one parks beside the lanes, all along.
        bus_lane: Whether the outermost lane ahead is for buses.
        cycle_lane: Whether lanes for bicycles lie beside the lanes.
        tram: Whether rails lie in the innermost lane each way.
        ridden: Whether that ahead is the outermost of the lanes, for an ego that rides in it.
        bend: In its middle.
        crosswalk: Whether one leads across its middle, or across each arm of its junction.
        bus_bay: Whether a bay for buses lies on its right.
        driveway: On which side a driveway leads off its middle.
        mouth: How wide that is [m].
        drop: Whether its outermost lane ends before its middle.
        drop_left: Whether its innermost lane does, of a divided road.
        ramp: Which ramp it has ahead, with a lane beside the others that leads to it or ends beyond it.
        junction: In its middle: which arms it has.
        side: Lanes each way of its other arms; those of the arm straight on are the road's own.
        ring: Lanes that go round, if the junction is a roundabout; one gives way as one enters it.
        diameter: Of the circle round those lanes [m], 0 for one that is usual.
        turn_lane: On which side of the lanes ahead there is one more before the junction, for who turns off there.
        signs: What rules the junction.
        length: [m]
    """

    ahead: int = 1
    back: int = 1
    lane: float = LANE
    along: Along = Along.TOWN
    speed: int | None = None
    median: float = 0.0
    shoulder: float = 0.0
    parking: Sides | None = None
    bus_lane: bool = False
    cycle_lane: bool = False
    ridden: bool = False
    tram: bool = False
    bend: Bend | None = None
    crosswalk: bool = False
    bus_bay: bool = False
    driveway: Sides | None = None
    mouth: float = MOUTH
    drop: bool = False
    drop_left: bool = False
    ramp: Ramp | None = None
    junction: Meets | None = None
    side: int = 1
    ring: int = 0
    diameter: float = 0.0
    turn_lane: Sides | None = None
    signs: Signs | None = None
    length: int = LENGTH

    def __post_init__(self) -> None:
        """Hold it to what can be laid.

        Raises:
            MapError: It cannot.
        """
        if fault := next((why for there, why in self._faults() if there), None):
            raise MapError(f"map {str(self)!r} cannot be laid: {fault}")

    def _faults(self) -> tuple[tuple[bool, str], ...]:
        radius = TIGHTEST if self.bend is None else self.bend.radius
        taken = self.parking or self.crosswalk or self.bus_bay or self.driveway
        return (
            (not 1 <= self.ahead <= MOST_LANES, f"it has 1 to {MOST_LANES} lanes ahead"),
            (not 0 <= self.back <= MOST_LANES, f"it has 0 to {MOST_LANES} lanes back"),
            (not NARROWEST <= self.lane <= WIDEST, f"a lane is {NARROWEST:g} to {WIDEST:g} m wide"),
            (not 0.0 <= self.median <= 30.0, "a median is up to 30 m wide"),
            (not 0.0 <= self.shoulder <= 6.0, "a shoulder is up to 6 m wide"),
            (self.speed is not None and not 5 <= self.speed <= 130, "a speed is 5 to 130 km/h"),
            (not SHORTEST <= self.length <= LONGEST, f"it is {SHORTEST} to {LONGEST} m long"),
            (not TIGHTEST <= radius <= FLATTEST, f"a bend has a radius of {TIGHTEST} to {FLATTEST} m"),
            (bool(self.median) and not self.back, "a median lies between two directions"),
            (
                self.tram and bool(self.median or not self.back or self.bend),
                "rails lie in both directions, on a straight",
            ),
            (bool(self.shoulder) and bool(self.parking or self.cycle_lane), "one strip lies beside the lanes"),
            (self.signs is not None and self.junction is None, "signs stand at a junction"),
            ((self.bus_lane or self.ridden) and self.ahead < 2, "a lane for buses or bicycles lies beside another"),
            (
                self.ridden and (self.bus_lane or not self.cycle_lane),
                "bicycles ride in a cycle lane, beside no bus lane",
            ),
            (self.bend is not None and self.junction is not None, "no junction lies in a bend"),
            (self.junction is not None and not self.back, "a junction is on a road of two directions"),
            (self.drops and (self.ahead < 2 or self.bend is not None or self.junction is not None), _DROP),
            (self.drops and bool(taken), "nothing else lies along a road of which a lane ends"),
            (self.ramp is not None and self.length < 1000, "a motorway with a ramp is 1000 m long at least"),
            (self.ramp is not None and not (self._plain() and self.along is Along.MOTORWAY and self.median), _RAMP),
            (self.drop_left and (self.drop or not self.median), "one lane ends, and the innermost into a median"),
            (self.bus_bay and self.parking is not None, "one parks beside no road that has a bay for buses"),
            (not 2.0 <= self.mouth <= 12.0, "a driveway is 2 to 12 m wide"),
            (self.driveway is not None and self.junction is not None, "a driveway leads off between junctions"),
            (radius <= self._inside(), "what lies inside its bend is wider than the bend's radius"),
            (self.bus_bay and (self.bend is not None or self.junction is not None), "a bay lies on a straight road"),
            *self._faults_of_junction(),
        )

    def _faults_of_junction(self) -> tuple[tuple[bool, str], ...]:
        ring, lane = bool(self.ring), self.turn_lane is not None
        return (
            (not 1 <= self.side <= MOST_LANES, f"another arm has 1 to {MOST_LANES} lanes each way"),
            (self.side > 1 and self.junction is None, "other arms are those of a junction"),
            (not 0 <= self.ring <= max(USUAL), f"1 to {max(USUAL)} lanes go round"),
            (ring and self.junction is None, "a roundabout is a junction of arms"),
            (bool(self.diameter) and not ring, "a diameter is that of a roundabout"),
            (ring and (self.signs not in (None, Signs.YIELD) or lane), "one gives way at a roundabout"),
            (ring and self.tram, "rails lead through no roundabout"),
            (ring and self._ring_fault() is not None, str(self._ring_fault())),
            (lane and (self.junction is None or self.turn_lane is Sides.BOTH or bool(self.median)), _TURN_LANE),
            (lane and (self.bus_lane or self.ridden or self.tram), _TURN_LANE),
        )

    @property
    def design(self) -> RingDesign | None:
        """The ring of its roundabout; None without one.

        Raises:
            ValueError: It has no room for that.
        """
        if not self.ring or self.junction is None:
            return None
        outside = self.along in (Along.RURAL, Along.MOTORWAY)
        apart = math.radians(self.junction.narrowest)
        return RingDesign.of(self.ring, self.diameter or USUAL[self.ring], apart, 0.0 if outside else SIDEWALK)

    def _ring_fault(self) -> str | None:
        try:
            _ = self.design if self.ring in USUAL else None
        except ValueError as error:
            return str(error)
        return None

    def _plain(self) -> bool:
        """Whether it is straight, with nothing along or in it."""
        taken = self.parking or self.crosswalk or self.bus_bay or self.driveway or self.bus_lane or self.ridden
        return not (taken or self.bend or self.junction or self.drops)

    @property
    def drops(self) -> bool:
        """Whether one of its lanes ends."""
        return self.drop or self.drop_left

    def _inside(self) -> float:
        """How far [m] from the middle of its bend what lies inside of that goes; 0 without one."""
        if self.bend is None:
            return 0.0
        lanes = self.back if self.bend.left else self.ahead
        return lanes * self.lane + self.median / 2 + max(self.shoulder, HARD_SHOULDER) + SIDEWALK

    def __str__(self) -> str:
        """Its name, the same for the same road."""
        said = [f"{self.ahead}+{self.back}"]
        for one in fields(self):
            value = getattr(self, one.name)
            if one.name not in ("ahead", "back") and value != one.default:
                word = one.name.replace("_", "-")
                said.append(
                    word if value is True else f"{word}={value:g}" if isinstance(value, float) else f"{word}={value}"
                )
        return PREFIX + ",".join(said)


_RAMP = "a ramp is on a straight motorway with a median, and nothing else along it"
_TURN_LANE = "a lane for who turns is on one side of a road without a median, with no lane for buses, bicycles or rails"
_DROP = "a lane ends beside another, on a straight road without a junction"


def _bend(said: str) -> Bend:
    side, _, radius = said.partition("-")
    return Bend(left=Sides(side) is Sides.LEFT, radius=float(radius))


_READ: Mapping[str, Callable[[str], Any]] = {
    "lane": float,
    "along": Along,
    "speed": int,
    "median": float,
    "shoulder": float,
    "parking": Sides,
    "bend": _bend,
    "driveway": Sides,
    "mouth": float,
    "junction": Meets,
    "side": int,
    "ring": int,
    "diameter": float,
    "turn-lane": Sides,
    "ramp": Ramp,
    "signs": Signs,
    "length": int,
}
"""How each word of a name that has a value is read."""
_PLAIN = {"bus-lane", "cycle-lane", "ridden", "tram", "crosswalk", "bus-bay", "drop", "drop-left"}
WORDS = ", ".join((*(f"{word}=…" for word in _READ), *sorted(_PLAIN)))


def is_laid(name: str) -> bool:
    """Whether a map's name says a road that is laid to order."""
    return name.startswith(PREFIX)


def road_of(name: str) -> LaidRoad:
    """The road that a map's name says.

    Raises:
        MapError: It says none; the word is named.
    """
    lanes, *words = name.removeprefix(PREFIX).split(",")
    ahead, _, back = lanes.partition("+")
    try:
        said: dict[str, Any] = {"ahead": int(ahead), "back": int(back)}
    except ValueError as error:
        raise MapError(f"map {name!r}: {lanes!r} says no lanes; say road:1+1 for one each way") from error
    for one in words:
        word, has_value, value = one.partition("=")
        if word.replace("-", "_") in said:
            raise MapError(f"map {name!r}: {word!r} is said twice; say it once")
        try:
            said[word.replace("-", "_")] = _READ[word](value) if has_value else dict.fromkeys(_PLAIN, True)[word]
        except (KeyError, ValueError) as error:
            raise MapError(f"map {name!r}: {one!r} says nothing of a road; words are {WORDS}") from error
    return LaidRoad(**said)
