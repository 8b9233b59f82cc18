"""A run in the native engine leaves the embedded simulator's bytes, and says who stepped its drives."""

from __future__ import annotations

from pathlib import Path

import pytest

import chatscene
from chatscene import pipeline, runs
from chatscene.maps.network import resolve_map
from chatscene.settings import SIMULATOR, SearchSettings, Settings, SimulationSettings
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.simulate.native.engine import NoEngine, load_engine

TEXT = "A cyclist rides out from the left and stops in front of us."
NAMED = {"run.json", "report.html"}  # which name the simulator and the time


def _ran(folder: Path, simulation: SimulationSettings) -> tuple[runs.RunRecord, dict[str, bytes], str]:
    settings = Settings(search=SearchSettings(scenes=3, block=2, keep=1), simulation=simulation)
    said = pipeline.run(runs.asked_run(TEXT, settings=settings), folder).in_words()
    files = {
        str(path.relative_to(folder)): path.read_bytes()
        for path in sorted(folder.rglob("*"))
        if path.is_file() and path.name not in NAMED
    }
    return runs.read_record(runs.open_run(folder)), files, said


def test_every_table_of_a_run_has_the_same_bytes_in_both_simulators(tmp_path: Path) -> None:
    try:
        load_engine()
    except NoEngine as error:
        pytest.skip(str(error))
    mine, files, said = _ran(tmp_path / "native", SimulationSettings(simulator="native"))
    theirs, reference, told = _ran(tmp_path / "embedded", SimulationSettings(simulator="embedded"))
    assert len(files) > 5
    assert files == reference
    assert (mine.stepped, theirs.stepped) == ({"native": 3}, {"embedded": 3})
    assert mine.instead == theirs.instead == {}
    assert "stepped: 3 by native" in said.splitlines()
    assert "stepped: 3 by embedded" in told.splitlines()


def test_a_run_names_the_scenes_that_the_engine_does_not_cover_and_why(tmp_path: Path) -> None:
    record, _, said = _ran(tmp_path / "run", SimulationSettings(simulator="native", physics="lagged"))
    assert record.stepped == {"embedded": 3}
    assert record.instead.keys() == {"the physics lagged"}
    assert len(record.instead["the physics lagged"]) == 3
    assert "stepped: 3 by embedded (not by native: 3 scenes: the physics lagged)" in said.splitlines()


def test_a_run_in_which_no_simulator_was_named_drives_in_the_engine(tmp_path: Path) -> None:
    try:
        load_engine()
    except NoEngine as error:
        pytest.skip(str(error))
    chatscene.run(TEXT, tmp_path / "run", ego="idm", scenes=2)
    record = runs.read_record(runs.open_run(tmp_path / "run"))
    assert (record.simulator.name, record.stepped) == ("native", {"native": 2})


def test_what_must_be_confined_is_hosted_by_the_embedded_simulator_where_none_was_named() -> None:
    with ConfinedSimulator(resolve_map("town"), SimulationSettings(simulator=SIMULATOR)) as simulator:
        assert simulator.identity.name == "confined"
        assert simulator.identity.confinable
