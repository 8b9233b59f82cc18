"""When two bodies touch, where, and how fast they met: for all simulators, so that a collision means one thing."""

from __future__ import annotations

import math

from chatscene.terms.episode import Track
from chatscene.world.bodies import Body


def touch(a: Body, b: Body) -> bool:
    """Whether the oriented boxes of two bodies overlap (separating axes, two per box)."""
    dx, dy = b.x - a.x, b.y - a.y
    reach = a.radius + b.radius
    if dx * dx + dy * dy > reach * reach:
        return False
    c = abs(a.cos * b.cos + a.sin * b.sin)
    s = abs(a.cos * b.sin - a.sin * b.cos)
    return (
        abs(dx * a.cos + dy * a.sin) <= a.half_length + b.half_length * c + b.half_width * s
        and abs(dy * a.cos - dx * a.sin) <= a.half_width + b.half_length * s + b.half_width * c
        and abs(dx * b.cos + dy * b.sin) <= b.half_length + a.half_length * c + a.half_width * s
        and abs(dy * b.cos - dx * b.sin) <= b.half_width + a.half_length * s + a.half_width * c
    )


def depth(a: Body, b: Body) -> float:
    """How deep the oriented boxes of two bodies are in each other [m], along the axis where it is least.

    Apart it is negative, and not the distance; far apart it is minus infinity.
    """
    dx, dy = b.x - a.x, b.y - a.y
    reach = a.radius + b.radius
    if dx * dx + dy * dy > reach * reach:
        return -math.inf
    c = abs(a.cos * b.cos + a.sin * b.sin)
    s = abs(a.cos * b.sin - a.sin * b.cos)
    return min(
        a.half_length + b.half_length * c + b.half_width * s - abs(dx * a.cos + dy * a.sin),
        a.half_width + b.half_length * s + b.half_width * c - abs(dy * a.cos - dx * a.sin),
        b.half_length + a.half_length * c + a.half_width * s - abs(dx * b.cos + dy * b.sin),
        b.half_width + a.half_length * s + a.half_width * c - abs(dy * b.cos - dx * b.sin),
    )


def contact_side(ego: Body, other: Body) -> str:
    """Where on the ego the other touches: ``front``, ``rear``, ``left`` or ``right``.

    The axis of the ego along which the two are less deep in each other is the one they met along.
    """
    dx, dy = other.x - ego.x, other.y - ego.y
    along, across = dx * ego.cos + dy * ego.sin, dy * ego.cos - dx * ego.sin
    c = abs(ego.cos * other.cos + ego.sin * other.sin)
    s = abs(ego.cos * other.sin - ego.sin * other.cos)
    depth_along = ego.half_length + other.half_length * c + other.half_width * s - abs(along)
    depth_across = ego.half_width + other.half_length * s + other.half_width * c - abs(across)
    if depth_along < depth_across:
        return "front" if along > 0 else "rear"
    return "left" if across > 0 else "right"


def side_touched(track: Track, by: Track, step: int) -> str:
    """Where on what a track is of another touches it at a step, or at its last: as `contact_side` says."""
    return contact_side(_at(track, step), _at(by, step))


def _at(track: Track, step: int) -> Body:
    there = min(step, len(track.x) - 1)
    return Body(float(track.x[there]), float(track.y[there]), float(track.heading[there]), track.length, track.width)


def approach_speed(a: Body, b: Body) -> float:
    """Relative speed [m/s] of two bodies: the magnitude of the difference of their velocities before the step."""
    return math.hypot(a.before * a.cos - b.before * b.cos, a.before * a.sin - b.before * b.sin)
