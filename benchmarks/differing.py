"""In what two drives differ, to the last bit."""

from __future__ import annotations

from dataclasses import asdict
from typing import Any

import numpy as np

from chatscene.terms.episode import Episode, Track


def differences(one: Episode, other: Episode) -> list[str]:
    """In what two episodes of one scene and ego differ, down to the last bit; empty if in nothing."""
    found = [
        name
        for name in ("ending", "events", "signals", "route_completion", "surroundings", "dt", "reached")
        if _told(one, name) != _told(other, name)
    ]
    found += [
        name
        for name in ("distance_to_route", "off_road")
        if not np.array_equal(getattr(one, name), getattr(other, name))
    ]
    if [_about(track) for track in one.tracks] != [_about(track) for track in other.tracks]:
        return [*found, "who is there"]
    for a, b in zip(one.tracks, other.tracks, strict=True):
        for name in ("x", "y", "heading", "speed"):
            mine, theirs = getattr(a, name), getattr(b, name)
            if not np.array_equal(mine, theirs):
                steps = min(len(mine), len(theirs))
                first = next(iter(np.flatnonzero(mine[:steps] != theirs[:steps]).tolist()), steps)
                found.append(f"{name} of {a.actor} from step {first}")
    return found


def _told(episode: Episode, name: str) -> Any:
    value = getattr(episode, name)
    return [asdict(one) for one in value] if isinstance(value, tuple) else value


def _about(track: Track) -> tuple[Any, ...]:
    return track.actor, track.role, track.kind, track.length, track.width
