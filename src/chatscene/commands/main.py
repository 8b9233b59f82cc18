"""The command line: one verb per command, the same words as the Python functions.

Exit status: 0 done, 1 error, 2 usage, 3 refused because a text or an edit was not understood, or cannot be built.
"""

from __future__ import annotations

import gc
import json
import os
import sys
import warnings
from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, Unpack

import click

from chatscene.commands.coverage import coverage
from chatscene.commands.editing import EDITS, chat, edit
from chatscene.commands.finetune import PHYSICS_THERE, finetune, say_finetuned
from chatscene.commands.library import (
    AGAIN,
    CHOOSING,
    DRIVEN_AGAIN,
    EXECUTOR_OPTION,
    GENERATOR_AGAIN,
    JSON,
    LIBRARY_AGAIN,
    MAP,
    MAP_WITH_SITE,
    PHYSICS_OPTION,
    READING,
    WORKERS,
    Again,
    Chosen,
    DrivenAgain,
    console,
    library,
    param_option,
    progress,
    say,
    usable_map,
)
from chatscene.commands.maps import map_group
from chatscene.commands.mcp import mcp
from chatscene.commands.proposal import COMMANDS, describe
from chatscene.commands.rate import rate
from chatscene.commands.refusal import REFUSED, complain, going_on, refusing
from chatscene.commands.reports import REPORT, explain_report, found_in
from chatscene.commands.reproduce import reproduce, say_reproduced
from chatscene.commands.sections import write_sections
from chatscene.commands.serve_carla import serve_carla
from chatscene.commands.situations import say_stated, schema, situation_file
from chatscene.commands.skill import skill
from chatscene.commands.sql import runs_below, sql
from chatscene.commands.story import story
from chatscene.commands.verify import verify
from chatscene.commands.view import open_report, view
from chatscene.commands.why import why
from chatscene.errors import ChatSceneError, EditRefused, MeansSomethingElse, NothingFits
from chatscene.memory import lack_of_memory, require_memory
from chatscene.settings import EGO, PAPER, SIMULATOR, SearchSettings, SimulationSettings
from chatscene.terms.conflict import Conflict

if TYPE_CHECKING:
    from chatscene.api import Run
    from chatscene.learn.train import Trained
    from chatscene.studies.benchmark import Benchmarked
    from chatscene.studies.evaluation import Evaluated
    from chatscene.terms.situation import Situation


def _sampler(default: str) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """The option that says where a search looks next."""
    return click.option(
        "--sampler",
        default=default,
        show_default=True,
        help="How to search: paper, random, grid, policy-gradient, cross-entropy, tpe, cma-es, "
        "quality-diversity, or package.module:factory.",
    )


def _speed(command: Callable[..., Any]) -> Callable[..., Any]:
    """The option that says how fast egos drive where nobody has said so."""
    return click.option(
        "--speed",
        type=click.FloatRange(1.0, 300.0),
        default=None,
        metavar="KMH",
        help="Speed of the ego [km/h] where the text says none.  [default: the speed of the road]",
    )(command)


ROAD = "road"


def _road_speed(context: click.Context, parameter: click.Parameter, value: str | None) -> float | None:
    """A speed [m/s], as it is typed; as fast as any road allows where it is that of the road."""
    from chatscene.maps.limits import KMH, MOTORWAY

    if value is None or value == ROAD:
        return None if value is None else MOTORWAY
    return KMH * click.FloatRange(1.0, 300.0)(value, parameter, context)


def _simulator(default: str) -> Callable[[Callable[..., Any]], Callable[..., Any]]:
    """The option that says what scenes run in."""
    return click.option(
        "--simulator",
        default=default,
        show_default=True,
        help="Simulator: native (C, same numbers as embedded, which takes over where needed), embedded, "
        "confined (in the sandbox), carla[:HOST[:PORT]] (a CARLA server), or package.module:factory.",
    )


def _warn(otherwise: Callable[..., None], message: Warning | str, kind: type[Warning], file: str, *more: Any) -> None:
    """Say a warning of ours as a line; where in our code it stands is nothing to a user."""
    if Path(file).is_relative_to(Path(__file__).parents[1]):
        say(f"warning: {message}", err=True)
    else:
        otherwise(message, kind, file, *more)


