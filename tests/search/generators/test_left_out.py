"""What of a user's own program has no effect on its drives is told first, not left away in silence."""

from __future__ import annotations

from pathlib import Path

import pytest

import chatscene
from chatscene.search.generators.foreign import foreign_program
from chatscene.search.generators.left_out import left_out

THEIRS = """{before}
model scenic.simulators.carla.model
EGO_SPEED = 9
{params}
behavior Slow():
    take SetBrakeAction(globalParameters.BRAKE)
ego = new Car on road, with behavior FollowLaneBehavior(target_speed=EGO_SPEED)
other = new Car ahead of ego by 20, with behavior Slow()
{after}
"""
DRIVER = (
    "the ego under test replaces the program's ego, so its behavior FollowLaneBehavior(target_speed=EGO_SPEED) is not "
    "used; --as-written keeps it"
)


def told(params: str = "", *, before: str = "", after: str = "", as_written: bool = False) -> tuple[str, ...]:
    source = THEIRS.format(params=f"param BRAKE = 0.5\n{params}", before=before, after=after)
    return left_out(foreign_program("theirs", source, as_written=as_written))


def test_the_behavior_of_the_programs_own_ego_is_told_unless_it_drives() -> None:
    assert told() == (DRIVER,)
    assert told(as_written=True) == ()


@pytest.mark.parametrize("param", ["weather = 'HardRainNoon'", "time = 22", "SPEED = Range(3, 5)"])
def test_a_parameter_that_nothing_reads_is_told(param: str) -> None:
    assert told(f"param {param}") == (DRIVER, f"param {param} has no effect here: nothing reads it")


def test_what_only_reaches_a_simulator_and_what_the_program_reads_is_not_told() -> None:
    assert told("param carla_map = 'Town05'\nparam render = 0", before="param map = localPath('town.xodr')") == (
        DRIVER,
    )


def test_weather_that_is_read_with_a_light_is_not_told() -> None:
    assert told("param light = 'night', weather = 'rain'") == (DRIVER,)


def test_a_record_is_told_since_a_run_keeps_the_tracks_alone() -> None:
    assert told(after="record (distance from ego to other) as gap") == (
        DRIVER,
        "`record distance from ego to other` is not kept; the tracks of all road users are",
    )


def test_of_a_program_for_our_model_that_says_what_is_read_nothing_is_told() -> None:
    source = """model chatscene.world.model
param light = 'night', weather = 'rain'{more}
egoRoute = selectRoute(maneuver="straight")
behavior AdvBehavior():
    do DrivePath(egoRoute, 5)
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
AdvAgent = new Car at pointOn(egoRoute, 30), facing directionOn(egoRoute, 30), with behavior AdvBehavior()
"""
    assert left_out(foreign_program("own", source.format(more=""))) == ()
    assert left_out(foreign_program("own", source.format(more=", wind = 3"), trusted=True)) == (
        "param wind = 3 has no effect here: nothing reads it",
    )


def test_it_stands_before_any_number_of_a_run(tmp_path: Path) -> None:
    program = tmp_path / "mine.scenic"
    program.write_text(
        """model chatscene.world.model
param time = 22
egoRoute = selectRoute(maneuver="straight")
behavior AdvBehavior():
    do DrivePath(egoRoute, 5)
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
AdvAgent = new Car at pointOn(egoRoute, 30), facing directionOn(egoRoute, 30), with behavior AdvBehavior()
"""
    )
    run = chatscene.run(program=program, scenes=1, folder=tmp_path / "run", simulator="embedded", trust=True)
    first = "param time = 22 has no effect here: nothing reads it"
    assert run.told_first == [first]
    assert str(run).startswith(first)
    assert first in run.report.read_text().split("</header>")[0]
