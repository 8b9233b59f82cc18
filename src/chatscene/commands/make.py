"""The command line, continued: a text, a report, a situation or a program is explained, run, and gone on with."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

import chatscene
from chatscene.api.make import named_in
from chatscene.commands.learn import say_finetuned, say_trained
from chatscene.commands.measure import say_benchmarked, say_compared, say_evaluated
from chatscene.commands.options import (
    AGAIN,
    AS_WRITTEN,
    AVOIDABLE,
    CHOOSING,
    EDITS,
    EGO_OPTION,
    EXECUTOR_OPTION,
    JSON,
    MANY,
    MAP_WITH_SITE,
    OCCLUSION,
    PHYSICS_OPTION,
    READING,
    REPORT,
    SEED,
    SIMULATOR_OPTION,
    SPEED,
    TRUST,
    OneText,
    param_option,
    sampler_option,
)
from chatscene.commands.output import progress, say
from chatscene.commands.refusal import REFUSED, going_on, refuse, refusing
from chatscene.commands.reproduce import say_reproduced
from chatscene.commands.situations import say_understood
from chatscene.errors import MeansSomethingElse, NothingFits
from chatscene.report.refused import refusal
from chatscene.settings import SearchSettings
from chatscene.terms.conflict import Conflict

if TYPE_CHECKING:
    from chatscene.api.results import Run
    from chatscene.terms.situation import Situation


@click.command(cls=OneText)
@click.argument("text", required=False)
@click.option(
    "--program",
    type=click.Path(path_type=Path, exists=True),
    default=None,
    help="Your own .scenic program, or a folder of them, instead of TEXT.",
)
@REPORT
@TRUST
@AS_WRITTEN
@param_option("Set a parameter that the program uses but does not define, such as town=Town05.")
@EDITS
@MAP_WITH_SITE
@EGO_OPTION
@click.option("--scenes", default=50, show_default=True, type=MANY, help="Simulations per scenario and route.")
@click.option("--routes", default=1, show_default=True, type=MANY, help="Routes per scenario.")
@SEED
@AVOIDABLE
@SPEED
@sampler_option(SearchSettings().sampler)
@SIMULATOR_OPTION
@PHYSICS_OPTION
@OCCLUSION
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    default=None,
    help="Run folder; default: a new one under runs/.",
)
@click.option(
    "--jobs",
    default=None,
    type=MANY,
    help="Number of worker processes. Default: chosen automatically.",
)
@EXECUTOR_OPTION
@READING
@CHOOSING
@JSON
def run(
    text: str | None,
    program: Path | None,
    report: Path | None,
    map: str | None,  # noqa: A002 - the name of the option
    out: Path | None,
    jobs: int | None,
    as_json: bool,
    **options: Any,
) -> None:
    """Understand TEXT, search for crash scenes, keep the ones worth testing on, and write a report.

    TEXT is a sentence, or the .yaml or .json file of a situation.

    \b
    chatscene run "a child runs out from behind a parked van on the right"
    chatscene run "an oncoming car turns left across our path" --routes 10 --out runs/left
    chatscene run "the car ahead brakes hard" --map Town04.xodr --ego mypackage.stack:make_ego
    chatscene run "a van cuts in" --set side=left --set ego.speed="40 km/h"
    chatscene run "the car ahead brakes hard" --speed 90
    chatscene run --report claim.txt --out runs/claim
    chatscene run situation.yaml --set others.A.kind=truck
    chatscene run --program mine.scenic --routes 4
    chatscene run --program theirs.scenic --map Town05.xodr --as-written
    """
    from chatscene import runs
    from chatscene.simulate.simulator import has_one_world

    if sum(one is not None for one in (text, report, program)) != 1:
        raise click.UsageError("nothing to run: give TEXT, --report FILE or --program FILE")
    asked: list[tuple[str, str | Conflict | Situation, Path | None]] = [(text or "", text or "", None)]
    stated = named_in(text) if text is not None else None
    if stated is not None and text is not None:
        asked = [(stated.about or Path(text).stem, stated, None)]
    if report is not None:
        asked = [(f"conflict-{one.number}", one, None) for one in found_in(report, options, as_json)]
    elif program is not None:
        asked = [(name, "", file) for name, file in _programs(program).items()]
    several = len(asked) > 1 or (program is not None and program.is_dir())
    at_a_time = jobs or (1 if has_one_world(options["simulator"]) else _jobs(options["scenes"], options["routes"]))
    gone: list[int] = []
    for name, said, own in asked:
        title = name if stated is not None else str(said)
        folder = (out / name if several else out) if out else None
        with going_on(title, options["embedder"], as_json, gone if several else None):
            done = chatscene.run(
                said,
                folder or runs.free_folder(Path("runs"), title or name),
                program=own,
                map=map,
                jobs=at_a_time,
                progress=progress(),
                **options,
            )
            say_done(done, as_json)
    if gone:
        sys.exit(min(gone))


@click.command(cls=OneText)
@click.argument("text", required=False)
@REPORT
@click.option("--program", "show_program", is_flag=True, help="Print the Scenic program as well.")
@EDITS
@MAP_WITH_SITE
@READING
@CHOOSING
@JSON
def explain(text: str | None, report: Path | None, show_program: bool, as_json: bool, **options: Any) -> None:
    """Show how TEXT is understood: the situation in words, your words with their facts, and the facts. Runs nothing.

    Words that were not read, and what was assumed or left out, come first. --program prints the program as well.

    TEXT is a sentence, or the .yaml or .json file of a situation.

    \b
    chatscene explain "a motorbike cuts us off from the right"
    chatscene explain "a dragon lands on the bonnet"        # refused, exit status 3
    chatscene explain "a car cuts in from the left" --map left-hand.xodr
    chatscene explain --report claim.txt
    """
    if (text is None) == (report is None):
        raise click.UsageError("nothing to explain: give TEXT or --report FILE")
    if text is None or report is not None:
        explain_report(report or Path(), options, program=show_program, as_json=as_json)
        return
    stated = named_in(text)
    with refusing(text if stated is None else "", options["embedder"], as_json):
        understood = chatscene.explain(text if stated is None else stated, **options)
    if as_json:
        say(json.dumps(understood.as_dict(), indent=1))
    else:
        say_understood(understood, program=show_program)


@click.command()
@click.argument("folder", metavar="DIR", type=click.Path(path_type=Path))
@click.option("--jobs", default=1, type=MANY, help="Number of worker processes.  [default: 1]")
@EXECUTOR_OPTION
@AGAIN
@JSON
def resume(folder: Path, as_json: bool, **options: Any) -> None:
    """Continue the work in DIR after it was killed or failed. The result is the same as without the interruption.

    DIR is a folder that run, evaluate, benchmark, reproduce, finetune or train wrote.

    \b
    chatscene resume runs/cyclist
    chatscene resume runs/benchmark --jobs 2
    chatscene resume runs/my-stack --ego mypackage.stack:make_ego
    """
    from chatscene import runs

    record = runs.read_record(runs.Workspace(folder), runs.Record)
    text = record.text if isinstance(record, runs.RunRecord) else ""
    with refusing(text, record.code_named().get("embedder", ""), as_json):
        done = chatscene.resume(folder, progress=progress(), **options)
    say_any: dict[runs.Kind, Callable[[Any, bool], None]] = {
        runs.Kind.RUN: say_done,
        runs.Kind.EVALUATION: say_evaluated,
        runs.Kind.COMPARISON: say_compared,
        runs.Kind.BENCHMARK: say_benchmarked,
        runs.Kind.REPRODUCTION: say_reproduced,
        runs.Kind.FINETUNING: say_finetuned,
        runs.Kind.TRAINING: say_trained,
    }
    say_any[record.kind](done, as_json)


def _programs(program: Path) -> dict[str, Path]:
    """The files of a program or of a folder of them, by a name for the run's folder."""
    from chatscene.search.generators.foreign import foreign_files

    named: dict[str, Path] = {}
    for file in foreign_files(program):
        parts = file.relative_to(program).with_suffix("").parts if program.is_dir() else (file.stem,)
        name, number = "-".join(parts), 1
        while name in named:  # `a-b.scenic` and `a/b.scenic`
            number += 1
            name = f"{'-'.join(parts)}-{number}"
        named[name] = file
    return named


