"""Parameters of any unit and width as points in [0, 1]^n, for samplers that reckon in distances."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from chatscene.program.sample import DECIMALS
from chatscene.terms.outcome import Outcome
from chatscene.terms.snippet import ParameterRange

Array = NDArray[np.float64]


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
