"""Expressions of plans as programs for a stack: what does not depend on poses is computed once, now."""

from __future__ import annotations

import operator
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

from chatscene.simulate.native.engine import STACK, Code, Instruction
from chatscene.terms.actors import LIMITS, kind_of
from chatscene.terms.nouns import with_article
from chatscene.terms.pace import Pace
from chatscene.terms.plan import (
    FUNCTIONS,
    AnyOf,
    Arithmetic,
    Boolean,
    Call,
    Comparison,
    Conditional,
    Expression,
    Name,
    Negation,
    Not,
    Number,
    Parameter,
    Text,
    Texts,
    parts_of,
)
from chatscene.terms.polyline import Polyline
from chatscene.terms.profile import Timetable
from chatscene.world.places import against, extended, line_of, ownLane, timetable_of

OPERATIONS = {
    name: i
    for i, name in enumerate(
        [
            "CONST",
            "LOCAL",
            "ALONG",
            "OFFSET",
            "GAP",
            "SPEED",
            "HEADING",
            "BRAKED",
            "ABS",
            "MAX",
            "MIN",
            "ADD",
            "SUB",
            "MUL",
            "DIV",
            "NEG",
            "LT",
            "LE",
            "GT",
            "GE",
            "EQ",
            "NE",
            "AND",
            "OR",
            "NOT",
            "SELECT",
            "SECONDS",
        ]
    )
}  # in the order of engine.c
_ARITHMETIC: dict[str, tuple[str, Callable[[Any, Any], Any]]] = {
    "+": ("ADD", operator.add),
    "-": ("SUB", operator.sub),
    "*": ("MUL", operator.mul),
    "/": ("DIV", operator.truediv),
}
_RELATIONS: dict[str, tuple[str, Callable[[Any, Any], bool]]] = {
    "<": ("LT", operator.lt),
    "<=": ("LE", operator.le),
    ">": ("GT", operator.gt),
    ">=": ("GE", operator.ge),
    "==": ("EQ", operator.eq),
    "!=": ("NE", operator.ne),
}
_FIXED: dict[str, Callable[..., Any]] = {
    "length": operator.attrgetter("length"),
    "eventAt": operator.attrgetter("eventAt"),
    "exitAt": operator.attrgetter("exitAt"),
    "entry": operator.attrgetter("entry"),
    "abs": abs,
    "max": max,
    "min": min,
    "ownLane": ownLane,
    "against": against,
    "extended": extended,
    "beside": Polyline.offset,
}


Anew = Callable[[Any], None]


class NotCovered(Exception):  # noqa: N818 - reads as what it says
    """The engine cannot run something as the embedded simulator does; the message says what, in general words."""


@dataclass(frozen=True, slots=True, kw_only=True)
class Surrounding:
    """What names in a plan stand for, in one scene.

    Attributes:
        parameters: Values of the program's parameters, by name.
        objects: Everything in the scene, the ego first; where each stands is its number.
        drawn: Which of the names are something else in another scene; of the parameters, each is.
        moved: Which of the objects are elsewhere in another scene, by number; the ego never is.
    """

    names: Mapping[str, Any]
    parameters: Mapping[str, Any]
    objects: list[Any]
    self_index: int
    drawn: frozenset[str] = frozenset()
    moved: frozenset[int] = frozenset()


