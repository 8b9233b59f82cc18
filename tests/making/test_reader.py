"""What the learned reader learns from, and how it is trained."""

from __future__ import annotations

import json
import random
from pathlib import Path

import pytest

from chatscene.read.learned.grammar import COPIED, grammar
from chatscene.situations.form import from_plain
from chatscene.terms.reading import Verdict
from making.reader.texts import example, in_our_words, of_edits, of_told, situations_in
from making.reader.trust import trust_of

VAN = {"others": [{"id": "A", "kind": "van", "starts": {"where": "ahead"},
                   "does": [{"act": "brake", "acceleration": "6 m/s²"}]}]}  # fmt: skip


def written(path: Path, *rows: object) -> Path:
    path.write_text("".join(json.dumps(row) + "\n" for row in rows), encoding="utf-8")
    return path


def test_an_amount_points_to_its_words() -> None:
    one = example("The van ahead brakes at 6 m/s².", Verdict.SITUATION, from_plain(VAN))
    (at,) = [i for i, step in enumerate(one.steps) if step.place.endswith(COPIED)]
    assert one.read.amounts[one.copied[at]].amount == from_plain(VAN).others[0].does[0].acceleration


def test_an_amount_that_the_text_lacks_is_neither_learned_nor_unlearned() -> None:
    one = example("The van ahead brakes hard.", Verdict.SITUATION, from_plain(VAN))
    assert not [step for step in one.steps if step.place.endswith(COPIED)]
    assert one.barred == {grammar().number["Deed.acceleration", ""]}


def test_a_text_that_tells_nothing_has_no_situation(tmp_path: Path) -> None:
    row = {"text": "What is a tram?", "verdict": "no-situation"}
    (one,) = of_told(written(tmp_path / "a.jsonl", row))
    assert [step.place for step in one.steps] == ["verdict.not", ""]


def test_a_mirrored_reply_is_not_learned(tmp_path: Path) -> None:
    reply = {"verdict": "situation", "situation": VAN | {"evidence": {"quoted": {}, "mirrored": True}}}
    assert not list(of_told(written(tmp_path / "a.jsonl", {"text": "A van brakes.", "replies": [reply]})))


def test_situations_are_told_in_our_words_or_in_those_of_a_writer(tmp_path: Path) -> None:
    file = written(tmp_path / "a.jsonl", {"text": "van stops, 6 m/s²", "situation": VAN})
    (theirs,), (ours,) = of_told(file), in_our_words(situations_in(file))
    assert theirs.read.text == "van stops, 6 m/s²"
    assert "brake" in ours.read.text
    assert theirs.steps == ours.steps


def test_an_edit_is_learned_behind_the_telling_and_comes_to_what_is_after_it(tmp_path: Path) -> None:
    after = VAN | {"others": [VAN["others"][0] | {"kind": "bus"}]}
    rows = {"situation": VAN, "edit": "make it a bus", "after": after}, {"situation": VAN, "edit": "thank you"}
    bus, same = of_edits(written(tmp_path / "a.jsonl", *rows))
    assert bus.read.text.endswith(" Change: make it a bus")
    assert [step.token for step in bus.steps if step.place == "others.kind"] == [("Other.kind", "bus")]
    assert [step.token for step in same.steps if step.place == "others.kind"] == [("Other.kind", "van")]


def test_trust_is_as_often_right_as_it_says() -> None:
    rng = random.Random(0)
    said = [rng.random() for _ in range(4000)]
    scale, offset = trust_of([(p, rng.random() < p) for p in said])
    assert scale == pytest.approx(1.0, abs=0.1)
    assert offset == pytest.approx(0.0, abs=0.1)
    lower, _ = trust_of([(p, rng.random() < 0.3) for p in said])
    assert lower < 0.2


def test_training_is_the_same_after_a_stop(tmp_path: Path) -> None:
    torch = pytest.importorskip("torch")
    pytest.importorskip("onnx")
    from making.reader.fit import Learning, fit

    some = [example(f"van brakes, {i} m/s²", Verdict.SITUATION, from_plain(VAN)) for i in (6, 5)]
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
    learning = Learning(some, 0, None, 6)
    fit(learning, epochs=2, seed=0, out=tmp_path / "one", minutes=1e9)
    again = Learning(some, 0, None, 6)
    fit(again, epochs=2, seed=0, out=tmp_path / "two", minutes=0.0)
    fit(again, epochs=2, seed=0, out=tmp_path / "two", minutes=0.0)
    for name, value in learning.network.state_dict().items():
        assert torch.equal(value, again.network.state_dict()[name]), name


def test_the_words_of_a_fact_are_those_quoted_for_it_or_for_what_it_is_part_of() -> None:
    quoted = {"others.A": "van ahead", "others.A.does.0": "brakes"}
    situation = from_plain(VAN | {"evidence": {"quoted": quoted}})
    one = example("The van ahead brakes at 6 m/s².", Verdict.SITUATION, situation)
    said = {
        step.place: " ".join(dict.fromkeys(one.read.text[slice(*one.read.where[i - 1])].strip() for i in words))
        for step, words in zip(one.steps, one.words, strict=True)
    }
    assert said["others.kind"] == said["others.starts.where"] == "van ahead"
    assert said["others.does.act"] == "brakes"
    assert said[""] == said["verdict"] == ""


def test_what_a_model_filled_is_joined_with_its_text(tmp_path: Path) -> None:
    written(tmp_path / "set.jsonl", {"text": "A van stops."}, {"text": "The van ahead brakes at 6 m/s²."})
    reply = {"id": "set/1", "verdict": "situation", "situation": VAN | {"evidence": {"quoted": {"others": "van"}}}}
    (one,) = of_told(written(tmp_path / "filled.jsonl", reply))
    assert one.read.text == "The van ahead brakes at 6 m/s²."


def test_dropout_leaves_the_mean_and_nothing_out_of_training() -> None:
    torch = pytest.importorskip("torch")
    from making.reader.dropout import Dropout

    drop, x = Dropout(0.1), torch.ones(100, 1000)
    kept = drop(x)
    assert (kept == 0).float().mean() == pytest.approx(0.1, abs=0.01)
    assert kept.mean() == pytest.approx(1.0, abs=0.01)
    assert torch.equal(drop.eval()(x), x)
