"""What is found of each fact over all drives, and what that comes to."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from statistics import median
from typing import Any

from chatscene.terms.episode import Episode


class Answer(StrEnum):
    """What drives show of a fact."""

    SHOWN = "shown"
    IN_PART = "in part"  # by some of the drives that came to it
    NOT_SHOWN = "not shown"
    NOT_REACHED = "not reached"  # no drive came to it
    NOT_SEEN = "not seen"  # no track can tell


@dataclass(frozen=True, slots=True, kw_only=True)
class Seen:
    """What one drive shows of a fact.

    Attributes:
        draw: Which drive, from 0.
        shown: Whether it is seen; None where the drive did not come to it, or no track tells.
        told: What was said, and what is seen, in words.
        at: When [s]; None for what has no moment.
    """

    draw: int
    shown: bool | None
    told: str
    at: float | None


@dataclass(frozen=True, slots=True, kw_only=True)
class Fact:
    """A fact that was said, and what drives show of it.

    Attributes:
        path: Of the fact, as ``others.A.does.0.act``; ``encounter.A`` is that the ego could meet A, ``unasked.…`` what
            nobody said.
        said: Its value.
        seen: What each drive shows that has anything to do with it.
        untold: Whether no track can tell it.
        assumed: Whether no words gave it, so that nothing is asked of it.
        instead: What is seen in its place.
    """

    path: str
    said: str = ""
    seen: tuple[Seen, ...] = ()
    untold: bool = False
    assumed: bool = False
    instead: str = ""

    @property
    def judged(self) -> tuple[Seen, ...]:
        """Those that came to it."""
        return tuple(one for one in self.seen if one.shown is not None)

    @property
    def shown(self) -> int:
        """In how many it is seen."""
        return sum(one.shown is True for one in self.seen)

    @property
    def answer(self) -> Answer:
        """What they show together."""
        if not self.judged:
            return Answer.NOT_SEEN if self.untold else Answer.NOT_REACHED
        if self.shown == len(self.judged):
            return Answer.SHOWN
        return Answer.IN_PART if self.shown else Answer.NOT_SHOWN

    @property
    def at(self) -> float | None:
        """When it is seen [s], in the middle of the drives that show it."""
        times = [one.at for one in self.seen if one.shown and one.at is not None]
        return median(times) if times else None

    def fails(self, least: float) -> bool:
        """Whether fewer drives than such a share of those that came to it show it."""
        return not self.assumed and bool(self.judged) and self.shown < least * len(self.judged)

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        return {
            "fact": self.path,
            "said": self.said,
            "answer": self.answer.value,
            "shown": self.shown,
            "of": len(self.judged),
            "at": self.at,
            "assumed": self.assumed,
            "instead": self.instead,
            "draws": [{"draw": one.draw, "shown": one.shown, "at": one.at, "told": one.told} for one in self.seen],
        }


@dataclass(frozen=True, slots=True, kw_only=True)
class Draw:
    """One drive in short.

    Attributes:
        number: From 0.
        begin: From when on it is judged [s].
        seconds: For how long.
        ending: Why it ended.
        collision: Whom the ego touched; empty if nobody.
        at: When they touched [s].
        impact: The speed of approach then [m/s].
        avoidable: Whether a careful driver would have avoided that; None without a collision, or where nobody knows.
        missing: What it does not show, a sentence each.
        variant: The number of the set of parameter values; 0 where there are no such sets.
    """

    number: int
    begin: float
    seconds: float
    ending: str
    collision: str = ""
    at: float | None = None
    impact: float | None = None
    avoidable: bool | None = None
    missing: tuple[str, ...] = ()
    variant: int = 0

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        return {
            "draw": self.number,
            "begin": self.begin,
            "seconds": self.seconds,
            "ending": self.ending,
            "collision": self.collision or None,
            "at": self.at,
            "impact_speed": self.impact,
            "avoidable": self.avoidable,
            "missing": list(self.missing),
            "variant": self.variant or None,
        }


@dataclass(frozen=True, slots=True, kw_only=True)
class Verdict:
    """Whether something shows what was said.

    Attributes:
        what: What was judged, as it was named.
        kind: What it is.
        told: What was said, in plain sentences.
        situation: The same as a file has it.
        not_read: Words of a text that gave no fact.
        draws: The drives.
        rejected: Why others could not be made.
        facts: What was said.
        encounters: Whether the ego could meet each of those who are to meet it.
        unasked: What happened that nobody said.
        nearest: How near [m] each adversary comes to the ego, in the drive in which it comes nearest; 0 if they touch.
        dead: What makes the scene none: nobody drives, or nothing moves.
        notes: What else is to be known.
        who: The road user of the scene in whom each of the situation is seen, by id.
        least: The share of the drives that must show a fact.
        played: The drives, with everybody named as in the situation, for pictures.
    """

    what: str
    kind: str
    told: str
    situation: Mapping[str, Any]
    not_read: tuple[str, ...] = ()
    draws: tuple[Draw, ...] = ()
    rejected: tuple[str, ...] = ()
    facts: tuple[Fact, ...] = ()
    encounters: tuple[Fact, ...] = ()
    unasked: tuple[Fact, ...] = ()
    nearest: Mapping[str, float] = field(default_factory=dict[str, float])
    dead: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    who: Mapping[str, str] = field(default_factory=dict[str, str])
    least: float = 0.5
    played: tuple[Episode, ...] = field(default=(), repr=False, compare=False)

    @property
    def failing(self) -> tuple[Fact, ...]:
        """What is not shown, and what happened unasked, in too many drives."""
        return tuple(one for one in (*self.facts, *self.encounters, *self.unasked) if one.fails(self.least))

    @property
    def judged(self) -> bool:
        """Whether anything could be judged: there is a drive, and it shows or does not show a fact."""
        return bool(self.draws) and any(one.judged and not one.assumed for one in self.facts)

    @property
    def status(self) -> int:
        """0 if all facts that could be judged are shown, 1 if something is not, 2 if nothing could be judged."""
        if not self.judged:
            return 2
        return 1 if self.failing or self.dead else 0

    @property
    def crashes(self) -> tuple[Draw, ...]:
        """Drives in which the ego touched somebody."""
        return tuple(one for one in self.draws if one.collision)

    def as_dict(self) -> dict[str, Any]:
        """For a script."""
        crashes = self.crashes
        return {
            "what": self.what,
            "kind": self.kind,
            "status": self.status,
            "verdict": VERDICTS[self.status],
            "told": self.told,
            "situation": dict(self.situation),
            "not_read": list(self.not_read),
            "who": dict(self.who),
            "least": self.least,
            "facts": [one.as_dict() for one in self.facts],
            "encounters": [one.as_dict() for one in self.encounters],
            "unasked": [one.as_dict() for one in self.unasked],
            "nearest": {who: round(gap, 3) for who, gap in self.nearest.items()},
            "dead": list(self.dead),
            "collisions": len(crashes),
            "avoidable": sum(one.avoidable is True for one in crashes),
            "draws": [one.as_dict() for one in self.draws],
            "rejected": list(self.rejected),
            "notes": list(self.notes),
        }

    def __str__(self) -> str:
        """For a person."""
        from chatscene.verdict.words import in_words

        return in_words(self)


VERDICTS = ("shown", "not shown", "nothing could be judged")
"""What a verdict comes to, by the exit status."""
