"""What a search is told of a scene that was driven."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

FULL_IMPACT = 20.0  # [m/s] of approach: from here on a collision counts as the worst
NOWHERE = 100.0  # [m]: how far away an adversary counts that was never there


@dataclass(frozen=True, slots=True, kw_only=True)
class Outcome:
    """One scene and how it went.

    Attributes:
        values: Of its parameters, in their units.
        collided: Whether the ego did.
        distance: Least gap between the ego and an adversary [m], 0 in a contact; None where there was none.
        impact_speed: Speed of approach at the collision [m/s], 0 without one.
        completion: Share of the route that the ego drove, in [0, 1].
    """

    values: Mapping[str, float]
    collided: bool
    distance: float | None
    impact_speed: float
    completion: float

    @property
    def danger(self) -> float:
        """What a search maximises, in (0, 2]: nearness below 1, a collision above, the more the faster."""
        if self.collided:
            return 1.0 + min(self.impact_speed / FULL_IMPACT, 1.0)
        return 1.0 / (1.0 + (NOWHERE if self.distance is None else self.distance))
