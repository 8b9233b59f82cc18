"""Where on the ego's way somebody comes to a stand since the road says so: at a line, at rails, at a bus stop."""

from __future__ import annotations

from typing import TYPE_CHECKING

from chatscene.build.asked import Meets, stops_ahead
from chatscene.build.chain import in_terms_of
from chatscene.build.gaps import seconds_to_get_by
from chatscene.build.place import NEXT_LANE, Found, at_junction, has_crosswalks
from chatscene.terms.scenario import Control, Site
from chatscene.terms.situation import Deed, Situation
from chatscene.terms.vocabulary import Act, EgoLight, Feature, Heads, Tempo, UserKind, Where, acts_of

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

NOSE = (0.5, 1.5)  # [m] before a line that the nose of who halts there is, from and to
RAILS, CROSSWALK = 2.0, 6.0  # [m] before the first rail, and before a junction that has a crosswalk, that one halts
HARD = 0.75  # of its brake with which who halts does
COMES_IN, LATER = 1.5, 2.0  # [s] in which who has passed is back; [m] of road beyond there, up to a bus stop
MOST, SHORT = 0.8, 5.0  # of the ego's way, up to which a bus stop is if it can be; [m] before its end, at most
SERVES = frozenset((UserKind.BUS, UserKind.ARTICULATED_BUS, UserKind.MINIBUS, UserKind.TRAM))
"""Who stops at a bus stop, since that is for such."""
_COMES_BY = acts_of(Heads.BY, Heads.BEFORE)


def line_before(situation: Situation, found: Found) -> float | None:
    """How far [m] before where a junction or the rails begin one halts for them; None where nobody must.

    Args:
        situation: What was said.
        found: Where it happens.
    """
    if found.query.get("site") == Site.RAIL_CROSSING:
        return RAILS
    ruled = found.query.get("control") not in (None, Control.NONE)
    if not (ruled and at_junction(situation)) or situation.road.ego_light is EgoLight.GREEN:
        return None
    return CROSSWALK if has_crosswalks(found) else 0.0


def halts_at(actor: Actor, k: int) -> str:
    """When somebody must brake to halt by its k-th deed where the road says so; empty of who halts anywhere.

    Who is ahead of the ego halts at the line of the junction or at the rails; who has passed it, at the bus stop.
    """
    deed = actor.deeds[k]
    if deed.act is not Act.STOP or not of_itself(deed):
        return ""
    stop = bus_stop_of(actor)
    at = f"egoRoute.eventAt - {_from_line(actor):.3g}" if _at_line(actor, k) else stop or ""
    share = f"$BRAKE_{k}" if deed.acceleration is not None else "$BRAKE"
    return actor.filled(f"progressOn(egoRoute, self)[0] + brakingDistance(self) / {share} > {at}") if at else ""


def of_itself(deed: Deed) -> bool:
    """Whether a deed is done for nobody, and waits for nothing."""
    return deed.whom is None and deed.when is None and deed.distance is None


def _at_line(actor: Actor, k: int) -> bool:
    """Whether it goes before the ego to where one halts, and there is nobody before it."""
    situation = actor.ledger.situation
    line = line_before(situation, actor.found)
    goes = stops_ahead(actor.one) and all(deed.act in acts_of(Heads.ALONG, Tempo.SLOWS) for deed in actor.deeds[:k])
    first = next(one for one in situation.others if one.starts.where is Where.AHEAD) if goes else None
    along = actor.stand.meets is Meets.ALONG and not actor.stand.rolls and not actor.ego.stands
    return line is not None and goes and first is actor.one and along


def _from_line(actor: Actor) -> float:
    """How far [m] before the junction or the rails the middle of somebody is who halts there."""
    line = line_before(actor.ledger.situation, actor.found)
    return (line or 0.0) + 0.5 * (actor.limits.length + sum(NOSE))


def bus_stop_of(actor: Actor) -> str | None:
    """How far [m] along the ego's way the middle of somebody is who passes the ego and then halts at the bus stop.

    It is a text of a program, since it is where that one is back before the ego, by its numbers. None of who does not,
    or for whom the road is too short.
    """
    situation, deeds, numbers = actor.ledger.situation, actor.deeds, actor.numbers
    k = next((k for k, deed in enumerate(deeds) if deed.act is Act.STOP and of_itself(deed)), 0)
    comes_by = all(deed.act in _COMES_BY for deed in deeds[:k]) and deeds[0].act is Act.OVERTAKE if k else False
    there = Feature.BUS_STOP in situation.road.has and not at_junction(situation)
    if not (there and comes_by and actor.one.starts.where in NEXT_LANE | {Where.BEHIND}):
        return None
    length = 0.5 * (actor.limits.length + actor.ego_limits.length)

    def metres() -> float:
        seconds = numbers.middle("STEADY") + seconds_to_get_by(actor, 0) + COMES_IN
        brakes = actor.ego_speed**2 / (2.0 * HARD * actor.limits.brake)  # as fast as the ego by then
        return actor.ego_speed * seconds + numbers.middle("AHEAD") + length + brakes + LATER

    text = in_terms_of(numbers, ("$STEADY", "$FAST_0", "$AHEAD", "$Y"), metres)
    place = metres()
    actor.takes = max(actor.takes, place / MOST)
    return text.removeprefix("+ ") if place < actor.found.route.line.length - SHORT else None
