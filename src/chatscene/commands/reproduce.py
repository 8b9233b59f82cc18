"""The command line, continued: the paper's tables."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from chatscene.commands.options import AVOIDABLE, JSON, NEW_FOLDER, PHYSICS_OPTION, SEED, WORKERS
from chatscene.commands.output import progress, say

if TYPE_CHECKING:
    from chatscene.studies.reproduce import Reproduced

ALL = "all"


@click.command()
@click.argument("tables", nargs=-1, required=True, metavar="TABLE...")
@click.option(
    "--budget",
    default="small",
    show_default=True,
    help="'small': minutes; 'paper': as many simulations per method as in the paper; 'reference': each method's own.",
)
@AVOIDABLE
@PHYSICS_OPTION
@click.option(
    "--preset",
    default="released",
    show_default=True,
    help="Gradient steps in table 3: released, one per episode, or paper, one per step.",
)
@click.option(
    "--choice",
    default="paper",
    show_default=True,
    help="Routes on which table 3's checkpoints are chosen: paper, or held-out.",
)
@SEED
@NEW_FOLDER
@WORKERS
@JSON
def reproduce(
    tables: tuple[str, ...], avoidable: bool, out: Path, jobs: int, executor: str, as_json: bool, **options: Any
) -> None:
    """Make the paper's tables, with the paper's numbers below ours. TABLE is table1 to table5, or all.

    Missing runs are made. Repeat the command to continue after an interruption. Needs the extras 'search' and, for
    table 3, 'train'.

    \b
    chatscene reproduce all --out runs/tables
    chatscene reproduce table1 table2 --budget paper --jobs 2 --out runs/tables-paper
    """
    from chatscene.runs.executor import Workers
    from chatscene.studies.reproduce import TABLES
    from chatscene.studies.reproduce import reproduce as make

    done = make(
        out,
        TABLES if tables == (ALL,) else tables,
        avoidable_only=avoidable,
        workers=Workers(jobs, executor),
        progress=progress(),
        **options,
    )
    say_reproduced(done, as_json)


def say_reproduced(done: Reproduced, as_json: bool) -> None:
    """Say what a reproduction came to."""
    from chatscene.report.tables import as_text

    if as_json:
        say(json.dumps({"folder": str(done.folder), "tables": sorted(done.tables), "seconds": done.seconds}))
        return
    for table in done.tables.values():
        say(as_text(table))
    spent = ", ".join(f"{part} {seconds:.0f} s" for part, seconds in done.seconds.items())
    say(f"wall time: {spent}\ntables as text, Markdown, CSV and LaTeX: {done.folder / 'tables'}")
