"""What a fine-tuning learns from: crashes and everything else apart, so that the few crashes are not drowned.

Paper, appendix "Adversarial Finetuning Details". Released code: a transition is a crash's if the ego collided in that
step, so that a drive yields one at most.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from chatscene.errors import MissingExtra

try:
    import torch
    from stable_baselines3.common.buffers import ReplayBuffer
    from stable_baselines3.common.type_aliases import ReplayBufferSamples
except ImportError as error:
    raise MissingExtra("fine-tuning needs Stable-Baselines3", extra="train") from error

COLLISION_SHARE = 5  # one in five samples of a batch (paper: 20 %)
_FIELDS = ("observations", "actions", "next_observations", "dones", "rewards")  # of a batch
_ARRAYS = ("observations", "next_observations", "actions", "rewards", "dones", "timeouts")


class SplitBuffer(ReplayBuffer):
    """A replay buffer of ordinary steps, and beside it one of the steps in which the ego collided.

    ``infos[0]["collision"]`` says which a transition is. Each part keeps the latest it was given. A batch has one in
    five from the crashes, or all of them where there are fewer, and is filled up with ordinary steps; nothing is in a
    batch twice.
    """

    def __init__(
        self,
        buffer_size: int,
        observation_space: Any,
        action_space: Any,
        device: Any = "cpu",
        *,
        collisions: int,
        **arguments: Any,
    ) -> None:
        super().__init__(buffer_size, observation_space, action_space, device, **arguments)
        self.crashes = ReplayBuffer(collisions, observation_space, action_space, device, **arguments)
        self._rng = np.random.default_rng(0)

    @property
    def transitions(self) -> int:
        """How many there are in both parts."""
        return self.size() + self.crashes.size()

    def seed(self, seed: int) -> None:
        """Draw batches from this seed on."""
        self._rng = np.random.default_rng(seed)

    def add(self, obs: Any, next_obs: Any, action: Any, reward: Any, done: Any, infos: list[dict[str, Any]]) -> None:
        """Keep one transition in the part it belongs to."""
        keep = self.crashes.add if infos[0].get("collision") else super().add
        keep(obs, next_obs, action, reward, done, infos)

    def sample(self, batch_size: int, env: Any = None) -> ReplayBufferSamples:
        """Draw a batch: first the crashes, then the ordinary steps."""
        crashed = min(batch_size // COLLISION_SHARE, self.crashes.size())
        ordinary = min(batch_size - crashed, self.size())
        parts = [(self.crashes, crashed), (self, ordinary)]
        drawn = [buffer._get_samples(self._draw(buffer.size(), count), env) for buffer, count in parts]
        return ReplayBufferSamples(*(torch.cat([getattr(part, name) for part in drawn]) for name in _FIELDS))

    def _draw(self, size: int, count: int) -> np.ndarray[Any, Any]:
        return self._rng.choice(size, count, replace=False, shuffle=False)

    def stored(self) -> dict[str, Any]:
        """Both parts as arrays and plain numbers; `restore` takes them up again."""
        return {name: _stored(buffer) for name, buffer in (("ordinary", self), ("crashes", self.crashes))}

    def restore(self, kept: Mapping[str, Mapping[str, Any]]) -> None:
        """Take up what `stored` gave."""
        for name, buffer in (("ordinary", self), ("crashes", self.crashes)):
            for array in _ARRAYS:
                getattr(buffer, array)[:] = kept[name][array]
            buffer.pos, buffer.full = kept[name]["pos"], kept[name]["full"]


def _stored(buffer: ReplayBuffer) -> dict[str, Any]:
    arrays = {name: getattr(buffer, name) for name in _ARRAYS}
    return arrays | {"pos": buffer.pos, "full": buffer.full}
