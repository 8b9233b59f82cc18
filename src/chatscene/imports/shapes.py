"""The shapes of trajectories in a scenario file, as points: polylines, clothoids, splines of clothoids, NURBS."""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from chatscene.imports.given import Given, Refused
from chatscene.imports.stranger_xml import Element
from chatscene.terms.polyline import Polyline

_STEP = 0.5  # [m] between points of a curve
_PARTS = 32  # of a NURBS between two of its control points
_MOST = 20_000  # points
_HIGHEST = 12  # order of a NURBS
_SHORTEST = 0.02  # [m] that a line is long at least: a program says its points to the centimetre
_OFF = 0.02  # [m] that a line in a program may be beside the one that was read
_FINELY = 0.002  # [m] the same where there is room
_TURNED = 0.01  # [rad] to which it is told which way somebody looks
_EXACT = 0.001  # [m] to which ways are told
MOST_TIMES = 120  # of one road user; with eight of them a program is still short enough
Pose = tuple[float, float, float]  # x, y [m], heading [rad]
Places = Callable[[Element], Pose]


@dataclass(frozen=True, slots=True)
class Shape:
    """A trajectory.

    Attributes:
        points: x and y of each [m], those at which somebody waits twice.
        times: When each is passed [s]; None where no time is told.
        faces: Which way somebody looks at each point [rad]; empty where that is along the line, as the file says;
            None where it does not say it.
        closed: Whether the last point leads to the first again.
    """

    points: tuple[tuple[float, float], ...]
    times: tuple[float, ...] | None
    line: Polyline
    faces: tuple[float, ...] | None = None
    closed: bool = False


_Traced = tuple[tuple[tuple[float, float], ...], tuple[float, ...] | None]  # the points of a shape, and their times


def shape_of(trajectory: Element, given: Given, place: Places) -> Shape:
    """The shape of a trajectory.

    Args:
        trajectory: The element.
        given: Parameters of the file.
        place: Where a Position is; one that is left out is where the frame is in which it is told, (0, 0, 0).

    Raises:
        Refused: It has no shape that can be read.
    """
    shape = trajectory.find("Shape")
    inner = shape.inside[0] if shape is not None and shape.inside else None
    if inner is None:
        raise Refused(trajectory, "it has no shape")
    read = {"Polyline": _polyline, "Clothoid": _clothoid, "ClothoidSpline": _spline, "Nurbs": _nurbs}.get(inner.tag)
    if read is None:
        raise Refused(inner, "such a shape is not read; write a Polyline")
    points, times = read(inner, given, place)
    faces = _faces(inner, points, place) if inner.tag == "Polyline" else None
    if given.flag(trajectory, "closed"):
        if times is None:
            points, faces = (*points, points[0]), (*faces, faces[0]) if faces else faces
        else:
            given.note(trajectory, "it is closed, but has no time for the way back; it ends at its last point")
    closed = times is None and given.flag(trajectory, "closed")
    return Shape(points, times, line_through(inner, points), faces, closed=closed)


def line_through(one: Element, points: Sequence[tuple[float, ...]]) -> Polyline:
    """The line through points, each x and y [m].

    Raises:
        Refused: They are not two or more places.
    """
    if max((math.dist(points[0][:2], point[:2]) for point in points), default=0.0) < _SHORTEST:
        raise Refused(one, "it is not a line of two points or more")
    return Polyline(points)


def _counted(one: Element, points: int) -> int:
    """A number of points, before they are made."""
    if points > _MOST:
        raise Refused(one, f"it has more than {_MOST} points; cut it down")
    return points


def _polyline(one: Element, given: Given, place: Places) -> _Traced:
    points: list[tuple[float, float]] = []
    times: list[float | None] = []
    vertices = one.all("Vertex")
    _counted(one, len(vertices))
    for vertex in vertices:
        position = vertex.find("Position")
        if position is None:
            raise Refused(vertex, "it has no Position")
        points.append(place(position)[:2])
        times.append(given.number(vertex, "time") if "time" in vertex.attributes else None)
    known = [time for time in times if time is not None]
    return tuple(points), tuple(known) if len(known) == len(points) else None


def _faces(one: Element, points: tuple[tuple[float, float], ...], place: Places) -> tuple[float, ...] | None:
    """Which way somebody looks at each vertex, where each says so; empty where all of it is along the line."""
    positions = [found for vertex in one.all("Vertex") if (found := vertex.find("Position")) is not None]
    if not all(_says_heading(position) for position in positions):
        return None
    faces = tuple(place(position)[2] for position in positions)
    ways = (
        (face, math.atan2(y1 - y0, x1 - x0))
        for face, (x0, y0), (x1, y1) in zip(faces, points, points[1:], strict=False)
        if math.hypot(x1 - x0, y1 - y0) > _SHORTEST
    )
    return faces if any(abs(math.remainder(face - way, math.tau)) > _TURNED / 2 for face, way in ways) else ()


