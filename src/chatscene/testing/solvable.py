"""Scenes that are tests: somebody who does not react crashes, a driver at hand survives, and the twin is harmless."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

import numpy as np

from chatscene.ego.asking import begin, decide, fitted
from chatscene.ego.observation import Observation
from chatscene.ego.policy import EgoPolicy, load_ego, name_of, observation_of, pedals_of
from chatscene.measure.avoidability import avoidable
from chatscene.measure.criticality import criticality
from chatscene.simulate.simulator import Simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from chatscene.testing.twins import Twin, twins, without_adversary

DRIVERS = ("idm", "planner")  # who may prove that a scene can be survived, in this order
STANDING = 0.3  # [m/s] below which an ego stands
LONGER = 3.0  # [s] that an ego may stand in a twin beyond what the driver that survives does
ALONE = "no driver at hand drives it even without the adversary"
NOTHING = "nothing is to be avoided: whoever does not react gets through"
NOBODY = "no driver at hand survives it"
BEHIND = 0.15  # of the route, that the driver of the proof may be behind in a twin, against without the adversary
SLOW = 0.5  # of the way of that driver, that an ego may come in a twin: slower is no driving


@dataclass(frozen=True, slots=True, kw_only=True)
class Solvable:
    """A scene that is a test.

    Attributes:
        program: What is run.
        scene: The concrete values.
        twin: The same without harm.
        survivor: Who survives the scene.
        oblivious: The drive of whoever drives as if the adversary was not there, which ends in a crash.
        spare: Least time [s] to a collision that the survivor came to; without bound if it never was about to collide.
        completion: Share of the route that the driver of the proof drives in the twin.
        standing: How long [s] it stands there.
    """

    program: ScenicProgram
    scene: Scene
    twin: Twin
    survivor: str
    oblivious: Episode
    spare: float
    completion: float
    standing: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Unfit:
    """A scene that is no test.

    Attributes:
        scene: The scene.
        reason: Why not.
        drive: The drive of whoever does not react; None if there was none.
    """

    scene: Scene
    reason: str
    drive: Episode | None = None


def solvable(program: ScenicProgram, scene: Scene, simulator: Simulator) -> Solvable | Unfit:
    """Whether a scene is a test, found by driving it.

    It is one if (1) whoever drives as if the adversary was not there crashes, so that there is something to avoid;
    (2) one of `DRIVERS` or the careful driver of `chatscene.measure.avoidability` does not; and (3) in a twin whoever
    drives as if the adversary was not there does not crash, and the driver drives as far as without it.
    """
    empty = without_adversary(program)
    if empty is None:
        return Unfit(scene=scene, reason="nobody in its program is the adversary, so that there is no twin of it")
    found: Solvable | Unfit = Unfit(scene=scene, reason="")
    for name in DRIVERS:
        try:
            found = _proved_by(name, program, empty, scene, simulator)
        except _NotPlacedError as error:
            return Unfit(scene=scene, reason=f"it cannot be placed: {error}")
        if isinstance(found, Solvable) or found.reason not in (ALONE, NOBODY):
            return found
    return found


def _proved_by(
    name: str, program: ScenicProgram, empty: ScenicProgram, scene: Scene, simulator: Simulator
) -> Solvable | Unfit:
    """Whether it is a test that a driver, by name, survives."""
    driver = _Recording(fitted(load_ego(name), program))
    alone = _driven(empty, scene, driver, simulator)
    if alone.collision is not None:
        return Unfit(scene=scene, reason=ALONE)
    oblivious = _Repeating(driver)
    struck = _driven(program, scene, oblivious, simulator)
    if struck.collision is None:
        return Unfit(scene=scene, reason=NOTHING, drive=struck)
    if (survived := _survives(name, program, scene, simulator)) is None:
        return Unfit(scene=scene, reason=NOBODY, drive=struck)
    if (harmless := _harmless(program, scene, name, oblivious, alone, simulator)) is None:
        return Unfit(scene=scene, reason="no twin of it is harmless", drive=struck)
    (survivor, spare), (twin, free) = survived, harmless
    return Solvable(
        program=program,
        scene=scene,
        twin=twin,
        survivor=survivor,
        oblivious=struck,
        spare=spare,
        completion=free.completion,
        standing=standing_in(free),
    )


class _NotPlacedError(Exception):
    """A scene is rejected; the message is the reason."""


def _driven(program: ScenicProgram, scene: Scene, ego: EgoPolicy, simulator: Simulator) -> Episode:
    episode = simulate(simulator, program, scene, ego)
    if isinstance(episode, Rejected):
        raise _NotPlacedError(episode.reason)
    return episode


def _survives(name: str, program: ScenicProgram, scene: Scene, simulator: Simulator) -> tuple[str, float] | None:
    """Who survives, the driver of that name or the careful driver in its place, and the time [s] it had to spare."""
    ego = fitted(load_ego(name), program)
    episode = _driven(program, scene, ego, simulator)
    if episode.collision is None:
        spare = criticality(episode).time_to_collision
        return name, math.inf if spare is None else spare
    careful = avoidable(episode, program, scene, ego, simulator)
    return (f"{name}, braking as the careful driver of UN R157", math.inf) if careful else None


def _harmless(
    program: ScenicProgram, scene: Scene, name: str, oblivious: _Repeating, alone: Episode, simulator: Simulator
) -> tuple[Twin, Episode] | None:
    """The first twin that is harmless, and the driver's drive in it."""
    for twin in twins(program):
        blind = simulate(simulator, twin.program, scene, oblivious)
        if isinstance(blind, Rejected) or blind.collision is not None:
            continue
        drive = simulate(simulator, twin.program, scene, load_ego(name))
        if isinstance(drive, Rejected) or drive.collision is not None:
            continue
        if not hindered(drive, least=alone.completion - BEHIND, standing=standing_in(alone)):
            return twin, drive
    return None


def standing_in(episode: Episode) -> float:
    """How long [s] the ego stood."""
    return float(np.count_nonzero(np.abs(episode.ego_track.speed) < STANDING)) * episode.dt


def hindered(episode: Episode, *, least: float, standing: float) -> str:
    """Why a drive is not free: it completed less than the `least` share of its route, or stood `LONGER` than another.

    Args:
        episode: The drive.
        least: In [0, 1].
        standing: How long [s] the other stood.
    """
    stood = standing_in(episode)
    if stood > standing + LONGER:
        return f"it stood for {stood:.1f} s"
    if episode.completion < least:
        return f"it came {100 * episode.completion:.0f} % of its way in {episode.duration:.1f} s"
    return ""


class _Recording:
    """An ego, and what it did."""

    def __init__(self, ego: EgoPolicy) -> None:
        self._ego = ego
        self.name, self.observation, self.pedals = name_of(ego), observation_of(ego), pedals_of(ego)
        self.actions: list[Any] = []

    def reset(self) -> None:
        self.actions.clear()
        begin(self._ego)

    def act(self, observation: Observation) -> tuple[float, float]:
        self.actions.append(decide(self._ego, observation))
        return self.actions[-1]


class _Repeating:
    """Does at each step what another ego did, whatever it sees."""

    name = "oblivious"

    def __init__(self, recorded: _Recording) -> None:
        self.observation, self.pedals = recorded.observation, recorded.pedals
        self._actions = list(recorded.actions)
        self._step = 0

    def reset(self) -> None:
        self._step = 0

    def act(self, observation: Observation) -> tuple[float, float]:  # noqa: ARG002 - it does not look
        self._step += 1
        return self._actions[min(self._step, len(self._actions)) - 1]
