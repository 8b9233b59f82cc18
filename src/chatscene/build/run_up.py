"""The run-up: what the ego is held to until somebody does that for which a speed or a gap was said.

A number that was said of the ego and of who is before it holds when that one acts. Left to its own driver, an ego has
lost speed and opened the gap by then, each by another amount. So it is driven at its speed, as a test protocol drives a
car under test, until that deed begins; then it is its driver's alone.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

from chatscene.build.asked import ROOM, stands_first
from chatscene.build.keeping import followed
from chatscene.build.ledger import Ledger
from chatscene.build.own import is_own
from chatscene.build.relations import said_speed
from chatscene.terms.backing import backs
from chatscene.terms.order import Order
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import GOES_ON, Act, EgoRoute, Heads, Manner, Where, acts_of

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

LEAST, MOST = 0.8, 1.1  # of the ego's speed: on who is slower the ego closes in, and who is faster leaves
NEAR = 0.5  # of the gap at first: an ego that has come so near is let go
_COMES = acts_of(Heads.BEFORE, Heads.MERGES)
_STRAIGHT = (None, EgoRoute.STRAIGHT)


def run_up(ledger: Ledger, speed: float, actors: Mapping[str, Actor]) -> tuple[Order, ...]:
    """The order by which the ego keeps its speed until what follows begins; none where no number was said for that.

    Args:
        ledger: What was said.
        speed: What the ego drives at [m/s].
        actors: All others, with their plans.
    """
    situation = ledger.situation
    lead = led_by(situation, speed)
    event = None if lead is None else _event(situation, lead)
    if lead is None or event is None:
        return ()
    who, k = event
    begins = actors[who.id].begins
    if k >= len(begins) or begins[k] < 1:  # it does so from the start
        return ()
    actor = actors[lead.id]
    nose = 0.5 * actor.ego_limits.length
    gap = actor.nearest - nose
    if who is not lead and gap < actors[who.id].limits.length + 2.0 * ROOM:  # which the ego has to make
        return ()
    near = _said_near(lead, speed) if _waits_for(lead) else gap
    least = NEAR * max(near, 0.0)
    within = nose + 0.5 * actor.limits.length + least if who is lead else 0.0
    ledger.assume(
        f"the ego is held at {3.6 * speed:.0f} km/h behind {lead.id} until {who.id} does its {who.does[k].act}"
    )
    return (Order(at_least=round(speed, 2), whom=who.id, within=round(within, 1), phase=begins[k], ends=True),)


def led_by(situation: Situation, speed: float) -> Other | None:
    """Who goes before the ego about as fast, at a gap that was said or so that the ego follows it; None if nobody.

    Args:
        situation: What was said.
        speed: What the ego drives at [m/s].
    """
    ego = situation.ego
    if ego.speed is None or ego.route not in _STRAIGHT or backs(situation):
        return None
    follows = next((deed for deed in ego.does if not is_own(deed)), None)
    if any(deed.act not in GOES_ON or deed.manner is Manner.SLOW or deed.speed is not None for deed in ego.does[:1]):
        return None
    name = followed(situation, follows) if follows is not None and follows.act is Act.FOLLOW else None
    ahead = [one for one in situation.others if one.starts.where is Where.AHEAD and not stands_first(one)]
    leads = (one for one in ahead if one.id == name or (name is None and one.starts.distance is not None))
    return next((one for one in leads if _as_fast(one, speed)), next(filter(_waits_for, ahead), None))


def _waits_for(one: Other) -> bool:
    """Whether somebody begins what it does once the ego has come as near to it as was said."""
    first = one.does[0].when if one.does else None
    return first is not None and first.ego_within is not None and first.of in (None, one.id)


def _said_near(one: Other, speed: float) -> float:
    """How near [m] to somebody the ego is said to be when that begins what it does.

    Args:
        one: Who is ahead.
        speed: What the ego drives at [m/s].
    """
    when = one.does[0].when
    assert when is not None
    assert when.ego_within is not None
    closing = speed - (said_speed(one, speed) or 0.0)
    return when.ego_within.least * (closing if when.ego_within.QUANTITY == "duration" else 1.0)


def _as_fast(one: Other, speed: float) -> bool:
    """Whether somebody goes about as fast as the ego, by what was said."""
    said = said_speed(one, speed)
    return one.kind.row.body.row.motorised and (said is None or LEAST * speed < said < MOST * speed)


def _event(situation: Situation, lead: Other) -> tuple[Other, int] | None:
    """The first deed that ends the run-up: of who is before the ego, or else by which another comes in between."""
    for one in (lead, *situation.adversaries):
        acts = GOES_ON if one is lead else frozenset(Act) - _COMES
        k = next((k for k, deed in enumerate(one.does) if deed.act not in acts), None)
        if k is not None:
            return one, k
    return None
