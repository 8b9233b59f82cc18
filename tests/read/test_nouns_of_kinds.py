"""What the offline reader makes of the noun of each kind of road user."""

from __future__ import annotations

import pytest

from chatscene.read.learned.reader import LearnedReader
from chatscene.situations.phrases import KINDS
from chatscene.terms.actors import Manner
from chatscene.terms.reading import Verdict
from chatscene.terms.vocabulary import UserKind

NOT_LEARNED: frozenset[UserKind] = frozenset()
"""Kinds that came after it was trained; a language model, an edit and a file know them at once."""


@pytest.mark.parametrize("kind", sorted(frozenset(UserKind) - NOT_LEARNED))
def test_a_kind_is_read_by_the_noun_that_it_is_told_with(kind: UserKind) -> None:
    noun = KINDS[kind].one
    does = "lies in our lane" if kind.moves is Manner.LIES else "crosses in front of us from the right"
    read = LearnedReader().read(f"{noun[0].upper()}{noun[1:]} {does}.")
    said = f"train the reader (docs/lab/learned-reader.md), or name {kind} in NOT_LEARNED here"
    assert read.verdict is Verdict.SITUATION, said
    assert [one.kind for one in read.ranked[0].situation.others] == [kind], said
