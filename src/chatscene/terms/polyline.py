"""A line in the plane with arc length: centre lines, routes, planned paths."""

from __future__ import annotations

import math
from collections.abc import Iterable
from itertools import accumulate
from operator import sub
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import SettingsError

_APART = 1e-3  # [m] between neighbours at least


class Polyline:
    """A sequence of points [m] in the map frame (right-handed, x east, y north), with arc length.

    Immutable. Coordinates are kept both as an array, for work on whole tracks, and as plain lists, because
    one look-up per simulated step on Python floats is several times faster than on numpy scalars.

    Args:
        points: (N, 2) [m], N >= 2; a point closer than 1 mm to its predecessor is dropped.

    Raises:
        SettingsError: Fewer than two distinct points.
    """

    __slots__ = ("_hx", "_hy", "_made", "_s", "_segments", "_x", "_y", "length", "points")

    def __init__(self, points: Iterable[Iterable[float]]) -> None:
        listed: Any = points.tolist() if isinstance(points, np.ndarray) else points  # plain floats are the quicker ones
        kept = [(float(x), float(y)) for x, y, *_ in listed]
        x, y, steps = _columns(kept)
        if not all(step > _APART for step in steps):
            kept = _apart(kept)
            x, y, steps = _columns(kept)
        if len(kept) < 2:
            raise SettingsError("a polyline needs at least two distinct points")
        self.points: NDArray[np.float64] = np.array(kept)
        self.points.setflags(write=False)
        self._x, self._y = x, y
        self._s = list(accumulate(steps, initial=0.0))
        self._hx = [(b - a) / step for a, b, step in zip(x, x[1:], steps, strict=False)]
        self._hy = [(b - a) / step for a, b, step in zip(y, y[1:], steps, strict=False)]
        self.length: float = self._s[-1]
        self._made: tuple[NDArray[np.float64], ...] | None = None
        x0, y0 = self.points[:-1].T
        dx, dy = self.points[1:, 0] - x0, self.points[1:, 1] - y0
        self._segments = x0, y0, dx, dy, dx * dx + dy * dy

    def __len__(self) -> int:
        return len(self._x)

    def __repr__(self) -> str:
        return f"Polyline({len(self)} points, {self.length:.1f} m)"

    @property
    def columns(self) -> tuple[list[float], ...]:
        """X, y and arc length [m] of each point, and the unit direction of each segment, x and y; not to be changed."""
        return self._x, self._y, self._s, self._hx, self._hy

    def segment_at(self, s: float) -> int:
        """Index of the segment that holds arc length `s` [m]; the ends hold everything beyond them."""
        low, high = 0, len(self._hx) - 1
        while low < high:
            middle = (low + high + 1) // 2
            if self._s[middle] <= s:
                low = middle
            else:
                high = middle - 1
        return low

    def segment(self, i: int) -> tuple[float, float, float, float]:
        """Start point [m] and unit direction of segment `i`; beyond the last, the last one's end."""
        last = len(self._hx) - 1
        if i > last:
            return self._x[-1], self._y[-1], self._hx[last], self._hy[last]
        return self._x[i], self._y[i], self._hx[i], self._hy[i]

    def point_at(self, s: float) -> tuple[float, float]:
        """The point [m] at arc length `s` [m]; beyond the ends the line goes straight on."""
        i = self.segment_at(s)
        d = s - self._s[i]
        return self._x[i] + d * self._hx[i], self._y[i] + d * self._hy[i]

    def heading_at(self, s: float) -> float:
        """Direction [rad, 0 = +x, counter-clockwise] at arc length `s` [m]."""
        i = self.segment_at(s)
        return math.atan2(self._hy[i], self._hx[i])

    def segments_at(self, s: NDArray[np.float64]) -> NDArray[np.intp]:
        """What `segment_at` says of each of many arc lengths [m]."""
        return np.maximum(np.searchsorted(self._arrays[2][:-1], s, side="right") - 1, 0)

    def points_at(self, s: NDArray[np.float64]) -> NDArray[np.float64]:
        """(N, 2): what `point_at` says of each of many arc lengths [m]."""
        x, y, arc, hx, hy, _ = self._arrays
        i = self.segments_at(s)
        d = s - arc[i]
        return np.stack((x[i] + d * hx[i], y[i] + d * hy[i]), axis=-1)

    def headings_at(self, s: NDArray[np.float64]) -> NDArray[np.float64]:
        """What `heading_at` says of each of many arc lengths [m]."""
        return self._arrays[5][self.segments_at(s)]

    @property
    def _arrays(self) -> tuple[NDArray[np.float64], ...]:
        """The columns, and the direction [rad] of each segment, as arrays; made when they are first asked for."""
        if self._made is None:
            headings = map(math.atan2, self._hy, self._hx)
            self._made = (*map(np.array, self.columns), np.array(list(headings)))
        return self._made

    def project(self, x: float, y: float, near: int | None = None) -> tuple[float, float, int]:
        """Where a point lies relative to the line.

        Args:
            x: Map frame [m].
            y: Map frame [m].
            near: Segment to search outward from, for a point that moved little since the last call; the
                search ends at the first local minimum. None searches the whole line.

        Returns:
            Arc length [m] of the nearest point; signed distance to the line [m, positive = left of it], where
            beyond an end the line is taken to go straight on; and the segment's index, to pass as `near` next
            time.
        """
        if near is None:
            near = int(self._nearest(x, y))
        xs, ys, arcs, hxs, hys = self._x, self._y, self._s, self._hx, self._hy
        last = len(hxs) - 1
        best, step, i = math.inf, 1, near
        along = across = length = 0.0
        while True:  # ever nearer ahead, then ever nearer behind; every step of a simulation comes through here
            hx, hy = hxs[i], hys[i]
            rx, ry = x - xs[i], y - ys[i]
            ahead, aside = rx * hx + ry * hy, hx * ry - hy * rx
            whole = arcs[i + 1] - arcs[i]
            beyond = ahead if ahead < 0.0 else ahead - whole if ahead > whole else 0.0
            distance2 = beyond * beyond + aside * aside
            if distance2 < best or (distance2 == best and step > 0):
                near, best, along, across, length = i, distance2, ahead, aside, whole
            elif step > 0:
                step = -1
            else:
                break
            i = near + step
            if i > last:
                step, i = -1, near - 1
            if i < 0:
                break
        if along < 0.0:  # outside a corner, unless it is the start of the line
            return arcs[near], math.copysign(math.hypot(along, across), across) if near > 0 else across, near
        if (beyond := along - length) > 0.0:
            return arcs[near + 1], math.copysign(math.hypot(beyond, across), across) if near < last else across, near
        return arcs[near] + along, across, near

    def along(self, x: NDArray[np.float64], y: NDArray[np.float64]) -> NDArray[np.float64]:
        """Arc lengths [m] of the nearest points to points [m]: what `project` says of each, the whole line searched."""
        near = self._nearest(x[:, None], y[:, None]).tolist()
        return np.array([self.project(*each)[0] for each in zip(x.tolist(), y.tolist(), near, strict=True)])

    def _nearest(self, x: Any, y: Any) -> NDArray[np.intp]:
        """The segment nearest to a point; of points in a column, one each."""
        x0, y0, dx, dy, length2 = self._segments
        rx, ry = x - x0, y - y0
        t = np.minimum(np.maximum((rx * dx + ry * dy) / length2, 0.0), 1.0)
        return np.argmin((rx - t * dx) ** 2 + (ry - t * dy) ** 2, axis=-1)

    def resampled(self, spacing: float) -> Polyline:
        """The same line with points `spacing` [m] of arc length apart (the last gap may be shorter)."""
        gaps = max(math.ceil((self.length - 2e-3) / spacing), 1)  # none so short that its end would be dropped
        stops = np.append(np.arange(gaps) * spacing, self.length)
        arc = np.array(self._s)
        return Polyline(
            np.column_stack((np.interp(stops, arc, self.points[:, 0]), np.interp(stops, arc, self.points[:, 1])))
        )

    def between(self, start: float, end: float) -> Polyline:
        """The part from arc length `start` to `end` [m], both inside the line."""
        inner = [(x, y) for x, y, s in zip(self._x, self._y, self._s, strict=True) if start < s < end]
        return Polyline([self.point_at(start), *inner, self.point_at(end)])

    def offset(self, left: float) -> Polyline:
        """The line shifted sideways by `left` [m, positive = left], each point along its own normal."""
        p = self.points
        tangent = np.gradient(p, axis=0)
        tangent /= np.linalg.norm(tangent, axis=1, keepdims=True)
        return Polyline(p + left * np.column_stack((-tangent[:, 1], tangent[:, 0])))

    @staticmethod
    def join(*lines: Polyline) -> Polyline:
        """Several lines, end to end."""
        return Polyline(np.concatenate([line.points for line in lines]))


def _columns(points: list[tuple[float, float]]) -> tuple[list[float], list[float], list[float]]:
    """X, y and the distances between neighbours [m]."""
    x, y = [x for x, _ in points], [y for _, y in points]
    return x, y, list(map(math.hypot, map(sub, x[1:], x), map(sub, y[1:], y)))


def _apart(points: list[tuple[float, float]]) -> list[tuple[float, float]]:
    """The points without those that lie too close to the one kept before."""
    kept = points[:1]
    for x, y in points[1:]:
        if math.hypot(x - kept[-1][0], y - kept[-1][1]) > _APART:
            kept.append((x, y))
    return kept
