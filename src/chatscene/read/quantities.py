"""Numbers in a sentence: "about ten metres ahead", "at 50 km/h", "for three seconds", "when we are 15 m away"."""

from __future__ import annotations

import re

from chatscene.terms.scenario import Measure, Quantity

_UNITS = {
    "m": 1.0, "metre": 1.0, "meter": 1.0, "mtr": 1.0, "yard": 0.9144, "yd": 0.9144, "foot": 0.3048, "feet": 0.3048, "ft": 0.3048,
    "car length": 5.0,
    "km/h": 1 / 3.6, "kph": 1 / 3.6, "kmh": 1 / 3.6, "kmph": 1 / 3.6, "mph": 0.44704, "m/s": 1.0,
    "second": 1.0, "sec": 1.0, "s": 1.0,
    "m/s²": 1.0, "g": 9.81,
}  # fmt: skip
_NUMBERS = {
    "a couple of": 2, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7, "eight": 8, "nine": 9,
    "ten": 10, "twelve": 12, "fifteen": 15, "twenty": 20, "twenty-five": 25, "thirty": 30, "thirty-five": 35,
    "forty": 40, "fifty": 50, "sixty": 60, "seventy": 70, "eighty": 80, "a hundred": 100, "one hundred": 100,
    "half a": 0.5, "one": 1, "a": 1,
}  # fmt: skip

_NUMBER = (
    r"(?P<number>(?<![\d.,])\d+(?:,\d{3}(?!\d))*(?:[.,]\d+)?|" + "|".join(sorted(_NUMBERS, key=len, reverse=True)) + ")"
)
_LENGTH = r"(?P<unit>m|metre|meter|mtr|yard|yd|foot|feet|ft|car length)s?"
_SPEED = r"(?P<unit>km/h|kph|kmh|kmph|mph|m/s)(?! ?(?:²|\^?2))"  # m/s² is no speed
_DECELERATION = r"(?P<unit>m/s ?(?:²|\^?2)|g)(?!\w)"
_TIME = r"(?P<unit>second|sec|s)s?"
_SQUARED = re.compile(r" ?(?:²|\^?2)$")
_EGO = r"(?:we|i|the ego(?: vehicle)?|ego|our car|the vut|the av)"

_PATTERNS: tuple[tuple[Measure, re.Pattern[str]], ...] = (
    (
        Measure.TRIGGER,
        re.compile(
            rf"\b(?:when|once|as soon as|while|with) {_EGO}(?: is| are| am|'re|'s| gets?| comes?)? (?:still |only |just |about |within |some )*"
            rf"{_NUMBER}[ -]?{_LENGTH}\b"
        ),
    ),
    (
        Measure.DISTANCE,
        re.compile(
            rf"\b{_NUMBER}[ -]?{_LENGTH} (?:away|ahead|in front|off|down the road|up the road|further|behind|before|beyond|from (?:us|the ego)|to the (?:front|rear))"
        ),
    ),
    (Measure.DISTANCE, re.compile(rf"\bat (?:a )?(?:distance|range|gap) of (?:about |some |roughly )?{_NUMBER}[ -]?{_LENGTH}\b")),
    (Measure.SPEED, re.compile(rf"\b{_NUMBER} ?{_SPEED}")),
    (
        Measure.DECELERATION,
        re.compile(
            r"\b(?:brak|decelerat|slow)(?:[^.,;]| ?[.,](?=\d))*? "
            rf"(?P<said>(?:with|at|by) (?:about |some |around |roughly )?{_NUMBER} ?{_DECELERATION})"
        ),
    ),
    (Measure.TIME, re.compile(rf"\bfor (?:about |some |around |roughly )?{_NUMBER} ?{_TIME}\b")),
)  # fmt: skip


# A speed right behind the ego's name is the ego's, whoever's clause it is in.
_OF_EGO = re.compile(
    rf"\b{_EGO}(?: (?:drives?|drive on|goes?|travels?|moves?))?(?: at| with|:|,)? (?:about |some |around |roughly )?{_NUMBER} ?{_SPEED}"
)


def quantities_of(adversary: str, whole: str) -> tuple[Quantity, ...]:
    """The quantities said of the adversary, the first of each measure, in SI units.

    Args:
        adversary: What is said of the adversary, lower case.
        whole: All that is said; when the adversary acts is often said of the ego.
    """
    found: dict[Measure, Quantity] = {}
    adversary = _OF_EGO.sub("", adversary)
    for measure, pattern in _PATTERNS:
        text = whole if measure in (Measure.TRIGGER, Measure.TIME) else adversary
        match = pattern.search(text)
        if match and measure not in found and not (measure is Measure.DISTANCE and Measure.TRIGGER in found):
            found[measure] = _quantity(measure, match)
    return tuple(found.values())


