"""How often something happens: estimates hold in toy worlds whose answer is known."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray

from chatscene.errors import SettingsError
from chatscene.measure.score import wilson
from chatscene.search.exposure import exposure_of, read_exposure
from chatscene.search.rare import FEWEST, Batch, Box, Came, Share, Tally, rounds, share_of
from chatscene.terms.exposure import Density, Shape
from chatscene.terms.snippet import ParameterRange

Array = NDArray[np.float64]
SPEED = ParameterRange(name="OPT_ADV_SPEED", low=0.0, high=10.0, unit="m/s")
GAP = ParameterRange(name="OPT_ADV_DISTANCE", low=-5.0, high=15.0, unit="m")
CUBE = Box(np.zeros(2), np.ones(2))
NORMAL = Density(parameter="OPT_ADV_SPEED", shape=Shape.NORMAL, middle=4.0, spread=2.0, source="a study")


def _corner(side: float) -> Callable[[Array], Came]:
    """A crash in one corner of the cube, the more dangerous the nearer to it."""

    def came(point: Array) -> Came:
        crashed = bool((point < side).all())
        return Came(2.0 if crashed else 1.0 / (1.0 + float(point.max())), crashed, avoidable=False)

    return came


def _slow(speed: float, below: float) -> Came:
    crashed = bool(speed < below)
    return Came(1.5 if crashed else 0.1, crashed, avoidable=False)


def _estimated(
    came: Callable[[Array], Came | None], scenes: int, seed: int, *densities: Density
) -> tuple[Share, Tally]:
    tally = Tally(exposure_of((SPEED, GAP), densities))
    for number, count in enumerate(rounds(scenes)):
        rng = np.random.default_rng((seed, number))
        points, batch = tally.draw(count, rng)
        tally.add(points, [0] * count, [came(point) for point in points], batch)
    return tally.shares()[0], tally


def test_intervals_hold_the_known_share_of_a_rare_crash() -> None:
    found = [_estimated(_corner(0.1), 500, seed)[0] for seed in range(60)]
    told = [one for one in found if one.probability is not None]
    assert len(told) >= 55
    held = sum((one.low or 0.0) <= 0.01 <= (one.high or 0.0) for one in told)
    assert held >= 0.95 * len(told)
    assert np.mean([one.probability or 0.0 for one in told]) == pytest.approx(0.01, rel=0.1)


def test_what_drives_led_to_makes_them_count_no_less() -> None:
    """With only their own kernels left out, the shares would be 0.84 of what is true."""
    five = [ParameterRange(name=f"OPT_{letter}", low=0.0, high=1.0, unit="m") for letter in "ABCDE"]
    came, shares = _corner(0.05 ** (1 / 5)), list[float]()
    for seed in range(60):
        tally = Tally(exposure_of(five))
        for number, count in enumerate(rounds(600)):
            points, batch = tally.draw(count, np.random.default_rng((seed, number)))
            tally.add(points, [0] * count, [came(point) for point in points], batch)
        shares.append(tally.shares()[0].probability or 0.0)
    assert all(shares)
    assert np.mean(shares) == pytest.approx(0.05, rel=0.07)


def test_an_interval_is_wider_where_earlier_drives_led_to_later_ones() -> None:
    happened, weights = np.arange(1000) < 100, np.ones(1000)
    plain, aimed = share_of(happened, weights), share_of(happened, weights, aimed=True)
    assert plain.low and plain.high and aimed.low and aimed.high
    assert aimed.low < plain.low < 0.1 < plain.high < aimed.high
    assert not Batch(count=1, density=CUBE).aimed
    assert Batch(count=1, density=Box(np.zeros(2), np.array([1.0, 0.5]))).aimed


def test_a_rare_crash_is_told_from_fewer_drives_than_without_aiming() -> None:
    aimed, _ = _estimated(_corner(0.1), 500, 3)
    rng = np.random.default_rng(3)
    plain = np.array([_corner(0.1)(point).crashed for point in rng.random((500, 2))])
    assert aimed.probability is not None
    without = share_of(plain, np.ones(500))
    assert aimed.high is not None and aimed.low is not None
    assert without.high is not None and without.low is not None
    assert aimed.high - aimed.low < without.high - without.low


def test_an_exposure_is_what_a_share_is_of() -> None:
    """Half of a normal density lies below its mean, however little of the range does."""
    exposure = exposure_of((SPEED,), (NORMAL,))
    points = exposure.draw(4000, np.random.default_rng(0))
    inside = exposure.inside()["OPT_ADV_SPEED"]
    below = float((points < 0.4).mean()) * inside
    assert below == pytest.approx(0.5 - (1 - inside) * 0.96, abs=0.03)
    grid = (np.arange(1000)[:, None] + 0.5) / 1000
    assert float(exposure.density(grid).mean()) == pytest.approx(1.0, abs=1e-3)


def test_the_same_draws_tell_of_another_exposure() -> None:
    """A crash below 2 m/s: 1 in 5 if all speeds are alike, fewer by a density around 4 m/s."""
    tally = Tally(exposure_of((SPEED, GAP), (NORMAL,)))
    points = np.random.default_rng(1).random((3000, 2))
    tally.add(points, [0] * 3000, [_slow(x, 0.2) for x, _ in points], Batch(count=3000, density=CUBE))
    share = tally.shares()[0]
    assert share.probability == pytest.approx((0.1587 - 0.0228) / (0.9987 - 0.0228), abs=0.02)


def test_boxes_of_a_search_count_as_often_as_they_were_drawn() -> None:
    """Four in five draws lie where all crash, a tenth of the cube: the share is a tenth."""
    tally, rng = Tally(exposure_of((SPEED, GAP))), np.random.default_rng(2)
    for high, count in ((np.array([1.0, 1.0]), 300), (np.array([0.1, 1.0]), 1200)):
        points = rng.random((count, 2)) * high
        batch = Batch(count=count, density=Box(np.zeros(2), high))
        tally.add(points, [0] * count, [_slow(x, 0.1) for x, _ in points], batch)
    share = tally.shares()[0]
    assert share.low is not None and share.high is not None
    assert share.low < 0.1 < share.high
    assert share.high - share.low < 0.07


def test_a_search_on_one_route_tells_nothing_of_another() -> None:
    """On the first of two routes one in five crashes, and the search stays with those; on the second nobody does."""
    held = []
    for seed in range(40):
        tally, rng = Tally(exposure_of((SPEED, GAP))), np.random.default_rng(seed)
        for route, high, count in ((0, 1.0, 100), (0, 0.2, 300), (1, 1.0, 400)):
            points = rng.random((count, 2)) * np.array([high, 1.0])
            came = [_slow(x, 0.2 if route == 0 else 0.0) for x, _ in points]
            box = Box(np.zeros(2), np.array([high, 1.0]))
            tally.add(points, [route] * count, came, Batch(count=count, density=box, route=route))
        share = tally.shares()[0]
        assert share.low is not None and share.high is not None
        held.append(share.low <= 0.1 <= share.high)
    assert sum(held) >= 36


def test_what_cannot_be_placed_is_no_scene() -> None:
    """Half of the cube cannot be placed; a tenth of the other half crashes."""

    def came(point: Array) -> Came | None:
        crashed = bool(point[1] < 0.1)
        return None if point[0] > 0.5 else Came(1.5 if crashed else 0.1, crashed, avoidable=False)

    share, tally = _estimated(came, 2000, 5)
    assert share.probability == pytest.approx(0.1, abs=0.03)
    assert tally.placed < tally.drawn == 2000


def test_too_few_crashes_tell_no_share() -> None:
    weights = np.where(np.arange(1000) < 500, 1.0, 2.0)
    few = share_of(np.arange(1000) < FEWEST - 1, weights)
    assert (few.seen, few.probability, few.high) == (FEWEST - 1, None, None)
    none = share_of(np.zeros(1000, bool), np.ones(1000))
    assert none.probability is None
    assert none.high == pytest.approx(0.003, abs=1e-4)  # three in a thousand
    enough = share_of(np.arange(1000) < 100, np.ones(1000))
    assert (enough.probability, round(enough.low or 0, 3), round(enough.high or 0, 3)) == (0.1, 0.083, 0.12)


@pytest.mark.parametrize("weight", [1.0, 1 / 3])
def test_of_drives_that_weigh_the_same_however_few_crashes_have_wilsons_interval(weight: float) -> None:
    weights = weight * (1 + 1e-12 * np.arange(50))  # quotients of equal densities differ in their last bits
    share = share_of(np.arange(50) < 22, weights)
    assert (share.seen, share.probability) == (22, pytest.approx(0.44))
    assert (share.low, share.high) == pytest.approx(wilson(22, 50), abs=1e-4)
    every = share_of(np.ones(20, bool), weights[:20])
    assert (every.low, every.high) == pytest.approx(wilson(20, 20), abs=1e-4)


def test_an_exposure_is_a_file_with_sources(tmp_path: Path) -> None:
    path = tmp_path / "speeds.toml"
    path.write_text('[OPT_ADV_SPEED]\nshape = "normal"\nmean = 4\ndeviation = 2\nsource = "a study"\n')
    assert read_exposure(path) == (NORMAL,)


@pytest.mark.parametrize(
    ("said", "told"),
    [
        (
            '[OPT_ADV_SPEED]\nshape = "normal"\nmean = 4\ndeviation = 2\n',
            "'OPT_ADV_SPEED' that is not a density .source: ",
        ),
        ('[OPT_ADV_SPEED]\nshape = "normal"\nmean = 4\ndeviation = -2\nsource = "x"\n', "not a density .deviation: "),
        ('[OPT_ADV_SPEED]\nshape = "flat"\nsource = "x"\n', "not a density .*'flat'.*'uniform', 'normal', 'lognormal'"),
        ("shape = ", "is not TOML"),
        (None, "cannot be read"),
    ],
)
def test_an_exposure_that_is_none_is_refused(said: str | None, told: str, tmp_path: Path) -> None:
    path = tmp_path / "speeds.toml"
    if said is not None:
        path.write_text(said)
    with pytest.raises(SettingsError, match=told):
        read_exposure(path)


def test_an_exposure_of_something_else_is_refused() -> None:
    with pytest.raises(SettingsError, match="has OPT_ADV_SPEED, and the program does not"):
        exposure_of((GAP,), (NORMAL,))
    far = Density(parameter="OPT_ADV_SPEED", shape=Shape.LOGNORMAL, middle=400.0, spread=0.1, source="a study in km/h")
    with pytest.raises(SettingsError, match="units"):
        exposure_of((SPEED,), (far,))
