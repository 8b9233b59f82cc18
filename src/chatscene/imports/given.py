"""What a scenario file gives: its parameters, the numbers made of them, and what of it is taken, noted or refused."""

from __future__ import annotations

import ast
import math
import operator
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from itertools import product
from pathlib import Path
from typing import Any

from chatscene.errors import ScenarioError, SnippetError
from chatscene.imports.names import Apart
from chatscene.imports.stranger_xml import Element
from chatscene.terms.plan import Parameter, walk
from chatscene.terms.plan_text import PARAMETERS, parse_expression
from chatscene.terms.snippet import ParameterRange
from chatscene.terms.sums import Sum, number, sum_of, valued

REPORTED = 20  # refusals in one message
DEEPEST = 50  # parameters, each an expression of the next
MOST_CHARACTERS = 4_000  # of an expression with its parameters: each may name another twice
MOST_VARYING = 6  # parameters in one expression: a sum is looked at in every corner of their ranges
_FARTHEST = 1e6  # beyond which no number is read
REFERENCE = re.compile(r"\$([A-Za-z_][A-Za-z0-9_]*)")
_RANGED = frozenset(("double", "int", "integer", "unsignedInt", "unsignedShort"))
_LOWER, _UPPER = frozenset(("greaterOrEqual", "greaterThan")), frozenset(("lessOrEqual", "lessThan"))


class Refused(Exception):  # noqa: N818 - reads as what it says
    """An element says what cannot be said here."""

    def __init__(self, element: Element, why: str) -> None:
        super().__init__(f"{element.where}: <{element.tag}>: {why}")
        self.why = why


