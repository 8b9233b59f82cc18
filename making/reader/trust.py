"""How sure the learned reader may be, of readings and parts of them: fitted on texts that it did not learn from."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import minimize

from chatscene.read.learned.reader import LearnedReader
from chatscene.read.learned.weights import AS_IT_IS, load, save_trust
from chatscene.situations.main_facts import same_in_the_main, within_the_main
from making.reader.texts import told_in

_RIDGE = 1e-2
_LEAST = 1e-6  # of a probability


def calibrate(weights: Path, texts: Sequence[Path]) -> tuple[int, int]:
    """Fit how sure the reader is on situations with texts, and write it beside its weights.

    A part of a reading is right if it has no main fact that the situation has not.

    Returns:
        How many texts there were, and of how many the main facts were read rightly.
    """
    save_trust(replace(load(weights), trust=AS_IT_IS, trust_in_parts=AS_IT_IS), weights)
    load.cache_clear()
    sure, in_parts = list[tuple[float, bool]](), list[tuple[float, bool]]()
    reader = LearnedReader(weights)
    for path in texts:
        for text, _, said in told_in(path):
            read = reader.read(text)
            if read.ranked:
                right = said is not None and same_in_the_main(said, read.ranked[0].situation)
                sure.append((read.ranked[0].probability, right))
            for part in read.parts:
                right = said is not None and within_the_main(part.situation, said)
                in_parts.append((part.probability, right))
    save_trust(replace(load(weights), trust=trust_of(sure), trust_in_parts=trust_of(in_parts)), weights)
    load.cache_clear()
    return len(sure), sum(right for _, right in sure)


def trust_of(sure: Sequence[tuple[float, bool]]) -> tuple[float, float]:
    """Factor and offset of the log-odds by which probabilities are as often right as they say (Platt scaling).

    Args:
        sure: Probabilities, and whether what they were of was right.
    """
    x = np.array([math.log(p / (1 - p)) for p in (min(max(one, _LEAST), 1 - _LEAST) for one, _ in sure)])
    y = np.array([float(right) for _, right in sure])

    def unlikely(w: NDArray[np.float64]) -> float:
        z = w[0] * x + w[1]
        pull = _RIDGE * ((w[0] - 1.0) ** 2 + w[1] ** 2)  # toward the probabilities as they are
        return float((np.logaddexp(0, z) - y * z).sum() + pull)

    scale, offset = minimize(unlikely, np.array([1.0, 0.0]), method="BFGS").x
    return float(scale), float(offset)
