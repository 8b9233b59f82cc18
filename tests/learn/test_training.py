"""Training: what a learner is told at the end of a drive, what is kept, and that it is the same every time."""

from __future__ import annotations

import re
from dataclasses import replace
from inspect import signature
from pathlib import Path
from typing import Any
from unittest.mock import Mock, patch

import numpy as np
import pytest

pytest.importorskip("stable_baselines3", reason="the extra 'train' is not installed")

from click.testing import CliRunner

import chatscene
import chatscene as api
import chatscene.gym
from chatscene import runs
from chatscene.commands.main import main
from chatscene.ego.asking import wanting
from chatscene.ego.network import load_network
from chatscene.ego.observation import OBSERVATIONS
from chatscene.ego.policy import load_ego
from chatscene.errors import RunError, SettingsError
from chatscene.learn import env as driving_env
from chatscene.learn import train as training
from chatscene.learn.finetune.settings import FinetuneSettings
from chatscene.learn.train import Trained, TrainSettings, train
from chatscene.measure.ordinary import OrdinaryDrive, OrdinaryResult
from chatscene.program.ordinary import Course, ordinary_program, ordinary_queries
from chatscene.simulate.simulator import Simulator

pytestmark = [
    pytest.mark.filterwarnings("ignore::DeprecationWarning"),
    pytest.mark.filterwarnings("ignore::FutureWarning"),
    pytest.mark.filterwarnings("ignore::UserWarning"),
]


def silent(_what: str, _done: int, _total: int) -> None:
    pass


@pytest.fixture(autouse=True)
def short(monkeypatch: pytest.MonkeyPatch) -> None:
    """Small networks, one course, and an evaluation that takes no time."""
    monkeypatch.setattr(training, "HIDDEN", (8, 8))
    monkeypatch.setitem(training.ALGORITHMS["sac"], "learning_starts", 20)
    monkeypatch.setitem(training.ALGORITHMS["td3"], "learning_starts", 20)
    monkeypatch.setitem(training.ALGORITHMS["ppo"], "n_steps", 40)
    monkeypatch.setitem(training.ALGORITHMS["ppo"], "batch_size", 40)
    monkeypatch.setitem(training.ALGORITHMS["ppo"], "n_epochs", 2)

    def evaluated(
        ego: Any, simulator: Simulator, *, scenes: int, seed: int, speed: float | None = None
    ) -> OrdinaryResult:
        speed = float(ego.act(np.resize((0.0, 0.0, 5.0, 0.0), OBSERVATIONS[ego.observation]))[0])
        one = OrdinaryDrive(course=0, completion=0.5, speed=speed, off_road=0.0, collided=False)
        return OrdinaryResult(ego="e", drives=(one,), rejected=0)

    monkeypatch.setattr(training, "drive_ordinary", evaluated)
    course = Course(program=ordinary_program(ordinary_queries()[0]), route=0)
    monkeypatch.setattr(driving_env, "ordinary_courses", Mock(return_value=(course,)))


def settings(algorithm: str, **changes: Any) -> TrainSettings:
    return replace(TrainSettings(algorithm=algorithm, steps=80, round=40, seed=3), **changes)


