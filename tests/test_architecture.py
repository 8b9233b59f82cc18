"""The shape of the house: what the import contracts cannot see, and what its page says of it."""

from __future__ import annotations

import ast
import re
import runpy
import subprocess
import sys
import tomllib
from fnmatch import fnmatch
from functools import partial
from typing import Any

import pytest

import chatscene
from places import ROOT

SOURCE = ROOT / "src" / "chatscene"
LANGUAGE_WING = {"sentences", "interpret", "library", "read", "models"}
UNDER_THE_WORLD = {"world", "maps", "terms", "settings", "plugins", "files", "errors"}
PROGRAMS = sorted(SOURCE.rglob("*.scenic"))
IMPORTED = re.compile(r"^\s*(?:from|import|model)\s+chatscene\.(\w+)", re.MULTILINE)


@pytest.mark.parametrize(
    "path", [path for path in PROGRAMS if "packaged" not in path.parts], ids=lambda path: path.name
)
def test_the_world_model_imports_what_lies_below_it(path: Any) -> None:
    assert set(IMPORTED.findall(path.read_text(encoding="utf-8"))) <= UNDER_THE_WORLD


def test_pytest_passes_over_no_folder_with_tests(pytestconfig: pytest.Config) -> None:
    tests = ROOT / "tests"
    folders = {part for path in tests.rglob("test_*.py") for part in path.relative_to(tests).parts[:-1]}
    passed_over = pytestconfig.getini("norecursedirs")
    assert not [folder for folder in folders if any(fnmatch(folder, pattern) for pattern in passed_over)]


def test_snippets_import_nothing() -> None:
    assert not [p.name for p in PROGRAMS if "packaged" in p.parts and IMPORTED.search(p.read_text(encoding="utf-8"))]


def test_the_pipeline_stays_on_one_screen() -> None:
    assert len((SOURCE / "pipeline.py").read_text(encoding="utf-8").splitlines()) <= 120


def test_the_page_draws_every_room() -> None:
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
    drawing = page.split("```")[1]
    rooms = {path.name for path in SOURCE.iterdir() if (path / "__init__.py").exists()}
    assert rooms <= set(re.findall(r"\w+", drawing))


def test_a_room_says_in_its_first_line_what_it_is_for() -> None:
    rooms = [path for path in SOURCE.rglob("__init__.py") if path.parent != SOURCE]
    assert all(ast.get_docstring(ast.parse(path.read_text(encoding="utf-8"))) for path in rooms)


def test_the_contracts_name_every_room() -> None:
    settings = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    (layers,) = [
        c["layers"] for c in settings["tool"]["importlinter"]["contracts"] if "chatscene.terms" in c.get("layers", ())
    ]
    named = set(re.findall(r"chatscene\.(\w+)", " ".join(layers)))
    rooms = {path.stem for path in SOURCE.iterdir() if (path / "__init__.py").exists() or path.suffix == ".py"}
    assert rooms - {"__init__", "__main__"} == named


def test_a_sentence_goes_through_the_doors_that_the_page_tells_and_through_no_more_files() -> None:
    walk = runpy.run_path(str(ROOT / "benchmarks" / "walk.py"))
    chatscene.explain(walk["SENTENCE"])  # what is made once a process is there
    files: set[str] = set()
    stays = walk["walked"](partial(chatscene.explain, walk["SENTENCE"]), files)
    for room in ("read", "interpret", "build"):
        assert len({there for there, here, _ in stays if here == room}) == 1
    assert not {"search", "program", "simulate"} & {here for _, here, _ in stays}
    page = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8").split("## The path of a scene")[0]
    told = set(re.findall(r"^\| `(\w+)` \| `(\w+)` \|", page, re.MULTILINE))
    assert told == {(there.removesuffix(".py"), here) for there, here, _ in stays if there}
    assert len(files) <= int(re.findall(r"(\d+) files", page)[0])


HEAVY = (
    "scenic", "trimesh", "scipy", "shapely", "PIL", "pyarrow", "matplotlib", "jinja2", "networkx", "torch", "onnx",
    "pydantic",
)  # fmt: skip
TEXT = "A cyclist rides out from the left and stops in front of us."
READS = f"from chatscene.read.learned.reader import LearnedReader; LearnedReader().read({TEXT!r})"
EXPLAINS = f"import chatscene; str(chatscene.explain({TEXT!r}))"


def loaded_by(code: str) -> set[str]:
    shows = f"import sys\n{code}\nprint(*(name for name in sys.argv[1:] if name in sys.modules))"
    told = subprocess.run([sys.executable, "-c", shows, *HEAVY], capture_output=True, text=True, check=True)
    return set(told.stdout.split())


def test_reading_a_sentence_loads_nothing_that_drives_draws_or_trains() -> None:
    assert loaded_by(READS) == set()


def test_explaining_a_sentence_loads_neither_scenic_nor_what_draws_stores_or_trains() -> None:
    chatscene.explain(TEXT)  # so that the roads of the map are kept, which Scenic makes
    assert loaded_by(EXPLAINS) == {"shapely"}
