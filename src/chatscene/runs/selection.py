"""Step 7 of 9 on what lies in a run folder."""

from __future__ import annotations

from chatscene.runs.blocks import read_scenes
from chatscene.runs.workspace import Workspace
from chatscene.search.select import Candidate, select
from chatscene.settings import SearchSettings


def selected(run: Workspace, settings: SearchSettings) -> dict[str, bool]:
    """Step 7 for every scenario and route: scene id to whether it is a fill-in."""
    jobs: dict[tuple[str, str], list[Candidate]] = {}
    for row in read_scenes(run):
        if row["status"] == "ran":
            candidate = Candidate(
                scene_id=row["scene_id"],
                collided=row["collision"],
                shown=row["meaning_ok"],
                avoidable=row["avoidable"],
                overall_score=row["overall_score"],
            )
            jobs.setdefault((row["scenario_id"], row["route_id"]), []).append(candidate)
    return {
        s.scene_id: s.fill_in
        for candidates in jobs.values()
        for s in select(
            candidates, count=settings.keep, selection=settings.selection, avoidable_only=settings.avoidable_only
        )
    }
