"""The learned reader: one model from a text to ranked situations."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path

from chatscene.read.blows import settled
from chatscene.read.english import check_english
from chatscene.read.learned.decoder import Decoder, Written
from chatscene.read.learned.evidence import marked_in, quoted_of
from chatscene.read.learned.sequence import situation_of, verdict_of
from chatscene.read.learned.text import Read, prepared
from chatscene.read.learned.weights import PACKAGED, load
from chatscene.read.quotes import is_a_duty, unread, without_words
from chatscene.read.reader import check_text
from chatscene.settings import OFFLINE
from chatscene.situations.facts import is_said
from chatscene.situations.faults import Malformed
from chatscene.situations.main_facts import same_in_the_main
from chatscene.terms.reading import Ranked, SituationReading, Verdict
from chatscene.terms.situation import Evidence, Situation

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
        """``offline``."""
        return OFFLINE

    def read(self, text: str) -> SituationReading:
        """What a text tells.

        The probability of a situation is that of all sequences that come to its main facts.

        Raises:
            SettingsError: The text is empty or too long.
            NothingFits: It is not English.
            SnippetError: The file of what was learned is missing or damaged.
        """
        check_text(text)
        check_english(text)
        read = prepared(text)
        written = written_of(read, self.weights)
        verdicts = dict.fromkeys(Verdict, 0.0)
        for one in written:
            verdicts[verdict_of(one.steps)] += math.exp(one.likely)
        ranked = ranked_of(read, written)
        tells = verdicts[Verdict.SITUATION] / sum(verdicts.values())
        verdict = max(verdicts, key=lambda one: verdicts[one])
        if verdict is not Verdict.SITUATION or not ranked:
            refused = max((one for one in Verdict if one is not Verdict.SITUATION), key=lambda one: verdicts[one])
            return SituationReading(text=text, reader=self.name, verdict=refused, tells=tells)
        trust = load(self.weights)
        sure = tuple(replace(one, probability=_trusted(one.probability, trust.scale, trust.offset)) for one in ranked)
        return SituationReading(
            text=text,
            reader=self.name,
            verdict=Verdict.SITUATION,
            ranked=sure,
            unread=unread(sure[0].situation, text),
            tells=tells,
        )


def written_of(read: Read, weights: Path) -> tuple[Written, ...]:
    """The likeliest sequences of a text, the likeliest first."""
    return _decoder(weights).written(read)


@lru_cache(maxsize=2)
def _decoder(weights: Path) -> Decoder:
    return Decoder(load(weights))


@dataclass(frozen=True, slots=True, eq=False)
class Way:
    """A situation that a text may tell.

    Attributes:
        situation: The situation, whose others are called A, B, C….
        probability: That of all sequences that come to it, in [0, 1].
        written: The likeliest of them.
    """

    situation: Situation
    probability: float
    written: Written


def ways_of(written: Sequence[Written]) -> tuple[Way, ...]:
    """The situations that sequences come to and that are not against themselves, the likeliest first."""
    likely: dict[Situation, float] = {}
    first: dict[Situation, Written] = {}
    for one in written:
        if verdict_of(one.steps) is not Verdict.SITUATION:
            continue
        try:
            situation = situation_of(one.steps)
        except Malformed:
            continue
        if situation.others:
            likely[situation] = likely.get(situation, 0.0) + math.exp(one.likely)
            first.setdefault(situation, one)
    return tuple(Way(one, likely[one], first[one]) for one in sorted(likely, key=lambda one: -likely[one]))


def ranked_of(read: Read, written: Sequence[Written]) -> tuple[Ranked, ...]:
    """The situations that differ in the main, the likeliest first.

    The probability of one is that of all sequences that come to a situation with the same main facts, of which it
    is the likeliest.
    """
    told: dict[Way, float] = {}
    for one in (_by_grammar(way, read) for way in ways_of(written)):
        same = next((way for way in told if same_in_the_main(one.situation, way.situation)), one)
        told[same] = told.get(same, 0.0) + one.probability  # each counts for one of them
    ranked = (Ranked(situation=_evident(one.situation, read, one.written), probability=p) for one, p in told.items())
    return tuple(sorted(ranked, key=lambda one: -one.probability))


def _by_grammar(way: Way, read: Read) -> Way:
    """A way whose contact is as the grammar of the text has it.

    It has none that is denied only since somebody has to avoid it: what a driver shall do is not told.
    """
    contact = way.situation.contact
    if contact is None:
        return way
    words = quoted_of(read, way.written).get("contact.happens", "")
    if contact.happens is False and is_a_duty(words, read.text):
        return replace(way, situation=replace(way.situation, contact=None))
    return replace(way, situation=settled(way.situation, read.text, marked_in(read, way.written)))


def _evident(situation: Situation, read: Read, written: Written) -> Situation:
    quoted = {path: words for path, words in quoted_of(read, written).items() if is_said(situation, path)}
    made = replace(situation, about=read.text, evidence=Evidence(quoted=quoted))
    return replace(made, evidence=replace(made.evidence, assumed=without_words(made)))


def _trusted(probability: float, scale: float, offset: float) -> float:
    sure = min(max(probability, _IMPOSSIBLE), _SURE)
    return 1 / (1 + math.exp(-(scale * math.log(sure / (1 - sure)) + offset)))
