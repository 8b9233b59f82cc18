"""Who tells it and how: what the ego is called, in which tense; and all chance of a sentence."""

from __future__ import annotations

import random
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeVar

from chatscene.situations.inflection import Form, conjugated
from chatscene.terms.conclusions import LANE_CHANGES
from chatscene.terms.description import Style
from chatscene.terms.scenario import Slots

_T = TypeVar("_T")
PRONOUNS = {"it": "its", "he": "his", "she": "her", "they": "their"}


@dataclass(frozen=True, slots=True)
class Ego:
    """What a sentence calls the ego.

    Attributes:
        subject: As the one who does something.
        object: As the one to whom it is done.
        possessive: In clauses about others.
        own: In its own clause.
        many: Whether its verbs are in the plural, as those of *we* and *I*.
    """

    subject: str
    object: str
    possessive: str
    own: str
    many: bool = False


def _called(name: str, short: str | None = None) -> Ego:
    return Ego(name, short or name, f"{short or name}'s", "its")


_WE = Ego("we", "us", "our", "our", many=True)
_I = Ego("I", "me", "my", "my", many=True)
_OUR_CAR = Ego("our car", "us", "our", "its")
_NAMED = (_called("the ego vehicle"), _called("the ego vehicle", "the ego"), _called("the ego"))
EGOS: dict[Style, tuple[Ego, ...]] = {
    Style.PLAIN: (
        *_NAMED, *_NAMED, _WE, _WE, _OUR_CAR, _called("the test vehicle"), _called("the autonomous vehicle"),
        _called("the self-driving car"), _called("the ego car", "the ego"), _called("the host vehicle"),
    ),
    Style.REPORT: (
        *_NAMED, _called("the subject vehicle"), _called("vehicle 1"), _called("V1"), _OUR_CAR, _WE,
        _called("the test vehicle"), _called("the AV"),
    ),
    Style.TELEGRAM: (_called("ego"), _called("ego vehicle", "ego"), _called("ego car", "ego")),
    Style.PROTOCOL: (
        _called("the VUT"), _called("the vehicle under test", "the VUT"), _called("the ego vehicle"),
        _called("the subject vehicle"), _called("the host vehicle"), _called("the test vehicle"),
    ),
    Style.COLLOQUIAL: (_WE, _WE, _I, _OUR_CAR),
}  # fmt: skip


class Voice:
    """What one telling has decided on.

    Attributes:
        slots: What is to be said.
        style: How it is told.
        past: Whether it is told in the past.
        ego: What the ego is called.
    """

    def __init__(self, slots: Slots, rng: random.Random, style: Style) -> None:
        self.slots = slots
        self.style = style
        self.past = style is Style.REPORT
        self._rng = rng
        self.ego = self.pick(EGOS[style])

    def pick(self, options: Sequence[_T]) -> _T:
        """One of them by chance."""
        return options[int(self._rng.random() * len(options))]

    def chance(self, share: float) -> bool:
        """True in that share of cases."""
        return self._rng.random() < share

    def fill(self, text: str, pronoun: str = "it", origin: str = "") -> str:
        """A phrase with the ego, the side and the adversary's own pronouns filled in."""
        if self.slots.maneuver not in LANE_CHANGES:
            text = text.replace("original ", "")  # only who changes lanes has an original one
        if "{" not in text:
            return text
        text = text.replace("{it} is", "{it} " + self.be(pronoun == "they"))
        named = {
            "ego": self.ego.object,
            "egos": self.ego.possessive,
            "side": self.slots.side or "",
            "its": PRONOUNS[pronoun],
            "it": pronoun,
            "from": origin,
        }
        return text.format_map(named)

    def be(self, many: bool) -> str:
        """*To be* of the third person."""
        if self.past:
            return "were" if many else "was"
        return "are" if many else "is"

    def finite(self, phrase: str, many: bool) -> str:
        """A marked phrase in the tense of the telling."""
        return conjugated(phrase, Form.PAST if self.past else Form.PLURAL if many else Form.SINGULAR)
