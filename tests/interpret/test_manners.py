"""How a deed is done is said by the words that stand at it, and is built or told as left out."""

from __future__ import annotations

import pytest

from chatscene.build.build import build
from chatscene.interpret.edited import edited
from chatscene.interpret.offline import OfflineReader
from chatscene.terms.reading import Ranked
from chatscene.terms.vocabulary import Manner


def read(text: str) -> Ranked:
    return OfflineReader().read(text).ranked[0]


@pytest.mark.parametrize(
    ("text", "manners"),
    [
        ("a car ahead brakes hard", (Manner.HARD,)),
        ("the car ahead slams on the brakes", (Manner.HARD,)),
        ("a pedestrian suddenly crosses", (Manner.SUDDEN,)),
        ("a child runs out suddenly from behind a parked car", (Manner.SUDDEN,)),
        ("all of a sudden a pedestrian crosses", (Manner.SUDDEN,)),
        ("a car cuts in without warning", (Manner.SUDDEN,)),
        ("a car gently brakes ahead", (Manner.SLIGHT,)),
        ("a car cuts in and brakes hard", (None, Manner.HARD)),
        ("a cyclist ahead swerves and suddenly stops", (None, Manner.SUDDEN)),
        ("a car slowly cuts in", (Manner.SLOW,)),
        ("a car ahead brakes", (None,)),
        ("a truck ahead stops on the hard shoulder", (None,)),
    ],
)
def test_the_words_at_an_act_say_how_it_is_done(text: str, manners: tuple[Manner | None, ...]) -> None:
    assert tuple(deed.manner for deed in read(text).situation["A"].does) == manners


def test_of_several_each_does_it_as_was_said_of_that_one() -> None:
    made = read("a pedestrian crosses and a car behind us brakes hard").situation
    assert [deed.manner for one in made.others for deed in one.does] == [None, Manner.HARD]


def test_words_that_deny_a_manner_give_none() -> None:
    assert read("a car ahead does not brake hard").situation["A"].does[0].manner is None


@pytest.mark.parametrize("text", ["a car ahead brakes hard", "a pedestrian suddenly crosses", "a car suddenly cuts in"])
def test_a_manner_that_a_scene_has_is_built(text: str) -> None:
    assert build(read(text).situation).left_out == ()


def test_a_manner_that_no_scene_has_is_told_as_left_out() -> None:
    assert build(read("a car gently brakes ahead").situation).left_out == ("others.A.does.0.manner: slight",)


def test_the_words_for_a_manner_are_those_of_the_deed() -> None:
    quoted = read("a pedestrian suddenly crosses").situation.evidence.quoted
    assert (quoted["others.A.kind"], quoted["others.A.does"]) == ("a pedestrian", "suddenly crosses")


def test_an_edit_of_who_it_is_keeps_how_it_is_done() -> None:
    after = edited(read("a car ahead brakes hard").situation, "make it a truck").after
    assert after["A"].does[0].manner is Manner.HARD