@pytest.mark.parametrize("algorithm", sorted(training.ALGORITHMS))
class TestEveryAlgorithm:
    def test_the_same_seed_trains_the_same_ego(self, algorithm: str, tmp_path: Path) -> None:
        for name in ("a", "b"):
            train(tmp_path / name, settings(algorithm), progress=silent)
        first, second = (load_network(tmp_path / name / "policy.npz")[0] for name in ("a", "b"))
        for (w1, b1), (w2, b2) in zip(first.layers, second.layers, strict=True):
            assert np.array_equal(w1, w2)
            assert np.array_equal(b1, b2)

    def test_a_training_that_was_cut_ends_like_one_that_was_not(
        self, algorithm: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        whole = train(tmp_path / "whole", settings(algorithm, steps=120), progress=silent)
        learn = training._Learner.learn  # pyright: ignore[reportPrivateUsage]

        def killed(self: Any, number: int) -> None:
            if number == 2:
                raise KeyboardInterrupt
            learn(self, number)

        with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
            patch.setattr(training._Learner, "learn", killed)  # pyright: ignore[reportPrivateUsage]
            train(tmp_path / "cut", settings(algorithm, steps=120), progress=silent)
        (tmp_path / "cut" / ".policy.npz.1234.tmp").write_bytes(b"half")  # what the killed process was writing
        resumed = api.resume(tmp_path / "cut")
        assert isinstance(resumed, Trained)
        condition = runs.check(tmp_path / "cut")
        assert condition.whole
        assert not condition.added
        figures = [[{**row, "seconds": 0.0} for row in trained.curve] for trained in (whole, resumed)]
        assert figures[0] == figures[1]

    def test_the_policy_that_is_kept_is_the_policy_that_learned(self, algorithm: str, tmp_path: Path) -> None:
        import torch

        chosen = settings(algorithm, steps=40)
        learner = training._Learner(tmp_path, chosen)  # pyright: ignore[reportPrivateUsage]
        learner.learn(0)
        (tmp_path / "p.npz").write_bytes(learner.network().stored({"observation": "safebench", "pedals": "safebench"}))
        network, about = load_network(tmp_path / "p.npz")
        assert about == {"observation": "safebench", "pedals": "safebench"}
        for observation in np.random.default_rng(0).normal(size=(20, 4)):
            with torch.no_grad():
                expected = learner.model.predict(observation.astype(np.float32), deterministic=True)[0]
            assert network(observation) == pytest.approx(np.clip(expected, -1, 1).tolist(), abs=1e-5)

    def test_the_ego_can_be_loaded_from_its_file(self, algorithm: str, tmp_path: Path) -> None:
        train(tmp_path / "t", settings(algorithm, steps=40), progress=silent)
        ego = load_ego(str(tmp_path / "t" / "policy.npz"))
        assert len(tuple(ego.act(np.zeros(4)))) == 2


@pytest.mark.parametrize("algorithm", ["sac", "td3"])
def test_a_truncated_drive_is_bootstrapped_and_a_crash_is_not(algorithm: str, tmp_path: Path) -> None:
    learner = training._Learner(tmp_path, settings(algorithm, steps=2000, round=2000))  # pyright: ignore[reportPrivateUsage]
    model: Any = learner.model
    endings: list[tuple[bool, bool]] = []
    step = learner._env.step  # pyright: ignore[reportPrivateUsage]

    def noting(action: Any) -> Any:
        result = step(action)
        endings.append((result[2], result[3]))
        return result

    learner._env.step = noting  # type: ignore[method-assign] # pyright: ignore
    model.learning_starts = 10**9
    model.learn(900)
    learner._env.close()  # pyright: ignore[reportPrivateUsage]
    buffer = model.replay_buffer
    assert any(truncated for _, truncated in endings)
    for i, (terminated, truncated) in enumerate(endings):
        assert bool(buffer.dones[i, 0]) == (terminated or truncated)
        assert bool(buffer.timeouts[i, 0]) == truncated
    # What the Bellman target is multiplied by: zero after a crash only.
    sampled = buffer._get_samples(np.arange(len(endings)))
    assert sampled.dones.flatten().tolist() == [float(terminated) for terminated, _ in endings]


def test_ppo_adds_the_discounted_value_of_the_last_state_where_a_drive_was_truncated(tmp_path: Path) -> None:
    import torch

    learner = training._Learner(tmp_path, settings("ppo"))  # pyright: ignore[reportPrivateUsage]
    model: Any = learner.model
    with torch.no_grad():  # a critic that says 7 whatever it sees
        model.policy.value_net.weight.zero_()
        model.policy.value_net.bias.fill_(7.0)
    rewards: list[float] = []
    endings: list[tuple[bool, bool]] = []
    step, model.n_epochs = learner._env.step, 0  # pyright: ignore[reportPrivateUsage]

    def noting(action: Any) -> Any:
        observation, reward, terminated, _, info = step(action)
        truncated = len(rewards) % 10 == 9 and not terminated
        rewards.append(reward)
        endings.append((terminated, truncated))
        return observation, reward, terminated, truncated, info

    learner._env.step = noting  # type: ignore[method-assign] # pyright: ignore
    env, callback = model.get_env(), None
    _, callback = model._setup_learn(40, callback)
    model.collect_rollouts(env, callback, model.rollout_buffer, n_rollout_steps=40)
    learner._env.close()  # pyright: ignore[reportPrivateUsage]
    stored = model.rollout_buffer.rewards.flatten().tolist()
    expected = [r + (0.99 * 7.0 if truncated else 0.0) for r, (_, truncated) in zip(rewards, endings, strict=True)]
    assert stored == pytest.approx(expected, rel=1e-5)
    assert sum(truncated for _, truncated in endings) >= 3


def faring(monkeypatch: pytest.MonkeyPatch, *rounds: tuple[OrdinaryDrive, ...]) -> None:
    """Evaluations that come out so, round by round."""
    results = iter([OrdinaryResult(ego="e", drives=drives, rejected=0) for drives in rounds])

    def evaluated(*_: object, **__: object) -> OrdinaryResult:
        return next(results)

    monkeypatch.setattr(training, "drive_ordinary", evaluated)


def driven(*off_road: float, speed: float = 5.0, collided: bool = False) -> tuple[OrdinaryDrive, ...]:
    return tuple(
        OrdinaryDrive(course=i, completion=1.0, speed=speed, off_road=share, collided=collided)
        for i, share in enumerate(off_road)
    )


def test_who_leaves_the_road_for_a_moment_in_every_drive_is_not_the_best(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    slow_but_on_it = (OrdinaryDrive(course=0, completion=0.5, speed=2.0, off_road=0.0, collided=False),)
    faring(monkeypatch, driven(0.01, 0.02), slow_but_on_it)
    trained = train(tmp_path / "t", settings("ppo"), progress=silent)
    assert trained.best == trained.curve[1]
    assert [row["off_road_rate"] for row in trained.curve] == [1.0, 0.0]
    assert load_network(tmp_path / "t" / "policy.npz")[1]["evaluation_steps"] == 80


def test_a_later_round_is_weighed_against_the_policy_that_is_kept_though_another_rule_kept_it(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    faring(monkeypatch, driven(0.0, 0.3), driven(0.0, 0.0))

    def earlier(row: dict[str, float], _: float) -> float:  # which keeps the first, whatever it does
        return -row["steps"]

    with monkeypatch.context() as patch:
        patch.setattr(training, "_worth", earlier)
        assert train(tmp_path / "t", settings("ppo"), progress=silent).best["steps"] == 40
    faring(monkeypatch, driven(0.0, 0.01))
    on = train(tmp_path / "t", settings("ppo", steps=120), progress=silent)
    assert on.best == on.curve[0]  # as good by the share of drives; the second, better than both, is not kept any more
    assert load_network(tmp_path / "t" / "policy.npz")[1]["evaluation_steps"] == 40


def test_an_ego_that_is_trained_for_a_speed_sees_how_fast_it_may_drive_and_says_what_it_was_trained_for(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[float | None] = []

    def evaluated(*_: object, speed: float | None, **__: object) -> OrdinaryResult:
        asked.append(speed)
        return OrdinaryResult(ego="e", drives=driven(0.0), rejected=0)

    monkeypatch.setattr(training, "drive_ordinary", evaluated)
    command = ["train", "--algorithm", "ppo", "--steps", "40", "--round", "40", "--out", str(tmp_path / "t")]
    CliRunner().invoke(main, [*command, "--speed", "road"], catch_exceptions=False)
    about = load_network(tmp_path / "t" / "policy.npz")[1]
    assert {name: about[name] for name in ("observation", "pedals", "speed")} == {
        "observation": "traffic", "pedals": "full-brake", "speed": 110.0
    }  # fmt: skip
    assert asked == [pytest.approx(110 / 3.6)]
    ego: Any = load_ego(str(tmp_path / "t" / "policy.npz"))
    assert ego.trained_for == pytest.approx(110 / 3.6)
    assert wanting(ego, 20.0).at_most == 20.0  # type: ignore[attr-defined] # pyright: ignore[reportAttributeAccessIssue]


def test_the_environment_of_a_training_for_a_speed_wants_that_speed(tmp_path: Path) -> None:
    chosen = settings("ppo", observation="traffic", speed=50.0)
    with patch.object(driving_env, "DrivingEnv", wraps=driving_env.DrivingEnv) as made:
        training._Learner(tmp_path, chosen)  # pyright: ignore[reportPrivateUsage]
    assert made.call_args.kwargs["speed"] == 50.0


def test_who_is_trained_for_a_speed_is_the_better_the_swifter_up_to_that_speed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    faring(monkeypatch, driven(0.0, speed=9.0), driven(0.0, speed=12.0), driven(0.0, speed=14.0))
    chosen = settings("ppo", observation="traffic", speed=43.2, steps=120)
    assert train(tmp_path / "t", chosen, progress=silent).best["mean_speed"] == 12.0


def test_a_training_without_a_speed_is_recorded_as_before_there_were_any(tmp_path: Path) -> None:
    train(tmp_path / "t", settings("ppo", steps=40), progress=silent)
    assert "speed" not in runs.read_record(runs.Workspace(tmp_path / "t"), runs.TrainingRecord).settings


def test_steps_that_are_rounded_up_are_told(tmp_path: Path) -> None:
    command = ["train", "--algorithm", "ppo", "--steps", "50", "--round", "40", "--out", str(tmp_path / "t")]
    told = CliRunner().invoke(main, command, catch_exceptions=False)
    assert "80 steps instead of 50: whole rounds of 40" in told.output


def test_the_table_of_a_training_has_units(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    faring(monkeypatch, driven(0.5, 0.1, 0.0, 0.0, speed=22.5))
    command = ["train", "--algorithm", "ppo", "--steps", "40", "--round", "40", "--out", str(tmp_path / "t")]
    told = CliRunner().invoke(main, command, catch_exceptions=False).output
    assert re.search(r"40 +100\.0% +0\.0% +50\.0% +15\.0% +22\.50  kept", told)
    assert "it leaves the road in 50% of its drives: it has not learned to drive yet" in told
    assert "[m/s]" in told


def test_progress_is_what_a_training_and_an_environment_pay_for_where_nothing_is_said() -> None:
    assert TrainSettings().reward == "progress"
    assert FinetuneSettings().reward == "safebench"  # the paper's
    for made in (driving_env.DrivingEnv.__init__, chatscene.gym.make_drive, chatscene.gym.make_scene):
        assert signature(made).parameters["reward"].default == "progress"
    assert signature(chatscene.DrivenScene.env).parameters["reward"].default == "progress"


def test_another_training_in_the_folder_is_not_continued(tmp_path: Path) -> None:
    train(tmp_path / "t", settings("ppo", steps=40), progress=silent)
    with pytest.raises(RunError, match="other settings"):
        train(tmp_path / "t", settings("ppo", steps=40, seed=4), progress=silent)
    (tmp_path / "x").mkdir()
    (tmp_path / "x" / "letter.txt").write_text("dear all")
    with pytest.raises(RunError, match="is not empty"):
        train(tmp_path / "x", settings("ppo", steps=40), progress=silent)


def test_a_damaged_checkpoint_is_said_to_be_one(tmp_path: Path) -> None:
    train(tmp_path / "t", settings("ppo", steps=40), progress=silent)
    (tmp_path / "t" / "checkpoint.npz").write_bytes(b"not a checkpoint")
    with pytest.raises(RunError, match=r"checkpoint\.npz is damaged"):
        train(tmp_path / "t", settings("ppo", steps=80), progress=silent)
    runs.update(runs.Workspace(tmp_path / "t"), files={})  # of an unfinished training there are no digests
    with pytest.raises(RunError, match="cannot read"):
        train(tmp_path / "t", settings("ppo", steps=80), progress=silent)


def test_settings_that_cannot_be_are_refused() -> None:
    with pytest.raises(SettingsError, match="no algorithm 'dqn'"):
        TrainSettings(algorithm="dqn")
    with pytest.raises(SettingsError, match="longer than a training"):
        TrainSettings(steps=10, round=20)
    with pytest.raises(SettingsError, match="multiple"):
        TrainSettings(algorithm="ppo", steps=2000, round=1500)
    with pytest.raises(SettingsError, match="'actors' does not know how fast it may drive"):
        TrainSettings(observation="actors", speed=50.0)
    with pytest.raises(SettingsError, match=r"speed must be a number from 0\.0 to 300"):
        TrainSettings(observation="traffic", speed=-1.0)
