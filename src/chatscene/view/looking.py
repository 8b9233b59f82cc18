"""What a page shows of runs: a list of all below a folder, two beside each other, the still of the best scene."""

from __future__ import annotations

import base64
from collections import Counter, defaultdict
from collections.abc import Iterable, Mapping
from functools import lru_cache
from pathlib import Path
from statistics import median
from typing import Any

from chatscene import runs
from chatscene.errors import RunError
from chatscene.measure.score import wilson
from chatscene.measure.severity import in_kmh
from chatscene.report.animation import still as still_of
from chatscene.report.index import Index, index, name_of
from chatscene.report.stated import lines_changed
from chatscene.report.viewer import best
from chatscene.runs.workspace import RECORD
from chatscene.view.below import COVERAGE, REPORT, run_below

Row = Mapping[str, Any]

_ASKED = ("text", "ego", "map", "seed", "sampler", "simulator", "physics", "version")
_NOT_COMPARED = ("run", "scenario_id")


def listed(folder: Path) -> dict[str, Any]:
    """All runs below a folder, the pages about several of them, and what was left out and why; of no folder, nothing.

    Raises:
        RunError: It cannot be read.
    """
    coverages = [_page(folder, file, "coverage", "What of catalogues is served") for file in _below(folder, COVERAGE)]
    if not _below(folder, RECORD):
        return {"runs": [], "pages": coverages, "left_out": []}
    found = index(folder)
    facts = _by_run(found, "facts")
    scenes = found.scenes(("status", "avoidable", "fault"))
    evaluations = [
        _page(folder, path / REPORT, "evaluation", _compared(record))
        for path, record in found.evaluations.items()
        if (path / REPORT).is_file()
    ]
    return {
        "runs": [_line(run, facts[run["run"]], scenes.get(run["run"], ())) for run in found.tables["runs"].to_pylist()],
        "pages": [*evaluations, *coverages],
        "left_out": [str(one) for one in found.left_out],
    }


def _below(folder: Path, name: str) -> list[Path]:
    """The files of a name below a folder, in the order of their paths; none if there is no such folder."""
    return sorted(folder.rglob(name)) if folder.is_dir() else []


def _compared(record: runs.EvaluationRecord | runs.ComparisonRecord) -> str:
    """What an evaluation compares, in a line."""
    if isinstance(record, runs.ComparisonRecord):
        many = len(record.programs)
        egos = [*record.egos, *(["as-written"] if record.settings.get("as_written") else [])]
        return f"{', '.join(egos)} on {many} imported program{'s' * (many != 1)}"
    which = "every scene" if record.scenes is runs.Driven.EVERY else "kept scenes"
    return f"{', '.join(record.egos)} on {which} of {len(record.sources)} run{'s' * (len(record.sources) != 1)}"


def _page(folder: Path, page: Path, kind: str, title: str) -> dict[str, Any]:
    name = name_of(page.parent, folder)
    return {"name": name, "kind": kind, "title": title, "began": page.stat().st_mtime}


def _by_run(found: Index, table: str) -> dict[str, list[Row]]:
    rows: dict[str, list[Row]] = defaultdict(list)
    for row in found.tables[table].to_pylist():
        rows[row["run"]].append(row)
    return rows


def _line(run: Row, facts: list[Row], scenes: Iterable[Row]) -> dict[str, Any]:
    driven, avoidable, struck = 0, 0, Counter[str]()
    for row in scenes:
        if row["status"] == "ran":
            driven, avoidable = driven + 1, avoidable + (row["avoidable"] is True)
            struck.update([row["fault"]] if row["fault"] else [])
    folder = Path(run["folder"])
    return {
        "run": run["run"],
        "text": run["text"],
        "status": run["status"],
        "reason": run["reason"],
        "ego": run["ego"],
        "adversary": ", ".join(sorted({row["adversary"] for row in facts if row["adversary"]})),
        "ran": run["ran"],
        "collided": run["collided"],
        "off_road": run["off_road"],
        "avoidable": avoidable if run["status"] == "done" else None,
        "kept": run["selected"],
        "struck": dict(struck),
        "report": (folder / REPORT).is_file(),
        "still": driven > 0,
        "began": (folder / RECORD).stat().st_mtime,
    }


