"""The command line, continued: what of a catalogue of traffic situations is served."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Unpack

import click

from chatscene.commands.options import EGOS, JSON, MANY, MAP_WITH_SITE, READING, SEED, WORKERS, Named, Reading
from chatscene.commands.output import console, progress, say, say_failures


@click.command()
@click.option(
    "--catalogue",
    "catalogues",
    multiple=True,
    metavar="NAME|FILE|DIR",
    help="nhtsa, ncap, r157, iso34502, leaderboard, challenge, a .toml file of your own, or a folder that `import` "
    "made. Repeatable.  [default: all six names]",
)
@click.option("--drive", is_flag=True, help="Draw scenes of each entry and let egos drive them.")
@click.option(
    "--scenes",
    type=MANY,
    default=None,
    help="Scenes per entry.  [default: 10 with --drive, 50 with --fill]",
)
@click.option(
    "--ego",
    "egos",
    cls=Named,
    kind=EGOS,
    multiple=True,
    help="An ego by name, file or package.module:factory. Repeatable; runs use the first.  [default: sac, idm]",
)
@MAP_WITH_SITE
@SEED
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    default=None,
    help="Folder for the page, JSON and runs.",
)
@click.option(
    "--fill", is_flag=True, help="Make a run of each served entry that has none under --out yet; can be interrupted."
)
@WORKERS
@READING
@JSON
def coverage(
    catalogues: tuple[str, ...],
    drive: bool,
    scenes: int | None,
    egos: tuple[str, ...],
    map: str | None,  # noqa: A002 - the name of the option
    seed: int,
    out: Path | None,
    fill: bool,
    jobs: int,
    executor: str,
    as_json: bool,
    **reading: Unpack[Reading],
) -> None:
    """Show which entries of a catalogue of traffic situations can be made, and why the others cannot.

    With --drive, also show how many drives show all facts that were read, and how many collisions were avoidable.

    \b
    chatscene coverage
    chatscene coverage --catalogue nhtsa --catalogue mine.toml --drive --jobs 2 --out runs/coverage
    chatscene coverage --catalogue imported --drive
    chatscene coverage --catalogue ncap --fill --jobs 2 --out runs/ncap
    """
    from chatscene.report.terminal import print_coverage
    from chatscene.runs.executor import Workers
    from chatscene.settings import RetrievalSettings, SearchSettings, Settings
    from chatscene.studies import coverage as desk
    from chatscene.studies.catalogue import PACKAGED, load_catalogue

    if fill and out is None:
        raise click.UsageError("--fill needs --out, where runs are kept")
    search = SearchSettings(seed=seed) if scenes is None else SearchSettings(seed=seed, scenes=scenes)
    asked = desk.Asked(
        settings=Settings(search=search, retrieval=RetrievalSettings(**reading)),
        map_name=map,
        egos=egos or desk.EGOS,
        scenes=(scenes or desk.SCENES) if drive else 0,
        folder=out,
        fill=fill,
    )
    found = [load_catalogue(name) for name in dict.fromkeys(catalogues or PACKAGED)]
    rows = desk.cover(found, asked, workers=Workers(jobs, executor), progress=progress())
    page = desk.write(out, found, asked, rows) if out else None
    if as_json:
        say(json.dumps(desk.as_json(found, asked, rows), indent=1, ensure_ascii=False))
    else:
        for catalogue in found:
            print_coverage(console(), catalogue, desk.of_catalogue(catalogue, rows))
        if page:
            say(f"page: {page}")
    failures: dict[str, str] = {}
    for row in rows:
        for ego, reason in row.failures.items():
            failures.setdefault(ego, f"{row.entry.name}: {reason}")
    say_failures(failures)
