"""The words behind facts, from what the reader marks."""

from __future__ import annotations

import numpy as np

from chatscene.read.learned.decoder import Written
from chatscene.read.learned.evidence import quoted_of
from chatscene.read.learned.sequence import path_of, steps_of
from chatscene.read.learned.text import prepared
from chatscene.situations.form import from_plain
from chatscene.terms.reading import Verdict

TEXT = "A small van, ahead of us, brakes."
VAN = from_plain({"others": [{"id": "A", "kind": "van", "starts": {"where": "ahead"}, "does": [{"act": "brake"}]}]})


def quoted(**marked: str) -> dict[str, str]:
    """What is quoted if of each fact, by the last name of its path, some words are marked."""
    read, steps = prepared(TEXT), steps_of(Verdict.SITUATION, VAN)
    marks: list[np.ndarray] = []
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
