"""Runs of many scenes: folded, and read for a page, some at a time."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pyarrow.parquet as pq
import pytest

from chatscene import Run
from chatscene.errors import QueryError
from chatscene.report import viewer
from chatscene.report.how_fast import how_fast
from chatscene.report.index import index
from chatscene.report.sql import ask
from chatscene.report.viewer import best, ranked, write_report
from chatscene.report.what_happened import kept_in_words
from chatscene.runs import (
    Workspace,
    blocks,
    each_scene,
    read_counts,
    read_episodes,
    read_events,
    read_record,
    read_scenes,
)
from chatscene.search.sampler import looks_back
from fake_run import finished


@pytest.mark.parametrize("at_once", [1, 25, 1000])
def test_a_run_is_folded_into_the_same_rows_however_many_at_a_time(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, at_once: int
) -> None:
    whole = finished(tmp_path / "whole", routes=2)
    monkeypatch.setattr(blocks, "AT_ONCE", at_once)
    parted = finished(tmp_path / "parted", routes=2)
    for name in ("scenes", "events", "signals", "ranges"):
        one, other = (run.file(f"{name}.parquet") for run in (whole, parted))
        assert pq.read_table(one).equals(pq.read_table(other))
        assert at_once < 1000 or one.read_bytes() == other.read_bytes()
    told = read_record(whole).model_dump(include={"counts", "stepped", "instead", "unplayed"})
    assert read_record(parted).model_dump(include={"counts", "stepped", "instead", "unplayed"}) == told


def test_of_a_large_run_a_page_shows_what_was_kept_and_others_evenly(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    run = finished(tmp_path / "run", routes=2)
    every = read_scenes(run)
    assert read_scenes(run, some=True) == every
    assert "This page is made of" not in write_report(run.path).read_text(encoding="utf-8")
    monkeypatch.setattr(blocks, "ON_A_PAGE", -(-len(every) // 4))
    some = read_scenes(run, some=True)
    assert some == [row for number, row in enumerate(every) if number % 4 == 0 or row["selected"]]
    page = write_report(run.path).read_text(encoding="utf-8")
    assert f"This page is made of {len(some)} of {read_counts(run)['scenes']} scenes" in page
    assert read_scenes(run, selected=True) == [row for row in every if row["selected"]]


@pytest.fixture
def parted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Workspace:
    """A run whose tables have several parts."""
    monkeypatch.setattr(blocks, "AT_ONCE", 5)
    run = finished(tmp_path / "parted", routes=2)
    assert pq.ParquetFile(run.file("scenes.parquet")).num_row_groups > 2
    return run


def test_some_scenes_of_a_large_run_are_those_of_all(parted: Workspace) -> None:
    every, events = read_scenes(parted), read_events(parted)
    wanted = [row["scene_id"] for row in every if row["status"] == "ran"][::-3]
    assert read_scenes(parted, ids=wanted) == [row for row in every if row["scene_id"] in wanted]
    assert read_events(parted, wanted) == [row for row in events if row["scene_id"] in wanted]
    assert read_scenes(parted, ids=["none"]) == []
    assert [one.scene_id for one in read_episodes(parted, wanted)] == wanted
    names = ("overall_score", "scene_id", "seed")
    assert list(each_scene(parted, names)) == [{name: row[name] for name in names} for row in every]


def test_the_best_scene_is_found_without_reading_all(parted: Workspace, monkeypatch: pytest.MonkeyPatch) -> None:
    every = ranked(read_scenes(parted))
    assert best(parted) == every[0]
    chosen = read_scenes

    def none_kept(run: Workspace, *, selected: bool = False, ids: list[str] | None = None) -> list[dict[str, Any]]:
        return [] if selected else chosen(run, ids=ids)

    monkeypatch.setattr(viewer, "read_scenes", none_kept)
    assert best(parted) == every[0]


def test_a_run_in_python_says_the_same_of_few_and_of_many(parted: Workspace) -> None:
    run, every = Run(parted.path), read_scenes(parted)
    assert run.scenes.to_pylist() == every
    assert [scene.row for scene in run.kept] == [row for row in ranked(every) if row["selected"]]
    assert run.best.row == ranked(every)[0]
    assert run.scene(run.kept[-1].id).row == run.kept[-1].row
    assert run.summary.fast == how_fast(every)
    assert run.summary.kept == kept_in_words(every)


@pytest.mark.parametrize(
    "query",
    [
        "SELECT * FROM scenes ORDER BY run, scene_id",
        "SELECT * FROM parameters ORDER BY run, scene_id, name",
        "SELECT * FROM events ORDER BY run, scene_id, step, kind",
        "SELECT * FROM runs ORDER BY run",
        "SELECT * FROM facts ORDER BY run",
        "SELECT run, count(*), sum(collision::INT), avg(overall_score) FROM scenes GROUP BY run ORDER BY run",
        "SELECT name, count(*), max(value) FROM scenes JOIN parameters USING (run, scene_id) GROUP BY 1 ORDER BY 1",
    ],
)
def test_sql_answers_the_same_of_a_large_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, query: str) -> None:
    pytest.importorskip("duckdb")
    finished(tmp_path / "it's small", routes=1)
    finished(tmp_path / "large", routes=2)
    whole = index(tmp_path)
    monkeypatch.setattr("chatscene.report.index.LARGE", whole.tables["runs"].column("scenes").to_pylist()[0])
    parted = index(tmp_path)
    assert [one.run for one in parted.large] == ["large"]
    assert ask(query, parted).equals(ask(query, whole))
    assert {run: list(rows) for run, rows in parted.scenes(["scene_id", "fault"]).items()} == whole.scenes(
        ["scene_id", "fault"]
    )


def test_sql_over_a_large_run_reads_no_other_file(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pytest.importorskip("duckdb")
    run, other = finished(tmp_path / "run"), finished(tmp_path / "other")
    monkeypatch.setattr("chatscene.report.index.LARGE", 0)
    for query in (
        f"SELECT * FROM read_parquet('{run.file('scenes.parquet')}')",
        f"SELECT * FROM '{other.file('scenes.parquet')}'",
        f"SELECT * FROM '{run.file('run.json')}'",
    ):
        with pytest.raises(QueryError):
            ask(query, index(run.path))


def test_only_a_sampler_that_looks_back_is_told_of_the_blocks_before() -> None:
    assert not looks_back("random")
    assert looks_back("paper")
    assert looks_back("quality-diversity")
