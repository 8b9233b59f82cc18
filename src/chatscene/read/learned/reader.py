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
from chatscene.read.learned.sequence import situation_of, verdict_of
from chatscene.read.learned.text import prepared
from chatscene.read.learned.weights import PACKAGED, load
from chatscene.read.quotes import unread, without_words
from chatscene.settings import LEARNED
from chatscene.situations.faults import Malformed
from chatscene.terms.reading import Ranked, SituationReading, Verdict
from chatscene.terms.situation import Evidence, Situation

_REASON = "the learned reader found none in its words"
_SURE, _IMPOSSIBLE = 1.0 - 1e-6, 1e-6


@dataclass(frozen=True, slots=True)
class LearnedReader:
    """Reads with what was learned; see `chatscene.read.reader.Reader` for the contract.

    Attributes:
        weights: The file of what was learned.
        slots_alone: Whether texts are read as those are labelled who know slots alone; for measurements.
    """

    weights: Path = field(default=PACKAGED)
    slots_alone: bool = False

    @property
    def name(self) -> str:
        """``learned``."""
        return LEARNED

    def read(self, text: str) -> SituationReading:
        """What a text tells.

        The probability of a situation is that of all sequences that come to it.

        Raises:
            SettingsError: The text is empty or too long.
            SnippetError: The file of what was learned is missing or damaged.
        """
        if not text.strip():
            raise SettingsError("the text is empty; describe a situation")
        if len(text) > LONGEST:
            raise SettingsError(f"the text has {len(text)} characters; describe one situation in at most {LONGEST}")
        written = _decoder(self.weights).written(prepared(text), slots_alone=self.slots_alone)
        verdicts = dict.fromkeys(Verdict, 0.0)
        for one in written:
            verdicts[verdict_of(one.steps)] += math.exp(one.likely)
        ranked = _ranked(text, written)
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


def _ranked(text: str, written: Sequence[Written]) -> tuple[Ranked, ...]:
    """The situations that are not against themselves, the likeliest first, with the probability of all their ways."""
    likely: dict[Situation, float] = {}
    told: dict[Situation, Situation] = {}
    for one in written:
        if verdict_of(one.steps) is not Verdict.SITUATION:
            continue
        try:
            situation = situation_of(one.steps)
        except Malformed:
            continue
        if not situation.others:
            continue
        key = replace(situation, evidence=Evidence())
        likely[key] = likely.get(key, 0.0) + math.exp(one.likely)
        told.setdefault(key, _evident(situation, text, one))
    return tuple(
        Ranked(situation=told[key], probability=p) for key, p in sorted(likely.items(), key=lambda one: -one[1])
    )


def _evident(situation: Situation, text: str, written: Written) -> Situation:
    quoted = {_path(written, at): text[found.low : found.high] for at, found in written.found}
    made = replace(situation, about=text, evidence=Evidence(quoted=quoted))
    return replace(made, evidence=replace(made.evidence, assumed=without_words(made)))


def _path(written: Written, at: int) -> str:
    """The path of the fact that a step gives, with the names and numbers of who does it."""
    steps = written.steps[: at + 1]
    place = steps[-1].place.rstrip("@#")
    others = sum(step.place == "others.kind" for step in steps) - 1
    does = "ego.does.act" if place.startswith("ego.") else "others.does.act"
    last = max((i for i, step in enumerate(steps) if step.place == "others.kind"), default=0)
    deeds = sum(step.place == does for step in (steps if place.startswith("ego.") else steps[last:])) - 1
    path = place.replace("others.", f"others.{'ABCDEFGH'[max(others, 0)]}.", 1)
    return path.replace(".does.", f".does.{deeds}.", 1)


def _trusted(probability: float, scale: float, offset: float) -> float:
    sure = min(max(probability, _IMPOSSIBLE), _SURE)
    return 1 / (1 + math.exp(-(scale * math.log(sure / (1 - sure)) + offset)))
