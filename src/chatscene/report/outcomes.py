"""What came of each value of a parameter: one small plot per parameter, collisions above the line and misses below."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from chatscene.measure.severity import KMH, in_kmh
from chatscene.report.measures import scene_label
from chatscene.report.ranges import at, axis

Row = Mapping[str, Any]

TOP, LINE, BOTTOM = 10.0, 86.0, 132.0  # [px]: hardest impact, contact, widest gap
WIDEST = 10.0  # [m] of gap at the lower edge; whoever stayed further away lies there too


@dataclass(frozen=True, slots=True, kw_only=True)
class Point:
    """A scene.

    Attributes:
        scene: Its id.
        kind: Its classes: ``hit`` or ``miss``, and ``kept``.
        x: By the value of the parameter [px].
        y: By what came of it [px].
        title: What it says of itself.
    """

    scene: str
    kind: str
    x: float
    y: float
    title: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Outcomes:
    """One parameter against what came of it.

    Attributes:
        label: What it shows, in words.
        low: Lower end of the declared range.
        high: Upper end.
        hardest: Impact at the upper edge [km/h].
        start: Left end of what the last block was drawn from [px].
        width: Of that [px].
        points: The scenes; those that collided are last, so that they are on top.
    """

    label: str
    low: str
    high: str
    hardest: str
    start: float
    width: float
    points: tuple[Point, ...]


def plot_outcomes(parameter: str, ranges: Sequence[Row], scenes: Sequence[Row]) -> Outcomes:
    """One parameter of one scenario over all routes."""
    blocks = sorted(ranges, key=lambda row: row["block"])
    low, high = axis(blocks)
    last = [row for row in blocks if row["block"] == blocks[-1]["block"]]
    start = at(min(row["low"] for row in last), low, high)
    end = at(max(row["high"] for row in last), low, high)
    own = [row for row in scenes if row.get(parameter) is not None]
    hardest = max(1.0, *(row["impact_speed"] or 0.0 for row in own)) if own else 1.0
    return Outcomes(
        label=f"{parameter}: what came of {len(own)} scenes",
        low=f"{low:.4g}",
        high=f"{high:.4g}",
        hardest=f"{KMH * hardest:.0f}",
        start=start,
        width=max(round(end - start, 1), 2.0),
        points=tuple(
            _point(row, parameter, low, high, hardest) for row in sorted(own, key=lambda row: bool(row["collision"]))
        ),
    )


def _point(row: Row, parameter: str, low: float, high: float, hardest: float) -> Point:
    if row["collision"]:
        y, said = (
            LINE - (LINE - TOP) * (row["impact_speed"] or 0.0) / hardest,
            f"impact at {in_kmh(row['impact_speed'] or 0.0)}",
        )
    elif (gap := row.get("distance")) is None:
        y, said = BOTTOM, row["ending"]
    else:
        y, said = LINE + (BOTTOM - LINE) * min(gap / WIDEST, 1.0), f"missed by {gap:.1f} m"
    return Point(
        scene=row["scene_id"],
        kind=("hit" if row["collision"] else "miss") + (" kept" if row["selected"] else ""),
        x=at(row[parameter], low, high),
        y=round(y, 1),
        title=f"{scene_label(row['scene_id'])}: {row[parameter]:.4g}, {said}",
    )
