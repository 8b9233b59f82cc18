"""The ego's route in a program: which of a map's routes it is, and what holds on it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import MapError
from chatscene.maps.kept import kept_with_network
from chatscene.maps.lane_runs import centre_line
from chatscene.maps.limits import limits_along
from chatscene.maps.onward import route_through
from chatscene.maps.ring_routes import left_at
from chatscene.maps.routes import TO_LINE, find_routes, from_line
from chatscene.terms.arrays import fixed
from chatscene.terms.polyline import Polyline
from chatscene.terms.profile import allowed_speeds
from chatscene.terms.route import Beside, Equipment, Route, RouteQuery, Shape
from chatscene.terms.scenario import Control, Maneuver, Place, Site
from chatscene.terms.vocabulary import Setting

ROUTES = 10  # per geometry, as in the paper (section 4.2)


class EgoRoute:
    """The ego's route in a program: the route, the map it lies on, and which signals hold for it.

    Attributes:
        route: The route itself.
        network: Scenic's road network.
        line: Its line.
        eventAt: Arc length [m] where its manoeuvre begins, as in the route.
        exitAt: Arc length [m] where it leaves its junction; `eventAt` on open road.
        maneuver: What it does.
        before: The way to where it begins, if it is a part of a longer one.
    """

    def __init__(self, route: Route, network: Any, count: int, before: Polyline | None = None) -> None:
        self.exitAt = _exit_of(route, network)
        self.route = route if route.junction is None else replace(route, exit_at=self.exitAt)
        self.before = before
        self.count = count
        self.network = network
        self.line = route.line
        self.eventAt = route.event_at
        self.maneuver = route.maneuver
        self._allowed: dict[tuple[bool, float], NDArray[np.float64]] = {}

    def __repr__(self) -> str:
        return f"EgoRoute({self.route.id})"

    @cached_property
    def limits(self) -> NDArray[np.float64]:
        """(segments,): the speed [m/s] that the map, or the kind of its roads, allows on each segment of its line."""
        return fixed(limits_along(self.network, self.line, self.route.lane_ids))

    def allowed(self, *, keeps_limits: bool, grip: float = math.inf) -> NDArray[np.float64]:
        """(segments,): the speed [m/s] at which each segment may be driven, as the preset `traffic` shows it.

        Args:
            keeps_limits: Whether its limits count, beside its bends.
            grip: What the road holds [m/s²].
        """
        if (asked := (keeps_limits, grip)) not in self._allowed:
            self._allowed[asked] = fixed(allowed_speeds(self.line, self.limits if keeps_limits else None, grip))
        return self._allowed[asked]


def _exit_of(route: Route, network: Any) -> float:
    if route.junction is None:
        return route.event_at
    through = {m.connectingLane.uid for m in left_at(network, route).maneuvers if m.connectingLane}
    last = next(uid for uid in reversed(route.lane_ids) if uid in through)
    return route.line.project(*centre_line(network.elements[last]).points[-1])[0]


def routes_for(
    network: Any,
    map_path: str,
    maneuver: str,
    place: str | None = None,
    control: str | None = None,
    lanes: int = 1,
    most: int | None = None,
    opposite: bool | None = None,
    beside: str | None = None,
    crossed: tuple[str, ...] = (),
    site: str | None = None,
    lane: int | None = None,
    approach: float | None = None,
    begins: str | None = None,
    ends: str | None = None,
    setting: str | None = None,
    divided: bool = False,
    shape: str | None = None,
    arms: int | None = None,
    across: tuple[float, float] | None = None,
    by_exit: int | None = None,
    has: tuple[str, ...] = (),
) -> tuple[Route, ...]:
    """The routes of a map that a geometry asks for, best spread first.

    Args:
        network: Scenic's road network.
        map_path: The map's file; its stem names the routes.
        maneuver: A `Maneuver`.
        place: A `Place`, or None for any.
        control: A `Control`, or None for any.
        lanes: Least number of lanes in the ego's direction.
        most: The greatest, or None for any.
        opposite: Whether an oncoming lane must lie beside the ego's.
        beside: ``left`` or ``right`` if a lane of the ego's direction must lie directly there.
        crossed: From where another vehicle must be able to cross: ``left``, ``right``, ``oncoming``.
        site: A `Site`, or None for any.
        lane: Which lane of its direction it starts in, 1 for the outermost, -1 for the innermost; None for any.
        approach: How far [m] it leads up to its manoeuvre; None for as far as is usual.
        begins: Where it begins beside its lane: a `Beside`, or None.
        ends: Where it ends beside its lane: a `Beside`, or None.
        setting: What lies about the road where it begins: a `Setting`, or None for anything.
        divided: Whether no oncoming lane may lie beside any lane of the ego's direction.
        shape: A `Shape` of a junction of three arms, or None for any.
        arms: How many arms there are, or None for any number.
        across: Between what [m] the diameter of a roundabout lies, or None for any.
        by_exit: The number of the exit of a roundabout, or None for any.
        has: What the roads have: words of `Equipment`.

    Raises:
        MapError: The map has no such geometry.
    """
    query = RouteQuery(
        maneuver=Maneuver(maneuver),
        place=None if place is None else Place(place),
        control=None if control is None else Control(control),
        lanes_same_way=lanes,
        most_lanes=most,
        opposite_lane=opposite,
        lane_beside=beside,
        conflicting_from=tuple(crossed),
        site=None if site is None else Site(site),
        lane=lane,
        approach=approach,
        begins=None if begins is None else Beside(begins),
        ends=None if ends is None else Beside(ends),
        setting=None if setting is None else Setting(setting),
        divided=divided,
        shape=None if shape is None else Shape(shape),
        arms=arms,
        across=across,
        by_exit=by_exit,
        has=tuple(map(Equipment, has)),
    )
    found = _routes(network, Path(map_path).stem, query)
    if isinstance(found, str):
        raise MapError(found)
    return found


@kept_with_network(1024)  # all catalogues ask for 640
def _routes(network: Any, map_name: str, query: RouteQuery) -> tuple[Route, ...] | str:
    """The routes, or why there are none, which takes as long to find out and is asked as often."""
    try:
        return find_routes(network, map_name, query, count=ROUTES)
    except MapError as error:
        return str(error)


def has_route(network: Any, map_path: str, **query: Any) -> bool:
    """Whether a map has such a geometry, asked for as `routes_for` is."""
    try:
        return bool(routes_for(network, map_path, **query))
    except MapError:
        return False


def choose_route(
    network: Any,
    map_path: str,
    index: int,
    *,
    only: int | None = None,
    at_line: bool = False,
    to_line: float = TO_LINE,
    **query: Any,
) -> EgoRoute:
    """The `index`-th route that the geometry asks for; from its junction's line on, if it is to begin there.

    `only` is the number of the one that counts, and `to_line` how far [m] the middle of who waits at a line is from the
    junction's entry.

    Raises:
        MapError: There are fewer routes than that.
    """
    routes = routes_for(network, map_path, **query)
    routes = routes if only is None else routes[only : only + 1]
    if index >= len(routes):
        raise MapError(
            f"map {Path(map_path).stem!r} has {len(routes)} routes for this geometry, so there is no route {index}; "
            f"ask for at most {len(routes)}"
        )
    return _ego_route(network, routes[index], len(routes), to_line if at_line else None)


@kept_with_network(1024)  # what is worked out of a route, as its limits, is so once
def _ego_route(network: Any, route: Route, count: int, to_line: float | None) -> EgoRoute:
    route, before = (route, None) if to_line is None else from_line(network, route, to_line)
    return EgoRoute(route, network, count, before)


def route_along(network: Any, map_path: str, points: Sequence[tuple[float, float]]) -> EgoRoute:
    """The ego's route along points [m] in driving order.

    Raises:
        MapError: They begin on no lane, or are less than a route.
    """
    return EgoRoute(route_through(network, Path(map_path).stem, points), network, 1)
