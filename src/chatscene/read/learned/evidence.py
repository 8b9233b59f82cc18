"""The words of a text behind each fact that was read in it."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from functools import cache, lru_cache
from itertools import count

import numpy as np

from chatscene.read.kinds import names_another
from chatscene.read.learned.decoder import Written
from chatscene.read.learned.grammar import Token
from chatscene.read.learned.numbers import Found
from chatscene.read.learned.sequence import path_of
from chatscene.read.learned.text import Read
from chatscene.read.learned.weights import load
from chatscene.read.learned.words import is_learned, stems_in
from chatscene.read.quotes import says_nothing
from chatscene.situations.facts import GAP, within
from chatscene.terms.vocabulary import UserKind

_NAMED = (".kind", "around.light", "around.weather", "around.surface")
"""Facts whose words are held against what they name (`chatscene.read.quotes.otherwise_named`), new ones as well."""
_KINDS = ("Ego.kind", "Other.kind")
"""The fields of what somebody is."""
_ENDS = " \t\n\r.,;:!?()[]{}\"'\u2018\u2019\u201c\u201d"


def quoted_of(read: Read, written: Written) -> Mapping[str, str]:
    """The words of each fact, by its path; among an amount's are those that it was copied from."""
    copied = {path_of(written.steps, at): found for at, found in written.found}
    marked = marked_in(read, written)
    quoted = {path: _words(read.text, words, copied.get(path)) for path, words in marked.items()}
    return {path: words for path, words in quoted.items() if words}


@lru_cache(maxsize=64)
def marked_in(read: Read, written: Written) -> Mapping[str, tuple[tuple[int, int], ...]]:
    """Where the words of each fact stand, by its path; without those of an amount that it was copied from.

    A word counts if it is more likely than not one of the fact's; of a fact without such a word the likeliest one does.
    A number says no fact but a number, and neither do the units behind it; what names another word of the same field,
    as "rain" of ``weather: fog``, does not say this one, nor does a word that was never learned. A fact that only such
    words are marked for has none. Of several facts a word belongs to the one that it is likeliest of, unless another
    has no word besides.
    """
    copied = {path_of(written.steps, at): found for at, found in written.found}
    figures = [one for one in read.amounts if any(c.isdigit() for c in read.text[one.low : one.high])]
    spans, begins = _spans(read)
    taken_up = _within(spans, copied.values())
    of_amounts = taken_up | _within(spans, figures)
    strangers = _strangers(written, spans)
    new = {i for i, word in enumerate(spans) if not (is_learned(word[2]) or says_nothing(word[2]))}
    marked: dict[str, dict[int, float]] = {}
    names: dict[str, frozenset[str]] = {}
    for at, marks in enumerate(written.marks):
        if not written.steps[at].place or at == 0:
            continue
        path = path_of(written.steps, at)
        if path in marked:
            continue
        likely = np.maximum.reduceat(marks[1 : len(read.where) + 1], begins) if spans else marks[:0]
        token = written.steps[at].token
        other = {i for i, word in enumerate(spans) if _says_another(token, word[2])}
        if token is None or token[0] not in _KINDS:
            other |= {i for i in strangers if i + 1 == len(spans) or likely[i + 1] <= 0}
        other |= of_amounts if token is not None else set()
        other |= set() if path.endswith(_NAMED) else new
        mine = {i: float(likely[i]) for i in range(len(spans)) if i not in other}
        likeliest = max((float(likely[i]) for i in range(len(spans)) if i not in taken_up), default=0.0)
        marked[path] = _marked(mine, likeliest, path in copied)
        names[path] = frozenset(stems_in(token[1].replace("-", " ")) if token is not None else ())
    idle = frozenset(i for i, word in enumerate(spans) if says_nothing(word[2]))
    own = {path: _own(path, marked, idle) for path in marked}
    nobodys = set(range(len(spans))) - of_amounts - {i for words in own.values() for i in words}
    of_names = {i: set(stems_in(spans[i][2])) for i in nobodys if i not in idle}
    own = {path: [*words, *_beside(words, names[path], of_names, idle)] for path, words in own.items()}
    return {path: tuple(spans[i][:2] for i in sorted(words)) for path, words in own.items()}


def _beside(
    words: Sequence[int], names: frozenset[str], of_names: Mapping[int, set[str]], idle: Container[int]
) -> Iterator[int]:
    """The words next to those of a fact that name what it is."""
    for i in {*words}:
        for way in (-1, 1):
            there = next(k for k in count(i + way, way) if k not in idle)
            if of_names.get(there) and of_names[there] <= names:
                yield there


def _strangers(written: Written, spans: Sequence[_Word]) -> tuple[int, ...]:
    """The numbers of the words that name a road user of a kind that nobody in a situation is or may be."""
    told = [step.token for step in written.steps if step.token is not None and step.token[0] in _KINDS]
    kinds = {UserKind(word) for _, word in told}
    if not any(field == _KINDS[0] for field, _ in told):
        kinds.add(UserKind.CAR)  # the ego
    return tuple(i for i, word in enumerate(spans) if names_another(word[2], kinds))


def _within(spans: Sequence[_Word], amounts: Iterable[Found]) -> set[int]:
    """The numbers of the words that lie in amounts."""
    places = [(one.low, one.high) for one in amounts]
    return {i for i, (start, end, _) in enumerate(spans) if any(low <= start and end <= high for low, high in places)}


def _marked(mine: Mapping[int, float], likeliest: float, copied: bool) -> dict[int, float]:
    """The words that say a fact, by their numbers, with their log-odds."""
    words = {i: odds for i, odds in mine.items() if odds > 0}
    if words or copied or likeliest > 0 or not mine:
        return words
    best = max(mine, key=lambda i: mine[i])
    return {best: mine[best]}


def _own(path: str, marked: Mapping[str, Mapping[int, float]], idle: Container[int]) -> list[int]:
    """The words that a fact keeps of those that are marked for it; one that would have none but idle ones keeps all.

    A fact and a part of it share theirs. An idle word, such as an article, goes with the word that it stands before.
    """
    words = marked[path]
    rivals = [other for name, other in marked.items() if not within(name, (path,)) and not within(path, (name,))]
    kept = [i for i, odds in words.items() if all(odds >= other.get(i, odds) for other in rivals)]
    if not any(i not in idle for i in kept):
        return list(words)

    def with_next(i: int) -> bool:
        after = next(k for k in count(i + 1) if k not in idle)
        others = [other for other in rivals if i in other and after in other]
        return not others or after in kept

    return [i for i in words if (with_next(i) if i in idle else i in kept)]


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
    """What a reader could have said in a field: of a word that it never learned another was said."""
    return frozenset(word for each, word in load().tokens if each == field)


def _words(text: str, taken: Sequence[tuple[int, int]], copied: Found | None) -> str:
    """Words of a text as they stand, what lies between them left out, with those of an amount; empty without any."""
    if copied is not None:
        apart = (where for where in taken if where[1] <= copied.low or where[0] >= copied.high)
        taken = sorted((*apart, (copied.low, copied.high)))
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
