"""Of whom a start is asked, and what it is then: where somebody stands at first, and how it comes to meet the ego."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum

from chatscene.build.coming import Coming
from chatscene.build.numbers import Numbers
from chatscene.build.place import Found, beside_lane, rides_at_edge
from chatscene.errors import NotBuilt
from chatscene.maps.crossings import CrossingPath
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.routing import BEGINS
from chatscene.terms.scenario import Maneuver
from chatscene.terms.situation import Deed, Other, Situation
from chatscene.terms.vocabulary import (
    ENDS,
    GOES_ON,
    HALTS,
    NOSE_TO_TAIL,
    PLAIN,
    STOPS,
    Act,
    Heads,
    Manner,
    Tempo,
    Where,
    acts_of,
)

ROOM = 3.0  # [m] between who stand in a row
SOME = 3  # of a group whose size was not said
PARKED_APART = 2.5  # [m] between who are parked in a row
APART = 1.0  # [s] between who drive in a row, from nose to tail
NEAREST = 3.0  # [m] between who begin one behind the other


class Meets(StrEnum):
    """How somebody comes to meet the ego: what its deeds are made of, and when the first is due."""

    ALONG = "along"  # goes the ego's way
    TOWARD = "toward"  # comes against it
    THROUGH = "through"  # comes through a junction
    ACROSS = "across"  # heads over the road
    KERB = "kerb"  # stands at the kerb


@dataclass(frozen=True, slots=True, kw_only=True)
class Stand:
    """Where somebody stands at first. In texts ``{i}`` is its name, ``$NAME`` a parameter of it.

    Attributes:
        meets: How it comes to meet the ego.
        way: The line it goes along.
        at: Arc length [m] on that.
        point: Where it is instead of on its way.
        facing: Which way it faces there.
        lines: What is named before.
        ego_meets: Arc length [m] on the ego's route where they would meet.
        left: How far [m] it has to there.
        behind: Whether it is behind the ego.
        faces: Whether it faces as was said.
        anywhere: Whether ``$Y`` is how far along the ego's route it is, which may be any number.
        rolls: Whether it comes driving from the first, so that it is there in time without waiting.
        slants: Whether it heads over the road at a slant.
        over: How far [rad] it turns to the left to cross, if it faces along the road at first.
        turn: How far [rad] it is turned to the left of its way, who stands.
        found: Its way on the first route that was found, if that meets the ego's at a junction.
    """

    meets: Meets
    way: str = "egoRoute"
    at: str = ""
    point: str = ""
    facing: str = ""
    lines: tuple[str, ...] = ()
    ego_meets: str = "egoRoute.eventAt"
    left: str = "0"
    behind: bool = False
    faces: bool = False
    anywhere: bool = False
    rolls: bool = False
    slants: bool = False
    over: str = ""
    turn: float = 0.0
    found: CrossingPath | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Asked:
    """Of whom a start is asked.

    Attributes:
        situation: What was said.
        found: Where it happens.
        one: Who.
        numbers: Its parameters.
        ego: How the ego gets on.
        room: How far [m] beyond the first of its place it stands, where others stand there already.
        first: Where that stands.
    """

    situation: Situation
    found: Found
    one: Other
    numbers: Numbers
    ego: Coming
    room: float = 0.0
    first: Stand | None = None

    @property
    def walks(self) -> bool:
        """Whether it is on foot."""
        return self.one.kind.moves is Moves.WALKS

    @property
    def rides(self) -> bool:
        """Whether it is on two wheels that keep to the edge."""
        return rides_at_edge(self.one, self.situation.ego.route)

    @property
    def stands(self) -> bool:
        """Whether it stands at first."""
        return stands_first(self.one)

    @property
    def rolls(self) -> bool:
        """Whether it comes driving from the first: nothing has it wait, and it is known when the ego comes."""
        first = self.one.does[0] if self.one.does else None
        drives = self.one.starts.speed is not None  # and so does not wait to go on
        waits = first is not None and first.when is not None and first.act.row.lasting and not drives
        in_row = self.first is not None and not self.first.rolls
        comes_driving = self.one.starts.where is Where.ONCOMING or (drives and self.one.starts.where is Where.ARM)
        comes_out = self.one.hidden_by is not None and not comes_driving
        return not (self.stands or waits or in_row or comes_out) and self.ego.late is not None

    @property
    def hidden_by(self) -> Other | None:
        """Who hides it at first."""
        return self.situation[self.one.hidden_by] if self.one.hidden_by is not None else None

    @property
    def comes(self) -> bool:
        """Whether it rolls, and does nothing before its last deed that takes it longer to where it meets the ego.

        Who gains or loses speed on its way is timed from a stand, by when it must set off.
        """
        return self.rolls and all(deed.act.row.lasting for deed in self.one.does[:-1])

    def way_back(self, meets: str, own: str) -> str:
        """How far [m] it has to where it meets the ego, if it is there in time, by where that is on the ego's way."""
        return f"{own}$SPEED * ({self.ego.seconds(meets)} - $OFFSET)"

    @property
    def backs(self) -> bool:
        """Whether it comes backwards onto the road."""
        first = next((deed.act for deed in self.one.does if deed.act is not Act.STAND), None)
        return first is Act.REVERSE and not self.walks

    @property
    def side(self) -> str:
        """Its side of the ego."""
        return str(self.one.starts.side)

    @property
    def begins_beside(self) -> bool:
        """Whether the ego comes into its lane from beside it, so that who comes along there comes from its left."""
        return self.situation.ego.route in BEGINS

    @property
    def lane(self) -> str:
        """The way of traffic before and behind the ego: its route, or the lane that it leaves."""
        return "ownLane(egoRoute)" if beside_lane(self.situation) else "ownWay(egoRoute)"

    @property
    def swings_out(self) -> bool:
        """Whether the ego's way swings out round something."""
        return self.found.query["maneuver"] == Maneuver.BYPASS

    @property
    def ends_straight(self) -> bool:
        """Whether the ego goes straight on at a junction."""
        return self.found.query["maneuver"] == Maneuver.STRAIGHT

    @property
    def middles(self) -> float:
        """How far [m] the middles of the ego and of it are apart where they touch, one behind the other."""
        row = self.one.kind.row.body.row
        return 0.5 * (self.situation.ego.body.row.limits.length + row.limits.length)

    @property
    def longer(self) -> float:
        """How much nearer [m] the two are to each other, nose to tail, than two cars whose middles are as far apart."""
        return max(0.0, self.middles - AdversaryKind.CAR.row.limits.length)

    def headway(self, low: float, high: float, caught_up: float = 0.0) -> None:
        """From where to where [s] before or behind the ego it may be, nose to tail, if no distance was said.

        Args:
            low: The least [s].
            high: The most [s].
            caught_up: How far [m] the ego comes up to it until it is as near.
        """
        speed, middles = self.ego.speed, self.middles + caught_up
        self.reach(middles + max(low * speed, NEAREST), middles + max(high * speed, NEAREST + 1.0))

    def ahead(self, low: float, high: float) -> None:
        """From where to where [m] ahead it may be, if that was not said: farther where the ego comes faster."""
        self.reach(low * self.found.further, low * self.found.further + high - low)

    @property
    def nose(self) -> float:
        """How much farther [m] its middle is than what was said of how far it is: that is from nose to tail, or not."""
        return self.middles if self.one.starts.where in NOSE_TO_TAIL else 0.0

    def reach(self, low: float, high: float, meaning: str = "how far ahead of the ego it is") -> None:
        """From where to where [m] it may be, if that was not said."""
        if (said := self.one.starts.distance) is not None:
            low, high = (end + self.nose for end in said.drawn(low - self.nose, high - self.nose))
        path = f"others.{self.one.id}.starts.distance" if said is not None else ""
        self.numbers.measure("Y", low, high, "m", meaning, path)

    def at_event(self, low: float, high: float, there: str, meaning: str, most: float = 0.0) -> str:
        """Where along the ego's way it is that is where the ego's way, or the road, has something: text of Scenic.

        Args:
            low: How far [m] beyond where that begins it is at least; below 0 before it.
            high: How far at most.
            there: What is told of where it is, as "the crosswalk is".
            meaning: Of the parameter, if no distance was said.
            most: How far beyond it may be said to be, if that is more.

        Raises:
            NotBuilt: It was said to be elsewhere.
        """
        if (said := self.one.starts.distance) is None:
            before = high < 0.0
            self.reach(*((-high, -low) if before else (low, high)), meaning)
            return f"egoRoute.eventAt {'-' if before else '+'} $Y"
        event = self.found.route.eventAt
        nearest, farthest = event + low - self.nose, event + max(high, most) - self.nose
        if said.high < nearest or said.low > farthest:
            at_crosswalk = self.one.starts.where is Where.CROSSING
            anywhere = f", or say starts.where: {Where.ROADSIDE}, which may be anywhere" if at_crosswalk else ""
            raise NotBuilt(
                f"others.{self.one.id}.starts.distance: {said}: {there} {nearest:.0f} to {farthest:.0f} m ahead of the"
                f" ego there; leave the distance out{anywhere}"
            )
        self.reach(event + low, event + high)
        return "$Y"

    @property
    def more(self) -> str:
        """The room that is added to a place ahead."""
        return f" + {self.room:g}" if self.room else ""

    @property
    def less(self) -> str:
        """The room that is taken off a place behind."""
        return f" {'-' if self.room > 0.0 else '+'} {abs(self.room):g}" if self.room else ""


