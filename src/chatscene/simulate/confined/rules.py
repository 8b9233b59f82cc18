"""What each kind of node of a syntax tree must keep to, beyond being on the list: one function each, one table."""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from chatscene.simulate.confined.plain_text import Refusal
from chatscene.simulate.confined.words import MODULES, NO_MODULE, PARAMETERS, Dialect, outside
from chatscene.terms.pointing import meant, nearest
from chatscene.terms.scene import OWN_MODEL
from chatscene.world.models import STANDS_IN

MAX_NUMBER = 1e6
MAX_EXPONENT = 4
MAX_TURNS = 100  # of a `for` loop
MAX_OBJECTS = 50

FORBIDDEN = "the sandbox does not allow it"
ODD_NAME = "a name is made of at most 64 ASCII letters and digits, a letter first"
LONGEST_TEXT = 120

_NAME = re.compile(r"(?:[A-Za-z][A-Za-z0-9_]{0,63}|_)\Z")
_OPT = re.compile(r"OPT_[A-Z0-9_]{1,60}\Z")
_NO_TEXT = re.compile(r"[^A-Za-z0-9 ,.:!?_-]")  # which a text in a program may not hold
_FORMAT = re.compile(r"\d{0,2}(\.\d{1,2})?[defg%]?\Z")
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
        own: Names that mean the program's own wherever it reads them.
        dialect: What it may use.
        modules: The names by which it calls modules, and which module each is.
        line: Where the reader is.
        lines: Its text.
        column: Where in the line, from 1.
        declared: The names of the parameters of a whole program; None for a part of one.
        meanings: What to say of names that nothing defines, besides that.
        parts: What may be read of its own sub-scenarios and monitors, besides, by their names.
        refusals: What was found.
        objects: How many things it places.
        egos: How often it places the ego.
        parameters: The names of its parameters.
    """

    given: frozenset[str]
    own: frozenset[str]
    dialect: Dialect
    modules: Mapping[str, str] = field(default_factory=dict[str, str])
    lines: Sequence[str] = ()
    declared: frozenset[str] | None = None
    meanings: Mapping[str, str] = field(default_factory=dict[str, str])
    parts: Mapping[str, frozenset[str]] = field(default_factory=dict[str, frozenset[str]])
    line: int = 0
    column: int = 0
    refusals: list[Refusal] = field(default_factory=list[Refusal])
    objects: int = 0
    egos: int = 0
    parameters: set[str] = field(default_factory=set[str])

    def refuse(self, what: str, why: str, *, word: str = "", faulty: bool = False) -> None:
        """Note something that is not allowed, at the line where the reader is.

        Args:
            what: What was found.
            why: Why it is not allowed.
            word: How it is written; the place is where that stands next in the line.
            faulty: Whether it is wrong whoever runs it.
        """
        if len(self.refusals) >= 200:
            return
        column, width = self.column, 1
        if word and 0 < self.line <= len(self.lines):
            text = self.lines[self.line - 1]
            found = next((at for at in (text.find(word, max(0, column - 1)), text.find(word)) if at >= 0), -1)
            column, width = (found + 1, len(word)) if found >= 0 else (column, 1)
        self.refusals.append(Refusal(self.line, what, why, column, width, faulty))

    def known(self, name: str) -> None:
        """Refuse a name that nothing a stranger may use defines."""
        if name in self.given or name in self.dialect.names:
            return
        if name in outside():
            self.refuse(f"the name {shown(name)}", FORBIDDEN, word=name)
            return
        hint = self.meanings.get(name) or meant(name, self.given | self.dialect.names)
        self.refuse(
            f"the name {shown(name)}",
            f"neither the program nor the world model defines it{hint}",
            word=name,
            faulty=True,
        )

    def bind(self, name: str, *, module: bool = False) -> None:
        """Refuse to define a name that is odd, or that means something already.

        Args:
            name: The name.
            module: Whether it is to be that of a module.
        """
        if not _NAME.match(name):
            self.refuse(f"the name {shown(name)}", ODD_NAME, word=name)
        elif name in self.modules and not module:
            self.refuse(f"the name {name}", "it is the name of a module in this program", word=name)
        elif name in self.dialect.kept:
            why = "a program may not put something else in the place of what is given"
            self.refuse(f"the name {name}", why, word=name)
        elif name in outside() and name not in self.dialect.names | self.own:
            # Where the program's own is not in force, the name would lead to what the list leaves out.
            why = "Python or Scenic defines it, too, and the sandbox does not allow theirs; choose another name"
            self.refuse(f"the name {name}", why, word=name)


def shown(text: str) -> str:
    """A stranger's text, safe to print."""
    return ascii(text[:40])[1:-1]


