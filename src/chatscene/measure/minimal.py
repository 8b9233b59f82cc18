"""The causes that a failure needs, by trying: delta debugging.

Source: A. Zeller, R. Hildebrandt, "Simplifying and isolating failure-inducing input", IEEE Transactions on Software
Engineering 28 (2002), algorithm ddmin.
"""

from __future__ import annotations

import itertools
from collections.abc import Callable, Hashable, Sequence
from typing import TypeVar

C = TypeVar("C", bound=Hashable)


def minimal(causes: Sequence[C], fails: Callable[[frozenset[C]], bool]) -> tuple[C, ...]:
    """A smallest-by-one set of causes that still fails: without any single one of them it does not.

    It need not be the only such set, nor one of the fewest causes. Where it fails without any cause, it is empty.

    Args:
        causes: All of them, in the order in which they are tried; together they fail.
        fails: Whether these causes alone fail. No set is asked about twice.

    Returns:
        The set, in the order of `causes`.
    """
    known: dict[frozenset[C], bool] = {}

    def asked(kept: Sequence[C]) -> bool:
        key = frozenset(kept)
        if key not in known:
            known[key] = fails(key)
        return known[key]

    left, parts = list(causes), 2
    if not left or asked(()):
        return ()
    while len(left) > 1:
        cuts = [len(left) * part // parts for part in range(parts + 1)]
        chunks = [left[low:high] for low, high in itertools.pairwise(cuts)]
        rests = [[cause for cause in left if cause not in chunk] for chunk in chunks]
        if alone := next((chunk for chunk in chunks if asked(chunk)), None):
            left, parts = alone, 2
        elif rest := next((rest for rest in rests if asked(rest)), None):
            left, parts = rest, max(parts - 1, 2)
        elif parts < len(left):
            parts = min(2 * parts, len(left))
        else:
            break
    return tuple(left)
