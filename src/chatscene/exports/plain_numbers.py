"""What a number of a plan is for an actor that has moved so far: a static part, and how many of each live quantity."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from chatscene.terms.actors import Limits
from chatscene.terms.pace import NOMINAL
from chatscene.terms.plan import (
    Arithmetic,
    Call,
    Comparison,
    Conditional,
    Expression,
    Kind,
    Name,
    Negation,
    Number,
    Parameter,
    walk,
)
from chatscene.terms.plan_text import print_expression
from chatscene.terms.polyline import Polyline
from chatscene.terms.snippet import ParameterRange
from chatscene.terms.sums import Sum, called, combined, number, product, quotient, sum_of, valued

STRAIGHT = 0.05  # [rad] of a line over `_NEAR` both ways, within which walking toward it is walking straight at it
_NEAR = 10.0  # [m]


class Unsayable(Exception):  # noqa: N818 - reads as what it says
    """The format has no word for something; the message says for what."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Site:
    """What a plan is said of.

    Attributes:
        grip: What the road holds [m/s²].
        prefix: What its lines are called, with a number behind.
        value: What an expression stands for that stays, such as a path.
        start_on: Where on a line the actor starts: along and to the left [m], and its turn [rad].
        lane_of: The number of the lane that a line follows, for somebody who comes from another line.
        pace: What the ego drives at where nothing holds it [m/s].
    """

    limits: Limits
    grip: float
    walks: bool
    prefix: str
    value: Callable[[Expression], Any]
    start_on: Callable[[Polyline], tuple[Sum, Sum, float]]
    ego_line: Polyline
    lane_of: Callable[[Polyline], int]
    ranges: Mapping[str, ParameterRange]
    pace: float = NOMINAL.speed


@dataclass(slots=True)
class Linear:
    """A static part, and how many of each live quantity."""

    rest: Sum
    live: dict[str, float] = field(default_factory=dict[str, float])

    def plus(self, other: Linear, sign: float) -> Linear:
        """The sum with another, or the difference where `sign` is -1."""
        live = {q: self.live.get(q, 0.0) + sign * other.live.get(q, 0.0) for q in {*self.live, *other.live}}
        return Linear(self.rest + other.rest.times(sign), {q: n for q, n in live.items() if n})

    def times(self, factor: float) -> Linear:
        """All of it, so many times."""
        return Linear(self.rest.times(factor), {q: factor * n for q, n in self.live.items()})


