"""What formats ask of a body beyond its track: how high it is, and where its axles are."""

from __future__ import annotations

from chatscene.terms.actors import BY_CLASS, height_of_kind
from chatscene.terms.episode import Track


def height_of(track: Track) -> float:
    """The nominal height of an actor [m]."""
    return height_of_kind(track.kind)


def wheelbase_of(track: Track) -> float:
    """The wheelbase of a vehicle [m], whose rear axle is half of it behind the centre; 0 of walkers and things."""
    kind = BY_CLASS.get(track.kind)
    return min(kind.row.limits.wheelbase, track.length) if kind else 0.0
