import math
from collections.abc import Sequence
from itertools import product

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.stats import binomtest

from chatscene.errors import SettingsError
from chatscene.measure.intervals import METRICS, bootstrap, percentiles, resample, resample_means, resample_scores
from chatscene.measure.score import score, wilson
from chatscene.terms.metrics import Measurements, Mode

few = settings(max_examples=25)

anything = st.builds(
    Measurements,
    collided=st.booleans(), red_lights=st.integers(0, 5), stop_signs=st.integers(0, 5),
    off_road=st.floats(0, 200), distance_to_route=st.floats(0, 30), completion=st.floats(0, 1),
    time=st.none() | st.floats(0, 100), acceleration=st.floats(0, 50), yaw_rate=st.floats(0, 50),
    yaw_rate_unwrapped=st.floats(0, 50), lane_invasions=st.integers(0, 100), duration=st.floats(0.1, 60),
)  # fmt: skip
routes = st.lists(
    st.lists(st.tuples(st.sampled_from(["ppo", "sac", "td3"]), anything), min_size=1, max_size=4),
    min_size=1,
    max_size=4,
)


def mean(values: Sequence[float]) -> float:
    return math.fsum(values) / len(values)


def test_the_bootstrap_is_the_same_for_the_same_seed_and_only_then() -> None:
    groups = [[float(k), k + 0.5] for k in range(8)]
    first = bootstrap(groups, mean, seed=3)
    assert first == bootstrap(groups, mean, seed=3)
    assert first != bootstrap(groups, mean, seed=4)


def test_whole_groups_are_drawn() -> None:
    """Of two groups of two, a draw has both of one, or one each of both: never one and three."""
    drawn = resample([["a", "a"], ["b", "b"]], lambda s: float([*s].count("a")), seed=0, draws=200)
    assert {*drawn.tolist()} == {0.0, 2.0, 4.0}
    assert np.mean(drawn == 2.0) == pytest.approx(0.5, abs=0.1)


@pytest.mark.parametrize("groups", [[[1.0, 2.0]], [[float(k)] for k in range(4)], [[1.0]] * 10])
def test_too_few_groups_or_groups_alike_give_no_interval(groups: list[list[float]]) -> None:
    assert all(math.isnan(end) for end in bootstrap(groups, mean, seed=0))


def test_a_base_scenario_with_one_route_leaves_the_average_without_an_interval() -> None:
    values = np.linspace(0.0, 1.0, 100)
    assert math.isnan(percentiles(values, [10, 1])[0])
    assert not math.isnan(percentiles(values, [2, 2, 2, 2])[0])


@pytest.mark.parametrize("groups", [[], [[]], [[1.0], []]])
def test_nothing_cannot_be_resampled(groups: list[list[float]]) -> None:
    with pytest.raises(SettingsError, match="nothing to resample"):
        bootstrap(groups, mean, seed=0)


def test_the_interval_of_a_mean_is_that_of_student_for_many_draws() -> None:
    """Ten groups: the mean is 4.5, its standard error 0.957, t with 9 degrees of freedom 2.262."""
    low, high = bootstrap([[float(k)] for k in range(10)], mean, seed=0, draws=20_000)
    assert (low, high) == pytest.approx((4.5 - 2.262 * 0.957, 4.5 + 2.262 * 0.957), abs=0.1)


@few
@given(
    st.lists(
        st.dictionaries(st.sampled_from("abc"), st.lists(st.floats(0.0, 100.0), min_size=1), min_size=1), min_size=1
    )
)
def test_resampled_means_are_means_of_resampled_groups(groups: list[dict[str, list[float]]]) -> None:
    def statistic(some: Sequence[tuple[str, float]]) -> float:
        sets = [[value for of, value in some if of == ego] for ego in "abc"]
        return mean([mean(own) for own in sets if own])

    drives = [[(ego, value) for ego, own in group.items() for value in own] for group in groups]
    assert resample_means(groups, seed=1, draws=20).tolist() == resample(drives, statistic, seed=1, draws=20).tolist()


def test_the_percentiles_of_five_routes_are_taken_out_by_the_table_of_student() -> None:
    """t with 4 degrees of freedom is 2.7764 in every table; the tail is Φ(-√(5/4) 2.7764)."""
    low, high = percentiles(np.linspace(0.0, 1.0, 1_000_001), [5])
    assert (low, 1 - high) == pytest.approx((0.000954, 0.000954), abs=1e-6)


def test_more_confidence_is_a_wider_interval() -> None:
    groups = [[float(k)] for k in range(10)]
    narrow = bootstrap(groups, mean, seed=0, level=0.8)
    wide = bootstrap(groups, mean, seed=0)
    assert wide[0] < narrow[0] < narrow[1] < wide[1]


def test_the_interval_covers_as_often_as_it_says() -> None:
    """Ten groups of ten with a common part, as routes have: the plain interval of all hundred would cover half."""
    rng = np.random.default_rng(5)
    held = 0
    for case in range(400):
        groups = rng.normal(size=(10, 1)) + rng.normal(scale=0.5, size=(10, 10))
        drawn = resample(groups.mean(axis=1, keepdims=True).tolist(), mean, seed=case, draws=300)
        low, high = percentiles(drawn, [10])
        held += low <= 0.0 <= high
    assert 0.91 <= held / 400 <= 0.98


@few
@given(routes, st.sampled_from(list(Mode)))
def test_resampled_scores_are_scores_of_resampled_routes(
    drives: list[list[tuple[str, Measurements]]], mode: Mode
) -> None:
    def one_by_one(name: str) -> list[float]:
        def statistic(some: Sequence[tuple[str, Measurements]]) -> float:
            sets = [[m for of, m in some if of == ego] for ego in ("ppo", "sac", "td3")]
            return mean([getattr(score(own, mode=mode), name) for own in sets if own])

        return resample(drives, statistic, seed=1, draws=20).tolist()

    fast = resample_scores(drives, mode, seed=1, draws=20)
    assert list(fast) == [*METRICS, "overall_score"]
    for name, values in fast.items():
        assert values.tolist() == pytest.approx(one_by_one(name), abs=1e-9)


@pytest.mark.parametrize(
    ("successes", "trials", "low", "high"),
    [  # Newcombe (1998), Statistics in Medicine 17, 857-872, table I, method 3
        (81, 263, 0.2553, 0.3662),
        (15, 148, 0.0624, 0.1605),
        (0, 20, 0.0, 0.1611),
        (1, 29, 0.0061, 0.1718),
    ],
)
def test_the_wilson_interval_is_the_published_one(successes: int, trials: int, low: float, high: float) -> None:
    assert wilson(successes, trials) == pytest.approx((low, high), abs=5e-5)


@given(st.integers(1, 500), st.floats(0, 1))
def test_the_wilson_interval_is_that_of_scipy(trials: int, share: float) -> None:
    successes = round(share * trials)
    theirs = binomtest(successes, trials).proportion_ci(0.95, "wilson")
    assert wilson(successes, trials) == pytest.approx((theirs.low, theirs.high), abs=1e-8)


def test_wilson_holds_a_mean_rate_that_is_no_whole_count() -> None:
    """The tables round the mean rate over egos to a count; the rate must stay inside."""
    for trials, share in product(range(1, 60), np.linspace(0.0, 1.0, 101).tolist()):
        low, high = wilson(round(share * trials), trials)
        assert low <= share <= high
