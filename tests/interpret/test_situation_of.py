"""What the offline reader decides of a text, as a situation: each of its words has one, and an edit reads them back."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import pytest

from chatscene.interpret import situation_rows as rows
from chatscene.interpret.offline import OfflineReader
from chatscene.interpret.situation_of import in_a_situation
from chatscene.interpret.situation_rows import BESIDE, HIDES, WHO
from chatscene.interpret.slots_of import facts_of, parties_of
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import Control, EgoState, Maneuver, Measure, Occluder, Place, Position, Side, Site, Slots
from chatscene.terms.situation import Situation
from chatscene.terms.surroundings import Light, Surroundings, Weather
from chatscene.terms.vocabulary import Act, Breach, Manner, UserKind, Where

TABLES: list[tuple[Any, Mapping[Any, object]]] = [
    (Action, rows.ACTS),
    (Position, rows.STARTS),
    (Place, rows.ROADS),
    (Site, rows.SITES),
    (Occluder, rows.HIDING),
    (EgoState, rows.EGO_DOES),
    (Control, rows.RULES),
    (Maneuver, rows.ROUTES),
]


@pytest.mark.parametrize(("words", "table"), TABLES, ids=lambda one: getattr(one, "__name__", ""))
def test_each_word_of_the_reader_has_one_of_a_situation(words: Any, table: Mapping[Any, object]) -> None:
    assert set(words) - set(table) == set()


def test_each_body_has_the_plainest_kind_and_each_measure_stands_somewhere() -> None:
    assert {kind for kind in AdversaryKind if rows.KINDS[kind].row.body is not kind} == set()
    assert rows.KINDS[AdversaryKind.CAR] is UserKind.CAR
    placed = {Measure.DISTANCE, Measure.TRIGGER, Measure.ASIDE, Measure.EGO_SPEED}  # of no deed of another
    assert set(Measure) - placed - set(rows.AMOUNTS) == set()


def read(text: str) -> Situation:
    return OfflineReader().read(text).ranked[0].situation


@pytest.mark.parametrize(
    ("text", "speed", "words"),
    [
        ("We drive at 50 km/h. A car ahead brakes hard.", "50 km/h", "drive at 50 km/h"),
        ("The VUT travels at 45 mph and the car ahead brakes at 6 m/s2.", "45 mph", "travels at 45 mph"),
        ("At 30 km/h we approach a truck that stands in our lane.", "30 km/h", "at 30 km/h"),
        ("The car ahead brakes while we drive at 50 km/h.", "50 km/h", "drive at 50 km/h"),
    ],
)
def test_a_speed_that_is_said_of_the_ego_is_the_egos(text: str, speed: str, words: str) -> None:
    made = read(text)
    assert str(made.ego.speed) == speed
    assert made.evidence.quoted["ego.speed"].lower() == words.lower()
    assert all(deed.speed is None for one in made.others for deed in one.does)


def test_a_speed_that_is_said_of_another_is_not_the_egos() -> None:
    made = read("A car crosses from the left at 50 km/h towards us.")
    assert made.ego.speed is None
    assert str(made.others[0].does[0].speed) == "50 km/h"


CAR, WALKS, RIDES = AdversaryKind.CAR, AdversaryKind.PEDESTRIAN, AdversaryKind.BICYCLE


@pytest.mark.parametrize(
    "slots",
    [
        Slots(adversary=CAR, actions=(Action.BRAKE,), position=Position.AHEAD),
        Slots(adversary=CAR, actions=(Action.STOP,), position=Position.AHEAD),
        Slots(adversary=WALKS, actions=(Action.CROSS,), side=Side.LEFT, position=Position.ROADSIDE),
        Slots(adversary=RIDES, actions=(Action.CROSS, Action.STOP), side=Side.RIGHT, position=Position.ROADSIDE),
        Slots(adversary=WALKS, actions=(Action.CROSS, Action.TURN_BACK), side=Side.LEFT, position=Position.ROADSIDE),
        Slots(adversary=CAR, actions=(Action.CUT_IN,), side=Side.LEFT, position=Position.AHEAD_BESIDE),
        Slots(adversary=CAR, actions=(Action.PULL_OUT,), side=Side.RIGHT, position=Position.KERB),
        Slots(adversary=CAR, actions=(Action.TAILGATE,), position=Position.BEHIND),
        Slots(adversary=CAR, actions=(Action.ONCOMING,), position=Position.ONCOMING),
        Slots(adversary=CAR, actions=(Action.WRONG_WAY,), position=Position.ONCOMING),
        Slots(adversary=CAR, actions=(Action.SWERVE,), position=Position.ONCOMING),
        Slots(adversary=RIDES, actions=(Action.WEAVE,), side=Side.RIGHT, position=Position.BESIDE),
        Slots(adversary=WALKS, actions=(Action.CROSS, Action.FAST), side=Side.LEFT, position=Position.ROADSIDE),
        Slots(
            adversary=CAR, actions=(Action.TURN_LEFT,), position=Position.ONCOMING, place=Place.FOUR_WAY,
            control=Control.SIGNAL, maneuver=Maneuver.STRAIGHT,
        ),
        Slots(
            adversary=CAR, actions=(Action.CROSS,), side=Side.LEFT, position=Position.CROSSING, place=Place.JUNCTION,
            control=Control.STOP_SIGN, maneuver=Maneuver.LEFT_TURN,
        ),
        Slots(
            adversary=WALKS, actions=(Action.CROSS,), side=Side.RIGHT, position=Position.ROADSIDE, group=True,
            occluder=Occluder.PARKED_TRUCK,
        ),
        Slots(
            adversary=WALKS, actions=(Action.CROSS,), side=Side.RIGHT, position=Position.ROADSIDE,
            occluder=Occluder.BUS_STOP,
        ),
        Slots(adversary=CAR, actions=(Action.FOLLOW,), position=Position.BEHIND, ego=EgoState.STANDS),
        Slots(adversary=CAR, actions=(Action.OVERTAKE,), position=Position.ONCOMING, leader=True),
        Slots(adversary=CAR, actions=(Action.ONCOMING,), position=Position.ONCOMING, blocker=True,
              maneuver=Maneuver.BYPASS),
        Slots(adversary=CAR, actions=(Action.BRAKE,), position=Position.AHEAD, lanes=2, two_way=False),
    ],
    ids=str,
)  # fmt: skip
def test_what_both_can_say_comes_back_as_it_was(slots: Slots) -> None:
    there = in_a_situation(slots, (), Surroundings(light=Light.NIGHT, weather=Weather.FOG))
    parties = parties_of(there)
    assert parties is not None
    back = facts_of(there, parties)
    assert back.slots == slots
    assert (back.surroundings.light, back.surroundings.weather) == (Light.NIGHT, Weather.FOG)
    assert in_a_situation(back.slots, (), back.surroundings) == there


def test_two_who_do_something_come_back_as_two() -> None:
    truck = Slots(adversary=AdversaryKind.TRUCK, actions=(Action.ONCOMING,), position=Position.ONCOMING)
    slots = Slots(
        adversary=WALKS, actions=(Action.CROSS,), side=Side.RIGHT, position=Position.ROADSIDE, others=(truck,)
    )
    there = in_a_situation(slots, (), Surroundings())
    assert [one.id for one in there.others] == [WHO, BESIDE[0]]
    parties = parties_of(there)
    assert parties is not None
    assert facts_of(there, parties).slots == slots


@pytest.mark.parametrize(
    ("text", "kind", "count"),
    [
        ("A van ahead of us brakes hard.", UserKind.VAN, 1),
        ("A taxi ahead of us brakes hard.", UserKind.CAR, 1),
        ("A child runs out from the left.", UserKind.CHILD, 1),
        ("Two children run out from the left.", UserKind.CHILD, 2),
        ("Three pedestrians cross the road from the right.", UserKind.PEDESTRIAN, 3),
        ("A group of pedestrians crosses the road from the right.", UserKind.PEDESTRIAN, 0),
        ("A lorry ahead of us brakes hard.", UserKind.TRUCK, 1),
    ],
)
def test_somebody_is_what_the_words_call_them_and_as_many(text: str, kind: UserKind, count: int) -> None:
    who = read(text)[WHO]
    assert (who.kind, who.count) == (kind, count)


def test_each_of_two_has_the_words_that_tell_of_it() -> None:
    quoted = read("An oncoming truck drives on while a pedestrian crosses the road from the right.").evidence.quoted
    assert quoted["others.A.kind"] == "a pedestrian"
    assert quoted["others.A.does"] == "crosses the road"
    assert quoted["others.B.kind"] == "An oncoming truck"
    assert quoted["others.B.does"] == "drives on"


def test_who_runs_into_us_touches_us_and_who_nearly_does_or_only_has_parts_does_not() -> None:
    struck = read("While we wait at a red light, a car drives into us from behind.")
    assert struck.contact is not None
    assert struck.contact.happens
    assert struck.evidence.quoted["contact.happens"] == "drives into us from behind"
    assert struck.evidence.assumed == ()
    near = OfflineReader().read("A lorry nearly hits us as it changes lanes.")
    assert near.ranked[0].situation.contact is None
    assert near.unread == ("nearly hits",)
    assert read("A car cuts in from the left.").contact is None


def test_an_act_that_breaks_a_rule_or_has_a_pace_is_one_deed() -> None:
    runs = Slots(adversary=CAR, actions=(Action.CROSS, Action.RUN_LIGHT), side=Side.LEFT, position=Position.CROSSING)
    (deed,) = in_a_situation(runs, (), Surroundings())[WHO].does
    assert (deed.act, deed.breaks) == (Act.GO_STRAIGHT, Breach.RED_LIGHT)
    slow = replace(runs, actions=(Action.CROSS, Action.SLOW), position=Position.ROADSIDE, adversary=WALKS)
    (deed,) = in_a_situation(slow, (), Surroundings())[WHO].does
    assert (deed.act, deed.manner) == (Act.CROSS, Manner.SLOW)


def test_who_hides_somebody_is_there_and_named() -> None:
    said = read("A pedestrian steps out from behind a parked truck on the right.")
    assert said[WHO].hidden_by == HIDES
    assert (said[HIDES].kind, said[HIDES].starts.where) == (UserKind.TRUCK, Where.KERB)
    assert "truck" in said.evidence.quoted[f"others.{HIDES}"]


def test_a_speed_that_no_deed_has_is_what_somebody_drove_at_before() -> None:
    text = "Target vehicle ahead in the ego lane at 40 km/h decelerates with 5 m/s² to standstill."
    (first, *_) = OfflineReader().read(text).ranked
    who = first.situation["A"]
    assert str(who.starts.speed) == "40 km/h"
    assert [deed.act for deed in who.does] == [Act.STOP]
    assert first.left_out == ()


def test_who_cuts_in_from_an_arm_of_a_junction_comes_into_our_lane() -> None:
    (first, *_) = OfflineReader().read("A car from the left arm of the junction cuts in front of us.").ranked
    assert [deed.act for deed in first.situation["A"].does] == [Act.ENTER]
