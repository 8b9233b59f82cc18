"""Tree-structured Parzen estimator: scenes from where the dangerous ones are dense and the harmless ones are not.

Source: Bergstra et al., "Algorithms for Hyper-Parameter Optimization", NeurIPS 2011; the implementation is Optuna's.
"""

from __future__ import annotations

from collections.abc import Generator, Sequence
from contextlib import contextmanager

import optuna
from optuna.distributions import BaseDistribution, FloatDistribution

from chatscene.program.sample import DECIMALS
from chatscene.search.sampler import Proposal
from chatscene.terms.outcome import Outcome
from chatscene.terms.snippet import ParameterRange

PLUGIN = {
    "name": "tpe",
    "makes": "TreeParzen",
    "needs": "search",
    "what": "tree-structured Parzen estimator (Optuna)",
}


class TreeParzen:
    """Optuna's TPE; see `chatscene.search.sampler.Sampler` for the contract."""

    def propose(
        self,
        declared: Sequence[ParameterRange],
        done: Sequence[Sequence[Outcome]],
        *,
        count: int,
        seed: int,
    ) -> Proposal:
        """What Optuna asks for, given all outcomes; draws of the block that have no outcome yet are kept clear of."""
        space: dict[str, BaseDistribution] = {p.name: FloatDistribution(p.low, p.high) for p in declared}
        tpe = optuna.samplers.TPESampler(seed=seed, constant_liar=True)
        with _silence():
            study = optuna.create_study(sampler=tpe, direction="maximize")
            for outcome in (outcome for block in done for outcome in block):
                values = {p.name: p.clip(outcome.values[p.name]) for p in declared}
                study.add_trial(optuna.trial.create_trial(params=values, distributions=space, value=outcome.danger))

        def draw(_: int) -> dict[str, float]:
            asked = study.ask(space).params
            return {p.name: p.clip(round(float(asked[p.name]), DECIMALS)) for p in declared}

        return Proposal(ranges=tuple(declared), draw=draw)


@contextmanager
def _silence() -> Generator[None]:
    """Optuna reports every study it makes; its level is put back, for it may be the user's."""
    level = optuna.logging.get_verbosity()
    optuna.logging.set_verbosity(optuna.logging.WARNING)
    try:
        yield
    finally:
        optuna.logging.set_verbosity(level)
