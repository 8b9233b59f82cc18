"""Simulators for Scenic's own command, which runs a simulation to its end by itself."""

from __future__ import annotations

from pathlib import Path

from chatscene.errors import SettingsError
from chatscene.settings import SimulationSettings
from chatscene.simulate.physics import PhysicsOf
from chatscene.simulate.simulation import PhysicsSimulator
from chatscene.simulate.simulator import load_simulator


def scenic_simulator(name: str, map_path: str) -> PhysicsSimulator:
    """Scenic's simulator over the physics of a simulator of ours.

    Raises:
        SettingsError: There is no simulator of that name, or it is not made of Scenic's loop and a physics.
    """
    simulator = load_simulator(Path(map_path), SimulationSettings(simulator=name))
    physics_of: PhysicsOf | None = getattr(simulator, "physics_of", None)
    if physics_of is None:
        raise SettingsError(f"Scenic's own command cannot run the simulator {name!r}; use chatscene run --program")
    return PhysicsSimulator(physics_of)
