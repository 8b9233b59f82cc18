"""Who begins beside another, or just before it: who is passed, who keeps level with it, who lets it across."""

from __future__ import annotations

from collections.abc import Sequence

from chatscene.build.asked import stands_first
from chatscene.build.place import NEXT_LANE
from chatscene.build.relations import AGAINST, AHEAD, BEHIND
from chatscene.build.towards import passes
from chatscene.terms.situation import Other
from chatscene.terms.vocabulary import COMES_IN, Act, Heads, Role, Side, Where, acts_of

OUT = (2.0, 6.0)  # [m] between who has swung out and whom it passes, from and to
BEFORE_OUT = (10.0, 14.0)  # [m], the same, of who has not swung out yet
_CLEAR = 1.5  # [m] between who crosses and who stands before it
_COMES_ACROSS = COMES_IN | acts_of(Heads.MERGES, Heads.OVER)
_FROM_SIDE = frozenset((Where.ROADSIDE, Where.DRIVEWAY, Where.KERB))
_GROUPS = (AGAINST, AHEAD, BEHIND)


def anchor_of(one: Other, others: Sequence[Other]) -> tuple[Other, float] | None:
    """Whom somebody begins beside, and how much farther [m] it then is; None for who begins by itself."""
    if one.starts.distance is not None:
        return None
    length = one.kind.row.body.row.limits.length
    for other in others:
        if other.id == one.id:
            continue
        body = other.kind.row.body.row.limits
        if _keeps_level(one, other, others) or (_goes_abreast(one, other) and _is_first(other, one, others)):
            return other, 0.0
        if passed_at_distance(one, other):
            apart = OUT if other.starts.where is Where.ONCOMING_IN_OUR_LANE else BEFORE_OUT
            return other, -0.5 * (length + body.length) - 0.5 * sum(apart)
        if _lets_across(one, other):
            room = 0.5 * (length + body.width) + _CLEAR  # before its nose
            return other, room if one.starts.where in AGAINST else -room
    return None


def passed_at_distance(one: Other, other: Other) -> bool:
    """Whether somebody is passed by another who comes against the ego, so far away as was said."""
    against = one.starts.where in AGAINST and other.starts.where in AGAINST
    return against and passes(other, one) and other.starts.distance is not None


def _keeps_level(one: Other, other: Other, others: Sequence[Other]) -> bool:
    """Whether two keep level with each other, and the other is placed first."""
    levels = any(
        deed.act is Act.KEEP_LEVEL and deed.whom == then.id
        for who, then in ((one, other), (other, one))
        for deed in who.does[:1]
    )
    together = any(one.starts.where in group and other.starts.where in group for group in _GROUPS)
    return levels and together and _is_first(other, one, others)


def _is_first(other: Other, one: Other, others: Sequence[Other]) -> bool:
    """Whether another is placed before somebody."""
    ids = [each.id for each in others]
    ranks = [(each.role is not Role.ADVERSARY, ids.index(each.id)) for each in (other, one)]
    return ranks[0] < ranks[1]


def _goes_abreast(one: Other, other: Other) -> bool:
    """Whether two without motors go side by side in one lane: the one to its left, the other to its right."""
    start, there = one.starts, other.starts
    if start.lateral is None or there.lateral is None or there.distance is not None:
        return False
    sides = {start.lateral.side, there.lateral.side} == {Side.LEFT, Side.RIGHT}
    slow = not (one.kind.row.body.row.motorised or other.kind.row.body.row.motorised)
    return sides and slow and start.where is there.where and start.side is there.side


def _lets_across(one: Other, other: Other) -> bool:
    """Whether somebody stands in the next lane for another who comes across that lane."""
    start, there = one.starts, other.starts
    stands = stands_first(one) and len(one.does) <= 1 and one.role is not Role.ADVERSARY
    crosses = any(deed.act in _COMES_ACROSS for deed in other.does) and there.where in _FROM_SIDE
    lane = start.side if start.where in NEXT_LANE else Side.LEFT if start.where is Where.ONCOMING else None
    return stands and crosses and lane is not None and lane is there.side and other.hidden_by in (None, one.id)
