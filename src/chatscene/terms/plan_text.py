"""The plan in the text of a behavior, and its text again.

What is printed is Scenic, byte for byte as the library writes it, without comments and blank lines.
"""

from __future__ import annotations

import ast
import difflib
import io
import json
import sys
import tokenize
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import lru_cache
from typing import NoReturn, cast

from chatscene.errors import SnippetError
from chatscene.terms.nouns import with_article
from chatscene.terms.plan import (
    FUNCTIONS,
    PRIMITIVES,
    After,
    AnyOf,
    Arithmetic,
    Boolean,
    Call,
    Comparison,
    Conditional,
    Expression,
    Foreign,
    Function,
    Kind,
    Name,
    Negation,
    Not,
    Number,
    Operator,
    Parameter,
    Phase,
    Plan,
    Range,
    Relation,
    Text,
    Texts,
    Until,
    Value,
)
from chatscene.terms.scenario import Component
from chatscene.terms.snippet import Snippet

BEHAVIOR = "AdvBehavior"  # what every program calls its adversary's
PARAMETERS = "globalParameters"  # where Scenic keeps the values of parameters


def plan_of(snippet: Snippet) -> Plan | Foreign:
    """The plan that a snippet is the text of, or why it is none."""
    if snippet.component is not Component.BEHAVIOR:
        return Foreign(f"{with_article(snippet.component)} says where, not what is done")
    return _plan_of(snippet.source)


@lru_cache(maxsize=1024)
def _plan_of(source: str) -> Plan | Foreign:
    try:
        return parse_plan(source)
    except SnippetError as error:
        return Foreign(str(error))


# From text


def parse_plan(source: str) -> Plan:
    """Read the plan that a behavior's text says.

    Args:
        source: Scenic text, without a snippet's header.

    Raises:
        SnippetError: It says something that no plan can; the message names the line.
    """
    try:
        return _plan_in(_lines(source))
    except RecursionError as error:
        raise SnippetError("brackets within brackets, too many to follow") from error


@dataclass(frozen=True, slots=True)
class _Line:
    """One logical line: where it stands, how far it is indented, and its tokens."""

    number: int
    indent: int
    tokens: tuple[str, ...]

    def __str__(self) -> str:
        return " ".join(self.tokens)

    def fail(self, why: str) -> NoReturn:
        raise SnippetError(f"line {self.number}: {why}")


def _lines(source: str) -> Iterator[_Line]:
    silent = (tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER)
    begun: list[tokenize.TokenInfo] = []
    try:
        for token in tokenize.generate_tokens(io.StringIO(source).readline):
            if token.type == tokenize.NEWLINE and begun:
                yield _Line(*begun[0].start, tuple(t.string for t in begun))
                begun = []
            elif token.type not in silent:
                begun.append(token)
    except tokenize.TokenError as error:
        raise SnippetError(f"line {error.args[1][0]}: {error.args[0]}") from error
    except SyntaxError as error:
        raise SnippetError(f"line {error.lineno}: {error.msg}") from error
    except UnicodeEncodeError as error:  # from Python 3.12 on; before, half a character is a token like others
        at = next(at for at, sign in enumerate(source) if "\ud800" <= sign <= "\udfff")
        line = source.count("\n", 0, at) + 1
        raise SnippetError(f"line {line}: U+{ord(source[at]):04X} is not a character") from error


def _plan_in(lines: Iterator[_Line]) -> Plan:
    parameters: list[Range] = []
    constants: list[Value] = []
    for line in lines:
        match line.tokens:
            case ("param", *_):
                parameters.append(_range(line))
            case (name, "=", *value):
                constants.append(Value(name, _expression(line, value, _kind_of(value))))
            case ("behavior", name, "(", ")", ":") if name == BEHAVIOR and line.indent == 0:
                phases, loop = _phases(lines)
                return Plan(phases=phases, parameters=tuple(parameters), constants=tuple(constants), loop=loop)
            case _:
                line.fail(f"{str(line)!r}: a plan has parameters, constants and `behavior {BEHAVIOR}():`, nothing else")
    raise SnippetError(f"there is no `behavior {BEHAVIOR}():`")


def _range(line: _Line) -> Range:
    match line.tokens:
        case ("param", name, "=", "Range", "(", *bounds, ")") if "," in bounds:
            cut = bounds.index(",")
            low, high = (_expression(line, part, Kind.NUMBER) for part in (bounds[:cut], bounds[cut + 1 :]))
            if isinstance(low, Number) and isinstance(high, Number):
                return Range(name, low.value, high.value)
        case _:
            pass
    line.fail(f"{str(line)!r}: a parameter of a plan is `param OPT_NAME = Range(low, high)`, with two numbers")


