"""Tables of pages, made of what the code says; `UPDATE_GOLDEN=1 pytest tests/test_page_tables.py` writes them."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields
from typing import Any

import pytest

from chatscene.exports.exporter import EXPORTERS
from chatscene.plugins import Kind, Packaged
from chatscene.search.sampler import SAMPLERS
from chatscene.terms.criticality import Criticality
from places import ROOT

COMMAND = "UPDATE_GOLDEN=1 pytest tests/test_page_tables.py"
ENDS = "<!-- end of it -->\n"
Row = Sequence[str]


def plugins(kind: Kind[Any], *columns: str) -> Iterator[Row]:
    """A row per built-in plug-in: its name, and what its file says of it."""
    assert isinstance(kind.built_in, Packaged)
    for name, row in kind.built_in.rows.items():
        needs = f'; needs `pip install -e ".[{row["needs"]}]"`' if "needs" in row else ""
        yield (f"`{name}`", row["what"] + needs, *(row.get(column, "") for column in columns))


def exporters() -> Iterator[Row]:
    yield ("`--to`", "you want", "per scene", "also")
    yield from plugins(EXPORTERS, "per scene", "also")
    yield ("`package.module:factory`", "[your own format](plugins.md)", "", "")


def samplers() -> Iterator[Row]:
    yield ("`--sampler`", "what it does")
    yield from plugins(SAMPLERS)


def criticality() -> Iterator[Row]:
    yield ("column", "unit", "what it is", "null when")
    yield from ((f"`{one.name}`", *one.metadata["page"]) for one in fields(Criticality))


TABLES = {"exports.md": exporters, "search.md": samplers, "metrics.md": criticality}


@pytest.mark.parametrize("page", TABLES)
def test_the_table_of_a_page_is_what_the_code_says(page: str) -> None:
    path, made = ROOT / "docs" / page, table(TABLES[page])
    begins = f"<!-- table: {TABLES[page].__name__}; {COMMAND} writes it -->\n"
    text = path.read_text(encoding="utf-8")
    before, _, rest = text.partition(begins)
    there, _, after = rest.partition(ENDS)
    if os.environ.get("UPDATE_GOLDEN"):
        path.write_text(f"{before}{begins}{made}{ENDS}{after}", encoding="utf-8")
        return
    same = there == made  # two whole tables would hide the message
    assert same, f"the table of docs/{page} has changed: {COMMAND} writes it"


def table(rows: Callable[[], Iterator[Row]]) -> str:
    """A table as Markdown has it."""
    head, *others = rows()
    lines = [f"| {' | '.join(cells)} |".replace("|  |", "| |").replace("|  |", "| |") for cells in (head, *others)]
    return "\n".join((lines[0], "|---" * len(head) + "|", *lines[1:], ""))
