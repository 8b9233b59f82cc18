"""How fast the ego drives, where a text says it: a speed belongs to whoever was last the subject of its sentence."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import cache

from chatscene.read.lexicon import EGO, EGO_AS_OBJECT
from chatscene.read.phrases import road_user
from chatscene.read.quantities import number_at
from chatscene.terms.scenario import Measure, Quantity

_ENDS = re.compile(r"[.!?;](?!\d)")
_OTHERS = r"(?:it|he|she|they|who|which|somebody|someone|the (?:other|driver|rider|target|speed limit|limit))"
_WORD = re.compile(r"\S+")


def ego_speed_of(told: str) -> Quantity | None:
    """The first speed that is said of the ego, with the verb before it; None if none is.

    Args:
        told: Lower case, mended and put into the words that patterns know.
    """
    for sentence in _sentences(told):
        subject, since = None, 0
        waiting: Quantity | None = None  # of whom nobody was spoken yet
        at = 0
        while at < len(sentence):
            if (passed := EGO_AS_OBJECT.match(sentence, at)) is not None:
                at = passed.end()
            elif (party := _party().match(sentence, at)) is not None:
                subject, since, at = party["ego"] is not None, party.end(), party.end()
                if waiting is not None:
                    if subject:
                        return replace(waiting, measure=Measure.EGO_SPEED)
                    waiting = None
            elif (number := number_at(sentence, at)) is not None and number[0].measure is Measure.SPEED:
                quantity, at = number
                if subject:
                    said = sentence[since:at].strip(" ,:")
                    return replace(quantity, measure=Measure.EGO_SPEED, said=said)
                waiting = quantity if subject is None else waiting
            else:
                word = _WORD.match(sentence, at)
                at = word.end() if word is not None else at + 1
            at = _skipped(sentence, at)
    return None


def not_of_ego(numbers: Iterable[Quantity], ego: Quantity | None) -> Iterator[Quantity]:
    """The numbers but for the one that is the ego's speed."""
    for one in numbers:
        its = ego is not None and one.measure is Measure.SPEED and one.value == ego.value and one.said in ego.said
        if not its:
            yield one


def _sentences(told: str) -> Iterator[str]:
    start = 0
    for end in _ENDS.finditer(told):
        yield told[start : end.start()]
        start = end.end()
    yield told[start:]


def _skipped(sentence: str, at: int) -> int:
    while at < len(sentence) and sentence[at] == " ":
        at += 1
    return at


@cache
def _party() -> re.Pattern[str]:
    """Whoever a sentence speaks of: the ego, or another."""
    named = re.sub(r"\(\?P<\w+>", "(?:", road_user().pattern)
    return re.compile(rf"(?P<ego>{EGO.pattern})|{named}|{_OTHERS}\b")
