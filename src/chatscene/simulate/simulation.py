"""Scenic's loop over the bodies of any physics, and the same loop stepped from outside.

Scenic runs a simulation to its end inside the constructor. `SteppedLoop` restates that loop as open, advance, close, so
that a policy outside decides at each step, and leaves out what a drive here has not (sensors, replays). Objects are not
copied back from the simulator at each step: their poses are properties that read the moving body when somebody asks,
which takes most of the time out of a step.
"""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Mapping
from typing import Any, Self

import scenic.core.dynamics as scenic_dynamics
from scenic.core.distributions import RejectionException
from scenic.core.dynamics.actions import (  # Scenic has no public names for what `terminate` yields
    _EndScenarioAction,  # pyright: ignore[reportPrivateUsage]
    _EndSimulationAction,  # pyright: ignore[reportPrivateUsage]
)
from scenic.core.dynamics.behaviors import Behavior
from scenic.core.dynamics.guards import GuardViolation
from scenic.core.dynamics.utils import RejectSimulationException
from scenic.core.errors import InvalidScenarioError
from scenic.core.object_types import disableDynamicProxyFor, setDynamicProxyFor
from scenic.core.requirements import RequirementType
from scenic.core.simulators import Simulation, TerminationType
from scenic.core.vectors import Orientation, Vector
from scenic.domains.driving.simulators import DrivingSimulation, DrivingSimulator
from scenic.syntax import veneer

from chatscene.simulate.physics import CannotPlace, Physics, PhysicsOf
from chatscene.terms.actors import kind_of
from chatscene.terms.surroundings import Surroundings, surroundings_of
from chatscene.world.actors import QUARTER
from chatscene.world.bodies import Body, Placement, become
from chatscene.world.control import Pose
from chatscene.world.lights import TrafficLights
from chatscene.world.pilots import Pilot

SIDEWAYS = 0.01  # share of a velocity across the heading that is put down to rounding
_ENDINGS = (_EndSimulationAction, _EndScenarioAction)
_ANGLES = ("yaw", "pitch", "roll", "heading")
_CACHED = "_cached_"  # how Scenic names attributes it has computed from a pose


class _live_property(property):  # noqa: N801 - used as `property` is
    """A property that may be set to what it is: `override` sets every property of an object anew."""

    def __set__(self, thing: Any, value: Any) -> None:
        if value != getattr(thing, self.fget.__name__ if self.fget else ""):
            raise AttributeError(f"{type(thing).__name__} is where its body is; nothing else sets that")


class LivePose:
    """The dynamic properties of a Scenic object, read from its body at the moment they are asked for."""

    body: Body

    @property
    def pose(self) -> Pose:
        """X [m], y [m], heading [rad, 0 = +x], speed [m/s]."""
        body = self.body
        return body.x, body.y, body.heading, body.speed

    @_live_property
    def position(self) -> Vector:
        """Centre [m]."""
        return Vector(self.body.x, self.body.y)

    @_live_property
    def heading(self) -> float:
        """Scenic's heading [rad, 0 = +y]."""
        return self.body.heading - QUARTER

    @_live_property
    def yaw(self) -> float:
        """The same as `heading`: in two dimensions our objects have no parent orientation."""
        return self.body.heading - QUARTER

    @_live_property
    def orientation(self) -> Orientation:
        """Scenic's orientation."""
        return Orientation.fromEuler(self.body.heading - QUARTER, 0.0, 0.0)

    @_live_property
    def speed(self) -> float:
        """[m/s] along the heading."""
        return self.body.speed

    @_live_property
    def velocity(self) -> Vector:
        """[m/s]."""
        body = self.body
        return Vector(body.speed * body.cos, body.speed * body.sin)

    @_live_property
    def elevation(self) -> float:
        """The world is flat."""
        return 0.0


def live_of(cls: Any, values: Mapping[str, Any]) -> Any:
    """A stand-in for a Scenic object of a class while it moves: same attributes, live pose.

    It is all that Scenic's own copy of the object would be, which takes longer than to sample it: every property,
    angles as plain numbers, nothing that was computed from the pose, no object that it was sampled from.
    """
    live = cls.__dict__.get("_live_class")
    if live is None:
        # The two entries tell Scenic that the class needs no further work on its properties.
        ready = {"_defaults": cls._defaults, "_props_transformed": str(cls)}
        live = type(f"Live{cls.__name__}", (LivePose, cls), ready)
        cls._live_class = live
    proxy = object.__new__(live)
    setDynamicProxyFor(proxy, proxy)  # first of all, since every look-up goes through it
    attributes = proxy.__dict__
    attributes.update((name, value) for name, value in values.items() if not name.startswith(_CACHED))
    attributes.update((name, float(attributes[name])) for name in _ANGLES)
    attributes["_sampleParent"] = None
    setDynamicProxyFor(proxy, proxy)
    return proxy


