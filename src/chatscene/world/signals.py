"""Traffic signals on a clock, or held by the program.

A junction's approaches fall into two axes: the ego's own and the one across it. On the clock the axes take turns;
a program can hold them with ``param signals``: ``ego-green`` (the ego's axis has green, crossing traffic red),
``ego-red`` (the reverse), or have them change once, while it happens (`CHANGES`).
"""

from __future__ import annotations

import math
from functools import lru_cache

GREEN, YELLOW, RED = "g", "y", "r"
COLOURS = {"green": GREEN, "yellow": YELLOW, "red": RED}
GREEN_TIME = 12.0  # [s], fixed-time control of a small urban junction
YELLOW_TIME = 3.0  # [s]
ALL_RED_TIME = 1.0  # [s]
_AT_ONCE = 512  # [steps], of which the states are worked out together and kept
_HALF = GREEN_TIME + YELLOW_TIME + ALL_RED_TIME

Held = tuple[tuple[float, str], ...]
"""The states of a signal, each with the time [s] at which it ends; the last never does."""
CHANGES: dict[str, tuple[Held, Held]] = {
    "ego-green": (((math.inf, GREEN),), ((math.inf, RED),)),
    "ego-red": (((math.inf, RED),), ((math.inf, GREEN),)),
    # An ego that comes at its usual speed is at the line after 5 s.
    "ego-yellow": (((3.5, GREEN), (6.5, YELLOW), (math.inf, RED)), ((7.5, RED), (math.inf, GREEN))),
    "ego-turns-green": (((4.0, RED), (math.inf, GREEN)), ((0.0, GREEN), (3.0, YELLOW), (math.inf, RED))),
    "ego-turns-red": (((0.5, GREEN), (3.5, YELLOW), (math.inf, RED)), ((4.5, RED), (math.inf, GREEN))),
}
"""What a program can hold the signals of the ego's junction to: those of the ego's axis, then those across it."""

MODES = ("clock", *CHANGES)


def signal_states(mode: str, own_axis: bool, steps: int, dt: float) -> str:
    """The state of one signal at each of `steps` steps, as a string of ``g``, ``y`` and ``r``.

    Args:
        mode: One of `MODES`.
        own_axis: Whether the signal stands on the ego's axis.
        steps: How many states.
        dt: Step [s].
    """
    return _states(mode, own_axis, -(-steps // _AT_ONCE) * _AT_ONCE, dt)[:steps]


@lru_cache(maxsize=64)
def _states(mode: str, own_axis: bool, steps: int, dt: float) -> str:
    if mode in CHANGES:
        held = CHANGES[mode][0 if own_axis else 1]
        return "".join(next(state for until, state in held if step * dt < until) for step in range(steps))
    return "".join(state_on_clock(step * dt, own_axis) for step in range(steps))


def last_change(mode: str) -> float:
    """When the last signal changes that a program holds so [s]: 0 where none does, inf on the clock."""
    if mode not in CHANGES:
        return math.inf
    return max((until for held in CHANGES[mode] for until, _ in held[:-1]), default=0.0)


def state_on_clock(time: float, own_axis: bool) -> str:
    """The state of a signal on the clock, so many seconds after its start."""
    phase = (time + (0.0 if own_axis else _HALF)) % (2 * _HALF)
    if phase < GREEN_TIME:
        return GREEN
    return YELLOW if phase < GREEN_TIME + YELLOW_TIME else RED
