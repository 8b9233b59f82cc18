"""A number that is drawn anew in each step of a drive, as Scenic 3.2 has it."""

from __future__ import annotations

from typing import Any
from weakref import ref

from scenic.core.distributions import Distribution
from scenic.syntax import veneer


class TimeSeries:
    """`TimeSeries(VerifaiRange(0, 1))`: `getSample()` gives another number of it in each step.

    VerifAI's samplers are not here, so that the numbers are independent of one another, drawn with the scene's seed.

    Args:
        number: What each is drawn from.

    Raises:
        TypeError: It is not drawn.
    """

    def __init__(self, number: Any) -> None:
        if not isinstance(number, Distribution):
            raise TypeError("TimeSeries takes a random number, as VerifaiRange(0, 1)")
        self._number: Any = number
        self._last: tuple[Any, int] = (lambda: None, -1)

    def getSample(self) -> Any:  # noqa: N802 - Scenic's name
        """The number of this step.

        Raises:
            RuntimeError: No drive is going on, or it was asked for in this step already.
        """
        simulation: Any = veneer.currentSimulation
        if simulation is None:
            raise RuntimeError("getSample gives a number in a drive; call it in a behavior or a monitor")
        drive, step = self._last
        if drive() is simulation and step == simulation.currentTime:
            raise RuntimeError("getSample is called twice in one step; keep the number")
        self._last = ref(simulation), simulation.currentTime
        return self._number.sample()
