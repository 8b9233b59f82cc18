"""What a program has and a drive does not show is told: a result of an event that did not take place is none."""

from __future__ import annotations

from dataclasses import replace

import pytest

from chatscene.ego.policy import load_ego
from chatscene.library.waiting_words import begins_in_words, to_do_in_words
from chatscene.maps.network import resolve_map
from chatscene.measure.unplayed import unplayed
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.plan import PRIMITIVES, Kind, Name, Number, Phase
from chatscene.terms.plan_text import parse_plan
from chatscene.terms.scene import Scene, ScenicProgram

SOURCE = """model chatscene.world.model
param OPT_NEAR = Range(1, 60)
egoRoute = selectRoute(maneuver="straight")
leadWay = lineThrough((0.0, 0.0), (10.0, 0.0))

behavior Waves():
    do DrivePath(egoRoute, 7)

behavior AdvBehavior():
    {phases}

ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
AdvAgent = new Car at pointOn(egoRoute, 30), facing directionOn(egoRoute, 30), with behavior AdvBehavior()
"""
WAITS = "do DrivePath(egoRoute, 7) until gap(self, ego) < globalParameters.OPT_NEAR\n    do BrakeOnPath(egoRoute)"


@pytest.fixture(scope="module")
def simulator() -> Simulator:
    return load_simulator(resolve_map("town"), SimulationSettings(simulator="embedded", max_steps=40))


def driven(simulator: Simulator, phases: str, near: float = 1.0) -> tuple[ScenicProgram, Episode]:
    source = SOURCE.format(phases=phases)
    program = ScenicProgram(scenario_id="own", source=source, parameters=(), snippet_ids=(), own="own.scenic")
    scene = Scene(id="own/0", scenario_id="own", route=0, block=0, seed=0, values={"OPT_NEAR": near})
    episode = simulate(simulator, program, scene, load_ego("planner"))
    assert isinstance(episode, Episode)
    return program, episode


def test_a_phase_whose_condition_never_came_true_is_told_with_the_condition(simulator: Simulator) -> None:
    assert unplayed(*driven(simulator, WAITS)) == (
        "this never began: adversary was to brake along the ego's route, once it is less than OPT_NEAR m from the ego",
    )


def test_nothing_is_told_of_a_drive_in_which_every_phase_began(simulator: Simulator) -> None:
    assert unplayed(*driven(simulator, WAITS, near=60.0)) == ()


def test_who_waits_longer_than_the_drive_lasts_is_told(simulator: Simulator) -> None:
    told = unplayed(
        *driven(simulator, "do Park() for 60 seconds\n    do DrivePath(egoRoute, 5) for 1 seconds\n    do Park()")
    )
    assert told == (
        "this never began: adversary was to follow the ego's route at 5 m/s, after 60 s, and 1 more after that",
    )


def test_who_is_still_moving_over_along_its_line_as_the_drive_ends_has_begun_to(simulator: Simulator) -> None:
    over = "\n    ".join(f"do DrivePath(egoRoute, 7, {left}) for 3 seconds" for left in (2.0, 1.0, 0.5))
    assert unplayed(*driven(simulator, f"{over}\n    do DrivePath(egoRoute, 7)")) == ()


def test_a_round_of_a_loop_that_is_not_over_is_no_phase_that_never_began(simulator: Simulator) -> None:
    phases = (
        "while True:\n        do DrivePath(egoRoute, 7) for 1 seconds\n        do BrakeOnPath(egoRoute) for 1.5 seconds"
    )
    program, episode = driven(simulator, phases)
    assert unplayed(program, episode) == ()


def test_who_drives_on_where_the_followed_line_ends_is_told(simulator: Simulator) -> None:
    program, episode = driven(simulator, "do DrivePath(leadWay, 7)")
    there = episode.tracks[1]
    x, y = float(there.x[0]), float(there.y[0])
    ends = f"lineThrough(({x:.1f}, {y:.1f}), ({there.x[9]:.2f}, {there.y[9]:.2f}))"
    source = program.source.replace("lineThrough((0.0, 0.0), (10.0, 0.0))", ends)
    again = replace(program, source=source)
    drive = simulate(
        simulator,
        again,
        Scene(id="own/0", scenario_id="own", route=0, block=0, seed=0, values={"OPT_NEAR": 1.0}),
        load_ego("planner"),
    )
    assert isinstance(drive, Episode)
    assert unplayed(again, drive) == ("adversary drives on past the end of its line leadWay",)


