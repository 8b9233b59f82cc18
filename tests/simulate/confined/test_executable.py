"""Somebody else's program behind the walls of the kernel: it gets its file, gives its text, and nothing else."""

from __future__ import annotations

import os
import re
import sys
from pathlib import Path

import pytest

from chatscene.simulate.confined.confinement import Limits
from chatscene.simulate.confined.executable import GIVEN, Ended, Executable, run_confined
from chatscene.simulate.confined.landlock import landlock_version

pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="the walls are those of Linux")

LIMITS = Limits(processor=1, wall=20.0, memory=256, message=100_000)


def _ran(code: str, folder: Path, limits: Limits = LIMITS) -> Ended:
    given = folder / "given, ${HOME}.txt"
    given.write_text("what was given")
    program = Executable(
        command=(os.path.realpath(sys.executable), "-I", "-S", "-c", code),
        readable=(sys.base_prefix,),
        environment={"ONLY": "this"},
    )
    return run_confined(program, (GIVEN,), given, limits)


def test_a_program_reads_its_file_and_what_it_writes_comes_back(tmp_path: Path) -> None:
    ended = _ran("import sys; print(open(sys.argv[1]).read()); print('a\\x1b\\nb', file=sys.stderr)", tmp_path)
    assert ended == Ended(fault="", output=b"what was given\n", said=("a?", "b"))


TRIES = """
import os, socket, sys
def tried(do):
    try:
        do()
    except (OSError, RuntimeError):
        return "no"
    return "yes"
there = os.path.dirname(os.readlink(sys.argv[1]))
print(*[tried(do) for do in (
    lambda: open(there + "/secret").read(),
    lambda: open(there + "/left", "w"),
    lambda: open(sys.argv[1], "r+"),
    lambda: socket.create_connection(("127.0.0.1", 9), 1),
    os.fork,
    lambda: os.kill(os.getppid(), 0),
    lambda: os.execv("/bin/sh", ["sh", "-c", "true"]),
)], sorted(os.environ))
"""


def test_a_program_can_neither_look_round_nor_leave_anything_nor_start_another(tmp_path: Path) -> None:
    (tmp_path / "secret").write_text("x")
    ended = _ran(TRIES, tmp_path)
    assert ended.fault == "", ended.said
    *said, environment = ended.output.decode().split(maxsplit=7)
    assert environment.strip() == "['LC_CTYPE', 'ONLY']"
    assert said[1:6] == ["no"] * 5
    if landlock_version():
        assert said == ["no"] * 7
    assert sorted(path.name for path in tmp_path.iterdir()) == ["given, ${HOME}.txt", "secret"]


@pytest.mark.parametrize(
    ("code", "fault"),
    [
        ("import sys; sys.exit(3)", r"it gave up \(exit status 3\)"),
        ("import os; os.abort()", r"it crashed \(SIG\w+\)"),
        ("while True: pass", r"it used up its processor time \(1 s\)"),
        ("while True: print('x' * 1000)", "it wrote more than 0 MB"),
        ("x = bytearray(2**30)", r"it gave up \(exit status 1\)"),
    ],
)
def test_a_program_that_does_not_end_as_it_should_is_told_why(code: str, fault: str, tmp_path: Path) -> None:
    ended = _ran(code, tmp_path)
    assert re.fullmatch(fault, ended.fault), ended


def test_a_program_that_waits_is_ended(tmp_path: Path) -> None:
    ended = _ran("import time; time.sleep(60)", tmp_path, Limits(processor=2, wall=0.5, memory=256))
    assert ended.fault == "it had not ended after 0.5 s"
