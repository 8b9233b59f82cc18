from __future__ import annotations

import sys
from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import combinations, islice, product

import numpy as np
import pytest

from chatscene.errors import MissingExtra, SettingsError
from chatscene.program.sample import scene_seed
from chatscene.search.sampler import SAMPLERS, Proposal, Sampler, load_sampler
from chatscene.search.samplers.cross_entropy import FLOOR, fit
from chatscene.search.samplers.grid import grid
from chatscene.search.samplers.policy_gradient import learn, policy
from chatscene.search.samplers.quality_diversity import elites
from chatscene.search.samplers.unit_cube import UnitCube
from chatscene.terms.outcome import Outcome
from chatscene.terms.snippet import ParameterRange

NEEDS = {"tpe": "optuna", "cma-es": "cmaes"}
LEARNING = ("paper", "policy-gradient", "cross-entropy", "tpe", "cma-es", "quality-diversity")
every_sampler = pytest.mark.parametrize("name", sorted(SAMPLERS.built_in))

Values = dict[str, float]
Scene = Callable[[Values], Outcome]

DECLARED = (
    ParameterRange(name="OPT_SPEED", low=0.0, high=5.0, unit="m/s"),
    ParameterRange(name="OPT_OFFSET", low=-10.0, high=10.0, unit="m"),
    ParameterRange(name="OPT_DELAY", low=1.0, high=3.0, unit="s"),
)


def loaded(name: str) -> Sampler:
    if name in NEEDS:
        pytest.importorskip(NEEDS[name], reason="the extra 'search' is not installed")
    return load_sampler(name)


def corner(values: Values) -> Outcome:
    """A collision in a corner of 3 in 10 of each range, a near miss around it, nothing far from it."""
    shares = UnitCube(DECLARED).point(values)
    gap = 20.0 * float(np.linalg.norm(np.maximum(shares - 0.3, 0.0)))
    collided = gap == 0.0
    return Outcome(
        values=values,
        collided=collided,
        distance=gap,
        impact_speed=8.0 if collided else 0.0,
        completion=0.5 if collided else 1.0,
    )


def two_regions(values: Values) -> Outcome:
    """Collisions at both ends of the first range, of every speed and place; a near miss between."""
    first, second, third = UnitCube(DECLARED).point(values)
    gap = 20.0 * max(0.0, min(first - 0.05, 0.95 - first))
    if gap > 0.0:
        return Outcome(values=values, collided=False, distance=gap, impact_speed=0.0, completion=1.0)
    speed, place = (0.5 * second, 0.5 * third) if first < 0.5 else (1.0 - 0.5 * second, 1.0 - 0.5 * third)
    kind = f"{int(10 * place)} {int(10 * speed)}"
    return Outcome(
        values=values, collided=True, distance=0.0, impact_speed=20.0 * speed, completion=place, crash_type=kind
    )


def drawn(proposal: Proposal, block: int, count: int) -> list[Values]:
    return [proposal.draw(scene_seed(0, f"block-{block}/scene-{index}")) for index in range(count)]


def searched(
    name: str,
    declared: Sequence[ParameterRange],
    scene: Scene,
    *,
    sizes: Sequence[int],
    seed: int = 0,
    done: Sequence[Sequence[Outcome]] = (),
) -> list[list[Outcome]]:
    """A search in which so many scenes of each block could be placed; `done` of its blocks are taken as given."""
    history = [list(block) for block in done]
    for block in range(len(done), len(sizes)):
        proposal = loaded(name).propose(declared, history, count=10, seed=scene_seed(seed, f"block-{block}"))
        history.append([scene(values) for values in drawn(proposal, block, 10)[: sizes[block]]])
    return history


def hit_rate(name: str) -> float:
    """Share of collisions in the last five blocks of 25 toward `corner`."""
    last = searched(name, DECLARED, corner, sizes=[10] * 25, seed=3)[-5:]
    return float(np.mean([outcome.collided for block in last for outcome in block]))


