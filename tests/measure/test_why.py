"""Why a scene crashed, in toy scenes whose causes were planted."""

from __future__ import annotations

import itertools
from dataclasses import replace
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import chatscene
from blind import Blind
from chatscene.errors import RunError
from chatscene.maps.network import resolve_map
from chatscene.measure.counterfactual import (
    BEYOND,
    FINENESS,
    Braking,
    Trial,
    _Braking,  # pyright: ignore[reportPrivateUsage]
    _first_of_run,  # pyright: ignore[reportPrivateUsage]
    _Limited,  # pyright: ignore[reportPrivateUsage]
    _own_braking,  # pyright: ignore[reportPrivateUsage]
    highest_speed,
    last_moment,
    latest_braking,
    things_needed,
    values_needed,
)
from chatscene.measure.minimal import minimal
from chatscene.program.without import placings, without
from chatscene.runs import read_scenes
from chatscene.runs.crash import Contact, braking_in_words
from chatscene.runs.why import MIDDLE, back_of
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.simulate.striking import Strike
from chatscene.terms.criticality import Fault
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Scene, ScenicProgram
from chatscene.terms.snippet import ParameterRange
from fake_run import finished

HEAD = """model chatscene.world.model
{params}
egoRoute = selectRoute(maneuver="straight", place="road")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
"""
STANDING = """
behavior AdvBehavior():
    do Halt()

AdvAgent = new Car at pointOn(egoRoute, 30, {aside}), facing directionOn(egoRoute, 30), with behavior AdvBehavior()
"""
PARKED = """new Car at besideRoad(egoRoute, 10, "left", 1.5),
    facing directionOn(egoRoute, 10),
    with label "parked"
"""


def program(body: str, **ranges: tuple[float, float]) -> ScenicProgram:
    params = "\n".join(f"param OPT_{name} = Range({low}, {high})" for name, (low, high) in ranges.items())
    source = HEAD.format(params=params) + body
    return ScenicProgram(
        scenario_id="toy",
        source=source,
        parameters=tuple(
            ParameterRange(name=f"OPT_{name}", low=low, high=high, unit="m") for name, (low, high) in ranges.items()
        ),
        snippet_ids=(),
    )


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings())


def trial_in(simulator: Simulator, toy: ScenicProgram, **values: float) -> Trial:
    named = {f"OPT_{name}": value for name, value in values.items()}
    scene = Scene(id="toy/route-00/scene-000", scenario_id="toy", route=0, block=0, seed=0, values=named)
    episode = simulate(simulator, toy, scene, Blind())
    assert isinstance(episode, Episode)
    assert episode.collision is not None
    route = simulator.route_in(toy, scene).line
    return Trial(program=toy, scene=scene, ego=Blind(), simulator=simulator, episode=episode, route=route)


@settings(max_examples=40)
@given(
    failing=st.sets(st.frozensets(st.integers(0, 4)), max_size=8),
    count=st.integers(0, 5),
)
def test_what_delta_debugging_finds_fails_and_does_not_without_any_single_cause(
    failing: set[frozenset[int]], count: int
) -> None:
    causes = range(count)
    sets = failing | {frozenset(causes)}
    found = frozenset(minimal(causes, lambda kept: kept in sets))
    assert found in sets
    assert not any(found - {one} in sets for one in found)


def test_no_set_of_causes_is_tried_twice() -> None:
    asked: list[frozenset[int]] = []

    def fails(kept: frozenset[int]) -> bool:
        asked.append(kept)
        return {1, 6} <= kept

    assert minimal(range(8), fails) == (1, 6)
    assert len(asked) == len(set(asked))


def test_a_program_goes_without_a_statement_of_several_lines_and_keeps_what_it_names() -> None:
    toy = program(STANDING.format(aside=0) + PARKED + "tree = new Tree at 1 @ 1\nrequire tree.x > 0\n")
    adversary, parked, tree = placings(toy)
    assert [one.asked_for for one in (adversary, parked, tree)] == [False, False, True]
    left = without(toy, [parked])
    assert "parked" not in left.source
    assert left.source.count("\n") == toy.source.count("\n")
    assert left.digest != toy.digest


def test_what_a_behavior_places_or_a_comment_says_is_no_statement_that_places() -> None:
    assert placings(program("behavior B():\n    thing = new Car at 0 @ 0\n# new Car at 1 @ 1\n")) == ()


def test_where_one_value_alone_matters_just_that_one_is_named(simulator: Simulator) -> None:
    toy = program(
        STANDING.format(aside="globalParameters.OPT_ASIDE") + PARKED.replace("10", "globalParameters.OPT_IDLE"),
        ASIDE=(-12, 0),
        IDLE=(5, 20),
        UNUSED=(0, 1),
    )
    trial = trial_in(simulator, toy, ASIDE=0.0, IDLE=10.0, UNUSED=0.3)
    (needed,) = values_needed(trial, {"OPT_ASIDE": -9.0, "OPT_IDLE": 15.0, "OPT_UNUSED": 0.7})
    assert (needed.name, needed.value, needed.back) == ("OPT_ASIDE", 0.0, -9.0)
    assert needed.came.harmless
    assert needed.came.gap == pytest.approx(9.0 - 2.1, abs=0.3)  # less the width of a car