def bolts(one: Other) -> bool:
    """Whether it is an animal on the road of which nothing else is said: it runs over it when the ego comes."""
    return one.kind.is_animal and one.starts.where is Where.AHEAD and not one.does and one.starts.facing is None


def between(one: Other, speed: float) -> float:
    """How much room [m] is between those who are in a row, more where they drive at a speed [m/s]."""
    drives = one.kind.row.body.row.motorised and not stands_first(one)
    return max(ROOM, APART * min(speed, slow_speed(one) or speed)) if drives else ROOM


def slow_speed(one: Other) -> float | None:
    """How fast [m/s] somebody goes along who was said to do so at a speed, or slowly; None if nothing was said."""
    first = one.does[0] if one.does else None
    said = one.starts.speed or (first.speed if first is not None and first.act in GOES_ON else None)
    if said is not None:
        return None if said.than_ego else said.most
    return one.kind.row.body.row.slow if goes_slowly(one) else None


FROM_A_STAND = acts_of(Tempo.STANDS, Tempo.SETS_OFF)
"""What is begun standing, wherever somebody is."""


def stops_ahead(one: Other) -> bool:
    """Whether somebody stops in the ego's lane, in which it goes before it."""
    stops = any(deed.act in STOPS for deed in one.does)
    return one.starts.where is Where.AHEAD and stops and not stands_first(one)


