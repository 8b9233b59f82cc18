"""Who leaves the road: over which edge, how far aside of its line that is, and how it comes to a stand there."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from chatscene.build.asked import Meets
from chatscene.build.deeds import ALONG, Steps
from chatscene.build.numbers import RANGES
from chatscene.build.over_lanes import lane_after
from chatscene.build.place import LANE
from chatscene.errors import NothingBuilds
from chatscene.terms.situation import Road, Situation
from chatscene.terms.vocabulary import Act, Side, Where
from chatscene.world.places import beside_road

if TYPE_CHECKING:
    from chatscene.build.actor import Actor

BEYOND = (0.3, 1.2)  # [m] between the edge of the lanes and the body, from and to
_AGAINST = frozenset((Where.ONCOMING, Where.ONCOMING_IN_OUR_LANE))


def leaves_road(actor: Actor, k: int) -> Steps:
    """How somebody leaves the road by its k-th deed: over the nearest edge, if no side was said.

    Raises:
        NotBuilt: The road has no edge on that side, or somebody does not go along it.
    """
    deed, at = actor.deeds[k], f"{actor.path}.does.{k}"
    if actor.stand.meets not in (Meets.ALONG, Meets.TOWARD):
        raise NothingBuilds(f"cannot be built yet: {deed.act}, {actor.one.starts.where}")
    found = {side: far for side in Side if (far := _to_edge(actor, k, side)) is not None}
    if deed.to is not None:
        actor.ledger.take(f"{at}.to")
    side = deed.to or min(found, key=lambda one: (round(found[one], 1), one is Side.LEFT), default=Side.RIGHT)
    if side not in found:
        raise NothingBuilds(f"cannot be built yet: {at}.to: {side}; the road has no edge there")
    far = found[side] + 0.5 * actor.limits.width
    name = f"OFF_{k}"
    _, _, unit, meaning = RANGES["OFF"]
    actor.numbers.measure(name, far + BEYOND[0], far + BEYOND[1], unit, meaning)
    against = actor.stand.meets is Meets.TOWARD
    sign = "-" if (side is Side.RIGHT) is not against else ""
    row = ALONG[Act.LEAVE_ROAD]
    does, last = (
        tuple(text.replace("{aside} * $OFF", f"{sign}${name}") for text in texts) for texts in (row.does, row.last)
    )
    return replace(row, does=does, last=last)


def _to_edge(actor: Actor, k: int, side: Side) -> float | None:
    """How far [m] the edge of all lanes on a side of the ego is from somebody's line; None where there is none."""
    route = actor.found.route
    edge = beside_road(route, max(route.eventAt, 0.0), str(side), 0.0)
    if edge is None:
        return None
    begins = actor.one.starts.where
    lane = 1 if begins is Where.ONCOMING else 0 if begins in _AGAINST else lane_after(actor.one, actor.deeds, k - 1)
    left = route.line.project(*edge)[1] - lane * LANE
    return max(left if side is Side.LEFT else -left, 0.0)


def ego_to_edge(situation: Situation, side: Side) -> float:
    """How far [m] the ego leaves its line to be off the road, by the lanes that were said."""
    road: Road = situation.road
    lanes = max(road.lanes or 1, 1)
    own = road.ego_lane or 1
    from_right = own - 1 if own > 0 else lanes + own
    beyond = from_right if side is Side.RIGHT else lanes - 1 - from_right + int(road.two_way is not False)
    return (beyond + 0.5) * LANE + 0.5 * situation.ego.body.row.limits.width + sum(BEYOND) / 2
