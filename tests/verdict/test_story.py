"""What happened in a drive is told in order, with times and speeds, whoever made it."""

from __future__ import annotations

import json
import math
from collections.abc import Callable
from pathlib import Path

import pytest
from click.testing import CliRunner

import chatscene
from chatscene.commands.main import main
from chatscene.errors import RunError, SettingsError
from fake_run import finished, started

PNG = b"\x89PNG\r\n\x1a\n"
State = tuple[float, float, float, float]
"""x [m], y [m], heading [rad], speed [m/s]."""


@pytest.fixture
def drive(tmp_path: Path) -> Path:
    """An ego at 10 m/s that brakes from 2 s to 4 s, down to 4 m/s, and a walker who crosses from its right at 1.5 s."""
    rows, x = ["time,id,kind,x,y,heading,speed,ego"], 0.0
    for step in range(100):
        now = step / 10
        speed = 10.0 - 3.0 * min(max(now - 2.0, 0.0), 2.0)
        y = -6.0 + 1.5 * max(0.0, now - 1.5)
        rows.append(f"{now},car1,car,{x},0,0,{speed},1")
        rows.append(f"{now},walker,pedestrian,60,{y},{math.pi / 2},{1.5 if now > 1.5 else 0},0")
        x += speed / 10
    path = tmp_path / "drive.csv"
    path.write_text("\n".join(rows))
    return path


def test_who_does_what_when_and_how_fast_is_told_in_order(drive: Path) -> None:
    told = chatscene.story(drive)
    lines = [str(one) for one in told.told]
    assert [one.at for one in told.told] == sorted(one.at for one in told.told)
    assert any("the ego goes at 36 km/h" in line for line in lines)
    assert any("60 m ahead of the ego and 6.0 m to its right, and is stationary" in line for line in lines)
    (brakes,) = [one for one in told.told if one.who == "the ego" and "from 36 km/h to 14 km/h" in one.what]
    assert (brakes.at, brakes.until) == (pytest.approx(2.0, abs=0.21), pytest.approx(4.0, abs=0.21))
    (crosses,) = [one for one in told.told if "(cross)" in one.what]
    assert crosses.at == pytest.approx(1.6, abs=0.21)
    assert any("closest" in line for line in lines)


def test_who_comes_from_the_next_lane_cuts_in_and_neither_crosses_nor_weaves(tmp_path: Path) -> None:
    rows = ["time,id,kind,x,y,heading,speed,ego"]
    for step in range(100):
        now = step / 10
        across = 3.5 - 3.5 * min(max((now - 3.0) / 2.0, 0.0), 1.0)
        slant = -math.atan2(1.75, 12.0) if 3.0 < now < 5.0 else 0.0
        rows.append(f"{now},car1,car,{10 * now},0,0,10,1")
        rows.append(f"{now},car2,car,{15 + 12 * now},{across},{slant},12,0")
    path = tmp_path / "drive.csv"
    path.write_text("\n".join(rows))
    acts = [
        act for act in ("cross", "weave", "cut-in") if any(f"({act})" in one.what for one in chatscene.story(path).told)
    ]
    assert acts == ["cut-in"]


def test_a_moment_is_a_picture_and_one_after_the_end_is_refused(drive: Path) -> None:
    told = chatscene.story(drive)
    assert told.picture().startswith(PNG)
    assert told.picture(4.0).startswith(PNG)
    for never in (-1.0, 99.0, math.nan):
        with pytest.raises(SettingsError, match=r"the drive is from 0\.0 to"):
            told.picture(never)


def test_the_command_says_it_and_writes_the_picture(drive: Path, tmp_path: Path) -> None:
    picture = tmp_path / "moment.png"
    said = CliRunner().invoke(main, ["story", str(drive), "--picture", str(picture), "--at", "3"])
    assert said.exit_code == 0, said.output
    assert "the ego goes at 36 km/h" in said.output
    assert picture.read_bytes().startswith(PNG)
    as_json = json.loads(CliRunner().invoke(main, ["story", str(drive), "--json"]).output)
    assert as_json["told"][0]["at"] == 0.0
    assert CliRunner().invoke(main, ["story", str(drive), "--at", "3"]).exit_code == 2


def test_a_collision_is_told_with_who_ran_into_whom(tmp_path: Path) -> None:
    rows = ["time,id,kind,x,y,heading,speed,ego"]
    for step in range(60):
        now = step / 10
        rows += [f"{now},car1,car,{10 * now},0,0,10,1", f"{now},other,car,30,0,0,0,0"]
    (tmp_path / "crash.csv").write_text("\n".join(rows))
    told = chatscene.story(tmp_path / "crash.csv")
    assert told.ending == "collision"
    assert "the ego runs into the other (car)" in told.told[-1].what
    assert "impact speed 36 km/h" in told.told[-1].what


RAGGED = """time,id,kind,x,y,heading,speed,ego
0,car1,car,0,0,0,10,1
6,car1,car,60,0,0,10,1
0,first,car,-30,4,0,5,0
2,first,car,-20,4,0,5,0
2.5,late,car,{late},0,0,0,0
6,late,car,{late},0,0,0,0
{after},after,car,100,9,0,0,0
6,after,car,100,9,0,0,0
"""


