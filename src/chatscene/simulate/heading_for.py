"""Where the ego of a user's program is to go, as far as the program says: by its behavior, else by its lane."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from scenic.core.regions import PolylineRegion
from scenic.domains.driving.roads import Lane
from shapely import LineString

from chatscene.maps.onward import LENGTH, SHORTEST, route_onward, route_through
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route

NEAR = 3.0  # [m] of the ego within which a line begins that is its way


def route_of_ego(scene: Any, map_name: str) -> Route:
    """The route of a scene's ego.

    It goes by the lanes that the ego's behavior is given to follow; else by a list of lanes in the program that begins
    where the ego stands; from there on, by the straightest lanes. Else it goes along a line of points in the program
    that begins there; else by its lane and the straightest after it.

    Args:
        scene: Scenic's scene.
        map_name: Goes into the route.

    Raises:
        MapError: The ego stands on no lane, or its lane ends too soon.
    """
    ego, network = scene.egoObject, scene.workspace.network
    x, y = float(ego.position.x), float(ego.position.y)
    said = [lanes for lanes in (*_given(ego.behavior), *_written(scene)) if _within(lanes[0], x, y)]
    if not said and (line := next(_lines(scene, x, y, float(ego.heading)), None)) is not None:
        return route_through(network, map_name, line)
    lanes = said[0] if said else ()
    length = max(LENGTH, sum(lane.centerline.length for lane in lanes)) if lanes else LENGTH
    return route_onward(network, map_name, (x, y), lanes, min(length, 2 * LENGTH))


def _given(behavior: Any) -> Iterator[list[Any]]:
    """Lanes that a behavior is given: a list of them, or one."""
    if behavior is not None:
        for value in (*behavior._args, *behavior._kwargs.values()):
            if _is_way(value):
                yield list(value)
            elif _is_lane(value):
                yield [value]


def _written(scene: Any) -> Iterator[list[Any]]:
    """Lists of lanes among the program's own names, those that are called the ego's first."""
    for named in _named(scene):
        ways = sorted((not name.lower().startswith("ego"), name) for name, value in named.items() if _is_way(value))
        yield from (list(named[name]) for _, name in ways)


def _lines(scene: Any, x: float, y: float, heading: float) -> Iterator[list[tuple[float, float]]]:
    """Lines among the program's own names that begin where the ego stands, along its heading: the rest of each [m]."""
    for named in _named(scene):
        for _, value in sorted(named.items()):
            if isinstance(value, PolylineRegion) and isinstance(value.lineString, LineString):
                line = Polyline([point[:2] for point in value.lineString.coords])
                along = line.project(x, y)[0]
                turned = math.remainder(line.heading_at(along) - math.pi / 2 - heading, math.tau)
                near = math.dist((x, y), line.point_at(along)) < NEAR and along < NEAR
                if near and abs(turned) < math.pi / 4 and line.length - along >= SHORTEST:
                    yield line.between(along, line.length).points.tolist()


def _named(scene: Any) -> Iterator[dict[str, Any]]:
    """What the names of a program stand for in a scene: of the module that places the ego."""
    for namespace, sampled, _ in scene.behaviorNamespaces.values():
        named = {**getattr(namespace, "module", namespace), **sampled}
        if "ego" in named:
            yield named


def _is_way(value: Any) -> bool:
    return isinstance(value, list | tuple) and len(value) > 1 and all(map(_is_lane, value))


def _is_lane(value: Any) -> bool:
    return isinstance(value, Lane)


def _within(lane: Any, x: float, y: float) -> bool:
    return bool(lane.containsPoint((x, y)))
