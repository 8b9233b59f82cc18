"""How sure the learned reader may be, of readings and parts of them: fitted on texts that it did not learn from."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from chatscene.read.learned.reader import Heard, hear, parts_read
from chatscene.read.learned.trust import OF_A_READING, OF_NONE, OFFSET
from chatscene.read.learned.weights import load, save_trust
from chatscene.situations.main_facts import same_in_the_main, within_the_main
from chatscene.terms.reading import Verdict
from chatscene.terms.situation import Situation
from making.reader.texts import told_in

_RIDGE = 1e-2
_RIDGE_OF_SIGNS = 3.0  # of each sign over its spread
_LEAST = 1e-6  # of a probability
_MOST = 300  # texts as which a file counts at most


@dataclass(frozen=True, slots=True)
class Judged:
    """The readings of a text, and which of them is right.

    Attributes:
        readings: The signs of each.
        none: The signs that none is right.
        right: The number of the right one; that of all where none is.
        weight: As how many texts it counts.
        hard: Whether it is of texts in which more is wrong than of those that it is to be sure of.
    """

    readings: Sequence[Sequence[float]]
    none: Sequence[float]
    right: int
    weight: float = 1.0
    hard: bool = False


def calibrate(weights: Path, texts: Sequence[Path], harder: Sequence[Path] = ()) -> tuple[int, int]:
    """Fit how sure the reader is on situations with texts, and write it beside its weights.

    A part of a reading is right if it has no main fact that the situation has not. Of texts that are harder for it only
    what tells right from wrong is learned: an offset of their own takes up how much more is wrong.

    Returns:
        How many texts there were, and of how many the main facts were read rightly.
    """
    heard: list[tuple[Heard, Judged, Situation | None]] = []
    for path in (*texts, *harder):
        rows = [(hear(text, weights), said) for text, _, said in told_in(path)]
        weight = min(1.0, _MOST / len(rows))
        for one, said in rows:
            if one.verdict is Verdict.SITUATION and one.found:
                right = (i for i, each in enumerate(one.found) if said and same_in_the_main(said, each.situation))
                judged = Judged(*one.signs, next(right, len(one.found)), weight, path in harder)
                heard.append((one, judged, said))
    trust = signs_weighed([judged for _, judged, _ in heard])
    in_parts = [
        (part.probability, said is not None and within_the_main(part.situation, said), judged.weight)
        for one, judged, said in heard
        for part in parts_read(one.ranked(trust))
    ]
    save_trust(replace(load(weights), trust=trust, trust_in_parts=trust_of(in_parts)), weights)
    load.cache_clear()
    return len(heard), sum(judged.right == 0 for _, judged, _ in heard)


def signs_weighed(texts: Sequence[Judged]) -> dict[str, float]:
    """The weights of signs by which readings are as often right as they say (a conditional logit with a ridge)."""
    x = np.concatenate([np.array(one.readings) for one in texts])
    z = np.array([[*one.none, 1.0, float(one.hard)] for one in texts])
    many = np.array([len(one.readings) for one in texts])
    begins = np.concatenate([[0], np.cumsum(many)[:-1]])
    whose, weight = np.repeat(np.arange(len(texts)), many), np.array([one.weight for one in texts])
    right = np.array([one.right for one in texts])
    none = right == many
    chosen = (begins + right)[~none]
    spread, middle = x.std(axis=0) + _LEAST, z[:, :-2].mean(axis=0)
    spread_of_none = z[:, :-2].std(axis=0) + _LEAST
    x = x / spread
    z = np.concatenate([(z[:, :-2] - middle) / spread_of_none, z[:, -2:]], axis=1)
    ridge = np.full(x.shape[1] + z.shape[1], _RIDGE_OF_SIGNS)
    ridge[[0, -2]] = 0.0  # the probability itself, and the offset

    def unlikely(w: NDArray[np.float64]) -> tuple[float, NDArray[np.float64]]:
        each, of_none = x @ w[: x.shape[1]], z @ w[x.shape[1] :]
        most = np.maximum(np.maximum.reduceat(each, begins), of_none)
        shares, left = np.exp(each - most[whose]), np.exp(of_none - most)
        total = np.add.reduceat(shares, begins) + left
        told = np.where(none, of_none, each[np.minimum(begins + right, len(each) - 1)])
        by_each = -weight[whose] * shares / total[whose]
        by_each[chosen] += weight[~none]
        by_none = weight * (none - left / total)
        cost = -(weight * (told - most - np.log(total))).sum() + 0.5 * (ridge * w * w).sum()
        return float(cost), ridge * w - np.concatenate([by_each @ x, by_none @ z])

    w = minimize(unlikely, np.zeros(len(ridge)), jac=True, method="L-BFGS-B").x
    of_readings, of_none = w[: x.shape[1]] / spread, w[x.shape[1] : -2] / spread_of_none
    fitted = dict(zip((*OF_A_READING, *OF_NONE), map(float, (*of_readings, *of_none)), strict=True))
    return {**fitted, OFFSET: float(w[-2] - of_none @ middle)}


def trust_of(sure: Sequence[tuple[float, bool, float]]) -> tuple[float, float]:
    """Factor and offset of the log-odds by which probabilities are as often right as they say (Platt scaling).

    Args:
        sure: Probabilities, whether what they were of was right, and as how many it counts.
    """
    x = np.array([math.log(p / (1 - p)) for p in (min(max(one, _LEAST), 1 - _LEAST) for one, *_ in sure)])
    y = np.array([float(right) for _, right, _ in sure])
    weight = np.array([many for *_, many in sure])

    def unlikely(w: NDArray[np.float64]) -> float:
        z = w[0] * x + w[1]
        pull = _RIDGE * ((w[0] - 1.0) ** 2 + w[1] ** 2)  # toward the probabilities as they are
        return float((weight * (np.logaddexp(0, z) - y * z)).sum() + pull)

    scale, offset = minimize(unlikely, np.array([1.0, 0.0]), method="BFGS").x
    return float(scale), float(offset)