@dataclass(slots=True)
class Given:
    """What a file gives.

    Attributes:
        ranges: Parameters that vary, by their name in the file.
        values: The value of every parameter, as written.
        notes: What was taken otherwise than it is written, or left to others, each with its line.
        refusals: What cannot be said here, each with its line.
        fixed: Parameters that keep their values, whatever range they have.
        wanted: Those that vary and stand where nothing may vary; the file is to be read again with them fixed.
        told: Values of parameters that were told from outside, as by a set of parameter values.
        spans: Ends between which parameters vary that were told from outside.
        within: The folder in which every other file lies that is opened; None for any.
    """

    ranges: dict[str, ParameterRange] = field(default_factory=dict[str, ParameterRange])
    values: dict[str, str] = field(default_factory=dict[str, str])
    notes: list[str] = field(default_factory=list[str])
    refusals: list[str] = field(default_factory=list[str])
    fixed: frozenset[str] = frozenset()
    wanted: set[str] = field(default_factory=set[str])
    told: Mapping[str, str] = field(default_factory=dict[str, str])
    spans: Mapping[str, tuple[float, float]] = field(default_factory=dict[str, tuple[float, float]])
    within: Path | None = None
    _known: dict[str, float] = field(default_factory=dict[str, float])

    def note(self, element: Element, what: str) -> None:
        """Note what was taken otherwise than it is written."""
        self.notes.append(f"{element.where}: {what}")

    def copied(self) -> Given:
        """The same, to be read on from in another way."""
        return replace(
            self,
            ranges=dict(self.ranges),
            values=dict(self.values),
            notes=list(self.notes),
            refusals=list(self.refusals),
            wanted=set(self.wanted),
            _known={},
        )

    def declare(self, root: Element) -> None:
        """Read the parameters of a file."""
        constrained: list[tuple[Element, str, str, list[Element]]] = []
        for one in (below for group in root.all("ParameterDeclarations") for below in group.inside):
            name, kind = one.attributes.get("name", "").removeprefix("$"), one.attributes.get("parameterType", "double")
            if not re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]{0,50}", name):
                self.refusals.append(str(Refused(one, f"{name[:40]!r} is not a name; use letters, digits and _")))
                continue
            self.values[name] = self.told.get(name, one.attributes.get("value", ""))
            groups = one.all("ConstraintGroup")
            if name in self.spans:
                low, high = self.spans[name]
                self.values[name] = repr((low + high) / 2)
                if name in self.fixed:
                    self.note(
                        one, f"${name} stands where nothing may vary here; it keeps the value {(low + high) / 2!r}"
                    )
                else:
                    self._vary(one, name, kind, low, high)
            elif groups:
                constrained.append((one, name, kind, groups))
        for one, name, kind, groups in constrained:  # once all are known, of which values may be made
            self._constrained(one, name, kind, groups)
        for name in sorted(set(self.told) - set(self.values)):
            self.note(root, f"the scenario declares no parameter {name[:40]!r}; its value is left out")

    def _constrained(self, declared: Element, name: str, kind: str, groups: list[Element]) -> None:
        """Let a parameter vary between the two ends that its constraints give it; else it keeps its value."""
        try:
            found = self._range(groups) if kind in _RANGED else None
            at = self._evaluated(declared, f"${name}", ()) if kind in _RANGED else 0.0
        except (Refused, ValueError) as reason:
            self.refusals.append(str(reason if isinstance(reason, Refused) else Refused(declared, str(reason))))
            return
        if found is not None and name in self.told:  # which whoever asks for it may have beyond them
            if not found[0] <= at <= found[1]:
                self.note(declared, f"${name} is {at:g}, and its constraints are {found[0]:g} to {found[1]:g}")
        elif found is None:
            self.note(
                declared,
                f"its constraints give no range with two ends; ${name} keeps the value {self.values[name][:40]}",
            )
        elif name in self.fixed:
            self.note(
                declared, f"${name} stands where nothing may vary here; it keeps the value {self.values[name][:40]}"
            )
        elif not found[0] <= at <= found[1]:
            self.refusals.append(str(Refused(declared, f"{at:g} is not within {found[0]:g} to {found[1]:g}")))
        elif not self.values[name].strip().startswith("$"):  # else it is what it is made of
            self._vary(declared, name, kind, *found)

    def _vary(self, declared: Element, name: str, kind: str, low: float, high: float) -> None:
        """Let a parameter vary, under a name of its own."""
        upper = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", name).upper().lstrip("_")
        apart = Apart("_", (one.name for one in self.ranges.values()))
        called = apart.of(upper if upper.startswith("OPT_") else f"OPT_{upper}")
        self.ranges[name] = ParameterRange(name=called, low=low, high=high, unit="1")
        if kind != "double":
            self.note(
                declared, f"${name} is of the type {kind}, and varies here among all numbers, not only whole ones"
            )

    def _range(self, groups: list[Element]) -> tuple[float, float] | None:
        """The range that a group of constraints gives; None where it has not two ends, or there are several groups."""
        lows, highs = list[float](), list[float]()
        for one in groups[0].inside:
            rule = one.attributes.get("rule", "")
            value = one.attributes.get("value", "")
            if rule not in _LOWER | _UPPER or len(groups) > 1 or value.strip().startswith("$"):
                return None
            (lows if rule in _LOWER else highs).append(finite(one, value))
        if not lows or not highs or max(lows) > min(highs):
            return None
        return max(lows), min(highs)

    def text(self, element: Element, name: str, default: str | None = None) -> str:
        """What an attribute says; the value of a parameter in its place."""
        written = element.attributes.get(name, default)
        if written is None:
            raise Refused(element, f"it has no attribute {name!r}")
        within: tuple[str, ...] = ()
        while (found := REFERENCE.fullmatch(written)) is not None:
            if found[1] in self.ranges:
                self.wanted.add(found[1])
            self._defined(element, found[1], within)
            within = (*within, found[1])
            written = self.values[found[1]]
        if written.startswith("${"):
            value = self._calculated(element, written)
            return str(int(value)) if value == int(value) else repr(value)
        return written

    def flag(self, element: Element, name: str, default: str = "false") -> bool:
        """Whether an attribute says that something holds."""
        return self.text(element, name, default).strip().lower() in ("true", "1")

    def sum(self, element: Element, name: str, default: str | None = None) -> Sum:
        """The number that an attribute says, of parameters that vary."""
        written = element.attributes.get(name, default)
        if written is None:
            raise Refused(element, f"it has no attribute {name!r}")
        written = written.strip()
        if not written.startswith("$"):
            return number(finite(element, written))
        names = self._names(written)
        varying = [name for name in names if name in self.ranges]
        if not varying:
            return number(self._calculated(element, written))
        try:
            few = len(varying) <= MOST_VARYING
            found = sum_of(parse_expression(self._filled(element, written, ()))) if few else None
        except (SnippetError, ZeroDivisionError):
            found = None
        if found is None:  # more than a plan computes: what varies in it is to keep its value
            self.wanted.update(varying)
            return number(self._calculated(element, written))
        return found

    def _names(self, written: str) -> set[str]:
        """The parameters in an expression, and in what they stand for."""
        found: set[str] = set()
        waiting = set(REFERENCE.findall(written))
        while waiting:
            found.add(name := waiting.pop())
            waiting |= set(REFERENCE.findall(self.values.get(name, ""))) - found
        return found

    def _calculated(self, element: Element, written: str) -> float:
        """The value of an expression, with every parameter at its value."""
        try:
            found = self._evaluated(element, written, ())
        except ValueError as error:
            raise Refused(element, f"{written[:60]!r} is not a number that can be said here ({error})") from error
        return finite(element, repr(found))

    def least(self, one: Sum) -> float:
        """The least that a sum is at the ends of the ranges of its parameters."""
        expression = one.expression
        read = {part.name for part in walk(expression) if isinstance(part, Parameter)}
        ends = [[(r.name, r.low), (r.name, r.high)] for r in self.ranges.values() if r.name in read]
        return min(valued(expression, dict(corner)) for corner in product(*ends))

    def _filled(self, element: Element, written: str, within: tuple[str, ...]) -> str:
        """An expression with what each parameter stands for, which may be an expression of others."""
        return _replaced(element, written, lambda name: self._spelled(element, name, within))

    def _spelled(self, element: Element, name: str, within: tuple[str, ...]) -> str:
        if name in self.ranges:
            return f"{PARAMETERS}.{self.ranges[name].name}"
        text = self._defined(element, name, within)
        if text.startswith("$"):
            return f"({self._filled(element, text, (*within, name))})"
        return f"({finite(element, text)!r})"

    def _evaluated(self, element: Element, written: str, within: tuple[str, ...]) -> float:
        """The value of an expression."""
        return calculated(_replaced(element, written, lambda name: f"({self._value(element, name, within)!r})"))

    def _value(self, element: Element, name: str, within: tuple[str, ...]) -> float:
        """The value of a parameter, computed once however often expressions name it."""
        if name not in self._known:
            text = self._defined(element, name, within)
            computed = text.startswith("$")
            self._known[name] = self._evaluated(element, text, (*within, name)) if computed else finite(element, text)
        return self._known[name]

    def _defined(self, element: Element, name: str, within: tuple[str, ...]) -> str:
        """What a parameter stands for, as it is written; `within` are those of whose expressions it is a part."""
        if name not in self.values:
            raise Refused(element, f"it speaks of ${name}, which the file does not declare")
        if name in within or len(within) > DEEPEST:
            raise Refused(element, f"${name} is an expression of itself, or of too many others in a row")
        text = self.values[name].strip()
        return {"true": "1", "false": "0"}.get(text.lower(), text)

    def number(self, element: Element, name: str, default: str | None = None) -> float:
        """The number that an attribute says, where it may not vary: parameters in it are to keep their values."""
        found = self.sum(element, name, default)
        if found.number is None:
            self.wanted.update(one for one in self._names(element.attributes.get(name, "")) if one in self.ranges)
            return valued(found.expression, self.nominal)
        return found.number

    def limit(self, element: Element, name: str, default: str = "INF") -> float:
        """The number that an attribute says of what bounds something; infinite for INF, and beyond a million."""
        try:
            written = float(self.text(element, name, default))
        except ValueError:
            return self.number(element, name, default)
        return math.inf if written > _FARTHEST else self.number(element, name, default)

    def count(self, element: Element, name: str, default: str | None = None) -> int:
        """The whole number that an attribute says."""
        found = self.number(element, name, default)
        if found != int(found):
            raise Refused(element, f"its {name} is {found:g}, and is to be a whole number")
        return int(found)

    @property
    def nominal(self) -> Mapping[str, float]:
        """The value of each parameter that varies, by its name here."""
        return {one.name: one.clip(float(self.values[name])) for name, one in self.ranges.items()}

    def raise_refusals(self, path: object) -> None:
        """Tell all that was refused.

        Raises:
            ScenarioError: Anything was.
        """
        if self.refusals:
            told = list(dict.fromkeys(self.refusals))
            more = f"\n  and {len(told) - REPORTED} more" if len(told) > REPORTED else ""
            raise ScenarioError(f"{path} cannot be said here:\n  " + "\n  ".join(told[:REPORTED]) + more)


