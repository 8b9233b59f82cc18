"""Packaged vectors are the encoder's own, but for rounding; what is not packaged is encoded."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from chatscene.snippets import wording_vectors
from chatscene.snippets.embedding import load_embedder
from chatscene.snippets.library import load_library
from chatscene.snippets.wording_vectors import save_vectors, vectors_of
from chatscene.terms.scenario import Component

TEXTS = ("The car brakes hard.", "A child runs into the road.", "The car brakes hard.")


def test_kept_rows_are_the_encoders_rows_but_for_rounding(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    embedder = load_embedder()
    save_vectors(TEXTS, embedder, tmp_path / "v.npz")
    monkeypatch.setattr(wording_vectors, "PACKAGED", tmp_path / "v.npz")
    wording_vectors._known.cache_clear()  # pyright: ignore[reportPrivateUsage]
    kept = vectors_of([*TEXTS, "Something else entirely."], embedder)
    wording_vectors._known.cache_clear()  # pyright: ignore[reportPrivateUsage]
    cosines = (kept * embedder.encode([*TEXTS, "Something else entirely."])).sum(axis=1)
    np.testing.assert_allclose(cosines, 1.0, atol=1e-3)
    np.testing.assert_array_equal(kept[0], kept[2])


def test_a_damaged_file_costs_time_and_nothing_else(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "v.npz").write_bytes(b"nothing")
    monkeypatch.setattr(wording_vectors, "PACKAGED", tmp_path / "v.npz")
    wording_vectors._known.cache_clear()  # pyright: ignore[reportPrivateUsage]
    embedder = load_embedder()
    np.testing.assert_allclose(vectors_of(TEXTS, embedder), embedder.encode(TEXTS), atol=1e-6)
    wording_vectors._known.cache_clear()  # pyright: ignore[reportPrivateUsage]


def test_nearly_every_wording_of_the_packaged_behaviors_is_kept() -> None:
    embedder = load_embedder()
    wording_vectors._known.cache_clear()  # pyright: ignore[reportPrivateUsage]
    known = wording_vectors._known()  # pyright: ignore[reportPrivateUsage]
    texts = [t for s in load_library().of(Component.BEHAVIOR) for t in (s.description, *s.rephrasings)]
    missing = [t for t in texts if wording_vectors._key(t, embedder) not in known]  # pyright: ignore[reportPrivateUsage]
    assert len(missing) <= 0.05 * len(texts)
