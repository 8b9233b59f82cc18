"""How often a situation ends in a crash, if it comes about: from the drives of a run and from more."""

from __future__ import annotations

from collections import Counter
from collections.abc import Generator, Iterator, Sequence
from dataclasses import asdict, dataclass
from itertools import groupby
from operator import itemgetter
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.maps.carried import CarriedMap
from chatscene.measure.avoidability import avoidable_if_driven
from chatscene.measure.criticality import criticality
from chatscene.program.sample import scene_seed
from chatscene.runs.blocks import each_event, each_scene, read_episode, read_ranges
from chatscene.runs.executor import ONE, Workers
from chatscene.runs.parallel import spread
from chatscene.runs.progress import Progress, silent
from chatscene.runs.rebuild import map_of, rebuild
from chatscene.runs.record import RunRecord, settings_of
from chatscene.runs.tables import route_index, scene_of
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.workspace import Workspace, open_run, read_record, require_done
from chatscene.search.climb import simulator_of
from chatscene.search.exposure import Exposure, as_rows, exposure_of
from chatscene.search.generator import load_generator
from chatscene.search.generators.exploring import Exploring
from chatscene.search.rare import FEWEST, Batch, Box, Came, Share, Tally, rounds
from chatscene.settings import SearchSettings, Settings
from chatscene.simulate.simulator import check_jobs, simulate
from chatscene.terms.episode import Episode, EventKind
from chatscene.terms.exposure import Density, Shape
from chatscene.terms.outcome import Outcome
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

Array = NDArray[np.float64]

# How many of a route's blocks a sampler draws uniformly from ranges, which a run keeps; None of all.
UNIFORM: dict[str, int | None] = {"paper": None, "random": None, "cross-entropy": 1, "quality-diversity": 1}


@dataclass(frozen=True, slots=True, kw_only=True)
class Rate:
    """How often a situation ends in a crash, of scenes that can be placed, if the situation comes about.

    Attributes:
        stored: How many drives of the run were counted.
        driven: How many were made for this, of scenes that could be placed.
        drawn: How many scenes were drawn in all, those that could not be placed as well.
        crash: How often the ego's first collision is with an adversary.
        avoidable: How often that happens and a careful driver would have avoided it (decision 0013); None where that is
            not known of every crash.
        unknown: Of how many crashes it is not known, such as those of a program whose own ego drives.
        exposure: The parameters with their densities.
        left: Which drives of the run were not counted, and why; empty if all were.
    """

    text: str
    ego: str
    stored: int
    driven: int
    drawn: int
    crash: Share
    avoidable: Share | None
    unknown: int
    exposure: tuple[dict[str, Any], ...]
    left: str

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        return asdict(self)

    def in_words(self) -> str:
        """A few lines."""
        uniform = [one["parameter"] for one in self.exposure if one["shape"] == Shape.UNIFORM and not one["source"]]
        known = [one for one in self.exposure if one["source"]]
        of = f"{self.unknown} of {self.crash.seen} crashes"
        careful = f"not known of {of}" if self.avoidable is None else _told(self.avoidable)
        lines = [
            f"{self.text!r}, driven by {self.ego}: if it comes about,",
            f"  a crash with the adversary: {_told(self.crash)}",
            f"  one that a careful driver avoids: {careful}",
            f"from {self.stored} drives of the run and {self.driven} more ({self.drawn} scenes drawn in all).",
        ]
        if self.left:
            lines.append(f"Not counted: {self.left}.")
        if uniform:
            lines.append(
                f"Assumed, not measured: every value of its range is equally frequent for {', '.join(uniform)}."
            )
        lines += [
            f"{one['parameter']}: {one['shape']}, {one['inside']:.0%} of it in the declared range; {one['source']}."
            for one in known
        ]
        return "\n".join(lines)


def _told(share: Share) -> str:
    if share.probability is not None:
        return f"{share.probability:.2%} (95 %: {share.low:.2%} to {share.high:.2%})"
    if share.seen:
        return (
            f"too few crashes for an estimate: {share.seen}, {share.effective:.1f} after weighting, "
            f"of at least {FEWEST}; add scenes with --scenes"
        )
    return f"none seen; below {share.high:.2%} (95 %)"


