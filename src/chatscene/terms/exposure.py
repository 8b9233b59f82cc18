"""How often the values of a scenario's parameters occur on the road."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Shape(StrEnum):
    """The shape of a density; each is cut off at the ends of the parameter's declared range."""

    UNIFORM = "uniform"
    NORMAL = "normal"
    LOGNORMAL = "lognormal"


@dataclass(frozen=True, slots=True, kw_only=True)
class Density:
    """How often the values of one parameter occur.

    Attributes:
        parameter: Its name, such as ``OPT_ADV_SPEED``.
        middle: The mean of a normal one, the median of a lognormal one, in the parameter's unit; 0 of a uniform one.
        spread: The standard deviation of a normal one, in the parameter's unit, and that of the logarithm of a
            lognormal one; 0 of a uniform one.
        source: Who measured it, and where; empty only of a uniform one that nobody asked for.
    """

    parameter: str
    shape: Shape = Shape.UNIFORM
    middle: float = 0.0
    spread: float = 0.0
    source: str = ""
