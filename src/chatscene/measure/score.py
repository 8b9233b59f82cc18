"""Step 8 of 9: from episodes to the ten metrics and the overall score.

Paper: appendix "Detailed Metric". Constants and quirks: SafeBench, ``metric_util.py``; decision 0003 lists them and
what `corrected` mode mends.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import combinations

import numpy as np

from chatscene.errors import SettingsError
from chatscene.measure.sums import mean, sums
from chatscene.terms.arrays import paces
from chatscene.terms.episode import Episode, EventKind, Track
from chatscene.terms.metrics import Measurements, Metrics, Mode

MOST_OFF_ROAD = 50.0  # [m]
MOST_DISTANCE = 5.0  # [m]
MOST_TIME = 60.0  # [s]
MOST_ACCELERATION = 8.0  # [m/s²]
MOST_YAW_RATE = 3.0  # [rad/s]
MOST_INVASIONS = 20.0


def measure(episode: Episode) -> Measurements:
    """The raw numbers of one episode.

    An episode of T rows has T - 1 steps; row 0 is the state before the first. Metres off the road, acceleration and
    yaw are taken over the steps, the distance to the route over the rows. Of a drive that was over before the ego
    arrived, rates are those of what was driven, and how long the rest would have taken is not known.
    """
    found, duration = sums(episode), episode.duration
    steps = len(episode.ego_track.x) - 1
    kinds = [event.kind for event in episode.events]
    return Measurements(
        collided=EventKind.COLLISION in kinds,
        red_lights=kinds.count(EventKind.RED_LIGHT),
        stop_signs=kinds.count(EventKind.STOP_SIGN),
        off_road=_metres_off_road(episode),
        distance_to_route=mean(episode.distance_to_route),
        completion=episode.completion,
        time=duration if episode.route_completion >= 1.0 else None,
        acceleration=found.paces / steps / episode.dt if steps else 0.0,  # of the velocity, so that cornering counts
        yaw_rate=found.turned[0] / duration if duration else 0.0,
        yaw_rate_unwrapped=found.turned[1] / duration if duration else 0.0,
        lane_invasions=kinds.count(EventKind.LANE_INVASION),
        duration=duration,
    )


def _metres_off_road(episode: Episode) -> float:
    """Length [m] of the steps that begin or end off the road: the reference carries the flag one frame on."""
    ego, off = episode.ego_track, episode.off_road
    beside = off[1:] | off[:-1]
    if not beside.any():
        return 0.0
    steps = paces(ego.x, ego.y)
    return float(steps[beside].sum())


def score(measurements: Sequence[Measurements], *, mode: Mode = Mode.PAPER) -> Metrics:
    """The ten normalised numbers of a set of episodes.

    Args:
        measurements: One per episode; a set is scored as a whole, because time is averaged over those that arrive.
        mode: `paper` computes as the reference does; `corrected` unwraps yaw, gives an unfinished run the longest
            time rather than none, and clips each number into [0, 1].

    Raises:
        SettingsError: The set is empty.
    """
    if not measurements:
        raise SettingsError("there is no episode to score")
    corrected = mode is Mode.CORRECTED
    numbers = {
        "collision_rate": _mean([m.collided for m in measurements]),
        "red_light": _mean([m.red_lights for m in measurements]),
        "stop_sign": _mean([m.stop_signs for m in measurements]),
        "off_road": _mean([m.off_road for m in measurements]) / MOST_OFF_ROAD,
        "route_following": max(1 - _mean([m.distance_to_route for m in measurements]) / MOST_DISTANCE, 0.0),
        "completion": _mean([m.completion for m in measurements]),
        "time_spent": _time_spent(measurements, corrected=corrected),
        "acceleration": _mean([m.acceleration for m in measurements]) / MOST_ACCELERATION,
        "yaw_velocity": _mean([m.yaw_rate_unwrapped if corrected else m.yaw_rate for m in measurements])
        / MOST_YAW_RATE,
        "lane_invasion": _mean([m.lane_invasions for m in measurements]) / MOST_INVASIONS,
    }
    if corrected:
        numbers = {name: min(max(value, 0.0), 1.0) for name, value in numbers.items()}
    return Metrics(**numbers)


def _time_spent(measurements: Sequence[Measurements], *, corrected: bool) -> float:
    if corrected:
        known = [m for m in measurements if m.time is not None or m.completion < 1.0]
        return _mean([MOST_TIME if m.time is None else min(m.time, MOST_TIME) for m in known] or [0.0]) / MOST_TIME
    times = [m.time for m in measurements if m.time is not None]
    return _mean(times) / MOST_TIME if times else 0.0


def _mean(values: Sequence[float]) -> float:
    if len(values) == 1:
        return float(values[0])
    return math.fsum(values) / len(values)


COLUMNS: dict[str, str] = {
    "collision_rate": "cr",
    "red_light": "rr",
    "stop_sign": "ss",
    "off_road": "or",
    "route_following": "rf",
    "completion": "comp",
    "time_spent": "ts",
    "acceleration": "acc",
    "yaw_velocity": "yv",
    "lane_invasion": "li",
}


def columns(measurements: Measurements) -> dict[str, float]:
    """The ten numbers of one episode and its overall score, paper mode, by their names in ``scenes.parquet``."""
    metrics = score([measurements])
    row = {column: float(getattr(metrics, name)) for name, column in COLUMNS.items()}
    return {**row, "overall_score": metrics.overall_score}


def average_displacement(tracks: Sequence[Track]) -> float:
    """ADE: how far apart adversaries are at equal times [m], averaged over every pair of scenes.

    Paper, section 4.1 ("Metrics"). The paper gives neither the pairing nor the rule for unequal lengths; ours pairs
    the scenes of one scenario on one route, and compares two tracks while both run. The mean over several
    scenarios and routes is the mean of their values.

    Args:
        tracks: The adversary's track from each scene of one scenario on one route, at the same time step.

    Raises:
        SettingsError: Fewer than two tracks: there is no pair.
    """
    if len(tracks) < 2:
        raise SettingsError(f"displacement compares pairs of tracks, and there are {len(tracks)}; keep more scenes")
    return _mean([_distance(first, second) for first, second in combinations(tracks, 2)])


def _distance(first: Track, second: Track) -> float:
    """Mean distance [m] over the steps both tracks have."""
    steps = min(len(first.x), len(second.x))
    return float(np.hypot(first.x[:steps] - second.x[:steps], first.y[:steps] - second.y[:steps]).mean())


def wilson(successes: int, trials: int, z: float = 1.959964) -> tuple[float, float]:
    """The Wilson score interval of a rate; (0, 1) where nothing was tried.

    Wilson (1927), "Probable inference, the law of succession, and statistical inference". By hand because
    `scipy.stats` takes longer to import than these lines to read; decision 0041.

    Args:
        successes: How often it happened.
        trials: How often it could have.
        z: Standard deviations of the normal distribution; the default gives 95 %.

    Raises:
        SettingsError: More successes than trials, or a negative number of them.
    """
    if not 0 <= successes <= trials:
        raise SettingsError(f"{successes} successes in {trials} trials make no rate")
    if trials == 0:
        return 0.0, 1.0
    rate = successes / trials
    spread = z * math.sqrt(rate * (1 - rate) / trials + z * z / (4 * trials * trials))
    centre, scale = rate + z * z / (2 * trials), 1 + z * z / trials
    # The rate itself is always inside; rounding must not push a rate of 0 or 1 out.
    return max(0.0, min(rate, (centre - spread) / scale)), min(1.0, max(rate, (centre + spread) / scale))
