"""An ego that backs in a car park: out of the bay in which it stands."""

from __future__ import annotations

from dataclasses import replace

from chatscene.terms.situation import Deed, Situation
from chatscene.terms.vocabulary import Act, EgoRoute, RoadKind


def out_of_bay(situation: Situation) -> Situation:
    """The same; an ego of which nothing but that it backs was said of its way in a car park leaves a bay."""
    ego, does = situation.ego, situation.ego.does
    if situation.road.kind is not RoadKind.PARKING_LOT or ego.route is not EgoRoute.REVERSE:
        return situation
    if not does:
        does = (Deed(act=Act.REVERSE),)
    elif does[0].act is Act.GO_ALONG:
        does = (replace(does[0], act=Act.REVERSE), *does[1:])
    return replace(situation, ego=replace(ego, route=EgoRoute.LEAVE_PARKING, does=does))
