"""A scene driven again with somebody else in the ego's place."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from chatscene.ego.asking import failed
from chatscene.ego.observation import Observation
from chatscene.ego.policy import EgoPolicy, observation_of
from chatscene.errors import SimulationError
from chatscene.simulate.simulator import Session, Simulator, drives_itself
from chatscene.terms.braking import STANDING, STANDSTILL, Braking
from chatscene.terms.episode import Ending
from chatscene.terms.scene import Rejected, Scene, ScenicProgram


class Driver(Protocol):
    """Somebody in an ego's place, who does as that ego did until the step `begins`."""

    begins: int

    def act(self, observation: Observation) -> tuple[float, float]:
        """Acceleration and steering in [-1, 1], as those of an ego."""
        ...

    def skip(self) -> None:
        """Be told that everything before `begins` was driven without it."""
        ...


@dataclass(frozen=True, slots=True, kw_only=True)
class Ended:
    """How a drive ended.

    Attributes:
        crashed: Whether with a collision.
        along: Where on its route the ego was [m].
        speed: How fast it went [m/s].
    """

    crashed: bool
    along: float
    speed: float


def drive_instead(
    driver: Driver,
    ego: EgoPolicy,
    program: ScenicProgram,
    scene: Scene,
    simulator: Simulator,
    *,
    pedals: str,
    not_over_before: int,
    dt: float,
    opened: Callable[[Session], None] = lambda _: None,
    braking: Braking | None = None,
) -> Ended:
    """Drive a scene with another driver in the ego's place.

    Args:
        driver: Who drives.
        ego: In whose place, and with whose eyes.
        program: What is driven.
        scene: Its scene.
        simulator: Where.
        pedals: Those of the driver, one of `chatscene.ego.policy.PEDALS`.
        not_over_before: The step after which the drive is over once the driver has stood for `STANDSTILL`.
        dt: Length of a step [s].
        opened: Told of the session, for a driver that sees more than the ego.
        braking: All that the driver does, if that is to brake.

    Raises:
        SimulationError: The scene cannot be driven again.
        EgoError: The ego fails this time.
    """
    drive = simulator.open(program, scene, observation=observation_of(ego), pedals=pedals)
    if isinstance(drive, Rejected):
        raise SimulationError(f"scene {scene.id!r} ran once and is now rejected: {drive.reason}")
    opened(drive)
    standing = 0
    try:
        if braking is not None and drives_itself(drive) and drive.brake(ego, braking):
            return _ended(drive)
        if driver.begins and drives_itself(drive) and drive.drive(ego, until=driver.begins):
            driver.skip()
        while drive.ending is None and not drive.rejection and standing * dt < STANDSTILL:
            try:
                action = driver.act(drive.observation)
            except (Exception, SystemExit) as error:
                when = f"at step {drive.step_number} of scene {scene.id!r}, which it drove once before"
                raise failed(ego, error, when) from error
            drive.step(action)
            standing = standing + 1 if drive.step_number > not_over_before and abs(drive.speed) < STANDING else 0
        return _ended(drive)
    finally:
        drive.close()


def _ended(drive: Session) -> Ended:
    return Ended(crashed=drive.ending is Ending.COLLISION, along=drive.along, speed=abs(drive.speed))
