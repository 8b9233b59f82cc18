"""The words of a text behind each fact that was read in it."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cache, lru_cache

import numpy as np

from chatscene.read.learned.decoder import Written
from chatscene.read.learned.grammar import Token, grammar
from chatscene.read.learned.numbers import Found
from chatscene.read.learned.sequence import path_of
from chatscene.read.learned.text import Read
from chatscene.situations.facts import GAP

_ENDS = " \t\n\r.,;:!?()[]{}\"'\u2018\u2019\u201c\u201d"


def quoted_of(read: Read, written: Written) -> Mapping[str, str]:
    """The words of each fact, by its path; among an amount's are those that it was copied from.

    A word counts if it is more likely than not one of the fact's; of a fact without such a word the likeliest one does.
    A number says no fact but a number, and the words of an amount that is copied say no other fact; what names another
    word of the same field, as "rain" of ``weather: fog``, does not say this one.
    """
    copied = {path_of(written.steps, at): found for at, found in written.found}
    amounts = [(found.low, found.high) for found in copied.values()]
    spans, begins = _spans(read)
    quoted: dict[str, str] = {}
    for at, marks in enumerate(written.marks):
        if not written.steps[at].place or at == 0:
            continue
        path = path_of(written.steps, at)
        if path in quoted:
            continue
        likely = np.maximum.reduceat(marks[1 : len(read.where) + 1], begins) if spans else marks[:0]
        token = written.steps[at].token
        mine = [
            i
            for i, word in enumerate(spans)
            if not _says_another(token, word[2])
            and (token is None or not any(low <= word[0] and word[1] <= high for low, high in amounts))
        ]
        words = _words(read.text, [(spans[i], float(likely[i])) for i in mine], copied.get(path))
        if words:
            quoted[path] = words
    return quoted


_Word = tuple[int, int, str]
"""Where a word begins and ends in a text, and the word without what stands around it, in small letters."""


@lru_cache(maxsize=8)
def _spans(read: Read) -> tuple[tuple[_Word, ...], tuple[int, ...]]:
    """The words of a text, and of each the number of its first piece."""
    first = {where: i for i, where in reversed(tuple(enumerate(read.where)))}
    spans = sorted(first, key=lambda where: first[where])
    words = tuple((low, high, read.text[low:high].strip(_ENDS).lower()) for low, high in spans)
    return words, tuple(first[where] for where in spans)


@lru_cache(maxsize=4096)
def _says_another(token: Token | None, word: str) -> bool:
    """Whether a word says another fact than a token, whatever is marked."""
    if token is None:
        return False
    field, value = token
    return (word != value and word in _words_of(field)) or (not value.isdigit() and any(c.isdigit() for c in word))


@cache
def _words_of(field: str) -> frozenset[str]:
    return frozenset(word for each, word in grammar().tokens if each == field)


def _words(text: str, marked: Sequence[tuple[_Word, float]], copied: Found | None) -> str:
    """The marked words of a text as they stand, what lies between them left out; empty if all say something else."""
    taken = [word[:2] for word, mark in marked if mark > 0]
    if copied is not None:
        apart = (where for where in taken if where[1] <= copied.low or where[0] >= copied.high)
        taken = sorted((*apart, (copied.low, copied.high)))
    elif marked and not taken:
        taken = [max(marked, key=lambda one: one[1])[0][:2]]
    return GAP.join(filter(None, (text[low:high].strip(_ENDS) for low, high in _runs(text, taken))))


def _runs(text: str, taken: Sequence[tuple[int, int]]) -> Iterator[tuple[int, int]]:
    if not taken:
        return
    begin, end = taken[0]
    for low, high in taken[1:]:
        if text[end:low].strip():
            yield begin, end
            begin = low
        end = high
    yield begin, end
