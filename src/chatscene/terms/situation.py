"""What is to happen, as typed facts: independent of text, library, map and simulator.

Readers make a situation, people and agents write one, programs are built from it, scenes are judged against it, edits
change it, and words are made of it. Its words are those of `chatscene.terms.vocabulary`. A fact that is None, or an
empty list, was not said. Sides are the ego's own at its start.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar

from chatscene.terms.actors import AdversaryKind, RoadUser
from chatscene.terms.amount import Acceleration, Duration, Length, Share, Speed
from chatscene.terms.surroundings import Light, Surface, Weather
from chatscene.terms.vocabulary import (
    GLIDES,
    KEEPS_UP,
    SLOWS,
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

VERSION = 1
EGO = "ego"
SEVERAL = 0
"""The count of a group whose size was not said."""


class _Closed:
    """A noun that takes no other fields, from whatever file."""

    __slots__ = ()
    __pydantic_config__: ClassVar[Mapping[str, Any]] = {"extra": "forbid"}


CREEPS = 2.0  # [m/s]: a speed below it of what leads aside says how fast somebody comes aside, and not along
KEEPS_AHEAD = 1.2  # times the ego's speed is what somebody may drive at who passes it
MUCH_FASTER = 2.0  # times that, the least speed of another road user of whom it says so


def _fastest(*said: Speed | None) -> float:
    """The largest speed [m/s] of those that were said, but for what is said against the ego's."""
    return max((one.most for one in said if one and not one.than_ego and one.low > 0.0), default=0.0)


@dataclass(frozen=True, slots=True, kw_only=True)
class When(_Closed):
    """When a deed begins, where that is said.

    Attributes:
        after: The deed after which it begins: whose, and its number from 0 or its act, as ``A.0`` or ``ego.stop``.
        during: The deed while which it begins.
        delay: How long after `after` ended or `during` began.
        ego_within: How near the ego then is, as a length or as the time it still needs.
        of: The id of whom it is near to, if not who does it.
    """

    after: str | None = None
    during: str | None = None
    delay: Duration | None = None
    ego_within: Length | Duration | None = None
    of: str | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Lateral(_Closed):
    """Where across the road, by one of five or by a side.

    Attributes:
        side: Of its lane.
        offset: From the lane's middle.
        edge: From the lane's edge; 0 is on the line.
        overlap: With the ego's width.
        clearance: Room beside the ego.
        beyond: Outside the lanes.
    """

    side: Side | None = None
    offset: Length | None = None
    edge: Length | None = None
    overlap: Share | None = None
    clearance: Length | None = None
    beyond: Length | None = None


