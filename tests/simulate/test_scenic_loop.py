"""A drive that is stepped from outside ends where Scenic's own loop ends it."""

from typing import Any

import pytest
from scenic.core.dynamics import GuardViolation, RejectSimulationException

from chatscene.ego.observation import Observation
from chatscene.ego.rule_based import RuleBased
from chatscene.maps.network import resolve_map
from chatscene.search.generators.foreign import foreign_program
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.simulate.staging import Stage
from chatscene.simulate.stock import scenic_simulator
from chatscene.terms.episode import Ending, Episode
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

TOWN = resolve_map("town")
SETTINGS = SimulationSettings()
SCENE = Scene(id="toy/0", scenario_id="toy", route=0, block=0, seed=0, values={})
PROGRAM = """model chatscene.world.model
egoRoute = selectRoute(maneuver="straight")
behavior AdvBehavior():
    {behavior}
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
adv = new Car at pointOn(egoRoute, 30), facing directionOn(egoRoute, 30), with behavior AdvBehavior()
{rest}
"""
AWAY = "do DrivePath(egoRoute, 8)"  # the gap grows from 30 m
GAP = "(distance from ego to adv)"
MONITOR = "monitor M():\n    while True:\n        {0}\n        wait\nrequire monitor M()"

ENDINGS: dict[str, tuple[str, str]] = {
    "a time in seconds": (AWAY, "terminate after 2 seconds"),
    "a time that is no whole number of steps": (AWAY, "terminate after 0.25 seconds"),
    "a time in steps": (AWAY, "terminate after 7 steps"),
    "a condition": (AWAY, f"terminate when {GAP} > 40"),
    "a condition that holds at once": (AWAY, f"terminate when {GAP} > 10"),
    "a condition on the simulation": (AWAY, f"terminate simulation when {GAP} > 40"),
    "two at the same step": (AWAY, f"terminate when {GAP} > 40\nterminate simulation when {GAP} > 40"),
    "always, kept": (AWAY, f"require always {GAP} > 20\nterminate after 5 seconds"),
    "always, broken": (AWAY, f"require always {GAP} < 40"),
    "always, broken in the last state": (AWAY, f"require always {GAP} < 40\nterminate when {GAP} > 40"),
    "eventually, kept": (AWAY, f"require eventually {GAP} > 40\nterminate after 5 seconds"),
    "eventually, kept in the last state": (AWAY, f"require eventually {GAP} > 40\nterminate when {GAP} > 40"),
    "eventually, broken": (AWAY, f"require eventually {GAP} > 400\nterminate after 5 seconds"),
    "eventually, broken at the limit of steps": (AWAY, f"require eventually {GAP} > 400"),
    "always eventually, broken": (AWAY, f"require always (eventually {GAP} < 32)\nterminate after 5 seconds"),
    "until, kept": (AWAY, f"require ({GAP} < 45) until ({GAP} > 40)\nterminate after 5 seconds"),
    "until, broken": (AWAY, f"require ({GAP} < 35) until ({GAP} > 40)\nterminate after 5 seconds"),
    "next, broken": (AWAY, f"require next {GAP} > 40\nterminate after 5 seconds"),
    "implies, kept": (
        AWAY,
        f"require always (({GAP} > 40) implies (eventually {GAP} > 50))\nterminate after 5 seconds",
    ),
    "a plain requirement": (AWAY, f"require {GAP} > 20\nterminate after 1 seconds"),
    "a monitor that ends": (AWAY, MONITOR.format(f"if {GAP} > 40:\n            terminate")),
    "a monitor that ends the simulation": (AWAY, MONITOR.format(f"if {GAP} > 40:\n            terminate simulation")),
    "a monitor that rejects": (AWAY, MONITOR.format(f"require {GAP} < 40")),
    "a monitor at the limit of time": (AWAY, MONITOR.format(f"require {GAP} < 38") + "\nterminate after 2 seconds"),
    "a behavior that ends": (f"{AWAY} for 2 seconds\n    terminate", ""),
    "a behavior that ends too early": (f"{AWAY} for 2 seconds\n    terminate", f"require eventually {GAP} > 400"),
    "a behavior that ends the simulation": (f"{AWAY} for 2 seconds\n    terminate simulation", ""),
    "a behavior that ends the simulation too early": (
        f"{AWAY} for 2 seconds\n    terminate simulation",
        f"require eventually {GAP} > 400",
    ),
    "a behavior that ends at once": ("terminate", ""),
    "a behavior that requires": ("for i in range(10):\n        wait\n    require 1 > 2", ""),
    "a guard that never held": (f"precondition: {GAP} > 40\n    {AWAY}", ""),
    "a guard that fails": (f"invariant: {GAP} < 31\n    while True:\n        take SetSpeedAction(8)", ""),
    "nothing": (AWAY, ""),
}


