"""A plan in plain words: what OpenSCENARIO can say of it, each live quantity by itself; or the phase it cannot say."""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from chatscene.terms.actors import Limits
from chatscene.terms.pace import NOMINAL
from chatscene.terms.plan import (
    FUNCTIONS,
    After,
    Arithmetic,
    Boolean,
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
    Range,
    Relation,
    Until,
    Value,
    walk,
)
from chatscene.terms.plan_text import print_expression, print_phase
from chatscene.terms.polyline import Polyline
from chatscene.terms.snippet import ParameterRange
from chatscene.terms.storyboard import EGO_ROUTE, OVER, START
from chatscene.terms.sums import Sum, called, combined, number, product, quotient, sum_of, valued

_STANDS = ("Halt", "Park")
_ALONG = ("DrivePath", "BrakeOnPath", "ThrottleOnPath", "KeepStation", "PaceOnPath")
SAYABLE = frozenset((*_STANDS, *_ALONG, "MoveAhead"))
"""What can be said of what an actor does."""
_FLIPPED: dict[Relation, Relation] = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "==": "==", "!=": "!="}
_STRAIGHT = 0.05  # [rad] of a line over `_NEAR` both ways, within which walking toward it is walking straight at it
_NEAR = 10.0  # [m]
_SAME = 0.5  # [m] within which two distances are one
_STEP = 0.1  # [s] of a drive: a time that is waited for is longer, or it may be over before anybody asks
_CLOSING = Arithmetic("+", Call("speed", (Name("self", Kind.ACTOR),)), Call("speed", (Name("ego", Kind.ACTOR),)))


class Unsayable(Exception):  # noqa: N818 - reads as what it says
    """The format has no word for something; the message says for what."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Site:
    """What a plan is said of.

    Attributes:
        limits: Of the actor.
        grip: What the road holds [m/s²].
        walks: Whether the actor is on foot.
        prefix: What its lines are called, with a number behind.
        value: What an expression stands for that stays, such as a path.
        start_on: Where on a line the actor starts: along and to the left [m], and its turn [rad].
        ego_line: The line of the ego's route.
        lane_of: The number of the lane that a line follows, for somebody who comes from another line.
        ranges: Of the parameters.
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


@dataclass(frozen=True, slots=True, kw_only=True)
class Plain:
    """A plan in plain words.

    Attributes:
        plan: The plan; its paths are names of `lines`.
        lines: Its lines, by name.
        lanes: The lanes of those that it changes to.
        unsaid: What the format has no word for, and the rest is true without, in words.
    """

    plan: Plan
    lines: Mapping[str, Polyline]
    lanes: Mapping[str, int]
    unsaid: tuple[str, ...] = ()


def plainly(plan: Plan, site: Site) -> Plain:
    """A plan in plain words.

    Raises:
        Unsayable: There are none for it; the message names the phase.
    """
    if plan.loop is not None:
        raise Unsayable(f"phase {plan.loop + 1} and those after it are done over and over")
    teller = _Teller(site)
    phases: list[Phase] = []
    for index, phase in enumerate(plan.phases, 1):
        try:
            phases.append(teller.phase(phase))
        except Unsayable as reason:
            raise Unsayable(f"phase {index}, {print_phase(phase)!r}: {reason}") from reason
        except ZeroDivisionError as error:
            raise Unsayable(f"phase {index}, {print_phase(phase)!r}: it divides by zero") from error
    if teller.measured:
        way = next(iter(teller.lines), f"{site.prefix}Way")
        begins = Value(START, Call("progress", (Name(way, Kind.PATH), Name("self", Kind.ACTOR))))
        phases[0] = Phase(phases[0].primitive, phases[0].arguments, phases[0].end, (begins,))
    read = {
        part.name for phase in phases for e in _expressions(phase) for part in walk(e) if isinstance(part, Parameter)
    }
    ranges = sorted((r for r in site.ranges.values() if r.name in read), key=lambda r: r.name)
    parameters = tuple(Range(r.name, r.low, r.high) for r in ranges)
    return Plain(
        plan=Plan(phases=tuple(phases), parameters=parameters),
        lines=teller.lines,
        lanes=teller.lanes,
        unsaid=tuple(teller.unsaid),
    )


