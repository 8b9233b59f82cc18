"""What lies along a route: lanes, stop lines, signals; and the events that follow from a finished track.

Events other than collisions change nothing while a drive goes on, so they are found afterwards on whole tracks.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np
import shapely
from numpy.typing import NDArray

from chatscene.ego.observation import BESIDE
from chatscene.errors import MapError
from chatscene.maps.junctions import StopLine, junction_control, junction_signals
from chatscene.maps.lane_map import LaneMap
from chatscene.maps.limits import limits_along
from chatscene.simulate.cells import Cells
from chatscene.simulate.native.lines import engine
from chatscene.terms.arrays import fixed
from chatscene.terms.episode import Event, EventKind, SignalTrack, Track
from chatscene.terms.profile import allowed_speeds
from chatscene.terms.route import Route
from chatscene.terms.scenario import Control
from chatscene.world.lights import TrafficLights
from chatscene.world.signals import MODES, last_change, signal_states

HALTED = 0.1  # [m/s], slow enough to count as a stop at a stop sign (SafeBench, RunningStopTest)
STOP_ZONE = 6.0  # [m] before the line within which the ego must have halted
_ROOM_STEP = 0.25  # [m], how finely the room beside a route is measured
_AXIS = math.sqrt(0.5)  # cosine of 45°: a lane nearer than that to the ego's direction is on its axis


class RouteSurroundings:
    """The neighbourhood of one route, prepared for quick questions.

    Args:
        network: Scenic's road network.
        route: The route.
        lane_map: The lanes of the network.

    Attributes:
        lanes: The areas of the lanes that the route uses.
        mirrored: Whether the network is the mirror image of its map.
    """

    def __init__(self, network: Any, route: Route, lane_map: LaneMap) -> None:
        self._network = network
        self._allowed: dict[tuple[bool, float], NDArray[np.float64]] = {}
        self._route = route
        self.mirrored = bool(network.mirrored)
        self._lane_map = lane_map
        self._cells = Cells(lane_map, route)
        self.lanes = [network.elements[uid].polygons for uid in route.lane_ids]
        self._junctions = network.intersectionRegion.polygons if network.intersections else shapely.Polygon()
        for shape in (*self.lanes, self._junctions):
            shapely.prepare(shape)
        self._control = Control.NONE
        self._lines: tuple[StopLine, ...] = ()
        if route.junction is not None:
            self._control = junction_control(network.elements[route.junction])
            self._lines = junction_signals(network, route.junction)
        self._approach = route.line.heading_at(max(route.event_at - 1.0, 0.0))

    @cached_property
    def room(self) -> NDArray[np.float64]:
        """(points, 2): the room left and right of each point of the route on driving lanes [m], at most `BESIDE`."""
        x, y, _, hx, hy = (np.array(column) for column in self._route.line.columns)
        hx, hy = np.append(hx, hx[-1]), np.append(hy, hy[-1])
        away = np.arange(_ROOM_STEP, BESIDE + _ROOM_STEP / 2, _ROOM_STEP)
        beside: list[NDArray[np.float64]] = []
        for side in (1.0, -1.0):
            there = np.stack((x[:, None] - side * hy[:, None] * away, y[:, None] + side * hx[:, None] * away), axis=-1)
            off = self._lane_map.off_road(there.reshape(-1, 2)).reshape(len(x), len(away))
            beside.append(_ROOM_STEP * np.logical_and.accumulate(~off, axis=1).sum(axis=1))
        return fixed(np.stack(beside, axis=1))

    @cached_property
    def limits(self) -> NDArray[np.float64]:
        """(segments,): the speed [m/s] that the map, or the kind of its roads, allows on each segment of the route."""
        return fixed(limits_along(self._network, self._route.line, self._route.lane_ids))

    def allowed(self, *, keeps_limits: bool, grip: float) -> NDArray[np.float64]:
        """(segments,): the speed [m/s] at which each segment of the route may be driven.

        Args:
            keeps_limits: Whether its limits count, beside its bends.
            grip: What the road holds [m/s²].
        """
        if (asked := (keeps_limits, grip)) not in self._allowed:
            limits = self.limits if keeps_limits else None
            self._allowed[asked] = fixed(allowed_speeds(self._route.line, limits, grip))
        return self._allowed[asked]

    def _own(self, line: StopLine) -> bool:
        return line.lane in self._route.lane_ids

    def same_lane(self, x: float, y: float, other_x: float, other_y: float) -> bool:
        """Whether two points lie in the same lane of the route."""
        return any(
            shapely.contains_xy(lane, other_x, other_y) and shapely.contains_xy(lane, x, y) for lane in self.lanes
        )

    @property
    def axis(self) -> float:
        """The direction [rad, 0 = +x, counter-clockwise] in which the ego comes to its junction."""
        return self._approach

    def signal_tracks(
        self, mode: str, steps: int, dt: float, lights: TrafficLights | None = None
    ) -> tuple[SignalTrack, ...]:
        """The signals at the route's junction, for as many states; as a program set them, if it did.

        Raises:
            MapError: `mode` is none of `MODES`.
        """
        return tuple(
            SignalTrack(
                x0=line.x0,
                y0=line.y0,
                x1=line.x1,
                y1=line.y1,
                state=states,
                role="ego" if self._own(line) else "other",
            )
            for line, states in self._states(mode, steps, dt, lights)
        )

    def settled(self, mode: str) -> float:
        """When the last signal at the route's junction changes [s]: 0 where there is none, inf where they go on."""
        return last_change(mode) if self._control is Control.SIGNAL and self._lines else 0.0

    def lights(self, mode: str, steps: int, dt: float, own: TrafficLights | None = None) -> dict[str, str]:
        """The states of each traffic light at the route's junction, by its id in OpenDRIVE; as a program set them.

        Raises:
            MapError: `mode` is none of `MODES`.
        """
        return {light: states for line, states in self._states(mode, steps, dt, own) for light in line.lights}

    def _states(
        self, mode: str, steps: int, dt: float, lights: TrafficLights | None = None
    ) -> Iterator[tuple[StopLine, str]]:
        """Each signalled stop line at the route's junction with its states."""
        if mode not in MODES:
            raise MapError(f"a program sets signals to {mode!r}; they can be {', '.join(MODES)}")
        if self._control is Control.SIGNAL:
            for line in self._lines:
                own_axis = abs(math.cos(line.heading - self._approach)) > _AXIS
                if lights is not None and line.control is Control.SIGNAL:
                    yield line, "".join(lights.state(line, step) for step in range(steps))
                else:
                    yield line, signal_states(mode, own_axis, steps, dt)

    def events(self, ego: Track, signals: tuple[SignalTrack, ...]) -> tuple[NDArray[np.bool_], list[Event]]:
        """Whether the ego was off the road at each step, and everything it did wrong but collide."""
        off_road, leaves, changes = self._cells.along(ego.x, ego.y)
        events = [Event(kind=EventKind.OFF_ROAD, step=step) for step in leaves]
        events += self._lane_invasions(ego, changes)
        own = [signal for signal in signals if signal.role == "ego"]
        events += [
            Event(kind=EventKind.RED_LIGHT, step=step, other="signal")
            for signal, step in zip(own, crossing_steps(ego, own), strict=True)
            if step is not None and signal.state[step] == "r"
        ]
        if self._control is Control.STOP_SIGN:
            events += self._stop_signs(ego)
        return off_road, events

    def _lane_invasions(self, ego: Track, changes: list[int]) -> list[Event]:
        """A change of lane outside junctions, or onto no lane at all."""
        if not changes:
            return []
        both = [*changes, *(step + 1 for step in changes)]
        inside: list[bool] = shapely.contains_xy(self._junctions, ego.x[both], ego.y[both]).tolist()
        crossed = zip(changes, inside, inside[len(changes) :], strict=False)
        return [Event(kind=EventKind.LANE_INVASION, step=step + 1) for step, *there in crossed if not any(there)]

    def _stop_signs(self, ego: Track) -> list[Event]:
        events: list[Event] = []
        free = any(line.control is Control.STOP_SIGN for line in self._lines)  # else the sign stands elsewhere
        for line in self._lines:
            signed = line.control is Control.STOP_SIGN or not free
            step = crossing_step(ego, line) if signed and self._own(line) else None
            if step is None:
                continue
            distance = np.hypot(ego.x[: step + 1] - ego.x[step], ego.y[: step + 1] - ego.y[step])
            before = np.abs(ego.speed[: step + 1][distance < STOP_ZONE])
            if before.min() > HALTED:
                events.append(Event(kind=EventKind.STOP_SIGN, step=step, other="stop sign"))
        return events