@dataclass(frozen=True, slots=True)
class _Setup:
    program: ScenicProgram
    generator: str
    map: CarriedMap
    settings: Settings
    ego: str


class _Driver:
    """Drives one scene after another."""

    def __init__(self, setup: _Setup) -> None:
        self._program = setup.program
        self._simulator = simulator_of(load_generator(setup.generator), setup.map.file(), setup.settings)
        self._ego: EgoPolicy = load_ego(setup.ego)

    def __call__(self, task: tuple[int, Scene]) -> tuple[int, Came | None]:
        number, scene = task
        episode = simulate(self._simulator, self._program, scene, self._ego)
        if isinstance(episode, Rejected):
            return number, None
        crashed = _with_adversary(episode)
        careful: bool | None = False
        if crashed:
            careful, _ = avoidable_if_driven(episode, self._program, scene, self._ego, self._simulator)
        near = criticality(episode)
        came = Outcome(
            values=scene.values,
            collided=crashed,
            distance=near.distance,
            impact_speed=near.impact_speed or 0.0,
            completion=float(episode.route_completion),
        )
        return number, Came(came.danger, crashed, careful)


def _with_adversary(episode: Episode) -> bool:
    return episode.collision is not None and episode.collision.other in {one.actor for one in episode.adversaries}


def rate(
    folder: Path,
    *,
    scenes: int = 200,
    seed: int = 0,
    densities: Sequence[Density] = (),
    workers: Workers = ONE,
    progress: Progress = silent,
    repeated: Repeated | None = None,
) -> Rate:
    """How often the situation of a run ends in a crash, if it comes about.

    The drives of the run count where it is known what they were drawn from. Further ones are drawn from the exposure,
    and where crashes are rare, around those that were seen; each counts as often as it occurs under the exposure.

    Args:
        folder: A run.
        scenes: How many scenes to draw beside those of the run.
        seed: Of these.
        densities: How often values occur; a parameter without one is taken to be uniform in its range.
        workers: Who drives; it changes no number.
        progress: Told of the drives.
        repeated: What the run names and the user trusts.

    Raises:
        RunError: There is no run, it was refused or is not done, or it names what must be repeated.
        SettingsError: A density is of no parameter of the program, or lies outside its range.
        Diverged: This version makes another program than the one that was kept.
    """
    run = open_run(folder, RunRecord)
    follow(repeated or Repeated(), egos_of=[run], simulators_of=[run], joining_of=[run])
    record = read_record(run)
    require_done(run, record)
    settings = settings_of(record)
    check_jobs(settings.simulation, workers.jobs)
    made = rebuild(run)
    scenario, program = made.scenario, made.program
    exposure = exposure_of(program.parameters, densities)
    ran = Counter[str]()
    for row in each_scene(run, ("route_id", "status")):
        ran[row["route_id"]] += row["status"] == "ran"
    routes = sorted(map(route_index, ran)) or [0]
    tally = Tally(exposure)
    by, blocks = _searched_by(record.generator, settings.search)
    for points, came, batch in _stored(run, program, exposure, blocks):
        tally.add(points, [batch.route or 0] * len(came), came, batch)
    stored = tally.placed
    setup = _Setup(program, made.generator, CarriedMap.of(map_of(record)), settings, record.ego)
    series = _rounds(tally, exposure, scenario.id, routes, scenes, seed)
    waiting = next(series, [])
    found: dict[int, Came | None] = {}

    def then(result: tuple[int, Came | None]) -> list[tuple[int, Scene]]:
        found.update([result])
        if len(found) < len(waiting):
            return []
        try:
            waiting[:] = series.send(found)
        except StopIteration:
            waiting.clear()
        found.clear()
        return waiting

    # One set of workers for all rounds: to begin with the program takes longer than to drive a round.
    for done, _ in enumerate(spread(_Driver, setup, waiting, workers=workers, then=then), start=1):
        progress("scenes", done, scenes)
    crash, careful = tally.shares()
    return Rate(
        text=record.title,
        ego="its own ego" if program.as_written else record.ego,
        stored=stored,
        driven=tally.placed - stored,
        drawn=tally.drawn,
        crash=crash,
        avoidable=careful,
        unknown=tally.unknown,
        exposure=tuple(dict(row) for row in as_rows(exposure)),
        left=_not_counted(by, blocks, counted=stored == ran.total()),
    )


