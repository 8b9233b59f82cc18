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
    """Show the runs below DIR (default: runs/) in the browser, where you can also describe, change and run situations.

    The page is served on loopback and loads nothing from elsewhere. Its address has a secret that is new each time.
    Interrupt the command to end it.

    \b
    chatscene view
    chatscene view runs/mine --port 8000 --scenes 20
    """
    from chatscene.view.server import Server

    search = {"map": map, "ego": ego, "scenes": scenes, "seed": seed}
    with Server(folder, port, reading, search) as server:
        say(f"the runs below {folder} are shown at {server.address} until you press Ctrl+C")
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            say("ended; the runs stay in their folders")


@click.command("open")
@click.argument("folder", metavar="[RUN]", required=False, type=click.Path(path_type=Path))
def open_report(folder: Path | None) -> None:
    """Open the report of RUN, or of the newest run below runs/, in the browser, and print its path.

    RUN is a run or an evaluation. The report is first written anew from the folder's tables; an existing report.html is
    never opened.

    \b
    chatscene open
    chatscene open runs/cyclist
    chatscene open runs/compared
    """
    page = _drawn(folder or _newest(Path("runs")))
    webbrowser.open(page.absolute().as_uri())
    say(str(page))


def _drawn(folder: Path) -> Path:
    """The page of a run or an evaluation, drawn anew: a browser runs what it holds, and it may be a stranger's."""
    from chatscene import runs
    from chatscene.report.evaluation import write_evaluation
    from chatscene.report.viewer import write_report

    work = runs.open_run(folder)
    record = runs.read_record(work, runs.Record)
    if record.kind not in {runs.Kind.RUN, runs.Kind.EVALUATION}:
        raise RunError(f"{folder} holds {record.kind.in_words()}; `open` shows a run or an evaluation")
    runs.require_done(work, record)
    page = work.file("report.html")
    finished = page.stat().st_mtime if page.is_file() else None
    if record.kind is runs.Kind.RUN:
        write_report(folder)
    else:
        write_evaluation(work)
    if finished is not None:
        os.utime(page, (finished, finished))  # the newest run is the one finished last, not the one opened last
    return page


def _newest(folder: Path) -> Path:
    """The run that was finished last."""
    from chatscene.runs import run_folders

    reports = [run / "report.html" for run in run_folders([folder], readable=True)]
    there = [page for page in reports if page.is_file()]
    if not there:
        raise RunError(f"no run below {folder} has a report; finish one with: chatscene resume DIR")
    return max(there, key=lambda page: page.stat().st_mtime).parent