_SWERVES = (
    r"(?<!\bnot )(?<!n't )(?<!without )\b(?:swerv|veer|lurch|jerk|jink)\w*(?: (?:\w+ly|sharp|hard|out|over|off|away))*"
)
_NOT_TO_BOTH = r"(?!,? (?:and |then |to |the |its )*(?:left|right)\b)"  # who does weaves
_NOT_TO_US = r"(?![^.;]*\b(?:into|onto|towards?|at) (?:us\b|our\b|the ego))"  # which says where the ego is, not a side
_ASIDE = re.compile(
    rf"{_SWERVES} (?:(?:to|towards?) (?:(?:the|its|his|her|their) )?(?P<to>left|right)\b(?!(?:[- ]hand)? (?:lane|turn))"
    r"|(?P<on>left|right)(?=$|[,.;!]| (?:and|then|to avoid|around|round|out|because)\b))" + _NOT_TO_BOTH + _NOT_TO_US
)


def aside_of(text: str) -> tuple[Quantity, ...]:
    """To which side the adversary swerves, if it is said; "right in front of us" says none.

    Args:
        text: What is said of it, lower case, mended.
    """
    if (match := _ASIDE.search(text)) is None:
        return ()
    side = match["to"] or match["on"]
    return (Quantity(measure=Measure.ASIDE, value=1.0 if side == "left" else -1.0, said=match[0]),)


_AT_PLACE: tuple[tuple[Measure, re.Pattern[str]], ...] = (
    (Measure.SPEED, re.compile(rf"(?:at|with) (?:an? )?(?:constant |steady |speed of |about |some |around |roughly )*{_NUMBER} ?{_SPEED}(?!\w)")),
    (Measure.DECELERATION, re.compile(rf"(?:with|at|by) (?:about |some |around |roughly )*{_NUMBER} ?{_DECELERATION}")),
    (Measure.TIME, re.compile(rf"for (?:about |some |around |roughly )?{_NUMBER} ?{_TIME}(?!\w)")),
    (
        Measure.DISTANCE,
        re.compile(rf"(?:about |some |just |only )?{_NUMBER}[ -]?{_LENGTH} (?:away|ahead|in front|behind)(?: of us| from us| us)?(?!\w)"),
    ),
)  # fmt: skip
WALKING_PACE = 1.4  # [m/s]
_WALKING_PACE = re.compile(r"at (?:a )?walking (?:pace|speed)")


def quantity_at(text: str, start: int) -> tuple[Quantity, int] | None:
    """The number that is said at a place in a text, and where it ends; None if there is none.

    Args:
        text: Lower case, mended.
        start: Where it must begin.
    """
    if pace := _WALKING_PACE.match(text, start):
        return Quantity(measure=Measure.SPEED, value=WALKING_PACE, said=pace[0]), pace.end()
    found = [(m, measure) for measure, pattern in _AT_PLACE if (m := pattern.match(text, start))]
    if not found:
        return None
    match, measure = max(found, key=lambda one: one[0].end())
    return _quantity(measure, match), match.end()


_BARE: tuple[tuple[Measure, re.Pattern[str]], ...] = (
    (Measure.TRIGGER, _PATTERNS[0][1]),
    *(
        (measure, re.compile(rf"(?:(?:at|with|by|to|of|for|about|some|roughly|around|only|just|from|exactly) )*{_NUMBER}[ -]?{unit}(?!\w)"))
        for measure, unit in (
            (Measure.SPEED, _SPEED), (Measure.DECELERATION, _DECELERATION),
            (Measure.TIME, _TIME), (Measure.DISTANCE, _LENGTH),
        )
    ),
)  # fmt: skip


def number_at(text: str, start: int) -> tuple[Quantity, int] | None:
    """The number with a unit at a place in a text, whatever stands about it, and where it ends; None if there is none.

    Args:
        text: Lower case, mended.
        start: Where it must begin.
    """
    for measure, pattern in _BARE:
        if (match := pattern.match(text, start)) and match["number"] not in ("a", "one"):
            return _quantity(measure, match), match.end()
    return None


def quantity_or_speed_at(text: str, start: int) -> tuple[Quantity, int] | None:
    """What `quantity_at` finds, or a speed without a word before it, as notes and protocols have it: "5 km/h"."""
    if (said := quantity_at(text, start)) is not None:
        return said
    bare = number_at(text, start)
    return bare if bare is not None and bare[0].measure is Measure.SPEED else None


def _quantity(measure: Measure, match: re.Match[str]) -> Quantity:
    number = _NUMBERS.get(match["number"])
    value = (_number(match["number"]) if number is None else number) * _UNITS[_SQUARED.sub("²", match["unit"])]
    said = match.groupdict().get("said") or match[0]
    return Quantity(measure=measure, value=round(value, 3), said=said)


def _number(figures: str) -> float:
    """A number in figures: "1.5", "1,5" as much of the world writes it, "1,200" as a thousand and more."""
    return float(re.sub(r",(?=\d{3}(?!\d))", "", figures).replace(",", "."))
