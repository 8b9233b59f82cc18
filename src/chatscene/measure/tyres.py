"""Whether bodies did what tyres cannot do, or did it where bodies that answer at once tell nothing of real ones.

A kinematic body is held to what its kind can brake and turn with, each by itself, and answers within a step. So it may
brake and turn at once harder than any tyre holds; and the faster it goes, the earlier it is where a car would be later:
a lag of the yaw rate grows with the speed. Beside CommonRoad's multi-body car (`benchmarks/manoeuvres.py`) a step of
the wheel is right to 2 m after 4 s up to 50 km/h, whatever it asks, and at any speed where it asks for 2 m/s².
"""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from chatscene.simulate.native.lines import engine
from chatscene.terms.actors import AIR_DRAG, BY_CLASS, LIMITS
from chatscene.terms.arrays import Array, changes, fixed
from chatscene.terms.episode import Episode, Track
from chatscene.terms.situation import EGO
from chatscene.terms.surroundings import DRY, GRAVITY

FAST = 50.0 / 3.6  # [m/s]
ACROSS = 4.0  # [m/s²], up to which cars answer to the wheel in proportion (ISO 4138 looks for no more)
GRIPPIEST = 1.0 / DRY  # of a surface's friction; the highest that is published beside the value that we use


@lru_cache(maxsize=1)
def friction_demand(episode: Episode) -> float | None:
    """The largest share of the road's friction that anybody on wheels took, along and across together.

    Up to the step before the first contact. Above 1 it is more than tyres hold. None where nobody on wheels moved.
    """
    most = max((most for most, _ in did(episode)), default=-1.0)
    return most / (_friction(episode) * GRAVITY) if most >= 0.0 else None


def beyond_tyres(episode: Episode) -> tuple[str, ...]:
    """What somebody did in a drive of bodies that answer at once for which it should not be taken for physics."""
    held = _friction(episode) * GRAVITY * GRIPPIEST
    wheeled = (track.actor for track in episode.tracks if _on_wheels(track))
    who = [actor for actor, (most, lags) in zip(wheeled, did(episode), strict=True) if lags or most > held]
    if not who:
        return ()
    names = " and ".join("the ego" if one == EGO else one for one in who)
    return (
        f"{names}: braking, speeding up or turning harder or sooner than tyres do; compare with `--physics lagged`",
    )


def _friction(episode: Episode) -> float:
    return min(episode.surroundings.surface.row.friction, DRY)


def _until(episode: Episode) -> int | None:
    """How many steps to look at: an impact is no manoeuvre."""
    return None if episode.collision is None else max(episode.collision.step, 1)


def _on_wheels(track: Track) -> bool:
    return track.kind in BY_CLASS and LIMITS[track.kind].wheelbase > 0.0


@lru_cache(maxsize=1)
def taken(episode: Episode) -> tuple[tuple[Array, Array, Array], ...]:
    """What tyres did in a drive, as `_taken_by` has it, of everybody on wheels."""
    until = _until(episode)
    return tuple(_taken_by(track, episode.dt, until) for track in episode.tracks if _on_wheels(track))


@lru_cache(maxsize=1)
def did(episode: Episode) -> tuple[tuple[float, bool], ...]:
    """What tyres did at most along and across together [m/s²], of everybody on wheels; -1 without a step.

    And whether they turned with more than `ACROSS` while faster than `FAST`.
    """
    native = engine()
    if native is None:
        return tuple(
            (
                float(np.hypot(along, across).max(initial=-1.0)),
                bool(((np.abs(across) > ACROSS) & (speed > FAST)).any()),
            )
            for along, across, speed in taken(episode)
        )
    until = _until(episode)
    return tuple(
        native.tyres_did(
            *(track.speed[:until], track.heading[:until]),
            *(episode.dt, LIMITS[track.kind].drag, AIR_DRAG, ACROSS, FAST),
        )
        for track in episode.tracks
        if _on_wheels(track)
    )


def _taken_by(track: Track, dt: float, until: int | None) -> tuple[Array, Array, Array]:
    """What tyres did along and across [m/s²] over each step, and the speed [m/s] in it."""
    limits, speed, heading = LIMITS[track.kind], np.abs(track.speed[:until]), track.heading[:until]
    change, mean = changes(speed) / dt, 0.5 * (speed[1:] + speed[:-1])
    # What air and rolling do is none of the tyres' doing.
    along = np.where(change < 0.0, np.minimum(change + limits.drag + AIR_DRAG * speed[:-1] ** 2, 0.0), change)
    return fixed(along), fixed(mean * changes(heading) / dt), fixed(mean)
