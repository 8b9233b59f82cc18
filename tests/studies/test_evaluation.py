"""Egos on kept scenes: the folder, the tables, egos that fail, kills, and the number of processes."""

from __future__ import annotations

import shutil
import signal
import sys
import time
import types
from dataclasses import replace
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import numpy as np
import pytest

import chatscene as api
from chatscene import pipeline, runs
from chatscene.errors import EgoError, RunError, SettingsError
from chatscene.measure import ordinary
from chatscene.measure.ordinary import OrdinaryDrive, OrdinaryResult, ordinary_table
from chatscene.program.ordinary import Course, ordinary_program, ordinary_queries
from chatscene.runs.executor import ONE, Workers
from chatscene.search.generator import load_generator
from chatscene.settings import PAPER, SearchSettings, Settings
from chatscene.studies import benchmark as benchmarks
from chatscene.studies import driving
from chatscene.studies.benchmark import Benchmarked, Budget, benchmark
from chatscene.studies.driving import drive
from chatscene.studies.evaluation import evaluate, read_drives, resume
from chatscene.terms.scenario import BaseScenario
from plainly import RUNS_RED, STOPS

TEXTS = (
    STOPS,
    RUNS_RED,
)
SETTINGS = Settings(search=SearchSettings(scenes=4, block=2, keep=2, routes=2))


def silent(_what: str, _done: int, _total: int) -> None:
    pass


