"""What a reader makes of a text: the situations that it may tell, how likely each is, and the words left over."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from chatscene.terms.situation import Situation


class Verdict(StrEnum):
    """Whether a text can be played."""

    SITUATION = "situation"
    NO_SITUATION = "no-situation"
    OUT_OF_REACH = "out-of-reach"

    @property
    def said(self) -> str:
        """What it says of a text, in words."""
        return _SAID[self]


_SAID = {
    Verdict.SITUATION: "it tells a situation",
    Verdict.NO_SITUATION: "it tells no dangerous traffic situation",
    Verdict.OUT_OF_REACH: "it tells a situation for which there are no words here, or several, as a report may",
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Ranked:
    """A situation that a text may tell, or a part of one.

    Attributes:
        situation: The situation, with the words that gave each fact as its evidence.
        probability: That every fact of it is right; of a part, whatever else the text tells.
    """

    situation: Situation
    probability: float


@dataclass(frozen=True, slots=True, kw_only=True)
class SituationReading:
    """What a reader makes of a text.

    Attributes:
        text: The text.
        reader: Who read it.
        verdict: Whether it tells a situation.
        reason: Why it tells none, in the reader's own words, if it has any.
        ranked: The situations that it may tell, the likeliest first; none unless the verdict is `Verdict.SITUATION`.
        parts: What is left of one of these if what is less sure is left open: the fullest first, each surer than those
            before it.
        unread: The words that gave no fact of the likeliest one, those first that most often tell one.
        tells: How likely it is that the text tells a situation at all, in [0, 1].
    """

    text: str
    reader: str
    verdict: Verdict
    reason: str = ""
    ranked: tuple[Ranked, ...] = ()
    parts: tuple[Ranked, ...] = ()
    unread: tuple[str, ...] = ()
    tells: float = 1.0
