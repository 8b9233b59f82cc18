"""Whatever is wrong with what a command is given, it says so in one message, with its status, and leaves nothing."""

from __future__ import annotations

import re
import socket
import sys
import webbrowser
from collections.abc import Iterator
from importlib.machinery import ModuleSpec
from pathlib import Path

import click
import pytest
from click.testing import CliRunner

from chatscene.commands.main import main
from chatscene.commands.options import Named
from chatscene.maps import network, roads_file
from chatscene.read.learned import reader
from chatscene.runs import rebuild
from chatscene.simulate.confined.nursery import Nursery
from chatscene.simulate.native.simulator import NativeSimulator
from chatscene.simulate.stepped import SteppedSimulator
from fake_run import finished

SITUATION = "others:\n- {id: A, kind: car, starts: {where: ahead}, does: [{act: brake}]}\n"
BAD = (
    "no-such",
    "a-folder",
    "nan",
    "",
    "x" * 5000,
    "/proc/x",
    "empty.yaml",
    "binary.yaml",
    "binary.npz",
    "binary.xodr",
)
NUMBERS = ("nan", "-1", "9" * 30)
HEAVY = ("carla", "mcp", "optuna", "ray", "stable_baselines3", "torch")


class Begun(BaseException):
    """The work of a command begins: what it was given is taken."""


def begins(*_: object, **__: object) -> None:
    raise Begun


class _Heavy:
    """Finds packages that only work itself needs."""

    @staticmethod
    def find_spec(name: str, *_: object) -> ModuleSpec | None:
        if name.partition(".")[0] in HEAVY:
            raise Begun
        return None


def commands(at: click.Command = main, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], click.Command]]:
    """Every command, and how it is called."""
    if not isinstance(at, click.Group):
        yield path, at
        return
    for name, command in at.commands.items():
        yield from commands(command, (*path, name))


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a run and with files that are none, in which no work is done."""
    for simulator in (NativeSimulator, SteppedSimulator):
        monkeypatch.setattr(simulator, "open", begins)
    monkeypatch.setattr(Nursery, "_started", begins)
    monkeypatch.setattr(reader, "prepared", begins)
    monkeypatch.setattr(network, "_parse", begins)
    monkeypatch.setattr(roads_file, "read", begins)
    monkeypatch.setattr(rebuild, "read_ranges", begins)
    for name in ("bind", "connect", "listen"):
        monkeypatch.setattr(socket.socket, name, begins)
    monkeypatch.setattr(webbrowser, "open", begins)
    monkeypatch.setattr(sys, "meta_path", [_Heavy, *sys.meta_path])
    for name in [name for name in sys.modules if name.partition(".")[0] in HEAVY]:
        monkeypatch.delitem(sys.modules, name)
    monkeypatch.chdir(tmp_path)
    finished(tmp_path / "run")
    (tmp_path / "a-folder").mkdir()
    (tmp_path / "said.yaml").write_text(SITUATION)
    (tmp_path / "empty.yaml").write_text("")
    for name in (name for name in BAD if name.startswith("binary")):
        (tmp_path / name).write_bytes(bytes(range(256)) * 4)
    return tmp_path


GOOD = {"text": "said.yaml", "said": "said.yaml", "query": "select 1", "tables": "table1", "to": "csv", "egos": "idm"}


def words_for(command: click.Command, tried: click.Parameter, value: str) -> list[str]:
    """What a command is called with: each argument, and each option that it needs, one of them another one."""
    words = list[str]()
    for one in command.params:
        usual = "run" if isinstance(one.type, click.Path) else "x"
        given = value if one is tried else GOOD.get(one.name or "", "new" if one.name == "out" else usual)
        if isinstance(one.type, click.Choice):
            given = one.type.choices[0]
        if isinstance(one, click.Argument):
            words.append(given)
        elif one is tried or one.required:
            words.append(f"{one.opts[0]}={given}")
    return words


def tried() -> Iterator[tuple[list[str], bool]]:
    """Every command with everything that it may be given wrong, and whether that is wrong whatever it is for."""
    for path, command in commands():
        for one in command.params:
            if isinstance(one.type, click.Choice) or (isinstance(one, click.Option) and one.is_flag):
                continue
            if isinstance(one.type, click.types.IntParamType | click.types.FloatParamType):
                bad, surely = NUMBERS, NUMBERS[:1]
            elif isinstance(one, Named):
                bad = surely = ("plannr",)
            else:
                bad, surely = BAD, ()
            for value in bad:
                yield [*path, *words_for(command, one, value)], value in surely


def test_what_is_given_wrong_is_told_in_one_message_and_leaves_nothing(place: Path) -> None:
    runner, there, odd = CliRunner(), set(place.rglob("*")), list[str]()
    for words, surely in tried():
        called = " ".join(words)[:200]
        try:
            done = runner.invoke(main, words, input="the car ahead brakes\n")
        except Begun:
            refused = False
        else:
            refused = done.exit_code != 0
            told = re.findall(r"^(?!Usage)[A-Z]\w*: .+", done.output, re.MULTILINE)
            if not isinstance(done.exception, SystemExit | None):
                odd.append(f"{called}: {done.exception!r}")
            elif refused and (len(told) != 1 or done.exit_code not in (1, 2, 3)):
                odd.append(f"{called}: status {done.exit_code}, {done.output[-300:]!r}")
        left = [one for one in place.rglob("*") if one not in there]
        if surely and not refused:
            odd.append(f"{called}: is taken")
        if refused and left:
            odd.append(f"{called}: leaves {left[0]}")
        for one in reversed(left):
            one.rmdir() if one.is_dir() else one.unlink()
    assert not odd, "\n".join(odd)
