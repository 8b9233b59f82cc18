"""Two road users who both do something: one is searched with, the other does what was said of it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

from chatscene.commands.main import main
from chatscene.ego.rule_based import RuleBased
from chatscene.errors import NothingFits
from chatscene.interpret.asked import scenario_of
from chatscene.interpret.choose import choose
from chatscene.library.load import load_library
from chatscene.maps.network import resolve_map
from chatscene.program.check import check
from chatscene.program.meaning import check_meaning
from chatscene.program.sample import scene_at
from chatscene.search.generator import Choice
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings, SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.episode import OTHER, Episode, Role
from chatscene.terms.scenario import Position, Slots

SETTINGS = RetrievalSettings()
TWO = "A pedestrian crosses the road from the right while an oncoming truck drives straight on."
REVEALS = "The car ahead changes lanes to the left and reveals a car that stands still in our lane."


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings())


@pytest.mark.parametrize("text", [TWO, REVEALS])
def test_both_do_what_was_said_of_them(text: str, simulator: Simulator) -> None:
    scenario = scenario_of(text, SETTINGS)
    written = Retrieved().write(scenario, SETTINGS)
    checked = check(written.program, scenario.slots, simulator, RuleBased())
    assert any(not failures for failures in checked.meaning)
    other = next(track for track in checked.episodes[0].tracks if track.actor == OTHER)
    assert other.role is Role.BACKGROUND


def test_the_one_who_is_searched_with_alone_has_parameters() -> None:
    one, both = (
        Retrieved().write(scenario_of(text, SETTINGS), SETTINGS).program
        for text in ("A pedestrian crosses the road from the right.", TWO)
    )
    assert [p.name for p in one.parameters] == [p.name for p in both.parameters]


def test_what_the_other_does_not_do_is_a_failure(simulator: Simulator) -> None:
    scenario = scenario_of(TWO, SETTINGS)
    program = Retrieved().write(scenario, SETTINGS).program
    episode = simulate(simulator, program, scene_at(program, 0, 0.5, name="one"), RuleBased())
    assert isinstance(episode, Episode)
    route = simulator.route(program, 0)
    assert check_meaning(scenario.slots, episode, route) == ()
    stands = Slots(adversary=AdversaryKind.TRUCK, actions=(Action.STAND,), position=Position.ONCOMING)
    assert "said stand, but the truck" in check_meaning(Slots(others=(stands,)), episode, route)[0]
    alone = replace(episode, tracks=episode.tracks[:2])
    assert "there is no truck" in check_meaning(Slots(others=(stands,)), alone, route)[0]


def test_a_spawn_with_another_in_it_follows_from_its_id() -> None:
    retrieval, (_, _, spawn) = choose(scenario_of(TWO, SETTINGS), SETTINGS)
    assert load_library().get(spawn.id) == spawn
    assert any("beside the adversary: truck" in note for note in retrieval.notes)


def test_a_program_with_another_is_written_again_from_what_was_chosen() -> None:
    scenario = scenario_of(REVEALS, SETTINGS)
    written = Retrieved().write(scenario, SETTINGS)
    assert Retrieved().write_again(scenario, Choice.of(written), SETTINGS) == written.program


def test_the_other_is_told_in_words(tmp_path: Path) -> None:
    told = " ".join(CliRunner().invoke(main, ["explain", TWO]).output.split())
    assert "A truck is coming the other way. It is not the danger. It goes straight on." in told
    assert "(others.B.kind: an oncoming truck)" in told
    assert "no words of the text say" not in told
    run = CliRunner().invoke(main, ["run", TWO, "--out", str(tmp_path / "run"), "--routes", "1", "--scenes", "4"])
    assert run.exit_code == 0, run.output
    assert "adversary truck" in (tmp_path / "run" / "report.html").read_text()


def test_one_who_does_what_no_steps_do_is_refused_by_name() -> None:
    text = "A pedestrian crosses the road from the right while a car behind us makes a u-turn."
    with pytest.raises(NothingFits, match=r"no steps .* another road user .*u-turn"):
        choose(scenario_of(text, SETTINGS), SETTINGS)
