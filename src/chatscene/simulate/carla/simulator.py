"""CARLA as a simulator: Scenic's loop over the bodies of a server."""

from __future__ import annotations

import logging
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from chatscene.settings import SimulationSettings
from chatscene.simulate.carla.blueprints import blueprint_of
from chatscene.simulate.carla.connection import address, connected
from chatscene.simulate.carla.physics import CarlaPhysics, size_as_placed
from chatscene.simulate.stepped import SteppedSimulator
from chatscene.terms.scene import Scene
from chatscene.terms.simulator import SimulatorIdentity
from chatscene.world.bodies import Placement

ENGINE = "CARLA's engine"
STAND_IN = "a stand-in for CARLA, not CARLA: chatscene serve-carla"
_log = logging.getLogger(__name__)


class CarlaSimulator(SteppedSimulator):
    """Runs scenes in a CARLA server; see `chatscene.simulate.simulator.Simulator` for the contract.

    Args:
        map_path: The map everything runs on.
        settings: Step and limits, and where the server is (`chatscene.simulate.carla.connection.address`).

    Attributes:
        watched: Whether the server's own window looks down on the ego.
        recording: Where the server writes its recorder's file of the next scenes, as it sees files; None for nowhere.
        disagreements: What CARLA's collision sensor and our boxes said differently so far.

    Raises:
        ServerError: No CARLA server of the wheel's version answers there.
        SettingsError: The settings do not say where it is.
    """

    def __init__(self, map_path: Path, settings: SimulationSettings) -> None:
        self._connection = connected(*address(settings.simulator))
        identity = SimulatorIdentity(
            name="carla",
            version=self._connection.version,
            physics=STAND_IN if self._connection.stands_in else ENGINE,
            exact=False,
            confinable=False,
        )
        super().__init__(map_path, settings, identity=identity, physics_of=self._bodies)
        self.watched = False
        self.recording: Path | None = None
        self.disagreements: list[str] = []

    def size_of(self, placement: Placement) -> tuple[float, float]:
        """Length and width [m] that a thing has here."""
        return size_as_placed(placement, self._connection.measured(blueprint_of(placement.kind)))

    def physics_for(self, scene: Scene, placed: Any) -> CarlaPhysics:
        """The bodies of one of Scenic's scenes, and the lights on the ego's way."""
        mode, states = str(placed.params["signals"]), self._settings.max_steps + 1
        around = self.surroundings(placed.egoObject.route.route)
        return self._bodies(around.lights(mode, states, self._settings.dt), scene.id)

    def _bodies(self, lights: Mapping[str, str] | None = None, scene_id: str = "a scene") -> CarlaPhysics:
        def told(disagreement: str) -> None:
            self.disagreements.append(f"{scene_id}: {disagreement}")
            _log.warning("%s: %s", scene_id, disagreement)

        return CarlaPhysics(
            self._connection,
            self._map_path,
            self._settings.dt,
            lights=lights or {},
            told=told,
            watched=self.watched,
            recording=self.recording,
        )
