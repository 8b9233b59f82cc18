"""Roads laid to order: what is said of one in a map's name, and the plan of streets that it is laid by.

``road:2+2,median=4,bend=left-250`` is a map: two lanes each way, four metres of grass between them, a bend to the left
with a radius of 250 m. The name says all of it, so that whoever has the name can lay the same road, byte for byte.
"""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import dataclass, fields, replace
from enum import StrEnum
from functools import cache, lru_cache
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from chatscene.errors import MapError
from chatscene.files.atomic import write_whole
from chatscene.files.caches import cache_folder, only_mine
from chatscene.maps.writing.objects import Bay, Crosswalk, Driveway, Use
from chatscene.maps.writing.opendrive import write_opendrive
from chatscene.maps.writing.streets import LANE, SETBACK, Node, Street, Surroundings
from chatscene.terms.scenario import Control

PREFIX = "road:"
DIGEST = 12  # [bytes] of a map's digest
LENGTH = 600  # [m]
MOST_LANES, WIDEST, NARROWEST = 6, 6.0, 2.5
LONGEST, SHORTEST = 5000, 300  # [m]
TIGHTEST, FLATTEST = 30, 3000  # [m] of radius
SIDEWALK, SHOULDER, HARD_SHOULDER, STRIP = 2.5, 1.5, 3.0, 2.2  # [m]
WALKED, DRIVEN = 40.0, 15.0  # [m] before the middle of the road, where a driveway and a bay for buses begin
TURNS_LEAST, TURNS_MOST = math.radians(40), math.radians(150)
_BACK = 10  # by which the id of a street is greater that leads the other way, with grass between
_KERB = 6.0  # [m] between the lanes of a crossing road and where the arms of a junction end
_DROPS = 80.0  # [m] over which a lane tapers out
_BUS = 65.0  # [m] of a bay for buses
_NOSE, _AT_NODE = 80.0, 5.0  # [m] beside a ramp in which the hard shoulder gives way; to where the two part or meet
_WITH_LANE = 330.0  # [m] of the lane for those who come from a ramp, or leave by it
_RAMP_LONG, _RAMP_TURN, _RAMP_RADIUS = 400.0, math.radians(12), 400.0  # [m], [rad], [m]


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
    """Which junction a road leads to in its middle."""

    LEFT = "left"
    RIGHT = "right"
    FOUR = "four"