# Names and values


def _name(node: ast.Name, reading: Reading) -> None:
    if isinstance(node.ctx, ast.Store):
        reading.bind(node.id)
    elif node.id == "globalParameters":
        reading.refuse(node.id, "parameters are read one by one, as in globalParameters.OPT_SPEED", word=node.id)
    elif node.id in reading.modules:
        reading.refuse(f"the module {node.id}", "its functions are used one by one, as in math.sqrt(x)", word=node.id)
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
        if why := _not_plain(value):
            reading.refuse(f"the text {shown(value)}", why)
    elif value is None or isinstance(value, int | float):
        if value is not None and not abs(value) <= MAX_NUMBER:
            reading.refuse(f"the constant {shown(repr(value))}", f"numbers lie between ±{MAX_NUMBER:.0f}")
    else:
        called = "..." if value is ... else shown(repr(value))
        reading.refuse(f"the constant {called}", "a constant is a real number, a text, True, False or None")


def _not_plain(text: str) -> str:
    """Why a text may not stand in a program; empty if it may."""
    if len(text) > LONGEST_TEXT:
        return f"it has {len(text)} characters, and a text has at most {LONGEST_TEXT}"
    if odd := _NO_TEXT.search(text):
        return f"a text may not hold {shown(odd[0])!r}; it is made of letters, digits, blanks and , . : ! ? _ -"
    return ""


def _formatted(node: ast.FormattedValue, reading: Reading) -> None:
    spec: Any = node.format_spec
    plain = spec is None or (isinstance(spec, ast.JoinedStr) and all(_is_format(one) for one in spec.values))
    if node.conversion != -1 or not plain:
        reading.refuse("a format", "a value in an f-string is formatted with digits and a letter at most, as {x:.2f}")


def _is_format(part: Any) -> bool:
    return isinstance(part, ast.Constant) and isinstance(part.value, str) and bool(_FORMAT.match(part.value))


def _attribute(node: ast.Attribute, reading: Reading) -> None:
    if not isinstance(node.ctx, ast.Load):
        why = "what belongs to a thing is set with `with`, when it is made"
        reading.refuse(f".{shown(node.attr)} =", why, word=f".{node.attr}")
    elif is_parameter(node):
        _read_parameter(node.attr, reading)
    elif (module := module_of(node, reading.modules)) is not None:
        if node.attr not in MODULES[module]:
            _not_of(module, node.attr, reading)
    elif isinstance(node.value, ast.Name) and node.attr in reading.parts.get(node.value.id, ()):
        pass  # a variable of a part of the program, which it sets itself
    elif node.attr not in (known := reading.dialect.attributes | reading.dialect.methods):
        near = nearest(node.attr, known)
        if near:
            why = f"the list of what may be read of a thing has it not; did you mean .{near}?"
        elif reading.dialect.free:
            why = "the list of what may be read of a thing has it not"
        else:
            why = f"of a thing may be read: {', '.join(sorted(reading.dialect.attributes))}"
        reading.refuse(f".{shown(node.attr)}", why, word=f".{node.attr}", faulty=bool(near))


def _read_parameter(name: str, reading: Reading) -> None:
    if not (_NAME if reading.dialect.free else _OPT).match(name):
        reading.refuse(f"globalParameters.{shown(name)}", "only OPT_ parameters may be read", word=name)
    elif not reading.dialect.free and reading.declared is not None and name not in reading.declared:
        hint = meant(name, reading.declared) or f"; add `param {name} = Range(low, high)`"
        why = f"the program has no such parameter{hint}"
        reading.refuse(f"globalParameters.{name}", why, word=name, faulty=True)


