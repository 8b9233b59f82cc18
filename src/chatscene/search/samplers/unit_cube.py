"""Parameters of any unit and width as points in [0, 1]^n, for samplers that reckon in distances or walk a sequence."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice, takewhile

import numpy as np
from numpy.typing import NDArray

from chatscene.program.sample import DECIMALS
from chatscene.terms.outcome import Outcome
from chatscene.terms.snippet import ParameterRange

Array = NDArray[np.float64]
FARTHEST = 100  # points tried per scene that was driven, as the default of `SearchSettings.tries`


@dataclass(frozen=True, slots=True)
class UnitCube:
    """The declared ranges as a unit cube; a parameter without width is no dimension of it.

    Attributes:
        declared: The parameters, in the order of the values.
    """

    declared: tuple[ParameterRange, ...]

    @property
    def free(self) -> tuple[ParameterRange, ...]:
        """The parameters that can vary: the cube's dimensions."""
        return tuple(p for p in self.declared if p.high > p.low)

    def values(self, point: Array | Sequence[float]) -> dict[str, float]:
        """The values at a point, in the parameters' units, rounded and within their ranges.

        Args:
            point: Shape (dimensions,); what lies outside the cube is moved to its nearest face.
        """
        shares = {p.name: float(share) for p, share in zip(self.free, point, strict=True)}
        return {
            p.name: p.clip(round(p.low + shares.get(p.name, 0.0) * (p.high - p.low), DECIMALS)) for p in self.declared
        }

    def point(self, values: Mapping[str, float]) -> Array:
        """The point with these values, shape (dimensions,)."""
        return np.array([(p.clip(values[p.name]) - p.low) / (p.high - p.low) for p in self.free], dtype=np.float64)

    def points(self, outcomes: Sequence[Outcome]) -> Array:
        """A row per outcome, shape (outcomes, dimensions)."""
        return np.array([self.point(outcome.values) for outcome in outcomes]).reshape(len(outcomes), len(self.free))


def dangers(outcomes: Sequence[Outcome]) -> Array:
    """What is maximised, shape (outcomes,)."""
    return np.array([outcome.danger for outcome in outcomes], dtype=np.float64)


def walk_on(
    cube: UnitCube,
    done: Sequence[Sequence[Outcome]],
    count: int,
    points: Callable[[int], Iterator[Array] | Iterator[Sequence[float]]],
) -> Iterator[dict[str, float]]:
    """The values of the points of a sequence behind those that were tried, for a sampler that draws nothing at random.

    Points that could not be placed are tried, too, and no outcome tells of them. So the sequence is walked again from
    its start, to the point that was driven last.

    Args:
        cube: The parameters.
        done: What came of each block before.
        count: How many scenes a block has.
        points: All points of a cube of so many dimensions, from the first one on, without end.
    """
    walk = map(cube.values, points(len(cube.free)))
    driven = sum(map(len, done))
    # Blocks since then in which nothing could be placed have left no trace, but have tried `count` points or more.
    traceless = sum(1 for _ in takewhile(lambda block: not block, reversed(done)))
    if driven:
        last = next(block for block in reversed(done) if block)[-1].values
        tried = islice(map(cube.values, points(len(cube.free))), FARTHEST * max(map(len, done)) * len(done))
        driven = next((number for number, values in enumerate(tried, start=1) if values == last), driven)
    return islice(walk, driven + traceless * count, None)
