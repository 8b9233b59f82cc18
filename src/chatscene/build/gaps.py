"""Gaps: how much room somebody leaves who comes in before the ego or another, and how long it takes to get ahead."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets, goes_slowly
from chatscene.build.contact import misses
from chatscene.build.cutting_in import SLOWER, comes_before, gets_before, leaves, seconds_to_get_before, set_speed
from chatscene.build.deeds import OWN, SLOW_FOR
from chatscene.build.over_lanes import lane_after
from chatscene.build.place import GOES_OVER, NEXT_LANE
from chatscene.build.relations import speed_of
from chatscene.build.sideways import glides_for, seconds_over
from chatscene.build.timing import Body
from chatscene.build.towards import done_to, to_whom
from chatscene.errors import NotBuilt
from chatscene.terms.situation import EGO, Deed
from chatscene.terms.vocabulary import ASIDE, GOES_ON, LOSES, Act, Heads, Manner, Role, Side, Where, acts_of

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

_MIDDLES = "(ego.length + self.length) / 2 + "
"""What is between the middles of two who leave so much room."""
_COMES_BEFORE = acts_of(Heads.BEFORE, Heads.TURNS)
_OVER = acts_of(Heads.OVER, Heads.MERGES, Heads.IN)
WAITS = 0.6  # of its speed, the least of who lets the ego come near again
BACK_OVER = 0.5  # [s] in which who comes against the ego goes back to its lane before it
SETTLES = 2.5  # [s] in which somebody who has passed another comes to be as far ahead of it as was said
HALF_BY = 0.6  # of its time beside whom it passes, in which somebody meets the ego that it does not miss
CLOSE = (1.0, 3.0)  # [m], from and to, that somebody leaves who comes in suddenly, or all but touches the ego
GETS_BY = 3.0  # [m/s] that somebody is faster at most who gets as far before another as it must be …
FALLS_BACK = 0.75  # … and the least of that one's speed
GAP_WITHIN, EASED = 1.0, 1.0  # [m] of a gap that was said; [m/s] faster than whom it passed, who is no faster
OVER_THE_LINE = 0.75  # [s] after it sets out for a lane that somebody's middle is over the line
SAME = 1.0  # [m/s] by which two go as fast
SEEN_BEFORE = 1.0  # [s] that it is seen to go beside before
LEAVES_FOR = 0.5, 2.0  # [s], from and to, that the ego needs for the room that is left, if only a bound was said
BACKS_FAR = 0.5, 5.0  # [m], from and to, that somebody backs up, if only a bound was said
BACKS = 1.5  # [m/s] that somebody backs up at, of whom only the way was said


def gap_is_said(deed: Deed) -> bool:
    """Whether the room was said that somebody leaves who cuts in, or merges."""
    return deed.act in acts_of(Heads.BEFORE, Heads.MERGES) and (deed.distance is not None or deed.time is not None)


def falls_back(actor: Actor, k: int) -> bool:
    """Whether the ego comes up to somebody who then comes in, by what was said or by its kind."""
    deed = actor.deeds[k]
    there = actor.one.starts.where in (Where.AHEAD_BESIDE, Where.ON_RAMP)
    ahead = there and all(one.act in GOES_ON for one in actor.deeds[:k])
    slow = _is_slow(actor, k) or _cannot_keep_up(actor)
    slower = slow and actor.numbers.range_of(actor.speed_in(k))[1] < actor.ego_speed - SLOWER
    over = deed.act in _OVER | {Act.CUT_IN} and (
        deed.act is not Act.LANE_CHANGE or lane_after(actor.one, actor.deeds, k) == 0
    )
    begins = deed.when is not None and deed.when.ego_within is not None  # so near that it was said when
    return over and done_to(deed) == EGO and ahead and slower and not (begins or gap_is_said(deed))


def _is_slow(actor: Actor, k: int) -> bool:
    """Whether it was said how fast it does its k-th deed, or that it goes slowly."""
    return actor.numbers.is_said(actor.speed_in(k)) or goes_slowly(actor.one)


def _cannot_keep_up(actor: Actor) -> bool:
    """Whether its kind does not hold the ego's speed."""
    return actor.one.kind.row.body.row.motorised and actor.along_speed < actor.ego_speed - SLOWER