def test_who_comes_later_and_is_hit_is_told_and_so_is_who_goes_and_who_is_left_out(tmp_path: Path) -> None:
    path = tmp_path / "ragged.csv"
    path.write_text(RAGGED.format(late=45, after=5.9))
    told = chatscene.story(path)
    lines = [str(one) for one in told.told]
    assert any("2.1 s  the first (car) is no longer there" in line for line in lines)
    assert any("2.5 s  the late (car) is there from now on, 20 m ahead of the ego" in line for line in lines)
    assert "the ego runs into the late (car), front to rear" in lines[-1]
    assert "the other at 0 km/h, impact speed 36 km/h" in lines[-1]
    assert [note for note in told.notes if "after" in note] == ["not described: after, present only for a moment"]
    for moment in (None, 0.0, 2.5, 4.1):
        assert told.picture(moment).startswith(PNG)
    verdict = chatscene.verify(path, "A car is ahead of us in our lane.")
    assert verdict.draws[0].collision == "A"
    assert verdict.who == {"A": "late"}


def test_who_comes_and_goes_and_was_not_spoken_of_is_said_not_to_be_judged_and_a_contact_with_it_is(
    tmp_path: Path,
) -> None:
    path = tmp_path / "ragged.csv"
    path.write_text(
        RAGGED.format(late=45, after=5.9) + "0,walker,pedestrian,50,-6,1.57,1.4,0\n6,walker,pedestrian,50,2,1.57,1.4,0"
    )
    verdict = chatscene.verify(path, "A pedestrian crosses from the right.")
    assert verdict.who == {"A": "walker"}
    assert "not judged, except contacts: first, late, absent for part of that time" in verdict.notes
    assert [one.path for one in verdict.unasked] == ["unasked.contact"]


def test_who_is_there_from_inside_the_ego_is_no_collision(tmp_path: Path) -> None:
    path = tmp_path / "load.csv"
    path.write_text(RAGGED.format(late=25, after=1))
    told = chatscene.story(path)
    assert told.ending == "timeout"
    assert any("closest: less than 0.1 m between the ego and the late" in one.what for one in told.told)


def test_of_many_the_nearest_are_told_of_and_how_many_are_not_is_said(tmp_path: Path) -> None:
    rows = ["time,id,kind,x,y,heading,speed,ego"]
    for step in range(20):
        rows += [f"{step / 10},car1,car,{step},0,0,10,1"]
        rows += [f"{step / 10},other{n},car,{40 + 10 * n},{5 + n},0,0,0" for n in range(8)]
    (tmp_path / "many.csv").write_text("\n".join(rows))
    told = chatscene.story(tmp_path / "many.csv")
    assert "not described: 2 farther from the ego" in told.notes
    assert not any("other7" in one.who for one in told.told)


def told_by(path: Path, ego: Callable[[float], State], **others: Callable[[float], State]) -> list[str]:
    """The lines of the story of 8 s in which each is at x, y with a heading and a speed, by the time."""
    rows = ["time,id,kind,x,y,heading,speed,ego"]
    for step in range(81):
        now = step / 10
        rows.append(f"{now},ego,car,{','.join(map(str, ego(now)))},1")
        rows += [f"{now},{name},car,{','.join(map(str, who(now)))},0" for name, who in others.items()]
    path.write_text("\n".join(rows))
    return [str(one) for one in chatscene.story(path).told]


def along(x: float, y: float, speed: float = 15.0) -> Callable[[float], State]:
    return lambda now: (x + speed * now, y, 0.0, speed)


def over(x: float, y: float, to: float, speed: float = 15.0) -> Callable[[float], State]:
    """Along the road, from one line to another from 2 s to 5 s."""

    def state(now: float) -> State:
        share = min(max((now - 2.0) / 3.0, 0.0), 1.0)
        slant = math.atan2((to - y) / 3.0, speed) if 0.0 < share < 1.0 else 0.0
        return x + speed * now, y + (to - y) * share, slant, speed

    return state


def test_who_keeps_its_lane_while_the_ego_moves_over_does_not_cut_in(tmp_path: Path) -> None:
    lines = told_by(tmp_path / "over.csv", over(0.0, 0.0, 3.5), A=along(1.0, 3.5))
    assert not [
        line for line in lines if any(f"({act})" in line for act in ("cut-in", "cross", "enter", "lane-change"))
    ]
    assert "the ego's left side touches the car's right side" in lines[-1]


def test_who_was_never_in_the_lane_of_the_ego_changes_lanes_and_does_not_leave_that(tmp_path: Path) -> None:
    lines = told_by(tmp_path / "out.csv", along(0.0, 0.0), A=over(40.0, 3.5, 7.0), B=over(80.0, 0.0, 3.5))
    assert [line for line in lines if "car A changes lanes to its left (lane-change)" in line]
    assert [line for line in lines if "car B leaves the ego's lane to the left (cut-out)" in line]
    assert sum("(cut-out)" in line for line in lines) == 1


