"""Facts that have names, as a situation: each of their values has a word there, and comes back as it was."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import pytest

from chatscene.interpret import situation_rows as rows
from chatscene.interpret.situation_of import in_a_situation
from chatscene.interpret.situation_rows import BESIDE, WHO
from chatscene.interpret.slots_of import facts_of, parties_of
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.scenario import (
    Control,
    EgoState,
    Maneuver,
    Occluder,
    Place,
    Position,
    Quantity,
    QuantityKind,
    Side,
    Site,
    Slots,
)
from chatscene.terms.surroundings import Light, Surroundings, Weather
from chatscene.terms.vocabulary import Act, Breach, Manner, UserKind
from chatscene.terms.vocabulary import Side as To

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
def test_each_value_of_a_fact_has_a_word_of_a_situation(words: Any, table: Mapping[Any, object]) -> None:
    assert set(words) - set(table) == set()


def test_each_body_has_the_plainest_kind_and_each_measure_stands_somewhere() -> None:
    assert {kind for kind in AdversaryKind if rows.KINDS[kind].row.body is not kind} == set()
    assert rows.KINDS[AdversaryKind.CAR] is UserKind.CAR
    placed = {
        QuantityKind.DISTANCE,
        QuantityKind.TRIGGER,
        QuantityKind.ASIDE,
        QuantityKind.EGO_SPEED,
    }  # of no deed of another
    assert set(QuantityKind) - placed - set(rows.AMOUNTS) == set()


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


def test_an_act_that_breaks_a_rule_or_has_a_pace_is_one_deed() -> None:
    runs = Slots(adversary=CAR, actions=(Action.CROSS, Action.RUN_LIGHT), side=Side.LEFT, position=Position.CROSSING)
    (deed,) = in_a_situation(runs, (), Surroundings())[WHO].does
    assert (deed.act, deed.breaks) == (Act.GO_STRAIGHT, Breach.RED_LIGHT)
    slow = replace(runs, actions=(Action.CROSS, Action.SLOW), position=Position.ROADSIDE, adversary=WALKS)
    (deed,) = in_a_situation(slow, (), Surroundings())[WHO].does
    assert (deed.act, deed.manner) == (Act.CROSS, Manner.SLOW)


@pytest.mark.parametrize("position", [Position.AHEAD, Position.ONCOMING])
@pytest.mark.parametrize("aside", [1, -1])
def test_to_which_side_of_its_own_somebody_swerves_comes_back(position: Position, aside: int) -> None:
    number = Quantity(measure=QuantityKind.ASIDE, value=aside, said="to a side")
    slots = Slots(adversary=CAR, actions=(Action.SWERVE,), position=position)
    there = in_a_situation(slots, (number,), Surroundings())
    to_its_left = aside == 1
    assert there[WHO].does[0].to is (To.LEFT if to_its_left is (position is Position.AHEAD) else To.RIGHT)
    parties = parties_of(there)
    assert parties is not None
    assert [one.value for one in facts_of(there, parties).quantities] == [aside]