def test_of_every_subset_of_three_values_just_those_crash_that_hold_the_two_that_were_found(
    simulator: Simulator,
) -> None:
    aside = "-max(globalParameters.OPT_P, globalParameters.OPT_Q) - 0.01 * globalParameters.OPT_R"
    toy = program(STANDING.format(aside=aside), P=(0, 10), Q=(0, 10), R=(0, 1))
    trial = trial_in(simulator, toy, P=0.0, Q=0.5, R=0.1)
    mine, back = trial.scene.values, {"OPT_P": 8.0, "OPT_Q": 9.0, "OPT_R": 0.9}
    found = {one.name for one in values_needed(trial, back)}
    assert found == {"OPT_P", "OPT_Q"}
    for size in range(len(mine) + 1):
        for kept in itertools.combinations(mine, size):
            values = {name: mine[name] if name in kept else back[name] for name in mine}
            assert trial.drive(values=values).crashed == (found <= set(kept))


def test_values_are_set_back_to_the_nearest_scene_that_drove_past_and_else_to_the_middle(
    simulator: Simulator,
) -> None:
    toy = program(STANDING.format(aside="globalParameters.OPT_ASIDE"), ASIDE=(-12, 0))
    trial = trial_in(simulator, toy, ASIDE=-1.0)
    rows = [
        {
            "scene_id": f"toy/route-00/{aside}",
            "scenario_id": "toy",
            "route_id": "route-00",
            "block": 0,
            "seed": 0,
            "status": "ran",
            "collision": collided,
            "OPT_ASIDE": aside,
        }
        for aside, collided in ((-11.0, False), (-9.0, False), (-0.5, True))
    ]
    near, middle = back_of(trial, rows), back_of(trial, rows[2:])
    assert near is not None
    assert middle is not None
    assert (near.name, near.values) == ("toy/route-00/-9.0", {"OPT_ASIDE": -9.0})
    assert (middle.name, middle.values) == (MIDDLE, {"OPT_ASIDE": -6.0})
    assert near.came.harmless


def test_where_it_crashes_in_the_middle_of_the_ranges_too_no_value_is_needed(simulator: Simulator) -> None:
    toy = program(STANDING.format(aside="globalParameters.OPT_ASIDE"), ASIDE=(-1, 1))
    back = back_of(trial_in(simulator, toy, ASIDE=-0.8), [])
    assert back is not None
    assert back.came.crashed


def test_a_thing_for_which_the_adversary_stops_is_needed_and_a_parked_car_is_not(simulator: Simulator) -> None:
    body = """
behavior AdvBehavior():
    do FollowTraffic(egoRoute, 9)

AdvAgent = new Car at pointOn(egoRoute, 15), facing directionOn(egoRoute, 15), with behavior AdvBehavior()
new Car at pointOn(egoRoute, 60), facing directionOn(egoRoute, 60), with label "broken-down"
"""
    trial = trial_in(simulator, program(body + PARKED))
    assert trial.struck.actor == "adversary"
    told = {thing.actors: thing for thing in things_needed(trial)}
    assert {actors: thing.needed for actors, thing in told.items()} == {("broken-down",): True, ("parked",): False}
    assert told[("broken-down",)].why.startswith("no crash")


def test_the_adversary_is_not_needed_where_the_ego_runs_into_somebody_else(simulator: Simulator) -> None:
    body = STANDING.format(aside=-9) + "new Car at pointOn(egoRoute, 25), facing directionOn(egoRoute, 25)\n"
    told = things_needed(trial_in(simulator, program(body)))
    assert [(thing.actors, thing.needed) for thing in told] == [(("adversary",), False)]


def test_of_what_the_program_asks_for_elsewhere_nobody_can_tell(simulator: Simulator) -> None:
    body = STANDING.format(aside=0) + PARKED.replace("new Car", "other = new Car") + "require other.x != 0.5\n"
    (told,) = things_needed(trial_in(simulator, program(body)))
    assert (told.actors, told.needed) == (("parked",), None)


