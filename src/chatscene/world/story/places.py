"""Places of a story.

('at', x, y, heading)               on the map
('beside', whom, x, y, heading)     in the frame of somebody's origin, as it is when it is asked for
('beside', whom, x, y, heading, place turns, heading turns)     the same; without a turn, along the axes of the map
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

from chatscene.world.story.entities import Entity

AWAY = 5_000.0  # [m] along x and y from its place, where somebody is who is not there


@dataclass(frozen=True, slots=True)
class Place:
    """A place that may move.

    Attributes:
        pose: Where it is now: x [m], y [m], heading [rad].
        velocity: How it moves [m/s], without what the turning of its frame does.
    """

    pose: Callable[[], tuple[float, float, float]]
    velocity: Callable[[], tuple[float, float]]


def place_of(told: tuple[Any, ...], entity: Callable[[str], Entity]) -> Place:
    """A place.

    Raises:
        ValueError: There is no such place.
    """
    match told:
        case ("at", x, y, heading):
            return Place(lambda: (x, y, heading), lambda: (0.0, 0.0))
        case ("beside", whom, x, y, heading, *turns):
            who, (place_turns, heading_turns) = entity(whom), turns or (True, True)

            def pose() -> tuple[float, float, float]:
                fx, fy, turn = who.origin
                there = moved((fx, fy, turn if place_turns else 0.0), x, y, 0.0)
                return *there[:2], heading + (turn if heading_turns else 0.0)

            return Place(pose, lambda: who.velocity)
        case _:
            raise ValueError(f"a story has no place {told!r}")


def moved(frame: tuple[float, float, float], x: float, y: float, heading: float) -> tuple[float, float, float]:
    """A pose told in a frame, on the map."""
    fx, fy, turn = frame
    c, s = math.cos(turn), math.sin(turn)
    return fx + x * c - y * s, fy + x * s + y * c, turn + heading
