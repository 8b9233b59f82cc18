"""Where scenes are run: one Protocol, one table of names."""

from __future__ import annotations

import importlib
from pathlib import Path
from typing import Any, Protocol

from chatscene.ego.observation import Observation
from chatscene.ego.policy import EgoPolicy, name_of
from chatscene.errors import EgoError, SettingsError, StuckBehavior, no_such
from chatscene.settings import SimulationSettings
from chatscene.terms.episode import Ending, Episode
from chatscene.terms.route import Route
from chatscene.terms.scene import Rejected, Scene, ScenicProgram


class OpenDrive(Protocol):
    """A drive that is stepped from outside; one at a time per process.

    `observation` is what the ego sees now; `ending` is None while the drive goes on; `rejection` says why the
    program itself gave the drive up, and is empty otherwise. Nothing may be stepped after an ending or a rejection.
    """

    observation: Observation
    ending: Ending | None
    rejection: str
    step_number: int

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
        """Drive one step with an action, acceleration and steering in [-1, 1]."""
        ...

    def episode(self, scene_id: str, ego: str) -> Episode:
        """Everything that happened so far."""
        ...

    def close(self) -> None:
        """Give the process free for another drive; to be called once, whatever happened."""
        ...


class Backend(Protocol):
    """Runs scenes of programs against egos.

    Determinism: the same program, scene and ego give the same episode, bit for bit, whatever ran before.
    Failure: a scene that cannot be placed is a `Rejected` value; a program that does not compile raises
    `ProgramError`; a behavior that never yields raises `StuckBehavior`.
    """

    def run(
        self, program: ScenicProgram, scene: Scene, ego: EgoPolicy, *, through_collisions: bool = False
    ) -> Episode | Rejected:
        """Run one scene.

        Args:
            program: What to run.
            scene: The concrete values.
            ego: Who drives.
            through_collisions: Go on after a collision, to see whether the adversary does what was said.
        """
        ...

    def open(
        self,
        program: ScenicProgram,
        scene: Scene,
        *,
        observation: str = "safebench",
        pedals: str = "safebench",
        through_collisions: bool = False,
    ) -> OpenDrive | Rejected:
        """Start a drive that is stepped from outside.

        Args:
            program: What to run.
            scene: The concrete values.
            observation: A preset of `chatscene.ego.observation`.
            pedals: One of `chatscene.ego.policy.PEDALS`.
            through_collisions: Go on after a collision.
        """
        ...

    def route(self, program: ScenicProgram, index: int) -> Route:
        """The route a program's geometry picks under this index."""
        ...

    def routes(self, program: ScenicProgram) -> int:
        """How many routes the map has for a program's geometry, at most ten."""
        ...


def drive_to_the_end(drive: OpenDrive, ego: EgoPolicy) -> None:
    """Let an ego drive until the drive ends.

    Raises:
        EgoError: The ego fails, or does not answer.
    """
    if (reset := getattr(ego, "reset", None)) is not None:
        reset()
    act, step = ego.act, drive.step
    while drive.ending is None and not drive.rejection:
        try:
            action = act(drive.observation)
        except StuckBehavior as error:
            raise EgoError(
                f"the ego {name_of(ego)!r} gave no action at step {drive.step_number}: its drive was stopped after "
                f"{error.within}"
            ) from error
        except (Exception, SystemExit) as error:
            raise EgoError(
                f"the ego {name_of(ego)!r} fails at step {drive.step_number}: {type(error).__name__}: {error}"
            ) from error
        step(action)


BACKENDS: dict[str, str] = {"embedded": "chatscene.simulate.embedded.backend:EmbeddedBackend"}


def load_backend(name: str, map_path: Path, settings: SimulationSettings) -> Backend:
    """A backend by its name in `BACKENDS`, for one map.

    Raises:
        SettingsError: There is no backend of that name.
    """
    if name not in BACKENDS:
        raise SettingsError(no_such("backend", name, BACKENDS))
    module, _, cls = BACKENDS[name].partition(":")
    backend: Backend = getattr(importlib.import_module(module), cls)(map_path, settings)
    return backend
