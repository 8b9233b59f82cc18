"""When two bodies touch, where, and how fast they met."""

from __future__ import annotations

from chatscene.simulate.embedded.dynamics import Body

_NEAR_END = 0.9  # beyond this share of the half length, a contact counts as front or rear


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


def contact_side(ego: Body, other: Body) -> str:
    """Where on the ego the other touches: ``front``, ``rear``, ``left`` or ``right``.

    The nearest point of the other's outline (corners and centre projected onto the ego's box) decides: it lies
    at an end if it is further out along the ego than its flank region, else on a flank.
    """
    along, across = 0.0, 0.0
    nearest = float("inf")
    for u, v in ((1, 1), (1, -1), (-1, 1), (-1, -1), (0, 0), (1, 0), (-1, 0), (0, 1), (0, -1)):
        px = other.x + u * other.half_length * other.cos - v * other.half_width * other.sin - ego.x
        py = other.y + u * other.half_length * other.sin + v * other.half_width * other.cos - ego.y
        ahead, left = px * ego.cos + py * ego.sin, py * ego.cos - px * ego.sin
        outside = max(abs(ahead) - ego.half_length, 0.0) ** 2 + max(abs(left) - ego.half_width, 0.0) ** 2
        if outside < nearest:
            along, across, nearest = ahead, left, outside
    if along >= _NEAR_END * ego.half_length:
        return "front"
    if along <= -_NEAR_END * ego.half_length:
        return "rear"
    return "left" if across >= 0 else "right"


def approach_speed(a: Body, b: Body) -> float:
    """Relative speed [m/s] of two bodies (magnitude of the difference of their velocities)."""
    dvx = a.speed * a.cos - b.speed * b.cos
    dvy = a.speed * a.sin - b.speed * b.sin
    return float((dvx * dvx + dvy * dvy) ** 0.5)
