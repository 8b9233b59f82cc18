"""Step 6 of 9: move the ranges to where collisions were.

Paper: section 3.3, step v. Released code: ``scenic_utils.py``; decision 0004 says what we keep of it and what not.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from statistics import fmean, pstdev

from chatscene.program.sample import draw
from chatscene.search.sampler import Proposal
from chatscene.terms.outcome import Outcome
from chatscene.terms.snippet import ParameterRange

PLUGIN = {
    "name": "paper",
    "makes": "Paper",
    "what": "ranges move to the values of scenes that collided, mean ± deviation; default of `benchmark`",
}

LEAST = 2  # collisions before anything moves
DECIMALS = 2  # the released code rounds bounds


class Paper:
    """The rule of the paper; see `chatscene.search.sampler.Sampler` for the contract."""

    def propose(
        self,
        declared: Sequence[ParameterRange],
        done: Sequence[Sequence[Outcome]],
        *,
        count: int,
        seed: int,
    ) -> Proposal:
        """Uniform in ranges around what collided."""
        ranges = refine(declared, [outcome.values for block in done for outcome in block if outcome.crashed])
        return Proposal(ranges=ranges, draw=lambda scene_seed: draw(ranges, seed=scene_seed))


def refine(declared: Sequence[ParameterRange], collided: Sequence[Mapping[str, float]]) -> tuple[ParameterRange, ...]:
    """The ranges for the next block: mean ± population deviation of what collided, inside the declared ranges.

    Parameters move independently of each other, and every block so far counts, not only the last.

    Args:
        declared: The ranges of the program.
        collided: The values of every scene so far in which the ego collided, in the parameters' units.

    Returns:
        A range per parameter; the declared ones while fewer than two scenes have collided.
    """
    if len(collided) < LEAST:
        return tuple(declared)
    return tuple(_moved(p, [values[p.name] for values in collided]) for p in declared)


def _moved(declared: ParameterRange, values: Sequence[float]) -> ParameterRange:
    mean, deviation = fmean(values), pstdev(values)
    low = round(max(mean - deviation, declared.low), DECIMALS)
    high = round(min(mean + deviation, declared.high), DECIMALS)
    # Rounding may step over a declared bound; the released code lets it, we do not.
    return replace(declared, low=declared.clip(low), high=declared.clip(high))
