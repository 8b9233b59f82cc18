"""Where a text names the ego: in the first person, by the field's names for it, or as the first of numbered units."""

from __future__ import annotations

import re
from dataclasses import dataclass
from functools import lru_cache

from chatscene.read.kinds import nouns_of
from chatscene.terms.vocabulary import UserKind

Span = tuple[int, int]

_FIRST_PERSON = r"(?:I|i|[Mm][ey]|[Mm]ine|[Ww]e|us|[Oo]urs?)"
_VEHICLE = r"(?i:vehicle|car|bus|truck|van)"
_NAMES = rf"""(?i:the\ |an?\ )?(?:
    (?i:ego)(?:[ -]{_VEHICLE})? | (?i:host|subject|test)[ -]{_VEHICLE} | (?:AV|ADS|SV|VUT|SUT|DUT)(?:\ {_VEHICLE})?
    | (?i:vehicle|system)\ (?i:under\ test) | (?i:autonomous|automated|self-driving)\ {_VEHICLE} )"""
_NAMED = re.compile(rf"(?<![\w'\u2019-])(?:{_FIRST_PERSON}|{_NAMES})(?![\w-])", re.VERBOSE)
_NUMBERED = re.compile(
    r"(?i)(?<![\w-])(?:v|veh|vehicle|u|unit|car|d|driver|operator|party)[ .#-]{0,2}(?P<which>[1-9]|[A-C])(?![\w-])"
)


@dataclass(frozen=True, slots=True)
class Naming:
    """Which words of a text name the ego.

    Attributes:
        spans: Where each begins and ends, in the order of the text.
        unit: What the unit is called that is taken for the ego, where units are numbered and no narrator and no name
            of the ego is there; else empty.
        others: Where the other units are named, each by its number; empty where no unit is taken for the ego.
    """

    spans: tuple[Span, ...]
    unit: str = ""
    others: tuple[tuple[str, Span], ...] = ()


@lru_cache(maxsize=32)
def ego_named(text: str) -> Naming:
    """The words of a text that name the ego.

    Of numbered units the first is the ego, as those had it who filled the texts that the offline reader learned from.
    """
    if spans := tuple(found.span() for found in _NAMED.finditer(text)):
        return Naming(spans)
    units = [(found["which"].upper(), found) for found in _NUMBERED.finditer(text)]
    numbers = {which for which, _ in units}
    first = [found for which, found in units if which in ("1", "A")]
    if not first or len(numbers) < 2:
        return Naming(())
    others = tuple((which, found.span()) for which, found in units if found not in first)
    return Naming(tuple(found.span() for found in first), first[0][0], others)


def owned_kind(text: str) -> tuple[UserKind, str] | None:
    """What the ego is by whose it is, as in "our old bus", and the words that say so; None if none do.

    A car is none: that is what an ego is of which nothing is said.
    """
    found = _owned().search(text)
    if found is None:
        return None
    noun = re.sub(r"[\s-]+", " ", found["noun"].lower())
    return next((kind, found[0]) for kind in _driven() if noun in {one.replace("-", " ") for one in nouns_of(kind)})


@lru_cache(maxsize=1)
def _owned() -> re.Pattern[str]:
    nouns = sorted({noun for kind in _driven() for noun in nouns_of(kind)}, key=len, reverse=True)
    said = "|".join(re.escape(noun).replace(r"\ ", r"[\s-]+").replace(r"\-", r"[\s-]+") for noun in nouns)
    return re.compile(
        rf"(?i)(?<![\w'\u2019-])(?:my|our)\s+(?:\w+\s+)?(?P<noun>{said})(?![\w'\u2019-]|\s+(?:driver|stop|lane)\b)"
    )


def _driven() -> tuple[UserKind, ...]:
    return tuple(kind for kind in UserKind if kind.may_be_ego and kind is not UserKind.CAR)
