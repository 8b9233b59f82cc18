"""What an expression of OpenSCENARIO is, once every parameter in it has a value."""

from __future__ import annotations

import ast
import math
import operator
import re
from collections.abc import Callable
from typing import Any

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
