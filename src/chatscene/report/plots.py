"""Small plots of a parameter, as its template draws them: how its ranges moved, and what came of its values.

Lengths are in pixels.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from chatscene.measure.severity import KMH, in_kmh
from chatscene.report.measures import scene_label

Row = Mapping[str, Any]
Plot = dict[str, Any]

WIDTH, LEFT, RIGHT, TOP, PITCH = 360, 22, 12, 8, 26
HARDEST, LINE, BOTTOM = 10.0, 86.0, 132.0  # hardest impact, contact, widest gap
WIDEST = 10.0  # [m] of gap at the lower edge; whoever stayed further away lies there too


def plot_ranges(parameter: str, ranges: Sequence[Row], scenes: Sequence[Row]) -> Plot:
    """One parameter of one scenario and route: a row per block, with its range and its scenes."""
    blocks = sorted(ranges, key=lambda row: row["block"])
    low, high = _axis(blocks)

    def bar(row: Row) -> dict[str, Any]:
        start, end = _at(row["low"], low, high), _at(row["high"], low, high)
        own = [scene for scene in scenes if scene["block"] == row["block"] and scene.get(parameter) is not None]
        return {
            "block": row["block"] + 1,
            "y": TOP + PITCH * (row["block"] + 0.5),
            "start": start,
            "width": max(end - start, 2),
            "title": f"block {row['block'] + 1}: {row['low']:.4g} to {row['high']:.4g}",
            "dots": [_dot(one, parameter, low, high, one["ending"]) for one in _collided_last(own)],
        }

    return {
        "label": f"{parameter}: range and scenes in {len(blocks)} blocks",
        "width": WIDTH,
        "left": LEFT,
        "right": WIDTH - RIGHT,
        "bottom": TOP + PITCH * len(blocks),
        "low": f"{low:.4g}",
        "high": f"{high:.4g}",
        "rows": [bar(row) for row in blocks],
    }


def plot_outcomes(parameter: str, ranges: Sequence[Row], scenes: Sequence[Row]) -> Plot:
    """One parameter of one scenario over all routes: collisions above the line of contact, misses below."""
    blocks = sorted(ranges, key=lambda row: row["block"])
    low, high = _axis(blocks)
    last = [row for row in blocks if row["block"] == blocks[-1]["block"]]
    start = _at(min(row["low"] for row in last), low, high)
    end = _at(max(row["high"] for row in last), low, high)
    own = [row for row in scenes if row.get(parameter) is not None]
    hardest = max(1.0, *(row["impact_speed"] or 0.0 for row in own)) if own else 1.0

    def point(row: Row) -> dict[str, Any]:
        impact = row["impact_speed"] or 0.0
        if row["collision"]:
            y, said = LINE - (LINE - HARDEST) * impact / hardest, f"impact at {in_kmh(impact)}"
        elif (gap := row.get("distance")) is None:
            y, said = BOTTOM, row["ending"]
        else:
            y, said = LINE + (BOTTOM - LINE) * min(gap / WIDEST, 1.0), f"missed by {gap:.1f} m"
        return _dot(row, parameter, low, high, said) | {"scene": row["scene_id"], "y": round(y, 1)}

    return {
        "label": f"{parameter}: what came of {len(own)} scenes",
        "low": f"{low:.4g}",
        "high": f"{high:.4g}",
        "hardest": f"{KMH * hardest:.0f}",
        "start": start,
        "width": max(round(end - start, 1), 2.0),
        "points": [point(row) for row in _collided_last(own)],
    }


def _axis(blocks: Sequence[Row]) -> tuple[float, float]:
    """The declared range, or something around it if it is a single value."""
    low, high = blocks[0]["low"], blocks[0]["high"]
    return (low, high) if high > low else (low - 0.5, low + 0.5)


def _at(value: float, low: float, high: float) -> float:
    share = min(max((value - low) / (high - low), 0.0), 1.0)
    return round(LEFT + share * (WIDTH - LEFT - RIGHT), 1)


def _collided_last(scenes: Sequence[Row]) -> list[Row]:
    return sorted(scenes, key=lambda row: bool(row["collision"]))  # so that collisions are on top


def _dot(row: Row, parameter: str, low: float, high: float, said: str) -> dict[str, Any]:
    return {
        "kind": ("hit" if row["collision"] else "miss") + (" kept" if row["selected"] else ""),
        "x": _at(row[parameter], low, high),
        "title": f"{scene_label(row['scene_id'])}: {row[parameter]:.4g}, {said}",
    }
