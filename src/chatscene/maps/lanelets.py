"""A network as lanelets: pieces of lanes, each with a left and a right bound, the pieces before, after and beside it.

A lanelet is what OpenDRIVE has as a lane of a lane section. Bounds are in driving order and have as many points as each
other, one beside the other. Scenic computes the edges of each piece by itself, so that where pieces join, edges part or
step back by up to some 15 cm; here the corners that belong together are one point.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from chatscene.maps.kept import kept_with_network
from chatscene.maps.lane_runs import forward
from chatscene.maps.neighbours import opposes, section_beside
from chatscene.terms.polyline import Polyline

Array = NDArray[np.float64]

_SEAM = 0.5  # [m], within which corners of pieces that join are one
_NEXT = 0.15  # [m] at least from one point of a bound to the next
_WIDTH = 0.02  # [m], less than which is none
_ALONG = 1.0  # [m] of a way in a lanelet, less than which only touches it


@dataclass(frozen=True, slots=True)
class Beside:
    """A lanelet that shares a bound with another from end to end.

    Attributes:
        same_way: Whether both are driven in one direction.
    """

    number: int
    same_way: bool


@dataclass(frozen=True, slots=True, kw_only=True, eq=False)
class Lanelet:
    """A piece of a lane.

    Attributes:
        number: From 1, the same for the same map.
        left: (N, 2) [m], map frame, in driving order.
        right: (N, 2) [m], each point beside that of `left`.
        after: The numbers of those that it leads to.
        before: The numbers of those that lead to it.
        in_junction: Whether it leads through a junction.
    """

    number: int
    left: Array
    right: Array
    after: tuple[int, ...] = ()
    before: tuple[int, ...] = ()
    on_left: Beside | None = None
    on_right: Beside | None = None
    in_junction: bool = False

    @property
    def area(self) -> shapely.Polygon:
        """What it covers."""
        return shapely.Polygon(np.concatenate([self.right, self.left[::-1]]))


@kept_with_network()
def lanelets_of(network: Any) -> tuple[Lanelet, ...]:
    """All lanelets of Scenic's road network as they lie on its map, in the order of their numbers."""
    found = _lanelets(network)
    return tuple(map(_mirrored, found)) if network.mirrored else found


def _mirrored(one: Lanelet) -> Lanelet:
    left, right = one.right * (1.0, -1.0), one.left * (1.0, -1.0)
    return replace(one, left=left, right=right, on_left=one.on_right, on_right=one.on_left)


def _lanelets(network: Any) -> tuple[Lanelet, ...]:
    lanes = sorted(network.lanes, key=lambda lane: lane.uid)
    sections = [section for lane in lanes for section in lane.sections]
    numbers = {section.uid: number for number, section in enumerate(sections, 1)}
    after: dict[int, set[int]] = {number: set() for number in numbers.values()}
    before: dict[int, set[int]] = {number: set() for number in numbers.values()}
    for lane in lanes:
        for one, other in (*pairwise(lane.sections), *_onward(lane)):
            after[numbers[one.uid]].add(numbers[other.uid])
            before[numbers[other.uid]].add(numbers[one.uid])
    made: list[Lanelet] = []
    inside = {m.connectingLane.uid for junction in network.intersections for m in junction.maneuvers}
    for number, section in enumerate(sections, 1):
        left, right = _paired(_spaced(section.leftEdge), _spaced(section.rightEdge))
        made.append(
            Lanelet(
                number=number,
                left=left,
                right=right,
                after=tuple(sorted(after[number])),
                before=tuple(sorted(before[number])),
                on_left=_beside(section, 1, numbers),
                on_right=_beside(section, -1, numbers),
                in_junction=section.lane.uid in inside,
            )
        )
    return _joined(made)


def _onward(lane: Any) -> Iterator[tuple[Any, Any]]:
    """The last section of a lane with the first of each lane that it leads to."""
    for maneuver in lane.maneuvers:
        yield lane.sections[-1], (maneuver.connectingLane or maneuver.endLane).sections[0]


def _beside(section: Any, side: int, numbers: dict[str, int]) -> Beside | None:
    other = section_beside(section, side)
    return None if other is None else Beside(numbers[other.uid], not opposes(section.lane, other.lane))


def _spaced(edge: Any) -> Array:
    """The points of an edge, without those that step back or hardly on."""
    first, *inner, last = forward(edge.points)
    kept = [first]
    for point in inner:
        if min(math.dist(point, kept[-1]), math.dist(point, last)) > _NEXT:
            kept.append(point)
    return np.array([*kept, last])


def _paired(left: Array, right: Array) -> tuple[Array, Array]:
    """Two edges with as many points, level with each other: those of the finer one, and what is nearest to them."""
    if len(left) >= len(right):
        return left, _nearest(right, left)
    return _nearest(left, right), right


