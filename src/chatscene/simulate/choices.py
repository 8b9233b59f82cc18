"""What a program chooses from its map, enumerated: which of it can be drawn at all.

A program that asks for a right turn, and for a lane to the right of it, chooses an intersection, a lane and a turn, and
then a place on the lane. Scenic draws all of that anew for each scene, and a map on which one turn of a hundred serves
takes thousands of draws. The choices are few and known: here each is tried by itself, and the rest is drawn among those
that serve. Where none does, that is known, too.
"""

from __future__ import annotations

import math
import random
from collections import Counter
from collections.abc import Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from scenic.core.distributions import (
    ConstantSamplable,
    DiscreteRange,
    Distribution,
    RejectionException,
    Samplable,
    needsSampling,
)
from scenic.core.utils import DefaultIdentityDict
from scenic.core.vectors import VectorMethodDistribution, VectorOperatorDistribution

PROBES = 25  # draws by which it is found what is not there
MOST = 2_000  # ways to choose that are tried
LEAST_TRIES, MOST_TRIES, ALL_TRIES = 25, 200, 6_000
"""How often each way is tried, at least and at most, and how often all of them together."""

NOT_THERE = (RejectionException, AttributeError)
_OF_VECTORS = VectorOperatorDistribution | VectorMethodDistribution  # functions that Scenic counts among what is drawn


@dataclass(frozen=True, slots=True)
class Choices:
    """Ways to choose what a program takes from its map.

    Attributes:
        selectors: What is chosen: Scenic's numbers of it.
        ways: The numbers of each way that serves.
        none: Why no way serves; empty where one does.
    """

    selectors: tuple[Any, ...]
    ways: tuple[tuple[int, ...], ...]
    weights: tuple[float, ...]
    none: str = ""

    @contextmanager
    def chosen(self) -> Generator[None]:
        """One of the ways, drawn by how likely it is, while a scene is drawn."""
        way = random.choices(self.ways, self.weights)[0]
        try:
            for selector, number in zip(self.selectors, way, strict=True):
                selector.conditionTo(ConstantSamplable(number))
            yield
        finally:
            for selector in self.selectors:
                selector.conditionTo(selector)


def is_not_there(error: BaseException) -> bool:
    """Whether an exception says that a place of the map is not there."""
    return isinstance(error, RejectionException) or (isinstance(error, AttributeError) and error.obj is None)


def not_there(error: BaseException) -> str:
    """In words, what is not there."""
    if isinstance(error, AttributeError):
        return f"the map has nothing there with the attribute .{error.name}"
    return "a place that the program asks for is not there"


