"""The result tables: cells by hand, the paper's averages, and what is written."""

import csv
import io
import json
import random
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.errors import RunError
from chatscene.measure.score import wilson
from chatscene.measure.tables import (
    Which,
    avoidability_table,
    diagnostic_table,
    ego_table,
    fault_table,
    generation_table,
)
from chatscene.report.tables import as_csv, as_latex, as_markdown, as_text, write_tables
from chatscene.terms.criticality import Fault
from chatscene.terms.metrics import Measurements, Metrics, Mode
from chatscene.terms.results import Cell, Displacement, Drive, ResultTable
from chatscene.terms.scenario import BaseScenario
from places import GOLDEN, SHARED

TABLES_GOLDEN = GOLDEN / "tables"
PAPER = SHARED / "data" / "paper_tables.json"
EGOS = ("ppo", "sac", "td3")
FIRST, SECOND = list(BaseScenario)[:2]

PERFECT = Measurements(
    collided=False, red_lights=0, stop_signs=0, off_road=0.0, distance_to_route=0.0, completion=1.0, time=None,
    acceleration=0.0, yaw_rate=0.0, yaw_rate_unwrapped=0.0, lane_invasions=0, duration=10.0,
)  # fmt: skip
CRASH = replace(PERFECT, collided=True)


def drive(
    measurements: Measurements = PERFECT,
    *,
    base: BaseScenario = FIRST,
    ego: str = "sac",
    route: int = 0,
    scene: int = 0,
    generator: str = "chatscene",
    **others: Any,
) -> Drive:
    known: dict[str, Any] = {"fill_in": False, "avoidable": None, "fault": None, **others}
    return Drive(
        generator=generator, base_scenario=base, scenario_id=f"{base}-1", route=route,
        scene_id=f"{base}-1/route-{route:02d}/scene-{scene:03d}", ego=ego, measurements=measurements, **known,
    )  # fmt: skip


def scoring(overall_score: float) -> Measurements:
    """A drive of that overall score in paper mode: perfect but for metres off the road, which are not clipped."""
    return replace(PERFECT, off_road=(1.0 - overall_score) * 10.1 * 50.0)


def displacement(value: float, *, base: BaseScenario = FIRST, ego: str = "sac", route: int = 0) -> Displacement:
    return Displacement(generator="chatscene", base_scenario=base, scenario_id="s", route=route, ego=ego, value=value)


def cells(table: ResultTable, label: str) -> dict[str, Cell]:
    return dict(zip(table.columns, dict(table.rows)[label], strict=True))


def many(seed: int = 0) -> list[Drive]:
    """Two base scenarios, three egos, six routes of four scenes, everything random."""
    rng = random.Random(seed)
    return [
        drive(
            replace(
                PERFECT, collided=rng.random() < 0.6, off_road=rng.uniform(0, 9), time=rng.choice([None, 9.0, 20.0]),
                distance_to_route=rng.uniform(0, 3), completion=rng.random(), lane_invasions=rng.randrange(4),
                acceleration=rng.uniform(0, 8), yaw_rate=rng.random(), red_lights=rng.randrange(2),
            ),
            base=base, ego=ego, route=route, scene=scene,
        )
        for base in (FIRST, SECOND) for ego in EGOS for route in range(6) for scene in range(4)
    ]  # fmt: skip


def test_the_collision_rate_of_a_cell_is_pooled_and_has_its_wilson_interval() -> None:
    drives = [drive(CRASH if k < 3 else PERFECT, ego=ego, scene=k) for ego in EGOS for k in range(4)]
    cell = cells(generation_table(drives, [], Mode.PAPER), "CR, chatscene")["Straight obstacle"]
    assert cell == Cell(0.75, *wilson(9, 12))


def test_a_cell_weighs_the_egos_alike() -> None:
    drives = [drive(CRASH, ego="a"), *(drive(ego="b", scene=k) for k in range(3))]
    table = generation_table(drives, [displacement(1.0, ego="a"), displacement(2.0), displacement(4.0)], Mode.PAPER)
    assert cells(table, "CR, chatscene")["Straight obstacle"].value == 0.5
    assert cells(table, "OS, chatscene")["Straight obstacle"].value == pytest.approx(((5.1 / 10.1) + 1) / 2)
    assert cells(table, "ADE [m], chatscene")["Straight obstacle"].value == 2.0


