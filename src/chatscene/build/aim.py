"""Which part of whom is met: the window of time in which somebody crosses the ego's way so that it is."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from chatscene.build.arriving import way_through
from chatscene.build.asked import Meets, stops_in_the_way
from chatscene.build.chain import meeting_of
from chatscene.build.contact import is_braked_for, touches
from chatscene.build.numbers import Numbers
from chatscene.build.place import ROUNDABOUT_PLACES
from chatscene.build.sweep import Moving, Touch
from chatscene.build.sweep import touches as touching
from chatscene.build.timing import Body
from chatscene.errors import NotBuilt
from chatscene.situations.facts import is_said
from chatscene.terms.polyline import Polyline
from chatscene.terms.situation import Contact
from chatscene.terms.vocabulary import COMES_IN, SIDES_OF, STOPS, Act, Heads, Part, Role, Side, Striker, acts_of
from chatscene.world.control import curve_speeds

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

NEAR_MISS = 0.5  # [s] before the ego at most that somebody has gone by where there is no contact
BEFORE = 3.0  # [m] before the junction that who lets another by stands
COMES = 0.5  # [s] for which somebody is seen to come before it is in the junction
LETS_GO = 1.0  # [s] at most that somebody stands until another is by whom it lets by
LEADS = 0.4  # [s] within which somebody is there who has another brake
LETS_BY = (1.2, 2.5)  # [s] before the ego that somebody is at a junction who lets it by
STOOD = 1.0  # [s] that somebody has stood in the ego's way when the ego comes, so that it is seen to stop
GENTLE = 2.5  # [m/s²] that an ego brakes with that nothing forces to brake harder
NEAR_POINT = 0.1  # of the ego's width: how near to the point that was said somebody is met
_TICK = 0.1  # [s]; who waits for a moment sets off half of it later, on average
_SPARE = 0.5  # [s] sooner and later than at right angles that somebody may be there whose way does not leave the ego's
_LOOKS, _STEPS = 3.0, 121  # [s] sooner and later that is looked at, and in how many steps
_FINER = 5  # times as many, where a point is to be met
_CORNER = 0.3  # of half its length ahead of its middle: from there on it is a corner that is met
_END = 0.8  # of half its length: from there on it is its end that is met, as good as that can be of who crosses
_ENDS = frozenset(("front", "rear"))
_FAR = 40.0  # [m] of the way over the road
_COMES_THROUGH = acts_of(Heads.THROUGH, Heads.TURNS)
AT_START = 0.5  # [s] that who comes from the beginning of its way is at most slower in curves
LATEST_MET = 10.0  # [s] that somebody needs to where it meets the ego, if only a least was said
Window = tuple[float, float]


def set_offset(actor: Actor) -> None:
    """Let somebody be where the ways meet at a time at which the two would touch if neither reacted.

    Whoever comes later strikes the other.
    """
    ego = actor.ego_limits
    speed = actor.ego.table.speed_at(actor.meets_at)
    late = -0.5 * (ego.length + actor.limits.length) / speed
    early = (ego.width + actor.limits.length) / _speed(actor)
    yields = bool(actor.deeds) and actor.deeds[0].act is Act.YIELD
    if yields:  # who waits for the ego is there well before it
        late, early = LETS_BY
    else:
        late, early, *taken = aimed(actor, (late, early))
        actor.ledger.take(*taken)
    if (let_by := _let_by(actor)) is not None:
        late, early = let_by
    elif is_braked_for(actor.ledger.situation, actor.one) and actor.one.role is Role.SUPPORTING:
        late = 0.5 * (late + early)  # it is half over: whoever drives the ego brakes, and need not touch it
        early = 0.5 * (late + early)
    elif actor.sooner is not None and not yields:
        late, early = actor.sooner, actor.sooner + LEADS
    elif actor.one.role is Role.SUPPORTING and not yields:  # not met: before the ego, which can still brake for it
        late, early = early + 0.5 * speed / GENTLE, early + speed / GENTLE
    if actor.stand.meets is Meets.THROUGH and stops_in_the_way(Meets.THROUGH, actor.deeds):
        stops = 0.5 * actor.numbers.middle("SPEED") / actor.limits.brake + STOOD
        late, early = stops, stops + early  # it stands there when the ego comes
    elif actor.ledger.situation.contact is None and actor.one.role is Role.ADVERSARY and not yields:
        late, early = _just_missed(actor, late, early)
    if actor.one.role is Role.SUPPORTING and actor.stand.rolls and (most := _from_outside(actor)) is not None:
        late, early = min(late, most), min(early, most)
    actor.numbers.narrow("OFFSET", late, early)


def set_time_to_meet(actor: Actor) -> None:
    """Let somebody still need as long as was said to where it meets the ego, when that is at the junction."""
    at_line = max(actor.found.route.eventAt - 0.5 * actor.ego_limits.length, 0.0)
    for k, deed in enumerate(actor.deeds):
        if deed.time is None or deed.act not in _COMES_THROUGH or actor.stand.meets is not Meets.THROUGH:
            continue
        own = actor.ego.time_at(actor.meets_at) - actor.ego.time_at(at_line)
        low, high = deed.time.drawn(0.0, LATEST_MET)
        path = f"{actor.path}.does.{k}.time"
        meaning = "how much sooner than the ego it reaches the point where their paths meet"
        actor.numbers.measure("OFFSET", own - high, own - low, "s", meaning, path)


def _from_outside(actor: Actor) -> float | None:
    """How much sooner [s] than the ego somebody can be there at most who is seen to come to the junction before."""
    if (found := actor.stand.found) is None or actor.first is not None or actor.one.starts.distance is not None:
        return None
    metres = found.meets_at - found.entry + 0.5 * actor.limits.length + BEFORE
    seconds = actor.ego.time_at(found.ego_meets_at) + actor.ego.late_at(found.ego_meets_at)
    least = seconds - (found.meets_at / actor.numbers.range_of("SPEED")[1] - AT_START)  # its way is no longer
    return max(seconds - metres / actor.numbers.middle("SPEED") - COMES, least)


def _let_by(actor: Actor) -> Window | None:
    """When somebody who is not met is there whom another lets by at a junction, which the ego meets then.

    That one has just come to a stand, and has the time left that it needs from there.
    """
    if actor.one.role is not Role.SUPPORTING or actor.stand.meets is not Meets.THROUGH:
        return None
    for one in actor.ledger.situation.adversaries:
        waits = any(deed.act is Act.YIELD and deed.whom == actor.one.id for deed in one.does)
        goes = waits and one.starts.where.row.junction and one.starts.where not in ROUNDABOUT_PLACES
        way = way_through(actor.ledger.situation, actor.found, one) if goes else None
        if way is not None:
            row = one.kind.row.body.row
            metres = way.meets_at - way.entry + 0.5 * row.limits.length + BEFORE
            takes = Body(row.limits, walks=False).covers(metres, Numbers(one.id, row).middle("SPEED"))
            return takes - 0.5 * LETS_GO, takes + 0.5 * LETS_GO
    return None


def _just_missed(actor: Actor, late: float, early: float) -> Window:
    """The same window, and on either side the time in which one of them goes by: then the two just miss each other.

    Who crosses on foot is there before the ego, or nobody would say that it crosses.
    """
    ego = actor.ego_limits
    if actor.stand.meets is Meets.THROUGH:
        late -= ego.length / actor.ego.table.speed_at(actor.meets_at)
    return late, early + ego.width / _speed(actor)


def aimed(actor: Actor, usual: Window) -> tuple[float, float, *tuple[str, ...]]:
    """When somebody is where the ways meet, and the facts that this has.

    Args:
        actor: Who crosses the ego's way.
        usual: How much sooner than the ego [s] it is there if they touch, from and to, at right angles.

    Returns:
        How much sooner than the ego it is there, from and to, then the paths of what is aimed at. A part that cannot be
        met together with what stands before it is not aimed at.
    """
    contact = actor.ledger.situation.contact
    pointed = contact is not None and contact.at is not None and contact.whom in (None, actor.one.id)
    sooner = np.linspace(min(usual[0], -_LOOKS), max(usual[1], _LOOKS), _STEPS * (_FINER if pointed else 1))
    found = touching(_ego(actor, turning=pointed), way, sooner) if (way := _other(actor)) is not None else []
    if not any(found):  # along each other
        found = [_FRONTAL if usual[0] <= one <= usual[1] else None for one in sooner.tolist()]
    if contact is not None and pointed and way is not None:
        return _at_point(actor, contact, sooner.tolist(), found)
    met = [one is not None for one in found]
    low, high = (float(sooner[one]) for one in _longest(met))
    by = usual[1] if met[-1] else high  # who turns into the ego's lane is never by
    if contact is not None and _strikes_another(actor):
        return by, by + NEAR_MISS
    unsaid = max(low, usual[0] - _SPARE) if met[0] else low, min(high, usual[1] + _SPARE) if met[-1] else high
    if contact is None or contact.whom not in (None, actor.one.id):
        return unsaid
    if not contact.happens and not any(True for _ in _asked(contact)):
        return by, by + NEAR_MISS, "contact.happens"
    taken = [] if contact.happens else ["contact.happens"]  # it is braking that keeps them apart
    for path, holds in _asked(contact):
        both = [so and one is not None and holds(one) for so, one in zip(met, found, strict=True)]
        if way is not None and any(both):
            met = both
            taken.append(path)
    low, high = (float(sooner[one]) for one in _longest(met))
    return (low, high, *taken) if taken else unsaid


def _at_point(
    actor: Actor, contact: Contact, sooner: list[float], found: list[Touch | None]
) -> tuple[float, float, *tuple[str, ...]]:
    """When somebody is there whom the ego, if it does not brake, meets at a point of its width.

    Raises:
        NotBuilt: It is met there at no time.
    """
    assert contact.at is not None
    width = actor.ego_limits.width
    sign = 1.0 if _from_left(actor) else -1.0
    low, high = contact.at.drawn(0.0, 1.0)
    behind = None if contact.behind_nose is None else 0.5 * sum(contact.behind_nose.drawn(0.0, 1.0))

    def share(one: Touch) -> float:
        aside = one.across if behind is None else one.across + _to_point(actor, behind, one)
        return 0.5 - sign * aside / width

    shares = [share(one) if one is not None and one.ego == "front" else math.nan for one in found]
    there = [max(low - share, share - high, 0.0) for share in shares]
    nearest = min((far for far in there if not math.isnan(far)), default=1.0)
    if nearest > NEAR_POINT:
        raise NotBuilt(
            f"cannot be built yet: contact.at: {contact.at}: the ego's front cannot meet {actor.one.id} there"
        )
    least, most = _when(sooner, shares, low), _when(sooner, shares, high)
    taken = [path for path in ("contact.happens", "contact.striker") if is_said(actor.ledger.situation, path)]
    if contact.ego is Part.FRONT:
        taken.append("contact.ego")
    if behind is not None:
        taken.append("contact.behind_nose")
    part = contact.other
    if part is not None and any(one is not None and _is(part, one.other, one.other_along) for one in found):
        taken.append("contact.other")
    late = 0.0 if actor.stand.rolls else 0.5 * _TICK
    return min(least, most) + late, max(least, most) + late, "contact.at", *taken


def _to_point(actor: Actor, behind: float, touch: Touch) -> float:
    """How far [m] to the left of the middle of somebody, as the ego sees it, a point lies on its side facing the ego.

    Args:
        actor: Who.
        behind: How far behind its nose the point is, as a share of its length.
        touch: How the two touch.
    """
    ahead, aside = (0.5 - behind) * actor.limits.length, 0.5 * actor.limits.width
    return ahead * math.sin(touch.turned) + (aside if touch.left else -aside) * math.cos(touch.turned)


def _when(sooner: Sequence[float], shares: Sequence[float], share: float) -> float:
    """How much sooner [s] somebody is there whom the front meets at a share of its width, or as near to that as can be.

    Args:
        sooner: Times, in order.
        shares: Where it is met at each; NaN where the front does not meet it.
        share: Where it is to be met.
    """
    pairs = zip(pairwise(sooner), pairwise(shares), strict=True)
    for (begins, ends), (first, last) in pairs:
        if min(first, last) <= share <= max(first, last):  # which NaN never is
            return begins + (ends - begins) * ((share - first) / (last - first) if last != first else 0.5)
    met = [(abs(one - share), when) for when, one in zip(sooner, shares, strict=True) if not math.isnan(one)]
    return min(met)[1]


def _from_left(actor: Actor) -> bool:
    """Whether somebody comes over the ego's way from its left."""
    if (found := actor.stand.found) is not None:
        return found.from_side == Side.LEFT
    return actor.one.starts.side is Side.LEFT or "left" in actor.stand.facing