class Moving:
    """An actor as far as it has moved, and what numbers are for it there.

    Attributes:
        lines: The lines that it followed so far, by name.
        lanes: Of each to which it changed, by how many lanes.
    """

    def __init__(self, site: Site) -> None:
        self._site = site
        self.lines: dict[str, Polyline] = {}
        self.lanes: dict[str, int] = {}
        self._changes = False  # whether it begins to change to another line in this phase
        self._place: Sum = number(0.0)  # on the ego's route, to which it is asked how long the ego needs
        self._stands = True
        self._way: str | None = None  # the line that it follows
        self._ahead: bool = False  # whether all that it did so far was to go straight on
        self._pace: Sum | None = None  # what it was told to drive

    def _number(self, expression: Expression | None) -> Sum:
        if expression is None:
            return number(0.0)
        found = self._linear(expression)
        if found.live:
            raise Unsayable(f"{print_expression(expression)!r} changes while it drives")
        return found.rest

    def _linear(self, expression: Expression) -> Linear:  # noqa: C901, PLR0911
        match expression:
            case Number() | Parameter():
                found = sum_of(expression)
                assert found is not None
                return Linear(found)
            case Name():
                return Linear(number(float(self._site.value(expression))))
            case Negation(of):
                return self._linear(of).times(-1)
            case Arithmetic("+" | "-" as sign, left, right):
                return self._linear(left).plus(self._linear(right), 1 if sign == "+" else -1)
            case Arithmetic("*", left, right):
                one, other = self._linear(left), self._linear(right)
                if one.live and other.rest.number is not None and not other.live:
                    return one.times(other.rest.number)
                if other.live and one.rest.number is not None and not one.live:
                    return other.times(one.rest.number)
                return Linear(product(self._static(one, left), self._static(other, right)))
            case Arithmetic(operator, left, right):
                one, other = self._linear(left), self._static(self._linear(right), right)
                if one.live and other.number:
                    return one.times(1 / other.number)
                return Linear(combined(operator, self._static(one, left), other))
            case Call(function, arguments):
                return self._call(function, arguments, expression)
            case Conditional(Comparison(first, ((relation, second),)), then, otherwise):
                differ = self._number(first) + self._number(second).times(-1)
                above = self._sign(differ, first) > 0
                return self._linear(then if above == (relation in (">", ">=")) else otherwise)
            case _:
                raise Unsayable(f"{print_expression(expression)!r} is not a number that the format can express")

    def _static(self, found: Linear, expression: Expression) -> Sum:
        if found.live:
            raise Unsayable(f"{print_expression(expression)!r} changes, and is multiplied or divided by")
        return found.rest

    def _call(self, function: str, arguments: tuple[Expression, ...], whole: Expression) -> Linear:  # noqa: C901, PLR0911, PLR0912
        match function:
            case "length" | "eventAt" | "exitAt" | "entry":
                return Linear(number(float(self._site.value(whole))))
            case "abs" if self._is_changing_to(arguments[0]):
                return Linear(number(0.0), {"change": 1.0})
            case "abs" if self._drives_beside(arguments[0]):
                return Linear(number(0.0), {"beside": 1.0})
            case "abs":
                inner = self._linear(arguments[0])
                return inner.times(self._sign(inner.rest, whole))
            case "max" | "min":
                return Linear(self._extreme(function, [self._number(one) for one in arguments]))
            case "progress":
                return self._progress(arguments[0], arguments[1])
            case "distanceLeft":
                return self._linear(arguments[2]).plus(self._progress(arguments[0], arguments[1]), -1)
            case "headway" if self._is_ahead(arguments):
                return Linear(number(0.0), {"headway": 1.0})
            case "headway":
                return self._progress(arguments[0], arguments[2]).plus(self._progress(arguments[0], arguments[1]), -1)
            case "offsetFrom":
                return self._offset(arguments[0], arguments[1])
            case "gap":
                return Linear(number(0.0), {"gap": 1.0})
            case "secondsTo":
                return self._seconds(*arguments)
            case "speed" if arguments == (Name("ego", Kind.ACTOR),):
                return Linear(number(0.0), {"ego's speed": 1.0})
            case "speed" if arguments == (Name("self", Kind.ACTOR),):
                return Linear(number(0.0), {"speed": 1.0})
            case "brakingDistance" if arguments == (Name("self", Kind.ACTOR),):
                return Linear(self._braked())
            case _:
                raise Unsayable(f"the format does not know {print_expression(whole)!r}")

    def _seconds(self, path: Expression, actor: Expression, to: Expression) -> Linear:
        """How long the ego needs to a place on its route, or to where somebody is who drives along that."""
        if actor != Name("ego", Kind.ACTOR) or not same(self._site.value(path), self._site.ego_line):
            raise Unsayable("it asks how long somebody needs elsewhere than the ego on its route")
        place = self._linear(to)
        if place.live:
            return Linear(number(0.0), {"seconds behind": 1.0})
        self._place = place.rest
        return Linear(number(0.0), {"seconds": 1.0})

    def _is_changing_to(self, asked: Expression) -> bool:
        """Whether it is asked how far it still is from the line to which it has begun to change."""
        if not self._changes or not isinstance(asked, Call) or asked.function != "offsetFrom":
            return False
        own = asked.arguments[1] == Name("self", Kind.ACTOR)
        return own and same(self._site.value(asked.arguments[0]), self.lines[str(self._way)])

    def _drives_beside(self, asked: Expression) -> bool:
        """Whether it is asked how far beside the ego's route it is, driving: that is how far beside the ego."""
        if self._stands or self._ahead or not isinstance(asked, Call) or asked.function != "offsetFrom":
            return False
        own = asked.arguments[1] == Name("self", Kind.ACTOR)
        return own and same(self._site.value(asked.arguments[0]), self._site.ego_line)

    def _is_ahead(self, asked: tuple[Expression, ...]) -> bool:
        """Whether it is asked how far ahead of the ego it is on the ego's route, driving, and it started ahead."""
        path, first, second = asked
        line: Polyline = self._site.value(path)
        if self._stands or (first, second) != (Name("ego", Kind.ACTOR), Name("self", Kind.ACTOR)):
            return False
        follows = self._way is not None and not self.lanes and same(line, self.lines[self._way])
        if follows or not same(line, self._site.ego_line):
            return False
        if min(value for (value,) in self._corners(self._site.start_on(line)[0])) <= 0:
            raise Unsayable("it starts behind the ego, and distances have no sign")
        return True

    def _progress(self, path: Expression, actor: Expression) -> Linear:
        line: Polyline = self._site.value(path)
        if actor == Name("ego", Kind.ACTOR):
            if not same(line, self._site.ego_line):
                raise Unsayable(f"it asks how far the ego is on {print_expression(path)!r}, which is not its route")
            return Linear(number(0.0), {"ego": 1.0})
        if actor != Name("self", Kind.ACTOR):
            raise Unsayable(f"it asks how far {print_expression(actor)!r} is")
        if self._stands:
            return Linear(self._site.start_on(line)[0])
        if self._way is None or self.lanes or not same(line, self.lines[self._way]):
            raise Unsayable(f"it asks how far it is on {print_expression(path)!r}, which it does not follow")
        return Linear(self._site.start_on(line)[0], {"self": 1.0})

    def _offset(self, path: Expression, actor: Expression) -> Linear:
        line: Polyline = self._site.value(path)
        if actor != Name("self", Kind.ACTOR) or not (self._stands or self._ahead):
            raise Unsayable(f"it asks how far beside {print_expression(path)!r} somebody is who drives")
        along, left, turn = self._site.start_on(line)
        if self._stands:
            return Linear(left)
        at = self._middle(along)
        bend = max(
            abs(math.remainder(line.heading_at(at + d) - line.heading_at(at), math.tau)) for d in (-_NEAR, _NEAR)
        )
        if bend > STRAIGHT:
            raise Unsayable(f"{print_expression(path)!r} is not a straight line there")
        return Linear(left, {"self": math.sin(turn)})

    def _braked(self) -> Sum:
        """How far it still goes if it brakes now, at the speed that it is told."""
        if self._stands:
            return number(0.0)
        if self._pace is None:
            raise Unsayable("it asks how far it would go on braking, at a speed that changes")
        return quotient(product(self._pace, self._pace), number(2 * min(self._site.limits.brake, self._site.grip)))

    def _corners(self, *sums: Sum) -> Iterator[list[float]]:
        """What sums are at every corner of the ranges."""
        ranges = self._site.ranges
        names = sorted({p.name for s in sums for _, t in s.terms for p in walk(t) if isinstance(p, Parameter)})
        for corner in itertools.product(*((ranges[name].low, ranges[name].high) for name in names)):
            known = dict(zip(names, corner, strict=True))
            yield [valued(one.expression, known) for one in sums]

    def _middle(self, one: Sum) -> float:
        found = [value for (value,) in self._corners(one)]
        return sum(found) / len(found)

    def _sign(self, one: Sum, whole: Expression) -> int:
        """Whether a number is positive all over the ranges, or negative."""
        values = [value for (value,) in self._corners(one)]
        if min(values) < 0 < max(values):
            raise Unsayable(f"{print_expression(whole)!r} has the one sign or the other")
        return 1 if max(values) > 0 else -1

    def _extreme(self, function: str, sums: list[Sum]) -> Sum:
        """The largest or the smallest, which is one of them where it is that all over the ranges."""
        choose = max if function == "max" else min
        corners = list(self._corners(*sums))
        for index, one in enumerate(sums):
            if all(values[index] == choose(values) for values in corners):
                return one
        return called(function, sums)


def same(one: Polyline, other: Polyline) -> bool:
    """Whether two lines have the same points."""
    return one is other or (one.points.shape == other.points.shape and bool((one.points == other.points).all()))
