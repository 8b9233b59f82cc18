"""How an ego is held to its orders: its pedals, as they are pressed where it asks for more than it may."""

from __future__ import annotations

from collections.abc import Sequence

from chatscene.terms.actors import Limits
from chatscene.terms.order import Order

ROLLING = 0.1  # [m/s], slower than which who may not move is held with the whole brake


def obeyed(
    orders: Sequence[Order],
    pedals: tuple[float, float],
    *,
    time: float,
    along: float,
    speed: float,
    dt: float,
    limits: Limits,
) -> tuple[float, float]:
    """Throttle and brake for one step: as asked for, unless the ego would then be faster than it may be after it.

    Then the throttle is let go and the brake pressed as far as is needed; what the ego brakes itself counts.

    Args:
        orders: What it is held to.
        pedals: Throttle and brake that it asks for, each in [0, 1].
        time: Since the beginning [s].
        along: Arc length of the ego on its route [m].
        speed: Of the ego [m/s].
        dt: Step [s].
        limits: What its kind of vehicle can do.
    """
    throttle, brake = pedals
    most = min(order.allows(time + dt, along + speed * dt) for order in orders)
    if most == 0.0 and speed < ROLLING:
        return 0.0, 1.0
    if speed + (limits.throttle * throttle - limits.brake * brake) * dt <= most:
        return pedals
    needed = ((speed - most) / dt - limits.drag) / limits.brake
    return 0.0, max(brake, min(max(needed, 0.0), 1.0))
