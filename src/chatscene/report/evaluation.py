"""`report.html` of an evaluation: egos side by side, as one page that needs nothing but a browser."""

from __future__ import annotations

import math
import os
from collections.abc import Mapping, Sequence
from pathlib import Path
from statistics import median
from typing import Any
from urllib.parse import quote

from chatscene.ego.policy import in_words
from chatscene.errors import RunError
from chatscene.measure.score import score, wilson
from chatscene.measure.severity import in_kmh
from chatscene.report.measures import scene_label
from chatscene.report.templates import asset, fill, policy, scripts
from chatscene.runs import EvaluationRecord, RunRecord, Workspace, measurements_of, note, read_record, read_scenes
from chatscene.runs.atomic import write_bytes
from chatscene.runs.record import SourceRecord
from chatscene.terms.criticality import Fault
from chatscene.terms.metrics import Mode

Row = Mapping[str, Any]


def write_evaluation(run: Workspace) -> Path:
    """Write `report.html` into the folder of an evaluation whose scenes were driven.

    Returns:
        The path of the page: one file, no requests, works from ``file://``. It links the reports of the runs that the
        scenes are from, where these have one.

    Raises:
        RunError: The folder cannot be read or written.
    """
    record = read_record(run, EvaluationRecord)
    script = scripts("sort", "table", "evaluation")
    driven = [row for row in read_scenes(run) if row["status"] == "ran"]
    situations = [_situation(run, number, source) for number, source in enumerate(record.sources, 1)]
    fared = _each_fared(record, driven)
    egos = [one["ego"] for one in fared]
    scenes = _scenes(driven, situations)
    maps = list(dict.fromkeys(source.map_name for source in record.sources))
    page = fill(
        "evaluation.html",
        title=", ".join(egos),
        policy=policy(script),
        style=asset("viewer.css") + asset("evaluation.css"),
        script=script,
        egos=egos,
        fared=fared,
        failures=record.failures,
        drives=len(driven),
        rejected=record.counts.get("rejected", 0),
        scenes=scenes,
        several_maps=len(maps) > 1,
        situations=[one | {"collided": _collided(scenes, one["number"], len(egos))} for one in situations],
        pairs=_pairs(scenes, len(egos)),
        facts={
            ("Maps" if len(maps) > 1 else "Map"): ", ".join(maps),
            "Scenes": "all that were driven" if record.scenes == "every" else "those that were kept",
            "Simulator": f"{record.simulator.name}, {record.simulator.physics}",
            "Versions": ", ".join(f"{name} {number}" for name, number in record.versions.items()),
        },
    )
    path = run.file("report.html")
    write_bytes(path, page.encode())
    note(run, path)
    return path


def fared_in(run: Workspace) -> list[dict[str, Any]]:
    """How each ego of an evaluation fared, a row per ego: counts, shares in percent, speeds [m/s], overall score.

    Raises:
        RunError: The folder cannot be read.
    """
    return _each_fared(read_record(run, EvaluationRecord), [row for row in read_scenes(run) if row["status"] == "ran"])


def fared_in_words(fared: Sequence[Row]) -> str:
    """A line per ego, below the names of its figures."""
    names = ("ego", "collided", "95 % interval", "a careful driver avoids", "ran into somebody", "hardest", "completed")
    told = [names, *(_line(one) for one in fared)]
    widths = [max(len(line[i]) for line in told) for i in range(len(names))]
    lines = ["  ".join(text.ljust(width) for text, width in zip(line, widths, strict=True)).rstrip() for line in told]
    if any(one["collided"] for one in fared):
        lines.append("the careful driver is that of UN R157; a driver that brakes earlier may avoid more")
    if any(one["by_selection"] for one in fared):
        lines.append(
            "by selection: the scenes were kept because of this ego's results, so they say nothing about how good it is"
        )
    return "\n".join(lines)


def _line(one: Row) -> tuple[str, ...]:
    hits = one["collided"]
    return (
        one["ego"],
        f"{hits} of {one['drives']}",
        "by selection" if one["by_selection"] else f"{one['low']:.0f} % to {one['high']:.0f} %",
        f"{one['avoidable']} of {hits}" if hits else "",
        f"{one['struck']} of {hits}" if hits else "",
        "" if one["hardest"] is None else in_kmh(one["hardest"]),
        f"{one['completion']:.0f} %",
    )


