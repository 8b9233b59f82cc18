"""What each kind of node of a syntax tree must keep to, beyond being on the list: one function each, one table."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from chatscene.simulate.confined.plain_text import Refusal
from chatscene.simulate.confined.words import PARAMETERS, Dialect
from chatscene.terms.scene import OWN_MODEL
from chatscene.world.models import STANDS_IN

MAX_NUMBER = 1e6
MAX_EXPONENT = 4
MAX_TURNS = 100  # of a `for` loop
MAX_OBJECTS = 50

_NAME = re.compile(r"(?:[A-Za-z][A-Za-z0-9_]{0,63}|_)\Z")
_OPT = re.compile(r"OPT_[A-Z0-9_]{1,60}\Z")
_TEXT = re.compile(r"[A-Za-z0-9 ,.:!?_-]{0,120}\Z")
OTHERS = "or the model of Scenic's driving domain, of CARLA, of MetaDrive or of the Newtonian simulator"

_YIELDING = frozenset(
    ("Take", "Wait", "WaitFor", "WaitUntil", "Do", "DoFor", "DoUntil", "Abort", "Terminate", "TerminateSimulation")
)
_OVER_TIME = frozenset(("Always", "Eventually", "Next", "UntilOp"))


@dataclass(slots=True)
class Reading:
    """What was seen of a program so far.

    Attributes:
        given: Names that it or its partners define.
        dialect: What it may use.
        line: Where the reader is.
        refusals: What was found.
        objects: How many things it places.
        egos: How often it places the ego.
        parameters: The names of its parameters.
    """

    given: frozenset[str]
    dialect: Dialect
    line: int = 0
    refusals: list[Refusal] = field(default_factory=list[Refusal])
    objects: int = 0
    egos: int = 0
    parameters: set[str] = field(default_factory=set[str])

    def refuse(self, what: str, why: str) -> None:
        """Note something that is not allowed, at the line where the reader is."""
        if len(self.refusals) < 200:
            self.refusals.append(Refusal(self.line, what, why))

    def known(self, name: str) -> None:
        """Refuse a name that nothing a stranger may use defines."""
        if name not in self.given and name not in self.dialect.names:
            self.refuse(
                f"the name {shown(name)}",
                "neither the program nor the part of the world model that strangers may use defines it",
            )

    def bind(self, name: str) -> None:
        """Refuse to define a name that is odd, or that means something already."""
        if not _NAME.match(name):
            self.refuse(f"the name {shown(name)}", "a name is made of ASCII letters and digits, a letter first")
        elif name in self.dialect.kept:
            self.refuse(f"the name {name}", "a program may not put something else in the place of what is given")


def shown(text: str) -> str:
    """A stranger's text, safe to print."""
    return ascii(text[:40])[1:-1]


# Names and values


def _name(node: ast.Name, reading: Reading) -> None:
    if isinstance(node.ctx, ast.Store):
        reading.bind(node.id)
    elif node.id == "globalParameters":
        reading.refuse(node.id, "parameters are read one by one, as in globalParameters.OPT_SPEED")
    else:
        reading.known(node.id)


def _argument(node: ast.arg, reading: Reading) -> None:
    reading.bind(node.arg)
    if node.annotation is not None:
        reading.refuse("an annotation", "a parameter has a name and a default, no more")


def _arguments(node: ast.arguments, reading: Reading) -> None:
    if node.vararg or node.kwarg:
        reading.refuse("* or ** in a parameter list", "a behavior lists its parameters")


def _constant(node: ast.Constant, reading: Reading) -> None:
    value: Any = node.value
    if isinstance(value, str):
        if not _TEXT.match(value):
            reading.refuse(f"the text {shown(value)}", "a text is at most 120 plain characters")
    elif not (value is None or (isinstance(value, int | float) and abs(value) <= MAX_NUMBER)):
        reading.refuse(f"the constant {shown(repr(value))}", f"numbers lie between ±{MAX_NUMBER:g}")


def _attribute(node: ast.Attribute, reading: Reading) -> None:
    if not isinstance(node.ctx, ast.Load):
        reading.refuse(f".{shown(node.attr)} =", "what belongs to a thing is set with `with`, when it is made")
    elif is_parameter(node):
        if not (_NAME if reading.dialect.free else _OPT).match(node.attr):
            reading.refuse(f"globalParameters.{shown(node.attr)}", "only OPT_ parameters may be read")
    elif node.attr not in reading.dialect.attributes | reading.dialect.methods:
        known = "" if reading.dialect.free else f": {', '.join(sorted(reading.dialect.attributes))}"
        reading.refuse(f".{shown(node.attr)}", f"of a thing may be read what is on the list{known}")


