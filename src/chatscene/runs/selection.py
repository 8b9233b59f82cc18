"""Step 7 of 9 on what lies in a run folder."""

from __future__ import annotations

from collections.abc import Iterable
from itertools import groupby

from chatscene.runs.rows import Part, SceneRow
from chatscene.search.select import Candidate, select
from chatscene.settings import SearchSettings
from chatscene.terms.criticality import Happening


def selected(parts: Iterable[Part], settings: SearchSettings) -> dict[str, bool]:
    """Step 7 for every scenario and route of blocks in order: scene id to whether it is a fill-in."""
    return {
        s.scene_id: s.fill_in
        for _, of_route in groupby(parts, key=lambda part: (part.scenario_id, part.route))
        for s in select(
            (_candidate(scene) for part in of_route for scene in part.scenes if scene.reason is None),
            count=settings.keep,
            selection=settings.selection,
            avoidable_only=settings.avoidable_only,
        )
    }


def _candidate(scene: SceneRow) -> Candidate:
    return Candidate(
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
