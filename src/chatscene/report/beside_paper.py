"""The paper's own numbers, put below ours row by row."""

from __future__ import annotations

import json
from dataclasses import replace
from functools import cache
from importlib.resources import files

from chatscene.terms.results import Cell, ResultTable

PAPER = "paper"


def beside_paper(table: ResultTable, name: str) -> ResultTable:
    """A table of ours with the paper's row below each of ours that the paper has."""
    paper = _paper()[name]
    rows: list[tuple[str, tuple[Cell, ...]]] = []
    for label, cells in table.rows:
        rows.append((label, cells))
        if label in paper:
            rows.append((f"… {PAPER}", tuple(map(Cell, paper[label]))))
    return replace(table, rows=tuple(rows), notes=(*table.notes, f"… {PAPER}: the paper's number, in CARLA."))


@cache
def _paper() -> dict[str, dict[str, list[float]]]:
    content = json.loads(files("chatscene.report").joinpath("paper_tables.json").read_text(encoding="utf-8"))
    return {name: rows for name, rows in content.items() if name != "about"}
