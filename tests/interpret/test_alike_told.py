"""How words are shown: paths as they are set."""

from __future__ import annotations

import chatscene
from chatscene.report.accounting import in_words, parts_of
from chatscene.report.stated import Stated


def test_words_of_a_fact_that_was_changed_are_shown_as_they_stand() -> None:
    made = chatscene.explain("a car ahead brakes", set={"others.A.kind": "truck"})
    assert isinstance(made, Stated)
    assert "(about" not in str(made)
    assert "\na car (others.A.starts.where: ahead)" in str(made)


def test_a_path_is_shown_as_it_is_set() -> None:
    word = {"text": "hidden", "start": 0, "end": 6, "fact": "others.A.hidden_by"}
    assert in_words(parts_of("hidden", [word])) == "(others.A.hidden_by: hidden)"
