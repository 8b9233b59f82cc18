"""A driver by rule that sees everybody: the intelligent driver model along its route, and an emergency brake.

Source for the model: M. Treiber, A. Hennecke, D. Helbing, "Congested traffic states in empirical observations and
microscopic simulations", Physical Review E 62 (2000). Steering is pure pursuit.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from chatscene.ego.observation import AHEAD, OWN, PER_ACTOR, Observation
from chatscene.ego.traffic_driver import TrafficDriver
from chatscene.terms.actors import LIMITS, Limits
from chatscene.terms.profile import CURVE_ACCELERATION

DESIRED_SPEED = 8.0  # [m/s]
ACCELERATION, COMFORTABLE = 2.0, 2.5  # [m/s²], the model's a and b
HEADWAY, GAP = 1.2, 2.5  # [s], [m], the model's T and s0
MARGIN = 0.5  # [m] kept free beside the car
FORESIGHT = np.arange(0.0, 2.51, 0.25)  # [s], when somebody may have come into the way
EMERGENCY = 2.0  # [m/s²] of needed deceleration from which the brake is used at once

CAR = LIMITS["Car"]


class IntelligentDriver:
    """IDM and AEB on the preset ``actors``, with the whole brake pedal; at a speed that is wanted, `TrafficDriver`."""

    name = "idm"
    observation = "actors"
    pedals = "full-brake"

    def __init__(self, speed: float = DESIRED_SPEED, body: Limits = CAR) -> None:
        self.speed, self.body = speed, body

    def wanting(self, speed: float) -> TrafficDriver:
        """The same driver at the speed of traffic, with a wanted speed [m/s]."""
        return TrafficDriver(speed, name=self.name, body=self.body)

    def driving(self, body: Limits) -> IntelligentDriver:
        """The same driver in another vehicle."""
        return IntelligentDriver(self.speed, body)

    def act(self, observation: Observation) -> tuple[float, float]:
        """Acceleration and steering in [-1, 1] for one step."""
        speed = float(observation[0])
        wish = min(self.speed, curve_speed(observation[4:OWN].reshape(-1, 2)))
        actors = observation[OWN:].reshape(-1, PER_ACTOR)
        acceleration = _free(speed, wish)
        for row in actors[actors[:, 0] > 0.0]:
            acceleration = min(acceleration, _behind(speed, row, acceleration, self.body))
        action = pressed(acceleration, self.body)
        return max(-1.0, min(1.0, action)), _steering(observation)


def _free(speed: float, wish: float) -> float:
    """Acceleration [m/s²] on an empty road."""
    ratio = speed / max(wish, 0.1)
    return ACCELERATION * (1.0 - ratio**4) if ratio < 1.0 else max(-COMFORTABLE, -2.0 * (speed - wish))


def pressed(acceleration: float, body: Limits) -> float:
    """The pedal for an acceleration [m/s²]: as SafeBench presses a car's, and as much farther as a body is weaker."""
    return acceleration / (3.0 * body.throttle / CAR.throttle) if acceleration > 0.0 else acceleration / body.brake


def _behind(speed: float, row: NDArray[np.float64], free: float, body: Limits) -> float:
    """Acceleration [m/s²] with regard to one actor; `free` if it is not and will not be in the way."""
    along, beside, _, _, vx, vy = row[1:7].tolist()
    turned, half_length, half_width = row[7:10].tolist()
    reach = half_length * abs(math.cos(turned)) + half_width * abs(math.sin(turned))
    breadth = half_length * abs(math.sin(turned)) + half_width * abs(math.cos(turned))
    room = along - reach - body.length / 2
    if along < 0.0:
        return free
    corridor = body.width / 2 + breadth + MARGIN
    inside = np.abs(beside + vy * FORESIGHT) < corridor
    # In the way when the ego gets there; whoever has passed by then is not.
    ahead = along + (vx - speed) * FORESIGHT
    meets = inside & (ahead < speed * 1.0 + reach + body.length) & (ahead > -reach - body.length)
    if not (inside[0] or meets.any()):
        return free
    lead = max(vx, 0.0) if inside[0] or vx > 2.0 * abs(vy) else 0.0
    closing = speed - lead
    distance = max(room - 1.0, 0.1)
    needed = closing * closing / (2.0 * distance) if closing > 0.0 else 0.0
    if needed > EMERGENCY:
        return -min(1.3 * needed, body.brake)
    wanted = GAP + speed * HEADWAY + speed * closing / (2.0 * math.sqrt(ACCELERATION * COMFORTABLE))
    return max(free - ACCELERATION * (max(wanted, GAP) / max(room, 0.5)) ** 2, -COMFORTABLE)


def curve_speed(points: NDArray[np.float64]) -> float:
    """The speed [m/s] from which every point of the route ahead can be taken in time."""
    lowest = math.inf
    for distance, (x, y) in zip(AHEAD, points.tolist(), strict=True):
        chord2 = x * x + y * y
        if abs(y) > 0.05:
            radius = chord2 / (2.0 * abs(y))
            reachable = CURVE_ACCELERATION * radius + 2.0 * COMFORTABLE * max(distance - AHEAD[1], 0.0)
            lowest = min(lowest, math.sqrt(reachable))
    return lowest


def _steering(observation: Observation) -> float:
    """Toward the nearest of the points ahead on the route, as a car's wheel turns there (`controls`)."""
    x, y = observation[4:6].tolist()
    curvature = 2.0 * y / max(x * x + y * y, 1.0)
    wheel = math.atan(CAR.wheelbase * curvature)
    return max(-1.0, min(1.0, -wheel / CAR.wheel_angle / 0.3))
