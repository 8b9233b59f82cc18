"""Step 7 of 9: keep the scenes most worth testing on.

Paper: section 4.2 ("Scene": two of fifty per scenario and route). Released code: ``scenic_runner.py``.
"""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass

from chatscene.errors import SettingsError


@dataclass(frozen=True, slots=True, kw_only=True)
class Candidate:
    """A scene that was driven once by the surrogate ego.

    Attributes:
        shown: Whether its drive showed what was read (`chatscene.program.meaning`).
        avoidable: Whether a careful driver would have avoided the collision; None without one.
        crash_type: Of which kind the collision is (`chatscene.measure.crash_type`); empty without one.
        waits: Whether the ego waits at the end behind somebody who does not move on.
        happened: Whether anything happened to it: a collision, a near miss, hard braking or evasive steering.
        near: Least gap in time between the ego and an adversary [s]; None where there was none.
        cut: How many facts a contact cut short that were to be seen to their end.
        touch: Whether it was said that there is a contact; None where nothing was said of one.
        distance: Least gap between the ego and an adversary [m]; None where there was none.
    """

    scene_id: str
    collided: bool
    shown: bool
    avoidable: bool | None
    overall_score: float
    crash_type: str = ""
    waits: bool = False
    happened: bool = True
    near: float | None = None
    cut: int = 0
    touch: bool | None = None
    distance: float | None = None

    @property
    def wanted(self) -> bool:
        """Whether it is what a search is for: a collision, or none where it was said that there is none."""
        return self.collided is not (self.touch is False)


@dataclass(frozen=True, slots=True, kw_only=True)
class Selected:
    """A scene that is kept.

    Attributes:
        fill_in: It did not collide, though that was not said; it is kept because too few did.
    """

    scene_id: str
    fill_in: bool


def select(
    candidates: Iterable[Candidate], *, count: int, selection: str = "distinct", avoidable_only: bool = False
) -> tuple[Selected, ...]:
    """Scenes that show what was said first, of these those that collided, then those in which something happened.

    Of those that show it, those come first in which no contact cuts short what was to be seen to its end. Where it was
    said that there is no contact, those come first that have none, and of these the nearest. Else it is the nearest gap
    in time, where nothing collided, and the lowest overall score.

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
        best = sorted(allowed, key=_by_collision if selection == "worst" else _by_what_is_shown)[:count]
    blind = selection in ("worst", "last")
    kept = (Selected(scene_id=c.scene_id, fill_in=not (c.collided if blind else c.wanted)) for c in best)
    return tuple(sorted(kept, key=lambda s: s.scene_id))


def _distinct(candidates: Iterable[Candidate]) -> list[Candidate]:
    """In the order in which they are worth keeping; a second of a kind comes after the first of every other."""
    found: Counter[object] = Counter()
    order: list[tuple[tuple[int, ...], int, Candidate]] = []
    for one in sorted(candidates, key=lambda c: (*_rank(c), *_worst(c))):
        kind = _rank(one), one.crash_type
        order.append((_rank(one), found[kind], one))
        found[kind] += 1
    return [one for _, _, one in sorted(order, key=lambda placed: placed[:2])]


def _by_collision(candidate: Candidate) -> tuple[bool, float, str]:
    return not candidate.collided, candidate.overall_score, candidate.scene_id


def _by_what_is_shown(candidate: Candidate) -> tuple[float | str, ...]:
    return *_first(candidate), not (candidate.collided or candidate.happened), *_worst(candidate)


def _rank(candidate: Candidate) -> tuple[int, ...]:
    dull = not (candidate.collided or candidate.happened)
    return *_first(candidate), dull, candidate.waits, candidate.avoidable is False


def _first(candidate: Candidate) -> tuple[int, ...]:
    """What was said before all else."""
    return not candidate.shown, candidate.cut, not candidate.wanted


def _worst(candidate: Candidate) -> tuple[float, float, str]:
    """The nearest where there is to be no contact, or was none; then the lowest score."""
    far = math.inf if candidate.distance is None else candidate.distance
    near = math.inf if candidate.near is None or candidate.collided else candidate.near
    first = far if candidate.touch is False else 0.0 if candidate.collided else near
    return first, candidate.overall_score, candidate.scene_id
