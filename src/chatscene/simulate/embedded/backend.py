"""One episode after another in the embedded simulator."""

from __future__ import annotations

from pathlib import Path

from chatscene.ego.policy import EgoPolicy, name_of, observation_of, pedals_of
from chatscene.errors import ChatSceneError, ProgramError
from chatscene.maps.lane_map import LaneMap
from chatscene.maps.network import load_network
from chatscene.settings import SimulationSettings
from chatscene.simulate.backend import drive_to_the_end
from chatscene.simulate.embedded.driving import EmbeddedDrive
from chatscene.simulate.embedded.roadside import RouteSurroundings
from chatscene.simulate.embedded.simulation import Drive
from chatscene.simulate.embedded.staging import Stage
from chatscene.simulate.watchdog import time_limit
from chatscene.terms.episode import Episode
from chatscene.terms.route import Route
from chatscene.terms.scene import Rejected, Scene, ScenicProgram


class EmbeddedBackend:
    """Runs scenes in this process; see `chatscene.simulate.backend.Backend` for the contract.

    Args:
        map_path: The map everything runs on.
        settings: Step and limits.
    """

    def __init__(self, map_path: Path, settings: SimulationSettings) -> None:
        self._settings = settings
        self._map_path = map_path
        self._stage = Stage(map_path)
        self._lane_map: LaneMap | None = None
        self._surroundings: dict[str, RouteSurroundings] = {}

    def route(self, program: ScenicProgram, index: int) -> Route:
        """The route a program's geometry picks under this index."""
        route: Route = self._stage.compiled(program, index).egoObject.route.route
        return route

    def routes(self, program: ScenicProgram) -> int:
        """How many routes the map has for a program's geometry, at most ten."""
        count: int = self._stage.compiled(program, 0).egoObject.route.count
        return count

    def run(
        self, program: ScenicProgram, scene: Scene, ego: EgoPolicy, *, through_collisions: bool = False
    ) -> Episode | Rejected:
        """Run one scene."""
        with time_limit(f"scene {scene.id!r}"):
            drive = self.open(
                program,
                scene,
                observation=observation_of(ego),
                pedals=pedals_of(ego),
                through_collisions=through_collisions,
            )
            if isinstance(drive, Rejected):
                return drive
            try:
                drive_to_the_end(drive, ego)
                if drive.rejection:
                    return Rejected(scene=scene, reason=drive.rejection)
                return drive.episode(scene.id, name_of(ego))
            finally:
                drive.close()

    def open(
        self,
        program: ScenicProgram,
        scene: Scene,
        *,
        observation: str = "safebench",
        pedals: str = "safebench",
        through_collisions: bool = False,
    ) -> EmbeddedDrive | Rejected:
        """Start a drive that is stepped from outside."""
        label = f"program {program.scenario_id!r} ({', '.join(program.snippet_ids)}), scene {scene.id!r},"
        try:
            placed = self._stage.place(program, scene)
            if isinstance(placed, Rejected):
                return placed
            setup = Drive(placed, self._settings.dt).__enter__()
        except Drive.REJECTIONS as error:
            return Rejected(scene=scene, reason=f"the program rejects the episode before it begins: {error}")
        except (ChatSceneError, MemoryError):
            raise
        except Exception as error:  # the program's own code, which may raise anything
            raise ProgramError(f"{label} fails while it is set up: {type(error).__name__}: {error}") from error
        route: Route = placed.egoObject.route.route
        try:
            drive = EmbeddedDrive(
                setup, route, self._around(route), self._settings, observation, pedals, through_collisions, label
            )
        except BaseException:
            setup.__exit__()
            raise
        if drive.rejection:
            drive.close()
            return Rejected(scene=scene, reason=drive.rejection)
        return drive

    def _around(self, route: Route) -> RouteSurroundings:
        if route.id not in self._surroundings:
            network = load_network(self._map_path)
            self._lane_map = self._lane_map or LaneMap(network)
            self._surroundings[route.id] = RouteSurroundings(network, route, self._lane_map)
        return self._surroundings[route.id]
