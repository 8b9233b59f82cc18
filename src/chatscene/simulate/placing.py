"""A program's placement as a function of its parameters, taken from Scenic's scenario once it has placed one scene.

Of a scene of our world model nothing is drawn: its values are given, and what stands where follows from them. Scenic
works that out anew for each scene, with new objects of some sixty properties and copies of them, of which a value or
two differ. Here what differs is known once for a program on a route; for each scene it alone is worked out, by Scenic's
own functions in Scenic's order, so that every number is the same.
"""

from __future__ import annotations

import random
from collections.abc import Iterable, Iterator, Mapping, Sequence
from math import hypot
from types import SimpleNamespace
from typing import Any

from scenic.core.distributions import Distribution, OperatorDistribution, needsSampling, underlyingFunction
from scenic.core.dynamics.behaviors import Behavior
from scenic.core.object_types import Point, setDynamicProxyFor
from scenic.core.type_support import TypecheckedDistribution
from scenic.core.utils import DefaultIdentityDict
from scenic.core.vectors import Vector, VectorMethodDistribution, VectorOperatorDistribution

from chatscene.simulate.physics import Physics
from chatscene.simulate.simulation import SteppedSimulation, live_of

_TURNS = ("Orientation.localAnglesFor", "Orientation.fromEuler", "normalizeAngle")
_DIRECTIONS = 4096  # of which each part of a turn is kept
_OURS = ("chatscene.", "scenic.", "builtins", "math", "operator")
"""Of which modules a function draws nothing; one of a user's may."""
_OF_VECTORS = VectorOperatorDistribution | VectorMethodDistribution  # functions that Scenic counts among what is drawn
_SIZES = ("width", "length", "height")
_POSE = frozenset(("position", "heading", "orientation", "yaw", "pitch", "roll", "speed", "velocity"))


class NoFunction(Exception):  # noqa: N818 - reads as what it says
    """What a scenario places is more than a function of its parameters."""


class Placement:
    """Where things stand in a program on a route, for any values of its parameters.

    Attributes:
        parameters: The names of what is set in each scene.
        moved: Of the things of a scene, the ego first, which are elsewhere in another.
        moves: Whether that is all in which its scenes differ, but for names and parameters, and the ego is none of it;
            so that one scene serves for all (`again`).

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
        order = tuple(_in_order((*self._params.values(), *named, *self._objects), given))
        stays = tuple(node for node in self._objects if not needsSampling(node))
        numbers, angles = {id(node): number for number, node in enumerate(self._objects)}, _angles(order)
        self._order = [
            (node, self._like.get(id(node)), numbers.get(id(node), -1), angles.get(id(node)))
            for node in (*stays, *order)
        ]
        self.moved = frozenset(i for i, node in enumerate(self._objects) if self._like[id(node)].differs)
        apart = any(id(of) in self._like for node in order for of in node._dependencies)
        others = any(needsSampling(node) for name, node in self._params.items() if name not in self._set)
        poses = all(_POSE.issuperset(like.differs) for like in self._like.values())
        self.moves = poses and not apart and not others and 0 not in self.moved

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
        found = self._found(values, seed, [None] * len(self._objects))
        things = [found[node] for node in self._objects]
        params = {name: found[value] for name, value in self._params.items()}
        simulation = SteppedSimulation(SimpleNamespace(params=params, egoObject=things[0]), physics, dt)
        simulation.begin(things)
        simulation.drawn = {
            id(module): {name: found[value] for name, value in names.items()} for module, names in self._modules
        }
        return simulation

    def again(self, simulation: SteppedSimulation, values: Mapping[str, float], seed: int, physics: Physics) -> None:
        """Make a scene that `scene` placed another one, if that is all in which they differ (`moves`).

        Raises:
            RejectionException: A place that the program asks for is not there.
            CannotPlace: Something cannot be made there.
        """
        found = self._found(values, seed, simulation.objects)
        for number in self.moved:
            node = self._objects[number]
            attributes = {name: found[getattr(node, name)] for name in self._like[id(node)].differs}
            simulation.put(number, attributes, physics)
        simulation.scene.params.update((name, found[self._set[name]]) for name in self._set)
        for module, names in self._modules:
            simulation.drawn[id(module)].update((name, found[value]) for name, value in names.items())

    def _found(self, values: Mapping[str, float], seed: int, things: Sequence[Any]) -> Any:
        """What everything that is drawn is; things are made, but for those that are given."""
        random.seed(seed)  # as `chatscene.simulate.staging` does
        found = DefaultIdentityDict()
        for name, node in self._set.items():
            found[node] = values[name]
        for node, like, number, angle in self._order:
            if like is not None:
                thing = things[number]
                found[node] = like.made(node, found) if thing is None else thing
            elif angle is not None:
                found[node] = angle.of(node, found)
            else:
                found[node] = node.sampleGiven(found)
        return found


class _Like:
    """An object of the scenes, by one of them: all of its attributes, and which of them depend on parameters.

    All scenes share what does not differ, so nothing may be set on that.
    """

    def __init__(self, node: Any, one: Any) -> None:
        self._kind: type = type(one)
        self._attributes = dict(one.__dict__)
        self.differs = [name for name in node.properties if needsSampling(getattr(node, name))]
        self._sized = any(name in self.differs for name in _SIZES)

    def made(self, node: Any, found: Any) -> Any:
        """The object of a scene, which has its values by its live stand-in."""
        attributes = self._attributes | {name: found[getattr(node, name)] for name in self.differs}
        if self._sized:
            hw, hl, hh = (attributes[name] / 2 for name in _SIZES)
            attributes |= {"hw": hw, "hl": hl, "hh": hh, "radius": hypot(hw, hl, hh)}
        thing = object.__new__(self._kind)
        setDynamicProxyFor(thing, live_of(self._kind, attributes))
        return thing


class _Angle:
    """A part of how something is turned, which follows from one direction alone; scenes have few of these."""

    def __init__(self, direction: Any) -> None:
        self._direction = direction
        self._known: dict[str, Any] = {}

    def of(self, node: Any, found: Any) -> Any:
        """The part of a scene."""
        direction = found[self._direction]
        if type(direction) is not float:
            return node.sampleGiven(found)
        key = direction.hex()  # 0.0 is not -0.0
        if key not in self._known:
            if len(self._known) == _DIRECTIONS:
                self._known.clear()
            self._known[key] = node.sampleGiven(found)
        return self._known[key]


def _angles(order: Iterable[Any]) -> dict[int, _Angle]:
    """Those that are worked out of a direction alone, by identity: Scenic makes a rotation in space of each."""
    found: dict[int, _Angle] = {}
    roots: dict[int, Any] = {}
    for node in order:
        function = underlyingFunction(vars(node).get("function")) if isinstance(node, Distribution) else None
        turns = isinstance(node, TypecheckedDistribution) or getattr(function, "__qualname__", "") in _TURNS
        of = [one for one in getattr(node, "_dependencies", ()) if needsSampling(one)]
        if isinstance(node, OperatorDistribution) and node.operator == "__getitem__":
            turns = all(id(one) in roots for one in of)
        direction = {id(roots.get(id(one), one)): roots.get(id(one), one) for one in of}
        if turns and len(direction) == 1:
            roots[id(node)] = next(iter(direction.values()))
            found[id(node)] = _Angle(roots[id(node)])
    return found


def _in_order(roots: Iterable[Any], given: set[int]) -> Iterator[Any]:
    """What is worked out for each scene, each after all that it depends on."""
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
