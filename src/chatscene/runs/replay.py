"""A scene simulated again from what its run kept."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from chatscene.ego.policy import load_ego
from chatscene.runs.blocks import read_episode, read_scenes
from chatscene.runs.rebuild import map_of, rebuild, since
from chatscene.runs.record import RunRecord, settings_of
from chatscene.runs.tables import scene_of
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.workspace import changed_versions, open_run, read_record
from chatscene.search.generator import load_generator, simulator_of
from chatscene.simulate.simulator import simulate
from chatscene.terms.episode import Episode, Track
from chatscene.terms.scene import Rejected


@dataclass(frozen=True, slots=True, kw_only=True)
class Replayed:
    """A scene simulated again.

    Attributes:
        scene_id: Which.
        difference: Where the tracks first differ, in words; empty if every number is the same.
        versions: What the run was made with and is otherwise now: by name, the version then and now.
    """

    scene_id: str
    difference: str
    versions: Mapping[str, tuple[str, str]]

    @property
    def identical(self) -> bool:
        """Whether the tracks are the same, bit for bit."""
        return not self.difference

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        return {
            "scene_id": self.scene_id,
            "identical": self.identical,
            "difference": self.difference,
            "versions": {name: {"then": then, "now": now} for name, (then, now) in self.versions.items()},
        }

    def in_words(self) -> str:
        """One line for a person."""
        if self.identical:
            return f"{self.scene_id}: identical"
        return f"{self.scene_id}: differs: {self.difference}{since(self.versions)}"


def replay(folder: Path, scene_id: str, *, repeated: Repeated | None = None) -> Replayed:
    """Simulate a scene of a run again from its stored values, and compare every number of every track.

    Raises:
        RunError: The run has no such scene, or it was never driven; or it names what must be repeated
            (`chatscene.runs.trust.follow`).
    """
    run = open_run(folder, RunRecord)
    follow(repeated or Repeated(), egos_of=[run], simulators_of=[run], joining_of=[run])
    record = read_record(run)
    stored = read_episode(run, scene_id)
    row = next(row for row in read_scenes(run) if row["scene_id"] == scene_id)
    settings = settings_of(record)
    _, program = rebuild(run)
    scene = scene_of(row, program)
    simulator = simulator_of(load_generator(record.generator), map_of(record), settings)
    again = simulate(simulator, program, scene, load_ego(record.ego))
    return Replayed(scene_id=scene_id, difference=_difference(stored, again), versions=changed_versions(record))


def _difference(stored: Episode, again: Episode | Rejected) -> str:
    """Where two episodes first differ, in words; empty if nowhere."""
    if isinstance(again, Rejected):
        return f"it is now rejected: {again.reason}"
    for old, new in zip(stored.tracks, again.tracks, strict=False):
        if (problem := _track_difference(old, new)) is not None:
            return f"{old.actor}: {problem}"
    if len(stored.tracks) != len(again.tracks):
        return f"{len(stored.tracks)} actors then, {len(again.tracks)} now"
    return "" if stored.events == again.events else "the events differ"


def _track_difference(old: Track, new: Track) -> str | None:
    if (old.actor, old.kind, len(old.x)) != (new.actor, new.kind, len(new.x)):
        return f"{old.kind} for {len(old.x)} steps then, {new.actor}, {new.kind} for {len(new.x)} steps now"
    for name in ("x", "y", "heading", "speed"):
        changed = np.flatnonzero(getattr(old, name) != getattr(new, name))
        if changed.size:
            return f"{name} from step {int(changed[0])} on"
    return None
