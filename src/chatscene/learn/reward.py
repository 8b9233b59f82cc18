"""What a step is worth to a learning ego: each term by name, so that a sum can be taken apart.

SafeBench: ``carla_env.py``, ``_get_reward``.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

DESIRED_SPEED = 8.0  # [m/s] (SafeBench)
OUT_OF_LANE = 4.0  # [m] (SafeBench)
CRASH = -50.0  # of `progress`: more than the whole rest of a route is worth at a discount of 0.99


@dataclass(frozen=True, slots=True, kw_only=True)
class Moment:
    """What one step did.

    Attributes:
        collided: The ego collided in it.
        speed: Speed after it [m/s].
        lateral: Lateral offset from the route after it [m].
        steer: The wheel command in it, in [-0.3, 0.3].
        progress: How far along the route it brought the ego [m].
        desired: The speed not to be exceeded [m/s]: SafeBench's, or what a program wants of its ego and is allowed.
    """

    collided: bool
    speed: float
    lateral: float
    steer: float
    progress: float
    desired: float = DESIRED_SPEED


def safebench(moment: Moment) -> dict[str, float]:
    """SafeBench's reward. Speed pays about eight times a step what a crash costs once; see `progress`."""
    return {
        "collision": -1.0 if moment.collided else 0.0,
        "speed": moment.speed,
        "too_fast": -10.0 if moment.speed > moment.desired else 0.0,
        "out_of_lane": -1.0 if abs(moment.lateral) > OUT_OF_LANE else 0.0,
        "steering": -5.0 * moment.steer**2,
        "lateral_acceleration": -0.2 * abs(moment.steer) * moment.speed**2,
    }


def progress(moment: Moment) -> dict[str, float]:
    """Pays metres along the route, so that standing still earns nothing, and charges for a crash."""
    return {
        "progress": moment.progress,
        "collision": CRASH if moment.collided else 0.0,
        "too_fast": min(0.0, moment.desired - moment.speed),
        "offset": -0.2 * abs(moment.lateral),
        "steering": -0.5 * moment.steer**2,
        "time": -0.1,
    }


REWARDS: dict[str, Callable[[Moment], dict[str, float]]] = {"safebench": safebench, "progress": progress}
