"""Where scenes are run: one Protocol, one table of names, and the one way from a scene to its episode."""

from __future__ import annotations

from collections.abc import Callable, Generator
from contextlib import AbstractContextManager, contextmanager, nullcontext, suppress
from contextvars import ContextVar
from dataclasses import replace
from pathlib import Path
from typing import Any, Protocol, TypeGuard

from chatscene.ego.asking import answer, begin, fitted
from chatscene.ego.observation import Observation
from chatscene.ego.policy import EgoPolicy, is_cut_off, name_of, observation_of, pedals_of, tell_cut_off
from chatscene.errors import (
    ChatSceneError,
    DoesNotCompile,
    ForeignCodeRefused,
    MapError,
    NamesNotClosed,
    ProgramError,
    ProgramStopped,
    SettingsError,
    StuckBehavior,
)
from chatscene.plugins import Kind, make, without_address
from chatscene.settings import SimulationSettings
from chatscene.simulate.watchdog import time_limit
from chatscene.terms.braking import Braking
from chatscene.terms.episode import Ending, Episode, Stepped
from chatscene.terms.route import Route
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.terms.simulator import SimulatorIdentity


class Session(Protocol):
    """A simulation that is stepped from outside; unless its simulator says otherwise, one at a time per process.

    `rejection` says why the program itself gave it up, and is empty otherwise. Nothing may be stepped after an ending
    or a rejection.
    """

    rejection: str

    @property
    def observation(self) -> Observation:
        """What the ego sees now."""
        ...

    @property
    def ending(self) -> Ending | None:
        """Why it ended, or None while it goes on."""
        ...

    @property
    def step_number(self) -> int:
        """How many steps were made."""
        ...

    @property
    def along(self) -> float:
        """Arc length of the ego on its route [m]."""
        ...

    @property
    def offset(self) -> float:
        """Lateral offset of the ego from its route [m, positive = left]."""
        ...

    @property
    def speed(self) -> float:
        """Speed of the ego [m/s]."""
        ...

    def step(self, action: Any) -> None:
        """Go on by one step with an action of the ego's, acceleration and steering in [-1, 1].

        Raises:
            EgoError: The action is not two finite numbers, or the drive is over.
            ProgramError: The program's own code fails.
        """
        ...

    def episode(self, scene_id: str, ego: str) -> Episode:
        """Everything that happened so far."""
        ...

    def close(self) -> None:
        """Give the process free for another session; to be called once, whatever happened."""
        ...


class DrivesItself(Session, Protocol):
    """A session that lets some egos drive to the end by itself, with the same episode."""

    def drive(self, ego: EgoPolicy, until: int | None = None) -> bool:
        """Let an ego drive from the beginning to the end or to a step, after its `reset`, with its own pedals.

        Returns:
            False if this one is not known here, or cannot be gone on with at that step; nothing was done then.
        """
        ...

    def brake(self, ego: EgoPolicy, braking: Braking) -> bool:
        """The same, but that somebody else brakes from a step on, to the end or until the ego has stood long enough.

        Returns:
            False if this one is not known here; nothing was done then.
        """
        ...


def drives_itself(session: Session) -> TypeGuard[DrivesItself]:
    """Whether a session lets some egos drive to the end by itself."""
    return hasattr(session, "drive") and hasattr(session, "brake")  # `isinstance` takes longer than many a drive


class Simulator(Protocol):
    """Opens scenes of programs as sessions, on one map; made with the map's path and the settings.

    Determinism: where its identity says `exact`, the same program, scene and ego give the same episode, bit for bit,
    whatever ran before.
    Failure: a scene that cannot be placed is a `Rejected` value; a program that does not compile raises
    `ProgramError`; a behavior that never yields raises `StuckBehavior`.
    """

    @property
    def identity(self) -> SimulatorIdentity:
        """What it is."""
        ...

    def open(
        self,
        program: ScenicProgram,
        scene: Scene,
        *,
        observation: str = "safebench",
        pedals: str = "safebench",
        through_collisions: bool = False,
    ) -> Session | Rejected:
        """Start a session.

        Args:
            program: What to run.
            scene: The concrete values.
            observation: A preset of `chatscene.ego.observation`.
            pedals: One of `chatscene.ego.policy.PEDALS`.
            through_collisions: Whether to go on after a collision.
        """
        ...

    def route(self, program: ScenicProgram, index: int) -> Route:
        """The route a program's geometry picks under this index."""
        ...

    def routes(self, program: ScenicProgram) -> int:
        """How many routes the map has for a program's geometry, at most ten."""
        ...

    def route_in(self, program: ScenicProgram, scene: Scene) -> Route:
        """The route of the ego in a scene: that of its index, or of its own where the program draws where things stand.

        Raises:
            MapError: The scene is rejected, so that there is none.
        """
        ...


_TELL: ContextVar[Callable[[], None] | None] = ContextVar("tell", default=None)


@contextmanager
def telling(tell: Callable[[], None]) -> Generator[None]:
    """Tell somebody of each drive that ends in this process meanwhile: a slow ego takes its time over every one."""
    before = _TELL.set(tell)
    try:
        yield
    finally:
        _TELL.reset(before)


