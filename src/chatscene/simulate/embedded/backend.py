"""One episode after another in the embedded simulator."""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any

import numpy as np

from chatscene.ego.observation import SIGHT, RouteView
from chatscene.ego.policy import EgoPolicy, controls
from chatscene.errors import EgoError, ProgramError
from chatscene.maps.lane_map import LaneMap
from chatscene.maps.network import load_network
from chatscene.settings import SimulationSettings
from chatscene.simulate.embedded.contact import approach_speed, contact_side, touch
from chatscene.simulate.embedded.dynamics import Body, VehicleBody
from chatscene.simulate.embedded.roadside import RouteSurroundings
from chatscene.simulate.embedded.simulation import Drive
from chatscene.simulate.embedded.staging import Stage
from chatscene.simulate.watchdog import time_limit
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, Track
from chatscene.terms.route import Route
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

PATIENCE = 20.0  # [s] of wall time for one episode, which normally takes some ten milliseconds
ARRIVAL = 0.99  # share of the route that counts as complete (SafeBench, RouteCompletionTest)
SECONDS_PER_METRE = 1.0  # SafeBench's time limit per metre of route

# What the code of a snippet, or of a program by a stranger, may raise while it runs.
_FAULTS = (ArithmeticError, AssertionError, AttributeError, LookupError, NameError, TypeError, ValueError)


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
        with time_limit(PATIENCE, f"scene {scene.id!r}"):
            placed = self._stage.place(program, scene)
            if isinstance(placed, Rejected):
                return placed
            try:
                return self._drive(placed, scene, ego, through_collisions)
            except _FAULTS as error:
                raise ProgramError(
                    f"program {program.scenario_id!r} fails while scene {scene.id!r} runs: "
                    f"{type(error).__name__}: {error}; its parts: {', '.join(program.snippet_ids)}"
                ) from error

    def _drive(self, placed: Any, scene: Scene, ego: EgoPolicy, through: bool) -> Episode | Rejected:
        route: Route = placed.egoObject.route.route
        around = self._around(route)
        with Drive(placed, self._settings.dt) as drive:
            names = _names(drive.objects)
            overlap = _overlap(drive.bodies, names)
            if overlap:
                return Rejected(scene=scene, reason=overlap)
            run = _Run(drive, route, around, names, self._settings, through)
            rejection = run.to_the_end(ego)
            if rejection is not None:
                return Rejected(scene=scene, reason=rejection)
        return run.episode(scene, _name(ego), str(placed.params["signals"]))

    def _around(self, route: Route) -> RouteSurroundings:
        if route.id not in self._surroundings:
            network = load_network(self._map_path)
            self._lane_map = self._lane_map or LaneMap(network)
            self._surroundings[route.id] = RouteSurroundings(network, route, self._lane_map)
        return self._surroundings[route.id]


