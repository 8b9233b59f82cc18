"""The words behind facts, from what the reader marks."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from chatscene.read.learned.decoder import Written
from chatscene.read.learned.evidence import quoted_of
from chatscene.read.learned.sequence import path_of
from chatscene.read.learned.text import prepared
from chatscene.situations.form import from_plain
from chatscene.terms.reading import Verdict
from making.reader.sequence import steps_of

TEXT = "A small van, ahead of us, brakes."
VAN = from_plain({"others": [{"id": "A", "kind": "van", "starts": {"where": "ahead"}, "does": [{"act": "brake"}]}]})


def quoted(**marked: str) -> dict[str, str]:
    """What is quoted if of each fact, by the last name of its path, some words are marked."""
    read, steps = prepared(TEXT), steps_of(Verdict.SITUATION, VAN)
    marks: list[NDArray[np.float32]] = []
    for at in range(len(steps) - 1):
        its = np.full(len(read.pieces), -3.0, np.float32)
        for word in marked.get(path_of(steps, at).rpartition(".")[2], "").split():
            low = TEXT.index(word)
            its[[i for i, (begin, end) in enumerate(read.where, 1) if begin <= low < end]] = 2.0
        marks.append(its)
    return dict(quoted_of(read, Written(steps, 0.0, (), tuple(marks))))


def test_marked_words_are_quoted_without_punctuation() -> None:
    assert quoted(kind="small van", where="ahead", act="brakes") == {
        "others.A.kind": "small van",
        "others.A.starts.where": "ahead",
        "others.A.does.0.act": "brakes",
    }


def test_words_that_stand_apart_are_quoted_apart() -> None:
    assert quoted(kind="van", where="ahead us", act="brakes")["others.A.starts.where"] == "ahead \u2026 us"


def test_a_fact_without_a_marked_word_has_its_likeliest() -> None:
    assert quoted(kind="van", act="brakes")["others.A.starts.where"] == "A"


def _quoted_as_turning(text: str, word: str) -> str:
    """What is quoted for the ego's turn to the left if one word is marked for it."""
    said = from_plain(
        {"ego": {"route": "left-turn"}, "others": [{"id": "A", "kind": "car", "starts": {"where": "ahead"}}]}
    )
    read, steps = prepared(text), steps_of(Verdict.SITUATION, said)
    marks = tuple(np.full(len(read.pieces), -3.0, np.float32) for _ in steps[:-1])
    for own, its in zip(("", word, "car", "ahead"), marks, strict=True):
        its[[i for i, (low, high) in enumerate(read.where, 1) if own and own in text[low:high]]] = 2.0
    return quoted_of(read, Written(steps, 0.0, (), marks))["ego.route"]


def test_a_word_beside_a_fact_that_names_what_it_is_says_it_too() -> None:
    assert _quoted_as_turning("A car is ahead as we turn to the left.", "left") == "turn … left"
    assert _quoted_as_turning("A car turning is ahead as we go left.", "left") == "left"


def _quoted_of_place(text: str, marked: str) -> str | None:
    """What is quoted for where the van of `VAN` is if some words are marked for it."""
    read, steps = prepared(text), steps_of(Verdict.SITUATION, VAN)
    marks = tuple(np.full(len(read.pieces), -3.0, np.float32) for _ in steps[:-1])
    for at, its in enumerate(marks):
        words = marked if path_of(steps, at).endswith("where") else "van"
        its[[i for i, (low, high) in enumerate(read.where, 1) if text[low:high].strip(" .") in words.split()]] = 2.0
    return quoted_of(read, Written(steps, 0.0, (), marks)).get("others.A.starts.where")


def test_a_road_user_that_nobody_there_is_says_no_place_unless_it_names_one_with_the_next_word() -> None:
    assert _quoted_of_place("A van and a cyclist brake ahead.", "cyclist ahead") == "ahead"
    assert _quoted_of_place("A van brakes at the bus stop.", "bus stop") == "bus stop"


def test_a_number_and_another_word_of_the_same_field_do_not_say_a_fact() -> None:
    text = "In fog and rain a van of 40 tons brakes ahead."
    van = {"id": "A", "kind": "van", "starts": {"where": "ahead"}}
    said = from_plain({"around": {"weather": "fog"}, "others": [van]})
    read, steps = prepared(text), steps_of(Verdict.SITUATION, said)
    marks = tuple(np.full(len(read.pieces), 2.0, np.float32) for _ in steps[:-1])
    words = quoted_of(read, Written(steps, 0.0, (), marks))
    assert "fog" in words["around.weather"]
    assert "rain" not in words["around.weather"]
    assert "40" not in words["others.A.kind"]


def test_the_words_of_an_amount_that_is_copied_say_nothing_else() -> None:
    text = "A van brakes ahead of us at 8 km/h."
    read = prepared(text)
    deed = {"act": "brake", "speed": "8 km/h"}
    said = from_plain({"others": [{"id": "A", "kind": "van", "starts": {"where": "ahead"}, "does": [deed]}]})
    steps = steps_of(Verdict.SITUATION, said)
    at = next(i for i, step in enumerate(steps) if step.amount is not None)
    marks = tuple(
        np.array([0.0, *(2.0 if "km/h" in text[low:high] else -3.0 for low, high in read.where), 0.0], np.float32)
        for _ in steps[:-1]
    )
    told = quoted_of(read, Written(steps, 0.0, ((at, read.amounts[0]),), marks))
    assert "8 km/h" in told["others.A.does.0.speed"]
    assert "km/h" not in told["others.A.does.0.act"]


def test_a_word_that_two_facts_share_is_quoted_for_the_likelier_one_alone() -> None:
    read, steps = prepared(TEXT), steps_of(Verdict.SITUATION, VAN)
    marks = [np.full(len(read.pieces), -3.0, np.float32) for _ in steps[:-1]]
    for at, row in enumerate(marks):
        for i, (begin, end) in enumerate(read.where, 1):
            word, path = TEXT[begin:end].strip(" ,."), path_of(steps, at)
            if path.endswith(".where") and word in ("van", "ahead"):
                row[i] = 1.0
            if path.endswith(".kind") and word == "van":
                row[i] = 4.0
    told = quoted_of(read, Written(steps, 0.0, (), tuple(marks)))
    assert told["others.A.kind"] == "van"
    assert told["others.A.starts.where"] == "ahead"


def test_a_fact_for_which_only_an_amount_is_marked_has_no_words() -> None:
    text = "A van ahead brakes with 5 ft."
    said = from_plain(
        {
            "others": [
                {
                    "id": "A",
                    "kind": "van",
                    "starts": {"where": "ahead"},
                    "does": [{"act": "brake", "manner": "sudden"}],
                }
            ]
        }
    )
    read, steps = prepared(text), steps_of(Verdict.SITUATION, said)
    marks = tuple(
        np.array(
            [0.0, *(2.0 if text[low:high].strip(" .") in own else -3.0 for low, high in read.where), 0.0], np.float32
        )
        for own in ("5 ft" if path_of(steps, at).endswith("manner") else "van" for at in range(len(steps) - 1))
    )
    assert "others.A.does.0.manner" not in quoted_of(read, Written(steps, 0.0, (), marks))
