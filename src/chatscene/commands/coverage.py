"""The command line, continued: what of a catalogue of traffic situations is served."""

from __future__ import annotations

import json
from typing import Unpack

import click

from chatscene.commands.library import JSON, READING, Reading, console, progress, say


@click.command()
@click.option(
    "--catalogue",
    "catalogues",
    multiple=True,
    metavar="NAME|FILE",
    help="nhtsa, ncap, r157, iso34502, leaderboard, challenge, or a .toml file of your own; repeat.  "
    "[default: all of these]",
)
@click.option("--jobs", default=1, show_default=True, type=click.IntRange(min=1), help="Processes.")
@READING
@JSON
def coverage(catalogues: tuple[str, ...], jobs: int, as_json: bool, **reading: Unpack[Reading]) -> None:
    """Show what of a catalogue of traffic situations is served: a row per entry, and why the others are not.

    \b
    chatscene coverage
    chatscene coverage --catalogue nhtsa --catalogue mine.toml --json
    """
    from chatscene.report.terminal import print_coverage
    from chatscene.settings import RetrievalSettings
    from chatscene.studies import coverage as desk
    from chatscene.studies.catalogue import PACKAGED, load_catalogue

    asked = [load_catalogue(name) for name in dict.fromkeys(catalogues or PACKAGED)]
    rows = desk.cover(asked, settings=RetrievalSettings(**reading), jobs=jobs, progress=progress())
    if as_json:
        say(json.dumps(desk.as_json(asked, rows), indent=1, ensure_ascii=False))
        return
    for catalogue in asked:
        print_coverage(console(), catalogue, desk.of_catalogue(catalogue, rows))
