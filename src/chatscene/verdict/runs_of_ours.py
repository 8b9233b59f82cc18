"""Scenes of a run of ours, as they were driven; nothing is driven again."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from chatscene.errors import RunError
from chatscene.runs import (
    RunRecord,
    each_scene,
    open_run,
    read_drawing,
    read_episodes,
    read_record,
    read_scenes,
    require_done,
)
from chatscene.runs.rebuild import remade
from chatscene.runs.tables import scene_of
from chatscene.runs.trust import Repeated, follow
from chatscene.settings import VerifySettings
from chatscene.verdict.watched import Watched, Watching

SHOWN = 5  # of the scenes of a run where another was named


def watch_run(folder: Path, settings: VerifySettings, repeated: Repeated | None = None) -> Watching:
    """Scenes of a run: the one that is named, or those that it keeps; where it keeps none, the first that were driven.

    Raises:
        RunError: There is no run, it has no such scene, or it names what must be repeated.
        Diverged: This version makes another program than the one that was kept.
    """
    run = open_run(folder, RunRecord)
    record = read_record(run)
    first, kept = list[str](), list[str]()
    for row in each_scene(run, ("scene_id", "selected", "status")):
        if row["status"] == "ran":
            first += [row["scene_id"]] if len(first) <= max(settings.draws, SHOWN) else []
            kept += [row["scene_id"]] if row["selected"] else []
    chosen = [settings.scene_id] if settings.scene_id else (kept or first)[: settings.draws]
    driven = {row["scene_id"]: row for row in read_scenes(run, ids=chosen) if row["status"] == "ran"}
    if not chosen or chosen[0] not in driven:
        require_done(run, record)
        some = ", ".join([*first[:SHOWN], *(["…"] if len(first) > SHOWN else [])])
        raise RunError(f"{folder} has no scene {settings.scene_id!r} that was driven, but {some or 'none at all'}")
    follow(repeated or Repeated(), simulators_of=[run], joining_of=[run])  # its ego drove already, and is not loaded
    made = remade(run)
    drives = tuple(
        Watched(
            episode=episode,
            route=made.simulator.route_in(made.program, scene_of(driven[episode.scene_id], made.program)),
            tested=not made.program.as_written,
            avoidable=_known(driven[episode.scene_id]),
        )
        for episode in read_episodes(run, chosen)
    )
    drawing = read_drawing(run)
    kept = "the scene that was named" if settings.scene_id else "kept scenes"
    return Watching(
        kind=f"run, {kept}",
        drives=drives,
        notes=(f"{record.ego} drives the ego",),
        drawing=lambda _scene, _box: drawing,
    )


def _known(row: dict[str, Any]) -> bool | None:
    return row["avoidable"] if row["collision"] else None
