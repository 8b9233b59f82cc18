"""The opponent of every search: scenes drawn from the declared ranges, whatever came of the others."""

from __future__ import annotations

from collections.abc import Sequence

from chatscene.program.sample import draw
from chatscene.search.sampler import Proposal
from chatscene.terms.outcome import Outcome
from chatscene.terms.snippet import ParameterRange

PLUGIN = {
    "name": "random",
    "makes": "Uniform",
    "what": "always draws from the declared ranges",
}


class Uniform:
    """Uniform in the declared ranges; see `chatscene.search.sampler.Sampler` for the contract."""

    looks_back = False

    def propose(
        self,
        declared: Sequence[ParameterRange],
        done: Sequence[Sequence[Outcome]],
        *,
        count: int,
        seed: int,
    ) -> Proposal:
        """The declared ranges."""
        ranges = tuple(declared)
        return Proposal(ranges=ranges, draw=lambda scene_seed: draw(ranges, seed=scene_seed))
