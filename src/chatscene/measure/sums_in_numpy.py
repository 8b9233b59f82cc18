"""What `chatscene.measure.sums` has of a drive, by numpy: for machines without an engine, and to check it."""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray

from chatscene.measure import sums
from chatscene.simulate.boxes import CRAWL, Between, Boxes, between, gaps, least_gap, post_encroachment
from chatscene.terms.actors import AIR_DRAG, LIMITS
from chatscene.terms.arrays import Array, changes, changes_at, fixed, paces
from chatscene.terms.episode import Ending, Episode, Track


def sums_in_numpy(episode: Episode) -> sums.Sums:
    """The numbers of a drive."""
    ego, others, dt, crash = episode.ego_track, episode.adversaries, episode.dt, episode.collision
    pairs = [between(ego, other) for other in others]
    apart = seconds = np.full(len(ego.x), math.inf)
    lately = round(sums.LATELY / dt)
    for pair in pairs:
        apart = np.minimum(apart, pair.gaps)
        seconds = np.minimum(seconds, pair.times)
        seconds = np.minimum(seconds, _headways(pair, ego.speed, lately))
    soonest = int(seconds.argmin())
    meets = min(others, key=lambda other: least_gap(ego, other)) if others else None
    if crash is not None:
        meets = next((track for track in episode.tracks if track.actor == crash.other), None)
    met = crash is not None and any(other.actor == crash.other for other in others)
    begins, fast = _encounter(episode, meets) if meets is not None else (0, (0.0,) * 6)
    return sums.Sums(
        pairs=[(pair.least, float(pair.nearest), pair.soonest, pair.headway, pair.braking) for pair in pairs],
        parted=[post_encroachment(ego, other) for other in others] if not met else [],
        tyres=tuple(
            (float(np.hypot(along, across).max(initial=-1.0)), _too_much(across, speed))
            for along, across, speed in taken(episode)
        ),
        apart=(float(apart.min()), int(np.flatnonzero(apart <= apart.min() + sums.AS_NEAR)[-1])),
        seconds=(float(seconds[soonest]), soonest),
        braked=_most(-np.abs(ego.speed), sums.steps_in(sums.OVER, dt)),
        steered=_most(episode.distance_to_route, sums.steps_in(sums.WITHIN, dt)),
        meets=meets,
        begins=begins,
        fast=fast,
        paces=_paces(ego),
        turned=(_turned(_reference_yaw(ego.heading)), _turned(ego.heading)),
        waits=_waits(episode),
    )


def _headways(pair: Between, speed: Array, lately: int) -> Array:
    """(T,) Time headway [s] behind another ahead; inf where nobody is, or the ego stands.

    It counts if the ego comes nearer to the other, or that has come before it in so many steps at most.
    """
    ahead = pair.ahead > 0.0
    steps = np.arange(len(ahead))
    since = steps - np.maximum.accumulate(np.where(ahead, -lately - 1, steps))
    moves = ahead & (speed > CRAWL) & ((pair.closing > CRAWL) | (since <= lately))
    return np.where(moves, pair.ahead / np.where(moves, speed, 1.0), math.inf)


def _most(values: Array, steps: int) -> tuple[float, int]:
    """By how much something rises at most in so many steps, and the step at which it has."""
    if len(values) <= steps:
        return 0.0, len(values) - 1
    change = values[steps:] - values[:-steps]
    at = int(change.argmax())
    return float(change[at]), at + steps


def _encounter(episode: Episode, other: Track) -> tuple[int, tuple[float, ...]]:
    """The step at which an encounter begins, and how fast both were."""
    ego, crash, dt = episode.ego_track, episode.collision, episode.dt
    nearest = max(crash.step - 1, 0) if crash is not None else between(ego, other).nearest
    mine, theirs = np.abs(ego.speed[: nearest + 1]), np.abs(other.speed[: nearest + 1])
    turned = float(other.heading[nearest] - ego.heading[nearest])
    begins = _begins(mine, theirs, dt, same_way=math.cos(turned) > sums.SAME_WAY)
    most = (float(one.max()) for one in (mine, theirs))
    return begins, (float(mine[begins]), float(theirs[begins]), *most, *map(sums.lost, (mine, theirs)))


