"""The command line, continued: what many runs asked for and came to, listed and asked in SQL."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import click

from chatscene.commands.options import JSON
from chatscene.commands.output import console, say

if TYPE_CHECKING:
    from chatscene.report.index import Index

WHERE = click.argument("folder", metavar="[DIR]", default=Path("runs"), type=click.Path(path_type=Path))


@click.command()
@click.argument("query", required=False)
@WHERE
@click.option(
    "--tables", "show_tables", is_flag=True, help="List the tables and columns, with units, instead of a query."
)
@JSON
def sql(query: str | None, folder: Path, show_tables: bool, as_json: bool) -> None:
    """Answer QUERY, a SELECT over all runs below DIR. DIR is runs/ if none is given.

    Tables: runs, facts (what the sentences say), scenes, parameters, events. Needs the extra 'sql'.

    \b
    chatscene sql "SELECT run, scene_id, impact_speed FROM scenes JOIN facts USING (run, scenario_id)
      WHERE avoidable AND adversary = 'bicycle' AND side = 'left'"
    chatscene sql "SELECT ego, avg(collision::INT) FROM scenes GROUP BY ego" runs/benchmark --json
    chatscene sql --tables
    """
    if show_tables:
        _say_tables(as_json)
        return
    if query is None:
        raise click.UsageError("nothing to ask: give a SELECT, or --tables")
    from chatscene.report.sql import ask, rows_of

    answer = ask(query, _index(folder))
    if as_json:
        say(json.dumps(rows_of(answer), indent=1, ensure_ascii=False))
        return
    from chatscene.report.terminal import print_answer

    print_answer(console(), answer)


@click.command("runs")
@WHERE
@JSON
def runs_below(folder: Path, as_json: bool) -> None:
    """List all runs below DIR, one per line. DIR is runs/ if none is given.

    \b
    chatscene runs
    chatscene runs runs/benchmark --json
    """
    rows = (
        _index(folder)
        .tables["runs"]
        .select(["run", "status", "ego", "scenes", "collided", "off_road", "selected", "text"])
    )
    if as_json:
        say(json.dumps(rows.to_pylist(), indent=1, ensure_ascii=False))
        return
    from chatscene.report.terminal import print_answer

    print_answer(console(), rows)


def _index(folder: Path) -> Index:
    """The index of a folder; what is left out of it is told."""
    from chatscene.report.index import index

    found = index(folder)
    for one in found.left_out:
        say(str(one), err=True)
    return found


def _say_tables(as_json: bool) -> None:
    from chatscene.report.index_columns import ROWS, TABLES
    from chatscene.report.terminal import print_columns

    if as_json:
        told = {name: {"rows": ROWS[name], "columns": [one.as_dict() for one in TABLES[name]]} for name in TABLES}
        say(json.dumps(told, indent=1, ensure_ascii=False))
    else:
        print_columns(console(), ROWS, TABLES)
