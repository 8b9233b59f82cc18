from __future__ import annotations

from pathlib import Path

import faiss
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.errors import SettingsError
from chatscene.interpret import vector_index
from chatscene.interpret.vector_index import VectorIndex, build, build_cached
from chatscene.interpret.wording_index import best_of_each
from chatscene.models.encoders.embedding import Vectors

DIMENSION = 24


def rows(count: int, seed: int = 0, centres: int = 40) -> Vectors:
    """Rows of length 1 that lie in clumps, as texts do."""
    rng = np.random.default_rng(seed)
    clumps = rng.standard_normal((centres, DIMENSION))
    made = clumps[rng.integers(centres, size=count)] + 0.5 * rng.standard_normal((count, DIMENSION))
    return (made / np.linalg.norm(made, axis=1, keepdims=True)).astype(np.float32)


ROWS = rows(2000)
QUERIES = rows(20, seed=1)


@pytest.fixture(scope="module")
def large() -> VectorIndex:
    """An index that is approximate, though its rows are few."""
    return build(ROWS, exact_up_to=100)


@given(seed=st.integers(0, 99), size=st.integers(1, 60), count=st.integers(1, 80))
@settings(max_examples=40)
def test_a_small_index_finds_what_comparing_with_every_row_finds(seed: int, size: int, count: int) -> None:
    stored, queries = rows(size, seed), rows(3, seed + 100)
    cosines, found = build(stored).search(queries, count)
    assert cosines.shape == found.shape == (3, min(count, size))
    everyone = queries @ stored.T
    np.testing.assert_allclose(cosines, -np.sort(-everyone, axis=1)[:, :count], atol=1e-5)
    np.testing.assert_allclose(np.take_along_axis(everyone, found, 1), cosines, atol=1e-5)


def test_a_large_index_finds_nearly_all_that_an_exact_one_finds(large: VectorIndex) -> None:
    assert large.lists > vector_index.PROBED
    _, exact = build(ROWS).search(QUERIES, 10)
    _, found = large.search(QUERIES, 10)
    assert np.mean([len(set(a) & set(b)) / 10 for a, b in zip(exact.tolist(), found.tolist(), strict=True)]) >= 0.9


@pytest.mark.parametrize("count", [1, 7, 1500, 2000, 9999])
def test_a_large_index_finds_as_many_as_asked_for_each_once_and_best_first(large: VectorIndex, count: int) -> None:
    cosines, found = large.search(QUERIES, count)
    assert cosines.dtype == np.float32
    assert found.dtype == np.int64
    assert all(len(set(row)) == min(count, 2000) and min(row) >= 0 for row in found.tolist())
    assert (np.diff(cosines, axis=1) <= 0).all()
    np.testing.assert_allclose(cosines, np.take_along_axis(QUERIES @ ROWS.T, found, 1), atol=1e-5)


def test_everything_asked_of_a_large_index_is_everything_in_exact_order(large: VectorIndex) -> None:
    for ours, exact in zip(large.search(QUERIES, 2000), build(ROWS).search(QUERIES, 2000), strict=True):
        np.testing.assert_allclose(ours, exact, atol=1e-5)


@pytest.mark.parametrize("exact_up_to", [100, 5000])
def test_the_cosines_to_all_rows_are_those_of_the_searches(exact_up_to: int) -> None:
    index = build(ROWS, exact_up_to=exact_up_to)
    for query in (QUERIES[:1], QUERIES[1:2]):
        cosines, found = index.search(query, 2000)
        np.testing.assert_array_equal(index.cosines(query)[found[0]], cosines[0])
    with pytest.raises(SettingsError, match="same embedder"):
        index.cosines(np.ones((1, 1), np.float32))


@given(st.lists(st.lists(st.integers(0, 3), min_size=1, max_size=5), min_size=1, max_size=6))
def test_the_best_of_each_owner_is_the_first_of_its_highest_scores(scores: list[list[int]]) -> None:
    owners = np.array([owner for owner, own in enumerate(scores) for _ in own])
    best, rows = best_of_each(np.array([float(score) for own in scores for score in own]), owners)
    for owner, own in enumerate(scores):
        assert best[owner] == max(own)
        assert rows[owner] == np.flatnonzero(owners == owner)[own.index(max(own))]