def choices_of(scenario: Any) -> Choices | None:
    """Which ways to choose serve, whatever the values of the parameters.

    Returns:
        None where nothing is chosen of what is not there, or too much.
    """
    faults = _faults(scenario)
    called = {id(value): name for name, one in scenario.names.items() for value in vars(one).values()}
    selectors = tuple(_selectors(faults, called))
    if not selectors:
        return None
    names_of = [called.get(id(selector), "something without a name") for selector in selectors]
    ways, weights, empty = list[tuple[int, ...]](), list[float](), Counter[int]()
    for way, weight in _ways(selectors, (), 1.0, empty):
        ways.append(way)
        weights.append(weight)
        if len(ways) > MOST:
            return None
    if not ways:
        last = max(empty)
        before = f"each of the {empty[last]} choices of {_listed(names_of[:last])} leaves" if last else "the map has"
        return Choices(selectors, (), (), f"{before} nothing to choose {names_of[last]} from")
    tries = min(MOST_TRIES, max(LEAST_TRIES, ALL_TRIES // len(ways)))
    reasons = Counter[str]()
    serve = [_serves(faults, selectors, way, tries, reasons) for way in ways]
    if not any(serve):
        why = reasons.most_common(1)[0][0]
        many = f"each of the {len(ways)} choices" if len(ways) > 1 else "the one choice"
        return Choices(selectors, (), (), f"in {many} of {_listed(names_of)}, drawn {tries} times, {why}")
    kept = [(way, weight) for way, weight, serves in zip(ways, weights, serve, strict=True) if serves]
    return Choices(selectors, tuple(way for way, _ in kept), tuple(weight for _, weight in kept))


def _faults(scenario: Any) -> list[Any]:
    """What could not be worked out in a few draws, in order of how often."""
    found = Counter[int]()
    nodes: dict[int, Any] = {}
    for _ in range(PROBES):
        try:
            Samplable.sampleAll(scenario.dependencies)
        except NOT_THERE as error:
            node = _failing(error) if is_not_there(error) else None
            if node is not None:
                nodes[id(node)] = node
                found[id(node)] += 1
    return [nodes[one] for one, _ in found.most_common()]


def _failing(error: BaseException) -> Any:
    """What Scenic was working out when an exception was raised."""
    found, at = None, error.__traceback__
    while at is not None:
        if at.tb_frame.f_code is Samplable.sample.__code__:
            found = at.tb_frame.f_locals["self"]
        at = at.tb_next
    return found


def _selectors(nodes: Sequence[Any], called: Mapping[int, str]) -> Iterator[Any]:
    """The numbers by which what some nodes depend on is chosen, each after all that it depends on itself.

    A number that depends on what is drawn otherwise, as on a place, is none of them; nor one of a list that is written
    out and has no name, as of the models of cars.
    """
    only_chosen: dict[int, bool] = {}

    def of(node: Any) -> Iterator[Any]:
        if id(node) in only_chosen or not needsSampling(node):
            return
        only_chosen[id(node)] = False  # while it is looked at
        conditioned: Any = node._conditioned
        parts = [one for one in conditioned._dependencies if needsSampling(one)]
        for one in parts:
            yield from of(one)
        chosen = isinstance(node, DiscreteRange) and bool(parts or id(node) in called)
        follows = all(only_chosen[id(one)] for one in parts) and (chosen or _follows(conditioned))
        only_chosen[id(node)] = follows
        if chosen and follows and conditioned is node:
            yield node

    for node in nodes:
        yield from of(node)


def _follows(node: Any) -> bool:
    """Whether a value follows from those that it depends on."""
    if isinstance(node, Distribution):
        return node._deterministic or isinstance(node, _OF_VECTORS)  # pyright: ignore[reportPrivateUsage]
    return isinstance(node, Samplable)


def _ways(
    selectors: Sequence[Any], chosen: tuple[int, ...], weight: float, empty: Counter[int]
) -> Iterator[tuple[tuple[int, ...], float]]:
    """Every way to choose, with how likely it is; where nothing is left to choose from is counted."""
    if len(chosen) == len(selectors):
        yield chosen, weight
        return
    selector = selectors[len(chosen)]
    try:
        low, high = (_value(end, selectors, chosen) for end in (selector.low, selector.high))
    except NOT_THERE as error:
        if not is_not_there(error):
            raise
        low, high = 0, -1
    numbers = range(math.ceil(low), math.floor(high) + 1)
    if not numbers:
        empty[len(chosen)] += 1
    for k, number in enumerate(numbers):
        share = selector.weights[k] / sum(selector.weights) if selector.weights else 1 / len(numbers)
        yield from _ways(selectors, (*chosen, number), weight * share, empty)


def _value(node: Any, selectors: Sequence[Any], chosen: Sequence[int]) -> Any:
    return _given(selectors, chosen, node)[0]


def _given(selectors: Sequence[Any], chosen: Sequence[int], *nodes: Any) -> list[Any]:
    """What some nodes are for some choices; the rest is drawn."""
    found = DefaultIdentityDict()
    for selector, number in zip(selectors, chosen, strict=False):
        found[selector] = number
    for node in nodes:
        if needsSampling(node) and node not in found:
            found[node] = node.sample(found)
    return [found[node] for node in nodes]


def _serves(faults: Sequence[Any], selectors: Sequence[Any], way: Sequence[int], tries: int, why: Counter[str]) -> bool:
    """Whether what was not there is there in some draw of a way to choose."""
    for _ in range(tries):
        try:
            _given(selectors, way, *faults)
        except NOT_THERE as error:
            if not is_not_there(error):
                raise
            why[not_there(error)] += 1
        else:
            return True
    return False


def _listed(names: Sequence[str]) -> str:
    return " and ".join((", ".join(names[:-1]), names[-1])) if len(names) > 1 else names[0]
