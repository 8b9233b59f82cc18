"""The documents say what is true: commands run, links lead somewhere, the glossary knows the words."""

import json
import re
import runpy
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from chatscene.library.load import load_library
from chatscene.search.generators.baselines.adversarial_trajectory import LIMIT, VULNERABLE_LIMIT
from chatscene.search.generators.baselines.learning_to_collide import LearningToCollide
from chatscene.search.generators.baselines.nominal import NOMINAL
from chatscene.search.generators.baselines.scenario_runner import AROUND, EARLIER_OR_LATER
from chatscene.simulate.confined.words import world_words
from chatscene.terms.scenario import BaseScenario, Component
from fake_run import finished
from notebooks import TUTORIALS, held, printed
from pages import Written, steps_of
from places import ROOT

PAGES = sorted([*ROOT.glob("*.md"), *ROOT.glob("docs/**/*.md")])
OF_OTHERS = {"dec2269"}  # commits that pages name of SafeBench
CONSOLE = re.compile(r"```console\n(.*?)```", re.DOTALL)


def test_the_commands_of_the_first_pages_are_there_after_the_line_that_activates() -> None:
    for page in ("README.md", "docs/tour.md"):
        lines = [line for block in CONSOLE.findall((ROOT / page).read_text()) for line in block.splitlines()]
        assert lines[:2] == ["$ make demo", "$ source .venv/bin/activate"], page
    said = re.findall(r"@echo '(.*)'", (ROOT / "Makefile").read_text())
    assert said[0].split(":")[1].strip() == "source .venv/bin/activate"
    assert all(line.split(":")[-1].strip().startswith("chatscene ") for line in said[1:])


def test_no_page_installs_from_an_index_that_has_no_such_package() -> None:
    pages = [*PAGES, *ROOT.glob("docs/**/*.ipynb"), *ROOT.glob("src/**/*.py"), ROOT / "Makefile"]
    for page in pages:
        for said in re.findall(r"pip install [^`\n]*", page.read_text()):
            named = [word.strip("\\\"',.;)") for word in said.split()[2:]]
            assert not any(re.fullmatch(r"chatscene(\[.*\])?", word) for word in named), f"{page.name}: {said}"
    assert "\nwheel:" in (ROOT / "Makefile").read_text()


WITH_PYTHON = ("docs/edit.md", "docs/situation.md", "README.md", "docs/python.md", "docs/howto/rl-researcher.md")
NOTEBOOK = "docs/notebook.ipynb"
# Each page on its own: in its folder, with its names. One process for all, since to begin takes seconds.
_EACH = """
import json, os, sys, traceback
pages = json.load(sys.stdin)
for name, (folder, code) in pages.items():
    os.chdir(folder)
    try:
        exec(compile(code, name, "exec"), {"__name__": "__main__"})
    except BaseException:
        pages[name] = traceback.format_exc()
    else:
        pages[name] = ""
with open(sys.argv[1], "w") as file:
    json.dump(pages, file)
"""


def python_of(page: str) -> str:
    """All Python of a page, or of the notebook."""
    if page == NOTEBOOK:
        *before, last = cells_of_the_notebook()
        return "\n".join([*map(shown, before), last])
    return "\n".join(re.findall(r"```python\n(.*?)```", (ROOT / page).read_text(), re.DOTALL))


