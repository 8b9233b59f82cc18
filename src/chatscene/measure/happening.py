"""What happened in a drive, and when: what is worth keeping, showing and looking at."""

from __future__ import annotations

import math

from chatscene.measure.sums import OVER, Sums, sums
from chatscene.terms.criticality import Happened, Happening
from chatscene.terms.episode import Episode

SOON, NEAR = 1.5, 2.0  # [s], [m] below which a nearest gap is an encounter
HARD = 4.0  # [m/s²] that an ego brakes at least that brakes hard
ASIDE = 1.0  # [m] by which an ego leaves its way that steers clear of somebody


def happened(episode: Episode) -> Happened:
    """The gravest of what happened, and when; of a drive in which nothing did, when the ego was nearest to somebody.

    Gaps in time are the least of time to collision and of the headway of an ego that comes nearer to somebody ahead, or
    before which that one has come; gaps in length are those between the boxes.
    """
    found = sums(episode)
    least, soonest = found.seconds
    kind, step = _kind(episode, found), found.apart[1]
    if episode.collision is not None:
        step = episode.collision.step
    elif kind is Happening.NEAR_IN_TIME:
        step = soonest
    elif kind is Happening.BRAKING:
        step = found.braked[1]
    elif kind is Happening.STEERING:
        step = found.steered[1]
    return Happened(kind=kind, step=step, seconds=least if math.isfinite(least) else None)


def _kind(episode: Episode, found: Sums) -> Happening:
    if episode.collision is not None:
        return Happening.COLLISION
    if found.seconds[0] < SOON:
        return Happening.NEAR_IN_TIME
    if found.apart[0] < NEAR:
        return Happening.NEAR
    if found.braked[0] >= HARD * OVER:
        return Happening.BRAKING
    return Happening.STEERING if found.steered[0] >= ASIDE else Happening.NOTHING
