"""`report.html`: a run as one page that needs nothing but a browser."""

from __future__ import annotations

import base64
import json
import zlib
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from chatscene.errors import ChatSceneError
from chatscene.exports.export import kept_scenes
from chatscene.exports.exporter import load_exporter
from chatscene.report import sections
from chatscene.report.egos import egos_in_words
from chatscene.report.how_fast import harm_in_words, how_fast, scene_in_words
from chatscene.report.measures import in_words, scene_label
from chatscene.report.surroundings import surroundings_in_words
from chatscene.report.templates import asset, fill, fill_section, policy, scripts
from chatscene.report.tracks import Box, called, extent, met, pack_beside, pack_drawing, pack_episode, size_of
from chatscene.report.what_happened import outcome_in_words
from chatscene.runs import (
    RunRecord,
    Workspace,
    criticality_of,
    each_scene,
    metrics_of,
    note,
    open_run,
    read_counts,
    read_drawing,
    read_episodes,
    read_explanation,
    read_programs,
    read_ranges,
    read_record,
    read_scenes,
    speeds_of,
)
from chatscene.runs.atomic import write_bytes
from chatscene.runs.beside import Beside, drive_beside
from chatscene.terms.actors import BY_CLASS
from chatscene.terms.episode import Episode, Role

if TYPE_CHECKING:
    from markupsafe import Markup

REPLAY_BYTES = 1_600_000  # of tracks on one page; the page stays under 3 MB with its map and files
SCRIPTS = (
    "unpack",
    "draw",
    "labels",
    "chart",
    "camera",
    "words",
    "overview",
    "sort",
    "table",
    "files",
    "hands",
)  # of page/


def write_report(folder: Path, *, followed: bool = False) -> Path:
    """Write `report.html` into a run folder, finished or not.

    Args:
        folder: The run folder.
        followed: Whether the user named what the run names, so that the page may have its kept scenes driven again
            with it (`chatscene.runs.beside`); else that is done only where everything is packaged.

    Returns:
        The path of the page: one file, no requests, works from ``file://``.

    Raises:
        RunError: The folder is not a run, or cannot be read or written.
    """
    run = open_run(folder, RunRecord)
    path = run.file("report.html")
    write_bytes(path, _page(run, followed=followed).encode())
    note(run, path)
    return path


_RANKED_BY = ("scene_id", "status", "selected", "collision", "meaning_failures", "overall_score")


def ranked(scenes: Sequence[Mapping[str, Any]]) -> list[Mapping[str, Any]]:
    """The driven scenes: selected ones first, then what shows most of what was said, then collisions, then by score."""
    return sorted((row for row in scenes if row["status"] == "ran"), key=_rank)


def best(run: Workspace) -> Mapping[str, Any] | None:
    """The first of the driven scenes, as they are ranked, of a run with any number of them; None if none was driven."""
    if kept := ranked(read_scenes(run, selected=True)):
        return kept[0]
    driven = (row for row in each_scene(run, _RANKED_BY) if row["status"] == "ran")
    first = min(driven, key=_rank, default=None)
    return None if first is None else read_scenes(run, ids=[first["scene_id"]])[0]


def _rank(row: Mapping[str, Any]) -> tuple[bool, int, bool, float, str]:
    score = row["overall_score"]
    unlike = (not row["selected"], len(row["meaning_failures"] or ()), not row["collision"])
    return *unlike, 1.0 if score is None else score, row["scene_id"]


