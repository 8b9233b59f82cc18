"""A driver by rule: keeps to its route at a target speed and brakes for a vehicle ahead in its own lane."""

from __future__ import annotations

from chatscene.ego.observation import Observation
from chatscene.ego.traffic_driver import TrafficDriver

TARGET_SPEED = 7.5  # [m/s]; from SafeBench's 8 its hardest brake does not stop it within its sight
TURN_SPEED = 5.5  # [m/s], while the route ahead bends away
BEND = 0.15  # [rad] of heading error at the preview point that counts as a bend


class RuleBased:
    """The surrogate ego of a first run. It sees four numbers, so it cannot see pedestrians or crossing traffic.

    Within 15 m it could not stop from more than 7.5 m/s. So one of which a speed is wanted is another driver, which
    sees ``traffic`` as far as that speed takes and has the whole brake, and still heeds nothing but what is in its own
    lane and does not walk.

    Args:
        speed: Wanted [m/s], where the route does not bend.
    """

    def __init__(self, speed: float = TARGET_SPEED) -> None:
        self.speed = speed

    def wanting(self, speed: float) -> TrafficDriver:
        """One like it at the speed of traffic [m/s], as a car with an adaptive cruise control drives."""
        return TrafficDriver(speed, name=type(self).__name__, all_around=False)

    def act(self, observation: Observation) -> tuple[float, float]:
        """Acceleration and steering in [-1, 1] for one step."""
        lateral, heading, speed, vehicle_ahead = observation.tolist()
        wish = self.speed if abs(heading) < BEND else min(self.speed, TURN_SPEED)
        acceleration = 0.5 * (wish - speed)
        if vehicle_ahead:
            acceleration = -1.0
        steering = 0.35 * lateral + 1.6 * heading
        return max(-1.0, min(1.0, acceleration)), max(-1.0, min(1.0, steering))
