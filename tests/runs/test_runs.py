from __future__ import annotations

import errno
import json
import os
import signal
import subprocess
import sys
import time
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pyarrow.parquet as pq
import pytest
from hypothesis import given
from hypothesis import strategies as st

from chatscene.errors import RunError, SettingsError
from chatscene.runs import (
    SCHEMA_VERSION,
    Status,
    Workspace,
    create,
    finish,
    metrics_of,
    open_run,
    read_counts,
    read_drawing,
    read_episode,
    read_episodes,
    read_events,
    read_explanation,
    read_programs,
    read_ranges,
    read_record,
    read_scenes,
    resume,
    settings_of,
    take_up,
    update,
    write_block,
)
from chatscene.search.explore import outcomes
from chatscene.settings import SearchSettings, Settings
from chatscene.terms.episode import Ending, Episode, Event, EventKind
from fake_run import DECLARED, SCENARIO, TEXT, asked, blocks, drive, finished, scene, selection, started
from places import TESTS

CONTRACT = {
    "scenes.parquet": "scene_id scenario_id route_id block seed status reason meaning_ok meaning_failures collision "
    "impact_speed severity fault avoidable overall_score selected",
    "episodes": "scene_id ego step time actor role kind x y heading speed acceleration yaw_rate length width",
    "events.parquet": "scene_id ego step kind actor other",
}


def _contents(folder: Path) -> dict[str, bytes]:
    """Every file but `run.json`, which holds the timings."""
    files = (path for path in sorted(folder.rglob("*")) if path.is_file() and path.name != "run.json")
    return {str(path.relative_to(folder)): path.read_bytes() for path in files}


def _same(a: Episode, b: Episode) -> bool:
    tracks = all(
        (s.actor, s.role, s.kind, s.length, s.width) == (t.actor, t.role, t.kind, t.length, t.width)
        and all(np.array_equal(getattr(s, n), getattr(t, n)) for n in ("x", "y", "heading", "speed"))
        for s, t in zip(a.tracks, b.tracks, strict=True)
    )
    signals = [(s.x0, s.y0, s.x1, s.y1, s.state, s.role) for s in a.signals]
    return (
        tracks
        and signals == [(s.x0, s.y0, s.x1, s.y1, s.state, s.role) for s in b.signals]
        and (a.scene_id, a.ego, a.dt, a.events, a.ending) == (b.scene_id, b.ego, b.dt, b.events, b.ending)
        and a.route_completion == b.route_completion
        and np.array_equal(a.distance_to_route, b.distance_to_route)
        and np.array_equal(a.off_road, b.off_road)
    )


def test_an_episode_reads_back_bit_for_bit_before_and_after_the_run_is_finished(tmp_path: Path) -> None:
    run, done = started(tmp_path / "run"), blocks(2)
    for block in done:
        write_block(run, block)
    driven = [ran.episode for block in done for ran in block.ran]
    ids = [episode.scene_id for episode in driven]
    assert all(map(_same, driven, read_episodes(run, ids)))
    finish(run, selected=selection(done), expected=())
    assert all(map(_same, driven, read_episodes(run, ids)))


