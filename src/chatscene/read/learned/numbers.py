"""The amounts in a text, wherever they stand: numbers with units, ranges, bounds, and how much more than the ego's."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from enum import IntEnum

from chatscene.terms.amount import CAR_LENGTH, Acceleration, Amount, Duration, Length, Share, Speed

FIGURES = {
    "half a": 0.5, "a couple of": 2, "one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7,
    "eight": 8, "nine": 9, "ten": 10, "eleven": 11, "twelve": 12, "thirteen": 13, "fourteen": 14, "fifteen": 15,
    "sixteen": 16, "seventeen": 17, "eighteen": 18, "nineteen": 19, "twenty": 20, "twenty-five": 25, "thirty": 30,
    "thirty-five": 35, "forty": 40, "forty-five": 45, "fifty": 50, "fifty-five": 55, "sixty": 60, "sixty-five": 65,
    "seventy": 70, "seventy-five": 75, "eighty": 80, "ninety": 90, "a hundred": 100, "one hundred": 100, "a": 1,
    "an": 1,
}  # fmt: skip
"""Numbers in words."""
UNITS: Mapping[str, tuple[type[Amount], float]] = {
    **{unit: (kind, scale) for kind in (Share, Duration, Acceleration, Length, Speed)
       for unit, scale in kind.UNITS.items() if unit},
    **dict.fromkeys(("km per hour", "kmph", "kms/h", "kilometres per hour", "kilometers per hour", "kilometres an hour",
                     "kilometers an hour", "km per h", "clicks"), (Speed, 1 / 3.6)),
    **dict.fromkeys(("miles per hour", "miles an hour", "mi/h"), (Speed, Speed.UNITS["mph"])),
    **dict.fromkeys(("metres per second", "meters per second", "m per second"), (Speed, 1.0)),
    **dict.fromkeys(("metre", "metres", "meter", "meters", "mtr", "mtrs"), (Length, 1.0)),
    **dict.fromkeys(("kilometre", "kilometres", "kilometer", "kilometers"), (Length, 1000.0)),
    **dict.fromkeys(("centimetre", "centimetres", "centimeter", "centimeters"), (Length, 0.01)),
    **dict.fromkeys(("car-length", "car-lengths", "carlength", "carlengths"), (Length, CAR_LENGTH)),
    **dict.fromkeys(("sec", "secs", "second", "seconds"), (Duration, 1.0)),
    **dict.fromkeys(("minute", "minutes"), (Duration, 60.0)),
    **dict.fromkeys(("m/s/s", "m/sec²", "m/sec2", "m/s**2", "metres per second squared",
                     "meters per second squared"), (Acceleration, 1.0)),
    **dict.fromkeys(("percent", "per cent", "pct"), (Share, 0.01)),
}  # fmt: skip
"""What each unit is of, and how many SI units it has."""
_BOUNDS = {
    "<=": ("at most", "no more than", "not more than", "less than", "under", "below", "up to", "within", "max",
           "maximum", "max.", "<", "<=", "≤"),
    ">=": ("at least", "no less than", "more than", "over", "above", "min", "minimum", "min.", ">", ">=", "≥"),
}  # fmt: skip
_AFTER = {
    "<=": ("or less", "or under", "or below", "at most", "or so at most", "max"),
    ">=": ("or more", "or over", "at least"),
}


def _either(words: Iterable[str]) -> str:
    return "|".join(re.escape(word) for word in sorted(words, key=len, reverse=True))


_NUMBER = rf"(?:(?<![\d.,\w])\d+(?:,\d{{3}}(?!\d))*(?:[.,]\d+)?|(?<!\w)(?:{_either(FIGURES)})(?!\w))"
_UNIT = _either(UNITS)
_OURS = r"(?:us|we|ours?|me|mine|ego|i|you|VUT|AV|SV|test\s+vehicle|subject)"
_ALL = re.compile(
    rf"""(?:(?P<bound>(?<!\w)(?:{_either(_BOUNDS["<="] + _BOUNDS[">="])}))\s*(?:about\s+|some\s+)?)?
    (?P<low>{_NUMBER})
    (?:\s*(?P<first>{_UNIT})?\s*(?:to|and|[-\u2013\u2014]|or)\s*(?P<high>{_NUMBER}))?
    [\s-]*(?P<unit>{_UNIT})(?!\w)
    (?:\s+(?P<than>(?:more|less|faster|slower|quicker)\s+than\s+(?:the\s+)?{_OURS}(?!\w)
        |(?:above|below)\s+(?:(?:our|my|your|the\s+ego's)(?:\s+own)?\s+speed|(?:the\s+)?(?:{_OURS})(?![\w']))
        |(?:faster|slower|quicker)(?!\w))
        (?P<another>\s+than\s)?)?
    (?:,?\s+(?P<after>{_either(_AFTER["<="] + _AFTER[">="])})(?!\w))?""",
    re.VERBOSE | re.IGNORECASE,
)
_LESS = re.compile(r"(?i)less|slower|below")
_BARE = re.compile(rf"{_NUMBER}(?![\w.,]*\d)", re.IGNORECASE)
_SLOWEST, _FASTEST = 5.0, 250.0  # of a number without a unit that is taken for a speed
_ODD = str.maketrans("\u0131\u0130\u017f", "iis")  # letters that patterns which ignore case take for these
_WALKING = re.compile(r"(?i)walking[ -](?:pace|speed)")
WALKING_PACE = Speed(1.4, 1.4)
_LASTS = re.compile(r"(?i)\bfor(?: (?:the|another|some|about|around|at|least|most|up|to|next|last|\w+ly))* $")


_GAP_BEFORE = re.compile(
    r"(?i)\b(?:headway|gap|thw|ttc|time[- ]to[- ]collision)(?:,| of| is| was| about| around| =)* $"
)
_GAP_BEHIND = re.compile(r"(?i)[- ](?:time[- ])?(?:headway|gap|thw|ttc)\b")


class Form(IntEnum):
    """In which form an amount stands in a text."""

    PLAIN = 0
    RANGE = 1
    MOST = 2
    LEAST = 3
    THAN_EGO = 4
    BARE_KMH = 5  # a number without a unit, taken for a speed
    BARE_MPH = 6


@dataclass(frozen=True, slots=True)
class Found:
    """An amount that a text may mean."""

    low: int
    high: int
    amount: Amount
    form: Form = Form.PLAIN


MOST_FOUND = 24
"""Amounts of one text; those after are not read."""


def amounts_in(text: str, edit: int | None = None) -> tuple[Found, ...]:
    """The amounts that the words of a text may mean, in their order; of a bound or a range, its number as well.

    A speed that is so much faster or slower, and not than whom, is so than the ego's, and never a speed by itself.

    Args:
        text: The text.
        edit: Where an edit of what was told begins; what is faster by that, is so than it was.
    """
    text = text.translate(_ODD)
    matches = tuple(_ALL.finditer(text))
    told = len(text) if edit is None else edit
    found = [one for match in matches for one in _compared(match, whom=match.start() >= told)]
    found += [Found(match.start(), match.end(), WALKING_PACE) for match in _WALKING.finditer(text)]
    taken = [(match.start(), match.end()) for match in matches]
    for match in _BARE.finditer(text):
        if not any(low < match.end() and match.start() < high for low, high in taken):
            found += _bare(match)
    return tuple(sorted(dict.fromkeys(found), key=lambda one: (one.low, one.high, one.form)))[:MOST_FOUND]


def lasts(text: str, found: Found) -> bool:
    """Whether the words before a time say that something lasts so long, as in "for 20 s"."""
    return isinstance(found.amount, Duration) and _LASTS.search(text[: found.low]) is not None


def is_gap(text: str, found: Found) -> bool:
    """Whether the words beside a time say that it is between two road users, as in "a headway of 1.2 s"."""
    before, behind = _GAP_BEFORE.search(text[: found.low]), _GAP_BEHIND.match(text, found.high)
    return isinstance(found.amount, Duration) and (before is not None or behind is not None)


def _bare(match: re.Match[str]) -> Iterator[Found]:
    """A number without a unit, as the speed that it may be."""
    number = _number(match[0])
    if _SLOWEST <= number <= _FASTEST:
        for form, unit in ((Form.BARE_KMH, "km/h"), (Form.BARE_MPH, "mph")):
            speed = number * Speed.UNITS[unit]
            yield Found(match.start(), match.end(), Speed(speed, speed), form)


def _compared(match: re.Match[str], *, whom: bool) -> Iterator[Found]:
    """What an amount may mean that is no speed by itself if it is faster, slower, above or below another.

    Args:
        match: The amount.
        whom: Whether it is so only where it is said than whom.
    """
    than = match["than"]
    if than is None or _unit(match["unit"])[0] is not Speed or (whom and " " not in than):
        yield from _meant(match)
    elif match["another"] is None:
        low, high = (_number(match[end] or match["low"]) * _unit(match["unit"])[1] for end in ("low", "high"))
        ends = (-high, -low) if _LESS.match(than) else (low, high)
        yield from _made(Speed, *ends, match.start("low"), match.end("than"), Form.THAN_EGO)


def _meant(match: re.Match[str]) -> Iterator[Found]:
    kind, scale = _unit(match["unit"])
    if match["first"] is not None and _unit(match["first"])[0] is not kind:  # of two quantities, no range
        other, its = _unit(match["first"])
        value = _number(match["low"]) * its
        yield from _made(other, value, value, match.span("low")[0], match.end("first"))
        value = _number(match["high"]) * scale
        yield from _made(kind, value, value, match.start("high"), match.end("unit"))
        return
    start, end, low = match.start("low"), match.end("unit"), _number(match["low"]) * scale
    high = low if match["high"] is None else _number(match["high"]) * scale
    yield from _made(kind, low, high, start, end, Form.PLAIN if match["high"] is None else Form.RANGE)
    if match["high"] is not None:
        return
    for group, table in (("bound", _BOUNDS), ("after", _AFTER)):
        if match[group] is not None:
            most = match[group].lower() in table["<="]
            ends = (float("-inf"), low) if most else (low, float("inf"))
            words = min(match.start(group), start), max(match.end(group), end)
            yield from _made(kind, *ends, *words, Form.MOST if most else Form.LEAST)


def _unit(said: str) -> tuple[type[Amount], float]:
    return UNITS[said.lower() if said.lower() in UNITS else said]


def _made(
    kind: type[Amount], low: float, high: float, start: int, end: int, form: Form = Form.PLAIN
) -> Iterator[Found]:
    try:
        yield Found(start, end, kind(low, high, form is Form.THAN_EGO), form)
    except ValueError:  # it is none, as a range that goes down or 120 % of something
        return


def _number(said: str) -> float:
    if (number := FIGURES.get(said.lower())) is not None:
        return number
    return float(re.sub(r",(?=\d{3}(?!\d))", "", said).replace(",", "."))


_NEAR = 0.02  # of its size, by which an amount may differ from that of the text and still be meant


def same(one: Amount, other: Amount) -> bool:
    """Whether two amounts are the same but for rounding."""
    if type(one) is not type(other) or one.than_ego is not other.than_ego:
        return False
    pairs = ((one.low, other.low), (one.high, other.high))
    return all(math.isclose(a, b, rel_tol=_NEAR) for a, b in pairs)