def finite(element: Element, written: str) -> float:
    """The number that a text of an element is.

    Raises:
        Refused: It is none, or none within a million.
    """
    try:
        found = float(written)
    except ValueError:
        raise Refused(element, f"{written[:40]!r} is not a number") from None
    if not math.isfinite(found) or abs(found) > _FARTHEST:
        raise Refused(element, f"{written[:40]} is not a number within a million")
    return found


def _replaced(element: Element, written: str, of: Callable[[str], str]) -> str:
    """An expression with something in the place of each parameter."""
    inner = written[2:-1] if written.startswith("${") and written.endswith("}") else written
    replaced = REFERENCE.sub(lambda one: of(one[1]), inner)
    if len(replaced) > MOST_CHARACTERS:
        raise Refused(element, f"{written[:40]!r} is longer than {MOST_CHARACTERS} characters with its parameters")
    return replaced


# What an expression of OpenSCENARIO is, once every parameter in it has a value


_TWO: dict[type[ast.AST], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.Mod: math.fmod,
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
}
_ONE: dict[type[ast.AST], Callable[[Any], Any]] = {
    ast.USub: operator.neg,
    ast.UAdd: operator.pos,
    ast.Not: operator.not_,
}
_NAMES = {"pi": math.pi, "true": 1.0, "false": 0.0, "e": math.e}
_OF_MATH = ("sqrt", "pow", "sin", "cos", "tan", "asin", "acos", "atan", "floor", "ceil")
_FUNCTIONS: dict[str, Callable[..., Any]] = {
    **{name: getattr(math, name) for name in _OF_MATH},
    "abs": abs,
    "max": max,
    "min": min,
    "sign": lambda value: math.copysign(1.0, value) if value else 0.0,  # pyright: ignore[reportUnknownLambdaType]
    "round": lambda value: math.floor(value + 0.5),  # pyright: ignore[reportUnknownLambdaType]
}
_SIGNS = re.compile(r"&&|\|\||!(?!=)")


