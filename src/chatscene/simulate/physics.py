"""What a simulator has to bring where it runs Scenic's loop: bodies, and how they move. All else is written once."""

from __future__ import annotations

from collections.abc import Callable
from typing import Protocol

from scenic.core.simulators import SimulationCreationError

from chatscene.world.bodies import Body, Placement


class CannotPlace(SimulationCreationError):  # noqa: N818 - reads as what it says
    """A thing of a scene has no room where the scene puts it; the scene is rejected, and this is why."""


class Physics(Protocol):
    """The bodies of one scene.

    What is asked of a body stands in it before each step (see `chatscene.world.bodies`), and where it is has to stand
    in it afterwards: `x`, `y`, `heading`, `cos`, `sin`, `speed` and `before`. Whether two touch is told from that, the
    same way for every simulator.
    """

    def add(self, placement: Placement) -> Body:
        """Make the body of a thing; the ego's comes first.

        Raises:
            CannotPlace: It has no room there.
            ValueError: There can be no such thing.
        """
        ...

    def step(self, dt: float) -> None:
        """Move every body by `dt` [s]."""
        ...

    def close(self) -> None:
        """Take the bodies away; the scene is over."""
        ...


PhysicsOf = Callable[[], Physics]
"""Makes the physics of one scene; called for each."""
