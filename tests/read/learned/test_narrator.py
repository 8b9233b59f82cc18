"""Who tells a text may be on foot, or one of the others: that is told, and nobody becomes a driver in silence."""

from __future__ import annotations

import pytest

from chatscene.read.ego_named import owned_kind
from chatscene.read.learned.narrator import clauses, of_somebody
from chatscene.read.learned.reader import YOU_ON_FOOT, LearnedReader
from chatscene.read.quotes import not_in_words, words_of
from chatscene.read.quotes import unread as unread_in
from chatscene.situations.form import from_plain
from chatscene.terms.reading import Verdict
from chatscene.terms.vocabulary import UserKind


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("Our old bus was overtaken.", UserKind.BUS),
        ("A car hit my motorbike.", UserKind.MOTORCYCLE),
        ("A car hit our car.", None),
        ("On our left a bus pulls out.", None),
        ("Our bus driver braked.", None),
    ],
)
def test_the_ego_is_of_the_kind_that_the_narrator_owns(text: str, kind: UserKind | None) -> None:
    found = owned_kind(text)
    assert (found and found[0]) == kind


def test_what_the_narrator_does_is_said_of_somebody() -> None:
    text = "As I walked over the road a truck came. We were slow."
    said = [of_somebody(text[low:high]) for low, high in clauses(text)]
    assert said == [
        "Somebody walked over the road.",
        "Somebody walked over the road a truck came.",
        "Somebody was slow.",
    ]


def test_an_owned_vehicle_is_the_ego() -> None:
    made = LearnedReader().read("Our bus was overtaken by a car that cut in and braked.").ranked[0].situation
    assert made.ego.kind is UserKind.BUS
    assert made.evidence.quoted["ego.kind"] == "Our bus"


@pytest.mark.parametrize(
    "text",
    [
        "As I walked over the zebra crossing a truck ran the red light.",
        "I was jogging along the road and a cyclist came up from behind.",
    ],
)
def test_who_is_on_foot_and_meets_nobody_on_foot_is_told_so(text: str) -> None:
    read = LearnedReader().read(text)
    assert read.verdict is Verdict.OUT_OF_REACH
    assert read.reason == YOU_ON_FOOT


@pytest.mark.parametrize(
    ("text", "line"),
    [
        (
            "I was crossing on foot when a car turned right and nearly hit me.",
            "you are a pedestrian here (A), and not the ego, which is a car",
        ),
        (
            "In my truck, coming the other way, I overtook this car at 50 km/h and cut in left ahead of it.",
            "you are a truck here (A), and not the ego, which is a car",
        ),
        ("V1 was struck on its left by V2, a van from the left.", "'V1' is taken for the ego, a car"),
    ],
)
def test_who_is_who_is_told(text: str, line: str) -> None:
    assert line in not_in_words(LearnedReader().read(text).ranked[0].situation)


@pytest.mark.parametrize(("others", "unread"), [(1, {"sat"}), (0, {"2", "sat"})])
def test_units_that_are_in_a_situation_are_read(others: int, unread: set[str]) -> None:
    text = "Unit 1 was struck by unit 2. In unit 1 nobody sat."
    struck = {"id": "A", "kind": "car", "starts": {"where": "behind"}}
    said = from_plain(
        {"about": text, "others": [struck] * others, "evidence": {"quoted": {"contact": "was struck by"}}}
    )
    assert {word for run in unread_in(said, text) for word in run.split()} & {"1", "2", "sat"} == unread
    named = [one.text for one in words_of(said, text) if one.besides == "names who it is"]
    assert named.count("1") == 2
    assert named.count("2") == others


def test_who_drives_is_the_ego() -> None:
    lines = not_in_words(
        LearnedReader().read("I turned left and a pedestrian crossed from the right.").ranked[0].situation
    )
    assert not any(line.startswith("you are") for line in lines)
