"""Many runs are asked in one query, and a query can do nothing but read them."""

from __future__ import annotations

import json
import re
import resource
import shlex
import shutil
import sys
from collections.abc import Sequence
from dataclasses import fields
from pathlib import Path
from typing import Any

import pyarrow as pa
import pytest
from click.testing import CliRunner, Result

import chatscene
from chatscene.commands.main import main
from chatscene.errors import MissingExtra, QueryError, RunError
from chatscene.report.index import OTHERWISE_CALLED, Index, index
from chatscene.report.index_columns import ROWS, TABLES, schema_of
from chatscene.report.sql import answer, ask, rows_of
from chatscene.runs import Status, Workspace, update
from chatscene.runs.tables import SCENES, read_table, write_table
from chatscene.terms.scenario import Slots
from fake_run import finished, resealed, started
from places import ROOT

pytest.importorskip("duckdb", reason="the extra 'sql' is not installed")


@pytest.fixture(scope="module")
def one_run(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A finished run of 50 scenes, for reading only."""
    return finished(tmp_path_factory.mktemp("one") / "walker").path


@pytest.fixture(scope="module")
def one_index(one_run: Path) -> Index:
    return index(one_run)


def copied(run: Path, to: Path, **slots: Any) -> Workspace:
    """The same run again, of a sentence that says something else."""
    shutil.copytree(run, to)
    copy = Workspace(to)
    if slots:
        path = copy.file("explanation.json")
        told = json.loads(path.read_text())
        told["scenarios"][0]["slots"] |= slots
        told["scenarios"][0]["adversary"] = slots.get("adversary", "pedestrian")
        path.write_text(json.dumps(told))
        resealed(copy)
    return copy


def changed_scenes(run: Workspace, table: Any) -> None:
    write_table(run.file("scenes.parquet"), table)
    resealed(run)


def told(*words: str | Path) -> Result:
    return CliRunner().invoke(main, [str(word) for word in words], catch_exceptions=False)


def answered(query: str, folder: Path) -> list[dict[str, Any]]:
    """The answer found in this process; the command and `ask` have one of its own find it."""
    return rows_of(answer(query, index(folder).tables))


def column(query: str, folder: Path) -> Sequence[Any]:
    return [next(iter(row.values())) for row in answered(query, folder)]


AVOIDABLE = (
    "SELECT run, scene_id, impact_speed FROM scenes JOIN facts USING (run, scenario_id) "
    "WHERE avoidable AND adversary = 'bicycle' AND side = 'left'"
)


def test_all_avoidable_crashes_with_a_cyclist_from_the_left_are_one_query(one_run: Path, tmp_path: Path) -> None:
    copied(one_run, tmp_path / "walker")
    copied(one_run, tmp_path / "deeper" / "cyclist-left", adversary="bicycle", side="left")
    copied(one_run, tmp_path / "cyclist-right", adversary="bicycle", side="right")
    rows = answered(AVOIDABLE, tmp_path)
    scenes = read_table(one_run / "scenes.parquet", SCENES).to_pylist()
    crashes = [scene for scene in scenes if scene["avoidable"]]
    assert crashes
    assert {row["run"] for row in rows} == {"deeper/cyclist-left"}
    assert [(row["scene_id"], row["impact_speed"]) for row in rows] == [
        (scene["scene_id"], scene["impact_speed"]) for scene in crashes
    ]
    done = told("sql", AVOIDABLE, tmp_path, "--json")
    assert (done.exit_code, json.loads(done.stdout)) == (0, rows)
    assert chatscene.sql(AVOIDABLE, tmp_path).num_rows == len(rows)


@pytest.mark.parametrize(
    "query",
    [
        "SELECT * FROM '/etc/passwd'",
        "SELECT * FROM read_text('/etc/passwd')",
        "SELECT * FROM read_csv('{here}/kept.csv')",
        "SELECT * FROM '{here}/scenes.parquet'",
        "SELECT * FROM glob('/*')",
        "SELECT * FROM read_parquet('https://example.com/scenes.parquet')",
        "SELECT * FROM 's3://bucket/scenes.parquet'",
        "SELECT getenv('HOME')",
        "COPY scenes TO '{here}/out.csv'",
        "EXPLAIN ANALYZE COPY scenes TO '{here}/out.csv'",
        "EXPORT DATABASE '{here}/out'",
        "IMPORT DATABASE '{here}/out'",
        "ATTACH '{here}/out.db' AS other",
        "INSTALL httpfs",
        "LOAD httpfs",
        "SET enable_external_access = true",
        "SET lock_configuration = false",
        "RESET threads",
        "CALL pragma_version()",
        "CREATE TABLE mine AS SELECT 1",
        "DELETE FROM scenes",
        "DROP VIEW scenes",
        "SELECT 1; DROP VIEW scenes",
        "PREPARE one AS SELECT 1",
        'SELECT * FROM "table"',  # a variable of `ask`
        "SELECT no_such_column FROM scenes",
        "SELECT * FROM no_such_table",
        "SELECT * FROM pandas_scan(NULL)",  # would end the process
        "SELECT * FROM arrow_scan(NULL, NULL, NULL)",
        "SELECT * FROM enable_logging(storage='stdout')",  # would print to the terminal
        "SELECT write_log(chr(27) || '[31m')",
        "WITH a AS (SELECT (SELECT max(b) FROM (SELECT WRITE_LOG('x') AS b)) AS c) SELECT * FROM a",
        "SELECT * FROM enable_profiling(save_location='{here}/p')",
        "SELECT * FROM query('SELECT * FROM enable_logging()')",
        "SELECT * FROM json_execute_serialized_sql(json_serialize_sql('SELECT 1'))",
        "SELECT * FROM force_checkpoint()",
        "SELECT sleep_ms(1)",
        "SELEC 1",
        "SELECT \udcff",
        "SELECT * FROM range(1000001)",  # more rows than anybody reads
        "-- nothing",
        "",
    ],
)
def test_a_query_that_would_do_more_than_read_the_tables_or_is_none_is_refused(
    query: str, one_index: Index, tmp_path: Path
) -> None:
    (tmp_path / "kept.csv").write_text("a\n1\n")
    write_table(tmp_path / "scenes.parquet", pa.table({"a": [1]}))
    before = sorted(tmp_path.rglob("*"))
    with pytest.raises(QueryError):
        answer(query.replace("{here}", str(tmp_path)), one_index.tables)
    assert sorted(tmp_path.rglob("*")) == before


@pytest.mark.parametrize(
    "query",
    [
        "PIVOT scenes ON status IN ('ran', 'rejected') USING count(*)",
        "SELECT * FROM (SELECT status, block FROM scenes) PIVOT (count(*) FOR status IN ('ran', 'rejected'))",
        "SELECT unnest(range(3)), random()",
        "SELECT * FROM generate_series(1, 3)",
    ],
)
def test_what_only_computes_is_answered(query: str, one_index: Index) -> None:
    assert answer(query, one_index.tables).num_rows > 0


@pytest.mark.parametrize(
    "query",
    [
        "SELECT range(10000) FROM range(1000000)",
        "SELECT repeat(repeat('x', 1000000), 4000)",
        "SELECT repeat('x', 1000000) FROM range(1000000)",
    ],
)
def test_a_query_that_takes_more_memory_than_there_is_is_refused(query: str, one_index: Index) -> None:
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    with pytest.raises(QueryError, match=r"Out of Memory|takes more than 4 GiB|maximum total string size"):
        ask(query, one_index)
    assert resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before < 200_000  # kB


def test_a_query_that_breaks_duckdb_ends_nobody_else(one_index: Index, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("chatscene.report.sql.sys.executable", "/bin/false")
    with pytest.raises(QueryError, match="or breaks DuckDB"):
        ask("SELECT 1", one_index)


def test_what_was_wrong_with_a_query_is_said_with_what_there_is(one_run: Path) -> None:
    done = told("sql", "SELECT impact_sped FROM scenes", one_run)
    assert done.exit_code == 1
    assert "impact_speed" in done.stderr
    assert "chatscene sql --tables" in done.stderr
    assert told("sql").exit_code == 2


def test_a_damaged_folder_is_left_out_by_name_and_the_others_answer(one_run: Path, tmp_path: Path) -> None:
    copied(one_run, tmp_path / "whole")
    for name in ("scenes.parquet", "explanation.json", "ranges.parquet", "run.json"):
        copy = copied(one_run, tmp_path / f"damaged-{name}")
        content = copy.file(name).read_bytes()
        copy.file(name).write_bytes(content[:-40] + bytes(len(content[-40:])))
    done = told("sql", "SELECT DISTINCT run FROM scenes", tmp_path, "--json")
    assert json.loads(done.stdout) == [{"run": "whole"}]
    lines = [line for line in done.stderr.splitlines() if line.startswith("left out")]
    assert [name for name in lines if "damaged-" in name] == lines
    assert len(lines) == 4
    with pytest.warns(RuntimeWarning, match="left out .*damaged-") as caught:
        chatscene.sql("SELECT 1", tmp_path)
    assert len(caught) == 4


def test_an_unfinished_run_is_listed_and_told_and_has_no_scenes(one_run: Path, tmp_path: Path) -> None:
    copied(one_run, tmp_path / "done")
    started(tmp_path / "cut")
    update(started(tmp_path / "refused"), status=Status.REFUSED, reason="no snippet has a dragon")
    done = told("sql", "SELECT run, status, scenes FROM runs", tmp_path, "--json")
    assert json.loads(done.stdout) == [
        {"run": "cut", "status": "stopped", "scenes": None},
        {"run": "done", "status": "done", "scenes": 55},
        {"run": "refused", "status": "refused", "scenes": None},
    ]
    (line,) = done.stderr.splitlines()
    assert "chatscene resume" in line
    assert str(tmp_path / "cut") in line
    assert column("SELECT DISTINCT run FROM scenes", tmp_path) == ["done"]
    assert column("SELECT count(*) FROM facts", tmp_path) == [3]


def test_runs_with_different_columns_share_the_tables(one_run: Path, tmp_path: Path) -> None:
    copied(one_run, tmp_path / "a")
    other = copied(one_run, tmp_path / "b")
    scenes = read_table(other.file("scenes.parquet"), SCENES)
    older = scenes.drop_columns(["crash_type", "light", "weather", "surface", "OPT_GEO_Y"])
    count = older.num_rows
    changed_scenes(
        other,
        older.append_column("OPT_SPEED", pa.array([2.5] * count)).append_column("calm", pa.array([0.5] * count)),
    )
    assert column("SELECT DISTINCT name FROM parameters WHERE run = 'a' ORDER BY name", tmp_path) == [
        "OPT_ADV_DISTANCE",
        "OPT_ADV_SPEED",
        "OPT_GEO_Y",
    ]
    assert column("SELECT DISTINCT name FROM parameters WHERE run = 'b' ORDER BY name", tmp_path) == [
        "OPT_ADV_DISTANCE",
        "OPT_ADV_SPEED",
        "OPT_SPEED",
    ]
    assert answered("SELECT run, max(calm) calm, max(light) light FROM scenes GROUP BY run ORDER BY run", tmp_path) == [
        {"run": "a", "calm": None, "light": "day"},
        {"run": "b", "calm": 0.5, "light": "day"},
    ]


def test_a_crash_has_a_kind_and_nothing_else_has(one_run: Path) -> None:
    wrong = "(crash_type IS NULL) = (status = 'ran' AND collision)"
    assert column(f"SELECT count(*) FROM scenes WHERE {wrong}", one_run) == [0]
    assert column("SELECT count(DISTINCT crash_type) > 1 FROM scenes", one_run) == [True]


def test_a_parameter_has_the_range_that_its_block_drew_from(one_run: Path) -> None:
    assert column("SELECT count(*) FROM parameters WHERE value < low - 1e-9 OR value > high + 1e-9", one_run) == [0]
    query = "SELECT DISTINCT unit FROM parameters WHERE name = 'OPT_ADV_SPEED' AND meaning = 'walking speed'"
    assert column(query, one_run) == ["m/s"]
    assert column("SELECT count(*) FROM parameters", one_run) == [3 * 55]


def test_a_metric_that_takes_the_place_of_the_runs_name_keeps_its_folder_out(one_run: Path, tmp_path: Path) -> None:
    copied(one_run, tmp_path / "a")
    other = copied(one_run, tmp_path / "b")
    scenes = read_table(other.file("scenes.parquet"), SCENES)
    changed_scenes(other, scenes.append_column("run", pa.array([0.0] * scenes.num_rows)))
    found = index(tmp_path)
    assert [one.folder.name for one in found.left_out] == ["b"]
    assert set(found.tables["runs"].column("run").to_pylist()) == {"a"}


def test_a_thousand_scenes_of_twenty_runs_are_counted(one_run: Path, tmp_path: Path) -> None:
    for number in range(20):
        copied(one_run, tmp_path / f"run-{number:02d}")
    query = "SELECT count(*) n, count(DISTINCT run) runs, bool_and(dt = 0.1) same FROM scenes WHERE status = 'ran'"
    found = index(tmp_path)
    assert rows_of(ask(query, found)) == [{"n": 1000, "runs": 20, "same": True}]
    sums = "SELECT sum(impact_speed) FROM scenes"
    assert answer(sums, found.tables).equals(answer(sums, found.tables))


def test_runs_are_listed_without_duckdb_and_sql_names_the_extra(one_run: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "duckdb", None)
    assert json.loads(told("runs", one_run, "--json").stdout)[0]["scenes"] == 55
    assert "walker" in told("runs", one_run.parent).stdout
    with pytest.raises(MissingExtra, match=r'pip install .*\[sql\]"'):
        chatscene.sql("SELECT 1", one_run)


def test_a_folder_without_runs_is_told(tmp_path: Path) -> None:
    for folder in (tmp_path, tmp_path / "none"):
        with pytest.raises(RunError, match=r"there is no|no folder"):
            index(folder)


def test_an_answer_in_json_is_json(one_run: Path) -> None:
    query = (
        "SELECT 'nan'::DOUBLE n, 1::DOUBLE / 0 i, -1::DOUBLE / 0 j, NULL o, "
        "sum(block) s, 1.5::DECIMAL(4,2) d, '2026-11-24'::DATE AS day, '\\xAA'::BLOB b, "
        "list(DISTINCT status ORDER BY status) l, map {'a': 1} m, {'x': NULL} t FROM scenes"
    )
    done = told("sql", query, one_run, "--json")
    (row,) = json.loads(done.stdout, parse_constant=pytest.fail)
    assert (row["n"], row["i"], row["j"], row["o"]) == ("NaN", "Infinity", "-Infinity", None)
    assert row["s"] == 110
    assert row["d"] == 1.5
    assert row["day"] == "2026-11-24"
    assert row["l"] == ["ran", "rejected"]
    assert row["b"] == "aa"
    assert row["m"] == [["a", 1]]
    assert row["t"] == {"x": None}
    with pytest.raises(QueryError, match="AS"):
        answered("SELECT 1 AS a, 2 AS a", one_run)


def test_a_column_that_a_run_has_is_a_column_that_is_documented(one_run: Path) -> None:
    for name, table in index(one_run).tables.items():
        assert table.schema.equals(schema_of(name)), name
    for columns in TABLES.values():
        assert all(one.meaning and one.in_sql for one in columns)


def test_the_tables_are_listed_column_by_column_with_their_units() -> None:
    listed = json.loads(told("sql", "--tables", "--json").stdout)
    assert set(listed) == set(TABLES) == set(ROWS)
    units = {one["column"]: one["unit"] for one in listed["scenes"]["columns"]}
    assert (units["impact_speed"], units["time_to_collision"], units["distance"]) == ("m/s", "s", "m")
    shown = told("sql", "--tables").stdout
    assert all(one.name in shown for columns in TABLES.values() for one in columns)


COMMANDS = re.compile(r"^\$ chatscene ((?:sql|runs)\b.*?)(?:  # status (\d).*)?$", re.MULTILINE)


def test_the_commands_of_the_page_do_what_it_says(
    one_run: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    copied(one_run, tmp_path / "runs" / "pedestrian")
    copied(one_run, tmp_path / "runs" / "cyclist", adversary="bicycle", side="left")
    monkeypatch.chdir(tmp_path)
    page = (ROOT / "docs" / "sql.md").read_text(encoding="utf-8")
    steps = COMMANDS.findall(page)
    assert len(steps) == 7
    for command, status in steps:
        done = told(*shlex.split(command))
        assert done.exit_code == int(status or 0), f"{command}\n{done.output}"
        assert not re.search(r"^0 rows", done.output, re.MULTILINE), command
    (code,) = re.findall(r"```python\n(.*?)```", page, re.DOTALL)
    here: dict[str, Any] = {}
    exec(code, here)
    assert here["worst"].num_rows == 5


def test_only_one_column_has_a_name_that_must_be_quoted(one_index: Index) -> None:
    for name, columns in TABLES.items():
        answer(f"SELECT {', '.join(one.name for one in columns if one.name != 'or')} FROM {name}", one_index.tables)
    assert answer('SELECT "or" FROM scenes', one_index.tables).num_rows == 55


def test_every_slot_has_a_column_since_what_has_none_would_be_dropped_in_silence() -> None:
    columns = {column.name for column in TABLES["facts"]}
    assert {OTHERWISE_CALLED.get(field.name, field.name) for field in fields(Slots)} <= columns
