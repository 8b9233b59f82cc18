"""What of a catalogue of traffic situations is served: the questions, and what became of each."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import StrEnum

SHOWN = 0.9  # of the drives of an entry that is told as shown


@dataclass(frozen=True, slots=True, kw_only=True)
class Entry:
    """A situation of a catalogue: it has either a sentence or a program, or a reason why it has none.

    Attributes:
        sentence: What happens, in plain words; empty where it is out of reach. Of a program what is said of it.
        reason: Why no sentence about an ego and other road users can say it; empty where one does.
        program: The file of a program that was imported; empty of what is said in a sentence.
    """

    name: str
    sentence: str = ""
    reason: str = ""
    program: str = ""
    map_name: str = ""


@dataclass(frozen=True, slots=True, kw_only=True)
class Catalogue:
    """A list of situations, in its own order.

    Attributes:
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
class Fared:
    """How one ego fared in the scenes of an entry.

    Attributes:
        scenes: How many it drove, drives that failed among them.
        shown: In how many of them all that was read was seen, every act in order, before it met anything.
        avoidable: How many of these collisions a careful driver would have avoided.
    """

    ego: str
    scenes: int
    shown: int
    collisions: int
    avoidable: int


@dataclass(frozen=True, slots=True, kw_only=True)
class Searched:
    """The run of an entry.

    Attributes:
        folder: The run folder, seen from the desk's.
        counts: Of scenes, as in `run.json`; empty until it is done.
    """

    folder: str
    status: str
    counts: Mapping[str, int]


@dataclass(frozen=True, slots=True, kw_only=True)
class Covered:
    """An entry and what became of it.

    Attributes:
        reasons: Why it is not, the weightiest first; empty if it is.
        slots: What was read in its sentence, in words, by the slot's name.
        unused: What was said and is not in the program, a line for every reason.
        snippet_ids: Behavior, geometry, spawn; empty if it is not served.
        confidence: Of the choice; None if there is none.
        fared: How each ego fared; empty if nothing was driven.
        failures: Why egos were given up in it, by ego.
        missed: What drives did not show, and in how many, the commonest first.
        searched: Its run; None if it has none.
        picture: A moment of a drive, as WebP; empty if none was drawn.
    """

    catalogue: str
    entry: Entry
    answer: Answer
    reasons: tuple[str, ...] = ()
    slots: dict[str, str]
    unused: tuple[str, ...] = ()
    snippet_ids: tuple[str, ...] = ()
    confidence: float | None = None
    fared: tuple[Fared, ...] = ()
    failures: Mapping[str, str] = field(default_factory=dict[str, str])
    missed: tuple[tuple[str, int], ...] = ()
    searched: Searched | None = None
    picture: bytes = field(default=b"", repr=False)

    @property
    def scenes(self) -> int:
        """How many scenes were driven, each as often as there are egos."""
        return sum(fared.scenes for fared in self.fared)

    @property
    def shown(self) -> int:
        """How many of these drives showed all that was read."""
        return sum(fared.shown for fared in self.fared)


@dataclass(frozen=True, slots=True, kw_only=True)
class Tally:
    """How many entries of a catalogue came how far.

    Attributes:
        shown: Of these, those of which a share of `SHOWN` of the drives show all that was read; None if nothing was
            driven.
    """

    entries: int
    in_reach: int
    served: int
    shown: int | None

    @classmethod
    def of(cls, rows: Sequence[Covered]) -> Tally:
        """Count rows."""
        driven = [row for row in rows if row.scenes]
        return cls(
            entries=len(rows),
            in_reach=sum(row.answer is not Answer.OUT_OF_REACH for row in rows),
            served=sum(row.answer is Answer.SERVED for row in rows),
            shown=sum(row.shown >= SHOWN * row.scenes for row in driven) if driven else None,
        )

    def in_words(self) -> str:
        """A line for a person."""
        shown = "" if self.shown is None else f"; {self.shown} shown in at least {100 * SHOWN:.0f} % of the drives"
        return f"{self.served} served of {self.in_reach} in reach, of {self.entries} entries{shown}"
