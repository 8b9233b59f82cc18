"""Quality diversity: the worst scene of each kind, not the worst scene over and over.

MAP-Elites (Mouret and Clune, "Illuminating search spaces by mapping elites", 2015) keeps the most dangerous scene of
every cell of a grid of kinds, and varies those by the iso-line operator (Vassiliades and Mouret, "Discovering the
Elite Hypervolume by Leveraging Interspecies Correlation", GECCO 2018); the implementation is pyribs'.
"""

from __future__ import annotations

from collections.abc import Sequence

from ribs.archives import GridArchive
from ribs.emitters import IsoLineEmitter

from chatscene.search.sampler import Proposal
from chatscene.search.samplers.uniform import Uniform
from chatscene.search.samplers.unit_cube import UnitCube, dangers
from chatscene.terms.outcome import FULL_IMPACT, Outcome
from chatscene.terms.snippet import ParameterRange

CELLS = (10, 10)  # of share of the route, and of speed of approach
RANGES = ((0.0, 1.0), (0.0, FULL_IMPACT))
# Deviations around an elite, as a share of the range, and along the line to another. Wide, for a search has a few
# hundred scenes and not the customary hundred thousand: less finds more collisions, but fewer kinds.
AROUND, ALONG = 0.2, 0.2


class QualityDiversity:
    """MAP-Elites; see `chatscene.search.sampler.Sampler` for the contract."""

    def propose(
        self, declared: Sequence[ParameterRange], done: Sequence[Sequence[Outcome]], *, count: int, seed: int
    ) -> Proposal:
        """Uniform first, then variations of the elites."""
        cube = UnitCube(tuple(declared))
        seen = [outcome for block in done for outcome in block]
        if not seen or not cube.free:
            return Uniform().propose(declared, done, count=count, seed=seed)
        emitter = IsoLineEmitter(
            archive(cube, seen, seed=seed),
            x0=[0.5] * len(cube.free),  # wanted by the package, used for an empty archive only
            iso_sigma=AROUND,
            line_sigma=ALONG,
            bounds=[(0.0, 1.0)] * len(cube.free),
            batch_size=1,
            seed=seed,
        )
        return Proposal(ranges=cube.declared, draw=lambda _: cube.values(emitter.ask()[0]))


def archive(cube: UnitCube, outcomes: Sequence[Outcome], *, seed: int = 0) -> GridArchive:
    """The elites among these outcomes, by where on the route and how fast the ego was hit."""
    elites = GridArchive(solution_dim=len(cube.free), dims=CELLS, ranges=RANGES, seed=seed)
    measures = [(outcome.completion, outcome.impact_speed) for outcome in outcomes]
    elites.add(cube.points(outcomes), dangers(outcomes), measures)
    return elites
