"""How an ego is held to its orders: its pedals, where it asks for more or less than it may, and its wheel."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field

from chatscene.terms.actors import Limits
from chatscene.terms.order import Order, backs_at, demands, steers_to
from chatscene.terms.polyline import Polyline
from chatscene.world.control import pedals as pedals_for
from chatscene.world.control import wheel_to

ROLLING = 0.1  # [m/s], slower than which who may not move is held with the whole brake


@dataclass(slots=True)
class Obedience:
    """An ego that is held to its orders.

    Attributes:
        met: Since when [s] each counts; inf of one that waits for somebody, and of one that is over since it has met.
    """

    orders: Sequence[Order]
    met: list[float] = field(init=False)
    waits: list[bool] = field(init=False)

    def __post_init__(self) -> None:
        self.waits = [bool(order.whom) for order in self.orders]
        self.met = [math.inf if order.whom and not order.ends else 0.0 for order in self.orders]

    def meet(self, number: int, time: float, distance: float, phase: int) -> None:
        """See whom an order waits for.

        Args:
            number: Of the order.
            time: Since the beginning [s].
            distance: From the ego [m], from middle to middle.
            phase: The number of the phase in which that one is of its plan.
        """
        order = self.orders[number]
        if self.waits[number] and (distance <= order.within or 0 <= order.phase <= phase):
            self.waits[number] = False
            self.met[number] = math.inf if order.ends else time

    def since(self, time: float) -> Iterator[tuple[Order, float]]:
        """Every order, and for how long [s] it counts; -inf of one that does not yet."""
        return ((one, time - met) for one, met in zip(self.orders, self.met, strict=True))

    def counting(self, time: float) -> list[tuple[Order, float]]:
        """The orders that count, and for how long [s]."""
        return [(one, time - met) for one, met in zip(self.orders, self.met, strict=True) if met < math.inf]

    def pedals(
        self, asked: tuple[float, float], *, time: float, along: float, speed: float, dt: float, limits: Limits
    ) -> tuple[float, float]:
        """Throttle and brake for one step: as asked for, unless the ego would be faster or slower than it is ordered.

        If it would be faster, the throttle is let go and the brake pressed as far as is needed; what it brakes itself
        counts. If it would be slower, it is kept at the speed.

        Args:
            asked: Throttle and brake that it asks for, each in [0, 1].
            time: Since the beginning [s].
            along: Arc length of the ego on its route [m].
            speed: Of the ego [m/s].
            dt: Step [s].
            limits: What its kind of vehicle can do.
        """
        throttle, brake = asked
        orders = self.counting(time)
        most = min((order.allows(for_time + dt, along + speed * dt) for order, for_time in orders), default=math.inf)
        if most == 0.0 and speed < ROLLING:
            return 0.0, 1.0
        after = speed + (limits.throttle * throttle - limits.brake * brake) * dt
        if after <= most:
            least = demands(orders, along)
            return pedals_for(speed, least) if after < least <= most else asked
        needed = ((speed - most) / dt - limits.drag) / limits.brake
        return 0.0, max(brake, min(max(needed, 0.0), 1.0))

    def backs(self, *, time: float, along: float, speed: float) -> tuple[float, float, bool] | None:
        """Throttle, brake and gear of an ego that is to drive backwards, or still does; None of any other.

        Args:
            time: Since the beginning [s].
            along: Arc length of the ego on its route [m].
            speed: Of the ego [m/s].
        """
        wish = backs_at(self.counting(time), along)
        if wish > 0.0 and speed <= ROLLING:
            return (*pedals_for(-speed, wish), True)
        return (0.0, 1.0, False) if wish > 0.0 or speed < -ROLLING else None

    def steer(
        self, asked: float, *, time: float, line: Polyline, along: float, pose: tuple[float, float, float, float],
        limits: Limits,
    ) -> float:  # fmt: skip
        """Steering for one step, in [-1, 1]: as asked for, unless the ego is steered to somewhere beside its route."""
        left = steers_to(self.counting(time), along)
        if math.isnan(left):
            return asked
        return wheel_to(line, along, pose, left, limits.wheelbase, limits.wheel_angle)
