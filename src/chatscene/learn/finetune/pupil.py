"""A learner that is shown what to do: at each step of its own drives, a teacher says what it would have done.

Of a teacher that chooses among ways (`chatscene.ego.planner`) the choice is learned, so that between two of them the
pupil takes one; of any other, what it does, and between two actions their mean.

S. Ross, G. Gordon, J. A. Bagnell, "A Reduction of Imitation Learning and Structured Prediction to No-Regret Online
Learning", AISTATS 2011 (DAgger). The first round is driven by the teacher, every later one by the pupil as it is, so
that it learns what to do where its own mistakes take it.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from torch import Tensor, nn

from chatscene.ego.asking import begin, decide
from chatscene.ego.network import Network, NetworkEgo
from chatscene.ego.observation import OBSERVATIONS, Observation
from chatscene.ego.planner import ACCELERATION, Planner, carried_out
from chatscene.ego.policy import EgoPolicy, observation_of, pedals_of
from chatscene.learn.env import DrivingEnv
from chatscene.learn.finetune.learner import Schedule
from chatscene.learn.finetune.settings import FinetuneSettings
from chatscene.learn.state import keep, kept
from chatscene.settings import SimulationSettings

Array = NDArray[np.float32]
HIDDEN = 512  # units of either layer: what a planner does is hard to put into fewer
STEPS, BATCH, RATE = 4_000, 256, 1e-3  # gradient steps after a round, rows of each, and Adam's first rate
NOISE = np.array([0.3, 0.2])  # standard deviation of what is added to acceleration and steering, so that slips occur …
LASTING = 0.9  # … and last: the share of it that stays from step to step


class _Actions:
    """What a teacher does, acceleration and steering."""

    output, at_most, outputs, empty = "tanh", 0.0, 2, torch.empty((0, 2))
    kept_as = np.float32

    def __init__(self, teacher: EgoPolicy) -> None:
        self._teacher = teacher

    def shown(self, observation: Observation) -> tuple[Any, tuple[float, float]]:
        """What is to be learned, and the action."""
        told = decide(self._teacher, observation)
        return told, told

    def action(self, answer: Tensor, _: Observation) -> tuple[float, float]:
        """What an answer of the network comes to."""
        acceleration, steering = answer.tanh().tolist()
        return acceleration, steering

    def loss(self, answers: Tensor, shown: Tensor) -> Tensor:
        return (answers.tanh() - shown).square().mean()


class _Ways:
    """Which way a teacher chooses."""

    output, outputs, empty = "ways", len(ACCELERATION), torch.empty(0, dtype=torch.int64)
    kept_as = np.int64

    def __init__(self, teacher: Planner) -> None:
        self._teacher, self.at_most = teacher, teacher.caution.speed

    def shown(self, observation: Observation) -> tuple[Any, tuple[float, float]]:
        """What is to be learned, and the action."""
        way = self._teacher.choose(observation)
        return way, carried_out(observation, way, self.at_most)

    def action(self, answer: Tensor, observation: Observation) -> tuple[float, float]:
        """What an answer of the network comes to."""
        return carried_out(observation, int(answer.argmax()), self.at_most)

    def loss(self, answers: Tensor, shown: Tensor) -> Tensor:
        return nn.functional.cross_entropy(answers, shown)


class Pupil:
    """Drives episodes and learns to do in them as its teacher would."""

    def __init__(
        self,
        teacher: EgoPolicy,
        settings: FinetuneSettings,
        schedule: Schedule,
        map_name: str,
        simulation: SimulationSettings,
    ) -> None:
        torch.set_num_threads(1)  # networks this small are slower on two
        self._teacher = teacher
        self._schedule = schedule
        self._seed = settings.seed
        self._env = DrivingEnv(
            schedule.courses(),
            map_name=map_name,
            ego_observation=observation_of(teacher),
            pedals=pedals_of(teacher),
            settings=simulation,
        )
        size = OBSERVATIONS[observation_of(teacher)]
        torch.manual_seed(settings.seed)
        self._lesson = _Ways(teacher) if type(teacher) is Planner else _Actions(teacher)
        layers = nn.Linear(size, HIDDEN), nn.Linear(HIDDEN, HIDDEN), nn.Linear(HIDDEN, self._lesson.outputs)
        self._net = nn.Sequential(layers[0], nn.ReLU(), layers[1], nn.ReLU(), layers[2])
        self._scale = torch.ones(size)
        self._seen = torch.empty((0, size))
        self._shown = self._lesson.empty
        self.updates = 0

    @property
    def steps(self) -> int:
        """How many steps were driven."""
        return len(self._seen)

    def warm_up(self) -> dict[str, float]:
        """Nothing: a pupil learns from its first drive on."""
        return {}

    def learn(self, number: int, episodes: range) -> int:
        """Drive some episodes, then learn from all driven so far; how many collided."""
        rng = np.random.default_rng((self._seed, number))
        collisions = 0
        for episode in episodes:
            seen, shown, collided = self._drive(episode, rng, led=number == 0)
            self._seen = torch.cat([self._seen, torch.from_numpy(seen)])
            self._shown = torch.cat([self._shown, torch.from_numpy(shown)])
            collisions += collided
        self._env.close()
        if number == 0:
            self._scale = self._seen.abs().amax(dim=0).clamp(min=1.0)
        self._fit(rng)
        return collisions

    def _drive(self, episode: int, rng: np.random.Generator, *, led: bool) -> tuple[Array, NDArray[Any], bool]:
        """One episode: what was seen, what the teacher says to it, and whether it ended in a collision."""
        seed = int(np.random.SeedSequence((self._seed, episode)).generate_state(1)[0])
        observation, _ = self._env.reset(seed=seed, options=self._schedule.options(episode))
        seen, shown, noise = list[Array](), list[Any](), np.zeros(2)
        begin(self._teacher)
        terminated = truncated = False
        while not (terminated or truncated):
            exact = observation.astype(np.float64)
            lesson, told = self._lesson.shown(exact)
            seen.append(observation)
            shown.append(lesson)
            with torch.no_grad():
                own = self._lesson.action(self._net(torch.from_numpy(observation) / self._scale), exact)
            noise = LASTING * noise + rng.normal(0.0, NOISE * np.sqrt(1.0 - LASTING**2))
            action = np.clip(np.array(told if led else own) + noise, -1.0, 1.0).astype(np.float32)
            observation, _, terminated, truncated, _ = self._env.step(action)
        return np.array(seen, np.float32), np.array(shown, self._lesson.kept_as), terminated

    def _fit(self, rng: np.random.Generator) -> None:
        seen = self._seen / self._scale
        optimizer = torch.optim.Adam(self._net.parameters(), RATE)
        for step in range(STEPS):
            optimizer.param_groups[0]["lr"] = RATE * (1.0 - step / STEPS)
            rows = torch.from_numpy(rng.integers(len(seen), size=BATCH))
            loss = self._lesson.loss(self._net(seen[rows]), self._shown[rows])
            optimizer.zero_grad()
            loss.backward()
            optimizer.step()
        self.updates += STEPS

    def ego(self) -> NetworkEgo:
        """The ego as it is."""
        layers = [module for module in self._net if isinstance(module, nn.Linear)]
        arrays = [[layer.weight.detach().clone(), layer.bias.detach().clone()] for layer in layers]
        arrays[0][0] /= self._scale
        network = Network(
            layers=tuple((weights.numpy(), bias.numpy()) for weights, bias in arrays),
            output=self._lesson.output,
            at_most=self._lesson.at_most,
        )
        teacher = self._teacher
        return NetworkEgo(network, name="pupil", observation=observation_of(teacher), pedals=pedals_of(teacher))

    def keep(self, path: Path) -> None:
        """Write what the next round needs."""
        state = {"scale": self._scale, "seen": self._seen, "shown": self._shown, "updates": self.updates}
        keep(path, {**state, "network": self._net.state_dict()})

    def restore(self, path: Path) -> None:
        """Take up what `keep` wrote.

        Raises:
            RunError: It is damaged.
        """
        with kept(path) as state:
            self._net.load_state_dict(state["network"])
            self._scale, self._seen, self._shown = state["scale"], state["seen"], state["shown"]
            self.updates = state["updates"]