@pytest.mark.parametrize(
    ("speeds", "risk", "braked", "told"),
    [
        ([10.0] * 6, 0, (None, None), "it did not brake"),
        ([10.0, 10.0, 9.2, 8.4, 8.4, 8.4], 2, (1, 3), "it braked from 0.1 to 0.3 s, and let go"),
        ([10.0, 10.0, 9.2, 8.4, 8.4, 8.4], 3, (None, None), "it did not brake"),
        ([10.0, 10.0, 10.0, 9.2, 8.4, 7.6], 0, (2, None), "0.2 s earlier than it did"),
    ],
)
def test_a_braking_that_ended_before_the_contact_is_no_lack_of_one(
    speeds: list[float], risk: int, braked: tuple[int | None, int | None], told: str, simulator: Simulator
) -> None:
    trial = trial_in(simulator, program(STANDING.format(aside=0)))
    ego = trial.episode.ego_track
    rows = slice(0, len(speeds))
    short = replace(ego, x=ego.x[rows], y=ego.y[rows], heading=ego.heading[rows], speed=np.array(speeds))
    episode = replace(trial.episode, tracks=(short, *trial.episode.tracks[1:]))
    own, let_go = _own_braking(episode, len(speeds) - 1, risk)
    assert (own, let_go) == braked
    pace: Any = SimpleNamespace(dt=0.1, at=str)
    braking = Braking(step=0, own=own, let_go=let_go, deceleration=8.0)
    assert braking_in_words(braking, 0.5, None, pace).endswith(f"; {told}.")


def test_braking_later_than_what_is_found_crashes_and_earlier_does_not(simulator: Simulator) -> None:
    trial = trial_in(simulator, program(STANDING.format(aside=0)))
    found = latest_braking(trial)
    assert found is not None
    assert found.own is None
    crash = trial.crash.step
    speed = float(trial.episode.ego_track.speed[found.step])
    # From that speed the way to a standstill fits into what was driven from there to the contact, and hardly more.
    driven = float(trial.episode.ego_track.speed[found.step : crash].sum()) * 0.1
    stops = speed**2 / (2 * (found.deceleration + 0.2))
    assert stops < driven + 0.4
    assert stops > driven - 1.6

    def avoids(step: int) -> bool:
        return trial.instead(_Braking(Blind(), step), "safebench", crash)

    assert not any(avoids(step) for step in range(found.step + 1, crash))
    assert all(avoids(step) for step in range(found.step - BEYOND, found.step + 1))
    last = last_moment(trial)  # with more than twice the deceleration
    assert last is not None
    assert found.step < last < crash


def test_who_runs_into_a_standing_car_does_so_at_any_speed(simulator: Simulator) -> None:
    assert highest_speed(trial_in(simulator, program(STANDING.format(aside=0)))) is None


def test_who_goes_a_little_slower_comes_when_a_walker_has_crossed(simulator: Simulator) -> None:
    body = """
behavior AdvBehavior():
    do Halt() for 4.5 seconds
    do MoveAhead(4)

AdvAgent = new Pedestrian at besideRoad(egoRoute, 40, "right", 1), facing crossingDirection(egoRoute, 40, "right"),
    with behavior AdvBehavior()
"""
    trial = trial_in(simulator, program(body))
    found = highest_speed(trial)
    assert found is not None
    assert 0.0 < found.highest - found.limit < 4.0
    tried = round((found.highest - found.limit) / FINENESS)

    def avoids(less: int) -> bool:
        driver = _Limited(Blind(), found.highest - less * FINENESS, 0.1)
        return trial.instead(driver, "safebench", trial.crash.step)

    assert not avoids(tried - 1)
    assert all(avoids(less) for less in range(tried, tried + BEYOND + 1))


def test_a_change_that_avoids_it_by_luck_alone_is_passed_over() -> None:
    assert _first_of_run(range(20), {2, 3, 4, *range(9, 20)}.__contains__) == 9
    assert _first_of_run(range(5), {3, 4}.__contains__) == 3  # as far as there are so many
    assert _first_of_run(range(5), set[int]().__contains__) is None


def test_of_a_scene_without_a_crash_and_of_none_there_is_nothing_to_explain(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=1)
    calm = next(row["scene_id"] for row in read_scenes(run) if row["status"] == "ran" and not row["collision"])
    with pytest.raises(RunError, match="without a collision"):
        chatscene.why(run.path, calm)
    with pytest.raises(RunError, match="has no scene 'no-such' that was driven"):
        chatscene.why(run.path, "no-such")


@pytest.mark.parametrize(
    ("other", "kind", "said"),
    [
        ("adversary", "EmergencyVehicle", "the adversary (ambulance)"),
        ("bus-stop", "BusStop", "the bus-stop"),
    ],
)
def test_whom_the_ego_struck_is_told_in_words(other: str, kind: str, said: str) -> None:
    contact = Contact(
        time=2.0,
        other=other,
        kind=kind,
        fault=Fault.EGO_INTO_STATIC,
        strike=Strike(by_ego=True, static=True, foremost=(True, False), moving=False),
        ego_part="front",
        other_part="",
        ego_speed=6.0,
        other_speed=0.0,
        impact_speed=6.0,
    )
    words = contact.in_words({other: kind})
    assert f"ran into {said} with its front" in words
    assert kind not in words


def test_marks_within_a_text_are_no_code() -> None:
    source = 'a = new Car at (f(2), "lane #2 (old)"), \\\n    facing 1\nb = new Car at 0 @ 3  # (\n'
    assert [(one.first, one.last, one.named) for one in placings(program(source))] == [(4, 5, "a"), (6, 6, "b")]
