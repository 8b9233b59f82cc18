"""Whether a route serves: all whom it is for can come there, and in time."""

from __future__ import annotations

from collections.abc import Iterator

from chatscene.build.arriving import LATEST, way_through
from chatscene.build.asked import stands_first
from chatscene.build.place import (
    NEXT_LANE,
    Found,
    arm_of,
    beside_lane,
    beside_ramp,
    leaves_by_ramp,
    rides_at_edge,
    ring_arms,
    way_of,
)
from chatscene.build.relations import said_speed
from chatscene.build.screening import from_its_lane
from chatscene.errors import MapError
from chatscene.maps.ring_ways import ring_ways
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.backing import backs
from chatscene.terms.nouns import with_article
from chatscene.terms.scenario import Site
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import Where
from chatscene.world.places import lanes_beside, trafficFrom, wayOf

BESIDE_RAMP = 2  # from the outermost, which is the ramp's, of the lane beside that


def lacking_for(situation: Situation, found: Found) -> str | None:
    """What a place lacks for somebody who is to be there, in words; None if it lacks nothing."""
    if found.query.get("site") == Site.ROUNDABOUT:
        there = {way.from_side for way in ring_ways(found.route.network, found.route.route)}
        for one in situation.others:
            if (arms := ring_arms(one, found.sides)) and not there & set(arms):
                return f"no lane from the {' or '.join(arms)} meets the ego's route in the roundabout"
    by_ramp = (one for one in situation.others if one.starts.where is Where.ON_RAMP or leaves_by_ramp(situation, one))
    if beside_ramp(found.query) and found.query.get("lane", 2) > BESIDE_RAMP and any(by_ramp):
        return "the ego's lane is not the one beside the ramp's"
    if (side := _no_lane(situation, found)) is not None:
        return f"no lane of the ego's direction lies to its {side}"
    arms = [(one, arm) for one in situation.others if (arm := arm_of(situation, one, found.sides))]
    ways = [(one, way_through(situation, found, one)) for one, _ in arms]
    unmet = [pair for pair, (_, way) in zip(arms, ways, strict=True) if way is None]
    if missing := {(arm, way_of(situation, one, arm)) for one, arm in unmet}:
        who = ", ".join(f"from the {arm} in {with_article(turn)}" for arm, turn in sorted(missing))
        return f"no way {who} meets the ego's route there"
    if arms and abreast(situation) and not _comes_in_two_lanes(found):
        return "there are not two oncoming lanes there"
    return None


def _comes_in_two_lanes(found: Found) -> bool:
    """Whether two can come straight against the ego at its junction, side by side, and meet its way."""
    try:
        opposite = trafficFrom(found.route, "oncoming")
        return wayOf(opposite, "straight", "inner") is not wayOf(opposite, "straight", "outer")
    except MapError:
        return False


def _no_lane(situation: Situation, found: Found) -> str | None:
    """The side on which somebody is to be in the next lane, where there is none of the ego's direction."""
    route = situation.ego.route
    if beside_lane(situation) or backs(situation):
        return None
    there = lanes_beside(found.route)
    for one in situation.others:
        side = str(one.starts.side or found.sides.get(one.id, ""))
        in_lane = one.starts.where in NEXT_LANE and not rides_at_edge(one, route) and one.kind.moves is Moves.DRIVES
        if in_lane and there.get(side) is not False:
            return side
    return None


def too_short(situation: Situation, found: Found, ego: float) -> Iterator[tuple[str, float]]:
    """What is told of each road by which somebody comes who was said to be too fast for its length, and the most [m/s].

    It begins so far back that it is there when an ego of a speed [m/s] is that nothing holds.
    """
    for one in situation.others:
        said = said_speed(one, ego)
        if said is None or one.starts.distance is not None or stands_first(one):
            continue
        way = way_through(situation, found, one) if arm_of(situation, one, found.sides) else None
        if way is not None and said > (most := way.meets_at / (way.ego_meets_at / ego + LATEST)):
            yield f"others.{one.id}: the road that it comes from is too short for more than {{:.1f}} m/s", most


def abreast(situation: Situation) -> bool:
    """Whether two come against the ego side by side, one of whom hides the other."""
    return any(
        one.starts.where is Where.ONCOMING
        and one.hidden_by is not None
        and from_its_lane(situation, situation[one.hidden_by], one)
        for one in situation.others
    )
