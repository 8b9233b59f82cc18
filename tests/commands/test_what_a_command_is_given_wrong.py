"""What a command is given wrong is told with what to write instead."""

from __future__ import annotations

from pathlib import Path

import pytest
from click.testing import CliRunner

from chatscene.commands.main import main

WRONG = {
    "a text without quotes": (
        ["explain", "the", "car", "ahead", "brakes"],
        "put the text in quotes: chatscene explain 'the car ahead brakes'",
    ),
    "a number with a unit": (
        ["run", "a car brakes", "--speed", "50km/h"],
        "'50km/h' is not a number; write it without a unit, such as 50",
    ),
    "a number in words": (
        ["run", "a car brakes", "--scenes", "four"],
        "'four' is not a whole number; write it in digits, such as 50",
    ),
    "no such file": (["verify", "nowhere", "a car brakes"], "no file or run folder 'nowhere'"),
    "another kind of file": (
        ["story", "hostname"],
        "the file 'hostname' has no ending, which is not a kind that can be read",
    ),
    "no folder of runs": (["sql", "select 1"], "no folder 'runs' here; start where your runs are"),
    "a town that there is not": (
        ["explain", "a car ahead brakes", "--map", "Town99"],
        "brings CARLA's towns: Town01 to Town07",
    ),
    "what is so already": (
        ["explain", "a van cuts in", "--edit", "make it a van"],
        "no fact changes by 'make it a van': it is already a van",
    ),
}


@pytest.mark.parametrize("case", WRONG)
def test_what_is_given_wrong_is_told_with_what_to_write_instead(
    case: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    Path("hostname").write_text("here\n")
    arguments, told = WRONG[case]
    answer = CliRunner().invoke(main, arguments, prog_name="chatscene")
    assert answer.exit_code in (1, 2, 3)
    assert told in " ".join(answer.stderr.split())
