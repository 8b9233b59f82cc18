"""What an ego sees: four presets, each a vector of fixed size.

``safebench``, four numbers (SafeBench v1, ``carla_env.py``, observation type 0; paper, appendix on egos):

| index | meaning | unit |
|---|---|---|
| 0 | lateral offset from the route at a point about 6 m ahead, positive = ego is left of it | m |
| 1 | heading error against the route there, positive = ego points left of it | rad |
| 2 | speed | m/s |
| 3 | 1 if a vehicle is within 15 m ahead in the ego's own lane, else 0 | 1 |

Signs: SafeBench computes both errors in CARLA's left-handed frame and flips them, which gives the values above in
our right-handed frame. Pedestrians, cyclists on the pavement, props and crossing traffic are not seen: that is the
reference, not an oversight.

``actors``, the route ahead and whoever is near, of any kind (ours; decision 0011):

| index | meaning | unit |
|---|---|---|
| 0 to 3 | speed; lateral offset and heading error at the ego itself; distance to the end of the route, at most 100 | m/s, m, rad, m |
| 4 to 13 | the route 5, 10, 15, 20 and 30 m ahead: x, y in the ego's frame (x ahead, y left) | m |
| from 14 | for each of the six nearest actors within 50 m: 1; along the route ahead of the ego, left of the route; x, y and velocity x, y in the ego's frame; heading against the ego's; half length, half width; 1 if it walks | 1, m, m/s, rad |

``road``, ``actors`` and how far the driving lanes go on beside the route (ours; decision 0111):

| index | meaning | unit |
|---|---|---|
| 0 to 79 | ``actors`` | |
| 80, 81 | room left and right of the route on the driving lanes, the least of the next 30 m, at most 8 | m |

``traffic``, ``road`` for who drives faster than SafeBench's egos, and how fast one may (ours; decision 0121):

| index | meaning | unit |
|---|---|---|
| 0 to 81 | ``road``, of which every distance is `scale_of` the speed times as long: the end of the route, the points on it, how near the nearest actors are and how far the room is looked for; up to 8 m/s it is ``road`` itself | |
| 82 | the speed allowed here by the bends of the route and, where the program keeps them, by its limits, those ahead too (`chatscene.terms.profile`), at most 100 | m/s |

Rows of actors that are not there are zero. So are those of who is hidden: at night and in fog by being farther than
light and weather let it be seen (`chatscene.terms.surroundings`), and else by bodies that stand between, unless the
simulation leaves that out (`chatscene.terms.sight`). A preset is eyes without a memory, not a sensor model.
``safebench`` looks no farther than anybody sees at night and in fog, and only at who is ahead in its own lane, so that
neither changes anything of it.
"""  # noqa: E501 - a table

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Sequence
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import EgoError, no_such
from chatscene.terms.polyline import Polyline
from chatscene.terms.sight import eye_of, is_hidden

Observation = NDArray[np.float64]

PREVIEW = 6  # route points 1 m apart: SafeBench drops those within 4 m and looks at the third of the rest
SIGHT = 15.0  # [m], how far `safebench` sees a vehicle
RANGE = 50.0  # [m], how far `actors` sees anybody
NEAREST = 6  # actors
AHEAD = (5.0, 10.0, 15.0, 20.0, 30.0)  # [m], where `actors` looks at the route
PER_ACTOR = 11
OWN = 4 + 2 * len(AHEAD)
HORIZON = 100.0  # [m] of route left beyond which it does not matter how much

BESIDE = 8.0  # [m] beside the route beyond which it does not matter how wide the road is
ROAD = OWN + NEAREST * PER_ACTOR  # where in `road` the room left and right stands
ALLOWED = ROAD + 2  # where in `traffic` the speed stands that is allowed
USUAL = 8.0  # [m/s], what SafeBench's egos drive at, up to which `traffic` sees no farther than `road`
UNHELD = 100.0  # [m/s], allowed where nothing holds anybody

OBSERVATIONS: dict[str, int] = {"safebench": 4, "actors": ROAD, "road": ROAD + 2, "traffic": ALLOWED + 1}
"""The presets by name, and the size of each vector."""

