"""How near the logical OpenSCENARIO of packaged behaviors comes to our drives: in esmini, and read back here.

    python benchmarks/retold.py --esmini libesminiLib.so
    python benchmarks/retold.py --esmini libesminiLib.so --runs RUNS

Every packaged behavior is put into the first program that lint would try it in, with a scene drawn from its ranges,
and driven by `idm`; or the scenes that runs keep are taken. They are exported as `openscenario-logical`, or refused.
What is exported is

- played by esmini, where the ego follows its own trajectory as driven and all others do what their events say;
- imported again, written as a program, and driven with the same values, seed and ego.

Distances are those of the actors' centres from our tracks at the same time, until the ego meets anybody.
"""

from __future__ import annotations

import ctypes
import math
import multiprocessing
from collections import Counter
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any
from xml.etree import ElementTree as Xml

import click
import numpy as np
from esmini_plays import State, loaded

from chatscene.ego.policy import load_ego
from chatscene.errors import ChatSceneError, RunError
from chatscene.exports.export import kept_scenes
from chatscene.exports.exporter import KeptScene, MapFile
from chatscene.exports.openscenario import OpenScenario
from chatscene.exports.openscenario_logical import OpenScenarioLogical
from chatscene.exports.plain_plan import SAYABLE
from chatscene.grow.lint import trials
from chatscene.grow.twins import scenario_of
from chatscene.imports.import_file import written
from chatscene.imports.openscenario import read_openscenario
from chatscene.library.load import load_library
from chatscene.maps.network import resolve_map
from chatscene.program.assemble import assemble
from chatscene.program.sample import draw
from chatscene.search.generators.foreign import foreign_program
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import Simulator, load_simulator, simulate
from chatscene.terms.episode import Episode, Track
from chatscene.terms.plan import Foreign
from chatscene.terms.plan_text import plan_of
from chatscene.terms.scenario import Component
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

STEP = 0.1  # [s]


@click.command()
@click.option("--esmini", type=click.Path(path_type=Path, exists=True), help="Its library.")
@click.option("--seed", default=0, show_default=True)
@click.option("--each", default=1, show_default=True, help="Take every so many-th behavior.")
@click.option("--runs", type=click.Path(path_type=Path, exists=True), help="A folder of runs; their kept scenes.")
@click.option("--import/--no-import", "back", default=True, show_default=True, help="Whether to import and drive.")
def main(esmini: Path | None, seed: int, each: int, runs: Path | None, *, back: bool) -> None:
    """See the head of this file."""
    simulator = load_simulator(resolve_map("town"), SimulationSettings(simulator="native"))
    count: Counter[str] = Counter()
    away: dict[str, list[float]] = {"esmini": [], "import": []}
    for kept, scene in _of_runs(runs) if runs else _of_library(simulator, seed, each, count):
        name = kept.episode.scene_id
        try:
            files = dict(OpenScenarioLogical().files(kept))
        except RunError as error:
            count["refused"] += 1
            click.echo(f"{name} refused: {str(error).split(': ', 1)[1].rpartition(';')[0]}")
            continue
        count["exported"] += 1
        told = [name]
        with TemporaryDirectory() as written:
            folder = Path(written)
            for file, content in files.items():
                (folder / file).write_bytes(content)
            again = _read_back(folder / f"{kept.stem}.xosc", scene, simulator) if back else ""
            if isinstance(again, Episode):
                told.append(_told("import", kept.episode, again.tracks, away))
            elif again:
                told.append(f"import {again}")
                count["not driven again"] += 1
            if esmini:
                tracks = _played(esmini, folder, kept, files)
                told.append(_told("esmini", kept.episode, tracks, away) if tracks else "esmini refuses it")
        click.echo(", ".join(told))
    click.echo(", ".join(f"{what} {number}" for what, number in count.items()))
    for reader, found in away.items():
        if found:
            shares = ", ".join(f"{np.mean(np.array(found) < near):.2f} within {near} m" for near in (0.1, 0.5, 1, 2, 5))
            most = f"largest distance of a scene: median {np.median(found):.2f} m"
            click.echo(f"{reader}: {len(found)} scenes; {most}; {shares}")


def _of_runs(folder: Path) -> Iterator[tuple[KeptScene, Scene]]:
    for run in sorted(path.parent for path in folder.glob("*/run.json")):
        try:
            scenes = list(kept_scenes(run))
        except RunError:
            continue
        for kept in scenes:
            yield (
                kept,
                Scene(id=kept.episode.scene_id, scenario_id="", route=kept.route, block=0, seed=0, values=kept.values),
            )


def _of_library(simulator: Simulator, seed: int, each: int, count: Counter[str]) -> Iterator[tuple[KeptScene, Scene]]:
    library = load_library()
    left = [one.id for one in library.of(Component.BEHAVIOR)][::each]
    for triple, kind in trials(library, set(left)):
        behavior = triple[0]
        if behavior.id not in left:
            continue
        left.remove(behavior.id)
        plan = plan_of(behavior)
        if isinstance(plan, Foreign) or plan.loop is not None or not {p.primitive for p in plan.phases} <= SAYABLE:
            count["refused"] += 1
            click.echo(f"{behavior.id} refused for its primitives or its loop")
            continue
        program = assemble(scenario_of(triple), triple, kind)
        driven = _driven(program, simulator, seed)
        if driven is None:
            count["not placed"] += 1
            continue
        yield _kept(program, *driven), driven[0]


