"""What is judged: drives of a program, or one that was recorded, each with the ego's route."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from chatscene.terms.episode import Episode
from chatscene.terms.route import Route

Drawing = Callable[[str, tuple[float, float, float, float]], Mapping[str, Any]]
"""The map of a scene, by its id, inside a box (west, south, east, north [m]), as `chatscene.maps.drawing.map_drawing`
gives it."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Watched:
    """One drive.

    Attributes:
        episode: What happened.
        route: The ego's.
        mapped: Whether the route lies on a map, so that the road and who has the right of way are known.
        tested: Whether an ego under test drove, which may avoid what the scene has for it.
        avoidable: Whether a careful driver would have avoided the collision; None without one, or where nobody knows.
        unplayed: What of the program did not take place, in words.
        variant: The number of the set of parameter values; 0 where the file has no such sets.
    """

    episode: Episode
    route: Route
    mapped: bool = True
    tested: bool = True
    avoidable: bool | None = None
    unplayed: tuple[str, ...] = ()
    variant: int = 0


@dataclass(frozen=True, slots=True, kw_only=True)
class Watching:
    """All that is judged.

    Attributes:
        kind: What it is in words, as "Scenic program".
        drives: Those that were driven, or recorded.
        rejected: Why others could not be.
        failed: In how many of these the program itself fails, or does not come to its end.
        notes: What was taken otherwise than it is written, and what ran where.
        drawing: The map about it; None where there is none.
    """

    kind: str
    drives: tuple[Watched, ...]
    rejected: tuple[str, ...] = ()
    failed: int = 0
    notes: tuple[str, ...] = ()
    drawing: Drawing | None = field(default=None, repr=False)
