"""The command line, continued: the paper's tables."""

from __future__ import annotations

import json
from pathlib import Path
from typing import TYPE_CHECKING

import click

from chatscene.commands.library import JSON, PHYSICS_OPTION, WORKERS, progress, say

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
@click.option("--avoidable", is_flag=True, help="Keep only crashes that a careful driver would have avoided.")
@PHYSICS_OPTION
@click.option("--preset", default="released", show_default=True, help="Gradient steps of table 3: released, or paper.")
@click.option("--choice", default="paper", show_default=True, help="Checkpoints of table 3: paper, or held-out.")
@click.option("--seed", default=0, show_default=True)
@click.option(
    "--out", type=click.Path(path_type=Path, file_okay=False), required=True, help="A new folder, or one to continue."
)
@WORKERS
@JSON
def reproduce(
    tables: tuple[str, ...],
    budget: str,
    avoidable: bool,
    physics: str,
    preset: str,
    choice: str,
    seed: int,
    out: Path,
    jobs: int,
    executor: str,
    as_json: bool,
) -> None:
    """Make the paper's tables, TABLE... being table1 to table5 or all, with its own numbers below ours.

    What is missing is run, and the same command goes on after a kill. Needs the extras 'search' and, for table 3,
    'train'.

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
        budget=budget,
        avoidable_only=avoidable,
        physics=physics,
        preset=preset,
        choice=choice,
        seed=seed,
        workers=Workers(jobs, executor),
        progress=progress(),
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