class Signs(StrEnum):
    """What rules that junction."""

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
    """A road, or three or four roads that meet. It begins at the ego's back, and all its sides are those of its start.

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
        drop: Whether its outermost lane ends before its middle.
        drop_left: Whether its innermost lane does, of a divided road.
        ramp: Which ramp it has ahead, with a lane beside the others that leads to it or ends beyond it.
        junction: In its middle: of three arms, on which side the third is.
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
    drop: bool = False
    drop_left: bool = False
    ramp: Ramp | None = None
    junction: Meets | None = None
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
            (self.driveway is not None and self.junction is not None, "a driveway leads off between junctions"),
            (radius <= self._inside(), "what lies inside its bend is wider than the bend's radius"),
            (self.bus_bay and (self.bend is not None or self.junction is not None), "a bay lies on a straight road"),
        )

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
    "junction": Meets,
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


def laid(road: LaidRoad) -> str:
    """The OpenDRIVE file of a road."""
    return write_opendrive(str(road), _streets(road), located=True)


def laid_file(name: str) -> Path:
    """The file of the road that a map's name says, which is laid now if it is not there.

    It lies in this user's cache, or where there can be none in a folder of this process, by its content.

    Raises:
        MapError: The name says no road, or one that cannot be laid.
    """
    name, content = _content(name)
    digest = hashlib.blake2b(content, digest_size=DIGEST).hexdigest()
    file = f"{name.replace(':', '-')}.xodr"
    if (folder := only_mine(cache_folder("maps") / digest)) is not None:
        with suppress(OSError):
            return _written(folder / file, content)
    return _written(Path(_folder().name, file), content)


def laid_name(path: Path) -> str | None:
    """The name of the road that was laid in a file; None if it is another map."""
    name = path.stem.replace("-", ":", 1)
    try:
        return name if is_laid(name) and laid_file(name) == path else None
    except MapError:
        return None


@lru_cache(maxsize=64)
def _content(name: str) -> tuple[str, bytes]:
    """The one name of a road, and what is in its file."""
    road = road_of(str(road_of(name)))  # with its numbers as the name has them
    return str(road), laid(road).encode()


def _written(path: Path, content: bytes) -> Path:
    if not path.exists() or path.read_bytes() != content:
        write_whole(path, content)
    return path


@cache
def _folder() -> TemporaryDirectory[str]:
    return TemporaryDirectory(prefix="chatscene-")


_SURROUNDINGS = {
    Along.TOWN: Surroundings.TOWN,
    Along.RESIDENTIAL: Surroundings.ZONE,
    Along.RURAL: Surroundings.COUNTRY,
    Along.MOTORWAY: Surroundings.SLOWER_MOTORWAY,
}

_USUAL = {Along.TOWN: 110, Along.RESIDENTIAL: 30, Along.RURAL: 80, Along.MOTORWAY: 110}  # [km/h] at most on such

_Point = tuple[float, float]


def _surroundings(road: LaidRoad) -> Surroundings:
    """What a road is called: nothing of which its speed is more than counts."""
    faster = road.speed is not None and road.speed > _USUAL[road.along]
    return Surroundings.ANY if faster and road.along is not Along.MOTORWAY else _SURROUNDINGS[road.along]


def _streets(road: LaidRoad) -> tuple[Street, ...]:
    """The plan of a road: its streets, in the middle of which what it has lies."""
    if road.junction is not None:
        return _meeting(road)
    a, corner, b, length = _line(road)
    parts = _directions(road, (a, corner, b), length)
    return tuple(part for street in parts for part in (_changing(road, street) if street.id == 1 else (street,)))


def _line(road: LaidRoad) -> tuple[_Point, _Point | None, _Point, float]:
    """Where its middle line begins, where it would have its corner, where it ends, and how long it is [m]."""
    if (bend := road.bend) is None:
        return (-road.length / 2, 0.0), None, (road.length / 2, 0.0), float(road.length)
    angle = min(max(road.length / 2 / bend.radius, TURNS_LEAST), TURNS_MOST)
    straight = max((road.length - angle * bend.radius) / 2, 150.0)
    reach = straight + bend.radius * math.tan(angle / 2)
    up = math.copysign(reach * math.sin(angle), 1.0 if bend.left else -1.0)
    return (-reach, 0.0), (0.0, 0.0), (reach * math.cos(angle), up), 2 * straight + angle * bend.radius


def _directions(road: LaidRoad, line: tuple[_Point, _Point | None, _Point], length: float) -> list[Street]:
    """One street along a line, or one for each direction where grass lies between them or there is only one."""
    a, corner, b = line
    via = () if corner is None or road.bend is None else ((*corner, road.bend.radius),)
    whole = _street(road, Street(id=1, start=None, end=None, lanes=road.ahead, start_at=a, end_at=b, via=via), length)
    if not road.back:
        return [replace(whole, back=0, kerbs=True)]
    if not road.median:
        return [replace(whole, back=road.back)]
    half = road.median / 2
    ahead = replace(whole, back=0, median=half)
    return _both(ahead, replace(ahead, id=2, lanes=road.back, start_at=b, end_at=a), half, length)


def _both(ahead: Street, other: Street, half: float, length: float) -> list[Street]:
    """The two directions of a divided road, each half a median to the right of its middle."""
    sides = ((_aside(ahead, half), False), (_aside(other, half), True))
    return [_one_side(street, length, turned=turned) for street, turned in sides]


def _aside(street: Street, right: float) -> Street:
    """A street so far [m] to the right of the line that it is given."""
    assert street.start_at is not None and street.end_at is not None
    points = [street.start_at, *((x, y) for x, y, _ in street.via), street.end_at]
    ways = [math.atan2(q[1] - p[1], q[0] - p[0]) for p, q in pairwise(points)]

    def moved(at: _Point, first: float, last: float) -> _Point:
        middle = math.remainder(last - first, 2 * math.pi) / 2
        far, way = right / math.cos(middle), first + middle
        return at[0] + far * math.sin(way), at[1] - far * math.cos(way)

    corners = tuple(
        (*moved((x, y), *ways), radius + math.copysign(right, math.remainder(ways[1] - ways[0], 2 * math.pi)))
        for x, y, radius in street.via
    )
    return replace(
        street, start_at=moved(points[0], ways[0], ways[0]), end_at=moved(points[-1], ways[-1], ways[-1]), via=corners
    )


def _street(road: LaidRoad, street: Street, length: float) -> Street:
    """A street of a road with what lies along and beside it."""
    outside = road.along in (Along.RURAL, Along.MOTORWAY)
    strip = HARD_SHOULDER if road.along is Along.MOTORWAY else SHOULDER
    bays = tuple(
        Bay(use=Use.PARKING, right=right, start=10.0, end=length - 10.0, width=STRIP) for right in _on(road.parking)
    )
    middle = length / 2
    if road.bus_bay:
        bays = (Bay(use=Use.BUS, right=True, start=middle - DRIVEN, end=middle - DRIVEN + _BUS, width=3.0),)
    return replace(
        street,
        lane=road.lane,
        shoulder=road.shoulder or strip,
        sidewalk=0.0 if outside else SIDEWALK,
        surroundings=_surroundings(road),
        allowed=road.speed,
        bays=bays,
        cycle=road.cycle_lane,
        tram=road.tram,
        bus_lane=road.bus_lane and street.id in (1, 2) and street.lanes > 1,
        ridden=road.ridden and street.id in (1, 2) and street.lanes > 1,
        crosswalks=(Crosswalk(at=middle),) if road.crosswalk and road.junction is None else (),
        driveways=tuple(Driveway(right=right, at=middle) for right in _on(road.driveway)),
    )


def _on(sides: Sides | None) -> tuple[bool, ...]:
    """For each of some sides, whether it is the right one."""
    return {None: (), Sides.LEFT: (False,), Sides.RIGHT: (True,), Sides.BOTH: (True, False)}[sides]


def _one_side(street: Street, length: float, *, turned: bool) -> Street:
    """One direction of a road with what lies on the right of it, seen from its own start."""
    bays = tuple(
        replace(one, right=True, start=length - one.end, end=length - one.start) if turned else one
        for one in street.bays
        if one.right is not turned
    )
    ways = tuple(replace(one, right=True) for one in street.driveways if one.right is not turned)
    return replace(street, bays=bays, driveways=ways)


def _changing(road: LaidRoad, street: Street) -> tuple[Street, ...]:
    """A street of which the lanes change on the way, in parts that follow each other."""
    return _dropping(road, street) if road.ramp is None else _with_ramp(road, street)


def _with_ramp(road: LaidRoad, street: Street) -> tuple[Street, ...]:
    """The carriageway ahead with a ramp at its middle, and a lane that leads to it or that ends beyond it."""
    assert street.start_at is not None and street.end_at is not None
    lane, y = street.lane, street.start_at[1]
    edge = y - street.lanes * lane
    node = Node(id=101, x=0.0, y=y, control=Control.NONE)
    leads = replace(street, lanes=1, sidewalk=0.0, median=0.0, nose=(0.0, 0.0), via=())
    aside = (_RAMP_LONG * math.cos(_RAMP_TURN), _RAMP_LONG * math.sin(_RAMP_TURN))
    if road.ramp is Ramp.ON:
        joint = (_WITH_LANE + 10.0, y)
        ramp = replace(
            leads,
            id=5,
            end=node,
            start_at=(-_NOSE - aside[0], edge - aside[1]),
            via=((-_NOSE, edge, _RAMP_RADIUS),),
            end_at=(-_AT_NODE, edge),
        )
        before = replace(street, end=node, end_at=(-_AT_NODE, y), nose=(0.0, _NOSE))
        beside = replace(street, id=3, start=node, end=4, start_at=(_AT_NODE, y), end_at=joint, lanes=street.lanes + 1)
        length = joint[0] - _AT_NODE
        return (
            ramp,
            before,
            replace(beside, ceases=(length - 80.0, length - 10.0)),
            replace(street, id=4, start=3, start_at=joint),
        )
    joint = (-_WITH_LANE - 10.0, y)
    ramp = replace(
        leads,
        id=5,
        start=node,
        start_at=(_AT_NODE, edge),
        via=((_NOSE, edge, _RAMP_RADIUS),),
        end_at=(_NOSE + aside[0], edge - aside[1]),
    )
    before = replace(street, end=3, end_at=joint)
    beside = replace(street, id=3, start=1, end=node, start_at=joint, end_at=(-_AT_NODE, y), lanes=street.lanes + 1)
    beyond = replace(street, id=4, start=node, start_at=(_AT_NODE, y), nose=(_NOSE, 0.0))
    return ramp, before, replace(beside, begins=(10.0, 80.0)), beyond


def _dropping(road: LaidRoad, street: Street) -> tuple[Street, ...]:
    """A street whose outermost lane ends before its middle: two, that follow each other."""
    if not road.drops:
        return (street,)
    first = road.length * 0.6
    ends = (first - _DROPS - 20.0, first - 20.0)
    if road.drop_left:
        return (replace(street, inner=ends),)
    assert street.start_at is not None and street.end_at is not None
    joint = (street.start_at[0] + first, street.start_at[1])
    before = replace(street, end=3, end_at=joint, ceases=ends, one_sided=True)
    beyond = replace(street, id=3, start=1, start_at=joint, lanes=road.ahead - 1)
    return before, beyond


_CONTROL = {None: Control.NONE, Signs.SIGNAL: Control.SIGNAL}


def _meeting(road: LaidRoad) -> tuple[Street, ...]:
    """A road with a junction in its middle, whose other arms have a lane each way."""
    half = road.length / 2
    widest = max(road.ahead, road.back) * road.lane + road.median / 2
    arms = {Meets.LEFT: (3,), Meets.RIGHT: (4,), Meets.FOUR: (3, 4)}[road.junction or Meets.FOUR]
    own = (1, 2, *(number + _BACK for number in (1, 2)))
    minor = {Signs.SIDE_STOP: arms, Signs.SIDE_YIELD: arms, Signs.YIELD: own}.get(road.signs, ()) if road.signs else ()
    node = Node(
        id=101,
        x=0.0,
        y=0.0,
        control=_CONTROL.get(road.signs, Control.STOP_SIGN),
        setback=max(SETBACK, widest + _KERB + SIDEWALK),
        marked=road.crosswalk,
        minor=minor,
        gives_way=road.signs in (Signs.YIELD, Signs.SIDE_YIELD),
    )
    main = replace(road, driveway=None)
    length = half - node.setback
    streets: list[Street] = []
    for number, far in ((1, -half), (2, half)):
        begin, end = ((far, 0.0), None) if number == 1 else (None, (far, 0.0))
        street = Street(
            id=number,
            start=None if begin else node,
            end=None if end else node,
            lanes=road.ahead,
            back=road.back,
            start_at=begin,
            end_at=end,
        )
        streets += _parted(main, _street(main, street, length), node, length)
    side = replace(
        main, ahead=1, back=1, median=0.0, parking=None, bus_lane=False, cycle_lane=False, ridden=False, tram=False
    )
    for number in arms:
        far = half if number == 3 else -half
        streets.append(_street(side, Street(id=number, start=node, end=None, lanes=1, end_at=(0.0, far)), length))
    return tuple(streets)


def _parted(road: LaidRoad, street: Street, node: Node, length: float) -> list[Street]:
    """An arm of a junction as one street, or as one for each direction with grass between them."""
    if not road.median:
        return [street]
    half, near = road.median / 2, node.setback
    outer = street.start_at or street.end_at
    assert outer is not None
    inner = (math.copysign(near, outer[0]), 0.0)
    a, b = (outer, inner) if street.start_at else (inner, outer)
    ahead = replace(street, start_at=a, end_at=b, back=0, median=half)
    turned = replace(ahead, start=street.end, end=street.start, start_at=b, end_at=a)
    other = replace(turned, id=street.id + _BACK, lanes=road.back)
    return _both(ahead, other, half, length)
