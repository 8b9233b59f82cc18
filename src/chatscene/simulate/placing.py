"""A program's placement as a function of its parameters, taken from Scenic's scenario once it has placed one scene.

Of a scene of our world model nothing is drawn: its values are given, and what stands where follows from them. Scenic
works that out anew for each scene, with new objects of some sixty properties and copies of them, of which a value or
two differ. Here what differs is known once for a program on a route; for each scene it alone is worked out, by Scenic's
own functions in Scenic's order, so that every number is the same.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Mapping
from math import hypot
from types import SimpleNamespace
from typing import Any

from scenic.core.distributions import Distribution, needsSampling, underlyingFunction
from scenic.core.dynamics.behaviors import Behavior
from scenic.core.object_types import Point, setDynamicProxyFor
from scenic.core.utils import DefaultIdentityDict
from scenic.core.vectors import Vector, VectorMethodDistribution, VectorOperatorDistribution

from chatscene.simulate.physics import Physics
from chatscene.simulate.simulation import SteppedSimulation, live_of

_OURS = ("chatscene.", "scenic.", "builtins", "math", "operator")
"""Of which modules a function draws nothing; one of a user's may."""
_OF_VECTORS = VectorOperatorDistribution | VectorMethodDistribution  # functions that Scenic counts among what is drawn
_SIZES = ("width", "length", "height")


class NoFunction(Exception):  # noqa: N818 - reads as what it says
    """What a scenario places is more than a function of its parameters."""


class Placement:
    """Where things stand in a program on a route, for any values of its parameters.

    Args:
        scenario: Scenic's scenario of it.
        placed: A scene of it as it began, closed.

    Attributes:
        parameters: The names of what is set in each scene.

    Raises:
        NoFunction: Scenic has to place each of its scenes.
    """

    def __init__(self, scenario: Any, placed: SteppedSimulation) -> None:
        if placed.watched or scenario.userRequirements or scenario.checker.requirements or scenario.externalSampler:
            raise NoFunction
        self._set: dict[str, Any] = {name: node for name, node in scenario.params.items() if name.startswith("OPT_")}
        self.parameters = set(self._set)
        self._params = dict(scenario.params)
        self._objects = tuple(scenario.objects)
        self._like = {id(node): _Like(node, one) for node, one in zip(self._objects, placed.objects, strict=True)}
        self._modules = [self._drawn(names) for names in scenario.behaviorNamespaces.values()]
        if not all(map(needsSampling, self._set.values())):
            raise NoFunction
        named = (value for _, names in self._modules for value in names.values())
        given = {id(node) for node in self._set.values()}
        self._order = tuple(_in_order((*self._params.values(), *named, *self._objects), given))
        self._stays = tuple(node for node in self._objects if not needsSampling(node))

    def _drawn(self, names: Any) -> tuple[dict[str, Any], dict[str, Any]]:
        """A module and those of its names that are another thing in each scene, if none is set while one runs."""
        module: dict[str, Any] | None = getattr(names, "module", None)
        if module is None:
            raise NoFunction
        return module, {n: value for n, value in module.items() if id(value) in self._like or needsSampling(value)}

    def scene(self, values: Mapping[str, float], seed: int, physics: Physics, dt: float) -> SteppedSimulation:
        """A scene at its beginning, with nobody who acts: to be stepped by an engine.

        Args:
            values: Of its parameters.
            seed: Of the scene.
            physics: Its bodies, none made yet.
            dt: Step [s].

        Raises:
            RejectionException: A place that the program asks for is not there.
            CannotPlace: Something cannot be made there.
        """
        random.seed(seed)  # as `chatscene.simulate.staging` does
        found = DefaultIdentityDict()
        for name, node in self._set.items():
            found[node] = values[name]
        for node in (*self._stays, *self._order):
            like = self._like.get(id(node))
            found[node] = node.sampleGiven(found) if like is None else like.made(node, found)
        things = [found[node] for node in self._objects]
        params = {name: found[value] for name, value in self._params.items()}
        simulation = SteppedSimulation(SimpleNamespace(params=params, egoObject=things[0]), physics, dt)
        simulation.begin(things)
        simulation.drawn = {
            id(module): {name: found[value] for name, value in names.items()} for module, names in self._modules
        }
        return simulation


class _Like:
    """An object of the scenes, by one of them: all of its attributes, and which of them depend on parameters.

    All scenes share what does not differ, so nothing may be set on that.
    """

    def __init__(self, node: Any, one: Any) -> None:
        self._kind: type = type(one)
        self._attributes = dict(one.__dict__)
        self._differs = [name for name in node.properties if needsSampling(getattr(node, name))]
        self._sized = any(name in self._differs for name in _SIZES)

    def made(self, node: Any, found: Any) -> Any:
        """The object of a scene, which has its values by its live stand-in."""
        attributes = self._attributes | {name: found[getattr(node, name)] for name in self._differs}
        if self._sized:
            hw, hl, hh = (attributes[name] / 2 for name in _SIZES)
            attributes |= {"hw": hw, "hl": hl, "hh": hh, "radius": hypot(hw, hl, hh)}
        thing = object.__new__(self._kind)
        setDynamicProxyFor(thing, live_of(self._kind, attributes))
        return thing


def _in_order(roots: Iterable[Any], given: set[int]) -> Iterator[Any]:
    """What is worked out for each scene, each after all that it depends on.

    Raises:
        NoFunction: Something of it is drawn, or by a function of a user's.
    """
    done = set(given)

    def of(node: Any) -> Iterator[Any]:
        if id(node) in done or not needsSampling(node):
            return
        done.add(id(node))
        if node._conditioned is not node or not _is_function(node):
            raise NoFunction
        for one in node._dependencies:
            yield from of(one)
        yield node

    for root in roots:
        yield from of(root)


def _is_function(node: Any) -> bool:
    """Whether a value follows from those that it depends on."""
    if isinstance(node, Distribution):
        function = underlyingFunction(vars(node).get("function") or vars(node).get("method"))
        follows = node._deterministic or isinstance(node, _OF_VECTORS)  # pyright: ignore[reportPrivateUsage]
        return follows and (function is None or str(getattr(function, "__module__", "")).startswith(_OURS))
    if isinstance(node, Point):
        return not needsSampling(node.mutationScale) and node.mutationScale == 0
    return isinstance(node, Vector | Behavior)