def _strikes_another(actor: Actor) -> bool:
    """Whether it was said that the ego strikes another who comes over its way, and not this one, who is by before."""
    situation = actor.ledger.situation
    others = (one for one in situation.others if one.id != actor.one.id and touches(situation, one))
    named = situation.contact is not None and situation.contact.whom is not None
    return named and any(not COMES_IN.isdisjoint(deed.act for deed in one.does) for one in others)


_FRONTAL = Touch("front", 1.0, "front", 1.0, by_ego=True)


def _asked(contact: Contact) -> Iterator[tuple[str, Callable[[Touch], bool]]]:
    """What was said of the contact, and whether a touch is so."""
    if (striker := contact.striker) is not None:
        yield "contact.striker", lambda one: one.by_ego is (striker is Striker.EGO)
    if (ego := contact.ego) is not None:
        yield "contact.ego", lambda one: _is(ego, one.ego, one.ego_along)
    if (other := contact.other) is not None:
        yield "contact.other", lambda one: _is(other, one.other, one.other_along)


def _is(part: Part, side: str, along: float) -> bool:
    """Whether a place on a body is a part of it, or a place on its flank the end that the part is of."""
    sides = SIDES_OF[part]
    if len(sides) == 1 and side == sides[0]:
        return True
    if sides[0] not in _ENDS or (len(sides) == 2 and side not in sides):
        return False
    least = _CORNER if len(sides) == 2 else _END
    return (along if sides[0] == "front" else -along) > least


