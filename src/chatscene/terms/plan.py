"""Plans: what an actor does, as phases that are data. A behavior of the library is the text of one.

A plan is typed to its last number, so that whoever reads it (a simulator without Scenic, an exporter, a check)
needs no parser of code. Its words are closed: `PRIMITIVES` and `FUNCTIONS` are all that a plan can say.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from enum import StrEnum
from typing import Literal


class Kind(StrEnum):
    """What an expression stands for."""

    NUMBER = "number"
    TRUTH = "truth"
    TEXT = "text"
    PATH = "path"  # a line in driving order
    ACTOR = "actor"
    ACTORS = "actors"


# Expressions


@dataclass(frozen=True, slots=True)
class Number:
    """A number that stands in the plan."""

    value: int | float


@dataclass(frozen=True, slots=True)
class Text:
    """One of the words that the library compares, such as the colour of a light."""

    value: str


@dataclass(frozen=True, slots=True)
class Texts:
    """Several words, best first."""

    values: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class Name:
    """What a partner, the world or a local value of the plan calls so.

    Attributes:
        kind: What it must stand for where it is used.
    """

    id: str
    kind: Kind


@dataclass(frozen=True, slots=True)
class Parameter:
    """The value that a parameter has in the scene.

    Attributes:
        name: With its prefix, e.g. ``OPT_ADV_SPEED``.
    """

    name: str


@dataclass(frozen=True, slots=True)
class Negation:
    """A number with the other sign."""

    of: Expression


@dataclass(frozen=True, slots=True)
class Not:
    """What holds if something does not."""

    of: Expression


@dataclass(frozen=True, slots=True)
class Arithmetic:
    """Two numbers and what to do with them."""

    operator: Operator
    left: Expression
    right: Expression


Operator = Literal["+", "-", "*", "/"]
Relation = Literal["<", "<=", ">", ">=", "==", "!="]


@dataclass(frozen=True, slots=True)
class Comparison:
    """A chain of comparisons, all of which must hold, as in ``0 < x < 5``.

    Attributes:
        links: Each relation with what stands to the right of it; at least one.
    """

    first: Expression
    links: tuple[tuple[Relation, Expression], ...]


@dataclass(frozen=True, slots=True)
class Boolean:
    """Truths of which all or any must hold, tried from the left; at least two."""

    operator: Literal["and", "or"]
    terms: tuple[Expression, ...]


@dataclass(frozen=True, slots=True)
class Conditional:
    """One of two values."""

    test: Expression
    then: Expression
    otherwise: Expression


@dataclass(frozen=True, slots=True)
class AnyOf:
    """Whether something holds for at least one of several actors.

    Attributes:
        actor: What the condition calls the actor that is looked at.
    """

    actor: str
    actors: Expression
    condition: Expression


@dataclass(frozen=True, slots=True, kw_only=True)
class Function:
    """Something that can be asked of numbers, paths and actors.

    Attributes:
        form: How Scenic writes it, with ``{}`` for each argument.
        takes: The kinds of its arguments; of one that takes `more`, of the first two.
        unit: Of the value: ``m``, ``m/s``, ``rad``, or empty for that of its arguments.
        live: Whether the value changes while the scene runs.
        more: Whether it takes further arguments of its last kind.
    """

    name: str
    form: str
    takes: tuple[Kind, ...]
    gives: Kind
    unit: str = ""
    live: bool = False
    more: bool = False


@dataclass(frozen=True, slots=True)
class Call:
    """The value of a function of `FUNCTIONS`."""

    function: str
    arguments: tuple[Expression, ...]


Expression = (
    Number
    | Text
    | Texts
    | Name
    | Parameter
    | Negation
    | Not
    | Arithmetic
    | Comparison
    | Boolean
    | Conditional
    | AnyOf
    | Call
)

_N, _P, _A = Kind.NUMBER, Kind.PATH, Kind.ACTOR
# fmt: off
FUNCTIONS = {function.name: function for function in (
    # The quantities of conditions
    Function(name="distanceLeft", form="distanceLeft({}, {}, {})", takes=(_P, _A, _N), gives=_N, unit="m", live=True),
    Function(name="headway", form="headway({}, {}, {})", takes=(_P, _A, _A), gives=_N, unit="m", live=True),
    Function(name="gap", form="gap({}, {})", takes=(_A, _A), gives=_N, unit="m", live=True),
    Function(name="offsetFrom", form="offsetFrom({}, {})", takes=(_P, _A), gives=_N, unit="m", live=True),
    Function(name="restsWithin", form="restsWithin({}, {}, {})", takes=(_P, _A, _N), gives=Kind.TRUTH, live=True),
    Function(name="speed", form="{}.pose[3]", takes=(_A,), gives=_N, unit="m/s", live=True),
    Function(name="heading", form="{}.pose[2]", takes=(_A,), gives=_N, unit="rad", live=True),
    Function(name="progress", form="progressOn({}, {})[0]", takes=(_P, _A), gives=_N, unit="m", live=True),
    Function(name="secondsTo", form="secondsTo({}, {}, {})", takes=(_P, _A, _N), gives=_N, unit="s", live=True),
    Function(name="brakingDistance", form="brakingDistance({})", takes=(_A,), gives=_N, unit="m", live=True),
    # What stays as it is
    Function(name="length", form="{}.length", takes=(_A,), gives=_N, unit="m"),
    Function(name="eventAt", form="{}.eventAt", takes=(_P,), gives=_N, unit="m"),
    Function(name="exitAt", form="{}.exitAt", takes=(_P,), gives=_N, unit="m"),
    Function(name="entry", form="{}.entry", takes=(_P,), gives=_N, unit="m"),
    Function(name="abs", form="abs({})", takes=(_N,), gives=_N),
    Function(name="max", form="max({}, {})", takes=(_N, _N), gives=_N, more=True),
    Function(name="min", form="min({}, {})", takes=(_N, _N), gives=_N, more=True),
    # Paths
    Function(name="ownLane", form="ownLane({})", takes=(_P,), gives=_P),
    Function(name="against", form="against({})", takes=(_P,), gives=_P),
    Function(name="extended", form="extended({}, {})", takes=(_P, _N), gives=_P),
    Function(name="onward", form="onward({}, {})", takes=(_P, _N), gives=_P),
    Function(name="beside", form="{}.offset({})", takes=(_P, _N), gives=_P),
    # Everybody but the actor itself and the ego
    Function(
        name="others",
        form="[other for other in simulation().objects "
        "if other.body is not self.body and other.body is not ego.body]",
        takes=(), gives=Kind.ACTORS,
    ),
)}
# fmt: on


# Phases


@dataclass(frozen=True, slots=True)
class Argument:
    """What a primitive is told.

    Attributes:
        unit: Of a number: ``m``, ``m/s``, ``s``, ``rad`` or ``1``; of others empty.
        default: What holds if nothing is told; None if something must be.
    """

    name: str
    kind: Kind
    unit: str = ""
    default: int | float | None = None


@dataclass(frozen=True, slots=True)
class Primitive:
    """One thing an actor can do, as `world/behaviors.scenic` defines it.

    Attributes:
        takes: Its arguments, those without a default first.
    """

    name: str
    takes: tuple[Argument, ...]
    ends: bool = False


_PATH, _OTHER, _LEFT = Argument("path", _P), Argument("other", _A), Argument("left", _N, "m", 0)
_SPEED = Argument("speed", _N, "m/s")
# fmt: off
PRIMITIVES = {primitive.name: primitive for primitive in (
    Primitive("DrivePath", (_PATH, _SPEED, _LEFT)),
    Primitive("BrakeOnPath", (_PATH, Argument("brake", _N, "1", 1.0), _LEFT)),
    Primitive("ThrottleOnPath", (_PATH, Argument("throttle", _N, "1"), _LEFT, Argument("top", _N, "m/s", 17))),
    Primitive("SwerveOnPath", (_PATH, _SPEED, Argument("left", _N, "m"))),
    Primitive("WeaveOnPath", (_PATH, _SPEED, Argument("amplitude", _N, "m"), Argument("period", _N, "s"))),
    Primitive("PaceOnPath", (
        _PATH, _OTHER, Argument("ahead", _N, "m", 0), Argument("top", _N, "m/s", 25), Argument("least", _N, "m/s", 0),
    )),
    Primitive("KeepStation", (_PATH, _OTHER, Argument("least", _N, "m/s", 5))),
    Primitive("FollowTraffic", (_PATH, _SPEED)),
    Primitive("WaitFor", (_OTHER, Argument("way", _P), _SPEED)),
    Primitive("ReverseStraight", (_SPEED,)),
    Primitive("ReverseTurning", (_SPEED, Argument("steer", _N, "1"))),
    Primitive("TurnOff", (Argument("angle", _N, "rad"), _SPEED, Argument("radius", _N, "m", 6)), ends=True),
    Primitive("Slide", (Argument("spin", _N, "1/m"), Argument("brake", _N, "1"))),
    Primitive("Park", ()),
    Primitive("MoveAhead", (_SPEED, Argument("turn", _N, "rad", 0))),
    Primitive("Halt", ()),
)}
# fmt: on


@dataclass(frozen=True, slots=True)
class Value:
    """A name that a plan gives to something."""

    name: str
    expression: Expression


@dataclass(frozen=True, slots=True)
class Until:
    """The end of a phase at the first step, that of its beginning included, in which a condition holds."""

    condition: Expression


@dataclass(frozen=True, slots=True)
class After:
    """The end of a phase some time [s] after its beginning."""

    seconds: Expression


@dataclass(frozen=True, slots=True)
class Phase:
    """A primitive, and when it ends.

    Attributes:
        primitive: Its name in `PRIMITIVES`.
        arguments: What it is told, in the order of its signature; what is left out at the end has its default.
            Each is computed once, when the phase begins.
        end: When the next phase takes over; None if the primitive must end by itself or never does.
        values: What is computed before, once, when the phase begins, and known from there on.
    """

    primitive: str
    arguments: tuple[Expression, ...] = ()
    end: Until | After | None = None
    values: tuple[Value, ...] = ()

    def argument(self, name: str) -> Expression | None:
        """What the primitive is told under a name of its signature, by default or outright; None if it takes none."""
        for i, argument in enumerate(PRIMITIVES[self.primitive].takes):
            if argument.name == name:
                if i < len(self.arguments):
                    return self.arguments[i]
                return None if argument.default is None else Number(argument.default)
        return None


@dataclass(frozen=True, slots=True)
class Range:
    """A tunable parameter as the code declares it.

    Attributes:
        name: With its prefix, e.g. ``OPT_ADV_SPEED``.
    """

    name: str
    low: int | float
    high: int | float


@dataclass(frozen=True, slots=True, kw_only=True)
class Plan:
    """What an actor does, phase after phase.

    Attributes:
        phases: At least one. When the last has ended, the actor is left to itself.
        constants: What the plan tells its partners, or itself, once for all scenes.
        loop: Index of the phase to go back to after the last; None to stop there.
    """

    phases: tuple[Phase, ...]
    parameters: tuple[Range, ...] = ()
    constants: tuple[Value, ...] = ()
    loop: int | None = None

    def constant(self, name: str) -> Expression | None:
        """What the plan tells its partners under a name; None if nothing."""
        return next((constant.expression for constant in self.constants if constant.name == name), None)


@dataclass(frozen=True, slots=True)
class Foreign:
    """A behavior that is not a plan: Scenic that says more than a plan can. It runs as any other.

    Attributes:
        reason: The first thing in it that no plan can say, with its line.
    """

    reason: str


def expressions_of(phase: Phase) -> Iterator[Expression]:
    """The whole expressions of a phase: values, arguments, and what it ends with."""
    yield from (value.expression for value in phase.values)
    yield from phase.arguments
    if phase.end is not None:
        yield phase.end.condition if isinstance(phase.end, Until) else phase.end.seconds


def parts_of(expression: Expression) -> tuple[Expression, ...]:  # noqa: PLR0911
    """The expressions that an expression is made of."""
    match expression:
        case Comparison(first, links):
            return (first, *(right for _, right in links))
        case Boolean(_, terms):
            return terms
        case Call(_, arguments):
            return arguments
        case Negation(of) | Not(of):
            return (of,)
        case Arithmetic(_, left, right):
            return (left, right)
        case Conditional(test, then, otherwise):
            return (test, then, otherwise)
        case AnyOf(_, actors, condition):
            return (actors, condition)
        case _:
            return ()


def walk(expression: Expression) -> Iterator[Expression]:
    """An expression and everything in it."""
    yield expression
    for part in parts_of(expression):
        yield from walk(part)
