"""A drive whose program asks for it ends when all is over: not before what is to come, and in every simulator alike."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from benchmarks.differing import differences
from chatscene.ego.asking import wanting
from chatscene.ego.policy import load_ego
from chatscene.errors import ProgramError
from chatscene.maps.network import resolve_map
from chatscene.measure.crash_type import waits
from chatscene.measure.score import measure, score
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.episode import Ending, Episode
from chatscene.terms.metrics import Mode
from chatscene.terms.scene import Scene, ScenicProgram

HEAD = """model chatscene.world.model
param drivesUntil = {asks!r}
{params}
egoRoute = selectRoute({query})
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute, with speed {speed},
    with wantedSpeed 7.8{ego}
behavior Does():
{behavior}
other = new {kind} at pointOn(egoRoute, {ahead}, {left}), facing directionOn(egoRoute, {ahead}{turned}),
    with behavior Does(), with role 'adversary'
"""
SCENE = Scene(id="own/0", scenario_id="own", route=0, block=0, seed=0, values={})
BRAKES = "do DrivePath(egoRoute, 7.8) for 1 seconds\n    do BrakeOnPath(egoRoute)"
WAITS = "do BrakeOnPath(egoRoute) until distanceLeft(egoRoute, ego, 30) < 0\n    do DrivePath(egoRoute, 5)"
CROSSES = "do Halt() until secondsTo(egoRoute, ego, 40) < 3\n    do MoveAhead(1.5)"


def program(
    behavior: str = BRAKES, *, kind: str = "Car", ahead: float = 20, left: float = 0, turned: float = 0,
    speed: float = 7.8, asks: str = "over", ego: str = "", params: str = "",
    query: str = "maneuver='straight', place='road'",
) -> ScenicProgram:  # fmt: skip
    source = HEAD.format(
        asks=asks,
        speed=speed,
        params=params,
        query=query,
        ego=ego,
        behavior=f"    {behavior}",
        kind=kind,
        ahead=ahead,
        left=left,
        turned=f", {turned}" if turned else "",
    )
    return ScenicProgram(scenario_id="own", source=source, parameters=(), snippet_ids=())


def crossing(asks: str = "over") -> ScenicProgram:
    return program(CROSSES, kind="Pedestrian", ahead=40, left=-4, turned=1.5708, asks=asks)


@cache
def simulator(name: str = "native", physics: str = "kinematic") -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings(simulator=name, physics=physics))


def driven(one: ScenicProgram, ego: str = "idm", by: Simulator | None = None) -> Episode:
    driver = wanting(load_ego(ego), one.wanted_speed)
    episode = simulate(by or simulator(), one, SCENE, driver)
    assert isinstance(episode, Episode)
    return episode


def test_two_that_stand_end_it_two_seconds_later_and_the_ego_waits_behind_the_other() -> None:
    episode = driven(program())
    assert (episode.ending, waits(episode)) == (Ending.OVER, True)
    both = [max(abs(track.speed[-k]) for track in episode.tracks) for k in (21, 22)]
    assert both[0] < 0.1 <= both[1]


def test_who_has_crossed_and_is_left_behind_ends_it_before_the_ego_arrives() -> None:
    episode, whole = driven(crossing()), driven(crossing("arrival"))
    assert (episode.ending, whole.ending) == (Ending.OVER, Ending.ARRIVED)
    assert episode.duration < whole.duration
    ego, walker = episode.tracks
    assert (ego.x == whole.ego_track.x[: len(ego.x)]).all(), "until then it is the same drive"
    assert ego.speed[-1] > 5.0
    assert abs(ego.x[-1] - walker.x[-1]) + abs(ego.y[-1] - walker.y[-1]) > 3.0 * ego.speed[-1]


def test_a_program_that_does_not_ask_for_it_drives_to_the_end_of_its_time() -> None:
    assert driven(program(asks="arrival")).ending is Ending.TIMEOUT


def test_another_end_is_refused() -> None:
    with pytest.raises(ProgramError, match="no drivesUntil 'som'; known: arrival, over"):
        driven(program(asks="som"))


def test_an_ego_that_waits_behind_who_acts_later_waits_for_that() -> None:
    later = "do DrivePath(egoRoute, 7.8) for 1 seconds\n    do BrakeOnPath(egoRoute) for 12 seconds\n    do {}"
    episode = driven(program(later.format("DrivePath(egoRoute, 7.8)")))
    assert episode.tracks[1].speed[130:].max() > 7.0, "it stood for some ten seconds, and set off again"


def test_an_ego_that_is_ordered_to_set_off_later_does_so_before_it_is_over() -> None:
    episode = driven(program("do Park()", ahead=45, left=8, ego=", with orders (Order(at_most=0, till=9),)"))
    assert abs(episode.ego_track.speed[60]) < 0.1
    assert episode.ego_track.speed[-1] > 5.0


def test_a_light_that_changes_is_awaited_by_an_ego_that_stands() -> None:
    changes = 4.5
    for braking in (1.0, 0.5):
        light = program(
            f"do BrakeOnPath(egoRoute, {braking})",
            ahead=12,
            params="param signals = 'ego-turns-red'",
            query="maneuver='straight', control='signal'",
        )
        assert driven(light).duration >= changes


def test_an_ego_that_stands_before_whom_waits_for_it_ends_it_after_five_seconds() -> None:
    episode = driven(program(WAITS))
    assert episode.ending is Ending.OVER
    stood = [max(abs(track.speed[-k]) for track in episode.tracks) for k in (51, 52)]
    assert stood[0] < 0.1 <= stood[1]


def test_an_ego_that_never_set_off_is_not_over() -> None:
    assert driven(program("do Park()", ahead=6, speed=0)).ending is Ending.TIMEOUT


def test_one_that_follows_at_the_same_speed_for_five_seconds_has_seen_all() -> None:
    episode = driven(program("do DrivePath(egoRoute, 3)"))
    assert episode.ending is Ending.OVER
    assert abs(episode.ego_track.speed[-1] - 3.0) < 0.5


SLOWER = program("do DrivePath(egoRoute, 5.6)", ego=", with orders (Order(at_most=5),)")
"""Who is ahead draws slowly away from an ego that keeps its speed."""


def test_one_that_draws_away_slowly_from_an_ego_that_keeps_its_speed_ends_it() -> None:
    episode = driven(SLOWER)
    assert episode.ending is Ending.OVER
    apart = np.hypot(*(getattr(episode.tracks[1], of) - getattr(episode.ego_track, of) for of in "xy"))
    assert apart[-1] > apart[-50] + 1.0


def test_a_drive_that_was_over_did_not_fail() -> None:
    episode = driven(crossing())
    assert episode.route_completion < 1.0 == episode.completion
    measured = measure(episode)
    assert (measured.completion, measured.time) == (1.0, None)
    assert score([measured], mode=Mode.CORRECTED).time_spent == 0.0
    stuck = driven(program())
    assert stuck.completion == stuck.route_completion < 1.0


CASES = {
    "stand": program(),
    "cross": crossing(),
    "follow": program("do DrivePath(egoRoute, 3)"),
    "slower": SLOWER,
    "wait": program(
        "do BrakeOnPath(egoRoute) until distanceLeft(egoRoute, ego, 30) < 0\n    do DrivePath(egoRoute, 5)"
    ),
    "junction": program("do WaitFor(ego, egoRoute, 7)", ahead=8, left=9, query="maneuver='left-turn'"),
    "orders": program("do Park()", ahead=45, left=8, ego=", with orders (Order(at_most=0, till=6),)"),
}


@pytest.mark.parametrize("case", CASES)
@pytest.mark.parametrize("ego", ["idm", "planner"])
def test_the_engine_ends_it_at_the_same_step(case: str, ego: str) -> None:
    native, embedded = driven(CASES[case], ego), driven(CASES[case], ego, simulator("embedded"))
    assert native.stepped.by == "native"
    assert (native.ending, differences(native, embedded)) == (embedded.ending, [])


@pytest.mark.parametrize("by", [("confined", "kinematic"), ("embedded", "lagged")])
def test_so_do_all_simulators(by: tuple[str, str]) -> None:
    episode = driven(program(), by=simulator(*by))
    assert episode.ending is Ending.OVER
    if by[1] == "kinematic":
        assert not differences(driven(program()), episode)
