"""Train an ego on ordinary drives, never on the scenes it will be judged by.

Stable-Baselines3 learns; this module gives it the environment, the paper's hyperparameters, and a folder that can be
killed at any moment. Training goes in rounds. Between two rounds nothing is in progress, so that is where an ego is
evaluated, kept and, after a kill, taken up again; each round seeds everything from its own number, so a training
that was taken up again ends in the same weights as one that was not.

Hyperparameters: SafeBench v1, the configuration files beside its checkpoints (SAC, PPO, TD3).
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from chatscene import runs
from chatscene.ego.network import Network, ego_of, layers_of, load_network
from chatscene.errors import MissingExtra, SettingsError, no_such
from chatscene.learn.reward import DESIRED_SPEED
from chatscene.maps.network import resolve_map
from chatscene.measure.ordinary import OrdinaryResult, drive_ordinary
from chatscene.runs.atomic import write_bytes
from chatscene.runs.digests import digest_of
from chatscene.runs.progress import Progress, silent
from chatscene.runs.trust import Repeated, follow
from chatscene.runs.working import going_on
from chatscene.settings import SIMULATOR, SimulationSettings, check_settings
from chatscene.simulate.simulator import load_simulator

if TYPE_CHECKING:
    from stable_baselines3.common.base_class import BaseAlgorithm

HIDDEN = (256, 256)
CHECKPOINT = "checkpoint.npz"
LEAVES = ("policy.npz", CHECKPOINT, "checkpoint.pt", "tensorboard/*")  # the third of before, which is not read
EVALUATION_SEED = 10_000  # far from any seed a training draws with
ALGORITHMS: dict[str, dict[str, Any]] = {
    "sac": {
        "learning_rate": 1e-3,
        "batch_size": 100,
        "buffer_size": 20_000,
        "learning_starts": 600,
        "gamma": 0.99,
        "tau": 0.005,
        "ent_coef": 0.01,
    },
    "td3": {
        "learning_rate": 1e-3,
        "batch_size": 100,
        "buffer_size": 20_000,
        "learning_starts": 600,
        "gamma": 0.99,
        "tau": 0.005,
        "policy_delay": 2,
        "target_policy_noise": 0.2,
        "target_noise_clip": 0.5,
    },
    # The reference trains the critic at 1e-3; Stable-Baselines3 has one rate for both.
    "ppo": {
        "learning_rate": 3e-4,
        "n_steps": 1000,
        "batch_size": 1000,
        "n_epochs": 80,
        "gamma": 0.99,
        "gae_lambda": 0.97,
        "clip_range": 0.2,
        "target_kl": 0.01,
    },
}
"""The preset `safebench`, by algorithm, in the words of Stable-Baselines3."""


@dataclass(frozen=True, slots=True, kw_only=True)
class TrainSettings:
    """What a training is.

    Attributes:
        algorithm: One of `ALGORITHMS`.
        observation: A preset of `chatscene.ego.observation`.
        reward: One of `chatscene.learn.reward.REWARDS`.
        pedals: One of `chatscene.ego.policy.PEDALS`.
        steps: Environment steps of 0.1 s.
        simulator: In what, one of `chatscene.simulate.simulator.SIMULATORS`.
        physics: How bodies answer there, one of `chatscene.settings.PHYSICS`.
        speed: What the ego is to drive at [km/h], within the limits of the roads, and everybody in proportion; 0 where
            it is told nothing, and drives at SafeBench's speed.
    """

    algorithm: str = "sac"
    observation: str = "safebench"
    reward: str = "progress"
    pedals: str = "safebench"
    steps: int = 60_000
    round: int = 5_000
    seed: int = 0
    map_name: str = "town"
    simulator: str = SIMULATOR
    physics: str = SimulationSettings().physics
    speed: float = 0.0

    def __post_init__(self) -> None:
        check_settings(self, {"speed": (0.0, 300.0)})
        if self.speed and self.observation != "traffic":
            raise SettingsError(
                f"an ego that sees {self.observation!r} does not know how fast it may drive; "
                "to train one for a speed, let it see 'traffic'"
            )
        if self.algorithm not in ALGORITHMS:
            raise SettingsError(no_such("algorithm", self.algorithm, ALGORITHMS))
        if not 0 < self.round <= self.steps:
            raise SettingsError(
                f"a round of {self.round} steps is longer than a training of {self.steps}; give a shorter one"
            )
        if self.algorithm == "ppo" and self.round % ALGORITHMS["ppo"]["n_steps"]:
            raise SettingsError(f"PPO learns every {ALGORITHMS['ppo']['n_steps']} steps; make --round a multiple of it")

    @property
    def simulation(self) -> SimulationSettings:
        """How an episode is stepped, and by what."""
        return SimulationSettings(simulator=self.simulator, physics=self.physics)

    @property
    def wanted(self) -> float | None:
        """What the ego is to drive at [m/s]; None where it is told nothing."""
        return self.speed / 3.6 or None

    @property
    def rounds(self) -> int:
        """How many rounds; the last may overshoot `steps`."""
        return -(-self.steps // self.round)


@dataclass(frozen=True, slots=True, kw_only=True)
class Trained:
    """What a training came to.

    Attributes:
        folder: Where everything is; `policy.npz` is the best ego, which `--ego` takes.
        curve: One row per round: steps, seconds, and the figures of the ego then.
    """

    folder: Path
    curve: tuple[Row, ...]
    best: Row


Row = dict[str, int | float]  # of a curve


def train(folder: Path, settings: TrainSettings, *, progress: Progress) -> Trained:
    """Train into a new folder, or go on in one where a training with the same settings was cut.

    Raises:
        MissingExtra: Stable-Baselines3 is not installed.
        RunError: The folder holds another training, or something else, or cannot be written.
    """
    simulator = load_simulator(resolve_map(settings.map_name), settings.simulation)
    asked = runs.TrainingRecord(
        settings={
            name: value
            for name, value in asdict(settings).items()
            if name != "steps" and (name, value) != ("speed", 0.0)  # as before there were speeds
        },
        steps=settings.steps,
        map_digest=digest_of(resolve_map(settings.map_name)),
        simulator=runs.SimulatorRecord.of(simulator.identity),
    )
    with going_on(folder, asked, progress, leaves=LEAVES) as (work, tell):
        curve = runs.read_record(work, runs.TrainingRecord).curve
        if len(curve) < settings.rounds:
            _rounds(work, settings, curve, tell)
        tell("training, steps", settings.steps, settings.steps)
    kept = _kept(work)
    return Trained(
        folder=folder, curve=tuple(curve), best=next((row for row in curve if row["steps"] == kept["steps"]), kept)
    )


def resume(folder: Path, *, progress: Progress = silent, repeated: Repeated | None = None) -> Trained:
    """Go on with a training that was killed or failed.

    Raises:
        RunError: There is none in the folder, or it names what must be repeated (`chatscene.runs.trust.follow`).
    """
    work = runs.open_run(folder, runs.TrainingRecord)
    follow(repeated or Repeated(), simulators_of=[work])
    record = runs.read_record(work, runs.TrainingRecord)
    settings = runs.settings_from(TrainSettings, {**record.settings, "steps": record.steps})
    return train(folder, settings, progress=progress)


def _rounds(work: runs.Workspace, settings: TrainSettings, curve: list[Row], progress: Progress) -> None:
    """Do the rounds that are not done, and add a row to the curve for each."""
    learner = _Learner(work.path, settings)
    if curve:
        learner.restore()
    for number in range(len(curve), settings.rounds):
        progress("training, steps", number * settings.round, settings.steps)
        began = time.monotonic()
        learner.learn(number)
        seconds = time.monotonic() - began
        network = learner.network()
        result = evaluate_network(network, settings)
        row = {"steps": float((number + 1) * settings.round), "seconds": round(seconds, 1)} | result.figures()
        swiftest = settings.wanted or DESIRED_SPEED
        if not curve or _worth(row, swiftest) > _worth(_kept(work), swiftest):
            write_bytes(work.file("policy.npz"), network.stored(_about(settings, row)))
        learner.keep()
        curve.append(row)  # last: a row says that everything before it is on disk
        runs.update(work, curve=curve)
    learner.close()


def evaluate_network(network: Network, settings: TrainSettings, *, seed: int = EVALUATION_SEED) -> OrdinaryResult:
    """How a network fares on every ordinary drive of the map."""
    ego = ego_of(network, asdict(settings), settings.algorithm)
    simulator = load_simulator(resolve_map(settings.map_name), settings.simulation)
    return drive_ordinary(ego, simulator, scenes=1, seed=settings.seed + seed, speed=settings.wanted)


def _kept(work: runs.Workspace) -> Row:
    """The row of the policy that is kept, which an earlier version may have chosen by another rule."""
    _, about = load_network(work.file("policy.npz"))
    own = "evaluation_"
    return {name.removeprefix(own): value for name, value in about.items() if name.startswith(own)}


def _worth(row: Mapping[str, float], swiftest: float) -> float:
    """What makes one ego better than another: to arrive, not to crash, to stay on the road, and then to be swift.

    A drive that leaves the road is as bad as one that crashes. Rows of earlier versions have only the share of the time
    off the road, which is at most the share of such drives.
    """
    swift = min(row["mean_speed"], swiftest)
    astray = row.get("off_road_rate", row["off_road"])
    return row["completion"] - 5.0 * (row["collision_rate"] + astray) + 0.01 * swift


def _about(settings: TrainSettings, row: Mapping[str, float]) -> dict[str, str | float]:
    return {**asdict(settings), **{f"evaluation_{name}": value for name, value in row.items()}}


_BUFFER_ARRAYS = ("observations", "next_observations", "actions", "rewards", "dones", "timeouts")
_ACTORS = {
    "sac": (("actor.latent_pi.0", "actor.latent_pi.2", "actor.mu"), "tanh"),
    "td3": (("actor.mu.0", "actor.mu.2", "actor.mu.4"), "tanh"),
    "ppo": (("mlp_extractor.policy_net.0", "mlp_extractor.policy_net.2", "action_net"), "clip"),
}  # the layers of the deterministic policy in Stable-Baselines3's names, and what follows them


class _Learner:
    """A Stable-Baselines3 model that is kept as plain arrays: nothing it reads back can run code."""

    def __init__(self, folder: Path, settings: TrainSettings) -> None:
        try:
            import stable_baselines3
            import torch
            from stable_baselines3.common.logger import configure
            from stable_baselines3.common.noise import NormalActionNoise
        except ImportError as error:
            raise MissingExtra("training needs Stable-Baselines3", extra="train") from error
        from chatscene.learn.env import DrivingEnv

        self._folder = folder
        self._settings = settings
        self._env = DrivingEnv(
            map_name=settings.map_name,
            ego_observation=settings.observation,
            pedals=settings.pedals,
            reward=settings.reward,
            speed=settings.speed or None,
            settings=settings.simulation,
        )
        torch.set_num_threads(1)  # networks this small are slower on two
        policy: dict[str, Any] = {"net_arch": list(HIDDEN), "activation_fn": torch.nn.ReLU}
        more: dict[str, Any] = {}
        if settings.algorithm == "td3":
            more["action_noise"] = NormalActionNoise(np.zeros(2), np.full(2, 0.1))
        if settings.algorithm == "ppo":
            policy["log_std_init"] = -0.5
        make = getattr(stable_baselines3, settings.algorithm.upper())
        self.model: BaseAlgorithm = make(
            "MlpPolicy",
            self._env,
            policy_kwargs=policy,
            seed=settings.seed,
            device="cpu",
            **ALGORITHMS[settings.algorithm],
            **more,
        )
        self._logger = configure(str(folder / "tensorboard"), ["tensorboard"])
        self.model.set_logger(self._logger)

    def learn(self, number: int) -> None:
        """Learn for one round."""
        seed = int(np.random.SeedSequence((self._settings.seed, number)).generate_state(1)[0] >> 1)
        self.model.set_random_seed(seed)
        self.model._last_obs = None  # pyright: ignore[reportPrivateUsage] - the last drive ended with its round
        self.model.learn(self._settings.round, reset_num_timesteps=False)
        self._env.close()

    def close(self) -> None:
        """Write the learning curves to their end."""
        self._logger.close()

    def network(self) -> Network:
        """The policy as it is, deterministic."""
        state = {name: tensor.numpy() for name, tensor in self.model.policy.state_dict().items()}
        names, output = _ACTORS[self._settings.algorithm]
        return Network(layers=layers_of(state, names), output=output)

    def keep(self) -> None:
        """Write what the next round needs."""
        from chatscene.learn.state import keep

        keep(
            self._folder / CHECKPOINT,
            {
                "parameters": self.model.get_parameters(),
                "steps": self.model.num_timesteps,
                "updates": self.model._n_updates,  # pyright: ignore[reportPrivateUsage]
                "buffer": self._buffer(),
            },
        )

    def _buffer(self) -> dict[str, Any]:
        buffer: Any = getattr(self.model, "replay_buffer", None)
        if buffer is None:
            return {}
        return {name: getattr(buffer, name) for name in (*_BUFFER_ARRAYS, "pos", "full")}

    def restore(self) -> None:
        """Take up what `keep` wrote.

        Raises:
            RunError: It is damaged.
        """
        from chatscene.learn.state import kept

        with kept(self._folder / CHECKPOINT) as state:
            self.model.set_parameters(state["parameters"])
            self.model.num_timesteps = state["steps"]
            self.model._n_updates = state["updates"]  # pyright: ignore[reportPrivateUsage]
            buffer: Any = getattr(self.model, "replay_buffer", None)
            if buffer is not None:
                for name in _BUFFER_ARRAYS:
                    getattr(buffer, name)[:] = state["buffer"][name]
                buffer.pos, buffer.full = state["buffer"]["pos"], state["buffer"]["full"]