@pytest.fixture(scope="module")
def failed(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """For each page with Python how it fails where it is run; empty where it does not."""
    pytest.importorskip("gymnasium", reason="the extra 'gym' is not installed")
    told, pages = tmp_path_factory.mktemp("told") / "told.json", dict[str, tuple[str, str]]()
    for page in (*WITH_PYTHON, NOTEBOOK):
        folder = tmp_path_factory.mktemp("page")
        for step in steps_of(ROOT / page) if page != NOTEBOOK else ():
            if isinstance(step, Written):
                (folder / step.name).write_text(step.content, encoding="utf-8")
        pages[page] = str(folder), python_of(page)
    done = subprocess.run(
        [sys.executable, "-c", _EACH, str(told)], input=json.dumps(pages), capture_output=True, text=True, check=False
    )
    assert done.returncode == 0, f"{done.stdout}\n{done.stderr}"
    return json.loads(told.read_text())


@pytest.mark.parametrize("page", WITH_PYTHON)
def test_the_python_of_a_page_runs(page: str, failed: dict[str, str]) -> None:
    assert "import chatscene" in python_of(page)
    assert not failed[page]


def shown(cell: str) -> str:
    """A cell that prints what a notebook shows: what its last line gives, if that does not print."""
    *before, last = cell.splitlines()
    return "\n".join([*before, last if last.startswith("print(") else f"({last})._repr_html_()"])


def cells_of_the_notebook() -> list[str]:
    """Its code, cell by cell."""
    cells = json.loads((ROOT / NOTEBOOK).read_text())["cells"]
    code = [cell for cell in cells if cell["cell_type"] == "code"]
    assert not any(cell["outputs"] for cell in code)
    return ["".join(cell["source"]) for cell in code]


def test_the_notebook_goes_from_a_sentence_to_a_step_in_ten_lines(failed: dict[str, str]) -> None:
    lines = cells_of_the_notebook()
    assert sum(bool(line.strip()) for cell in lines for line in cell.splitlines()) <= 10
    assert "env.step(" in lines[-1]
    assert not failed[NOTEBOOK]


@pytest.fixture(scope="module")
def said(tmp_path_factory: pytest.TempPathFactory) -> dict[Path, list[str]]:
    """For each tutorial what its cells print."""
    pytest.importorskip("gymnasium", reason="the extra 'gym' is not installed")
    with pytest.MonkeyPatch.context() as patch:
        patch.delenv("PYTEST_ADDOPTS", raising=False)  # a cell runs pytest, and what that prints is held
        notebooks = {tmp_path_factory.mktemp(path.stem): json.loads(path.read_text()) for path in TUTORIALS}
        return dict(zip(TUTORIALS, printed(notebooks), strict=True))


@pytest.mark.parametrize("path", TUTORIALS, ids=lambda path: path.stem)
def test_a_tutorial_holds_what_its_cells_print(path: Path, said: dict[Path, list[str]]) -> None:
    assert said[path] == held(json.loads(path.read_text()))


def test_pages_for_users_name_no_commit_of_ours() -> None:
    pages = [*PAGES, *ROOT.glob("benchmarks/**/README.md")]
    ours = [page for page in pages if not {"decisions", "lab"} & set(page.relative_to(ROOT).parts)]
    for page in ours:
        words = re.findall(r"\b[0-9a-f]{7,40}\b", page.read_text())
        named = {word for word in words if re.search(r"\d", word) and re.search(r"[a-f]", word)}
        assert not named - OF_OTHERS, f"{page.name}: name it in docs/lab/commits.md"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_links_between_pages_lead_somewhere(page: Path) -> None:
    for target in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", page.read_text()):
        if not target.startswith("http"):
            assert (page.parent / target).exists(), f"{page.name} links to {target}"


def test_the_same_pythons_are_allowed_by_the_package_the_makefile_and_the_doctor() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    first, after = re.findall(r"3, (\d+)", re.sub(r"3\.(\d+)", r"3, \1", project["requires-python"]))
    for place in ("Makefile", "src/chatscene/commands/doctor.py"):
        assert re.search(rf"\(3, {first}\) <= \S+ < \(3, {after}\)", (ROOT / place).read_text()), place
    assert (int(first), int(after)) == (11, 14)
    assert f"Python 3.{first}, 3.12 or 3.{int(after) - 1}" in (ROOT / "README.md").read_text()


def test_the_version_is_the_same_wherever_it_stands() -> None:
    version = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"]
    newest = re.search(r"^## (\S+)", (ROOT / "CHANGELOG.md").read_text(), re.MULTILINE)
    cited = re.search(r"^version: (\S+)", (ROOT / "CITATION.cff").read_text(), re.MULTILINE)
    assert newest
    assert cited
    assert newest[1] == cited[1] == version


def test_a_push_is_tested_on_every_python_that_is_allowed() -> None:
    workflow = (ROOT / ".github" / "workflows" / "test.yml").read_text()
    assert re.findall(r"- run: (.*)", workflow) == [".ci/run"]
    minors = [int(minor) for minor in re.findall(r'"3\.(\d+)"', workflow)]
    assert minors == [11, 12, 13]
    classifiers = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["classifiers"]
    assert [f"Programming Language :: Python :: 3.{minor}" in classifiers for minor in minors] == [True] * 3


def test_every_pin_that_has_no_wheel_for_a_python_gives_way_to_one_that_has() -> None:
    pins = [
        line.split("; ")
        for line in (ROOT / "constraints.txt").read_text().splitlines()
        if "==" in line and "; " in line
    ]
    conditions: dict[str, set[str]] = {}
    for pin, condition in pins:
        conditions.setdefault(pin.partition("==")[0], set()).add(condition)
    assert conditions == {"numpy": {"python_version < '3.13'", "python_version >= '3.13'"}}


def test_the_glossary_defines_the_words_the_design_rests_on() -> None:
    defined = set(re.findall(r"^- \*\*([a-z -]+)\*\*:", (ROOT / "docs" / "glossary.md").read_text(), re.MULTILINE))
    words = {"route", "base scenario", "scenario", "scene", "component", "snippet", "sub-description", "surrogate ego"}
    words |= {"ego", "adversary", "episode", "block", "selection", "slot", "track", "event", "rejected", "fill-in"}
    assert words <= defined


def test_no_public_name_is_a_word_that_says_nothing() -> None:
    for path in (ROOT / "src" / "chatscene").rglob("*.py"):
        names = {path.stem, *re.findall(r"^(?:class|def) (\w+)", path.read_text(), re.MULTILINE)}
        assert not {n for n in names if re.search(r"util|helper|manager|_info$|_data$", n, re.IGNORECASE)}, path


def test_the_readme_lists_what_there_is() -> None:
    text = (ROOT / "README.md").read_text()
    assert all(verb in text for verb in ("run", "resume", "replay", "explain", "library", "map", "doctor"))
    assert len(BaseScenario) == 8
    assert len(Component) == 3


def test_the_page_of_the_world_model_lists_the_names_that_it_offers() -> None:
    names = (ROOT / "docs" / "world.md").read_text().split("## Names", 1)[1].split("\n## ", 1)[0]
    listed = {name for row in re.findall(r"^\|.*$", names, re.MULTILINE) for name in re.findall(r"`([A-Za-z]\w*)", row)}
    assert listed - {"param"} == world_words()


DECISIONS = {path.name[:4]: path for path in sorted((ROOT / "docs" / "decisions").glob("*.md"))}
STATUS = re.compile(r"Status: (?:accepted|superseded by (\d{4})), \d{4}-\d\d-\d\d(?:; amended by (\d{4}(?:, \d{4})*))?")


@pytest.mark.parametrize("number", DECISIONS)
def test_a_decision_says_what_became_of_it(number: str) -> None:
    title, empty, status = DECISIONS[number].read_text().splitlines()[:3]
    assert title.startswith(f"# {number} ")
    assert not empty
    found = STATUS.fullmatch(status)
    assert found, status
    others = [other for group in found.groups() if group for other in group.split(", ")]
    assert all(other in DECISIONS and other != number for other in others)


def test_the_figures_about_the_printed_tables_follow_from_them() -> None:
    text = (ROOT / "docs" / "lab" / "paper-tables.md").read_text()
    printed = runpy.run_path(str(ROOT / "benchmarks" / "printed_tables.py"))
    start, slope, share, cells = printed["score_from_collisions"]()
    assert f"over the {cells} cells of tables 4 and 5 it is {start:.3f} \N{MINUS SIGN} {-slope:.3f} CR" in text
    assert f"R² = {share:.3f}" in text
    deviation, average, cells = printed["between_protocols"]()
    assert f"a standard deviation of {deviation:.2f} ({cells} cells" in text
    assert f"a standard deviation of {average:.2f} from one training to another, that is ±{1.96 * average:.2f}" in text
    for rate in printed["transfer"]().values():
        assert f"{rate + 1e-9:.3f} " in text


def test_the_surrogates_rows_have_no_interval_in_the_documents() -> None:
    for page in ("lab/paper-tables.md", "lab/benchmark.md"):
        rows = re.findall(r"^\| (?:sac, |(?:CR|OS|Comp), before).*$", (ROOT / "docs" / page).read_text(), re.MULTILINE)
        assert rows
        for row in rows:
            assert row.endswith("(by selection) |"), row
            assert "\N{EN DASH}" not in row, row


def test_the_limits_of_the_baselines_stand_in_the_documents() -> None:
    page = (ROOT / "docs" / "lab" / "benchmark.md").read_text()
    junctions = [base for base in BaseScenario if NOMINAL[base].turns]
    assert len(junctions) == 4
    for base in junctions:
        nominal = NOMINAL[base]
        _, (trigger, speed) = LearningToCollide().behavior(nominal)
        (start,) = load_library().get(f"spawn/{nominal.spawn}").parameters
        assert f"trigger ±{(trigger.high - trigger.low) / 2:g} m, start over {start.high - start.low:g} m" in page
        assert f"speed ±{(speed.high / nominal.speed - 1):.0%}".replace("%", " %") in page
    assert f"±{VULNERABLE_LIMIT:g} m on foot or bicycle, ±{LIMIT:g} m in a car" in page
    assert f"trigger ±{EARLIER_OR_LATER:g} m, speed ±{AROUND:.0%}".replace("%", " %") in page


def test_the_example_that_reads_a_table_runs_with_what_is_installed(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    finished(tmp_path / "run", count=1)
    (code,) = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "run-folder.md").read_text(), re.DOTALL)
    exec(code.replace("DIR", str(tmp_path / "run")), {})
    assert len(capsys.readouterr().out.splitlines()) == 2  # the kept scenes
