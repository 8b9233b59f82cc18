"""Who comes against the ego and loses speed while somebody crosses the road does so for that one, and when it does."""

from __future__ import annotations

from dataclasses import replace

from chatscene.build.asked import stands_first
from chatscene.build.possible import OFF_ROAD
from chatscene.terms.actors import Manner as Moves
from chatscene.terms.situation import Other, Situation, When
from chatscene.terms.vocabulary import COMES_IN, LOSES, Where


def answering(situation: Situation) -> tuple[Situation, tuple[str, ...]]:
    """The same; who loses speed on its way against the ego waits for who crosses, if nothing else was said.

    Returns:
        The situation, and what was chosen for it, in words.
    """
    crosses = next((one for one in situation.others if _crosses(one)), None)
    if crosses is None:
        return situation, ()
    k = next(k for k, deed in enumerate(crosses.does) if deed.act in COMES_IN)
    others, told = list[Other](), list[str]()
    for one in situation.others:
        if _answers(one, crosses):
            first = replace(one.does[0], when=When(during=f"{crosses.id}.{k}"))
            told.append(f"{one.id} does its {first.act} for {crosses.id}")
            one = replace(one, does=(first, *one.does[1:]))  # noqa: PLW2901 - the same road user
        others.append(one)
    return replace(situation, others=tuple(others)), tuple(told)


def _crosses(one: Other) -> bool:
    """Whether somebody on foot crosses the road."""
    on_foot = one.kind.moves is Moves.WALKS and one.starts.where in OFF_ROAD
    return on_foot and any(deed.act in COMES_IN for deed in one.does)


def _answers(one: Other, crosses: Other) -> bool:
    """Whether somebody who comes the other way loses speed, and it was not said when or for whom else."""
    if one.starts.where is not Where.ONCOMING or not one.does or stands_first(one) or one.starts.distance is not None:
        return False
    first = one.does[0]
    return first.act in LOSES and first.when is None and first.whom in (None, crosses.id)
