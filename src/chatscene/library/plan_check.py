"""What is wrong with a plan, as far as that can be seen without driving it; and what it must show when it is driven."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field

from chatscene.terms.acts import Action
from chatscene.terms.plan import (
    FUNCTIONS,
    PRIMITIVES,
    After,
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
    Phase,
    Plan,
    Text,
    Until,
    expressions_of,
    parts_of,
    walk,
)
from chatscene.terms.plan_text import print_expression
from chatscene.terms.snippet import ParameterRange

STANDING = frozenset(
    {"Halt", "Park", "BrakeOnPath", "WaitFor", "Slide"}
)  # who does one of these stands, sooner or later
FOLLOWING = frozenset({"PaceOnPath", "KeepStation", "FollowTraffic"})  # who does one of these goes as fast as others
TURNED_ROUND = 2.4  # [rad]
CRAWLING = 0.6  # [m/s]; whoever is slower may be said to stand
_ON_RED = Comparison(Name("crossSignal", Kind.TEXT), (("==", Text("red")),))
_WAYS = {"left-turn": Action.TURN_LEFT, "right-turn": Action.TURN_RIGHT}

Dimension = tuple[int, int]  # exponents of length and time
_DIMENSIONS: dict[str, Dimension] = {
    "m": (1, 0),
    "m/s": (1, -1),
    "s": (0, 1),
    "rad": (0, 0),
    "1/m": (-1, 0),
    "1": (0, 0),
}


def check_plan(plan: Plan, parameters: Iterable[ParameterRange]) -> Iterator[str]:
    """What is wrong with a plan."""
    declared, read = {p.name for p in plan.parameters}, set(_parameters_in(plan))
    yield from (f"{name} changes nothing, no phase reads it" for name in sorted(declared - read))
    yield from (f"{name} is read and not declared" for name in sorted(read - declared))
    yield from _idle_values(plan)
    units = _Units({p.name: _DIMENSIONS[p.unit] for p in parameters})
    for i, phase in enumerate(plan.phases, 1):
        where = f"phase {i}, {phase.primitive}"
        if (
            phase.end is None
            and not PRIMITIVES[phase.primitive].ends
            and (i < len(plan.phases) or plan.loop is not None)
        ):
            yield f"{where}, never ends, so nothing after it is ever done"
        if isinstance(phase.end, Until) and not _changes(phase.end.condition):
            yield f"{where}, ends at once or never: nothing changes in {print_expression(phase.end.condition)!r}"
        yield from (f"{where}: {fault}" for fault in units.faults(phase))


def _parameters_in(plan: Plan) -> Iterator[str]:
    whole = (e for phase in plan.phases for e in expressions_of(phase))
    for expression in (*whole, *(constant.expression for constant in plan.constants)):
        yield from (part.name for part in walk(expression) if isinstance(part, Parameter))


def names_read(phases: Iterable[Phase]) -> set[str]:
    """The names that phases read."""
    whole = (part for phase in phases for e in expressions_of(phase) for part in walk(e))
    return {part.id for part in whole if isinstance(part, Name)}


def _idle_values(plan: Plan) -> Iterator[str]:
    read = names_read(plan.phases)
    for phase in plan.phases:
        yield from (f"nothing uses the value {value.name}" for value in phase.values if value.name not in read)


def _changes(condition: Expression) -> bool:
    return any(isinstance(part, Call) and FUNCTIONS[part.function].live for part in walk(condition))


# Units


@dataclass(slots=True)
class _Units:
    """Dimensions of what parameters and local values stand for.

    A number that stands in the text can be anything, and so can what is made of one.
    """

    known: dict[str, Dimension]
    found: list[str] = field(default_factory=list[str])

    def faults(self, phase: Phase) -> Iterator[str]:
        """Where a phase takes one measure for another."""
        self.found.clear()
        for value in phase.values:
            if (dimension := self._of(value.expression)) is not None:
                self.known[value.name] = dimension
        for argument, given in zip(PRIMITIVES[phase.primitive].takes, phase.arguments, strict=False):
            if argument.kind is Kind.NUMBER:
                self._agree(f"{argument.name} [{argument.unit}]", _DIMENSIONS[argument.unit], given)
        if isinstance(phase.end, After):
            self._agree("seconds", _DIMENSIONS["s"], phase.end.seconds)
        elif isinstance(phase.end, Until):
            self._of(phase.end.condition)
        yield from self.found

    def _agree(self, what: str, wanted: Dimension, given: Expression) -> None:
        if self._of(given) not in (None, wanted):
            self.found.append(f"{print_expression(given)!r} is no {what}")

    def _same(self, whole: Expression, parts: Iterable[Expression]) -> Dimension | None:
        dimensions = {d for d in map(self._of, parts) if d is not None}
        if len(dimensions) > 1:
            self.found.append(f"{print_expression(whole)!r} takes one measure for another")
        return dimensions.pop() if len(dimensions) == 1 else None

    def _of(self, expression: Expression) -> Dimension | None:  # noqa: PLR0911
        """The dimension of an expression; None if it can be any."""
        match expression:
            case Parameter(name) | Name(name, Kind.NUMBER):
                return self.known.get(name)
            case Negation(of):
                return self._of(of)
            case Arithmetic("*" | "/" as operator, left, right):
                one, other = self._of(left), self._of(right)
                sign = 1 if operator == "*" else -1
                return None if one is None or other is None else (one[0] + sign * other[0], one[1] + sign * other[1])
            case Arithmetic(_, left, right):
                return self._same(expression, (left, right))
            case Comparison(first, links):
                self._same(expression, (first, *(right for _, right in links)))
            case Conditional(test, then, otherwise):
                self._of(test)
                return self._same(expression, (then, otherwise))
            case Call(name, arguments) if FUNCTIONS[name].gives is Kind.NUMBER:
                function = FUNCTIONS[name]
                if function.unit:
                    return _DIMENSIONS[function.unit]
                return self._same(expression, arguments)
            case _:
                for part in parts_of(expression):
                    self._of(part)
        return None


# Acts


def acts_of(plan: Plan) -> Mapping[Action, bool]:
    """What a plan itself says that it shows (True) and cannot show (False); of other acts it does not decide.

    Whether an act is seen also depends on where the plan begins, so that most are left to drives.
    """
    primitives = {phase.primitive for phase in plan.phases}
    said = {Action.REVERSE: not primitives.isdisjoint({"ReverseStraight", "ReverseTurning"})}
    if any(_ON_RED in walk(e) for phase in plan.phases for e in expressions_of(phase)):
        said[Action.RUN_LIGHT] = True
    stops, goes_on = _stops(plan)
    if not stops:
        said[Action.STOP] = False
    if not goes_on:
        said[Action.HESITATE] = False
    if any(phase.primitive == "WeaveOnPath" and not isinstance(phase.end, After) for phase in plan.phases):
        said[Action.WEAVE] = True
    if "SwerveOnPath" in primitives:
        said[Action.SWERVE] = True
    return {**said, **dict.fromkeys(_turns(plan), True)}


def _stops(plan: Plan) -> tuple[bool, bool]:
    """Whether somebody who has moved may come to stand, and may then move on."""
    stops = goes_on = moved = False
    for phase in (*plan.phases, *plan.phases[len(plan.phases) if plan.loop is None else plan.loop :]):
        if _may_stand(plan, phase):
            stops = stops or moved
        else:
            goes_on = goes_on or stops
        moved = moved or phase.primitive not in STANDING
    return stops, goes_on or (stops and any(phase.primitive in FOLLOWING for phase in plan.phases))


def _may_stand(plan: Plan, phase: Phase) -> bool:
    slowest = phase.argument("least" if phase.primitive in FOLLOWING else "speed")
    if phase.primitive in STANDING or slowest is None:
        return phase.primitive != "ThrottleOnPath"
    bounds = _bounds(plan, slowest)
    return bounds is None or bounds[0] < CRAWLING


def _turns(plan: Plan) -> Iterator[Action]:
    way = plan.constant("advTurn")
    if isinstance(way, Text) and way.value in _WAYS:
        yield _WAYS[way.value]
    for phase in plan.phases:
        angle = phase.argument("angle")
        if angle is not None and (bounds := _bounds(plan, angle)) is not None:
            if min(map(abs, bounds)) > TURNED_ROUND:
                yield Action.U_TURN
            elif bounds[0] > 0 or bounds[1] < 0:
                yield Action.TURN_LEFT if bounds[0] > 0 else Action.TURN_RIGHT


def _bounds(plan: Plan, expression: Expression) -> tuple[float, float] | None:
    """Between which numbers a number or a parameter lies; None of anything else."""
    match expression:
        case Number(value):
            return value, value
        case Parameter(name):
            return next(((p.low, p.high) for p in plan.parameters if p.name == name), None)
        case Negation(of) if (bounds := _bounds(plan, of)) is not None:
            return -bounds[1], -bounds[0]
        case _:
            return None
