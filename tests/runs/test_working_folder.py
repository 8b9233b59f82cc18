"""A stranger's folder in which the user stands: no module of it is imported, whatever it is called."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from importlib.metadata import packages_distributions
from pathlib import Path
from typing import Any

import pyarrow as pa
import pytest

from chatscene.report.index import Index
from chatscene.report.sql import ask
from chatscene.view.child import Child

NAMES = sorted(
    name for name in {*sys.stdlib_module_names, *packages_distributions(), "chatscene"} if name.isidentifier()
)
MINE = """model chatscene.world.model
behavior AdvBehavior():
    do Halt()
egoRoute = selectRoute(maneuver="straight")
ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute
AdvAgent = new Pedestrian at besideRoad(egoRoute, 40, "right", 1), with behavior AdvBehavior()
"""


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """One with a module for every name of Python's own and of an installed package, each of which leaves a mark."""
    folder = tmp_path / "strange"
    folder.mkdir()
    (tmp_path / "marks").mkdir()
    for name in NAMES:
        (folder / f"{name}.py").write_text(f"open({str(tmp_path / 'marks' / name)!r}, 'w').close()\n")
    (folder / "mine.scenic").write_text(MINE)
    return folder


@pytest.fixture
def marks(folder: Path) -> Callable[[], list[str]]:
    """The names of modules that were imported."""
    return lambda: [path.name for path in (folder.parent / "marks").iterdir()]


def done(folder: Path, *words: str, python: tuple[str, ...] = ("-P", "-m", "chatscene")) -> str:
    """What a command says that is called there."""
    command = [sys.executable, *python, *words]
    called = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=False)
    assert called.returncode == 0, called.stdout + called.stderr
    return called.stdout


def test_a_module_that_is_imported_there_leaves_a_mark(folder: Path, marks: Callable[[], list[str]]) -> None:
    done(folder, python=("-c", "import colorsys, numpy, chatscene"))
    assert sorted(marks()) == ["chatscene", "colorsys", "numpy"]


@pytest.mark.parametrize(
    "words",
    [
        ["run", "a car ahead brakes hard", "--routes", "1", "--scenes", "4", "--jobs", "2", "--out", "out"],
        ["run", "--program", "mine.scenic", "--routes", "1", "--scenes", "1", "--out", "out"],
    ],
    ids=["in several processes", "in the confined process"],
)
def test_a_run_imports_no_module_of_the_working_folder(
    folder: Path, marks: Callable[[], list[str]], words: list[str]
) -> None:
    done(folder, *words)
    assert (folder / "out" / "report.html").is_file()
    assert marks() == []


def test_what_looks_talks_and_asks_in_a_process_of_its_own_imports_none_either(
    folder: Path, marks: Callable[[], list[str]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
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
    assert marks() == []
