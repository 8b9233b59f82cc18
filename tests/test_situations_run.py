"""A situation that was written down is run, told, replayed and taken up again as a sentence is."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest
from click.testing import CliRunner

import chatscene
from chatscene import runs
from chatscene.commands.main import main
from chatscene.errors import EditRefused, NotBuilt, RunError, SettingsError, SituationError
from chatscene.report.sections import command
from chatscene.report.stated import Stated, stated
from chatscene.runs import read_record
from chatscene.runs.workspace import Workspace
from chatscene.situations.file import read_file
from chatscene.situations.form import schema, to_plain
from chatscene.terms.vocabulary import Side, UserKind

WRITTEN = """\
about: a van pulls out in front of us
ego: {speed: 25 km/h}
road: {has: [hill]}
others: [{id: A, kind: van, starts: {where: kerb}, does: [{act: stand}, {act: pull-out, manner: sudden}]}]
"""
TOLD = (
    "assumed: A is on the right",
    "left out, since it cannot be built yet: road.has.0: hill",
)


@pytest.fixture(scope="module")
def finished(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("situations")
    (folder / "van.yaml").write_text(WRITTEN, encoding="utf-8")
    done = CliRunner().invoke(main, ["run", str(folder / "van.yaml"), "--scenes", "4", "--out", str(folder / "run")])
    assert done.exit_code == 0, done.output
    for line in TOLD:
        assert line in " ".join(done.output.split())
    return folder


def test_a_run_of_a_situation_is_whole_and_told_as_what_it_is_called(finished: Path) -> None:
    run = chatscene.Run(finished / "run")
    assert tuple(run.told_first) == TOLD
    assert run.summary.counts["ran"] == 4
    assert "a van pulls out in front of us" in (finished / "run" / "report.html").read_text(encoding="utf-8")
    assert runs.check(finished / "run").whole


def test_its_folder_keeps_the_situation_with_its_map_and_says_how_to_run_it_again(finished: Path) -> None:
    kept = read_file(finished / "run" / "situation.yaml")
    assert kept == replace(read_file(finished / "van.yaml"), map="town")
    again = command(read_record(Workspace(finished / "run")))  # type: ignore[arg-type]
    assert again.startswith("chatscene run situation.yaml --map town")


def test_its_scenes_are_replayed_and_the_run_taken_up_again(finished: Path) -> None:
    run = chatscene.Run(finished / "run")
    assert run.best.replay().identical
    again = chatscene.resume(finished / "run")
    assert isinstance(again, chatscene.Run)
    assert again.summary.counts == run.summary.counts


def test_a_run_of_a_situation_is_edited_in_words(finished: Path) -> None:
    run = chatscene.Run(finished / "run")
    edited = run.edit("make it a truck, from the left", finished / "truck")
    before, after = (read_file(one.folder / "situation.yaml") for one in (run, edited))
    starts = replace(before["A"].starts, side=Side.LEFT)
    assert after.others == (replace(before["A"], kind=UserKind.TRUCK, starts=starts),)
    assert replace(after, others=before.others) == before  # what no edit names stays, whatever it is
    assert edited.edited_from.folder == run.folder.resolve()
    with pytest.raises(EditRefused, match="no fact changes"):
        edited.edit("make it a truck")


def test_a_situation_is_explained_without_running_and_its_facts_are_set_by_path(finished: Path) -> None:
    asked = [
        "explain",
        str(finished / "van.yaml"),
        "--json",
        "--set",
        "others.A.kind=truck",
        "--set",
        "ego.speed=20 km/h",
    ]
    told = CliRunner().invoke(main, asked)
    assert told.exit_code == 0, told.output
    made = json.loads(told.stdout)
    assert made["situation"]["others"][0]["kind"] == "truck"
    assert "new Truck at" in made["program"]
    assert "wantedSpeed 5.556" in made["program"]
    side, *shifted = made["assumed"]
    assert side == "A is on the right"
    assert shifted  # the program that stands there is rehearsed
    assert all(one.startswith("OPT_A_") for one in shifted)
    shown = CliRunner().invoke(main, ["explain", str(finished / "van.yaml"), "--program"]).output
    assert "new Van at" in shown
    assert "model chatscene.world.model" in shown


WORDS = (
    "We drive at 25 km/h. The road has a hill. A van is at the kerb. "
    "It stands still, then suddenly pulls out into our lane."
)


def test_a_situation_is_explained_in_words_before_its_facts(finished: Path) -> None:
    shown = CliRunner().invoke(main, ["explain", str(finished / "van.yaml")]).output
    lines = shown.splitlines()
    assert lines.index(WORDS) < lines.index("version: 1")
    assert all(line.startswith(("assumed: ", "left out: ")) for line in lines[: lines.index(WORDS)])
    as_json = CliRunner().invoke(main, ["explain", str(finished / "van.yaml"), "--json", "--set", "others.A.kind=car"])
    assert json.loads(as_json.stdout)["told"] == WORDS.replace("van", "car")


def test_a_file_of_a_situation_is_named_in_python_as_on_the_command_line(finished: Path) -> None:
    said = chatscene.read_situation(finished / "van.yaml")
    for name in (finished / "van.yaml", str(finished / "van.yaml")):
        explained = chatscene.explain(name)
        assert isinstance(explained, Stated)
        assert explained.situation == said
    with pytest.raises(SituationError, match=r"nothing\.yaml: No such file"):
        chatscene.explain("nothing.yaml")


def test_a_run_of_what_nobody_gave_a_name_is_called_by_its_first_sentences(tmp_path: Path) -> None:
    (tmp_path / "van.yaml").write_text(WRITTEN.partition("\n")[2], encoding="utf-8")
    situation = chatscene.read_situation(tmp_path / "van.yaml")
    assert situation.about == ""
    run = chatscene.run(situation, tmp_path / "run", scenes=1, set={"others.A.kind": "car"})
    record = read_record(Workspace(run.folder))
    assert record.title == WORDS.replace("van", "car")
    assert read_file(tmp_path / "run" / "situation.yaml").about == ""


def test_a_speed_that_is_given_beside_it_is_the_egos_where_none_was_said(finished: Path, tmp_path: Path) -> None:
    said = chatscene.read_situation(finished / "van.yaml")
    assert stated(said, speed=70.0) == said
    silent = replace(said, ego=replace(said.ego, speed=None))
    driven = stated(silent, speed=70.0).ego.speed
    assert driven is not None
    assert driven.low == driven.high == pytest.approx(70.0 / 3.6)
    run = chatscene.run("The car ahead of us brakes hard.", tmp_path / "run", scenes=2, ego="idm", speed=70.0)
    assert read_file(run.folder / "situation.yaml").ego.speed is not None
    assert "with wantedSpeed 19.44" in run.best.program
    assert run.best.replay().identical
    with pytest.raises(SettingsError, match="here snippets are used"):
        chatscene.run("The car ahead brakes.", tmp_path / "own", reader="paper", speed=70.0)


def test_from_python_it_is_a_value(finished: Path) -> None:
    situation = chatscene.read_situation(finished / "van.yaml")
    assert situation["A"].kind is UserKind.VAN
    stated = chatscene.explain(situation, set={"others.A.starts.side": "right"})
    assert isinstance(stated, Stated)
    assert stated.built.assumed == ()
    assert "new Van at" in stated.built.program.source
    with pytest.raises(SituationError, match=r"others\.A\.starts\.side: 'up' is none of left, right"):
        chatscene.explain(situation, set={"others.A.starts.side": "up"})
    with pytest.raises(NotBuilt, match=r"others\.A\.starts\.where: kerb, with a reversing ego"):
        chatscene.explain(situation, set={"ego.route": "reverse"})


def test_a_fault_of_a_file_ends_the_command_with_its_line(tmp_path: Path) -> None:
    (tmp_path / "van.yaml").write_text(WRITTEN.replace("kind: van", "kind: vam"), encoding="utf-8")
    refused = CliRunner().invoke(main, ["run", str(tmp_path / "van.yaml")])
    assert refused.exit_code != 0
    told = " ".join(refused.output.split())
    assert "van.yaml: line 4, others.A.kind: 'vam' is none of car" in told
    missing = CliRunner().invoke(main, ["explain", str(tmp_path / "none.yaml")])
    assert "No such file" in missing.output


def test_the_command_schema_prints_the_schema() -> None:
    assert json.loads(CliRunner().invoke(main, ["schema"]).stdout) == schema()


def test_another_situation_does_not_go_on_in_the_folder_of_one(finished: Path) -> None:
    other = chatscene.read_situation(finished / "van.yaml")
    with pytest.raises(RunError, match="situation"):
        chatscene.run(other, finished / "run", scenes=4, set={"others.A.kind": "truck"})


def test_an_edit_in_words_of_a_situation_is_applied_wherever_it_is_asked(finished: Path, tmp_path: Path) -> None:
    asked = [str(finished / "van.yaml"), "--edit", "make it a truck", "--edit", "at night"]
    told = CliRunner().invoke(main, ["explain", *asked, "--json"])
    made = json.loads(told.stdout)["situation"]
    done = CliRunner().invoke(main, ["run", *asked, "--scenes", "1", "--out", str(tmp_path / "run")])
    assert done.exit_code == 0, done.output
    kept = to_plain(read_file(tmp_path / "run" / "situation.yaml"))
    assert kept == {**made, "map": "town"}
    assert (made["others"][0]["kind"], made["around"]) == ("truck", {"light": "night"})
    refused = CliRunner().invoke(main, ["explain", str(finished / "van.yaml"), "--edit", "make it a dragon"])
    assert (refused.exit_code, "was not understood, so no fact changes" in refused.output) == (3, True)


def test_a_map_that_no_path_can_name_is_refused_in_words(finished: Path) -> None:
    refused = CliRunner().invoke(main, ["explain", str(finished / "van.yaml"), "--set", f"map={'m' * 300}.xodr"])
    assert refused.exit_code != 0
    assert "MapError" in refused.output
