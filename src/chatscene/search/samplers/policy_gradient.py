"""Learning-to-Collide: an autoregressive Gaussian policy, trained by REINFORCE on how dangerous its scenes were.

Source: Ding, Chen, Xu and Zhao, "Learning to Collide: An Adaptive Safety-Critical Scenarios Generating Method", IROS
2020. Theirs is a network over the route; here each route is searched on its own, so that nothing is seen but the
parameters before, and 25 updates are all there are, so that each mean is affine in them. The learning rate is ours,
for the same reason.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from chatscene.search.sampler import Proposal
from chatscene.search.samplers.unit_cube import Array, UnitCube, dangers
from chatscene.terms.outcome import Outcome
from chatscene.terms.snippet import ParameterRange

PLUGIN = {
    "name": "policy-gradient",
    "makes": "PolicyGradient",
    "what": "an autoregressive Gaussian policy, REINFORCE",
}

RATE = 0.1  # Adam's
DECAY = (0.9, 0.999)  # Adam's, of the first and the second moment
TINY = 1e-8
ENTROPY = 1e-4  # weight of the bonus for staying curious (SafeBench)
START = -0.5  # log of the deviation before anything was learned: 0.6 of a range that is 2 wide
LEAST = -3.0  # log of the least deviation: 2.5 % of the range; below, a step of the gradient has no bound


@dataclass(frozen=True, slots=True)
class Policy:
    """A density over points in [-1, 1]^n: each dimension is Gaussian given those before it.

    Attributes:
        offset: Mean where the dimensions before are 0, shape (n,).
        slope: How the mean of a row follows the dimension of a column, shape (n, n), strictly lower triangular.
        log_deviation: Natural logarithm of the deviations, shape (n,).
    """

    offset: Array
    slope: Array
    log_deviation: Array

    def sample(self, rng: np.random.Generator) -> Array:
        """A point, shape (n,), dimension by dimension; each is clipped to [-1, 1] before the next follows from it."""
        point = np.zeros(len(self.offset))
        noise = rng.normal(size=len(self.offset)) * np.exp(self.log_deviation)
        for i in range(len(point)):
            point[i] = np.clip(self.offset[i] + self.slope[i] @ point + noise[i], -1.0, 1.0)
        return point

    def log_likelihood(self, points: Array) -> Array:
        """Of each row, up to a constant, shape (points,)."""
        return np.sum(-0.5 * self._standardised(points) ** 2 - self.log_deviation, axis=1)

    def score(self, points: Array) -> Array:
        """Gradient of the log likelihood of each row by the policy's numbers, shape (points, n + n * n + n)."""
        z = self._standardised(points)
        by_mean = z / np.exp(self.log_deviation)
        by_slope = np.tril(by_mean[:, :, None] * points[:, None, :], k=-1)
        return np.concatenate([by_mean, by_slope.reshape(len(points), points.shape[1] ** 2), z**2 - 1.0], axis=1)

    def _standardised(self, points: Array) -> Array:
        return (points - self.offset - points @ self.slope.T) / np.exp(self.log_deviation)


def policy(numbers: Array, dimensions: int) -> Policy:
    """The policy with these numbers: offset, slope and log deviation in a row, as `Policy.score` has them."""
    n = dimensions
    return Policy(numbers[:n], numbers[n : n + n * n].reshape(n, n), numbers[n + n * n :])


class PolicyGradient:
    """Learning-to-Collide; see `chatscene.search.sampler.Sampler` for the contract."""

    def propose(
        self,
        declared: Sequence[ParameterRange],
        done: Sequence[Sequence[Outcome]],
        *,
        count: int,
        seed: int,
    ) -> Proposal:
        """Draws of the policy after an update per block."""
        cube = UnitCube(tuple(declared))
        learned = learn(cube, done)
        rng = np.random.default_rng(seed)
        return Proposal(ranges=cube.declared, draw=lambda _: cube.values((learned.sample(rng) + 1.0) / 2.0))


def learn(cube: UnitCube, done: Sequence[Sequence[Outcome]]) -> Policy:
    """The policy after these blocks: an ascent by Adam, from the middle of the ranges."""
    n = len(cube.free)
    numbers = np.concatenate([np.zeros(n + n * n), np.full(n, START)])
    # The entropy of a Gaussian is its log deviation and a constant.
    curious = np.concatenate([np.zeros(n + n * n), np.full(n, ENTROPY)])
    floor = np.concatenate([np.full(n + n * n, -np.inf), np.full(n, LEAST)])
    first, second = np.zeros_like(numbers), np.zeros_like(numbers)
    for step, block in enumerate((block for block in done if block), start=1):
        reward = dangers(block)
        scores = policy(numbers, n).score(2.0 * cube.points(block) - 1.0)
        ascent = (reward - reward.mean()) @ scores / len(block) + curious
        first = DECAY[0] * first + (1 - DECAY[0]) * ascent
        second = DECAY[1] * second + (1 - DECAY[1]) * ascent**2
        mean, square = first / (1 - DECAY[0] ** step), second / (1 - DECAY[1] ** step)
        numbers = np.maximum(numbers + RATE * mean / (np.sqrt(square) + TINY), floor)
    return policy(numbers, n)
