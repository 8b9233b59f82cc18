"""Who ran into whom, and where: what a watcher tells of a collision."""

from __future__ import annotations

import math

from chatscene.program.deeds import MOVING
from chatscene.terms.episode import Episode, Track, contact_point
from chatscene.terms.vocabulary import Part, Striker

NOSE = 0.5  # [m] behind the foremost point of somebody that are its nose
SIDES_OF: dict[Part, tuple[str, ...]] = {
    Part.FRONT: ("front",),
    Part.REAR: ("rear",),
    Part.LEFT: ("left",),
    Part.RIGHT: ("right",),
    Part.LEFT_FRONT: ("front", "left"),
    Part.RIGHT_FRONT: ("front", "right"),
    Part.LEFT_REAR: ("rear", "left"),
    Part.RIGHT_REAR: ("rear", "right"),
}
"""For each part of the ego, the sides on which a contact with it may be."""


def striker_of(episode: Episode, other: Track) -> Striker:
    """Who runs into whom: whose nose touches a flank or a tail, else who comes nearer by the own motion."""
    collision, ego = episode.collision, episode.ego_track
    assert collision is not None
    before = max(collision.step - 2, 0)
    noses = collision.side == "front", _touches_with_nose(episode, other)
    if noses == (True, False) and ego.speed[before] > MOVING:
        return Striker.EGO
    if noses == (False, True) and abs(other.speed[before]) > MOVING:
        return Striker.OTHER
    dx, dy = float(other.x[before] - ego.x[before]), float(other.y[before] - ego.y[before])
    far = math.hypot(dx, dy) or 1.0

    def toward(track: Track, sign: float) -> float:
        heading, speed = float(track.heading[before]), float(track.speed[before])
        return sign * speed * (math.cos(heading) * dx + math.sin(heading) * dy) / far

    return Striker.EGO if toward(ego, 1.0) >= toward(other, -1.0) else Striker.OTHER


def _touches_with_nose(episode: Episode, other: Track) -> bool:
    """Whether the nose of the other is where it touches the ego."""
    collision = episode.collision
    assert collision is not None
    x, y = contact_point(episode, collision)
    step = min(collision.step, len(other.x) - 1)
    heading = float(other.heading[step])
    dx, dy = x - float(other.x[step]), y - float(other.y[step])
    ahead = dx * math.cos(heading) + dy * math.sin(heading)
    return ahead > other.length / 2 - NOSE
