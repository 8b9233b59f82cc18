"""Egos on the ordinary drives of a map: the table, and a picture of each at the wheel."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from chatscene.ego.policy import load_ego
from chatscene.errors import EgoError, SettingsError
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
LONGEST = 100  # characters of the name of a GIF


@dataclass(frozen=True, slots=True, kw_only=True)
class OrdinaryDrives:
    """What came of ordinary drives.

    Attributes:
        table: A row for each ego that did not fail, by what it was asked for as.
        failures: Why the others were given up, by ego.
    """

    table: ResultTable
    failures: dict[str, str]


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
) -> OrdinaryDrives:
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
        EgoError: An ego cannot be loaded, or every one fails.
        SettingsError: There is no such simulator, or an ego is named twice.
    """
    if len(set(egos)) != len(egos):
        raise SettingsError(f"name each ego once: {', '.join(egos)}")
    for ego in egos:
        load_ego(ego)
    simulation = simulation or SimulationSettings()
    check_jobs(simulation, workers.jobs)
    path = resolve_map(map_name)
    load_simulator(path, simulation)  # an unknown one is told here, and once
    carried, pictured = CarriedMap.of(path), folder is not None
    setup = _Setup(map=carried, simulation=simulation, scenes=scenes, seed=seed, speed=speed, pictured=pictured)
    results: dict[str, OrdinaryResult] = {}
    failures: dict[str, str] = {}
    pictures = dict(zip(egos, picture_names(egos), strict=True))
    for count, (ego, came, picture) in enumerate(spread(_Driver, setup, egos, workers=workers), 1):
        if isinstance(came, OrdinaryResult):
            results[ego] = came
        else:
            failures[ego] = came
        if folder is not None and picture:
            write_bytes(folder / pictures[ego], picture)
        progress("driving, egos", count, len(egos))
    if not results:
        raise EgoError("\n".join(failures.values()))
    table = ordinary_table([results[ego] for ego in egos if ego in results])
    if folder is not None:
        write_tables(folder, {"ordinary": table})
    return OrdinaryDrives(table=table, failures=failures)


def picture_names(egos: Sequence[str]) -> list[str]:
    """The file of each ego's picture, by what it was asked for as: no folder is in it, and no two are alike."""
    found: list[str] = []
    for ego in egos:
        stem = re.sub(r"[^A-Za-z0-9_]+", "-", ego).strip("-")[-LONGEST:] or "ego"
        alike = sum(one == f"{stem}.gif" or one.startswith(f"{stem}.") for one in found)
        found.append(f"{stem}.{alike + 1}.gif" if alike else f"{stem}.gif")
    return found


class _Driver:
    """Drives with one ego after another."""

    def __init__(self, setup: _Setup) -> None:
        self._setup = setup
        self._map = setup.map.file()
        self._simulator = load_simulator(self._map, setup.simulation)

    def __call__(self, ego: str) -> tuple[str, OrdinaryResult | str, bytes]:
        """How an ego fares, or why it was given up; and a picture of it where one is asked for."""
        try:
            return ego, *self._driven(ego)
        except EgoError as error:
            return ego, str(error), b""

    def _driven(self, ego: str) -> tuple[OrdinaryResult, bytes]:
        setup = self._setup
        policy = load_ego(ego)
        picture = b""
        if setup.pictured:
            drives = ordinary_episodes(policy, self._simulator, scenes=1, seed=setup.seed, speed=setup.speed)
            shown = [episode for _, episode in zip(range(SHOWN + 1), drives, strict=False)][-1][1]
            if isinstance(shown, Episode):
                picture = if_drawn(f"the animation of {ego}", lambda: self._animated(shown)) or b""
        fared = drive_ordinary(policy, self._simulator, scenes=setup.scenes, seed=setup.seed, speed=setup.speed)
        return replace(fared, ego=ego), picture

    def _animated(self, shown: Episode) -> bytes:
        return animate(shown, _drawing(shown, self._map), frames=FRAMES, widest=WIDEST)


def _drawing(episode: Episode, map_path: Path) -> dict[str, object]:
    """The map around a drive."""
    ego = episode.ego_track
    return drawing_around(load_roads(map_path), np.column_stack((ego.x, ego.y)))
