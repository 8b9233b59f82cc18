"""What the ego does with its wheel, or beyond what it wants by itself: orders that a situation states as its deeds.

They follow each other in time. They begin when the ego is near to whom it does so for, so that all are begun before it
is there; where nobody is ahead, at a time or a place.
"""

from __future__ import annotations

import math
from collections.abc import Generator, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from chatscene.build.asked import stands_first
from chatscene.build.awaiting import awaited, waiting
from chatscene.build.leaving import ego_to_edge
from chatscene.build.ledger import Ledger
from chatscene.build.place import LANE, NEXT_LANE
from chatscene.build.relations import AGAINST, falls_behind, speed_of
from chatscene.errors import NotBuilt
from chatscene.terms.amount import Amount, Length, Speed
from chatscene.terms.lateral import aside_of_ego
from chatscene.terms.order import Order
from chatscene.terms.situation import CREEPS, EGO, LATERALS, Deed, Lateral, Other, Situation, When
from chatscene.terms.vocabulary import COMES_IN, Act, Heads, Manner, Role, Side, Where, acts_of

ASIDE = {Act.SWERVE: 2.6, Act.DRIFT: 1.7, Act.LANE_CHANGE: LANE, Act.PARK: 2.6, Act.LEAVE_ROAD: LANE}
"""How far [m] the ego leaves its line by a deed, if that was not said."""
TAKES = {Act.SWERVE: 1.6, Act.DRIFT: 2.5, Act.LANE_CHANGE: 3.0, Act.PARK: 4.0, Act.LEAVE_ROAD: 3.0}
"""How long [s] a deed lasts, if that was not said: then the ego goes back to its way, unless it changes lanes."""
_OVER = {Act.SWERVE: 0.0, Act.DRIFT: 2.2, Act.LANE_CHANGE: 1.5, Act.PARK: 1.5, Act.LEAVE_ROAD: 1.5}
_SIDES = {Act.PARK: Side.RIGHT, Act.LEAVE_ROAD: Side.RIGHT, Act.DRIFT: Side.LEFT}
KEEPS = 0.95  # of its speed that it keeps while it is steered, as far as nothing slows it
SOON = {Act.SWERVE: 1.4, Act.DRIFT: 2.2, Act.LANE_CHANGE: 2.6, Act.PARK: 3.4, Act.LEAVE_ROAD: 2.0}
"""How long [s] before they would meet the last of its deeds begins."""
SPARES = 0.8  # [s] sooner, where they are said not to touch
BY = 3.0  # [m] of which somebody who is passed at its side is to be left, beside the ego's own way
GAINS = 2.0  # [m/s²] by which an ego gains speed
EASES = 2.5  # [m/s²] by which it loses speed to have one that was said of what it does with its wheel
SLOWER = 0.6  # of its speed that an ego has that is to gain speed, if no speed was said
OFF_BRAKES = 4.0  # [m/s²] by which an ego stops that has left the road
FIRST = 2.0  # [s] after which it does
AT_ONCE = 0.5  # [m/s] by which its speed is raised at a time where it was said how fast it gains speed
OFF = 0.25  # of a speed, by which two numbers may be off a third that follows from them
LATER = 1.15  # of the way within which the ego was said to be over
SAME = 1.0  # [m/s] by which two go as fast
NOT_AHEAD = frozenset((Where.BEHIND, Where.BEHIND_BESIDE, Where.BESIDE))


@dataclass(frozen=True, slots=True, kw_only=True)
class Near:
    """When deeds of the ego begin.

    Attributes:
        whom: The label of whom the ego is then near to; empty for a time.
        within: How near [m]; of a deed that is waited for, if that one does it from the start; 0 if it is not ahead.
        since: After how many seconds [s] the next begins.
        by: After how many seconds [s] the ego has passed somebody who is ahead in its lane; 0 of others.
        after: Whether a deed is to be done before, if `whom` is one; None if it is a label.
    """

    whom: str = ""
    within: float = 0.0
    since: float = 0.0
    by: float = 0.0
    after: bool | None = None

    def order(self, **held: float) -> Order:
        """An order that begins then."""
        order = replace(Order(), **held)
        if self.after is not None:
            near = replace(order, within=round(self.within, 1))
            return waiting(near, "after" if self.after else "during", self.whom)
        return replace(order, whom=self.whom, within=round(self.within, 1)) if self.whom else order


