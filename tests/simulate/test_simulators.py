"""The simulators that there are, and a user's own: one contract, chosen by name, kept in the record."""

from dataclasses import replace
from pathlib import Path

import pytest

from chatscene import pipeline, runs
from chatscene.ego.rule_based import RuleBased
from chatscene.errors import RunError, SettingsError
from chatscene.learn.finetune.scenes import kept_scenes
from chatscene.maps.network import resolve_map
from chatscene.runs.record import upgraded
from chatscene.runs.replay import replay
from chatscene.runs.trust import Repeated
from chatscene.search.climb import simulator_of
from chatscene.search.generator import load_generator
from chatscene.settings import SearchSettings, Settings, SimulationSettings
from chatscene.simulate.simulator import SIMULATORS, load_simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.testing.simulators import check_simulator
from scripted_simulator import make_simulator

TOWN = resolve_map("town")
OWN = "scripted_simulator:make_simulator"
SCRIPTED = SimulationSettings(simulator=OWN)


HERE = sorted(SIMULATORS.built_in.keys() - SIMULATORS.addressed)  # the others need a server


@pytest.mark.parametrize("name", [*HERE, OWN])
def test_a_simulator_keeps_its_contract(name: str) -> None:
    check_simulator(lambda map_path, settings: load_simulator(map_path, replace(settings, simulator=name)))


def test_a_simulator_that_moves_nobody_breaks_the_contract(monkeypatch: pytest.MonkeyPatch) -> None:
    import scripted_simulator

    monkeypatch.setattr(scripted_simulator, "SPEEDS", (0.0,))
    with pytest.raises(AssertionError, match="an ego that drives at a wall ends in timeout"):
        check_simulator(make_simulator)


def test_each_built_in_simulator_says_its_own_name() -> None:
    for name in HERE:
        assert load_simulator(TOWN, SimulationSettings(simulator=name)).identity.name == name


def test_what_moves_the_bodies_is_the_simulator_that_was_chosen() -> None:
    source = "model chatscene.world.model\negoRoute = selectRoute(maneuver='straight')\n"
    source += "ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute\n"
    program = ScenicProgram(scenario_id="road", source=source, parameters=(), snippet_ids=())
    scene = Scene(id="road/0", scenario_id="road", route=0, block=0, seed=0, values={})
    episode = simulate(make_simulator(TOWN, SCRIPTED), program, scene, RuleBased())
    assert isinstance(episode, Episode)
    assert episode.ego_track.speed[:7].tolist() == [0.0, 2.0, 4.0, 6.0, 8.0, 10.0, 10.0]


def test_a_simulator_that_cannot_be_confined_runs_no_stranger_s_program() -> None:
    with pytest.raises(SettingsError, match=f"{OWN}' cannot run in the sandbox"):
        simulator_of(load_generator("program"), TOWN, Settings(simulation=SCRIPTED))


@pytest.fixture(scope="module")
def scripted(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("scripted") / "run"
    few = Settings(search=SearchSettings(scenes=2, block=2, keep=1), simulation=SCRIPTED)
    asked = runs.asked_run("AdvSim: straight-obstacle", settings=few, ego="rule-based", generator="advsim")
    pipeline.run(asked, folder)
    return folder


def test_a_record_says_what_ran_its_scenes(scripted: Path) -> None:
    record = runs.read_record(runs.Workspace(scripted))
    assert (record.simulator.name, record.simulator.version, record.simulator.physics) == ("scripted", "1", "a script")
    assert runs.settings_of(record).simulation == SCRIPTED


def test_a_replay_runs_in_the_simulator_of_the_record_and_only_if_the_user_names_it_too(scripted: Path) -> None:
    scene_id = next(row["scene_id"] for row in runs.read_scenes(runs.Workspace(scripted)) if row["status"] == "ran")
    with pytest.raises(RunError, match=f"names the simulator '{OWN}', .*say so: --simulator {OWN}"):
        replay(scripted, scene_id)
    assert replay(scripted, scene_id, repeated=Repeated(simulator=(OWN,))).identical


def test_a_fine_tuning_takes_no_simulator_from_a_record_that_is_not_packaged(scripted: Path) -> None:
    with pytest.raises(RunError, match=f"say so: --simulator {OWN}"):
        kept_scenes([scripted])
    assert kept_scenes([scripted], simulator=OWN).simulation == SCRIPTED
    assert kept_scenes([scripted], simulator="embedded").simulation == SimulationSettings()


def test_a_record_without_a_simulator_is_of_the_default() -> None:
    folder = {"schema_version": 2, "status": "done", "text": "", "map_name": "town", "ego": "sac", "seed": 0}
    record = runs.RunRecord.model_validate(
        upgraded({**folder, "settings": {"simulation": {"dt": 0.1, "max_steps": 300}}})
    )
    assert record.simulator.name == runs.settings_of(record).simulation.simulator == SimulationSettings().simulator
