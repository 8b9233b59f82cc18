"""Step 6 of 9: move the ranges to where collisions were.

Paper: section 3.3, step iv. Released code: ``scenic_utils.py``.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import replace

from chatscene.terms.snippet import ParameterRange

LEAST = 2  # collisions before anything moves
DECIMALS = 2  # the released code rounds bounds


def refine(declared: Sequence[ParameterRange], collided: Sequence[Mapping[str, float]]) -> tuple[ParameterRange, ...]:
    """The ranges for the next block: mean ± population deviation of what collided, inside the declared ranges.

    Parameters move independently of each other. All blocks so far count, not only the last.
    Deviation from the released code: bounds are clipped after they are rounded (decision 0004).

    Args:
        declared: The ranges of the program.
        collided: The values of every scene so far in which the ego collided.

    Returns:
        A range per parameter; the declared ones while fewer than two scenes have collided.
    """
    if len(collided) < LEAST:
        return tuple(declared)
    return tuple(_moved(p, [values[p.name] for values in collided]) for p in declared)


def _moved(declared: ParameterRange, values: Sequence[float]) -> ParameterRange:
    mean = math.fsum(values) / len(values)
    deviation = math.sqrt(math.fsum((value - mean) ** 2 for value in values) / len(values))
    return replace(
        declared,
        low=declared.clip(round(mean - deviation, DECIMALS)),
        high=declared.clip(round(mean + deviation, DECIMALS)),
    )
