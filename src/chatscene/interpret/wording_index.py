"""Words that a text and a snippet's wordings share, weighed by how rare they are.

TF-IDF cosine over stems and pairs of stems (G. Salton, 1975); beside an encoder it tells apart what an encoder
blurs: "brakes twice" from "brakes".
"""

from __future__ import annotations

import hashlib
import re
from bisect import bisect_left
from collections import Counter
from dataclasses import dataclass, fields
from functools import lru_cache
from io import BytesIO
from itertools import pairwise
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.files.caches import cache_folder, keep, kept, sealed
from chatscene.models.encoders import embedding
from chatscene.models.encoders.embedding import plain

RECENT = 16  # texts of which the cosines are kept
MANY = 1000  # wordings; to count fewer takes as long as to look for them in the cache

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


@dataclass(frozen=True, slots=True)
class _Counts:
    """Which terms stand in which wordings, term by term in alphabetical order.

    Attributes:
        starts: (T + 1,) where in `terms` each begins, and behind the last.
        rarity: (T,) the weight of each.
        ends: (T,) where in `rows` and `times` those of each end.
        rows: (P,) the wordings that have it.
        times: (P,) how often each has it.
        lengths: (N,) of the wordings, as rows of weights.
    """

    terms: bytes
    starts: NDArray[np.int64]
    rarity: NDArray[np.float64]
    ends: NDArray[np.int64]
    rows: NDArray[np.int32]
    times: NDArray[np.int32]
    lengths: NDArray[np.float64]

    def number(self, term: str) -> int | None:
        """The number of a term; None if no wording has it."""
        wanted, count = term.encode(), len(self.rarity)
        found = bisect_left(range(count), wanted, key=self._term)
        return found if found < count and self._term(found) == wanted else None

    def _term(self, number: int) -> bytes:
        return self.terms[self.starts[number] : self.starts[number + 1] - 1]

    def shares(self, number: int) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
        """The wordings that have a term, and its share of each."""
        own = slice(self.ends[number - 1] if number else 0, self.ends[number])
        rows = self.rows[own]
        return rows, self.times[own].astype(float) * self.rarity[number] / self.lengths[rows]


class WordingIndex:
    """Wordings, each owned by a snippet; searched by the words they share with a text."""

    def __init__(self, wordings: tuple[str, ...], owners: tuple[int, ...]) -> None:
        self._wordings = wordings
        self._owners = np.array(owners)
        self._counts = _counted(wordings) if len(wordings) < MANY else _kept(wordings)
        # A sentence is asked for again and again while it is settled.
        self.search = lru_cache(maxsize=RECENT)(self._search)

    def _search(self, text: str) -> tuple[NDArray[np.float64], tuple[str, ...]]:
        """(N,) cosine of a text to the nearest wording of each snippet, not to be changed, and that wording."""
        counts = self._counts
        found = ((counts.number(term), times) for term, times in _terms(text).items())
        weights = {number: times * float(counts.rarity[number]) for number, times in found if number is not None}
        length = float(np.sqrt(sum(w * w for w in weights.values()))) or 1.0
        scores = np.zeros(len(self._wordings))
        for number, weight in weights.items():
            rows, shares = counts.shares(number)
            scores[rows] += shares * (weight / length)
        best, rows = best_of_each(scores, self._owners)
        best.flags.writeable = False
        return best, tuple(self._wordings[row] for row in rows)


def _counted(wordings: tuple[str, ...]) -> _Counts:
    numbers: dict[str, int] = {}
    each, times, sizes = list[int](), list[int](), list[int]()
    for text in wordings:
        terms = _terms(text)
        each.extend(numbers.setdefault(term, len(numbers)) for term in terms)
        times.extend(terms.values())
        sizes.append(len(terms))
    ordered = sorted(numbers)
    place = np.empty(len(numbers), np.intp)
    place[[numbers[term] for term in ordered]] = np.arange(len(numbers))
    term, row = place[np.array(each, np.intp)], np.repeat(np.arange(len(wordings)), sizes)
    seen = np.bincount(term, minlength=len(numbers))
    rarity = np.log((1.0 + len(wordings)) / (1.0 + seen)) + 1.0
    weight = np.array(times, float) * rarity[term]
    by_term = np.argsort(term, kind="stable")
    return _Counts(
        terms="".join(f"{one}\n" for one in ordered).encode(),
        starts=np.cumsum([0, *(len(one) + 1 for one in ordered)]),
        rarity=rarity,
        ends=np.cumsum(seen),
        rows=row[by_term].astype(np.int32),
        times=np.array(times, np.int32)[by_term],
        lengths=np.sqrt(np.bincount(row, weight**2, minlength=len(wordings))),
    )


def _kept(wordings: tuple[str, ...]) -> _Counts:
    """The counts of many wordings, from the user's cache folder if they are there, and put there if not.

    The file is named by a hash of the wordings and of the code that counts. One that is missing, damaged or cannot be
    written costs time and nothing else.
    """
    path = cache_folder("words") / f"{_digest(wordings)}.npz"
    if (content := kept(path)) is not None:
        with np.load(BytesIO(content), allow_pickle=False) as arrays:
            return _Counts(**{**arrays, "terms": arrays["terms"].tobytes()})
    counts = _counted(wordings)
    stream = BytesIO()
    arrays: dict[str, Any] = {field.name: getattr(counts, field.name) for field in fields(counts)}
    arrays["terms"] = np.frombuffer(counts.terms, np.uint8)
    np.savez(stream, **arrays)
    keep(path, sealed(stream.getvalue()), lasting=False)
    return counts


def _digest(wordings: tuple[str, ...]) -> str:
    digest = hashlib.blake2b(digest_size=16)
    for module in (__file__, embedding.__file__):  # which say what a term is
        digest.update(Path(module).read_bytes())
    digest.update("\0".join(wordings).encode())
    return digest.hexdigest()


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
