"""The simulator `native`: scenes of plans in the engine, all others in the embedded one, with the same numbers."""

from __future__ import annotations

import ctypes
import random
from collections import OrderedDict
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from typing import Any, TypedDict

import numpy as np
from numpy.typing import NDArray

from chatscene.ego.observation import Observation
from chatscene.ego.policy import PEDALS, EgoPolicy, controls, observation_of, pedals_of
from chatscene.errors import EgoError, SimulationError, StuckBehavior
from chatscene.settings import SimulationSettings
from chatscene.simulate.native.binding import Bound, bind
from chatscene.simulate.native.code import NotCovered
from chatscene.simulate.native.engine import END, Engine, NoEngine, load_engine
from chatscene.simulate.native.policies import drives, foot_of, policy_of
from chatscene.simulate.placing import Placement
from chatscene.simulate.session import SteppedSession
from chatscene.simulate.simulator import Session, load_simulator
from chatscene.simulate.stepped import SteppedSimulator
from chatscene.terms.braking import Braking
from chatscene.terms.episode import Ending, Episode, Stepped
from chatscene.terms.route import Route
from chatscene.terms.scene import Rejected, Scene, ScenicProgram

NAME, REFERENCE = "native", "embedded"
ENDINGS = {1: Ending.COLLISION, 2: Ending.ARRIVED, 3: Ending.TIMEOUT, 4: Ending.OVER}  # as engine.c numbers them
COLLIDED = next(number for number, ending in ENDINGS.items() if ending is Ending.COLLISION)
SIDES = ("front", "rear", "left", "right")


AGAIN = 16  # programs on a route of which a scene is kept to be made others of it
_Placed = tuple[SteppedSession, Callable[[], Bound], Callable[[], object]]
"""A placed scene, what makes the same as arrays, and what makes the first it again."""


class _Senses(TypedDict):
    """What the ego sees and how hard it brakes, and whether its drive goes on after a collision."""

    observation: str
    pedals: str
    through_collisions: bool


def _like(program: ScenicProgram, scene: Scene, senses: _Senses) -> tuple[object, ...]:
    """What scenes have in common of which one can be made of another."""
    of = program.digest, program.scenario_id, program.model, program.as_written
    return *of, scene.route, senses["observation"], senses["through_collisions"]


def _key_of(program: ScenicProgram, scene: Scene, senses: _Senses) -> tuple[object, ...]:
    """What tells a scene from any other."""
    return (scene.id, scene.seed, tuple(scene.values.items()), *_like(program, scene, senses))


