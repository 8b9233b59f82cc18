"""The search of generators that have none of their own: ChatScene's, block by block."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from chatscene.settings import SearchSettings
from chatscene.terms.outcome import Outcome
from chatscene.terms.scenario import Said
from chatscene.terms.scene import ScenicProgram

if TYPE_CHECKING:
    from chatscene.ego.policy import EgoPolicy
    from chatscene.search.explore import Block
    from chatscene.simulate.simulator import Simulator


class Exploring:
    """Explores as `chatscene.search.explore.explore` does."""

    def searching(self, settings: SearchSettings) -> SearchSettings:
        """What its search is set to: what the user set, unless a generator says otherwise."""
        return settings

    def explore(
        self,
        program: ScenicProgram,
        said: Said,
        route: int,
        *,
        simulator: Simulator,
        ego: EgoPolicy,
        settings: SearchSettings,
        done: Sequence[Sequence[Outcome]],
    ) -> Iterator[Block]:
        """Steps 5 and 6."""
        from chatscene.search.explore import explore

        own = self.searching(settings)
        return explore(program, said, route, simulator=simulator, ego=ego, settings=own, done=done)
