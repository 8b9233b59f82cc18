"""What no snippet does is composed, where words say all that is done; what one does is left to it."""

from __future__ import annotations

import pytest

from chatscene.ego.rule_based import RuleBased
from chatscene.interpret.asked import scenario_of
from chatscene.interpret.choose import choose
from chatscene.library.compose import COMPOSED
from chatscene.maps.network import resolve_map
from chatscene.program.check import check
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings, SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator
from chatscene.terms.snippet import Tried

SETTINGS = RetrievalSettings()


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings())


@pytest.mark.parametrize(
    ("text", "snippet_id"),
    [
        ("A cyclist crosses from the right, stops and turns back.", "bicycle.roadside.cross.stop.turn-back"),
        ("A motorcycle from behind overtakes us and brakes.", "motorcycle.behind.overtake.brake"),
        ("A truck ahead weaves, then reverses.", "truck.ahead.weave.reverse"),
        ("We are stopped and the car ahead of us reverses.", "car.ahead-of-standing-ego.reverse"),
    ],
)
def test_what_words_say_and_no_snippet_does_is_composed_and_shown(
    text: str, snippet_id: str, simulator: Simulator
) -> None:
    scenario = scenario_of(text, SETTINGS)
    written = Retrieved().write(scenario, SETTINGS)
    assert written.retrieval is not None
    assert written.retrieval.behavior.snippet.id == f"behavior/composed.{snippet_id}"
    assert any("composed" in note for note in written.retrieval.notes)
    checked = check(written.program, scenario.slots, simulator, RuleBased())
    assert any(not failures for failures in checked.meaning)


@pytest.mark.parametrize(
    "text",
    [
        "The car ahead accelerates, then brakes.",  # a snippet does it
        "The oncoming car accelerates, then brakes.",  # oncoming goes without saying
    ],
)
def test_a_snippet_that_does_it_is_preferred(text: str) -> None:
    retrieval, _ = choose(scenario_of(text, SETTINGS), SETTINGS)
    assert not retrieval.behavior.snippet.id.startswith(COMPOSED)


@pytest.mark.parametrize(
    "text",
    [
        "A speeding car runs the red light from the left.",  # the calm one is likelier to be meant, but for one word
        "A car runs the red light from the left at high speed.",
        "A car speeds through the red light from the left.",
        "A motorcycle shoots through the red light from the right at full speed.",
    ],
)
def test_haste_is_done_wherever_it_is_said(text: str, simulator: Simulator) -> None:
    scenario = scenario_of(text, SETTINGS)
    written = Retrieved().write(scenario, SETTINGS)
    assert written.retrieval is not None
    assert written.retrieval.behavior.snippet.id == "behavior/run-light-fast"
    assert any(not failures for failures in check(written.program, scenario.slots, simulator, RuleBased()).meaning)


def test_a_composed_behavior_that_was_tried_gives_way_to_the_nearest_snippet() -> None:
    scenario = scenario_of("A motorcycle from behind overtakes us and brakes.", SETTINGS)
    first, _ = choose(scenario, SETTINGS)
    behavior, _, spawn = first.snippets
    again, _ = choose(scenario, SETTINGS, [Tried(snippet_ids=(behavior.id, spawn.id), reason="not shown")])
    assert behavior.id.startswith(COMPOSED)
    assert not again.behavior.snippet.id.startswith(COMPOSED)
