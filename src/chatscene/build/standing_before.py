"""Who stands before an ego that stands, as in a queue: who is to back up there does not come driving first."""

from __future__ import annotations

from dataclasses import replace

from chatscene.terms.amount import Speed
from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import Act, Where

_STANDS = Speed(0.0, 0.0)


def in_queue(situation: Situation) -> Situation:
    """The same; who backs up first, before an ego that stands all the time, stands before it."""
    stands = bool(situation.ego.does) and all(deed.act is Act.STAND for deed in situation.ego.does)
    return replace(situation, others=tuple(map(_standing, situation.others))) if stands else situation


def _standing(one: Other) -> Other:
    backs = bool(one.does) and one.does[0].act is Act.REVERSE and one.starts.where is Where.AHEAD
    return replace(one, starts=replace(one.starts, speed=_STANDS)) if backs and one.starts.speed is None else one