def _speed_at_start(obj: Any, properties: Mapping[str, Any]) -> float:
    """The speed [m/s] along its heading that a program gives to a thing, with `with speed` or `with velocity`.

    Raises:
        ValueError: The two differ, or its velocity is not along its heading.
    """
    speed: float = properties["speed"]
    heading, (vx, vy, _) = properties["heading"] + QUARTER, properties["velocity"]
    along = vx * math.cos(heading) + vy * math.sin(heading)
    if abs(vy * math.cos(heading) - vx * math.sin(heading)) > SIDEWAYS * abs(along):
        raise ValueError(
            f"the {type(obj).__name__} has a velocity that is not along its heading; turn it with `facing`"
        )
    if math.isclose(along, speed, rel_tol=1e-6, abs_tol=1e-9):
        return speed
    if speed != 0.0:
        raise ValueError(f"the {type(obj).__name__} has a velocity of {along:g} m/s and a speed of {speed:g} m/s")
    return along


class PhysicsSimulation(DrivingSimulation):
    """Scenic's view of one scene; `scenic` itself can run it from start to end.

    Args:
        scene: A scene that Scenic generated.
        physics: Its bodies, none made yet.
        options: Of Scenic's `Simulation`.

    Attributes:
        bodies: The body of each object of the scene, the ego's first.
        lights: The traffic lights, once a program asks for them.
        axes: By junction, the direction [rad] that has green first, where it matters to somebody.
        surroundings: Light, weather and the state of the road, as the program asks for them.
    """

    bodies: list[Body]
    surroundings: Surroundings
    lights: TrafficLights | None
    axes: dict[str, float]

    def __init__(self, scene: Any, *, physics: Physics, **options: Any) -> None:
        self._physics = physics
        super().__init__(scene, **options)

    def setup(self) -> None:
        """Create every object of the scene, the ego first."""
        self._clear()
        super().setup()

    def _clear(self) -> None:
        self.bodies = []
        self.surroundings = surroundings_of(self.scene.params)
        self.lights = None
        self.axes = {}
        self._pilots: dict[Any, Pilot] = {}
        self._proxies: list[tuple[Any, int]] = []

    def set_pilot(self, agent: Any, pilot: Pilot | None) -> None:
        """Have somebody be driven by a pilot from now on, or not any more."""
        self._pilots.pop(agent, None)
        if pilot is not None:
            self._pilots[agent] = pilot

    def _createObject(self, obj: Any) -> None:  # noqa: N802 - Scenic's name
        """Put an object into the scene, as Scenic does, but for a copy that `createObjectInSimulator` would replace."""
        self.objects.append(obj)
        if obj.behavior:
            self.agents.append(obj)
        self.createObjectInSimulator(obj)
        obj.startDynamicSimulation()

    def createObjectInSimulator(self, obj: Any) -> None:  # noqa: N802 - Scenic's name
        """Give an object its body and its live pose."""
        proxy = live_of(type(obj), obj.__dict__)
        setDynamicProxyFor(obj, proxy)
        self._embody(obj, proxy.__dict__)
        self._proxies.append((proxy, len(proxy.__dict__)))

    def _embody(self, obj: Any, original: dict[str, Any]) -> None:
        """Give an object with these attributes its body."""
        original["body"] = self._made(obj, original)
        self.bodies.append(original["body"])

    def _made(self, obj: Any, original: Mapping[str, Any]) -> Body:
        """The body of an object with these attributes."""
        position, backs = original["position"], bool(original.get("backwards", False))
        heading, speed = original["heading"] + QUARTER, _speed_at_start(obj, original)
        return self._physics.add(
            Placement(
                kind=kind_of(obj),
                x=position.x,
                y=position.y,
                heading=heading - math.pi if backs else heading,
                speed=-speed if backs else speed,
                length=original["length"],
                width=original["width"],
                wheelbase=original.get("wheelbase", 0.0),
                wheel_angle=original.get("wheelAngle", 0.0),
                top_speed=original.get("topSpeed", 0.0),
                blueprint=original.get("blueprint") or "",
                grip=self.surroundings.grip,
                backs=backs,
            )
        )

    def step(self) -> None:
        """Ask the pilots, then move every body by one step."""
        for pilot in self._pilots.values():
            pilot.drive()
        self._physics.step(self.timestep)

    def destroy(self) -> None:
        """Take the bodies away."""
        self._physics.close()

    def updateObjects(self) -> None:  # noqa: N802
        """Forget what Scenic computed from poses that are no longer true."""
        for i, (proxy, size) in enumerate(self._proxies):
            attributes = proxy.__dict__
            if len(attributes) != size:
                for name in [name for name in attributes if name.startswith(_CACHED)]:
                    del attributes[name]
                self._proxies[i] = (proxy, len(attributes))

    def getProperties(self, obj: Any, properties: Any) -> dict[str, Any]:  # noqa: N802
        """Poses are live (see `LivePose`); Scenic's own copying is not used."""
        return {name: getattr(obj, name) for name in properties}