def test_the_average_is_the_mean_of_base_scenarios_however_many_drives_each_has() -> None:
    drives = [drive(CRASH), *(drive(base=SECOND, scene=k) for k in range(9))]
    row = cells(generation_table(drives, [], Mode.PAPER), "CR, chatscene")
    assert row["Avg."].value == 0.5
    assert row["Lane changing"] == Cell(None)


def test_one_route_gives_a_value_without_an_interval_and_six_give_one() -> None:
    one, six = ([drive(scoring(0.5 + route / 20), route=route) for route in range(count)] for count in (1, 6))
    alone = cells(ego_table(one, Mode.PAPER, which="overall_score"), "sac, chatscene")["Avg."]
    assert (alone.value, alone.low, alone.high) == (pytest.approx(0.5), None, None)
    cell = cells(ego_table(six, Mode.PAPER, which="overall_score"), "sac, chatscene")["Avg."]
    assert cell.value == pytest.approx(0.625)
    assert cell.low is not None
    assert cell.high is not None
    assert 0.5 <= cell.low < 0.6
    assert 0.65 < cell.high <= 0.75


def test_time_is_averaged_over_those_that_arrive_and_the_mode_decides_about_the_others() -> None:
    drives = [drive(replace(PERFECT, time=12.0)), drive(replace(PERFECT, completion=0.5), scene=1)]
    paper, corrected = (cells(diagnostic_table(drives, mode), "chatscene")["TS"].value for mode in Mode)
    assert (paper, corrected) == pytest.approx((0.2, 0.6))


def test_the_diagnostic_overall_score_follows_from_its_ten_columns() -> None:
    row = cells(diagnostic_table(many(), Mode.PAPER), "chatscene")
    values = [cell.value for cell in row.values()]
    assert None not in values
    metrics = Metrics(**{name: value or 0.0 for name, value in zip(Metrics.__slots__, values[:-1], strict=True)})
    assert metrics.overall_score == pytest.approx(values[-1])


def test_the_tables_agree_where_they_show_the_same() -> None:
    drives = many()
    generation, diagnostic = generation_table(drives, [], Mode.PAPER), diagnostic_table(drives, Mode.PAPER)
    for name in ("CR", "OS"):
        assert cells(generation, f"{name}, chatscene")["Avg."] == cells(diagnostic, "chatscene")[name]


TABLES: list[Callable[[list[Drive]], ResultTable]] = [
    lambda drives: generation_table(drives, [], Mode.PAPER),
    lambda drives: diagnostic_table(drives, Mode.CORRECTED),
    lambda drives: ego_table(drives, Mode.PAPER, which="overall_score"),
    avoidability_table,
    fault_table,
]


@settings(max_examples=5)
@given(st.randoms(use_true_random=False), st.sampled_from(TABLES))
def test_the_order_of_drives_does_not_matter(order: random.Random, table: Callable[[list[Drive]], ResultTable]) -> None:
    drives = many()
    expected = table(drives)
    order.shuffle(drives)
    assert table(drives) == expected


@pytest.mark.parametrize("table", TABLES)
def test_without_drives_a_table_has_no_rows(table: Callable[[list[Drive]], ResultTable]) -> None:
    empty = table([])
    assert empty.rows == ()
    assert as_text(empty).startswith(empty.title)


def test_another_generator_changes_nothing_for_the_first() -> None:
    ours = many()
    theirs = [replace(each, generator="other") for each in many(1)]
    alone, beside = (generation_table(drives, [], Mode.PAPER) for drives in (ours, [*theirs, *ours]))
    assert cells(alone, "OS, chatscene") == cells(beside, "OS, chatscene")


def test_avoidable_is_of_collisions_and_fill_in_of_scenes() -> None:
    drives = [
        *(drive(CRASH, ego=ego, avoidable=ego == "sac") for ego in EGOS),
        *(drive(ego=ego, scene=1, fill_in=True) for ego in EGOS),
        drive(CRASH, base=SECOND, avoidable=True),
    ]
    table = avoidability_table(drives)
    avoidable, fill_in = cells(table, "Avoidable, chatscene"), cells(table, "Fill-in, chatscene")
    assert avoidable["Straight obstacle"] == Cell(1 / 3, *wilson(1, 3))
    assert avoidable["All"] == Cell(0.5, *wilson(2, 4))
    assert fill_in["Straight obstacle"] == Cell(0.5, *wilson(1, 2))
    assert avoidable["Lane changing"] == Cell(None)


