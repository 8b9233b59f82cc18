"""The ten metrics of an ego, their levels and the overall score, as nouns.

Paper: appendix "Detailed Metric"; constants and weights: SafeBench, ``metric_util.py``.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Mode(StrEnum):
    """How the ten numbers are computed."""

    PAPER = "paper"  # every quirk of the reference code
    CORRECTED = "corrected"  # yaw unwrapped, unfinished runs not rewarded, values clipped into [0, 1]


@dataclass(frozen=True, slots=True, kw_only=True)
class Measurements:
    """The raw numbers of one episode.

    Attributes:
        collided: The ego hit a vehicle, walker or static actor.
        red_lights: Red lights run.
        stop_signs: Stop signs ignored.
        off_road: Metres driven off the driving lanes [m].
        distance_to_route: Mean distance to the route [m].
        completion: Share of the route that counts as driven (`Episode.completion`), in [0, 1].
        time: Duration [s] if the ego arrived, else None.
        acceleration: Mean magnitude of acceleration [m/s²].
        yaw_rate: Summed change of yaw over duration [rad/s], a full turn for each crossing of ±π.
        yaw_rate_unwrapped: The same without those turns [rad/s].
        lane_invasions: Number of lane invasions.
        duration: Duration [s].
    """

    collided: bool
    red_lights: int
    stop_signs: int
    off_road: float
    distance_to_route: float
    completion: float
    time: float | None
    acceleration: float
    yaw_rate: float
    yaw_rate_unwrapped: float
    lane_invasions: int
    duration: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Metrics:
    """The ten normalised numbers of a set of episodes; computed from the set, never averaged from members.

    Attributes:
        collision_rate: CR.
        red_light: RR.
        stop_sign: SS.
        off_road: OR, over 50 m.
        route_following: RF, 1 is on the route.
        completion: Comp, 1 is complete.
        time_spent: TS, over 60 s.
        acceleration: ACC, over 8 m/s².
        yaw_velocity: YV, over 3 rad/s.
        lane_invasion: LI, over 20.
    """

    collision_rate: float
    red_light: float
    stop_sign: float
    off_road: float
    route_following: float
    completion: float
    time_spent: float
    acceleration: float
    yaw_velocity: float
    lane_invasion: float

    @property
    def safety_level(self) -> float:
        """Safety level in [0, 1] (weights 5 and 1, of 8)."""
        return (5 * (1 - self.collision_rate) + 3 - self.red_light - self.stop_sign - self.off_road) / 8

    @property
    def functionality_level(self) -> float:
        """Functionality level in [0, 1] (weight 0.5 each, of 1.5)."""
        return 0.5 * (self.route_following + self.completion + 1 - self.time_spent) / 1.5

    @property
    def etiquette_level(self) -> float:
        """Etiquette level in [0, 1] (weight 0.2 each, of 0.6)."""
        return 0.2 * (3 - self.acceleration - self.yaw_velocity - self.lane_invasion) / 0.6

    @property
    def overall_score(self) -> float:
        """OS in [0, 1]: high is good driving."""
        return (8 * self.safety_level + 1.5 * self.functionality_level + 0.6 * self.etiquette_level) / 10.1
