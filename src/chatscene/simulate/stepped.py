"""A simulator made of Scenic's loop and a physics."""

from __future__ import annotations

from collections import OrderedDict
from dataclasses import replace
from pathlib import Path
from typing import Any

from scenic.core.distributions import RejectionException

from chatscene.errors import ChatSceneError, MapError, ProgramError, StuckBehavior
from chatscene.maps.lane_map import LaneMap
from chatscene.maps.loading import load_roads
from chatscene.maps.network import map_digest
from chatscene.settings import SimulationSettings
from chatscene.simulate.physics import CannotPlace, Physics, PhysicsOf
from chatscene.simulate.placing import Placement
from chatscene.simulate.roadside import RouteSurroundings
from chatscene.simulate.session import SteppedSession
from chatscene.simulate.simulation import SteppedSimulation
from chatscene.simulate.staging import NO_PLACE, Stage
from chatscene.terms.mirroring import mirrored_route
from chatscene.terms.pointing import fault
from chatscene.terms.route import Route
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.simulator import SimulatorIdentity
from chatscene.world.compilation import free_process, take_process

DRAWN = 10  # routes of a program that draws where its ego stands; each is a sequence of draws of its own
KEPT = 64  # routes whose surroundings are kept per process

_counts: dict[tuple[str, str, str, bool], int] = {}  # of routes, which every simulator of a map is asked for anew


