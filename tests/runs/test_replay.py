"""A replay uses what was stored: it reads no sentence, executes no stored program, and says what has changed."""

from __future__ import annotations

import json
import shutil
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from click.testing import CliRunner

from chatscene import pipeline, runs
from chatscene.commands.main import main
from chatscene.errors import Diverged, RunError
from chatscene.maps.network import resolve_map
from chatscene.runs.atomic import write_json
from chatscene.runs.rebuild import map_of, rebuild
from chatscene.runs.replay import replay
from chatscene.search.generator import Choice
from chatscene.search.generators.baselines.advsim import AdvSim
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings, SearchSettings, Settings
from chatscene.terms.scenario import BaseScenario, Scenario
from fake_run import resealed

QUANTIFIED = "A cyclist rides out at 18 km/h from the left and stops in front of us."
SENTENCES = [
    QUANTIFIED,
    "A pedestrian crosses from the right 30 m ahead of us and stops.",
    "A cyclist crosses the road from the left, stops and then turns back.",
    "The car ahead of us stops and then reverses.",
    *(Retrieved().texts(base)[0] for base in BaseScenario),
]


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("replay") / "run"
    few = Settings(search=SearchSettings(scenes=2, block=1))
    pipeline.run(runs.asked_run(QUANTIFIED, settings=few, ego="rule-based"), folder)
    return folder


@pytest.fixture
def folder(whole: Path, tmp_path: Path) -> Path:
    return shutil.copytree(whole, tmp_path / "run")


@pytest.fixture
def unread(monkeypatch: pytest.MonkeyPatch) -> None:
    """Nothing that reads a sentence or retrieves may be called."""

    def refuse(*_: object, **__: object) -> None:
        raise AssertionError("a stored run is read, not its sentence")

    for name in ("chatscene.read.learned.reader.LearnedReader.read", "chatscene.interpret.choose.choose"):
        monkeypatch.setattr(name, refuse)


def _driven(folder: Path) -> str:
    return next(row["scene_id"] for row in runs.read_scenes(runs.Workspace(folder)) if row["status"] == "ran")


@pytest.mark.usefixtures("unread")
def test_a_replay_reads_no_sentence(whole: Path) -> None:
    replayed = replay(whole, _driven(whole))
    assert replayed.identical
    assert replayed.versions == {}


@pytest.mark.usefixtures("unread")
def test_the_program_of_a_run_is_joined_again_with_the_ranges_it_was_bound_to(whole: Path) -> None:
    made = rebuild(runs.open_run(whole))
    scenario, program = made.scenario, made.program
    speed = next(p for p in program.parameters if p.name == "OPT_ADV_SPEED")
    assert (speed.low, speed.high) == (4.5, 5.0)
    assert program.source == runs.read_programs(runs.Workspace(whole))[scenario.id]
    assert scenario.text == QUANTIFIED
    assert scenario.slots.side == "left"


def _stored(tmp_path: Path, told: dict[str, Any]) -> tuple[Scenario, Choice | None]:
    run = runs.Workspace(tmp_path)
    write_json(run.file("explanation.json"), told)
    return runs.read_choice(run)


@pytest.mark.parametrize("number", range(len(SENTENCES)))
def test_a_choice_that_was_stored_makes_the_same_program_again(tmp_path: Path, number: int) -> None:
    settings = RetrievalSettings()
    scenario = Retrieved().read(SENTENCES[number], settings)
    written = Retrieved().write(scenario, settings)
    told = runs.explain(scenario.text, [(scenario, written.retrieval)])
    again, choice = _stored(tmp_path, told)
    assert choice is not None
    assert (again.id, again.text, again.base, again.parts) == (
        scenario.id,
        scenario.text,
        scenario.base,
        scenario.parts,
    )
    assert again.slots == scenario.slots
    choice = replace(choice, ranges={p.name: (p.low, p.high) for p in written.program.parameters})
    assert Retrieved().write_again(again, choice, settings) == written.program


def test_a_program_without_a_retrieval_is_made_of_its_stored_scenario(tmp_path: Path) -> None:
    settings, advsim = RetrievalSettings(), AdvSim()
    scenario = advsim.read(advsim.texts(BaseScenario.RIGHT_TURN)[0], settings)
    again, choice = _stored(tmp_path, runs.explain(scenario.text, [(scenario, None)]))
    assert choice is None
    assert advsim.write(again, settings).program == advsim.write(scenario, settings).program


@pytest.mark.usefixtures("unread")
def test_a_baseline_is_rebuilt_from_its_stored_scenario(tmp_path: Path) -> None:
    few = Settings(search=SearchSettings(scenes=1, block=1))
    text = AdvSim().texts(BaseScenario.RIGHT_TURN)[0]
    pipeline.run(runs.asked_run(text, settings=few, ego="rule-based", generator="advsim"), tmp_path / "run")
    assert replay(tmp_path / "run", _driven(tmp_path / "run")).identical


def _forge(folder: Path, name: str, change: dict[str, Any]) -> None:
    path = folder / name
    content = json.loads(path.read_text())
    (content["scenarios"][0] if name == "explanation.json" else content).update(change)
    path.write_text(json.dumps(content))


