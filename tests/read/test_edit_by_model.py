"""Edits that a language model applies, with replies from a script."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from chatscene.build.build import Built, build
from chatscene.errors import EditRefused, LanguageModelError
from chatscene.models.language.protocol import LanguageModel, load_language_model
from chatscene.read.by_model import LIMITS
from chatscene.read.edit_by_model import EXAMPLES, edited_by
from chatscene.report import stated as report
from chatscene.report.filled import editor_of
from chatscene.situations.form import from_plain, to_plain
from chatscene.terms.situation import Situation
from chatscene.terms.vocabulary import UserKind

VAN: dict[str, Any] = {
    "id": "A",
    "kind": "van",
    "starts": {"where": "kerb", "side": "right"},
    "does": [{"act": "stand"}, {"act": "pull-out", "speed": "25 km/h"}],
}
READ = from_plain(
    {
        "about": "A van on the right pulls out at 25 km/h.",
        "map": "town",
        "others": [VAN],
        "evidence": {"quoted": {"others.A": "A van on the right", "others.A.does": "pulls out at 25 km/h"}},
    }
)
LEFT = {**VAN, "starts": {"where": "kerb", "side": "left"}}


def reply(*others: dict[str, Any], **facts: Any) -> dict[str, Any]:
    quoted = {"others.A": "from the left"}
    situation = {"others": list(others), "evidence": {"quoted": quoted}, **facts}
    return {"verdict": "situation", "reason": "", "situation": situation}


def scripted(folder: Path, *replies: Any) -> LanguageModel:
    script = folder / "script.json"
    script.write_text(json.dumps(replies), encoding="utf-8")
    return load_language_model(f"scripted:{script}", limits=LIMITS, cache=folder / "cache")


def builds(_: Situation) -> str:
    return ""


def test_what_the_model_changes_is_changed_and_name_map_and_evidence_of_the_rest_are_kept(tmp_path: Path) -> None:
    made = edited_by(scripted(tmp_path, reply(LEFT)), builds)(READ, " from  the left ")
    assert made.text == "from the left"
    assert made.in_words() == ["others.A.starts.side: right \u2192 left"]
    assert (made.after.about, made.after.map) == (READ.about, "town")
    quoted = made.after.evidence.quoted
    assert quoted["others.A.kind"] == "A van on the right"
    assert quoted["others.A.does"] == "pulls out at 25 km/h"
    assert "others.A.starts.side" not in quoted


@pytest.mark.parametrize("verdict", ["no-situation", "out-of-reach"])
def test_a_verdict_is_a_refusal_in_the_words_of_the_model(tmp_path: Path, verdict: str) -> None:
    says = {"verdict": verdict, "reason": "It names nothing to change.", "situation": None}
    with pytest.raises(EditRefused, match=r"says: “It names nothing to change\.”"):
        edited_by(scripted(tmp_path, says), builds)(READ, "thank you")


def test_a_verdict_without_a_reason_is_sent_back(tmp_path: Path) -> None:
    mute = {"verdict": "out-of-reach", "reason": " ", "situation": None}
    made = edited_by(scripted(tmp_path, mute, reply(LEFT)), builds)(READ, "from the left")
    assert made.changes


def test_what_cannot_be_built_or_changes_nothing_or_has_faults_is_sent_back_and_mended(tmp_path: Path) -> None:
    same = reply(VAN)
    same["situation"] = {k: v for k, v in to_plain(READ).items() if k not in ("about", "map", "version")}
    deaf = reply({**LEFT, "kind": "vam"})
    asked: list[str] = []

    def bus_only(situation: Situation) -> str:
        asked.append(situation["A"].kind)
        return (
            "" if situation["A"].kind is UserKind.BUS else f"cannot be built yet: others.A.kind: {situation['A'].kind}"
        )

    made = edited_by(scripted(tmp_path, same, reply(LEFT), reply({**LEFT, "kind": "bus"})), bus_only)(READ, "a bus")
    assert asked == ["van", "bus"]  # what is as it was is not even tried
    assert made.after["A"].kind == "bus"
    (tmp_path / "faults").mkdir()
    made = edited_by(scripted(tmp_path / "faults", deaf, reply(LEFT)), builds)(READ, "from the left")
    assert made.in_words() == ["others.A.starts.side: right \u2192 left"]


def test_a_model_that_is_never_right_ends_with_the_reason(tmp_path: Path) -> None:
    model = scripted(tmp_path, *[reply(LEFT)] * 3)
    with pytest.raises(LanguageModelError, match="it cannot be built: no such road"):
        edited_by(model, lambda _: "no such road")(READ, "from the left")


@pytest.mark.parametrize("text", ["", "  ", "x" * 10_000])
def test_nothing_and_too_much_is_refused_before_the_model_is_asked(tmp_path: Path, text: str) -> None:
    with pytest.raises(EditRefused, match="say what is to be changed"):
        edited_by(scripted(tmp_path), builds)(READ, text)


def test_the_replies_that_are_shown_to_the_model_are_edits_that_it_may_give(tmp_path: Path) -> None:
    for example in EXAMPLES[:-1]:
        before = json.loads(example.text.partition("\n")[0].removeprefix("Situation: "))
        made = edited_by(scripted(tmp_path, json.loads(example.reply)), builds)(from_plain(before), "an edit")
        assert made.changes


def test_what_was_tried_for_the_model_is_not_built_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / "script.json").write_text(json.dumps([reply(LEFT)]), encoding="utf-8")
    built: list[Situation] = []

    def counted(situation: Situation, **named: Any) -> Built:
        built.append(situation)
        return build(situation, **named)

    monkeypatch.setattr(report, "build", counted)
    before = report.Stated(situation=READ, built=build(READ), editor=editor_of(f"scripted:{tmp_path / 'script.json'}"))
    after = before.edit("from the left")
    assert len(built) == 1
    assert after.built == report.built_of(after.situation)
