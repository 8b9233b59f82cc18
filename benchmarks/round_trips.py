"""Whether an exported scene comes back: exported as OpenSCENARIO, imported, driven, held against its tracks.

    python benchmarks/round_trips.py RUN... [--to openscenario-logical] [--most 30] [--ego planner]

Each kept scene of each run is exported, imported again, and driven in the sandbox: what was driven as its file is
written, the ego too; a logical scenario, which leaves the ego to whoever drives, by the ego of its run. With `--ego`
that ego drives, and is not compared. Each road user is compared with the one nearest to its place at the start, until
the shorter of the two drives ends. Distances are between the middles of bodies.
"""

from __future__ import annotations

import sys
import tempfile
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import click
import numpy as np

import chatscene
from chatscene.ego.policy import load_ego
from chatscene.errors import ChatSceneError
from chatscene.imports.import_file import import_scenario
from chatscene.program.sample import scene_at
from chatscene.runs import open_run, read_episode, read_record, read_scenes
from chatscene.runs.rebuild import map_of
from chatscene.search.generators.foreign import read_foreign
from chatscene.settings import SimulationSettings
from chatscene.simulate.confined.simulator import ConfinedSimulator
from chatscene.simulate.simulator import simulate
from chatscene.terms.episode import Episode, Track
from chatscene.terms.scene import Rejected

NEAR = 0.05  # [m]
DISTRIBUTION = "_distribution."


def apart(was: Episode, now: Episode, *, with_ego: bool) -> Iterator[tuple[str, float, float]]:
    """Each road user, how far [m] it is at most from where it was, and when [s]; the ego only where that is told."""
    first = 0 if with_ego else 1
    left = list(now.tracks[first:])
    for track in was.tracks[first:]:
        if not left:
            yield track.actor, float("inf"), 0.0
            continue
        twin = min(left, key=lambda one: float(np.hypot(one.x[0] - track.x[0], one.y[0] - track.y[0])))
        left.remove(twin)
        yield track.actor, *_apart(track, twin, was.dt)


def _apart(one: Track, other: Track, dt: float) -> tuple[float, float]:
    count = min(len(one.x), len(other.x))
    gaps = np.hypot(one.x[:count] - other.x[:count], one.y[:count] - other.y[:count])
    return float(gaps.max()), float(gaps.argmax() * dt)


def values_of(row: Mapping[str, Any]) -> dict[str, float]:
    """The values of a scene's parameters, by their names."""
    return {name: value for name, value in row.items() if name.startswith("OPT_") and value is not None}


def played(
    xosc: Path, where: Path, simulators: dict[Path, ConfinedSimulator], ego: str, values: Mapping[str, float]
) -> tuple[Episode, tuple[str, ...]]:
    """A drive of an imported file on the map of its run, with the values of its scene, and what was noted of it.

    Nobody by the name of the ego is that of the file.

    Raises:
        ChatSceneError: It does not come back, or does not run.
    """
    made = import_scenario(xosc, out=xosc.with_suffix(".scenic"), map_name=str(where))
    own = read_foreign(made.program, searched_with=False, as_written=not ego)
    if where not in simulators:
        simulators[where] = ConfinedSimulator(where, SimulationSettings())
    scene = replace(scene_at(own.program, 0, 0.5, name="back"), seed=0)
    scene = replace(scene, values={**scene.values, **{name: values[name] for name in scene.values if name in values}})
    episode = simulate(simulators[where], own.program, scene, load_ego(ego or "planner"))
    if isinstance(episode, Rejected):
        raise ChatSceneError(f"rejected: {episode.reason}")
    return episode, made.notes


@click.command()
@click.argument("folders", metavar="RUN...", nargs=-1, required=True, type=click.Path(path_type=Path, exists=True))
@click.option("--to", default="openscenario", show_default=True, help="An exporter of OpenSCENARIO.")
@click.option("--most", default=1_000, show_default=True, help="Scenes.")
@click.option("--ego", default="", help="Who drives in the place of the ego.  [default: as is written]")
def main(folders: tuple[Path, ...], to: str, most: int, ego: str) -> None:
    """Print a line for each scene, and how many come back."""
    count, worst = Counter[str](), list[float]()
    simulators: dict[Path, ConfinedSimulator] = {}
    for folder in folders:
        run = open_run(folder)
        record = read_record(run)
        where, driver = map_of(record), ego or (record.ego if to == "openscenario-logical" else "")
        rows = {str(row["scene_id"]): row for row in read_scenes(run)}
        kept = [scene_id for scene_id, row in rows.items() if row["selected"]]
        for scene_id in kept[: most - count["scenes"]]:
            count["scenes"] += 1
            with tempfile.TemporaryDirectory() as name:
                try:
                    done = chatscene.export(folder, scene_id, to=to, out=Path(name) / "out")
                    (xosc,) = (
                        Path(name) / "out" / one
                        for one in done.files[scene_id]
                        if one.endswith(".xosc") and DISTRIBUTION not in one
                    )
                    count["exported"] += 1
                    episode, notes = played(xosc, where, simulators, driver, values_of(rows[scene_id]))
                except ChatSceneError as error:
                    print(f"{scene_id}: {type(error).__name__}: {' '.join(str(error).split())[:200]}", flush=True)
                    continue
            count["played"] += 1
            was = read_episode(run, scene_id)
            gaps = list(apart(was, episode, with_ego=not ego))
            who, far, at = max(gaps, key=lambda one: one[1], default=("nobody", 0.0, 0.0))
            worst.append(far)
            count["near"] += far <= NEAR
            told = f"{was.duration:.1f} s {was.ending} and {episode.duration:.1f} s {episode.ending}"
            print(f"{scene_id}: {who} {far:.3f} m away at {at:.1f} s; {told}; {len(notes)} notes", flush=True)
    print(dict(count), f"median {np.median(worst):.3f} m" if worst else "")
    for one in simulators.values():
        one.close()


if __name__ == "__main__":
    sys.exit(main())
