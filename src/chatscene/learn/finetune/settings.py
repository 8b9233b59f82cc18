"""Every number of a fine-tuning, with its source."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from chatscene.errors import SettingsError, no_such
from chatscene.settings import check_settings

CHOICES = ("paper", "held-out")
PRESETS: dict[str, dict[str, Any]] = {
    "paper": {"updates_per_step": 1.0, "updates_per_episode": 0},
    "released": {"updates_per_step": 0.0, "updates_per_episode": 1},
}
"""How often is learned.

The paper says 500 epochs of one simulation each and no number of gradient steps; ``paper`` takes the one step per
environment step that soft actor-critic is known for. ``released`` is what the released code does.
"""


@dataclass(frozen=True, slots=True, kw_only=True)
class FinetuneSettings:
    """What a fine-tuning is (paper, appendix "Adversarial Finetuning Details"; released code, ``adv_scenic.yaml``).

    Attributes:
        ego: Who is fine-tuned: ``sac``, a policy's file, or a folder with ``policy.npz``. With a teacher: who is only
            driven before, to compare.
        teacher: An ego that says at each step what it would do, by its name or file: a new policy then learns that,
            from nothing, and no reward; empty for none.
        reward: One of `chatscene.learn.reward.REWARDS`.
        choice: Who chooses the checkpoint: ``paper``, the test scenes; ``held-out``, the last of the training routes.
        episodes: Scenes driven (paper: 500).
        ordinary_share: Share of the episodes that are ordinary drives (paper: none).
        train_routes: How many routes train; the scenes on the others test (paper: 8).
        validation_routes: How many of these choose under ``held-out``, and do not train.
        round: Episodes between two checkpoints (paper: 50).
        first_choice: Episodes before the first checkpoint that can be chosen (paper: 100).
        updates_per_step: Gradient steps for each environment step of an episode, taken after it; see `PRESETS`.
        updates_per_episode: Gradient steps after an episode besides; see `PRESETS`.
        learning_rate: Of actor and critics (paper: 1e-4).
        batch: Transitions per gradient step (paper: 512).
        buffer: Latest ordinary transitions kept (paper: 20,000).
        collision_buffer: Latest transitions with a collision kept (paper: 200).
        learning_starts: Transitions before the first gradient step (released code: 1,000).
        discount: Of the future (paper: 0.99).
        entropy: The weight of entropy (paper: 0.01).
        tau: How far the target critics follow in each step (SafeBench v1: 0.005).
        log_std: Logarithm of the policy's standard deviation at the start, before tanh; an ego's file has none.
        warm_up_steps: Environment steps driven to teach the critics before anything else; an ego's file has none.
        critic_steps: Gradient steps of the critics on these.
        simulator: In what scenes are driven; empty for that of the runs.
        physics: How bodies answer there; empty for that of the runs.
    """

    ego: str = "sac"
    teacher: str = ""
    reward: str = "safebench"
    choice: str = "paper"
    episodes: int = 500
    ordinary_share: float = 0.0
    train_routes: int = 8
    validation_routes: int = 2
    round: int = 50
    first_choice: int = 100
    updates_per_step: float = 1.0
    updates_per_episode: int = 0
    learning_rate: float = 1e-4
    batch: int = 512
    buffer: int = 20_000
    collision_buffer: int = 200
    learning_starts: int = 1_000
    discount: float = 0.99
    entropy: float = 0.01
    tau: float = 0.005
    log_std: float = -2.0
    warm_up_steps: int = 5_000
    critic_steps: int = 2_000
    simulator: str = ""
    physics: str = ""
    seed: int = 0

    def __post_init__(self) -> None:
        check_settings(self, {})
        if self.choice not in CHOICES:
            raise SettingsError(no_such("choice", self.choice, CHOICES))
        for name in ("episodes", "round", "train_routes", "validation_routes", "batch", "warm_up_steps"):
            if getattr(self, name) < 1:
                raise SettingsError(f"{name} must be at least 1, not {getattr(self, name)}")
        if not 0.0 <= self.ordinary_share < 1.0:
            raise SettingsError(f"ordinary_share must be at least 0 and below 1, not {self.ordinary_share}")
        if self.choice == "held-out" and self.validation_routes >= self.train_routes:
            raise SettingsError(
                f"{self.validation_routes} of {self.train_routes} training routes cannot be held out; "
                "some must be left to train on"
            )

    def updates(self, steps: int) -> int:
        """How many gradient steps follow an episode of so many environment steps."""
        return self.updates_per_episode + round(self.updates_per_step * steps)

    def ends(self) -> list[int]:
        """How many episodes are done after each round."""
        return [*range(self.round, self.episodes, self.round), self.episodes]
