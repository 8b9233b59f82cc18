"""Words that a text and a snippet's wordings share, weighed by how rare they are.

TF-IDF cosine over stems and pairs of stems (G. Salton, 1975); beside an encoder it tells apart what an encoder
blurs: "brakes twice" from "brakes".
"""

from __future__ import annotations

import re
from collections import Counter
from functools import lru_cache
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.models.encoders.embedding import plain

_SILENT = frozenset(
    (
        *("a", "an", "and", "are", "as", "at", "be", "by", "for", "from", "he", "her", "him", "his", "in", "is", "it"),
        *("its", "of", "on", "or", "she", "that", "the", "their", "them", "then", "they", "this", "to", "was", "were"),
        *("while", "who", "with", "which"),
    )
)


@lru_cache(maxsize=8192)
def stem(word: str) -> str:
    """A word without its commonest endings."""
    return re.sub(r"(?<=[a-z]{3})(?:'s|ing|ed|es|s|ly|e)$", "", word)


def _terms(text: str) -> Counter[str]:
    words = [stem(word) for word in re.findall(r"[a-z0-9']+", plain(text).lower()) if word not in _SILENT]
    return Counter([*words, *(f"{a} {b}" for a, b in pairwise(words))])


class WordingIndex:
    """Wordings, each owned by a snippet; searched by the words they share with a text."""

    def __init__(self, wordings: tuple[str, ...], owners: tuple[int, ...]) -> None:
        self._wordings = wordings
        self._owners = np.array(owners)
        self._numbers: dict[str, int] = {}  # of the terms
        each, times, sizes = list[int](), list[int](), list[int]()
        for text in wordings:
            terms = _terms(text)
            each.extend(self._numbers.setdefault(term, len(self._numbers)) for term in terms)
            times.extend(terms.values())
            sizes.append(len(terms))
        term, row = np.array(each, np.intp), np.repeat(np.arange(len(wordings)), sizes)
        seen = np.bincount(term, minlength=len(self._numbers))
        self._rarity = np.log((1 + len(wordings)) / (1 + seen)) + 1
        weight = np.array(times, float) * self._rarity[term]
        length = np.sqrt(np.bincount(row, weight**2, minlength=len(wordings)))
        by_term = np.argsort(term, kind="stable")
        # Of each term, one after another: the rows that have it, and its share of them.
        self._rows, self._shares = row[by_term], (weight / length[row])[by_term]
        self._ends = np.cumsum(seen)

    def search(self, text: str) -> tuple[NDArray[np.float64], list[str]]:
        """(N,) cosine of a text to the nearest wording of each snippet, and that wording."""
        terms = {self._numbers[term]: times for term, times in _terms(text).items() if term in self._numbers}
        weights = {number: times * float(self._rarity[number]) for number, times in terms.items()}
        length = float(np.sqrt(sum(w * w for w in weights.values()))) or 1.0
        scores = np.zeros(len(self._wordings))
        for number, weight in weights.items():
            own = slice(self._ends[number - 1] if number else 0, self._ends[number])
            scores[self._rows[own]] += self._shares[own] * (weight / length)
        best, rows = best_of_each(scores, self._owners)
        return best, [self._wordings[row] for row in rows]


def best_of_each(scores: NDArray[Any], owners: NDArray[np.intp]) -> tuple[NDArray[Any], NDArray[np.intp]]:
    """(N,) the best score among the rows of each owner, and the first row that has it.

    Args:
        scores: (R,), one per row.
        owners: (R,) whose each row is: 0 to N - 1, in order, none left out.
    """
    best = np.maximum.reduceat(scores, np.flatnonzero(np.diff(owners, prepend=-1)))
    rows = np.empty(len(best), np.intp)
    found = np.flatnonzero(scores == best[owners])[::-1]
    rows[owners[found]] = found  # of several, the one written last stays: the first
    return best, rows