# What every sampler keeps to besides `chatscene.testing.check_sampler`.


@every_sampler
def test_outcomes_of_another_sampler_do_no_harm(name: str) -> None:
    done = searched("random", DECLARED, corner, sizes=[10, 10], seed=9)
    assert len(drawn(loaded(name).propose(DECLARED, done, count=10, seed=1), 2, 10)) == 10


def test_an_unknown_name_is_refused_with_the_known_ones() -> None:
    with pytest.raises(SettingsError, match=r"no sampler 'crossentropy'.*did you mean 'cross-entropy'.*cma-es, .*tpe"):
        load_sampler("crossentropy")


@pytest.mark.parametrize(("name", "package"), [("tpe", "optuna"), ("cma-es", "cmaes")])
def test_a_missing_package_ends_in_the_extra_to_install(
    name: str, package: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(sys.modules, package, None)
    monkeypatch.delitem(sys.modules, SAMPLERS.built_in[name].partition(":")[0], raising=False)
    with pytest.raises(MissingExtra, match=r"\[search\]"):
        load_sampler(name)


# What those that learn have learned.


@pytest.mark.parametrize("name", LEARNING)
def test_a_sampler_that_learns_ends_in_the_dangerous_corner(name: str) -> None:
    # The corner is 2.7 % of the space.
    assert hit_rate("random") < 0.1
    assert hit_rate(name) > 0.2


# The grid.


@pytest.mark.parametrize(("dimensions", "points", "shares"), [(1, 9, 9), (2, 9, 3), (3, 8, 2), (3, 27, 3)])
def test_the_first_points_of_a_grid_are_a_full_factorial_one(dimensions: int, points: int, shares: int) -> None:
    axis = [index / (shares - 1) for index in range(shares)]
    assert sorted(islice(grid(dimensions), points)) == sorted(product(axis, repeat=dimensions))


@pytest.mark.parametrize("dimensions", [1, 2, 3, 5])
def test_no_point_of_a_grid_comes_twice(dimensions: int) -> None:
    points = list(islice(grid(dimensions), 1000))
    assert len(set(points)) == 1000


@pytest.mark.parametrize(("dimensions", "points"), [(2, 4), (3, 4), (4, 8), (7, 8), (8, 16), (15, 16)])
def test_few_points_of_a_grid_have_both_ends_of_every_two_ranges_together(dimensions: int, points: int) -> None:
    corners = np.array(list(islice(grid(dimensions), points)), dtype=int)
    for first, second in combinations(range(dimensions), 2):
        pairs = 2 * corners[:, first] + corners[:, second]
        np.testing.assert_array_equal(np.bincount(pairs), points // 4)


@pytest.mark.parametrize("dimensions", [1, 2, 3, 5, 7])
@pytest.mark.parametrize("scenes", [8, 10, 25, 50, 100, 250])
def test_no_beginning_of_a_grid_leans_to_one_side(dimensions: int, scenes: int) -> None:
    points = np.array(list(islice(grid(dimensions), scenes)))
    np.testing.assert_allclose(points.mean(axis=0), 0.5, atol=0.1)


@pytest.mark.parametrize("dimensions", [2, 3, 4, 5])
def test_a_level_of_a_grid_has_every_point(dimensions: int) -> None:
    halves = set(islice(grid(dimensions), 3**dimensions))
    assert halves == set(product((0.0, 0.5, 1.0), repeat=dimensions))


def test_blocks_of_a_grid_go_on_where_the_former_ended() -> None:
    cube = UnitCube(DECLARED)
    walked = [outcome.values for block in searched("grid", DECLARED, corner, sizes=[10] * 4) for outcome in block]
    assert walked == [cube.values(point) for point in islice(grid(3), 40)]


def test_a_grid_comes_back_to_no_point_when_some_cannot_be_placed() -> None:
    cube = UnitCube(DECLARED)
    done: list[list[Outcome]] = []
    for block in range(4):
        values = drawn(load_sampler("grid").propose(DECLARED, done, count=10, seed=0), block, 20)
        done.append([corner(each) for each in values[1::2]])  # every other one has no place
    walked = [outcome.values for block in done for outcome in block]
    assert walked == [cube.values(point) for point in islice(grid(3), 80)][1::2]


def test_a_grid_moves_on_from_where_nothing_could_be_placed() -> None:
    blocks = searched("grid", DECLARED, corner, sizes=[10, 0, 0, 10])
    assert blocks[3][0].values == UnitCube(DECLARED).values(next(islice(grid(3), 30, None)))


# The policy gradient.


def test_the_score_of_a_policy_is_the_slope_of_its_log_likelihood() -> None:
    rng = np.random.default_rng(4)
    n = 3
    slope = np.tril(rng.normal(size=(n, n)), k=-1)
    numbers = np.concatenate([rng.normal(size=n), slope.ravel(), rng.normal(size=n)])
    points = rng.uniform(-1.0, 1.0, size=(5, n))
    scores = policy(numbers, n).score(points)
    lower = np.concatenate([np.ones(n), np.tril(np.ones((n, n)), k=-1).ravel(), np.ones(n)])
    for index, counts in enumerate(lower):
        step = np.zeros(len(numbers))
        step[index] = 1e-6
        difference = policy(numbers + step, n).log_likelihood(points) - policy(numbers - step, n).log_likelihood(points)
        np.testing.assert_allclose(scores[:, index], counts * difference / 2e-6, rtol=1e-5, atol=1e-6)


def test_a_policy_moves_to_what_is_dangerous_and_grows_sure_of_it() -> None:
    target = np.array([0.5, -0.4, 0.2])
    cube = UnitCube(DECLARED)

    def near(values: Values) -> Outcome:
        gap = 5.0 * float(np.linalg.norm(2.0 * cube.point(values) - 1.0 - target))
        return Outcome(values=values, collided=False, distance=gap, impact_speed=0.0, completion=1.0)

    start = learn(cube, [])
    learned = learn(cube, searched("policy-gradient", DECLARED, near, sizes=[10] * 40))
    rng = np.random.default_rng(0)
    points = np.array([learned.sample(rng) for _ in range(500)])
    np.testing.assert_allclose(points.mean(axis=0), target, atol=0.2)
    assert np.all(learned.log_deviation < start.log_deviation)


def test_a_policy_follows_the_parameters_before() -> None:
    """Dangerous is where the second equals the first: only the slope between them can say so."""
    cube = UnitCube(DECLARED)

    def equal(values: Values) -> Outcome:
        first, second, _ = cube.point(values)
        gap = 20.0 * abs(float(first - second))
        return Outcome(values=values, collided=False, distance=gap, impact_speed=0.0, completion=1.0)

    learned = learn(cube, searched("policy-gradient", DECLARED, equal, sizes=[10] * 40))
    assert learned.slope[1, 0] > 0.5
    assert np.all(np.triu(learned.slope) == 0.0)


# The others.


def test_the_deviations_of_cross_entropy_have_a_floor() -> None:
    cube = UnitCube(DECLARED)
    same = [[corner({p.name: p.low for p in DECLARED})] * 10] * 20
    mean, deviation = fit(cube, same)
    np.testing.assert_allclose(mean, 0.0, atol=1e-6)
    np.testing.assert_array_equal(deviation, FLOOR)


def test_cross_entropy_follows_the_best_fifth() -> None:
    cube = UnitCube(DECLARED[:1])
    mean, _ = fit(cube, [[any_speed(cube.values([1.0]), 10.0)] * 2 + [any_speed(cube.values([0.0]), 1.0)] * 8])
    np.testing.assert_allclose(mean, 0.7 * 1.0 + 0.3 * 0.5)


def any_speed(values: Values, speed: float) -> Outcome:
    return Outcome(values=values, collided=True, distance=0.0, impact_speed=speed, completion=0.5)


def test_optuna_says_nothing_and_its_level_of_logging_is_left_alone(capfd: pytest.CaptureFixture[str]) -> None:
    optuna = pytest.importorskip("optuna", reason="the extra 'search' is not installed")
    before = optuna.logging.get_verbosity()
    searched("tpe", DECLARED, corner, sizes=[10, 10])
    assert optuna.logging.get_verbosity() == before
    assert capfd.readouterr() == ("", "")


def test_an_evolution_strategy_starts_anew_where_nothing_is_to_be_gained() -> None:
    pytest.importorskip("cmaes", reason="the extra 'search' is not installed")
    from chatscene.search.samplers.cma_es import evolve

    flat = searched("random", DECLARED, lambda values: any_speed(values, 5.0), sizes=[10] * 40)
    strategy = evolve(UnitCube(DECLARED), flat, 10)
    assert 0 <= strategy.generation < 40


def test_an_evolution_strategy_learns_from_a_block_that_was_not_filled() -> None:
    pytest.importorskip("cmaes", reason="the extra 'search' is not installed")
    from chatscene.search.samplers.cma_es import evolve

    cube = UnitCube(DECLARED)
    scenes = [corner(cube.values([share] * 3)) for share in (0.1, 0.2, 0.3, 0.8, 0.9, 1.0)]
    strategy = evolve(cube, [scenes], 10)
    assert strategy.generation == 1
    assert np.all(strategy.mean < 0.5)


def test_quality_diversity_finds_more_kinds_of_crashes_than_chance_and_the_rule_of_the_paper() -> None:
    kinds: dict[str, int] = {}
    for name in ("paper", "random", "quality-diversity"):
        blocks = searched(name, DECLARED, two_regions, sizes=[10] * 25)
        kinds[name] = len({outcome.crash_type for block in blocks for outcome in block if outcome.collided})
    assert kinds["quality-diversity"] > 1.25 * max(kinds["paper"], kinds["random"])


def crash(speed: float, kind: str, avoidable: bool | None = None) -> Outcome:
    return replace(any_speed({}, speed), crash_type=kind, avoidable=avoidable)


def test_of_each_kind_of_crash_the_most_dangerous_scene_is_varied() -> None:
    slow, fast, faster = crash(3.0, "front"), crash(9.0, "rear"), crash(9.5, "rear")
    assert {one.danger for one, _ in elites([slow, faster, fast])} == {slow.danger, faster.danger}


def test_an_avoidable_crash_is_varied_more_often_and_a_kind_that_came_up_often_less() -> None:
    rare, avoidable, *often = crash(3.0, "a", False), crash(3.0, "b", True), *[crash(3.0, "c", False)] * 3
    shares = {one.crash_type: share for one, share in elites([rare, avoidable, *often])}
    assert shares["b"] > shares["a"] == pytest.approx(3 * shares["c"])
    assert sum(shares.values()) == pytest.approx(1.0)


def test_where_nothing_crashed_the_nearest_misses_are_varied() -> None:
    misses = [corner(UnitCube(DECLARED).values([share] * 3)) for share in (0.9, 0.4, 0.8, 0.5, 0.6)]
    near = [one for one, _ in elites(misses)]
    assert near == [misses[1], misses[3], misses[4]]


def test_a_search_where_no_contact_was_said_goes_toward_near_misses_and_away_from_collisions() -> None:
    def came(collided: bool, distance: float, touch: bool | None = False) -> Outcome:
        speed = 8.0 if collided else 0.0
        return Outcome(values={}, collided=collided, distance=distance, impact_speed=speed, completion=1.0, touch=touch)

    hit, near, far = came(True, 0.0), came(False, 0.5), came(False, 30.0)
    assert near.danger > far.danger > hit.danger
    assert not hit.crashed
    assert came(True, 0.0, None).danger > near.danger