def _not_of(module: str, name: str, reading: Reading) -> None:
    near = nearest(name, MODULES[module])
    why = f"the list of what may be used of {module} has it not{f'; did you mean {near}?' if near else ''}"
    reading.refuse(f"{module}.{shown(name)}", why, word=name, faulty=bool(near))


def module_of(node: Any, modules: Mapping[str, str]) -> str | None:
    """The module of which something is used by its name, as in ``math.sqrt``; None of all else."""
    return modules.get(node.value.id) if isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) else None


def is_parameter(node: Any) -> bool:
    """Whether it reads one parameter, as in ``globalParameters.OPT_SPEED``."""
    return isinstance(node, ast.Attribute) and isinstance(node.value, ast.Name) and node.value.id == "globalParameters"


def _subscript(node: ast.Subscript, reading: Reading) -> None:
    if not isinstance(node.ctx, ast.Load):
        reading.refuse("an assignment to an element", "values are made anew, not changed")


def _call(node: ast.Call, reading: Reading) -> None:
    called = node.func
    if isinstance(called, ast.Attribute) and module_of(called, reading.modules) is None:
        read = called.attr in reading.dialect.attributes or is_parameter(called)
        if read and called.attr not in reading.dialect.methods:
            reading.refuse(f".{shown(called.attr)}()", "it may be read, not called", word=f".{called.attr}")
    elif not isinstance(called, ast.Name | ast.Attribute):
        reading.refuse("a call of something without a name", "only named functions, behaviors and actions are called")
    if any(keyword.arg is None or not _NAME.match(keyword.arg) for keyword in node.keywords):
        reading.refuse("** or an odd name in a call", "a call lists its arguments")
    # Loops of the longer dialect run over any list, and are held by the process's time and memory alone.
    if not reading.dialect.free and _calls(node, "range") and not all(_is_number(end, MAX_TURNS) for end in node.args):
        reading.refuse("range", f"its ends are numbers between ±{MAX_TURNS}")


def _assign(node: ast.Assign, reading: Reading) -> None:
    if any(isinstance(target, ast.List | ast.Starred) for target in node.targets):
        reading.refuse("an assignment", "only names are assigned to")
    if type(node.value).__name__ == "FieldAtOp" and (kind := _without_new(node.value, reading)):
        reading.refuse(f"{kind} without new", scenic_2(kind), word=kind, faulty=True)


def _operation(node: ast.BinOp | ast.AugAssign, reading: Reading) -> None:
    left, right = (node.left, node.right) if isinstance(node, ast.BinOp) else (node.target, node.value)
    if _is_sequence(left) or _is_sequence(right):
        reading.refuse("arithmetic with text or a list", "only numbers and vectors are computed with")
    if isinstance(node.op, ast.Pow) and not _is_number(right, MAX_EXPONENT):
        reading.refuse("**", f"an exponent is a number between ±{MAX_EXPONENT}")


def _compare(node: ast.Compare, reading: Reading) -> None:
    if isinstance(node.ops[0], ast.In) and (kind := _without_new(node.left, reading)):
        reading.refuse(f"{kind} without new", scenic_2(kind), word=kind, faulty=True)


# Imports


def _import(node: ast.Import, reading: Reading) -> None:
    for one in node.names:
        if one.name not in MODULES:
            _no_module("import", one.name, reading)
        elif one.asname is not None:
            reading.bind(one.asname, module=True)


def _import_from(node: ast.ImportFrom, reading: Reading) -> None:
    module = "." * node.level + (node.module or "")
    if module not in MODULES:
        _no_module("from", module, reading)
        return
    for one in node.names:
        bound = one.asname or one.name
        if one.name == "*":
            reading.refuse(f"from {module} import *", f"name what is taken, as in from {module} import sqrt", word="*")
        elif one.name not in MODULES[module]:
            _not_of(module, one.name, reading)
        elif bound != one.name or bound not in reading.dialect.names:  # as `sin`, which Scenic has by that name, too
            reading.bind(bound)