def test_the_row_of_the_ego_that_scenes_were_kept_for_is_marked_and_has_no_interval() -> None:
    drives = [replace(one, by_selection=one.ego == "sac") for one in many()]
    table = ego_table(drives, Mode.PAPER, which="collision_rate")
    marked = {label: [cell for cell in row if cell.value is not None] for label, row in table.rows}
    assert all(cell.by_selection and cell.low is None for cell in marked["sac, chatscene"])
    assert not any(cell.by_selection for label in ("ppo, chatscene", "td3, chatscene") for cell in marked[label])
    values = [cell.value for cell in dict(ego_table(many(), Mode.PAPER, which="collision_rate").rows)["sac, chatscene"]]
    assert [cell.value for cell in dict(table.rows)["sac, chatscene"]] == values
    assert "(by selection)" in as_markdown(table)
    assert "by selection" in as_text(table)
    for of_all in (table, generation_table(drives, [], Mode.PAPER), avoidability_table(drives), fault_table(drives)):
        assert any(note.startswith("sac: by selection.") for note in of_all.notes)


def test_every_bootstrap_says_what_it_leaves_out() -> None:
    tables = (
        generation_table(many(), [], Mode.PAPER),
        diagnostic_table(many(), Mode.PAPER),
        ego_table(many(), Mode.PAPER, which="overall_score"),
    )
    for table in tables:
        assert any("Scenarios, egos and their trainings are not resampled" in note for note in table.notes)


def test_the_shares_of_faults_are_of_collisions_and_sum_to_one() -> None:
    faults = [Fault.ADVERSARY_INTO_EGO, Fault.ADVERSARY_INTO_EGO, Fault.EGO_INTO_STATIC, None]
    drives = [drive(CRASH if fault else PERFECT, scene=k, fault=fault) for k, fault in enumerate(faults)]
    table = fault_table(drives)
    assert cells(table, "adversary-into-ego, chatscene")["All"] == Cell(2 / 3, *wilson(2, 3))
    assert sum(row[0].value or 0.0 for _, row in table.rows) == pytest.approx(1.0)


def test_the_notes_say_mode_interval_and_how_many() -> None:
    notes = "\n".join(generation_table(many(), [], Mode.CORRECTED).notes)
    for said in (
        "Mode: corrected.",
        "Wilson",
        "bootstrap over the routes",
        "144 drives, 48 scenes, 6 routes",
        "2 of 8",
    ):
        assert said in notes


def published() -> dict[str, Any]:
    if not PAPER.exists():
        pytest.skip("the paper's tables are not beside this checkout")
    return json.loads(PAPER.read_text())["tables"]


def of_paper(by_ego: dict[str, dict[str, float]], of_value: Callable[[float], list[Measurements]]) -> list[Drive]:
    """Drives that give each ego the published number on each base scenario."""
    return [
        drive(measurements, base=base, ego=ego, scene=scene)
        for ego, numbers in by_ego.items()
        for base in BaseScenario
        for scene, measurements in enumerate(of_value(numbers[base]))
    ]


def colliding(rate: float) -> list[Measurements]:
    return [CRASH] * round(100 * rate) + [PERFECT] * round(100 - 100 * rate)


METHODS = ("LC", "AS", "CS", "AT", "ChatScene")
# The table with numbers per ego, the same of table 1, how to make drives of a number, half of the last digit.
DETAILED: list[tuple[str, str, str, Which, Callable[[float], list[Measurements]], float]] = [
    ("tab:detailed_cr", "collisionrate", "CR", "collision_rate", colliding, 0.005),
    ("tab:detailed_os", "overallscore", "OS", "overall_score", lambda value: [scoring(value)], 0.0005),
]


