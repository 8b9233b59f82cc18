"""What a viewer needs to draw a map from above, as plain numbers."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import Any, cast

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from chatscene.maps.furniture import furniture_of
from chatscene.maps.junctions import junction_signals
from chatscene.maps.neighbours import opposes, section_beside
from chatscene.terms.route import Route

Points = list[list[float]]
MARGIN = 60.0  # [m] of map drawn around what happens
STRIPE = 0.5  # [m], of a crosswalk
RAIL = 0.1  # of the width of a track, as a rail is drawn
SIMPLIFY = 0.02  # [m]; less than a pixel at any useful zoom


def map_drawing(network: Any, box: tuple[float, float, float, float]) -> dict[str, Any]:
    """The part of a map inside a box, ready for JSON.

    Args:
        network: Scenic's road network.
        box: West, south, east, north [m], map frame.

    Returns:
        Points are [x, y] in metres, rounded to 1 cm.

        - ``roads``, ``junctions``, ``shoulders``, ``sidewalks``, and where there are any ``cycle_lanes`` and
          ``driveways``: polygons, each a list of rings, the outer first;
        - ``lane_boundaries``: ``{"kind": "solid" | "dashed" | "centre", "points": [...]}``, where ``centre``
          parts opposite directions and ``solid`` is the edge of the carriageway;
        - ``stop_lines``: ``{"control": "signal" | "stop-sign", "points": [...]}``;
        - ``crosswalks`` and ``rails``, where there are any: the polygons of their stripes, and of single rails.
    """
    if network.mirrored:
        west, south, east, north = box
        return _mirrored(_drawn(network, (west, -north, east, -south)))
    return _drawn(network, box)


def _mirrored(drawing: Any) -> Any:
    """The same in the mirror: each point on the other side of the x axis."""
    if isinstance(drawing, dict):
        return {name: _mirrored(part) for name, part in cast("dict[str, Any]", drawing).items()}
    if not isinstance(drawing, list):
        return drawing
    parts = cast("list[Any]", drawing)
    if parts and isinstance(parts[0], float):
        x, y = parts
        return [x, 0.0 - y]
    return [_mirrored(part) for part in parts]


def _drawn(network: Any, box: tuple[float, float, float, float]) -> dict[str, Any]:
    """The part of a map inside a box, as it was read."""
    frame = shapely.box(*box)
    furniture = furniture_of(network)
    some = {
        "cycle_lanes": furniture.cycle_lanes.values(),
        "driveways": (area for _, area in furniture.driveways),
        "crosswalks": (stripe for _, area in furniture.crosswalks for stripe in _stripes(area)),
        "rails": (rail for _, area, _ in furniture.tracks for rail in _rails(area)),
    }
    return {
        "roads": _polygons((road.polygons for road in network.roads), frame),
        "junctions": _polygons((junction.polygons for junction in network.intersections), frame),
        "shoulders": _polygons((shoulder.polygons for shoulder in network.shoulders), frame),
        "sidewalks": _polygons((sidewalk.polygons for sidewalk in network.sidewalks), frame),
        "lane_boundaries": [
            {"kind": kind, "points": points} for kind, line in _boundaries(network) for points in _lines(line, frame)
        ],
        "stop_lines": [
            {"control": line.control.value, "points": _rounded([(line.x0, line.y0), (line.x1, line.y1)])}
            for junction in network.intersections
            if frame.intersects(junction.polygons)
            for line in junction_signals(network, junction.uid)
            if line.control != "none" and frame.contains(shapely.Point(line.x0, line.y0))
        ],
        **{kind: there for kind, areas in some.items() if (there := _polygons(areas, frame))},
    }


def _long_sides(area: shapely.Polygon) -> tuple[Any, Any, Any, Any]:
    """The corners of the box around an area, so that from the first to the second is one of its long sides."""
    box: Any = area.minimum_rotated_rectangle
    a, b, c, d, _ = np.array(box.exterior.coords)
    return (b, c, d, a) if np.hypot(*(b - a)) < np.hypot(*(d - a)) else (a, b, c, d)


def _rails(track: shapely.Polygon) -> Iterator[shapely.Polygon]:
    """The two rails of a track."""
    a, b, c, d = _long_sides(track)
    for first, last in ((0.0, RAIL), (1.0 - RAIL, 1.0)):
        yield shapely.Polygon([a + first * (d - a), b + first * (c - b), b + last * (c - b), a + last * (d - a)])


def _stripes(crosswalk: shapely.Polygon) -> Iterator[shapely.Polygon]:
    """The painted stripes of a crosswalk, side by side across its street."""
    a, b, c, d = _long_sides(crosswalk)
    count = max(int(np.hypot(*(b - a)) / (2 * STRIPE)), 1)
    for number in range(count):
        first, last = (number + 0.25) / count, (number + 0.75) / count
        yield shapely.Polygon([a + first * (b - a), a + last * (b - a), d + last * (c - d), d + first * (c - d)])


def _boundaries(network: Any) -> Iterator[tuple[str, BaseGeometry]]:
    """The kind and the line of each lane boundary outside junctions, once each."""
    for road in network.roads:
        for section in road.sections:
            for lane in section.lanes:
                left, right = section_beside(lane, 1), section_beside(lane, -1)
                if left is None:
                    yield "solid", _line(lane.leftEdge)
                elif not opposes(lane.lane, left.lane):
                    yield "dashed", _line(lane.leftEdge)
                elif (lane.isForward, lane.uid) > (left.isForward, left.uid):  # whose own left edge is the same line
                    yield "centre", _line(lane.leftEdge)
                if right is None:
                    yield "solid", _line(lane.rightEdge)


def _line(edge: Any) -> BaseGeometry:
    return shapely.LineString(np.array(edge.points)[:, :2])


def drawing_around(network: Any, points: NDArray[np.float64]) -> dict[str, Any]:
    """The map around some points [m], an array of n x 2 in the map frame, as `map_drawing` gives it."""
    (x0, y0), (x1, y1) = points.min(axis=0) - MARGIN, points.max(axis=0) + MARGIN
    return map_drawing(network, (float(x0), float(y0), float(x1), float(y1)))


def routes_drawing(network: Any, routes: Mapping[str, Route]) -> dict[str, Any]:
    """The map around some routes, and the routes, ready for JSON.

    Args:
        network: Scenic's road network.
        routes: By name, as they lie on the map; none for the whole map.

    Returns:
        As `map_drawing`, and ``routes``: by name, points [x, y] in metres.
    """
    lines = [route.line.points for route in routes.values()]
    x0, y0, x1, y1 = network.drivableRegion.polygons.bounds
    if network.mirrored:
        y0, y1 = -y1, -y0
    drawing = drawing_around(network, np.concatenate(lines or [np.array(((x0, y0), (x1, y1)))]))
    return {**drawing, "routes": {name: route.line.points.round(2).tolist() for name, route in routes.items()}}


def _polygons(areas: Iterable[BaseGeometry], frame: BaseGeometry) -> list[list[Points]]:
    parts = [part for area in areas for part in _clipped(area, frame, "Polygon")]
    return [[_rounded(ring.coords) for ring in (part.exterior, *part.interiors)] for part in parts]


def _lines(line: BaseGeometry, frame: BaseGeometry) -> list[Points]:
    return [_rounded(part.coords) for part in _clipped(line, frame, "LineString")]


def _clipped(shape: BaseGeometry, frame: BaseGeometry, kind: str) -> list[Any]:
    """The parts of a shape inside the frame that are of one kind; touching points and edges are left out."""
    if not frame.intersects(shape):
        return []
    inside = shape.intersection(frame).simplify(SIMPLIFY)
    return [part for part in shapely.get_parts(inside) if part.geom_type == kind and not part.is_empty]


def _rounded(points: Iterable[Iterable[float]]) -> Points:
    return [[round(float(x), 2) + 0.0, round(float(y), 2) + 0.0] for x, y, *_ in points]
