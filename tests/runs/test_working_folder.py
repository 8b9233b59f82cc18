"""A stranger's folder in which the user stands: no module of it is imported, whatever it is called."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

import pyarrow as pa
import pytest

from chatscene.maps.network import PACKAGED
from chatscene.report.index import Index
from chatscene.report.sql import ask
from chatscene.view.child import Child
from strange_folder import Strange, strange

MINE = """model chatscene.world.model
behavior AdvBehavior():
    do Halt()
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
AdvAgent = new Pedestrian at besideRoad(egoRoute, 40, "right", 1), with behavior AdvBehavior()
"""
THEIRS = """param map = localPath("town.xodr")
model scenic.domains.driving.model
ego = new Car
new Car
"""
EGO = """import colorsys

from chatscene.ego.policy import load_ego

def make():
    return load_ego("planner")
"""
TESTS = """import chatscene

@chatscene.scene("the car ahead brakes hard", ego="my_own:make", scenes=1)
def test_my_own(): ...
"""


@pytest.fixture
def folder(tmp_path: Path) -> Strange:
    """One in which a program and tests of the user's lie, too."""
    folder = strange(tmp_path)
    (folder.path / "mine.scenic").write_text(MINE)
    (folder.path / "both").mkdir()
    (folder.path / "both" / "mine.scenic").write_text(MINE)
    (folder.path / "both" / "theirs.scenic").write_text(THEIRS)
    shutil.copy(PACKAGED["town"], folder.path / "both" / "town.xodr")
    (folder.path / "my_own.py").write_text(EGO)
    (folder.path / "tests").mkdir()
    for place in (folder.path, folder.path / "tests"):
        (place / "test_mine.py").write_text(TESTS)
    return folder


def done(folder: Strange, *words: str, python: tuple[str, ...] = ("-P", "-m", "chatscene")) -> str:
    """What a command says that is called there."""
    command = [sys.executable, *python, *words]
    called = subprocess.run(command, cwd=folder.path, capture_output=True, text=True, check=False)
    assert called.returncode == 0, called.stdout + called.stderr
    return called.stdout


def test_a_module_that_is_imported_there_leaves_a_mark(folder: Strange) -> None:
    done(folder, python=("-c", "import colorsys, numpy, chatscene"))
    assert folder.imported() == ["chatscene", "colorsys", "numpy"]


@pytest.mark.parametrize(
    "words",
    [
        ["run", "a car ahead brakes hard", "--ego", "my_own:make", "--routes", "1", "--scenes", "4", "--jobs", "2"],
        ["run", "--program", "mine.scenic", "--routes", "1", "--scenes", "1"],
        ["run", "--program", "both", "--trust", "--routes", "1", "--scenes", "1"],
    ],
    ids=[
        "in several processes, of an ego of the user's own, which lies there",
        "in the confined process",
        "of programs that are trusted, one of them for Scenic's own model",
    ],
)
def test_a_run_imports_no_module_of_the_working_folder(folder: Strange, words: list[str]) -> None:
    done(folder, *words, "--out", "out")
    reports = [path.parent.name for path in (folder.path / "out").rglob("report.html")]
    assert sorted(reports) == (["mine", "theirs"] if "both" in words else ["out"])
    assert folder.imported() == []


@pytest.mark.parametrize(
    "words",
    [["--import-mode=importlib", "test_mine.py"], ["tests"]],
    ids=["beside the modules, which pytest is told not to put first", "in a folder below, which pytest puts first"],
)
def test_scenes_as_tests_import_no_module_of_the_working_folder(folder: Strange, words: list[str]) -> None:
    """As the command `pytest` runs them.

    `python -m pytest` itself has the working folder first, and so have the workers of pytest-xdist; pytest puts the
    folder of a test file first unless it is told otherwise. None of that is ours.
    """
    said = done(folder, "-p", "no:cacheprovider", "-p", "no:randomly", *words, python=("-P", "-m", "pytest"))
    assert "1 passed: the car ahead brakes hard" in said
    assert folder.imported() == []


def test_what_looks_talks_and_asks_in_a_process_of_its_own_imports_none_either(
    folder: Strange, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder.path)
    monkeypatch.setenv("PYTHONPATH", "")
    reading: dict[str, Any] = {"library": "", "embedder": "minilm", "language_model": "offline"}
    for setup, question, answer in (
        ({"folder": "."}, {"look": "list", "runs": []}, "runs"),
        ({"folder": ".", "reading": reading, "search": {}, "kept": {}}, {"line": "the car ahead brakes hard"}, "told"),
    ):
        child = Child(lambda setup=setup: setup)
        child.start()
        assert answer in child.ask(question)
        child.close()
    pytest.importorskip("duckdb", reason="the extra 'sql' is not installed")
    index = Index(tables={"scenes": pa.table({"a": [1]})}, evaluations={}, left_out=())
    assert ask("SELECT a FROM scenes", index).num_rows == 1
    assert folder.imported() == []
