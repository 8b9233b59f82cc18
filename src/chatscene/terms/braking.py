"""How somebody brakes who takes over the ego's pedals: when, how hard, how soon, and when that is over."""

from __future__ import annotations

from dataclasses import dataclass

STANDSTILL = 3.0  # [s] of standing after which nothing more is to come
STANDING = 0.01  # [m/s]


@dataclass(frozen=True, slots=True, kw_only=True)
class Braking:
    """The ego's own drive until a step; from then on its steering, and braking that rises evenly.

    Attributes:
        begins: The step from which on the brake is pressed.
        full: How hard it comes to be [m/s²].
        ramp: How long until it is [s].
        over: The step after which the drive is over once the ego has stood for `STANDSTILL`.
    """

    begins: int
    full: float
    ramp: float
    over: int

    def wish(self, step: int, dt: float) -> float:
        """The deceleration asked for in a step [m/s²]; 0 before it begins; `dt` [s] is the length of a step."""
        return 0.0 if step < self.begins else self.full * min(1.0, (step - self.begins + 1) * dt / self.ramp)
