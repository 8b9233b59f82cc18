"""AdvSim: black-box search over the adversary's speed along its nominal path.

Source: J. Wang, A. Pun, J. Tu, S. Manivasagam, A. Sadat, S. Casas, M. Ren, R. Urtasun, "AdvSim: Generating
Safety-Critical Scenarios for Self-Driving Vehicles", CVPR 2021; as SafeBench has it, with the path kept.
"""

from __future__ import annotations

from chatscene.search.generators.baselines.nominal import Baseline, Nominal
from chatscene.terms.snippet import ParameterRange

STRETCHES, SECONDS = 20, 0.5  # of the profile, and how long each lasts; the last speed is held


class AdvSim(Baseline):
    """A speed for every half second, between standing and twice the nominal speed."""

    name = "advsim"
    title = "AdvSim"
    sampler = "cma-es"

    def behavior(self, nominal: Nominal) -> tuple[str, tuple[ParameterRange, ...]]:
        """Waits, then follows its path at the speeds of the profile."""
        speeds = [f"{2 * nominal.speed:g} * globalParameters.OPT_SPEED_{i:02d}" for i in range(STRETCHES)]
        body = "\n".join(
            (
                f"do {nominal.waits} until {nominal.acts(f'{nominal.trigger:g}')}",
                *(f"do {nominal.moves(speed)} for {SECONDS} seconds" for speed in speeds),
                f"do {nominal.moves(speeds[-1])}",
            )
        )
        return body, tuple(
            ParameterRange(
                name=f"OPT_SPEED_{i:02d}", low=0.0, high=1.0, unit="1",
                meaning=f"share of twice the nominal speed, {i * SECONDS:g} s after it sets off",
            )
            for i in range(STRETCHES)
        )  # fmt: skip