def set_room(actor: Actor) -> None:
    """Let who falls back toward the ego be so far ahead that it is seen to go beside before it cuts in."""
    for k in range(len(actor.deeds)):
        set_speed(actor, k)
        if falls_back(actor, k) and actor.one.starts.distance is None and actor.one.starts.where is Where.AHEAD_BESIDE:
            numbers, closing = actor.numbers, _closing(actor, k)
            seen = closing * (numbers.range_of("STEADY")[1] + SEEN_BEFORE)
            least = _falls_back_to(actor, k) + seen
            _, _, unit, meaning = numbers.range_of("Y")
            numbers.measure("Y", least, least + closing, unit, meaning)


def _falls_back_to(actor: Actor, k: int) -> float:
    """How far [m] ahead of the ego somebody is at most when it begins to come over, middle to middle."""
    middles = 0.5 * (actor.ego_limits.length + actor.limits.length)
    return middles + actor.numbers.range_of(_room(actor, k))[1] + _closing(actor, k) * seconds_over(actor, k)[1]


def gets_ahead(actor: Actor, k: int, way: str, *, last: bool) -> Iterator[str]:
    """The phase in which somebody gets as far ahead as it must be before it comes into the lane, if it must.

    Args:
        actor: Who.
        k: The number of its deed.
        way: The line it goes along.
        last: Whether it does nothing then.
    """
    deed, speeds = actor.deeds[k], _speeds(actor, k)
    if deed.act is Act.LANE_CHANGE and lane_after(actor.one, actor.deeds, k) != 0:
        return
    may = deed.act in _COMES_BEFORE or (leaves_room(actor) and deed.act in _OVER) or stops_before(actor, k)
    if not (may or comes_before(actor, k) or falls_back(actor, k)):
        return
    from_behind = _from_behind(actor, k) or leaves_room(actor)
    if falls_back(actor, k):
        comes = f"{_MIDDLES}${_room(actor, k)} + max(0, ego.pose[3] - self.pose[3]) * {seconds_over(actor, k)[0]}"
        yield f"DrivePath({way}, ${actor.speed_in(k)}) until headway(egoRoute, ego, self) < {comes}"
    elif comes_before(actor, k) and not gap_is_said(deed):
        yield gets_before(actor, k, way, f"{_MIDDLES}${_room(actor, k)}")
    elif gap_is_said(deed) and keeps_its_speed(actor, k):
        ahead = f"{_MIDDLES}${_bound(actor, k)}"
        _start_far_enough(actor, k)
        yield f"DrivePath({way}, ${actor.speed_in(k)}) until {_has_room(actor, k, ahead)}"
    elif gap_is_said(deed):
        ahead = f"{_MIDDLES}${_bound(actor, k)}"
        there = f"abs(headway(egoRoute, ego, self) - ({ahead})) < {GAP_WITHIN:g}"
        yield to_whom(f"PaceOnPath({way}, ego, {ahead}, {speeds}) until {there}", deed)
    elif (
        stops_before(actor, k)
        or (deed.act in _OVER and leaves_room(actor))
        or (deed.act is Act.CUT_IN and (not last or from_behind or done_to(deed) != EGO))
    ):
        ahead = f"{_MIDDLES}${_room(actor, k)}"  # or the ego would run into it before it does the next thing
        yield to_whom(
            f"PaceOnPath({way}, ego, {ahead} + 2, {speeds}) until headway(egoRoute, ego, self) > {ahead}", deed
        )
    elif from_behind and k and actor.one.starts.where is Where.BEHIND:
        ahead = f"{_MIDDLES}${_room(actor, k)}"
        yield f"PaceOnPath({way}, ego, {ahead}, {speeds}) until headway(egoRoute, ego, self) > {ahead} - 2"


