"""The command line, continued: how often a situation ends in a crash."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import click

import chatscene
from chatscene.commands.options import DRIVEN_AGAIN, JSON, SEEDS, WORKERS
from chatscene.commands.output import progress, say
from chatscene.errors import SettingsError
from chatscene.settings import EGO

FIRST_LOOK = 20  # scenes of a run that is made only to have its situation rated


@click.command()
@click.argument("what", metavar="DIR|TEXT")
@click.option(
    "--scenes",
    default=200,
    show_default=True,
    type=click.IntRange(0, 1_000_000),
    help="Scenes to draw in addition to the run's.",
)
@click.option("--seed", default=0, show_default=True, type=SEEDS, help="Seed of these scenes.")
@click.option(
    "--exposure",
    metavar="FILE",
    type=click.Path(path_type=Path),
    help="TOML file with a density per parameter. Without it, all values of a range are assumed equally frequent.",
)
@WORKERS
@DRIVEN_AGAIN
@JSON
def rate(
    what: str,
    scenes: int,
    seed: int,
    exposure: Path | None,
    jobs: int,
    executor: str,
    as_json: bool,
    **again: Any,
) -> None:
    """Estimate how often a run's situation, if it occurs, ends in a crash, and in an avoidable one.

    DIR is a run; its ego drives. For a TEXT, a run is made first, with --ego if given. If crashes are rare, more scenes
    are drawn near those that were found, and weighted by how often they occur.

    \b
    chatscene rate runs/cyclist
    chatscene rate runs/cyclist --exposure speeds.toml --scenes 1000
    """
    from chatscene import runs
    from chatscene.search.exposure import read_exposure

    folder = Path(what)
    if exposure is not None:
        read_exposure(exposure)  # what is wrong with it is said before anything is driven
    if " " in what.strip() and not os.path.lexists(what):  # a path that is too long is none
        for option in ("simulator", "generator", "library"):
            if again[option]:
                raise SettingsError(
                    f"--{option} names what a run in a folder uses; of a text, make the run first, with `chatscene run`"
                )
        folder = runs.free_folder(Path("runs"), what)
        ego = again["ego"][0] if again["ego"] else EGO
        chatscene.run(
            what,
            folder,
            scenes=FIRST_LOOK,
            sampler="random",
            jobs=jobs,
            executor=executor,
            progress=progress(),
            ego=ego,
        )
        say(f"the run: {folder}", err=as_json)
    found = chatscene.rate(
        folder, scenes=scenes, seed=seed, exposure=exposure, jobs=jobs, executor=executor, progress=progress(), **again
    )
    say(json.dumps(found.as_dict()) if as_json else found.in_words())
