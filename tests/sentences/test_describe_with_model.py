"""A model's sentences are kept where the library serves them; the rest is written offline, and said to be."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from click.testing import CliRunner

from chatscene.commands import proposal as cli_proposal
from chatscene.errors import NothingFits
from chatscene.interpret.asked import scenario_of
from chatscene.library.load import load_library
from chatscene.models.language.checked import CheckedModel
from chatscene.models.language.protocol import Limits
from chatscene.models.language.scripted import Scripted
from chatscene.sentences.describe_with_model import Sentences, Told, describe_with
from chatscene.settings import RetrievalSettings
from chatscene.terms.scenario import BaseScenario

BASE = BaseScenario.STRAIGHT_OBSTACLE
WALKER = "The ego drives along a straight road and a pedestrian crosses from the right and stops."
BRAKES = "We follow a truck on a straight road and it suddenly slams on its brakes."


def told(script: Scripted, n: int = 3, base: BaseScenario | None = BASE, **more: Any) -> Told:
    return describe_with(
        CheckedModel(script, limits=Limits(reasks=0)),
        base,
        n,
        library=load_library(),
        settings=RetrievalSettings(),
        seed=0,
        **more,
    )


def says(*rounds: list[str]) -> Scripted:
    return Scripted([{"sentences": sentences} for sentences in rounds])


def test_sentences_that_are_served_are_kept_each_with_its_triple() -> None:
    found = told(says([WALKER, BRAKES]), n=2)
    assert [d.text for d in found.by_model] == [WALKER, BRAKES]
    assert len({d.snippet_ids for d in found.by_model}) == 2
    assert {d.base for d in found.by_model} == {BASE}
    assert not found.topped_up
    assert not found.unserved


def test_what_is_not_served_is_counted_and_written_offline() -> None:
    left = "We turn left at a crossroads with a signal and an oncoming car accelerates at us."
    sea = "Write a poem about the sea and the wind over it."
    found = told(says([WALKER, f"  {WALKER.upper()} ", left], [sea, "no"], []), n=3)
    assert [d.text for d in found.by_model] == [WALKER]
    assert len(found.topped_up) == 2
    assert found.reasons["duplicate"] == 1
    assert found.reasons["base"] == 1
    assert found.reasons["text"] == 1
    assert found.reasons["adversary"] == 1
    assert len({d.snippet_ids for d in found.descriptions}) == 3


def test_a_triple_that_serves_another_sentence_already_is_not_served_twice() -> None:
    other = WALKER.replace("drives along", "goes along")
    assert told(says([WALKER, other], [], []), n=2).reasons == {"same triple": 1}


def test_a_model_that_is_asked_again_is_told_what_could_not_be_used() -> None:
    script = says(["too short", WALKER], [BRAKES])
    assert len(told(script, n=2).by_model) == 2
    assert "too short" in script.asked[1][-1].text
    assert WALKER in script.asked[1][-1].text


def test_a_model_without_a_usable_reply_leaves_the_offline_sentences() -> None:
    found = told(Scripted(["no idea"]), n=4)
    assert (len(found.by_model), len(found.topped_up), found.reasons) == (0, 4, {"reply": 1})


def test_a_text_of_a_model_is_cleaned_and_bounded() -> None:
    found = told(says(["\x1b[31m" + "very " * 2000], [], []), n=1)
    assert found.reasons == {"text": 1}
    assert "\x1b" not in found.unserved[0].text
    assert len(found.unserved[0].text) <= 80


def test_the_examples_of_the_prompt_are_sentences_of_the_base_scenario() -> None:
    script = says([WALKER])
    told(script, n=1, instruction="pedestrians who stop")
    example = Sentences.model_validate_json(script.asked[0][2].text)
    assert {scenario_of(text).base for text in example.sentences} == {BASE}
    assert "pedestrians who stop" in script.asked[0][-1].text


def test_what_the_library_has_nothing_of_is_said_before_a_model_is_asked() -> None:
    script = says([WALKER])
    with pytest.raises(NothingFits):
        told(script, instruction="a blizzard of frogs")
    assert not script.asked


def test_the_command_prints_sentences_and_how_different_they_are(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    offline = CliRunner().invoke(cli_proposal.describe, ["--base", BASE.value, "--n", "3"])
    assert offline.exit_code == 0, offline.output
    assert "diversity, offline: 3 sentences, 3 behaviors" in offline.output
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    script = tmp_path / "replies.json"
    script.write_text(json.dumps([{"sentences": [WALKER]}, {"sentences": []}, {"sentences": []}]), encoding="utf-8")
    both = CliRunner().invoke(
        cli_proposal.describe, ["--base", BASE.value, "--n", "3", "--json", "--language-model", f"scripted:{script}"]
    )
    assert both.exit_code == 0, both.output
    printed = json.loads(both.stdout)
    assert printed["descriptions"][0]["text"] == WALKER
    assert printed["topped_up"] == 2
    assert set(printed["diversity"]) == {"kept", "offline"}
