"""What a text says, before anything of the library is chosen for it: words, facts, and how sure they are.

Paper: section 3.3, step ii. A reader makes a frame once; whoever interprets it is handed the value.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from chatscene.errors import OfferedReading
from chatscene.terms.scenario import Quantity, Slots, Unused
from chatscene.terms.surroundings import Surroundings


@dataclass(frozen=True, slots=True, kw_only=True)
class Clauses:
    """A text, sorted by whom it speaks of."""

    whole: str = ""
    ego: str = ""
    adversary: str = ""


class About(StrEnum):
    """What whoever reads or chooses has to tell of a text; the values are its words for it."""

    NOTHING = "{} says that {}"
    DIFFERENT = "{}: {} read {}, {} {}"
    READER = "read by {}"
    STATED = "stated by the user: {}"
    TAKEN = "the user took reading {}: {}"


@dataclass(frozen=True, slots=True, kw_only=True)
class Note:
    """Something that whoever reads or chooses has to tell.

    Attributes:
        said: What stands in the places of its words.
    """

    about: About
    said: tuple[str, ...] = ()

    def __str__(self) -> str:
        """The note in words for the user."""
        return self.about.format(*self.said)


@dataclass(frozen=True, slots=True, kw_only=True)
class Word:
    """A word of a text, with what became of it; one of which neither a fact nor a reason is known was not read.

    Attributes:
        fact: The fact that it gave: a slot, ``light``, ``weather`` or ``surface``, a measure, ``the ego``, ``contact``.
        besides: Why it is without effect, if that is known.
    """

    text: str
    start: int
    end: int
    fact: str = ""
    besides: str = ""

    @property
    def unread(self) -> bool:
        """Whether it was not read."""
        return not self.fact and not self.besides

    def as_dict(self) -> dict[str, Any]:
        """For a script: with its fact, with why it is without effect, or as not read."""
        became = {"fact": self.fact} if self.fact else {"besides": self.besides} if self.besides else {"unread": True}
        return {"text": self.text, "start": self.start, "end": self.end, **became}


@dataclass(frozen=True, slots=True, kw_only=True)
class Frame:
    """What a text says.

    Attributes:
        text: The text as it was written, printable and with single spaces.
        clauses: The text, sorted by whom it speaks of.
        ego_speed: How fast the ego drives, which no snippet says and a situation does.
        unused: What is in no slot and no quantity.
        reader: The language model that read it; empty for our own reader.
        sure: The probability that every fact is right.
        surroundings: Light, weather and the state of the road.
    """

    text: str = ""
    clauses: Clauses = field(default_factory=Clauses)
    outright: Slots = field(default_factory=Slots)
    quantities: tuple[Quantity, ...] = ()
    ego_speed: Quantity | None = None
    unused: tuple[Unused, ...] = ()
    notes: tuple[Note, ...] = ()
    reader: str = ""
    sure: float = 0.0
    surroundings: Surroundings = field(default_factory=Surroundings)
    words: tuple[Word, ...] = ()
    readings: tuple[OfferedReading, ...] = ()
