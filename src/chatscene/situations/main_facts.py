"""The facts by which one situation is another one: where the ego goes, who is there, where they begin, what they do."""

from __future__ import annotations

from itertools import permutations

from chatscene.terms.situation import Deed, Other, Situation
from chatscene.terms.vocabulary import PLAIN, Act, Role, Where

MOST = 5
"""Others that are matched in every order; more are matched in their own."""
NEXT_TO_US = frozenset((Where.BESIDE, Where.AHEAD_BESIDE))
"""Where somebody is who comes from the next lane: texts seldom say which, and either is built to come in ahead."""


def same_in_the_main(one: Situation, other: Situation) -> bool:
    """Whether two situations have the same main facts, those apart that one of them leaves open.

    The order of the others does not count, nor do amounts, manners, contact, road and weather, what hides somebody
    (but that it is hidden does), whether somebody in the next lane is beside or ahead there, and deeds that go without
    saying: that somebody goes on, or stands before it sets off.
    """
    ours, theirs = _met(one), _met(other)
    if len(ours) != len(theirs) or not _same_or_open(one.ego.route, other.ego.route):
        return False
    if _acts(one.ego.does) != _acts(other.ego.does):
        return False
    orders = permutations(theirs) if len(theirs) <= MOST else (theirs,)
    return any(all(map(_same_other, ours, order)) for order in orders)


def _met(situation: Situation) -> tuple[Other, ...]:
    return tuple(one for one in situation.others if one.role is not Role.HIDES)


def _same_other(one: Other, other: Other) -> bool:
    return (
        one.kind is other.kind
        and (one.starts.where is other.starts.where or {one.starts.where, other.starts.where} <= NEXT_TO_US)
        and _same_or_open(one.starts.side, other.starts.side)
        and _acts(one.does) == _acts(other.does)
        and (one.hidden_by is None) == (other.hidden_by is None)
    )


def _acts(does: tuple[Deed, ...]) -> tuple[Act, ...]:
    acts = tuple(one.act for one in does if one.act not in PLAIN)
    return acts[1:] if len(acts) > 1 and acts[0] is Act.STAND else acts


def _same_or_open(one: object, other: object) -> bool:
    return one is None or other is None or one == other
