"""The middle of a lane as its map draws it: lines, arcs, spirals and cubics, and widths that change along them.

Scenic draws a lane between twenty points of each piece of its road, so that the middle lies some decimetres inside a
long bend. That is near enough to drive by; who is to be where a file says to the centimetre asks here.
Source: ASAM OpenDRIVE 1.8.1, sections 9 (geometry), 11.4 (offset of lanes), 11.7.1 (width).
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np
from numpy.typing import NDArray

from chatscene.maps.kept import kept
from chatscene.maps.lane_runs import centre_line, forward
from chatscene.maps.plain_form import in_plain_form, name_of
from chatscene.terms.polyline import Polyline

_OFF = 0.002  # [m] that a line of points may be beside the curve
_LONGEST, _SHORTEST = 10.0, 0.05  # [m] between two points of what is no straight line
_ALIKE = 1.0  # [m] from where Scenic has the ends of a lane, beyond which it is another lane
_FINE = 16  # parts of a cubic's parameter between two points, by which its length is measured
_NUMBERS = re.compile(r"road(-?\d+)_sec(\d+)_lane(-?\d+)")  # what Scenic calls a lane in a section of its road
_Piece = tuple[float, float, Xml.Element]  # where a piece of a reference line begins, and how long it is [m]
Array = NDArray[np.float64]
Steps = list[tuple[float, float, float, float, float]]  # from which s [m] on, and the four numbers of a cubic


def middle_line(lane: Any) -> Polyline:
    """The middle of a lane [m], map frame, in driving order, at most 2 mm beside its curve.

    Where the map does not tell it so that it lies where Scenic has the lane, it is Scenic's own line.
    """
    return kept(lane, "middle_line", _middle_line)


def _middle_line(lane: Any) -> Polyline:
    usual = centre_line(lane)
    parts = [_section(section) for section in lane.sections]
    points = [point for part in parts if part is not None for point in part]
    if None in parts or max(math.dist(points[0], point) for point in points) < _SHORTEST:
        return usual
    line = Polyline(forward(Polyline(points).points.tolist()))
    ends = zip((line.points[0], line.points[-1]), (usual.points[0], usual.points[-1]), strict=True)
    return line if all(math.dist(one, other) < _ALIKE for one, other in ends) else usual


def _section(section: Any) -> list[tuple[float, float]] | None:
    """The points of the middle of a lane in one section of its road; None where the map does not tell them."""
    told = _NUMBERS.fullmatch(section.uid)
    if told is None:
        return None
    for form in kept(section.network, "drawn_roads", _drawn_roads):
        road = form.get(told[1])
        if road is not None and road.sections == len(section.road.sections):
            break
    else:
        return None
    try:
        points = road.middle(int(told[2]), int(told[3]))
    except (LookupError, ValueError, ArithmeticError):  # whatever a road does not tell as it should
        return None
    return points if section.isForward else points[::-1]


def _drawn_roads(network: Any) -> tuple[dict[str, DrawnRoad], ...]:
    """The roads of a map by number, in each of the forms in which it may have been read."""
    written: bytes | None = getattr(network, "written", None)
    if written is None:
        return ()
    found: list[dict[str, DrawnRoad]] = []
    for again in (False, True):
        root = Xml.fromstring(written)
        in_plain_form(root, again=again)
        found.append({road.get("id", ""): DrawnRoad(road) for road in root.iter("road")})
    return tuple(found)


@dataclass(frozen=True, slots=True)
class End:
    """What a road leads to at its start or its end.

    Attributes:
        kind: ``road`` or ``junction``.
        contact: ``start`` or ``end`` of that road; nothing for a junction.
    """

    kind: str
    number: str
    contact: str


class DrawnRoad:
    """A road as it is written.

    Attributes:
        junction: The number of the junction that it leads through; -1 for none.
        ends: What it leads to before its ``start`` and after its ``end``, where that is told.
    """

    def __init__(self, road: Xml.Element) -> None:
        self._road, self.name = road, name_of(road)
        self.junction = road.get("junction", "-1")
        self.ends = {
            at: End(link.get("elementType", ""), link.get("elementId", ""), link.get("contactPoint", ""))
            for at, tag in (("start", "predecessor"), ("end", "successor"))
            if (link := road.find(f"link/{tag}")) is not None
        }

    @cached_property
    def length(self) -> float:
        """Of its reference line [m]."""
        start, length, _ = self._pieces[-1]
        return start + length

    @cached_property
    def sections(self) -> int:
        """How many sections of lanes it has."""
        return len(self._sections)

    def place(self, s: float, left: float) -> tuple[float, float, float]:
        """A point by its arc length on the reference line and how far to the left of it it lies [m], and the direction.

        Raises:
            ValueError: Its reference line is of another kind.
        """
        first, _, element = [piece for piece in self._pieces if piece[0] <= max(s, 0.0) + 1e-9][-1]
        x, y, heading = (float(one[0]) for one in _reference(element, np.array([s - first])))
        return x - left * math.sin(heading), y + left * math.cos(heading), heading

    def lanes_at(self, s: float) -> list[int]:
        """The numbers of its lanes at an arc length [m], from right to left, without the middle."""
        return sorted(self._at(s)[1])

    def middle_at(self, s: float, lane: int) -> float:
        """How far to the left of the reference line the middle of a lane is [m].

        Raises:
            LookupError: It has no such lane there.
        """
        at = np.array([s])
        return sum(float(share * _valued(steps, at)[0]) for steps, share in self._shares(*self._at(s), lane))

    def middle(self, number: int, lane: int) -> list[tuple[float, float]]:
        """The middle of a lane of a section, in the order of the road's reference line.

        Raises:
            LookupError: It has no such lane there.
            ValueError: It is not told.
        """
        starts = [start for start, _ in self._sections]
        begin, end = starts[number], (*starts[1:], self.length)[number]
        shares = self._shares(*self._sections[number], lane)
        points: list[tuple[float, float]] = []
        for low, high, (first, _, element) in _spans(
            begin, end, self._pieces, [one for steps, _ in shares for one in steps]
        ):
            held = [_held(steps, (low + high) / 2) for steps, _ in shares]
            sharp = _bend(element) + sum(2 * abs(c) + 6 * abs(d) * (high - s0) for s0, _, _, c, d in held)
            step = min(max(math.sqrt(8 * _OFF / sharp), _SHORTEST), _LONGEST) if sharp > 1e-9 else high - low
            s = np.linspace(low, high, max(math.ceil((high - low) / step), 1) + 1)
            x, y, heading = _reference(element, s - first)
            left = sum((share * _valued(steps, s) for steps, share in shares), np.zeros_like(s))
            rows = np.column_stack((x - left * np.sin(heading), y + left * np.cos(heading)))
            points += [(float(a), float(b)) for a, b in rows]
        return points

    @cached_property
    def _pieces(self) -> list[_Piece]:
        found = [(float(p.attrib["s"]), float(p.attrib["length"]), p) for p in self._road.iterfind("planView/geometry")]
        return sorted(found, key=lambda piece: piece[0])

    def joints(self) -> Iterator[tuple[float, float, float]]:
        """Where pieces of its reference line meet: arc length, how far apart they are [m], the turn between [rad].

        Raises:
            ValueError: Its reference line is of another kind.
        """
        for (first, length, one), (start, _, other) in pairwise(self._pieces):
            del first
            (x0, y0, before), (x1, y1, after) = (
                tuple(float(column[0]) for column in _reference(element, np.array([at])))
                for element, at in ((one, length), (other, 0.0))
            )
            yield start, math.hypot(x1 - x0, y1 - y0), abs(math.remainder(after - before, math.tau))

    @cached_property
    def _offsets(self) -> Steps:
        return _cubics(self._road.find("lanes"), "laneOffset", "s", 0.0) or [(0.0, 0.0, 0.0, 0.0, 0.0)]

    @cached_property
    def _sections(self) -> list[tuple[float, dict[int, Xml.Element]]]:
        return [
            (
                float(one.attrib["s"]),
                {int(lane.attrib["id"]): lane for lane in one.iter("lane") if int(lane.attrib["id"])},
            )
            for one in self._road.iterfind("lanes/laneSection")
        ]

    def _at(self, s: float) -> tuple[float, dict[int, Xml.Element]]:
        return next((one for one in reversed(self._sections) if one[0] <= s), self._sections[0])

    def _shares(self, begin: float, lanes: dict[int, Xml.Element], lane: int) -> list[tuple[Steps, float]]:
        """What lies between the reference line and the middle of a lane: cubics, and how much of each."""
        side = 1 if lane > 0 else -1
        inner = [(_cubics(lanes[k], "width", "sOffset", begin), float(side)) for k in range(side, lane, side)]
        return [(self._offsets, 1.0), *inner, (_cubics(lanes[lane], "width", "sOffset", begin), 0.5 * side)]


def _cubics(holder: Xml.Element | None, tag: str, name: str, begin: float) -> Steps:
    found = () if holder is None else holder.findall(tag)
    return sorted((begin + float(e.attrib[name]), *(float(e.get(k, "0")) for k in "abcd")) for e in found)  # pyright: ignore[reportReturnType] - four after the first


def _spans(begin: float, end: float, pieces: list[_Piece], steps: Steps) -> list[tuple[float, float, _Piece]]:
    """The stretches of a section in each of which one piece of the reference line and one cubic of each width hold."""
    cuts = {begin, end, *(s for s, *_ in steps), *(s for s, _, _ in pieces)}
    inner = sorted(s for s in cuts if begin <= s <= end)
    return [
        (low, high, [piece for piece in pieces if piece[0] <= low + 1e-9][-1])
        for low, high in pairwise(inner)
        if high - low > 1e-6
    ]


def _held(steps: Steps, s: float) -> tuple[float, float, float, float, float]:
    """The cubic that holds at an arc length [m]."""
    return next((step for step in reversed(steps) if step[0] <= s), steps[0])


def _valued(steps: Steps, s: Array) -> Array:
    """A width or an offset at arc lengths between which one cubic holds [m]."""
    s0, a, b, c, d = _held(steps, float(s[0] + s[-1]) / 2)
    x = s - s0
    return a + x * (b + x * (c + x * d))


def _bend(piece: Xml.Element) -> float:
    """How sharply a piece of a reference line bends at most [1/m]."""
    if (arc := piece.find("arc")) is not None:
        return abs(float(arc.attrib["curvature"]))
    if (spiral := piece.find("spiral")) is not None:
        return max(abs(float(spiral.attrib[name])) for name in ("curvStart", "curvEnd"))
    if (curve := piece.find("paramPoly3")) is not None:
        x, y, heading = _cubic_curve(curve, np.linspace(0.0, 1.0, 65))
        turns, ways = np.abs(np.diff(np.unwrap(heading))), np.hypot(np.diff(x), np.diff(y))
        return float(np.max(turns / np.maximum(ways, 1e-6)))
    return 0.0


def _reference(piece: Xml.Element, s: Array) -> tuple[Array, Array, Array]:
    """X, y [m] and direction [rad] of a piece of a reference line, at arc lengths from its start [m]."""
    x0, y0, turn, length = (float(piece.attrib[name]) for name in ("x", "y", "hdg", "length"))
    s = np.clip(s, 0.0, length)
    if (arc := piece.find("arc")) is not None:
        u, v, heading = _clothoid(float(arc.attrib["curvature"]), 0.0, s)
    elif (spiral := piece.find("spiral")) is not None:
        first, last = (float(spiral.attrib[name]) for name in ("curvStart", "curvEnd"))
        u, v, heading = _clothoid(first, (last - first) / length, s)
    elif (curve := piece.find("paramPoly3")) is not None:
        fine = np.linspace(0.0, 1.0, max(math.ceil(length), 1) * _FINE + 1)
        fu, fv, _ = _cubic_curve(curve, fine)
        gone = np.concatenate(([0.0], np.cumsum(np.hypot(np.diff(fu), np.diff(fv)))))
        u, v, heading = _cubic_curve(curve, np.interp(s, gone, fine))
    elif piece.find("line") is not None:
        u, v, heading = s, np.zeros_like(s), np.zeros_like(s)
    else:
        raise ValueError("a piece of a reference line of another kind")
    c, d = math.cos(turn), math.sin(turn)
    return x0 + u * c - v * d, y0 + u * d + v * c, heading + turn


def _cubic_curve(curve: Xml.Element, p: Array) -> tuple[Array, Array, Array]:
    (au, bu, cu, du), (av, bv, cv, dv) = ([float(curve.get(f"{k}{axis}", "0")) for k in "abcd"] for axis in "UV")
    heading = np.arctan2(bv + p * (2 * cv + 3 * dv * p), bu + p * (2 * cu + 3 * du * p))
    return au + p * (bu + p * (cu + p * du)), av + p * (bv + p * (cv + p * dv)), heading


_NODES, _WEIGHTS = np.polynomial.legendre.leggauss(5)


def _clothoid(bend: float, slope: float, s: Array) -> tuple[Array, Array, Array]:
    """A curve from the origin along x whose curvature begins so [1/m] and grows so [1/m²], at arc lengths [m]."""
    heading = s * (bend + slope * s / 2)
    if abs(slope) < 1e-12:
        if abs(bend) < 1e-12:
            return s, np.zeros_like(s), np.zeros_like(s)
        return np.sin(heading) / bend, (1 - np.cos(heading)) / bend, heading
    first, last = np.concatenate(([0.0], s[:-1])), s
    parts = 8  # between two points, each by Gauss's rule of five nodes
    edges = first[:, None] + (last - first)[:, None] * np.linspace(0.0, 1.0, parts + 1)[None, :]
    half = np.diff(edges, axis=1)[:, :, None] / 2
    at = (edges[:, :-1, None] + edges[:, 1:, None]) / 2 + half * _NODES
    turn = at * (bend + slope * at / 2)
    u = np.cumsum((np.cos(turn) * _WEIGHTS * half).sum(axis=(1, 2)))
    v = np.cumsum((np.sin(turn) * _WEIGHTS * half).sum(axis=(1, 2)))
    return u, v, heading
