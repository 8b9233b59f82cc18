"""The speed that is allowed on the lanes of a map: what its file says, else what is usual on roads of its kind.

Where the file says more than is usual there, the usual counts (decision 0121).

Source: ASAM OpenDRIVE 1.7.0, sections 8.5 (type of a road and its limit) and 9.10 (limit of a lane). What is usual is
what most of Europe allows in towns, outside them, and on motorways by day and night.
"""

from __future__ import annotations

import math
from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any
from xml.etree import ElementTree as Xml

import numpy as np
import shapely
from numpy.typing import NDArray

from chatscene.maps.lane_runs import centre_line
from chatscene.terms.polyline import Polyline

KMH = 1.0 / 3.6  # [m/s]
UNITS = {"": 1.0, "m/s": 1.0, "km/h": KMH, "mph": 0.44704}  # OpenDRIVE takes a number without a unit for m/s
TOWN, RURAL, MOTORWAY, SLOW = 50 * KMH, 80 * KMH, 110 * KMH, 30 * KMH  # [m/s], usual there

_KINDS = {
    "rural": (RURAL, RURAL),
    "motorway": (MOTORWAY, MOTORWAY),
    **dict.fromkeys(("lowSpeed", "townPlayStreet", "pedestrian"), (SLOW, SLOW)),
}
_KINDS["bicycle"] = (SLOW, SLOW)  # on its own: lists of several road users are one table (decision 0034)
# Of any other kind. `town` is what netconvert and the maps of CARLA say of every road, motorways too: where such a
# one has a limit of its own, that is the better witness.
_OTHER = (TOWN, MOTORWAY)

Steps = tuple[tuple[float, float], ...]


@dataclass(frozen=True, slots=True)
class RoadLimits:
    """What is allowed on one road.

    Attributes:
        allowed: From which place along its reference line on [m], which speed [m/s]; in order, the first
            from its start.
        most: The same of what no lane of it exceeds.
        lanes: For lanes with a limit of their own, by OpenDRIVE's id, the same; NaN where one has none again.
        kind: OpenDRIVE's type of the road, if it is of one all along.
    """

    allowed: Steps
    most: Steps
    lanes: Mapping[int, Steps] = field(default_factory=dict[int, Steps])
    kind: str = ""

    def at(self, s: float, lane: int | None = None) -> float:
        """The speed allowed [m/s].

        Args:
            s: Where along the reference line [m].
            lane: OpenDRIVE's id of a lane there; None for the road as a whole.
        """
        own = math.nan if lane is None or lane not in self.lanes else _at(self.lanes[lane], s)
        return _at(self.allowed, s) if math.isnan(own) else min(own, _at(self.most, s))


_UNKNOWN = RoadLimits(((0.0, TOWN),), ((0.0, MOTORWAY),))


def limits_of(network: Any) -> Mapping[int, RoadLimits]:
    """What is allowed on the roads of a network that `chatscene.maps.network.load_network` gave, by OpenDRIVE's id."""
    return getattr(network, "speed_limits", {})


def read_limits(root: Xml.Element) -> dict[int, RoadLimits]:
    """What is allowed on the roads of a map, by OpenDRIVE's id.

    A road of which no kind is said, as of those in junctions, takes that of the roads it joins, and of these the less.

    Args:
        root: OpenDRIVE that has been checked.
    """
    roads = {int(road.get("id", "0")): road for road in root.iter("road")}
    typed = {number: found for number, road in roads.items() if (found := _typed(road)) is not None}
    limits: dict[int, RoadLimits] = {}
    for number, road in roads.items():
        allowed, most = typed.get(number) or _joined(road, typed)
        kinds = {kind.get("type", "") for kind in road.iterfind("type")}
        limits[number] = RoadLimits(allowed, most, _lanes(road), kinds.pop() if len(kinds) == 1 else "")
    return limits


def is_called(network: Any, road: int, kind: str) -> bool:
    """Whether a map says of a road, by OpenDRIVE's id, that it is of a type all along."""
    there = limits_of(network).get(road)
    return there is not None and there.kind == kind