def test_two_who_meet_head_on_run_into_each_other(tmp_path: Path) -> None:
    lines = told_by(tmp_path / "on.csv", along(0.0, 0.0), A=lambda now: (100.0 - 15.0 * now, 0.0, math.pi, 15.0))
    assert "the ego and the car run into each other, front to front" in lines[-1]


def brakes(now: float) -> State:
    """20 m/s, from 1 s on 1 m/s² less, from 4 s on 6 m/s²."""
    gentle, hard = min(max(now - 1.0, 0.0), 3.0), max(now - 4.0, 0.0)
    stops = min(hard, 17.0 / 6.0)
    x = 100.0 + 20.0 * min(now, 1.0) + 20.0 * gentle - gentle**2 / 2 + 17.0 * stops - 3.0 * stops**2
    return x, 3.5, 0.0, 20.0 - gentle - 6.0 * stops


def test_to_slow_down_gently_and_then_to_brake_are_two(tmp_path: Path) -> None:
    lines = told_by(tmp_path / "two.csv", along(0.0, 0.0), A=brakes)
    (gentle,) = [line for line in lines if "the car loses speed gently (slow-down)" in line]
    (hard,) = [line for line in lines if "the car loses speed hard (brake)" in line]
    assert "from 72 km/h to 61 km/h, at up to 1.0 m/s²" in gentle
    assert "from 61 km/h to 0 km/h and stops, at up to 6.0 m/s²" in hard
    assert float(hard.split()[0]) == pytest.approx(4.0, abs=0.11)


def test_who_gains_speed_unevenly_does_not_lose_it(tmp_path: Path) -> None:
    def gains(now: float) -> State:
        speed = 8.0 + 0.5 * now - 0.3 * (int(10 * now) % 5 == 0)
        return 30.0 + 8.0 * now + 0.25 * now**2, 3.5, 0.0, speed

    lines = [line for line in told_by(tmp_path / "up.csv", along(0.0, 0.0, 5.0), A=gains) if "m/s²" in line]
    assert lines and all("gains speed (accelerate)" in line for line in lines)


def test_who_turns_back_is_told_to_do_so_once_and_not_to_have_crossed(tmp_path: Path) -> None:
    rows = ["time,id,kind,x,y,heading,speed,ego"]
    for step in range(81):
        now = step / 10
        came, back = 1.5 * min(now, 4.0), 1.5 * min(max(now - 4.0, 0.0), 3.0)
        rows.append(f"{now},car1,car,{5 * now},0,0,5,1")
        rows.append(f"{now},walker,pedestrian,70,{-6.0 + came - back},{math.pi / 2 * (1 if now < 4 else -1)},1.5,0")
    (tmp_path / "back.csv").write_text("\n".join(rows))
    lines = [str(one) for one in chatscene.story(tmp_path / "back.csv").told]
    assert sum("(turn-back)" in line for line in lines) == 1
    assert len(set(lines)) == len(lines)
    assert [line for line in lines if "(cross), unfinished at the end" in line]


def test_a_run_that_was_interrupted_says_so_and_names_no_scene(tmp_path: Path) -> None:
    with pytest.raises(RunError, match="was interrupted; continue with: chatscene resume"):
        chatscene.story(started(tmp_path / "run").path)


def test_a_scene_that_a_run_does_not_have_is_told_with_those_that_it_has(tmp_path: Path) -> None:
    run = finished(tmp_path / "run", count=2)
    with pytest.raises(RunError, match=r"has no scene 'nobody' that was driven, but .*scene-000, .*scene-001"):
        chatscene.story(run.path, scene="nobody")


def test_who_brakes_hard_for_a_moment_alone_is_said_to_do_so_for_a_moment(tmp_path: Path) -> None:
    def dabs(now: float) -> State:
        lost = 1.5 * min(max(now - 2.0, 0.0), 2.0) + (0.6 if now >= 3.0 else 0.0)
        return 100.0 + 18.0 * now, 3.5, 0.0, 20.0 - lost

    lines = told_by(tmp_path / "dab.csv", along(0.0, 0.0), A=dabs)
    (gentle,) = [line for line in lines if "the car loses speed gently (slow-down)" in line]
    assert "m/s² for a moment" in gentle


def test_how_hard_speed_is_gained_is_no_dab_of_the_brake_within_it(tmp_path: Path) -> None:
    def gains(now: float) -> State:
        dab = 0.8 * max(0.0, 1.0 - (now - 4.0) / 2.0) if now >= 4.0 else 0.0
        return 10.0 * now, 0.0, 0.0, 5.0 + 2.0 * min(max(now - 2.0, 0.0), 5.0) - dab

    (gained,) = [line for line in told_by(tmp_path / "drive.csv", gains) if "(accelerate)" in line]
    assert "from 18 km/h to 54 km/h" in gained
    peak = float(gained.rpartition("at up to ")[2].partition(" m/s²")[0])
    assert peak == pytest.approx(2.4, abs=0.1)