class PhysicsSimulator(DrivingSimulator):
    """What Scenic's own command simulates programs in.

    Args:
        physics_of: Makes the physics of each scene.
    """

    def __init__(self, physics_of: PhysicsOf) -> None:
        super().__init__()
        self._physics_of = physics_of

    def createSimulation(self, scene: Any, **options: Any) -> PhysicsSimulation:  # noqa: N802
        """Run one scene to its end, with nobody at the ego's wheel."""
        return PhysicsSimulation(scene, physics=self._physics_of(), **options)


class SteppedLoop(Simulation):
    """Scenic's loop, stepped from outside; a mix-in before the `Simulation` that makes objects and moves them.

    Use as a context manager: one at a time per process. The order is Scenic's: `check` judges a state, the first
    included, before anybody acts on it; `advance` makes the next; `finish` judges the whole, once.

    Attributes:
        done: What of the program ended the scenario, or None while it goes on.
        how: Which kind of thing that was, as Scenic tells them apart.
        watched: Whether the program itself says anything of states: conditions, monitors, what it records.
        drawn: The names of modules that depend on parameters, by the identity of the module, where they are not put
            into it.
    """

    REJECTIONS = (RejectionException, RejectSimulationException, GuardViolation, CannotPlace)

    scene: Any
    objects: list[Any]
    agents: list[Any]
    done: str | None
    how: TerminationType | None
    watched: bool
    drawn: dict[int, dict[str, Any]]

    def __init__(self, scene: Any, dt: float) -> None:  # Scenic's own would run it to its end
        self.screen = None
        self.result = None
        self.scene = scene
        self.timestep = dt
        self.currentTime = 0
        self.objects = []
        self.agents = []
        self.trajectory = []
        self.records = defaultdict(list)
        self.actionSequence = []
        self.verbosity = 0
        self.name = "session"
        self.replaying = False
        self._replayOut = None
        self._checkDivergence = False
        self.done = None
        self.how = None
        self.drawn = {}

    def __enter__(self) -> Self:
        # Our steps have no time limit of their own (a watchdog guards whole episodes), and signal handlers are dear.
        scenic_dynamics.stuckBehaviorWarningTimeout = 0
        veneer.beginSimulation(self)
        try:
            self._scenario = self.scene.dynamicScenario
            self.setup()
            self._scenario._start()
        except BaseException:
            self.__exit__()
            raise
        self._composed = self._scenario._compose is not None
        self._behaviors = [(agent, agent.behavior) for agent in self.agents]
        self.watched = self._composed or bool(
            self._scenario._requirementMonitors
            or self._scenario._terminationConditions
            or self._scenario._terminateSimulationConditions
            or self._scenario._monitors
            or self._scenario._timeLimitInSteps
            or self._scenario._endWithBehaviors
            or self._scenario._recordedExprs
            or self._scenario._recordedInitialExprs
        )
        return self

    def __exit__(self, *_: object) -> None:
        for agent in self.agents:
            if agent.behavior and agent.behavior._isRunning:
                agent.behavior._stop()
        for obj in self.objects:
            disableDynamicProxyFor(obj)
        for scenario in tuple(reversed(veneer.runningScenarios)):
            scenario._stop("session closed", quiet=True)
        veneer.endSimulation(self)
        self.destroy()

    def check(self) -> None:
        """Hold the present state against the program's own conditions, in Scenic's order; may set `done`.

        Raises:
            RejectionException: One of `REJECTIONS`: a requirement or a monitor of the program is violated.
        """
        if not self.watched:
            return
        scenario = self._scenario
        reason, how = scenario._step(), TerminationType.scenarioComplete
        self.recordCurrentState()
        if (monitored := scenario._runMonitors()) is not None:  # also after the scenario's end: it may still reject
            reason, how = monitored, TerminationType.terminatedByMonitor
        if reason is None:
            reason = scenario._checkSimulationTerminationConditions()
            how = TerminationType.simulationTerminationCondition
        if reason is not None:
            self.done, self.how = str(reason), how

    def advance(self) -> None:
        """Let every agent act, then move every body; if a behavior ends the scenario (see `done`), nothing moves.

        Raises:
            RejectionException: One of `REJECTIONS`: a requirement or guard of the program is violated.
        """
        if self._composed:  # only what composes places things, and gives and takes behaviors, while it runs
            for obj in self.objects:
                obj.lastActions = ()
            self.agents += [obj for obj in self.objects if obj.behavior and obj not in self.agents]
            self._behaviors = [(agent, agent.behavior) for agent in self.agents if agent.behavior]
        chosen: list[tuple[Any, tuple[Any, ...]]] = []
        for agent, behavior in self._behaviors:
            if self._composed and agent.behavior is not behavior:  # taken back with a scenario that was just ended
                continue
            actions = _next_actions(behavior)
            if isinstance(actions, _ENDINGS):
                if self._ends(actions):
                    return
                actions = ()
            if len(actions) == 1 and isinstance(actions[0], list | tuple):
                actions = tuple(actions[0])
            if not self.actionsAreCompatible(agent, actions):
                raise InvalidScenarioError(f"{agent} cannot take the actions {', '.join(map(str, actions))}")
            chosen.append((agent, actions))
            agent.lastActions = actions
        self.act(chosen)
        self.step()
        self.currentTime += 1
        self.updateObjects()

    def act(self, chosen: list[tuple[Any, tuple[Any, ...]]]) -> None:
        """Hand over what each agent chose to do."""
        for agent, actions in chosen:
            for action in actions:
                action.applyTo(agent, self)

    def finish(self) -> None:
        """End the program's scenario as Scenic ends a simulation, whatever ended it.

        Raises:
            RejectSimulationException: What was required over time did not come true.
        """
        for scenario in tuple(reversed(veneer.runningScenarios)):
            scenario._stop("the session is over")
        final = self._scenario._evaluateRecordedExprs(RequirementType.recordFinal, self.currentTime)
        self.records.update(final)

    def _ends(self, ending: Any) -> bool:
        """What `terminate` in a behavior does: a scenario stops; whether it was the whole, and nothing goes on."""
        if isinstance(ending, _EndScenarioAction):
            if ending.scenario._isRunning:
                ending.scenario._stop(ending)
            if ending.scenario is not self._scenario:
                return False
        self.done, self.how = str(ending), TerminationType.terminatedByBehavior
        return True


