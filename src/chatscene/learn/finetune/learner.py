"""The learner of a fine-tuning: an SAC that starts from an ego's actor, and what it drives.

Stable-Baselines3 has the networks and the gradient step; driving an episode, what comes into the buffers, and when
to learn are here, because a fine-tuning counts in episodes of chosen scenes.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
import torch
from numpy.typing import NDArray
from stable_baselines3 import SAC
from stable_baselines3.common.logger import Logger
from stable_baselines3.common.utils import set_random_seed

from chatscene.ego.network import Network, NetworkEgo, layers_of
from chatscene.learn.env import DrivingEnv
from chatscene.learn.finetune.buffer import SplitBuffer
from chatscene.learn.finetune.scenes import KeptScene
from chatscene.learn.finetune.settings import FinetuneSettings
from chatscene.learn.state import keep, kept
from chatscene.program.ordinary import Course
from chatscene.settings import SimulationSettings

Array = NDArray[np.float32]
CRITIC = [256, 256]  # as the reference's
WARM_UP_RATE = 1e-3  # of the critics, before there is anything to spoil (SafeBench v1 trains at this rate)
_WARM_UP = 2**31  # the number of the "round" before the first


@dataclass(frozen=True, slots=True, kw_only=True)
class Schedule:
    """Which scene each episode drives: all in a new random order, then all again, ordinary drives spread evenly.

    Attributes:
        ordinary: The ordinary courses; empty if none is driven.
        share: Share of the episodes that are ordinary drives.
    """

    scenes: tuple[KeptScene, ...]
    ordinary: tuple[Course, ...]
    share: float
    seed: int

    def courses(self) -> tuple[Course, ...]:
        """What the environment must know: the course of each scene, then the ordinary ones."""
        return (*(kept.course for kept in self.scenes), *self.ordinary)

    def options(self, episode: int) -> dict[str, Any]:
        """What the environment is reset with for an episode, counted from 0."""
        ordinary = int(episode * self.share)
        if int((episode + 1) * self.share) > ordinary:
            return {"course": len(self.scenes) + self._turn(1, ordinary, len(self.ordinary))}
        turn = self._turn(0, episode - ordinary, len(self.scenes))
        return {"course": turn, "values": self.scenes[turn].scene.values}

    def _turn(self, stream: int, number: int, count: int) -> int:
        again, place = divmod(number, count)
        return int(np.random.default_rng((self.seed, stream, again)).permutation(count)[place])


@dataclass(frozen=True, slots=True, kw_only=True)
class Driven:
    """One episode: a row per step.

    Attributes:
        observations: (T + 1, n) float32, the last after the last step.
        actions: (T, 2) float32.
        rewards: (T,) float32.
        collided: Whether the last step was a collision; if not, the episode was cut or arrived.
    """

    observations: Array
    actions: Array
    rewards: Array
    collided: bool


class Learner:
    """Drives episodes and learns from them."""

    def __init__(
        self,
        start: NetworkEgo,
        settings: FinetuneSettings,
        schedule: Schedule,
        map_name: str,
        simulation: SimulationSettings,
    ) -> None:
        torch.set_num_threads(1)  # networks this small are slower on two
        self._start = start
        self._settings = settings
        self._schedule = schedule
        self._env = DrivingEnv(
            schedule.courses(),
            map_name=map_name,
            ego_observation=start.observation,
            pedals=start.pedals,
            reward=settings.reward,
            settings=simulation,
        )
        set_random_seed(settings.seed)
        self.model = SAC(
            "MlpPolicy",
            self._env,
            learning_rate=settings.learning_rate,
            buffer_size=settings.buffer,
            batch_size=settings.batch,
            gamma=settings.discount,
            tau=settings.tau,
            ent_coef=settings.entropy,
            replay_buffer_class=SplitBuffer,
            replay_buffer_kwargs={"collisions": settings.collision_buffer},
            policy_kwargs={
                "net_arch": {"pi": [len(bias) for _, bias in start.network.layers[:-1]], "qf": CRITIC},
                "activation_fn": torch.nn.ReLU,
            },
            seed=settings.seed,
            device="cpu",
        )
        self.model.set_logger(Logger(None, []))
        self._names = (*(f"latent_pi.{2 * i}" for i in range(len(start.network.layers) - 1)), "mu")
        self._put_in(start.network)
        self.steps = 0
        self.updates = 0

    @cached_property
    def buffer(self) -> SplitBuffer:
        """What was driven."""
        assert isinstance(self.model.replay_buffer, SplitBuffer)
        return self.model.replay_buffer

    def _put_in(self, start: Network) -> None:
        """Give the actor an ego's weights, and the same small noise everywhere: an ego's file has no other."""
        state = self.model.actor.state_dict()
        for name, (weights, bias) in zip(self._names, start.layers, strict=True):
            state[f"{name}.weight"], state[f"{name}.bias"] = torch.tensor(weights), torch.tensor(bias)
        state["log_std.weight"].zero_()
        state["log_std.bias"].fill_(self._settings.log_std)
        self.model.actor.load_state_dict(state)

    def warm_up(self) -> dict[str, float]:
        """Teach the critics what the start policy's actions are worth, and leave the actor as it is.

        Both are fitted to the discounted returns of noisy drives through the training scenes; a drive that ended
        without a crash counts as going on at the mean reward. These drives come into no buffer.

        Returns:
            ``episodes`` and ``steps`` driven; ``explained``, the share of the returns' variance that the critics
            explain in the end.
        """
        settings = self._settings
        self._seed(_WARM_UP)
        drives: list[Driven] = []
        while sum(len(drive.rewards) for drive in drives) < settings.warm_up_steps:
            drives.append(self._drive(len(drives)))
        self._env.close()
        reward = float(np.concatenate([drive.rewards for drive in drives]).mean())
        onward = reward / (1.0 - settings.discount)
        returns = np.concatenate([_returns(drive, settings.discount, onward) for drive in drives])
        observations = torch.from_numpy(np.concatenate([drive.observations[:-1] for drive in drives]))
        actions = torch.from_numpy(np.concatenate([drive.actions for drive in drives]))
        error = self._fit_critics(observations, actions, torch.from_numpy(returns))
        return {
            "episodes": float(len(drives)),
            "steps": float(len(returns)),
            "explained": 1.0 - error / max(float(returns.var()), 1e-9),
        }

    def _fit_critics(self, observations: torch.Tensor, actions: torch.Tensor, returns: torch.Tensor) -> float:
        """Regress both critics on returns; the mean squared error in the end."""
        critic, rng = self.model.critic, np.random.default_rng((self._settings.seed, _WARM_UP))
        with torch.no_grad():
            for network in critic.q_networks:
                last: Any = list(network.children())[-1]
                last.bias.fill_(returns.mean())  # most of what there is to learn
        optimizer = torch.optim.Adam(critic.parameters(), lr=WARM_UP_RATE)  # of its own: its moments end with it
        for _ in range(self._settings.critic_steps):
            rows = torch.from_numpy(rng.integers(len(returns), size=self._settings.batch))
            wanted = returns[rows, None]
            loss = sum((q - wanted).square().mean() for q in critic(observations[rows], actions[rows]))
            assert isinstance(loss, torch.Tensor)
            optimizer.zero_grad()
            loss.backward()
            optimizer.step()
        self.model.critic_target.load_state_dict(critic.state_dict())
        with torch.no_grad():
            first, second = critic(observations, actions)
            return float((0.5 * (first + second)[:, 0] - returns).square().mean())

    def learn(self, number: int, episodes: range) -> int:
        """Drive some episodes, and learn after each; how many collided."""
        self._seed(number)
        collisions = 0
        for episode in episodes:
            driven = self._drive(episode)
            self._remember(driven)
            collisions += driven.collided
            self.steps += len(driven.rewards)
            updates = self._settings.updates(len(driven.rewards))
            if updates and self.buffer.transitions >= self._settings.learning_starts:
                self.model.train(updates, self._settings.batch)
                self.updates += updates
        self._env.close()
        return collisions

    def _seed(self, number: int) -> None:
        seed = int(np.random.SeedSequence((self._settings.seed, number)).generate_state(1)[0] >> 1)
        set_random_seed(seed)
        self.buffer.seed(seed)

    def _drive(self, episode: int) -> Driven:
        """Drive one episode, drawing each action from the policy as it stands."""
        seed = int(np.random.SeedSequence((self._settings.seed, episode)).generate_state(1)[0])
        observation, _ = self._env.reset(seed=seed, options=self._schedule.options(episode))
        observations, actions, rewards = [observation], list[Array](), list[float]()
        terminated = truncated = False
        while not (terminated or truncated):
            with torch.no_grad():
                action: Array = self.model.actor(torch.from_numpy(observation)[None])[0].numpy()
            observation, reward, terminated, truncated, _ = self._env.step(action)
            observations.append(observation)
            actions.append(action)
            rewards.append(reward)
        return Driven(
            observations=np.array(observations, np.float32),
            actions=np.array(actions, np.float32),
            rewards=np.array(rewards, np.float32),
            collided=terminated,
        )

    def _remember(self, driven: Driven) -> None:
        """Put an episode into the buffers; what was cut or arrived is bootstrapped, what crashed is not."""
        last = len(driven.rewards) - 1
        for i, (action, reward) in enumerate(zip(driven.actions, driven.rewards, strict=True)):
            crashed = i == last and driven.collided
            cut = i == last and not driven.collided
            self.buffer.add(
                driven.observations[i],
                driven.observations[i + 1],
                action,
                reward,
                np.array(crashed or cut),
                [{"collision": crashed, "TimeLimit.truncated": cut}],
            )

    def ego(self) -> NetworkEgo:
        """The ego as it is, deterministic."""
        state = {name: tensor.numpy().copy() for name, tensor in self.model.actor.state_dict().items()}
        network = Network(layers=layers_of(state, self._names), output="tanh")
        return NetworkEgo(network, name="sac", observation=self._start.observation, pedals=self._start.pedals)

    def keep(self, path: Path) -> None:
        """Write what the next round needs."""
        state = {
            "parameters": self.model.get_parameters(),
            "steps": self.steps,
            "updates": self.updates,
            "buffer": self.buffer.stored(),
        }
        keep(path, state)

    def restore(self, path: Path) -> None:
        """Take up what `keep` wrote.

        Raises:
            RunError: It is damaged.
        """
        with kept(path) as state:
            self.model.set_parameters(dict(state["parameters"]))
            self.steps, self.updates = state["steps"], state["updates"]
            self.buffer.restore(state["buffer"])


def _returns(driven: Driven, discount: float, onward: float) -> Array:
    """The discounted return of each step; `onward` is what follows a drive that did not crash."""
    value = 0.0 if driven.collided else onward
    returns = np.empty(len(driven.rewards), np.float32)
    for i in range(len(returns) - 1, -1, -1):
        value = float(driven.rewards[i]) + discount * value
        returns[i] = value
    return returns
