"""Who backs in a car park: out of the bay in which it stands, across the way between the bays."""

from __future__ import annotations

from dataclasses import replace

from chatscene.terms.actors import Manner
from chatscene.terms.situation import Deed, Ego, Other, Situation
from chatscene.terms.vocabulary import Act, EgoRoute, RoadKind, Where


def out_of_bay(situation: Situation) -> Situation:
    """The same; in a car park whoever stands at the edge and backs comes out across the way, as out of a driveway."""
    if situation.road.kind is not RoadKind.PARKING_LOT:
        return situation
    return replace(situation, ego=_ego(situation.ego), others=tuple(_other(one) for one in situation.others))


def _ego(ego: Ego) -> Ego:
    """The ego; if nothing but that it backs was said of its way, it leaves a bay."""
    does = ego.does
    if ego.route is not EgoRoute.REVERSE:
        return ego
    if not does:
        does = (Deed(act=Act.REVERSE),)
    elif does[0].act is Act.GO_ALONG:
        does = (replace(does[0], act=Act.REVERSE), *does[1:])
    return replace(ego, route=EgoRoute.LEAVE_PARKING, does=does)


def _other(one: Other) -> Other:
    moves = next((deed.act for deed in one.does if deed.act is not Act.STAND), None)
    if one.starts.where is not Where.KERB or moves is not Act.REVERSE or one.kind.moves is not Manner.DRIVES:
        return one
    return replace(one, starts=replace(one.starts, where=Where.DRIVEWAY))
