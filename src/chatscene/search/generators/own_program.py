"""A user's own Scenic program as a generator: nothing is retrieved, and all of it is run behind the sandbox's walls."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from chatscene.ego.policy import EgoPolicy
from chatscene.search.explore import Block, explore
from chatscene.search.generator import Choice, Written
from chatscene.search.generators.foreign import foreign_program
from chatscene.settings import RetrievalSettings, SearchSettings
from chatscene.simulate.simulator import Simulator
from chatscene.terms.outcome import Outcome
from chatscene.terms.scenario import BaseScenario, Scenario, Slots, SubDescriptions
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import Tried

_PARTS = SubDescriptions(behavior="as programmed", geometry="as programmed", spawn="as programmed")


class OwnProgram:
    """Searches with a program as it is; see `chatscene.search.generator.Generator` for the contract."""

    reference = SearchSettings()

    def texts(self, base: BaseScenario) -> tuple[str, ...]:  # noqa: ARG002
        """None: a program of one's own belongs to no base scenario."""
        return ()

    def read(self, text: str, settings: RetrievalSettings) -> Scenario:  # noqa: ARG002 - nothing is retrieved
        """The scenario of a program, whose text is its code; nothing was said, so nothing is held against it."""
        program = foreign_program("program", text)
        return Scenario(id=program.scenario_id, text=text, base=None, parts=_PARTS, slots=Slots())

    def write(self, scenario: Scenario, settings: RetrievalSettings, tried: Sequence[Tried] = ()) -> Written:  # noqa: ARG002
        """The program itself."""
        return Written(program=foreign_program(scenario.id, scenario.text), retrieval=None)

    def write_again(self, scenario: Scenario, choice: Choice | None, settings: RetrievalSettings) -> ScenicProgram:  # noqa: ARG002
        """The program itself."""
        return foreign_program(scenario.id, scenario.text)

    def is_trusted(self, settings: RetrievalSettings) -> bool:  # noqa: ARG002
        """Never: whoever wrote the program is a stranger."""
        return False

    def explore(
        self,
        program: ScenicProgram,
        slots: Slots,
        route: int,
        *,
        simulator: Simulator,
        ego: EgoPolicy,
        settings: SearchSettings,
        done: Sequence[Sequence[Outcome]],
    ) -> Iterator[Block]:
        """Steps 5 and 6."""
        return explore(program, slots, route, simulator=simulator, ego=ego, settings=settings, done=done)
