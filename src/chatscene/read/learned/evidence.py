"""The words of a text behind each fact that was read in it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache

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
    A number says no fact but a number, and what names another word of the same field, as "rain" of ``weather: fog``,
    does not say this one.
    """
    copied = {path_of(written.steps, at): found for at, found in written.found}
    quoted: dict[str, str] = {}
    for at, marks in enumerate(written.marks):
        if not written.steps[at].place or at == 0:
            continue
        path = path_of(written.steps, at)
        words = _words(read, [float(one) for one in marks], _says_another(written.steps[at].token), copied.get(path))
        if words:
            quoted.setdefault(path, words)
    return quoted


def _says_another(token: Token | None) -> Callable[[str], bool]:
    """Whether a word says another fact than a token, whatever is marked."""
    if token is None:
        return lambda _: False
    field, value = token
    others = _words_of(field) - {value}
    return lambda word: word in others or (not value.isdigit() and any(c.isdigit() for c in word))


@cache
def _words_of(field: str) -> frozenset[str]:
    return frozenset(word for each, word in grammar().tokens if each == field)


def _words(read: Read, marks: Sequence[float], others: Callable[[str], bool], copied: Found | None) -> str:
    """The marked words of a text as they stand, what lies between them left out; empty if all say something else."""
    best: dict[tuple[int, int], float] = {}
    for where, mark in zip(read.where, marks[1:], strict=False):  # before the first piece stands the mark of begin
        if not others(read.text[where[0] : where[1]].strip(_ENDS).lower()):
            best[where] = max(mark, best.get(where, mark))
    taken = sorted(where for where, mark in best.items() if mark > 0)
    if copied is not None:
        apart = (where for where in taken if where[1] <= copied.low or where[0] >= copied.high)
        taken = sorted((*apart, (copied.low, copied.high)))
    elif best and not taken:
        taken = [max(best, key=lambda one: best[one])]
    return GAP.join(filter(None, (read.text[low:high].strip(_ENDS) for low, high in _runs(read.text, taken))))


def _runs(text: str, taken: Sequence[tuple[int, int]]) -> Iterator[tuple[int, int]]:
    begin, end = taken[0]
    for low, high in taken[1:]:
        if text[end:low].strip():
            yield begin, end
            begin = low
        end = high
    yield begin, end