def _no_module(how: str, name: str, reading: Reading) -> None:
    why = NO_MODULE.get(name.partition(".")[0], f"of Python's modules a program may import {', '.join(MODULES)} alone")
    reading.refuse(f"{how} {shown(name)}", why, word=name)


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
        hint = meant(node.name, STANDS_IN, alike=0.9)
        why = f"there is no such model{hint}" if hint else f"a program says `model {OWN_MODEL}` and no other; {OTHERS}"
        reading.refuse(f"model {shown(node.name)}", why, word=node.name, faulty=True)


def _parameter(node: Any, reading: Reading) -> None:
    name, value = node.identifier, node.value
    if name in reading.parameters:
        reading.refuse(f"param {shown(name)}", "it is given twice", word=name)
    reading.parameters.add(name)
    if reading.dialect.free:
        if not _NAME.match(name):
            reading.refuse(f"param {shown(name)}", ODD_NAME)
    elif name in PARAMETERS:
        if not (isinstance(value, ast.Constant) and value.value in PARAMETERS[name]):
            why = f"it is one of {', '.join(sorted(PARAMETERS[name]))}"
            reading.refuse(f"param {name}", why, word=name, faulty=True)
    elif not _OPT.match(name):
        why = "a program's parameters are named OPT_...; map and route are the user's"
        reading.refuse(f"param {shown(name)}", why, word=name)
    elif not _is_range(value):
        reading.refuse(f"param {name}", "it is Range(low, high) with two numbers, the lower first")


def _new(node: Any, reading: Reading) -> None:
    reading.objects += 1
    if reading.objects == MAX_OBJECTS:
        reading.refuse("new", f"a program places at most {MAX_OBJECTS} things")
    reading.known(node.className)


def _with(node: Any, reading: Reading) -> None:
    if node.prop not in reading.dialect.properties:
        known = reading.dialect.properties
        why = f"there is no such property{meant(node.prop, known) or '; known: ' + ', '.join(sorted(known))}"
        reading.refuse(f"with {shown(node.prop)}", why, word=node.prop, faulty=bool(nearest(node.prop, known)))


def _ego(node: Any, reading: Reading) -> None:
    if type(node.target).__name__ != "Ego":  # a workspace, which is refused itself
        return
    reading.egos += 1
    if kind := _without_new(node.value, reading):
        reading.refuse(f"{kind} without new", scenic_2(kind), word=kind, faulty=True)
    elif type(node.value).__name__ != "New" or reading.egos > 1:
        reading.refuse("ego", "it is placed once, with `ego = new ...`", faulty=reading.egos > 1)


def scenic_2(kind: str) -> str:
    """Why a thing cannot be placed as Scenic 2 has it."""
    return f"this is Scenic 2; Scenic 3 needs `new`: write `new {kind}`"


def _without_new(node: Any, reading: Reading) -> str:
    """The class of what is placed as Scenic 2 has it, as in ``ego = Car`` or ``Car at (1, 2)``; empty for all else."""
    if type(node).__name__ == "FieldAtOp":
        node = node.left
    name = node.id if isinstance(node, ast.Name) else ""
    return name if name[:1].isupper() and name in reading.dialect.names and name not in reading.given else ""


def _expression(node: ast.Expr, reading: Reading) -> None:
    if kind := _without_new(node.value, reading):
        reading.refuse(f"{kind} without new", scenic_2(kind), word=kind, faulty=True)


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
    if isinstance(node.name, str) and (why := _not_plain(node.name)):
        reading.refuse(f"the name {shown(node.name)}", why)


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
    "FormattedValue": _formatted,
    "Attribute": _attribute,
    "Subscript": _subscript,
    "Call": _call,
    "Import": _import,
    "ImportFrom": _import_from,
    "Assign": _assign,
    "Expr": _expression,
    "BinOp": _operation,
    "AugAssign": _operation,
    "Compare": _compare,
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
        ("alias", "name"),
        ("alias", "asname"),
        ("ImportFrom", "module"),
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
