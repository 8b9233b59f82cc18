"""Our environments by their ids, as Gymnasium makes them."""

from __future__ import annotations

import subprocess
import sys
import warnings
from typing import Any

import numpy as np
import pytest

pytest.importorskip("gymnasium", reason="the extra 'gym' is not installed")

import gymnasium
from gymnasium.envs.registration import EnvSpec
from gymnasium.utils.env_checker import check_env

import chatscene.gym
from chatscene.errors import NothingFits

IDS: dict[str, dict[str, Any]] = {
    "chatscene/Scene-v0": {"text": "A delivery van ahead of us brakes hard on a straight road."},
    "chatscene/Drive-v0": {"ego_observation": "actors"},
}
every_id = pytest.mark.parametrize("name", IDS)


def driven(env: Any, seed: int) -> tuple[dict[str, float], list[list[float]]]:
    """The scene of an episode, and what is seen in its first steps."""
    seen, info = env.reset(seed=seed)
    action = np.array((0.5, 0.0), np.float32)
    return info["values"], [seen.tolist(), *(env.step(action)[0].tolist() for _ in range(10))]


@every_id
def test_gymnasium_finds_nothing_wrong_and_warns_of_nothing(name: str) -> None:
    env = gymnasium.make(name, render_mode="rgb_array", **IDS[name])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env.unwrapped)
    env.close()


@every_id
def test_the_same_seed_gives_the_same_episode_and_another_one_another(name: str) -> None:
    env = gymnasium.make(name, **IDS[name])
    assert driven(env, 3) == driven(env, 3) != driven(env, 4)
    env.close()


@every_id
def test_an_environment_is_made_again_from_its_spec(name: str) -> None:
    env = gymnasium.make(name, **IDS[name])
    assert env.spec is not None
    first = driven(env, 3)
    env.close()
    again = gymnasium.make(EnvSpec.from_json(env.spec.to_json()))
    assert driven(again, 3) == first
    again.close()


def test_a_sentence_that_nothing_serves_is_refused() -> None:
    with pytest.raises(NothingFits):
        gymnasium.make("chatscene/Scene-v0", text="A helicopter lands on our roof.")


def test_an_id_can_name_the_module_that_knows_it_and_nothing_that_learns_is_needed() -> None:
    code = (
        "import gymnasium, sys\n"
        "env = gymnasium.make('chatscene.gym:chatscene/Drive-v0')\n"
        "env.reset(seed=0)\n"
        "print(env.step(env.action_space.sample())[0].shape, {'torch', 'stable_baselines3'} & {*sys.modules})"
    )
    told = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert told.stdout == "(4,) set()\n"


def test_the_ids_are_those_of_the_package() -> None:
    assert {name for name in gymnasium.registry if name.startswith("chatscene/")} == set(IDS)
    assert chatscene.gym.__doc__ is not None
    assert all(name in chatscene.gym.__doc__ for name in IDS)


@every_id
def test_an_environment_has_the_physics_that_is_asked_for(name: str) -> None:
    kinematic, lagged = (
        driven(gymnasium.make(name, physics=physics, **IDS[name]).unwrapped, seed=3)
        for physics in ("kinematic", "lagged")
    )
    assert kinematic[0] == lagged[0]
    assert kinematic[1] != lagged[1]