def simulate(
    simulator: Simulator,
    program: ScenicProgram,
    scene: Scene,
    ego: EgoPolicy,
    *,
    through_collisions: bool = False,
    placed: Callable[[int], None] | None = None,
) -> Episode | Rejected:
    """Run one scene to its end.

    Args:
        simulator: Where.
        program: What to run.
        scene: The concrete values.
        ego: Who drives.
        through_collisions: Whether to go on after a collision, to see whether the adversary does what was said.
        placed: Told how many draws the scene took to place, once it is.

    Raises:
        EgoError: The ego fails, or does not answer.
        ProgramError: The program does not compile, or its own code fails.
        StuckBehavior: The program does not come to its end.
    """
    ego = fitted(ego, program)
    alone = getattr(simulator, "alone", None)
    session: Session | Rejected | None
    session = None if alone is None else alone(program, scene, ego, through_collisions=through_collisions)
    if session is not None:  # nobody in it needs a clock: neither the program's code nor an ego of Python's
        return _driven(simulator, scene, ego, session, placed)
    with time_limit(f"scene {scene.id!r}"):
        session = simulator.open(
            program,
            scene,
            observation=observation_of(ego),
            pedals=pedals_of(ego),
            through_collisions=through_collisions,
        )
        return _driven(simulator, scene, ego, session, placed)


def limited(
    simulator: Simulator, program: ScenicProgram, scene: Scene, ego: EgoPolicy, what: str
) -> AbstractContextManager[None]:
    """A time limit for another drive of a scene that was just driven, where one can run for ever."""
    bounded = getattr(simulator, "bounded", None)
    return nullcontext() if bounded is not None and bounded(program, scene, ego) else time_limit(what)


def _driven(
    simulator: Simulator,
    scene: Scene,
    ego: EgoPolicy,
    session: Session | Rejected,
    placed: Callable[[int], None] | None,
) -> Episode | Rejected:
    """What comes of a scene that was opened."""
    if isinstance(session, Rejected):
        return session
    if placed is not None:
        placed(getattr(session, "draws", 1))
    try:
        drive(session, ego, scene.id)
        if session.rejection:
            return Rejected(scene=scene, reason=session.rejection)
        episode = session.episode(scene.id, name_of(ego))
        if (tell := _TELL.get()) is not None:
            tell()
        return episode if episode.stepped.by else replace(episode, stepped=Stepped(by=simulator.identity.name))
    finally:
        session.close()


def fails_in_its_scene(error: ChatSceneError) -> bool:
    """Whether what ended a drive is told of its scene alone, so that the program's other scenes may be driven.

    Its own code failed there, did not come to its end, or was stopped. A text that does not compile fails in each.
    """
    of_the_text = isinstance(error, DoesNotCompile | ForeignCodeRefused | NamesNotClosed)
    return isinstance(error, ProgramError | StuckBehavior | ProgramStopped) and not of_the_text


def routes_of(simulator: Simulator, program: ScenicProgram, wanted: int) -> dict[int, Route | None]:
    """The first routes of a program's geometry on which its adversary has a way, by number; as many as there are.

    A program that draws where its things stand has one for each scene; its routes are sequences of draws.
    """
    if program.drawn:
        return dict.fromkeys(range(min(wanted, simulator.routes(program))))
    found: dict[int, Route | None] = {}
    for index in range(simulator.routes(program)):
        if len(found) < wanted:
            with suppress(MapError):
                found[index] = simulator.route(program, index)
    return found


def drive(session: Session, ego: EgoPolicy, scene: str) -> None:
    """Let an ego drive until the session ends.

    Raises:
        EgoError: The ego fails, or does not answer.
        ProgramError: The program's own code fails.
    """
    begin(ego, scene)
    if drives_itself(session) and session.drive(ego):
        return
    while session.ending is None and not session.rejection:
        action = answer(ego, session.observation, step=session.step_number, scene=scene)
        session.step(action)
        if is_cut_off(action):
            tell_cut_off(f"the ego {name_of(ego)!r}", action)


SIMULATORS: Kind[Simulator] = Kind(
    noun="simulator",
    group="chatscene.simulators",
    method="open",
    built_in={
        "embedded": "chatscene.simulate.embedded.physics:make_simulator",
        "native": "chatscene.simulate.native.simulator:NativeSimulator",
        "confined": "chatscene.simulate.confined.simulator:ConfinedSimulator",
        "carla": "chatscene.simulate.carla.simulator:CarlaSimulator [carla]",
    },
    forms=("carla:HOST:PORT",),
    addressed=frozenset({"carla"}),
)


def has_one_world(simulator: str) -> bool:
    """Whether a simulator is a server elsewhere, whose one world serves one process at a time."""
    return without_address(SIMULATORS, simulator) in SIMULATORS.addressed


def check_jobs(settings: SimulationSettings, jobs: int) -> None:
    """Hold how many processes are asked for against how many worlds there are.

    Raises:
        SettingsError: There are more processes.
    """
    if jobs > 1 and has_one_world(settings.simulator):
        raise SettingsError(
            f"the simulator {settings.simulator!r} has one world, so that {jobs} processes would drive in each other's "
            "scenes; use --jobs 1, and for more a server and a run each"
        )


def load_simulator(map_path: Path, settings: SimulationSettings) -> Simulator:
    """The simulator that settings name (`chatscene.plugins`), for one map.

    Raises:
        SettingsError: There is none of that name.
    """
    return make(SIMULATORS, settings.simulator, map_path, settings)
