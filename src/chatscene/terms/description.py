"""Step 1 of 9: sentences that describe scenarios, and how different they are.

Paper: section 3.3, step i.
"""

from __future__ import annotations

from dataclasses import dataclass

from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scenario import BaseScenario, Slots


@dataclass(frozen=True, slots=True, kw_only=True)
class Description:
    """A scenario that was made up from a compatible triple of snippets."""

    text: str
    base: BaseScenario
    adversary: AdversaryKind
    snippet_ids: tuple[str, str, str]
    slots: Slots


@dataclass(frozen=True, slots=True, kw_only=True)
class Diversity:
    """How different descriptions are from each other.

    Attributes:
        distinct_2: Different pairs of neighbouring words, per pair.
        distance: Mean pairwise cosine distance of their embeddings, in [0, 2].
    """

    behaviors: int
    geometries: int
    spawns: int
    kinds: int
    distinct_2: float
    distance: float