def is_map(node: Any) -> bool:
    """Whether it says where a map lies, as in ``param map = localPath('Town01.xodr')``: a run has its own."""
    if type(node).__name__ != "parameter" or node.identifier != "map":
        return False
    value = node.value
    path = value.args[0] if _calls(value, "localPath") and len(value.args) == 1 and not value.keywords else value
    return isinstance(path, ast.Constant) and isinstance(path.value, str)


def is_parameter(node: Any) -> bool:
    """Whether it reads one parameter, as in ``globalParameters.OPT_SPEED``."""
    return isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "globalParameters"


def _subscript(node: ast.Subscript, reading: Reading) -> None:
    if not isinstance(node.ctx, ast.Load):
        reading.refuse("an assignment to an element", "values are made anew, not changed")


def _call(node: ast.Call, reading: Reading) -> None:
    called = node.func
    if not (
        isinstance(called, ast.Name) or (isinstance(called, ast.Attribute) and called.attr in reading.dialect.methods)
    ):
        reading.refuse("a call of something without a name", "only named functions, behaviors and actions are called")
    if any(keyword.arg is None or not _NAME.match(keyword.arg) for keyword in node.keywords):
        reading.refuse("** or an odd name in a call", "a call lists its arguments")
    if _calls(node, "range") and not all(_is_number(end, MAX_TURNS) for end in node.args):
        reading.refuse("range", f"its ends are numbers between ±{MAX_TURNS}")


def _assign(node: ast.Assign, reading: Reading) -> None:
    if any(isinstance(target, ast.List | ast.Starred) for target in node.targets):
        reading.refuse("an assignment", "only names are assigned to")


def _operation(node: ast.BinOp | ast.AugAssign, reading: Reading) -> None:
    left, right = (node.left, node.right) if isinstance(node, ast.BinOp) else (node.target, node.value)
    if _is_sequence(left) or _is_sequence(right):
        reading.refuse("arithmetic with text or a list", "only numbers and vectors are computed with")
    if isinstance(node.op, ast.Pow) and not _is_number(right, MAX_EXPONENT):
        reading.refuse("**", f"an exponent is a number between ±{MAX_EXPONENT}")


# Loops and interrupts


def _for(node: ast.For, reading: Reading) -> None:
    if not (reading.dialect.free or _calls(node.iter, "range") or isinstance(node.iter, ast.Tuple | ast.List)):
        reading.refuse("for", f"a loop runs over range(number), at most {MAX_TURNS}, or over a list written out")


def _while(node: ast.While, reading: Reading) -> None:
    if not any(type(part).__name__ in _YIELDING for part in ast.walk(node)):
        reading.refuse("while", "a loop that never takes an action or waits never lets time pass")


def _interrupts(node: Any, reading: Reading) -> None:
    if node.except_handlers or node.orelse or node.finalbody:
        reading.refuse("except, else or finally", "`try` in a stranger's program only has `interrupt when`")


# Scenic's own


def _behavior(node: Any, reading: Reading) -> None:
    reading.bind(node.name)
    if any(type(part).__name__ in _OVER_TIME for part in ast.walk(node)):
        reading.refuse("a requirement over time in a behavior", "always, eventually, next and until stand at the top")


def _model(node: Any, reading: Reading) -> None:
    if node.name not in STANDS_IN:
        reading.refuse(f"model {shown(node.name)}", f"a program says `model {OWN_MODEL}` and no other; {OTHERS}")


def _parameter(node: Any, reading: Reading) -> None:
    name, value = node.identifier, node.value
    if name in reading.parameters:
        reading.refuse(f"param {shown(name)}", "it is given twice")
    reading.parameters.add(name)
    if reading.dialect.free:
        if not _NAME.match(name):
            reading.refuse(f"param {shown(name)}", "a name is made of ASCII letters and digits, a letter first")
    elif name in PARAMETERS:
        if not (isinstance(value, ast.Constant) and value.value in PARAMETERS[name]):
            reading.refuse(f"param {name}", f"it is one of {', '.join(sorted(PARAMETERS[name]))}")
    elif not _OPT.match(name):
        reading.refuse(f"param {shown(name)}", "a program's parameters are named OPT_...; map and route are the user's")
    elif not _is_range(value):
        reading.refuse(f"param {name}", "it is Range(low, high) with two numbers, the lower first")


