"""Egos on the ordinary drives of a map: the table, and a picture of each at the wheel."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from chatscene.ego.policy import load_ego, name_of
from chatscene.maps.carried import CarriedMap
from chatscene.maps.drawing import drawing_around
from chatscene.maps.loading import load_roads
from chatscene.maps.network import resolve_map
from chatscene.measure.ordinary import OrdinaryResult, drive_ordinary, ordinary_episodes, ordinary_table
from chatscene.report.animation import animate, if_drawn
from chatscene.report.tables import write_tables
from chatscene.runs.atomic import write_bytes
from chatscene.runs.executor import ONE, Workers
from chatscene.runs.parallel import spread
from chatscene.runs.progress import Progress
from chatscene.settings import SimulationSettings
from chatscene.simulate.simulator import check_jobs, load_simulator
from chatscene.terms.episode import Episode
from chatscene.terms.results import ResultTable

SEED = 20_000  # neither a training's nor that of its evaluations
FRAMES = 200  # of a GIF: a whole drive
WIDEST = 240.0  # [m] of a GIF: a whole route from north to south
SHOWN = 10  # the course in the GIF: the first that turns


@dataclass(frozen=True, slots=True, kw_only=True)
class _Setup:
    """What every process needs to know."""

    map: CarriedMap
    simulation: SimulationSettings
    scenes: int
    seed: int
    speed: float | None
    pictured: bool


def drive(
    egos: Sequence[str],
    *,
    folder: Path | None = None,
    map_name: str = "town",
    simulation: SimulationSettings | None = None,
    scenes: int = 5,
    seed: int = SEED,
    speed: float | None = None,
    workers: Workers = ONE,
    progress: Progress,
) -> ResultTable:
    """Let egos drive every ordinary course of a map.

    Args:
        egos: By name, file or ``package.module:factory``.
        folder: Where the table and a GIF of each ego go; None for nowhere.
        map_name: Where they drive.
        simulation: In what, and with which step and limits.
        scenes: Variants of the traffic per course.
        seed: Of the traffic.
        speed: What they want to drive at [m/s] within the limits of the roads; None if they are told nothing.
        workers: Who drives; an ego is driven by one.
        progress: Told what is done.

    Raises:
        EgoError: An ego cannot be loaded, or fails.
        SettingsError: There is no such simulator.
    """
    for ego in egos:
        load_ego(ego)
    simulation = simulation or SimulationSettings()
    check_jobs(simulation, workers.jobs)
    path = resolve_map(map_name)
    load_simulator(path, simulation)  # an unknown one is told here, and once
    carried, pictured = CarriedMap.of(path), folder is not None
    setup = _Setup(map=carried, simulation=simulation, scenes=scenes, seed=seed, speed=speed, pictured=pictured)
    results: dict[str, OrdinaryResult] = {}
    for count, (ego, result, picture) in enumerate(spread(_Driver, setup, egos, workers=workers), 1):
        results[ego] = result
        if folder is not None and picture:
            write_bytes(folder / f"{name_of(load_ego(ego))}.gif", picture)
        progress("driving, egos", count, len(egos))
    table = ordinary_table([results[ego] for ego in egos])
    if folder is not None:
        write_tables(folder, {"ordinary": table})
    return table


class _Driver:
    """Drives with one ego after another."""

    def __init__(self, setup: _Setup) -> None:
        self._setup = setup
        self._map = setup.map.file()
        self._simulator = load_simulator(self._map, setup.simulation)

    def __call__(self, ego: str) -> tuple[str, OrdinaryResult, bytes]:
        """How an ego fares, and a picture of it where one is asked for."""
        setup = self._setup
        policy = load_ego(ego)
        picture = b""
        if setup.pictured:
            drives = ordinary_episodes(policy, self._simulator, scenes=1, seed=setup.seed, speed=setup.speed)
            shown = [episode for _, episode in zip(range(SHOWN + 1), drives, strict=False)][-1][1]
            if isinstance(shown, Episode):
                picture = if_drawn(f"the animation of {ego}", lambda: self._animated(shown)) or b""
        fared = drive_ordinary(policy, self._simulator, scenes=setup.scenes, seed=setup.seed, speed=setup.speed)
        return ego, fared, picture

    def _animated(self, shown: Episode) -> bytes:
        return animate(shown, _drawing(shown, self._map), frames=FRAMES, widest=WIDEST)


def _drawing(episode: Episode, map_path: Path) -> dict[str, object]:
    """The map around a drive."""
    ego = episode.ego_track
    return drawing_around(load_roads(map_path), np.column_stack((ego.x, ego.y)))