def calculated(text: str) -> float:
    """The value of an expression of numbers.

    Raises:
        ValueError: It is none, or has no value; the message says what in it is not known.
    """
    plain = _SIGNS.sub(lambda one: {"&&": " and ", "||": " or ", "!": " not "}[one[0]], text).strip()
    try:
        return float(_value(ast.parse(plain, mode="eval").body))
    except SyntaxError as error:
        raise ValueError("it is not an expression") from error
    except (RecursionError, MemoryError) as error:
        raise ValueError("brackets within brackets, too many to follow") from error
    except (ArithmeticError, TypeError) as error:
        raise ValueError(str(error)) from error


def _value(node: ast.expr) -> Any:  # noqa: PLR0911
    match node:
        case ast.Constant(value=bool() | int() | float() as value):
            return float(value)
        case ast.Name(id=name) if name in _NAMES:
            return _NAMES[name]
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _TWO:
            return _TWO[type(op)](_value(left), _value(right))
        case ast.UnaryOp(op=op, operand=operand) if type(op) in _ONE:
            return _ONE[type(op)](_value(operand))
        case ast.Compare(left=left, ops=[op], comparators=[right]) if type(op) in _TWO:
            return _TWO[type(op)](_value(left), _value(right))
        case ast.BoolOp(op=op, values=values):
            parts = [bool(_value(one)) for one in values]
            return all(parts) if isinstance(op, ast.And) else any(parts)
        case ast.Call(func=ast.Name(id=name), args=args, keywords=[]) if name in _FUNCTIONS:
            return _FUNCTIONS[name](*(_value(one) for one in args))
        case _:
            raise ValueError(f"{ast.unparse(node)[:40]!r} is not known")
