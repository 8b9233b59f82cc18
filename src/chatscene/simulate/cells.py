"""Where on the roads a track lies, by squares of the map: most of them lie wholly in one lane, and are asked of once.

Every answer is that of the map itself (`chatscene.maps.lane_map`): where an edge goes through a square, each point is
asked for by itself.
"""

from __future__ import annotations

import numpy as np
import shapely
from numpy.typing import NDArray

from chatscene.maps.lane_map import Indices, LaneMap
from chatscene.simulate.native.engine import Engine, address
from chatscene.simulate.native.lines import engine
from chatscene.terms.arrays import Array
from chatscene.terms.route import Route

SIDE = 0.5  # [m] of a square
KEPT = 20_000  # points of which it is kept where they lie
BESIDE = 10.0  # [m] around the box of a route, beyond which each point is asked for
_WIDER = 1e-6  # [m] by which a square is taken to be larger on each side: more than rounding makes of a place
_UNKNOWN, _EDGE = 0, -1


class Cells:
    """Squares along a route.

    Args:
        lane_map: The lanes of the map.
        route: Whose lanes win where several overlap.
    """

    def __init__(self, lane_map: LaneMap, route: Route) -> None:
        self._lane_map = lane_map
        self._along = route.lane_ids
        self._points: dict[tuple[float, float], int] = {}
        low, high = (route.line.points.min(axis=0) - BESIDE), (route.line.points.max(axis=0) + BESIDE)
        self._low: tuple[float, float] = (float(low[0]), float(low[1]))
        wide, tall = np.ceil((high - low) / SIDE).astype(int).tolist()
        self._known = np.zeros((tall, wide), np.int32)  # a square's lane and whether it is off the road: `_code`
        self._at = address(self._known)

    def along(self, x: Array, y: Array) -> tuple[NDArray[np.bool_], list[int], list[int]]:
        """Where a track is off the road, and at which steps it comes to be so, and leaves a lane.

        Args:
            x: (T,) [m], map frame.
            y: (T,) [m].

        Returns:
            (T,) whether it is off the road; the steps at which it is and was not before; and those of which it is in a
            lane, and at the next in another or in none.
        """
        if (native := engine()) is not None:
            return native.lane_events(self._codes(x, y, native))
        xy = np.array((x, y)).T
        lane, off_road = self._lane_map.lane_index(xy, self._along), self._lane_map.off_road(xy)
        begins = off_road & ~np.concatenate(([False], off_road[:-1]))
        changed = (lane[1:] != lane[:-1]) & (lane[:-1] >= 0)
        return off_road, np.flatnonzero(begins).tolist(), np.flatnonzero(changed).tolist()

    def _codes(self, x: Array, y: Array, native: Engine) -> NDArray[np.int32]:
        """(T,) The `_code` of each point."""
        found, told = native.in_cells(x, y, self._low, SIDE, self._known, self._at)
        if not told:
            if not found.all():
                self._learn(x[found == _UNKNOWN], y[found == _UNKNOWN])
                found, _ = native.in_cells(x, y, self._low, SIDE, self._known, self._at)
            at = np.flatnonzero(found == _EDGE)
            found[at] = self._of_points(x[at].tolist(), y[at].tolist())
        return found

    def _of_points(self, x: list[float], y: list[float]) -> list[int]:
        """Of points by themselves: an ego comes to the very same ones in one scene after another."""
        points = list(zip(x, y, strict=True))
        if new := [point for point in points if point not in self._points]:
            if len(self._points) > KEPT:
                self._points.clear()
                new = points
            xy = np.array(new)
            codes = _code(self._lane_map.lane_index(xy, self._along), self._lane_map.off_road(xy))
            self._points.update(zip(new, codes.tolist(), strict=True))
        return [self._points[point] for point in points]

    def _learn(self, x: Array, y: Array) -> None:
        """Ask of the squares of some points, none of them beside the map."""
        columns = (np.floor((of - low) / SIDE) for of, low in zip((x, y), self._low, strict=True))
        column, row = np.unique(np.array([*columns], np.int64), axis=1)
        low_x, low_y = (low + SIDE * at - _WIDER for low, at in zip(self._low, (column, row), strict=True))
        wide = SIDE + 2.0 * _WIDER
        squares = shapely.box(low_x, low_y, low_x + wide, low_y + wide)
        lane, off_road, sure = self._lane_map.throughout(squares, self._along)
        self._known[row, column] = np.where(sure, _code(lane, off_road), _EDGE)


def _code(lane: Indices, off_road: NDArray[np.bool_]) -> NDArray[np.int64]:
    """A lane, -1 for none, and whether that is off the road, as one number above 1."""
    return (lane + 2 << 1) | off_road
