"""What a program orders the ego under test, so that it does at the pedals what a text says of it."""

from __future__ import annotations

from dataclasses import dataclass

from chatscene.terms.scenario import EgoState


@dataclass(frozen=True, slots=True, kw_only=True)
class Ordered:
    """How a state of the ego is brought about.

    Attributes:
        source: The order (`chatscene.terms.order.Order`), as Scenic writes it.
        words: The same for a reader.
    """

    source: str
    words: str


_LINE = "egoRoute.eventAt - 4"  # the nose is then before the line of the junction, if there is one
_THERE = "by where its manoeuvre begins, or by the line"

ORDERS: dict[EgoState, Ordered] = {
    EgoState.STANDS: Ordered(source="Order(at_most=0)", words="it is held where it stands, all the time"),
    EgoState.SETS_OFF: Ordered(
        source="Order(at_most=0, till=1.5)", words="it is held where it stands for 1.5 s, and drives as it likes then"
    ),
    EgoState.SLOW: Ordered(source="Order(at_most=2.5)", words="it drives at most 2.5 m/s (9 km/h)"),
    EgoState.SLOWS_DOWN: Ordered(
        source=f"Order(at_most=2, place={_LINE}, braking=2.5)",
        words=f"it is braked with 2.5 m/s² to 2 m/s (7 km/h) {_THERE}",
    ),
    EgoState.BRAKES: Ordered(
        source=f"Order(at_most=1, place={_LINE}, braking=6)",
        words=f"it is braked hard, with 6 m/s², to 1 m/s (4 km/h) {_THERE}",
    ),
    EgoState.STOPS: Ordered(
        source=f"Order(at_most=0, place={_LINE})", words=f"it is braked with 3 m/s² to a stop {_THERE}, and held there"
    ),
}
