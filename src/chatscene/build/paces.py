"""How fast somebody is before and after each deed: each gains or loses so much that a watcher sees it.

Speeds that were said are kept; those that were not are chosen about them. A deed that would gain or lose too little of
what was said is refused, with what could be said instead.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets, goes_slowly, stands_first
from chatscene.build.numbers import PACES, Numbers
from chatscene.build.relations import BEHIND, GAINS, GAINS_AGAINST, PASSES, speed_of
from chatscene.build.timing import Body
from chatscene.build.towards import done_to
from chatscene.errors import NotBuilt
from chatscene.situations.phrases import one_of, one_seen
from chatscene.terms.seeing import LOST, SHARE_LOST, gain_of, loss_of
from chatscene.terms.situation import EGO, Deed
from chatscene.terms.vocabulary import PLAIN, SIDEWAYS, Act, Heads, Where, acts_of

if TYPE_CHECKING:
    from chatscene.build.actor import Actor
    from chatscene.build.deeds import Steps

SEEN = 1.1  # times what a watcher must see at least
HELD_FROM = 0.95  # of the speed that a pedal holds, from which on it is held
CREEPS = 0.3  # [m/s], nobody goes slower on purpose
ABOUT = 0.85  # of a speed that was said, the least that a watcher takes for it
BY_ONE_THAT_STANDS = 0.5, 0.8  # of its speed, from and to, that somebody has who comes by an ego that stands
FOLLOWS = 0.64  # of the ego's speed, the least of who goes with it
LOST_MORE = 1.3  # times that, the most that somebody loses who is to come up again
CRAWLS = 1.0  # [m/s]: who must be slower before it gains speed gains it from a stand
AT_ONE_SPEED = PLAIN | acts_of(Heads.TURNS, Heads.ACROSS, Heads.IN)
_COMES_UP = acts_of(Heads.BY, Heads.LEVEL, Heads.CLOSE) | {Act.EXIT}


class Pace(StrEnum):
    """What a deed does to the speed of who does it."""

    KEEPS = "keeps"  # goes at a speed, that which it had if none was said
    GAINS = "gains"
    LOSES = "loses"
    STANDS = "stands"  # stands then, and goes on as fast as it was used to
    ENDS = "ends"  # has another speed then, which does not matter


@dataclass(slots=True)
class Speed:
    """A speed that somebody has for some time.

    Attributes:
        name: The parameter; empty for the ego's own speed, which it keeps to at first.
        low: The least it may be [m/s].
        high: The most.
        said: Whether it was said.
    """

    name: str
    low: float
    high: float
    said: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Change:
    """A deed that changes the speed.

    Attributes:
        deed: Its number.
        before: The speed that it had.
        after: The speed that it then has.
        gains: Whether that is more.
    """

    deed: int
    before: Speed
    after: Speed
    gains: bool


class Paces:
    """The speeds of one road user.

    Args:
        numbers: Its parameters, which are narrowed.
        body: What its body can do.
        path: Of its facts.
        first: The speed that it has before its first deed.
    """

    def __init__(self, numbers: Numbers, body: Body, path: str, first: Speed) -> None:
        self._numbers = numbers
        self._body = body
        self._path = path
        self._used = first if first.high > 0.0 else Speed("SPEED", *numbers.ranges["SPEED"][:2])
        self._now = first
        self._speeds = [first]
        self._changes: list[Change] = []
        self.before: list[Speed] = []
        self.after: list[Speed] = []

    def add(self, k: int, pace: Pace, said: tuple[float, float] | None, name: str) -> None:
        """The next deed, with the speed that was said of it and the parameter that it has."""
        if pace is not Pace.GAINS and self._now.high <= 0.0:
            self._now = self._used
        self.before.append(self._now)
        match pace:
            case Pace.KEEPS if said is not None:
                self._now = self._used = self._new(name, *said, said=True)
            case Pace.GAINS | Pace.LOSES:
                gains = pace is Pace.GAINS
                top = self._numbers.row.limits.fastest
                then = self._new(name, *(said or (CREEPS, top)), said=said is not None)
                self._changes.append(Change(deed=k, before=self._now, after=then, gains=gains))
                self._now = then
            case Pace.STANDS:
                self._now = self._new("", 0.0, 0.0, said=True)
            case Pace.ENDS:
                self._now = self._used
            case _:
                pass
        self.after.append(self._now)

    def _new(self, name: str, low: float, high: float, *, said: bool) -> Speed:
        self._speeds.append(one := Speed(name, low, high, said))
        return one

    def held(self, speed: Speed) -> float:
        """The share of a speed that is wanted from which on it is held."""
        ends = (speed.low, speed.high) if speed.high > 0.0 else (1.0,)
        return round(HELD_FROM * min(self._body.holds(wish) / wish for wish in ends if wish > 0.0), 3)

    def settle(self, deeds: Sequence[Deed]) -> None:
        """Choose the speeds that were not said.

        Raises:
            NotBuilt: What was said cannot be seen.
        """
        gain = gain_of(self._numbers.row) * SEEN
        for one in reversed(self._changes):
            if one.gains:
                wish = one.after.low if one.after.said else one.after.high
                _lower(one.before, HELD_FROM * self._body.holds(wish) - gain)
            elif one.after.said:
                least = min(one.after.high + LOST * SEEN, one.after.high / (1 - SHARE_LOST * SEEN))
                _raise(one.before, least)
                if not one.before.said and (share := self.held(one.before)) > 0.0:
                    _raise(one.before, least / share)
        for one in self._changes:
            if one.gains and not one.after.said:
                one.after.low = max(one.after.low, min((one.before.high + gain) / HELD_FROM, one.after.high))
                one.after.high = min(one.after.high, max(one.after.low, one.after.low + gain))
            elif not one.after.said:
                one.after.low, one.after.high = _lost(one, _comes_up_again(deeds[one.deed + 1 :]))
            self._check(one, deeds[one.deed])
        for speed in self._speeds:
            if speed.name and not speed.said:
                self._numbers.narrow(speed.name, speed.low, speed.high)

    def _check(self, one: Change, deed: Deed) -> None:
        before, after, name = one.before, one.after, f"{self._path}.does.{one.deed}.act: {deed.act}"
        least = gain_of(self._numbers.row)
        was = before.low if before.name else before.high  # who keeps to the ego is about as fast as it
        most = after.high
        if self._numbers.row.motorised and not after.said:
            most = min(most, self._body.holds_pressed(self._numbers.range_of("THROTTLE")[0]))
        if one.gains and most < was + least and was > CREEPS:
            raise NotBuilt(f"{name} {_told(was, most)}; say {_kmh(was + least)} at least")
        if before.low > self._numbers.row.limits.fastest:
            kind, most = one_seen(self._numbers.row.scenic), self._numbers.row.limits.fastest
            raise NotBuilt(f"{name} to {_kmh(after.low)} is not visible for {kind}, which drives at most {_kmh(most)}")
        least = loss_of(before.high)
        if not one.gains and after.low > before.high - least:
            raise NotBuilt(f"{name} {_told(before.high, after.low)}; say {_kmh(before.high - least)} at most")


def _lost(one: Change, comes_up: bool) -> tuple[float, float]:
    """The least and the most speed [m/s] of who has lost some; of who comes up again no less than is seen."""
    if not comes_up:
        return 0.3 * one.before.low, 0.6 * one.before.low
    seen = loss_of(one.before.high) * SEEN
    return max(CREEPS, one.before.high - LOST_MORE * seen), one.before.high - seen


def _comes_up_again(later: Sequence[Deed]) -> bool:
    """Whether somebody who has lost speed is to pass the ego, to keep to it, or to leave by a ramp, by what it does."""
    return any(deed.act in _COMES_UP and done_to(deed) == EGO for deed in later)


def paces_of(actor: Actor, steps: Sequence[Steps], body: Body) -> Paces:
    """How fast somebody is before and after each of its deeds.

    Args:
        actor: Who.
        steps: For each deed, how it is done.
        body: What its body can do.

    Raises:
        NotBuilt: A speed that was said is more than it can, or cannot be seen.
    """
    said = [_said_speed(actor, k, one, body) for k, one in enumerate(steps)]

    def paced(first: Speed) -> Paces:
        paces = Paces(actor.numbers, body, actor.path, first)
        for k, (one, (name, speed)) in enumerate(zip(steps, said, strict=True)):
            passed = actor.deeds[k].act is Act.OVERTAKE and one.pace is Pace.KEEPS  # and is slow no more
            paces.add(k, Pace.ENDS if passed else one.pace, speed, name)
        paces.settle(actor.deeds)
        return paces

    try:
        return paced(_first(actor, as_ego=True))
    except NotBuilt:
        if _gains_with_ego(actor, steps):
            raise  # a slower ego may do: who is much slower than it would be left behind
        return paced(_first(actor, as_ego=False))


def _gains_with_ego(actor: Actor, steps: Sequence[Steps]) -> bool:
    """Whether somebody beside or behind an ego of which no speed was said gains speed first, to none that was said."""
    free = actor.ledger.situation.ego.speed is None and not actor.numbers.is_said("SPEED")
    there = actor.one.starts.where in BEHIND | {Where.BESIDE} and keeps_distance(actor)
    gains = next((k for k, one in enumerate(steps) if one.pace is not Pace.KEEPS), None)
    return free and there and gains is not None and steps[gains].pace is Pace.GAINS and not actor.deeds[gains].speed


def _first(actor: Actor, *, as_ego: bool) -> Speed:
    """The speed that somebody has before its first deed."""
    said = actor.numbers.is_said("SPEED") or goes_slowly(actor.one)
    if stands_first(actor.one):
        return Speed("", 0.0, 0.0, said=True)
    keeps_up = actor.along_speed > actor.ego_speed - CRAWLS
    if as_ego and not said and keeps_up and keeps_distance(actor):
        return Speed("", slowest_with_ego(actor), actor.along_speed, said=True)  # the ego's, or less behind others
    low, high, *_ = actor.numbers.ranges["SPEED"]
    return Speed("SPEED", low, high, said=said)


def slowest_with_ego(actor: Actor) -> float:
    """The least speed [m/s] of who keeps its distance to the ego: else both would slow down for each other."""
    return actor.along_speed if actor.leads else FOLLOWS * actor.along_speed


def keeps_distance(actor: Actor) -> bool:
    """Whether somebody goes as fast as the ego until its first deed is due."""
    motorised = actor.one.kind.row.body.row.motorised
    return actor.stand.meets is Meets.ALONG and motorised and not actor.stand.rolls


def _said_speed(actor: Actor, k: int, steps: Steps, body: Body) -> tuple[str, tuple[float, float] | None]:
    """The parameter of the speed of a deed, and what was said of it."""
    deed, numbers, at = actor.deeds[k], actor.numbers, f"{actor.path}.does.{k}"
    general = {Pace.GAINS: "FAST", Pace.LOSES: "SLOW"}.get(steps.pace, "SPEED")
    own = f"{general}_{k}"
    bound = steps.binds.get("speed") == general
    if bound and deed.speed is not None:
        own = general if general == "SPEED" and actor.is_its_speed(k) else own
        numbers.bind(own, deed.speed, f"{at}.speed")
        low, high, *_ = numbers.ranges[own]
        if steps.pace is Pace.KEEPS:
            check_held(actor, low, f"{at}.speed: {deed.speed}")
        if steps.pace is Pace.KEEPS and body.falls_short(low):
            low, high = body.wish_for(low), body.wish_for(high)
            numbers.narrow(own, low, high)
        return own, (low, high)
    aside = deed.act in SIDEWAYS or (deed.act is Act.ENTER and actor.stand.meets is Meets.ALONG)
    if deed.manner in PACES and aside:
        return own, None  # it goes aside at the speed that it has
    if deed.manner in PACES and deed.speed is None and bound and steps.pace is Pace.KEEPS:
        actor.ledger.take(f"{at}.manner")
        low, high, *_ = numbers.ranges[PACES[deed.manner]]
        if deed.act in AT_ONE_SPEED and in_one_manner(actor):
            return "SPEED", numbers.ranges["SPEED"][:2]  # as it comes
        own = "SPEED" if in_one_manner(actor) else own
        numbers.narrow(own, low, high)
        return own, (low, high)
    return own, None


def check_held(actor: Actor, speed: float, said: str) -> None:
    """Hold that somebody on wheels is about as fast as was said, once it is under way.

    Raises:
        NotBuilt: Its engine does not hold so much.
    """
    most = Body(actor.limits, actor.walks).fastest if actor.one.kind.row.body.row.motorised else speed
    if most < ABOUT * speed:
        raise NotBuilt(f"{said} is more than {one_of(actor.one.kind)} can drive: at most {_kmh(most)}")


def in_one_manner(actor: Actor) -> bool:
    """Whether somebody does all that it does slowly, or all of it fast: nothing at a speed that was said."""
    at_speeds = any(one.speed is not None for one in actor.deeds)
    return not at_speeds and len({one.manner for one in actor.deeds if one.manner in PACES}) == 1


def set_passing_speed(actor: Actor, k: int) -> None:
    """Let somebody be so much faster than whom it passes in its k-th deed that it gets by.

    Raises:
        NotBuilt: It is not, or no such body is.
    """
    deed, speed_name, numbers = actor.deeds[k], f"FAST_{k}", actor.numbers
    whom = done_to(deed)
    passed = speed_of(actor.ledger.situation, whom, actor.ego_speed)
    least, most = passed + PASSES, actor.limits.fastest
    if not actor.one.kind.row.body.row.motorised:
        most = min(most, Body(actor.limits, actor.walks).fastest)
    can = most
    low, high = (passed + gain for gain in (GAINS if actor.stand.meets is Meets.ALONG else GAINS_AGAINST))
    if whom == EGO and actor.ego.stands:
        low, high = (share * actor.along_speed for share in BY_ONE_THAT_STANDS)
    if deed.speed is not None:
        numbers.bind(speed_name, deed.speed, f"{actor.path}.does.{k}.speed")
        low, high, *_ = numbers.ranges[speed_name]
        most = high
    elif numbers.is_said("SPEED") and numbers.ranges["SPEED"][1] >= least:
        low, high, *_ = numbers.ranges["SPEED"]
    if most < least:
        name = "ego" if whom == EGO else whom
        slower = f"{'an ego' if whom == EGO else whom} at {math.floor(3.6 * (can - PASSES))} km/h at most"
        raise NotBuilt(
            f"{actor.path}.does.{k}: {one_of(actor.one.kind)} at {_kmh(most)} does not overtake "
            f"{'an ego' if whom == EGO else whom} at {_kmh(passed)}; say "
            f"{f'{_kmh(least)} at least, or a slower {name}' if can >= least else slower}"
        )
    numbers.narrow(speed_name, min(max(low, least), most), min(max(high, least), most))


def _told(before: float, after: float) -> str:
    return f"cannot be seen from {_kmh(before)} to {_kmh(after)}"


def _kmh(speed: float) -> str:
    return f"{3.6 * speed:.0f} km/h"


def _lower(speed: Speed, most: float) -> None:
    """Let a speed that was not said be no more than something."""
    if not speed.said:
        speed.high = max(CREEPS, min(speed.high, most))
        speed.low = min(speed.low, speed.high)


def _raise(speed: Speed, least: float) -> None:
    if not speed.said:
        speed.low = max(speed.low, least)
        speed.high = max(speed.low, speed.high)
