"""Standard output holds what was asked for, and nothing that code of a user's own prints."""

from __future__ import annotations

import json
import subprocess
import sys

import pytest
from click.testing import CliRunner

from chatscene.commands.main import main

CODE = """
import json, os, subprocess, sys
import click
from chatscene.commands.options import JSON
from chatscene.commands.output import say

@click.command()
@JSON
def command(as_json):
    print("printed")
    os.write(1, b"written\\n")
    subprocess.run([sys.executable, "-c", "print('by a worker')"], check=True)
    say(json.dumps({"egos": ["idm", "\u00e9"]}) if as_json else "text")

command()
"""


def test_where_json_is_asked_for_it_is_alone() -> None:
    ran = subprocess.run([sys.executable, "-c", CODE, "--json"], capture_output=True, text=True, check=True)
    assert json.loads(ran.stdout) == {"egos": ["idm", "é"]}
    assert sorted(ran.stderr.split("\n")) == ["", "by a worker", "printed", "written"]


def test_else_all_of_it_is_there() -> None:
    ran = subprocess.run([sys.executable, "-c", CODE], capture_output=True, text=True, check=True)
    assert sorted(ran.stdout.split("\n")) == ["", "by a worker", "printed", "text", "written"]
    assert ran.stderr == ""


@pytest.mark.parametrize("command", [["explain", "nowhere.yaml"], ["run", "nowhere.yaml"], ["replay", "nowhere"]])
def test_an_error_is_json_to_who_reads_that(command: list[str]) -> None:
    told = CliRunner().invoke(main, [*command, "--json"])
    assert told.exit_code == 1
    error = json.loads(told.stdout)
    assert "nowhere" in error["message"]
    assert error["error"].endswith("Error")
    assert error["message"] in told.stderr
