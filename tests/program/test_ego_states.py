"""What the ego does at the pedals: how a program orders it, and what a drive shows of it, on speeds made by hand."""

from dataclasses import replace

import numpy as np
import pytest

from chatscene.library.load import load_library
from chatscene.program.assemble import assemble
from chatscene.program.meaning import EGO_STATES
from chatscene.program.orders import ORDERS
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.arrays import Array
from chatscene.terms.scenario import EgoState, Scenario, Slots, SubDescriptions
from chatscene.terms.scene import ScenicProgram

DT = 0.1
BLANK = SubDescriptions(behavior="", geometry="", spawn="")


def speeds(*legs: tuple[float, float]) -> Array:
    """Speeds [m/s], linear between the ends of legs: how many seconds, and the speed at their end."""
    found = [0.0]
    for seconds, end in legs:
        found += np.linspace(found[-1], end, round(seconds / DT) + 1)[1:].tolist()
    return np.array(found)


DRIVES = speeds((3, 8), (5, 8))
TOYS = {
    EgoState.STANDS: speeds((5, 0)),
    EgoState.SETS_OFF: speeds((1.5, 0), (3, 8)),
    EgoState.SLOW: speeds((1, 2.5), (5, 2.5)),
    EgoState.SLOWS_DOWN: speeds((3, 8), (2, 8), (3, 2)),
    EgoState.BRAKES: speeds((3, 8), (2, 8), (1, 2)),
    EgoState.STOPS: speeds((3, 8), (2, 8), (3, 0), (2, 0)),
}


@pytest.mark.parametrize("state", list(EgoState))
def test_a_state_is_seen_where_it_is(state: EgoState) -> None:
    assert EGO_STATES[state](TOYS[state], DT)


@pytest.mark.parametrize("state", list(EgoState))
def test_a_state_is_not_seen_in_a_drive_at_an_even_speed(state: EgoState) -> None:
    assert not EGO_STATES[state](DRIVES, DT)


def test_who_slows_down_neither_brakes_hard_nor_stops() -> None:
    assert not EGO_STATES[EgoState.BRAKES](TOYS[EgoState.SLOWS_DOWN], DT)
    assert not EGO_STATES[EgoState.STOPS](speeds((3, 8), (2, 5), (3, 5)), DT)


def test_who_is_hit_while_he_comes_to_a_stop_stops_once_he_has_lost_half_his_speed() -> None:
    late, early = speeds((3, 8), (1, 8), (2, 3)), speeds((3, 8), (1, 8), (1, 5))
    assert EGO_STATES[EgoState.STOPS](late, DT)
    assert not EGO_STATES[EgoState.STOPS](early, DT)


def test_every_state_has_its_orders_and_its_test() -> None:
    assert list(ORDERS) == list(EGO_STATES) == list(EgoState)


def program(state: EgoState | None, *, spawn: str = "behind-in-lane", behavior: str = "follow-lane") -> ScenicProgram:
    library = load_library()
    parts = (f"behavior/{behavior}", "geometry/straight-signalised", f"spawn/{spawn}")
    scenario = Scenario(id="toy", text="toy", base=None, parts=BLANK, slots=Slots(ego=state))
    behavior_, geometry, placed = (library.get(part) for part in parts)
    return assemble(scenario, (behavior_, geometry, placed), AdversaryKind.CAR)


@pytest.mark.parametrize("state", list(EgoState))
def test_a_program_differs_by_its_orders_alone_where_nobody_waits(state: EgoState) -> None:
    free, ordered = (program(one, spawn="ahead-in-lane") for one in (None, state))
    order = f", with orders ({ORDERS[state].source},)"
    assert order in ordered.source
    assert _lights(ordered).replace(order, "") == _lights(free)


def _lights(one: ScenicProgram) -> str:
    return one.source.replace("'ego-red'", "'ego-green'").replace('crossSignal = "green"', 'crossSignal = "red"')


@pytest.mark.parametrize("state", [EgoState.STANDS, EgoState.SETS_OFF])
def test_who_waits_begins_at_the_line_unless_somebody_is_between(state: EgoState) -> None:
    at_line = "param egoStart = 'at-line'"
    assert at_line in program(state).source
    assert at_line not in program(state, spawn="ahead-in-lane").source
    assert at_line not in program(None).source


def test_the_light_is_red_for_who_stands_there_unless_the_adversary_is_to_have_that() -> None:
    assert "'ego-red'" in program(EgoState.STANDS).source
    assert "'ego-green'" in program(EgoState.SETS_OFF).source
    assert "'ego-green'" in program(EgoState.STANDS, behavior="run-light", spawn="crossing-from-left").source


def test_orders_are_part_of_what_a_program_is() -> None:
    digests = {program(state).digest for state in (None, *EgoState)}
    assert len(digests) == len(EgoState) + 1


def test_slots_say_a_state_as_any_other_fact() -> None:
    assert replace(Slots(), ego=EgoState.SLOW).said() == {"ego": EgoState.SLOW}
