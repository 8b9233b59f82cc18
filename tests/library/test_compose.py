"""A behavior that nobody wrote does what was said, in order, and is the same whenever it is composed."""

from __future__ import annotations

from dataclasses import replace

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.errors import SnippetError
from chatscene.library.act_steps import STARTS
from chatscene.library.compose import Asked, compose, composed_again, goes_without_saying
from chatscene.library.load import library_with
from chatscene.library.plan_check import check_plan
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.acts import Action
from chatscene.terms.plan import Plan, waits_for_ego
from chatscene.terms.plan_text import parse_plan, print_plan
from chatscene.terms.scenario import Position, Side


def asked_of(said: str) -> Asked:
    kind, position, *actions = said.split()
    return Asked(kind=AdversaryKind(kind), position=Position(position), actions=tuple(map(Action, actions)))


def plan(said: str) -> Plan:
    made = compose(asked_of(said))
    assert made is not None
    return parse_plan(made.source)


@given(
    kind=st.sampled_from(AdversaryKind),
    position=st.sampled_from(sorted(STARTS)),
    actions=st.lists(st.sampled_from(Action), min_size=1, max_size=4, unique=True),
    junction=st.booleans(),
    held=st.booleans(),
)
@settings(max_examples=300, deadline=None)
def test_what_is_composed_is_a_plan_without_faults_and_follows_from_its_id(
    kind: AdversaryKind, position: Position, actions: list[Action], junction: bool, held: bool
) -> None:
    asked = Asked(kind=kind, position=position, actions=tuple(actions), junction=junction, ego_stands=held)
    made = compose(asked)
    if made is None:
        with pytest.raises(SnippetError, match="no step of a plan does that"):
            composed_again(asked.snippet_id)
        return
    assert composed_again(made.id) == made == library_with().get(made.id)
    parsed = parse_plan(made.source)
    assert print_plan(parsed) == made.source
    assert not list(check_plan(parsed, made.parameters))
    assert {p.name: (p.low, p.high) for p in made.parameters} == {p.name: (p.low, p.high) for p in parsed.parameters}
    assert (made.slots.actions, made.slots.position, made.adversaries) == (asked.actions, position, (kind,))
    assert not (held and waits_for_ego(parsed))


@pytest.mark.parametrize(
    ("said", "primitives"),
    [
        ("car ahead brake stop", ["PaceOnPath", "BrakeOnPath", "Halt"]),
        ("car ahead stop accelerate", ["PaceOnPath", "BrakeOnPath", "Halt", "ThrottleOnPath"]),
        (
            "bus ahead-beside cut-in reverse",
            ["PaceOnPath", "DrivePath", "BrakeOnPath", "Halt", "ReverseStraight", "Halt"],
        ),
        ("truck ahead slow", ["DrivePath"]),
        ("car ahead reverse stop", ["PaceOnPath", "BrakeOnPath", "Halt", "ReverseStraight", "Halt"]),
        ("motorcycle behind overtake brake", ["KeepStation", "DrivePath", "DrivePath", "BrakeOnPath"]),
        ("pedestrian roadside cross", ["Halt", "MoveAhead"]),
        ("pedestrian roadside cross stop turn-back", ["Halt", "MoveAhead", "MoveAhead", "Halt", "Halt", "MoveAhead"]),
        ("bicycle crossing cross", ["Halt", "DrivePath"]),
        ("car crossing slow cross", ["Halt", "DrivePath", "DrivePath"]),  # it comes up first, or the ego were gone
        ("car crossing turn-left stop", ["Halt", "DrivePath", "DrivePath", "BrakeOnPath", "Halt"]),
        ("car ahead stand", ["Halt"]),
        ("car ahead narrow", ["Halt"]),
        ("truck beyond block", ["Halt"]),
        ("box ahead stand", ["Halt"]),
        ("car behind stand", ["BrakeOnPath"]),
        ("car beside change-lane brake", ["PaceOnPath", "DrivePath", "BrakeOnPath"]),
    ],
)
def test_acts_are_done_one_after_the_other(said: str, primitives: list[str]) -> None:
    assert [phase.primitive for phase in plan(said).phases] == primitives