def test_of_a_program_that_was_made_here_nothing_is_told_here(simulator: Simulator) -> None:
    program, episode = driven(simulator, WAITS)
    assert unplayed(replace(program, own=""), episode) == ()


def test_who_only_waits_for_the_next_event_has_not_left_out_what_it_is_doing(simulator: Simulator) -> None:
    brakes = "do BrakeOnPath(egoRoute, 0.5) until self.pose[3] < 0.1\n    do BrakeOnPath(egoRoute, 0.5) for 60 seconds"
    assert unplayed(*driven(simulator, f"{brakes}\n    do DrivePath(egoRoute, 5)")) == (
        "this never began: adversary was to follow the ego's route at 5 m/s, after 60 s",
    )
    waits = brakes.replace("< 0.1", "> 60")
    assert unplayed(*driven(simulator, f"{waits}\n    do DrivePath(egoRoute, 5)")) == (
        "this never began: adversary was to follow the ego's route at 5 m/s, once it drives at more than 60 m/s",
    )


def test_how_far_somebody_is_from_a_line_is_told_in_a_sentence(simulator: Simulator) -> None:
    waits = "do DrivePath(egoRoute, 7) until abs(offsetFrom(leadWay, self)) < 0.3\n    do BrakeOnPath(egoRoute)"
    (told,) = unplayed(*driven(simulator, waits))
    assert told.endswith(", once it is less than 0.3 m aside of leadWay")


@pytest.mark.parametrize(
    ("waits", "does", "told"),
    [
        (
            "FollowTraffic(wayA, 8) until headway(egoRoute, ego, self) - (ego.length + self.length) / 2 < 15",
            "ThrottleOnPath(wayA, globalParameters.OPT_A_THROTTLE, 0, 13.8889)",
            "accelerate, up to 13.9 m/s, once the ego is less than 15 m from it along the road",
        ),
        (
            "DrivePath(wayA, 8) until headway(egoRoute, ego, self) - ((ego.length + self.length) / 2 + 8) < 15",
            "BrakeOnPath(wayA, globalParameters.OPT_A_BRAKE)",
            "brake, once the ego is near enough to it along the road",
        ),
        (
            "Park() until secondsTo(egoRoute, ego, progressOn(egoRoute, self)[0]) < max(0, 2) / 1.4 + "
            "globalParameters.OPT_A_OFFSET or ego.pose[3] < 1",
            "DrivePath(besideA, 2)",
            "follow the lane beside at 2 m/s, once the ego is near enough in time to it or "
            "the ego drives at less than 1 m/s",
        ),
        (
            "PaceOnPath(wayA, ego) until abs(offsetFrom(ownLane(egoRoute), ego)) > 0.3",
            "SwerveOnPath(wayA, 8, globalParameters.OPT_A_BY)",
            "swerve at 8 m/s, once the ego is more than 0.3 m aside of the ego's first lane",
        ),
    ],
)
def test_what_never_began_is_told_without_the_names_of_a_built_program(waits: str, does: str, told: str) -> None:
    plan = parse_plan(f"behavior AdvBehavior():\n    do {waits}\n    do {does}\n")
    assert f"{to_do_in_words(plan.phases[1])}, {begins_in_words(plan.phases[0].end)}" == told


def test_every_primitive_has_words_for_what_was_to_be_done() -> None:
    for name, primitive in PRIMITIVES.items():
        number = {True: Number(2.5), False: Name("egoRoute", Kind.PATH)}
        phase = Phase(name, tuple(number[one.kind is Kind.NUMBER] for one in primitive.takes))
        assert not set(to_do_in_words(phase)) & set("[]{}")
