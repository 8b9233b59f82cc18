"""What happened in a drive, and when: what is worth keeping, showing and looking at."""

from __future__ import annotations

import math

import numpy as np

from chatscene.measure.criticality import headways
from chatscene.simulate.boxes import gaps, times_to_collision
from chatscene.terms.arrays import Array
from chatscene.terms.criticality import Happened, Happening
from chatscene.terms.episode import Episode

LATELY = 2.0  # [s] for which who has come before the ego is near, though the ego comes no nearer
SOON, NEAR = 1.5, 2.0  # [s], [m] below which a nearest gap is an encounter
AS_NEAR = 0.3  # [m] farther apart than at their nearest, two are as near: what comes of driving level is at its end
HARD, OVER = 4.0, 0.4  # [m/s²], [s] that an ego brakes at least that brakes hard
ASIDE, WITHIN = 1.0, 1.5  # [m], [s] by which an ego leaves its way that steers clear of somebody


def happened(episode: Episode) -> Happened:
    """The gravest of what happened, and when; of a drive in which nothing did, when the ego was nearest to somebody.

    Gaps in time are the least of time to collision and of the headway of an ego that comes nearer to somebody ahead, or
    before which that one has come; gaps in length are those between the boxes.
    """
    ego, others = episode.ego_track, episode.adversaries
    apart = seconds = np.full(len(ego.x), math.inf)
    lately = round(LATELY / episode.dt)
    for other in others:
        apart = np.minimum(apart, gaps(ego, other))
        seconds = np.minimum(seconds, times_to_collision(ego, other))
    for other in others:
        seconds = np.minimum(seconds, headways(ego, other, lately=lately))
    nearest, soonest = int(np.flatnonzero(apart <= apart.min() + AS_NEAR)[-1]), int(seconds.argmin())
    least = float(seconds[soonest])
    kind, step = _kind(episode, least, float(apart.min())), nearest
    if episode.collision is not None:
        step = episode.collision.step
    elif kind is Happening.NEAR_IN_TIME:
        step = soonest
    elif kind in _OWN:
        step = _OWN[kind](episode)[1]
    return Happened(kind=kind, step=step, seconds=least if math.isfinite(least) else None)


def _kind(episode: Episode, seconds: float, metres: float) -> Happening:
    if episode.collision is not None:
        return Happening.COLLISION
    if seconds < SOON:
        return Happening.NEAR_IN_TIME
    if metres < NEAR:
        return Happening.NEAR
    if _braked(episode)[0] >= HARD * OVER:
        return Happening.BRAKING
    return Happening.STEERING if _steered(episode)[0] >= ASIDE else Happening.NOTHING


def _braked(episode: Episode) -> tuple[float, int]:
    """How much speed [m/s] the ego loses at most within `OVER`, and the step at which it has."""
    return _most(-np.abs(episode.ego_track.speed), round(OVER / episode.dt))


def _steered(episode: Episode) -> tuple[float, int]:
    """How far [m] the ego leaves its way at most within `WITHIN`, and the step at which it has."""
    return _most(episode.distance_to_route, round(WITHIN / episode.dt))


_OWN = {Happening.BRAKING: _braked, Happening.STEERING: _steered}


def _most(values: Array, steps: int) -> tuple[float, int]:
    """By how much something rises at most in so many steps, and the step at which it has."""
    if len(values) <= steps:
        return 0.0, len(values) - 1
    change = values[steps:] - values[:-steps]
    at = int(change.argmax())
    return float(change[at]), at + steps
