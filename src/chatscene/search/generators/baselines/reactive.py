"""A reactive adversary under a feasibility gate: it answers what the ego does, and leaves it a way out.

After K. Chen, Y. Lei, H. Cheng, H. Wu, W. Sun, S. Zheng, "FREA: Feasibility-Guided Generation of Safety-Critical
Scenarios with Reasonable Adversariality", CoRL 2024. Kept of it are an adversary that answers the ego, step by step,
and that is adversarial only while the ego is in a feasible state. Its policy is a rule of three parameters, searched
for on a route, not a network trained on all; and a state is feasible in which the careful driver of UN R157 can still
stop, not one of a region that a value network knows (decision 0108).
"""

from __future__ import annotations

from chatscene.measure.avoidability import BRAKING_DELAY, FULL_BRAKE, RAMP, RISK_EVALUATION
from chatscene.search.generators.baselines.nominal import TO_ADVERSARY, Baseline, Nominal
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.snippet import ParameterRange

SECONDS = 0.2  # between two decisions
REACH = 2.0  # of the nominal trigger, from where on it reacts
UNTIL_BRAKED = RISK_EVALUATION + BRAKING_DELAY + RAMP / 2  # [s] of the careful driver
HARDER = round(AdversaryKind.CAR.row.limits.brake / FULL_BRAKE, 3)  # is a car's whole brake than that driver's
ROOM = 5.0  # [m] between the centres of two that have just stopped short of each other
SLOWEST = 0.2  # of the nominal speed, so that it blocks no way for ever

# How far [m] the careful driver still goes.
_STOPS = f"{ROOM:g} + {UNTIL_BRAKED:g} * ego.pose[3] + {HARDER:g} * brakingDistance(ego)"


class Reactive(Baseline):
    """Five times a second a speed along its path, by how soon the ego will be where they meet."""

    name = "reactive"
    title = "Reactive adversary under a feasibility gate"
    sampler = "cma-es"
    objective = "avoidable"

    def behavior(self, nominal: Nominal) -> tuple[str, tuple[ParameterRange, ...]]:
        """Waits, then times itself by the ego for as long as the careful driver could still stop."""
        trigger, (wish, manner), stops, then = nominal.trigger, _wish(nominal), _STOPS, "self.pose[3]"
        if not nominal.own and not nominal.leads:  # comes toward the ego, who has a way out only if it stops, too
            stops, then = f"{stops} + {ROOM:g} + {SECONDS:g} * self.pose[3] + brakingDistance(self)", "0"
        fastest = f"{nominal.speed:g} * globalParameters.OPT_ADV_TOP"
        body = "\n".join(
            (
                f"do {nominal.waits} until {nominal.acts('globalParameters.OPT_ADV_DISTANCE')}",
                "while True:",
                f"    left = {TO_ADVERSARY if nominal.leads else nominal.left}",
                f"    wish = max({SLOWEST * nominal.speed:g}, min({fastest}, {wish}))",
                f"    speed = wish if left > {stops} else {then}",
                f"    do {nominal.moves('speed')} for {SECONDS} seconds",
            )
        )
        return body, (
            ParameterRange(
                name="OPT_ADV_DISTANCE", low=trigger, high=REACH * trigger, unit="m",
                meaning="how far the ego still has to go when the adversary begins to react",
            ),
            ParameterRange(
                name="OPT_ADV_TOP", low=0.5, high=2.0, unit="1", meaning="share of the nominal speed that it may go"
            ),
            manner,
        )  # fmt: skip


def _wish(nominal: Nominal) -> tuple[str, ParameterRange]:
    """The speed that it would go, as Scenic, and the parameter that it depends on."""
    if nominal.own:
        late = ParameterRange(
            name="OPT_ADV_LATE", low=-1.0, high=1.5, unit="s", meaning="how long after the ego it aims to be there"
        )
        return f"{nominal.own} / max(0.5, left / max(1, ego.pose[3]) + globalParameters.OPT_ADV_LATE)", late
    share = ParameterRange(
        name="OPT_ADV_SHARE", low=0.0, high=1.0, unit="1",
        meaning="share that it goes of the ego's speed" if nominal.leads else "share that it goes of its nominal speed",
    )  # fmt: skip
    return f"{'ego.pose[3]' if nominal.leads else f'{nominal.speed:g}'} * globalParameters.OPT_ADV_SHARE", share
