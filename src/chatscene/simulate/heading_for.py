"""Where the ego of a user's program is to go, as far as the program says: by its behavior, else by its lane."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from scenic.domains.driving.roads import Lane

from chatscene.maps.onward import LENGTH, route_onward
from chatscene.terms.route import Route


def route_of_ego(scene: Any, map_name: str) -> Route:
    """The route of a scene's ego.

    It goes by the lanes that the ego's behavior is given to follow; else by a list of lanes in the program that begins
    where the ego stands; else by its lane. From there on, by the straightest lanes.

    Args:
        scene: Scenic's scene.
        map_name: Goes into the route.

    Raises:
        MapError: The ego stands on no lane, or its lane ends too soon.
    """
    ego, network = scene.egoObject, scene.workspace.network
    x, y = float(ego.position.x), float(ego.position.y)
    said = [lanes for lanes in (*_given(ego.behavior), *_written(scene)) if _within(lanes[0], x, y)]
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
    """Lists of lanes among the program's own names."""
    for namespace, sampled, _ in scene.behaviorNamespaces.values():
        if "ego" in namespace or "ego" in sampled:
            yield from (list(value) for name, value in sorted(sampled.items()) if _is_way(value) and name != "ego")


def _is_way(value: Any) -> bool:
    return isinstance(value, list | tuple) and len(value) > 1 and all(map(_is_lane, value))


def _is_lane(value: Any) -> bool:
    return isinstance(value, Lane)


def _within(lane: Any, x: float, y: float) -> bool:
    return bool(lane.containsPoint((x, y)))
