"""The command line, continued: how egos fare, on kept scenes, on the paper's, and on ordinary drives."""

from __future__ import annotations

import json
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import chatscene
from chatscene.commands.options import (
    AS_WRITTEN,
    AVOIDABLE,
    EGOS,
    GENERATOR_AGAIN,
    GENERATORS,
    JSON,
    LIBRARY_AGAIN,
    MANY,
    MAP,
    NEW_FOLDER,
    PHYSICS_OPTION,
    PHYSICS_THERE,
    SEED,
    SEEDS,
    SIMULATOR_OPTION,
    SIMULATOR_THERE,
    SPEED,
    WORKERS,
    Named,
    road_speed,
    sampler_option,
)
from chatscene.commands.output import progress, say, say_failures
from chatscene.settings import PAPER, SimulationSettings

if TYPE_CHECKING:
    from chatscene.studies.benchmark import Benchmarked
    from chatscene.studies.collection import Compared
    from chatscene.studies.evaluation import Evaluated


@click.command()
@click.argument("scenes", metavar="DIR...", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option(
    "--ego",
    cls=Named,
    kind=EGOS,
    multiple=True,
    help="An ego by name, file or package.module:factory. Repeatable.  [default: planner, idm, sac]",
)
@AS_WRITTEN
@SPEED
@click.option("--all", is_flag=True, help="Use every scene that ran, not only the kept ones.")
@SIMULATOR_THERE
@PHYSICS_THERE
@click.option(
    "--out", type=click.Path(path_type=Path, file_okay=False), default=None, help="Default: a new folder under runs/."
)
@WORKERS
@GENERATOR_AGAIN
@LIBRARY_AGAIN
@JSON
def evaluate(scenes: tuple[Path, ...], out: Path | None, as_json: bool, **options: Any) -> None:
    """Compare egos on the kept scenes of the runs in DIR.... Prints a row per ego; the paper's tables go to files.

    DIR may be a folder that `chatscene import FOLDER --out DIR` made. Then each ego drives each of its programs.

    \b
    chatscene evaluate runs/cyclist --ego sac --ego idm
    chatscene evaluate imported --ego planner --ego idm
    chatscene evaluate imported --as-written
    chatscene evaluate runs/* --ego my-policy.onnx --ego mypackage.stack:make_ego --out runs/my-stack
    """
    from chatscene import runs
    from chatscene.studies.collection import Compared

    folder = out or runs.free_folder(Path("runs"), "evaluation")
    done = chatscene.evaluate(scenes, folder, progress=progress(), **options)
    if isinstance(done, Compared):
        say_compared(done, as_json)
    else:
        say_evaluated(done, as_json)


@click.command()
@click.option(
    "--generator", cls=Named, kind=GENERATORS, default="chatscene", show_default=True, help="Generator of the scenes."
)
@click.option(
    "--budget",
    default="small",
    show_default=True,
    help="'paper': 20,000 simulations; 'small': minutes; 'reference': each generator's own number of tries.",
)
@click.option(
    "--ego", "egos", cls=Named, kind=EGOS, multiple=True, help="Ego to measure. Repeatable.  [default: sac, ppo, td3]"
)
@click.option(
    "--surrogate",
    cls=Named,
    kind=EGOS,
    default="sac",
    show_default=True,
    help="The ego that scenes are searched against.",
)
@MAP
@AVOIDABLE
@sampler_option(PAPER.sampler)
@SIMULATOR_OPTION
@PHYSICS_OPTION
@SEED
@NEW_FOLDER
@WORKERS
@JSON
def benchmark(
    egos: tuple[str, ...],
    map: str,  # noqa: A002 - the name of the option
    avoidable: bool,
    out: Path,
    jobs: int,
    executor: str,
    as_json: bool,
    **options: Any,
) -> None:
    """Search all eight base scenarios and measure egos on the scenes that are kept; the paper's main experiment.

    \b
    chatscene benchmark --budget small --out runs/benchmark
    chatscene benchmark --budget paper --jobs 2 --out runs/paper
    chatscene benchmark --generator advsim --budget paper --jobs 2 --out runs/advsim
    """
    from chatscene.runs.executor import Workers
    from chatscene.studies import benchmark as benchmarks
    from chatscene.studies import evaluation

    outcome = benchmarks.benchmark(
        out,
        egos=egos or evaluation.EGOS,
        map_name=map,
        avoidable_only=avoidable,
        workers=Workers(jobs, executor),
        progress=progress(),
        **options,
    )
    say_benchmarked(outcome, as_json)


@click.command()
@click.option(
    "--ego",
    "egos",
    cls=Named,
    kind=EGOS,
    multiple=True,
    required=True,
    help="An ego by name, file or package.module:factory. Repeatable.",
)
@MAP
@SIMULATOR_OPTION
@PHYSICS_OPTION
@click.option("--scenes", default=5, show_default=True, type=MANY, help="Variants of the traffic per route.")
@click.option("--seed", default=20_000, show_default=True, type=SEEDS, help="Seed of the traffic.")
@road_speed(
    "Speed of the egos in km/h, within the speed limits; other traffic scales with it. 'road': only the limits apply."
    "  [default: the egos' own speed]"
)
@click.option(
    "--out", type=click.Path(path_type=Path, file_okay=False), default=None, help="Folder for tables and GIFs."
)
@WORKERS
def drive(
    egos: tuple[str, ...],
    map: str,  # noqa: A002 - the name of the option
    simulator: str,
    physics: str,
    speed: float | None,
    out: Path | None,
    jobs: int,
    executor: str,
    **options: Any,
) -> None:
    """Let egos drive the ordinary routes of a map, and report arrivals, crashes and speeds.

    \b
    chatscene drive --ego sac --ego idm
    chatscene drive --ego idm --ego planner --speed road --map region
    chatscene drive --ego my-policy.zip --out runs/my-policy
    """
    from chatscene.maps.limits import KMH
    from chatscene.report.tables import as_text
    from chatscene.runs.executor import Workers
    from chatscene.studies import driving

    done = driving.drive(
        egos,
        map_name=map,
        folder=out,
        simulation=SimulationSettings(simulator=simulator, physics=physics),
        speed=None if speed is None else KMH * speed,
        workers=Workers(jobs, executor),
        progress=progress(),
        **options,
    )
    say(as_text(done.table))
    say_failures(done.failures)


def say_evaluated(evaluated: Evaluated, as_json: bool) -> None:
    """Say what an evaluation came to; ends with status 1 if an ego failed."""
    from chatscene import runs
    from chatscene.report.evaluation import fared_in, fared_in_words

    fared = fared_in(runs.open_run(evaluated.folder, runs.EvaluationRecord))
    if as_json:
        told = {"folder": str(evaluated.folder), "page": str(evaluated.page), "egos": fared}
        say(json.dumps(told | {"seconds": evaluated.seconds, "failures": evaluated.failures}))
    else:
        say(fared_in_words(fared))
        say(f"the paper's tables, as text, Markdown, CSV and LaTeX: {evaluated.folder / 'tables'}")
        if evaluated.stepped:
            say(evaluated.stepped)
        say(f"egos side by side: {evaluated.page}")
    say_failures(evaluated.failures)


def say_compared(compared: Compared, as_json: bool) -> None:
    """Say how egos fared in imported programs; ends with status 1 if one was not driven, or an ego failed."""
    from chatscene.report.evaluation import fared_in_words

    if as_json:
        told = {"folder": str(compared.folder), "page": str(compared.page), "egos": compared.fared}
        left = {"failures": compared.failures, "lost": compared.lost, "partly": compared.partly}
        say(json.dumps(told | {"seconds": compared.seconds} | left))
    else:
        say(fared_in_words(compared.fared))
        for program, reason in compared.lost.items():
            say(f"not driven: {program}: {reason}", err=True)
        for program, reason in compared.partly.items():
            say(f"driven in part: {program}: without {reason}", err=True)
        say(f"each drive: {compared.folder / 'evaluation.json'}")
        say(f"egos side by side: {compared.page}")
    say_failures(compared.failures)
    if compared.lost:
        sys.exit(1)


def say_benchmarked(benchmarked: Benchmarked, as_json: bool) -> None:
    """Say what a benchmark came to, and which of its sentences were refused."""
    for text, reason in benchmarked.refused.items():
        say(f"refused: {text!r}: {reason}", err=True)
    say_evaluated(benchmarked.evaluated, as_json)
