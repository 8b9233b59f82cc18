"""CARLA as a simulator: Scenic's loop over the bodies of a server."""

from __future__ import annotations

import logging
import time
from pathlib import Path
from typing import Any

from scenic.syntax.veneer import simulation

from chatscene.errors import ServerError
from chatscene.maps.junctions import junction_signals
from chatscene.maps.network import load_network
from chatscene.settings import SimulationSettings
from chatscene.simulate.carla.blueprints import PROPS, blueprint_of
from chatscene.simulate.carla.connection import address, connected
from chatscene.simulate.carla.physics import CarlaPhysics, size_as_placed
from chatscene.simulate.carla.weather import weather_of
from chatscene.simulate.stepped import SteppedSimulator
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scene import Scene
from chatscene.terms.simulator import SimulatorIdentity
from chatscene.terms.surroundings import Surface, surroundings_of
from chatscene.world.bodies import Placement

ENGINE = "CARLA's engine"
STAND_IN = "a stand-in for CARLA, not CARLA: chatscene serve-carla"
_log = logging.getLogger(__name__)


class CarlaSimulator(SteppedSimulator):
    """Runs scenes in a CARLA server; see `chatscene.simulate.simulator.Simulator` for the contract.

    Attributes:
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
        super().__init__(map_path, settings, identity=identity, physics_of=None)
        self._watched = False
        self._recording: Path | None = None
        self._held_dry: set[Surface] = set()
        self.disagreements: list[str] = []

    def show(self, *, watched: bool, recording: Path | None) -> None:
        """Say how the next scenes can be looked at.

        Args:
            watched: Whether the server's own window looks down on the ego.
            recording: Where its recorder writes, as the server sees files; None for nowhere.
        """
        self._watched, self._recording = watched, recording

    def size_of(self, placement: Placement) -> tuple[float, float]:
        """Length and width [m] that a thing has here."""
        return size_as_placed(placement, self._connection.measured(blueprint_of(placement)))

    def survey(self) -> str:
        """What the server has of what our scenes need on their map, in words.

        Raises:
            ServerError: It lacks something.
        """
        connection = self._connection
        world = connection.begin(self._map_path, self._settings.dt)
        try:
            wanted = {*PROPS.values(), *(kind.row.blueprint for kind in AdversaryKind)}
            for name in sorted(wanted):
                connection.measured(name)
            began, ticks = time.monotonic(), 20
            for _ in range(ticks):
                connection.tick(world)
            rate = ticks / (time.monotonic() - began)
            with connection.asking("tell its map and lights"):
                name = world.get_map().name
                lights = {light.get_opendrive_id() for light in world.get_actors().filter("traffic.traffic_light*")}
        finally:
            if not connection.lost:
                connection.end(world)
        network = load_network(self._map_path)
        lines = [line for junction in network.intersections for line in junction_signals(network, junction.uid)]
        ours = {light for line in lines for light in line.lights}
        if missing := sorted(ours - lights):
            raise ServerError(
                f"on the map {name} of the server at {connection.place}, {len(missing)} of {len(ours)} traffic lights "
                f"are not there: {', '.join(missing[:10])}"
            )
        has = f"map {name}, {len(wanted)} blueprints, {len(ours)} traffic lights"
        return f"{has}; {rate:.0f} ticks/s with nobody there"

    def physics_for(self, scene: Scene, placed: Any) -> CarlaPhysics:
        """The bodies of one of Scenic's scenes, and the lights on the ego's way."""
        around = self.surroundings(placed.egoObject.route.route)
        mode, dt = str(placed.params["signals"]), self._settings.dt
        planned = around.lights(mode, self._settings.max_steps + 1, dt)

        def lights(step: int) -> dict[str, str]:
            own = simulation().lights  # those of the drive that is running, once its program has asked for any
            states = planned if own is None else around.lights(mode, step + 1, dt, own)
            return {name: state[min(step, len(state) - 1)] for name, state in states.items()}

        def told(disagreement: str) -> None:
            self.disagreements.append(f"{scene.id}: {disagreement}")
            _log.warning("%s: %s", scene.id, disagreement)

        surroundings = surroundings_of(placed.params)
        if surroundings.surface not in (Surface.DRY, *self._held_dry):
            self._held_dry.add(surroundings.surface)
            _log.warning("%s: %s; CARLA's tyres hold as on a dry road", scene.id, surroundings.surface.row.said)
        return CarlaPhysics(
            self._connection,
            self._map_path,
            dt,
            weather=weather_of(surroundings),
            lights=lights,
            told=told,
            watched=self._watched,
            recording=self._recording,
        )