def is_own(deed: Deed) -> bool:
    """Whether a deed is one of the wheel, or of the throttle."""
    return deed.act in ASIDE or deed.act is Act.ACCELERATE


@dataclass(frozen=True, slots=True, kw_only=True)
class Drives:
    """How the ego drives before deeds of its own.

    Attributes:
        wants: The speed it wants [m/s].
        speed: What it then has [m/s]: less, if it was to lose speed before.
        since: After how many seconds [s] it has done what comes before; 0 if nothing does.
    """

    wants: float
    speed: float
    since: float = 0.0


def own_orders(
    ledger: Ledger, deeds: Sequence[Deed], first: int, drives: Drives, sides: Mapping[str, Side]
) -> Iterator[Order]:
    """Orders for deeds of the ego that follow each other, of which all are its own.

    Args:
        ledger: What was said.
        deeds: The deeds.
        first: The number of the first.
        drives: How it drives before.
        sides: Those of others that were chosen.

    Raises:
        NotBuilt: It is to gain speed faster than it can, or by numbers of which one is not true.
    """
    begins, speed, over = _begins(ledger, deeds, first, drives, sides), drives.speed, 0.0
    for k, deed in enumerate(deeds, start=first):
        if k > first and awaited(deed) is not None:
            begins = _begins(ledger, deeds[k - first :], k, drives, sides)
        at = f"ego.does.{k}"
        ledger.take(f"{at}.act", f"{at}.to", f"{at}.whom", *((f"{at}.manner",) if deed.manner is Manner.SUDDEN else ()))
        if deed.when is not None and (k > first or drives.since):  # its own deeds come one after the other
            waits = {name: getattr(deed.when, name) or "" for name in ("after", "during")}
            ledger.take(*(f"{at}.when.{name}" for name, said in waits.items() if said.startswith(f"{EGO}.")))
        if deed.act is Act.ACCELERATE:
            speed, lasts = yield from _gains(ledger, deed, at, begins, replace(drives, speed=speed))
        else:
            lasts, does = _lasts(ledger, deed, at), deed
            if begins.by > 0.0 and deed.act is Act.SWERVE and deed.time is None and deed.distance is None:
                lasts, does = max(lasts, begins.by), replace(deed, distance=Length(BY, BY))
            from_there = over if deed.act is Act.LANE_CHANGE else 0.0
            yield from _aside(ledger, does, at, begins, lasts, speed, sides, from_there)
            over += _to_left(ledger.situation, does, sides) if deed.act is Act.LANE_CHANGE else 0.0
        begins = replace(begins, since=round(begins.since + lasts, 2))


def _aside(
    ledger: Ledger,
    deed: Deed,
    at: str,
    begins: Near,
    lasts: float,
    speed: float,
    sides: Mapping[str, Side],
    from_there: float,
) -> Iterator[Order]:
    far, aside, side = _far(ledger.situation, deed, sides), _comes_aside(deed), _side_of(ledger.situation, deed, sides)
    _check_within(deed, at, lasts * speed)
    ledger.take(f"{at}.distance", *(f"{at}.lateral.{name}" for name in LATERALS))
    if deed.lateral is not None and deed.lateral.side is side:
        ledger.take(f"{at}.lateral.side")
    left = from_there + _to_left(ledger.situation, deed, sides)
    if aside is not None:  # how fast it comes aside, and not along
        lasts = max(lasts, far / aside.high)
    since, over = round(begins.since, 2), min(_OVER[deed.act] if aside is None else far / aside.high, lasts)
    if deed.act is Act.LEAVE_ROAD:
        lasts = over + speed / OFF_BRAKES
    keeps = 0.0 if deed.act in acts_of(Heads.EDGE) else round(KEEPS * speed, 2)
    if deed.speed is not None:
        ledger.take(f"{at}.speed")
    stays = deed.act in acts_of(Heads.EDGE, Heads.OVER)
    if deed.speed is not None and aside is None:
        keeps = deed.speed.near(keeps) or deed.speed.most
        if (slows := _slows(deed, speed)) > 0.0:  # it has that speed when it begins to
            since_when, till = round(max(since, slows), 2), math.inf if stays else round(since + lasts, 2)
            speed = deed.speed.most
            yield begins.order(at_most=speed, since=since_when, till=max(till, since_when), braking=EASES)
    yield begins.order(aside=left, over=over, since=since, till=math.inf if stays else round(since + lasts, 2))
    if keeps:
        yield begins.order(at_least=keeps, since=since, till=round(since + lasts, 2))
    if deed.act in acts_of(Heads.EDGE):
        braking = round(max(2.0 * speed / lasts, 1.5), 2)  # in the second half of it
        if deed.act is Act.LEAVE_ROAD:
            braking = OFF_BRAKES
        yield begins.order(at_most=0.0, since=round(since + lasts, 2), braking=braking)