def _phases(lines: Iterator[_Line]) -> tuple[tuple[Phase, ...], int | None]:
    phases: list[Phase] = []
    values: list[Value] = []
    loop: int | None = None
    indent = 0
    for line in lines:
        indent = indent or line.indent
        if line.indent != indent:
            line.fail(f"{str(line)!r}: nothing in a plan comes after its loop, or after its behavior")
        match line.tokens:
            case ("while", "True", ":") if loop is None and not values:
                loop, indent = len(phases), 0
            case ("do", *words):
                phases.append(_phase(line, words, tuple(values)))
                values = []
            case (name, "=", *value):
                values.append(Value(name, _expression(line, value, _kind_of(value))))
            case _:
                line.fail(f"{str(line)!r}: a plan knows `do …`, `name = …` before that, and one loop `while True:`")
    if values or not phases or loop == len(phases):
        raise SnippetError(f"`behavior {BEHAVIOR}():` ends without anything to do")
    return tuple(phases), loop


def _phase(line: _Line, words: list[str], values: tuple[Value, ...]) -> Phase:
    depth = 0
    for i, word in enumerate(words):
        depth += (word in "([{") - (word in ")]}")
        if depth == 0 and word == "until":
            end = Until(_expression(line, words[i + 1 :], Kind.TRUTH))
            break
        if depth == 0 and word == "for" and words[-1] == "seconds":
            end = After(_expression(line, words[i + 1 : -1], Kind.NUMBER))
            break
    else:
        i, end = len(words), None
    return _call(line, _node(line, words[:i]), end, values)


def _call(line: _Line, node: ast.expr, end: Until | After | None, values: tuple[Value, ...]) -> Phase:
    if not isinstance(node, ast.Call) or not isinstance(node.func, ast.Name):
        line.fail(f"`do` needs a behavior and its arguments, not {ast.unparse(node)!r}")
    name = node.func.id
    if name not in PRIMITIVES:
        near = difflib.get_close_matches(name, PRIMITIVES, n=1) or list(PRIMITIVES)
        line.fail(f"no plan can do {name!r}; it can do {', '.join(near)}")
    takes = PRIMITIVES[name].takes
    told = {argument.name: given for argument, given in zip(takes, node.args, strict=False)}
    named = {str(keyword.arg): keyword.value for keyword in node.keywords}
    wrong = sorted(set(named) - {argument.name for argument in takes} | set(named) & set(told))
    if wrong or len(node.args) > len(takes):
        signature = ", ".join(argument.name for argument in takes)
        line.fail(f"{name} takes ({signature}), each once, not {ast.unparse(node)!r}")
    told |= named
    arguments: list[Expression] = []
    for argument in takes[: max((i + 1 for i, a in enumerate(takes) if a.name in told), default=0)]:
        if argument.name in told:
            arguments.append(_read(line, told[argument.name], argument.kind))
        elif argument.default is not None:
            arguments.append(Number(argument.default))
    if missing := [a.name for a in takes if a.default is None and a.name not in told]:
        line.fail(f"{name} must be told its {', '.join(missing)}")
    return Phase(name, tuple(arguments), end, values)


def _expression(line: _Line, words: Iterable[str], kind: Kind) -> Expression:
    return _read(line, _node(line, words), kind)


def _node(line: _Line, words: Iterable[str]) -> ast.expr:
    text = " ".join(words)
    try:
        return ast.parse(f"({text})", mode="eval").body
    except (SyntaxError, ValueError, MemoryError) as error:
        raise SnippetError(f"line {line.number}: {text!r} is not an expression: {error}") from error


def _kind_of(words: list[str]) -> Kind:
    """What a name is given: several actors, words, or a number."""
    if words[:1] == ["["]:
        return Kind.ACTORS
    first = "".join(words[:2]).removeprefix("(")
    return Kind.TEXT if first.startswith(("'", '"')) else Kind.NUMBER


def _read(line: _Line, node: ast.expr, kind: Kind) -> Expression:
    """What a node of Python's tree says, if it is of a kind."""
    found, gives = _meant(line, node, kind)
    if gives is not kind:
        line.fail(f"{ast.unparse(node)!r} is {with_article(gives)}, where {with_article(kind)} is needed")
    return found


