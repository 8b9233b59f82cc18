"""What a user states beside a text is in the situation, or is refused by its name."""

from __future__ import annotations

import pytest

from chatscene.errors import SettingsError
from chatscene.report.filled import filled
from chatscene.settings import RetrievalSettings
from chatscene.terms.surroundings import Light
from chatscene.terms.vocabulary import Act

BRAKES = "a car ahead brakes"


@pytest.mark.parametrize(
    ("text", "name", "value"),
    [
        (BRAKES, "side", "left"),
        (BRAKES, "actions", "brake,oncoming"),
    ],
)
def test_a_stated_fact_that_has_no_place_is_refused_by_its_name(text: str, name: str, value: str) -> None:
    with pytest.raises(SettingsError, match=name):
        filled(text, RetrievalSettings(), {name: value})


def test_a_stated_fact_that_is_what_nobody_says_has_its_place() -> None:
    assert filled(BRAKES, RetrievalSettings(), {"weather": "clear"}).situation.around.weather is None


def test_stated_facts_are_in_the_situation() -> None:
    made = filled(BRAKES, RetrievalSettings(), {"light": "night", "actions": "brake,stop"}).situation
    assert made.around.light is Light.NIGHT
    assert [deed.act for deed in made["A"].does] == [Act.STOP]


def test_a_name_of_no_fact_is_answered_with_what_can_be_set() -> None:
    with pytest.raises(SettingsError, match=r"did you mean 'side'\?.*known: .*others\.A\.starts\.side"):
        filled(BRAKES, RetrievalSettings(), {"sides": "left"})