class NativeSession:
    """A scene in the engine; see `chatscene.simulate.simulator.Session` for the contract.

    Args:
        reference: The same scene, opened and closed by the embedded simulator, no step made: what is kept of a drive
            is made by it.
        bound: The scene as arrays, its own.
        engine: What steps it.
        pedals: One of `chatscene.ego.policy.PEDALS`.
        be: Makes the reference the scene's again, where it may have become another one's.

    Attributes:
        rejection: Always empty: a program that can reject a drive while it runs is not covered.
    """

    rejection = ""

    def __init__(
        self, reference: SteppedSession, bound: Bound, engine: Engine, pedals: str, be: Callable[[], object]
    ) -> None:
        self._reference = reference
        self._pedals = pedals
        self._bound = bound
        self._engine = engine
        self._be = be
        self._size = len(reference.observation)
        bound.world.hardest = PEDALS[pedals]
        engine.see(bound.world)

    @property
    def observation(self) -> Observation:
        """What the ego sees now."""
        return np.frombuffer(self._bound.world.seen, np.float64, self._size).copy()

    @property
    def ending(self) -> Ending | None:
        """Why it ended, or None while it goes on."""
        return ENDINGS.get(self._bound.world.ending)

    @property
    def step_number(self) -> int:
        """How many steps were made."""
        return self._bound.world.step

    @property
    def along(self) -> float:
        """Arc length of the ego on its route [m]."""
        return self._bound.world.along

    @property
    def offset(self) -> float:
        """Lateral offset of the ego from its route [m, positive = left]."""
        return self._bound.world.offset

    @property
    def speed(self) -> float:
        """Speed of the ego [m/s]."""
        return self._bound.world.body[0].speed

    def step(self, action: Any) -> None:
        """Drive one step.

        Raises:
            EgoError: The action is not two finite numbers, or the drive is over.
            StuckBehavior: A plan comes to no act, since its phases end as they begin.
        """
        if self.ending is not None:  # its tracks have no room for more
            raise EgoError(f"the drive is over ({self.ending.value}): begin another")
        self._engine.step(self._bound.world, *controls(action, self._pedals, self._reference.limits))
        self._look()

    def drive(self, ego: EgoPolicy, until: int | None = None) -> bool:
        """Let an ego that the engine knows drive to the end or to a step; False if it does not, and nothing was done.

        Raises:
            StuckBehavior: As for `step`.
        """
        policy = policy_of(ego, self._engine)
        if policy is None or observation_of(ego) != self._reference.preset:
            return False
        if until is not None and policy.every > 1:
            return False  # it holds what it decided before
        self._bound.world.hardest = PEDALS[pedals_of(ego)]
        self._engine.run(self._bound.world, policy, END if until is None else until)
        self._look()
        return True

    def brake(self, ego: EgoPolicy, braking: Braking) -> bool:
        """Let an ego that the engine knows drive until it is braked; False if it does not, and nothing was done."""
        policy = policy_of(ego, self._engine)
        if policy is None or observation_of(ego) != self._reference.preset:
            return False
        hardest = self._bound.world.hardest = PEDALS[self._pedals]
        foot = foot_of(braking, PEDALS[pedals_of(ego)] / hardest, self._reference.limits)
        self._engine.brake(self._bound.world, policy, foot)
        self._look()
        return True

    def _look(self) -> None:
        world = self._bound.world
        if world.fault:
            raise StuckBehavior("a plan comes to no act: its phases end as they begin", within=f"step {world.step}")

    def episode(self, scene_id: str, ego: str) -> Episode:
        """Everything that happened so far, with the events that follow from the tracks."""
        bound, world = self._bound, self._bound.world
        self._be()
        states = world.step + 1
        self._reference.take_over(
            rows=bound.rows[:states],
            offsets=bound.offsets[:states],
            contacts=[(c.step, c.other, SIDES[c.side], c.speed, c.earlier) for c in world.contact[: world.contacts]],
            step=world.step,
            along=world.along,
            ending=self.ending,
            phases={agent.body: agent.phase for agent in world.agent[: world.agents]},
        )
        return self._reference.episode(scene_id, ego)

    def close(self) -> None:
        """Nothing: Scenic has no part in it any more, and any number of them may be open in a process."""


class Together:
    """Scenes in the engine that make their steps in one call."""

    def __init__(self, count: int, size: int) -> None:
        self._sessions: list[NativeSession | None] = [None] * count
        self._at = np.zeros(count, np.uint64)
        self._size = size

    def put(self, place: int, session: Session | None) -> None:
        """Have a scene in a place, in that of the one before; one that another engine steps leaves it empty."""
        native = session if isinstance(session, NativeSession) else None
        self._sessions[place] = native
        self._at[place] = 0 if native is None else ctypes.addressof(native._bound.world)  # pyright: ignore[reportPrivateUsage]

    @property
    def there(self) -> NDArray[np.bool_]:
        """(count,) Which places have a scene."""
        return self._at != 0

    def step(self, places: NDArray[np.int64], actions: NDArray[np.float64]) -> Stepwise:
        """Drive one step of each of the scenes in some places.

        Args:
            places: (N,) Which, none of them empty, and none of a scene that ended.
            actions: (N, 2) Acceleration and steering in [-1, 1]; finite.

        Raises:
            StuckBehavior: As for `NativeSession.step`.
        """
        first = self._sessions[places[0]]
        assert first is not None
        told, seen = first._engine.step_many(self._at[places], actions, self._size)  # pyright: ignore[reportPrivateUsage]
        for failed in np.flatnonzero(told[:, 5]).tolist():
            if (session := self._sessions[places[failed]]) is not None:
                session._look()  # pyright: ignore[reportPrivateUsage]
        before, along, offset, speed, ending, _ = told.T
        return Stepwise(before=before, along=along, offset=offset, speed=speed, ending=ending.astype(int), seen=seen)