_OPERATORS: dict[type[ast.operator], Operator] = {ast.Add: "+", ast.Sub: "-", ast.Mult: "*", ast.Div: "/"}
_RELATIONS: dict[type[ast.cmpop], Relation] = {
    ast.Lt: "<",
    ast.LtE: "<=",
    ast.Gt: ">",
    ast.GtE: ">=",
    ast.Eq: "==",
    ast.NotEq: "!=",
}


def _meant(line: _Line, node: ast.expr, kind: Kind) -> tuple[Expression, Kind]:  # noqa: C901, PLR0911, PLR0912
    """What a node says where something of a kind is needed, and of which kind that is."""
    match node:
        case ast.Constant(value=str(text)):
            return Text(text), Kind.TEXT
        case ast.Tuple(elts=[ast.Constant(value=str()), *_] as words):
            texts = tuple(word.value for word in words if isinstance(word, ast.Constant))
            if len(texts) == len(words) > 1 and all(isinstance(text, str) for text in texts):
                return Texts(cast("tuple[str, ...]", texts)), Kind.TEXT
        case ast.Constant(value=bool()):
            pass
        case ast.Constant(value=int(value) | float(value)) if value <= sys.float_info.max:
            return Number(value), Kind.NUMBER
        case ast.Name(id=name):
            return Name(name, kind), kind
        case ast.Attribute(value=ast.Name(id=owner), attr=name) if owner == PARAMETERS:
            return Parameter(name), Kind.NUMBER
        case ast.UnaryOp(op=ast.USub(), operand=ast.Constant(value=int(value) | float(value))):
            return Number(-value), Kind.NUMBER
        case ast.UnaryOp(op=ast.USub(), operand=operand):
            return Negation(_read(line, operand, Kind.NUMBER)), Kind.NUMBER
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            return Not(_read(line, operand, Kind.TRUTH)), Kind.TRUTH
        case ast.BinOp(left=left, op=op, right=right) if type(op) in _OPERATORS:
            one, other = (_read(line, side, Kind.NUMBER) for side in (left, right))
            return Arithmetic(_OPERATORS[type(op)], one, other), Kind.NUMBER
        case ast.Compare(left=left, ops=ops, comparators=comparators) if all(type(op) in _RELATIONS for op in ops):
            words = any(isinstance(n, ast.Constant) and isinstance(n.value, str) for n in (left, *comparators))
            first, *rest = (_read(line, n, Kind.TEXT if words else Kind.NUMBER) for n in (left, *comparators))
            relations: list[Relation] = [_RELATIONS[type(op)] for op in ops]
            return Comparison(first, tuple(zip(relations, rest, strict=True))), Kind.TRUTH
        case ast.BoolOp(op=op, values=values):
            terms = tuple(_read(line, value, Kind.TRUTH) for value in values)
            return Boolean("and" if isinstance(op, ast.And) else "or", terms), Kind.TRUTH
        case ast.IfExp(test=test, body=then, orelse=otherwise):
            condition = _read(line, test, Kind.TRUTH)
            return Conditional(condition, _read(line, then, kind), _read(line, otherwise, kind)), kind
        case ast.Call(
            func=ast.Name(id="any"),
            args=[ast.GeneratorExp(elt=test, generators=[ast.comprehension(ast.Name(id=actor), actors, [], 0)])],
            keywords=[],
        ):
            return AnyOf(actor, _read(line, actors, Kind.ACTORS), _read(line, test, Kind.TRUTH)), Kind.TRUTH
        case _:
            for function, pattern in _patterns():
                if (given := _matched(function, pattern, node)) is not None:
                    takes = (*function.takes, *function.takes[-1:] * (len(given) - len(function.takes)))
                    arguments = (_read(line, *pair) for pair in zip(given, takes, strict=True))
                    return Call(function.name, tuple(arguments)), function.gives
    line.fail(f"no plan can say {ast.unparse(node)!r}")


@lru_cache(maxsize=1)
def _patterns() -> tuple[tuple[Function, ast.expr], ...]:
    """Every function, and the tree of its form with names `_` for arguments."""
    blanks = {function: ["_"] * len(function.takes) for function in FUNCTIONS.values()}
    return tuple((f, ast.parse(f.form.format(*blanks[f]), mode="eval").body) for f in FUNCTIONS.values())


def _matched(function: Function, pattern: ast.expr, node: ast.expr) -> list[ast.expr] | None:
    """The arguments of a node that has the form of a function; None if it has another."""
    if function.more and isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and not node.keywords:
        enough = node.func.id == function.name and len(node.args) >= len(function.takes)
        return node.args if enough else None
    found: list[ast.expr] = []
    return found if _same(pattern, node, found) else None