def _jobs(scenes: int, routes: int) -> int:
    """As many processes as pay: starting one costs about as much as 250 scenes."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return max(1, min(cores, routes, scenes * routes // 250))


def say_done(run: Run, as_json: bool) -> None:
    """Say what a run came to."""
    if as_json:
        summary = run.summary
        told = {"folder": str(run.folder), "seconds": summary.seconds, "told_first": run.told_first}
        say(json.dumps({**told, **summary.counts}))
    else:
        say(str(run))


# The command line, continued: reports, which are read for the conflicts that they tell


def found_in(report: Path, reading: Mapping[str, Any], as_json: bool) -> tuple[Conflict, ...]:
    """The conflicts of a report, and a word on what it is read as; ends with status 3 if there is none."""
    with refusing("", reading["embedder"], as_json):
        found = chatscene.conflicts(report, progress=progress())
    if len(found) > 1 and (reading["reading"] or reading["set"]):
        raise click.UsageError(f"{report} has {len(found)} conflicts; --reading and --set need one: give its text")
    if not as_json:
        for line in in_words(found):
            say(line, err=True)
    return found


def in_words(found: tuple[Conflict, ...]) -> list[str]:
    """What a report is read as, in lines."""
    first = found[0]
    lines = [f"{first.report} has {'a conflict' if len(found) == 1 else f'{len(found)} conflicts'}:"]
    lines += [f"  {one.number}  {one.text}" for one in found]
    return [*lines, *(f"  left out: {passage}" for passage in first.left_out)]


def explain_report(report: Path, reading: Mapping[str, Any], *, program: bool, as_json: bool) -> None:
    """Show how each conflict of a report is understood; ends with status 3 if one is refused."""
    found = found_in(report, reading, as_json)
    told: list[dict[str, Any]] = []
    refused = False
    for one in found:
        try:
            understood = chatscene.explain(one, **reading)
        except (NothingFits, MeansSomethingElse) as error:
            refused = True
            if as_json:
                told.append(refusal(error, one.text, reading["embedder"]))
            else:
                say(f"\n{one.number}  {one.text}")
                refuse(error, one.text, reading["embedder"], as_json)
            continue
        told.append(understood.as_dict())
        if not as_json:
            say(f"\n{one.number}  {one.text}\n")
            say_understood(understood, program=program)
    if as_json:
        say(json.dumps({"report": found[0].report, "left_out": found[0].left_out, "conflicts": told}, indent=1))
    if refused:
        sys.exit(REFUSED)
