"""Who has passed the ego, or is ahead of it, and turns off: it comes to the junction, or the driveway, and turns."""

from __future__ import annotations

from typing import TYPE_CHECKING

from chatscene.build.asked import Meets, stands_first
from chatscene.build.coming import wanted_by
from chatscene.build.deeds import EASES, OFF, must_slow
from chatscene.build.gaps import seconds_to_get_by
from chatscene.build.place import DRIVEWAYS, NEXT_LANE, at_junction, hooks_off, passed_before, turns_in_ahead
from chatscene.build.sideways import USUAL
from chatscene.maps.open_road import OPEN_ROAD
from chatscene.maps.routes import APPROACHES
from chatscene.maps.sites import PAST
from chatscene.maps.ways_off import turns_at
from chatscene.terms.vocabulary import Act, Tempo, acts_of

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

STEADY = 1.0  # [s] that who is ahead is seen to go along, before it slows down
SLOWED = 0.7  # of what it wants, below which an ego is told to be slower
AT_ENTRY = 0.5  # [s] before the ego is at the entry of a junction that who is beside it begins to turn off there
NEARLY = 0.9  # of the road that it needs, from which on it is told to turn at its place


def hooks_at(actor: Actor) -> int | None:
    """The number of the deed by which somebody on its way before the ego turns off, where the road has a place for it.

    None of who does not, and where it turns off over the edge of the road.
    """
    deeds, there = actor.deeds, at_junction(actor.ledger.situation) or _at_driveway(actor)
    if not there or actor.stand.meets is not Meets.ALONG or actor.walks or actor.stand.rolls:
        return None
    one, junction = actor.one, at_junction(actor.ledger.situation)
    ahead = not junction and not stands_first(one)
    turns = (k for k in range(len(deeds)) if hooks_off(one, k) or (ahead and turns_in_ahead(one, k)))
    return next(turns, None)


def slows_to_turn(actor: Actor, k: int) -> str:
    """When somebody must slow down by its k-th deed who turns off then; empty of who slows down anywhere."""
    slows = actor.deeds[k].act in acts_of(Tempo.BRAKES, Tempo.SLOWS) and actor.deeds[k].when is None
    if not slows or hooks_at(actor) != k + 1:
        return ""
    route, side = actor.found.route, "left" if actor.deeds[k + 1].act is Act.TURN_LEFT else "right"
    at = turns_at(route.network, route.route, side)
    return "" if at is None else must_slow(at - route.eventAt)


def leaves_at(actor: Actor) -> int | None:
    """The number of the deed by which somebody who stands ahead turns into a driveway; None of who does not."""
    deeds, stands = actor.deeds, stands_first(actor.one) and actor.stand.meets is Meets.ALONG
    turns = (k for k in range(len(deeds)) if stands and _at_driveway(actor) and turns_in_ahead(actor.one, k))
    return next(turns, None)


def _at_driveway(actor: Actor) -> bool:
    return actor.found.query.get("site") in DRIVEWAYS.values()


def turns_at_entry(actor: Actor, k: int) -> bool:
    """Whether somebody goes along beside the ego, and by its k-th deed turns off at the junction."""
    along = actor.stand.meets is Meets.ALONG and actor.one.starts.where in NEXT_LANE and not stands_first(actor.one)
    return along and actor.deeds[k].act in OFF and at_junction(actor.ledger.situation) and hooks_at(actor) is None


def road_to_turn(actor: Actor) -> float:
    """How far [m] from where the ego is somebody turns who then begins to pass it, comes back and slows down."""
    k = hooks_at(actor)
    assert k is not None
    numbers, passed = actor.numbers, passed_before(actor.one, k)
    if passed is None:
        return numbers.range_of("Y")[1] + _slows(actor, actor.along_speed) + STEADY * actor.ego_speed
    passes, fast = seconds_to_get_by(actor, passed), f"FAST_{passed}"
    ahead = numbers.middle("AHEAD") + 0.5 * (actor.limits.length + actor.ego_limits.length)
    slows = _slows(actor, numbers.middle(fast))
    return actor.ego_speed * passes + ahead + USUAL * numbers.middle(fast) + slows


def _slows(actor: Actor, speed: float) -> float:
    """How far [m] somebody goes who slows down from a speed [m/s] to that of its turn."""
    return (speed**2 - actor.numbers.middle("SLOW") ** 2) / (2.0 * EASES * actor.limits.brake)


def take_road_to_turn(actor: Actor) -> None:
    """Let the road be so long up to there; where none is, tell that it turns off beyond."""
    needs, there = road_to_turn(actor), actor.found.route.eventAt
    place = "the junction" if at_junction(actor.ledger.situation) else "the driveway"
    usual = APPROACHES[0] if at_junction(actor.ledger.situation) else PAST[0]
    if there < NEARLY * needs:
        actor.takes = max(actor.takes, actor.found.route.line.length + 1.0, needs / usual * OPEN_ROAD)
        if actor.found.sought:
            actor.ledger.lack(f"{actor.one.id} turns off beyond {place}, since the road before that is too short")
    elif actor.ego_speed < SLOWED * wanted_by(actor.ledger.told or actor.ledger.situation):
        told = f"the ego is slow, or {actor.one.id} would not be by before {place}: the road before that is too short"
        actor.ledger.lack(told)