def _begins(mine: Array, theirs: Array, dt: float, *, same_way: bool) -> int:
    """The step before the first of the last braking, of either, before the nearest moment; that one if neither does.

    What is parted by no more than `PAUSE` is one braking, and so is it of two that go the same way while the ego has
    not become faster again by `GAINS`; who stands after having moved still brakes. Else it had another reason.
    """
    reacts = _brakes(mine, dt) | _brakes(theirs, dt)
    pause = round(sums.PAUSE / dt)
    begins = last = len(mine) - 1
    for step in np.flatnonzero(reacts)[::-1].tolist():
        follows = same_way and float(mine[step : last + 1].max() - mine[step]) < sums.GAINS
        if last - step > pause and not follows:
            break
        begins, last = max(step - 1, 0), step
    return begins


def _brakes(speed: Array, dt: float) -> NDArray[np.bool_]:
    """(T,) Whether somebody loses speed in the step that led to each row, or stands there after having moved."""
    loses = -changes_at(speed) > sums.REACTS * dt
    return loses | ((speed < sums.STILL) & (np.maximum.accumulate(speed) >= sums.STILL))


def taken(episode: Episode) -> tuple[tuple[Array, Array, Array], ...]:
    """What tyres did along and across [m/s²] over each step, and the speed [m/s] in it, of everybody on wheels."""
    until = None if episode.collision is None else max(episode.collision.step, 1)  # an impact is no manoeuvre
    return tuple(_taken_by(track, episode.dt, until) for track in episode.tracks if sums.on_wheels(track.kind))


def _taken_by(track: Track, dt: float, until: int | None) -> tuple[Array, Array, Array]:
    limits, speed, heading = LIMITS[track.kind], np.abs(track.speed[:until]), track.heading[:until]
    change, mean = changes(speed) / dt, 0.5 * (speed[1:] + speed[:-1])
    # What air and rolling do is none of the tyres' doing.
    along = np.where(change < 0.0, np.minimum(change + limits.drag + AIR_DRAG * speed[:-1] ** 2, 0.0), change)
    return fixed(along), fixed(mean * changes(heading) / dt), fixed(mean)


def _too_much(across: Array, speed: Array) -> bool:
    return bool(((np.abs(across) > sums.ACROSS) & (speed > sums.FAST)).any())


def _paces(ego: Track) -> float:
    way = Boxes.of(ego)
    return float(paces(ego.speed * way.cos, ego.speed * way.sin).sum())


def _turned(heading: Array) -> float:
    """Sum [rad] of the changes of heading."""
    return float(np.abs(changes(heading)).sum())


def _reference_yaw(heading: Array) -> Array:
    """Our heading [rad] as the reference sees it: CARLA's yaw, clockwise from the same +x, in (-π, π].

    CARLA keeps yaw in degrees in single precision. So do we, because a car that drives due west leaves ±180° by
    1e-11 rad and back in double precision, and each time would count as a full turn.
    """
    yaw = 180.0 - (np.degrees(heading).astype(np.float32) + 180.0) % 360.0
    return np.radians(yaw.astype(np.float64))


def _waits(episode: Episode) -> bool:
    if episode.collision is not None:
        return False
    rows = sums.rows_standing(episode.dt, over=episode.ending is Ending.OVER)
    ego, *others = episode.tracks
    standing = [track for track in others if _stands(track, rows)] if _stands(ego, rows) else []
    return any(float(gaps(ego, other)[-rows:].min()) < sums.BEHIND for other in standing)


def _stands(track: Track, rows: int) -> bool:
    """Whether somebody stands in so many rows at the end."""
    return bool((np.abs(track.speed[-rows:]) < sums.STANDING).all())