def _page(run: Workspace, *, followed: bool) -> str:
    record, scenes, ranges = read_record(run), read_scenes(run, some=True), read_ranges(run)
    explanation, every = read_explanation(run), read_counts(run)["scenes"]
    order = ranked(scenes)
    kept = [row for row in order if row["selected"]]
    beside = drive_beside(run, kept, followed=followed)
    replays, boxes = _replays(run, order, beside)
    shown = [row for row in order if row["scene_id"] in replays]
    numbers, measures = _numbers(shown)
    units = {row["parameter"]: row["unit"] for row in ranges}
    content = {
        "scenes": [_shown(row, own, replays[row["scene_id"]]) for row, own in zip(shown, numbers, strict=True)],
        "measures": measures,
        "files": pack_files(run.path, [row["scene_id"] for row in kept]),
        "formats": FORMATS,
        "map": pack_drawing(read_drawing(run), boxes),
        "manners": {name: kind.row.manner for name, kind in BY_CLASS.items()},
        "ego": record.ego,
        "beside": {"ego": beside.ego, "senses": beside.senses},
        "called": _called(replays.values()),
    }
    script = scripts(*SCRIPTS)
    return fill(
        "viewer.html",
        title=record.title,
        policy=policy(script),
        style=asset("viewer.css"),
        script=script,
        content=_json(content),
        heading=sections.heading(record, explanation, _around(run, order)),
        verdict=sections.verdict(scenes, read_counts(run), read=bool(sections.facts_of(explanation))),
        fast=fill_section("fast", told) if (told := how_fast(scenes)) else "",
        some=fill_section("some", len(scenes), every) if len(scenes) < every else "",
        left_out=fill_section("left_out", len(replays), len(order)) if len(replays) < len(order) else "",
        senses=egos_in_words(record)[0],
        beside=sections.beside(beside, kept),
        tiles=sections.tiles(scenes),
        outcomes=sections.outcomes(ranges, order),
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


def _replays(
    run: Workspace, order: Sequence[Mapping[str, Any]], beside: Beside
) -> tuple[dict[str, dict[str, Any]], list[Box]]:
    """Packed drives, best scenes first, until the page is full; and the part of the map that they need."""
    packed: dict[str, dict[str, Any]] = {}
    boxes: list[Box] = []
    left = REPLAY_BYTES
    for episode in read_episodes(run, [row["scene_id"] for row in order]):
        drive = pack_episode(episode)
        if (ghost := beside.drives.get(episode.scene_id)) is not None:
            drive["ghost"] = pack_beside(ghost, episode) | {"came": _came(ghost)}
        if (story := beside.stories.get(episode.scene_id)) is not None:
            drive["story"] = {"said": story.said, "marks": [[mark.step, mark.said] for mark in story.marks]}
        left -= size_of(drive)
        if left < 0 and packed:
            break
        packed[episode.scene_id] = drive
        boxes.append(extent(episode))
    return packed, boxes


def _came(episode: Episode) -> str:
    """How a drive ended that is shown beside another."""
    crash = episode.collision
    if crash is None:
        return "does not collide"
    struck = met(episode)
    name = called(struck.role, struck.kind) if struck else crash.other
    return f"collides with the {name} at {crash.step * episode.dt:.1f} s"


def _called(drives: Iterable[Mapping[str, Any]]) -> dict[str, dict[str, str]]:
    """What everybody in some drives is called, by role and kind."""
    told: dict[str, dict[str, str]] = {}
    for actor in (actor for drive in drives for actor in drive["actors"]):
        told.setdefault(actor["role"], {})[actor["kind"]] = called(Role(actor["role"]), actor["kind"])
    return told


def _numbers(rows: Sequence[Mapping[str, Any]]) -> tuple[list[list[tuple[int, str]]], list[tuple[str, str]]]:
    """The numbers of each scene: which of the measures, and its value; and the measures, with what they say of it."""
    measures: dict[tuple[str, str], int] = {}
    numbers = [
        [(measures.setdefault((one["name"], one["note"]), len(measures)), one["value"]) for one in in_words(told)]
        for told in (metrics_of(row) | criticality_of(row) | speeds_of(row) for row in rows)
    ]
    return numbers, list(measures)


def _shown(row: Mapping[str, Any], numbers: list[tuple[int, str]], drive: dict[str, Any]) -> dict[str, Any]:
    """What the replay shows of a scene beside its drive."""
    return {
        "id": row["scene_id"],
        "label": scene_label(row["scene_id"]),
        "route": f"{row['scenario_id']}/{row['route_id']}",
        "ending": outcome_in_words(row),
        "collision": row["collision"],
        "impact": row["impact_speed"],
        "began": scene_in_words(row),
        "harm": harm_in_words(row),
        "avoidable": row["avoidable"],
        "kept": row["selected"],
        "distance": row.get("distance"),
        "numbers": numbers,
        "drive": drive,
    }


def _json(content: object) -> Markup:
    """Data for a script: escaped as a script's text is, which no entity in it would be."""
    from markupsafe import Markup

    text = json.dumps(content, separators=(",", ":"), ensure_ascii=False)
    return Markup(text.replace("<", "\\u003c"))


# Kept scenes as the files of other tools, small enough to lie in a page


FORMATS = {"scenic": "Scenic", "openscenario": "OpenSCENARIO", "csv": "CSV"}  # exporters, and what they are called
FILES_BYTES = 400_000  # of files on one page


def pack_files(folder: Path, scene_ids: Sequence[str]) -> dict[str, str]:
    """Scenes of a run as `chatscene export` writes them, without the map, as compressed text.

    Returns:
        By scene: base 64 of what zlib makes of a JSON object: by format the file's ``name`` and ``text``, or ``why``
        there is none.
    """
    packed: dict[str, str] = {}
    left = FILES_BYTES
    if not scene_ids:
        return packed
    exporters = {name: load_exporter(name) for name in FORMATS}
    try:
        scenes = {scene.episode.scene_id: scene for scene in kept_scenes(folder, scene_ids)}
    except ChatSceneError:
        return packed  # without the map the page has the command, which says what is the matter
    for scene_id in scene_ids:
        scene, files = scenes[scene_id], dict[str, dict[str, str]]()
        for name, exporter in exporters.items():
            try:
                made = exporter.files(scene)
            except ChatSceneError as error:
                files[name] = {"why": str(error)}
                continue
            (file,) = made.keys() - {scene.map.name}
            files[name] = {"name": file, "text": made[file].decode()}
        content = json.dumps(files, separators=(",", ":"), ensure_ascii=False).encode()
        text = base64.b64encode(zlib.compress(content, 9)).decode()
        left -= len(text)
        if left < 0:
            break
        packed[scene_id] = text
    return packed
