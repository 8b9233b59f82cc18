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
        distance: Least gap between the ego and an adversary [m], 0 in a contact; None where there was none.
        impact_speed: Speed of approach at the collision [m/s], 0 without one.
        completion: Share of the route that the ego drove, in [0, 1].
        avoidable: Whether a careful driver would have avoided the collision; None without one, and where the search
            does not ask.
        by_ego: Whether it was the ego that struck.
        crash_type: Of which kind the collision is (`chatscene.measure.crash_type`); empty without one.
        waits: Whether the ego waits at the end behind somebody who does not move on; False where nobody asks.
        touch: Whether it was said that there is a contact; None where nothing was said of one.
    """

    values: Mapping[str, float]
    collided: bool
    distance: float | None
    impact_speed: float
    completion: float
    avoidable: bool | None = None
    by_ego: bool = False
    crash_type: str = ""
    waits: bool = False
    touch: bool | None = None

    @property
    def crashed(self) -> bool:
        """Whether the ego collided, and may have: a search is for that, but where no contact was said it is against."""
        return self.collided and self.touch is not False

    @property
    def danger(self) -> float:
        """What a search maximises: nearness below 1, a collision above, the more the faster.

        In (0, 2] where nobody asks who could have helped it. Where somebody does, a collision that nobody helps is in
        [1, 2], an avoidable one in which the ego was struck in [2, 3], one in which the ego struck in [3, 4]; to wait
        behind somebody is as harmless as to meet nobody. Where it was said that there is no contact, a collision is
        less than to meet nobody, and the less the faster.
        """
        if self.collided and self.touch is False:
            return 1.0 / (2.0 + NOWHERE + self.impact_speed)
        if self.collided:
            tier = (1 + self.by_ego) if self.avoidable else 0
            return 1.0 + tier + min(self.impact_speed / FULL_IMPACT, 1.0)
        return 1.0 / (1.0 + (NOWHERE if self.distance is None or self.waits else self.distance))
