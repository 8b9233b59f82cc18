"""A driver by rule at the speed of traffic: the intelligent driver model along its route, and an emergency brake.

It thinks in time and in the deceleration that is needed. Whoever is in its way is followed by the model, braked for
firmly when that needs more than is comfortable, and with the whole brake from the deceleration on that UN R152 asks of
an emergency brake, 5 m/s². Whoever comes from the side is in the way from `FORESIGHT` before, not earlier: nobody knows
that a person at the kerb will cross. Who has crossed by the time the ego gets there is not in the way.
"""

from __future__ import annotations

import math

from chatscene.ego.at_speed import CAR, Other, bends, other, pressed, slower, softness_of, steered
from chatscene.ego.observation import ALLOWED, OWN, PER_ACTOR, ROAD, Observation, scale_of
from chatscene.terms.actors import Limits

ACCELERATION, COMFORTABLE = 2.0, 2.5  # [m/s²], the model's a and b
HEADWAY, GAP = 1.2, 2.5  # [s], [m], the model's T and s0
MARGIN = 0.5  # [m] kept free beside the car
LANE = 1.75  # [m] from the middle of the lane to its edge
FORESIGHT = 1.0  # [s] before somebody who comes from the side is in the way, from when on that is seen
CROSSES = 0.5  # sine of the angle to the route from which on somebody crosses it, and does not come into it
CLEAR = 1.0  # [m] ahead where it comes to a stop
FIRM, FIRMLY = 2.0, 1.2  # [m/s²] of needed deceleration from which on it brakes by so many times as much
EMERGENCY = 5.0  # [m/s²] of needed deceleration from which on it uses the whole brake


class TrafficDriver:
    """IDM and AEB on the preset ``traffic``, with the whole brake pedal.

    Args:
        speed: Wanted [m/s], where no less is allowed.
        name: How it is called in tables.
        body: What the vehicle can do that it drives.
        all_around: Whether it sees everybody, or only what is in its lane and does not walk, as an adaptive cruise
            control does.
    """

    observation = "traffic"
    pedals = "full-brake"

    def __init__(self, speed: float, *, name: str = "idm", body: Limits = CAR, all_around: bool = True) -> None:
        self.speed, self.name, self.body, self.all_around = speed, name, body, all_around
        self._softness = softness_of(body)

    def wanting(self, speed: float) -> TrafficDriver:
        """The same driver with another wanted speed [m/s]."""
        return TrafficDriver(speed, name=self.name, body=self.body, all_around=self.all_around)

    def driving(self, body: Limits) -> TrafficDriver:
        """The same driver in another vehicle."""
        return TrafficDriver(self.speed, name=self.name, body=body, all_around=self.all_around)

    def act(self, observation: Observation) -> tuple[float, float]:
        """Acceleration and steering in [-1, 1] for one step."""
        speed = float(observation[0])
        k = scale_of(speed)
        middles, bearings = bends(observation, k)
        acceleration = _free(speed, min(self.speed, float(observation[ALLOWED])))
        for row in observation[OWN:ROAD].reshape(-1, PER_ACTOR).tolist():
            if row[0] > 0.0:
                one = other(row, k, middles, bearings)
                if self.all_around or (not one.walks and abs(one.beside) < LANE):
                    acceleration = min(acceleration, _behind(speed, one, acceleration, self.body))
        steering = steered(observation, 0.0, self._softness)
        return pressed(acceleration, speed, self.body), steering


def _free(speed: float, wish: float) -> float:
    """Acceleration [m/s²] on an empty road."""
    ratio = speed / max(wish, 0.1)
    return ACCELERATION * (1.0 - (ratio * ratio) * (ratio * ratio)) if ratio < 1.0 else slower(speed, wish)


def _behind(speed: float, one: Other, free: float, body: Limits) -> float:
    """Acceleration [m/s²] with regard to somebody; `free` if it is not and will not be in the way."""
    if one.along < 0.0:
        return free
    room, beside = one.along - one.half_along - body.length / 2, abs(one.beside)
    corridor, sideways = body.width / 2 + one.half_beside + MARGIN, abs(one.db)
    comes = one.beside * one.db < 0.0
    enters = 0.0 if beside < corridor else (beside - corridor) / sideways if comes else math.inf
    if enters > FORESIGHT:
        return free
    crosses = sideways > CROSSES * math.hypot(one.ds, one.db)
    lead = 0.0 if crosses else one.ds
    closing = speed - lead
    if closing > 0.0:
        leaves = (corridor + (beside if comes else -beside)) / sideways if crosses else math.inf
        if leaves < max(room, 0.0) / closing:  # it has crossed by then
            return free
        if (one.along + one.half_along + body.length / 2) / closing < enters:  # we have passed by then
            return free
    # What comes towards us takes its share of the road that is left.
    distance = max(room - CLEAR, 0.1)
    met = closing * (speed if lead < 0.0 else closing) if closing > 0.0 else 0.0
    needed = met / (2.0 * distance)
    if needed > EMERGENCY:
        return -body.brake
    wanted = GAP + speed * HEADWAY + speed * closing / (2.0 * math.sqrt(ACCELERATION * COMFORTABLE))
    ratio = max(wanted, GAP) / max(room, 0.5)
    kept = max(free - ACCELERATION * (ratio * ratio), -COMFORTABLE)
    return min(kept, -FIRMLY * needed) if needed > FIRM else kept