@pytest.fixture(scope="module")
def searched(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Two finished runs."""
    folder = tmp_path_factory.mktemp("searched")
    for number, text in enumerate(TEXTS):
        run = runs.create(folder / str(number), runs.asked_run(text, settings=SETTINGS, ego="rule-based"))
        pipeline.search(run, ONE, silent)
    return folder


def content(folder: Path) -> dict[str, bytes]:
    """Every file but the record, which holds timings and paths."""
    files = (path for path in sorted(folder.rglob("*")) if path.is_file() and path.name != "run.json")
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def test_every_kept_scene_is_driven_by_every_ego(searched: Path, tmp_path: Path) -> None:
    evaluated = evaluate([searched], tmp_path / "e", egos=["rule-based", "idm"], progress=silent)
    rows = runs.read_scenes(runs.open_run(tmp_path / "e"))
    kept = [
        row["scene_id"]
        for number in range(2)
        for row in runs.read_scenes(runs.open_run(searched / str(number)))
        if row["selected"]
    ]
    assert len(kept) == 8
    assert sorted((row["scene_id"], row["ego"]) for row in rows) == sorted(
        (scene, ego) for scene in kept for ego in ("RuleBased", "idm")
    )
    assert not evaluated.failures
    for table in evaluated.tables.values():
        assert any(note.startswith("idm sees its route and the 6 nearest") for note in table.notes)
        assert any(note.startswith("rule-based sees its route and, of all others, only") for note in table.notes)
    by_ego = dict(evaluated.tables["collision-rate-by-ego"].rows)  # the scenes were searched against rule-based
    marked = {label: any(cell.by_selection for cell in row) for label, row in by_ego.items()}
    assert marked == {"rule-based, chatscene": True, "idm, chatscene": False}
    assert (tmp_path / "e" / "tables" / "generation.tex").is_file()


def test_where_every_scene_is_driven_nothing_is_by_selection(searched: Path, tmp_path: Path) -> None:
    evaluated = evaluate([searched / "0"], tmp_path / "e", egos=["rule-based"], every_scene=True, progress=silent)
    rows = evaluated.tables["collision-rate-by-ego"].rows
    assert not any(cell.by_selection for _, row in rows for cell in row)


def test_the_surrogate_drives_its_scenes_as_it_did_when_they_were_found(searched: Path, tmp_path: Path) -> None:
    evaluate([searched], tmp_path / "e", egos=["rule-based"], progress=silent)
    found = {row["scene_id"]: row for n in range(2) for row in runs.read_scenes(runs.open_run(searched / str(n)))}
    for row in runs.read_scenes(runs.open_run(tmp_path / "e")):
        before = found[row["scene_id"]]
        for name in ("collision", "impact_speed", "overall_score", "avoidable", "fault", "severity", "raw_yaw_rate"):
            assert row[name] == before[name], name


def test_one_process_and_two_give_the_same_files(searched: Path, tmp_path: Path) -> None:
    for jobs in (1, 2):
        evaluate([searched], tmp_path / str(jobs), egos=["rule-based", "idm"], workers=Workers(jobs), progress=silent)
    assert content(tmp_path / "1") == content(tmp_path / "2")


def test_egos_are_told_a_speed_that_the_runs_do_not_say(searched: Path, tmp_path: Path) -> None:
    folder = tmp_path / "fast"
    fast = evaluate([searched / "0"], folder, egos=["rule-based"], every_scene=True, speed=50.0, progress=silent)
    notes = fast.tables["fault"].notes
    assert notes[-1] == "Where no speed was said, egos were to drive at 50 km/h."
    assert runs.read_record(runs.Workspace(folder), runs.EvaluationRecord).speed == 50.0
    usual = tmp_path / "usual"
    evaluate([searched / "0"], usual, egos=["rule-based"], every_scene=True, progress=silent)
    assert content(folder) != content(usual)
    with pytest.raises(RunError, match=r"speed was 50\.0 and is now 60\.0"):
        evaluate([searched / "0"], folder, egos=["rule-based"], every_scene=True, speed=60.0, progress=silent)
    resume(folder, progress=silent)


def test_an_evaluation_that_was_cut_ends_like_one_that_was_not(searched: Path, tmp_path: Path) -> None:
    evaluate([searched], tmp_path / "whole", egos=["rule-based", "idm"], progress=silent)

    def cut(_what: str, done: int, _total: int) -> None:
        if done == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        evaluate([searched], tmp_path / "cut", egos=["rule-based", "idm"], progress=cut)
    cut_run = runs.open_run(tmp_path / "cut")
    assert runs.read_record(cut_run, runs.EvaluationRecord).status is runs.Status.RUNNING
    assert len(runs.done_blocks(cut_run)) == 3
    resume(cut_run.path)
    assert content(tmp_path / "cut") == content(tmp_path / "whole")


def test_an_evaluation_and_its_runs_can_be_moved_together_and_gone_on_with(searched: Path, tmp_path: Path) -> None:
    evaluate([searched], tmp_path / "whole", egos=["idm"], progress=silent)
    shutil.copytree(searched, tmp_path / "old" / "runs")

    def cut(_what: str, _done: int, _total: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        evaluate([tmp_path / "old" / "runs"], tmp_path / "old" / "cut", egos=["idm"], progress=cut)
    (tmp_path / "old").rename(tmp_path / "new")
    resume(tmp_path / "new" / "cut")
    assert content(tmp_path / "new" / "cut") == content(tmp_path / "whole")


def test_an_evaluation_of_before_knows_its_runs_by_absolute_paths_and_is_gone_on_with(
    searched: Path, tmp_path: Path
) -> None:
    def cut(_what: str, _done: int, _total: int) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        evaluate([searched], tmp_path / "before", egos=["idm"], progress=cut)
    run = runs.open_run(tmp_path / "before")
    sources = runs.read_record(run, runs.EvaluationRecord).sources
    absolute = [one.model_copy(update={"folder": str(one.path_from(run.path))}) for one in sources]
    assert {Path(one.folder) for one in absolute} == set(runs.run_folders([searched]))
    runs.update(run, sources=absolute)
    done = evaluate([searched], tmp_path / "before", egos=["idm"], progress=silent)
    assert runs.read_record(runs.open_run(done.folder), runs.EvaluationRecord).sources == absolute


class _Bad:
    """Egos that do what no ego may."""

    def crash(self, observation: Any) -> Any:
        raise ZeroDivisionError("no gradient")

    def nan(self, observation: Any) -> Any:
        return float("nan"), 0.0

    def shape(self, observation: Any) -> Any:
        return np.zeros(3)

    def text(self, observation: Any) -> Any:
        return "0.3", "0.0"

    def block(self, observation: Any) -> Any:
        signal.setitimer(signal.ITIMER_REAL, 0.01)  # the minutes that it may take have passed
        time.sleep(600)


@pytest.mark.parametrize(
    ("kind", "message"),
    [
        ("crash", "ZeroDivisionError: no gradient (tests/studies/test_evaluation.py, line "),
        ("nan", "acceleration and steering must be finite, not (nan, 0.0) (tests/studies/test_evaluation.py, line "),
        ("shape", "two finite numbers, not array([0., 0., 0.]) (tests/studies/test_evaluation.py, line "),
        ("text", "two finite numbers, not ('0.3', '0.0') ("),
        ("block", "gave no action at step 0 of scene '"),
    ],
)
def test_an_ego_that_fails_is_given_up_and_the_others_results_stand(
    kind: str, message: str, searched: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    module = types.ModuleType("bad_stack")

    def make() -> Any:
        ego = types.SimpleNamespace(act=getattr(_Bad(), kind), name=kind)
        return ego

    module.make = make  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "bad_stack", module)
    alone = evaluate([searched], tmp_path / "alone", egos=["idm"], progress=silent)
    both = evaluate([searched], tmp_path / "both", egos=["bad_stack:make", "idm"], progress=silent)
    assert list(both.failures) == ["bad_stack:make"]
    reason = both.failures["bad_stack:make"]
    assert reason.startswith(f"the ego {kind!r} ")
    assert "at step 0 of scene '" in reason
    assert message in reason
    assert both.tables["collision-rate-by-ego"].rows == alone.tables["collision-rate-by-ego"].rows
    record = runs.read_record(runs.open_run(tmp_path / "both"), runs.EvaluationRecord)
    assert record.failures == both.failures
    assert {row["ego"] for row in runs.read_scenes(runs.open_run(tmp_path / "both"))} == {"idm"}


def test_scenes_on_earlier_routes_can_be_left_out(searched: Path, tmp_path: Path) -> None:
    done = runs.open_run(evaluate([searched], tmp_path / "e", egos=["idm"], first_route=1, progress=silent).folder)
    drives = read_drives(done)
    assert drives
    assert {drive.route for drive in drives} == {1}


def test_what_cannot_be_evaluated_is_said(searched: Path, tmp_path: Path) -> None:
    with pytest.raises(RunError, match="there is no run in"):
        evaluate([tmp_path], tmp_path / "e", egos=["idm"], progress=silent)
    with pytest.raises(SettingsError, match="each ego once"):
        evaluate([searched], tmp_path / "e", egos=["idm", "idm"], progress=silent)
    with pytest.raises(EgoError, match="no ego 'idn'; did you mean 'idm'"):
        evaluate([searched], tmp_path / "e", egos=["idn"], progress=silent)
    unfinished = runs.create(tmp_path / "u", runs.asked_run(TEXTS[0], settings=SETTINGS, ego="idm"))
    with pytest.raises(RunError, match="was interrupted; continue with: chatscene resume"):
        evaluate([unfinished.path], tmp_path / "e", egos=["idm"], progress=silent)
    runs.update(unfinished, status=runs.Status.REFUSED, reason="the scene has no dragon")
    with pytest.raises(RunError, match="was refused and has no scenes: the scene has no dragon; say it in other words"):
        evaluate([unfinished.path], tmp_path / "e", egos=["idm"], progress=silent)
    assert not (tmp_path / "e").exists()


def test_the_papers_generator_has_five_texts_for_every_base_scenario() -> None:
    assert all(len(load_generator("chatscene").texts(base)) == 5 for base in BaseScenario)


@pytest.fixture
def tiny(monkeypatch: pytest.MonkeyPatch) -> None:
    """A budget that takes seconds."""
    budget = Budget(scenarios=1, search=replace(PAPER, scenes=2, block=1, keep=1, routes=1))
    monkeypatch.setitem(benchmarks.BUDGETS, "tiny", budget)


@pytest.mark.usefixtures("tiny")
def test_a_benchmark_is_the_same_at_one_and_two_jobs_and_after_a_cut(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    bases = (BaseScenario.STRAIGHT_OBSTACLE, BaseScenario.LANE_CHANGING)
    monkeypatch.setattr(benchmarks, "BaseScenario", bases)

    def run(name: str, jobs: int, progress: Any = silent) -> Any:
        return benchmark(
            tmp_path / name,
            budget="tiny",
            egos=["idm"],
            surrogate="rule-based",
            workers=Workers(jobs),
            progress=progress,
        )

    def cut(what: str, done: int, _total: int) -> None:
        if what.startswith("searching") and done == 1:
            raise KeyboardInterrupt

    one = run("one", 1)
    assert one.counts["ran"] == 4
    assert not one.refused
    assert [name for name, _ in one.evaluated.tables["collision-rate-by-ego"].rows] == ["idm, chatscene"]
    searched = runs.run_folders([tmp_path / "one" / "scenes"])
    assert all(runs.read_record(runs.Workspace(path)).timings["total"] >= 0.0 for path in searched)
    run("two", 2)
    with pytest.raises(KeyboardInterrupt):
        run("cut", 1, cut)
    began = [runs.read_record(runs.Workspace(path)).status for path in runs.run_folders([tmp_path / "cut"])]
    assert sorted(began) == [runs.Status.DONE, runs.Status.RUNNING]
    resumed = api.resume(tmp_path / "cut")
    assert isinstance(resumed, Benchmarked)
    assert resumed.counts == one.counts
    tables = [content(tmp_path / name / "evaluation") for name in ("one", "two", "cut")]
    assert tables[0] == tables[1] == tables[2]
    assert {path.name for path in (tmp_path / "one" / "scenes").iterdir()} == {base.value for base in bases}

    assert runs.check(tmp_path / "two").whole
    (tmp_path / "two" / "scenes" / "straight-obstacle" / "0" / "events.parquet").unlink()
    shutil.rmtree(tmp_path / "two" / "scenes" / "lane-changing")
    missing = runs.check(tmp_path / "two").missing
    assert missing == ("scenes/lane-changing/0/run.json", "scenes/straight-obstacle/0/events.parquet")


@pytest.mark.usefixtures("tiny")
def test_a_benchmark_folder_is_not_continued_with_other_settings(tmp_path: Path) -> None:
    settings = Settings(search=replace(benchmarks.BUDGETS["tiny"].search, seed=3))
    runs.create(
        tmp_path / "b",
        runs.asked_benchmark("chatscene", "tiny", egos=["idm"], surrogate="sac", settings=settings, map_name="town"),
    )
    with pytest.raises(RunError, match=r"a benchmark with other settings: settings\.search\.seed was 3 and is now 4"):
        benchmark(tmp_path / "b", budget="tiny", egos=["idm"], seed=4, progress=silent)
    (tmp_path / "c").mkdir()
    (tmp_path / "c" / "letter.txt").write_text("dear all")
    with pytest.raises(RunError, match="is not empty"):
        benchmark(tmp_path / "c", budget="tiny", progress=silent)
    with pytest.raises(SettingsError, match="no budget 'huge'"):
        benchmark(tmp_path / "d", budget="huge", progress=silent)


def test_an_ego_that_is_driven_leaves_a_table_and_a_picture(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    program = ordinary_program(ordinary_queries()[0])
    courses = tuple(Course(program=program, route=k % 2) for k in range(11))
    monkeypatch.setattr(ordinary, "ordinary_courses", Mock(return_value=courses))
    table = drive(["idm", "rule-based"], folder=tmp_path, scenes=1, progress=silent).table
    assert [name for name, _ in table.rows] == ["idm", "rule-based"]
    completion = table.rows[0][1][0].value
    assert completion is not None
    assert completion > 0.9
    assert (tmp_path / "ordinary.md").is_file()
    assert (tmp_path / "idm.gif").read_bytes().startswith(b"GIF89a")


def test_egos_of_one_name_keep_their_rows_and_pictures_and_one_that_fails_loses_only_its_own(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    course = Course(program=ordinary_program(ordinary_queries()[0]), route=0)
    monkeypatch.setattr(ordinary, "ordinary_courses", Mock(return_value=(course,)))
    monkeypatch.setattr(driving, "SHOWN", 0)
    weights = Path(runs.__file__).parents[1] / "ego" / "weights" / "sac.npz"
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        shutil.copy(weights, tmp_path / folder / "policy.npz")
    module = types.ModuleType("bad_stack")
    module.make = lambda: types.SimpleNamespace(act=_Bad().crash, name="../../evil")  # type: ignore[attr-defined]
    monkeypatch.setitem(sys.modules, "bad_stack", module)
    monkeypatch.chdir(tmp_path)
    egos = ["a/policy.npz", "bad_stack:make", "b/policy.npz"]
    done = drive(egos, folder=tmp_path / "out", scenes=1, progress=silent)
    assert [name for name, _ in done.table.rows] == ["a/policy.npz", "b/policy.npz"]
    assert list(done.failures) == ["bad_stack:make"]
    assert "ZeroDivisionError: no gradient" in done.failures["bad_stack:make"]
    assert {one.name for one in (tmp_path / "out").glob("*.gif")} == {"a-policy-npz.gif", "b-policy-npz.gif"}
    with pytest.raises(SettingsError, match="each ego once"):
        drive(["idm", "idm"], progress=silent)
    with pytest.raises(EgoError, match="no gradient"):
        drive(["bad_stack:make"], scenes=1, progress=silent)


def test_the_picture_of_an_ego_lies_in_the_folder_of_its_drives() -> None:
    egos = ["../../evil", "evil", "a/b.npz", "a-b-npz", "é", "x" * 300, "m:<script>|\n"]
    names = driving.picture_names(egos)
    assert names[:5] == ["evil.gif", "evil.2.gif", "a-b-npz.gif", "a-b-npz.2.gif", "ego.gif"]
    assert len(set(names)) == len(names)
    assert all(Path(name).name == name and len(name) < 120 for name in names)


def test_ordinary_drives_make_a_table_with_intervals() -> None:
    drives = [
        OrdinaryDrive(
            course=k // 2, completion=k / 11, speed=4.0 + k, off_road=0.0, collided=k == 3, ran_red=k in (4, 5)
        )
        for k in range(12)
    ]
    table = ordinary_table([OrdinaryResult(ego="sac", drives=tuple(drives), rejected=0)])
    ((name, (completion, rate, off_road, red, speed)),) = table.rows
    assert name == "sac"
    assert completion.value == pytest.approx(0.5)
    assert rate.value == pytest.approx(1 / 12)
    assert red.value == pytest.approx(2 / 12)
    assert speed.value == pytest.approx(9.5)
    assert off_road.value == 0.0
    for cell in (completion, rate, red, speed):
        assert cell.low is not None
        assert cell.high is not None
        assert cell.low < cell.value < cell.high  # type: ignore[operator] # pyright: ignore[reportOperatorIssue]
    assert "12 drives per ego on 6 courses." in table.notes


def test_two_runs_of_one_sentence_are_not_taken_for_one(searched: Path, tmp_path: Path) -> None:
    shutil.copytree(searched / "0", tmp_path / "again")
    with pytest.raises(RunError, match="one and the same sentence"):
        evaluate([searched / "0", tmp_path / "again"], tmp_path / "e", egos=["idm"], progress=silent)


def test_a_comma_in_the_name_of_an_ego_parts_nothing(searched: Path, tmp_path: Path) -> None:
    ego = str(shutil.copy(Path(runs.__file__).parents[1] / "ego" / "weights" / "sac.npz", tmp_path / "a,b.npz"))
    folder = evaluate([searched / "0"], tmp_path / "e", egos=[ego], progress=silent).folder
    assert runs.read_record(runs.open_run(folder), runs.EvaluationRecord).egos == [ego]
