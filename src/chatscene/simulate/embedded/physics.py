"""The embedded simulator: our own bodies under Scenic's loop."""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import partial
from pathlib import Path

from chatscene.settings import SimulationSettings
from chatscene.simulate.embedded.dynamics import VehicleBody, WalkerBody, make_body
from chatscene.simulate.embedded.lagged import LaggedVehicle
from chatscene.simulate.stepped import SteppedSimulator
from chatscene.terms.actors import LIMITS
from chatscene.terms.simulator import SimulatorIdentity
from chatscene.world.bodies import Body, Led, Placement

VERSION = "1"  # another one whenever a step gives other numbers
KINEMATIC = "kinematic bicycles and walkers within actuator limits"
LAGGED = "bicycles with pedal and yaw lag, understeer and a friction circle, and walkers within limits"


class EmbeddedPhysics:
    """Bodies that move one by one, in the order they were made; see `chatscene.simulate.physics.Physics`."""

    def __init__(self, body_of: Callable[[Placement], Body] = make_body) -> None:
        self._body_of = body_of
        self._moving: list[VehicleBody | WalkerBody] = []

    def add(self, placement: Placement) -> Body:
        """Make the body of a thing."""
        body = self._body_of(placement)
        if isinstance(body, VehicleBody | WalkerBody):
            self._moving.append(body)
        return body

    def step(self, dt: float) -> None:
        """Move every body by `dt` [s]."""
        for body in self._moving:
            if body.led is None:
                body.step(dt)
            else:
                _leads(body, body.led)

    def close(self) -> None:
        """Nothing is held."""


def _leads(body: VehicleBody | WalkerBody, to: Led) -> None:
    """Put a body where it is led to."""
    x, y, heading, speed = to
    body.led, body.before = None, body.speed
    body.x, body.y, body.speed = x, y, speed
    body.heading += math.remainder(heading - body.heading, math.tau)
    body.cos, body.sin = math.cos(heading), math.sin(heading)
    if isinstance(body, WalkerBody):
        body.vx, body.vy = speed * body.cos, speed * body.sin
    else:
        body.wheel = 0.0


def make_simulator(map_path: Path, settings: SimulationSettings) -> SteppedSimulator:
    """The embedded simulator for one map."""
    lagged = settings.physics == "lagged"
    identity = SimulatorIdentity(
        name="embedded",
        version=VERSION,
        physics=LAGGED if lagged else KINEMATIC,
        exact=True,
        confinable=True,
        at_once=not lagged,
        brake_lag=LIMITS["Car"].brake_lag if lagged else 0.0,
    )
    body_of = partial(make_body, vehicle=LaggedVehicle) if lagged else make_body
    return SteppedSimulator(map_path, settings, identity=identity, physics_of=partial(EmbeddedPhysics, body_of))
