"""The mirror image of what is said and of what was driven: left is right, and y and headings change their sign.

A map of left-hand traffic is read as its image in the x axis (`chatscene.maps.left_hand`), on which programs are built,
driven and judged. What is said of such a map, and what comes from it, is on the map itself.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import fields, is_dataclass, replace
from enum import StrEnum
from typing import Any, cast

import numpy as np

from chatscene.terms.amount import Amount
from chatscene.terms.arrays import Array
from chatscene.terms.episode import Episode, Event, SignalTrack, Track
from chatscene.terms.polyline import Polyline
from chatscene.terms.route import Route
from chatscene.terms.situation import Evidence, Other, Situation, When
from chatscene.terms.vocabulary import Part, Side

IN_THE_MIRROR = "The map keeps to the left and is read as its mirror image: here left is right, and y is negative."
"""What a program of such a map says of itself."""

_OPPOSITE = {"left": "right", "right": "left"}
_NEAR_OR_OFF = re.compile(r"\b(?:near|off)[ -]?side\b", re.IGNORECASE)
_LEFT_AND_RIGHT = re.compile(r"\b(left|right)\b(?! of way)(?!-of-way)", re.IGNORECASE)
_LOST = re.compile(r"\bleft (?:out|over|away)\b|\b(?:is|are) left\b(?!-| of\b)", re.IGNORECASE)


def mirrored_words(told: str) -> str:
    """Words of ours with left for right, and right for left.

    What is left out, and who has the right of way, is neither.
    """
    kept = [one.span() for one in _LOST.finditer(told)]

    def other(found: re.Match[str]) -> str:
        if any(first <= found.start() < last for first, last in kept):
            return found[0]
        side = _OPPOSITE[found[0].lower()]
        return side.capitalize() if found[0][0].isupper() else side

    return _LEFT_AND_RIGHT.sub(other, told)


def mirrored_situation(situation: Situation) -> Situation:
    """A situation with left for right; the words that it was read in stay as they are."""
    made = _mirrored(replace(situation, evidence=Evidence()))
    return replace(cast("Situation", made), about=situation.about, map=situation.map, evidence=situation.evidence)


def as_said_on(situation: Situation, *, keeps_left: bool) -> Situation:
    """A situation as its text has it on a map of left-hand traffic; on any other it stays.

    Who reads takes the nearside for the right, and swaps left and right of a text of left-hand traffic, as most maps
    keep to the right. On a map that keeps to the left, a side that words call left or right is that, and one that they
    call by the kerb, or do not name, lies on the other side than it was read on. What comes of it stays if it is asked
    for again.
    """
    evidence = situation.evidence
    if not keeps_left or evidence.keeps_left:
        return situation
    made = mirrored_situation(situation) if evidence.mirrored else _by_the_kerb(situation, "", evidence)
    return replace(cast("Situation", made), evidence=replace(evidence, mirrored=False, keeps_left=True))


def _by_the_kerb(value: Any, path: str, evidence: Evidence) -> Any:
    """A noun, or a part of one, with the sides that its words do not call left or right on the other side."""
    if isinstance(value, Side | Part):
        return _mirrored(value) if _is_by_the_kerb(path, evidence) else value
    if isinstance(value, tuple):
        parts = cast("tuple[Any, ...]", value)
        return tuple(
            _by_the_kerb(one, f"{path}.{one.id if isinstance(one, Other) else n}", evidence)
            for n, one in enumerate(parts)
        )
    if is_dataclass(value) and not isinstance(value, type | Amount | Evidence):
        parts = {one.name: getattr(value, one.name) for one in fields(value)}
        return replace(value, **{name: _by_the_kerb(one, f"{path}.{name}", evidence) for name, one in parts.items()})
    return value


def _is_by_the_kerb(path: str, evidence: Evidence) -> bool:
    """Whether the words of a side, or those of the whole text where it has none of its own, name it by the kerb."""
    fact = path.removeprefix(".")
    own = evidence.quoted.get(fact, "")
    if not own and fact not in evidence.assumed:
        return False  # whoever wrote it down knows the map
    if _LEFT_AND_RIGHT.search(own):
        return False
    return bool(_NEAR_OR_OFF.search(own)) or not any(map(_LEFT_AND_RIGHT.search, evidence.quoted.values()))


def mirrored_drive(episode: Episode) -> Episode:
    """A drive in the mirror."""
    return replace(
        episode,
        tracks=tuple(map(_mirrored_track, episode.tracks)),
        events=tuple(map(_mirrored_event, episode.events)),
        signals=tuple(map(_mirrored_signal, episode.signals)),
    )


def mirrored_route(route: Route) -> Route:
    """A route in the mirror; its id is that of the query that it was found by, and stays."""
    return replace(
        route,
        maneuver=_mirrored(route.maneuver),
        place=_mirrored(route.place),
        line=Polyline(route.line.points * (1.0, -1.0)),
    )


def _mirrored(value: Any) -> Any:
    """A noun, or a part of one."""
    if isinstance(value, StrEnum):
        turned = "-".join(_OPPOSITE.get(part, part) for part in value.value.split("-"))
        known = cast("Mapping[str, Any]", type(value)._value2member_map_)
        return known.get(turned, value)  # nothing is on the other side of the right of way
    if isinstance(value, When):
        return replace(value, after=_mirrored_reference(value.after), during=_mirrored_reference(value.during))
    if isinstance(value, tuple):
        return tuple(map(_mirrored, cast("tuple[Any, ...]", value)))
    if is_dataclass(value) and not isinstance(value, type) and not isinstance(value, Amount):
        return replace(value, **{one.name: _mirrored(getattr(value, one.name)) for one in fields(value)})
    return value


def _mirrored_reference(deed: str | None) -> str | None:
    """Whose deed, and its number or its act, as ``A.turn-left``."""
    if deed is None:
        return None
    who, dot, what = deed.partition(".")
    return f"{who}{dot}{'-'.join(_OPPOSITE.get(part, part) for part in what.split('-'))}"


def _negated(values: Array) -> Array:
    return np.subtract(0.0, values)  # which makes no -0.0


def _mirrored_track(track: Track) -> Track:
    return replace(track, y=_negated(track.y), heading=_negated(track.heading))


def _mirrored_event(event: Event) -> Event:
    return replace(event, side=_OPPOSITE.get(event.side, event.side))


def _mirrored_signal(signal: SignalTrack) -> SignalTrack:
    return replace(signal, y0=0.0 - signal.y0, y1=0.0 - signal.y1)