def _says_heading(position: Element) -> bool:
    inner = position.inside[0] if position.inside else position
    return "h" in inner.attributes or any("h" in one.attributes for one in inner.all("Orientation"))


def _start(one: Element, tag: str, place: Places, otherwise: Pose = (0.0, 0.0, 0.0)) -> Pose:
    position = one.find(tag)
    return place(position) if position is not None else otherwise


def _clothoid(one: Element, given: Given, place: Places) -> _Traced:
    length = given.number(one, "length")
    prime = next((name for name in ("curvaturePrime", "curvatureDot") if name in one.attributes), "curvaturePrime")
    curvature, slope = given.number(one, "curvature"), given.number(one, prime, "0")
    points, _ = _bent(one, _start(one, "Position", place), (length, curvature, curvature + slope * length))
    ends = [given.number(one, name) for name in ("startTime", "stopTime") if name in one.attributes]
    return points, _evenly(points, ends[0], ends[1]) if len(ends) == 2 else None


def _spline(one: Element, given: Given, place: Places) -> _Traced:
    """A clothoid for each segment, which begins where the one before ends, or where it says, turned by `hOffset`."""
    segments = one.all("ClothoidSplineSegment")
    if not segments:
        raise Refused(one, "it has no segment")
    points: list[tuple[float, float]] = []
    ends: list[int] = []
    at: Pose = (0.0, 0.0, 0.0)
    for part in segments:
        at = _start(part, "PositionStart", place, at)
        bend = tuple(given.number(part, name) for name in ("length", "curvatureStart", "curvatureEnd"))
        x, y, heading = at
        traced, at = _bent(one, (x, y, heading + given.number(part, "hOffset", "0")), bend)
        points += traced[1:] if points and math.dist(points[-1], traced[0]) < _SHORTEST else traced
        _counted(one, len(points))
        ends.append(len(points) - 1)
    begins = [given.number(part, "timeStart") for part in segments if "timeStart" in part.attributes]
    if len(begins) != len(segments) or "timeEnd" not in one.attributes:
        return tuple(points), None
    times: list[float] = []
    for first, last, begin, end in zip(
        [0, *ends], ends, begins, [*begins[1:], given.number(one, "timeEnd")], strict=False
    ):
        times[-1:] = _evenly(points[first : last + 1], begin, end)
    return tuple(points), tuple(times)


def _bent(one: Element, start: Pose, bend: tuple[float, ...]) -> tuple[tuple[tuple[float, float], ...], Pose]:
    """The points of a curve whose curvature changes evenly, and how it ends.

    Args:
        one: The element.
        start: Where it begins.
        bend: Its length [m], and its curvature at both ends [1/m].
    """
    (x, y, heading), (length, first, last) = start, bend
    if length <= 0.0:
        raise Refused(one, f"a curve of {length:g} m is none")
    steps = _counted(one, math.ceil(length / _STEP))
    points, ds = [(x, y)], length / steps
    for i in range(steps):
        turn = ds * (first + (last - first) * (i + 0.5) / steps)
        x, y = x + ds * math.cos(heading + turn / 2), y + ds * math.sin(heading + turn / 2)
        heading += turn
        points.append((x, y))
    return tuple(points), (x, y, heading)


def _evenly(points: Sequence[tuple[float, float]], begin: float, end: float) -> tuple[float, ...]:
    """Times that pass evenly along points."""
    steps = [math.dist(a, b) for a, b in pairwise(points)]
    whole, gone, times = max(sum(steps), 1e-9), 0.0, [begin]
    for step in steps:
        gone += step
        times.append(begin + (end - begin) * gone / whole)
    return tuple(times)


def _nurbs(one: Element, given: Given, place: Places) -> _Traced:
    order = given.count(one, "order")
    controls = one.all("ControlPoint")
    count = _counted(one, _PARTS * len(controls))
    knots = [given.number(knot, "value") for knot in one.all("Knot")]
    if order > _HIGHEST:
        raise Refused(one, f"its order is {order}, and at most {_HIGHEST} is read")
    if not (2 <= order <= len(controls) and len(knots) == len(controls) + order and knots == sorted(knots)):
        raise Refused(one, "its order, control points and knots do not belong together")
    points: list[tuple[float, float]] = []
    for control in controls:
        position = control.find("Position")
        if position is None:
            raise Refused(control, "it has no Position")
        points.append(place(position)[:2])
    weights = [given.number(control, "weight", "1") for control in controls]
    low, high = knots[order - 1], knots[len(controls)]
    curve = [_on_nurbs(low + (high - low) * i / count, order, points, weights, knots) for i in range(count + 1)]
    told = [given.number(control, "time") for control in controls if "time" in control.attributes]
    times = _evenly(curve, told[0], told[-1]) if len(told) == len(controls) else None
    return tuple(curve), times