@pytest.mark.parametrize("exact_up_to", [100, 5000])
def test_the_same_rows_give_the_same_answers_alone_or_together(exact_up_to: int) -> None:
    first, again = (build(ROWS, exact_up_to=exact_up_to) for _ in range(2))
    for one, other in zip(first.search(QUERIES, 10), again.search(QUERIES, 10), strict=True):
        np.testing.assert_array_equal(one, other)
    for i in range(len(QUERIES)):
        np.testing.assert_array_equal(first.search(QUERIES[i : i + 1], 10)[1][0], first.search(QUERIES, 10)[1][i])


def test_of_equal_rows_the_earlier_comes_first() -> None:
    same = np.tile(QUERIES[:1], (6, 1))
    assert build(same).search(QUERIES[:1], 6)[1].tolist() == [[0, 1, 2, 3, 4, 5]]
    assert sorted(build(same, exact_up_to=1).search(QUERIES[:1], 6)[1][0].tolist()) == [0, 1, 2, 3, 4, 5]


@pytest.mark.parametrize("size", [0, 1, 2, 3, 5])
@pytest.mark.parametrize("exact_up_to", [0, 9])
def test_very_few_rows_and_no_queries_are_no_special_case(size: int, exact_up_to: int) -> None:
    index = build(ROWS[:size], exact_up_to=exact_up_to)
    assert index.search(QUERIES, 4)[1].shape == (20, min(size, 4))
    assert index.search(QUERIES[:0], 4)[1].shape == (0, min(size, 4))


def test_an_index_leaves_the_number_of_threads_as_it_was() -> None:
    before = faiss.omp_get_max_threads()
    build(ROWS, exact_up_to=100).search(QUERIES, 3)
    assert faiss.omp_get_max_threads() == before


@pytest.mark.parametrize("wrong", [0.0, 2.0, np.nan, np.inf])
def test_rows_and_queries_that_are_not_of_length_one_are_refused(wrong: float) -> None:
    bad = QUERIES * np.float32(wrong)
    with pytest.raises(SettingsError, match="length 1"):
        build(bad)
    with pytest.raises(SettingsError, match="length 1"):
        build(ROWS).search(bad, 1)


def test_a_query_by_another_embedder_is_refused() -> None:
    with pytest.raises(SettingsError, match="1 numbers in an index of rows of 24; encode both with the same"):
        build(ROWS).search(np.ones((1, 1), np.float32), 1)


# Kept between runs


@pytest.fixture
def home(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    return tmp_path


def _forbidden(*_: object, **__: object) -> VectorIndex:
    raise AssertionError("built again")


def test_a_large_index_is_built_once_and_then_read_from_the_cache(home: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    built = build_cached(ROWS, exact_up_to=100)
    monkeypatch.setattr(vector_index, "build", _forbidden)
    read = build_cached(ROWS, exact_up_to=100)
    for one, other in zip(built.search(QUERIES, 10), read.search(QUERIES, 10), strict=True):
        np.testing.assert_array_equal(one, other)
    with pytest.raises(AssertionError, match="built again"):
        build_cached(ROWS[::-1], exact_up_to=100)  # other rows, another file


def test_a_small_index_is_not_kept(home: Path) -> None:
    build_cached(ROWS)
    assert not list(home.rglob("*.*"))


@pytest.mark.parametrize("damage", [b"", b"not an index", "short", "changed"])
def test_a_damaged_index_is_built_again(home: Path, damage: bytes | str) -> None:
    built = build_cached(ROWS, exact_up_to=100)
    (file,) = home.rglob("*.ivf")
    whole = file.read_bytes()
    changed = whole[:-7] if damage == "short" else whole[:-7] + b"\xff" + whole[-6:]
    file.write_bytes(damage if isinstance(damage, bytes) else changed)
    again = build_cached(ROWS, exact_up_to=100)
    np.testing.assert_array_equal(again.search(QUERIES, 10)[1], built.search(QUERIES, 10)[1])
    assert file.read_bytes() == whole
    assert not list(home.rglob("*.tmp"))


def test_a_cache_that_cannot_be_written_stops_nothing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "file").write_text("not a folder")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    assert build_cached(ROWS, exact_up_to=100).search(QUERIES, 3)[1].shape == (20, 3)
