"""What the ego under test is held to, whatever it asks for: how fast it may be and where it is steered, and when."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Order:
    """An order to the ego: where it holds, the ego is no faster; what it is not ordered stays its own.

    It holds from a time and a place on. Before that the ego is braked in time, as a driver comes to a stop at a line:
    evenly, so that it is slow enough when the order begins. (Names are none that Scenic keeps for itself.)

    Attributes:
        at_most: The most it may drive [m/s]; 0 holds it where it stands.
        since: When it begins to hold [s], from the beginning of the drive.
        till: When it ends [s].
        place: From where on it holds: arc length [m] on the ego's route.
        braking: How hard the ego is braked before it [m/s²].
        at_least: The least it drives [m/s], if no order has it slower: it does not brake, whatever is ahead.
        aside: Where it is steered to, metres to the left of its route; nan leaves the wheel to it.
        over: How long [s] it takes to get there.
        back: How fast it drives backwards [m/s], straight, once it has come to a stand; 0 for not at all.
        whom: The label of somebody. The order is none until the ego is near to that one, or that one is so far in its
            plan, and its times count from then.
        within: How near [m], from middle to middle.
        phase: The number of the phase of its plan, from 0, in which that one then is, or a later one; -1 for none.
        ends: Whether the order ends then, having held from the beginning, and does not begin then.
    """

    at_most: float = math.inf
    since: float = 0.0
    till: float = math.inf
    place: float = -math.inf
    braking: float = 3.0
    at_least: float = 0.0
    aside: float = math.nan
    over: float = 0.0
    back: float = 0.0
    whom: str = ""
    within: float = 0.0
    phase: int = -1
    ends: bool = False

    def allows(self, time: float, along: float) -> float:
        """The most the ego may drive [m/s], so many seconds after it counts and metres along its route."""
        if time >= self.till:
            return math.inf
        in_time = self.at_most + self.braking * max(self.since - time, 0.0)
        in_place = math.sqrt(self.at_most**2 + 2.0 * self.braking * max(self.place - along, 0.0))
        return max(in_time, in_place)

    def holds(self, time: float, along: float) -> bool:
        """Whether it holds so many seconds after it counts, and metres along the ego's route."""
        return self.since <= time < self.till and along >= self.place


def demands(orders: Iterable[tuple[Order, float]], along: float) -> float:
    """The least the ego is to drive [m/s].

    Args:
        orders: Those that count, and for how long [s].
        along: Where it is on its route [m].
    """
    return max((order.at_least for order, time in orders if order.holds(time, along)), default=0.0)


def backs_at(orders: Iterable[tuple[Order, float]], along: float) -> float:
    """How fast the ego is to drive backwards [m/s]; 0 if it is not to.

    Args:
        orders: Those that count, and for how long [s].
        along: Where it is on its route [m].
    """
    return max((order.back for order, time in orders if order.holds(time, along)), default=0.0)


def steers_to(orders: Sequence[tuple[Order, float]], along: float) -> float:
    """How far [m] to the left of its route the ego is steered to, by the last order that says so; nan if by none."""
    left = math.nan
    for order, time in orders:
        if not math.isnan(order.aside) and order.holds(time, along):
            done = (time - order.since) / order.over if order.over > 0.0 else 1.0
            left = order.aside * (done if done < 1.0 else 1.0)
    return left
