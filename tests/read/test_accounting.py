"""Every word of a text gave a fact, is known to be without effect, or was not read."""

from __future__ import annotations

from functools import cache

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.errors import SettingsError
from chatscene.read.accounting import words_of
from chatscene.report.accounting import in_words, parts_of, unread_in_words
from chatscene.search.generators.retrieved import Retrieved
from chatscene.settings import RetrievalSettings
from chatscene.terms.edit import with_edits
from chatscene.terms.frame import Word

CLAIM = (
    "On 3 March at 14:20 some idiot in a blue Honda Civic on my left cut me off on Harbour Road, and then slammed on "
    "the brakes; a pigeon flew away."
)


@cache
def words(text: str, reading: int = 0) -> tuple[Word, ...]:
    return words_of(Retrieved().read(text, RetrievalSettings(reading=reading)))


def became(text: str, reading: int = 0) -> dict[str, str]:
    """What each word gave: its fact, ``-`` for one without effect, ``?`` for one that was not read."""
    return {one.text: one.fact or ("-" if one.besides else "?") for one in words(text, reading)}


@pytest.mark.parametrize(
    ("text", "facts"),
    [
        (
            "A cyclist crosses from the left while we turn right.",
            {"cyclist": "adversary", "crosses": "actions", "left": "side", "we": "the ego", "turn": "maneuver"},
        ),
        (
            "At night in heavy rain the car ahead brakes with 6 m/s².",
            {
                "night": "light",
                "rain": "weather",
                "heavy": "-",
                "ahead": "position",
                "brakes": "actions",
                "6": "deceleration",
            },
        ),
        (
            "An Acme AV was traveling westbound on Ortega Street in autonomous mode when a white van made contact "
            "with its rear bumper. There were no injuries.",
            {"Acme": "the ego", "van": "adversary", "white": "-", "rear": "contact", "Ortega": "-", "injuries": "-"},
        ),
    ],
)
def test_a_word_is_marked_by_the_fact_that_it_gave(text: str, facts: dict[str, str]) -> None:
    found = became(text)
    assert {word: found[word] for word in facts} == facts


def test_colours_makes_streets_dates_and_feelings_are_without_effect_and_the_rest_was_not_read() -> None:
    found = became(CLAIM, reading=1)
    assert {found[word] for word in ("3", "March", "idiot", "blue", "Harbour", "Road")} == {"-"}
    assert (found["cut"], found["left"]) == ("actions", "side")
    assert {found[word] for word in ("pigeon", "flew")} == {"?"}


def test_the_stops_of_a_telegram_are_full_stops_and_one_alone_is_an_act() -> None:
    assert became("CAR AHEAD BRAKES STOP WE FOLLOW STOP")["STOP"] == "-"
    assert became("Will the car ahead STOP")["STOP"] == "actions"


def test_a_red_light_is_no_colour() -> None:
    found = became("A red van from the left runs the red light.")
    assert found["red"] == "actions"
    assert words("A red van from the left runs the red light.")[1].besides == "a colour"


def test_an_act_that_nobody_does_in_the_scene_was_not_read() -> None:
    text = "A car from the left cuts in front of us and then brakes."
    assert (became(text)["cuts"], became(text)["brakes"]) == ("actions", "actions")
    told = words_of(Retrieved().read(text, RetrievalSettings(stated="actions=cut-in")))
    assert [one.text for one in told if one.unread] == ["brakes"]


@pytest.mark.parametrize("text", [CLAIM, "We  go straight,\na car cuts in — from the right!", "Une voiture freine."])
def test_words_stand_where_they_say_and_make_up_the_text_again(text: str) -> None:
    scenario = Retrieved().read(text, RetrievalSettings())
    told = words_of(scenario)
    assert all(scenario.text[one.start : one.end] == one.text for one in told)
    parts = parts_of(scenario.text, [one.as_dict() for one in told])
    assert "".join(part.before + part.text for part in parts) == scenario.text


def test_an_edit_was_read_by_itself_and_leaves_no_word_unread() -> None:
    text = with_edits("A car cuts in from the left.", ("make it a lorry", "at night (no moon)"))
    marks = became(text)
    assert marks["cuts"] == "actions"
    assert {marks[word] for word in ("edited", "make", "lorry", "night", "moon")} == {"-"}


def test_a_person_reads_the_marks_in_words() -> None:
    told = words("A cyclist crosses from the left.")
    shown = in_words(parts_of("A cyclist crosses from the left.", [one.as_dict() for one in told]))
    assert shown == "(adversary: A cyclist) (actions: crosses) (side: from the left)."


def test_a_run_says_in_one_line_what_it_does_not_show() -> None:
    told = [one.as_dict() for one in words(CLAIM)]
    assert unread_in_words(CLAIM, told) == "not understood, so possibly missing from the scenes: 'pigeon flew away'"
    assert not unread_in_words("A cyclist crosses from the left.", [])


@settings(max_examples=40, deadline=None)
@given(st.text(st.sampled_from("abc ABC.,;'-\u20190123 \u00e9\u4e2d\n"), min_size=1, max_size=80))
def test_no_text_breaks_the_account_of_its_words(text: str) -> None:
    try:
        scenario = Retrieved().read(text, RetrievalSettings())
    except SettingsError:
        return  # nothing is said
    assert all(bool(one.fact) + bool(one.besides) + one.unread == 1 for one in words_of(scenario))
