"""The words that the reader has learned, and how often each told a fact where it stood.

`making/reader/words.py` counts them in the texts that were learned from. What a word that never stood there is marked
for is a guess.
"""

from __future__ import annotations

import gzip
import re
from collections.abc import Mapping
from functools import cache, lru_cache
from pathlib import Path

NAME = "words.gz"
PACKAGED = Path(__file__).parent / NAME
_PART = re.compile(r"[^\W\d_]+")
_SHORTEST = 3  # letters of a stem
_PRIOR = 2.0  # times that a word counts as seen beforehand, as often telling as words are


def stem_of(word: str) -> str:
    """A word of letters without the common endings of English, so that "brakes" and "braking" are one."""
    word = word.lower()
    if word.endswith("ies") and len(word) > _SHORTEST + 1:
        return word[:-3] + "y"
    for end in ("ing", "ed", "es", "s", "er", "e"):
        stem = word.removesuffix(end)
        if stem != word and len(stem) >= _SHORTEST:
            return stem[:-1] if len(stem) > _SHORTEST and stem[-1] == stem[-2] and stem[-1] not in "sl" else stem
    return word


def stems_in(said: str) -> list[str]:
    """The stems of what stands between white space, as in "right-turning"; none of a number."""
    return [stem_of(part) for part in _PART.findall(said)]


@lru_cache(maxsize=4096)
def is_learned(said: str) -> bool:
    """Whether all parts of a word were in a text that was learned from."""
    return all(stem in _counts() for stem in stems_in(said))


@lru_cache(maxsize=4096)
def tells(said: str) -> float:
    """The share of its occurrences in which a word told a fact, in [0, 1]; that of all words, if it was never seen."""
    counts = [_counts().get(stem, (0, 0)) for stem in stems_in(said)] or [(0, 0)]
    return max((told + _PRIOR * _all_tell()) / (seen + _PRIOR) for seen, told in counts)


@cache
def _all_tell() -> float:
    return sum(told for _, told in _counts().values()) / sum(seen for seen, _ in _counts().values())


@cache
def _counts() -> Mapping[str, tuple[int, int]]:
    """Of each stem how often it was seen where facts have their words beside them, and how often it told one."""
    lines = gzip.decompress(PACKAGED.read_bytes()).decode("utf-8").splitlines()
    rows = (line.split(" ") for line in lines)
    return {stem: (int(seen), int(told)) for stem, seen, told in rows}