def crossing_step(track: Track, line: StopLine | SignalTrack) -> int | None:
    """The first step at which an actor's centre crosses a stop line, or None."""
    return crossing_steps(track, (line,))[0]


def crossing_steps(track: Track, lines: Sequence[StopLine | SignalTrack]) -> list[int | None]:
    """The first step at which an actor's centre crosses each of some stop lines, or None."""
    if not lines:
        return []
    if (native := engine()) is not None:
        return native.cross(track.x, track.y, np.array([(line.x0, line.y0, line.x1, line.y1) for line in lines]))
    return [_crossing_step(track, line) for line in lines]


def _crossing_step(track: Track, line: StopLine | SignalTrack) -> int | None:
    """The same of one line, without an engine."""
    px, py = track.x - line.x0, track.y - line.y0
    lx, ly = line.x1 - line.x0, line.y1 - line.y0
    side = lx * py - ly * px
    change = np.flatnonzero(side[:-1] * side[1:] < 0)
    for i in change.tolist():
        share = side[i] / (side[i] - side[i + 1])
        along = (px[i] + share * (px[i + 1] - px[i])) * lx + (py[i] + share * (py[i + 1] - py[i])) * ly
        if -0.1 <= along / (lx * lx + ly * ly) <= 1.1:
            return i + 1
    return None
