"""What run.json says: of each kind of folder, of older versions, and where another asks for something else."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import chatscene as api
from chatscene import runs
from chatscene.errors import RunError
from chatscene.runs.digests import write_sealed
from chatscene.runs.rebuild import rebuild
from chatscene.runs.record import RECORDS, upgraded
from fake_run import SCENARIO, TEXT, asked, finished, started


def as_of_schema_2(run: runs.Workspace, **told: Any) -> runs.Workspace:
    """A folder of a run as chatscene 0.1 left it: `run.json` had the ego as one text, and no kind."""
    path = run.file("run.json")
    content = json.loads(path.read_text()) | {"schema_version": 2, "command": "run", "ego": "rule-based", "seed": 7}
    for name in ("kind", "egos", "program", "digest"):
        del content[name]
    write_sealed(path, content | told)
    return run


def test_every_kind_has_a_record_and_its_name_in_the_file(tmp_path: Path) -> None:
    assert set(RECORDS) == set(runs.Kind)
    run = started(tmp_path / "run")
    content = json.loads(run.file("run.json").read_text())
    assert list(content)[:2] == ["schema_version", "kind"]
    assert (content["kind"], content["egos"]) == ("run", ["rule-based"])


def test_a_kind_that_nobody_knows_is_said(tmp_path: Path) -> None:
    run = started(tmp_path / "run")
    content = json.loads(run.file("run.json").read_text())
    del content["digest"]
    write_sealed(run.file("run.json"), content | {"kind": "opera"})
    with pytest.raises(RunError, match=r"not the record of a run: kind: 'opera'"):
        runs.open_run(run.path)


def test_a_run_of_schema_2_is_read_checked_and_gone_on_with(tmp_path: Path) -> None:
    run = as_of_schema_2(finished(tmp_path / "run", count=1))
    before = runs.read_scenes(runs.open_run(run.path, runs.RunRecord))
    record = runs.read_record(run)
    assert (record.text, record.egos, record.program, record.ego) == (TEXT, ["rule-based"], None, "rule-based")
    assert runs.check(run.path).whole
    assert runs.resume(run) == {}
    assert json.loads(run.file("run.json").read_text())["schema_version"] == 3
    assert runs.read_scenes(runs.open_run(run.path)) == before


def test_a_program_of_schema_2_was_in_its_text_and_is_joined_again_without_its_heading(tmp_path: Path) -> None:
    source = PROGRAM_OF_A_USER
    run = finished(tmp_path / "run", count=1, program=source, text=f"## program mine\n{source}")
    as_of_schema_2(run, generator="program")
    record = runs.read_record(run)
    assert record.program == runs.ProgramRecord(name="mine", source=source)
    assert (record.text, record.title) == ("", "mine")
    program = rebuild(run).program
    assert (program.scenario_id, program.source) == (SCENARIO, source)


@pytest.mark.parametrize(("text", "scenes"), [("all scenes", "every"), ("kept scenes", "kept")])
def test_the_egos_and_the_scenes_of_an_evaluation_of_schema_2_were_texts(text: str, scenes: str) -> None:
    told = {"schema_version": 2, "command": "evaluate", "ego": "sac,m:make", "text": text, "status": "done"}
    more = {"map_name": "town", "settings": {}, "seed": 0, "sources": [], "failures": {"m:make": "it fell over"}}
    record = runs.EvaluationRecord.model_validate(upgraded(told | more))
    assert (record.egos, record.scenes, record.schema_version) == (["sac", "m:make"], scenes, 3)
    assert record.failures == {"m:make": "it fell over"}


def test_who_asks_for_something_else_is_told_the_first_difference_then_and_now(tmp_path: Path) -> None:
    runs.create(tmp_path / "run", asked())
    assert runs.take_up(tmp_path / "run", asked()) == runs.Workspace(tmp_path / "run")
    with pytest.raises(RunError, match=r"a run with other settings: egos was \['rule-based'\] and is now \['sac'\]"):
        runs.take_up(tmp_path / "run", asked(egos=["sac"]))
    settings = asked().settings
    settings["search"]["scenes"] = 7
    with pytest.raises(RunError, match=r"settings\.search\.scenes was 50 and is now 7"):
        runs.take_up(tmp_path / "run", asked(settings=settings))


@pytest.mark.parametrize("name", ["benchmark.json", "finetune.json", "reproduce.json", "train.json"])
def test_a_folder_that_had_another_record_in_0_1_is_refused_with_the_version_that_goes_on(
    name: str, tmp_path: Path
) -> None:
    (tmp_path / name).write_text("{}")
    words = rf"made by chatscene 0\.1, which kept {name} in it .*go on with it by that version"
    for use in (api.resume, runs.check):
        with pytest.raises(RunError, match=words):
            use(tmp_path)
    with pytest.raises(RunError, match=words):
        runs.take_up(tmp_path, asked())


def test_a_folder_of_one_kind_is_not_gone_on_with_as_another(tmp_path: Path) -> None:
    training = runs.TrainingRecord(settings={"seed": 1}, map_digest="", simulator=runs.SimulatorRecord(), steps=5)
    folder = runs.create(tmp_path / "t", training).path
    with pytest.raises(RunError, match="holds a training, and this takes the folder of a run"):
        runs.take_up(folder, asked())
    with pytest.raises(RunError, match="holds a training, and this takes the folder of a run"):
        runs.open_run(folder, runs.RunRecord)


def test_what_may_be_another_the_next_time_is_what_was_asked_for_last(tmp_path: Path) -> None:
    training = runs.TrainingRecord(settings={"seed": 1}, map_digest="", simulator=runs.SimulatorRecord(), steps=5)
    run = runs.create(tmp_path / "t", training)
    runs.update(run, curve=[{"steps": 5.0}])
    runs.take_up(run.path, training.model_copy(update={"steps": 9}))
    record = runs.read_record(run, runs.TrainingRecord)
    assert (record.steps, record.curve) == (9, [{"steps": 5.0}])


PROGRAM_OF_A_USER = """model chatscene.world.model
param OPT_GEO_Y = Range(30, 55)
behavior AdvBehavior():
    do Halt()
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
AdvAgent = new Pedestrian at besideRoad(egoRoute, globalParameters.OPT_GEO_Y, "right", 1), with behavior AdvBehavior()
"""
