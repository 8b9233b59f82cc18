"""Snippets are chosen where one does all that was said; nothing else is chosen instead."""

from __future__ import annotations

import pytest

from chatscene.ego.rule_based import RuleBased
from chatscene.errors import NothingFits
from chatscene.interpret.asked import scenario_of
from chatscene.interpret.choose import choose
from chatscene.maps.network import resolve_map
from chatscene.program.check import check
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings, SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator

SETTINGS = RetrievalSettings()


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings())


@pytest.mark.parametrize(
    ("text", "why"),
    [
        ("The car ahead accelerates, then turns left.", "nothing in the library does this"),
        ("A pedestrian crosses from the right while an oncoming truck drives straight on.", "beside the adversary"),
    ],
)
def test_what_no_snippet_does_is_refused_and_told(text: str, why: str) -> None:
    with pytest.raises(NothingFits, match=why):
        choose(scenario_of(text, SETTINGS), SETTINGS)


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
