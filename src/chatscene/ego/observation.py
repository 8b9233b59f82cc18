"""The four numbers an ego sees (SafeBench v1, ``carla_env.py``, observation type 0; paper, appendix on egos).

| index | meaning | unit |
|---|---|---|
| 0 | lateral offset from the route at a point about 6 m ahead, positive = ego is left of it | m |
| 1 | heading error against the route there, positive = ego points left of it | rad |
| 2 | speed | m/s |
| 3 | 1 if a vehicle is within 15 m ahead in the ego's own lane, else 0 | 1 |

Signs: SafeBench computes both errors in CARLA's left-handed frame and flips them, which gives the values above in
our right-handed frame. Pedestrians, cyclists on the pavement, props and crossing traffic are not seen: that is the
reference, not an oversight.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from chatscene.terms.polyline import Polyline

Observation = NDArray[np.float64]

PREVIEW = 6  # route points 1 m apart: SafeBench drops those within 4 m and looks at the third of the rest
SIGHT = 15.0  # [m]


class RouteView:
    """The ego's view of its route; remembers where on it the ego was.

    Args:
        line: The route, points about 1 m apart.

    Attributes:
        along: Arc length of the ego on the route [m], after `observe`.
        offset: Lateral offset of the ego from the route [m, positive = left], after `observe`.
    """

    __slots__ = ("_line", "_near", "along", "offset")

    def __init__(self, line: Polyline) -> None:
        self._line = line
        self._near = 0
        self.along = 0.0
        self.offset = 0.0

    def observe(self, x: float, y: float, heading: float, speed: float, vehicle_ahead: bool) -> Observation:
        """The four numbers for an ego at a pose.

        Args:
            x: [m].
            y: [m].
            heading: [rad, 0 = +x, counter-clockwise].
            speed: [m/s].
            vehicle_ahead: The fourth number, which needs the other actors.

        Returns:
            (4,) float64.
        """
        self.along, self.offset, self._near = self._line.project(x, y, self._near)
        wx, wy, hx, hy = self._line.segment(self._near + PREVIEW)
        lateral = hx * (y - wy) - hy * (x - wx)
        cross = hx * math.sin(heading) - hy * math.cos(heading)
        error = math.asin(1.0 if cross > 1.0 else -1.0 if cross < -1.0 else cross)
        return np.array((lateral, error, abs(speed), 1.0 if vehicle_ahead else 0.0))
