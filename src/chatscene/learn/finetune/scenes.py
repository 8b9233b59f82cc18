"""The scenes of a fine-tuning: which are trained on, chosen by and tested on, and how an ego fares on them."""

from __future__ import annotations

import hashlib
import json
import shlex
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from chatscene import runs
from chatscene.ego.policy import EgoPolicy
from chatscene.errors import RunError
from chatscene.measure.score import measure, score, wilson
from chatscene.program.ordinary import Course
from chatscene.runs.rebuild import map_of, rebuild
from chatscene.runs.together import simulated_alike
from chatscene.search.generator import GENERATORS, load_generator
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import SIMULATORS, Simulator, simulate
from chatscene.terms.metrics import Measurements
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

TRAIN, CHOICE, TEST = "train", "choice", "test"


@dataclass(frozen=True, slots=True, kw_only=True)
class KeptScene:
    """A kept scene of a run, with what it takes to drive it."""

    program: ScenicProgram
    scene: Scene

    @property
    def course(self) -> Course:
        """What a `DrivingEnv` drives."""
        return Course(program=self.program, route=self.scene.route)


@dataclass(frozen=True, slots=True, kw_only=True)
class Lessons:
    """The kept scenes of some runs."""

    map_name: str
    simulation: SimulationSettings
    scenes: tuple[KeptScene, ...]

    @property
    def digest(self) -> str:
        """Which scenes these are: of the programs and all values."""
        told = [(kept.program.digest, kept.scene.id, dict(kept.scene.values)) for kept in self.scenes]
        return hashlib.blake2b(json.dumps(told, sort_keys=True).encode(), digest_size=8).hexdigest()


@dataclass(frozen=True, slots=True, kw_only=True)
class Judged:
    """How an ego fared on some scenes.

    Attributes:
        figures: ``n``, ``collision_rate`` with the ends of its Wilson interval, ``overall_score`` (paper mode),
            ``completion``, and ``rejected``; rates are left out where nothing could be driven.
        rejected: Why a scene could not be driven, by scene.
    """

    figures: dict[str, float]
    rejected: dict[str, str]


def kept_scenes(sources: Sequence[Path], *, simulator: str = "", physics: str = "") -> Lessons:
    """The kept scenes of finished runs among or below some folders.

    Raises:
        RunError: There is no run, one is not finished or damaged, they differ in map, step or simulator, or one holds a
            program or snippets that are not packaged, which are run nowhere but in the sandbox, or names a simulator
            that is not packaged, which only a user may.
        Diverged: This version makes another program of a run's snippets.
    """
    found = [runs.open_run(path) for path in runs.run_folders(sources)]
    records = [runs.read_record(run) for run in found]
    first = records[0]
    map_of(first)  # it must still be the file that they were made on
    simulation = simulated_alike(found, records, simulator=simulator, physics=physics)
    scenes: list[KeptScene] = []
    for run, record in zip(found, records, strict=True):
        runs.require_done(run, record)
        settings = runs.settings_of(record)
        if (record.map_name, record.map_digest) != (first.map_name, first.map_digest):
            raise RunError(
                f"{run.path} lies on map {record.map_name} and {found[0].path} on {first.map_name}, and a fine-tuning "
                "drives on one map; run the sentences on one, with --map, or fine-tune on them one by one"
            )
        if not simulator and simulation.simulator not in SIMULATORS.built_in:
            raise RunError(
                f"{run.path} names the simulator {simulation.simulator!r}, which is not a packaged one: whoever wrote "
                f"run.json chose it. If you trust it, say so: --simulator {shlex.quote(simulation.simulator)}"
            )
        packaged = record.generator in GENERATORS.built_in
        trusted = packaged and load_generator(record.generator).is_trusted(settings.retrieval)
        made = rebuild(run) if trusted else None
        if made is None or made.generator != record.generator:
            raise RunError(f"{run.path} holds code that is not packaged, which runs in the sandbox only; leave it out")
        rows = [row for row in runs.read_scenes(run) if row["selected"]]
        scenes += [KeptScene(program=made.program, scene=runs.scene_of(row, made.program)) for row in rows]
    return Lessons(map_name=first.map_name, simulation=simulation, scenes=tuple(scenes))


def split(
    scenes: Iterable[KeptScene], *, choice: str, train_routes: int, validation_routes: int
) -> dict[str, tuple[KeptScene, ...]]:
    """Scenes by what they are for, told apart by the number of their route.

    The first `train_routes` routes train, the rest test. With `choice` ``paper`` the test scenes also choose the
    checkpoint; with ``held-out`` the last `validation_routes` of the training routes do, and are not trained on.

    Raises:
        RunError: There is no scene to train on, to choose by or to test on.
    """
    first_choice = train_routes if choice == "paper" else train_routes - validation_routes
    parts: dict[str, list[KeptScene]] = {TRAIN: [], CHOICE: [], TEST: []}
    for kept in scenes:
        route = kept.scene.route
        if route < first_choice:
            parts[TRAIN].append(kept)
        if route >= train_routes:
            parts[TEST].append(kept)
        if (choice == "paper" and route >= train_routes) or first_choice <= route < train_routes:
            parts[CHOICE].append(kept)
    routes = {TRAIN: f"below {first_choice}", CHOICE: f"from {first_choice}", TEST: f"from {train_routes}"}
    for name, part in parts.items():
        if not part:
            raise RunError(
                f"there is no kept scene on a route {routes[name]} (for: {name}); search with `--routes 10`, "
                "or train on fewer routes with `--train-routes`"
            )
    return {name: tuple(part) for name, part in parts.items()}


def judge(
    ego: EgoPolicy, scenes: Sequence[KeptScene], simulator: Simulator, *, on_scene: Callable[[int, int], None]
) -> Judged:
    """Drive each scene once.

    Raises:
        EgoError: The ego fails.
    """
    measured: list[Measurements] = []
    rejected: dict[str, str] = {}
    for number, kept in enumerate(scenes, 1):
        episode = simulate(simulator, kept.program, kept.scene, ego)
        if isinstance(episode, Rejected):
            rejected[kept.scene.id] = episode.reason
        else:
            measured.append(measure(episode))
        on_scene(number, len(scenes))
    return Judged(figures={**_figures(measured), "rejected": float(len(rejected))}, rejected=rejected)


def _figures(measured: Sequence[Measurements]) -> dict[str, float]:
    if not measured:
        return {"n": 0.0}
    metrics = score(measured)
    low, high = wilson(sum(m.collided for m in measured), len(measured))
    return {
        "n": float(len(measured)),
        "collision_rate": metrics.collision_rate,
        "collision_rate_low": low,
        "collision_rate_high": high,
        "overall_score": metrics.overall_score,
        "completion": metrics.completion,
    }
