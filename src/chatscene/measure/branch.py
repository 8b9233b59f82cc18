"""A scene driven as it was until a moment, and by another ego from then on."""

from __future__ import annotations

from chatscene.ego.asking import begin, decide, fitted
from chatscene.ego.observation import Observation
from chatscene.ego.policy import PEDALS, EgoPolicy, name_of, observation_of, pedals_of
from chatscene.errors import SettingsError
from chatscene.simulate.simulator import Simulator, simulate
from chatscene.terms.episode import Episode
from chatscene.terms.scene import Rejected, Scene, ScenicProgram


def branch(
    program: ScenicProgram, scene: Scene, ego: EgoPolicy, to: EgoPolicy, simulator: Simulator, *, step: int
) -> Episode | Rejected:
    """Drive a scene with one ego until a step, and with another from then on.

    Nothing is copied: the scene is driven again with what the first ego did, so that every simulator can, and what it
    was until then it is to the bit where the simulator is exact. The other ego begins at that step, without a memory
    of what was before; each sees and brakes as it always does.

    Args:
        program: What is driven.
        scene: Its scene.
        ego: Who drives first.
        to: Who takes over.
        simulator: Where.
        step: The first step of the other; at 0 it drives alone.

    Raises:
        SettingsError: The drive is over before that step.
        EgoError: An ego fails.
        ProgramError: The program's own code fails.
    """
    ego, to = (fitted(one, program) for one in (ego, to))
    first = _Noted(ego)
    driven = simulate(simulator, program, scene, first)
    if isinstance(driven, Rejected):
        return driven
    if step >= len(first.actions):
        took, over = (f"{one * driven.dt:.4g} s" for one in (step, len(first.actions)))
        raise SettingsError(f"an ego cannot take over at {took}; the drive of the first is over at {over}")
    return simulate(simulator, program, scene, _After(first, to, step))


class _Noted:
    """An ego of which is noted what it does, as of one that has the whole brake."""

    pedals = "full-brake"

    def __init__(self, ego: EgoPolicy) -> None:
        self._ego, self.name = ego, name_of(ego)
        self.observation = observation_of(ego)
        self._scale = PEDALS[pedals_of(ego)]
        self.actions: list[tuple[float, float]] = []

    def reset(self) -> None:
        self.actions = []
        begin(self._ego)

    def act(self, observation: Observation) -> tuple[float, float]:
        acceleration, steering = decide(self._ego, observation)
        if acceleration < 0.0:
            acceleration = max(acceleration, -1.0) * self._scale
        self.actions.append((acceleration, steering))
        return acceleration, steering


class _After(_Noted):
    """Another ego, after what was noted of one."""

    def __init__(self, first: _Noted, ego: EgoPolicy, step: int) -> None:
        super().__init__(ego)
        self.name = f"{first.name}, then {self.name}"
        self._before = first.actions[:step]

    def act(self, observation: Observation) -> tuple[float, float]:
        if len(self.actions) < len(self._before):
            self.actions.append(self._before[len(self.actions)])
            return self.actions[-1]
        return super().act(observation)
