"""Edits that the learned reader reads: what differs from the telling alone, in the names at hand."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

import pytest

from chatscene.errors import EditRefused
from chatscene.interpret.edited import edited
from chatscene.read.learned import edits
from chatscene.read.learned.decoder import Written
from chatscene.read.learned.edits import CHANGE, asked
from chatscene.read.learned.numbers import Found
from chatscene.read.learned.text import Read
from chatscene.situations.form import from_plain, to_plain
from chatscene.terms.amount import Speed
from chatscene.terms.reading import Verdict
from chatscene.terms.situation import Situation
from making.reader.sequence import steps_of
from making.reader.texts import example

CAR = {"kind": "car", "starts": {"where": "ahead", "speed": "50 km/h"}, "does": [{"act": "brake"}]}
VAN = {"kind": "van", "role": "supporting", "starts": {"where": "behind"}, "does": [{"act": "follow"}]}
CRAWLS = VAN | {"starts": {"where": "behind", "speed": "5 km/h"}}
HAND = from_plain({"others": [{"id": "T", **CAR}, {"id": "V", **VAN}]})


def situation(*others: Mapping[str, Any], **more: Any) -> Situation:
    return from_plain({"others": [{"id": name, **one} for name, one in zip("ABC", others, strict=False)], **more})


def reads(
    monkeypatch: pytest.MonkeyPatch, alone: Situation, *both: tuple[Situation, float], doubt: Situation | None = None
) -> None:
    """A reader that makes one thing of a telling, or doubts, and others of the telling with an edit."""

    def written(read: Read, _: object) -> tuple[Written, ...]:
        told = ((alone, 0.9),) if doubt is None else ((alone, 0.45), (doubt, 0.45))
        ways = both if CHANGE in read.text else told
        return tuple(_written(read, one, sure) for one, sure in ways)

    monkeypatch.setattr(edits, "written_of", written)


def _written(read: Read, one: Situation, sure: float) -> Written:
    steps = steps_of(Verdict.SITUATION, one)
    found: list[tuple[int, Found]] = []
    for at, step in enumerate(steps):
        if step.amount is not None:
            taken = [one for one in read.amounts if one.amount == step.amount]
            found.append((at, taken[-1]))
    return Written(steps, math.log(sure), tuple(found))


def changed(text: str) -> dict[str, tuple[object, object]]:
    return {path: (was, now) for path, was, now in edited(HAND, text).changes}


def test_what_differs_from_the_telling_alone_changes_in_the_names_at_hand(monkeypatch: pytest.MonkeyPatch) -> None:
    reads(monkeypatch, situation(CAR, VAN), (situation(CAR | {"kind": "truck"}, VAN), 0.9))
    assert changed("make it a truck") == {"others.T.kind": ("car", "truck")}


def test_an_error_that_is_in_both_changes_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    misread = VAN | {"kind": "bus"}
    reads(monkeypatch, situation(CAR, misread), (situation(CAR | {"kind": "truck"}, misread), 0.9))
    assert changed("make it a truck") == {"others.T.kind": ("car", "truck")}


def test_who_is_told_in_another_order_is_known_again(monkeypatch: pytest.MonkeyPatch) -> None:
    reads(monkeypatch, situation(VAN, CAR), (situation(CAR, VAN | {"kind": "bus"}), 0.9))
    assert changed("a bus behind us") == {"others.V.kind": ("van", "bus")}


def test_who_comes_has_a_new_name_and_who_goes_is_gone(monkeypatch: pytest.MonkeyPatch) -> None:
    dog = {"kind": "dog", "starts": {"where": "roadside"}, "does": [{"act": "cross"}]}
    reads(monkeypatch, situation(CAR, VAN), (situation(CAR, VAN, dog), 0.9))
    assert [one.id for one in edited(HAND, "add a dog").after.others] == ["T", "V", "A"]
    reads(monkeypatch, situation(CAR, VAN), (situation(CAR), 0.9))
    assert [one.id for one in edited(HAND, "without the van").after.others] == ["T"]


def test_a_contact_is_edited_as_all_else(monkeypatch: pytest.MonkeyPatch) -> None:
    reads(monkeypatch, situation(CAR, VAN), (situation(CAR, VAN, contact={"happens": False}), 0.9))
    assert changed("no contact") == {"contact.happens": (None, False)}


@pytest.mark.parametrize(
    ("edit", "copied", "now"),
    [
        ("10 km/h faster", "10 km/h", "60 km/h"),
        ("10 km/h slower", "10 km/h", "40 km/h"),
        ("slow it down by 10 km/h", "10 km/h", "40 km/h"),
        ("another 10 km/h", "10 km/h", "60 km/h"),
        ("20 faster", "20 km/h", "70 km/h"),
        ("at 30 km/h", "30 km/h", "30 km/h"),
        ("brake harder, at 30 km/h", "30 km/h", "30 km/h"),
    ],
)
def test_a_comparative_beside_an_amount_shifts_what_was_said(
    edit: str, copied: str, now: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    after = CAR | {"starts": {"where": "ahead", "speed": copied}}
    reads(monkeypatch, situation(CAR, VAN), (situation(after, VAN), 0.9))
    assert changed(edit) == {"others.T.starts.speed": ("50 km/h", now)}


def test_what_was_not_said_cannot_be_shifted(monkeypatch: pytest.MonkeyPatch) -> None:
    after = VAN | {"starts": {"where": "behind", "speed": "10 km/h"}}
    reads(monkeypatch, situation(CAR, VAN), (situation(CAR, after), 0.9))
    with pytest.raises(EditRefused, match=r"others\.V\.starts\.speed is not stated"):
        changed("the van 10 km/h faster")


@pytest.mark.parametrize(
    ("was", "by", "more", "now"),
    [
        ("10 km/h more than the ego", "5 km/h", True, "15 km/h more than the ego"),
        ("10 km/h less than the ego", "5 km/h", True, "5 km/h less than the ego"),
        ("at most 30 km/h", "5 km/h", False, "at most 25 km/h"),
        ("20 to 30 km/h", "5 km/h", False, "15 to 25 km/h"),
    ],
)
def test_an_amount_is_shifted_as_what_it_is(was: str, by: str, more: bool, now: str) -> None:
    made, wanted = Speed.of(str(edits.shifted(was, Speed.of(by), more=more))), Speed.of(now)
    assert (made.low, made.high) == pytest.approx((wanted.low, wanted.high))
    assert made.than_ego is wanted.than_ego


def test_a_way_that_takes_away_more_than_there_is_counts_for_nothing_and_refuses_only_as_the_likeliest(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    there = situation(CAR, CRAWLS)
    right = situation(CAR | {"starts": {"where": "ahead", "speed": "10 km/h"}}, CRAWLS)
    odd = situation(CAR, CRAWLS | {"starts": {"where": "behind", "speed": "10 km/h"}})
    hand = from_plain({"others": [{"id": "T", **CAR}, {"id": "V", **CRAWLS}]})
    reads(monkeypatch, there, (right, 0.6), (odd, 0.3))
    (change,) = edited(hand, "10 km/h slower").changes
    assert change == ("others.T.starts.speed", "50 km/h", "40 km/h")
    reads(monkeypatch, there, (right, 0.3), (odd, 0.6))
    with pytest.raises(EditRefused, match="5 km/h is too small to subtract"):
        edited(hand, "10 km/h slower")


def test_an_amount_that_gives_no_fact_refuses_the_edit(monkeypatch: pytest.MonkeyPatch) -> None:
    reads(monkeypatch, situation(CAR, VAN), (situation(CAR | {"kind": "truck"}, VAN), 0.9))
    with pytest.raises(EditRefused, match="'20 %'"):
        changed("a truck, 20 % slower")


def test_what_changes_nothing_most_likely_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    truck = situation(CAR | {"kind": "truck"}, VAN)
    reads(monkeypatch, situation(CAR, VAN), (truck, 0.05), (situation(CAR, VAN), 0.9))
    with pytest.raises(EditRefused, match="no fact changes"):
        changed("thank you")


def test_what_is_not_sure_enough_is_refused_with_what_it_may_be(monkeypatch: pytest.MonkeyPatch) -> None:
    truck, bus = (situation(CAR | {"kind": kind}, VAN) for kind in ("truck", "bus"))
    reads(monkeypatch, situation(CAR, VAN), (truck, 0.32), (bus, 0.24), (situation(CAR, VAN), 0.24))
    with pytest.raises(EditRefused, match=r"truck \(40%\).*bus \(30%\)"):
        changed("a big one")


def test_a_situation_in_which_the_reader_is_lost_takes_no_edit(monkeypatch: pytest.MonkeyPatch) -> None:
    reads(monkeypatch, situation(CAR, VAN), (situation(CAR | {"kind": "truck"}, VAN), 0.1))
    with pytest.raises(EditRefused, match="too large to edit in words"):
        changed("make it a truck")


def test_what_the_reader_doubts_without_the_edit_too_stays(monkeypatch: pytest.MonkeyPatch) -> None:
    ways = ((situation(CAR | {"kind": "truck"}, other), 0.45) for other in (VAN, VAN | {"kind": "bus"}))
    reads(monkeypatch, situation(CAR, VAN), *ways, doubt=situation(CAR, VAN | {"kind": "bus"}))
    assert changed("make it a truck") == {"others.T.kind": ("car", "truck")}


@pytest.mark.parametrize("text", ["", " ", "x" * 9000])
def test_an_edit_of_no_words_or_too_many_is_refused(text: str) -> None:
    with pytest.raises(EditRefused, match="say what is to be changed"):
        edited(HAND, text)


def test_one_learns_to_copy_the_amount_by_which_an_edit_shifts() -> None:
    text = asked(HAND, "10 km/h faster")
    after = from_plain(
        to_plain(HAND) | {"others": [{"id": "T", **CAR, "starts": {"where": "ahead", "speed": "60 km/h"}}]}
    )
    made = example(text, Verdict.SITUATION, after, (Speed.of("50 km/h"),), text.index(CHANGE))
    (at,) = [at for at in made.copied if at >= 0]
    assert text[made.read.amounts[at].low : made.read.amounts[at].high] == "10 km/h"
