"""Actions of the world model: one per step and agent, cheap, and the same in every simulator."""

from __future__ import annotations

from typing import Any

from scenic.core.simulators import Action


class DriveAction(Action):
    """All pedals and the wheel at once.

    Args:
        throttle: In [0, 1].
        brake: In [0, 1].
        steer: In [-1, 1], right positive, as in CARLA.
        reverse: Whether the throttle pushes backwards.
    """

    __slots__ = ("brake", "reverse", "steer", "throttle")

    def __init__(self, throttle: float, brake: float, steer: float, reverse: bool = False) -> None:
        self.throttle = throttle
        self.brake = brake
        self.steer = steer
        self.reverse = reverse

    def applyTo(self, agent: Any, simulation: Any) -> None:  # noqa: N802, ARG002 - Scenic's name and signature
        """Hand the controls to the agent."""
        agent.setControls(self.throttle, self.brake, self.steer, self.reverse)


class SlideAction(Action):
    """Slide on where one went, and turn about oneself: the tyres have lost their grip, or a rider has fallen.

    Args:
        spin: How far one turns for each metre [rad/m], positive to the left.
        brake: How much is lost of the speed, as a share of what the brakes give, in [0, 1].
    """

    __slots__ = ("brake", "spin")

    def __init__(self, spin: float, brake: float) -> None:
        self.spin = spin
        self.brake = brake

    def applyTo(self, agent: Any, simulation: Any) -> None:  # noqa: N802, ARG002
        """Hand it to the agent."""
        agent.setSlide(self.spin, self.brake)


class WalkAction(Action):
    """Walk in a direction at a speed.

    Args:
        course: [rad, 0 = +x, counter-clockwise].
        speed: [m/s].
    """

    __slots__ = ("course", "speed")

    def __init__(self, course: float, speed: float) -> None:
        self.course = course
        self.speed = speed

    def applyTo(self, agent: Any, simulation: Any) -> None:  # noqa: N802, ARG002
        """Hand the wish to the agent."""
        agent.setWalk(self.course, self.speed)
