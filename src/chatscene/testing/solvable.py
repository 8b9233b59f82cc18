"""Scenes that are tests: somebody who does not react crashes, a driver at hand survives, and the twin is harmless."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass, replace
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

_BUILT = re.compile(r"^(\w+ = new \w+ at )[^\n]* with role 'adversary'[^\n]* with behavior (\w+)\(\)", re.MULTILINE)
_ASSEMBLED = re.compile(r"^(AdvAgent = new AdvClass at )", re.MULTILINE)
_WAYS = re.compile(r"\b(advTrajectory|way(?:[A-Z]|The_\w+)) = ")
_ENDS = re.compile(r" (?:until|for) .*")
AWAY = "(100000, 100000)"  # [m], beyond what anybody sees on any map


@dataclass(frozen=True, slots=True, kw_only=True)
class Twin:
    """A program whose adversary may be harmless."""

    program: ScenicProgram
    told: str


def without_adversary(program: ScenicProgram) -> ScenicProgram | None:
    """The program with the adversary far away from the map; None where nobody in it is one by name or role."""
    placed = _placed(program.source)
    source = _halted(program.source)
    found = placed and source and re.search(rf"^{re.escape(placed[0])}", source, re.MULTILINE)
    if not source or not found:
        return None
    return _with(program, f"{source[: found.end()]}{AWAY}{source[_end_of_value(source, found.end()) :]}")


def twins(program: ScenicProgram) -> tuple[Twin, ...]:
    """What may be harmless, the nearest to the program first; none where nobody in it is the adversary."""
    away = without_adversary(program)
    behavior = _behavior(program.source)
    if away is None or behavior is None:
        return ()
    before, first = _first_phase(behavior[1])
    way = next((one[1] for one in _WAYS.finditer(program.source) if one[1] in behavior[1]), "")
    told = {
        "never begins its act": f"{before}    {first}\n\n" if first else "",
        "stands where it starts": "    do Halt()\n\n",
        "drives on along its way": f"    do DrivePath({way}, 10)\n\n" if way else "",
    }
    near = [
        Twin(program=_with(program, _replaced(program.source, body)), told=words)
        for words, body in told.items()
        if body
    ]
    return (*near, Twin(program=away, told="is not there"))


def _placed(source: str) -> tuple[str, str] | None:
    """How the line begins that places the adversary, and what its behavior is called."""
    if (built := _BUILT.search(source)) is not None:
        return built[1], built[2]
    assembled = _ASSEMBLED.search(source)
    return (assembled[1], "AdvBehavior") if assembled is not None else None


def _behavior(source: str) -> re.Match[str] | None:
    """The adversary's behavior, with its body as the first group."""
    placed = _placed(source)
    if placed is None:
        return None
    return re.search(rf"^behavior {placed[1]}\(\):\n((?:(?:[ \t]+[^\n]*)?\n)+)", source, re.MULTILINE)


def _first_phase(body: str) -> tuple[str, str]:
    """What a behavior says before its first phase, and that phase without its end; no phase where it never ends."""
    before = ""
    for line in body.splitlines(keepends=True):
        if line.lstrip().startswith("do "):
            endless = _ENDS.sub("", line.strip())
            return before, endless if endless != line.strip() else ""
        before += line
    return before, ""


def _halted(source: str) -> str:
    return _replaced(source, "    do Halt()\n\n") if _behavior(source) else ""


def _replaced(source: str, body: str) -> str:
    behavior = _behavior(source)
    assert behavior is not None  # or there is no twin
    return f"{source[: behavior.start(1)]}{body}{source[behavior.end(1) :]}"


def _end_of_value(source: str, start: int) -> int:
    """Where the expression that begins at `start` ends: at the first comma or line end outside of brackets."""
    depth = 0
    for place in range(start, len(source)):
        sign = source[place]
        depth += (sign in "([{") - (sign in ")]}")
        if depth == 0 and sign in ",\n":
            return place
    return len(source)


def _with(program: ScenicProgram, source: str) -> ScenicProgram:
    return replace(program, source=source)


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
