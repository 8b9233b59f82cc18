"""Three snippets chosen together: of the triples that can be joined, the one whose scores have the greatest sum."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import NothingFits
from chatscene.library.compatibility import Compatibility
from chatscene.situations.phrases import one_seen
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.snippet import Snippet, Tried

Scores = NDArray[np.float64]


def none_left(kind: AdversaryKind | None, tried: Sequence[Tried]) -> NothingFits:
    """The error where no triple is left that has such an adversary, or any."""
    who = "an adversary" if kind is None else f"{one_seen(kind.row.scenic)} as adversary"
    return NothingFits(f"nothing {'else ' if tried else ''}in the library has {who}")


def highest(
    joint: Compatibility,
    scores: Sequence[Scores],
    allowed: Sequence[NDArray[np.bool_]],
    tried: Sequence[Tried] = (),
) -> tuple[int, int, int] | None:
    """The triple of allowed parts with the highest sum of scores that can be joined; None if there is none.

    Behaviors are looked at from the best down, until the best partners of all could not lift the next one any more. Of
    the parts of a sort, the best stands for all; those that were tried stand for themselves.

    Args:
        joint: What can be joined with what.
        scores: (B,), (G,) and (S,).
        allowed: The same shapes.
        tried: Triples with all of some snippets, which are not taken.
    """
    axes = (joint.behaviors, joint.geometries, joint.spawns)
    gone = {name for one in tried for name in one.snippet_ids}
    standing = [_standing(*each, gone) for each in zip(axes, joint.sorts, scores, allowed, strict=True)]
    (behaviors, geometries, spawns), (of_b, of_g, of_s) = standing, joint.sorts
    places = scores[1][geometries][:, None] + scores[2][spawns]
    ceiling = float(places.max(initial=-np.inf))
    best, found = -np.inf, None
    for b in behaviors[np.argsort(-scores[0][behaviors], kind="stable")].tolist():
        if scores[0][b] + ceiling <= best:
            break
        fits = joint.partners(int(of_b[b]))[np.ix_(of_g[geometries], of_s[spawns])]
        for one in tried:
            have = [np.array([axis[i].id in one.snippet_ids for i in at], np.intp)
                    for axis, at in zip(axes, ([b], geometries, spawns), strict=True)]  # fmt: skip
            fits &= have[0] + have[1][:, None] + have[2] < len(one.snippet_ids)
        joined = np.where(fits, places, -np.inf)
        if scores[0][b] + joined.max(initial=-np.inf) > best:
            g, s = divmod(int(np.argmax(joined)), len(spawns))
            best, found = float(scores[0][b] + joined[g, s]), (b, int(geometries[g]), int(spawns[s]))
    return found


def _standing(
    snippets: Sequence[Snippet], sorts: NDArray[np.intp], scores: Scores, allowed: NDArray[np.bool_], gone: set[str]
) -> NDArray[np.intp]:
    """The best allowed snippet of each sort, of equal ones the first, and every one that has gone; in order."""
    order = np.argsort(-scores, kind="stable")
    order = order[allowed[order]]
    alone = np.array([snippets[i].id in gone for i in order], bool)
    _, first = np.unique(np.where(alone, len(snippets) + order, sorts[order]), return_index=True)
    return np.sort(order[first])
