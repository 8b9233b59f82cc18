"""Step 7 of 9: keep the scenes most worth testing on.

Paper: section 4.2 ("Scene": two of fifty per scenario and route). Released code: ``scenic_runner.py``.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass

from chatscene.errors import SettingsError


@dataclass(frozen=True, slots=True, kw_only=True)
class Candidate:
    """A scene that was driven once by the surrogate ego.

    Attributes:
        scene_id: Which.
        collided: Whether the ego collided.
        shown: Whether its drive showed what was read (`chatscene.program.meaning`).
        avoidable: Whether a careful driver would have avoided the collision; None without one.
        overall_score: Of that one drive, paper mode.
        crash_type: Of which kind the collision is (`chatscene.measure.crash_type`); empty without one.
        waits: Whether the ego waits at the end behind somebody who does not move on.
    """

    scene_id: str
    collided: bool
    shown: bool
    avoidable: bool | None
    overall_score: float
    crash_type: str = ""
    waits: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Selected:
    """A scene that is kept.

    Attributes:
        scene_id: Which.
        fill_in: It did not collide; it is kept because too few did.
    """

    scene_id: str
    fill_in: bool


def select(
    candidates: Iterable[Candidate], *, count: int, selection: str = "distinct", avoidable_only: bool = False
) -> tuple[Selected, ...]:
    """Scenes that show what was said first, of these those that collided, of these the lowest overall scores.

    If too few are so, others fill up, in the same order.

    Args:
        candidates: The scenes of one scenario on one route, in the order in which they were driven.
        count: How many to keep, at least 1.
        selection: One of `chatscene.settings.SELECTIONS`: ``distinct`` keeps of the collisions the avoidable ones
            first, one of each kind before a second of any, and last drives in which the ego only waits; ``shown`` asks
            for neither; ``worst`` keeps collisions, whatever they show (paper); ``last`` keeps the last ones, whatever
            came of them.
        avoidable_only: Never keep a collision that a careful driver would not have avoided.

    Returns:
        At most `count`, in the order of their ids; equal scores are decided by id.

    Raises:
        SettingsError: `count` is below 1.
    """
    if count < 1:
        raise SettingsError(f"at least one scene must be kept, not {count}")
    allowed = [c for c in candidates if not (avoidable_only and c.avoidable is False)]
    if selection == "last":
        best = allowed[-count:]
    elif selection == "distinct":
        best = _distinct(allowed)[:count]
    else:
        blind = selection == "worst"
        best = sorted(allowed, key=lambda c: (not (c.shown or blind), not c.collided, c.overall_score, c.scene_id))
        best = best[:count]
    kept = (Selected(scene_id=c.scene_id, fill_in=not c.collided) for c in best)
    return tuple(sorted(kept, key=lambda s: s.scene_id))


def _distinct(candidates: Iterable[Candidate]) -> list[Candidate]:
    """In the order in which they are worth keeping; a second of a kind comes after the first of every other."""
    found: Counter[object] = Counter()
    order: list[tuple[tuple[bool, ...], int, Candidate]] = []
    for one in sorted(candidates, key=lambda c: (*_rank(c), c.overall_score, c.scene_id)):
        kind = _rank(one), one.crash_type
        order.append((_rank(one), found[kind], one))
        found[kind] += 1
    return [one for _, _, one in sorted(order, key=lambda placed: placed[:2])]


def _rank(candidate: Candidate) -> tuple[bool, bool, bool, bool]:
    return not candidate.shown, not candidate.collided, candidate.waits, candidate.avoidable is False