def _driven(program: ScenicProgram, simulator: Simulator, seed: int) -> tuple[Scene, Episode] | None:
    """The first of the routes on which the scene can be placed, driven."""
    for route in range(simulator.routes(program)):
        scene = Scene(
            id=f"{program.scenario_id}/route-{route:02d}/scene-000",
            scenario_id=program.scenario_id,
            route=route,
            block=0,
            seed=seed,
            values=draw(program.parameters, seed=seed),
        )
        outcome = simulate(simulator, program, scene, load_ego("idm"))
        if not isinstance(outcome, Rejected):
            return scene, outcome
    return None


def _kept(program: ScenicProgram, scene: Scene, episode: Episode) -> KeptScene:
    path = resolve_map("town")
    return KeptScene(
        episode=replace(episode, scene_id=scene.id.replace("behavior/", "").replace("+", "--")),
        text="",
        program=program.source,
        values=scene.values,
        route=scene.route,
        map=MapFile(name=path.name, content=path.read_bytes()),
        joined=lambda: program,
    )


def _read_back(path: Path, scene: Scene, simulator: Simulator) -> Episode | str:
    try:
        found = read_openscenario(path)
        program = foreign_program("read back", written(found.board, path.name))
    except ChatSceneError as error:
        return f"{type(error).__name__}: {error}"
    values = {one.name: scene.values[one.name] for one in program.parameters}
    own = replace(scene, scenario_id=program.scenario_id, route=0, values=values)
    try:
        outcome = simulate(simulator, program, own, load_ego("idm"))
    except ChatSceneError as error:
        return f"{type(error).__name__}: {error}"
    return outcome.reason if isinstance(outcome, Rejected) else outcome


def _told(reader: str, episode: Episode, tracks: Any, away: dict[str, list[float]]) -> str:
    """The largest distance of anybody but the ego, until it meets somebody."""
    end = episode.collision.step if episode.collision else len(episode.ego_track.x) - 1
    found = [float(d) for one, other in _pairs(episode, tracks) for d in _apart(one, other, end)]
    away[reader].append(max(found))
    return f"{reader} {max(found):.2f} m at most, {np.median(found):.3f} in the median"


def _pairs(episode: Episode, tracks: Any) -> Iterator[tuple[Track, Any]]:
    for index, one in enumerate(episode.tracks[1:], 1):
        yield one, tracks[one.actor] if isinstance(tracks, dict) else tracks[index]


def _apart(one: Track, other: Any, end: int) -> list[float]:
    x, y = (other.x, other.y) if isinstance(other, Track) else (other[:, 0], other[:, 1])
    last = min(end + 1, len(one.x), len(x))
    return [math.dist((one.x[i], one.y[i]), (x[i], y[i])) for i in range(last)]


def _played(library: Path, folder: Path, kept: KeptScene, files: dict[str, bytes]) -> dict[str, Any] | None:
    """The centres of everybody in esmini, where the ego follows its trajectory."""
    exact = Xml.fromstring(OpenScenario().files(kept)[f"{kept.stem}.xosc"])
    root = Xml.fromstring(files[f"{kept.stem}.xosc"])
    (act,) = root.iter("Act")
    act.insert(0, next(group for group in exact.iter("ManeuverGroup") if group.attrib["name"] == "ego drives"))
    for one in root.iter("ScenarioObject"):
        for controller in one.findall("ObjectController"):
            one.remove(controller)
    path = folder / "played.xosc"
    Xml.ElementTree(root).write(path)
    with multiprocessing.Pool(1) as fresh:  # esmini keeps state in its process
        return fresh.apply(_centres, (library, path, len(kept.episode.ego_track.x)))


def _centres(library: Path, path: Path, steps: int) -> dict[str, Any] | None:
    esmini = loaded(library)
    esmini.SE_SetOption(b"disable_stdout")
    esmini.SE_SetOptionValue(b"traj_filter", b"0")
    esmini.SE_SetOptionValue(b"logfile_path", str(path.with_suffix(".log")).encode())
    if esmini.SE_Init(str(path).encode(), 0, 0, 0, 0) != 0:
        return None
    found: dict[str, list[tuple[float, float]]] = {}
    for _ in range(steps):
        for index in range(esmini.SE_GetNumberOfObjects()):
            number, state = esmini.SE_GetId(index), State()
            esmini.SE_GetObjectState(number, ctypes.byref(state))
            centre = state.x + state.centre_x * math.cos(state.h), state.y + state.centre_x * math.sin(state.h)
            found.setdefault(esmini.SE_GetObjectName(number).decode(), []).append(centre)
        for _ in range(5):
            esmini.SE_StepDT(STEP / 5)
    return {name: np.array(poses) for name, poses in found.items()}


if __name__ == "__main__":
    main()
