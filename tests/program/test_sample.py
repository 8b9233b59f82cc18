import hashlib
import json
import random

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from chatscene.program.sample import draw, scene_seed
from chatscene.terms.snippet import ParameterRange

SPEED = ParameterRange(name="OPT_ADV_SPEED", low=0.0, high=5.0, unit="m/s")
GAP = ParameterRange(name="OPT_ADV_DISTANCE", low=2.0, high=15.0, unit="m")

few = settings(max_examples=60)
seeds = st.integers(0, 2**32 - 1)


@few
@given(st.floats(-50, 50), st.floats(0, 30), seeds)
def test_a_drawn_value_lies_in_its_range(low: float, width: float, seed: int) -> None:
    declared = ParameterRange(name="OPT_X", low=low, high=low + width, unit="m")
    assert declared.low <= draw([declared], seed=seed)["OPT_X"] <= declared.high


@few
@given(seeds)
def test_drawn_values_survive_being_written_as_text(seed: int) -> None:
    values = draw([SPEED, GAP], seed=seed)
    assert json.loads(json.dumps(values)) == values
    assert {name: float(f"{value:.6f}") for name, value in values.items()} == values


@few
@given(seeds)
def test_a_parameter_keeps_its_value_when_another_is_added(seed: int) -> None:
    assert draw([SPEED], seed=seed)["OPT_ADV_SPEED"] == draw([GAP, SPEED], seed=seed)["OPT_ADV_SPEED"]


def test_parameters_are_drawn_independently_and_uniformly() -> None:
    drawn = np.array([list(draw([SPEED, GAP], seed=seed).values()) for seed in range(2000)])
    assert np.allclose(drawn.mean(axis=0), [2.5, 8.5], atol=0.3)
    assert np.allclose(drawn.std(axis=0), [5 / 12**0.5, 13 / 12**0.5], atol=0.2)
    assert abs(np.corrcoef(drawn.T)[0, 1]) < 0.08


def test_drawing_leaves_the_global_generators_alone() -> None:
    random.seed(3)
    before = random.getstate()
    draw([SPEED], seed=1)
    assert random.getstate() == before


def test_the_same_seed_draws_the_same_values_on_every_machine() -> None:
    assert draw([SPEED, GAP], seed=7) == {"OPT_ADV_SPEED": 4.005679, "OPT_ADV_DISTANCE": 4.016404}


def test_scenes_have_seeds_of_their_own() -> None:
    names = [f"{scenario}/route-{r:02d}/scene-{n:03d}" for scenario in "ab" for r in range(10) for n in range(50)]
    seeds = {scene_seed(run, name) for run in (0, 1) for name in names}
    assert len(seeds) == 2 * len(names)
    assert all(0 <= seed < 2**32 for seed in seeds)


def test_the_seed_of_a_scene_follows_from_the_run_and_its_id_alone() -> None:
    assert scene_seed(0, "a/route-00/scene-000") == 2668571515


@pytest.mark.parametrize("seed", [0, 1, 2**32 - 1, 2**32, 2**63 - 1])
def test_values_are_those_that_numpy_draws_by_the_two_numbers_of_a_stream(seed: int) -> None:
    stream = int.from_bytes(hashlib.blake2b(b"OPT_X", digest_size=4).digest(), "big")
    (value,) = draw([ParameterRange(name="OPT_X", low=0.0, high=1.0, unit="1")], seed=seed).values()
    assert value == round(float(np.random.default_rng((seed, stream)).random()), 6)
