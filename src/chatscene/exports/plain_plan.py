"""A plan in plain words: what OpenSCENARIO can say of it, each live quantity by itself; or the phase it cannot say."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from chatscene.exports.plain_numbers import STRAIGHT, Moving, Site, Unsayable, same
from chatscene.terms.plan import (
    FUNCTIONS,
    After,
    Arithmetic,
    Boolean,
    Call,
    Comparison,
    Expression,
    Kind,
    Name,
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
from chatscene.terms.storyboard import EGO_ROUTE, OVER, START
from chatscene.terms.sums import Sum

_STANDS = ("Halt", "Park")
_ALONG = ("DrivePath", "BrakeOnPath", "ThrottleOnPath", "KeepStation", "PaceOnPath")
SAYABLE = frozenset((*_STANDS, *_ALONG, "MoveAhead"))
"""What can be said of what an actor does."""
_FLIPPED: dict[Relation, Relation] = {"<": ">", "<=": ">=", ">": "<", ">=": "<=", "==": "==", "!=": "!="}
_SAME = 0.5  # [m] within which two distances are one
_STEP = 0.1  # [s] of a drive: a time that is waited for is longer, or it may be over before anybody asks
_CLOSING = Arithmetic("+", Call("speed", (Name("self", Kind.ACTOR),)), Call("speed", (Name("ego", Kind.ACTOR),)))


@dataclass(frozen=True, slots=True, kw_only=True)
class Plain:
    """A plan in plain words.

    Attributes:
        plan: The plan; its paths are names of `lines`.
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


class _Teller(Moving):
    """Goes through the phases of a plan, and knows how the actor has moved so far."""

    def __init__(self, site: Site) -> None:
        super().__init__(site)
        self.measured = False
        self.unsaid: list[str] = []

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
            raise Unsayable("pedestrians do not follow a line")
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
        known = next((name for name, one in self.lines.items() if one is line or same(one, line)), None)
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
        return speeds == _CLOSING and abs(turn) > math.pi - STRAIGHT

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
