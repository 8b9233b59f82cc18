"""How far a reading is trusted: the probability that every fact of it is right.

A text of which not every phrase has its place is read twice: clause by clause (`chatscene.read.account`) and by
likelihood (`chatscene.read.slot_classifier`). The first does well on reports, protocols and short notes, the second on
indirect and elaborate stories; where both say the same, either is seldom wrong. What speaks for the first is weighed by
a logistic regression on texts that people of several trades wrote and labelled (`benchmarks/confidence.py`).
"""

from __future__ import annotations

import math

from chatscene.terms.acts import Action
from chatscene.terms.frame import Account, Frame
from chatscene.terms.scenario import Maneuver, Slots

ACCOUNT = {
    "base": 1.25, "unread": -0.20, "share": -2.29, "words": -0.68, "same acts": -0.23, "some acts": -0.37,
    "same kind": 0.10, "same place": 0.35, "same way": 0.33, "placed": 2.23, "touched": 0.95, "acts": 0.21,
    "quiet": -0.03, "others": 0.05, "behavior": 0.23, "facts": 0.51, "done": 0.61, "scope": 0.05,
}  # fmt: skip
"""Weights of `speaks_for_account`."""
FEW = 5  # words of which a share says little
_FAINT = 1e-3


def speaks_for_account(frame: Frame, account: Account, guessed: Slots) -> dict[str, float]:
    """What tells whether what was made out clause by clause is right, by the names in `ACCOUNT`.

    Args:
        frame: What the text says.
        account: What was made out of it clause by clause.
        guessed: What it is likeliest to say, by patterns and classifier.
    """
    slots, words = account.slots, len(frame.told.split())
    does, did = set(slots.actions), set(guessed.actions)
    likeliest = max(frame.beliefs.behaviors.values(), default=0.0)
    return {
        "base": 1.0,
        "unread": math.log1p(len(account.unread)),
        "share": len(account.unread) / max(words, FEW),
        "words": math.log(max(words, 1)),
        "same acts": float(does == did),
        "some acts": float(bool(does & did) and does != did),
        "same kind": float(slots.adversary is guessed.adversary),
        "same place": float(slots.position is guessed.position),
        "same way": float((slots.maneuver or Maneuver.STRAIGHT) is (guessed.maneuver or Maneuver.STRAIGHT)),
        "placed": float(slots.position is not None),
        "touched": float(account.touched),
        "acts": float(len(slots.actions)),
        "quiet": float(does <= {Action.FOLLOW, Action.STAND, Action.SLOW}),
        "others": float(len(slots.others)),
        "behavior": math.log(likeliest + _FAINT),
        "facts": frame.beliefs.facts(slots),
        "done": frame.beliefs.acts(slots.actions),
        "scope": log_odds(frame.beliefs.in_scope, _FAINT),
    }


def log_odds(p: float, faintest: float) -> float:
    """Log-odds of a probability, and of none fainter than the faintest."""
    return math.log((p + faintest) / (1.0 - p + faintest))


def account_is_right(frame: Frame, guessed: Slots) -> float:
    """The probability that what was made out clause by clause is right; 0 where nothing was.

    Args:
        frame: What the text says.
        guessed: What it is likeliest to say, by patterns and classifier.
    """
    if frame.account is None:
        return 0.0
    odds = sum(ACCOUNT[name] * value for name, value in speaks_for_account(frame, frame.account, guessed).items())
    return with_stated_sure(1.0 / (1.0 + math.exp(-odds)), frame, frame.account.slots)


def with_stated_sure(right: float, frame: Frame, slots: Slots) -> float:
    """The probability that every fact is right, once the user stated some: each had a share in the doubt.

    Args:
        right: The probability that every fact is right, if nothing had been stated.
        frame: What the text says, and what the user stated.
        slots: The facts.
    """
    said = slots.said()
    return right ** (1.0 - sum(name in said for name in frame.stated) / len(said)) if said else right