class _Run:
    """The state of one drive in progress, and what it leaves behind."""

    def __init__(
        self,
        drive: Drive,
        route: Route,
        around: RouteSurroundings,
        names: list[tuple[str, Role]],
        settings: SimulationSettings,
        through: bool,
    ) -> None:
        self._drive = drive
        self._route = route
        self._around = around
        self._names = names
        self._settings = settings
        self._through = through
        self._view = RouteView(route.line)
        self._moving = [body for body in drive.bodies if type(body) is not Body]
        self._vehicles = [body for obj, body in zip(drive.objects, drive.bodies, strict=True) if obj.isVehicle][1:]
        self._rows: list[float] = []
        self._offsets: list[float] = []
        self._contacts: list[Event] = []
        self._touching: set[int] = set()
        self.ending = Ending.TIMEOUT

    def to_the_end(self, ego: EgoPolicy) -> str | None:
        """Step until the episode ends; the reason if the program itself rejects it."""
        drive, body, view = self._drive, self._drive.bodies[0], self._view
        if not isinstance(body, VehicleBody):
            raise ProgramError(f"the ego must be a vehicle, not a {type(drive.objects[0]).__name__}")
        act, observe, ahead = ego.act, view.observe, self._vehicle_ahead
        limit = min(self._settings.max_steps, int(self._route.length * SECONDS_PER_METRE / self._settings.dt))
        for step in itertools.count():
            observation = observe(body.x, body.y, body.heading, body.speed, ahead(body))
            self._record()
            if (ending := self._ended(step, limit)) is not None:
                self.ending = ending
                return None
            try:
                action = act(observation)
            except Exception as error:
                raise EgoError(
                    f"the ego {_name(ego)!r} fails at step {step}: {type(error).__name__}: {error}"
                ) from error
            body.throttle, body.brake, body.steer = controls(action)
            try:
                drive.advance()
            except drive.REJECTIONS as error:
                return f"the program rejects the episode at step {step}: {error}"
        return None

    def _ended(self, step: int, limit: int) -> Ending | None:
        if self._collides(step) and not self._through:
            return Ending.COLLISION
        if self._view.along >= ARRIVAL * self._route.length:
            return Ending.ARRIVED
        if self._drive.done is not None:
            return Ending.SCENARIO_DONE
        return Ending.TIMEOUT if step >= limit else None

    def _vehicle_ahead(self, ego: Body) -> bool:
        for other in self._vehicles:
            dx, dy = other.x - ego.x, other.y - ego.y
            near = dx * dx + dy * dy < SIGHT * SIGHT and dx * ego.cos + dy * ego.sin > 0.0
            if near and self._around.same_lane(ego.x, ego.y, other.x, other.y):
                return True
        return False

    def _record(self) -> None:
        add = self._rows.extend
        for body in self._moving:
            add((body.x, body.y, body.heading, body.speed))
        self._offsets.append(self._view.offset)

    def _collides(self, step: int) -> bool:
        bodies = self._drive.bodies
        ego = bodies[0]
        for i in range(1, len(bodies)):
            if touch(ego, bodies[i]):
                if i not in self._touching:
                    self._touching.add(i)
                    self._contacts.append(
                        Event(
                            kind=EventKind.COLLISION,
                            step=step,
                            other=self._names[i][0],
                            side=contact_side(ego, bodies[i]),
                            impact_speed=approach_speed(ego, bodies[i]),
                        )
                    )
            else:
                self._touching.discard(i)
        return bool(self._touching)

    def episode(self, scene: Scene, ego: str, signals: str) -> Episode:
        """Everything that happened, with the events that follow from the tracks."""
        tracks = self._tracks()
        states = self._around.signal_tracks(signals, len(self._offsets), self._settings.dt)
        off_road, events = self._around.events(tracks[0], states)
        return Episode(
            scene_id=scene.id,
            ego=ego,
            dt=self._settings.dt,
            tracks=tracks,
            events=tuple(sorted((*self._contacts, *events), key=lambda e: (e.step, e.kind, e.other))),
            signals=states,
            ending=self.ending,
            route_completion=1.0
            if self.ending is Ending.ARRIVED
            else min(max(self._view.along / self._route.length, 0.0), 1.0),
            distance_to_route=np.abs(np.array(self._offsets)),
            off_road=off_road,
        )

    def _tracks(self) -> tuple[Track, ...]:
        steps = len(self._offsets)
        moving = iter(np.array(self._rows).reshape(steps, len(self._moving), 4).transpose(1, 2, 0))
        tracks: list[Track] = []
        for obj, body, (name, role) in zip(self._drive.objects, self._drive.bodies, self._names, strict=True):
            if type(body) is Body:
                state = np.repeat(np.array([[body.x], [body.y], [body.heading], [0.0]]), steps, axis=1)
            else:
                state = next(moving)
            tracks.append(
                Track(
                    actor=name,
                    role=role,
                    kind=type(obj).__name__,
                    length=body.length,
                    width=body.width,
                    x=state[0],
                    y=state[1],
                    heading=state[2],
                    speed=state[3],
                )
            )
        order = (Role.EGO, Role.ADVERSARY, Role.BACKGROUND, Role.OCCLUDER)
        return tuple(sorted(tracks, key=lambda track: order.index(track.role)))


def _name(ego: EgoPolicy) -> str:
    return str(getattr(ego, "name", type(ego).__name__))


def _names(objects: list[Any]) -> list[tuple[str, Role]]:
    """A unique name and the role of each object: the ego comes first, whoever runs `AdvBehavior` is the adversary."""
    named: list[tuple[str, Role]] = []
    seen: dict[str, int] = {}
    for i, obj in enumerate(objects):
        if i == 0:
            name, role = "ego", Role.EGO
        elif type(obj.behavior).__name__ == "AdvBehavior":
            name, role = "adversary", Role.ADVERSARY
        elif obj.behavior is not None:
            name, role = obj.label or type(obj).__name__.lower(), Role.BACKGROUND
        else:
            name, role = obj.label or type(obj).__name__.lower(), Role.OCCLUDER
        seen[name] = seen.get(name, 0) + 1
        named.append((name if seen[name] == 1 else f"{name}-{seen[name]}", role))
    return named


def _overlap(bodies: list[Body], names: list[tuple[str, Role]]) -> str:
    """Which two actors stand in each other at the start, in words; empty if none do."""
    for (i, a), (j, b) in itertools.combinations(enumerate(bodies), 2):
        if touch(a, b):
            return f"{names[j][0]} overlaps {names[i][0]} at the start"
    return ""
