"""How sure a reading may be: its probability, and what of it and of its text goes with being right.

`making.reader.trust` fits the weights on texts that the reader did not learn from. Of all readings of a text, and of
none of them being right, each is as likely as the exponential of its weighted signs.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import pairwise

from chatscene.read.clause_words import tokens_of
from chatscene.read.kinds import is_named, named_in
from chatscene.read.quotes import spans_of
from chatscene.read.users_unread import users_unread
from chatscene.terms.situation import EGO, Situation

OF_A_READING = ("likely", "marked", "waits", "misnamed", "unread", "fewer", "idle", "disorder")
"""The signs of a reading, see `signs_of`."""
OF_NONE = ("rest", "tells", "readings")
"""The signs that none is right: the probability that no reading has, that of a situation, and how many there are, as
logarithms."""
OFFSET = "offset"
Trust = Mapping[str, float]
"""The weight of each sign, and an offset for none being right."""
AS_IT_IS: Trust = {name: float(name in ("likely", "rest")) for name in (*OF_A_READING, *OF_NONE, OFFSET)}
_LEAST = 1e-6  # of a probability
_LEAST_REST = 1e-4


def signs_of(situation: Situation, likely: float, marked: float) -> tuple[float, ...]:
    """The signs of a reading.

    They are the logarithm of its probability, how surely words are marked for its main facts, how many deeds wait for
    something, how many others have words that name another kind, how many road users of the text are nobody, how many
    fewer others there are than nouns of road users, how many others do nothing, and how many deeds are told before the
    one that they follow.
    """
    text, quoted, others = situation.about, situation.evidence.quoted, situation.others
    nouns = {token.word for token in tokens_of(text) if not token.ego and named_in(token.word)}
    named = ((one.kind, quoted.get(f"others.{one.id}.kind", "")) for one in others)
    return (
        math.log(max(likely, _LEAST)),
        marked,
        float(sum(deed.when is not None for _, does in situation.everybody() for deed in does)),
        float(sum(bool(words) and not is_named(kind, words) for kind, words in named)),
        float(len(users_unread(situation, text))),
        float(max(len(nouns) - len(others), 0)),
        float(sum(not one.does for one in others)),
        float(_disorder(situation)),
    )


def _disorder(situation: Situation) -> int:
    """How many deeds of somebody are told before the one that they follow."""
    found = 0
    for who, does in situation.everybody():
        whose = EGO if who == EGO else f"others.{who}"
        words = (situation.evidence.quoted.get(f"{whose}.does.{k}.act", "") for k in range(len(does)))
        told = [spans[0][0] for spans in (spans_of(one, situation.about) for one in words) if spans]
        found += sum(before > after for before, after in pairwise(told))
    return found


def signs_of_none(likely: Sequence[float], tells: float) -> tuple[float, ...]:
    """The signs that none of some readings is right, by their probabilities and that of a situation."""
    return math.log(max(1.0 - sum(likely), _LEAST_REST)), math.log(max(tells, _LEAST)), math.log(max(len(likely), 1))


def sure_of(trust: Trust, readings: Sequence[Sequence[float]], none: Sequence[float]) -> tuple[float, ...]:
    """The probability of each reading, by their signs and those of none being right."""
    scores = [_weighed(trust, OF_A_READING, signs) for signs in readings]
    of_none = _weighed(trust, OF_NONE, none) + trust[OFFSET]
    most = max(*scores, of_none)
    shares = [math.exp(score - most) for score in scores]
    total = sum(shares) + math.exp(of_none - most)
    return tuple(share / total for share in shares)


def _weighed(trust: Trust, names: Sequence[str], signs: Sequence[float]) -> float:
    return sum(trust[name] * sign for name, sign in zip(names, signs, strict=True))
