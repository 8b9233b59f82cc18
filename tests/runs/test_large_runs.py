"""Runs of many scenes: folded, and read for a page, some at a time."""

from __future__ import annotations

from pathlib import Path

import pyarrow.parquet as pq
import pytest

from chatscene.report.viewer import write_report
from chatscene.runs import blocks, read_counts, read_record, read_scenes
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


def test_only_a_sampler_that_looks_back_is_told_of_the_blocks_before() -> None:
    assert not looks_back("random")
    assert looks_back("paper")
    assert looks_back("quality-diversity")
