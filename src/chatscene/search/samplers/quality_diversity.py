"""Quality diversity: the worst crash of each kind, not the worst crash over and over.

MAP-Elites (Mouret and Clune, "Illuminating search spaces by mapping elites", 2015) keeps the most dangerous scene of
every kind, and varies those by the iso-line operator (Vassiliades and Mouret, "Discovering the Elite Hypervolume by
Leveraging Interspecies Correlation", GECCO 2018). Kinds are those of crashes (`chatscene.measure.crash_type`), so that
there is no grid to lay over numbers. Which elite is varied is a draw: more often one of more worth, less often one of
a kind that has come up often. Of several variations the one farthest from all scenes so far is driven (Mitchell,
"Spectrally optimal sampling for distribution ray tracing", SIGGRAPH 1991), lest it be the same crash again.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence

import numpy as np

from chatscene.search.sampler import Proposal
from chatscene.search.samplers.uniform import Uniform
from chatscene.search.samplers.unit_cube import UnitCube
from chatscene.terms.outcome import Outcome
from chatscene.terms.snippet import ParameterRange

PLUGIN = {
    "name": "quality-diversity",
    "makes": "QualityDiversity",
    "what": "the default of `run`: varies the most dangerous scene of each kind of crash (MAP-Elites); "
    "the first block and a fifth of the other scenes are drawn uniformly",
}

# Deviations around an elite, as a share of the range, and along the line to another. Wide, for a search has a few
# hundred scenes and not the customary hundred thousand.
AROUND, ALONG = 0.1, 0.2
CANDIDATES = 8  # variations of which one is driven
ANYWHERE = 0.2  # share of the scenes that are drawn as if nothing were known
NEAREST = 3  # scenes without a crash that are varied as well, each as a kind of its own
WORTH = 4.0  # how many times as often an elite is varied as one a step less dangerous


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
        kept = elites(seen)
        points, shares = cube.points([one for one, _ in kept]), [share for _, share in kept]
        rng = np.random.default_rng(seed)

        taken = cube.points(seen)

        def draw(_: int) -> dict[str, float]:
            nonlocal taken
            if rng.random() < ANYWHERE:
                new = rng.random((CANDIDATES, len(cube.free)))
            else:
                one = points[rng.choice(len(points), CANDIDATES, p=shares)]
                toward = points[rng.integers(len(points), size=CANDIDATES)] - one
                around = rng.normal(scale=AROUND, size=one.shape)
                new = np.clip(one + around + rng.normal(scale=ALONG, size=(CANDIDATES, 1)) * toward, 0.0, 1.0)
            apart = np.linalg.norm(new[:, None] - taken, axis=2).min(axis=1)
            taken = np.concatenate((taken, new[apart.argmax()][None]))
            return cube.values(taken[-1])

        return Proposal(ranges=cube.declared, draw=draw)


def elites(outcomes: Sequence[Outcome]) -> list[tuple[Outcome, float]]:
    """The most dangerous outcome of each kind and the share of scenes that vary it; those without a crash come last."""
    worst: dict[tuple[str, bool | None], Outcome] = {}
    found: Counter[tuple[str, bool | None]] = Counter()
    for outcome in (outcome for outcome in outcomes if outcome.crashed):
        kind = (outcome.crash_type, outcome.avoidable)
        found[kind] += 1
        if kind not in worst or outcome.danger > worst[kind].danger:
            worst[kind] = outcome
    near = sorted((o for o in outcomes if not o.crashed), key=lambda o: -o.danger)[:NEAREST]
    weighed = [(one, WORTH ** int(one.danger) / found[kind]) for kind, one in worst.items()]
    weighed += [(one, 1.0) for one in near]
    whole = sum(weight for _, weight in weighed)
    return [(one, weight / whole) for one, weight in weighed]