def limits_along(network: Any, line: Polyline, lane_ids: Sequence[str]) -> NDArray[np.float64]:
    """The speed allowed on each segment of a line [m/s], (segments,).

    Args:
        network: Scenic's road network.
        line: What is driven, map frame.
        lane_ids: Scenic's ids of the lanes by which it leads, in driving order. Between lanes, and beside them, is
            allowed what was before.
    """
    x, y, *_ = (np.array(column) for column in line.columns)
    x, y = 0.5 * (x[:-1] + x[1:]), 0.5 * (y[:-1] + y[1:])
    allowed, limits = np.full(len(x), math.nan), limits_of(network)
    for uid in lane_ids:
        lane = network.elements[uid]
        road = limits.get(lane.road.id, _UNKNOWN)
        inside = np.flatnonzero(np.isnan(allowed) & shapely.contains_xy(lane.polygons, x, y))
        for i, s, number in _on_road(lane, inside, x, y):
            allowed[i] = road.at(s, number)
    known = np.flatnonzero(~np.isnan(allowed))
    if not len(known):
        return np.full(len(x), TOWN)
    before = np.searchsorted(known, np.arange(len(x)), side="right") - 1
    return allowed[known[np.maximum(before, 0)]]


def _on_road(
    lane: Any, inside: NDArray[np.intp], x: NDArray[np.float64], y: NDArray[np.float64]
) -> Iterator[tuple[int, float, int]]:
    """For each point in a lane: where along the road's reference line it lies, and OpenDRIVE's id of the lane there."""
    if not len(inside):
        return
    along = Polyline([p[:2] for p in lane.road.centerline.points]).along(x[inside], y[inside])
    ends = np.cumsum([centre_line(section).length for section in lane.sections])
    own = centre_line(lane).along(x[inside], y[inside])
    section = np.minimum(np.searchsorted(ends, own, side="right"), len(ends) - 1)
    for i, s, part in zip(inside.tolist(), along.tolist(), section.tolist(), strict=True):
        yield i, s, lane.sections[part].openDriveID


def _typed(road: Xml.Element) -> tuple[Steps, Steps] | None:
    """What is allowed along a road and what no lane exceeds; None where its kind is nowhere said."""
    found = [(float(kind.get("s", "0")), kind) for kind in road.iterfind("type")]
    if not found:
        return None
    allowed: list[tuple[float, float]] = []
    most: list[tuple[float, float]] = []
    for s, kind in sorted(found, key=lambda one: one[0]):
        usual, highest = _KINDS.get(kind.get("type", ""), _OTHER)
        own = speed_of(kind.find("speed"))
        allowed.append((s, usual if own is None else min(own, highest)))
        most.append((s, highest))
    return tuple(allowed), tuple(most)


def _joined(road: Xml.Element, typed: Mapping[int, tuple[Steps, Steps]]) -> tuple[Steps, Steps]:
    """The same of a road whose kind is nowhere said."""
    ends: list[tuple[float, float]] = []
    for link in (*road.iterfind("link/predecessor"), *road.iterfind("link/successor")):
        number = link.get("elementId", "")
        if link.get("elementType") == "road" and number.removeprefix("-").isdecimal() and int(number) in typed:
            end = 0 if link.get("contactPoint") == "start" else -1
            ends.append(tuple(steps[end][1] for steps in typed[int(number)]))  # pyright: ignore[reportArgumentType]
    if not ends:
        return _UNKNOWN.allowed, _UNKNOWN.most
    return ((0.0, min(allowed for allowed, _ in ends)),), ((0.0, min(most for _, most in ends)),)


def _lanes(road: Xml.Element) -> dict[int, Steps]:
    """The limits that lanes of a road have of their own."""
    found: dict[int, list[tuple[float, float]]] = {}
    for section in road.iterfind("lanes/laneSection"):
        start = float(section.get("s", "0"))
        for lane in section.iter("lane"):
            own = sorted(
                (start + float(one.get("sOffset", "0")), math.nan if (speed := speed_of(one)) is None else speed)
                for one in lane.iterfind("speed")
            )
            steps = found.setdefault(int(lane.get("id", "0")), [])
            steps += [(start, math.nan)] * (not own or own[0][0] > start)
            steps += own
    return {lane: tuple(steps) for lane, steps in found.items() if not all(math.isnan(own) for _, own in steps)}


def speed_of(element: Xml.Element | None) -> float | None:
    """A limit as OpenDRIVE writes it, ``<speed max unit>`` [m/s]; None for none, or for what is no positive number."""
    if element is None:
        return None
    try:
        speed = float(element.get("max", "")) * UNITS.get(element.get("unit", ""), math.nan)
    except ValueError:  # "no limit", "undefined"
        return None
    return speed if 0.0 < speed < math.inf else None


def _at(steps: Steps, s: float) -> float:
    return steps[max(bisect_right(steps, s, key=lambda one: one[0]) - 1, 0)][1]
