"""Quantities that were said become ranges of parameters: "at 50 km/h" is a speed near 13.9 m/s, not any speed."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import replace

from chatscene.errors import NothingFits, SnippetError
from chatscene.terms.scenario import WAITING, Distance, Measure, Quantity, Scenario
from chatscene.terms.snippet import ParameterRange, Snippet

Triple = tuple[Snippet, Snippet, Snippet]

DECIMALS, ROUNDING = 3, 1e-3  # of a narrowed range, and how far that may step over a declared one
SHARE = 0.1  # of a quantity, to either side: what a person means by a number
SLACK = 0.25  # a quantity this share beyond what a snippet can do is done as nearly as it can

_NAMES = {
    Measure.DISTANCE: "OPT_GEO_Y",
    Measure.SPEED: "OPT_ADV_SPEED",
    Measure.TIME: "OPT_STOP_TIME",
    Measure.TRIGGER: "OPT_ADV_DISTANCE",
}
_FROM_EGO = re.compile(r"how far (?:ahead of|behind|along) the ego")  # other distances start elsewhere


def bound(triple: Triple, scenario: Scenario) -> tuple[Triple, tuple[str, ...]]:
    """Narrow the parameters that quantities speak of, and those that make a start near or far.

    Args:
        triple: The snippets.
        scenario: What was said.

    Returns:
        The snippets, with code and header narrowed alike; and a note for each quantity that none of them can follow.

    Raises:
        NothingFits: A quantity lies far outside of what the snippet can do.
    """
    notes: list[str] = []
    parts = list(triple)
    if scenario.slots.distance is not None and all(q.measure is not Measure.DISTANCE for q in scenario.quantities):
        parts = [_begun(part, scenario.slots.distance) for part in parts]
    for quantity in scenario.quantities:
        found = [(i, p) for i, part in enumerate(parts) for p in part.parameters if _speaks_of(quantity, p)]
        if not found:
            notes.append(f"{quantity.said!r} was heard, but nothing in these snippets can be set to it")
        for i, parameter in found:
            parts[i] = _narrowed(parts[i], parameter, quantity)
    return (parts[0], parts[1], parts[2]), tuple(notes)


def distances(snippet: Snippet) -> frozenset[Distance]:
    """How far from the ego a snippet can be told to let its adversary start, or set out if it waits at first."""
    told = frozenset(distance for distance in Distance if _start(snippet, distance) is not None)
    return told | {Distance.NEAR} if snippet.slots.position in WAITING else told


def _start(snippet: Snippet, distance: Distance) -> tuple[ParameterRange, float, float] | None:
    """The parameter that says how far from the ego the adversary starts, and the part of its range that is said."""
    for parameter in snippet.parameters:
        if parameter.name == _NAMES[Measure.DISTANCE] and _FROM_EGO.match(parameter.meaning):
            least, most = distance.bounds(snippet.slots.position)
            low = parameter.low if distance is Distance.NEAR else max(parameter.low, least)
            high = min(parameter.high, most)
            return (parameter, low, high) if low < high else None
    return None


def narrowed(triple: Triple, ranges: Mapping[str, tuple[float, float]]) -> Triple:
    """A triple with the ranges that `bound` gave it once, by parameter; nothing is read for it.

    Raises:
        SnippetError: A range lies outside of what its snippet can do.
    """
    parts = list(triple)
    for i, part in enumerate(triple):
        for parameter in part.parameters:
            low, high = ranges.get(parameter.name, (parameter.low, parameter.high))
            if not parameter.low - ROUNDING <= low <= high <= parameter.high + ROUNDING:
                raise SnippetError(
                    f"{parameter.name} of {part.id} lies between {parameter.low:g} and {parameter.high:g}, "
                    f"not {low:g} and {high:g}"
                )
            parts[i] = _set(parts[i], parameter, low, high)
    return parts[0], parts[1], parts[2]


def _begun(part: Snippet, distance: Distance) -> Snippet:
    """A snippet whose adversary starts near or far, if it can be told so."""
    start = _start(part, distance)
    return part if start is None else _set(part, *start)


def out_of_reach(snippet: Snippet, quantities: Sequence[Quantity]) -> int:
    """How many of the quantities a snippet has a parameter for that cannot be set to them."""
    return sum(_speaks_of(q, p) and not _in_reach(p, q) for q in quantities for p in snippet.parameters)


def _in_reach(parameter: ParameterRange, quantity: Quantity) -> bool:
    reach = SLACK * max(abs(quantity.value), 1.0)
    return parameter.low - reach <= quantity.value <= parameter.high + reach


def _speaks_of(quantity: Quantity, parameter: ParameterRange) -> bool:
    if parameter.name != _NAMES[quantity.measure]:
        return False
    return quantity.measure is not Measure.DISTANCE or _FROM_EGO.match(parameter.meaning) is not None


def _narrowed(part: Snippet, parameter: ParameterRange, quantity: Quantity) -> Snippet:
    if not _in_reach(parameter, quantity):
        raise NothingFits(
            f"{part.id} cannot do {quantity.said!r} ({quantity.value:g} {parameter.unit}): "
            f"{parameter.meaning or parameter.name} lies between {parameter.low:g} and {parameter.high:g} "
            f"{parameter.unit}; say a number in between, or none"
        )
    low = parameter.clip(quantity.value * (1 - SHARE))
    high = parameter.clip(quantity.value * (1 + SHARE))
    return _set(part, parameter, low, high)


def _set(part: Snippet, parameter: ParameterRange, low: float, high: float) -> Snippet:
    """A snippet with a narrower range, in code and header alike."""
    if (low, high) == (parameter.low, parameter.high):
        return part
    told = replace(parameter, low=round(low, DECIMALS), high=round(high, DECIMALS))
    line = re.compile(rf"^(param {parameter.name} = Range)\([^)]*\)", re.MULTILINE)
    return replace(
        part,
        parameters=tuple(told if p is parameter else p for p in part.parameters),
        source=line.sub(rf"\1({told.low:g}, {told.high:g})", part.source),
    )
