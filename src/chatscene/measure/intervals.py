"""Confidence intervals from what varies between routes; decision 0014 says why routes and how well it covers.

The scenes of a route share its geometry, and every ego drives the same scenes, so drives are not independent; routes
are taken to be. A bootstrap draws as many routes as there are, with replacement, and computes the number again. What
other sentences, other egos or another training of the same ego would give is in none of these intervals.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence, Sized
from operator import mul
from typing import TypeVar

import numpy as np
from scipy.special import ndtr, stdtrit

from chatscene.errors import SettingsError
from chatscene.measure.score import (
    COLUMNS,
    MOST_ACCELERATION,
    MOST_DISTANCE,
    MOST_INVASIONS,
    MOST_OFF_ROAD,
    MOST_TIME,
    MOST_YAW_RATE,
)
from chatscene.terms.arrays import Array
from chatscene.terms.metrics import Measurements, Metrics, Mode

T = TypeVar("T")

DRAWS = 1000
LEVEL = 0.95
FEWEST_FREEDOM = 4  # degrees of freedom below which an interval would promise more than it can hold
ROUNDING = 1e-9  # what differs by less does not differ
METRICS = tuple(COLUMNS)
_RF, _TS = METRICS.index("route_following"), METRICS.index("time_spent")


def bootstrap(
    groups: Sequence[Sequence[T]],
    statistic: Callable[[Sequence[T]], float],
    *,
    seed: int,
    draws: int = DRAWS,
    level: float = LEVEL,
) -> tuple[float, float]:
    """The percentile interval of a number under resampling of whole groups.

    Args:
        groups: What belongs together, e.g. the drives of a route; none of them empty.
        statistic: The number of a set.
        seed: The same seed, groups and order give the same interval.
        draws: How often to resample.
        level: Confidence.

    Returns:
        Low and high; (nan, nan), as nothing is known of how groups vary, from fewer than five groups (even the whole
        range of four holds the middle only 7 times in 8) and where they do not differ.

    Raises:
        SettingsError: There is no group, or an empty one.
    """
    return percentiles(resample(groups, statistic, seed=seed, draws=draws), [len(groups)], level=level)


def resample(
    groups: Sequence[Sequence[T]], statistic: Callable[[Sequence[T]], float], *, seed: int, draws: int = DRAWS
) -> Array:
    """(draws,) The number of each resampled set; arguments and errors as of `bootstrap`."""
    counts = _counts(groups, seed, draws)
    return np.array(
        [
            statistic([each for group, count in zip(groups, row, strict=True) for each in [*group] * count])
            for row in counts.tolist()
        ]
    )


def resample_means(groups: Sequence[Mapping[str, Sequence[float]]], *, seed: int, draws: int = DRAWS) -> Array:
    """(draws,) The mean over egos of each one's mean, of resampled groups; an ego that is in none of them has none.

    Sums are whole numbers of the smallest fraction that any value has, so that the order of a draw is nothing to them.

    Args:
        groups: The values of each ego in a group.
        seed: As for `bootstrap`.
        draws: As for `bootstrap`.

    Raises:
        SettingsError: As by `bootstrap`.
    """
    counts = _counts(groups, seed, draws).tolist()
    ratios = {value: value.as_integer_ratio() for group in groups for own in group.values() for value in own}
    finest = max(below for _, below in ratios.values())
    whole = {value: above * (finest // below) for value, (above, below) in ratios.items()}
    egos = sorted({ego for group in groups for ego in group})
    sums = [[sum(whole[value] for value in group.get(ego, ())) for group in groups] for ego in egos]
    sizes = [[len(group.get(ego, ())) for group in groups] for ego in egos]
    means: list[float] = []
    for row in counts:
        drawn = [sum(map(mul, row, of)) for of in sizes]
        own = [sum(map(mul, row, of)) / finest / size for of, size in zip(sums, drawn, strict=True) if size]
        means.append(math.fsum(own) / len(own))
    return np.array(means)


def percentiles(values: Array, groups: Sequence[int], *, level: float = LEVEL) -> tuple[float, float]:
    """The expanded percentile interval of resampled values.

    The plain percentile interval of few groups is too narrow, as it lacks both the factor n / (n - 1) of the variance
    and Student's t. So the percentiles are taken further out, after Hesterberg (2015), "What teachers should know
    about the bootstrap", The American Statistician 69 ("expanded percentile").

    Args:
        values: (draws,) Resampled values; of a mean over strata, resampled independently, its values.
        groups: How many groups each stratum has.
        level: Confidence.

    Returns:
        Low and high; (nan, nan) where a stratum has one group, where all together have fewer than four degrees of
        freedom, and where nothing varies.
    """
    freedom = sum(groups) - len(groups)
    if freedom < FEWEST_FREEDOM or min(groups) < 2 or np.ptp(values) < ROUNDING:
        return math.nan, math.nan
    inflation = math.sqrt(sum(n / (n - 1) for n in groups) / len(groups))
    tail = float(ndtr(-inflation * stdtrit(freedom, (1 + level) / 2)))
    low, high = np.quantile(values, [tail, 1 - tail]).tolist()
    return low, high


def resample_scores(
    routes: Sequence[Sequence[tuple[str, Measurements]]], mode: Mode, *, seed: int, draws: int = DRAWS
) -> dict[str, Array]:
    """The ten numbers and the overall score, mean over egos, of resampled routes, all draws at once.

    A draw in which an ego has no drive is the mean over the others.

    Args:
        routes: The drives of each route, with their egos.
        mode: As for `score`.
        seed: As for `bootstrap`.
        draws: How often to resample.

    Returns:
        (draws,) by name of the metric; ``overall_score`` last.

    Raises:
        SettingsError: There is no route, or one without drives.
    """
    egos = sorted({ego for route in routes for ego, _ in route})
    totals = np.zeros((len(routes), len(egos), len(METRICS) + 2))
    for number, route in enumerate(routes):
        for ego, measurements in route:
            totals[number, egos.index(ego)] += _summands(measurements, mode)
    drawn = np.tensordot(_counts(routes, seed, draws).astype(float), totals, axes=1)
    drives, timed = drawn[..., -2], drawn[..., -1]
    numbers = np.full((*drives.shape, len(METRICS)), np.nan)
    np.divide(drawn[..., :-2], drives[..., None], out=numbers, where=drives[..., None] > 0)
    numbers[..., _RF] = np.maximum(1 - numbers[..., _RF], 0.0)
    # As in the reference, no time is spent where nobody arrives.
    numbers[..., _TS] = np.where(drives > 0, drawn[..., _TS] / np.maximum(timed, 1.0), np.nan)
    if mode is Mode.CORRECTED:
        numbers = np.clip(numbers, 0.0, 1.0)
    offset, slopes = _overall_score()
    means = np.nanmean(numbers, axis=1)
    return {**dict(zip(METRICS, means.T, strict=True)), "overall_score": offset + means @ slopes}


def _summands(m: Measurements, mode: Mode) -> list[float]:
    """What a drive adds to the ten sums, to the number of drives and to the number of those with a time."""
    corrected = mode is Mode.CORRECTED
    time = m.time
    if corrected and (time is not None or m.completion < 1.0):  # of a drive that was over it is not known
        time = MOST_TIME if time is None else min(time, MOST_TIME)
    return [
        float(m.collided),
        float(m.red_lights),
        float(m.stop_signs),
        m.off_road / MOST_OFF_ROAD,
        m.distance_to_route / MOST_DISTANCE,
        m.completion,
        (time or 0.0) / MOST_TIME,
        m.acceleration / MOST_ACCELERATION,
        (m.yaw_rate_unwrapped if corrected else m.yaw_rate) / MOST_YAW_RATE,
        m.lane_invasions / MOST_INVASIONS,
        1.0,
        float(time is not None),
    ]


def _overall_score() -> tuple[float, Array]:
    """The overall score as the affine function of the ten numbers that it is: its value at zero, its slopes."""
    units = np.vstack([np.zeros(len(METRICS)), np.eye(len(METRICS))]).tolist()
    scores = np.array([Metrics(**dict(zip(METRICS, unit, strict=True))).overall_score for unit in units])
    return float(scores[0]), scores[1:] - scores[0]


def _counts(groups: Sequence[Sized], seed: int, draws: int) -> np.ndarray[tuple[int, int], np.dtype[np.int64]]:
    """(draws, groups) How often each group is drawn."""
    if not groups or not all(groups):
        raise SettingsError("there is nothing to resample: no group, or an empty one")
    return np.random.default_rng(seed).multinomial(len(groups), [1 / len(groups)] * len(groups), size=draws)
