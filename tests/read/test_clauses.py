"""A text is cut into clauses by whose facts their words gave."""

from __future__ import annotations

import pytest

from chatscene.read.clauses import cut
from chatscene.read.learned.reader import LearnedReader
from chatscene.read.quotes import words_of


@pytest.mark.parametrize(
    ("text", "ego", "others"),
    [
        (
            "A cyclist crosses from the left while we turn right.",
            "we turn right",
            "A cyclist crosses from the left",
        ),
        (
            "We drive at 50 km/h on a road with two lanes; a truck cuts in from the right, then brakes hard.",
            "We drive at 50 km/h on a road with two lanes",
            "a truck cuts in from the right, then brakes hard",
        ),
    ],
)
def test_a_clause_belongs_to_whose_facts_its_words_gave(text: str, ego: str, others: str) -> None:
    read = LearnedReader().read(text).ranked[0].situation
    clauses = cut(text, words_of(read, text))
    assert (clauses.whole, clauses.ego, clauses.adversary) == (text, ego, others)


def test_a_clause_that_gave_no_fact_belongs_to_whoever_came_before() -> None:
    assert cut("Nothing is said, and nothing is done.", ()).ego == "Nothing is said, and nothing is done"


def test_a_number_is_not_cut() -> None:
    assert cut("At 1.5 m, we stop.", ()).ego == "At 1.5 m, we stop"
