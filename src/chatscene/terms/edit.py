"""The facts of a situation that have names of their own, and how a sentence is told with its edits."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from chatscene.terms.scenario import Quantity, Slots
from chatscene.terms.surroundings import Surroundings


@dataclass(frozen=True, slots=True, kw_only=True)
class Facts:
    """All facts of a situation that have names of their own."""

    slots: Slots
    surroundings: Surroundings
    quantities: tuple[Quantity, ...]


def with_edits(text: str, edits: Iterable[str]) -> str:
    """A sentence as it was written, and what was changed of it since."""
    return " ".join((text, *(f"(edited: {one})" for one in edits)))