def compared(folder: Path, first: str, second: str) -> dict[str, Any]:
    """Two runs beside each other: what was asked, what was read, what came of it, and the lines of their programs.

    Raises:
        RunError: There is no such run, or it is damaged.
    """
    folders = [run_below(folder, name) for name in (first, second)]
    told = [_told(one) for one in folders]
    groups: list[dict[str, Any]] = []
    for title in told[0]:
        names = list(dict.fromkeys(name for one in told for name in one[title]))
        rows = [{"name": name, "values": [one[title].get(name, "") for one in told]} for name in names]
        groups.append({"title": title, "rows": rows})
    before, after = ("\n".join(runs.read_programs(runs.Workspace(one)).values()) for one in folders)
    return {"groups": groups, "difference": list(lines_changed(before, after))}


def _told(folder: Path) -> dict[str, dict[str, str]]:
    found = index(folder)
    if found.left_out:
        raise RunError(str(found.left_out[0]))
    (run,), facts = found.tables["runs"].to_pylist(), found.tables["facts"].to_pylist()
    scenes = found.scenes(_COUNTED)
    driven = [row for row in scenes.get(run["run"], ()) if row["status"] == "ran"]
    return {
        "asked": {name: str(run[name]) for name in _ASKED if run[name] not in (None, "")},
        "read": {
            name.replace("_", " "): ", ".join(value) if isinstance(value, list) else str(value)
            for row in facts[:1]
            for name, value in row.items()
            if name not in _NOT_COMPARED and value not in (None, [], 0)
        },
        "came to": _came_to(run, driven),
    }


_COUNTED = ("status", "collision", "avoidable", "selected", "meaning_ok", "impact_speed", "fault")
_ENDED = {"off_road": "left the road", "timeout": "ran out of time", "waiting": "waited behind somebody to the end"}


def _came_to(run: Row, driven: list[Row]) -> dict[str, str]:
    if not driven:
        return {"scenes driven": "0"}
    hits = [row for row in driven if row["collision"]]
    low, high = wilson(len(hits), len(driven))
    told = {
        "scenes driven": str(len(driven)),
        "collided": f"{len(hits)} ({len(hits) / len(driven):.0%}, 95 % interval {low:.0%} to {high:.0%})",
        "avoidable": str(sum(row["avoidable"] is True for row in driven)),
        "kept": str(sum(row["selected"] for row in driven)),
        "show all that was read": str(sum(row["meaning_ok"] for row in driven)),
    }
    told |= {words: str(run[name]) for name, words in _ENDED.items() if run[name] is not None}
    if hits:
        told["median impact speed"] = in_kmh(median(row["impact_speed"] for row in hits))
    for fault, count in sorted(Counter(row["fault"] for row in hits if row["fault"]).items()):
        told[fault.replace("-", " ")] = str(count)
    return told


def still(folder: Path, name: str) -> dict[str, Any]:
    """A small picture of the decisive moment of a run's best scene: WebP, in base 64.

    Raises:
        RunError: There is no such run, it is damaged, or none of its scenes was driven.
    """
    path = run_below(folder, name)
    return {"webp": _still(path, (path / RECORD).stat().st_mtime_ns)}


@lru_cache(maxsize=1000)
def _still(folder: Path, _written: int) -> str:
    """The picture; drawn again once the record is another."""
    run = runs.open_run(folder, runs.RunRecord)
    first = best(run)
    if first is None:
        raise RunError(f"no scene of {folder} was driven")
    picture = still_of(runs.read_episode(run, first["scene_id"]), runs.read_drawing(run))
    return base64.b64encode(picture).decode()