class Coast:
    """An ego that does nothing, as in Scenic's own loop, where nobody drives it."""

    def act(self, observation: Observation) -> tuple[float, float]:
        return 0.0, 0.0


def toy(behavior: str, rest: str) -> ScenicProgram:
    source = PROGRAM.format(behavior=behavior, rest=rest)
    return ScenicProgram(scenario_id="toy", source=source, parameters=(), snippet_ids=())


@pytest.fixture(scope="module")
def stage() -> Stage:
    return Stage(TOWN)


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(TOWN, SETTINGS)


def by_scenic(stage: Stage, program: ScenicProgram) -> tuple[str, int]:
    """How Scenic's own loop ends, in the same simulator: whether rejected, and after how many steps."""
    placed: Any = stage.place(program, SCENE)
    assert not isinstance(placed, Rejected)
    try:
        simulation = scenic_simulator(SETTINGS.simulator, str(TOWN)).createSimulation(
            placed, maxSteps=SETTINGS.max_steps, name="x", timestep=SETTINGS.dt
        )
    except (RejectSimulationException, GuardViolation) as rejection:
        return "rejected", rejection.simulation.currentTime  # type: ignore[union-attr]
    return "ended", simulation.currentTime


def by_us(simulator: Simulator, program: ScenicProgram) -> tuple[str, int]:
    drive = simulator.open(program, SCENE)
    if isinstance(drive, Rejected):
        return "rejected", 0
    try:
        while drive.ending is None and not drive.rejection:
            drive.step((0.0, 0.0))
        if drive.rejection:
            assert drive.ending is None
            return "rejected", drive.step_number
        assert len(drive.episode("toy/0", "coast").ego_track.x) == drive.step_number + 1
        return "ended", drive.step_number
    finally:
        drive.close()


@pytest.mark.parametrize("name", ENDINGS)
def test_a_drive_ends_as_scenic_ends_it_and_after_as_many_steps(name: str, stage: Stage, simulator: Simulator) -> None:
    program = toy(*ENDINGS[name])
    assert by_us(simulator, program) == by_scenic(stage, program)


def test_the_differing_programs_end_in_every_way(stage: Stage) -> None:
    outcomes = {by_scenic(stage, toy(*ENDINGS[name])) for name in ENDINGS}
    assert {"ended", "rejected"} == {how for how, _ in outcomes}
    assert len({steps for _, steps in outcomes}) >= 8


def test_a_time_limit_of_two_seconds_ends_after_two_seconds(simulator: Simulator) -> None:
    episode = simulate(simulator, toy(AWAY, "terminate after 2 seconds"), SCENE, RuleBased())
    assert isinstance(episode, Episode)
    assert episode.ending is Ending.SCENARIO_DONE
    assert len(episode.ego_track.x) == 21


def test_a_drive_that_ends_by_a_collision_is_rejected_if_what_must_happen_did_not(simulator: Simulator) -> None:
    crash = toy("do Park()", "")
    assert isinstance(simulate(simulator, crash, SCENE, _Blind()), Episode)
    outcome = simulate(simulator, toy("do Park()", "require eventually 1 > 2 as never"), SCENE, _Blind())
    assert isinstance(outcome, Rejected)
    assert "never" in outcome.reason


class _Blind:
    """An ego that holds the pedal down."""

    def act(self, observation: Observation) -> tuple[float, float]:
        return 1.0, 0.0


def test_a_stranger_s_drive_is_judged_behind_the_walls_as_before_them(simulator: Simulator) -> None:
    with ConfinedSimulator(TOWN, SETTINGS) as confined:
        for name in (
            "a time in seconds",
            "eventually, broken",
            "a behavior that ends",
            "a condition that holds at once",
        ):
            program = foreign_program("toy", PROGRAM.format(behavior=ENDINGS[name][0], rest=ENDINGS[name][1]))
            assert by_us(confined, program) == by_us(simulator, program)


def test_a_name_that_a_program_sets_while_it_runs_is_as_it_was_in_the_next_scene() -> None:
    source = """
model chatscene.world.model
times = 0
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
behavior Counting():
    global times
    times = times + 1
    do MoveAhead(times)
other = new Car at pointOn(egoRoute, 60), facing directionOn(egoRoute, 60), with behavior Counting()
"""
    program = ScenicProgram(scenario_id="counting", source=source, parameters=(), snippet_ids=())
    scene = Scene(id="counting/0", scenario_id="counting", route=0, block=0, seed=0, values={})
    simulator = load_simulator(resolve_map("town"), SimulationSettings())
    first, second = (simulate(simulator, program, scene, RuleBased()) for _ in range(2))
    assert isinstance(first, Episode)
    assert isinstance(second, Episode)
    assert first.tracks[1].speed.max() == second.tracks[1].speed.max() > 0.5