def test_the_tables_have_the_columns_of_the_contract(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    for name, columns in CONTRACT.items():
        path = next(run.file(name).glob("*.parquet")) if name == "episodes" else run.file(name)
        present = pq.read_schema(path).names
        assert [column for column in present if column in columns.split()] == columns.split()
    assert {p.name for p in DECLARED} < set(pq.read_schema(run.file("scenes.parquet")).names)


def test_every_scene_is_a_row_and_a_rejected_one_says_why(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=2)
    rows = read_scenes(run)
    assert [row["status"] for row in rows].count("ran") == 20
    rejected = [row for row in rows if row["status"] == "rejected"]
    assert {row["reason"] for row in rejected} == {"bus-stop overlaps adversary"}
    assert all(row["collision"] is None and row["OPT_GEO_Y"] > 0 and not metrics_of(row) for row in rejected)
    assert sum(row["selected"] for row in rows) == 2
    assert set(metrics_of(rows[0])) >= {"cr", "comp", "overall_score"}
    assert read_record(run).counts["rejected"] == 2


def test_kept_scenes_that_show_what_was_said_are_counted(tmp_path: Path) -> None:
    run, done = started(tmp_path / "run"), blocks(1)
    ids = [ran.scene.id for ran in done[0].ran]
    like = replace(done[0].ran[0], meaning=())
    unlike = replace(done[0].ran[1], meaning=("action: said stop, but the adversary never does",))
    write_block(run, replace(done[0], ran=(like, unlike, *done[0].ran[2:])))
    finish(run, selected={ids[0]: False, ids[1]: False}, expected=[(SCENARIO, 0, 0)])
    counts = read_record(run).counts
    assert (counts["selected"], counts["selected_shown"]) == (2, 1)


def test_drives_off_the_road_out_of_time_and_waiting_are_counted(tmp_path: Path) -> None:
    run, done = started(tmp_path / "run"), blocks(1)
    first, second = done[0].ran[:2]
    left = (Event(kind=EventKind.OFF_ROAD, step=3), Event(kind=EventKind.OFF_ROAD, step=9))
    off = replace(first, episode=replace(first.episode, events=left, ending=Ending.ARRIVED))
    late = replace(second, episode=replace(second.episode, events=(), ending=Ending.TIMEOUT), waits=True)
    write_block(run, replace(done[0], ran=(off, late)))
    finish(run, selected={}, expected=[(SCENARIO, 0, 0)])
    counts = read_record(run).counts
    assert (counts["off_road"], counts["timeout"], counts["waiting"]) == (1, 1, 1)
    assert read_counts(run) == counts
    update(
        run, counts={name: counts[name] for name in ("scenes", "ran", "rejected", "collided", "selected", "fill_in")}
    )
    of_before = read_counts(run)  # as an older version left it
    assert (of_before["off_road"], of_before["timeout"]) == (1, 1)
    assert "waiting" not in of_before


def test_events_and_ranges_are_kept(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=3)
    crashes = [row for row in read_events(run) if row["kind"] == "collision"]
    assert crashes
    assert {(row["actor"], row["other"], row["side"]) for row in crashes} == {("ego", "adversary", "front")}
    assert len(crashes) == sum(bool(row["collision"]) for row in read_scenes(run))
    first = [row for row in read_ranges(run) if row["block"] == 0]
    assert [(row["parameter"], row["low"], row["high"]) for row in first] == [(p.name, p.low, p.high) for p in DECLARED]


def test_the_same_blocks_in_any_order_give_the_same_bytes(tmp_path: Path) -> None:
    done = blocks(3) + blocks(2, route=1)
    folders = tmp_path / "forward", tmp_path / "backward"
    for folder, order in zip(folders, (done, done[::-1]), strict=True):
        run = started(folder)
        for block in order:
            write_block(run, block)
        finish(run, selected=selection(done), expected=())
    assert _contents(folders[0]) == _contents(folders[1])


def test_a_run_stopped_after_two_blocks_ends_like_one_that_was_not(tmp_path: Path) -> None:
    done = blocks(4)
    whole, stopped = started(tmp_path / "whole"), started(tmp_path / "stopped")
    for block in done:
        write_block(whole, block)
    for block in done[:2]:
        write_block(stopped, block)
    again = open_run(tmp_path / "stopped")
    before = resume(again)[SCENARIO, 0]
    assert before == [outcomes(block) for block in done[:2]]
    for block in done[len(before) :]:
        write_block(again, block)
    for run in (whole, again):
        finish(run, selected=selection(done), expected=())
    assert _contents(whole.path) == _contents(again.path)


def test_resume_counts_blocks_only_up_to_the_first_gap(tmp_path: Path) -> None:
    run, done = started(tmp_path / "run"), blocks(4)
    for block in (done[0], done[1], done[3]):
        write_block(run, block)
    assert len(resume(run)[SCENARIO, 0]) == 2


def test_a_block_whose_part_was_never_written_is_not_done(tmp_path: Path) -> None:
    run, (block,) = started(tmp_path / "run"), blocks(1)
    write_block(run, block)
    run.part(SCENARIO, 0, 0).unlink()
    assert resume(run) == {}
    assert read_scenes(run) == []


def test_half_written_files_are_swept_away_and_never_read(tmp_path: Path) -> None:
    run, done = started(tmp_path / "run"), blocks(1)
    write_block(run, done[0])
    for folder in ("parts", "episodes"):
        (run.file(folder) / ".x-route-00-block-01.parquet.77.tmp").write_bytes(b"PAR1 half")
    assert len(resume(run)[SCENARIO, 0]) == 1
    finish(run, selected=selection(done), expected=())
    assert not list(run.path.rglob("*.tmp"))


WRITER = """
import itertools, sys
from dataclasses import asdict, replace
from pathlib import Path
from fake_run import blocks, started
from chatscene.runs import write_block
run, (block,) = started(Path(sys.argv[1])), blocks(1)
for number in itertools.count():
    write_block(run, replace(block, number=number))
"""


@pytest.mark.skipif(os.name != "posix", reason="SIGKILL is POSIX")
def test_a_killed_writer_leaves_only_whole_blocks(tmp_path: Path) -> None:
    folder = tmp_path / "run"
    path = os.pathsep.join([str(TESTS), *sys.path])
    writer = subprocess.Popen([sys.executable, "-c", WRITER, str(folder)], env={**os.environ, "PYTHONPATH": path})
    while len(list(folder.glob("parts/*.json"))) < 5 and writer.poll() is None:
        time.sleep(0.002)
    writer.send_signal(signal.SIGKILL)
    writer.wait()
    run = open_run(folder)
    done = resume(run)[SCENARIO, 0]
    assert len(done) >= 5
    assert all(pq.read_table(run.episodes(SCENARIO, 0, n)).num_rows > 0 for n in range(len(done)))
    assert finish(run, selected={}, expected=()).status is Status.DONE


def test_finish_can_be_killed_at_each_file_and_called_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    expected = _contents(finished(tmp_path / "whole", count=2).path)
    done = blocks(2)
    run = started(tmp_path / "run")
    for block in done:
        write_block(run, block)
    rename = Path.replace
    for name in ("signals.parquet", "scenes.parquet", "run.json"):

        def fail(self: Path, target: Path, name: str = name) -> Path:
            if target.name == name:
                raise KeyboardInterrupt
            return rename(self, target)

        with monkeypatch.context() as patch:
            patch.setattr(Path, "replace", fail)
            with pytest.raises(KeyboardInterrupt):
                finish(run, selected=selection(done), expected=())
        assert len(resume(run)[SCENARIO, 0]) == 2
    finish(run, selected=selection(done), expected=())
    finish(run, selected={}, expected=())  # done is done
    assert _contents(run.path) == expected


def test_a_full_disk_is_one_clear_message_and_loses_only_the_block_in_progress(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run, done = started(tmp_path / "run"), blocks(2)
    write_block(run, done[0])

    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(Path, "replace", full)
        with pytest.raises(RunError, match=r"the disk is full; free some space and continue with: chatscene resume"):
            write_block(run, done[1])
    assert len(resume(run)[SCENARIO, 0]) == 1
    assert not list(run.path.rglob("*.tmp"))


@pytest.mark.parametrize(
    ("number", "words"),
    [(errno.EROFS, "read-only"), (errno.EACCES, "permission denied"), (errno.EIO, "choose another")],
)
def test_a_folder_that_cannot_be_written_is_one_clear_message(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, number: int, words: str
) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(Path, "mkdir", refuse)
    with pytest.raises(RunError, match=rf"cannot write .*{words}"):
        started(tmp_path / "run")


def test_a_path_through_a_file_is_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(RunError, match="a file"):
        started(tmp_path / "file" / "run")
    with pytest.raises(RunError, match="a file"):
        started(tmp_path / "file")


def test_a_new_run_never_writes_into_a_folder_that_holds_something(tmp_path: Path) -> None:
    (tmp_path / "thesis.tex").write_text("precious")
    with pytest.raises(RunError, match="not empty"):
        started(tmp_path)
    run = started(tmp_path / "run")
    with pytest.raises(RunError, match="not empty"):
        started(run.path)
    with pytest.raises(RunError, match=r"holds a run with other settings.*To continue that run: chatscene resume"):
        take_up(run.path, asked(text="another"))


def test_a_new_run_may_start_where_one_was_killed_before_it_began(tmp_path: Path) -> None:
    (tmp_path / ".run.json.41.tmp").write_text("{")
    assert read_record(started(tmp_path)).status is Status.RUNNING
    assert not list(tmp_path.glob(".*"))


def _spoil(run: Workspace, **changes: object) -> None:
    path = run.file("run.json")
    path.write_text(json.dumps(json.loads(path.read_text()) | changes))


def test_a_folder_that_is_no_run_or_a_broken_one_is_said_to_be_so(tmp_path: Path) -> None:
    with pytest.raises(RunError, match=r"not a run folder.*chatscene run"):
        open_run(tmp_path)
    run = started(tmp_path / "run")
    _spoil(run, schema_version=SCHEMA_VERSION + 1)
    with pytest.raises(RunError, match=r"newer chatscene .*newer checkout .*newer wheel"):
        open_run(run.path)
    _spoil(run, schema_version=SCHEMA_VERSION, status="sleeping")
    with pytest.raises(RunError, match="status"):
        open_run(run.path)
    for text in ("[]", '{"schema_version": 1', ""):
        run.file("run.json").write_text(text)
        with pytest.raises(RunError, match=r"run\.json"):
            open_run(run.path)


def test_a_scene_that_is_not_there_or_was_never_driven_cannot_be_read(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    with pytest.raises(RunError, match="no scene 'x'"):
        read_episode(run, "x")
    rejected = next(row["scene_id"] for row in read_scenes(run) if row["status"] == "rejected")
    with pytest.raises(RunError, match="bus-stop overlaps adversary"):
        read_episode(run, rejected)


def test_a_missing_table_is_named(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    run.file("scenes.parquet").unlink()
    with pytest.raises(RunError, match=r"scenes\.parquet"):
        read_scenes(run)


def test_what_a_run_was_started_with_is_what_it_continues_with(tmp_path: Path) -> None:
    settings = Settings(search=SearchSettings(scenes=7, seed=3))
    run = create(tmp_path / "run", asked(settings=asdict(settings), map_name="a.xodr", egos=["m:f"]))
    record = read_record(open_run(run.path))
    assert settings_of(record) == settings
    assert (record.text, record.map_name, record.ego) == (TEXT, "a.xodr", "m:f")
    assert set(record.versions) == {"chatscene", "python", "scenic", "numpy", "shapely", "platform"}
    _spoil(run, settings={"search": {"phase_of_the_moon": 1}})
    with pytest.raises(SettingsError, match="phase_of_the_moon"):
        settings_of(read_record(run))


def test_a_report_that_fails_after_the_search_does_not_undo_it(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    before, scenes = _contents(run.path), read_scenes(run)
    update(run, status=Status.FAILED, reason="no room for the report")
    assert read_scenes(run) == scenes
    assert resume(run) == {}
    assert read_record(run).status is Status.DONE
    assert _contents(run.path) == before


def test_seconds_add_up_over_a_resumed_run_and_a_failure_is_forgotten(tmp_path: Path) -> None:
    run = started(tmp_path / "run")
    update(run, status=Status.FAILED, reason="no more coffee", timings={"search": 1.5})
    assert read_record(run).reason == "no more coffee"
    resume(run)
    finish(run, selected={}, expected=())
    record = update(run, timings={"search": 2.0, "report": 1.0})
    assert (record.status, record.reason, record.timings) == (Status.DONE, "", {"search": 3.5, "report": 1.0})


def test_programs_explanation_and_drawing_read_back(tmp_path: Path) -> None:
    run = started(tmp_path / "run")
    assert "behavior AdvBehavior" in read_programs(run)[SCENARIO]
    (understood,) = read_explanation(run)["scenarios"]
    assert understood["slots"]["actions"] == ["cross", "stop"]
    assert understood["chosen"]["spawn"] == "spawn/behind-bus-stop-right"
    assert understood["candidates"]["behavior"][1]["conflicts"]
    assert read_drawing(run)["roads"]


@given(name=st.text(min_size=1, max_size=30))
def test_no_scenario_can_name_a_file_outside_the_folder(name: str) -> None:
    run = Workspace(Path("/run"))
    for path in (run.episodes(name.replace("\0", ""), 0, 0), run.part(name.replace("\0", ""), 0, 0)):
        assert Path(os.path.normpath(path)).parent.parent == run.path


def test_a_drive_without_other_actors_or_signals_reads_back(tmp_path: Path) -> None:
    run, (block,) = started(tmp_path / "run"), blocks(1)
    lonely = drive(scene(0, dict(block.ran[0].scene.values)))
    lonely = replace(lonely, tracks=lonely.tracks[:1], signals=(), events=())
    write_block(run, replace(block, ran=(replace(block.ran[0], episode=lonely),), rejected=()))
    assert _same(read_episode(run, lonely.scene_id), lonely)


def test_a_block_in_which_nothing_could_be_placed_is_kept(tmp_path: Path) -> None:
    run, (block,) = started(tmp_path / "run"), blocks(1)
    write_block(run, replace(block, ran=()))
    assert resume(run)[SCENARIO, 0] == [[]]
    finish(run, selected={}, expected=())
    assert read_record(run).counts["rejected"] == 1


@pytest.mark.parametrize("content", ["[]", "5", "null"])
def test_a_file_that_holds_no_object_is_one_message(content: str, tmp_path: Path) -> None:
    (tmp_path / "run.json").write_text(content)
    with pytest.raises(RunError, match="holds no JSON object"):
        open_run(tmp_path)


def test_a_finished_run_has_waited_for_the_disk_of_every_table_and_the_blocks_before_for_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run, done = started(tmp_path / "run"), blocks(2)
    waited: list[int] = []

    def sync(handle: int) -> None:
        waited.append(os.fstat(handle).st_ino)

    monkeypatch.setattr(os, "fsync", sync)
    for block in done:
        write_block(run, block)
    assert not waited
    finish(run, selected={}, expected=[(SCENARIO, 0, 0), (SCENARIO, 0, 1)])
    tables = [path.stat().st_ino for path in run.path.rglob("*.parquet")]
    folders = [folder.stat().st_ino for folder in (run.path, run.path / "episodes")]
    assert len(tables) == 6
    assert {*tables, *folders} <= set(waited)
    assert max(map(waited.index, tables)) < waited.index(run.file("run.json").stat().st_ino)
