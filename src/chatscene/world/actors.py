"""What the classes of the world model can do, as mix-ins of Scenic's protocols.

During a simulation each object carries the `body` that its simulator moves; these methods say what is asked of it.
"""

from __future__ import annotations

import math
from typing import Any

from scenic.domains.driving.actions import Steers, Walks

from chatscene.world.bodies import Vehicle, Walker
from chatscene.world.control import Pose

QUARTER = math.pi / 2  # Scenic's headings start at +y, ours at +x


class Placed:
    """Anything with a pose, read the same way in every simulator."""

    @property
    def pose(self: Any) -> Pose:
        """X [m], y [m], heading [rad, 0 = +x, counter-clockwise], speed [m/s]."""
        return self.position.x, self.position.y, self.heading + QUARTER, self.speed

    def lead(self: Any, x: float, y: float, heading: float, speed: float) -> None:
        """Be at a place [m, rad] at a speed [m/s] after this step; only the story of a drive may ask for that.

        A thing is there at once.

        Raises:
            ValueError: Its simulator keeps elsewhere where it is, so that it cannot be put there.
        """
        body = self.body
        if not body.moves:
            body.x, body.y, body.heading = x, y, heading
            body.cos, body.sin = math.cos(heading), math.sin(heading)
            return
        if not hasattr(body, "limits"):
            raise ValueError("in this simulator nobody is moved as a story tells; choose the embedded one")
        body.led = x, y, heading, speed

    def setPosition(self, position: Any, elevation: Any) -> None:  # noqa: N802, ARG002 - Scenic's name
        """Refuse to jump.

        Raises:
            ValueError: Always.
        """
        raise ValueError("nothing jumps here: an action that sets a position is not simulated; drive or walk there")


class Lying(Placed):
    """A thing on the road that somebody may be told to be: whatever is asked of it, it stays where it is."""

    def setSpeed(self, speed: float, steer: float) -> None:  # noqa: N802
        """Nothing: it is not driven."""

    def setControls(self, throttle: float, brake: float, steer: float, reverse: bool) -> None:  # noqa: N802
        """Nothing: it has neither pedals nor a wheel."""


class Driven(Placed, Steers):
    """A vehicle or two-wheeler: Scenic's driving actions, which its body follows within its limits."""

    body: Vehicle

    def setControls(self, throttle: float, brake: float, steer: float, reverse: bool) -> None:  # noqa: N802
        """All controls at once (see `chatscene.world.actions.DriveAction`)."""
        body = self.body
        body.throttle = throttle
        body.brake = brake
        body.steer = steer
        body.reverse = reverse
        body.target_speed = None
        body.spin = None

    def setSpeed(self, speed: float, steer: float) -> None:  # noqa: N802
        """A speed [m/s] that is reached within the pedals' limits, and the wheel in [-1, 1], right positive."""
        self.body.target_speed = speed
        self.body.steer = steer
        self.body.spin = None

    def setSlide(self, spin: float, brake: float) -> None:  # noqa: N802
        """Slide on (see `chatscene.world.actions.SlideAction`)."""
        self.body.slide(spin, brake)

    def setThrottle(self, throttle: float) -> None:  # noqa: N802
        """Throttle in [0, 1]."""
        self.body.throttle = throttle
        self.body.target_speed = None

    def setSteering(self, steering: float) -> None:  # noqa: N802
        """Steering in [-1, 1], right positive."""
        self.body.steer = steering

    def setBraking(self, braking: float) -> None:  # noqa: N802
        """Brake in [0, 1]."""
        self.body.brake = braking
        self.body.target_speed = None

    def setHandbrake(self, handbrake: bool) -> None:  # noqa: N802
        """The hand brake is a full brake."""
        if handbrake:
            self.setBraking(1.0)

    def setReverse(self, reverse: bool) -> None:  # noqa: N802
        """The gear."""
        self.body.reverse = reverse

    def setVelocity(self, velocity: Any) -> None:  # noqa: N802
        """A velocity is reached within the pedals' limits and along the heading: nothing jumps."""
        body = self.body
        body.target_speed = velocity[0] * body.cos + velocity[1] * body.sin


class Walking(Placed, Walks):
    """A pedestrian."""

    body: Walker

    def setWalk(self, course: float, speed: float) -> None:  # noqa: N802
        """Walk in direction `course` [rad, 0 = +x] at `speed` [m/s]."""
        self.body.course = course
        self.body.target_speed = speed

    def setWalkingDirection(self, heading: float) -> None:  # noqa: N802
        """Direction in Scenic's frame [rad, 0 = +y]."""
        self.body.course = heading + QUARTER

    def setWalkingSpeed(self, speed: float) -> None:  # noqa: N802
        """[m/s]."""
        self.body.target_speed = speed

    def setVelocity(self, velocity: Any) -> None:  # noqa: N802
        """A velocity is a direction and a speed to be reached within a walker's limits."""
        self.setWalk(math.atan2(velocity[1], velocity[0]), math.hypot(velocity[0], velocity[1]))
