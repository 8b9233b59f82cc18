"""The paper's tables: its own rows stand below ours, figures are drawn, and what is not there is said."""

from __future__ import annotations

from pathlib import Path

import pytest

import chatscene as api
from chatscene import runs
from chatscene.errors import RunError, SettingsError
from chatscene.learn import finetune as finetuning
from chatscene.learn.finetune import FinetuneSettings
from chatscene.measure import drive as driving
from chatscene.measure.ordinary import OrdinaryDrive, OrdinaryResult
from chatscene.measure.tables import ABBREVIATIONS, BASES
from chatscene.report.beside_paper import beside_paper
from chatscene.report.figures import two_curves
from chatscene.settings import SearchSettings
from chatscene.studies import benchmark as benchmarks
from chatscene.studies import reproduce as reproducing
from chatscene.studies.reproduce import BEFORE, BUDGETS, METHODS, TABLES, Budget, Reproduced, reproduce
from chatscene.terms.results import Cell, ResultTable
from chatscene.terms.scenario import BaseScenario


def silent(_what: str, _done: int, _total: int) -> None:
    pass


def one_ordinary_drive(_ego: object, _simulator: object, **_: object) -> OrdinaryResult:
    one = OrdinaryDrive(course=0, completion=1.0, speed=7.0, off_road=0.0, collided=False)
    return OrdinaryResult(ego="e", drives=(one,), rejected=0)


def table(rows: dict[str, float], columns: tuple[str, ...] = (*BASES, "Avg.")) -> ResultTable:
    cells = {label: (Cell(value),) * len(columns) for label, value in rows.items()}
    return ResultTable(title="t", columns=columns, rows=tuple(cells.items()), notes=())


def test_the_papers_row_stands_below_ours() -> None:
    beside = beside_paper(table({"CR, chatscene": 0.5, "CR, mine": 0.4, "ADE [m], advsim": 1.0}), "table1")
    assert [label for label, _ in beside.rows] == ["CR, chatscene", "… paper", "CR, mine", "ADE [m], advsim", "… paper"]
    assert beside.rows[1][1][-1].value == 0.831
    assert all(cell.low is None for cell in beside.rows[1][1])


@pytest.mark.parametrize("name", TABLES)
def test_the_paper_has_a_row_of_every_method_in_every_table_and_as_many_columns_as_ours(name: str) -> None:
    columns = tuple(ABBREVIATIONS.values()) if name == "table2" else (*BASES, "Avg.")
    prefixes = {"table1": "CR, ", "table2": "", "table3": "OS, ", "table4": "td3, ", "table5": "sac, "}
    beside = beside_paper(table({f"{prefixes[name]}{method}": 0.5 for method in METHODS}, columns), name)
    assert len(beside.rows) == 2 * len(METHODS)
    assert all(len(cells) == len(columns) for _, cells in beside.rows)


def test_the_same_curves_are_the_same_figure(tmp_path: Path) -> None:
    curves = {"a": [(0.5, 0.1, 0.9), (1.0, 0.2, 0.8)], "b": [(1.0, 0.3, 0.7)]}
    for name in ("one.svg", "two.svg"):
        two_curves(tmp_path / name, curves, x="episodes", second="completion")
    assert (tmp_path / "one.svg").read_bytes() == (tmp_path / "two.svg").read_bytes()


def test_all_five_tables_come_from_one_command_and_a_second_call_does_nothing_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("stable_baselines3", reason="the extra train is not installed")
    search = SearchSettings(scenes=2, block=2, keep=1, routes=2)
    monkeypatch.setitem(benchmarks.BUDGETS, "tiny", benchmarks.Budget(scenarios=1, search=search))
    lesson = FinetuneSettings(
        episodes=2,
        round=1,
        first_choice=1,
        train_routes=1,
        learning_starts=50,
        warm_up_steps=50,
        critic_steps=5,
        batch=16,
    )
    methods = ("carla-scenario-generator", "chatscene")  # two, for time
    bases = (BaseScenario.STRAIGHT_OBSTACLE, BaseScenario.LANE_CHANGING)
    monkeypatch.setattr(benchmarks, "BaseScenario", bases)
    monkeypatch.setattr(reproducing, "METHODS", methods)
    monkeypatch.setattr(finetuning, "drive_ordinary", one_ordinary_drive)
    budget = Budget(benchmark="tiny", finetune=lesson, bases=(BaseScenario.STRAIGHT_OBSTACLE,))
    monkeypatch.setitem(BUDGETS, "tiny", budget)
    done = reproduce(tmp_path / "r", TABLES, budget="tiny", progress=silent)
    assert set(done.tables) == {*TABLES, "avoidability"}
    rows = {name: [label for label, _ in table.rows] for name, table in done.tables.items()}
    assert [label for label in rows["table1"] if label.startswith("CR")] == [f"CR, {m}" for m in methods]
    assert [label for label in rows["table3"] if label.startswith("Comp")] == [
        f"Comp, {name}" for name in sorted((*methods, BEFORE))
    ]
    before = next(row for label, row in done.tables["table3"].rows if label == f"CR, {BEFORE}")
    assert all(cell.by_selection for cell in before if cell.value is not None)
    assert any("A cell is one training" in note for note in done.tables["table3"].notes)
    for made in done.tables.values():
        assert any(note.startswith("sac sees its route and, of all others, only") for note in made.notes)
    assert all((tmp_path / "r" / "tables" / f"{name}.md").is_file() for name in TABLES)
    searched = [
        {path.name for path in scenes.iterdir()} for scenes in (tmp_path / "r").glob("**/scenes") if scenes.is_dir()
    ]
    assert {base.value for base in bases} in searched
    figures = ["figures/search.svg", "finetuning/released-paper/figures/finetuning.svg"]
    assert all((tmp_path / "r" / figure).is_file() for figure in figures)
    # Every scene and every ego is there: a second call only reads.
    monkeypatch.setattr(driving, "simulate", None)
    again = api.resume(tmp_path / "r")
    assert isinstance(again, Reproduced)
    assert again.tables == done.tables
    assert runs.check(tmp_path / "r").whole
    with pytest.raises(RunError, match=r"settings\.seed was 0 and is now 1"):
        reproduce(tmp_path / "r", TABLES, budget="tiny", seed=1, progress=silent)
    with pytest.raises(RunError, match=r"settings\.physics was 'kinematic' and is now 'lagged'"):
        reproduce(tmp_path / "r", TABLES, budget="tiny", physics="lagged", progress=silent)


def test_what_cannot_be_reproduced_is_said_before_anything_is_run(tmp_path: Path) -> None:
    with pytest.raises(SettingsError, match="no table 'table9'"):
        reproduce(tmp_path / "r", ["table9"], progress=silent)
    with pytest.raises(SettingsError, match="no budget 'papper'; did you mean 'paper'"):
        reproduce(tmp_path / "r", ["table1"], budget="papper", progress=silent)
    with pytest.raises(SettingsError, match="no physics 'laged'"):
        reproduce(tmp_path / "r", ["table1"], physics="laged", progress=silent)
    assert not (tmp_path / "r").exists()
