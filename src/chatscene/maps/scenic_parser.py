"""Have Scenic's parser of maps read what other makers write.

The parser is handed every map in the plain form (`chatscene.maps.plain_form`). Beyond that, it stops at drawings that
are a little off: a lane's edge that runs half a metre outside its area, two lanes that share a strip. Whether one can
drive on such a map is not told by that, so bounds are set here, and `chatscene.maps.survey` tells what lies between.
"""

from __future__ import annotations

import xml.etree.ElementTree as Xml
from contextvars import ContextVar
from typing import Any

import shapely

from chatscene.maps.direct_junctions import join_directly
from chatscene.maps.plain_form import in_plain_form
from chatscene.maps.unread import NEGATIVE

MOST_OUTSIDE = 2.0  # [m] that an edge or a middle may run outside its own area: half a lane, and a car is still on it


_AGAIN: ContextVar[bool] = ContextVar("whether a map is read again", default=False)
_TREE: ContextVar[Xml.ElementTree[Any] | None] = ContextVar("the map that is being read", default=None)


class _Etree:
    """The parser of XML as Scenic's parser of maps asks it."""

    @staticmethod
    def parse(_path: Any) -> Xml.ElementTree[Any]:
        """The tree of the file that is being read, in the plain form."""
        tree = _TREE.get()
        assert tree is not None
        return tree


def outside(element: Any, line: Any) -> float:
    """How far [m] a line of an element of a network runs outside the element's area."""
    area = shapely.union_all(element.polygons)
    points = shapely.points(shapely.get_coordinates(getattr(line, "lineString", None) or line.polygons))
    return float(shapely.distance(area, points).max())


def read_other_makers() -> None:
    """Set Scenic's parser up so; to do it twice changes nothing."""
    from scenic.domains.driving import roads
    from scenic.formats.opendrive import xodr_parser

    if xodr_parser.ET is _Etree:
        return
    setattr(xodr_parser, "ET", _Etree)  # noqa: B010 - a module of somebody else's
    _end_cubics(xodr_parser)
    _bound_widths(xodr_parser)
    _bound_edges(roads)
    _allow_overlaps(roads)
    _hand_over(xodr_parser)
    _read_again(roads)
    _divide_sections(xodr_parser)


def _hand_over(xodr_parser: Any) -> None:
    """Hand every map over in the plain form, and join its direct junctions afterwards."""
    of_network, of_file = xodr_parser.RoadMap.toScenicNetwork, xodr_parser.RoadMap.parse

    def parse(self: Any, path: Any) -> None:
        tree = Xml.parse(path)
        self.plain = tree.getroot()
        in_plain_form(self.plain, again=_AGAIN.get())
        handed = _TREE.set(tree)
        try:
            of_file(self, path)
        finally:
            _TREE.reset(handed)

    def to_network(self: Any) -> Any:
        network = of_network(self)
        join_directly(network, self.plain)
        return network

    xodr_parser.RoadMap.parse = parse
    xodr_parser.RoadMap.toScenicNetwork = to_network


def _read_again(roads: Any) -> None:
    """Read a map again, within wider bounds, if it cannot be read as it is."""
    once = roads.Network.fromOpenDrive.__func__

    def from_opendrive(cls: Any, path: Any, *rest: Any, **named: Any) -> Any:
        try:
            return once(cls, path, *rest, **named)
        except (ArithmeticError, AssertionError, AttributeError, LookupError, RuntimeError, TypeError, ValueError):
            wider = _AGAIN.set(True)
            try:
                return once(cls, path, *rest, **named)
            finally:
                _AGAIN.reset(wider)

    # what Scenic reads a map by is a table of functions
    roads.Network.fromOpenDrive = classmethod(from_opendrive)


