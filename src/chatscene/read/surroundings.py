"""Light, weather and the state of the road, as a text says them; and what it says of them that no scene has.

They are taken out of the text, so that what else is said is read as it is by day on a dry road.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeVar

from chatscene.read import lexicon as words
from chatscene.terms.scenario import Unused, Why
from chatscene.terms.surroundings import FOLLOWS, Light, Surface, Surroundings, Weather

Member = TypeVar("Member", Light, Weather, Surface)

_MARK = "\N{SECTION SIGN}"
_TOGETHER = re.compile(rf"{_MARK}(?:(?:,|,? and)? ?{_MARK})+")
_PHRASE = re.compile(
    r"(?:\b(?:and|but|while|when|as|because) )?"
    r"(?:\b(?:it|there) (?:is|was|has been|had been) (?:just |already |still )?)?"
    r"(?:\b(?:in|at|during|on|through|under|amid|with|by|because of|due to|despite|from|into) )?"
    rf"(?:\b(?:the|a|an|some|very) )*{_MARK}"
    r"(?: (?:weather|conditions?|day|morning|afternoon|evening|falls?|fell)\b)?"
)
_DEGREE = re.compile(r"\b(heavy|light|torrential|pouring|driving|thick|dense|patchy|slight|steady) $")
_TIDY = (
    (re.compile(r"\s+(?=[,;:.])"), ""),
    (re.compile(r"(?<=[,;:.])(?:\s*[,;:.])+"), ""),
    (re.compile(r"^[\s,;:.]*(?:(?:and|but|when|while|as) )?(?=.)"), ""),
    (re.compile(r"\ban (?=[bcdfghjklmnpqrstvwxyz])"), "a "),
    (re.compile(r"\s+"), " "),
)


@dataclass(frozen=True, slots=True, kw_only=True)
class Heard:
    """What was heard of the surroundings.

    Attributes:
        surroundings: As far as a scene can have them.
        unlike: The words for what no scene has.
        rest: The text without the words for what it has.
    """

    surroundings: Surroundings
    unlike: tuple[Unused, ...]
    rest: str


def hear_surroundings(text: str) -> Heard:
    """What a text says of light, weather and road.

    The darkest light and the worst road that are said count. What is denied ("no rain", "not icy") is not said.

    Args:
        text: In its canonical form.
    """
    unlike = [Unused(said=m[0], why=Why.LIGHT) for m in words.NO_LIGHT.finditer(text)]
    unlike += [Unused(said=m[0], why=Why.WEATHER) for m in words.NO_WEATHER.finditer(text) if not _denied(text, m)]
    left = words.NO_WEATHER.sub(_blank, words.NO_LIGHT.sub(_blank, text))
    surfaces, left = _said(words.SURFACES, left)
    weathers, left = _said(words.WEATHERS, left)
    lights, left = _said(words.LIGHTS, left)
    falling = {weather: hits for weather, hits in weathers.items() if weather is not Weather.CLEAR}
    weather = min(falling, key=lambda one: falling[one][0].start(), default=Weather.CLEAR)
    unlike += [Unused(said=hits[0][0], why=Why.WEATHER) for other, hits in falling.items() if other is not weather]
    light = max(lights, key=[*Light].index, default=Light.DAY)
    surface = max(surfaces, key=[*Surface].index, default=FOLLOWS.get(weather, Surface.DRY))
    if surface is Surface.DRY:
        unlike += [Unused(said=m[0], why=Why.WEATHER) for m in words.SLIPPERY.finditer(left) if not _denied(left, m)]
    if weather is Weather.CLEAR and light is Light.DAY:
        unlike += [Unused(said=m[0], why=Why.WEATHER) for m in words.HARDLY_SEEN.finditer(left)]
    degrees = [found for hits in falling.values() for hit in hits if (found := _DEGREE.search(text[: hit.start()]))]
    unlike += [Unused(said=degree[1], why=Why.DEGREE) for degree in degrees]
    said = (hit for hits in (*surfaces.values(), *weathers.values(), *lights.values()) for hit in hits)
    return Heard(
        surroundings=Surroundings(light=light, weather=weather, surface=surface),
        unlike=tuple(unlike),
        rest=_without(text, [*degrees, *said]),
    )


def _said(table: Mapping[Member, re.Pattern[str]], text: str) -> tuple[dict[Member, list[re.Match[str]]], str]:
    """Which of a table are said, and where; and the text without the words of any."""
    said = {
        member: [hit for hit in pattern.finditer(text) if not _denied(text, hit)] for member, pattern in table.items()
    }
    for pattern in table.values():
        text = pattern.sub(_blank, text)
    return {member: hits for member, hits in said.items() if hits}, text


def _blank(match: re.Match[str]) -> str:
    return "#" * len(match[0])


def _denied(text: str, match: re.Match[str]) -> bool:
    before = words.DENIED.search(text[: match.start()].rstrip())
    return before is not None or re.search(r"\bnot\b|n't\b", match[0]) is not None


def _without(text: str, hits: Sequence[re.Match[str]]) -> str:
    """A text without some phrases, of which a road remains that they spoke of."""
    if not hits:
        return text
    left, end = "", 0
    for hit in sorted(hits, key=lambda hit: hit.start()):
        if hit.start() >= end:
            road = words.OF_A_ROAD.fullmatch(hit[0])
            left += text[end : hit.start()] + (road["road"] if road else _MARK)
            end = hit.end()
    left = _PHRASE.sub("", _TOGETHER.sub(_MARK, left + text[end:]))
    for pattern, tidy in _TIDY:
        left = pattern.sub(tidy, left)
    return left
