"""Standard output holds what was asked for, and nothing that code of a user's own prints."""

from __future__ import annotations

import json
import subprocess
import sys

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
