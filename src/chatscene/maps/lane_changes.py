"""From one lane into the one beside it."""

from __future__ import annotations

from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from chatscene.maps.lane_runs import LaneRun
from chatscene.maps.neighbours import section_beside
from chatscene.terms.polyline import Polyline

NARROW = 2.5  # [m]; a lane that is narrower, as where it begins or tapers out, is none to drive in


def shifted(line: Polyline, left: float, out_at: float, back_at: float | None, over: float) -> Polyline:
    """A line that moves aside within a distance, and back.

    Args:
        line: The line.
        left: How far [m] it moves to the left.
        out_at: From which arc length [m] on.
        back_at: From which arc length [m] on it moves back; None if it stays.
        over: Within which distance [m].
    """
    fine = line.resampled(1.0)
    s = np.arange(len(fine), dtype=float)
    share = _smooth((s - out_at) / over)
    if back_at is not None:
        share = share - _smooth((s - back_at) / over)
    tangent = np.gradient(fine.points, axis=0)
    tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
    normal = np.column_stack((-tangent[:, 1], tangent[:, 0]))
    return Polyline(fine.points + (left * share)[:, None] * normal)


def changed(line: Polyline, other: Polyline, at: float, over: float, further: float) -> Polyline:
    """A line that goes over into another one beside it, of whatever width the lanes are.

    Args:
        line: The line.
        other: The line it goes over to.
        at: From which arc length [m] on.
        over: Within which distance [m].
        further: How far [m] it follows the other line then.
    """
    fine = line.between(0.0, at + over).resampled(1.0)
    points: list[NDArray[Any]] = []
    level = 0.0
    for s, (x, y) in enumerate(fine.points.tolist()):
        level = other.project(x, y)[0]
        share = float(_smooth(np.array((s - at) / over)))
        points.append(np.array([x, y]) * (1 - share) + share * np.array(other.point_at(level)))
    return Polyline.join(Polyline(points), other.between(level, min(level + further, other.length)))


def _smooth(t: NDArray[Any]) -> NDArray[Any]:
    t = np.clip(t, 0.0, 1.0)
    return t * t * (3 - 2 * t)


def neighbour(run: LaneRun, at: float, side: int) -> Any:
    """The lane beside a run at an arc length [m]: left for side 1, right for -1; None if there is none to drive in."""
    lane, point = run.lane_at(at), run.line.point_at(at)
    section = next((s for s in lane.sections if s.containsPoint(point)), lane.sections[0])
    there = section_beside(section, side)
    return None if there is None or width_at(there, point) < NARROW else there.lane


def width_at(section: Any, point: tuple[float, float]) -> float:
    """How wide [m] a lane, or a section of it, is level with a point [m]."""
    left, right = section.leftEdge.lineString, section.rightEdge.lineString
    level = left.interpolate(left.project(shapely.Point(point)))
    return float(right.distance(level))


def wide_at(run: LaneRun, at: float) -> bool:
    """Whether a run is wide enough to drive in at an arc length [m]."""
    return width_at(run.lane_at(at), run.line.point_at(at)) >= NARROW