@dataclass(slots=True)
class Compiler:
    """Makes code for a scene.

    Attributes:
        lines: All lines that it speaks of, by number; the ego's route is the first.
        places: Where the values are that the plan computes when a phase begins, by name.
        bound: What else names of the plan itself stand for: values that stay, actors of a condition over several.
        tables: All timetables that it speaks of, by number.
        known: Whether an expression changes while the scene runs, by its identity; with it, so that it stays.
        anew: What is to be done again for another scene, in this order, on a copy of the instructions; it raises
            `NotCovered` where more than numbers would be other ones. None where nobody asks.
        differ: Which names of `bound` are something else in another scene.
    """

    instructions: list[Instruction]
    lines: list[Polyline]
    around: Surrounding
    places: dict[str, int] = field(default_factory=dict[str, int])
    bound: dict[str, Any] = field(default_factory=dict[str, Any])
    tables: list[Timetable] = field(default_factory=list[Timetable])
    known: dict[int, tuple[bool, Expression]] = field(default_factory=dict[int, tuple[bool, Expression]])
    anew: list[Anew] | None = None
    differ: set[str] = field(default_factory=set[str])

    def is_live(self, expression: Expression) -> bool:
        """Whether its value changes while the scene runs."""
        known = self.known.get(id(expression))
        if known is None:
            live = (
                (isinstance(expression, Call) and FUNCTIONS[expression.function].live)
                or (isinstance(expression, Name) and expression.id in self.places)
                or any(map(self.is_live, parts_of(expression)))
            )
            known = self.known[id(expression)] = live, expression
        return known[0]

    def put(self, name: str, place: int) -> None:
        """Say where the value is from now on that the plan computes under a name."""
        self.places[name] = place
        self.known.clear()

    def code(self, expression: Expression) -> Code:
        """A number or a truth as code.

        Raises:
            NotCovered: It cannot be said.
        """
        start = len(self.instructions)
        depth = self._emit(expression)
        if depth > STACK:
            raise NotCovered("an expression too deep")
        return Code(start, len(self.instructions) - start)

    def number(self, value: float) -> Code:
        """A number as code."""
        return self.code(Number(value))

    def bind(self, name: str, expression: Expression) -> None:
        """Let a name of the plan itself stand for a value that stays while the scene runs."""

        def again(_: Any) -> None:
            self.bound[name] = self.value(expression)

        again(None)
        if self.differs(expression):
            self.differ.add(name)
            self._do_again(again)

    def _do_again(self, part: Anew) -> None:
        if self.anew is not None:
            self.anew.append(part)

    def differs(self, expression: Expression) -> bool:
        """Whether its value, which stays while the scene runs, may be another one in another scene, if one asks."""
        if self.anew is None:
            return False
        match expression:
            case Parameter():
                return True
            case Name(name):
                if name in self.differ or (name not in self.bound and name in self.around.drawn):
                    return True
                value = self._named(name) if self._knows(name) else None
                return any(value is self.around.objects[i] for i in self.around.moved)
            case AnyOf():
                self._do_again(_refuse)  # its conditions are made anew each time
                return True
            case _:
                return any(map(self.differs, parts_of(expression)))

    def _holds(self, expression: Expression, check: Callable[[Any], bool]) -> bool:
        """Whether something is true of a value; a scene of which it is not is to be bound by itself."""
        true = bool(check(self.value(expression)))

        def again(_: Any) -> None:
            if bool(check(self.value(expression))) != true:
                _refuse(None)

        if self.differs(expression):
            self._do_again(again)
        return true

    def path(self, expression: Expression) -> int:
        """The number of the line that a path is."""
        line = line_of(self.value(expression))

        def again(_: Any) -> None:
            if line_of(self.value(expression)) is not line:
                _refuse(None)

        if self.differs(expression):
            self._do_again(again)
        return self.line(line)

    def line(self, path: Any) -> int:
        """The number of a line."""
        line = line_of(path)
        for i, known in enumerate(self.lines):
            if known is line:
                return i
        self.lines.append(line)
        return len(self.lines) - 1

    def actor(self, expression: Expression) -> int:
        """The number of an actor.

        Raises:
            NotCovered: It is none of the scene's.
        """
        index = self.index_of(self.value(expression))

        def again(_: Any) -> None:
            if self.index_of(self.value(expression)) != index:
                _refuse(None)

        if self.differs(expression):
            self._do_again(again)
        return index

    def index_of(self, actor: Any) -> int:
        """The number of something in the scene.

        Raises:
            NotCovered: It is none of the scene's.
        """
        body = getattr(actor, "body", None)
        for i, known in enumerate(self.around.objects):
            if known is actor or (body is not None and known.body is body):
                return i
        raise NotCovered("an actor that is not in the scene")

    def value(self, expression: Expression) -> Any:  # noqa: C901, PLR0911, PLR0912
        """What an expression stands for that does not depend on poses.

        Raises:
            NotCovered: It cannot be said.
        """
        match expression:
            case Number(value) | Text(value):
                return value
            case Texts(values):
                return values
            case Name(name):
                return self._named(name)
            case Parameter(name):
                return self.around.parameters[name]
            case Negation(of):
                return -self.value(of)
            case Not(of):
                return not self.value(of)
            case Arithmetic(sign, left, right):
                return _ARITHMETIC[sign][1](self.value(left), self.value(right))
            case Comparison(first, links):
                left = self.value(first)
                for relation, part in links:
                    right = self.value(part)
                    if not _RELATIONS[relation][1](left, right):
                        return False
                    left = right
                return True
            case Boolean(joint, terms):
                return (all if joint == "and" else any)(bool(self.value(term)) for term in terms)
            case Conditional(test, then, otherwise):
                return self.value(then if self.value(test) else otherwise)
            case AnyOf():
                return any(self.value(condition) for condition in self._each(expression))
            case Call("others"):
                ego, own = self.around.objects[0], self.around.objects[self.around.self_index]
                return [one for one in self.around.objects if one is not ego and one is not own]
            case Call(function, arguments):
                if function not in _FIXED:
                    raise NotCovered(f"the value of {function} before the drive")
                return _FIXED[function](*(self.value(argument) for argument in arguments))

    def _named(self, name: str) -> Any:
        if name in self.bound:
            return self.bound[name]
        if name == "self":
            return self.around.objects[self.around.self_index]
        if name == "ego":
            return self.around.objects[0]
        if name not in self.around.names:
            raise NotCovered("a name that the program does not set")
        return self.around.names[name]

    def _knows(self, name: str) -> bool:
        return name in self.bound or name in ("self", "ego") or name in self.around.names

    def _each(self, any_of: AnyOf) -> list[Expression]:
        """Its condition for each actor, as the same condition over a name of its own."""
        conditions: list[Expression] = []
        for i, actor in enumerate(self.value(any_of.actors)):
            name = f"{any_of.actor} {len(self.bound)} {i}"
            self.bound[name] = actor
            conditions.append(_renamed(any_of.condition, any_of.actor, name))
        return conditions

    def _add(self, name: str, a: int = -1, b: int = -1, value: float = 0.0) -> None:
        self.instructions.append(Instruction(OPERATIONS[name], a, b, 0, value))

    def _emit(self, expression: Expression) -> int:  # noqa: C901, PLR0911, PLR0912
        """Code for an expression; how deep the stack becomes."""
        if not self.is_live(expression):
            place = len(self.instructions)
            self._add("CONST", value=float(self.value(expression)))
            if self.differs(expression):
                self._do_again(lambda code: setattr(code[place], "value", float(self.value(expression))))
            return 1
        match expression:
            case Name(name):
                self._add("LOCAL", self.places[name])
                return 1
            case Negation(of):
                return self._of("NEG", of)
            case Not(of):
                return self._of("NOT", of)
            case Arithmetic(sign, left, right):
                if sign == "/" and not self._is_never_zero(right):
                    raise NotCovered("a division by what may become zero")
                return self._of(_ARITHMETIC[sign][0], left, right)
            case Comparison(first, links):
                depth, left = 0, first
                for i, (relation, right) in enumerate(links):
                    depth = max(depth, self._of(_RELATIONS[relation][0], left, right) + (i > 0))
                    left = right
                    if i:
                        self._add("AND")
                return depth
            case Boolean(joint, terms):
                return self._joined("AND" if joint == "and" else "OR", terms)
            case Conditional(test, then, otherwise):
                return self._of("SELECT", then, otherwise, test)
            case AnyOf(actors=actors):
                conditions = self._each(expression)
                if self.differs(actors):
                    self._do_again(_refuse)  # others may be meant
                if not conditions:
                    self._add("CONST", value=0.0)
                    return 1
                return self._joined("OR", tuple(conditions))
            case Call(function, arguments):
                return self._call(function, arguments)
            case _:
                raise NotCovered(f"{with_article(type(expression).__name__)} that changes")

    def _is_never_zero(self, expression: Expression) -> bool:
        """Whether it stays and is not zero, or is the greatest of several of which one stays above zero."""
        if not self.is_live(expression):
            return self._holds(expression, lambda value: value != 0)
        match expression:
            case Call("max", arguments):
                return any(not self.is_live(one) and self._holds(one, lambda value: value > 0) for one in arguments)
            case _:
                return False

    def _of(self, name: str, *operands: Expression) -> int:
        depth = max(self._emit(operand) + i for i, operand in enumerate(operands))
        self._add(name)
        return depth

    def _joined(self, name: str, terms: tuple[Expression, ...]) -> int:
        depth = self._emit(terms[0])
        for term in terms[1:]:
            depth = max(depth, self._emit(term) + 1)
            self._add(name)
        return depth

    def _call(self, function: str, arguments: tuple[Expression, ...]) -> int:  # noqa: C901, PLR0911
        match function:
            case "abs":
                return self._of("ABS", *arguments)
            case "max" | "min":
                return self._joined(function.upper(), arguments)
            case "gap":
                self._add("GAP", self.actor(arguments[0]), self.actor(arguments[1]))
            case "speed" | "heading":
                self._add(function.upper(), b=self.actor(arguments[0]))
            case "progress":
                self._place("ALONG", arguments[0], arguments[1])
            case "offsetFrom":
                self._place("OFFSET", arguments[0], arguments[1])
            case "distanceLeft":  # to - along
                depth = self._emit(arguments[2])
                self._place("ALONG", arguments[0], arguments[1])
                self._add("SUB")
                return max(depth, 2)
            case "headway":  # of b - of a
                self._place("ALONG", arguments[0], arguments[2])
                self._place("ALONG", arguments[0], arguments[1])
                self._add("SUB")
                return 2
            case "secondsTo":
                return self._seconds(*arguments)
            case "brakingDistance":
                self._braked(arguments[0])
            case "restsWithin":
                self._place("OFFSET", arguments[0], arguments[1])
                self._add("ABS")
                self._braked(arguments[1])
                self._add("SUB")
                depth = self._emit(arguments[2])
                self._add("LT")
                return max(depth + 1, 2)
            case _:
                raise NotCovered(f"{function} of what changes")
        return 1

    def _place(self, name: str, path: Expression, actor: Expression) -> None:
        if self.is_live(path):
            raise NotCovered("a path that changes")
        self._add(name, self.path(path), self.actor(actor))

    def _seconds(self, path: Expression, actor: Expression, to: Expression) -> int:
        """As `chatscene.world.places.secondsTo` computes it, operation by operation."""
        if self.differs(actor) or self.differs(path):
            self._do_again(_refuse)
        pace, ego = Pace.of(self.value(actor)), self.around.objects[self.actor(actor)]
        if (table := timetable_of(self.value(path), ego)) is not None:
            return self._by_table(self._table(table), pace, path, actor, to)
        left = Call("distanceLeft", (path, actor, to))
        missing = Call("max", (Number(0.0), Arithmetic("-", Number(pace.speed), Call("speed", (actor,)))))
        square = Arithmetic("*", missing, missing)
        late = Arithmetic("*", square, Number(pace.loss))
        return self._emit(Arithmetic("+", Arithmetic("/", left, Number(pace.speed)), late))

    def _table(self, table: Timetable) -> int:
        """The number of a timetable."""
        if table not in self.tables:
            self.tables.append(table)
        return self.tables.index(table)

    def _by_table(self, table: int, pace: Pace, path: Expression, actor: Expression, to: Expression) -> int:
        """The same, of an ego of which a speed is wanted."""
        depth = self._emit(to)
        line, index = self.line(self.value(path)), self.actor(actor)
        self.instructions.append(Instruction(OPERATIONS["SECONDS"], line, index, table, pace.gain))
        return depth

    def _braked(self, actor: Expression) -> None:
        index = self.actor(actor)
        thing = self.around.objects[index]
        if (kind := kind_of(thing)) not in LIMITS:
            raise NotCovered("how far a thing brakes")
        self._add("BRAKED", b=index, value=2 * min(LIMITS[kind].brake, thing.body.grip))


def _refuse(_: Any) -> None:
    """Say that another scene is to be bound by itself."""
    raise NotCovered("more than numbers is other than in the scene before")


def _renamed(expression: Any, old: str, new: str) -> Any:
    """An expression with another name in the place of one."""
    if isinstance(expression, Name):
        return Name(new, expression.kind) if expression.id == old else expression
    if isinstance(expression, tuple):
        return tuple(_renamed(part, old, new) for part in expression)
    if hasattr(expression, "__dataclass_fields__"):
        parts = {name: getattr(expression, name) for name in expression.__dataclass_fields__}
        return type(expression)(**{name: _renamed(part, old, new) for name, part in parts.items()})
    return expression