def _longest(holds: list[bool]) -> tuple[int, int]:
    """The first and the last of the longest row of those that hold."""
    best, begins = (0, -1), None
    for i, one in enumerate([*holds, False]):
        if one and begins is None:
            begins = i
        elif not one and begins is not None:
            best = max(best, (begins, i - 1), key=lambda row: row[1] - row[0])
            begins = None
    return best


def _speed(actor: Actor) -> float:
    """How fast somebody is where it meets the ego."""
    speed = actor.numbers.middle("SPEED")
    if actor.stand.meets is Meets.ACROSS and actor.stand.left != "0" and not actor.stand.rolls:  # from a stand
        over = meeting_of(actor).metres + 0.5 * (actor.ego_limits.width + actor.limits.length)
        return min(speed, Body(actor.limits, actor.walks).reaches(over))
    if (found := actor.stand.found) is not None:
        return min(speed, curve_speeds(found.line)[found.line.segment_at(found.meets_at)])
    return speed


def _ego(actor: Actor, *, turning: bool = False) -> Moving:
    """The ego on its way; if it is to be met at a point in a junction, as far turned out of its bend as a car is there.

    Who is at a crosswalk behind the junction is so far from it that the ego has come about.
    """
    line, limits = actor.found.route.line, actor.ego_limits
    speed = actor.ego.table.speed_at(actor.meets_at)
    size = {
        "length": limits.length,
        "width": limits.width,
        "wheelbase": limits.wheelbase if turning and actor.stand.found is not None else 0.0,
    }
    return Moving(line=line, meets_at=actor.meets_at, speed=speed, **size)


def _other(actor: Actor) -> Moving | None:
    """Somebody on its way over the ego's; None of who goes along it."""
    stand, limits = actor.stand, actor.limits
    size = {"length": limits.length, "width": limits.width, "speed": _speed(actor)}
    if (found := stand.found) is not None:
        return Moving(line=found.line, meets_at=found.meets_at, **size)
    if stand.meets is not Meets.ACROSS or stand.left == "0":
        return None
    ego, at = actor.found.route.line, actor.meets_at
    (x, y), heading = ego.point_at(at), ego.heading_at(at)
    outward = heading + (0.5 if _from_left(actor) else -0.5) * np.pi
    ends = [(x + far * np.cos(outward), y + far * np.sin(outward)) for far in (_FAR, -_FAR)]
    return Moving(line=Polyline(ends), meets_at=_FAR - 1.0, ends_at=_FAR if _stays(actor) else np.inf, **size)


def _stays(actor: Actor) -> bool:
    """Whether somebody stops in the ego's lane."""
    return bool(actor.deeds) and actor.deeds[-1].act in STOPS | acts_of(Heads.IN)