def keeps_its_speed(actor: Actor, k: int) -> bool:
    """Whether somebody who leaves a room that was said cuts in at the one speed it may have, and waits for its time."""
    deed = actor.deeds[k]
    holds = actor.numbers.is_said(actor.speed_in(k)) or _cannot_keep_up(actor)
    free = done_to(deed) == EGO and actor.stand.meets is Meets.ALONG and not actor.stand.rolls
    passed = any(one.act is Act.OVERTAKE for one in actor.deeds[:k])  # and then is no faster than the ego
    return holds and free and not passed and abs(_closing(actor, k)) > SAME


def _closing(actor: Actor, k: int) -> float:
    """By how much [m/s] the ego is faster than somebody in its k-th deed."""
    return actor.ego_speed - actor.numbers.middle(actor.speed_in(k))


def _has_room(actor: Actor, k: int, ahead: str) -> str:
    """What shows that the room is right once somebody who sets out for the ego's lane now is over its line."""
    room = f"headway(egoRoute, ego, self) - ({ahead})"
    closes = f"{_over_the_line(actor, k):.3g} * (ego.pose[3] - self.pose[3])"
    return f"{room} < {closes}" if _closing(actor, k) > 0.0 else f"{room} > {closes}"


def _over_the_line(actor: Actor, k: int) -> float:
    """How long [s] after it sets out for a lane somebody's middle is over its line: half of it all, if it glides."""
    return OVER_THE_LINE if (takes := glides_for(actor, k)) is None else max(OVER_THE_LINE, 0.25 * sum(takes))


def _start_far_enough(actor: Actor, k: int) -> None:
    """Let somebody on whom the ego closes in begin so far ahead that it has the room when it is due."""
    numbers, closing = actor.numbers, _closing(actor, k)
    if closing <= 0.0 or actor.one.starts.distance is not None or actor.first is not None or actor.stand.behind:
        return
    soon = closing * (numbers.range_of("STEADY")[1] + _over_the_line(actor, k))
    middles = 0.5 * (actor.ego_limits.length + actor.limits.length)
    low = middles + numbers.range_of(_bound(actor, k))[1] + soon
    far, most, unit, meaning = numbers.range_of("Y")
    numbers.measure("Y", max(far, low), max(most, low + closing), unit, meaning)


def _room(actor: Actor, k: int) -> str:
    """The parameter that is the room that somebody leaves of whom none was said: little where that is the danger."""
    name = "AHEAD"
    if actor.deeds[k].act is Act.CUT_IN and (actor.deeds[k].manner is Manner.SUDDEN or leaves_room(actor)):
        name = f"AHEAD_{k}"
        actor.numbers.narrow(name, *CLOSE)
    elif (comes_before(actor, k) and k == len(actor.deeds) - 1) or (falls_back(actor, k) and not _is_slow(actor, k)):
        name = f"AHEAD_{k}"
        actor.numbers.measure(name, *leaves(actor), "m", "how much room it leaves before the ego")
    return name


def _speeds(actor: Actor, k: int) -> str:
    """The most and the least speed [m/s] of somebody who gets as far before another as its k-th deed needs."""
    passed = speed_of(actor.ledger.situation, done_to(actor.deeds[k]), actor.ego_speed)
    return f"{passed + GETS_BY:.4g}, {FALLS_BACK * passed:.4g}"


def leaves_room(actor: Actor) -> bool:
    """Whether it was said that somebody who comes over from the next lane does not touch the ego."""
    one, missed = actor.one, misses(actor.ledger.situation, actor.one)
    return missed and one.role is Role.ADVERSARY and one.starts.where in NEXT_LANE and actor.stand.meets is Meets.ALONG


def stops_before(actor: Actor, k: int) -> bool:
    """Whether somebody leaves its line for the ego's lane, in which it loses speed before the ego then."""
    deed, one = actor.deeds[k], actor.one
    there = one.starts.where in NEXT_LANE and deed.to in (None, *(side for side in Side if side is not one.starts.side))
    over = deed.act in ASIDE and deed.distance is None and actor.stand.meets is Meets.ALONG
    return over and there and any(then.act in LOSES for then in actor.deeds[k + 1 :])


