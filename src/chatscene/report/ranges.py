"""How the ranges moved from block to block: one small plot per parameter."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from chatscene.report.measures import scene_label

Row = Mapping[str, Any]

WIDTH, LEFT, RIGHT, TOP, PITCH = 360, 22, 12, 8, 26


@dataclass(frozen=True, slots=True, kw_only=True)
class Dot:
    """A scene.

    Attributes:
        kind: Its classes: ``hit`` or ``miss``, and ``kept``.
        x: Where it lies [px].
        title: What it says of itself.
    """

    kind: str
    x: float
    title: str


@dataclass(frozen=True, slots=True, kw_only=True)
class Bar:
    """A block: its range, and its scenes.

    Attributes:
        block: Its number, from 1.
        y: Its middle [px].
        start: Left end of the range [px].
        width: Of the range [px].
        title: What it says of itself.
        dots: Its scenes; those that collided are last, so that they are on top.
    """

    block: int
    y: float
    start: float
    width: float
    title: str
    dots: tuple[Dot, ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Plot:
    """One parameter of one scenario and route.

    Attributes:
        label: What it shows, in words.
        width: Of all of it [px].
        left: Left end of the declared range [px].
        right: Right end of the declared range [px].
        bottom: Lower end of the last row [px].
        low: Lower end of the declared range.
        high: Upper end of the declared range.
        rows: A row per block from the top.
    """

    label: str
    width: int
    left: int
    right: int
    bottom: int
    low: str
    high: str
    rows: tuple[Bar, ...]


def plot_ranges(parameter: str, ranges: Sequence[Row], scenes: Sequence[Row]) -> Plot:
    """One parameter of one scenario and route."""
    blocks = sorted(ranges, key=lambda row: row["block"])
    low, high = axis(blocks)
    return Plot(
        label=f"{parameter}: range and scenes in {len(blocks)} blocks",
        width=WIDTH,
        left=LEFT,
        right=WIDTH - RIGHT,
        bottom=TOP + PITCH * len(blocks),
        low=f"{low:.4g}",
        high=f"{high:.4g}",
        rows=tuple(_bar(row, parameter, low, high, scenes) for row in blocks),
    )


def axis(blocks: Sequence[Row]) -> tuple[float, float]:
    """The declared range, or something around it if it is a single value."""
    low, high = blocks[0]["low"], blocks[0]["high"]
    return (low, high) if high > low else (low - 0.5, low + 0.5)


def at(value: float, low: float, high: float) -> float:
    """Where a value lies between the ends of an axis [px]."""
    share = min(max((value - low) / (high - low), 0.0), 1.0)
    return round(LEFT + share * (WIDTH - LEFT - RIGHT), 1)


def _bar(row: Row, parameter: str, low: float, high: float, scenes: Sequence[Row]) -> Bar:
    start, end = at(row["low"], low, high), at(row["high"], low, high)
    own = [scene for scene in scenes if scene["block"] == row["block"] and scene.get(parameter) is not None]
    return Bar(
        block=row["block"] + 1,
        y=TOP + PITCH * (row["block"] + 0.5),
        start=start,
        width=max(end - start, 2),
        title=f"block {row['block'] + 1}: {row['low']:.4g} to {row['high']:.4g}",
        dots=tuple(_dot(scene, parameter, low, high) for scene in sorted(own, key=lambda s: bool(s["collision"]))),
    )


def _dot(scene: Row, parameter: str, low: float, high: float) -> Dot:
    return Dot(
        kind=("hit" if scene["collision"] else "miss") + (" kept" if scene["selected"] else ""),
        x=at(scene[parameter], low, high),
        title=f"{scene_label(scene['scene_id'])}: {scene[parameter]:.4g}, {scene['ending']}",
    )