class _Errors(click.Group):
    """Shows our own errors as one message and turns them into the exit status."""

    def make_context(self, info_name: str | None, args: list[str], *more: Any, **extra: Any) -> click.Context:
        """Refuse what no path, no name and no text holds, before anything takes it for one."""
        if odd := next((one for one in args if "\0" in one), None):
            raise click.UsageError(f"{odd!r} holds a NUL character")
        return super().make_context(info_name, args, *more, **extra)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:  # noqa: ARG002 - as in click
        """List the commands by what one wants to do."""
        write_sections(self.commands, formatter)

    def invoke(self, ctx: click.Context) -> Any:
        try:
            with warnings.catch_warnings():
                warnings.showwarning = partial(_warn, warnings.showwarning)
                require_memory()
                return super().invoke(ctx)
        except (NothingFits, MeansSomethingElse, EditRefused) as error:
            complain(error)
            ctx.exit(REFUSED)
        except (click.ClickException, click.exceptions.Exit, click.Abort):
            raise
        except Exception as error:
            told = lack_of_memory(error) or error
            if not isinstance(told, ChatSceneError):
                raise
            complain(told)
            ctx.exit(1)
        except KeyboardInterrupt:
            say("\ninterrupted; what was finished is kept: continue with chatscene resume DIR", err=True)
            ctx.exit(130)


@click.group(cls=_Errors, context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 100})
@click.version_option(package_name="chatscene")
def main() -> None:
    """Turn a sentence about a dangerous traffic situation into crash scenes to test on.

    \b
    chatscene run "a cyclist crosses from the left in front of us" --out runs/cyclist
    chatscene explain "the car ahead brakes hard"
    chatscene edit runs/cyclist "make it a truck, from the right"
    chatscene replay runs/cyclist SCENE_ID
    """
    gc.set_threshold(YOUNG)


YOUNG = 10_000
"""New objects after which Python looks for garbage. At its own 700, a tenth of the time that a command takes to begin
goes into looking through what has just been loaded and stays."""


