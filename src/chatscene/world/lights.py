"""Traffic lights that a program reads and sets, as programs for CARLA do.

A light is the stop line of a lane. Until a program touches it, it runs on the clock of `chatscene.world.signals`: the
approaches of a junction fall into two axes that take turns. What a program sets stays until it sets something else.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any

from scenic.syntax.veneer import simulation

from chatscene.maps.junctions import StopLine, junction_signals
from chatscene.maps.lane_runs import lane_runs
from chatscene.terms.scenario import Control
from chatscene.world.signals import COLOURS, state_on_clock

_AXIS = math.sqrt(0.5)  # cosine of 45°: a lane nearer than that to a direction is on its axis
_WORDS = {state: colour for colour, state in COLOURS.items()}
NONE = "None"
"""What Scenic's model for CARLA answers where there is no light."""


@dataclass(slots=True)
class TrafficLights:
    """The lights of one drive.

    Attributes:
        network: Scenic's road network.
        dt: Step [s].
        axis: By junction, the direction [rad] of the axis that has green first; else that of its first light.
    """

    network: Any
    dt: float
    axis: dict[str, float] = field(default_factory=dict[str, float])
    _lines: dict[str, tuple[StopLine, ...]] = field(default_factory=dict[str, tuple[StopLine, ...]])
    _set: dict[str, list[tuple[int, str]]] = field(default_factory=dict[str, list[tuple[int, str]]])
    _frozen: list[tuple[int, bool]] = field(default_factory=list[tuple[int, bool]])

    def lines(self, junction: str) -> tuple[StopLine, ...]:
        """The lights of a junction."""
        if junction not in self._lines:
            every = junction_signals(self.network, junction)
            self._lines[junction] = tuple(line for line in every if line.control is Control.SIGNAL)
        return self._lines[junction]

    def state(self, line: StopLine, step: int) -> str:
        """``g``, ``y`` or ``r``."""
        for since, state in reversed(self._set.get(line.lane, ())):
            if since <= step:
                return state
        axis = self.axis.setdefault(line.junction, self.lines(line.junction)[0].heading)
        return state_on_clock(self._running(step) * self.dt, abs(math.cos(line.heading - axis)) > _AXIS)

    def put(self, line: StopLine, state: str, step: int) -> None:
        """Set a light, from a step on."""
        self._set.setdefault(line.lane, []).append((step, state))

    def freeze(self, frozen: bool, step: int) -> None:
        """Stop the clock of all lights, or have it go on."""
        self._frozen.append((step, frozen))

    def _running(self, step: int) -> int:
        """For how many of the steps until now the clock has run."""
        running, since, stopped = 0, 0, False
        for at, frozen in (*self._frozen, (step, False)):
            if at > step:
                break
            running += 0 if stopped else at - since
            since, stopped = at, frozen
        return running + (0 if stopped else max(step - since, 0))


def lights() -> TrafficLights:
    """Those of the drive that is running."""
    running = simulation()
    if running.lights is None:
        running.lights = TrafficLights(running.scene.workspace.network, running.timestep, dict(running.axes))
    return running.lights


def light_ahead(agent: Any, within: float) -> StopLine | None:
    """The light that an agent comes to on its lane, if it is nearer than `within` [m]; none within a junction."""
    network = simulation().scene.workspace.network
    at = agent.position
    lane = None if network.intersectionAt(at) else network.laneAt(at)
    run = None if lane is None else lane_runs(network).get(lane.uid)
    if run is None or not run.lanes[-1].maneuvers or run.lanes[-1].maneuvers[0].intersection is None:
        return None
    last = run.lanes[-1]
    if run.line.length - run.line.project(at.x, at.y)[0] > within:
        return None
    return next((line for line in lights().lines(last.maneuvers[0].intersection.uid) if line.lane == last.uid), None)


# The functions of Scenic's model for CARLA


def freezeTrafficLights() -> None:  # noqa: N802 - Scenic's names, from here on
    """Stop the clock of all lights; what a program sets still counts."""
    lights().freeze(True, simulation().currentTime)


def unfreezeTrafficLights() -> None:  # noqa: N802
    """Have the clock of all lights go on."""
    lights().freeze(False, simulation().currentTime)


def withinDistanceToTrafficLight(vehicle: Any, thresholdDistance: float) -> bool:  # noqa: N802, N803
    """Whether a vehicle comes to a light that is nearer than so many metres."""
    return light_ahead(vehicle, thresholdDistance) is not None


def withinDistanceToRedYellowTrafficLight(vehicle: Any, thresholdDistance: float) -> bool:  # noqa: N802, N803
    """Whether a vehicle comes to a light that is nearer than so many metres and not green."""
    return getClosestTrafficLightStatus(vehicle, thresholdDistance) in ("red", "yellow")


def getClosestTrafficLightStatus(vehicle: Any, distance: float = 100) -> str:  # noqa: N802
    """The colour of the light that a vehicle comes to; ``None``, in words, where there is none."""
    line = light_ahead(vehicle, distance)
    return NONE if line is None else _WORDS[lights().state(line, simulation().currentTime)]


def setClosestTrafficLightStatus(vehicle: Any, color: str, distance: float = 100) -> None:  # noqa: N802
    """Set the light that a vehicle comes to, if there is one.

    Raises:
        ValueError: There is no such colour.
    """
    state = state_of(color)
    line = light_ahead(vehicle, distance)
    if line is not None:
        lights().put(line, state, simulation().currentTime)


def getTrafficLightStatus(signal: Any) -> str:  # noqa: N802
    """The colour of a light of the map; ``None``, in words, where no lane stops at it."""
    found = _lines_of(signal)
    return _WORDS[lights().state(found[0], simulation().currentTime)] if found else NONE


def setTrafficLightStatus(signal: Any, color: str) -> None:  # noqa: N802
    """Set a light of the map.

    Raises:
        ValueError: There is no such colour, or it is no light.
    """
    state = state_of(color)
    for line in _lines_of(signal):
        lights().put(line, state, simulation().currentTime)


def setAllIntersectionTrafficLightsStatus(intersection: Any, color: str) -> None:  # noqa: N802
    """Set all lights of a junction.

    Raises:
        ValueError: There is no such colour.
    """
    state = state_of(color)
    for line in lights().lines(intersection.uid):
        lights().put(line, state, simulation().currentTime)


def state_of(color: str) -> str:
    """The state that a colour stands for.

    Raises:
        ValueError: There is no such colour.
    """
    if color not in COLOURS:
        raise ValueError(f"a light is {', '.join(COLOURS)}; not {color!r}")
    return COLOURS[color]


def _lines_of(signal: Any) -> list[StopLine]:
    """The stop lines of the lanes whose ways through a junction a signal of the map controls."""
    if not signal.isTrafficLight:
        raise ValueError(f"the signal {signal.openDriveID} is not a traffic light")
    return [
        line
        for junction in lights().network.intersections
        for line in lights().lines(junction.uid)
        if str(signal.openDriveID) in line.lights
    ]