def goes_before(actor: Actor, k: int) -> bool:
    """Whether somebody goes on before the ego, in its lane, between two deeds by which it loses speed."""
    deeds, then = actor.deeds, k + 1 if actor.deeds[k].act in GOES_ON else k
    lost = any(deed.act in LOSES for deed in deeds[:k])
    ours = actor.one.starts.where is Where.AHEAD or any(deed.act in _COMES_BEFORE for deed in deeds[:k])
    ours = ours or any(stops_before(actor, earlier) for earlier in range(k))
    along = actor.stand.meets is Meets.ALONG and deeds[k].speed is None and deeds[k].time is None
    return along and lost and ours and then < len(deeds) and deeds[then].act in LOSES


def keeps_before(actor: Actor, way: str) -> str:
    """How somebody goes on before the ego that it has slowed down: so that the ego comes near again."""
    top, least = actor.ego_speed, WAITS * actor.ego_speed
    return f"PaceOnPath({way}, ego, {_MIDDLES}$AHEAD, {top:.4g}, {least:.3g}) for $NEAR_TIME seconds"


def _from_behind(actor: Actor, k: int) -> bool:
    """Whether somebody is still behind the ego when it is to come in before it."""
    passed = any(one.act is Act.OVERTAKE for one in actor.deeds[:k])
    return actor.deeds[k].act in _COMES_BEFORE and actor.stand.behind and not passed and done_to(actor.deeds[k]) == EGO


def seconds_to_get_ahead(actor: Actor, k: int) -> float:
    """How long [s] it takes somebody who is behind the ego to get before it, if it must."""
    if falls_back(actor, k):  # who comes from a ramp would be level with the ego where that ends
        return _falls_back_to(actor, k) / _closing(actor, k) if actor.one.starts.where is Where.ON_RAMP else 0.0
    if comes_before(actor, k):
        return seconds_to_get_before(actor, k)
    if gap_is_said(actor.deeds[k]) and k and f"FAST_{k - 1}" in actor.numbers.ranges:  # it eases, and falls back
        passed = speed_of(actor.ledger.situation, done_to(actor.deeds[k]), actor.ego_speed)
        faster = max(0.0, actor.numbers.middle(f"FAST_{k - 1}") - passed)
        return faster / (actor.numbers.middle("EASE") * actor.limits.brake) + SETTLES
    first = k == 0 and actor.deeds[k].act is not Act.CUT_IN
    if first or not _from_behind(actor, k):
        return 0.0
    behind, ahead = (actor.numbers.range_of(name)[1] for name in ("Y", "AHEAD"))
    return (behind + 2 * actor.limits.length + ahead) / GETS_BY


def seconds_to_get_by(actor: Actor, k: int) -> float:
    """How long [s] it takes somebody to get by whom it passes in its k-th deed."""
    numbers, whom = actor.numbers, done_to(actor.deeds[k])
    length, row = actor.ego_limits.length, 0.0
    if whom != EGO:
        other = actor.ledger.situation[whom]
        length, row = other.kind.row.body.row.limits.length, actor.room
    elif actor.stand.behind and "Y" in numbers.ranges:
        row = numbers.middle("Y")
    passed = speed_of(actor.ledger.situation, whom, actor.ego_speed)
    row += sum(_left_behind(actor, n, passed) for n in range(k) if actor.deeds[n].act is Act.SLOW_DOWN)
    faster = min(numbers.middle(f"FAST_{k}"), Body(actor.limits, actor.walks).fastest) - passed
    metres = row + 0.5 * (actor.limits.length + length) + numbers.middle(f"AHEAD_{k}")
    if passes_where_it_goes_over(actor) and whom == EGO:
        metres = row
    seconds = metres / max(faster, 0.5) + faster / actor.limits.throttle  # until it is as fast
    if actor.stand.meets is not Meets.TOWARD:
        return seconds
    return seconds + BACK_OVER if _comes_back(actor, k) else HALF_BY * seconds


