"""A scene simulated again from what its run kept."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from chatscene.errors import SettingsError
from chatscene.runs.blocks import read_episode, read_scenes
from chatscene.runs.rebuild import remade, since
from chatscene.runs.record import RunRecord, settings_of
from chatscene.runs.tables import scene_of
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.workspace import changed_versions, open_run, read_record
from chatscene.simulate.simulator import simulate
from chatscene.terms.episode import Episode, Track
from chatscene.terms.scene import Rejected

RECORDINGS = "recordings"
WITHIN = 0.5  # [m], of actors at the same step, in a simulator that does not repeat itself to the bit
STEPS_APART = 2  # ... and of its events and endings


@dataclass(frozen=True, slots=True, kw_only=True)
class Replayed:
    """A scene simulated again.

    Attributes:
        difference: Where the tracks first differ, in words; empty if every number is the same within the tolerance.
        within: The tolerance [m]; 0 where the simulator repeats itself to the bit.
        apart: The largest distance [m] between where an actor was and is at the same step.
        versions: What the run was made with and is otherwise now: by name, the version then and now.
    """

    scene_id: str
    difference: str
    within: float
    apart: float
    versions: Mapping[str, tuple[str, str]]

    @property
    def identical(self) -> bool:
        """Whether the tracks are the same, as far as the simulator repeats itself."""
        return not self.difference

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        return {
            "scene_id": self.scene_id,
            "identical": self.identical,
            "difference": self.difference,
            "within": self.within,
            "apart": self.apart,
            "versions": {name: {"then": then, "now": now} for name, (then, now) in self.versions.items()},
        }

    def in_words(self) -> str:
        """One line for a person."""
        if self.identical:
            how = f"the same within {self.within:g} m; actors are {self.apart:.3f} m apart at most"
            return f"{self.scene_id}: {how if self.within else 'identical'}"
        return f"{self.scene_id}: differs: {self.difference}{since(self.versions)}"


def replay(
    folder: Path, scene_id: str, *, repeated: Repeated | None = None, watch: bool = False, record: bool = False
) -> Replayed:
    """Simulate a scene of a run again from its stored values, and compare every number of every track.

    Where the simulator is not exact, what counts is that actors are within `WITHIN` and events within `STEPS_APART`.

    Args:
        folder: The run's.
        scene_id: Which scene.
        repeated: What the run names and the user as well.
        watch: Whether the window of the simulator's server looks down on the ego.
        record: Whether its recorder writes a file below ``recordings`` in the folder.

    Raises:
        RunError: The run has no such scene, or it was never driven; or it names what must be repeated
            (`chatscene.runs.trust.follow`).
        SettingsError: The simulator has no window or no recorder.
    """
    run = open_run(folder, RunRecord)
    follow(repeated or Repeated(), egos_of=[run], simulators_of=[run], joining_of=[run])
    kept = read_record(run)
    stored = read_episode(run, scene_id)
    (row,) = read_scenes(run, ids=[scene_id])
    made = remade(run)
    scene, simulator = scene_of(row, made.program), made.simulator
    if watch or record:
        if (show := getattr(simulator, "show", None)) is None:
            name = settings_of(kept).simulation.simulator
            raise SettingsError(f"the simulator {name!r} has no window and no recorder")
        recording = run.path.absolute() / RECORDINGS / f"{scene_id.replace('/', '-')}.log"
        if record:
            recording.parent.mkdir(exist_ok=True)
        show(watched=watch, recording=recording if record else None)
    again = simulate(simulator, made.program, scene, made.ego)
    exact = simulator.identity.exact
    return Replayed(
        scene_id=scene_id,
        difference=(_difference if exact else _far_difference)(stored, again),
        within=0.0 if exact else WITHIN,
        apart=0.0 if isinstance(again, Rejected) else max(map(apart, stored.tracks, again.tracks)),
        versions=changed_versions(kept),
    )


def _far_difference(stored: Episode, again: Episode | Rejected) -> str:
    """Where two episodes first differ by more than a simulator may that does not repeat itself to the bit."""
    if isinstance(again, Rejected):
        return f"it is now rejected: {again.reason}"
    if [track.actor for track in stored.tracks] != [track.actor for track in again.tracks]:
        return "other actors now"
    for old, new in zip(stored.tracks, again.tracks, strict=True):
        if abs(len(old.x) - len(new.x)) > STEPS_APART:
            return f"{len(old.x)} steps then, {len(new.x)} steps now"
        if (away := apart(old, new)) > WITHIN:
            return f"{old.actor}: {away:.2f} m away from where it was"
    then, now = ([(e.kind, e.other, e.side) for e in one.events] for one in (stored, again))
    far = any(abs(old.step - new.step) > STEPS_APART for old, new in zip(stored.events, again.events, strict=False))
    return "the events differ" if then != now or far else ""


def apart(old: Track, new: Track) -> float:
    """The largest distance [m] of an actor from where it was at the same step."""
    steps = min(len(old.x), len(new.x))
    return float(np.hypot(old.x[:steps] - new.x[:steps], old.y[:steps] - new.y[:steps]).max())


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
