"""Whether bodies did what tyres cannot do, or did it where bodies that answer at once tell nothing of real ones.

A kinematic body is held to what its kind can brake and turn with, each by itself, and answers within a step. So it may
brake and turn at once harder than any tyre holds; and the faster it goes, the earlier it is where a car would be later:
a lag of the yaw rate grows with the speed. Beside CommonRoad's multi-body car (`benchmarks/manoeuvres.py`) a step of
the wheel is right to 2 m after 4 s up to 50 km/h, whatever it asks, and at any speed where it asks for 2 m/s².
"""

from __future__ import annotations

from chatscene.measure.sums import on_wheels, sums
from chatscene.terms.episode import Episode
from chatscene.terms.situation import EGO
from chatscene.terms.surroundings import DRY, GRAVITY

GRIPPIEST = 1.0 / DRY  # of a surface's friction; the highest that is published beside the value that we use


def friction_demand(episode: Episode) -> float | None:
    """The largest share of the road's friction that anybody on wheels took, along and across together.

    Up to the step before the first contact. Above 1 it is more than tyres hold. None where nobody on wheels moved.
    """
    most = max((most for most, _ in sums(episode).tyres), default=-1.0)
    return most / (_friction(episode) * GRAVITY) if most >= 0.0 else None


def beyond_tyres(episode: Episode) -> tuple[str, ...]:
    """What somebody did in a drive of bodies that answer at once for which it should not be taken for physics."""
    held = _friction(episode) * GRAVITY * GRIPPIEST
    wheeled = (track.actor for track in episode.tracks if on_wheels(track.kind))
    who = [actor for actor, (most, lags) in zip(wheeled, sums(episode).tyres, strict=True) if lags or most > held]
    if not who:
        return ()
    names = " and ".join("the ego" if one == EGO else one for one in who)
    return (f"{names}: braking, acceleration or turning beyond what real tyres allow; compare with `--physics lagged`",)


def _friction(episode: Episode) -> float:
    return min(episode.surroundings.surface.row.friction, DRY)
