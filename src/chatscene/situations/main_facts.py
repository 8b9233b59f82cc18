"""The facts by which one situation is another one: where the ego goes, who is there, where they begin, what they do."""

from __future__ import annotations

from itertools import permutations

from chatscene.terms.situation import Deed, Other, Situation
from chatscene.terms.vocabulary import Act

MOST = 5
"""Others that are matched in every order; more are matched in their own."""


def same_in_the_main(one: Situation, other: Situation) -> bool:
    """Whether two situations have the same main facts, those apart that one of them leaves open.

    The order of the others does not count, nor do amounts, manners, contact, road and weather.
    """
    if len(one.others) != len(other.others) or not _same_or_open(one.ego.route, other.ego.route):
        return False
    if _acts(one.ego.does) != _acts(other.ego.does):
        return False
    orders = permutations(other.others) if len(other.others) <= MOST else (other.others,)
    return any(all(map(_same_other, one.others, order)) for order in orders)


def _same_other(one: Other, other: Other) -> bool:
    return (
        one.kind is other.kind
        and one.starts.where is other.starts.where
        and _same_or_open(one.starts.side, other.starts.side)
        and _acts(one.does) == _acts(other.does)
        and (one.hidden_by is None) == (other.hidden_by is None)
    )


def _acts(does: tuple[Deed, ...]) -> tuple[Act, ...]:
    return tuple(one.act for one in does)


def _same_or_open(one: object, other: object) -> bool:
    return one is None or other is None or one == other