def _same(pattern: object, node: object, found: list[ast.expr]) -> bool:
    if isinstance(pattern, ast.Name) and pattern.id == "_" and isinstance(node, ast.expr):
        found.append(node)
        return True
    if type(pattern) is not type(node):
        return False
    if isinstance(pattern, ast.AST):
        return all(_same(value, getattr(node, name), found) for name, value in ast.iter_fields(pattern))
    if isinstance(pattern, list) and isinstance(node, list):
        return len(pattern) == len(node) and all(map(_same, pattern, node, [found] * len(pattern)))
    return pattern == node


def parse_expression(text: str, kind: Kind = Kind.NUMBER) -> Expression:
    """Read an expression of a plan.

    Raises:
        SnippetError: It says something that no plan can.
    """
    try:
        return _expression(_Line(1, 0, (text,)), (text,), kind)
    except RecursionError as error:
        raise SnippetError("brackets within brackets, too many to follow") from error


# To text


def print_plan(plan: Plan) -> str:
    """The Scenic text of a plan."""
    out = [f"param {p.name} = Range({p.low!r}, {p.high!r})" for p in plan.parameters]
    out += [f"{constant.name} = {print_expression(constant.expression)}" for constant in plan.constants]
    out.append(f"behavior {BEHAVIOR}():")
    indent = "    "
    for i, phase in enumerate(plan.phases):
        if i == plan.loop:
            out.append(f"{indent}while True:")
            indent *= 2
        out += [f"{indent}{value.name} = {print_expression(value.expression)}" for value in phase.values]
        out.append(f"{indent}do {print_phase(phase)}")
    return "\n".join(out) + "\n"


def print_phase(phase: Phase) -> str:
    """What follows `do` in the Scenic text of a phase."""
    call = f"{phase.primitive}({', '.join(map(print_expression, phase.arguments))})"
    match phase.end:
        case Until(condition):
            return f"{call} until {print_expression(condition)}"
        case After(seconds):
            return f"{call} for {print_expression(seconds)} seconds"
        case None:
            return call


# How tightly each form holds its parts together
_CHOICE, _OR, _AND, _NOT, _COMPARISON, _SUM, _PRODUCT, _SIGN, _ATOM = range(9)


def print_expression(expression: Expression, least: int = _CHOICE) -> str:
    """The Scenic text of an expression.

    Args:
        expression: What to print.
        least: How tightly it must hold together to stand without brackets.
    """
    text, holds = _printed(expression)
    return text if holds >= least else f"({text})"


def _printed(expression: Expression) -> tuple[str, int]:  # noqa: C901, PLR0911, PLR0912
    show = print_expression
    match expression:
        case Number(value):
            return repr(value), _SIGN if repr(value).startswith("-") else _ATOM
        case Text(value):
            return json.dumps(value, ensure_ascii=False), _ATOM
        case Texts(values):
            return f"({', '.join(json.dumps(value, ensure_ascii=False) for value in values)})", _ATOM
        case Name(name, _):
            return name, _ATOM
        case Parameter(name):
            return f"{PARAMETERS}.{name}", _ATOM
        case Negation(of):
            return f"-{show(of, _SIGN)}", _SIGN
        case Not(of):
            return f"not {show(of, _NOT)}", _NOT
        case Arithmetic(operator, left, right):
            holds = _SUM if operator in "+-" else _PRODUCT
            return f"{show(left, holds)} {operator} {show(right, holds + 1)}", holds
        case Comparison(first, links):
            chain = (f"{relation} {show(right, _SUM)}" for relation, right in links)
            return " ".join((show(first, _SUM), *chain)), _COMPARISON
        case Boolean(operator, terms):
            holds = _AND if operator == "and" else _OR
            return f" {operator} ".join(show(term, holds + 1) for term in terms), holds
        case Conditional(test, then, otherwise):
            return f"{show(then, _OR)} if {show(test, _OR)} else {show(otherwise)}", _CHOICE
        case AnyOf(actor, actors, condition):
            return f"any({show(condition)} for {actor} in {show(actors, _OR)})", _ATOM
        case Call(name, arguments):
            function = FUNCTIONS[name]
            if function.more:
                return f"{name}({', '.join(map(show, arguments))})", _ATOM
            owner = function.form.startswith("{}")  # what is asked of an expression stands behind it
            parts = (show(a, _ATOM if owner and i == 0 else _CHOICE) for i, a in enumerate(arguments))
            return function.form.format(*parts), _ATOM
