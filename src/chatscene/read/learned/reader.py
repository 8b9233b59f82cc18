"""The learned reader: one model from a text to ranked situations."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path

from chatscene.errors import SettingsError
from chatscene.read.decompose import LONGEST
from chatscene.read.learned.decoder import Decoder, Written
from chatscene.read.learned.evidence import quoted_of
from chatscene.read.learned.sequence import situation_of, verdict_of
from chatscene.read.learned.text import Read, prepared
from chatscene.read.learned.weights import PACKAGED, load
from chatscene.read.quotes import unread, without_words
from chatscene.settings import LEARNED
from chatscene.situations.faults import Malformed
from chatscene.situations.main_facts import same_in_the_main
from chatscene.terms.reading import Ranked, SituationReading, Verdict
from chatscene.terms.situation import Evidence, Situation

_REASON = "the learned reader found none in its words"
_SURE, _IMPOSSIBLE = 1.0 - 1e-6, 1e-6


@dataclass(frozen=True, slots=True)
class LearnedReader:
    """Reads with what was learned; see `chatscene.read.reader.Reader` for the contract.

    Attributes:
        weights: The file of what was learned.
    """

    weights: Path = field(default=PACKAGED)

    @property
    def name(self) -> str:
        """``learned``."""
        return LEARNED

    def read(self, text: str) -> SituationReading:
        """What a text tells.

        The probability of a situation is that of all sequences that come to its main facts.

        Raises:
            SettingsError: The text is empty or too long.
            SnippetError: The file of what was learned is missing or damaged.
        """
        if not text.strip():
            raise SettingsError("the text is empty; describe a situation")
        if len(text) > LONGEST:
            raise SettingsError(f"the text has {len(text)} characters; describe one situation in at most {LONGEST}")
        read = prepared(text)
        written = _decoder(self.weights).written(read)
        verdicts = dict.fromkeys(Verdict, 0.0)
        for one in written:
            verdicts[verdict_of(one.steps)] += math.exp(one.likely)
        ranked = _ranked(read, written)
        verdict = max(verdicts, key=lambda one: verdicts[one])
        if verdict is not Verdict.SITUATION or not ranked:
            refused = max((one for one in Verdict if one is not Verdict.SITUATION), key=lambda one: verdicts[one])
            return SituationReading(text=text, reader=self.name, verdict=refused, reason=_REASON)
        trust = load(self.weights)
        sure = tuple(replace(one, probability=_trusted(one.probability, trust.scale, trust.offset)) for one in ranked)
        return SituationReading(
            text=text,
            reader=self.name,
            verdict=Verdict.SITUATION,
            ranked=sure,
            settled_by=("",) * len(sure),
            unread=unread(sure[0].situation, text),
        )


@lru_cache(maxsize=2)
def _decoder(weights: Path) -> Decoder:
    return Decoder(load(weights))


def _ranked(read: Read, written: Sequence[Written]) -> tuple[Ranked, ...]:
    """The situations that differ in the main and are not against themselves, the likeliest first.

    The probability of one is that of all sequences that come to a situation with the same main facts, of which it
    is the likeliest.
    """
    likely: dict[Situation, float] = {}
    way: dict[Situation, Written] = {}
    for one in written:
        if verdict_of(one.steps) is not Verdict.SITUATION:
            continue
        try:
            situation = situation_of(one.steps)
        except Malformed:
            continue
        if situation.others:
            likely[situation] = likely.get(situation, 0.0) + math.exp(one.likely)
            way.setdefault(situation, one)
    told: dict[Situation, float] = {}
    for one in sorted(likely, key=lambda one: -likely[one]):
        same = next((before for before in told if same_in_the_main(one, before)), one)  # each counts for one of them
        told[same] = told.get(same, 0.0) + likely[one]
    ranked = (Ranked(situation=_evident(one, read, way[one]), probability=p) for one, p in told.items())
    return tuple(sorted(ranked, key=lambda one: -one.probability))


def _evident(situation: Situation, read: Read, written: Written) -> Situation:
    made = replace(situation, about=read.text, evidence=Evidence(quoted=quoted_of(read, written)))
    return replace(made, evidence=replace(made.evidence, assumed=without_words(made)))


def _trusted(probability: float, scale: float, offset: float) -> float:
    sure = min(max(probability, _IMPOSSIBLE), _SURE)
    return 1 / (1 + math.exp(-(scale * math.log(sure / (1 - sure)) + offset)))
