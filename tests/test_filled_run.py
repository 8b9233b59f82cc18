"""A text that a language model reads is filled into a situation, and run, told, replayed and taken up as one."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner, Result

import chatscene
from chatscene import runs
from chatscene.commands.main import main
from chatscene.errors import LanguageModelError, NotBuilt, NothingFits, SettingsError
from chatscene.report.sections import command
from chatscene.report.stated import Changed, Stated
from chatscene.runs import read_record
from chatscene.runs.workspace import Workspace
from chatscene.situations.file import read_file
from chatscene.situations.form import from_plain
from chatscene.talk import Shown, Talk

TEXT = "A blue van on the right pulls out at 25 km/h, and we brake."
TOLD = ("not read: 'brake'", "no words of the text say around.light: night")


def answer(**facts: Any) -> dict[str, Any]:
    van: dict[str, Any] = {
        "id": "A",
        "kind": "van",
        "starts": {"where": "kerb", "side": "right"},
        "does": [{"act": "stand"}],
    }
    van["does"].append({"act": "pull-out", "speed": "25 km/h"})
    quoted = {"others.A": "van on the right", "others.A.does": "pulls out at 25 km/h"}
    situation = {"others": [van], "around": {"light": "night"}, "evidence": {"quoted": quoted}, **facts}
    return {"verdict": "situation", "reason": "", "situation": situation}


def says(folder: Path, *replies: Any) -> str:
    script = folder / "script.json"
    script.write_text(json.dumps(replies), encoding="utf-8")
    return f"scripted:{script}"


def invoked(*words: str) -> Result:
    return CliRunner().invoke(main, list(words))


@pytest.fixture(scope="module", autouse=True)
def replies(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """No reply of an earlier session."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("chatscene.report.filled.cache_folder", tmp_path_factory.mktemp("cache").joinpath)
        yield


