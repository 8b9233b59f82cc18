"""Folders that were written before, or later: a column more or less is no reason to refuse them."""

# pyright: reportUnknownLambdaType=false
# pyarrow ships no types

from __future__ import annotations

import json
import shutil
import tarfile
from pathlib import Path
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq
import pytest
from click.testing import CliRunner

import chatscene
from chatscene import runs
from chatscene.commands.main import main
from chatscene.errors import ForeignCodeRefused, RunError, SnippetError
from chatscene.library.load import load_library
from chatscene.report.index import index
from chatscene.report.sql import ask
from chatscene.report.viewer import write_report
from chatscene.runs import tables
from chatscene.runs.digests import digest_of
from chatscene.runs.rebuild import remade
from chatscene.runs.replay import replay
from chatscene.runs.workspace import RECORDS
from chatscene.view.looking import listed
from fake_run import finished, started

FIXTURES = Path(__file__).parents[1] / "fixtures"


def rewritten(run: runs.Workspace, name: str, change: Any) -> runs.Workspace:
    """A run with another table in it, sealed anew."""
    path = run.file(name)
    pq.write_table(change(pq.read_table(path, partitioning=None)), path, write_page_checksum=True)  # pyright: ignore[reportArgumentType]
    record = runs.read_record(run)
    runs.update(run, files=dict(record.files) | {name: digest_of(path)})
    return run


@pytest.mark.parametrize("lacking", ["time_headway", "crash_type", "light", "fault", "raw_duration"])
def test_a_table_of_before_a_column_is_read_with_what_held_then_or_null(lacking: str, tmp_path: Path) -> None:
    run = rewritten(finished(tmp_path / "run", count=2), "scenes.parquet", lambda table: table.drop_columns([lacking]))
    rows = runs.read_scenes(runs.open_run(run.path))
    assert {row[lacking] for row in rows if row["status"] == "ran"} == {"day" if lacking == "light" else None}
    assert index(tmp_path).left_out == ()