SPEED_AT: dict[str, int] = {"safebench": 2, "actors": 0, "road": 0, "traffic": 0}
"""Where in each vector the ego's own speed stands [m/s]."""

IN_WORDS: dict[str, str] = {
    "safebench": f"sees its route and, of all others, only whether a vehicle is within {SIGHT:g} m ahead in its lane",
    "actors": f"sees its route and the {NEAREST} nearest road users within {RANGE:g} m",
    "road": f"sees its route, how wide the road is, and the {NEAREST} nearest road users within {RANGE:g} m",
    "traffic": f"sees its route, how wide the road is, how fast it may drive, and the {NEAREST} nearest road users "
    f"within {RANGE:g} m, farther from {USUAL:g} m/s on in proportion to its speed",
}
"""What each preset shows, to stand beside what came of it."""


def scale_of(speed: float) -> float:
    """How many times as far `traffic` sees at a speed [m/s] as `road` does."""
    far = speed / USUAL
    return far if far > 1.0 else 1.0


class Seen(NamedTuple):
    """Somebody beside the ego.

    Attributes:
        body: Where it is.
        walks: Whether it walks.
        sight: From how far it is seen [m].
        height: [m]; 0 where nothing hides anybody.
    """

    body: Posed
    walks: bool
    sight: float
    height: float = 0.0


class Posed(Protocol):
    """Anything with a pose and a size: what `actors` sees of an actor."""

    x: float
    y: float
    heading: float
    speed: float
    cos: float
    sin: float
    half_length: float
    half_width: float


