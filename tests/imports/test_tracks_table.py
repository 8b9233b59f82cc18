"""A table of tracks is read by the names of its columns, and what is wrong with it is told with the line."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from chatscene.errors import ScenarioError
from chatscene.imports.recording import recording
from chatscene.imports.tracks_table import read_table

HEAD = "time,id,kind,x,y,heading,speed,ego\n"


def made(tmp_path: Path, text: str) -> Path:
    path = tmp_path / "drive.csv"
    path.write_text(text)
    return path


def test_columns_may_stand_in_any_order_and_have_others_beside_them(tmp_path: Path) -> None:
    text = "frame,Speed,y,x,kind,id,time,heading,ego\n" + "".join(
        f"{k},5,1,{k * 0.5},truck,7,{k / 10},0,true\n" for k in range(5)
    )
    found = recording(read_table(made(tmp_path, text)), "drive.csv")
    assert found.tracks[0].kind == "Truck"
    assert found.tracks[0].x.tolist() == pytest.approx([0.0, 0.5, 1.0, 1.5, 2.0])


def test_other_steps_than_ours_are_made_even(tmp_path: Path) -> None:
    text = HEAD + "".join(f"{k * 0.25},e,car,{k * 2.5},0,{3.0 + k},10,1\n" for k in range(9))
    (ego,) = recording(read_table(made(tmp_path, text)), "drive.csv").tracks
    assert len(ego.x) == 21
    assert np.allclose(np.diff(ego.x), 1.0)
    assert np.allclose(np.diff(ego.heading), 0.4)


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("", "no column time"),
        ("time,id\n", "no column kind"),
        (HEAD, "nobody"),
        (HEAD + "0,e,car,0,0,0,nan,1\n", "line 2: the speed 'nan'"),
        (HEAD + "0,e,car,0,0,0\n", "line 2: the speed ''"),
        (HEAD + "0,,car,0,0,0,1,1\n", "line 2: it has no id"),
        (HEAD + "0,e,car,0,0,0,1,1\n0,e,car,1,0,0,1,1\n", "e is in two rows at 0 s"),
        (HEAD + "0,e,car,0,0,0,1,1\n", "has 0.0 s"),
        (HEAD + "0,e,car,0,0,0,1,0\n1,e,car,1,0,0,1,0\n", "marks 0 road users as the ego"),
        (HEAD + "0,e,ufo,0,0,0,1,1\n1,e,ufo,1,0,0,1,1\n", "no kind of road user 'ufo'"),
        (HEAD + "0,e,car,0,0,0,1,1\n5000,e,car,1,0,0,1,1\n", "has 5000.0 s"),
        (HEAD + '0,e,"' + "x" * 200_000, "not a table"),
    ],
)
def test_what_is_no_drive_is_told_with_its_place(tmp_path: Path, text: str, told: str) -> None:
    with pytest.raises(ScenarioError, match=told):
        recording(read_table(made(tmp_path, text)), "drive.csv")


def test_who_is_never_there_while_the_ego_is_is_left_out_and_told(tmp_path: Path) -> None:
    ego = "".join(f"{k / 10},e,car,{k},0,0,10,1\n" for k in range(50))
    late = "".join(f"{k / 10},late,car,{k},9,0,10,0\n" for k in range(60, 65))
    found = recording(read_table(made(tmp_path, HEAD + ego + late)), "drive.csv")
    assert [one.actor for one in found.tracks] == ["ego"]
    assert found.notes == ("left out: late, which is not there while the ego is",)
