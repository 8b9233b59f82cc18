"""What an adversary does in the words of its snippet: the subject of a wording is cut off, the rest is kept."""

from __future__ import annotations

import re
from functools import lru_cache

from chatscene.terms.actors import Manner

_WHO = re.compile(
    r"(?:the|an?) (?:(?:oncoming|crossing|other|neighbouring|parked|waiting|approaching) )*"
    r"(?:car|vehicle|driver|pedestrian|person|walker|cyclist|rider|bicycle|motorcyclist|motorbike|adversary|truck|lorry|bus)"
    r"(?: ahead| beside| in the target lane| in front)?,? (?=(?:[a-z]+ly |at once )?[a-z]+s\b)",
    re.IGNORECASE,
)
_OTHERS = re.compile(
    r"\b(?:it|he|she|they|him|her|his|them|us|we|leader|lead(?:ing)?|somebody|who|which|left|\d+)\b|[:;\"()—]"
    r"|\bright\b(?! (?:before|in front|at|across|into|after|behind|ahead))",
    re.IGNORECASE,
)
_EGO_ACTS = re.compile(
    r"(?:\b(?:that|so|and|while|as|where|until|when|whether|if)|,) the ego(?! ?')|before the ego (?!and )"
)
_ALIEN: dict[Manner, re.Pattern[str]] = {
    Manner.WALKS: re.compile(r"\b(?:rid|driv|pedal|cycl|roll|steer|wheel|throttl|brak|engine|signal|overtak|motor)\w*"),
    Manner.RIDES: re.compile(
        r"\b(?:driv|walk|foot|step|stroll|strid|jog|run|runs|running|sprint|wander|stagger|on foot|car|bonnet)\w*\b"
    ),
    Manner.DRIVES: re.compile(r"\b(?:rid|pedal|walk|foot|step|stroll|strid|jog|saddle|cycl|handlebar)\w*"),
}


@lru_cache(maxsize=16384)
def predicate(text: str, manner: Manner) -> str | None:
    """What a wording of a behavior says of its subject, with the ego marked; None where it cannot be lifted out."""
    found = _WHO.match(text)
    if found is None:
        return None
    said = text[found.end() :].strip().rstrip(".")
    if _OTHERS.search(said) or _EGO_ACTS.search(said) or _ALIEN[manner].search(said) or "{" in said:
        return None
    said = re.sub(r"\bthe ego(?: vehicle)?'s\b", "{egos}", said)
    said = re.sub(r"\bthe ego(?: vehicle| car)?\b", "{ego}", said)
    return re.sub(r"\bits\b", "{its}", said)