@main.command()
@click.argument("text", required=False)
@click.option(
    "--program",
    type=click.Path(path_type=Path, exists=True),
    default=None,
    help="Your own .scenic program, or a folder of them, instead of TEXT.",
)
@REPORT
@click.option("--trust", is_flag=True, help="Run the program with all of Python, outside the sandbox.")
@click.option("--as-written", is_flag=True, help="Let the program's own ego drive.")
@param_option("Set a parameter that the program uses and does not define, such as town=Town05.")
@EDITS
@MAP_WITH_SITE
@click.option("--ego", default=EGO, show_default=True, help="An ego by name, file or package.module:factory.")
@click.option("--scenes", default=50, show_default=True, help="Simulations per scenario and route.")
@click.option("--routes", default=1, show_default=True, help="Routes per scenario.")
@click.option("--seed", default=0, show_default=True, help="Seed of everything random.")
@click.option("--avoidable", is_flag=True, help="Keep only crashes that a careful driver would have avoided.")
@_speed
@_sampler(SearchSettings().sampler)
@_simulator(SIMULATOR)
@PHYSICS_OPTION
@click.option(
    "--out",
    type=click.Path(path_type=Path, file_okay=False),
    default=None,
    help="Run folder; default: a new one under runs/.",
)
@click.option(
    "--jobs",
    default=None,
    type=click.IntRange(min=1),
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
    trust: bool,
    as_written: bool,
    param: dict[str, object],
    edit: tuple[str, ...],
    map_name: str | None,
    ego: str,
    scenes: int,
    routes: int,
    seed: int,
    avoidable: bool,
    speed: float | None,
    sampler: str,
    simulator: str,
    physics: str,
    out: Path | None,
    jobs: int | None,
    executor: str,
    as_json: bool,
    **reading: Unpack[Chosen],
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
    from chatscene import api, runs
    from chatscene.simulate.simulator import has_one_world

    if sum(one is not None for one in (text, report, program)) != 1:
        raise click.UsageError("say what to run: a TEXT, --report FILE or --program FILE")
    asked: list[tuple[str, str | Conflict | Situation, Path | None]] = [(text or "", text or "", None)]
    stated = situation_file(text) if text is not None else None
    if stated is not None and text is not None:
        asked = [(stated.about or Path(text).stem, stated, None)]
    if report is not None:
        asked = [(f"conflict-{one.number}", one, None) for one in found_in(report, reading, as_json)]
    elif program is not None:
        asked = [(name, "", file) for name, file in _programs(program).items()]
    several = len(asked) > 1 or (program is not None and program.is_dir())
    gone: list[int] = []
    for name, said, own in asked:
        folder = (out / name if several else out) if out else None
        with going_on(
            name if stated is not None else str(said), reading["embedder"], as_json, gone if several else None
        ):
            done = api.run(
                said,
                folder or runs.free_folder(Path("runs"), name if stated is not None else str(said) or name),
                program=own,
                trust=trust,
                as_written=as_written,
                param=param or None,
                edit=edit or None,
                map=map_name,
                ego=ego,
                scenes=scenes,
                routes=routes,
                seed=seed,
                avoidable=avoidable,
                speed=speed,
                sampler=sampler,
                simulator=simulator,
                physics=physics,
                jobs=jobs or (1 if has_one_world(simulator) else _jobs(scenes, routes)),
                executor=executor,
                progress=progress(),
                **reading,
            )
            _say_done(done, as_json)
    if gone:
        sys.exit(min(gone))


@main.command()
@click.argument("folder", metavar="DIR", type=click.Path(path_type=Path))
@click.option("--jobs", default=None, type=click.IntRange(min=1), help="Number of worker processes.  [default: 1]")
@EXECUTOR_OPTION
@AGAIN
@JSON
def resume(
    folder: Path,
    jobs: int | None,
    executor: str,
    as_json: bool,
    **again: Unpack[Again],
) -> None:
    """Continue the work in DIR after it was killed or failed; the result is that of an uninterrupted one.

    DIR is what run, evaluate, benchmark, reproduce, finetune or train left.

    \b
    chatscene resume runs/cyclist
    chatscene resume runs/benchmark --jobs 2
    chatscene resume runs/my-stack --ego mypackage.stack:make_ego
    """
    from chatscene import api, runs

    record = runs.read_record(runs.Workspace(folder), runs.Record)
    text = record.text if isinstance(record, runs.RunRecord) else ""
    with refusing(text, record.code_named().get("embedder", ""), as_json):
        done = api.resume(
            folder,
            jobs=jobs or 1,
            executor=executor,
            progress=progress(),
            **again,
        )
    say_any: dict[runs.Kind, Callable[[Any, bool], None]] = {
        runs.Kind.RUN: _say_done,
        runs.Kind.EVALUATION: _say_evaluated,
        runs.Kind.BENCHMARK: _say_benchmarked,
        runs.Kind.REPRODUCTION: say_reproduced,
        runs.Kind.FINETUNING: say_finetuned,
        runs.Kind.TRAINING: _say_trained,
    }
    say_any[record.kind](done, as_json)


@main.command()
@click.argument("scenes", metavar="DIR...", nargs=-1, required=True, type=click.Path(path_type=Path))
@click.option(
    "--ego",
    "egos",
    multiple=True,
    help="By name, file or package.module:factory; repeat.  [default: planner, idm, sac]",
)
@_speed
@click.option("--all", "every_scene", is_flag=True, help="Every scene that ran, not only the kept ones.")
@click.option("--simulator", default="", help="Simulator.  [default: that of the runs]")
@PHYSICS_THERE
@click.option("--out", type=click.Path(path_type=Path, file_okay=False), default=None, help="Default: under runs/.")
@WORKERS
@GENERATOR_AGAIN
@LIBRARY_AGAIN
@JSON
def evaluate(
    scenes: tuple[Path, ...],
    egos: tuple[str, ...],
    every_scene: bool,
    simulator: str,
    physics: str | None,
    speed: float | None,
    out: Path | None,
    jobs: int,
    executor: str,
    generator: tuple[str, ...],
    library: tuple[str, ...],
    as_json: bool,
) -> None:
    """Measure egos on the kept scenes of the runs in DIR..., and print a row per ego; the paper's tables go to files.

    \b
    chatscene evaluate runs/cyclist --ego sac --ego idm
    chatscene evaluate runs/* --ego my-policy.onnx --ego mypackage.stack:make_ego --out runs/my-stack
    """
    from chatscene import api, runs

    evaluated = api.evaluate(
        scenes,
        out or runs.free_folder(Path("runs"), "evaluation"),
        ego=egos,
        all=every_scene,
        simulator=simulator or None,
        physics=physics,
        speed=speed,
        jobs=jobs,
        executor=executor,
        generator=generator,
        library=library,
        progress=progress(),
    )
    _say_evaluated(evaluated, as_json)


@main.command()
@click.option("--generator", default="chatscene", show_default=True, help="Generator of the scenes.")
@click.option(
    "--budget",
    default="small",
    show_default=True,
    help="'paper': 20,000 simulations; 'small': minutes; 'reference': each generator's own number of tries.",
)
@click.option("--ego", "egos", multiple=True, help="Ego to measure. Repeatable.  [default: sac, ppo, td3]")
@click.option("--surrogate", default="sac", show_default=True, help="The ego that scenes are searched against.")
@MAP
@click.option("--avoidable", is_flag=True, help="Keep only crashes that a careful driver would have avoided.")
@_sampler(PAPER.sampler)
@_simulator(SIMULATOR)
@PHYSICS_OPTION
@click.option("--seed", default=0, show_default=True)
@click.option(
    "--out", type=click.Path(path_type=Path, file_okay=False), required=True, help="A new folder, or one to continue."
)
@WORKERS
@JSON
def benchmark(
    generator: str,
    budget: str,
    egos: tuple[str, ...],
    surrogate: str,
    map_name: str,
    avoidable: bool,
    sampler: str,
    simulator: str,
    physics: str,
    seed: int,
    out: Path,
    jobs: int,
    executor: str,
    as_json: bool,
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
        generator=generator,
        budget=budget,
        egos=egos or evaluation.EGOS,
        surrogate=surrogate,
        map_name=map_name,
        avoidable_only=avoidable,
        sampler=sampler,
        simulator=simulator,
        physics=physics,
        seed=seed,
        workers=Workers(jobs, executor),
        progress=progress(),
    )
    _say_benchmarked(outcome, as_json)


@main.command()
@click.option("--ego", "egos", multiple=True, required=True, help="By name, file or package.module:factory; repeat.")
@MAP
@_simulator(SIMULATOR)
@PHYSICS_OPTION
@click.option("--scenes", default=5, show_default=True, help="Draws of traffic per course.")
@click.option("--seed", default=20_000, show_default=True, help="Seed of the traffic.")
@click.option(
    "--speed",
    default=None,
    callback=_road_speed,
    metavar="KMH|road",
    help="Speed of the egos, and of everybody in proportion, within the limits of the roads: km/h, or 'road' for "
    "these alone.  [default: egos are told nothing]",
)
@click.option("--out", type=click.Path(path_type=Path, file_okay=False), default=None, help="For tables and GIFs.")
@WORKERS
def drive(
    egos: tuple[str, ...],
    map_name: str,
    simulator: str,
    physics: str,
    scenes: int,
    seed: int,
    speed: float | None,
    out: Path | None,
    jobs: int,
    executor: str,
) -> None:
    """Let egos drive the ordinary routes of a map: do they get there, do they crash, how fast are they?

    \b
    chatscene drive --ego sac --ego idm
    chatscene drive --ego idm --ego planner --speed road --map region
    chatscene drive --ego my-policy.zip --out runs/my-policy
    """
    from chatscene.report.tables import as_text
    from chatscene.runs.executor import Workers
    from chatscene.studies import driving

    table = driving.drive(
        egos,
        folder=out,
        map_name=map_name,
        simulation=SimulationSettings(simulator=simulator, physics=physics),
        scenes=scenes,
        seed=seed,
        speed=speed,
        workers=Workers(jobs, executor),
        progress=progress(),
    )
    say(as_text(table))


@main.command()
@click.option("--algorithm", default="sac", show_default=True, help="sac, ppo or td3.")
@click.option(
    "--observation",
    default=None,
    help="What the ego sees: safebench, actors, road or traffic.  [default: safebench; with --speed, traffic]",
)
@click.option("--reward", default="progress", show_default=True, help="progress or safebench.")
@click.option(
    "--pedals", default=None, help="safebench, or full-brake.  [default: safebench; with --speed, full-brake]"
)
@click.option(
    "--speed",
    default=None,
    callback=_road_speed,
    metavar="KMH|road",
    help="Speed of the ego, and of everybody in proportion, within the limits of the roads: km/h, or 'road' "
    "for these alone.  [default: SafeBench's speed]",
)
@click.option("--steps", default=60_000, show_default=True, help="Steps of 0.1 s, rounded up to whole rounds.")
@click.option("--round", "round_", default=5_000, show_default=True, help="Steps between two evaluations.")
@click.option("--seed", default=0, show_default=True)
@MAP
@_simulator(SIMULATOR)
@PHYSICS_OPTION
@click.option(
    "--out", type=click.Path(path_type=Path, file_okay=False), required=True, help="A new folder, or one to continue."
)
def train(
    algorithm: str,
    observation: str | None,
    reward: str,
    pedals: str | None,
    speed: float | None,
    steps: int,
    round_: int,
    seed: int,
    map_name: str,
    simulator: str,
    physics: str,
    out: Path,
) -> None:
    """Train an ego on the ordinary drives of a map. Needs the extra 'train'.

    \b
    chatscene train --algorithm sac --out egos/sac
    chatscene train --speed road --out egos/at-speed
    chatscene evaluate runs/cyclist --ego egos/sac/policy.npz
    """
    from chatscene import api

    if round_ > 0 and steps % round_:
        say(f"{-(-steps // round_) * round_} steps instead of {steps}: whole rounds of {round_} (--round)", err=True)
    trained = api.train(
        out,
        algorithm=algorithm,
        observation=observation,
        reward=reward,
        pedals=pedals,
        speed=None if speed is None else round(3.6 * speed, 6),
        steps=steps,
        round=round_,
        seed=seed,
        map=map_name,
        simulator=simulator,
        physics=physics,
        progress=progress(),
    )
    _say_trained(trained, as_json=False)


@main.command()
@click.argument("folder", metavar="DIR", type=click.Path(path_type=Path))
@click.argument("scene_id", required=False)
@DRIVEN_AGAIN
@click.option("--watch", is_flag=True, help="Keep a CARLA server's spectator above the ego.")
@click.option("--record", is_flag=True, help="Let a CARLA server's recorder write a file to DIR/recordings.")
@JSON
def replay(
    folder: Path, scene_id: str | None, watch: bool, record: bool, as_json: bool, **again: Unpack[DrivenAgain]
) -> None:
    """Simulate one scene of a run again, from its stored values, and say whether the tracks are identical.

    Without SCENE_ID it is the first that the report shows. In a CARLA server, which does not repeat itself to the bit,
    they have to be the same within half a metre.

    \b
    chatscene replay runs/cyclist cyclist-1f2e/route-00/scene-017
    chatscene replay runs/brakes brakes-8c1f/route-00/scene-004 --simulator carla --watch --record
    """
    from chatscene import api

    outcome = api.replay(folder, scene_id, watch=watch, record=record, **again)
    if as_json:
        say(json.dumps(outcome.as_dict()))
    else:
        say(outcome.in_words())
    if not outcome.identical:
        sys.exit(1)


@main.command()
@click.argument("folder", metavar="RUN", type=click.Path(path_type=Path))
@click.argument("scenes", metavar="[SCENE]...", nargs=-1)
@click.option("--to", required=True, help="The format, as below, or package.module:factory.")
@click.option(
    "--out",
    type=click.Path(path_type=Path),
    required=True,
    help="A new folder, or an empty one.",
)
@JSON
def export(folder: Path, scenes: tuple[str, ...], to: str, out: Path, as_json: bool) -> None:
    """Write each SCENE of RUN as a file that other tools read; without SCENE, the scenes that the run keeps.

    openscenario: OpenSCENARIO XML 1.2, everybody on a timed trajectory as driven, and the OpenDRIVE map beside it.
    openscenario-logical: what the plans say, in events, with parameters and their ranges; or a refusal that says why.
    opendrive: the map, and what its lights showed. commonroad: a planning problem among what was driven.
    osi: a trace of ground truth of ASAM OSI, in MCAP; needs the extra 'osi'. csv: the tracks.
    scenic: the program with the scene's values in it, and the map.

    \b
    chatscene export runs/cyclist --to openscenario --out exported/cyclist
    chatscene export runs/cyclist cyclist-1f2e/route-00/scene-017 --to csv --out exported/tracks
    """
    from chatscene import api

    done = api.export(folder, scenes, to=to, out=out)
    say(json.dumps({"folder": str(done.folder), "files": done.files}) if as_json else str(done))


@main.command("import")
@click.argument("file", metavar="FILE.xosc", type=click.Path(path_type=Path))
@click.option("--out", type=click.Path(path_type=Path), help="The .scenic file; default: beside FILE, with its name.")
@click.option(
    "--map",
    "map_name",
    metavar="MAP",
    callback=usable_map,
    help="A packaged map or an .xodr file; default: the one FILE names.",
)
@click.option("--ego", metavar="NAME", help="The ego in FILE; default: who is called ego, else the first vehicle.")
@click.option("--variant", type=click.IntRange(min=1), metavar="N", help="Only set N of a file of parameter values.")
@param_option("Set a parameter that FILE declares.")
@JSON
def import_scenario(
    file: Path,
    out: Path | None,
    map_name: str | None,
    ego: str | None,
    variant: int | None,
    param: dict[str, object],
    as_json: bool,
) -> None:
    """Write the OpenSCENARIO XML in FILE as a Scenic program, which `run --program` takes; nothing of it is run.

    FILE is a scenario, or sets of parameter values for one: then there is a program for each set. Catalogs and the map
    are those that FILE names by paths from its own folder. What cannot be said here is refused by its element and line.

    \b
    chatscene import cut-in.xosc
    chatscene import cut-in.xosc --map Town04.xodr --ego Car1 --out mine.scenic
    chatscene import variations.xosc --variant 3
    chatscene import theirs --out mine

    Of a folder each .xosc file in it is written below --out, and a table says what each became, or why it did not.
    """
    from chatscene import api
    from chatscene.imports.import_folder import import_folder

    if file.is_dir():
        if out is None or variant is not None or param:
            raise click.UsageError("of a folder, give --out, a new folder, and neither --variant nor --param")
        folder = import_folder(file, out, map_name=map_name, ego=ego)
        say(json.dumps([one.as_dict() for one in folder.files]) if as_json else str(folder))
        return
    done = api.import_scenario(file, out=out, map=map_name, ego=ego, variant=variant, param=param)
    told = {
        "program": str(done.program),
        "programs": [str(one) for one in done.programs],
        "map": str(done.map_path),
        "maps": [str(one) for one in done.maps],
        "notes": done.notes,
        "command": done.command,
    }
    say(json.dumps(told) if as_json else str(done))


@main.command()
@click.argument("folders", metavar="DIR...", nargs=-1, required=True, type=click.Path(path_type=Path))
@JSON
def check(folders: tuple[Path, ...], as_json: bool) -> None:
    """Say which files of the folders DIR... are damaged or missing, and which were added since.

    DIR is what run, evaluate, benchmark, reproduce, finetune or train left; the folders in it are checked as well.

    Every file of a finished folder is compared with the digest that run.json keeps of it, and run.json with its own.
    Exit status 0: all that was written is there and unchanged; 1: it is not, or nobody can tell.

    \b
    chatscene check runs/cyclist
    chatscene check runs/* --json
    """
    from chatscene import runs

    found = [runs.check(folder) for folder in folders]
    if as_json:
        say(json.dumps([condition.as_dict() for condition in found], indent=1))
    else:
        for condition in found:
            say(condition.in_words())
    if not all(condition.whole for condition in found):
        sys.exit(1)


@main.command()
@click.argument("text", required=False)
@REPORT
@click.option("--program", "show_program", is_flag=True, help="Print the Scenic program as well.")
@EDITS
@READING
@CHOOSING
@JSON
def explain(
    text: str | None,
    report: Path | None,
    show_program: bool,
    edit: tuple[str, ...],
    as_json: bool,
    **reading: Unpack[Chosen],
) -> None:
    """Show how TEXT is understood: the situation in words, the words of each fact, the facts. Runs nothing.

    What was not read, assumed or left out stands first. --program prints the program that is built.

    TEXT is a sentence, or the .yaml or .json file of a situation.

    \b
    chatscene explain "a motorbike cuts us off from the right"
    chatscene explain "a dragon lands on the bonnet"        # refused, exit status 3
    chatscene explain --report claim.txt
    """
    from chatscene import api
    from chatscene.report.stated import Stated

    if (text is None) == (report is None):
        raise click.UsageError("say what to explain: a TEXT or --report FILE")
    if text is None or report is not None:
        explain_report(report or Path(), reading, edit=edit, program=show_program, as_json=as_json)
        return
    stated = situation_file(text)
    with refusing(text if stated is None else "", reading["embedder"], as_json):
        if stated is not None:
            understood = api.explain(stated, edit=edit, set=reading["set"])
        else:
            understood = api.explain(text, edit=edit or None, **reading)
    if as_json:
        say(json.dumps(understood.as_dict(), indent=1))
    elif isinstance(understood, Stated):
        say_stated(understood, program=show_program)
    else:
        from chatscene.report.terminal import print_understanding

        print_understanding(console(), understood, show_program=show_program)


for command in COMMANDS:
    library.add_command(command)
main.add_command(library)
main.add_command(map_group)
main.add_command(describe)
main.add_command(edit)
main.add_command(chat)
main.add_command(finetune)
main.add_command(coverage)
main.add_command(mcp)
main.add_command(rate)
main.add_command(reproduce)
main.add_command(schema)
main.add_command(serve_carla)
main.add_command(skill)
main.add_command(sql)
main.add_command(story)
main.add_command(runs_below)
main.add_command(verify)
main.add_command(view)
main.add_command(open_report)
main.add_command(why)


@main.command()
@click.option("--simulator", default="", help="Check this simulator against the default one, such as carla:HOST:PORT.")
@MAP
@JSON
def doctor(simulator: str, map_name: str, as_json: bool) -> None:
    """Check this installation: versions, encoder, library, map, one simulated scene. Or check a simulator.

    A simulator is asked what it is, drives one scene twice, and drives ten that are compared with the default's.

    \b
    chatscene doctor
    chatscene doctor --simulator carla --map Town04.xodr
    """
    from chatscene.commands.doctor import Check, examine

    if simulator:
        from chatscene.commands.simulator_check import examine_simulator

        trying = examine_simulator(simulator, map_name)
    else:
        trying = iter(examine())
    checks: list[Check] = []
    for check in trying:
        checks.append(check)
        if not as_json:
            say(f"{'ok  ' if check.ok else 'FAIL'}  {check.what:<28} {check.found}")
    if as_json:
        say(json.dumps([{"what": c.what, "ok": c.ok, "found": c.found} for c in checks], indent=1))
    if not all(check.ok for check in checks):
        sys.exit(1)


def _programs(program: Path) -> dict[str, Path]:
    """The files of a program or of a folder of them, by a name for the run's folder."""
    from chatscene.search.generators.foreign import foreign_files

    return {
        "-".join(file.relative_to(program).with_suffix("").parts) if program.is_dir() else file.stem: file
        for file in foreign_files(program)
    }


def _jobs(scenes: int, routes: int) -> int:
    """As many processes as pay: starting one costs about as much as 250 scenes."""
    cores = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    return max(1, min(cores, routes, scenes * routes // 250))


def _say_evaluated(evaluated: Evaluated, as_json: bool) -> None:
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
    for reason in evaluated.failures.values():
        say(f"EgoError: {reason}; the other egos' results stand", err=True)
    if evaluated.failures:
        sys.exit(1)


def _say_benchmarked(benchmarked: Benchmarked, as_json: bool) -> None:
    for text, reason in benchmarked.refused.items():
        say(f"refused: {text!r}: {reason}", err=True)
    _say_evaluated(benchmarked.evaluated, as_json)


_SELDOM = 0.1  # of its drives: who crashes or leaves the road more often has not learned to drive


def _say_trained(trained: Trained, as_json: bool) -> None:
    if as_json:
        say(json.dumps({"folder": str(trained.folder), "best": trained.best}))
        return
    say("        of the route   of the drives           of the time  mean speed")
    say(" steps        driven  collided  off the road  off the road       [m/s]")
    for row in trained.curve:
        astray = f"{row['off_road_rate']:.1%}" if "off_road_rate" in row else "?"  # a round of an earlier version
        say(
            f"{row['steps']:6.0f}  {row['completion']:12.1%}  {row['collision_rate']:8.1%}  {astray:>12}"
            f"  {row['off_road']:12.1%}  {row['mean_speed']:10.2f}" + ("  kept" if row == trained.best else "")
        )
    best = trained.best
    policy = trained.folder / "policy.npz"
    say(f"the best of them is in {policy}; drive with it: --ego {policy}")
    faults = {"collides": best["collision_rate"], "leaves the road": best.get("off_road_rate", best["off_road"])}
    if told := [f"{does} in {share:.0%} of its drives" for does, share in faults.items() if share > _SELDOM]:
        say(f"it {' and '.join(told)}: it has not learned to drive yet; go on with more --steps")


def _say_done(run: Run, as_json: bool) -> None:
    if as_json:
        summary = run.summary
        told = {"folder": str(run.folder), "seconds": summary.seconds, "told_first": run.told_first}
        say(json.dumps({**told, **summary.counts}))
    else:
        say(str(run))
