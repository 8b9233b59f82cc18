"""Names that reports use: the ego's, makes, streets, dates, and what came of it."""

from __future__ import annotations

import pytest

from chatscene.read.decompose import hear
from chatscene.read.naming import plainly_named


@pytest.mark.parametrize(
    "said",
    [
        'A Fernweh autonomous vehicle ("Fernweh AV") was stopped',
        "The Fernweh AV, operating in autonomous mode, was stopped",
        "A Fernweh vehicle in manual mode was stopped",
        "The test vehicle was stopped",
        "Vehicle 1 was stopped; V2 did not stop",
        "The robotaxi was stopped",
    ],
)
def test_the_ego_is_known_under_any_of_its_names(said: str) -> None:
    assert plainly_named(said).text.lower().startswith("the ego was stopped")


@pytest.mark.parametrize(
    ("said", "plain"),
    [
        ("The AV was hit by a 2019 Toyota Corolla.", "The ego was hit by a car"),
        ("The AV was hit by a white Ford pickup truck.", "The ego was hit by a pickup truck"),
        ("On May 3, 2021 at 9:04 AM, the AV was stopped.", "the ego was stopped"),
        ("The AV drove westbound on Elm Street when a car cut in.", "The ego drove westbound when a car cut in"),
        ("The AV drove on Interstate 12 when a car cut in.", "The ego drove on the motorway when a car cut in"),
        ("The AV was struck on Elm Street at Oak Avenue.", "The ego was struck at the intersection"),
        ("A car struck the AV, damaging its rear bumper.", "A car struck the ego"),
        (
            "The AV was stopped when a car struck it. There were no injuries.",
            "The ego was stopped when a car struck it",
        ),
    ],
)
def test_what_no_scene_shows_is_taken_out(said: str, plain: str) -> None:
    assert plainly_named(said).text == plain


def test_what_is_taken_out_is_told() -> None:
    assert plainly_named("The AV was stopped on Elm Street. No injuries were reported.").dropped == (
        "on Elm Street",
        "No injuries were reported",
    )


@pytest.mark.parametrize(
    "said",
    [
        "A car cuts in from the left on the motorway.",
        "We wait at a red light on Friday, and a car hits us from behind.",
        "A pedestrian steps out from behind a bus stop on the right and freezes in front of us.",
        "A German car cuts in front of us from the left.",
        "The Police car overtakes us.",
        "A car overtakes us on Lincoln Road.",
        "Seat belts on: the car ahead brakes.",
        "A truck hits the vehicle a second time.",
    ],
)
def test_a_text_that_is_no_report_is_left_as_it_is(said: str) -> None:
    named = plainly_named(said)
    assert (named.text, named.dropped) == (said, ())


def test_what_a_bracket_tells_of_another_is_read_and_an_aside_is_listed() -> None:
    assert plainly_named("The AV was hit by Vehicle 2 (a truck).").text == "The ego was hit by the truck"
    assert plainly_named("The AV was hit by a car (it was late).").dropped == ("it was late",)


@pytest.mark.parametrize("first", ["Veh #1", "Veh. 1", "Vehicle #1", "V1"])
def test_a_sentence_behind_the_name_of_a_street_is_not_taken_for_a_part_of_it(first: str) -> None:
    second = first.replace("1", "2")
    said = f"{first} WB on Alder Ave, stopped at Pine St. {second}, a pickup, was ahead and rolled into {first}."
    assert plainly_named(said).text == "The ego WB, stopped. The pickup, was ahead and rolled into the ego"


@pytest.mark.parametrize(("said", "meant"), [("A car WB on Main", "westbound on"), ("A van, s/b", "southbound")])
def test_compass_directions_are_known_by_their_letters(said: str, meant: str) -> None:
    assert meant in hear(said).told


def test_a_make_is_a_car_whoever_speaks() -> None:
    assert plainly_named("A Ford Transit van in front of us brakes.").text == "A van in front of us brakes."
