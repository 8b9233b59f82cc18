"""What the ego under test is held to, whatever it asks for: how fast it may be, since when or where, until when."""

from __future__ import annotations

import math
from dataclasses import dataclass


@dataclass(frozen=True, slots=True, kw_only=True)
class Order:
    """An order to the ego: where it holds, the ego is no faster; steering, and how much slower it is, stay its own.

    It holds from a time and a place on. Before that the ego is braked in time, as a driver comes to a stop at a line:
    evenly, so that it is slow enough when the order begins. (Names are none that Scenic keeps for itself.)

    Attributes:
        at_most: The most it may drive [m/s]; 0 holds it where it stands.
        since: When it begins to hold [s], from the beginning of the drive.
        till: When it ends [s].
        place: From where on it holds: arc length [m] on the ego's route.
        braking: How hard the ego is braked before it [m/s²].
    """

    at_most: float
    since: float = 0.0
    till: float = math.inf
    place: float = -math.inf
    braking: float = 3.0

    def allows(self, time: float, along: float) -> float:
        """The most the ego may drive [m/s], so many seconds after the beginning and metres along its route."""
        if time >= self.till:
            return math.inf
        in_time = self.at_most + self.braking * max(self.since - time, 0.0)
        in_place = math.sqrt(self.at_most**2 + 2.0 * self.braking * max(self.place - along, 0.0))
        return max(in_time, in_place)
