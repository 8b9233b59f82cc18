"""A frame whose facts a language model gave: those of the situation that it fills."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from chatscene.errors import NoUsableReply
from chatscene.interpret.asked import heard
from chatscene.settings import RetrievalSettings
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Control, Maneuver, Place, Position, Side

TEXT = "A lorry from the left jumps its red light as we turn right."


@pytest.fixture(autouse=True)
def _no_replies_of_before(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("chatscene.interpret.readers.cache_folder", tmp_path.joinpath)


def settings(tmp_path: Path, *replies: Any) -> RetrievalSettings:
    script = tmp_path / "script.json"
    script.write_text(json.dumps(replies), encoding="utf-8")
    return RetrievalSettings(language_model=f"scripted:{script}")


def answer(**facts: Any) -> dict[str, Any]:
    lorry = {
        "id": "A",
        "kind": "truck",
        "starts": {"where": "arm", "side": "left"},
        "does": [{"act": "go-straight", "breaks": "red-light", "speed": "40 km/h"}],
    }
    quoted = {"others.A": "A lorry from the left", "others.A.does": "jumps its red light", "ego": "we turn right"}
    situation = {"ego": {"route": "right-turn"}, "others": [lorry], "evidence": {"quoted": quoted}, **facts}
    return {"verdict": "situation", "reason": "", "situation": situation}


def test_a_models_facts_are_used_with_what_follows_from_them(tmp_path: Path) -> None:
    frame = heard(TEXT, settings(tmp_path, answer()))
    slots = frame.outright
    assert (slots.adversary, slots.actions) == (AdversaryKind.TRUCK, (Action.RUN_LIGHT,))
    assert (slots.side, slots.position, slots.maneuver) == (Side.LEFT, Position.CROSSING, Maneuver.RIGHT_TURN)
    assert (slots.control, slots.place) == (Control.SIGNAL, Place.JUNCTION)
    assert [one.said for one in frame.quantities] == ["40 km/h"]
    assert frame.reader.startswith("scripted:")


def test_a_model_that_answers_nonsense_is_an_error_and_nobody_else_reads(tmp_path: Path) -> None:
    with pytest.raises(NoUsableReply):
        heard(TEXT, settings(tmp_path, *["nonsense"] * 3))


def test_the_projects_own_reader_gives_a_frame_as_a_model_does() -> None:
    frame = heard(TEXT, RetrievalSettings(reading=1))
    assert (frame.reader, frame.sure) == ("", 1.0)
    assert frame.outright.adversary is AdversaryKind.TRUCK
    assert {word.fact for word in frame.words if word.text == "lorry"} == {"others.A.kind"}


def test_a_text_that_a_model_finds_no_situation_in_says_nothing(tmp_path: Path) -> None:
    none = {"verdict": "no-situation", "reason": "It asks a question.", "situation": None}
    frame = heard("How long is a tram?", settings(tmp_path, none))
    assert frame.reader.startswith("scripted:")
    assert frame.outright.said() == {}
