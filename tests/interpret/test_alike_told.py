"""What is offered, and how words are shown: no reading twice, and paths as they are set."""

from __future__ import annotations

import chatscene
from chatscene.interpret.offline import OfflineReader
from chatscene.report.accounting import in_words, parts_of
from chatscene.report.stated import Stated
from chatscene.situations.words import told

ROUND = (
    "The Oruma AV, in driverless mode, was moving around a double-parked van in its lane on Kearsley Street. An SUV "
    "coming the other way continued in its lane and clipped the left mirror of the AV. The SUV did not remain at the "
    "scene."
)


def test_of_readings_that_are_told_alike_one_is_offered() -> None:
    offered = [told(one.situation) for one in OfflineReader().read(ROUND).ranked[1:]]
    assert offered
    assert len(set(offered)) == len(offered)


def test_words_of_a_fact_that_was_changed_are_shown_as_they_stand() -> None:
    made = chatscene.explain("a car ahead brakes", set={"others.A.kind": "truck"})
    assert isinstance(made, Stated)
    assert "(about" not in str(made)
    assert "a car (others.A.starts.where: ahead)" in str(made)


def test_a_path_is_shown_as_it_is_set() -> None:
    word = {"text": "hidden", "start": 0, "end": 6, "fact": "others.A.hidden_by"}
    assert in_words(parts_of("hidden", [word])) == "(others.A.hidden_by: hidden)"
