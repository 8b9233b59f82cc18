"""Step 7 of 9 on what lies in a run folder."""

from __future__ import annotations

from collections.abc import Sequence

from chatscene.runs.rows import Part
from chatscene.search.select import Candidate, select
from chatscene.settings import SearchSettings
from chatscene.terms.criticality import Happening


def selected(parts: Sequence[Part], settings: SearchSettings) -> dict[str, bool]:
    """Step 7 for every scenario and route of some blocks: scene id to whether it is a fill-in."""
    jobs: dict[tuple[str, int], list[Candidate]] = {}
    for part in parts:
        for scene in part.scenes:
            if scene.reason is None:
                candidate = Candidate(
                    scene_id=scene.scene_id,
                    collided=bool(scene.collision),
                    shown=not scene.meaning_failures,
                    avoidable=scene.avoidable,
                    overall_score=scene.metrics["overall_score"],
                    crash_type=scene.crash_type,
                    waits=scene.waits,
                    happened=scene.happened != Happening.NOTHING,
                    near=scene.gap_in_time,
                    cut=scene.cut,
                    touch=scene.touch,
                    distance=scene.criticality.get("distance"),
                )
                jobs.setdefault((part.scenario_id, part.route), []).append(candidate)
    return {
        s.scene_id: s.fill_in
        for candidates in jobs.values()
        for s in select(
            candidates, count=settings.keep, selection=settings.selection, avoidable_only=settings.avoidable_only
        )
    }