def _check_within(deed: Deed, at: str, way: float) -> None:
    """Hold that the ego is in the next lane within the way that was said, where it takes `way` [m].

    Raises:
        NotBuilt: It is not.
    """
    if deed.act is Act.LANE_CHANGE and deed.distance is not None and way > LATER * deed.distance.most:
        raise NotBuilt(
            f"{at}.distance: {deed.distance}: at its speed the ego is in the next lane after {way:.0f} m;"
            " say that, or a slower ego"
        )


def _to_left(situation: Situation, deed: Deed, sides: Mapping[str, Side]) -> float:
    """How far [m] to the left the ego goes by a deed of its wheel."""
    far = _far(situation, deed, sides)
    return far if _side_of(situation, deed, sides) is Side.LEFT else -far


def _comes_aside(deed: Deed) -> Speed | None:
    """How fast the ego comes aside by a deed, and not along, if that was said."""
    return deed.speed if deed.act is Act.DRIFT and deed.speed is not None and deed.speed.high < CREEPS else None


def _far(situation: Situation, deed: Deed, sides: Mapping[str, Side]) -> float:
    """How far [m] the ego leaves its line by a deed."""
    usual = ASIDE[deed.act]
    if deed.act is Act.LEAVE_ROAD:
        usual = ego_to_edge(situation, _side_of(situation, deed, sides))
    if deed.distance is not None and deed.act is not Act.LANE_CHANGE:  # of which it says within what way
        usual = deed.distance.near(usual)
    if deed.lateral is None:
        return usual
    return _far_aside(situation, deed.lateral, _side_of(situation, deed, sides), sides, usual)


def _far_aside(situation: Situation, lateral: Lateral, side: Side, sides: Mapping[str, Side], usual: float) -> float:
    """How far [m] the ego leaves its line to be where it was said to be across the road.

    An overlap, or room beside it, is with somebody on that side: in the next lane, or against it.
    """
    name, said = next(((name, one) for name in LATERALS if (one := getattr(lateral, name)) is not None), ("", None))
    if not isinstance(said, Amount):
        return usual
    ego = situation.ego.body.row.limits
    if name == "offset":
        return said.near(usual)
    if name == "edge":
        return 0.5 * LANE - said.near(0.0)
    if name == "beyond":
        return 0.5 * (LANE + ego.width) + said.near(0.0)
    beside = (one for one in situation.others if _lies_to(one, sides) is side)
    one = next(beside, next(iter(situation.adversaries)))
    away = 0.0 if _lies_to(one, sides) is None else LANE
    row = one.kind.row.body.row.limits
    share = 0.5 * sum(said.drawn(0.05, 0.95) if name == "overlap" else said.drawn(0.2, 2.0))
    return abs(away - aside_of_ego(name, share, ego.width, row.width))


def _lies_to(one: Other, sides: Mapping[str, Side]) -> Side | None:
    """On which side of the ego's lane the lane of somebody lies; None of who is in its own."""
    if one.starts.where is Where.ONCOMING:
        return Side.LEFT
    return one.starts.side or sides.get(one.id) if one.starts.where in NEXT_LANE else None


def _slows(deed: Deed, speed: float) -> float:
    """How long [s] the ego takes to lose speed to what was said of a deed of its wheel; 0 where it need not."""
    along = deed.act is not Act.DRIFT or deed.speed is None or deed.speed.high >= CREEPS
    if deed.speed is None or deed.act not in ASIDE or not along:
        return 0.0
    return max(speed - deed.speed.most, 0.0) / EASES