def _new(node: Any, reading: Reading) -> None:
    reading.objects += 1
    if reading.objects == MAX_OBJECTS:
        reading.refuse("new", f"a program places at most {MAX_OBJECTS} things")
    reading.known(node.className)


def _with(node: Any, reading: Reading) -> None:
    if node.prop not in reading.dialect.properties:
        known = ", ".join(sorted(reading.dialect.properties))
        reading.refuse(f"with {shown(node.prop)}", f"known properties: {known}")


def _ego(node: Any, reading: Reading) -> None:
    reading.egos += 1
    if type(node.value).__name__ != "New" or reading.egos > 1:
        reading.refuse("ego", "it is placed once, with `ego = new ...`")


def _defined(node: Any, reading: Reading) -> None:
    reading.bind(node.name)


def _function(node: ast.FunctionDef, reading: Reading) -> None:
    reading.bind(node.name)
    if node.decorator_list or node.returns:
        reading.refuse("a decorator or an annotation", "a function has parameters and a body, no more")


def _record(node: Any, reading: Reading) -> None:
    _named(node, reading)
    if node.recorder is not None:
        reading.refuse("record to", "nothing is written while a drive goes on")


def _named(node: Any, reading: Reading) -> None:
    if isinstance(node.name, str) and not _TEXT.match(node.name):
        reading.refuse(f"the name {shown(node.name)}", "a requirement's name is plain text")


# Shapes of values that are written out


def _calls(node: Any, name: str) -> bool:
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == name


def _is_sequence(node: Any) -> bool:
    return isinstance(node, ast.List | ast.Tuple) or (isinstance(node, ast.Constant) and isinstance(node.value, str))


def _number(node: Any) -> float | None:
    """The number that is written there, with its sign."""
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        inner = _number(node.operand)
        return None if inner is None else -inner
    if isinstance(node, ast.Constant) and isinstance(node.value, int | float) and not isinstance(node.value, bool):
        return node.value
    return None


def _is_number(node: Any, most: float) -> bool:
    value = _number(node)
    return value is not None and abs(value) <= most


def _is_range(node: Any) -> bool:
    if not _calls(node, "Range") or node.keywords or len(node.args) != 2:
        return False
    low, high = map(_number, node.args)
    return low is not None and high is not None and low <= high


RULES: dict[str, Callable[[Any, Reading], None]] = {
    "Name": _name,
    "arg": _argument,
    "arguments": _arguments,
    "Constant": _constant,
    "Attribute": _attribute,
    "Subscript": _subscript,
    "Call": _call,
    "Assign": _assign,
    "BinOp": _operation,
    "AugAssign": _operation,
    "For": _for,
    "While": _while,
    "TryInterrupt": _interrupts,
    "BehaviorDef": _behavior,
    "MonitorDef": _behavior,
    "ScenarioDef": _defined,
    "FunctionDef": _function,
    "Record": _record,
    "RecordInitial": _named,
    "RecordFinal": _named,
    "RequireMonitor": _named,
    "Model": _model,
    "parameter": _parameter,
    "New": _new,
    "WithSpecifier": _with,
    "TrackedAssign": _ego,
    "Require": _named,
    "TerminateWhen": _named,
    "TerminateSimulationWhen": _named,
}
"""By kind of node."""

TEXTS = frozenset(
    {
        ("Name", "id"),
        ("arg", "arg"),
        ("BehaviorDef", "name"),
        ("BehaviorDef", "docstring"),
        ("MonitorDef", "name"),
        ("MonitorDef", "docstring"),
        ("ScenarioDef", "name"),
        ("ScenarioDef", "docstring"),
        ("FunctionDef", "name"),
        ("Record", "name"),
        ("RecordInitial", "name"),
        ("RecordFinal", "name"),
        ("RequireMonitor", "name"),
        ("Constant", "value"),
        ("Attribute", "attr"),
        ("keyword", "arg"),
        ("Model", "name"),
        ("parameter", "identifier"),
        ("New", "className"),
        ("WithSpecifier", "prop"),
        ("Require", "name"),
        ("TerminateWhen", "name"),
        ("TerminateSimulationWhen", "name"),
    }
)
"""Fields of nodes that hold text and are looked at above, or that nothing reads: a behavior's docstring."""
