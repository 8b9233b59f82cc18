"""What happened in a drive is told in order, with times and speeds, whoever made it."""

from __future__ import annotations

import json
import math
from pathlib import Path

import pytest
from click.testing import CliRunner

import chatscene
from chatscene.commands.main import main
from chatscene.errors import SettingsError

PNG = b"\x89PNG\r\n\x1a\n"


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
    assert any("60 m ahead of the ego and 6.0 m to its right, and stands" in line for line in lines)
    (brakes,) = [one for one in told.told if one.who == "the ego" and "from 36 km/h to 14 km/h" in one.what]
    assert (brakes.at, brakes.until) == (pytest.approx(2.0, abs=0.21), pytest.approx(4.0, abs=0.21))
    (crosses,) = [one for one in told.told if "(cross)" in one.what]
    assert crosses.at == pytest.approx(1.6, abs=0.21)
    assert any("nearest" in line for line in lines)


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
    assert "closing at 36 km/h" in told.told[-1].what


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
    assert any("2.1 s  the first (car) is not there any more" in line for line in lines)
    assert any("2.5 s  the late (car) is there from now on, 20 m ahead of the ego" in line for line in lines)
    assert "the ego runs into the late (car) (the ego's front, the other's rear)" in lines[-1]
    assert "the other at 0 km/h, closing at 36 km/h" in lines[-1]
    assert [note for note in told.notes if "after" in note] == ["not told of: after, who is there for a moment at most"]
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
    assert any("nearest: 0.0 m between the ego and the late" in one.what for one in told.told)


def test_of_many_the_nearest_are_told_of_and_how_many_are_not_is_said(tmp_path: Path) -> None:
    rows = ["time,id,kind,x,y,heading,speed,ego"]
    for step in range(20):
        rows += [f"{step / 10},car1,car,{step},0,0,10,1"]
        rows += [f"{step / 10},other{n},car,{40 + 10 * n},{5 + n},0,0,0" for n in range(8)]
    (tmp_path / "many.csv").write_text("\n".join(rows))
    told = chatscene.story(tmp_path / "many.csv")
    assert "2 more who are farther from the ego are not told of" in told.notes
    assert not any("other7" in one.who for one in told.told)
