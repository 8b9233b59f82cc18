"""The embedded simulator: our own bodies under Scenic's loop."""

from __future__ import annotations

from pathlib import Path

from chatscene.settings import SimulationSettings
from chatscene.simulate.embedded.dynamics import VehicleBody, WalkerBody, make_body
from chatscene.simulate.stepped import SteppedSimulator
from chatscene.terms.simulator import SimulatorIdentity
from chatscene.world.bodies import Body, Placement

VERSION = "1"  # another one whenever a step gives other numbers


class EmbeddedPhysics:
    """Bodies that move one by one, in the order they were made; see `chatscene.simulate.physics.Physics`."""

    def __init__(self) -> None:
        self._moving: list[VehicleBody | WalkerBody] = []

    def add(self, placement: Placement) -> Body:
        """Make the body of a thing."""
        body = make_body(placement)
        if isinstance(body, VehicleBody | WalkerBody):
            self._moving.append(body)
        return body

    def step(self, dt: float) -> None:
        """Move every body by `dt` [s]."""
        for body in self._moving:
            body.step(dt)

    def close(self) -> None:
        """Nothing is held."""


def make_simulator(map_path: Path, settings: SimulationSettings) -> SteppedSimulator:
    """The embedded simulator for one map."""
    identity = SimulatorIdentity(
        name="embedded",
        version=VERSION,
        physics="kinematic bicycles and walkers within actuator limits",
        exact=True,
        confinable=True,
    )
    return SteppedSimulator(map_path, settings, identity=identity, physics_of=EmbeddedPhysics)