def _gains(
    ledger: Ledger, deed: Deed, at: str, begins: Near, drives: Drives
) -> Generator[Order, None, tuple[float, float]]:
    """Orders by which the ego gains speed; gives what it then has [m/s], and how long that takes [s]."""
    to, now, gain = _from_to(ledger, deed, at, drives)
    lasts = (to - now) / gain
    since = begins.since if begins.whom or begins.since else FIRST
    held = drives.wants if drives.since else now  # what comes before has it lose speed
    if held < max(to, drives.wants):
        if begins.whom:
            yield begins.order(at_most=round(held, 2), ends=True)
        if since:
            yield begins.order(at_most=round(held, 2), till=since)
    if deed.time is not None or deed.acceleration is not None:
        steps = max(1, math.ceil((to - now) / AT_ONCE))
        for n in range(steps):
            has, ends = now + (to - now) * (n + 1) / steps, since + lasts * (n + 1) / steps
            span = {"since": round(since + lasts * n / steps, 2), "till": round(ends, 2)}
            yield begins.order(at_most=round(has, 2), at_least=round(has, 2), **span)
        since, lasts = round(since + lasts, 2), lasts + 1.0
        yield begins.order(at_least=round(KEEPS * to, 2), since=since, till=round(since + 1.0, 2))
    else:
        lasts += 1.0
        yield begins.order(at_least=round(KEEPS * to, 2), since=since, till=round(since + lasts, 2))
    return to, lasts if begins.whom or begins.since else FIRST + lasts


def _from_to(ledger: Ledger, deed: Deed, at: str, drives: Drives) -> tuple[float, float, float]:
    """To which speed and from which an ego gains speed [m/s], and how fast [m/s²]: as was said of it.

    Raises:
        NotBuilt: It cannot gain speed so fast, or the numbers that were said cannot all be true.
    """
    said = {name: getattr(deed, name) for name in ("speed", "acceleration", "time") if getattr(deed, name) is not None}
    ledger.take(*(f"{at}.{name}" for name in said))
    to = drives.wants if deed.speed is None else deed.speed.near(drives.wants)
    less = drives.speed < to - AT_ONCE  # it has less before
    now = drives.speed if less else SLOWER * to
    gain = GAINS if deed.acceleration is None else deed.acceleration.near(GAINS)
    if deed.time is not None:
        lasts = deed.time.near((to - now) / gain)
        if not less and deed.acceleration is not None:
            now = to - gain * lasts
        by = to - now
        if now < 0.0 or (deed.acceleration is not None and abs(gain * lasts - by) > OFF * by):
            most = to / gain if now < 0.0 else by / gain
            raise NotBuilt(
                f"{at}.time: {deed.time}: up to {3.6 * to:.0f} km/h, {deed.acceleration} takes the ego"
                f" {'at most ' if now < 0.0 else ''}{most:.1f} s; say that, or leave one of the numbers out"
            )
        gain = by / lasts
    most = ledger.situation.ego.body.row.limits.throttle
    if gain > most:
        path = "acceleration" if deed.acceleration is not None else "time"
        least = f"{(to - now) / most + 0.05:.1f} s at least" if path == "time" else f"{most:g} m/s² at most"
        raise NotBuilt(f"{at}.{path}: {said[path]}: the ego cannot gain speed so fast; say {least}")
    return to, now, gain


def fastest(deeds: Sequence[Deed], speed: float) -> float:
    """What an ego wants in the end [m/s] that wants a speed at first [m/s], and is to gain more than that."""
    gained = (deed.speed.near(speed) for deed in deeds if deed.act is Act.ACCELERATE and deed.speed is not None)
    return max(speed, *gained, speed)


def _lasts(ledger: Ledger, deed: Deed, at: str) -> float:
    usual = TAKES[deed.act]
    if deed.time is None:
        return usual
    ledger.take(f"{at}.time")
    return deed.time.near(usual)


