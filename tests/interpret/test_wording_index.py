"""The words that a text shares with many wordings, and the file in which their counts are kept."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from chatscene.interpret import wording_index
from chatscene.interpret.wording_index import MANY, WordingIndex, best_of_each

WORDS = ("bus", "pulls", "out", "brakes", "twice", "left", "kerb", "cuts", "in", "stops")
WORDINGS = tuple(f"the {WORDS[i % 10]} {WORDS[i // 10 % 10]} {WORDS[i // 100 % 10]} near {i // 7}" for i in range(MANY))
OWNERS = tuple(i // 4 for i in range(MANY))
TEXTS = ("", "a bus brakes twice", "brakes, brakes", "nothing of it", "near 12 the kerb cuts in")


@pytest.fixture
def cache(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return tmp_path


def found(index: WordingIndex) -> list[tuple[list[float], tuple[str, ...]]]:
    return [(scores.tolist(), texts) for scores, texts in map(index.search, TEXTS)]


def test_a_wording_that_is_the_text_has_a_cosine_of_one_and_one_without_its_words_none() -> None:
    index = WordingIndex(("a bus brakes", "it stops at the kerb", "the van brakes twice"), (0, 0, 1))
    scores, texts = index.search("the bus brakes")
    assert scores[0] == pytest.approx(1.0)
    assert 0.0 < scores[1] < 1.0
    assert texts == ("a bus brakes", "the van brakes twice")
    assert index.search("a dragon")[0].tolist() == [0.0, 0.0]


def test_many_wordings_are_counted_once_and_then_read_from_the_cache(
    cache: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    first = found(WordingIndex(WORDINGS, OWNERS))
    assert len(list(cache.rglob("*.npz"))) == 1
    monkeypatch.setattr(wording_index, "_counted", None)
    assert found(WordingIndex(WORDINGS, OWNERS)) == first


def test_few_wordings_leave_nothing_in_the_cache(cache: Path) -> None:
    WordingIndex(WORDINGS[:20], OWNERS[:20])
    assert not list(cache.rglob("*.npz"))


@pytest.mark.parametrize("damage", ["empty", "half", "changed"])
def test_kept_counts_that_are_damaged_cost_time_and_nothing_else(cache: Path, damage: str) -> None:
    first = found(WordingIndex(WORDINGS, OWNERS))
    (path,) = cache.rglob("*.npz")
    whole = path.read_bytes()
    path.write_bytes(
        {"empty": b"", "half": whole[: len(whole) // 2], "changed": whole[:-7] + b"\xff" + whole[-6:]}[damage]
    )
    assert found(WordingIndex(WORDINGS, OWNERS)) == first
    assert path.read_bytes() == whole


@given(st.lists(st.lists(st.integers(0, 3), min_size=1, max_size=5), min_size=1, max_size=6))
def test_the_best_of_each_owner_is_the_first_of_its_highest_scores(scores: list[list[int]]) -> None:
    owners = np.array([owner for owner, own in enumerate(scores) for _ in own])
    best, rows = best_of_each(np.array([float(score) for own in scores for score in own]), owners)
    for owner, own in enumerate(scores):
        assert best[owner] == max(own)
        assert rows[owner] == np.flatnonzero(owners == owner)[own.index(max(own))]