def test_a_stored_program_that_is_another_one_is_not_executed(folder: Path, tmp_path: Path) -> None:
    program = next(folder.glob("programs/*.scenic"))
    program.write_text(program.read_text() + f"\nopen({str(tmp_path / 'ran')!r}, 'w')\n")
    resealed(runs.Workspace(folder))
    with pytest.raises(Diverged, match="now make another program"):
        replay(folder, _driven(folder))
    assert not (tmp_path / "ran").exists()


@pytest.mark.parametrize(
    "chosen",
    [
        {"behavior": "behavior/fly-away", "geometry": "geometry/straight-road", "spawn": "spawn/roadside-right"},
        {"behavior": "behavior/cross", "geometry": "geometry/straight-road", "spawn": "spawn/roadside-left"},
    ],
)
def test_other_snippets_than_those_of_the_program_diverge(folder: Path, chosen: dict[str, str]) -> None:
    _forge(folder, "explanation.json", {"chosen": chosen})
    resealed(runs.Workspace(folder))
    with pytest.raises(Diverged, match="the library has changed"):
        rebuild(runs.Workspace(folder))


def test_ranges_beyond_those_of_a_snippet_diverge(folder: Path) -> None:
    path = folder / "ranges.parquet"
    table = pq.read_table(path)
    high = np.full(table.num_rows, 900.0)
    pq.write_table(table.set_column(table.column_names.index("high"), "high", pa.array(high)), path)
    resealed(runs.Workspace(folder))
    with pytest.raises(Diverged, match=r"lies between .* not .* and 900"):
        rebuild(runs.Workspace(folder))


def test_a_run_that_came_to_no_choice_cannot_be_rebuilt(folder: Path) -> None:
    _forge(folder, "explanation.json", {"chosen": {}})
    resealed(runs.Workspace(folder))
    with pytest.raises(RunError, match="names no snippets"):
        rebuild(runs.Workspace(folder))


def _with_other_versions(folder: Path, **versions: str) -> None:
    run = runs.Workspace(folder)
    record = runs.read_record(run)
    _forge(folder, "run.json", {"versions": {**record.versions, **versions}})
    resealed(run)


def test_a_replay_that_differs_names_every_version_that_does(folder: Path) -> None:
    scene = _driven(folder)
    path = min((folder / "episodes").iterdir())
    table = pq.read_table(path)
    x = table.column("x").to_numpy().copy()
    x[3] += 1e-9
    pq.write_table(table.set_column(table.column_names.index("x"), "x", pa.array(x)), path)
    _with_other_versions(folder, numpy="1.0.0", scenic="3.0.0")
    now = runs.changed_versions(runs.read_record(runs.Workspace(folder)))
    assert list(now) == ["scenic", "numpy"]
    answer = CliRunner().invoke(main, ["replay", str(folder), scene])
    assert answer.exit_code == 1
    assert "differs: ego: x from step 3 on" in answer.output
    assert f"scenic 3.0.0 then, {now['scenic'][1]} now, numpy 1.0.0 then, {now['numpy'][1]} now" in answer.output
    told = json.loads(CliRunner().invoke(main, ["replay", str(folder), scene, "--json"]).output)
    assert told["versions"]["numpy"] == {"then": "1.0.0", "now": now["numpy"][1]}


def test_a_program_that_another_version_makes_otherwise_is_said_with_the_versions(folder: Path) -> None:
    program = next(folder.glob("programs/*.scenic"))
    program.write_text(program.read_text() + "\n")
    _with_other_versions(folder, chatscene="0.0.1")
    with pytest.raises(Diverged, match=r"chatscene 0\.0\.1 then"):
        rebuild(runs.Workspace(folder))


def test_an_identical_replay_under_other_versions_is_identical(folder: Path) -> None:
    _with_other_versions(folder, numpy="1.0.0")
    answer = CliRunner().invoke(main, ["replay", str(folder), _driven(folder)])
    assert answer.exit_code == 0
    assert answer.output.endswith("identical\n")


def test_what_a_run_was_made_with_and_nobody_knows_now_is_not_compared() -> None:
    record = runs.RunRecord.model_construct(versions={"abacus": "7"})
    assert runs.changed_versions(record) == {}


def test_a_run_is_not_replayed_on_a_map_that_was_changed_since(tmp_path: Path) -> None:
    town = tmp_path / "mine.xodr"
    town.write_bytes(resolve_map("town").read_bytes())
    run = runs.create(tmp_path / "run", runs.asked_run("a car", map_name=str(town)))
    assert map_of(runs.read_record(run)) == town
    town.write_text(town.read_text() + "<!-- wider -->")
    with pytest.raises(RunError, match="is not the file that the run was made on"):
        map_of(runs.read_record(run))


def test_the_map_of_a_run_is_found_from_any_folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    town = tmp_path / "mine.xodr"
    town.write_bytes(resolve_map("town").read_bytes())
    monkeypatch.chdir(tmp_path)
    run = runs.create(tmp_path / "run", runs.asked_run("a car", map_name="mine.xodr"))
    (tmp_path / "deep").mkdir()
    monkeypatch.chdir(tmp_path / "deep")
    assert map_of(runs.read_record(run)) == town
    town.rename("mine.xodr")  # the map went where it is looked for
    assert map_of(runs.read_record(run)).resolve() == tmp_path / "deep" / "mine.xodr"
