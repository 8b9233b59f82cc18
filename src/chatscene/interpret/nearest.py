"""Snippets by the nearness of their wordings to a text, as vectors and as words: what the paper retrieves with.

Paper: section 3.3, step iii. `chatscene library search` shows it; retrieval goes by it only for behaviors of
a user's own.
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from chatscene.interpret.wording_index import WordingIndex
from chatscene.library.load import Library
from chatscene.models.encoders.embedding import Embedder, Vectors, encode_cached
from chatscene.terms.scenario import Component
from chatscene.terms.snippet import Snippet

WORDS = 0.5  # share of shared words beside the cosine


def nearest(
    text: str, component: Component, library: Library, embedder: Embedder, *, count: int, lexical_weight: float = WORDS
) -> list[tuple[Snippet, float]]:
    """The snippets of one component most similar to a text, best first, with their similarities."""
    snippets = library.of(component)
    similarity = cosines(text, snippets, embedder)
    if lexical_weight:
        similarity = (1 - lexical_weight) * similarity + lexical_weight * _words(snippets).search(text)[0]
    best = np.argsort(-similarity, kind="stable")[:count]
    return [(snippets[i], float(similarity[i])) for i in best]


def cosines(text: str, snippets: tuple[Snippet, ...], embedder: Embedder) -> NDArray[np.float64]:
    """(N,) the cosine of a text and the description of each snippet."""
    rows = _descriptions(snippets, embedder)
    return np.einsum("nd,d->n", rows, embedder.encode([text])[0]).astype(np.float64)  # the same bits on any threads


@lru_cache(maxsize=16)
def _descriptions(snippets: tuple[Snippet, ...], embedder: Embedder) -> Vectors:
    return encode_cached(embedder, [s.description for s in snippets])


@lru_cache(maxsize=16)
def _words(snippets: tuple[Snippet, ...]) -> WordingIndex:
    texts = [(s.description, *s.rephrasings) for s in snippets]
    return WordingIndex(
        tuple(text for each in texts for text in each), tuple(i for i, each in enumerate(texts) for _ in each)
    )
