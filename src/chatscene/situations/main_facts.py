"""The facts by which one situation is another one: where the ego goes, who is there, where they begin, what they do."""

from __future__ import annotations

from collections.abc import Callable
from itertools import permutations

from chatscene.terms.situation import Deed, Other, Situation
from chatscene.terms.vocabulary import PLAIN, Act, Role, Where

MOST = 5
"""Others that are matched in every order; more are matched in their own."""
NEXT_TO_US = frozenset((Where.BESIDE, Where.AHEAD_BESIDE))
"""Where somebody is who comes from the next lane: texts seldom say which, and either is built to come in ahead."""
OVER_OUR_WAY = frozenset((Where.ROADSIDE, Where.CROSSING, Where.EXIT_CROSSING))
"""Where somebody is who crosses the ego's way: texts seldom say whether that is at a crosswalk, or before a turn."""


def same_in_the_main(one: Situation, other: Situation) -> bool:
    """Whether two situations have the same main facts, those apart that one of them leaves open.

    The order of the others does not count, nor do amounts, manners, contact, road and weather, what hides somebody
    (but that it is hidden does), whether somebody in the next lane is beside or ahead there, where who crosses does so,
    and deeds that go without saying: that somebody goes on, or stands before it sets off.
    """
    ours, theirs = _met(one), _met(other)
    if len(ours) != len(theirs) or not _same_or_open(one.ego.route, other.ego.route):
        return False
    return _acts(one.ego.does) == _acts(other.ego.does) and _all_among(ours, theirs, _same)


def within_the_main(part: Situation, whole: Situation) -> bool:
    """Whether one situation has no main fact that another has not.

    It may lack others, the last deeds of somebody, and what the ego does.
    """
    if not _same_or_open(part.ego.route, whole.ego.route) or not _begins(_acts(part.ego.does), _acts(whole.ego.does)):
        return False
    return _all_among(_met(part), _met(whole), _begins)


def _all_among(
    ours: tuple[Other, ...], theirs: tuple[Other, ...], same: Callable[[tuple[Act, ...], tuple[Act, ...]], bool]
) -> bool:
    """Whether each of some others is one of those of another situation, if their acts are the same in some sense."""
    if len(ours) > len(theirs):
        return False
    orders = permutations(theirs, len(ours)) if len(theirs) <= MOST else (theirs[: len(ours)],)
    return any(
        all(_same_other(a, b) and same(_acts(a.does), _acts(b.does)) for a, b in zip(ours, order, strict=True))
        for order in orders
    )


def _same(one: tuple[Act, ...], other: tuple[Act, ...]) -> bool:
    return one == other


def _begins(one: tuple[Act, ...], other: tuple[Act, ...]) -> bool:
    return one == other[: len(one)]


def _met(situation: Situation) -> tuple[Other, ...]:
    return tuple(one for one in situation.others if one.role is not Role.HIDES)


def _same_other(one: Other, other: Other) -> bool:
    return (
        one.kind is other.kind
        and _same_place(one, other)
        and _same_or_open(one.starts.side, other.starts.side)
        and (one.hidden_by is None) == (other.hidden_by is None)
    )


def _same_place(one: Other, other: Other) -> bool:
    places = {one.starts.where, other.starts.where}
    crosses = all(any(deed.act is Act.CROSS for deed in each.does) for each in (one, other))
    return len(places) == 1 or places <= NEXT_TO_US or (crosses and places <= OVER_OUR_WAY)


def _acts(does: tuple[Deed, ...]) -> tuple[Act, ...]:
    acts = tuple(one.act for one in does if one.act not in PLAIN)
    return acts[1:] if len(acts) > 1 and acts[0] is Act.STAND else acts


def _same_or_open(one: object, other: object) -> bool:
    return one is None or other is None or one == other
