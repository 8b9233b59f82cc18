"""The classifier: small ones trained here on sentences with known answers, and the packaged one."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from chatscene.errors import SnippetError
from chatscene.grow.compose_texts import Labelled, compose, wordings
from chatscene.grow.course import of_others
from chatscene.grow.fit import fit, heads_of, trust_of, unseen
from chatscene.interpret.decide import likeliest, likeliest_together, scenario_of
from chatscene.interpret.retrieve import guessed
from chatscene.interpret.wording_index import stem
from chatscene.library.load import Library, load_library
from chatscene.models.encoders.embedding import MiniLM
from chatscene.read.decompose import hear
from chatscene.read.slot_classifier import (
    PACKAGED,
    TRUSTED,
    VALUES,
    SlotClassifier,
    Trust,
    believed_by,
    load_classifier,
    save_classifier,
)
from chatscene.settings import RetrievalSettings
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Component, Side, Site, Slots
from outright import decompose

States = Callable[[str], list[Any]]  # of a sentence, from each member's encoder
WORDS = ("now", "then", "soon", "late", "fast", "slow", "far", "near")
IDS = ("behavior/cross", "behavior/lane-brake", "geometry/straight-road", "spawn/ahead-in-lane", "spawn/roadside-right")


def small() -> Library:
    library = load_library()
    return Library(tuple(library.get(i) for i in IDS))


def _silent(_what: str, _done: int, _of: int) -> None:
    pass


def sentences() -> list[Labelled]:
    crossing = Slots(adversary=AdversaryKind.PEDESTRIAN, actions=(Action.CROSS,), side=Side.RIGHT)
    braking = Slots(adversary=AdversaryKind.CAR, actions=(Action.BRAKE,))
    return [
        *(Labelled(f"a zorp glides over the way {w}", crossing, ("behavior/cross",)) for w in WORDS),
        *(Labelled(f"the krell anchors up at once {w}", braking, ("behavior/lane-brake",)) for w in WORDS),
    ]


@pytest.fixture(scope="module")
def trained() -> SlotClassifier:
    classes = heads_of(small())
    members = tuple(fit(sentences(), classes, epochs=16, seed=seed, told=_silent) for seed in range(2))
    return SlotClassifier(members, classes, dict.fromkeys(TRUSTED, Trust()))


@pytest.fixture(scope="module")
def states(trained: SlotClassifier) -> States:
    encoders = trained.encoders()
    return lambda text: [encoder.states(text) for encoder in encoders]


def test_words_that_no_pattern_knows_are_learned_from_sentences(trained: SlotClassifier, states: States) -> None:
    text = "a zorp glides over the way x"
    found = trained.classify(states(text), decompose(text).slots)
    assert likeliest(found, {}).adversary is AdversaryKind.PEDESTRIAN
    assert found.actions[Action.CROSS] > found.actions[Action.BRAKE]
    assert found.behaviors["behavior/cross"] > 0.5


def test_probabilities_are_probabilities(trained: SlotClassifier, states: States) -> None:
    found = trained.classify(states("the krell anchors up"), Slots())
    assert set(found.slots) == set(VALUES)
    assert all(sum(p.values()) == pytest.approx(1.0, abs=1e-5) for p in found.slots.values())
    assert all(0.0 <= p <= 1.0 for p in found.actions.values())


def test_what_the_patterns_found_counts_for_it(trained: SlotClassifier, states: States) -> None:
    trusting = replace(trained, trust=dict.fromkeys(trained.trust, Trust(found=4.0)))
    seen = states("the krell anchors up")
    plain = trusting.classify(seen, Slots()).of("side", Side.LEFT)
    told = trusting.classify(seen, Slots(side=Side.LEFT)).of("side", Side.LEFT)
    assert told > plain


def test_the_runtime_reads_what_was_trained_but_for_rounding(trained: SlotClassifier, states: States) -> None:
    right = [trained.log_odds(states(s.text)) for s in sentences()]
    assert [max(zip(odds["adversary"], trained.classes["adversary"], strict=True))[1] for odds in right] == [
        s.slots.adversary for s in sentences()
    ]


def test_untrained_layers_are_written_as_they_were_read() -> None:
    pytest.importorskip("torch", reason="the extra 'train' is not installed")
    from chatscene.grow.tuned_encoder import Tuned

    same = MiniLM(Tuned(frozen=3, columns=[2], dropout=0.0).changes())
    text = "a bus pulls out"
    np.testing.assert_allclose(same.states(text), MiniLM().states(text), atol=1e-4)


def test_trained_weights_are_whole_steps_from_the_old_ones_and_stay_int8() -> None:
    pytest.importorskip("torch", reason="the extra 'train' is not installed")
    from chatscene.grow.tuned_encoder import STEP, in_steps

    old = np.array([0, 0, 0, 126, -127, 127], np.int8)
    new = in_steps(old, np.array([0.9, 1.1, -2.6, 127.0, -127.0, -127.0]))
    assert new.dtype == np.int8
    assert new.tolist() == [0, 2, -2, 126, -127, -127]
    assert not np.any((new.astype(int) - old) % STEP)


def test_a_classifier_of_an_older_form_is_refused(tmp_path: Path) -> None:
    with np.load(PACKAGED) as arrays:
        older = dict(arrays)
    older["changes"] = np.zeros((2, int(older["lengths"].sum())), np.uint8)
    np.savez_compressed(tmp_path / "older.npz", **older)
    with pytest.raises(SnippetError, match="train it again"):
        load_classifier(tmp_path / "older.npz")


def test_a_classifier_comes_back_from_its_file(trained: SlotClassifier, tmp_path: Path) -> None:
    save_classifier(trained, tmp_path / "c.npz")
    again = load_classifier(tmp_path / "c.npz")
    assert again.classes == trained.classes
    assert again.trust == trained.trust
    for one, other in zip(again.members, trained.members, strict=True):
        assert one.changes == other.changes
        np.testing.assert_allclose(one.weights, other.weights, atol=1e-3)


def test_what_members_say_is_averaged(trained: SlotClassifier, states: States) -> None:
    seen = states("the krell anchors up")
    alone = [
        SlotClassifier((member,), trained.classes, trained.trust).log_odds([one])["side"]
        for member, one in zip(trained.members, seen, strict=True)
    ]
    assert not np.allclose(alone[0], alone[1], atol=1e-2)
    np.testing.assert_allclose(trained.log_odds(seen)["side"], np.mean(alone, axis=0), atol=1e-5)


def test_a_damaged_file_says_how_to_train_again(tmp_path: Path) -> None:
    (tmp_path / "c.npz").write_bytes(b"no weights")
    with pytest.raises(SnippetError, match="library fit"):
        load_classifier(tmp_path / "c.npz")


def test_trust_is_found_within_its_bounds(trained: SlotClassifier) -> None:
    for head, trust in trust_of(trained.classes, unseen(trained, sentences())).items():
        assert trust.found >= (2.0 if head in ("maneuver", "control") else 0.0)
        assert trust.silent <= 0.0 if head == "actions" else trust.silent >= 0.0


def test_slots_that_nobody_labelled_keep_the_default_trust(trained: SlotClassifier) -> None:
    open_ = [replace(s, open=frozenset((*VALUES, "actions"))) for s in sentences()]
    assert trust_of(trained.classes, unseen(trained, open_))["side"] == Trust()


def test_an_account_that_is_right_counts(trained: SlotClassifier) -> None:
    seen = unseen(trained, sentences())
    left = Slots(side=Side.LEFT)
    told = [replace(row, account=left, sentence=replace(row.sentence, slots=left)) for row in seen]
    assert trust_of(trained.classes, told)["side"].told > 0.0


def test_training_goes_on_from_what_was_learned(trained: SlotClassifier) -> None:
    other = [Labelled(f"a blick halts over there {w}", Slots(actions=(Action.STOP,)), ()) for w in WORDS]
    member = fit(other, trained.classes, epochs=1, seed=5, told=_silent, onward=(trained.members[0], trained.classes))
    after = SlotClassifier((member,), trained.classes, dict.fromkeys(TRUSTED, Trust()))
    text = "a zorp glides over the way x"
    found = after.classify([encoder.states(text) for encoder in after.encoders()], Slots())
    assert found.behaviors["behavior/cross"] > 0.5


def test_a_kind_and_a_slot_that_were_not_trained_are_heard_as_words_say_them() -> None:
    everything = heads_of(small())
    classes = {head: names for head, names in everything.items() if head != "site"}
    classes["adversary"] = ("", "pedestrian", "car")
    deer = hear("A deer runs out in front of us from the right, suddenly.")
    assert deer.outright.adversary is AdversaryKind.DEER
    member = fit(sentences(), classes, epochs=18, seed=0, told=_silent)
    classifier = SlotClassifier((member,), classes, dict.fromkeys(TRUSTED, Trust(found=4.0)))
    found = believed_by(classifier, classifier.encoders(), deer)
    assert set(found.slots["adversary"]) == {None, AdversaryKind.DEER, AdversaryKind.CAR}
    assert found.likeliest("adversary") is AdversaryKind.DEER
    assert "site" not in found.slots
    frame = replace(deer, beliefs=found, outright=replace(deer.outright, site=Site.RURAL))
    assert likeliest_together(frame, RetrievalSettings()).site is Site.RURAL


def test_a_text_of_others_means_any_behavior_that_does_what_it_says(tmp_path: Path) -> None:
    row = {"text": "the lead car brakes", "style": "x", "in_scope": True, "slots": {"actions": ["brake"]}}
    (tmp_path / "theirs.jsonl").write_text(json.dumps(row))
    (one,) = of_others(tmp_path / "theirs.jsonl", load_library())
    does = {load_library().get(name).slots.actions for name in one.behaviors}
    assert (Action.BRAKE,) in does
    assert all(Action.BRAKE in actions for actions in does)
    assert "lanes" in one.open  # few write it down


def test_composed_sentences_say_what_their_labels_say() -> None:
    library = load_library()
    made = compose(library, 60, seed=3)
    assert made == compose(library, 60, seed=3)
    assert len({s.text for s in made}) > 55
    actions = {s.id: set(s.slots.actions) for s in library.of(Component.BEHAVIOR)}
    assert all(set(s.slots.actions) <= actions[i] for s in made for i in s.behaviors)


def test_every_wording_teaches_only_what_is_done() -> None:
    taught = wordings(small())
    assert {s.behaviors for s in taught} == {("behavior/cross",), ("behavior/lane-brake",)}
    assert all(s.open == frozenset(VALUES) for s in taught)


@pytest.mark.parametrize(("word", "root"), [("braking", "brak"), ("brakes", "brak"), ("brake", "brak"), ("bus", "bus")])
def test_stems_join_the_forms_of_a_word(word: str, root: str) -> None:
    assert stem(word) == root


def test_the_packaged_classifier_knows_the_behaviors_of_the_library() -> None:
    known = load_classifier().classes["behavior"]
    ids = {s.id for s in load_library().of(Component.BEHAVIOR)}
    assert len(ids & set(known)) >= 0.95 * len(ids)


def test_a_fact_that_only_the_classifier_saw_is_called_a_guess() -> None:
    scenario = scenario_of("The bloke in front jumps on the anchors for no reason at all.")
    assert scenario.frame is not None
    found = guessed(scenario.slots, scenario.frame)
    assert "actions" in found
    assert all(getattr(scenario.slots, name) for name in found)
    assert not any(getattr(decompose(scenario.text).slots, name) for name in found)
