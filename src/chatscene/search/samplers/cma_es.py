"""CMA-ES: an evolution strategy that learns how the parameters go together.

Source: Hansen, "The CMA Evolution Strategy: A Tutorial", 2016; the implementation is the package ``cmaes``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from cmaes import CMA

from chatscene.search.sampler import Proposal
from chatscene.search.samplers.unit_cube import Array, UnitCube, dangers
from chatscene.terms.outcome import Outcome
from chatscene.terms.snippet import ParameterRange

PLUGIN = {
    "name": "cma-es",
    "makes": "CmaEs",
    "needs": "search",
    "what": "covariance matrix adaptation with restarts",
}

STEP = 0.3  # first deviation, as a share of the range (the tutorial's advice)
SMALLEST = 4  # population below which no ranking tells a direction
FEWEST = 2  # dimensions that the package can do with


class CmaEs:
    """A generation per block; see `chatscene.search.sampler.Sampler` for the contract."""

    def propose(
        self, declared: Sequence[ParameterRange], done: Sequence[Sequence[Outcome]], *, count: int, seed: int
    ) -> Proposal:
        """The generation after those that were driven."""
        cube = UnitCube(tuple(declared))
        # The last block of a search may be shorter than the others; they say how large a generation is.
        population = max(SMALLEST, count, *(len(block) for block in done), 0)
        strategy = evolve(cube, done, population)
        strategy.reseed_rng(seed)  # after the replay, which has no need of chance
        return Proposal(ranges=cube.declared, draw=lambda _: cube.values(strategy.ask()[: len(cube.free)]))


def evolve(cube: UnitCube, done: Sequence[Sequence[Outcome]], population: int) -> Any:
    """The strategy after these blocks; it starts anew, elsewhere, where it says that it has converged."""
    dimensions = max(FEWEST, len(cube.free))
    strategy = _start(np.full(dimensions, 0.5), population)
    for number, block in enumerate(done):
        if not block:
            continue  # nothing is known of it
        # A search in fewer dimensions than the package can do with has idle ones, which must not look converged.
        chance = np.random.default_rng(number)
        idle = chance.random((len(block), dimensions - len(cube.free)))
        told = list(zip(np.hstack([cube.points(block), idle]), -dangers(block), strict=True))
        # What is missing could not be placed: the package wants a full generation, and the worst of it pulls least.
        worst = max(told, key=lambda point_and_cost: point_and_cost[1])
        strategy.tell(told + [worst] * (population - len(told)))
        if strategy.should_stop():
            strategy = _start(chance.random(dimensions), population)
    return strategy


def _start(mean: Array, population: int) -> Any:
    bounds = np.tile([0.0, 1.0], (len(mean), 1))
    return CMA(mean=mean, sigma=STEP, bounds=bounds, population_size=population, seed=0)
