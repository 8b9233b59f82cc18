"""From what a generator writes to a program that shows what was said: where it runs, and the validation ladder."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from chatscene.ego.policy import EgoPolicy
from chatscene.errors import ChatSceneError, MeansSomethingElse, NothingFits, ServerError
from chatscene.search.generator import Generator, Written
from chatscene.settings import RetrievalSettings, Settings
from chatscene.simulate.simulator import Simulator, load_simulator
from chatscene.terms.scenario import Scenario
from chatscene.terms.snippet import Tried

if TYPE_CHECKING:
    from chatscene.program.check import Checked

TRIES = 4  # how many choices climb the ladder before a sentence is refused


def simulator_of(generator: Generator, map_path: Path, settings: Settings) -> Simulator:
    """Where a generator's programs are run: the simulator of the settings, behind the sandbox's walls if need be.

    Raises:
        SettingsError: There is no such simulator, or the programs must be confined and it cannot be.
    """
    if generator.is_trusted(settings.retrieval):
        return load_simulator(map_path, settings.simulation)
    from chatscene.simulate.confined.simulator import ConfinedSimulator

    return ConfinedSimulator(map_path, settings.simulation)


def climb(
    generator: Generator,
    scenario: Scenario,
    first: Written,
    *,
    settings: RetrievalSettings,
    simulator: Simulator,
    ego: EgoPolicy,
) -> tuple[Written, Checked]:
    """The best program of a scenario that climbs the validation ladder: where one shows something else, the next best.

    Raises:
        MeansSomethingElse: Neither the first choice nor the next ones show it; this is about the first.
        ChatSceneError: The first choice fails in another way.
    """
    from chatscene.program.check import check  # who drives a scene again climbs nothing

    written, tried = first, list[Tried]()
    refusal: MeansSomethingElse | None = None
    while True:
        try:
            return written, check(written.program, scenario.said, simulator, ego)
        except MeansSomethingElse as error:
            refusal = refusal or error
            tried.append(Tried(snippet_ids=error.blamed, reason=str(error)))
            if len(tried) == TRIES or not error.blamed:
                raise refusal from None
        except ServerError:
            raise  # which says nothing of the program
        except ChatSceneError as error:
            raise refusal or error from None
        try:
            written = generator.write(scenario, settings, tried)
        except NothingFits:
            raise refusal from None
