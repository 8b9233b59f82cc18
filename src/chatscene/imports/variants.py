"""Sets of parameter values for a scenario: what a file of OpenSCENARIO with a ParameterValueDistribution tells.

Each set of values is a variant. What is drawn from a continuous distribution varies between two ends in all of them,
as a parameter that is searched.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path

from chatscene.errors import ScenarioError
from chatscene.imports.catalogs import relative
from chatscene.imports.given import Refused, finite
from chatscene.imports.stranger_xml import Element

MOST = 1_000_000  # variants of one file
_STEPS = 10_000  # of one range
_WIDE = 3.0  # standard deviations about the mean, between which a parameter varies whose distribution has no ends

Values = Mapping[str, str]
Spans = Mapping[str, tuple[float, float]]


@dataclass(frozen=True, slots=True, kw_only=True)
class Variants:
    """Sets of parameter values.

    Attributes:
        scenario: The file whose parameters they are.
        axes: The values of each parameter, or of several together, of which each variant has one.
        spans: Ends between which parameters vary in all of them.
        ranges: Ends of those whose values are told as a range with steps.
        notes: What was taken otherwise than it is written.
    """

    scenario: Path
    axes: tuple[tuple[Values, ...], ...]
    spans: Spans = field(default_factory=dict[str, tuple[float, float]])
    ranges: Spans = field(default_factory=dict[str, tuple[float, float]])
    notes: tuple[str, ...] = ()

    @property
    def count(self) -> int:
        """How many there are."""
        return math.prod(map(len, self.axes))

    @property
    def names(self) -> frozenset[str]:
        """The parameters whose values they tell."""
        return frozenset(name for axis in self.axes for name in axis[0]) | frozenset(self.spans)

    def number(self, number: int) -> Values:
        """The values of a variant by its number, from 1: the last axis changes first."""
        index, chosen = number - 1, list[Values]()
        for axis in reversed(self.axes):
            index, at = divmod(index, len(axis))
            chosen.append(axis[at])
        return {name: value for one in reversed(chosen) for name, value in one.items()}

    def searched(self) -> Variants:
        """The same, with parameters that vary between the ends of their ranges in the place of their steps."""
        axes = tuple(axis for axis in self.axes if not set(axis[0]) & set(self.ranges))
        told = ", ".join(f"${name}" for name in self.ranges)
        note = f"{self.count} variants are too many programs; searched between their ends instead: {told}"
        spans = {**self.spans, **self.ranges}
        return replace(self, axes=axes, spans=spans, ranges={}, notes=(*self.notes, note))


def variants_of(root: Element, path: Path, within: Path | None = None) -> Variants | None:
    """The variants that a file tells; None where it is no file of variants.

    Raises:
        ScenarioError: It tells them in a way that is not read; the message names the element and the line.
    """
    told = root.find("ParameterValueDistribution")
    if told is None:
        return None
    named = told.find("ScenarioFile")
    where = relative(path, named.attributes.get("filepath", ""), within) if named is not None else None
    if named is None or where is None or where.suffix.lower() != ".xosc":
        raise ScenarioError(f"{path}: it names no scenario by a path from its own folder; write a ScenarioFile")
    if not where.is_file():
        raise ScenarioError(f"{path}: its scenario {str(where)[-200:]!r} does not lie there; put it there")
    notes: list[str] = []
    spans: dict[str, tuple[float, float]] = {}
    ranges: dict[str, tuple[float, float]] = {}
    try:
        axes = list[list[Values]]()
        known = set[str]()
        for one in (one for group in told.all("Deterministic") for one in group.inside):
            axes.append(_axis(one, ranges))
            _bounded(axes, path)
            _once(one, {name for values in axes[-1] for name in values}, known)
        for one in (one for group in told.all("Stochastic") for one in group.all("StochasticDistribution")):
            axes += _drawn(one, spans, notes)
            _bounded(axes, path)
            _once(one, {_name(one)}, known)
    except Refused as reason:
        raise ScenarioError(f"{path}: {reason}") from reason
    return Variants(scenario=where, axes=tuple(map(tuple, axes)), spans=spans, ranges=ranges, notes=tuple(notes))


def _bounded(axes: list[list[Values]], path: Path) -> None:
    """Stop before more is made where there are too many variants already."""
    if math.prod(map(len, axes)) > MOST:
        raise ScenarioError(f"{path} has more than {MOST} variants; remove some")


def _once(one: Element, names: set[str], known: set[str]) -> None:
    """Take the parameters of a distribution among those that are known."""
    if twice := sorted(names & known):
        raise Refused(one, f"the values of ${twice[0]} are given twice; give each parameter's once")
    known |= names


def _axis(one: Element, ranges: dict[str, tuple[float, float]]) -> list[Values]:
    """The values of one parameter, or of several together, of which each variant has one."""
    if one.tag == "DeterministicMultiParameterDistribution":
        sets = [part for part in one.walk() if part.tag == "ParameterValueSet"]
        return [{_name(p): p.attributes.get("value", "") for p in part.inside} for part in sets] or [{}]
    if one.tag != "DeterministicSingleParameterDistribution":
        raise Refused(one, "such values are not read; write sets or a range of them")
    name = _name(one)
    how = one.inside[0] if one.inside else one
    if how.tag == "DistributionSet":
        return [{name: part.attributes.get("value", "")} for part in how.all("Element")] or [{}]
    if how.tag != "DistributionRange":
        raise Refused(how, "such values are not read; write a DistributionSet or a DistributionRange")
    low, high = _ends(how)
    step = _float(how, "stepWidth")
    if step <= 0.0 or (high - low) / step > _STEPS:
        raise Refused(how, f"a range in steps of {step:g} is none")
    if high > low:
        ranges[name] = low, high
    return [{name: f"{low + i * step:.10g}"} for i in range(math.floor((high - low) / step + 1e-9) + 1)]


def _drawn(one: Element, spans: dict[str, tuple[float, float]], notes: list[str]) -> list[list[Values]]:
    """Values that are drawn: each of a set is a variant; what is drawn from a range varies in all of them."""
    name, how = _name(one), one.inside[0] if one.inside else one
    if how.tag == "ProbabilityDistributionSet":
        return [[{name: part.attributes.get("value", "")} for part in how.all("Element")] or [{}]]
    if how.find("Range") is not None:
        spans[name] = _ends(how)
    elif how.tag == "Histogram" and how.all("Bin"):
        ends = [end for part in how.all("Bin") for end in _ends(part)]
        spans[name] = min(ends), max(ends)
    elif how.tag == "NormalDistribution":
        mean, spread = _float(how, "expectedValue"), _WIDE * math.sqrt(max(_float(how, "variance"), 0.0))
        spans[name] = mean - spread, mean + spread
    else:
        raise Refused(how, "such a distribution has no ends that are known; write a Range")
    low, high = spans[name]
    notes.append(f"{how.where}: ${name} varies from {low:g} to {high:g}; how often each value comes is left out")
    return []


def _name(one: Element) -> str:
    for attribute in ("parameterName", "parameterRef"):
        if attribute in one.attributes:
            return one.attributes[attribute].lstrip("$")
    raise Refused(one, "it names no parameter")


def _ends(one: Element) -> tuple[float, float]:
    span = one.find("Range")
    if span is None:
        raise Refused(one, "it has no Range")
    low, high = _float(span, "lowerLimit"), _float(span, "upperLimit")
    if low > high:
        raise Refused(span, f"its ends are {low:g} and {high:g}, the lower first")
    return low, high


def _float(one: Element, name: str) -> float:
    return finite(one, one.attributes.get(name, ""))