@pytest.mark.parametrize(
    "said",
    [
        "pedestrian ahead brake",  # nobody on foot drives in a lane
        "car ahead cut-in",  # it is in the lane
        "car behind stop overtake",  # who has stood does not overtake
        "car kerb brake",  # before it pulls out it has nothing to brake
        "car crossing run-light",  # no step for it
        "car ahead slow accelerate",  # nobody crawls all along and speeds up
        "car behind stop block",  # who stops behind us is in nobody's way
        "car beside brake pace",  # it was level from the beginning on
        "bus behind overtake",  # the ego is gone before it is past
        "box ahead brake",  # a thing lies
        "car beyond follow",  # nobody drives there
        "pedestrian ahead narrow",  # nobody on foot is as wide
        "car crossing stop cross",  # once it stands on the ego's line it has no way left to cross
    ],
)
def test_what_has_no_steps_or_not_in_that_order_is_not_composed(said: str) -> None:
    assert compose(asked_of(said)) is None


@pytest.mark.parametrize(
    ("said", "primitives"),
    [
        ("car ahead reverse", ["BrakeOnPath", "ReverseStraight", "Halt"]),  # it stands already
        ("car ahead brake", ["BrakeOnPath", "DrivePath", "BrakeOnPath"]),  # it drives off first
        ("truck beside swerve", ["BrakeOnPath", "SwerveOnPath", "DrivePath"]),
        ("pedestrian roadside cross", ["Halt", "MoveAhead"]),
        ("car kerb pull-out", ["Park", "DrivePath", "DrivePath", "DrivePath"]),
        ("bus behind overtake", ["KeepStation", "DrivePath", "DrivePath", "DrivePath"]),  # the ego is not gone
    ],
)
def test_nobody_waits_for_an_ego_that_stands(said: str, primitives: list[str]) -> None:
    made = compose(replace(asked_of(said), ego_stands=True))
    assert made is not None
    assert [phase.primitive for phase in parse_plan(made.source).phases] == primitives


@pytest.mark.parametrize("said", ["car beside pace", "car behind tailgate"])
def test_nobody_keeps_level_with_an_ego_that_stands_or_close_behind_it(said: str) -> None:
    assert compose(replace(asked_of(said), ego_stands=True)) is None


@pytest.mark.parametrize(("act", "side"), [("turn-right", Side.LEFT), ("turn-left", Side.RIGHT)])
def test_who_turns_across_the_ego_at_a_junction_comes_from_the_lane_on_its_other_side(act: str, side: Side) -> None:
    made = compose(replace(asked_of(f"car ahead-beside {act}"), junction=True))
    assert made is not None
    assert made.slots.side is side
    assert compose(asked_of(f"car ahead-beside {act}")) is None  # away from junctions there is nowhere to turn to


def test_more_acts_begin_sooner() -> None:
    def trigger(said: str) -> float:
        return next(p.low for p in plan(said).parameters if p.name == "OPT_ADV_DISTANCE")

    assert (
        trigger("car ahead brake") < trigger("car ahead brake accelerate") < trigger("car ahead brake accelerate stop")
    )


def test_who_rides_across_and_does_nothing_else_may_be_as_fast_as_in_test_protocols() -> None:
    def fastest(said: str) -> float:
        return next(p.high for p in plan(said).parameters if p.name == "OPT_ADV_SPEED")

    assert fastest("bicycle roadside cross") > 25 / 3.6
    assert fastest("bicycle roadside cross stop") == fastest("pedestrian roadside cross") == 4


def test_what_an_act_or_a_place_shows_by_itself_need_not_be_said() -> None:
    assert Action.STOP in goes_without_saying(asked_of("car ahead reverse"))
    assert Action.ONCOMING in goes_without_saying(asked_of("car oncoming brake"))
    assert Action.STOP not in goes_without_saying(asked_of("car ahead brake"))


@pytest.mark.parametrize(
    "wrong", ["behavior/composed.", "behavior/composed.car.ahead", "behavior/composed.ufo.ahead.brake"]
)
def test_an_id_that_says_nothing_that_can_be_composed_is_no_snippet(wrong: str) -> None:
    with pytest.raises(SnippetError, match="there is no snippet"):
        library_with().get(f"behavior/composed.{wrong}")
