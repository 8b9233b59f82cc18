"""Carla scenario generator: rule-based adversaries over a grid of their parameters.

Source: CARLA's ScenarioRunner, with the parameters that SafeBench varies: speed and trigger.
"""

from __future__ import annotations

from dataclasses import replace

from chatscene.search.generators.baselines.nominal import Baseline, Nominal
from chatscene.settings import PAPER
from chatscene.terms.snippet import ParameterRange

AROUND = 0.2  # share of the nominal speed, and …
EARLIER_OR_LATER = 4.0  # … metres of the trigger, to either side


class ScenarioRunner(Baseline):
    """The nominal adversary, a little faster or slower, a little earlier or later."""

    name = "carla-scenario-generator"
    title = "Carla Scenario Generator"
    sampler = "grid"
    reference = replace(PAPER, scenes=10, keep=10, selection="last")

    def behavior(self, nominal: Nominal) -> tuple[str, tuple[ParameterRange, ...]]:
        """Waits, then moves at a constant speed."""
        body = (
            f"do {nominal.waits} until {nominal.acts('globalParameters.OPT_ADV_DISTANCE')}\n"
            f"do {nominal.moves('globalParameters.OPT_ADV_SPEED')}"
        )
        trigger, speed = nominal.trigger, nominal.speed
        return body, (
            ParameterRange(
                name="OPT_ADV_DISTANCE", low=trigger - EARLIER_OR_LATER, high=trigger + EARLIER_OR_LATER, unit="m",
                meaning="how far the ego still has to go when the adversary sets off",
            ),
            ParameterRange(
                name="OPT_ADV_SPEED", low=round((1 - AROUND) * speed, 3), high=round((1 + AROUND) * speed, 3),
                unit="m/s", meaning="how fast it then is",
            ),
        )  # fmt: skip
