"""Traffic signals on a clock, or held by the program.

A junction's approaches fall into two axes: the ego's own and the one across it. On the clock the axes take turns;
a program can hold them with ``param signals``: ``ego-green`` (the ego's axis has green, crossing traffic red) or
``ego-red`` (the reverse).
"""

from __future__ import annotations

GREEN, YELLOW, RED = "g", "y", "r"
COLOURS = {"green": GREEN, "yellow": YELLOW, "red": RED}
GREEN_TIME = 12.0  # [s], fixed-time control of a small urban junction
YELLOW_TIME = 3.0  # [s]
ALL_RED_TIME = 1.0  # [s]
_HALF = GREEN_TIME + YELLOW_TIME + ALL_RED_TIME

MODES = ("clock", "ego-green", "ego-red")


def signal_states(mode: str, own_axis: bool, steps: int, dt: float) -> str:
    """The state of one signal at each of `steps` steps, as a string of ``g``, ``y`` and ``r``.

    Args:
        mode: One of `MODES`.
        own_axis: Whether the signal stands on the ego's axis.
        steps: How many states.
        dt: Step [s].
    """
    if mode != "clock":
        return (GREEN if own_axis == (mode == "ego-green") else RED) * steps
    return "".join(state_on_clock(step * dt, own_axis) for step in range(steps))


def state_on_clock(time: float, own_axis: bool) -> str:
    """The state of a signal on the clock, so many seconds after its start."""
    phase = (time + (0.0 if own_axis else _HALF)) % (2 * _HALF)
    if phase < GREEN_TIME:
        return GREEN
    return YELLOW if phase < GREEN_TIME + YELLOW_TIME else RED