@dataclass(frozen=True, slots=True, kw_only=True)
class Stepwise:
    """What a step of several scenes came to.

    Attributes:
        before: (N,) arc length of the ego on its route before the step [m].
        along: (N,) the same after it.
        offset: (N,) lateral offset of the ego from its route [m, positive = left].
        speed: (N,) of the ego [m/s].
        ending: (N,) how each ended, as `ENDINGS` numbers it; 0 while it goes on.
        seen: (N, size) what the ego sees.
    """

    before: NDArray[np.float64]
    along: NDArray[np.float64]
    offset: NDArray[np.float64]
    speed: NDArray[np.float64]
    ending: NDArray[np.int64]
    seen: NDArray[np.float64]


class _Again:
    """A scene of a program that is made every other one of its scenes on a route, without Scenic and unbound."""

    def __init__(
        self,
        simulator: SteppedSimulator,
        placement: Placement,
        session: SteppedSession,
        bound: Bound,
        program: ScenicProgram,
        scene: Scene,
    ) -> None:
        self.session = session
        # its own, as the simulator keeps those of some programs only
        self._simulator, self._placement, self._bound, self._program = simulator, placement, bound, program
        self._is: Scene | None = scene
        self._apart: Scene | None = None  # what it was last asked for and cannot make

    def be(self, scene: Scene) -> None:
        """Have everybody begin where they do in a scene of the program that it was once."""
        if self._is is scene:
            return
        drawn = random.getstate()  # a Python ego may draw on
        there = self._begin(scene)
        random.setstate(drawn)
        if there is not True:
            why = there.reason if isinstance(there, Rejected) else "it fails"
            raise SimulationError(f"scene {scene.id!r} cannot be made again as it was: {why}")

    def _begin(self, scene: Scene) -> Rejected | bool:
        self._is = None
        there = self._simulator.again(self.session, self._placement, scene)
        if there is True:
            self._is = scene
        return there

    def scene(self, scene: Scene) -> Bound | Rejected | None:
        """A scene of the program at its beginning, as arrays; None where it has to be placed by itself."""
        if scene is self._apart:
            return None
        placement = self._simulator.differs_in(self._program, scene)
        there = placement is not None and self._begin(scene)
        if isinstance(there, Rejected):
            return there
        if placement is not None and there and self.session.ending is None:
            with suppress(NotCovered):
                return self._arrays(placement)
        self._apart = scene
        return None

    def anew(self, scene: Scene) -> Bound:
        """The same of a scene that `scene` was asked for before."""
        self.be(scene)
        return self._arrays(self._placement)

    def _arrays(self, placement: Placement) -> Bound:
        """What the session is now, as arrays.

        Raises:
            NotCovered: The engine does not do what the scene needs.
        """
        with suppress(NotCovered):
            return self._bound.again(self.session, placement.moved)
        return bind(self.session, self._program)  # its lines or its phases are other ones


