"""Adversarial trajectory optimisation: black-box search over how far the adversary strays from its nominal path.

Source: Q. Zhang, S. Hu, J. Sun, Q. A. Chen, Z. M. Mao, "On Adversarial Robustness of Trajectory Prediction for
Autonomous Vehicles", CVPR 2022. Limits are wider than SafeBench's for cars that no junction is near (decision 0022);
SafeBench's, with its triggers, are beside them.
"""

from __future__ import annotations

from chatscene.search.generators.baselines.nominal import Baseline, Nominal
from chatscene.terms.snippet import ParameterRange

STRETCHES, SECONDS = 20, 0.5  # of the path, and how long each takes at the nominal speed
VULNERABLE_LIMIT, LIMIT = 1.0, 3.0  # [m] to either side, on foot or two wheels and in a car


class AdversarialTrajectory(Baseline):
    """A lateral offset for every half second, tracked at the nominal speed."""

    name = "adversarial-trajectory"
    title = "Adversarial Trajectory Optimization"
    sampler = "cma-es"

    def limits(self, nominal: Nominal) -> tuple[float, float]:
        """How far it strays to either side [m], and when it sets off [m]."""
        return VULNERABLE_LIMIT if nominal.adversary.is_vulnerable else LIMIT, nominal.trigger

    def behavior(self, nominal: Nominal) -> tuple[str, tuple[ParameterRange, ...]]:
        """Waits, then moves at the nominal speed beside its path, as far as the offsets say."""
        limit, trigger = self.limits(nominal)
        speed = f"{nominal.speed:g}"
        body = f"do {nominal.waits} until {nominal.acts(f'{trigger:g}')}\n"
        if nominal.path:
            moves = [nominal.moves(speed, f"globalParameters.OPT_OFFSET_{i:02d}") for i in range(STRETCHES)]
            body += "".join(f"do {one} for {SECONDS} seconds\n" for one in moves) + f"do {moves[-1]}"
        else:  # without a path, an offset is reached by a course, which turns by what the last one did not
            body += (
                "offset, course = 0, 0\n"
                f"for i in range({STRETCHES}):\n"
                '    wanted = globalParameters[f"OPT_OFFSET_{i:02d}"]\n'
                f"    ahead = math.atan2(wanted - offset, {nominal.speed * SECONDS:g})\n"
                f"    do {nominal.moves(speed, 'ahead - course')} for {SECONDS} seconds\n"
                "    offset, course = wanted, ahead\n"
                f"do {nominal.moves(speed, '-course')}"
            )
        return body, tuple(
            ParameterRange(
                name=f"OPT_OFFSET_{i:02d}", low=-limit, high=limit, unit="m",
                meaning=f"how far to the left of its nominal path it is {i * SECONDS:g} s after it sets off",
            )
            for i in range(STRETCHES)
        )  # fmt: skip


class AdversarialTrajectoryCited(AdversarialTrajectory):
    """The same within SafeBench's limits."""

    name = "adversarial-trajectory-safebench"
    title = "Adversarial Trajectory Optimization within SafeBench's limits"

    def limits(self, nominal: Nominal) -> tuple[float, float]:
        """How far it strays to either side [m], and when it sets off [m]."""
        return nominal.cited.offset, nominal.cited.trigger