def _next_actions(behavior: Any) -> Any:
    """What a behavior does next; nothing once it has ended."""
    veneer.currentBehavior = behavior
    try:
        return behavior._runningIterator.send(None)
    except StopIteration:
        return ()
    except AttributeError as error:
        if isinstance(error.obj, Behavior):  # a local name that was never set, as Scenic reports it
            missing = NameError(f"name {error.name!r} is not defined", name=error.name)
            raise missing.with_traceback(error.__traceback__) from None
        raise
    finally:
        veneer.currentBehavior = None


class SteppedSimulation(SteppedLoop, PhysicsSimulation):
    """One simulation over a physics, stepped from outside (see `SteppedLoop`).

    Args:
        scene: A scene that Scenic generated.
        physics: Its bodies, none made yet.
        dt: Step [s].
    """

    def __init__(self, scene: Any, physics: Physics, dt: float) -> None:
        super().__init__(scene, dt)
        self._physics = physics

    def begin(self, things: list[Any]) -> None:
        """Put things into the scene that have their live stand-ins already, and of which none acts."""
        self._clear()
        self.watched = False
        self.objects = things
        for one in things:
            self._embody(one, one.__dict__)

    def put(self, number: int, attributes: Mapping[str, Any], physics: Physics) -> None:
        """Put a thing of the scene where it begins with other values of these attributes.

        Raises:
            CannotPlace: It has no room there.
            ValueError: There can be no such thing.
        """
        thing = self.objects[number]
        self._physics = physics
        become(self.bodies[number], self._made(thing, {**thing.__dict__, **attributes}))

    def recordCurrentState(self) -> None:  # noqa: N802 - Scenic's name
        """Evaluate what the program records; tracks are kept by the session."""
        scenario = self._scenario
        if self.currentTime == 0:
            self.records.update(scenario._evaluateRecordedExprs(RequirementType.recordInitial, 0))
        for name, value in scenario._evaluateRecordedExprs(RequirementType.record, self.currentTime).items():
            self.records[name].append((self.currentTime, value))
