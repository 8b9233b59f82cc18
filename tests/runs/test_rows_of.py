"""Rows of tables, as fast as they are read."""

from __future__ import annotations

import pyarrow as pa
import pytest

from chatscene.runs import tables
from chatscene.runs.tables import rows_of


@pytest.mark.parametrize("few", [0, 500])
def test_rows_are_those_that_arrow_gives(monkeypatch: pytest.MonkeyPatch, few: int) -> None:
    monkeypatch.setattr(tables, "_FEW", few)
    columns = {
        "words": pa.array(["a", None, "a", "b"]),
        "whole": pa.array([1, None, 3, -4], pa.int64()),
        "small": pa.array([1, 2, 3, 4], pa.int32()),
        "numbers": pa.array([0.5, float("inf"), None, -0.0]),
        "flags": pa.array([True, None, False, True]),
        "lists": pa.array([["x"], None, [], ["y", "z"]], pa.list_(pa.string())),
    }
    table = pa.table(columns)
    assert rows_of(table) == table.to_pylist()
    assert rows_of(pa.concat_tables([table, table.slice(1, 2)])) == [*table.to_pylist(), *table.slice(1, 2).to_pylist()]
    assert rows_of(table.slice(0, 0)) == []
    assert {type(value) for value in rows_of(table)[0].values()} == {str, int, float, bool, list}
