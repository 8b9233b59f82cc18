"""A language model fills the same slots; what it gets wrong never breaks the reading."""

from __future__ import annotations

import json
from dataclasses import replace
from typing import Any

import pytest

from chatscene.interpret.decide import decide
from chatscene.models.language.checked import CheckedModel
from chatscene.models.language.protocol import LanguageModel, Limits
from chatscene.models.language.scripted import Scripted
from chatscene.read.asking import EXAMPLES, Decomposition, ask
from chatscene.read.decompose import hear
from chatscene.settings import RetrievalSettings
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Control, Maneuver, Place, Scenario, Side

TEXT = "Some guy barrels through on red from our left while we go straight."


def model(*replies: Any) -> LanguageModel:
    texts = [reply if isinstance(reply, str) else json.dumps(reply) for reply in replies]
    return CheckedModel(Scripted(texts), limits=Limits())


def form(**slots: Any) -> dict[str, Any]:
    return json.loads(EXAMPLES[-1].reply) | {"position": None} | slots


def asked(text: str, *answers: dict[str, Any]) -> Scenario:
    return decide(ask(model(*answers), hear(text)), RetrievalSettings())


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda e: e.text[:30])
def test_the_examples_of_the_prompt_are_what_they_ask_for(example: Any) -> None:
    assert Decomposition.model_validate_json(example.reply).behavior


def test_a_models_slots_are_used_with_what_follows_from_them() -> None:
    answer = form(adversary="truck", actions=["run-light"], side="left", behavior="the truck runs the light")
    scenario = asked(TEXT, answer)
    slots = scenario.slots
    assert (slots.adversary, slots.actions, slots.side) == (AdversaryKind.TRUCK, (Action.RUN_LIGHT,), Side.LEFT)
    assert (slots.control, slots.place, slots.maneuver) == (Control.SIGNAL, Place.JUNCTION, Maneuver.STRAIGHT)
    assert scenario.parts.behavior == "the truck runs the light"
    assert "read by" in str(scenario.notes[0])


def test_what_a_model_read_is_believed_with_probability_one() -> None:
    answer = form(adversary="truck", actions=["run-light"], side="left")
    frame = ask(model(answer), hear("The bus ahead brakes."))
    assert (frame.beliefs.of("adversary", AdversaryKind.TRUCK), frame.beliefs.of("adversary", AdversaryKind.BUS)) == (
        1,
        0,
    )
    assert (frame.beliefs.heard(Action.RUN_LIGHT), frame.beliefs.heard(Action.BRAKE)) == (1, 0)


def test_where_the_readers_differ_is_told() -> None:
    answer = form(adversary="bus", actions=["brake"])
    notes = asked("The truck ahead brakes.", answer).notes
    assert any("bus" in str(note) and "truck" in str(note) for note in notes)


def test_a_model_that_answers_nonsense_leaves_the_offline_reading() -> None:
    offline = hear("A cyclist cuts across from the left.")
    frame = ask(model(*["no idea"] * 3), offline)
    assert replace(frame, notes=offline.notes) == offline
    assert "read offline" in str(frame.notes[-1])


def test_words_that_are_no_facts_are_asked_for_again() -> None:
    wrong = form(adversary="dragon")
    right = form(adversary="bicycle", actions=["cross"])
    scenario = asked("A cyclist crosses.", wrong, right)
    assert scenario.slots.adversary is AdversaryKind.BICYCLE
