"""The command line, continued: runs in a browser."""

from __future__ import annotations

import os
import webbrowser
from pathlib import Path
from typing import Unpack

import click

from chatscene.commands.options import EGO_OPTION, MANY, MAP_WITH_SITE, READING, SEED, Reading
from chatscene.commands.output import say
from chatscene.errors import RunError


@click.command()
@click.argument("folder", metavar="[DIR]", default=Path("runs"), type=click.Path(path_type=Path, file_okay=False))
@click.option("--port", default=0, type=click.IntRange(0, 65535), help="Port on loopback.  [default: a free one]")
@MAP_WITH_SITE
@EGO_OPTION
@click.option("--scenes", default=50, show_default=True, type=MANY, help="Simulations per run.")
@SEED
@READING
def view(
    folder: Path,
    port: int,
    map: str | None,  # noqa: A002 - the name of the option
    ego: str,
    scenes: int,
    seed: int,
    **reading: Unpack[Reading],
) -> None:
    """Show the runs below DIR, or runs/, in a page, in which a situation can be said, changed and run.

    The page is on loopback and asks nobody for anything; its address has a secret, which is new each time. It is there
    until the command is interrupted.

    \b
    chatscene view
    chatscene view runs/mine --port 8000 --scenes 20
    """
    from chatscene.view.server import Server

    search = {"map": map, "ego": ego, "scenes": scenes, "seed": seed}
    with Server(folder, port, reading, search) as server:
        say(f"the runs below {folder} are shown at {server.address} until this is interrupted (Ctrl+C)")
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            say("ended; runs are in their folders")


@click.command("open")
@click.argument("folder", metavar="[RUN]", required=False, type=click.Path(path_type=Path))
def open_report(folder: Path | None) -> None:
    """Open the report of RUN in the browser, or of the newest run below runs/; print its path.

    The report is drawn anew from the other files of the folder first: what stood in its place is never opened.

    \b
    chatscene open
    chatscene open runs/cyclist
    """
    from chatscene.api import Run
    from chatscene.report.viewer import write_report

    page = Run(folder or _newest(Path("runs"))).report
    if not page.is_file():
        raise RunError(f"{page} is not there any more; run it again into another folder")
    finished = page.stat().st_mtime
    # A browser runs what the page holds, and no digest keeps a stranger's page from being shown.
    write_report(page.parent)
    os.utime(page, (finished, finished))  # the newest run is the one that was finished last, not the one opened last
    webbrowser.open(page.absolute().as_uri())
    say(str(page))


def _newest(folder: Path) -> Path:
    """The run that was finished last."""
    from chatscene.runs import run_folders

    reports = [run / "report.html" for run in run_folders([folder])]
    there = [page for page in reports if page.is_file()]
    if not there:
        raise RunError(f"no run below {folder} has a report; finish one with: chatscene resume DIR")
    return max(there, key=lambda page: page.stat().st_mtime).parent
