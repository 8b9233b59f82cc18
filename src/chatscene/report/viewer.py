"""`report.html`: a run as one page that needs nothing but a browser."""

from __future__ import annotations

import base64
import hashlib
import json
import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from chatscene.report import sections
from chatscene.report.egos import egos_in_words
from chatscene.report.measures import in_words
from chatscene.report.surroundings import surroundings_in_words
from chatscene.report.templates import asset, fill, fill_section
from chatscene.report.tracks import Box, extent, pack_drawing, pack_episode, size_of
from chatscene.runs import (
    RunRecord,
    Workspace,
    criticality_of,
    metrics_of,
    note,
    open_run,
    read_drawing,
    read_episodes,
    read_explanation,
    read_programs,
    read_ranges,
    read_record,
    read_scenes,
)
from chatscene.runs.atomic import write_bytes
from chatscene.terms.actors import BY_CLASS

if TYPE_CHECKING:
    from markupsafe import Markup

REPLAY_BYTES = 1_900_000  # of tracks on one page; the page stays under 3 MB with its map


def write_report(folder: Path) -> Path:
    """Write `report.html` into a run folder, finished or not.

    Args:
        folder: The run folder.

    Returns:
        The path of the page: one file, no requests, works from ``file://``.

    Raises:
        RunError: The folder is not a run, or cannot be read or written.
    """
    run = open_run(folder, RunRecord)
    path = run.file("report.html")
    write_bytes(path, _page(run).encode())
    note(run, path)
    return path


def ranked(scenes: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """The driven scenes: selected ones first, then collisions, then what means what was said, then by score."""

    def rank(row: Mapping[str, Any]) -> tuple[bool, bool, bool, float, str]:
        score = row["overall_score"]
        unlike = (not row["selected"], not row["collision"], not row["meaning_ok"])
        return *unlike, 1.0 if score is None else score, row["scene_id"]

    return sorted((row for row in scenes if row["status"] == "ran"), key=rank)


def _page(run: Workspace) -> str:
    record, scenes, ranges = read_record(run), read_scenes(run), read_ranges(run)
    explanation = read_explanation(run)
    order = ranked(scenes)
    replays, boxes = _replays(run, order)
    units = {row["parameter"]: row["unit"] for row in ranges}
    content = {
        "scenes": [_shown(row, replays[row["scene_id"]]) for row in order if row["scene_id"] in replays],
        "map": pack_drawing(read_drawing(run), boxes),
        "manners": {name: kind.row.manner for name, kind in BY_CLASS.items()},
        "ego": record.ego,
        "called": {actor["kind"]: _called(actor["kind"]) for drive in replays.values() for actor in drive["actors"]},
    }
    script = asset("viewer.js")
    return fill(
        "viewer.html",
        title=record.title,
        policy=_policy(script),
        style=asset("viewer.css"),
        script=script,
        content=_json(content),
        heading=sections.heading(record, explanation, _around(run, order)),
        verdict=sections.verdict(scenes, egos_in_words(record)[0], read=bool(sections.facts_of(explanation))),
        left_out=fill_section("left_out", len(replays), len(order)) if len(replays) < len(order) else "",
        scenes=sections.scene_table(order, units, replays),
        understanding=sections.understanding(explanation),
        programs=sections.programs(read_programs(run)),
        refinement=sections.refinement(ranges, scenes),
        rejections=sections.rejections(scenes),
        provenance=sections.provenance(record),
    )


def _around(run: Workspace, order: Sequence[Mapping[str, Any]]) -> str:
    """Light, weather and road of the scenes that were driven."""
    first = next(iter(read_episodes(run, [row["scene_id"] for row in order[:1]])), None)
    return surroundings_in_words(first.surroundings) if first else ""


def _replays(run: Workspace, order: Sequence[Mapping[str, Any]]) -> tuple[dict[str, dict[str, Any]], list[Box]]:
    """Packed drives, best scenes first, until the page is full; and the part of the map that they need."""
    packed: dict[str, dict[str, Any]] = {}
    boxes: list[Box] = []
    left = REPLAY_BYTES
    for episode in read_episodes(run, [row["scene_id"] for row in order]):
        drive = pack_episode(episode)
        left -= size_of(drive)
        if left < 0 and packed:
            break
        packed[episode.scene_id] = drive
        boxes.append(extent(episode))
    return packed, boxes


def _shown(row: Mapping[str, Any], drive: dict[str, Any]) -> dict[str, Any]:
    """What the replay shows of a scene beside its drive."""
    return {
        "id": row["scene_id"],
        "label": sections.scene_label(row["scene_id"]),
        "route": f"{row['scenario_id']}/{row['route_id']}",
        "ending": row["ending"],
        "collision": row["collision"],
        "impact": row["impact_speed"],
        "avoidable": row["avoidable"],
        "kept": row["selected"],
        "metrics": in_words(metrics_of(row) | criticality_of(row)),
        "drive": drive,
    }


def _called(kind: str) -> str:
    """What a road user or a thing is called, by its class: ``Pedestrian`` a pedestrian, ``BusStop`` a bus stop."""
    return BY_CLASS[kind].noun if kind in BY_CLASS else re.sub(r"(?<=[a-z])(?=[A-Z])", " ", kind).lower()


def _json(content: object) -> Markup:
    """Data for a script: escaped as a script's text is, which no entity in it would be."""
    from markupsafe import Markup

    text = json.dumps(content, separators=(",", ":"), ensure_ascii=False)
    return Markup(text.replace("<", "\\u003c"))


def _policy(script: str) -> Markup:
    """Content security policy: this one script, inline styles, nothing from anywhere else."""
    from markupsafe import Markup

    digest = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()
    words = f"default-src 'none'; script-src 'sha256-{digest}'; style-src 'unsafe-inline'; img-src data:"
    return Markup(words)
