"""Where across the road somebody is, by the share of the ego's width or by the room beside it."""

from __future__ import annotations

from chatscene.terms.vocabulary import NOSE_TO_TAIL, Where

PLACED_IN_OURS = frozenset((Where.AHEAD, Where.BEHIND, Where.ONCOMING_IN_OUR_LANE, Where.KERB))
"""Places in the ego's lane or at its edge, where a start may have an offset, an edge, an overlap or a clearance."""
PLACED = PLACED_IN_OURS | NOSE_TO_TAIL | {Where.BESIDE, Where.ONCOMING}
"""All places where a start may have one of these."""
PLACED_BEYOND = frozenset((Where.ROADSIDE, Where.CROSSING, Where.DRIVEWAY, Where.EXIT_CROSSING))
"""Places beside the road, where a start may be so far beyond the lanes."""


def _named(places: frozenset[Where]) -> str:
    return ", ".join(one for one in Where if one in places)


LATERAL_OF_STARTS = (
    f"starts.lateral is built by offset, edge, overlap or clearance where starts.where is {_named(PLACED)}, "
    f"of the {Where.KERB} the right one; "
    f"by beyond where it is {_named(PLACED_BEYOND)}"
)
"""Where it is built what is said of a start across the road, in words."""
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
