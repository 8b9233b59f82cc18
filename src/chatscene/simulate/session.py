"""A session over Scenic's loop: what the ego sees, what it does, and the episode that comes of it."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from chatscene.ego.observation import SIGHT, Observation, Seen, check_preset
from chatscene.ego.policy import controls
from chatscene.errors import ChatSceneError, EgoError, ProgramError
from chatscene.settings import SimulationSettings
from chatscene.simulate.contact import SWEPT, Was, approach_speed, between, contact_side, met, touch
from chatscene.simulate.followed import FollowedPlans
from chatscene.simulate.obedience import Obedience
from chatscene.simulate.over import Over, over_of
from chatscene.simulate.recorded import states_of, tracks_of
from chatscene.simulate.roadside import RouteSurroundings
from chatscene.simulate.set_up import awaited_by, check_wanted, names_of, orders_of, overlap, view_of
from chatscene.simulate.simulation import SteppedSimulation
from chatscene.terms.actors import has_lamps, height_of_kind, kind_of
from chatscene.terms.backing import turned_about
from chatscene.terms.episode import Ending, Episode, Event, EventKind, Role, Stepped
from chatscene.terms.mirroring import mirrored_drive
from chatscene.terms.nouns import with_article
from chatscene.terms.pace import NOMINAL, limits_in
from chatscene.terms.pointing import fault
from chatscene.terms.route import Route
from chatscene.terms.scene import AS_WRITTEN, ScenicProgram
from chatscene.world.bodies import Body, Vehicle, going

ARRIVAL = 0.99  # share of the route that counts as complete (SafeBench, RouteCompletionTest)
SECONDS_PER_METRE = 1.0  # SafeBench's time limit per metre of route


class SteppedSession:
    """A simulation in progress; see `chatscene.simulate.simulator.Session` for the contract.

    Args:
        simulation: The scene, set up.
        route: The ego's.
        around: What lies along it.
        settings: Step and limits.
        observation: A preset of `chatscene.ego.observation`.
        pedals: One of `chatscene.ego.policy.PEDALS`.
        through: Whether to go on after a collision.
        label: The program and scene, for messages.
        program: What it is a scene of.
        draws: How many draws it took to place.

    Attributes:
        simulation: As above.
        route: As above.
        around: As above.
        settings: As above.
        preset: What the ego sees, as above.
        pedals: As above.
        through: As above.
        limit: How many steps it may take.
        orders: What the ego is held to.
        awaited: For each order that waits for somebody, by its number, who that is.
        others: Everybody but the ego, whether each walks, and from how far it is seen [m].
        observation: What the ego sees now.
        limits: What the ego's kind of vehicle can do.
        ending: Why it ended, or None while it goes on.
        rejection: Why the program itself rejects it, or empty.
        step_number: How many steps were made.
        over: What watches for the end of the drive, where the program asks for it.
        offset: Lateral offset of the ego from its route [m, positive = left].
        along: Arc length of the ego on its route [m].
        draws: How many draws it took to place.
        allowed: The speed allowed on each segment of its route [m/s]; None where the ego does not see it.
        swept: How far two must move past each other in a step [m] to be looked at within it.
        stepped: Who steps it, where that is another simulator than the one that was asked for.
    """

    step_number = 0
    _was: tuple[Was, ...] = ()  # where everybody was before the last step

    def __init__(
        self,
        simulation: SteppedSimulation,
        route: Route,
        around: RouteSurroundings,
        settings: SimulationSettings,
        observation: str,
        pedals: str,
        through: bool,
        label: str,
        program: ScenicProgram,
        draws: int,
    ) -> None:
        objects, bodies = simulation.objects, simulation.bodies
        self._ego = body = _vehicle(objects[0], bodies[0], program, label)
        self.orders = () if program.as_written else orders_of(objects[0], label)
        self._obedience = Obedience(self.orders)
        self.awaited = awaited_by(self.orders, objects, bodies, label)
        check_wanted(objects[0], program, label)
        self.limits = limits_in(objects[0])
        self.simulation = simulation
        self.route = route
        self.around = around
        self.settings = settings
        self.pedals = pedals
        self.through = through
        self._label = label
        self._program = program
        self.draws = draws
        self.stepped = Stepped()
        self._drawn, self._as_written = program.drawn, program.as_written
        self._followed = FollowedPlans(program.source, simulation)
        self._phases: dict[int, int] = {}
        self._names: list[tuple[str, Role]] = []
        self._is_told = (
            type(objects[0].behavior).__name__ == AS_WRITTEN
        )  # then the file says when it is over, not the ego's route
        longest = math.inf if self._is_told else int(route.length * SECONDS_PER_METRE / settings.dt)
        self.limit = int(min(settings.max_steps, longest))
        self.preset = check_preset(observation)
        self.allowed, self._view = view_of(observation, route, around, program, body.grip)
        self._see = {
            "safebench": self._four_numbers,
            "actors": self._actors,
            "road": self._road,
            "traffic": self._traffic,
        }[observation]
        self._moving: list[Body] = []
        self._vehicles: list[Body] = []
        self.height = height_of_kind(kind_of(objects[0])) if settings.occlusion else 0.0
        self.others: list[Seen] = []
        self._rows: Any = []  # of numbers, one after the other; an array where another engine stepped it
        self._since: list[int] = []
        self._offsets: Any = []
        self._contacts: list[Event] = []
        self._touching: set[int] = set()
        self.swept = SWEPT if program.wanted_speed is None else 0.0
        self._closed = False
        self.ending: Ending | None = None
        if route.junction is not None:
            simulation.axes = {route.junction: around.axis}
        self._meet()
        self.over = self._watching(program)
        self.rejection = overlap(objects, bodies, self._names)
        self.observation: Observation
        if not self.rejection:
            self._look()
        self._at_first = self._view.along, self._view.offset

    @property
    def held(self) -> Obedience:
        """What the ego is held to."""
        return self._obedience

    @property
    def along(self) -> float:
        """Arc length of the ego on its route [m]."""
        return self._view.along

    @property
    def offset(self) -> float:
        """Lateral offset of the ego from its route [m, positive = left]."""
        return self._view.offset

    @property
    def speed(self) -> float:
        """Speed of the ego [m/s]."""
        return self._ego.speed

    def step(self, action: Any) -> None:
        """Drive one step of the simulation.

        Raises:
            EgoError: The action is not two finite numbers, the drive is over, or the session was ended by another in
                the same process.
            ProgramError: The program's own code fails.
        """
        self.check_open()
        if self.ending is not None:
            raise EgoError(f"the drive is over ({self.ending.value}): begin another")
        body, simulation = self._ego, self.simulation
        pressed = controls(action, self.pedals, self.limits)
        if not self._as_written:
            body.throttle, body.brake, body.steer = pressed
        if self.orders:
            self._obey(pressed)
        if not self._go_on(simulation.advance):
            return
        if simulation.done is not None:  # a behavior ended the scenario, and nothing moved
            self._end(Ending.SCENARIO_DONE)
            return
        self.step_number += 1
        self._look()

    def _obey(self, pressed: tuple[float, float, float]) -> None:
        """Press the pedals and turn the wheel as the ego is ordered to."""
        body, dt, along, held = self._ego, self.settings.dt, self._view.along, self._obedience
        time = self.step_number * dt
        for number, other in self.awaited.items():
            if held.waits[number]:
                phase = (
                    self._followed.phase_of(self.simulation.bodies.index(other))
                    if self.orders[number].phase >= 0
                    else 0
                )
                held.meet(number, time, math.hypot(other.x - body.x, other.y - body.y), phase)
        if (backwards := held.backs(time=time, along=along, speed=body.speed)) is not None:
            body.throttle, body.brake, body.reverse = backwards
            body.steer = 0.0
            return
        body.reverse = False
        body.throttle, body.brake = held.pedals(
            pressed[:2], time=time, along=along, speed=body.speed, dt=dt, limits=self.limits
        )
        pose = body.x, body.y, body.heading, body.speed
        limits = getattr(body, "limits", self.limits)
        body.steer = held.steer(pressed[2], time=time, line=self.route.line, along=along, pose=pose, limits=limits)

    def check_open(self) -> None:
        """Hold that it can be stepped.

        Raises:
            EgoError: It was ended by another in the same process.
        """
        if self._closed:
            raise EgoError(
                "this session is over: something else was simulated in this process, which runs one session at a "
                "time; start it again, and give each environment a process of its own with vector_env"
            )

    def take_over(
        self,
        *,
        rows: NDArray[np.float64],
        offsets: NDArray[np.float64],
        contacts: list[tuple[int, int, str, float, float]],
        step: int,
        along: float,
        ending: Ending | None,
        phases: dict[int, int],
    ) -> None:
        """Put down what another engine stepped from its beginning on, in place of own steps.

        Args:
            rows: (steps + 1, bodies that move, 4): the state of each at each step: x, y, heading, speed.
            offsets: (steps + 1,) lateral offset of the ego from its route at each step [m, positive = left].
            contacts: When the ego began to touch whom, on which of its sides, how fast they met [m/s], and how long
                before the step, as a share of it.
            step: How many steps were made.
            along: Arc length of the ego on its route [m].
            ending: Why it ended, or None while it goes on.
            phases: How far each body that follows a plan is in it: the number of the phase, by that of the body.
        """
        self._rows, self._offsets, self._view.along = rows, offsets, along
        self._contacts = [self._contact(*contact) for contact in contacts]
        self.step_number, self.ending = step, ending
        self._phases = {number: phase for number, phase in phases.items() if self._followed.plan_of(number) is not None}

    def begin_again(self) -> None:
        """Be at the beginning once more, after others than the ego were put elsewhere (`SteppedSimulation.put`).

        Only for a session that an engine steps: what its ego sees then, the engine tells.
        """
        self._view.along, self._view.offset = self._at_first
        self._rows, self._offsets, self._contacts, self._phases = [], [], [], {}
        self._touching.clear()
        self.step_number, self.ending = 0, None
        self.over = self._watching(self._program)
        self.rejection = overlap(self.simulation.objects, self.simulation.bodies, self._names)
        if not self.rejection:
            self._was = ()
            self.ending = self._ended()

    def _contact(self, step: int, other: int, side: str, speed: float, earlier: float) -> Event:
        return Event(
            kind=EventKind.COLLISION,
            step=step,
            other=self._names[other][0],
            side=turned_about(side) if self._ego.backs else side,
            impact_speed=speed,
            earlier=earlier,
        )

    def close(self) -> None:
        """Give the process free for another session; to be called again does nothing."""
        if not self._closed:
            self._closed = True
            self.simulation.__exit__()

    def _look(self) -> None:
        """Take in the state that a step left: what the ego sees, what is kept, whether it is over."""
        body, view = self._ego, self._view
        view.locate(body.x, body.y)
        goes_on = self._go_on(self.simulation.check)  # may place things
        if len(self._names) < len(self.simulation.bodies):
            self._meet()
        add = self._rows.extend
        for moving in self._moving:
            add((moving.x, moving.y, moving.heading, moving.speed))
        self._offsets.append(view.offset)
        self.observation = self._see()  # after the last step too: a learner's value of a cut episode rests on it
        if goes_on and (ending := self._ended()) is not None:
            self._end(ending)
        self._was = tuple((one.x, one.y, one.heading) for one in self.simulation.bodies)

    def _meet(self) -> None:
        """Take in who is there and was not before; a program that is composed of others places things as it goes on."""
        simulation = self.simulation
        known = len(self._names)
        self._names = names_of(simulation.objects, self._drawn)
        for obj, body in list(zip(simulation.objects, simulation.bodies, strict=True))[known:]:
            if body.moves:
                self._moving.append(body)
                self._since.append(len(self._offsets))
            if body is not self._ego:
                sight = simulation.surroundings.sight(lit=has_lamps(kind_of(obj)))
                height = height_of_kind(kind_of(obj)) if self.settings.occlusion else 0.0
                self.others.append(Seen(body, getattr(obj, "isWalker", False), sight, height))
                if getattr(obj, "isVehicle", False):
                    self._vehicles.append(body)

    def _go_on(self, part: Callable[[], None]) -> bool:
        """Run a part of the program's own code; whether it goes on.

        Raises:
            ProgramError: It fails.
        """
        try:
            part()
        except self.simulation.REJECTIONS as error:
            self.rejection = f"the program rejects the episode at step {self.step_number}: {error}"
        except (ChatSceneError, MemoryError):
            raise
        except Exception as error:  # the program's own code, which may raise anything
            why = fault(error, self._program.filename, self._program.source)
            raise ProgramError(f"{self._label} fails while it runs: {why}") from error
        return not self.rejection

    def _end(self, ending: Ending) -> None:
        """End it, unless the program rejects it for how it ends."""
        self._phases = self._followed.reached()  # as it ends, its behaviors are stopped
        if self._go_on(self.simulation.finish):
            self.ending = ending

    def _ended(self) -> Ending | None:
        if self._collides() and not self.through:
            return Ending.COLLISION
        if self._view.along >= ARRIVAL * self.route.length and not self._is_told:
            return Ending.ARRIVED
        if self.simulation.done is not None:
            return Ending.SCENARIO_DONE
        over = self.over
        if over is not None and over.look(
            self.step_number, self._view.along, self._followed.all_phases(over), self._obedience
        ):
            return Ending.OVER
        return Ending.TIMEOUT if self.step_number >= self.limit else None

    def _four_numbers(self) -> Observation:
        body = self._ego
        return self._view.four_numbers(body.x, body.y, body.heading, body.speed, self._vehicle_ahead())

    def _actors(self) -> Observation:
        return self._view.actors(self._ego, self.others, height=self.height)

    def _road(self) -> Observation:
        return self._view.road(self._ego, self.others, height=self.height)

    def _traffic(self) -> Observation:
        return self._view.traffic(self._ego, self.others, self.height)

    def _vehicle_ahead(self) -> bool:
        ego = self._ego
        for other in self._vehicles:
            dx, dy = other.x - ego.x, other.y - ego.y
            near = dx * dx + dy * dy < SIGHT * SIGHT and dx * ego.cos + dy * ego.sin > 0.0
            if near and self.around.same_lane(ego.x, ego.y, other.x, other.y):
                return True
        return False

    def _collides(self) -> bool:
        bodies, ego, was, passed = self.simulation.bodies, self._ego, self._was, False
        for i in range(1, len(bodies)):
            other = bodies[i]
            if i in self._touching:
                if not touch(ego, other):
                    self._touching.discard(i)
                continue
            if i < len(was):
                earlier = met(ego, other, was[0], was[i], self.swept)
            else:  # it was nowhere before
                earlier = 0.0 if touch(ego, other) else None
            if earlier is None:
                continue
            mine, theirs = ego, other
            if earlier:
                mine, theirs = between(ego, was[0], 1.0 - earlier), between(other, was[i], 1.0 - earlier)
            headed = (was[0][2], was[i][2]) if i < len(was) else (ego.heading, other.heading)
            side, speed = contact_side(mine, theirs), approach_speed(ego, other, headed[0], going(other, headed[1]))
            self._contacts.append(self._contact(self.step_number, i, side, speed, earlier))
            if touch(ego, other):
                self._touching.add(i)
            else:
                passed = True
        return passed or bool(self._touching)

    def episode(self, scene_id: str, ego: str) -> Episode:
        """Everything that happened so far, on the map, with the events that follow from the tracks."""
        steps = len(self._offsets)
        moved = states_of(self._rows, self._since, steps)
        tracks = tracks_of(self.simulation, self._names, moved, steps, self._ego.backs)
        signals = str(self.simulation.scene.params["signals"])
        lights = self.simulation.lights
        states = self.around.signal_tracks(signals, steps, self.settings.dt, lights)
        off_road, events = self.around.events(tracks[0], states)
        driven = Episode(
            scene_id=scene_id,
            ego=ego,
            dt=self.settings.dt,
            tracks=tracks,
            events=tuple(sorted((*self._contacts, *events), key=lambda e: (e.step, e.kind, e.other))),
            signals=states,
            ending=self.ending or Ending.TIMEOUT,
            route_completion=1.0
            if self.ending is Ending.ARRIVED
            else min(max(self._view.along / self.route.length, 0.0), 1.0),
            distance_to_route=np.abs(np.array(self._offsets)),
            off_road=off_road,
            surroundings=self.simulation.surroundings,
            stepped=self.stepped,
            reached={
                self._names[i][0]: self._followed.in_plan(i, phase)
                for i, phase in (self._phases or self._followed.reached()).items()
            },
        )
        return mirrored_drive(driven) if self.around.mirrored else driven

    def _watching(self, program: ScenicProgram) -> Over | None:
        """What watches for the end of the drive, where the program asks for it and nothing else judges its states."""
        simulation, route = self.simulation, self.route
        if program.drawn or program.as_written or simulation.watched:
            return None
        params = simulation.scene.params
        return over_of(
            params,
            simulation.objects,
            self._followed.plans,
            bodies=simulation.bodies,
            line=route.line,
            dt=self.settings.dt,
            settled=self.around.settled(str(params["signals"])),
            wanted=NOMINAL.speed if program.wanted_speed is None else program.wanted_speed,
        )


def _vehicle(ego: Any, body: Body, program: ScenicProgram, label: str) -> Vehicle:
    """The ego's body.

    Raises:
        ProgramError: It is no vehicle, or has a behavior in a drive in which the ego under test is to drive it.
    """
    if not isinstance(body, Vehicle):
        raise ProgramError(f"{label} fails: the ego must be a vehicle, not {with_article(type(ego).__name__)}")
    if ego.behavior is not None and not program.as_written:
        raise ProgramError(
            f"{label} fails: the ego has a behavior of its own, {type(ego.behavior).__name__}, and the ego under test "
            "is to drive it; leave out its `with behavior …`"
        )
    return body
