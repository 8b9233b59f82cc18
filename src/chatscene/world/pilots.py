"""Who moves by themselves: a vehicle on autopilot, somebody out for a walk.

A program for CARLA says so once, with an action, and a part of CARLA that it does not see does it from then on. Here a
pilot is asked at each step, after the behaviors and before the bodies move.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any, Protocol

from chatscene.terms.polyline import Polyline
from chatscene.world.control import Tracker
from chatscene.world.lights import light_ahead, lights
from chatscene.world.places import followingSpeed, laneLine
from chatscene.world.signals import GREEN

CRUISE = 30 / 3.6  # [m/s]: CARLA's towns have a limit of 30 km/h, and its traffic manager keeps to it
COMFORT = 2.5  # [m/s²], with which an autopilot comes to a stand at a light
STOP_SHORT = 3.0  # [m] from the centre of a vehicle to the stop line at which it stands
AHEAD = 300.0  # [m] of its way that an autopilot knows; then it looks again


class Pilot(Protocol):
    """Who moves by themselves."""

    def drive(self) -> None:
        """Say what the next step is to be."""
        ...


class Autopilot:
    """Follows its lane and the straightest ones after it, behind who is ahead, and stops at lights that are not green.

    Args:
        agent: The vehicle.
        simulation: The drive.
        speed: At most [m/s]; None for `CRUISE`.
        slower: By how many hundredths less.
        heeds_lights: Whether it stops at lights.
        heeds_walkers: Whether it stops behind people on foot.
    """

    def __init__(
        self,
        agent: Any,
        simulation: Any,
        *,
        speed: float | None = None,
        slower: float = 0.0,
        heeds_lights: bool = True,
        heeds_walkers: bool = True,
    ) -> None:
        self._agent = agent
        self._simulation = simulation
        self._speed = speed if speed is not None else CRUISE * max(0.0, 1.0 - slower / 100.0)
        self._heeds_lights = heeds_lights
        self._heeds_walkers = heeds_walkers
        self._tracker: Tracker | None = None
        self._line: Polyline | None = None

    def drive(self) -> None:
        """Set the pedals and the wheel for the next step."""
        agent = self._agent
        if self._tracker is None or self._line is None or self._tracker.along > self._line.length - CRUISE:
            network = self._simulation.scene.workspace.network
            lane = network.laneAt(agent.position)
            if lane is None:  # off the road: it stands, as there is no lane that it could follow
                agent.setControls(0.0, 1.0, 0.0, False)
                return
            self._line = laneLine(lane, AHEAD)
            self._tracker = Tracker(self._line, agent.wheelbase, agent.wheelAngle, grip=agent.body.grip)
        wish = followingSpeed(self._line, agent, list(self._others()), self._speed)
        if self._heeds_lights:
            wish = min(wish, self._speed_for_light())
        agent.setControls(*self._tracker.controls(agent.pose, wish), False)

    def _others(self) -> Iterator[Any]:
        for other in self._simulation.objects:
            if other.body is not self._agent.body and (self._heeds_walkers or not getattr(other, "isWalker", False)):
                yield other

    def _speed_for_light(self) -> float:
        """The speed [m/s] from which it can still stop at the light ahead; any where it has green or none."""
        agent = self._agent
        line = light_ahead(agent, AHEAD)
        if line is None or lights().state(line, self._simulation.currentTime) == GREEN:
            return math.inf
        x, y, heading, speed = agent.pose
        mx, my = 0.5 * (line.x0 + line.x1), 0.5 * (line.y0 + line.y1)
        room = (mx - x) * math.cos(heading) + (my - y) * math.sin(heading) - 0.5 * agent.length - STOP_SHORT
        if room < speed * speed / (4 * COMFORT) - STOP_SHORT:  # too late to stop: it passes
            return math.inf
        return math.sqrt(2 * COMFORT * room) if room > 0.0 else 0.0


class Stroll:
    """Walks along the sidewalk, the way it faces, and straight on where there is none.

    Args:
        agent: Who walks.
        simulation: The drive.
        speed: [m/s].
    """

    def __init__(self, agent: Any, simulation: Any, speed: float) -> None:
        self._agent = agent
        self._speed = speed
        self._line: Polyline | None = None
        sidewalk = simulation.scene.workspace.network.sidewalkAt(agent.position)
        if sidewalk is not None:
            line = Polyline([(x, y) for x, y, *_ in sidewalk.centerline.points])
            along, _, _ = line.project(agent.position.x, agent.position.y)
            with_it = math.cos(line.heading_at(along) - agent.pose[2]) >= 0.0
            self._line = line if with_it else Polyline(line.points[::-1])

    def drive(self) -> None:
        """Say where to walk in the next step."""
        x, y, heading, _ = self._agent.pose
        if self._line is not None:
            px, py = self._line.point_at(self._line.project(x, y)[0] + 2.0)
            heading = math.atan2(py - y, px - x)
        self._agent.setWalk(heading, self._speed)