def _begins(ledger: Ledger, deeds: Sequence[Deed], first: int, drives: Drives, sides: Mapping[str, Side]) -> Near:
    """When the first of them begins: as was said, or so early that the last is begun before the ego meets somebody.

    Before a deed of the wheel at a speed that was said, it has the time to lose speed to that.
    """
    situation, when, speed = ledger.situation, deeds[0].when or When(), drives.speed
    slows = round(_slows(deeds[0], speed), 2)
    at = f"ego.does.{first}.when"
    waits = awaited(deeds[0]) if when.ego_within is None else None
    delay = 0.0
    if waits is not None:
        ledger.take(f"{at}.{waits[0]}")
        if when.delay is not None:
            ledger.take(f"{at}.delay")
            delay = when.delay.near(0.0)
    awaits = None if waits is None else Near(whom=waits[1], after=waits[0] == "after", since=round(delay, 2))
    named = (when.after or when.during or "").partition(".")[0]
    who = when.of or (named if named not in ("", EGO) else deeds[0].whom)
    others = [one for one in situation.others if one.starts.where not in NOT_AHEAD]
    whom = next((one for one in others if one.id == who), None) if who else next(iter(_in_the_way(others)), None)
    if awaits is not None and whom is None:
        return awaits
    if whom is None or (deeds[0].act is Act.ACCELERATE and when.ego_within is None and not named):
        level = (one for one in situation.others if one.starts.where is Where.BESIDE)  # who cannot be so for long
        soon = deeds[0].act is Act.ACCELERATE or any(falls_behind(situation, one, speed) > SAME for one in level)
        return Near(since=max(drives.since, slows) or (0.0 if soon else FIRST))
    ledger.take(*(f"{at}.{name}" for name in ("after", "during", "of", "ego_within") if getattr(when, name)))
    middles = 0.5 * (situation.ego.body.row.limits.length + whom.kind.row.body.row.limits.length)
    seconds = sum(TAKES.get(deed.act, FIRST) for deed in deeds[:-1]) + SOON.get(deeds[-1].act, FIRST)
    if (slow := _comes_aside(deeds[-1])) is not None:  # and is there when they meet
        seconds = max(seconds, _far(situation, deeds[-1], sides) / slow.high)
    if situation.contact is not None and not situation.contact.happens:
        seconds += SPARES
    comes = closing(situation, whom, speed)
    if awaits is not None:
        return replace(awaits, within=comes * (seconds + slows) + middles)
    if isinstance(when.ego_within, Length):
        return Near(whom=whom.id, within=when.ego_within.near(comes * seconds) + middles + comes * slows, since=slows)
    if when.ego_within is not None:
        seconds = when.ego_within.near(seconds)
    by = seconds + 2 * middles / comes if _is_ahead(whom) else 0.0
    return Near(whom=whom.id, within=comes * (seconds + slows) + middles, since=slows, by=by)


def _in_the_way(others: Sequence[Other]) -> list[Other]:
    """Those whom the ego does so for: first who stands in its lane, then who meets it."""
    return sorted(others, key=lambda one: (not (_is_ahead(one) and stands_first(one)), one.role is not Role.ADVERSARY))


def _is_ahead(one: Other) -> bool:
    return one.starts.where is Where.AHEAD


def _side_of(situation: Situation, deed: Deed, sides: Mapping[str, Side]) -> Side:
    """To which side the ego goes by a deed: if none was said, to where somebody is met beside its lane."""
    if deed.to is None and deed.lateral is not None and deed.lateral.side is not None:
        return deed.lateral.side
    usual = _SIDES.get(deed.act, Side.LEFT)
    round_another = any(_is_ahead(one) and stands_first(one) for one in situation.others)
    if deed.to is not None or not (deed.act is Act.DRIFT or (deed.act is Act.SWERVE and round_another)):
        return deed.to or usual
    met = (one for one in situation.adversaries if not any(done.act in COMES_IN for done in one.does))
    named = (one.starts.side or sides.get(one.id) for one in met if one.starts.where.row.sided)
    return next((side for side in named if side is not None), usual)


def closing(situation: Situation, whom: Other, speed: float) -> float:
    """How fast [m/s] the ego and somebody come nearer to each other."""
    row = whom.kind.row.body.row
    if stands_first(whom):
        own = 0.0
    elif row.motorised and whom.starts.where in AGAINST:
        own = speed_of(situation, whom.id, speed)
    else:
        said = next((one for one in (whom.starts.speed, *(deed.speed for deed in whom.does)) if one is not None), None)
        own = 0.7 * row.fast if said is None else said.near(0.7 * row.fast)
    match whom.starts.where:
        case where if where in AGAINST:
            return speed + own
        case Where.AHEAD | Where.AHEAD_BESIDE:
            return max(speed - own, 0.3 * speed)
        case _:
            return math.hypot(speed, own)