def _on_nurbs(
    u: float, order: int, points: Sequence[tuple[float, float]], weights: Sequence[float], knots: Sequence[float]
) -> tuple[float, float]:
    """A point of a curve, by Cox and de Boor, of the control points that bear on it: as many as its order."""
    first = min(bisect_right(knots, u), len(points)) - order
    points, weights = points[first : first + order], weights[first : first + order]
    knots = knots[first : first + 2 * order]
    last = order - 1
    base = [1.0 if a <= u < b or (u >= knots[last + 1] and i == last) else 0.0
            for i, (a, b) in enumerate(pairwise(knots))]  # fmt: skip
    for k in range(2, order + 1):
        for i in range(len(knots) - k):
            left, right = knots[i + k - 1] - knots[i], knots[i + k] - knots[i + 1]
            one = base[i] * (u - knots[i]) / left if left else 0.0
            other = base[i + 1] * (knots[i + k] - u) / right if right else 0.0
            base[i] = one + other
    parts = [weight * part for weight, part in zip(weights, base, strict=False)]
    whole = sum(parts) or 1.0
    x = sum(part * point[0] for part, point in zip(parts, points, strict=True)) / whole
    y = sum(part * point[1] for part, point in zip(parts, points, strict=True)) / whole
    return x, y


def thinned(points: Sequence[tuple[float, float]], off: float = _OFF) -> list[int]:
    """The indices of the points of a line that are needed to stay within a distance [m] of it (Douglas and Peucker)."""
    return _needed(points, off, _beside)


def thinned_finely(points: Sequence[tuple[float, float]]) -> list[int]:
    """The same within 2 mm; of a longer line as near as leaves room in the program."""
    off = _FINELY
    while len(kept := thinned(points, off)) > MOST_TIMES and off < _OFF:
        off *= 2.0
    return kept


def thinned_faces(faces: Sequence[tuple[float, float]]) -> list[int]:
    """The indices of ways [m] and headings [rad, not wrapped] that are needed to look to a hundredth as is told."""
    return _needed(faces, _TURNED, _late)


def thinned_in_time(table: Sequence[tuple[float, float]]) -> list[int]:
    """The indices of the times [s] and ways [m] that are needed to be at each time where the table says.

    To a millimetre, as a program tells them; of a longer table to as few more, up to what a line may be off, as leave
    room in the program. Who brakes as hard as it can never makes up what it begins too late.
    """
    off = _EXACT
    while len(kept := _needed(table, off, _late)) > MOST_TIMES and off < _OFF:
        off *= 2.0
    return kept


Point = tuple[float, float]
Table = NDArray[np.float64]  # (N, 2)


def _needed(points: Sequence[Point], off: float, far_of: Callable[[Table, Point, Point], Table]) -> list[int]:
    keep, table = {0, len(points) - 1}, np.asarray(points, dtype=np.float64)
    waiting = [(0, len(points) - 1)]
    while waiting:
        first, last = waiting.pop()
        if last - first < 2:
            continue
        far = far_of(table[first + 1 : last], points[first], points[last])
        worst = int(np.argmax(far))
        if far[worst] > off:
            at = first + 1 + worst
            keep.add(at)
            waiting += [(first, at), (at, last)]
    return sorted(keep)


def _beside(points: Table, first: Point, last: Point) -> Table:
    """How far points are from the straight piece between two others."""
    (x, y), (x0, y0), (x1, y1) = points.T, first, last
    whole = math.hypot(x1 - x0, y1 - y0)
    if whole <= 1e-9:
        return np.hypot(x - x0, y - y0)
    share = np.clip(((x - x0) * (x1 - x0) + (y - y0) * (y1 - y0)) / whole**2, 0.0, 1.0)
    return np.hypot(x - x0 - share * (x1 - x0), y - y0 - share * (y1 - y0))


def _late(points: Table, first: Point, last: Point) -> Table:
    """How far ways are from what they would be if they grew evenly between two others."""
    (t, s), (t0, s0), (t1, s1) = points.T, first, last
    return np.abs(s - s0 - (s1 - s0) * (t - t0) / max(t1 - t0, 1e-9))