def _rounds(
    tally: Tally, exposure: Exposure, scenario: str, routes: Sequence[int], scenes: int, seed: int
) -> Generator[list[tuple[int, Scene]], dict[int, Came | None], None]:
    """The scenes of each round with their numbers in it, for what each came to; a round is aimed by those before."""
    begun = 0
    for number, count in enumerate(rounds(scenes)):
        rng = np.random.default_rng((scene_seed(seed, f"{scenario}/rate"), number))
        points, batch = tally.draw(count, rng)
        on = [routes[(begun + i) % len(routes)] for i in range(count)]
        values = [exposure.cube.values(point) for point in points]
        found = yield [(i, _scene(scenario, seed, begun + i, on[i], values[i])) for i in range(count)]
        tally.add(points, on, [found[i] for i in range(count)], batch)
        begun += count


def _scene(scenario: str, seed: int, number: int, route: int, values: dict[str, float]) -> Scene:
    name = f"{scenario}/route-{route:02d}/rate-{number:05d}"
    return Scene(id=name, scenario_id=scenario, route=route, block=-1, seed=scene_seed(seed, name), values=values)


def _searched_by(name: str, search: SearchSettings) -> tuple[str, int | None]:
    """Who drew the values of a run, in words, and how many of a route's blocks uniformly; None of all.

    Many generators have a sampler of their own, whatever the settings name.
    """
    generator = load_generator(name)
    if not isinstance(generator, Exploring):
        return "the generator", 0
    sampler = generator.searching(search).sampler
    return f"the sampler {sampler!r}", UNIFORM.get(sampler, 0)


def _not_counted(by: str, blocks: int | None, *, counted: bool) -> str:
    if counted:
        return ""
    which = "the drives after the first block of a route" if blocks else "its drives"
    return f"{which}: {by} draws with unknown probabilities"


def _stored(
    run: Workspace, program: ScenicProgram, exposure: Exposure, blocks: int | None
) -> Iterator[tuple[Array, list[Came | None], Batch]]:
    """The points, the drives and the box of each of the first blocks; what could not be placed counts as drawn."""
    ranges: dict[tuple[str, int], dict[str, tuple[float, float]]] = {}
    for row in read_ranges(run):
        ranges.setdefault((row["route_id"], row["block"]), {})[row["parameter"]] = row["low"], row["high"]
    struck: dict[str, tuple[int, str]] = {}
    for event in each_event(run, ("scene_id", "kind", "step", "other")):
        first = struck.get(event["scene_id"])
        if event["kind"] == EventKind.COLLISION and (first is None or event["step"] < first[0]):
            struck[event["scene_id"]] = event["step"], event["other"]
    names = each_scene(run, ("scene_id", "status"))
    ran = next((row["scene_id"] for row in names if row["status"] == "ran"), None)
    adversaries = {one.actor for one in read_episode(run, ran).adversaries} if ran else set[str]()
    cube = exposure.cube
    # Blocks lie in the table in their order, each in one piece.
    for (route, block), rows in groupby(each_scene(run), key=itemgetter("route_id", "block")):
        box = ranges.get((route, block))
        if box is None or (blocks is not None and block >= blocks):
            continue
        here = list(rows)
        low, high = (cube.point({p.name: box[p.name][end] for p in cube.free}) for end in (0, 1))
        every: list[Came | None] = []
        points = np.zeros((len(here), len(cube.free)))
        for number, row in enumerate(here):
            if row["status"] != "ran":
                every.append(None)
                continue
            scene = scene_of(row, program)
            points[number] = cube.point(scene.values)
            crashed = struck.get(row["scene_id"], (0, ""))[1] in adversaries
            came = Outcome(
                values=scene.values,
                collided=crashed,
                distance=row["distance"],
                impact_speed=row["impact_speed"] or 0.0,
                completion=row["route_completion"],
            )
            every.append(Came(came.danger, crashed, row["avoidable"] if crashed else False))
        yield points, every, Batch(count=len(here), density=Box(low, high), route=route_index(route))
