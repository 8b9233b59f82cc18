"""How far ahead of the ego somebody in the next lane begins who turns round over the ego's way."""

from __future__ import annotations

import math

from chatscene.build.asked import Asked
from chatscene.build.place import LANE
from chatscene.terms.vocabulary import Act, Side, Where

TURNS_AT = 3.0  # [m/s²], sideways, of who turns round
WIDER = 1.15  # times its smallest circle, which it does not reach at once
BRAKES = 0.6  # of its brake, with which it comes down to the speed of its turn
SLOWED = 1.1  # times that speed, from which on it turns
IN_TIME = 1.0  # [s] of the ego's way at most that are left as it is in the ego's lane


def so_far_ahead(asked: Asked) -> tuple[float, float] | None:
    """From and to how far [m] ahead it begins, so that it is in the ego's lane as the ego comes; None for others.

    It slows down for its turn, and the ego does not: who begins level with the ego, or just ahead of it, turns round
    behind it.
    """
    first = asked.one.does[0].act if asked.one.does else None
    beside = asked.one.starts.where is Where.AHEAD_BESIDE and asked.side == Side.RIGHT
    if first is not Act.U_TURN or not beside or asked.stands:
        return None
    limits, speed = asked.numbers.row.limits, asked.ego.speed
    radius = max(LANE / 2, WIDER * limits.wheelbase / math.tan(limits.wheel_angle))
    turns = math.sqrt(TURNS_AT * radius)
    slowed, brakes = min(speed, SLOWED * turns), BRAKES * limits.brake
    over = math.acos(max(-1.0, 1.0 - LANE / 2 / radius))  # turned so far, its middle is between the lanes
    steady = asked.numbers.middle("STEADY")
    takes = steady + (speed - slowed) / brakes + over * radius / turns
    gone = steady * speed + (speed**2 - slowed**2) / (2 * brakes) + radius * math.sin(over)
    low = speed * takes - gone
    return low, low + IN_TIME * speed
