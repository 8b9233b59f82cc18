"""A scene of a run, driven as it was until a moment and otherwise from then on."""

from __future__ import annotations

import math
from numbers import Real
from pathlib import Path

from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.errors import RunError, SettingsError, SimulationError
from chatscene.measure.branch import branch
from chatscene.runs.blocks import read_scenes
from chatscene.runs.rebuild import remade
from chatscene.runs.record import RunRecord, settings_of
from chatscene.runs.tables import scene_of
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.workspace import open_run, read_record
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Rejected


def branch_scene(
    folder: Path, scene_id: str, *, at: float, ego: str | EgoPolicy, repeated: Repeated | None = None
) -> Episode:
    """Drive a scene of a run as its ego did until a moment, and with another ego from then on.

    Args:
        folder: The run's.
        scene_id: Which scene.
        at: When the other takes over [s].
        ego: Who, or by which name.
        repeated: What the run names and the user as well.

    Raises:
        RunError: The run has no such scene, or it was never driven; or it names what must be repeated
            (`chatscene.runs.trust.follow`).
        SettingsError: The moment is before the beginning, or when the drive is over.
        SimulationError: The scene cannot be driven again.
    """
    if not isinstance(at, Real) or not 0.0 <= at < math.inf:
        raise SettingsError(f"an ego cannot take over at {at!r}; give seconds from the beginning of the scene, 0")
    run = open_run(folder, RunRecord)
    follow(repeated or Repeated(), egos_of=[run], simulators_of=[run], joining_of=[run])
    row = next((row for row in read_scenes(run, ids=[scene_id]) if row["status"] == "ran"), None)
    if row is None:
        raise RunError(f"{folder} has no scene {scene_id!r} that was driven")
    again = remade(run)
    other = load_ego(ego) if isinstance(ego, str) else ego
    step = round(at / settings_of(read_record(run)).simulation.dt)
    driven = branch(again.program, scene_of(row, again.program), again.ego, other, again.simulator, step=step)
    if isinstance(driven, Rejected):
        raise SimulationError(f"scene {scene_id!r} ran once and is now rejected: {driven.reason}")
    return driven
