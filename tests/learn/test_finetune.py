"""Fine-tuning: what is learned from, which checkpoint is kept, that no test scene is trained on, and that a cut ends
where an uncut one does.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any
from unittest.mock import Mock

import numpy as np
import pytest
from click.testing import CliRunner
from hypothesis import given
from hypothesis import strategies as st

pytest.importorskip("stable_baselines3", reason="the extra 'train' is not installed")

import torch
from gymnasium import spaces

import chatscene as api
from chatscene import pipeline, runs
from chatscene.commands.learn import finetune as command
from chatscene.ego.network import load_network
from chatscene.ego.planner import ACCELERATION, Caution, Planner, carried_out
from chatscene.ego.policy import EgoPolicy, load_ego
from chatscene.ego.trained import sac
from chatscene.errors import EgoError, RunError, SettingsError
from chatscene.learn import finetune as finetuning
from chatscene.learn.env import DrivingEnv
from chatscene.learn.finetune import PRESETS, Finetuned, FinetuneSettings, choose, finetune
from chatscene.learn.finetune import pupil as learning
from chatscene.learn.finetune.buffer import SplitBuffer
from chatscene.learn.finetune.learner import Learner, Schedule
from chatscene.learn.finetune.pupil import Pupil
from chatscene.learn.finetune.scenes import KeptScene, Lessons, kept_scenes, split
from chatscene.measure.ordinary import OrdinaryDrive, OrdinaryResult
from chatscene.program.ordinary import Course
from chatscene.settings import SearchSettings, Settings
from chatscene.simulate.simulator import Simulator, simulate
from chatscene.terms.scene import Rejected, Scene, ScenicProgram
from plainly import STOPS

pytestmark = [
    pytest.mark.filterwarnings("ignore::DeprecationWarning"),
    pytest.mark.filterwarnings("ignore::FutureWarning"),
    pytest.mark.filterwarnings("ignore::UserWarning"),
]
PROGRAM = ScenicProgram(scenario_id="s", source="", parameters=(), snippet_ids=())


def silent(_what: str, _done: int, _total: int) -> None:
    pass


class TestBuffer:
    @staticmethod
    def filled(ordinary: int, crashes: int, *, capacity: int = 200) -> SplitBuffer:
        """Ordinary transitions see 0, 1, 2, ...; those with a collision see -1, -2, -3, ..."""
        box = spaces.Box(-1e6, 1e6, (1,), np.float32)
        buffer = SplitBuffer(1000, box, box, collisions=capacity)
        for count, sign, collision in ((ordinary, 1.0, False), (crashes, -1.0, True)):
            for i in range(count):
                seen = np.array([sign * (i + (sign < 0))], np.float32)
                info = {"collision": collision, "TimeLimit.truncated": not collision}
                buffer.add(seen, seen, np.zeros(1, np.float32), np.zeros(1), np.ones(1), [info])
        return buffer

    @pytest.mark.parametrize(("crashes", "expected"), [(0, 0), (1, 1), (101, 101), (102, 102), (150, 102)])
    def test_a_batch_has_one_in_five_from_collisions_or_all_there_are(self, crashes: int, expected: int) -> None:
        seen = self.filled(900, crashes).sample(512).observations.flatten()
        assert len(seen) == 512
        assert int((seen < 0).sum()) == expected
        assert len(set(seen.tolist())) == 512

    def test_only_collisions_end_what_is_to_come(self) -> None:
        batch = self.filled(900, 50).sample(512)
        assert torch.equal(batch.dones, (batch.observations < 0).float())

    def test_the_collision_buffer_keeps_exactly_the_latest_collisions(self) -> None:
        buffer = self.filled(30, 230)
        assert sorted((-buffer.crashes.observations.flatten()).astype(int).tolist()) == list(range(31, 231))
        assert (buffer.size(), buffer.transitions) == (30, 230)
        assert (buffer.observations[:30] >= 0).all()

    def test_batches_are_the_same_for_a_seed_and_after_being_stored(self) -> None:
        first, second = self.filled(900, 50), self.filled(0, 0)
        second.restore(first.stored())
        for buffer in (first, second):
            buffer.seed(5)
        assert torch.equal(first.sample(64).observations, second.sample(64).observations)


def row(episode: int, collision_rate: float, completion: float, overall_score: float = 0.5) -> dict[str, Any]:
    return {
        "episode": episode,
        "collision_rate": collision_rate,
        "completion": completion,
        "overall_score": overall_score,
    }


class TestChoice:
    def test_the_lowest_collision_rate_with_enough_completion_is_kept(self) -> None:
        curve = [{"episode": 50}, row(100, 0.4, 0.9), row(150, 0.2, 0.5), row(200, 0.0, 0.3), row(250, 0.0, 0.1)]
        assert choose(curve)[0]["episode"] == 150

    def test_of_equal_ones_the_higher_score_is_kept_and_then_the_earlier(self) -> None:
        curve = [row(100, 0.2, 0.9, 0.6), row(150, 0.2, 0.4, 0.7), row(200, 0.2, 0.9, 0.7)]
        assert choose(curve)[0]["episode"] == 150

    def test_where_all_stand_still_the_one_that_goes_farthest_is_kept_and_said_to_be(self) -> None:
        chosen, reason = choose([row(100, 0.0, 0.01), row(150, 0.3, 0.29), row(200, 0.1, 0.29)])
        assert chosen["episode"] == 200
        assert "no checkpoint completes more than 0.3" in reason

    def test_without_figures_there_is_no_choice(self) -> None:
        with pytest.raises(RunError, match="no checkpoint has figures"):
            choose([{"episode": 50}, {"episode": 100}])


def kept(route: int, number: int = 0) -> KeptScene:
    scene = Scene(id=f"s/{route}/{number}", scenario_id="s", route=route, block=0, seed=0, values={})
    return KeptScene(program=PROGRAM, scene=scene)


class TestSplit:
    @given(
        routes=st.lists(st.integers(0, 11), min_size=1, max_size=30),
        train=st.integers(2, 9),
        data=st.data(),
        choice=st.sampled_from(["paper", "held-out"]),
    )
    def test_no_route_that_chooses_or_tests_is_trained_on(
        self, routes: list[int], train: int, data: st.DataObject, choice: str
    ) -> None:
        validation = data.draw(st.integers(1, train - 1))
        scenes = [kept(route, i) for i, route in enumerate(routes)]
        try:
            parts = split(scenes, choice=choice, train_routes=train, validation_routes=validation)
        except RunError:
            return
        of = {name: {k.scene.route for k in part} for name, part in parts.items()}
        assert not of["train"] & (of["choice"] | of["test"])
        assert all(route >= train for route in of["test"])
        assert (of["choice"] == of["test"]) if choice == "paper" else not of["choice"] & of["test"]
        assert {k.scene.id for part in parts.values() for k in part} == {k.scene.id for k in scenes}

    def test_the_paper_trains_on_eight_routes_and_holding_out_takes_two_of_them(self) -> None:
        scenes = [kept(route) for route in range(10)]
        for choice, expected in (("paper", (8, 2, 2)), ("held-out", (6, 2, 2))):
            parts = split(scenes, choice=choice, train_routes=8, validation_routes=2)
            assert tuple(len(parts[name]) for name in ("train", "choice", "test")) == expected

    def test_a_part_without_scenes_is_said_with_what_to_do(self) -> None:
        with pytest.raises(RunError, match=r"route from 8 .*--routes 10"):
            split([kept(0)], choice="paper", train_routes=8, validation_routes=2)


class TestSchedule:
    def test_every_scene_is_driven_about_equally_often_and_ordinary_drives_are_spread_evenly(self) -> None:
        scenes = tuple(kept(0, i) for i in range(7))
        ordinary = tuple(Course(program=PROGRAM, route=i) for i in range(3))
        schedule = Schedule(scenes=scenes, ordinary=ordinary, share=0.25, seed=1)
        drawn = [schedule.options(i) for i in range(400)]
        counts = np.bincount([options["course"] for options in drawn], minlength=10)
        assert counts[:7].sum() == 300
        assert counts[:7].max() - counts[:7].min() <= 1
        assert counts[7:].tolist() in ([34, 33, 33], [33, 34, 33], [33, 33, 34])
        assert all(("values" in options) == (options["course"] < 7) for options in drawn)
        assert len(schedule.courses()) == 10


def test_presets_say_how_many_gradient_steps_follow_an_episode() -> None:
    assert FinetuneSettings(**PRESETS["paper"]).updates(80) == 80
    assert FinetuneSettings(**PRESETS["released"]).updates(80) == 1
    assert FinetuneSettings(updates_per_step=0.25).updates(80) == 20


def test_settings_that_cannot_be_are_refused() -> None:
    with pytest.raises(SettingsError, match="no choice 'best'"):
        FinetuneSettings(choice="best")
    with pytest.raises(SettingsError, match="episodes must be at least 1"):
        FinetuneSettings(episodes=0)
    with pytest.raises(SettingsError, match="ordinary_share"):
        FinetuneSettings(ordinary_share=1.0)
    with pytest.raises(SettingsError, match="cannot be held out"):
        FinetuneSettings(choice="held-out", train_routes=2)


TINY = FinetuneSettings(
    train_routes=1,
    episodes=6,
    round=2,
    first_choice=4,
    updates_per_step=0.05,
    batch=32,
    learning_starts=40,
    warm_up_steps=50,
    critic_steps=20,
    ordinary_share=0.25,
    seed=3,
)


@pytest.fixture(scope="module")
def scenes(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A small run on two routes."""
    folder = tmp_path_factory.mktemp("runs") / "stops"
    pipeline.run(runs.asked_run(STOPS, ego="sac", settings=Settings(search=SearchSettings(scenes=4, routes=2))), folder)
    return folder


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ordinary drives that take no time."""

    def driven(ego: Any, simulator: Simulator, *, scenes: int, seed: int) -> OrdinaryResult:
        one = OrdinaryDrive(course=0, completion=0.5, speed=5.0, off_road=0.0, collided=False)
        return OrdinaryResult(ego="e", drives=(one,), rejected=0)

    monkeypatch.setattr(finetuning, "drive_ordinary", driven)


def learner(lessons: Lessons, **changes: Any) -> Learner:
    schedule = Schedule(scenes=lessons.scenes, ordinary=(), share=0.0, seed=0)
    return Learner(sac(), replace(TINY, **changes), schedule, lessons.map_name, lessons.simulation)


def test_the_actor_is_the_egos_own_and_does_not_change_while_the_critics_warm_up(scenes: Path) -> None:
    one, own = learner(kept_scenes([scenes])), sac()
    critics = {name: tensor.clone() for name, tensor in one.model.critic.state_dict().items()}
    actor = {name: tensor.clone() for name, tensor in one.model.actor.state_dict().items()}
    one.warm_up()
    assert all(torch.equal(tensor, actor[name]) for name, tensor in one.model.actor.state_dict().items())
    assert not all(torch.equal(tensor, critics[name]) for name, tensor in one.model.critic.state_dict().items())
    assert one.buffer.transitions == 0
    ego = one.ego()
    for observation in np.random.default_rng(0).normal(size=(20, 4)):
        assert ego.act(observation) == own.act(observation)


def test_warmed_up_critics_tell_a_crash_that_is_near_from_one_that_is_far(scenes: Path) -> None:
    one = learner(kept_scenes([scenes]), warm_up_steps=200, critic_steps=200, batch=64)
    assert one.warm_up()["explained"] > 0.5


def test_a_drive_leaves_one_transition_in_the_collision_buffer_if_it_ends_in_one(scenes: Path) -> None:
    one = learner(kept_scenes([scenes]), updates_per_step=0.0)
    collisions = one.learn(0, range(4))
    assert one.buffer.crashes.size() == collisions > 0
    assert one.buffer.transitions == one.steps
    assert one.updates == 0
    assert not one.buffer.dones[: one.buffer.size()].any() or collisions < 4


class Slow:
    """A teacher that keeps to 4 m/s and steers against its offset."""

    name = "slow"
    observation = "safebench"
    pedals = "full-brake"

    def act(self, observation: Any) -> tuple[float, float]:
        return float(np.clip(0.5 * (4.0 - observation[2]), -1, 1)), float(np.clip(0.2 * observation[0], -1, 1))


def test_a_pupil_does_as_its_teacher_would_where_it_has_been(scenes: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    lessons = kept_scenes([scenes])
    schedule = Schedule(scenes=lessons.scenes, ordinary=(), share=0.0, seed=0)
    monkeypatch.setattr(learning, "STEPS", 400)
    monkeypatch.setattr(learning, "HIDDEN", 64)
    one = Pupil(Slow(), TINY, schedule, lessons.map_name, lessons.simulation)
    for number in range(2):
        one.learn(number, range(2 * number, 2 * number + 2))
    ego = one.ego()
    assert (ego.observation, ego.pedals) == ("safebench", "full-brake")
    for speed in (3.0, 4.0, 5.0):
        observation = np.array([0.1, 0.0, speed, 0.0])
        assert ego.act(observation) == pytest.approx(Slow().act(observation), abs=0.1)


def test_of_two_ways_a_pupil_takes_one_and_not_their_mean(scenes: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    lessons = kept_scenes([scenes])
    schedule = Schedule(scenes=lessons.scenes, ordinary=(), share=0.0, seed=0)
    monkeypatch.setattr(learning, "STEPS", 300)
    monkeypatch.setattr(learning, "HIDDEN", 128)
    teacher = Planner(Caution(speed=5.5))
    one = Pupil(teacher, TINY, schedule, lessons.map_name, lessons.simulation)
    one.learn(0, range(2))
    ego, seen = one.ego(), one._seen.numpy().astype(np.float64)  # pyright: ignore[reportPrivateUsage]
    assert (ego.network.output, ego.network.at_most) == ("ways", 5.5)
    taken = [ego.act(observation) for observation in seen]
    offered = [[carried_out(observation, way, 5.5) for way in range(len(ACCELERATION))] for observation in seen]
    assert all(action in actions for action, actions in zip(taken, offered, strict=True))
    same = np.mean([action == teacher.act(observation) for action, observation in zip(taken, seen, strict=True)])
    assert same > 0.5


def test_a_pupil_drives_itself_once_it_has_been_led(scenes: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    lessons = kept_scenes([scenes])
    schedule = Schedule(scenes=lessons.scenes, ordinary=(), share=0.0, seed=0)
    monkeypatch.setattr(learning, "STEPS", 1)
    monkeypatch.setattr(learning, "NOISE", np.zeros(2))
    driven: list[Any] = []
    step = DrivingEnv.step

    def told(self: DrivingEnv, action: Any) -> Any:
        driven.append(action)
        return step(self, action)

    monkeypatch.setattr(DrivingEnv, "step", told)
    one = Pupil(Slow(), TINY, schedule, lessons.map_name, lessons.simulation)
    one.learn(0, range(1))
    assert all(np.allclose(a, t, atol=1e-6) for a, t in zip(driven, one._shown.numpy(), strict=True))  # pyright: ignore[reportPrivateUsage]
    one.learn(1, range(1, 2))
    led = one.steps - len(driven)
    assert led == 0
    assert not np.allclose(driven[-1], one._shown.numpy()[-1], atol=1e-3)  # pyright: ignore[reportPrivateUsage]


@pytest.mark.usefixtures("quick")
class TestWhole:
    @pytest.mark.parametrize("taught", [False, True])
    def test_it_ends_in_an_ego_with_figures_before_and_after_whether_it_was_cut_or_not(
        self, taught: bool, scenes: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        settings, kind = (replace(TINY, teacher="rule-based"), Pupil) if taught else (TINY, Learner)
        monkeypatch.setattr(learning, "STEPS", 20)
        whole = finetune(tmp_path / "whole", [scenes], settings, progress=silent)
        learn: Any = kind.learn

        def killed(self: Any, number: int, episodes: range) -> int:
            if number == 2:
                raise KeyboardInterrupt
            return learn(self, number, episodes)

        with monkeypatch.context() as patch, pytest.raises(KeyboardInterrupt):
            patch.setattr(kind, "learn", killed)
            finetune(tmp_path / "cut", [scenes], settings, progress=silent)
        record = runs.read_record(runs.Workspace(tmp_path / "cut"), runs.FinetuningRecord)
        assert (record.status, len(record.curve)) == (runs.Status.RUNNING, 2)
        resumed = api.resume(tmp_path / "cut")
        assert isinstance(resumed, Finetuned)
        assert runs.check(tmp_path / "cut").whole
        assert [{**r, "seconds": 0} for r in resumed.curve] == [{**r, "seconds": 0} for r in whole.curve]
        paths = [tmp_path / name / "checkpoints" / "policy-0006.npz" for name in ("whole", "cut")]
        networks = [load_network(path)[0] for path in paths]
        for (w1, b1), (w2, b2) in zip(networks[0].layers, networks[1].layers, strict=True):
            assert np.array_equal(w1, w2)
            assert np.array_equal(b1, b2)
        own = sac().network
        assert not np.array_equal(networks[0].layers[0][0], own.layers[0][0])

        assert [row["episode"] for row in whole.curve] == [2, 4, 6]
        assert ["collision_rate" in row for row in whole.curve] == [False, True, True]
        assert whole.curve[-1]["updates"] > 0
        assert set(whole.before) == set(whole.after) == {"train", "choice", "test", "ordinary"}
        assert whole.before["train"]["collision_rate"] == 1.0
        assert whole.before["train"]["n"] == 2.0
        ego = load_ego(str(tmp_path / "whole" / "policy.npz"))
        assert len(tuple(ego.act(np.zeros(4)))) == 2
        assert [path.name for path in (tmp_path / "whole").glob("state-*.npz")] == ["state-0006.npz"]
        again = finetune(tmp_path / "whole", [scenes], settings, progress=silent)
        assert again == whole

        with pytest.raises(RunError, match="other settings"):
            finetune(tmp_path / "whole", [scenes], replace(settings, seed=4), progress=silent)
        runs.update(runs.Workspace(tmp_path / "cut"), chosen={}, after={}, files={})  # as if it was cut there
        (tmp_path / "cut" / "state-0006.npz").write_bytes(b"not a state")
        with pytest.raises(RunError, match="cannot read"):
            finetune(tmp_path / "cut", [scenes], settings, progress=silent)

    def test_a_scene_that_cannot_be_placed_is_skipped_with_its_reason(
        self, scenes: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
    ) -> None:
        lost = next(k.scene for k in kept_scenes([scenes]).scenes if k.scene.route == 0)
        judged = "chatscene.learn.finetune.scenes.simulate"

        def without_it(simulator: Simulator, program: ScenicProgram, scene: Scene, ego: EgoPolicy) -> Any:
            rejected = Rejected(scene=scene, reason="no room")
            return rejected if scene == lost else simulate(simulator, program, scene, ego)

        monkeypatch.setattr(judged, without_it)
        tuned = finetune(tmp_path / "t", [scenes], replace(TINY, episodes=2), progress=silent)
        assert tuned.skipped == {lost.id: "no room"}
        assert (tuned.before["train"]["n"], tuned.before["train"]["rejected"]) == (1.0, 1.0)

        def none(_simulator: Simulator, _program: ScenicProgram, scene: Scene, _ego: EgoPolicy) -> Any:
            return Rejected(scene=scene, reason="no room")

        monkeypatch.setattr(judged, none)
        with pytest.raises(RunError, match=r"none of the 2 training scenes .*no room.* search for them again"):
            finetune(tmp_path / "u", [scenes], TINY, progress=silent)

    def test_the_command_prints_before_and_after(self, scenes: Path, tmp_path: Path) -> None:
        out = tmp_path / "out"
        arguments = [str(scenes), "--out", str(out), "--episodes", "1", "--train-routes", "1", "--preset", "released"]
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(Learner, "warm_up", Mock(return_value={}))
            result = CliRunner().invoke(command, arguments, catch_exceptions=False)
        assert result.exit_code == 0
        for words in ("collision rate", "ordinary", "kept", "policy.npz"):
            assert words in result.output


def test_only_sac_can_be_fine_tuned(tmp_path: Path) -> None:
    for ego in ("td3", "ppo", "rule-based"):
        with pytest.raises(EgoError, match=r"not an SAC|not a network"):
            finetune(tmp_path / "t", [], replace(TINY, ego=ego), progress=silent)
    with pytest.raises(RunError, match="no run is named"):
        finetune(tmp_path / "t", [], TINY, progress=silent)
