"""Learning-to-Collide: policy-gradient search over how the adversary starts.

Source: W. Ding, B. Chen, M. Xu, D. Zhao, "Learning to Collide: An Adaptive Safety-Critical Scenarios Generating
Method", IROS 2020. Ranges are wider than SafeBench's at junctions (decision 0022); SafeBench's are beside them.
"""

from __future__ import annotations

import math

from chatscene.search.generators.baselines.nominal import Baseline, Nominal, narrowed
from chatscene.terms.snippet import ParameterRange, Snippet


class LearningToCollide(Baseline):
    """Where the adversary starts, which way it faces, when it sets off and how fast; then it keeps its course."""

    name = "learning-to-collide"
    title = "Learning-to-Collide"
    sampler = "policy-gradient"
    starts = True

    def ranges(self, nominal: Nominal) -> tuple[tuple[float, float], tuple[float, float]]:
        """Of the trigger [m] and the speed [m/s]."""
        trigger, speed = nominal.trigger, nominal.speed
        return (max(5.0, trigger - 15), trigger + 15), (0.5 * speed, 1.5 * speed)

    def behavior(self, nominal: Nominal) -> tuple[str, tuple[ParameterRange, ...]]:
        """Waits, then moves at a constant speed."""
        (nearest, farthest), (slowest, fastest) = self.ranges(nominal)
        parameters = [
            ParameterRange(
                name="OPT_ADV_DISTANCE", low=nearest, high=farthest, unit="m",
                meaning="how far the ego still has to go when the adversary sets off",
            ),
            ParameterRange(name="OPT_ADV_SPEED", low=slowest, high=fastest, unit="m/s", meaning="how fast it then is"),
        ]  # fmt: skip
        aside = ""
        if not nominal.path:
            aside = "globalParameters.OPT_ADV_TURN"
            sixty = round(math.pi / 3, 3)
            parameters.append(
                ParameterRange(
                    name="OPT_ADV_TURN", low=-sixty, high=sixty, unit="rad",
                    meaning="how far to the left of straight across it goes",
                )
            )  # fmt: skip
        body = (
            f"do {nominal.waits} until {nominal.acts('globalParameters.OPT_ADV_DISTANCE')}\n"
            f"do {nominal.moves('globalParameters.OPT_ADV_SPEED', aside)}"
        )
        return body, tuple(parameters)


class LearningToCollideCited(LearningToCollide):
    """The same within SafeBench's ranges."""

    name = "learning-to-collide-safebench"
    title = "Learning-to-Collide within SafeBench's ranges"

    def ranges(self, nominal: Nominal) -> tuple[tuple[float, float], tuple[float, float]]:
        """Of the trigger [m] and the speed [m/s]."""
        return nominal.cited.triggers, nominal.cited.speeds

    def start(self, spawn: Snippet, nominal: Nominal) -> Snippet:
        """Near the middle of its snippet's range, where SafeBench says how near."""
        return spawn if nominal.cited.start is None else narrowed(spawn, nominal.cited.start)
