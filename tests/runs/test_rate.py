"""A rate counts the drives of a run and more, the same at any number of processes, and says what it assumes."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import chatscene
from chatscene import pipeline, runs
from chatscene.commands.main import main
from chatscene.errors import ChatSceneError, RunError
from chatscene.search.exposure import exposure_of
from chatscene.search.generator import load_generator
from chatscene.search.rare import Batch, Came, Tally
from chatscene.settings import PAPER, SearchSettings, Settings
from chatscene.terms.scenario import BaseScenario

TEXT = "an oncoming car turns left across our way"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = tmp_path_factory.mktemp("rate") / "run"
    search = replace(PAPER, scenes=40, block=10, routes=1)
    chatscene.run(TEXT, path, ego="idm", settings=Settings(search=search))
    return path


def test_crashes_that_a_search_went_after_tell_less_than_as_many_others(folder: Path) -> None:
    found = chatscene.rate(folder, scenes=0)
    assert (found.stored, found.driven) == (40, 0)
    assert found.crash.seen > 30 > found.crash.effective
    assert found.crash.probability is None
    assert "too few crashes for an estimate: " in found.in_words()
    assert found.in_words().startswith(repr(TEXT))
    assert "one that a careful driver avoids: " in found.in_words()  # by whom: others may avoid more


def test_any_number_of_processes_finds_the_same_rate(folder: Path) -> None:
    one = chatscene.rate(folder, scenes=10, seed=4)
    assert chatscene.rate(folder, scenes=10, seed=4, jobs=2) == one
    assert chatscene.rate(folder, scenes=10, seed=5) != one


def test_what_is_assumed_is_said_and_a_density_has_its_source(folder: Path, tmp_path: Path) -> None:
    uniform = CliRunner().invoke(main, ["rate", str(folder), "--scenes", "0"], catch_exceptions=False)
    assert "Assumed, not measured" in uniform.output
    speeds = tmp_path / "speeds.toml"
    speeds.write_text('[OPT_A_SPEED]\nshape = "normal"\nmean = 8\ndeviation = 3\nsource = "a count in our street"\n')
    told = ["rate", str(folder), "--scenes", "0", "--exposure", str(speeds)]
    known = CliRunner().invoke(main, told, catch_exceptions=False)
    assert "OPT_A_SPEED: normal" in known.output
    assert "a count in our street" in known.output
    as_json = json.loads(CliRunner().invoke(main, [*told, "--json"], catch_exceptions=False).output)
    assert {row["parameter"]: row["shape"] for row in as_json["exposure"]}["OPT_A_SPEED"] == "normal"


def test_of_a_search_that_begins_with_uniform_draws_only_these_are_counted(tmp_path: Path) -> None:
    chatscene.run(TEXT, tmp_path / "run", ego="idm", settings=Settings(search=SearchSettings(scenes=6, block=2)))
    found = chatscene.rate(tmp_path / "run", scenes=0)
    assert found.stored == 2
    assert "the drives after the first block" in found.in_words()


def test_drives_that_nobody_knows_the_draw_of_are_not_counted(tmp_path: Path) -> None:
    few = Settings(search=SearchSettings(scenes=4, block=2, sampler="cma-es"))
    chatscene.run(TEXT, tmp_path / "run", ego="idm", settings=few)
    found = chatscene.rate(tmp_path / "run", scenes=2)
    assert (found.stored, found.driven) == (0, 2)
    assert "cma-es" in found.in_words()


def test_a_text_becomes_a_run_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("chatscene.commands.rate.FIRST_LOOK", 2)
    done = CliRunner().invoke(
        main, ["rate", "the car ahead brakes hard", "--scenes", "0", "--ego", "idm"], catch_exceptions=False
    )
    assert done.exit_code == 0
    assert "none seen; below" in done.output
    assert "driven by idm" in done.output
    assert len(list((tmp_path / "runs").iterdir())) == 1


def test_a_rate_of_no_run_is_refused(tmp_path: Path) -> None:
    with pytest.raises(RunError, match="not a run folder"):
        chatscene.rate(tmp_path)


def test_a_generator_that_has_a_sampler_of_its_own_is_asked_how_it_drew(tmp_path: Path) -> None:
    few = replace(PAPER, scenes=4, block=2, routes=1, sampler="random")
    asked = runs.asked_run(
        load_generator("learning-to-collide").texts(BaseScenario("straight-obstacle"))[0],
        settings=Settings(search=few),
        map_name=None,
        ego="idm",
        generator="learning-to-collide",
    )
    pipeline.run(asked, tmp_path / "run")
    found = chatscene.rate(tmp_path / "run", scenes=0)
    assert found.stored == 0
    assert "the sampler 'policy-gradient'" in found.in_words()


def test_a_run_that_was_refused_has_no_rate(tmp_path: Path) -> None:
    with pytest.raises(ChatSceneError):
        chatscene.run("the weather is nice", tmp_path / "run")
    with pytest.raises(RunError, match="refused"):
        chatscene.rate(tmp_path / "run", scenes=0)


def test_of_a_run_of_which_all_drives_count_nothing_is_said_to_be_left_out(tmp_path: Path) -> None:
    chatscene.run(TEXT, tmp_path / "run", ego="idm", scenes=2)
    assert chatscene.rate(tmp_path / "run", scenes=0).left == ""


def test_what_is_not_known_of_crashes_is_said_to_be_unknown() -> None:
    exposure = exposure_of((), ())
    tally = Tally(exposure)
    came = [Came(1.0, True, None), Came(1.0, True, True), Came(0.0, False, False)]
    tally.add(np.zeros((3, 0)), [0, 0, 0], came, Batch(count=3, density=exposure))
    crash, careful = tally.shares()
    assert (crash.seen, careful, tally.unknown) == (2, None, 1)


@pytest.mark.parametrize("option", ["--simulator=native", "--generator=x", "--library=x", "--exposure=none.toml"])
def test_what_cannot_be_used_is_refused_before_a_text_is_driven(
    option: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(main, ["rate", "the car ahead brakes hard", option])
    assert done.exit_code == 1
    assert not list(tmp_path.iterdir())


def test_a_long_text_is_no_path(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    done = CliRunner().invoke(main, ["rate", "the weather is very nice " * 20, "--ego", "idm"])
    assert done.exit_code == 3


def test_a_benchmark_refuses_a_sampler_that_its_generator_would_ignore(tmp_path: Path) -> None:
    done = CliRunner().invoke(
        main, ["benchmark", "--generator=advsim", "--sampler=random", f"--out={tmp_path / 'out'}"]
    )
    assert done.exit_code == 1
    assert "'cma-es'" in done.output
    assert not (tmp_path / "out").exists()
