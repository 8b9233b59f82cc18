"""Where on the roads a whole track lies, in one call: off the road, in which lane."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

Array = NDArray[np.float64]
Indices = NDArray[np.int64]

OFF_ROAD_TOLERANCE = 0.1  # [m]
_SEAM = 0.05  # [m]; neighbouring lanes of a map do not quite touch


class LaneMap:
    """The lanes of a network, prepared for questions about many points at once.

    Attributes:
        lane_ids: Scenic's id of each lane, in the order of the indices that `lane_index` gives.
    """

    def __init__(self, network: Any) -> None:
        lanes = sorted(network.lanes, key=lambda lane: lane.uid)
        self.lane_ids: tuple[str, ...] = tuple(lane.uid for lane in lanes)
        self._index = {uid: i for i, uid in enumerate(self.lane_ids)}
        self._areas = shapely.buffer([lane.polygons for lane in lanes], _SEAM)
        self._bounds: Array = shapely.bounds(self._areas)
        self._boxes: list[list[float]] = self._bounds.tolist()
        self._drivable = shapely.buffer(network.drivableRegion.polygons, OFF_ROAD_TOLERANCE)
        shapely.prepare(self._areas)
        shapely.prepare(self._drivable)

    def off_road(self, xy: Array) -> NDArray[np.bool_]:
        """Which points lie more than 0.1 m off every driving lane and junction.

        Args:
            xy: (T, 2) [m], map frame.

        Returns:
            (T,) bool.
        """
        return ~shapely.contains_xy(self._drivable, xy)

    def lane_index(self, xy: Array, along: Sequence[str] = ()) -> Indices:
        """In which lane each point lies.

        Args:
            xy: (T, 2) [m], map frame.
            along: Ids of lanes that win where several overlap, as they do in junctions: those of a route.

        Returns:
            (T,) indices into `lane_ids`; -1 where there is no lane.
        """
        found = np.full(len(xy), -1)
        left = np.arange(len(xy))
        for lane in self._candidates(xy, along):
            inside = shapely.contains_xy(self._areas[lane], xy[left])
            found[left[inside]] = lane
            left = left[~inside]
            if not left.size:
                break
        return found

    def throughout(
        self, squares: NDArray[np.object_], along: Sequence[str] = ()
    ) -> tuple[Indices, NDArray[np.bool_], NDArray[np.bool_]]:
        """In which lane all points of a square lie, and whether they are off the road.

        Args:
            squares: (N,) polygons, map frame.
            along: As for `lane_index`.

        Returns:
            (N,) indices as those of `lane_index`; (N,) whether they are off the road; and (N,) whether both are so of
            every point, as is not where an edge goes through.
        """
        bounds = shapely.bounds(squares)
        found, sure, left = np.full(len(squares), -1), np.ones(len(squares), np.bool_), np.arange(len(squares))
        for lane in self._candidates(np.concatenate((bounds[:, :2], bounds[:, 2:])), along):
            meets = shapely.intersects(self._areas[lane], squares[left])
            inside = meets & shapely.contains_properly(self._areas[lane], squares[left])
            found[left[inside]] = lane
            sure[left[meets & ~inside]] = False
            left = left[~meets]
            if not left.size:
                break
        off_road = ~shapely.intersects(self._drivable, squares)
        return found, off_road, sure & (off_road | shapely.contains_properly(self._drivable, squares))

    def _candidates(self, xy: Array, along: Sequence[str]) -> Iterator[int]:
        """Lanes whose bounding box meets that of the points, the preferred ones first."""
        if not len(xy):
            return
        low, high = xy.min(axis=0), xy.max(axis=0)
        (low_x, low_y), (high_x, high_y) = low.tolist(), high.tolist()
        first = dict.fromkeys(self._index[uid] for uid in along if uid in self._index)
        for lane in first:
            x0, y0, x1, y1 = self._boxes[lane]
            if not (x0 > high_x or x1 < low_x or y0 > high_y or y1 < low_y):
                yield lane
        near = np.flatnonzero((self._bounds[:, :2] <= high).all(axis=1) & (self._bounds[:, 2:] >= low).all(axis=1))
        yield from (lane for lane in near.tolist() if lane not in first)