def test_a_measure_that_is_added_later_leaves_older_folders_readable(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = finished(tmp_path / "run", count=2)
    later = [*tables.SCENES, ("later_measure", pa.float64()), ("later_word", pa.string())]
    table = tables.read_table(run.file("scenes.parquet"), pa.schema(later))
    assert table.column("later_measure").null_count == table.column("later_word").null_count == table.num_rows > 0
    events = tables.read_table(run.file("events.parquet"), pa.schema([*tables.EVENTS, ("later", pa.bool_())]))
    assert events.column("later").null_count == events.num_rows


def test_a_table_of_a_later_version_keeps_numbers_and_leaves_out_what_else_it_has_more(tmp_path: Path) -> None:
    def more(table: Any) -> Any:
        number, word = pa.array([1.5] * table.num_rows), pa.array(["new"] * table.num_rows)
        return table.append_column("later_number", number).append_column("later_word", word)

    run = rewritten(finished(tmp_path / "run", count=2), "scenes.parquet", more)
    rewritten(run, "events.parquet", lambda table: table.append_column("w", pa.array(["x"] * table.num_rows)))
    rows = runs.read_scenes(runs.open_run(run.path))
    assert {row["later_number"] for row in rows} == {1.5}
    assert all("later_word" not in row for row in rows)
    assert index(tmp_path).left_out == ()


def test_scoring_with_a_number_that_was_not_measured_then_says_which(tmp_path: Path) -> None:
    run = rewritten(
        finished(tmp_path / "run", count=1), "scenes.parquet", lambda table: table.drop_columns(["raw_off_road"])
    )
    row = next(row for row in runs.read_scenes(run) if row["status"] == "ran")
    with pytest.raises(RunError, match=r"has no raw_off_road in scenes\.parquet, which was written before"):
        runs.measurements_of(row)


@pytest.mark.parametrize("needed", ["scene_id", "status", "dt"])
def test_a_table_without_what_no_drive_is_without_is_refused(needed: str, tmp_path: Path) -> None:
    run = rewritten(finished(tmp_path / "run", count=1), "scenes.parquet", lambda table: table.drop_columns([needed]))
    with pytest.raises(RunError, match="it has no column"):
        runs.read_scenes(run)


def spoilt(run: runs.Workspace, **told: Any) -> None:
    """A record that says something else, sealed anew."""
    import json

    from chatscene.runs.digests import write_sealed

    content = json.loads(run.file("run.json").read_text())
    del content["digest"]
    write_sealed(run.file("run.json"), content | told)


def test_a_bad_folder_is_a_row_that_says_so_and_the_others_are_shown(tmp_path: Path) -> None:
    finished(tmp_path / "good", count=1)
    spoilt(finished(tmp_path / "bad", count=1), egos=[])
    found = index(tmp_path)
    assert ask("SELECT run FROM runs", found).to_pylist() == [{"run": "good"}]
    (bad,) = found.left_out
    assert bad.folder == tmp_path / "bad"
    assert "egos: list should have at least 1 item" in bad.why


def test_whatever_goes_wrong_in_reading_a_folder_the_others_are_shown(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    finished(tmp_path / "good", count=1)
    finished(tmp_path / "other", count=1)
    real = runs.open_run

    def fails(folder: Path, of: type[runs.Record] = runs.Record) -> runs.Workspace:
        if folder.name == "other":
            raise KeyError("ran")
        return real(folder, of)

    monkeypatch.setattr(runs, "open_run", fails)
    found = index(tmp_path)
    assert ask("SELECT run FROM runs", found).to_pylist() == [{"run": "good"}]
    assert "it cannot be read (KeyError: 'ran')" in found.left_out[0].why


def test_a_small_file_that_unpacks_to_more_than_fits_is_refused_before_it_is_unpacked(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(tables, "_MOST_VALUES", 100_000)
    run = rewritten(
        finished(tmp_path / "run", count=1), "scenes.parquet", lambda table: pa.concat_tables([table] * 5000)
    )
    assert run.file("scenes.parquet").stat().st_size < 1_000_000
    monkeypatch.setattr(tables.pq, "read_table", None)  # whoever unpacks it fails
    with pytest.raises(RunError, match=r"it unpacks to [0-9,]+ rows, more than any work leaves"):
        tables.read_table(run.file("scenes.parquet"), tables.SCENES)


def test_a_record_whose_counts_lack_one_is_refused_by_name(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    spoilt(run, counts={"scenes": 1})
    with pytest.raises(RunError, match="counts: ran is missing"):
        runs.open_run(run.path)


@pytest.fixture(scope="module")
def kept(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folders of all seven kinds that chatscene 0.2 left, byte for byte."""
    folder = tmp_path_factory.mktemp("kept")
    with tarfile.open(FIXTURES / "folders-of-schema-3.tar.xz") as archive:
        archive.extractall(folder, filter="data")
    return folder


KINDS: dict[str, type[runs.Record]] = {
    "run": runs.RunRecord,
    "evaluation": runs.EvaluationRecord,
    "comparison": runs.ComparisonRecord,
    "benchmark": runs.BenchmarkRecord,
    "reproduction": runs.ReproductionRecord,
    "finetuning": runs.FinetuningRecord,
    "training": runs.TrainingRecord,
}


@pytest.mark.parametrize("name", KINDS)
def test_a_folder_of_each_kind_that_was_kept_is_whole(name: str, kept: Path) -> None:
    record = runs.read_record(runs.Workspace(kept / name), KINDS[name])
    assert record.status is runs.Status.DONE
    condition = runs.check(kept / name)
    assert condition.whole, condition


def test_every_kind_of_folder_was_kept() -> None:
    assert set(KINDS.values()) == set(RECORDS.values())


def test_a_run_that_was_kept_is_whole_and_has_its_scenes_tracks_and_choice(kept: Path) -> None:
    run = runs.open_run(kept / "run", runs.RunRecord)
    assert runs.check(kept / "run").whole
    rows = runs.read_scenes(run)
    assert [row["status"] for row in rows] == ["ran"] * 3
    for row in rows:
        assert len(runs.read_episode(run, row["scene_id"]).tracks) >= 2
        assert 0 <= runs.measurements_of(row).completion <= 1
        assert runs.metrics_of(row)
    scenario, choice = runs.read_choice(run)
    assert scenario.text == "the car ahead brakes hard"
    assert choice is not None
    assert runs.read_programs(run)


def test_an_evaluation_and_a_training_that_were_kept_are_read(kept: Path) -> None:
    evaluation = runs.open_run(kept / "evaluation", runs.EvaluationRecord)
    assert runs.check(kept / "evaluation").whole
    assert {row["ego"] for row in runs.read_scenes(evaluation)} == {"idm"}
    training = runs.read_record(runs.Workspace(kept / "training"), runs.TrainingRecord)
    assert training.curve
    tuned = runs.read_record(runs.Workspace(kept / "finetuning"), runs.FinetuningRecord)
    assert tuned.curve
    assert set(tuned.before) == set(tuned.after)


def test_the_folders_that_were_kept_are_listed_and_answer_queries(kept: Path) -> None:
    found = index(kept)
    assert found.left_out == ()
    assert {folder.relative_to(kept).parts[0] for folder in found.evaluations} == {
        "evaluation",
        "comparison",
        "benchmark",
        "reproduction",
    }
    listed = ask("SELECT run, ran FROM runs ORDER BY run", found).to_pylist()
    assert {"run": "run", "ran": 3} in listed
    assert {row["run"].split("/")[0] for row in listed} == {"run", "benchmark", "reproduction"}
    assert ask("SELECT count(*) AS n FROM scenes", found).to_pylist()[0]["n"] > 3


def test_a_run_that_was_kept_is_replayed_reported_and_measured_anew(kept: Path, tmp_path: Path) -> None:
    folder = tmp_path / "run"
    shutil.copytree(kept / "run", folder)
    best = chatscene.Run(folder).best
    assert best.replay().scene_id == best.id
    assert write_report(folder).is_file()
    measured = chatscene.evaluate(folder, ego="rule-based", folder=tmp_path / "evaluation")
    kept_ids = {row["scene_id"] for row in runs.read_scenes(runs.Workspace(folder)) if row["selected"]}
    assert {row["scene_id"] for row in runs.read_scenes(runs.Workspace(measured.folder))} == kept_ids != set()


@pytest.fixture(scope="module")
def composed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Folders of runs whose behaviors and second road users were composed, as no version does any more."""
    folder = tmp_path_factory.mktemp("composed")
    with tarfile.open(FIXTURES / "folders-with-composed.tar.xz") as archive:
        archive.extractall(folder, filter="data")
    return folder


@pytest.mark.parametrize("name", ["composed", "beside"])
def test_a_run_of_a_snippet_that_is_no_more_is_replayed_to_the_bit_from_the_program_that_it_kept(
    name: str, composed: Path
) -> None:
    folder = composed / name
    run = runs.open_run(folder, runs.RunRecord)
    _, choice = runs.read_choice(run)
    assert choice is not None
    with pytest.raises(SnippetError, match="there is no snippet"):
        [load_library().get(snippet_id) for snippet_id in choice.snippet_ids]
    for row in runs.read_scenes(run):
        assert replay(folder, row["scene_id"]).identical
    assert remade(run).simulator.identity.name == "confined"


def test_a_run_of_a_snippet_that_is_no_more_is_reported_measured_anew_and_exported_as_it_was_driven(
    composed: Path, tmp_path: Path
) -> None:
    folder = tmp_path / "run"
    shutil.copytree(composed / "composed", folder)
    assert "overtakes us and brakes" in write_report(folder).read_text()
    measured = chatscene.evaluate(folder, ego="rule-based", folder=tmp_path / "evaluation")
    assert runs.read_scenes(runs.Workspace(measured.folder))
    assert chatscene.export(folder, to="openscenario", out=tmp_path / "files")
    with pytest.raises(RunError, match="an export does not execute the program that the folder keeps"):
        chatscene.export(folder, to="openscenario-logical", out=tmp_path / "logical")


def test_a_kept_program_that_does_what_no_stranger_may_is_refused(composed: Path, tmp_path: Path) -> None:
    folder = tmp_path / "run"
    shutil.copytree(composed / "composed", folder)
    (program,) = (folder / "programs").iterdir()
    program.write_text(program.read_text() + "\nimport os\nos.system('true')\n")
    run = runs.Workspace(folder)
    name = program.relative_to(folder).as_posix()
    runs.update(run, files=dict(runs.read_record(run).files) | {name: digest_of(program)})
    with pytest.raises(ForeignCodeRefused, match="import"):
        replay(folder, runs.read_scenes(run)[0]["scene_id"])


def test_a_run_that_was_killed_is_told_at_once_and_one_at_work_is_not(tmp_path: Path) -> None:
    run = started(tmp_path / "run")
    (killed,) = index(tmp_path).left_out
    assert "was interrupted; continue with" in killed.why
    assert "not while another machine works on it" in killed.why
    with runs.alone(run.path):
        (working,) = index(tmp_path).left_out
    assert "is running, not done; finish it with" in working.why
    assert "another machine" not in working.why


def statuses(folder: Path) -> set[str]:
    """What is told of the one run below a folder: in the index that SQL asks, by the command, and in the page."""
    (told,) = json.loads(CliRunner().invoke(main, ["runs", str(folder), "--json"]).stdout)
    (row,) = index(folder).tables["runs"].to_pylist()
    (line,) = listed(folder)["runs"]
    return {row["status"], told["status"], line["status"]}


def test_the_status_of_a_run_that_was_killed_says_so_wherever_it_is_listed(tmp_path: Path) -> None:
    run = started(tmp_path / "run")
    with runs.alone(run.path):
        assert statuses(tmp_path) == {"running"}
    before = {path: path.stat().st_mtime_ns for path in (run.path, *run.path.rglob("*"))}
    assert statuses(tmp_path) == {"stopped"}
    assert {path: path.stat().st_mtime_ns for path in (run.path, *run.path.rglob("*"))} == before
    assert runs.read_record(run).status is runs.Status.RUNNING  # as it was left


def test_a_run_that_ends_while_it_is_listed_was_running(tmp_path: Path) -> None:
    run = started(tmp_path / "run")
    read = runs.read_record(run)
    runs.update(run, status=runs.Status.FAILED, reason="the disk is full")
    assert runs.standing(run, read) == "running"


def test_a_folder_of_which_nobody_can_tell_who_works_on_it_is_what_its_record_says(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = started(tmp_path / "run")
    monkeypatch.setattr("chatscene.runs.workspace.at_work", lambda _: None)  # as where folders cannot be locked
    assert runs.standing(run, runs.read_record(run)) == "running"