def _left_behind(actor: Actor, k: int, passed: float) -> float:
    """How far [m] somebody falls back who loses speed in its k-th deed, behind whom it is to pass then."""
    if actor.stand.meets is not Meets.ALONG or f"SLOW_{k}" not in actor.numbers.ranges:
        return 0.0
    lost = max(0.0, passed - actor.numbers.middle(f"SLOW_{k}"))
    eases = lost / (actor.numbers.middle("EASE") * actor.limits.brake)
    return lost * (SLOW_FOR + 0.5 * (eases + lost / actor.limits.throttle))


def passes_where_it_goes_over(actor: Actor) -> bool:
    """Whether somebody ends by passing an ego that turns off, or over: it is level with that then."""
    last = actor.deeds[-1].act if actor.deeds else None
    motorised = actor.one.kind.row.body.row.motorised  # who has no motor takes longer than can be told
    return last is Act.OVERTAKE and motorised and actor.ledger.situation.ego.route in GOES_OVER


def eases(actor: Actor, k: int, way: str) -> str:
    """How somebody who has passed another in its k-th deed comes to be no faster than that, before it comes in."""
    least = speed_of(actor.ledger.situation, done_to(actor.deeds[k]), actor.ego_speed) + EASED
    return f"BrakeOnPath({way}, $EASE) until self.pose[3] < {least:.4g}"


def _comes_back(actor: Actor, k: int) -> bool:
    """Whether somebody who passes in the ego's lane is to be back in its own before it meets the ego."""
    contact = actor.ledger.situation.contact
    return (contact is not None and not contact.happens) or k + 1 < len(actor.deeds)


def comes_in(actor: Actor, k: int) -> str:
    """How somebody comes into the lane so that it leaves the room that was said: beside whom it leaves it."""
    ahead = f"{_MIDDLES}${_bound(actor, k)}"
    least = f"{WAITS * actor.ego_speed:.3g}"  # or both would stop for each other
    return to_whom(
        f"PaceOnPath({OWN}, ego, {ahead}, 40, {least}) until abs(offsetFrom({OWN}, self)) < 0.8", actor.deeds[k]
    )


def _bound(actor: Actor, k: int) -> str:
    """The parameter that is the room that was said, in metres or by how far the ego gets in a time."""
    deed, name, at = actor.deeds[k], f"AHEAD_{k}", f"{actor.path}.does.{k}"
    if deed.distance is not None:
        actor.numbers.bind(name, deed.distance, f"{at}.distance")
    elif deed.time is not None:
        low, high = (actor.ego_speed * one for one in deed.time.drawn(*LEAVES_FOR))
        actor.numbers.measure(name, low, high, "m", "how much room it leaves", f"{at}.time")
    return name


def backs_by(actor: Actor, k: int) -> str:
    """The parameter that is how long somebody backs up so that it covers the way that was said, at one speed.

    Raises:
        NotBuilt: It is not as fast on so short a way.
    """
    deed, at, numbers = actor.deeds[k], f"{actor.path}.does.{k}", actor.numbers
    assert deed.distance is not None
    speed = numbers.middle(f"BACK_{k}") if deed.speed is not None else BACKS
    numbers.narrow(f"BACK_{k}", speed, speed)
    low, high = deed.distance.drawn(*BACKS_FAR)
    stops = speed**2 / (2.0 * actor.limits.brake)  # to come to a stand again
    least = speed**2 / (2.0 * actor.limits.throttle) + stops
    if deed.speed is not None and high < least:
        raise NotBuilt(
            f"{at}.distance: {deed.distance} is too short to back up at {deed.speed}; say"
            f" {math.ceil(10 * least) / 10:g} m at least"
        )
    body = Body(actor.limits, actor.walks)
    low, high = (body.covers(max(end - stops, 0.0), speed) for end in (low, high))
    numbers.measure(f"BACK_TIME_{k}", low, high, "s", "for how long it backs up", f"{at}.distance")
    return f"BACK_TIME_{k}"
