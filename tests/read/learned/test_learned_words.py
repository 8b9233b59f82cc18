"""What a word that was never learned is marked for is a guess, and words that mostly told a fact are shown first."""

from __future__ import annotations

from chatscene.read.learned.reader import LearnedReader
from chatscene.read.learned.words import is_learned, stem_of, tells
from chatscene.read.quotes import unread
from chatscene.terms.situation import Situation


def test_the_forms_of_a_word_are_one() -> None:
    assert {stem_of(word) for word in ("brake", "brakes", "braked", "braking")} == {"brak"}
    assert is_learned("right-turning") and is_learned("50") and not is_learned("moonwalking")


def test_a_word_that_was_never_learned_says_no_act() -> None:
    read = LearnedReader().read("A pedestrian moonwalks over the road.")
    assert "moonwalks" in read.unread
    assert "moonwalks" not in " ".join(read.ranked[0].situation.evidence.quoted.values())


def test_words_that_mostly_told_a_fact_are_shown_first() -> None:
    assert tells("pedestrian") > tells("music")
    assert unread(Situation(), "music: a pedestrian") == ("pedestrian", "music")
