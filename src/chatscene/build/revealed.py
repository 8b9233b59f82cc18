"""Who leaves the ego's lane before somebody slow: it is nearer to the ego than that one, which it shows by leaving."""

from __future__ import annotations

from dataclasses import replace

from chatscene.build.asked import goes_slowly, stands_first
from chatscene.build.towards import screens
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import Act, Tempo, Where, acts_of


def revealed(situation: Situation) -> tuple[Situation, tuple[str, ...]]:
    """The same; who is slow or stands ahead is hidden by who is to cut out before it, if nothing else was said.

    Returns:
        The situation, and what was chosen for it, in words.
    """
    free = [one for one in situation.others if one.starts.where is Where.AHEAD and one.starts.distance is None]
    leaves = [one for one in free if one.does and one.does[0].act is Act.CUT_OUT and one.does[0].when is None]
    if len(leaves) != 1 or any(one.hidden_by == leaves[0].id for one in situation.others):
        return situation, ()
    first = next((one.id for one in free if one is not leaves[0] and _is_slow(one) and one.hidden_by is None), None)
    if first is None:
        return situation, ()
    others = (replace(one, hidden_by=leaves[0].id) if one.id == first else one for one in situation.others)
    told = f"{first} is ahead of {leaves[0].id}, which hides it until it moves out"
    return replace(situation, others=tuple(others)), (told,)


def shows_slow(one: Other, hidden: Other) -> bool:
    """Whether somebody leaves the ego's lane before another who goes along slowly there, and is hidden by it."""
    leaves = bool(one.does) and one.does[0].act is Act.CUT_OUT
    return leaves and screens(one, hidden) and not stands_first(hidden) and _is_slow(hidden)


def _is_slow(one: Other) -> bool:
    """Whether somebody stands, or is said to be slower than the ego wants to be."""
    said = one.starts.speed
    slower = said is not None and (said.than_ego and said.high < 0.0)
    backs = bool(one.does) and one.does[0].act in acts_of(Tempo.BACKS)
    return stands_first(one) or goes_slowly(one) or slower or backs or not one.kind.row.body.row.motorised