@pytest.fixture(scope="module")
def finished(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("filled")
    model = says(folder, answer())
    done = invoked("run", TEXT, "--language-model", model, "--scenes", "4", "--out", str(folder / "run"))
    assert done.exit_code == 0, done.output
    lines = done.output.splitlines()
    assert " ".join(lines).index(TOLD[0]) < " ".join(lines).index("4 scenes in")
    (folder / "script.json").unlink()
    return folder / "run"


def test_a_run_tells_first_which_words_were_not_read_and_which_facts_have_no_words(finished: Path) -> None:
    run = chatscene.Run(finished)
    assert tuple(run.told_first)[:2] == TOLD
    assert run.summary.counts["ran"] == 4


def test_its_folder_keeps_the_situation_with_its_evidence_under_the_text(finished: Path) -> None:
    kept = read_file(finished / "situation.yaml")
    assert (kept.about, kept.map) == (TEXT, "town")
    assert kept.evidence.quoted["others.A.does"] == "pulls out at 25 km/h"
    assert kept.evidence.assumed == ("around.light",)
    record = read_record(Workspace(finished))
    assert (record.title, record.text) == (TEXT, "")
    assert record.situation is not None
    assert record.situation.read_by.startswith("scripted:")
    assert "Read by" in (finished / "report.html").read_text(encoding="utf-8")


def test_its_folder_is_checked_replayed_and_taken_up_without_a_model(finished: Path) -> None:
    assert runs.check(finished).whole
    assert chatscene.Run(finished).best.replay().identical
    resumed = chatscene.resume(finished)
    assert isinstance(resumed, chatscene.Run)
    assert resumed.summary.counts["ran"] == 4
    again = command(read_record(Workspace(finished)))
    assert again.startswith("chatscene run situation.yaml --map town")
    assert "language-model" not in again


def test_it_is_explained_without_running(tmp_path: Path) -> None:
    model = says(tmp_path, answer())
    told = invoked("explain", TEXT, "--language-model", model, "--json", "--set", "others.A.kind=truck")
    assert told.exit_code == 0, told.output
    made = json.loads(told.stdout)
    assert made["situation"]["others"][0]["kind"] == "truck"
    assert "new Truck at" in made["program"]
    assert made["not_read"] == ["brake"]
    assert [word["besides"] for word in made["words"] if word["text"] == "blue"] == ["a colour"]
    assert made["reader"] == model
    shown = invoked("explain", TEXT, "--language-model", model).output
    assert shown.startswith(TOLD[0])


def test_from_python_it_is_a_stated_situation(tmp_path: Path) -> None:
    stated = chatscene.explain(TEXT, language_model=says(tmp_path, answer()))
    assert isinstance(stated, Stated)
    assert stated.told_first[:2] == TOLD


@pytest.mark.parametrize(
    ("verdict", "said"),
    [
        ("no-situation", "it tells no dangerous traffic situation: “It is a poem.”"),
        (
            "out-of-reach",
            "it tells a situation for which there are no words here, or several, as a report may: “It is a poem.”",
        ),
    ],
)
def test_what_the_model_does_not_take_for_one_is_refused_in_its_words(tmp_path: Path, verdict: str, said: str) -> None:
    model = says(tmp_path, {"verdict": verdict, "reason": "It is a poem.", "situation": None})
    refused = invoked("run", "Roses are red", "--language-model", model, "--out", str(tmp_path / "run"))
    assert refused.exit_code == 3
    assert f"{model} says that {said}" in " ".join(refused.output.split())
    assert not (tmp_path / "run").exists()
    with pytest.raises(NothingFits) as caught:
        chatscene.explain("Roses are red", language_model=model)
    assert caught.value.reasons == ("It is a poem.",)


def test_what_nothing_builds_ends_with_the_fact(tmp_path: Path) -> None:
    backwards = answer(ego={"route": "reverse"})
    model = says(tmp_path, backwards, backwards, backwards)
    with pytest.raises(NotBuilt, match=r"others\.A\.starts\.where: kerb, with a reversing ego"):
        chatscene.run(TEXT, tmp_path / "run", language_model=model)
    assert not (tmp_path / "run").exists()


def test_a_model_that_is_never_right_ends_the_command_with_the_faults(tmp_path: Path) -> None:
    model = says(tmp_path, *[answer(road={"kind": "moon"})] * 3)
    with pytest.raises(LanguageModelError, match=r"road\.kind: 'moon' is none of road"):
        chatscene.explain(TEXT, language_model=model)
    assert invoked("explain", TEXT, "--language-model", model).exit_code == 1


def test_there_are_no_more_readings_than_the_model_gives_and_facts_are_set_by_path(tmp_path: Path) -> None:
    model = says(tmp_path, answer())
    assert isinstance(chatscene.explain(TEXT, language_model=model, reading=1), Stated)
    with pytest.raises(SettingsError, match="there is no reading 2"):
        chatscene.explain(TEXT, language_model=model, reading=2)
    with pytest.raises(SettingsError, match="no fact"):
        chatscene.explain(TEXT, language_model=model, set={"sid": "left"})


def test_what_is_edited_in_words_is_edited_by_the_model_that_read_it(tmp_path: Path) -> None:
    truck = answer(evidence={"quoted": {"others.A.kind": "a truck"}})
    truck["situation"]["others"][0]["kind"] = "truck"
    edited = chatscene.explain(TEXT, language_model=says(tmp_path, answer(), truck), edit="make it a truck")
    assert isinstance(edited, Changed)
    assert edited.edited.in_words() == ["others.A.kind: van \u2192 truck"]
    assert edited.situation.about == TEXT
    talk = Talk({"language_model": says(tmp_path, answer(), truck)}, {}, tmp_path)
    assert isinstance(talk.hear(TEXT), Shown)
    assert isinstance(heard := talk.hear("make it a truck"), Changed)
    assert heard.situation == edited.situation


def test_a_run_that_a_model_read_is_edited_without_it(finished: Path) -> None:
    edited = chatscene.Run(finished).edit("make it a truck", finished.parent / "truck")
    kept = read_file(edited.folder / "situation.yaml")
    assert kept["A"].kind == "truck"
    assert kept.evidence.quoted["others.A.does"] == "pulls out at 25 km/h"
    record = read_record(Workspace(edited.folder))
    assert (record.title, record.edits) == (f"{TEXT} (edited: make it a truck)", ["make it a truck"])
    assert record.situation is not None
    assert record.situation.read_by.startswith("scripted:")


def test_what_a_person_calls_a_situation_is_held_against_its_quotes_only_if_it_has_them_all() -> None:
    said = {"about": "a van pulls out", "others": [{"id": "A", "kind": "van", "starts": {"where": "kerb"}}]}
    for quoted in ({}, {"others.A": "a lorry"}):
        stated = chatscene.explain(from_plain({**said, "evidence": {"quoted": quoted}}))
        assert isinstance(stated, Stated)
        assert not any("not read" in line for line in stated.told_first)


def test_a_refusal_names_who_is_read_as_somebody_else() -> None:
    with pytest.raises(NothingFits, match="'a helicopter' is read as an emergency vehicle"):
        chatscene.explain("a helicopter lands in front of us")