def _nearest(line: Array, points: Array) -> Array:
    """The points of a line that are nearest to some along it, from its own start to its own end."""
    found = shapely.LineString(line)
    along = np.maximum.accumulate(shapely.line_locate_point(found, shapely.points(points)))
    along[0], along[-1] = 0.0, found.length
    return shapely.get_coordinates(shapely.line_interpolate_point(found, along))


# Joints. A corner is the end of a bound: the number of the lanelet, its bound, and which end.
_Corner = tuple[int, str, int]
_START, _END = 0, -1


def _joined(lanelets: list[Lanelet]) -> tuple[Lanelet, ...]:
    """The same with one point where corners that belong together were near each other."""
    where = {
        (one.number, side, end): bound[end]
        for one in lanelets
        for side, bound in (("left", one.left), ("right", one.right))
        for end in (_START, _END)
    }
    together: dict[_Corner, list[_Corner]] = {corner: [corner] for corner in where}
    for one in lanelets:
        for a, b in _joints(one):
            if together[a] is not together[b] and math.dist(where[a], where[b]) < _SEAM:
                together[a] += together[b]
                together |= dict.fromkeys(together[b], together[a])
    common = {
        corner: np.mean([where[other] for other in sorted(all_)], axis=0).round(6) for corner, all_ in together.items()
    }

    def between_corners(one: Lanelet) -> Lanelet:
        ends = [[common[one.number, side, end] for end in (_START, _END)] for side in ("left", "right")]
        bounds = np.array([one.left, one.right])
        apart = [np.hypot(*(bounds - [[corners[i]] for corners in ends]).transpose(2, 0, 1)) for i in (0, 1)]
        # Both points of a pair or none, so that they stay level; where a lane begins, bounds that are one line part.
        kept = (np.minimum(*apart).min(axis=0) > _NEXT) & (np.hypot(*(one.left - one.right).T) > _WIDTH)
        left, right = (np.vstack([a, bound[kept], b]) for bound, (a, b) in zip(bounds, ends, strict=True))
        return replace(one, left=left, right=right)

    return tuple(map(between_corners, lanelets))


def _joints(one: Lanelet) -> Iterator[tuple[_Corner, _Corner]]:
    for other in one.after:
        for side in ("left", "right"):
            yield (one.number, side, _END), (other, side, _START)
    if one.on_right:  # driven the same way: to the right of a lane is none that is driven against it
        for end in (_START, _END):
            yield (one.number, "right", end), (one.on_right.number, "left", end)
    if one.on_left and not one.on_left.same_way:
        for end, level in ((_START, _END), (_END, _START)):
            yield (one.number, "left", end), (one.on_left.number, "left", level)


def lanelets_along(lanelets: Sequence[Lanelet], way: Polyline) -> tuple[int, ...]:
    """The numbers of the lanelets that a way leads along, in its order.

    Where several lie over one another, as in junctions, those that do not lead from its start to its end are left out.
    """
    line = shapely.LineString(way.points)
    covered = shapely.intersection([one.area for one in lanelets], line)
    on_way: dict[int, tuple[float, float]] = {}
    for one, part in zip(lanelets, covered, strict=True):
        if part.length < _ALONG:
            continue
        x, y = part.interpolate(0.5, normalized=True).coords[0]
        middle = Polyline((one.left + one.right) / 2)
        at = way.project(x, y)[0]
        if math.cos(way.heading_at(at) - middle.heading_at(middle.project(x, y)[0])) > 0:
            stops = [line.project(shapely.Point(corner)) for corner in shapely.get_coordinates(part)]
            on_way[one.number] = min(stops), max(stops)
    following = {one.number: [number for number in _next(one) if number in on_way] for one in lanelets}
    followed = {number: [one for one in on_way if number in following[one]] for number in on_way}
    begins = {number for number, (start, _) in on_way.items() if start < _ALONG}
    ends = {number for number, (_, end) in on_way.items() if line.length - end < _ALONG}
    through = _reached(begins, following) & _reached(ends, followed)
    return tuple(sorted(through, key=lambda number: (on_way[number], number)))


def _reached(first: set[int], following: Mapping[int, Sequence[int]]) -> set[int]:
    """Some and whoever follows them."""
    found, new = set[int](), first
    while new:
        found |= new
        new = {number for one in new for number in following[one]} - found
    return found


def _next(one: Lanelet) -> list[int]:
    """Where one may go from a lanelet: to those after it, and to those beside it that are driven the same way."""
    return [*one.after, *(beside.number for beside in (one.on_left, one.on_right) if beside and beside.same_way)]
