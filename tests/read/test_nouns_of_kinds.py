"""What the offline reader makes of the noun of each kind of road user."""

from __future__ import annotations

import pytest

from chatscene.read.learned.reader import LearnedReader
from chatscene.situations.phrases import KINDS
from chatscene.terms.actors import Manner
from chatscene.terms.reading import Verdict
from chatscene.terms.vocabulary import UserKind


@pytest.mark.parametrize("kind", UserKind)
def test_a_kind_is_read_by_the_noun_that_it_is_told_with(kind: UserKind) -> None:
    noun = KINDS[kind].one
    does = "lies in our lane" if kind.moves is Manner.LIES else "crosses in front of us from the right"
    read = LearnedReader().read(f"{noun[0].upper()}{noun[1:]} {does}.")
    assert read.verdict is Verdict.SITUATION
    assert [one.kind for one in read.ranked[0].situation.others] == [kind]


@pytest.mark.parametrize(
    ("text", "ego", "other"),
    [
        ("A pickup ahead of us brakes hard.", None, UserKind.PICKUP),
        ("A woman with a pram crosses from the left.", None, UserKind.PRAM),
        ("An auto-rickshaw makes a U-turn in front of my pickup truck.", UserKind.PICKUP, UserKind.AUTO_RICKSHAW),
        ("A shopping trolley lies in our lane.", None, UserKind.OBJECT),
        ("A tram crosses in front of us from the left.", None, UserKind.TRAM),
        ("A bicycle crosses in front of us from the left.", None, UserKind.BICYCLE),
    ],
)
def test_a_noun_that_was_never_learned_says_of_which_kind_somebody_is(
    text: str, ego: UserKind | None, other: UserKind
) -> None:
    situation = LearnedReader().read(text).ranked[0].situation
    assert (situation.ego.kind, situation.others[0].kind) == (ego, other)
