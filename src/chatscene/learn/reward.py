"""What a step is worth to a learning ego: each term by name, so that a sum can be taken apart.

SafeBench: ``carla_env.py``, ``_get_reward``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import reduce
from operator import add
from typing import Any

import numpy as np

DESIRED_SPEED = 8.0  # [m/s] (SafeBench)
OUT_OF_LANE = 4.0  # [m] (SafeBench)
CRASH = -50.0  # of `progress`: more than the whole rest of a route is worth at a discount of 0.99


@dataclass(frozen=True, slots=True, kw_only=True)
class Moment:
    """What one step did; or what a step of each of several drives did, with an (N,) array for each number.

    Attributes:
        speed: Speed after it [m/s].
        lateral: Lateral offset from the route after it [m].
        steer: The wheel command in it, in [-0.3, 0.3].
        progress: How far along the route it brought the ego [m].
        desired: The speed not to be exceeded [m/s]: SafeBench's, or what a program wants of its ego and is allowed.
    """

    collided: Any
    speed: Any
    lateral: Any
    steer: Any
    progress: Any
    desired: Any = DESIRED_SPEED


def safebench(moment: Moment) -> dict[str, Any]:
    """SafeBench's reward. Speed pays about eight times a step what a crash costs once; see `progress`."""
    return {
        "collision": 0.0 - moment.collided,
        "speed": moment.speed,
        "too_fast": 0.0 - 10.0 * (moment.speed > moment.desired),
        "out_of_lane": 0.0 - (abs(moment.lateral) > OUT_OF_LANE),
        "steering": -5.0 * _squared(moment.steer),
        "lateral_acceleration": -0.2 * abs(moment.steer) * _squared(moment.speed),
    }


def progress(moment: Moment) -> dict[str, Any]:
    """Pays metres along the route, so that standing still earns nothing, and charges for a crash."""
    return {
        "progress": moment.progress,
        "collision": 0.0 + CRASH * moment.collided,
        "too_fast": _at_most_nothing(moment.desired - moment.speed),
        "offset": -0.2 * abs(moment.lateral),
        "steering": -0.5 * _squared(moment.steer),
        "time": -0.1,
    }


def total(terms: Mapping[str, Any]) -> Any:
    """The sum of the terms of a reward, in their order, so that it is the same for one drive and for several."""
    return reduce(add, terms.values(), 0.0)


def _squared(value: Any) -> Any:
    """A square as Python has it, which differs in the last bit from that of an array in one number of a thousand."""
    return np.array([one**2 for one in value.tolist()]) if isinstance(value, np.ndarray) else value**2


def _at_most_nothing(value: Any) -> Any:
    return np.minimum(0.0, value) if isinstance(value, np.ndarray) else min(0.0, value)


REWARDS: dict[str, Callable[[Moment], dict[str, Any]]] = {"safebench": safebench, "progress": progress}
