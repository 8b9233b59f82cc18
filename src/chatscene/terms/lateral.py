"""Where across the road somebody is, by the share of the ego's width or by the room beside it."""

from __future__ import annotations

NARROW = 0.5  # of the ego's width: who is narrower is on a point of it, and overlaps no share


def aside_of_ego(name: str, said: float, ego: float, other: float) -> float:
    """How far [m] from the ego's line the middle of somebody is.

    The overlap of somebody narrow, on foot or on two wheels, is where on the ego's width its middle is, from its side.

    Args:
        name: What was said, ``overlap`` or ``clearance``.
        said: How much, as a share of the ego's width or in metres.
        ego: The ego's width [m].
        other: Its own.
    """
    if name == "clearance":
        return 0.5 * (ego + other) + said
    return 0.5 * ego - said * ego + (0.5 * other if other >= NARROW * ego else 0.0)


def seen_of_ego(name: str, aside: float, ego: float, other: float) -> float:
    """What that comes to, the other way round: the overlap or the clearance of somebody so far from the ego's line."""
    if name == "clearance":
        return aside - 0.5 * (ego + other)
    return (0.5 * ego + (0.5 * other if other >= NARROW * ego else 0.0) - aside) / ego