class RouteView:
    """The ego's view of its route; remembers where on it the ego was.

    Args:
        line: The route, points about 1 m apart.
        room: (points, 2): the room left and right of each point [m]; None is a road without edges.
        allowed: (segments,): the speed allowed on each segment [m/s]; None is any.

    Attributes:
        along: Arc length of the ego on the route [m], after `locate`.
        offset: Lateral offset of the ego from the route [m, positive = left], after `locate`.
    """

    __slots__ = ("_allowed", "_line", "_near", "_room", "along", "offset")

    def __init__(
        self, line: Polyline, room: NDArray[np.float64] | None = None, allowed: NDArray[np.float64] | None = None
    ) -> None:
        self._line = line
        self._room = room
        self._allowed = allowed
        self._near = 0
        self.along = 0.0
        self.offset = 0.0

    def locate(self, x: float, y: float) -> None:
        """Find the ego on its route; `x`, `y` [m]."""
        self.along, self.offset, self._near = self._line.project(x, y, self._near)

    def four_numbers(self, x: float, y: float, heading: float, speed: float, vehicle_ahead: bool) -> Observation:
        """The preset ``safebench`` for an ego that was located at this pose.

        Args:
            x: [m].
            y: [m].
            heading: [rad, 0 = +x, counter-clockwise].
            speed: [m/s].
            vehicle_ahead: The fourth number, which needs the other actors.

        Returns:
            (4,) float64.
        """
        wx, wy, hx, hy = self._line.segment(self._near + PREVIEW)
        lateral = hx * (y - wy) - hy * (x - wx)
        return np.array((lateral, _error(hx, hy, heading), abs(speed), 1.0 if vehicle_ahead else 0.0))

    def actors(self, ego: Posed, others: Sequence[Seen], scale: float = 1.0, height: float = 0.0) -> Observation:
        """The preset ``actors`` for an ego that was located at its pose.

        Args:
            ego: The ego.
            others: Everybody else.
            scale: How many times as far it sees.
            height: Of the ego [m]; 0 where nothing hides anybody.

        Returns:
            (``OBSERVATIONS["actors"]``,) float64.
        """
        line, x, y, cos, sin = self._line, ego.x, ego.y, ego.cos, ego.sin
        _, _, hx, hy = line.segment(self._near)
        left, horizon, reach = line.length - self.along, scale * HORIZON, scale * RANGE
        seen = [ego.speed, self.offset, _error(hx, hy, ego.heading), left if left < horizon else horizon]
        for ahead in AHEAD:
            px, py = line.point_at(self.along + scale * ahead)
            dx, dy = px - x, py - y
            seen += (dx * cos + dy * sin, dy * cos - dx * sin)
        near = sorted(
            (
                (distance, i)
                for i, (other, _, sight, _) in enumerate(others)
                if (distance := math.hypot(other.x - x, other.y - y)) < (sight if sight < reach else reach)
            )
        )
        rows = 0
        for _, i in near:
            if rows == NEAREST:
                break
            if height and self._is_hidden(ego, height, others, i):
                continue
            seen += self._row(ego, others[i].body, others[i].walks)
            rows += 1
        seen += [0.0] * (OBSERVATIONS["actors"] - len(seen))
        return np.array(seen)

    @staticmethod
    def _is_hidden(ego: Posed, height: float, others: Sequence[Seen], of: int) -> bool:
        between = ((one.body, one.height) for i, one in enumerate(others) if i != of)
        return is_hidden(eye_of(ego, height), others[of].body, others[of].height, between)

    def road(self, ego: Posed, others: Sequence[Seen], scale: float = 1.0, height: float = 0.0) -> Observation:
        """The preset ``road`` for an ego that was located at its pose; the rest as for `actors`.

        Returns:
            (``OBSERVATIONS["road"]``,) float64.
        """
        return np.concatenate((self.actors(ego, others, scale, height), self._beside(scale)))

    def traffic(self, ego: Posed, others: Sequence[Seen], height: float = 0.0) -> Observation:
        """The preset ``traffic`` for an ego that was located at its pose; the rest as for `actors`.

        Returns:
            (``OBSERVATIONS["traffic"]``,) float64.
        """
        allowed = UNHELD if self._allowed is None else min(float(self._allowed[self._near]), UNHELD)
        return np.append(self.road(ego, others, scale_of(ego.speed), height), allowed)

    def _beside(self, scale: float) -> Observation:
        """The room left and right [m]: the least of the points from that before the ego on."""
        if self._room is None:
            return np.array((BESIDE, BESIDE))
        arcs, near = self._line.columns[2], self._near
        end = bisect_right(arcs, arcs[near] + scale * AHEAD[-1], near)
        return self._room[near : max(end, near + 2)].min(axis=0)

    def _row(self, ego: Posed, other: Posed, walks: bool) -> tuple[float, ...]:
        along, beside = self._on_route(other)
        dx, dy = other.x - ego.x, other.y - ego.y
        turned = other.heading - ego.heading
        return (
            1.0,
            along - self.along,
            beside,
            dx * ego.cos + dy * ego.sin,
            dy * ego.cos - dx * ego.sin,
            other.speed * math.cos(turned),
            other.speed * math.sin(turned),
            math.remainder(turned, 2.0 * math.pi),
            other.half_length,
            other.half_width,
            1.0 if walks else 0.0,
        )

    def _on_route(self, other: Posed) -> tuple[float, float]:
        """Arc length and lateral offset [m] of an actor; the route is taken to go straight on beyond its ends.

        Else whoever drives up behind an ego at the start of its route would be beside it.
        """
        line = self._line
        along, beside, near = line.project(other.x, other.y, self._near)
        if along <= 0.0:
            x, y, hx, hy = line.segment(0)
            along = min((other.x - x) * hx + (other.y - y) * hy, 0.0)
        elif along >= line.length:
            x, y, hx, hy = line.segment(near + 1)
            along += max((other.x - x) * hx + (other.y - y) * hy, 0.0)
        return along, beside


def check_preset(name: str) -> str:
    """The name of a preset, if it is one.

    Raises:
        EgoError: It is not.
    """
    if name not in OBSERVATIONS:
        raise EgoError(no_such("observation", name, OBSERVATIONS))
    return name


def _error(hx: float, hy: float, heading: float) -> float:
    """Heading error [rad] against a direction, positive = points left of it; SafeBench's arc sine."""
    cross = hx * math.sin(heading) - hy * math.cos(heading)
    return math.asin(1.0 if cross > 1.0 else -1.0 if cross < -1.0 else cross)
