"""The benchmarks of what is driven at the speed of traffic: each command, on as little as tells that it works."""

from __future__ import annotations

import importlib
import re
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest
from click.testing import CliRunner

BENCHMARKS = Path(__file__).parents[2] / "benchmarks"


@pytest.fixture
def benchmark(monkeypatch: pytest.MonkeyPatch) -> Any:
    monkeypatch.syspath_prepend(BENCHMARKS)
    return importlib.import_module


def printed(module: ModuleType, *words: str) -> str:
    found = CliRunner().invoke(module.main, words, catch_exceptions=False)
    assert found.exit_code == 0
    return found.output


def test_of_texts_with_and_without_a_speed_it_is_told_how_many_reach_it(benchmark: Any) -> None:
    told = printed(benchmark("speeds"), "--ego", "idm", "--count", "1", "--drives", "1")
    assert "with a speed, idm: reached 1 of 1" in told
    assert "without, idm: reached" in told


def test_the_texts_are_those_of_others_by_a_rule_and_as_many_say_a_speed_as_do_not(benchmark: Any) -> None:
    speeds = benchmark("speeds")
    chosen = [(bool(speeds.said(one)), bool(speeds.unsaid(one))) for _, one in speeds.texts()]
    assert not any(both == (True, True) for both in chosen)
    assert min(sum(one for one, _ in chosen), sum(one for _, one in chosen)) >= 30


def test_each_case_of_the_protocols_has_a_situation_and_is_held_against_what_the_protocol_says(benchmark: Any) -> None:
    protocols = benchmark("protocols")
    files = {one.file or one.name for one in protocols.CASES}
    assert files == {path.stem for path in protocols.FOLDER.glob("*.yaml")}
    for case in protocols.CASES:
        for vut, target in case.speeds:
            made = protocols.situation(case, vut, target)
            assert str(made.ego.speed) == f"{vut} km/h"
            assert case.target in {one.id for one in made.adversaries}
    told = printed(protocols, "CCRs", "--drives", "1")
    assert told.count("1 of 1") == 3
    assert "as the protocol has it in each drive: 3 of 3" in told


def test_who_crosses_is_met_within_a_twentieth_of_the_width_of_where_the_protocol_has_it(benchmark: Any) -> None:
    told = printed(benchmark("protocols"), "CPNA-25", "CPFA-50", "CBFA-50", "--drives", "2")
    assert "as the protocol has it in each drive: 9 of 9" in told


def test_forty_plain_sentences_without_a_number_are_searched_with_and_who_is_met_is_counted(benchmark: Any) -> None:
    encounters = benchmark("encounters")
    texts = [text for _, text in encounters.sentences()]
    assert len(set(texts)) == 40
    assert not any(re.search(r"\d", text) for text in texts)
    told = printed(encounters, "--ego", "idm", "--count", "1", "--scenes", "10")
    assert "idm: first blocks: 10 scenes, an encounter in" in told
    assert "idm: per 1,000 of 10 simulations" in told
