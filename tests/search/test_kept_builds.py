"""Programs of situations that were built before are taken again, if the code is the same and nothing is damaged."""

from __future__ import annotations

import importlib
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from chatscene.search.generators.kept_builds import kept_program
from chatscene.search.generators.situated import Situated
from chatscene.settings import RetrievalSettings
from chatscene.terms.scene import ScenicProgram

situated: Any = importlib.import_module("chatscene.search.generators.situated")
builds: Any = importlib.import_module("chatscene.search.generators.kept_builds")

CROSSES = "others: [{id: A, kind: pedestrian, starts: {where: roadside, side: right}, does: [{act: cross}]}]\n"
SETTINGS = RetrievalSettings()


@pytest.fixture
def built(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ScenicProgram:
    """A program, built with an empty cache."""
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path))
    situated._rehearsed.cache_clear()
    return Situated().write(Situated().read(CROSSES, SETTINGS), SETTINGS).program


@pytest.fixture
def again(monkeypatch: pytest.MonkeyPatch) -> Callable[[], ScenicProgram]:
    """Write it again, in a process that built none."""
    scenario = Situated().read(CROSSES, SETTINGS)

    def write() -> ScenicProgram:
        situated._rehearsed.cache_clear()
        return Situated().write_again(scenario, None, SETTINGS)

    return write


def test_what_was_built_is_not_built_again(
    built: ScenicProgram, again: Callable[[], ScenicProgram], monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise AssertionError("it is built")

    monkeypatch.setattr("chatscene.build.build.build", refuse)
    assert again() == built
    assert (again().parameters, again().wanted_speed) == (built.parameters, built.wanted_speed)


def test_what_is_damaged_or_was_made_by_other_code_is_built_anew(
    built: ScenicProgram, again: Callable[[], ScenicProgram], tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (kept,) = (tmp_path / "chatscene" / "builds").iterdir()
    assert kept.stat().st_mode & 0o077 == 0
    whole = kept.read_bytes()
    kept.write_bytes(whole.replace(b"ego = new Car", b"ego = new Bus"))
    assert again() == built
    assert kept.read_bytes() == whole
    kept.write_bytes(whole[:100])
    assert again() == built
    monkeypatch.setattr(builds, "_code", lambda: b"another")
    assert again() == built
    assert len(list(kept.parent.iterdir())) == 2


@pytest.mark.usefixtures("built")
def test_another_text_name_or_map_has_none() -> None:
    scenario = Situated().read(CROSSES, SETTINGS)
    made_of = scenario.text, scenario.id, ""
    assert kept_program(*made_of) is not None
    for i in range(len(made_of)):
        assert kept_program(*(one + " " * (i == n) for n, one in enumerate(made_of))) is None


def test_code_is_another_once_a_file_of_it_changes(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(builds, "__file__", str(tmp_path / "search" / "generators" / "kept_builds.py"))
    found = [builds._code.__wrapped__()]
    for name in ("one.py", "two.scenic", "one.py"):
        (tmp_path / name).write_text(f"x = {len(found)}0" * len(found))
        found.append(builds._code.__wrapped__())
    (tmp_path / "__pycache__").mkdir()
    (tmp_path / "__pycache__" / "one.pyc").write_bytes(b"0")
    (tmp_path / ".#one.py").symlink_to("nobody@nowhere.1")  # by which an editor locks a file
    assert len({*found}) == len(found)
    assert builds._code.__wrapped__() == found[-1]
