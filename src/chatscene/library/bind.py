"""Quantities that were said become ranges of parameters: "at 50 km/h" is a speed near 13.9 m/s, not any speed."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, fields, replace

from chatscene.errors import NothingFits, SnippetError
from chatscene.terms.actors import AdversaryKind
from chatscene.terms.scenario import (
    WAITING,
    Distance,
    Place,
    Quantity,
    QuantityKind,
    Scenario,
    Side,
    Slots,
    Unused,
    Why,
    includes,
)
from chatscene.terms.snippet import ParameterRange, Snippet

Triple = tuple[Snippet, Snippet, Snippet]

DECIMALS, ROUNDING = 3, 1e-3  # of a narrowed range, and how far that may step over a declared one
SHARE = 0.1  # of a quantity, to either side: what a person means by a number

_NAMES = {
    QuantityKind.DISTANCE: "OPT_GEO_Y",
    QuantityKind.SPEED: "OPT_ADV_SPEED",
    QuantityKind.TIME: "OPT_STOP_TIME",
    QuantityKind.TRIGGER: "OPT_ADV_DISTANCE",
    QuantityKind.DECELERATION: "OPT_BRAKE",
    QuantityKind.ASIDE: "OPT_SWERVE",
}
_SWERVES = re.compile(
    r"SwerveOnPath\([^,]+, [^,]+, (-?)globalParameters\.OPT_SWERVE\)"
)  # to one side, whoever is where
_BY_THE_EGO = re.compile(r"SwerveOnPath\(.* if offsetFrom\(")
# Other distances start elsewhere, other times are not those for which it stands
_AHEAD_OF_EGO = re.compile(r"how far (?:ahead of|along) the ego")
_BEHIND_EGO = re.compile(r"how far behind the ego")
_STANDING = re.compile(r"how long it (?:pauses|stands|waits|rests|looks|hesitates|is down|bends)")
_SAID_AHEAD = re.compile(r"\b(?:ahead|in front|down the road|up the road|further|beyond|to the front)\b")
_SAID_BEHIND = re.compile(r"\b(?:behind|to the rear)\b")


@dataclass(frozen=True, slots=True)
class Bound:
    """What quantities make of a triple.

    Attributes:
        notes: Quantities that are met only nearly, in words.
        unused: Quantities that none of the snippets can follow.
    """

    triple: Triple
    notes: tuple[str, ...]
    unused: tuple[Unused, ...]


def bound(triple: Triple, scenario: Scenario) -> Bound:
    """Narrow the parameters that quantities speak of, and those that make a start near or far.

    Raises:
        NothingFits: A quantity lies outside of what the snippet can do, by more than a person means by a number.
    """
    notes: list[str] = []
    unused: list[Unused] = []
    parts = list(triple)
    quantities = _for(triple, scenario)
    if scenario.slots.distance is not None and all(q.measure is not QuantityKind.DISTANCE for q in quantities):
        parts = [_begun(part, scenario.slots.distance) for part in parts]
    for quantity in quantities:
        if quantity.measure is QuantityKind.ASIDE:
            swerving = _swerving(parts[0], quantity.value, scenario.slots.side)
            parts[0] = swerving or parts[0]
            unused += [] if swerving else [Unused(said=quantity.said, why=Why.NUMBER)]
            continue
        found = [(i, p) for i, part in enumerate(parts) for p in part.parameters if _speaks_of(quantity, p)]
        if not found:
            unused.append(Unused(said=quantity.said, why=Why.NUMBER))
        for i, parameter in found:
            if parameter.clip(quantity.value) != quantity.value:
                nearest = _in_words(parameter.clip(quantity.value), parameter)
                notes.append(f"{quantity.said!r} is met only nearly: {_range(parameter)}; {nearest} is the nearest")
            parts[i] = _narrowed(parts[i], parameter, quantity)
    return Bound((parts[0], parts[1], parts[2]), tuple(notes), tuple(unused))


def _swerving(behavior: Snippet, aside: float, side: Side | None) -> Snippet | None:
    """A behavior that swerves to a side, 1 the left; None if it does not swerve, or goes by where the ego is."""
    swerves = _SWERVES.search(behavior.source)
    if swerves is None:
        toward_us = _BY_THE_EGO.search(behavior.source) is not None and side is (Side.RIGHT if aside > 0 else Side.LEFT)
        return behavior if toward_us else None
    parameter = next((p for p in behavior.parameters if p.name == _NAMES[QuantityKind.ASIDE]), None)
    if parameter is None:
        return None
    if (aside > 0) == (swerves[1] == "" and parameter.low > 0):
        return behavior
    return _set(behavior, parameter, -parameter.high, -parameter.low)


def _for(triple: Triple, scenario: Scenario) -> tuple[Quantity, ...]:
    """The quantities of a scenario, as the adversary of a triple does them."""
    kind = scenario.slots.adversary or next(k for k in triple[0].adversaries if k in triple[2].adversaries)
    return tuple(as_done(one, kind) for one in (scenario.frame.quantities if scenario.frame else ()))


def as_done(quantity: Quantity, kind: AdversaryKind) -> Quantity:
    """A quantity in the measure of the parameter that it sets: a deceleration is a share of what a kind's brakes do.

    The rest that slows it, a few tenths of m/s², is left out of account.
    """
    if quantity.measure is not QuantityKind.DECELERATION:
        return quantity
    return replace(quantity, value=round(quantity.value / kind.row.limits.brake, DECIMALS))


def distances(snippet: Snippet) -> frozenset[Distance]:
    """How far from the ego a snippet can be told to let its adversary start, or set out if it waits at first."""
    told = frozenset(distance for distance in Distance if _start(snippet, distance) is not None)
    return told | {Distance.NEAR} if snippet.slots.position in WAITING else told


def _start(snippet: Snippet, distance: Distance) -> tuple[ParameterRange, float, float] | None:
    """The parameter that says how far from the ego the adversary starts, and the part of its range that is said."""
    for parameter in snippet.parameters:
        if parameter.name == _NAMES[QuantityKind.DISTANCE] and _from_ego(parameter):
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
            if parameter.name == _NAMES[QuantityKind.ASIDE] and (low, high) == (-parameter.high, -parameter.low):
                parts[i] = _set(parts[i], parameter, low, high)  # to the other side
                continue
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


def out_of_reach(snippet: Snippet, quantities: Sequence[Quantity], kind: AdversaryKind | None) -> int:
    """How many of the quantities a snippet has a parameter for that cannot be set to them, for an adversary."""
    told = [as_done(quantity, _acts(snippet, kind)) for quantity in quantities]
    return sum(_speaks_of(q, p) and not _in_reach(p, q) for q in told for p in snippet.parameters)


def settable(quantity: Quantity, snippets: Sequence[Snippet], kind: AdversaryKind | None) -> bool:
    """Whether some parameter of snippets can be set to a quantity, for an adversary."""
    if quantity.measure is QuantityKind.ASIDE:
        return any(pattern.search(snippet.source) for pattern in (_SWERVES, _BY_THE_EGO) for snippet in snippets)
    told = [(as_done(quantity, _acts(s, kind)), p) for s in snippets for p in s.parameters]
    return any(_speaks_of(one, p) and _in_reach(p, one) for one, p in told)


def _acts(snippet: Snippet, kind: AdversaryKind | None) -> AdversaryKind:
    """Who acts a snippet: who was said, else the first who can."""
    return kind or next(iter(snippet.adversaries), AdversaryKind.CAR)


def _in_reach(parameter: ParameterRange, quantity: Quantity) -> bool:
    about = SHARE * quantity.value
    return parameter.low <= quantity.value + about and quantity.value - about <= parameter.high


def _from_ego(parameter: ParameterRange) -> bool:
    return any(where.match(parameter.meaning) for where in (_AHEAD_OF_EGO, _BEHIND_EGO))


def _speaks_of(quantity: Quantity, parameter: ParameterRange) -> bool:
    """Whether a parameter measures what a quantity does, and on the side of the ego that was said."""
    if quantity.measure is QuantityKind.ASIDE:
        return False  # no range of values is meant
    if parameter.name != _NAMES.get(quantity.measure):
        return False
    if quantity.measure is QuantityKind.TIME:
        return _STANDING.match(parameter.meaning) is not None
    if quantity.measure is not QuantityKind.DISTANCE:
        return True
    other = _BEHIND_EGO if _SAID_AHEAD.search(quantity.said) else None
    other = _AHEAD_OF_EGO if _SAID_BEHIND.search(quantity.said) else other
    return _from_ego(parameter) and (other is None or not other.match(parameter.meaning))


def _narrowed(part: Snippet, parameter: ParameterRange, quantity: Quantity) -> Snippet:
    if not _in_reach(parameter, quantity):
        raise NothingFits(
            f"{quantity.said!r} ({_in_words(quantity.value, parameter)}) cannot be done by {part.id}: "
            f"{_range(parameter)}; say a number in between, or none"
        )
    low = parameter.clip(quantity.value * (1 - SHARE))
    high = parameter.clip(quantity.value * (1 + SHARE))
    return _set(part, parameter, low, high)


def _range(parameter: ParameterRange) -> str:
    return f"{parameter.meaning or parameter.name} lies between {_ends(parameter)}"


def _ends(parameter: ParameterRange) -> str:
    return " and ".join(_in_words(value, parameter) for value in (parameter.low, parameter.high))


def _in_words(value: float, parameter: ParameterRange) -> str:
    """A value with its unit; a speed as drivers say it, too."""
    plain = f"{value:.0%}" if parameter.unit == "1" else f"{value:.3g} {parameter.unit}"
    return f"{plain} ({value * 3.6:.0f} km/h)" if parameter.unit == "m/s" else plain


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


def does(triple: Sequence[Snippet], kind: AdversaryKind) -> Slots:
    """Everything that a compatible triple does, as facts; the more exact place counts."""
    facts: dict[str, object] = {}
    for snippet in triple:
        for f in fields(Slots):
            value, known = getattr(snippet.slots, f.name), facts.get(f.name)
            exact = isinstance(value, Place) and isinstance(known, Place) and includes(value, known)
            if value not in (None, ()) and not exact:
                facts[f.name] = value
    return Slots(**{**facts, "adversary": kind})  # type: ignore[arg-type]