@pytest.mark.parametrize("method", METHODS)
@pytest.mark.parametrize(("table", "summary", "name", "which", "of_value", "rounding"), DETAILED)
def test_our_averages_of_the_papers_numbers_are_the_papers(
    table: str,
    summary: str,
    name: str,
    which: Which,
    of_value: Callable[[float], list[Measurements]],
    rounding: float,
    method: str,
) -> None:
    paper = published()
    by_ego = {ego: numbers[method] for ego, numbers in paper[table].items()}
    drives = of_paper(by_ego, of_value)
    mine = ego_table(drives, Mode.PAPER, which=which)
    for ego, numbers in by_ego.items():
        row = cells(mine, f"{ego}, chatscene")
        assert [cell.value for cell in row.values()][:8] == pytest.approx([numbers[base] for base in BaseScenario])
        assert row["Avg."].value == pytest.approx(numbers["average"], abs=rounding + 0.0005)
    row = cells(generation_table(drives, [], Mode.PAPER), f"{name}, chatscene")
    expected = paper["tab:test_generation"][summary][method]
    ours = [cell.value for cell in row.values()]
    assert ours[:8] == pytest.approx([expected[base] for base in BaseScenario], abs=2 * rounding)
    assert ours[8] == pytest.approx(expected["average"], abs=rounding + 0.0005)
    assert ours[8] == pytest.approx(paper["tab:diagnostic"][method][name], abs=rounding + 0.0005)


@pytest.mark.parametrize("method", METHODS)
def test_our_average_displacement_of_the_papers_numbers_is_the_papers(method: str) -> None:
    numbers = published()["tab:test_generation"]["ADE"][method]
    found = [displacement(numbers[base], base=base) for base in BaseScenario]
    row = cells(generation_table([drive()], found, Mode.PAPER), "ADE [m], chatscene")
    assert row["Avg."].value == pytest.approx(numbers["average"], abs=0.001)


SMALL = ResultTable(
    title="Rate & score_1 of 100 %",
    columns=("Straight obstacle", "Unprotected left turn", "Avg."),
    rows=(
        ("CR, my_ego|a", (Cell(0.75, 0.46769, 0.91106), Cell(1.0), Cell(0.875, 0.8, 0.95))),
        ("OS, my_ego|a", (Cell(None), Cell(0.5), Cell(None))),
        ("ADE [m], <b>", (Cell(12.3456789, 10.0, 15.25), Cell(None), Cell(12.3456789, 10.0, 15.25))),
    ),
    notes=("Mode: paper.", "CR: 95 % Wilson interval."),
)


@pytest.mark.parametrize(
    ("suffix", "render"), [("txt", as_text), ("md", as_markdown), ("csv", as_csv), ("tex", as_latex)]
)
def test_a_table_renders_as_it_always_did(suffix: str, render: Callable[[ResultTable], str]) -> None:
    assert render(SMALL) == (TABLES_GOLDEN / f"small.{suffix}").read_text(encoding="utf-8")


def test_csv_reads_back_with_low_and_high_in_columns_of_their_own() -> None:
    rows = list(csv.DictReader(io.StringIO(as_csv(SMALL))))
    assert rows[0]["row"] == "CR, my_ego|a"
    assert [rows[0][f"Avg.{end}"] for end in ("", " low", " high")] == ["0.875", "0.8", "0.95"]
    assert rows[1]["Avg."] == ""


def test_every_line_of_markdown_has_as_many_cells_as_the_head() -> None:
    lines = [line.replace(r"\|", "") for line in as_markdown(SMALL).splitlines() if line.startswith("|")]
    assert {line.count("|") for line in lines} == {5}


def test_latex_leaves_no_special_character_of_a_name_bare() -> None:
    text = as_latex(replace(SMALL, title=r"\{}&%$#_~^<>", rows=(), notes=(), columns=()))
    assert (
        r"\caption{\textbackslash{}\{\}\&\%\$\#\_\textasciitilde{}\textasciicircum{}\textless{}\textgreater{}}" in text
    )


def test_tables_are_written_in_four_forms(tmp_path: Path) -> None:
    write_tables(tmp_path / "tables", {"small": SMALL})
    assert sorted(path.name for path in (tmp_path / "tables").iterdir()) == [
        "small.csv",
        "small.md",
        "small.tex",
        "small.txt",
    ]
    assert (tmp_path / "tables" / "small.txt").read_text(encoding="utf-8") == as_text(SMALL)


def test_a_folder_that_cannot_be_written_is_said(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(RunError, match="cannot write"):
        write_tables(tmp_path / "file", {"small": SMALL})
