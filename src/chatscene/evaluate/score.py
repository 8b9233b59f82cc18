"""Step 8 of 9: from episodes to the ten metrics and the overall score.

Paper: appendix C.1. Constants and quirks: SafeBench, ``metric_util.py``; decision 0003 lists what `corrected` mode
mends.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from chatscene.errors import SettingsError
from chatscene.terms.episode import Ending, Episode, EventKind, Track
from chatscene.terms.metrics import Measurements, Metrics, Mode

MOST_OFF_ROAD = 50.0  # [m]
MOST_DISTANCE = 5.0  # [m]
MOST_TIME = 60.0  # [s]
MOST_ACCELERATION = 8.0  # [m/s²]
MOST_YAW_RATE = 3.0  # [rad/s]
MOST_INVASIONS = 20.0

TAU = 2 * math.pi


def measure(episode: Episode) -> Measurements:
    """The raw numbers of one episode."""
    ego, dt = episode.ego_track, episode.dt
    kinds = [event.kind for event in episode.events]
    duration = episode.duration
    turned = np.diff(ego.heading)
    wrapped = np.diff(np.pi - (np.pi - ego.heading) % TAU)
    step = np.hypot(np.diff(ego.x), np.diff(ego.y))
    # The reference extends the off-road flag by one frame.
    off = episode.off_road[1:] | episode.off_road[:-1]
    return Measurements(
        collided=EventKind.COLLISION in kinds,
        red_lights=kinds.count(EventKind.RED_LIGHT),
        stop_signs=kinds.count(EventKind.STOP_SIGN),
        off_road=float(step[off].sum()),
        distance_to_route=float(episode.distance_to_route.mean()),
        completion=episode.route_completion,
        time=duration if episode.ending is Ending.ARRIVED else None,
        acceleration=float(_acceleration(ego, dt).mean()),
        yaw_rate=float(np.abs(wrapped).sum() / duration) if duration else 0.0,
        yaw_rate_unwrapped=float(np.abs(turned).sum() / duration) if duration else 0.0,
        lane_invasions=kinds.count(EventKind.LANE_INVASION),
        duration=duration,
    )


def _acceleration(ego: Track, dt: float) -> NDArray[np.float64]:
    """(T,) magnitude [m/s²] of the change of velocity; 0 in row 0."""
    vx, vy = ego.speed * np.cos(ego.heading), ego.speed * np.sin(ego.heading)
    return np.hypot(np.diff(vx, prepend=vx[:1]), np.diff(vy, prepend=vy[:1])) / dt


def score(measurements: Sequence[Measurements], *, mode: Mode = Mode.PAPER) -> Metrics:
    """The ten normalised numbers of a set of episodes.

    Args:
        measurements: One per episode; a set is scored as a whole, because time is averaged over those that arrive.
        mode: `paper` as the reference computes them; `corrected` unwraps yaw, gives an unfinished run the longest
            time rather than the shortest, and keeps every number in [0, 1].

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
        return _mean([MOST_TIME if m.time is None else min(m.time, MOST_TIME) for m in measurements]) / MOST_TIME
    times = [m.time for m in measurements if m.time is not None]
    return _mean(times) / MOST_TIME if times else 0.0


def _mean(values: Sequence[float]) -> float:
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
    """The ten numbers of one episode in paper mode, and its overall score, by the names they have in tables."""
    metrics = score([measurements])
    row = {column: float(getattr(metrics, name)) for name, column in COLUMNS.items()}
    return {**row, "overall_score": metrics.overall_score}


def average_displacement(first: Track, second: Track) -> float:
    """Mean distance [m] between two adversaries at equal times, over the steps that both tracks have.

    The paper gives neither the pairing nor what happens to tracks of unequal length; ours pairs the scenes kept
    for the same scenario and route, and compares while both run.
    """
    steps = min(len(first.x), len(second.x))
    return float(np.hypot(first.x[:steps] - second.x[:steps], first.y[:steps] - second.y[:steps]).mean())


def wilson(successes: int, trials: int, z: float = 1.959964) -> tuple[float, float]:
    """The Wilson score interval of a rate (95 % by default); (0, 1) where nothing was tried."""
    if trials == 0:
        return 0.0, 1.0
    rate = successes / trials
    spread = z * math.sqrt(rate * (1 - rate) / trials + z * z / (4 * trials * trials))
    centre, scale = rate + z * z / (2 * trials), 1 + z * z / trials
    return max(0.0, (centre - spread) / scale), min(1.0, (centre + spread) / scale)