class SteppedSimulator:
    """Opens sessions in this process; see `chatscene.simulate.simulator.Simulator` for the contract.

    Args:
        map_path: The map everything runs on.
        settings: Step and limits.
        identity: What it is.
        physics_of: Makes the physics of each scene; None where it depends on the scene (`physics_for`).

    Attributes:
        identity: What it is.
        physics_of: As above.
    """

    def __init__(
        self, map_path: Path, settings: SimulationSettings, *, identity: SimulatorIdentity, physics_of: PhysicsOf | None
    ) -> None:
        self.identity = replace(identity, occlusion=settings.occlusion)
        self.physics_of = physics_of
        self._settings = settings
        self._map_path = map_path
        self._stage = Stage(map_path)
        self._lane_map: LaneMap | None = None
        self._surroundings: OrderedDict[str, RouteSurroundings] = OrderedDict()

    def route(self, program: ScenicProgram, index: int) -> Route:
        """The route a program's geometry picks under this index."""
        if program.drawn:
            raise ProgramError(f"{program.called} draws where its ego stands; each scene has a route")
        return self._on_map(self._stage.compiled(program, index).egoObject.route)

    def routes(self, program: ScenicProgram) -> int:
        """How many routes the map has for a program's geometry, at most ten."""
        key = (map_digest(self._map_path), program.digest, program.model, program.drawn)
        if key not in _counts:
            scenario = self._stage.compiled(program, 0)
            _counts[key] = DRAWN if program.drawn else scenario.egoObject.route.count
        return _counts[key]

    def route_in(self, program: ScenicProgram, scene: Scene) -> Route:
        """The route of the ego in a scene."""
        if not program.drawn:
            return self.route(program, scene.route)
        placed = self._stage.place(program, scene)
        if isinstance(placed, Rejected):
            raise MapError(f"scene {scene.id!r} has no route, since it is rejected: {placed.reason}")
        return self._on_map(placed.egoObject.route)

    @staticmethod
    def _on_map(of_ego: Any) -> Route:
        """A route as it lies on its map, which may keep to the left."""
        route: Route = of_ego.route
        return replace(mirrored_route(route), mirrored=True) if of_ego.network.mirrored else route

    def open(
        self,
        program: ScenicProgram,
        scene: Scene,
        *,
        observation: str = "safebench",
        pedals: str = "safebench",
        through_collisions: bool = False,
    ) -> SteppedSession | Rejected:
        """Start a session."""
        free_process()
        try:
            placed = self._stage.place(program, scene)
            if isinstance(placed, Rejected):
                return placed
            simulation = SteppedSimulation(placed, self.physics_for(scene, placed), self._settings.dt).__enter__()
        except CannotPlace as error:
            return Rejected(scene=scene, reason=str(error))
        except SteppedSimulation.REJECTIONS as error:
            return Rejected(scene=scene, reason=f"the program rejects the episode before it begins: {error}")
        except (ChatSceneError, MemoryError):
            raise
        except Exception as error:  # the program's own code, which may raise anything
            why = fault(error, program.filename, program.source)
            raise ProgramError(f"{_label(program, scene)} fails while it is set up: {why}") from error
        try:
            session = self._session(simulation, program, scene, observation, pedals, through_collisions)
        except BaseException:
            simulation.__exit__()
            raise
        if session.rejection:
            session.close()
            return Rejected(scene=scene, reason=session.rejection)
        take_process(session.close)
        return session

    def _session(
        self,
        simulation: SteppedSimulation,
        program: ScenicProgram,
        scene: Scene,
        observation: str,
        pedals: str,
        through: bool,
    ) -> SteppedSession:
        route: Route = simulation.scene.egoObject.route.route
        return SteppedSession(
            simulation,
            route,
            self.surroundings(route),
            self._settings,
            observation,
            pedals,
            through,
            _label(program, scene),
            program,
            self._stage.draws,
        )

    def learn(self, program: ScenicProgram, scene: Scene, opened: SteppedSession) -> None:
        """Take in how one scene was placed, and is closed: the next need not be placed by Scenic, if that can be."""
        self._stage.learn(program, scene.route, opened.simulation)

    def place(
        self, program: ScenicProgram, scene: Scene, *, observation: str, pedals: str, through_collisions: bool
    ) -> SteppedSession | Rejected | None:
        """A scene at its beginning, with nobody who acts, for an engine; None where `open` has to place it.

        It is placed as `open` does, by what was taken in of one before (`learn`), and is not to be closed.
        """
        placement = self._stage.placement(program, scene)
        if placement is None:
            return None
        free_process()
        try:
            simulation = placement.scene(scene.values, scene.seed, self.physics_for(scene, None), self._settings.dt)
            session = self._session(simulation, program, scene, observation, pedals, through_collisions)
        except RejectionException:
            return Rejected(scene=scene, reason=NO_PLACE)
        except CannotPlace as error:
            return Rejected(scene=scene, reason=str(error))
        except (StuckBehavior, MemoryError):
            raise
        except Exception:  # noqa: BLE001 - whatever it is, `open` comes to it too, and says it as it does
            return None
        return Rejected(scene=scene, reason=session.rejection) if session.rejection else session

    def again(self, session: SteppedSession, placement: Placement, scene: Scene) -> Rejected | bool:
        """Make a session of `place` that of another scene of its program, at its beginning.

        Args:
            session: The session.
            placement: From `differs_in`.
            scene: The other scene.

        Returns:
            True, or why there is no such scene, or False if anything else fails: `place` comes to it, too.
        """
        free_process()
        try:
            placement.again(session.simulation, scene.values, scene.seed, self.physics_for(scene, None))
            session.begin_again()
        except RejectionException:
            return Rejected(scene=scene, reason=NO_PLACE)
        except CannotPlace as error:
            return Rejected(scene=scene, reason=str(error))
        except (StuckBehavior, MemoryError):
            raise
        except Exception:  # noqa: BLE001 - as in `place`
            return False
        return Rejected(scene=scene, reason=session.rejection) if session.rejection else True

    def differs_in(self, program: ScenicProgram, scene: Scene) -> Placement | None:
        """How scenes of a program on such a route differ, where `again` makes one of another; else None."""
        placement = self._stage.placement(program, scene)
        return placement if placement is not None and placement.moves else None

    def physics_for(self, scene: Scene, placed: Any) -> Physics:  # noqa: ARG002 - for those that need them
        """The physics of a scene, which Scenic has placed."""
        assert self.physics_of is not None
        return self.physics_of()

    def surroundings(self, route: Route) -> RouteSurroundings:
        """What lies along a route."""
        if route.id not in self._surroundings:
            roads = load_roads(self._map_path)
            self._lane_map = self._lane_map or LaneMap(roads)
            self._surroundings[route.id] = RouteSurroundings(roads, route, self._lane_map)
            while len(self._surroundings) > KEPT:
                self._surroundings.popitem(last=False)
        return self._surroundings[route.id]


def _label(program: ScenicProgram, scene: Scene) -> str:
    """What messages call a scene."""
    return f"{program.called}, scene {scene.id!r},"
