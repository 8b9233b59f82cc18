"""Cross-entropy method: a Gaussian per parameter that follows the best scenes so far.

Source: Rubinstein, "The Cross-Entropy Method for Combinatorial and Continuous Optimization", 1999, with the smoothing
of de Boer et al., "A Tutorial on the Cross-Entropy Method", 2005.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from chatscene.search.sampler import Proposal
from chatscene.search.samplers.uniform import Uniform
from chatscene.search.samplers.unit_cube import Array, UnitCube, dangers
from chatscene.terms.outcome import Outcome
from chatscene.terms.snippet import ParameterRange

PLUGIN = {
    "name": "cross-entropy",
    "makes": "CrossEntropy",
    "what": "a Gaussian per parameter, fitted to the best fifth",
}

ELITE = 0.2  # share of all outcomes that the Gaussian is fitted to
LEAST = 2  # outcomes in it
SMOOTHING = 0.7  # weight of the newest fit
FLOOR = 0.05  # of the deviation, as a share of the range
UNIFORM = 1 / math.sqrt(12)  # deviation of the uniform distribution that the first block is drawn from


class CrossEntropy:
    """Gaussians around the best; see `chatscene.search.sampler.Sampler` for the contract."""

    def propose(
        self, declared: Sequence[ParameterRange], done: Sequence[Sequence[Outcome]], *, count: int, seed: int
    ) -> Proposal:
        """Uniform first, then Gaussians cut to the declared ranges."""
        if sum(map(len, done)) < LEAST:
            return Uniform().propose(declared, done, count=count, seed=seed)
        cube = UnitCube(tuple(declared))
        mean, deviation = fit(cube, done)
        rng = np.random.default_rng(seed)
        return Proposal(ranges=cube.declared, draw=lambda _: cube.values(_truncated(rng, mean, deviation)))


def fit(cube: UnitCube, done: Sequence[Sequence[Outcome]]) -> tuple[Array, Array]:
    """Mean and deviation after these blocks, each of shape (dimensions,), as shares of the ranges."""
    mean, deviation = np.full(len(cube.free), 0.5), np.full(len(cube.free), UNIFORM)
    seen: list[Outcome] = []
    for block in done:
        seen += block
        if not block or len(seen) < LEAST:
            continue
        # A stable sort: of equals, the earlier one counts as the better, whatever the platform.
        best = np.argsort(-dangers(seen), kind="stable")[: max(LEAST, round(ELITE * len(seen)))]
        elite = cube.points([seen[index] for index in best])
        mean = SMOOTHING * elite.mean(axis=0) + (1 - SMOOTHING) * mean
        deviation = SMOOTHING * elite.std(axis=0) + (1 - SMOOTHING) * deviation
    return mean, np.maximum(deviation, FLOOR)


def _truncated(rng: np.random.Generator, mean: Array, deviation: Array) -> Array:
    """A normal point within the unit cube; what falls outside is drawn again, dimension by dimension."""
    point = rng.normal(mean, deviation)
    while (outside := (point < 0.0) | (point > 1.0)).any():
        point[outside] = rng.normal(mean[outside], deviation[outside])
    return point
