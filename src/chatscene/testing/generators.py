"""What every generator of scenes owes; see `chatscene.search.generator.Generator`."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from chatscene.ego.policy import load_ego
from chatscene.maps.network import resolve_map
from chatscene.search.climb import simulator_of
from chatscene.search.explore import Block, outcomes
from chatscene.search.generator import Choice, Generator, load_generator
from chatscene.settings import RetrievalSettings, SearchSettings, Settings
from chatscene.terms.outcome import Outcome
from chatscene.terms.scenario import BaseScenario
from chatscene.testing.contract import maker, require

_SETTINGS = Settings(search=SearchSettings(scenes=4, block=2, keep=1))


def check_generator(generator: str | Callable[[], Generator], *, text: str = "") -> None:
    """Hold a generator to the contract of all; it simulates some scenes.

    Args:
        generator: Its name, ``package.module:factory``, or what makes one.
        text: A text of it; its first for a base scenario if empty.

    Raises:
        ContractBroken: It breaks a rule; the message says which.
        SettingsError: There is none of that name.
    """
    made, reading = maker(generator, load_generator)(), RetrievalSettings()
    for base in BaseScenario:
        texts = made.texts(base)
        require(len(set(texts)) == len(texts), "it has no text twice", base)
        for said in texts:
            found = made.read(said, reading).base
            require(found is base, f"a text for {base} belongs to it", (said, found))
        text = text or next(iter(texts), "")
    require(text != "", "it has a text, or is given one to be checked with")
    scenario = made.read(text, reading)
    written, second = (made.write(scenario, reading) for _ in range(2))
    first = written.program
    require(first == second.program, "the same text gives the same program")
    again = made.write_again(scenario, Choice.of(written), reading)
    require(again == first, "what was chosen once gives the same program again")
    require(first.parameters != (), "a program has parameters to search")
    simulator = simulator_of(made, resolve_map("town"), _SETTINGS)
    ego = load_ego("rule-based")

    def search(done: Sequence[Sequence[Outcome]]) -> list[Block]:
        blocks = made.explore(
            first, scenario.slots, 0, simulator=simulator, ego=ego, settings=_SETTINGS.search, done=done
        )
        return list(blocks)

    whole = search([])
    require(len(whole) == 2, "it explores as many blocks as the settings say", len(whole))
    (rest,) = search([outcomes(whole[0])])
    same = [ran.scene for ran in rest.ran] == [ran.scene for ran in whole[1].ran]
    require(same, "it goes on after a block as if it had not stopped")
