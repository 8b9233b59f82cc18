"""How soon an ego that nothing holds is somewhere: the pace by which encounters are timed."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Pace:
    """How an ego gets under way.

    Attributes:
        speed: What it drives at where nothing holds it [m/s].
        gain: The acceleration by which what it loses until it drives so is told [m/s²].
    """

    speed: float
    gain: float

    @property
    def loss(self) -> float:
        """What the square of a missing speed costs in time [s per (m/s)²]."""
        return 1.0 / (2.0 * self.gain * self.speed)

    @classmethod
    def of(cls, ego: object) -> Pace:
        """Of an ego in a program: the speed that the program wants of it, else the nominal one."""
        wanted = getattr(ego, "wantedSpeed", None)
        return NOMINAL if wanted is None else cls(speed=float(wanted), gain=NOMINAL.gain)


NOMINAL = Pace(speed=7.8, gain=2.3)
"""Of `idm` on an empty road of the packaged town: 41.5 m in the first 7 s, from standstill."""
