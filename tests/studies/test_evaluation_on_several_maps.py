"""An evaluation of runs that lie on several maps: each scene is driven on its own."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from typing import Any

import pytest

from chatscene import pipeline, runs
from chatscene.errors import RunError
from chatscene.runs.executor import ONE, Workers
from chatscene.runs.record import EvaluationRecord
from chatscene.settings import SearchSettings, Settings, SimulationSettings
from chatscene.studies.evaluation import evaluate, resume
from plainly import BRAKES, STOPS

SETTINGS = Settings(
    search=SearchSettings(scenes=2, block=2, keep=2, routes=2), simulation=SimulationSettings(simulator="native")
)
LAID = "road:2+2,median=4"
EGOS = ["rule-based", "idm"]


def silent(_what: str, _done: int, _total: int) -> None:
    pass


@pytest.fixture(scope="module")
def searched(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A run on a packaged map, and one on a road that was laid to order."""
    folder = tmp_path_factory.mktemp("searched")
    for name, text, map_name in (("a", STOPS, "town"), ("b", BRAKES, LAID)):
        asked = runs.asked_run(text, settings=SETTINGS, ego="rule-based", map_name=map_name)
        pipeline.search(runs.create(folder / name, asked), ONE, silent)
    return folder


def content(folder: Path) -> dict[str, bytes]:
    """Every file but the record, which holds timings."""
    files = (path for path in sorted(folder.rglob("*")) if path.is_file() and path.name != "run.json")
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def record_of(folder: Path) -> EvaluationRecord:
    return runs.read_record(runs.open_run(folder), EvaluationRecord)


def test_each_source_keeps_its_own_map(searched: Path, tmp_path: Path) -> None:
    done = evaluate([searched], tmp_path / "e", egos=EGOS, progress=silent)
    asked = [runs.read_record(runs.Workspace(searched / name)) for name in "ab"]
    sources = record_of(done.folder).sources
    assert [source.map_name for source in sources] == ["town", LAID]
    assert [source.map_digest for source in sources] == [run.map_digest for run in asked]
    page = done.page.read_text()
    assert f"on map {LAID}" in page
    assert f"<dt>Maps</dt><dd>town, {LAID}</dd>" in page


def test_who_the_scenes_were_searched_against_drives_on_either_map_as_it_did_then(
    searched: Path, tmp_path: Path
) -> None:
    done = runs.Workspace(evaluate([searched], tmp_path / "e", egos=["rule-based"], progress=silent).folder)
    kept = [(runs.Workspace(searched / name), row) for name in "ab" for row in selected(searched / name)]
    assert {run.path.name for run, _ in kept} == {"a", "b"}
    for run, row in kept:
        then, now = (runs.read_episode(one, row["scene_id"]) for one in (run, done))
        assert [track.x.tobytes() for track in then.tracks] == [track.x.tobytes() for track in now.tracks]
        assert [track.y.tobytes() for track in then.tracks] == [track.y.tobytes() for track in now.tracks]


def selected(folder: Path) -> list[dict[str, Any]]:
    return list(runs.read_scenes(runs.Workspace(folder), selected=True))


def test_on_several_maps_one_process_two_and_a_kill_give_the_same_files(searched: Path, tmp_path: Path) -> None:
    def cut(_what: str, done: int, _total: int) -> None:
        if done == 3:
            raise KeyboardInterrupt

    one = evaluate([searched], tmp_path / "one", egos=EGOS, progress=silent)
    evaluate([searched], tmp_path / "two", egos=EGOS, workers=Workers(2), progress=silent)
    with pytest.raises(KeyboardInterrupt):
        evaluate([searched], tmp_path / "cut", egos=EGOS, progress=cut)
    assert len(runs.done_blocks(runs.Workspace(tmp_path / "cut"))) == 3
    resume(tmp_path / "cut")
    assert content(one.folder) == content(tmp_path / "two") == content(tmp_path / "cut")


def test_in_which_order_maps_come_changes_no_drive(searched: Path, tmp_path: Path) -> None:
    there = evaluate([searched / "a", searched / "b"], tmp_path / "there", egos=["idm"], progress=silent)
    back = evaluate([searched / "b", searched / "a"], tmp_path / "back", egos=["idm"], progress=silent)
    rows = [runs.read_scenes(runs.Workspace(one.folder)) for one in (there, back)]
    by_scene = [{row["scene_id"]: (row["distance"], row["impact_speed"]) for row in one} for one in rows]
    assert by_scene[0] == by_scene[1]
    assert len({row["scenario_id"] for row in rows[0]}) == 2


def test_a_source_of_before_has_no_map_of_its_own_and_lies_on_that_of_the_evaluation(
    searched: Path, tmp_path: Path
) -> None:
    def cut(_what: str, _done: int, _total: int) -> None:
        raise KeyboardInterrupt

    whole = evaluate([searched / "b"], tmp_path / "whole", egos=EGOS, progress=silent)
    with pytest.raises(KeyboardInterrupt):
        evaluate([searched / "b"], tmp_path / "before", egos=EGOS, progress=cut)
    before = record_of(tmp_path / "before").model_dump(mode="json")
    for source in before["sources"]:
        del source["map_name"], source["map_digest"]
    read = EvaluationRecord.model_validate(before)
    assert read.sources == record_of(tmp_path / "before").sources
    assert [(one.map_name, one.map_digest) for one in read.sources] == [(LAID, read.map_digest)]
    evaluate([searched / "b"], tmp_path / "before", egos=EGOS, progress=silent)
    assert content(tmp_path / "before") == content(whole.folder)


def test_a_map_that_is_another_file_by_now_is_told(searched: Path, tmp_path: Path) -> None:
    def cut(_what: str, _done: int, _total: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        evaluate([searched], tmp_path / "e", egos=["idm"], progress=cut)
    run = runs.Workspace(tmp_path / "e")
    first, second = record_of(run.path).sources
    runs.update(run, sources=[first, second.model_copy(update={"map_digest": "0" * 64})])
    with pytest.raises(RunError, match=re.escape(f"the map {LAID} is not the file that the run")):
        resume(run.path)


@pytest.mark.parametrize(
    ("second", "told"),
    [
        ({"physics": "lagged"}, "differ in physics (lagged and kinematic); name one for all, as with --physics kinem"),
        (
            {"dt": 0.05, "simulator": "embedded"},
            "differ in step [s] (0.05 and 0.1), simulator (embedded and native); name one for all, as with "
            "--simulator native; and repeat one run with the other's settings, or take each by itself",
        ),
        ({"occlusion": False}, "differ in occlusion (off and on); repeat one run with the other's settings"),
    ],
)
def test_what_keeps_runs_from_being_driven_together_is_told_with_both_values(
    searched: Path, tmp_path: Path, second: dict[str, object], told: str
) -> None:
    run = runs.Workspace(tmp_path / "runs" / "b")
    shutil.copytree(searched, tmp_path / "runs")
    settings = runs.read_record(run).settings
    runs.update(run, settings={**settings, "simulation": {**settings["simulation"], **second}})
    with pytest.raises(RunError) as caught:
        evaluate([tmp_path / "runs"], tmp_path / "e", egos=["idm"], progress=silent)
    assert told in str(caught.value)
    assert not (tmp_path / "e").exists()
