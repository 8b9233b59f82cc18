"""Which random numbers of a stranger's program are searched: those at its top level whose limits are written out.

``param EGO_SPEED = VerifaiRange(7, 10)`` and ``EGO_TO_OBSTACLE = Range(-20, -15)`` become the parameters
``OPT_EGO_SPEED`` and ``OPT_EGO_TO_OBSTACLE`` of a search, as do the numbers in ``-1 * Uniform(5, 10)``. The program's
text stays as it is: the call is wrapped where the text is translated, and the wrapper makes the parameter. A choice
among n things is a number from 0 to n of which the whole part counts; a whole number is one that is rounded.
"""

from __future__ import annotations

import ast
import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any, cast

from scenic.core.distributions import Range, distributionFunction
from scenic.syntax import veneer

from chatscene.terms.scene import OWN_MODEL

WRAPPER = "chatscene_parameter"
"""The name of `parameter` in a translated program; its world model imports it."""

_RANGES = frozenset(("Range", "VerifaiRange"))
_WHOLE = frozenset(("DiscreteRange", "VerifaiDiscreteRange"))
_CHOICES = frozenset(("Uniform", "Options", "VerifaiOptions"))
_WITHIN = (ast.UnaryOp, ast.BinOp)  # arithmetic around a random number
_SCENIC_WITHIN = frozenset(("DegOp",))

_deferred = cast("Callable[[Callable[..., Any]], Callable[..., Any]]", distributionFunction)


@dataclass(frozen=True, slots=True)
class Searched:
    """A random number that is searched.

    Attributes:
        name: Of its parameter, ``OPT_…``.
        low: Least value of the parameter.
        high: Largest.
        call: Where it stands in the syntax tree.
    """

    name: str
    low: float
    high: float
    call: ast.Call


def searched(tree: Any) -> tuple[Searched, ...]:
    """The random numbers at the top level of a syntax tree of Scenic's that are searched, in order."""
    found: list[Searched] = []
    for name, value in _assignments(tree):
        calls = [(call, limits) for call in _calls(value) if (limits := _limits(call)) is not None]
        for number, (call, (low, high)) in enumerate(calls, 1):
            own = name if name.startswith("OPT_") else f"OPT_{name.upper()}"
            own = own if number == 1 else f"{own}_{number}"
            if own not in {one.name for one in found}:
                found.append(Searched(own, low, high, call))
    return tuple(found)


def make_searchable(tree: Any) -> None:
    """Wrap, in the syntax tree of a program for a model that is not ours, the random numbers that are searched."""
    if any(type(node).__name__ == "Model" and node.name != OWN_MODEL for node in tree.body):
        for one in searched(tree):
            kind, values = cast("ast.Name", one.call.func).id, _values(one.call)
            one.call.func = ast.Name(WRAPPER, ast.Load())
            one.call.args = [ast.Constant(one.name), ast.Constant(kind), *values]
            ast.fix_missing_locations(one.call)


def parameter(name: str, kind: str, *values: Any) -> Any:
    """What a wrapped random number is: the parameter of a search, or what follows from it.

    Args:
        name: Of the parameter.
        kind: Which function the program calls.
        values: What it is given.
    """
    low, high = _span(kind, values)
    number = Range(low, high)
    veneer.param({name: number})
    if kind in _WHOLE:
        return _rounded(number)
    return _chosen(number, values) if kind in _CHOICES else number


@_deferred
def _rounded(number: float) -> int:
    return round(number)


@_deferred
def _chosen(number: float, values: Any) -> Any:
    return values[min(int(number), len(values) - 1)]


def _assignments(tree: Any) -> Iterator[tuple[str, Any]]:
    """The names that are given a value at the top level, with the value."""
    node: Any
    for node in tree.body:
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
            yield node.targets[0].id, node.value
        elif type(node).__name__ == "Param":
            yield from ((one.identifier, one.value) for one in cast("Any", node).elts)


def _calls(value: Any) -> Iterator[ast.Call]:
    """Calls in a value, within arithmetic only."""
    if isinstance(value, ast.Call):
        yield value
    elif isinstance(value, _WITHIN) or type(value).__name__ in _SCENIC_WITHIN:
        for child in ast.iter_child_nodes(value):
            yield from _calls(child)


def _limits(call: ast.Call) -> tuple[float, float] | None:
    """Between which numbers a call draws, if they are written out."""
    if not isinstance(call.func, ast.Name) or call.keywords:
        return None
    kind, given = call.func.id, _values(call)
    if kind in _CHOICES and len(given) > 1 and all(_is_written(one) for one in given):
        return _span(kind, given)
    values = [number(one) for one in given]
    if kind in _RANGES | _WHOLE and len(values) == 2 and None not in values:
        low, high = cast("list[float]", values)
        return _span(kind, (min(low, high), max(low, high)))
    return None


def _values(call: ast.Call) -> list[Any]:
    """What a call draws from: what it is given, or the elements of the one list that it is given."""
    one = call.args[0] if len(call.args) == 1 else None
    return one.elts if isinstance(one, ast.List | ast.Tuple) else call.args


def _span(kind: str, values: Any) -> tuple[float, float]:
    if kind in _CHOICES:
        return 0.0, float(len(values))
    low, high = sorted(map(float, values))
    return (low - 0.5, high + 0.5) if kind in _WHOLE else (low, high)


def _is_written(node: Any) -> bool:
    return isinstance(node, ast.Constant) or number(node) is not None


def number(node: Any) -> float | None:
    """The number that is written there, with its sign."""
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        inner = number(node.operand)
        return None if inner is None else -inner
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float) and not isinstance(node.value, bool):
        return node.value if math.isfinite(node.value) else None
    return None
