"""When two bodies touch, where, and how fast they met: for all simulators, so that a collision means one thing.

Bodies are held against each other as they stand after a step. At 30 m/s one goes 3 m in that, through a corner of
another or, at 70 m/s of approach, through a bicycle. So the way between two steps is looked at as well (`met`): always
in a drive at a speed that was asked for, else only where two come farther than `SWEPT` nearer in one step. Below that
nothing is looked at that was not always (decision 0126), and numbers on record stay.
"""

from __future__ import annotations

import math

from chatscene.terms.episode import Track
from chatscene.world.bodies import Body

SWEPT = 2.0  # [m] of a step: 20 m/s at 0.1 s, and more than any two of the benchmark's come nearer in one
CORNER = 0.45  # [m], a quarter of a car's width: what is touched on no more of its front is struck at a corner
FINE = 0.1  # [m] that two move past each other between two looks

Was = tuple[float, float, float]
"""Where a body was before a step: x [m], y [m], heading [rad]."""


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


def met(a: Body, b: Body, a_was: Was, b_was: Was, swept: float) -> float | None:
    """How long before the end of a step two bodies began to touch, as a share of it; None if they do not.

    They did not touch before the step. Between the steps, centres are taken to move evenly and bodies to turn evenly,
    and are looked at after every `FINE`.

    Args:
        a: As it is after the step.
        b: The same.
        a_was: Where it was before.
        b_was: The same.
        swept: How far they must have moved past each other [m] to be looked at between the steps.
    """
    dx, dy = b.x - a.x, b.y - a.y
    mx, my = dx - (b_was[0] - a_was[0]), dy - (b_was[1] - a_was[1])
    moved = math.sqrt(mx * mx + my * my)
    if moved > swept:
        reach = a.radius + b.radius + moved
        if dx * dx + dy * dy > reach * reach:
            return None
        parts = math.ceil(moved / FINE)
        for part in range(1, parts):
            share = part / parts
            if touch(between(a, a_was, share), between(b, b_was, share)):
                return 1.0 - share
    return 0.0 if touch(a, b) else None


def between(body: Body, was: Was, share: float) -> Body:
    """A body as it was when a share of the last step was over."""
    x, y, heading = was
    return Body(
        x + (body.x - x) * share,
        y + (body.y - y) * share,
        heading + (body.heading - heading) * share,
        body.length,
        body.width,
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
    return min(_depths(ego, other), key=lambda side: side[1])[0]


def _depths(ego: Body, other: Body) -> tuple[tuple[str, float], tuple[str, float]]:
    """The side across the ego and the one along it that are nearer to the other, and how deep [m] it is in each."""
    dx, dy = other.x - ego.x, other.y - ego.y
    along, across = dx * ego.cos + dy * ego.sin, dy * ego.cos - dx * ego.sin
    c = abs(ego.cos * other.cos + ego.sin * other.sin)
    s = abs(ego.cos * other.sin - ego.sin * other.cos)
    depth_along = ego.half_length + other.half_length * c + other.half_width * s - abs(along)
    depth_across = ego.half_width + other.half_length * s + other.half_width * c - abs(across)
    return ("left" if across > 0 else "right", depth_across), ("front" if along > 0 else "rear", depth_along)


def sides_touched(track: Track, by: Track, step: int, earlier: float = 0.0) -> frozenset[str]:
    """The sides of what a track is of that another touches: both at a corner, no more than `CORNER` of either.

    Args:
        track: Of what is touched.
        by: Of who touches it.
        step: At which step; at the last if there are fewer.
        earlier: How long before, as a share of a step.
    """
    first, second = sorted(_depths(_at(track, step, earlier), _at(by, step, earlier)), key=lambda side: side[1])
    return frozenset((first[0], second[0]) if second[1] < CORNER else (first[0],))


def side_touched(track: Track, by: Track, step: int, earlier: float = 0.0) -> str:
    """Where on what a track is of another touches it, as `contact_side` says.

    Args:
        track: Of what is touched.
        by: Of who touches it.
        step: At which step; at the last if there are fewer.
        earlier: How long before, as a share of a step.
    """
    return contact_side(_at(track, step, earlier), _at(by, step, earlier))


def _at(track: Track, step: int, earlier: float) -> Body:
    return Body(*track.pose(step, earlier), track.length, track.width)


def approach_speed(a: Body, b: Body, a_heading: float, b_heading: float) -> float:
    """Relative speed [m/s] of two bodies: the magnitude of the difference of their velocities before the step.

    Args:
        a: As it is after the step.
        b: The same.
        a_heading: Where it headed before [rad].
        b_heading: The same.
    """
    x = a.before * math.cos(a_heading) - b.before * math.cos(b_heading)
    return math.hypot(x, a.before * math.sin(a_heading) - b.before * math.sin(b_heading))
