"""How long a query over many runs takes and how much memory, and the same tables and query in SQLite beside it.

One run of 50 scenes is driven by the rule-based planner and copied; the index and the answers are made in a process of
their own.

    python benchmarks/many_runs.py [RUNS]        # 100 if none is given
"""

from __future__ import annotations

import resource
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from chatscene.report.index import Index, index
from chatscene.report.sql import ask

SENTENCE = "A cyclist rides out from the left and stops in front of us."
QUERY = (
    "SELECT run, scene_id, impact_speed FROM scenes JOIN facts USING (run, scenario_id) "
    "WHERE collision AND adversary = 'bicycle' AND side = 'left' ORDER BY impact_speed DESC"
)
MEDIANS = "SELECT name, median(value) FROM parameters GROUP BY name"


def copies(count: int, folder: Path) -> None:
    first = folder / "run-000"
    drive = [sys.executable, "-m", "chatscene", "run", SENTENCE, "--ego", "idm", "--scenes", "50", "--out", str(first)]
    subprocess.run(drive, check=True, capture_output=True)  # elsewhere, so that the memory below is the index's own
    for number in range(1, count):
        shutil.copytree(first, folder / f"run-{number:03d}")


def in_sqlite(found: Index) -> sqlite3.Connection:
    connection = sqlite3.connect(":memory:")
    for name, table in found.tables.items():
        columns = ", ".join(f'"{column}"' for column in table.column_names)
        places = ", ".join("?" * table.num_columns)
        connection.execute(f"CREATE TABLE {name} ({columns})")
        rows = zip(*(map(_of_sqlite, column.to_pylist()) for column in table.columns), strict=True)
        connection.executemany(f"INSERT INTO {name} VALUES ({places})", rows)
    return connection


def _of_sqlite(value: Any) -> Any:
    return ", ".join(value) if isinstance(value, list) else value


def memory() -> float:
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def told(what: str, began: float) -> None:
    print(f"{what:<44} {time.perf_counter() - began:7.2f} s   at most {memory():5.0f} MB so far")


def main(count: int) -> None:
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        copies(count, folder)
        size = sum(path.stat().st_size for path in folder.rglob("*") if path.is_file())
        print(f"{count} runs, {size / 1e6:.0f} MB")
        print(f"before: {memory():.0f} MB")
        began = time.perf_counter()
        found = index(folder)
        told(f"index: {found.tables['scenes'].num_rows} scenes, {len(found.left_out)} left out", began)
        print(f"  its tables: {sum(table.nbytes for table in found.tables.values()) / 1e6:.1f} MB")
        for query in (QUERY, MEDIANS):
            began = time.perf_counter()
            rows = ask(query, found).num_rows
            told(f"DuckDB: {rows} rows", began)
        began = time.perf_counter()
        connection = in_sqlite(found)
        told("SQLite: tables filled", began)
        began = time.perf_counter()
        told(f"SQLite: {len(connection.execute(QUERY).fetchall())} rows", began)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 100)