class NativeSimulator:
    """Runs in the engine what it covers; see `chatscene.simulate.simulator.Simulator` for the contract.

    A scene that is opened again and again, to be driven otherwise, is placed by Scenic once, as long as no more than
    `keeps` others were placed since.

    Attributes:
        identity: What it is: the physics of the embedded simulator.
        missing: Why there is no engine on this machine; empty if there is one.
        keeps: How many of the scenes that were placed last are kept.
    """

    keeps = 1

    def __init__(self, map_path: Path, settings: SimulationSettings) -> None:
        embedded = load_simulator(map_path, replace(settings, simulator=REFERENCE))
        assert isinstance(embedded, SteppedSimulator)
        self._embedded = embedded
        self.identity = replace(self._embedded.identity, name=NAME, confinable=False)
        self.missing = ""
        self._engine: Engine | None = None
        self._placed: OrderedDict[tuple[object, ...], _Placed] = OrderedDict()
        self._again: OrderedDict[tuple[object, ...], _Again] = OrderedDict()
        try:
            self._engine = load_engine()
        except NoEngine as error:
            self.missing = str(error)

    def route(self, program: ScenicProgram, index: int) -> Route:
        """The route a program's geometry picks under this index."""
        return self._embedded.route(program, index)

    def routes(self, program: ScenicProgram) -> int:
        """How many routes the map has for a program's geometry, at most ten."""
        return self._embedded.routes(program)

    def route_in(self, program: ScenicProgram, scene: Scene) -> Route:
        """The route of the ego in a scene."""
        return self._embedded.route_in(program, scene)

    def open(
        self,
        program: ScenicProgram,
        scene: Scene,
        *,
        observation: str = "safebench",
        pedals: str = "safebench",
        through_collisions: bool = False,
    ) -> Session | Rejected:
        """Start a session: Scenic places the scene, the engine steps it if it can, and the episode says why if not."""
        senses: _Senses = {"observation": observation, "pedals": pedals, "through_collisions": through_collisions}
        key = _key_of(program, scene, senses)
        if (found := self._known(key, program, scene, senses)) is not None:
            return found
        if self._engine is not None and (found := self._unscenic(key, program, scene, senses)) is not None:
            return found
        opened = self._embedded.open(program, scene, **senses)
        if isinstance(opened, Rejected):
            return opened
        try:
            bound = self._bound(opened, program)
        except NotCovered as reason:
            opened.stepped = Stepped(by=REFERENCE, instead=str(reason))
            return opened
        except BaseException:
            opened.close()
            raise
        opened.close()
        self._embedded.learn(program, scene, opened)
        self._keep(key, opened, bound.copy, bool)
        return self._session(pedals, opened, bound.copy(), bool)

    def alone(
        self, program: ScenicProgram, scene: Scene, ego: EgoPolicy, *, through_collisions: bool
    ) -> Session | Rejected | None:
        """A scene that nobody has to place (`_known`), of an ego that the engine drives; None if it is no such one."""
        senses = _Senses(observation=observation_of(ego), pedals=pedals_of(ego), through_collisions=through_collisions)
        if self._engine is None or not drives(ego, self._engine):
            return None
        return self._known(_key_of(program, scene, senses), program, scene, senses)

    def bounded(self, program: ScenicProgram, scene: Scene, ego: EgoPolicy) -> bool:
        """Whether a scene is there as arrays, and the engine drives it by itself with such an ego."""
        senses = _Senses(observation=observation_of(ego), pedals="", through_collisions=False)
        there = _key_of(program, scene, senses) in self._placed
        return there and self._engine is not None and drives(ego, self._engine)

    def _known(
        self, key: tuple[object, ...], program: ScenicProgram, scene: Scene, senses: _Senses
    ) -> Session | Rejected | None:
        """A scene that is kept, or made of another one of its program; None if it is neither."""
        if key in self._placed:
            self._placed.move_to_end(key)
            session, arrays, be = self._placed[key]
            return self._session(senses["pedals"], session, arrays(), be)
        if (again := self._again.get(_like(program, scene, senses))) is None:
            return None
        found = again.scene(scene)
        if found is None or isinstance(found, Rejected):
            return found
        self._keep(key, again.session, partial(again.anew, scene), be := partial(again.be, scene))
        return self._session(senses["pedals"], again.session, found, be)

    def _unscenic(
        self, key: tuple[object, ...], program: ScenicProgram, scene: Scene, senses: _Senses
    ) -> Session | Rejected | None:
        """A scene that is placed as another one of its program was; None where Scenic has to."""
        placed = self._embedded.place(program, scene, **senses)
        if placed is None or isinstance(placed, Rejected):
            return placed
        differs = self._embedded.differs_in(program, scene)
        try:
            bound = self._bound(placed, program, differs)
        except NotCovered:
            return None  # which the embedded simulator says
        if differs is None:
            self._keep(key, placed, bound.copy, bool)
            return self._session(senses["pedals"], placed, bound.copy(), bool)
        again = _Again(self._embedded, differs, placed, bound, program, scene)
        self._again[_like(program, scene, senses)] = again
        while len(self._again) > AGAIN:
            self._again.popitem(last=False)
        self._keep(key, placed, partial(again.anew, scene), be := partial(again.be, scene))
        return self._session(senses["pedals"], placed, bound.copy(), be)

    def _keep(self, key: tuple[object, ...], *placed: *_Placed) -> None:
        self._placed[key] = placed
        while len(self._placed) > self.keeps:
            self._placed.popitem(last=False)

    def _session(self, pedals: str, reference: SteppedSession, bound: Bound, be: Callable[[], object]) -> NativeSession:
        assert self._engine is not None
        return NativeSession(reference, bound, self._engine, pedals, be)

    def _bound(self, opened: SteppedSession, program: ScenicProgram, placement: Placement | None = None) -> Bound:
        if self._engine is None:
            raise NotCovered(f"there is no engine: {self.missing}")
        if opened.ending is not None:
            raise NotCovered("over as it begins")
        return bind(opened, program, placement)
