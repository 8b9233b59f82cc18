"""What of a catalogue of traffic situations is served: the questions, and what became of each."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import StrEnum


@dataclass(frozen=True, slots=True, kw_only=True)
class Entry:
    """A situation of a catalogue: it has either a sentence or a reason why it has none.

    Attributes:
        name: As the catalogue calls it.
        sentence: What happens, in plain words; empty where it is out of reach.
        reason: Why no sentence about an ego and other road users can say it; empty where one does.
    """

    name: str
    sentence: str = ""
    reason: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Catalogue:
    """A list of situations, in its own order.

    Attributes:
        name: Short, such as ``nhtsa``.
        title: For a person.
        entries: The situations; no two have the same name.
    """

    name: str
    title: str
    entries: tuple[Entry, ...]


class Answer(StrEnum):
    """What became of an entry."""

    SERVED = "served"  # read, and there is a program of it
    REFUSED = "refused"  # nothing in the library does it, or no drive shows it
    FAILED = "failed"  # its program cannot be driven on this map
    OUT_OF_REACH = "out of reach"  # no sentence says it


@dataclass(frozen=True, slots=True, kw_only=True)
class Covered:
    """An entry and what became of it.

    Attributes:
        catalogue: Name of its catalogue.
        entry: The entry.
        answer: Whether it is served.
        reasons: Why it is not, the weightiest first; empty if it is.
        slots: What was read in its sentence, in words, by the slot's name.
        unused: What was said and is not in the program, a line for every reason.
        snippet_ids: Behavior, geometry, spawn; empty if it is not served.
        composed: Those of them that were composed of acts, where the others are packaged or a user's own.
        confidence: Of the choice; None if there is none.
    """

    catalogue: str
    entry: Entry
    answer: Answer
    reasons: tuple[str, ...] = ()
    slots: dict[str, str]
    unused: tuple[str, ...] = ()
    snippet_ids: tuple[str, ...] = ()
    composed: tuple[str, ...] = ()
    confidence: float | None = None


@dataclass(frozen=True, slots=True, kw_only=True)
class Tally:
    """How many entries of a catalogue came how far.

    Attributes:
        entries: All.
        in_reach: Those with a sentence.
        served: Of these, those with a program.
    """

    entries: int
    in_reach: int
    served: int

    @classmethod
    def of(cls, rows: Sequence[Covered]) -> Tally:
        """Count rows."""
        return cls(
            entries=len(rows),
            in_reach=sum(row.answer is not Answer.OUT_OF_REACH for row in rows),
            served=sum(row.answer is Answer.SERVED for row in rows),
        )

    def in_words(self) -> str:
        """A line for a person."""
        return f"{self.served} served of {self.in_reach} in reach, of {self.entries} entries"
