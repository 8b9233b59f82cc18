"""Numbers that hang on parameters alone, in one form each: a constant and multiples of what is no sum.

Two ways to write the same sum become one expression, so that what is written down and read again is the same.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from chatscene.terms.plan import Arithmetic, Call, Expression, Negation, Number, Parameter

_DECIMALS = 6


@dataclass(frozen=True, slots=True)
class Sum:
    """A constant and terms.

    Attributes:
        terms: Multiples, each a factor and what it multiplies.
    """

    constant: float
    terms: tuple[tuple[float, Expression], ...] = ()

    def __add__(self, other: Sum) -> Sum:
        """Both together, terms in the order in which they first stand."""
        found: dict[Expression, float] = {}
        for factor, term in (*self.terms, *other.terms):
            found[term] = _round(found.get(term, 0.0) + factor)
        return Sum(_round(self.constant + other.constant), tuple((f, t) for t, f in found.items() if f))

    def times(self, factor: float) -> Sum:
        """So many of it."""
        return Sum(_round(self.constant * factor), tuple((_round(f * factor), t) for f, t in self.terms))

    @property
    def number(self) -> float | None:
        """What it is, if no parameter matters."""
        return None if self.terms else self.constant

    @property
    def expression(self) -> Expression:
        """It as an expression."""
        whole: Expression | None = None
        for factor, term in self.terms:
            size: Expression = term if abs(factor) == 1 else Arithmetic("*", Number(abs(factor)), term)
            if whole is None and factor < 0 and self.constant:
                whole = Number(self.constant)
            if whole is None:
                whole = size if factor > 0 else Negation(size)
            else:
                whole = Arithmetic("+" if factor > 0 else "-", whole, size)
        if whole is None:
            return Number(self.constant)
        if self.constant and not (self.terms[0][0] < 0):
            sign = "+" if self.constant > 0 else "-"
            whole = Arithmetic(sign, whole, Number(abs(self.constant)))
        return whole


def _round(value: float) -> float:
    return round(value, _DECIMALS) + 0.0


def number(value: float) -> Sum:
    """A constant."""
    return Sum(_round(value))


def product(one: Sum, other: Sum) -> Sum:
    """One times the other."""
    if one.number is not None:
        return other.times(one.number)
    if other.number is not None:
        return one.times(other.number)
    return Sum(0.0, ((1.0, Arithmetic("*", one.expression, other.expression)),))


def quotient(one: Sum, other: Sum) -> Sum:
    """One by the other.

    Raises:
        ZeroDivisionError: The other is 0.
    """
    if other.number is not None:
        return one.times(1 / other.number)
    return Sum(0.0, tuple((f, Arithmetic("/", t, other.expression)) for f, t in one.terms)) + (
        Sum(0.0, ((1.0, Arithmetic("/", Number(one.constant), other.expression)),)) if one.constant else Sum(0.0)
    )


def called(function: str, arguments: Iterable[Sum]) -> Sum:
    """``abs``, ``max`` or ``min`` of sums."""
    given = tuple(arguments)
    if all(one.number is not None for one in given):
        return number({"abs": abs, "max": max, "min": min}[function](*(one.constant for one in given)))
    return Sum(0.0, ((1.0, Call(function, tuple(one.expression for one in given))),))


def sum_of(expression: Expression) -> Sum | None:  # noqa: PLR0911
    """The sum that an expression of numbers and parameters is; None if it speaks of anything else."""
    match expression:
        case Number(value):
            return number(value)
        case Parameter():
            return Sum(0.0, ((1.0, expression),))
        case Negation(of):
            inner = sum_of(of)
            return inner and inner.times(-1)
        case Arithmetic(operator, left, right):
            one, other = sum_of(left), sum_of(right)
            if one is None or other is None:
                return None
            return combined(operator, one, other)
        case Call("abs" | "max" | "min" as function, arguments):
            parts = [sum_of(argument) for argument in arguments]
            known = [part for part in parts if part is not None]
            return called(function, known) if len(known) == len(parts) else None
        case _:
            return None


def combined(operator: str, one: Sum, other: Sum) -> Sum:
    """Two sums and what to do with them.

    Raises:
        ZeroDivisionError: One is divided by 0.
    """
    match operator:
        case "+":
            return one + other
        case "-":
            return one + other.times(-1)
        case "*":
            return product(one, other)
        case _:
            return quotient(one, other)


def valued(expression: Expression, values: Mapping[str, float]) -> float:
    """What a number is with these values of parameters."""
    match expression:
        case Number(value):
            return value
        case Parameter(name):
            return values[name]
        case Negation(of):
            return -valued(of, values)
        case Arithmetic(operator, left, right):
            one, other = valued(left, values), valued(right, values)
            return {"+": one + other, "-": one - other, "*": one * other}[operator] if operator != "/" else one / other
        case Call(function, arguments):
            return {"abs": abs, "max": max, "min": min}[function](*(valued(one, values) for one in arguments))
        case _:
            raise TypeError(f"{expression!r} hangs on more than parameters")