def _bound_widths(xodr_parser: Any) -> None:
    """Take widths that are a little negative for none."""
    of_lane = xodr_parser.Lane.width_at

    def width_at(self: Any, s: float) -> float:
        try:
            return of_lane(self, s)
        except RuntimeError as error:  # a negative width
            cubic, start = next(one for one in reversed(self.width) if one[1] <= s)
            if cubic.eval_at(s - start) < -NEGATIVE:
                raise ValueError(f"lane {self.id_} has a negative width") from error
            return 0.0

    xodr_parser.Lane.width_at = width_at


def _end_cubics(xodr_parser: Any) -> None:
    ends = xodr_parser.ParamCubic.point_at

    def point_at(self: Any, s: float) -> Any:
        """The point at an arc length; the last one for what lies a little beyond it."""
        whole = getattr(self, "_whole", None)
        if whole is None:
            whole = self._whole = self.arclength(self.p_range)
        return ends(self, min(s, whole * (1.0 - 1e-9)))

    xodr_parser.ParamCubic.point_at = point_at


def _bound_edges(roads: Any) -> None:
    """Let edges and middles run outside their areas as far as is stated, where Scenic lets them half a metre."""

    def within(element: Any, line: Any, what: str) -> None:
        most = MOST_OUTSIDE if _AGAIN.get() else 0.5
        if not element.containsRegion(line, tolerance=0.5) and (far := outside(element, line)) > most:
            raise ValueError(
                f"{element.uid}: its {what} runs up to {far:.1f} m outside its area, and at most {most:g} m"
            )

    def linear(self: Any) -> None:
        roads.NetworkElement.__attrs_post_init__(self)
        within(self, self.leftEdge, "left edge")
        within(self, self.rightEdge, "right edge")
        if self.orientation is None:
            self.orientation = roads.VectorField(self.name, self._defaultHeadingAt)

    def centred(self: Any) -> None:
        roads.LinearElement.__attrs_post_init__(self)
        beside = isinstance(self, roads.Sidewalk | roads.Shoulder)
        if beside and _AGAIN.get() and outside(self, self.centerline) > MOST_OUTSIDE:
            # Scenic draws its middle between edges of different stretches, where it has gaps
            self.centerline = self.leftEdge
        within(self, self.centerline, "middle")

    def crossing(self: Any) -> None:
        roads.NetworkElement.__attrs_post_init__(self)
        for maneuver in self.maneuvers:
            within(self, maneuver.connectingLane, f"way {maneuver.connectingLane.uid}")
        if self.orientation is None:
            self.orientation = roads.VectorField(self.name, self._defaultHeadingAt)

    roads.LinearElement.__attrs_post_init__ = linear
    roads._ContainsCenterline.__attrs_post_init__ = centred
    roads.Intersection.__attrs_post_init__ = crossing


def _allow_overlaps(roads: Any) -> None:
    """Let lanes share a strip; `chatscene.maps.survey` tells which do."""
    of_section = roads.RoadSection.__attrs_post_init__

    def section(self: Any) -> None:
        try:
            of_section(self)
        except AssertionError:  # the last thing that it does is to look whether lanes overlap
            if not self.lanes:
                raise

    roads.RoadSection.__attrs_post_init__ = section
    roads.LaneGroup.__attrs_post_init__ = roads.LinearElement.__attrs_post_init__


def _divide_sections(xodr_parser: Any) -> None:
    """Put a point of the reference line where each section begins, on whichever piece, when a map is read again.

    Scenic counts where a section begins from the wrong piece if a line has several, and misses short sections.
    """
    of_road = xodr_parser.Road.get_ref_points

    def get_ref_points(self: Any, num: int) -> Any:
        if not _AGAIN.get():
            return of_road(self, num)
        parts: list[list[tuple[float, float, float]]] = []
        start = 0.0
        for piece in self.ref_line:
            begins = [section.s0 - start for section in self.lane_secs[1:] if section.s0 > start]
            parts.append([(x, y, s + start) for x, y, s in piece.to_points(num, extra_points=begins)])
            start = parts[-1][-1][2]
        return parts

    xodr_parser.Road.get_ref_points = get_ref_points
