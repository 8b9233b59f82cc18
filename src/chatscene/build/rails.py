"""Who comes along the rails that lead across the ego's road: from beside it, at speed, over its way."""

from __future__ import annotations

from dataclasses import replace

from chatscene.terms.amount import Speed
from chatscene.terms.situation import Deed, Other, Situation
from chatscene.terms.vocabulary import PLAIN, Act, Heads, RoadKind, Where, acts_of

_GOES_ON = PLAIN | acts_of(Heads.ACROSS)
_FROM = frozenset((Where.ARM, Where.ROADSIDE, Where.CROSSING, Where.DRIVEWAY))


def over_rails(situation: Situation) -> Situation:
    """The same; who drives along rails across the road comes out of their side, and crosses.

    Its speed at the start is that at which it was said to cross, else the one at which its kind is driven.
    """
    if situation.road.kind is not RoadKind.RAIL_CROSSING:
        return situation
    return replace(situation, others=tuple(map(_over, situation.others)))


def _over(one: Other) -> Other:
    driven = one.kind.row.body.row.driven
    acts = [deed.act for deed in one.does]
    if one.starts.where not in _FROM or driven == float("inf") or not _GOES_ON.issuperset(acts):
        return one
    said = next((deed.speed for deed in one.does if deed.speed is not None), None)
    speed = one.starts.speed or said or Speed(driven, driven)
    does = tuple(replace(deed, act=Act.CROSS) for deed in one.does) or (Deed(act=Act.CROSS),)
    return replace(one, starts=replace(one.starts, where=Where.DRIVEWAY, speed=speed), does=does)