def _each_fared(record: EvaluationRecord, driven: Sequence[Row]) -> list[dict[str, Any]]:
    kept_for = {source.scenario_id: source.kept_for for source in record.sources}
    own = [[row for row in driven if row["block"] == number] for number in range(len(record.egos))]
    return [
        fared_of(
            ego,
            in_words(record.senses.get(ego, {})),
            rows,
            by_selection=sum(kept_for[row["scenario_id"]] == ego for row in rows),
        )
        for ego, rows in zip(record.egos, own, strict=True)
        if rows
    ]


def _situation(run: Workspace, number: int, source: SourceRecord) -> dict[str, Any]:
    """A run that scenes are from: what it was asked for, and where its report is, if it has one."""
    folder = source.path_from(run.path)
    try:
        text = read_record(Workspace(folder), RunRecord).title
    except RunError:
        text = source.scenario_id  # it is not there any more
    report = folder / "report.html"
    link = quote(Path(os.path.relpath(report, run.path.resolve())).as_posix()) if report.is_file() else ""
    return {
        "number": number,
        "scenario_id": source.scenario_id,
        "text": text,
        "link": link,
        "ego": source.kept_for,
        "map": source.map_name,
    }


def fared_of(ego: str, senses: str, rows: Sequence[Row], *, by_selection: int = 0) -> dict[str, Any]:
    """How an ego fared in all its drives."""
    crashes = [row for row in rows if row["collision"]]
    impacts = [row["impact_speed"] for row in crashes]
    kinds = {row["crash_type"] for row in crashes}
    low, high = wilson(len(crashes), len(rows))
    return {
        "ego": ego,
        "senses": senses,
        "drives": len(rows),
        "collided": len(crashes),
        "rate": 100 * len(crashes) / len(rows),
        "low": 100 * low,
        "high": 100 * high,
        "by_selection": by_selection,
        "avoidable": sum(row["avoidable"] is True for row in crashes),
        "struck": sum(Fault(row["fault"]).by_ego for row in crashes),
        "kinds": None if None in kinds else len(kinds),  # folders did not always keep them
        "median": median(impacts) if impacts else None,
        "hardest": max(impacts, default=None),
        "completion": 100 * math.fsum(measurements_of(row).completion for row in rows) / len(rows),
        "score": score([measurements_of(row) for row in rows], mode=Mode.CORRECTED).overall_score,
    }


def _scenes(driven: Sequence[Row], situations: Sequence[Row]) -> list[dict[str, Any]]:
    """Each scene with what became of it under each ego that drove any; those first in which most egos collide."""
    there = sorted({row["block"] for row in driven})
    by_scene: dict[str, dict[int, Row]] = {}
    for row in driven:
        by_scene.setdefault(row["scene_id"], {})[row["block"]] = row
    told = {one["scenario_id"]: one for one in situations}
    scenes: list[dict[str, Any]] = []
    for scene_id, rows in by_scene.items():
        collided = [bool(row["collision"]) for row in rows.values()]
        situation = told[next(iter(rows.values()))["scenario_id"]]
        link = f"{situation['link']}#{quote(scene_id)}" if situation["link"] else ""
        scenes.append(
            {
                "id": scene_id,
                "label": scene_label(scene_id),
                "situation": situation["number"],
                "link": link,
                "fails": sum(collided),
                "differ": 0 < sum(collided) < len(collided),
                "drives": [rows.get(number) for number in there],
            }
        )
    return sorted(scenes, key=lambda scene: (-scene["fails"], scene["situation"], scene["id"]))


def _collided(scenes: Sequence[Row], situation: int, egos: int) -> list[tuple[int, int]]:
    """In how many scenes of a situation each ego collides, and how many it drove."""
    own = [scene for scene in scenes if scene["situation"] == situation]
    drives = [[scene["drives"][ego] for scene in own if scene["drives"][ego]] for ego in range(egos)]
    return [(sum(bool(row["collision"]) for row in rows), len(rows)) for rows in drives]


def _pairs(scenes: Sequence[Row], egos: int) -> list[list[tuple[int, int] | None]]:
    """For each two egos, of the scenes that both drove, in how many the first collides and the second does not."""

    def alone(one: int, other: int) -> tuple[int, int]:
        both = [(a, b) for scene in scenes if (a := scene["drives"][one]) and (b := scene["drives"][other])]
        return sum(bool(a["collision"]) and not b["collision"] for a, b in both), len(both)

    return [[None if one == other else alone(one, other) for other in range(egos)] for one in range(egos)]