def is_still(one: Other) -> bool:
    """Whether it was said to have no speed when it begins."""
    said = one.starts.speed
    return said is not None and not said.than_ego and said.high <= 0.0


def stands_first(one: Other) -> bool:
    """Whether somebody stands when it begins: a door is opened standing, too."""
    first = one.does[0].act if one.does else None
    stands = FROM_A_STAND | acts_of(Heads.FROM_EDGE) | {Act.OPEN_DOOR}
    return is_still(one) or first in stands or one.kind.moves is Moves.LIES


def goes_slowly(one: Other) -> bool:
    """Whether somebody goes along slowly from the first, as was said without a number."""
    first = one.does[0] if one.does else None
    along = first is not None and first.act in GOES_ON
    return along and first is not None and first.manner is Manner.SLOW and first.speed is None


_OVER = {
    Meets.ACROSS: (acts_of(Heads.ACROSS, Heads.IN), ENDS),
    Meets.THROUGH: (acts_of(Heads.THROUGH, Heads.ACROSS, Heads.TURNS), ENDS),
}
"""What leads somebody over the ego's way, and what ends that in it."""


def stops_on_its_way(meets: Meets, deeds: Sequence[Deed], k: int) -> bool:
    """Whether somebody stops in its k-th deed where the ego goes, over whose way it was going by the deed before."""
    if not 1 <= k < len(deeds) or meets not in _OVER or deeds[k].when is not None:
        return False
    goes, ends = _OVER[meets]
    return deeds[k - 1].act in goes and deeds[k].act in ends


def stops_in_the_way(meets: Meets, deeds: Sequence[Deed]) -> bool:
    """Whether somebody stops where the ego goes, in any of its deeds."""
    return any(stops_on_its_way(meets, deeds, k) for k in range(len(deeds)))


def passes_with(one: Other, hidden: Other) -> bool:
    """Whether somebody comes the other way and drives on, before another who is hidden behind it."""
    goes = not stands_first(one) and all(deed.act in PLAIN for deed in one.does)
    return hidden.hidden_by == one.id and goes and one.starts.where is hidden.starts.where is Where.ONCOMING


ENDS_THERE = ENDS | HALTS
"""What ends the way of somebody where it is."""


def stays_after_turning(deeds: Sequence[Deed], k: int) -> bool:
    """Whether somebody comes over our lane by its k-th deed, turns back, and stays where it then is."""
    acts = [deed.act for deed in deeds[k : k + 3]]
    return len(acts) == 3 and acts[0] in _OVER[Meets.ACROSS][0] and acts[1] is Act.TURN_BACK and acts[2] in ENDS_THERE
