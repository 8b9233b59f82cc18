from __future__ import annotations

import pytest

from chatscene.errors import EditRefused, NothingFits
from chatscene.interpret.amend import Amended, amended
from chatscene.interpret.choose import choose
from chatscene.interpret.decide import scenario_of
from chatscene.settings import RetrievalSettings
from chatscene.terms.scenario import Scenario
from chatscene.terms.snippet import ParameterRange

SETTINGS = RetrievalSettings()
WALKS = "A pedestrian crosses the road from the right."


def edit(text: str, *edits: str) -> Amended:
    scenario, done = scenario_of(text), None
    for one in edits:
        done = amended(scenario, one, SETTINGS)
        scenario = done.scenario
    assert done is not None
    return done


def ranges(scenario: Scenario) -> dict[str, ParameterRange]:
    _, triple = choose(scenario, SETTINGS)
    return {one.name: one for part in triple for one in part.parameters}


def test_an_edited_situation_is_served_like_a_sentence() -> None:
    told, _ = choose(edit(WALKS, "from the left", "hidden by a hedge").scenario, SETTINGS)
    assert told.behavior.snippet.id == "behavior/cross"
    assert told.spawn.snippet.id == "spawn/behind-hedge-left"


def test_what_a_guessed_reading_says_stays_where_it_is_not_named() -> None:
    text = "some fool on a bike shoots across the street right in front of my bonnet from the left hand side"
    before = scenario_of(text)
    assert before.frame is not None
    assert not before.frame.whole
    after = edit(text, "at night")
    assert [one.fact for one in after.changes] == ["light"]
    assert after.scenario.slots == before.slots


def test_faster_is_the_faster_half_of_what_the_program_has() -> None:
    before, after = ranges(scenario_of(WALKS)), ranges(edit(WALKS, "faster").scenario)
    was, now = before["OPT_ADV_SPEED"], after["OPT_ADV_SPEED"]
    assert (now.low, now.high) == pytest.approx(((was.low + was.high) / 2, was.high))
    assert {name: one for name, one in after.items() if one != now} == {
        name: one for name, one in before.items() if one != was
    }


def test_closer_twice_is_closer_than_closer() -> None:
    once, twice = ranges(edit(WALKS, "closer").scenario), ranges(edit(WALKS, "closer", "even closer").scenario)
    assert twice["OPT_GEO_Y"].high < once["OPT_GEO_Y"].high


def test_metres_that_are_said_are_those_by_which_a_range_moves() -> None:
    before, after = ranges(scenario_of(WALKS)), ranges(edit(WALKS, "5 m further away").scenario)
    assert after["OPT_GEO_Y"].low == pytest.approx(before["OPT_GEO_Y"].low + 5.0)


def test_a_comparison_without_a_parameter_is_refused() -> None:
    with pytest.raises(NothingFits, match="'faster': nothing that fits the rest can be set to it"):
        choose(edit("The car ahead of us brakes hard.", "faster").scenario, SETTINGS)


def test_changes_that_follow_are_marked_as_such() -> None:
    assert edit(WALKS, "we turn left").in_words() == [
        "maneuver: not said → left-turn",
        "place: not said → junction (follows)",
    ]


def test_only_a_sentence_can_be_edited() -> None:
    from dataclasses import replace

    with pytest.raises(EditRefused, match="a program of its own"):
        amended(replace(scenario_of(WALKS), frame=None), "at night", SETTINGS)


def test_the_ego_is_told_another_speed_though_no_snippet_can_be_set_to_it() -> None:
    done = edit("A car ahead brakes hard.", "we drive at 50 km/h")
    assert [one.fact for one in done.changes] == ["ego-speed"]
    told, _ = choose(done.scenario, SETTINGS)
    assert told.behavior.snippet.id == "behavior/lane-brake"
    assert any("50 km/h" in str(one.said) for one in told.unused)
    again = edit("We drive at 30 km/h. A car ahead brakes hard.", "we drive at 50 km/h").changes
    assert [(str(one.before), one.fact) for one in again] != [("()", "ego-speed")]