def _expressions(phase: Phase) -> Iterator[Expression]:
    yield from phase.arguments
    if phase.end is not None:
        yield phase.end.condition if isinstance(phase.end, Until) else phase.end.seconds


@dataclass(slots=True)
class _Linear:
    """A static part, and how many of each live quantity."""

    rest: Sum
    live: dict[str, float] = field(default_factory=dict[str, float])

    def plus(self, other: _Linear, sign: float) -> _Linear:
        live = {q: self.live.get(q, 0.0) + sign * other.live.get(q, 0.0) for q in {*self.live, *other.live}}
        return _Linear(self.rest + other.rest.times(sign), {q: n for q, n in live.items() if n})

    def times(self, factor: float) -> _Linear:
        return _Linear(self.rest.times(factor), {q: factor * n for q, n in self.live.items()})


class _Teller:
    """Goes through the phases of a plan, and knows how the actor has moved so far."""

    def __init__(self, site: Site) -> None:
        self._site = site
        self.lines: dict[str, Polyline] = {}
        self.lanes: dict[str, int] = {}
        self.measured = False
        self.unsaid: list[str] = []
        self._changes = False  # whether it begins to change to another line in this phase
        self._place: Sum = number(0.0)  # on the ego's route, to which it is asked how long the ego needs
        self._stands = True
        self._way: str | None = None  # the line that it follows
        self._ahead: bool = False  # whether all that it did so far was to go straight on
        self._pace: Sum | None = None  # what it was told to drive

    def phase(self, phase: Phase) -> Phase:
        if phase.values:
            raise Unsayable("a value is remembered for later")
        self._changes = False
        name, arguments = self._does(phase)
        return Phase(name, arguments, self._end(phase.end))

    def _does(self, phase: Phase) -> tuple[str, tuple[Expression, ...]]:  # noqa: C901, PLR0911, PLR0912
        site, self._pace = self._site, None
        told = {
            name: phase.argument(name)
            for name in ("path", "speed", "left", "brake", "throttle", "top", "turn", "other", "ahead", "least")
        }
        if phase.primitive in _STANDS:
            if self._stands or self._way is None:
                return "Halt", ()
            return "BrakeOnPath", (Name(self._way, Kind.PATH), Number(1.0))
        if phase.primitive == "MoveAhead":
            speed, turn = self._number(told["speed"]), self._number(told["turn"])
            if turn.number is None or (turn.number and not (self._stands or self._ahead)):
                raise Unsayable("it turns by what varies")
            self._ahead = (self._stands or self._ahead) and not turn.number
            self._stands, self._way, self._pace = False, None, speed
            return "MoveAhead", (speed.expression, *([turn.expression] if turn.number else []))
        if phase.primitive not in _ALONG:
            raise Unsayable("the format has no action that does this")
        if site.walks:
            raise Unsayable("nobody on foot follows a line")
        if self._number(told["left"] or Number(0)).number != 0:
            raise Unsayable("it goes beside a line")
        stays = phase.primitive == "PaceOnPath" and self._stays(told)
        path = self._follows(told["path"])
        match phase.primitive:
            case "DrivePath":
                self._pace = self._number(told["speed"])
                return "DrivePath", (path, self._pace.expression)
            case "BrakeOnPath":
                return "BrakeOnPath", (path, self._number(told["brake"]).expression)
            case "ThrottleOnPath":
                throttle, top = self._number(told["throttle"]), self._number(told["top"])
                if throttle.number == 1.0:
                    return "DrivePath", (path, top.expression)
                return "ThrottleOnPath", (path, throttle.expression, Number(0), top.expression)
            case "PaceOnPath" if not stays:
                return phase.primitive, (path, *self._keeps(told))
            case _:
                return "KeepStation", (path, self._of_ego(told))

    def _of_ego(self, told: Mapping[str, Expression | None]) -> Name:
        """The ego, if it is that to which a distance is kept; that somebody does not stop for it has no word."""
        if told["other"] != Name("ego", Kind.ACTOR):
            raise Unsayable("it keeps its distance to another than the ego")
        if told["least"] != Number(0):
            assert told["least"] is not None
            self.unsaid.append(f"drives at {print_expression(told['least'])} m/s at least while it keeps its distance")
        return Name("ego", Kind.ACTOR)

    def _keeps(self, told: Mapping[str, Expression | None]) -> tuple[Expression, ...]:
        """To whom it keeps which distance, and how fast it is at most; by its sign it is ahead or behind."""
        assert told["ahead"] is not None
        ego, ahead = self._of_ego(told), self._number(told["ahead"])
        self._sign(ahead, told["ahead"])
        return ego, ahead.expression, self._number(told["top"]).expression

    def _stays(self, told: Mapping[str, Expression | None]) -> bool:
        """Whether it keeps the distance that it has from the first, which may be ahead as well as behind."""
        ahead, other = told["ahead"], told["other"]
        if not self._stands or ahead is None or other != Name("ego", Kind.ACTOR):
            return False
        kept = self._number(ahead)
        values = [value for (value,) in self._corners(kept)]
        if not min(values) < 0 < max(values):
            return False
        starts = self._site.start_on(self._site.ego_line)[0]
        return all(abs(value - start) < _SAME for value, start in self._corners(kept, starts))

    def _follows(self, path: Expression | None) -> Name:
        """The name of a line that it follows from now on."""
        assert path is not None
        line: Polyline = self._site.value(path)
        known = next((name for name, one in self.lines.items() if one is line or _same(one, line)), None)
        name = known or f"{self._site.prefix}Way{len(self.lines) + 1 if self.lines else ''}"
        if known is None and self._stands:
            if self.lines:
                raise Unsayable("it begins along a line on which it does not stand")
        elif name != self._way and not (known and self._way is None and self._stands):
            if self._way is None:
                raise Unsayable("it comes to a line from where it walked")
            if known is not None:
                raise Unsayable("it comes back to a line that it left")
            self.lanes[name] = self._site.lane_of(line)
            self._changes = True
        self.lines.setdefault(name, line)
        self._stands, self._ahead, self._way = False, False, name
        return Name(name, Kind.PATH)

    def _end(self, end: Until | After | None) -> Until | After | None:
        match end:
            case None:
                return None
            case After(seconds):
                return After(self._number(seconds).expression)
            case Until(condition):
                groups = [group for group in self._groups(condition) if group is not None]
                if not groups:
                    raise Unsayable("it never ends")
                if any(not group for group in groups):
                    raise Unsayable("it ends as it begins")
                terms = [group[0] if len(group) == 1 else Boolean("and", tuple(group)) for group in groups]
                return Until(terms[0] if len(terms) == 1 else Boolean("or", tuple(terms)))

    def _groups(self, condition: Expression) -> list[list[Expression] | None]:
        """Alternatives of conditions that hold together, each of one live quantity; None for what never holds."""
        match condition:
            case Boolean("or", terms):
                return [group for term in terms for group in self._groups(term)]
            case Boolean("and", terms):
                parts = [self._groups(term) for term in terms]
                return [
                    None if any(one is None for one in chosen) else [c for one in chosen for c in one or ()]
                    for chosen in itertools.product(*parts)
                ]
            case Comparison(
                Call("gap"), (("<" | "<=" as relation, Arithmetic("*", Arithmetic("+") as speeds, seconds)),)
            ) if self._is_closing(speeds):
                bound = Arithmetic("*", _CLOSING, self._number(seconds).expression)
                return [[Comparison(self._live("gap"), ((relation, bound),))]]
            case Comparison(first, ((relation, second),)):
                return [self._comparison(first, relation, second)]
            case Call("restsWithin", (path, actor, distance)):
                braking = Arithmetic(
                    "-", Call("abs", (Call("offsetFrom", (path, actor)),)), Call("brakingDistance", (actor,))
                )
                return [self._comparison(braking, "<", distance)]
            case _:
                raise Unsayable(f"it ends with {print_expression(condition)!r}")

    def _is_closing(self, speeds: Expression) -> bool:
        """Whether speeds are those of two who come toward each other."""
        _, _, turn = self._site.start_on(self._site.ego_line)
        return speeds == _CLOSING and abs(turn) > math.pi - _STRAIGHT

    def _comparison(self, first: Expression, relation: Relation, second: Expression) -> list[Expression] | None:
        if not any(
            isinstance(part, Call) and FUNCTIONS[part.function].live for e in (first, second) for part in walk(e)
        ):
            stays = Comparison(first, ((relation, second),))
            if any(isinstance(part, Parameter) for part in walk(stays)):
                raise Unsayable(f"whether {print_expression(stays)!r} hangs on a parameter")
            return [] if self._site.value(stays) else None
        whole = self._linear(first).plus(self._linear(second), -1)
        if len(whole.live) != 1:
            what = "several live quantities" if whole.live else "nothing that changes"
            raise Unsayable(f"{print_expression(Comparison(first, ((relation, second),)))!r} compares {what}")
        ((quantity, count),) = whole.live.items()
        relation = relation if count > 0 else _FLIPPED[relation]
        least = whole.rest.times(-1 / count)
        if quantity == "change":
            if relation not in ("<", "<="):
                raise Unsayable("it ends while it still changes to another line")
            return [Comparison(self._live(quantity), (("<", Number(OVER)),))]
        if quantity in ("seconds", "seconds behind"):
            return [self._soon(quantity, relation, least)]
        bound = least.expression
        if quantity in ("ego", "self"):
            if relation not in (">", ">="):
                raise Unsayable("it ends when somebody has not come so far, and distances that were driven only grow")
            relation = ">="
        return [Comparison(self._live(quantity), ((relation, bound),))]

    def _soon(self, quantity: str, relation: Relation, seconds: Sum) -> Expression:
        """That the ego needs no more than some seconds to a place, or to whoever it asks for.

        Where that may be no time at all, the ego has to be past the place: so far as it drives then at its pace.
        """
        if relation not in ("<", "<="):
            raise Unsayable("it ends when the ego is still some seconds away, as it is from the first")
        ego, own, route = Name("ego", Kind.ACTOR), Name("self", Kind.ACTOR), Name(EGO_ROUTE, Kind.PATH)
        late = min(value for (value,) in self._corners(seconds)) > _STEP
        if quantity == "seconds behind":
            if not late:
                raise Unsayable("it asks for less than no time behind somebody who drives")
            time = Arithmetic("*", seconds.expression, Call("speed", (ego,)))
            return Comparison(Call("headway", (route, ego, own)), ((relation, time),))
        if late:
            return Comparison(
                Call("secondsTo", (route, ego, self._place.expression)), ((relation, seconds.expression),)
            )
        past = self._place + seconds.times(-self._site.pace)
        return Comparison(self._live("ego"), ((">=", past.expression),))

    def _live(self, quantity: str) -> Expression:  # noqa: PLR0911
        ego, own = Name("ego", Kind.ACTOR), Name("self", Kind.ACTOR)
        match quantity:
            case "ego":
                return Call("progress", (Name(EGO_ROUTE, Kind.PATH), ego))
            case "self":
                self.measured = True
                way = next(iter(self.lines), f"{self._site.prefix}Way")
                return Arithmetic("-", Call("progress", (Name(way, Kind.PATH), own)), Name(START, Kind.NUMBER))
            case "gap":
                return Call("gap", (own, ego))
            case "headway":
                return Call("abs", (Call("headway", (Name(EGO_ROUTE, Kind.PATH), ego, own)),))
            case "change":
                return Call("abs", (Call("offsetFrom", (Name(str(self._way), Kind.PATH), own)),))
            case "ego's speed":
                return Call("speed", (ego,))
            case "beside":
                return Call("abs", (Call("offsetFrom", (Name(EGO_ROUTE, Kind.PATH), own)),))
            case _:
                return Call("speed", (own,))

    def _number(self, expression: Expression | None) -> Sum:
        if expression is None:
            return number(0.0)
        found = self._linear(expression)
        if found.live:
            raise Unsayable(f"{print_expression(expression)!r} changes while it drives")
        return found.rest

    def _linear(self, expression: Expression) -> _Linear:  # noqa: C901, PLR0911
        match expression:
            case Number() | Parameter():
                found = sum_of(expression)
                assert found is not None
                return _Linear(found)
            case Name():
                return _Linear(number(float(self._site.value(expression))))
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
                return _Linear(product(self._static(one, left), self._static(other, right)))
            case Arithmetic(operator, left, right):
                one, other = self._linear(left), self._static(self._linear(right), right)
                if one.live and other.number:
                    return one.times(1 / other.number)
                return _Linear(combined(operator, self._static(one, left), other))
            case Call(function, arguments):
                return self._call(function, arguments, expression)
            case Conditional(Comparison(first, ((relation, second),)), then, otherwise):
                differ = self._number(first) + self._number(second).times(-1)
                above = self._sign(differ, first) > 0
                return self._linear(then if above == (relation in (">", ">=")) else otherwise)
            case _:
                raise Unsayable(f"{print_expression(expression)!r} is no number that the format can say")

    def _static(self, found: _Linear, expression: Expression) -> Sum:
        if found.live:
            raise Unsayable(f"{print_expression(expression)!r} changes, and is multiplied or divided by")
        return found.rest

    def _call(self, function: str, arguments: tuple[Expression, ...], whole: Expression) -> _Linear:  # noqa: C901, PLR0911, PLR0912
        match function:
            case "length" | "eventAt" | "entry":
                return _Linear(number(float(self._site.value(whole))))
            case "abs" if self._is_changing_to(arguments[0]):
                return _Linear(number(0.0), {"change": 1.0})
            case "abs" if self._drives_beside(arguments[0]):
                return _Linear(number(0.0), {"beside": 1.0})
            case "abs":
                inner = self._linear(arguments[0])
                return inner.times(self._sign(inner.rest, whole))
            case "max" | "min":
                return _Linear(self._extreme(function, [self._number(one) for one in arguments]))
            case "progress":
                return self._progress(arguments[0], arguments[1])
            case "distanceLeft":
                return self._linear(arguments[2]).plus(self._progress(arguments[0], arguments[1]), -1)
            case "headway" if self._is_ahead(arguments):
                return _Linear(number(0.0), {"headway": 1.0})
            case "headway":
                return self._progress(arguments[0], arguments[2]).plus(self._progress(arguments[0], arguments[1]), -1)
            case "offsetFrom":
                return self._offset(arguments[0], arguments[1])
            case "gap":
                return _Linear(number(0.0), {"gap": 1.0})
            case "secondsTo":
                return self._seconds(*arguments)
            case "speed" if arguments == (Name("ego", Kind.ACTOR),):
                return _Linear(number(0.0), {"ego's speed": 1.0})
            case "speed" if arguments == (Name("self", Kind.ACTOR),):
                return _Linear(number(0.0), {"speed": 1.0})
            case "brakingDistance" if arguments == (Name("self", Kind.ACTOR),):
                return _Linear(self._braked())
            case _:
                raise Unsayable(f"the format does not know {print_expression(whole)!r}")

    def _seconds(self, path: Expression, actor: Expression, to: Expression) -> _Linear:
        """How long the ego needs to a place on its route, or to where somebody is who drives along that."""
        if actor != Name("ego", Kind.ACTOR) or not _same(self._site.value(path), self._site.ego_line):
            raise Unsayable("it asks how long somebody needs elsewhere than the ego on its route")
        place = self._linear(to)
        if place.live:
            return _Linear(number(0.0), {"seconds behind": 1.0})
        self._place = place.rest
        return _Linear(number(0.0), {"seconds": 1.0})

    def _is_changing_to(self, asked: Expression) -> bool:
        """Whether it is asked how far it still is from the line to which it has begun to change."""
        if not self._changes or not isinstance(asked, Call) or asked.function != "offsetFrom":
            return False
        own = asked.arguments[1] == Name("self", Kind.ACTOR)
        return own and _same(self._site.value(asked.arguments[0]), self.lines[str(self._way)])

    def _drives_beside(self, asked: Expression) -> bool:
        """Whether it is asked how far beside the ego's route it is, driving: that is how far beside the ego."""
        if self._stands or self._ahead or not isinstance(asked, Call) or asked.function != "offsetFrom":
            return False
        own = asked.arguments[1] == Name("self", Kind.ACTOR)
        return own and _same(self._site.value(asked.arguments[0]), self._site.ego_line)

    def _is_ahead(self, asked: tuple[Expression, ...]) -> bool:
        """Whether it is asked how far ahead of the ego it is on the ego's route, driving, and it started ahead."""
        path, first, second = asked
        line: Polyline = self._site.value(path)
        if self._stands or (first, second) != (Name("ego", Kind.ACTOR), Name("self", Kind.ACTOR)):
            return False
        follows = self._way is not None and not self.lanes and _same(line, self.lines[self._way])
        if follows or not _same(line, self._site.ego_line):
            return False
        if min(value for (value,) in self._corners(self._site.start_on(line)[0])) <= 0:
            raise Unsayable("it starts behind the ego, and distances have no sign")
        return True

    def _progress(self, path: Expression, actor: Expression) -> _Linear:
        line: Polyline = self._site.value(path)
        if actor == Name("ego", Kind.ACTOR):
            if not _same(line, self._site.ego_line):
                raise Unsayable(f"it asks how far the ego is on {print_expression(path)!r}, which is not its route")
            return _Linear(number(0.0), {"ego": 1.0})
        if actor != Name("self", Kind.ACTOR):
            raise Unsayable(f"it asks how far {print_expression(actor)!r} is")
        if self._stands:
            return _Linear(self._site.start_on(line)[0])
        if self._way is None or self.lanes or not _same(line, self.lines[self._way]):
            raise Unsayable(f"it asks how far it is on {print_expression(path)!r}, which it does not follow")
        return _Linear(self._site.start_on(line)[0], {"self": 1.0})

    def _offset(self, path: Expression, actor: Expression) -> _Linear:
        line: Polyline = self._site.value(path)
        if actor != Name("self", Kind.ACTOR) or not (self._stands or self._ahead):
            raise Unsayable(f"it asks how far beside {print_expression(path)!r} somebody is who drives")
        along, left, turn = self._site.start_on(line)
        if self._stands:
            return _Linear(left)
        at = self._middle(along)
        bend = max(
            abs(math.remainder(line.heading_at(at + d) - line.heading_at(at), math.tau)) for d in (-_NEAR, _NEAR)
        )
        if bend > _STRAIGHT:
            raise Unsayable(f"{print_expression(path)!r} is no straight line there")
        return _Linear(left, {"self": math.sin(turn)})

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


def _same(one: Polyline, other: Polyline) -> bool:
    return one is other or (one.points.shape == other.points.shape and bool((one.points == other.points).all()))
