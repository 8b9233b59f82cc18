"""Random triples: the library without anybody who chooses from it. An ablation of ChatScene, not of the paper.

Kind of adversary and geometry are those of a base scenario; what the adversary does, and where it starts, is drawn
among all that can be joined with them. The search is ChatScene's.
"""

from __future__ import annotations

import hashlib

import numpy as np

from chatscene.library.compatibility import compatibility
from chatscene.library.load import load_library
from chatscene.search.generators.baselines.nominal import Baseline, Nominal
from chatscene.settings import PAPER
from chatscene.terms.scenario import BaseScenario, Scenario
from chatscene.terms.snippet import Snippet


class RandomTriple(Baseline):
    """Five triples for each base scenario, as ChatScene has five sentences."""

    name = "random-triple"
    title = "Random Triple"
    reference = PAPER

    def texts(self, base: BaseScenario) -> tuple[str, ...]:
        """Five, that differ by their number."""
        return tuple(f"{self.title} {number}: {base.value}" for number in range(1, 6))

    def triple(self, scenario: Scenario, nominal: Nominal) -> tuple[Snippet, Snippet, Snippet]:
        """Behavior and spawn as drawn by the text, each pair that can be joined as likely as any other."""
        joint = compatibility(load_library())
        geometry = next(i for i, one in enumerate(joint.geometries) if one.id == f"geometry/{nominal.geometry}")
        behaviors, _, spawns = joint.able(nominal.adversary)
        pairs = np.argwhere(joint.mask[:, geometry] & behaviors[:, None] & spawns)
        drawn = int.from_bytes(hashlib.blake2b(scenario.text.encode(), digest_size=8).digest(), "big") % len(pairs)
        behavior, spawn = pairs[drawn].tolist()
        return joint.behaviors[behavior], joint.geometries[geometry], joint.spawns[spawn]