LATERALS = ("offset", "edge", "overlap", "clearance", "beyond")
"""The fields of `Lateral` of which one is said, if any is beside the side."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Deed(_Closed):
    """One thing that somebody does.

    Attributes:
        act: What.
        to: To which side, of an act that goes to one.
        whom: The id of whom it is done to, or for; else the ego.
        manner: How, where that is said without a number.
        breaks: The rule that is broken by it.
        speed: At which it is done, or that is reached.
        acceleration: How hard speed changes, without a sign.
        distance: The gap that is kept or left, or the way covered.
        time: How long it takes or lasts; of a cut-in, the gap in time.
        lateral: Where it then goes on.
        when: When it begins; else after the deed before it.
    """

    act: Act
    to: Side | None = None
    whom: str | None = None
    manner: Manner | None = None
    breaks: Breach | None = None
    speed: Speed | None = None
    acceleration: Acceleration | None = None
    distance: Length | None = None
    time: Duration | None = None
    lateral: Lateral | None = None
    when: When | None = None

    @property
    def done_to(self) -> str:
        """The id of whom it is done to: the ego where nobody is named, or an act is done to nobody."""
        return self.whom if self.whom is not None and self.act.row.whom else EGO


@dataclass(frozen=True, slots=True, kw_only=True)
class Start(_Closed):
    """Where somebody is when it begins.

    Attributes:
        where: The place, seen from the ego.
        side: Of a place that has one.
        distance: From the ego, along the road; of who is ahead or behind, the gap between the two; of who is beyond a
            junction (`exit`, `exit-crossing`), from there.
        speed: How fast it then is.
        facing: Which way it faces, where the place leaves that open.
        lateral: Where, if not in the lane's middle.
    """

    where: Where
    side: Side | None = None
    distance: Length | None = None
    speed: Speed | None = None
    facing: Facing | None = None
    lateral: Lateral | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Other(_Closed):
    """A road user or a thing beside the ego; or several that do the same.

    Attributes:
        id: A short name.
        kind: What it is.
        count: How many; 0 for several, if their number was not said.
        stretch: How long the row of several is, as of parked cars or a queue.
        role: What it is there for.
        starts: Where it is when it begins.
        hidden_by: The id of whom or what hides it from the ego at first.
        does: What it does, in order.
    """

    id: str
    kind: UserKind
    count: int = 1
    stretch: Length | None = None
    role: Role = Role.ADVERSARY
    starts: Start
    hidden_by: str | None = None
    does: tuple[Deed, ...] = ()

    @property
    def row(self) -> RoadUser:
        """What holds of its kind; of who is said to be faster than most of it, of a stronger one."""
        return self.kind.row.body.row.at(_fastest(self.starts.speed, *(deed.speed for deed in self.does)))

    def speed_aside(self, k: int) -> Speed | None:
        """How fast it comes aside by its k-th deed, and not along the road, if that was said.

        It is what a speed says at which nobody drives who changes lanes or drifts, and who was said to be much faster.
        """
        deed, before = self.does[k], (self.starts.speed, *(one.speed for one in self.does[:k]))
        was = next((one for one in reversed(before) if one is not None), None)
        if deed.act not in GLIDES or deed.speed is None or was is None or deed.speed.than_ego or was.than_ego:
            return None
        return deed.speed if deed.speed.high < CREEPS and was.least > MUCH_FASTER * deed.speed.high else None


@dataclass(frozen=True, slots=True, kw_only=True)
class Ego(_Closed):
    """The vehicle that is tested.

    Attributes:
        kind: What it is, of those that drive or ride; a car where that was not said.
        route: The way it goes.
        exit: Which of a roundabout, from 1.
        speed: How fast it drives where nothing holds it.
        does: What it does before the danger, in order.
    """

    kind: UserKind | None = None
    route: EgoRoute | None = None
    exit: int | None = None
    speed: Speed | None = None
    does: tuple[Deed, ...] = ()

    @property
    def body(self) -> AdversaryKind:
        """The kind of the world that it is built as."""
        return (self.kind or UserKind.CAR).row.body

    @property
    def row(self) -> RoadUser:
        """What holds of its kind; of one that is said to be faster than most of it, of a stronger one."""
        return self.body.row.at(_fastest(self.speed, *(deed.speed for deed in self.does)))


@dataclass(frozen=True, slots=True, kw_only=True)
class Road(_Closed):
    """The road where it happens.

    Attributes:
        kind: What kind of road.
        arms: How many roads meet there.
        side_road: On which side the third of these is.
        diameter: Of its roundabout.
        setting: What lies about it.
        control: What rules the ego's way.
        ego_light: The traffic light that the ego has.
        lanes: How many lanes go the ego's way, or round.
        ego_lane: Which of them the ego is in, from the outermost, 1, or the innermost, -1.
        two_way: Whether a lane the other way lies beside them.
        speed_limit: The speed limit.
        radius: Of its bend.
        has: What else is there.
    """

    kind: RoadKind | None = None
    arms: int | None = None
    side_road: Side | None = None
    diameter: Length | None = None
    setting: Setting | None = None
    control: RightOfWay | None = None
    ego_light: EgoLight | None = None
    lanes: int | None = None
    ego_lane: int | None = None
    two_way: bool | None = None
    speed_limit: Speed | None = None
    radius: Length | None = None
    has: tuple[Feature, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class Contact(_Closed):
    """How the ego and another touch.

    Attributes:
        whom: The id of the other; the adversary where none is named.
        ego: The part of the ego that is touched.
        other: The part of the other that is touched.
        striker: Who runs into whom.
        happens: False where there is said to be none.
        at: Where on the ego's width, from the other's side.
        behind_nose: Of the point that is there, as a share of the other's length; its middle if left out.
    """

    whom: str | None = None
    ego: Part | None = None
    other: Part | None = None
    striker: Striker | None = None
    happens: bool = True
    at: Share | None = None
    behind_nose: Share | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Around(_Closed):
    """Light, weather and the state of the road.

    Attributes:
        light: How light it is.
        weather: What falls or hangs in the air.
        surface: The state of the road; else what follows from the weather.
    """

    light: Light | None = None
    weather: Weather | None = None
    surface: Surface | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Evidence(_Closed):
    """Where the facts of a situation come from; a fact of which nothing is said here was stated by whoever wrote it.

    Attributes:
        quoted: By the path of a fact, as ``others.A.kind``, or of a whole, as ``others.A``, the words that give it.
        assumed: The paths of facts that no words give.
        open: What the text may tell besides, of which its reader was not sure enough: road users by their words, the
            rest in sentences.
        unbuilt: What was said and is left out, since it cannot be built: each fact as ``path: value``, with the reason.
        mirrored: Whether left and right of the text are swapped, as it is of left-hand traffic.
        keeps_left: Whether sides are as on a map that keeps to the left: those of the kerb are swapped for it already.
    """

    quoted: Mapping[str, str] = field(default_factory=dict[str, str])
    assumed: tuple[str, ...] = ()
    open: tuple[str, ...] = ()
    unbuilt: tuple[str, ...] = ()
    mirrored: bool = False
    keeps_left: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Situation(_Closed):
    """What is to happen.

    Attributes:
        version: Of the form in which situations are written.
        about: What a person calls it; no fact.
        map: The map it lies on: a packaged one, or a file; None for any that has such a place.
        ego: The vehicle that is tested.
        road: The road where it happens.
        others: Everybody else who matters; those who meet the ego first.
        contact: How they touch.
        around: Light, weather and the state of the road.
        evidence: Where the facts come from.
    """

    version: int = VERSION
    about: str = field(default="", compare=False)
    map: str | None = None
    ego: Ego = field(default_factory=Ego)
    road: Road = field(default_factory=Road)
    others: tuple[Other, ...] = ()
    contact: Contact | None = None
    around: Around = field(default_factory=Around)
    evidence: Evidence = field(default_factory=Evidence, compare=False)

    def __getitem__(self, name: str) -> Other:
        """Somebody by the id.

        Raises:
            KeyError: There is nobody of that id.
        """
        for other in self.others:
            if other.id == name:
                return other
        raise KeyError(name)

    @property
    def adversaries(self) -> tuple[Other, ...]:
        """Those who meet the ego."""
        return tuple(one for one in self.others if one.role is Role.ADVERSARY)

    def row_of(self, one: Other) -> RoadUser:
        """What holds of somebody beside this ego: of who passes or keeps up with a strong one, of one as strong."""
        said = any(speed and not speed.than_ego for speed in (one.starts.speed, *(deed.speed for deed in one.does)))
        keeps_up = self.ego.row.limits.most and not said and any(deed.act in KEEPS_UP for deed in one.does)
        return one.row.at(KEEPS_AHEAD * _fastest(self.ego.speed)) if keeps_up else one.row

    def does(self, who: str) -> tuple[Deed, ...]:
        """What the ego, or another of an id, does.

        Raises:
            KeyError: There is nobody of that id.
        """
        return self.ego.does if who == EGO else self[who].does

    def deed(self, reference: str) -> Deed:
        """The deed that a reference such as ``A.0`` or ``ego.set-off`` means; of several of that act, the first.

        Raises:
            KeyError: There is none.
        """
        return self.does(reference.partition(".")[0])[self.number_of(reference)]

    def number_of(self, reference: str) -> int:
        """The number of the deed that a reference means, of those of whoever does it.

        Raises:
            KeyError: There is none.
        """
        who, _, what = reference.partition(".")
        for i, deed in enumerate(self.does(who)):
            if what in (str(i), deed.act.value):
                return i
        raise KeyError(reference)

    def answered(self, deed: Deed) -> tuple[str, str] | None:
        """What a deed answers by which somebody loses speed: ``after`` or ``during`` and a deed, or ``whom`` and an id.

        None where it loses none, of itself, or since the ego does something. How an ego answers is up to whoever
        drives it.
        """
        if deed.act in SLOWS and deed.whom not in (None, EGO):
            return "whom", str(deed.whom)
        for name in ("after", "during"):
            reference = getattr(deed.when, name, None) or f"{EGO}."
            if deed.act in SLOWS and not reference.startswith(f"{EGO}."):
                return name, reference
        return None

    def everybody(self) -> Iterator[tuple[str, tuple[Deed, ...]]]:
        """The ego and all others, with what they do."""
        yield EGO, self.ego.does
        for one in self.others:
            yield one.id, one.does
