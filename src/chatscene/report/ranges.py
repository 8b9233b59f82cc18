"""How the ranges moved from block to block: one small plot per parameter, as SVG."""

from __future__ import annotations

import html
from collections.abc import Mapping, Sequence
from typing import Any

Row = Mapping[str, Any]

WIDTH, LEFT, RIGHT, TOP, PITCH = 360, 22, 12, 8, 26


def plot_ranges(parameter: str, ranges: Sequence[Row], scenes: Sequence[Row]) -> str:
    """One parameter of one scenario and route.

    Args:
        parameter: Its name, with prefix.
        ranges: Its rows of `ranges.parquet`; block 0 holds the declared range.
        scenes: The driven rows of `scenes.parquet` of the same scenario and route.

    Returns:
        An SVG element: a row per block from the top, its range as a bar, a dot per scene.
    """
    blocks = sorted(ranges, key=lambda row: row["block"])
    low, high = _axis(blocks)
    rows = [_block(row, parameter, low, high, scenes) for row in blocks]
    bottom = TOP + PITCH * len(blocks)
    label = f"{parameter}: range and scenes in {len(blocks)} blocks"
    return (
        f'<svg class="ranges" viewBox="0 0 {WIDTH} {bottom + 20}" role="img" aria-label="{html.escape(label)}">'
        f"{''.join(rows)}{_labels(low, high, bottom)}</svg>"
    )


def _axis(blocks: Sequence[Row]) -> tuple[float, float]:
    """The declared range, or something around it if it is a single value."""
    low, high = blocks[0]["low"], blocks[0]["high"]
    return (low, high) if high > low else (low - 0.5, low + 0.5)


def _at(value: float, low: float, high: float) -> float:
    share = min(max((value - low) / (high - low), 0.0), 1.0)
    return round(LEFT + share * (WIDTH - LEFT - RIGHT), 1)


def _block(row: Row, parameter: str, low: float, high: float, scenes: Sequence[Row]) -> str:
    middle = TOP + PITCH * (row["block"] + 0.5)
    start, end = _at(row["low"], low, high), _at(row["high"], low, high)
    own = [scene for scene in scenes if scene["block"] == row["block"] and scene.get(parameter) is not None]
    # Collisions are drawn last, so that they are on top.
    dots = [_dot(scene, parameter, low, high, middle) for scene in sorted(own, key=lambda s: bool(s["collision"]))]
    return (
        f'<line class="declared" x1="{LEFT}" x2="{WIDTH - RIGHT}" y1="{middle}" y2="{middle}"/>'
        f'<rect class="range" x="{start}" y="{middle - 9}" width="{max(end - start, 2):.1f}" height="18" rx="4">'
        f"<title>block {row['block'] + 1}: {row['low']:.4g} to {row['high']:.4g}</title></rect>"
        f'<text class="block" x="4" y="{middle + 3.5}">{row["block"] + 1}</text>{"".join(dots)}'
    )


def _dot(scene: Row, parameter: str, low: float, high: float, middle: float) -> str:
    kind = "hit" if scene["collision"] else "miss"
    kept = " kept" if scene["selected"] else ""
    title = f"{scene['scene_id']}: {scene[parameter]:.4g}, {scene['ending']}"
    return (
        f'<circle class="{kind}{kept}" cx="{_at(scene[parameter], low, high)}" cy="{middle}" r="3.6">'
        f"<title>{html.escape(title)}</title></circle>"
    )


def _labels(low: float, high: float, bottom: float) -> str:
    return (
        f'<text x="{LEFT}" y="{bottom + 13}">{low:.4g}</text>'
        f'<text x="{WIDTH - RIGHT}" y="{bottom + 13}" text-anchor="end">{high:.4g}</text>'
    )
