"""Things that roll or are blown over the road: they move as a ball does, whatever they are."""

from __future__ import annotations

from dataclasses import replace

from chatscene.terms.situation import Other, Situation
from chatscene.terms.vocabulary import ROLLING, Moves, UserKind


def rolls(one: Other) -> bool:
    """Whether it is a thing that lies there by its kind, and is said to come over the road."""
    return one.kind.moves is Moves.LIES and any(deed.act in ROLLING for deed in one.does)


def as_it_rolls(situation: Situation) -> Situation:
    """A situation in which each thing that rolls is a ball; the same, unless one does."""
    if not any(map(rolls, situation.others)):
        return situation
    others = (replace(one, kind=UserKind.BALL) if rolls(one) else one for one in situation.others)
    return replace(situation, others=tuple(others))
