"""The first wall: a stranger's program is read, not run, and refused for anything that is not on a list.

Text is bounded before it is parsed (`plain_text`); then the syntax tree is walked, and each node must be of a kind on
the list (`words`) and keep to the rules of its kind (`rules`). What passes still runs behind the second wall
(`confinement`): a list of words cannot know how long a loop takes.
"""

from __future__ import annotations

import ast
import re
from collections import Counter
from collections.abc import Collection, Iterable, Iterator
from functools import lru_cache
from typing import Any, cast

from chatscene.parsing import parse_string
from chatscene.simulate.confined.asked_map import map_of
from chatscene.simulate.confined.plain_text import REPORTED, TRUST, Refusal, check_text
from chatscene.simulate.confined.rules import (
    FORBIDDEN,
    OTHERS,
    RULES,
    TEXTS,
    Reading,
    is_parameter,
    module_of,
)
from chatscene.simulate.confined.syntax import not_scenic
from chatscene.simulate.confined.undefined import defined_in, undefined_in
from chatscene.simulate.confined.words import INSTEAD, KINDS, MODULES, dialect_of
from chatscene.terms.pointing import pointed
from chatscene.terms.scene import OWN_MODEL
from chatscene.world.models import STANDS_IN

MAX_NODES = 8_000
MAX_DEPTH = 60  # of the syntax tree
SHOWN = 3  # refusals in a message

_ONLY_AT_TOP = frozenset(
    ("Model", "Param", "BehaviorDef", "MonitorDef", "ScenarioDef", "FunctionDef", "Import", "ImportFrom")
)
_DEFINING = frozenset(("BehaviorDef", "MonitorDef", "ScenarioDef", "FunctionDef"))


def check_foreign(source: str, *, given: Collection[str] = (), whole: bool = True) -> tuple[Refusal, ...]:
    """What a stranger's Scenic may not do; nothing of it is run.

    Args:
        source: Scenic text.
        given: Names that partners define, if it is a part of a program.
        whole: Whether it is a whole program, which says what model it is written for, or a part, which does not.

    Returns:
        The refusals, in order of lines, at most `REPORTED`; empty if it may be run in a confined process.
    """
    if refusals := check_text(source):
        return refusals
    tree = parse_foreign(source)
    if isinstance(tree, Refusal):
        return (tree,)
    model = model_of(tree) if whole else OWN_MODEL
    dialect = dialect_of(STANDS_IN.get(model, OWN_MODEL))
    reading = Reading(
        given=frozenset(given) | defined_in(tree),
        own=_own(tree),
        dialect=dialect,
        modules=_modules(tree),
        lines=source.split("\n"),
        declared=_declared(tree) if whole else None,
        meanings=_meanings(tree) if whole and dialect.free else {},
        parts=_parts(tree) if whole and dialect.free else {},
    )
    _check_model(tree, reading, whole=whole)
    skipped = map_of(tree)[1] | (_never_read(tree) if whole and dialect.free else frozenset())
    for parts, (node, depth) in enumerate(_walk(tree, reading, skipped), 1):
        placed: Any = next((one for one in ast.walk(node) if hasattr(one, "lineno")), None)
        if placed is not None:
            reading.line, reading.column = placed.lineno, placed.col_offset + 1
        if parts > MAX_NODES or depth > MAX_DEPTH:
            reading.refuse("the size", f"a program has at most {MAX_NODES} parts, {MAX_DEPTH} deep in one another")
            break
        _check_node(node, depth, reading)
    return tuple(sorted(set(reading.refusals), key=lambda one: (one.line, one.column, one))[:REPORTED])


def _meanings(tree: Any) -> dict[str, str]:
    """What to say of names that nothing defines and that could be one of several things."""
    return {one.name: one.hint() for one in undefined_in(tree) if one.candidates}


def _never_read(tree: Any) -> frozenset[Any]:
    """Texts that are given a name which nothing reads, as a description is: nothing of the program sees them."""
    read = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)}
    return frozenset(
        node.value
        for node in tree.body
        if isinstance(node, ast.Assign)
        and isinstance(node.value, ast.Constant)
        and isinstance(node.value.value, str)
        and all(isinstance(one, ast.Name) and one.id not in read for one in node.targets)
    )


def refused(called: str, refusals: tuple[Refusal, ...], source: str, *, own: bool) -> str:
    """The message for a program that may not be run: each fault, with its line and a caret under the place.

    Args:
        called: What messages call the program.
        refusals: What is wrong with it.
        source: Its text.
        own: Whether it is a user's own, who may trust it.
    """
    said = [f"{refusal}\n{pointed(source, refusal.place)}".rstrip() for refusal in refusals[:SHOWN]]
    if len(refusals) > SHOWN:
        said.append(f"and {len(refusals) - SHOWN} more")
    if own and not any(refusal.faulty for refusal in refusals):
        said.append(TRUST)
    return f"{called}: " + "\n".join(said)


@lru_cache(maxsize=64)  # of one program every simulator of a run asks anew
def parse_foreign(source: str) -> Any | Refusal:
    """Scenic's syntax tree of a text, which is not to be changed, or why it has none."""
    try:
        return parse_string(source)
    except Exception as error:  # noqa: BLE001 - a parser that loses its way in a faulty text may raise anything
        return not_scenic(source, error)


def _modules(tree: Any) -> dict[str, str]:
    """The names by which a program calls modules that it may import, and which module each is."""
    return {
        one.asname or one.name: one.name
        for node in ast.walk(tree)
        if isinstance(node, ast.Import)
        for one in node.names
        if one.name in MODULES
    }


def _parts(tree: Any) -> dict[str, frozenset[str]]:
    """The variables of a program's sub-scenarios and monitors, by the names that surely mean one of these.

    Such a name is given a value once in the whole program, at its top level, by a call of what is defined once. What
    Scenic itself has in a scenario or a monitor is left out.
    """
    bound = Counter[str]()
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
            bound[node.id] += 1
        elif isinstance(node, ast.arg):
            bound[node.arg] += 1
        elif type(node).__name__ in _DEFINING:
            bound[cast("Any", node).name] += 1
        elif isinstance(node, ast.Import | ast.ImportFrom):
            bound.update(one.asname or one.name for one in node.names)
    made = {node.name: node for node in tree.body if type(node).__name__ in {"ScenarioDef", "MonitorDef"}}
    found: dict[str, frozenset[str]] = {}
    for node in tree.body:
        match node:
            case ast.Assign(targets=[ast.Name(id=name)], value=ast.Call(func=ast.Name(id=kind))) if kind in made:
                if bound[name] == bound[kind] == 1:
                    found[name] = frozenset(_variables(made[kind]))
            case _:
                pass
    return found


def _variables(part: Any) -> Iterator[str]:
    """The names that a sub-scenario sets when it is set up, or a monitor when it watches."""
    body = part.setup if type(part).__name__ == "ScenarioDef" else part.body
    nodes = (node for statement in body or () for node in ast.walk(statement))
    names = (node.id for node in nodes if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store))
    return (name for name in names if not name.startswith("_") and name not in _scenics())


@lru_cache(maxsize=1)
def _scenics() -> frozenset[str]:
    """What Scenic has in its scenarios and monitors."""
    from scenic.core.dynamics.behaviors import Monitor
    from scenic.core.dynamics.scenarios import DynamicScenario

    return frozenset((*dir(DynamicScenario), *dir(Monitor)))


def _own(tree: Any) -> frozenset[str]:
    """Names that mean the program's own wherever it reads them.

    They are defined at the top level, in a statement that is surely run, before all that reads them; or read only where
    a parameter has that name.
    """
    own: set[str] = set()
    read: set[str] = set()
    for node in tree.body:
        if type(node).__name__ in _DEFINING:
            read.update(_read([node.args]))
            own.update({node.name} - read)
            read.update(_read([node]))
        else:
            read.update(_read([node]))
            if isinstance(node, ast.Assign):
                own.update({target.id for target in node.targets if isinstance(target, ast.Name)} - read)
    parameters = {node.arg for node in ast.walk(tree) if isinstance(node, ast.arg)}
    return frozenset(own | (parameters - read))


def _read(nodes: Iterable[Any]) -> Iterator[str]:
    """Names that are read in parts of a program, but for those that are parameters where they are read."""
    left = [(node, frozenset[str]()) for node in nodes]
    while left:
        node, bound = left.pop()
        placed = getattr(node, "className", None)
        if isinstance(node, ast.AugAssign) and isinstance(node.target, ast.Name):
            names = {node.target.id}
        elif isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
            names = {node.id}
        else:
            names = {placed} if isinstance(placed, str) else set[str]()
        yield from names - bound
        head = getattr(node, "args", None)  # defaults are read outside
        if isinstance(head, ast.arguments):
            inner = bound | {one.arg for one in ast.walk(head) if isinstance(one, ast.arg)}
            left += [(child, bound if child is head else inner) for child in ast.iter_child_nodes(node)]
        else:
            left += [(child, bound) for child in ast.iter_child_nodes(node)]


def _declared(tree: Any) -> frozenset[str]:
    """The names of a program's parameters."""
    return frozenset(one.identifier for node in tree.body if type(node).__name__ == "Param" for one in node.elts)


def model_of(tree: Any) -> str:
    """The world model that a program is written for, as it says; empty if it does not, or more than once."""
    models = [node.name for node in tree.body if type(node).__name__ == "Model"]
    return models[0] if len(models) == 1 else ""


def _check_model(tree: Any, reading: Reading, *, whole: bool) -> None:
    models = [node for node in tree.body if type(node).__name__ == "Model"]
    begins = [node for node in tree.body if not _is_docstring(node)][:1]
    if whole and (len(models) != 1 or not (reading.dialect.free or begins == models)):
        why = f"a program begins with one line `model {OWN_MODEL}`, {OTHERS}"
        reading.refuse("the beginning", why, faulty=True)
    if not whole and models:
        reading.refuse("model", "a part of a program has no model statement of its own")
    if not whole and any(isinstance(node, ast.Import | ast.ImportFrom) for node in tree.body):
        reading.refuse("import", "a part of a program imports nothing; the world model has sin, cos and hypot")


def _check_node(node: Any, depth: int, reading: Reading) -> None:
    kind = type(node).__name__
    words = KINDS.get(kind, re.sub(r"(?<=[a-z])(?=[A-Z])", " ", kind).lower())
    if type(node) not in reading.dialect.syntax:
        reading.refuse(words, INSTEAD.get(kind, FORBIDDEN), word=words.removeprefix("the operator "))
        return
    if (kind in _ONLY_AT_TOP and depth != 1) or (kind == "TrackedAssign" and depth != 1 and not reading.dialect.free):
        reading.refuse(words, "it stands at the top level of a program")
    if kind in RULES:
        RULES[kind](node, reading)
    for name, value in ast.iter_fields(node):
        if isinstance(value, str) and (kind, name) not in TEXTS:
            reading.refuse(words, "it holds text that nobody has looked at")


def _walk(tree: Any, reading: Reading, skipped: frozenset[Any]) -> Iterator[tuple[Any, int]]:
    """Every node and how deep it lies; without what is skipped, and below what does nothing, is read or is refused.

    Does not recurse, since a program may be deeper than Python's stack.
    """
    left = [(tree, 0)]
    while left:
        node, depth = left.pop()
        if node in skipped:
            continue
        yield node, depth
        if _is_docstring(node) or is_parameter(node) or type(node) not in reading.dialect.syntax:
            continue
        if module_of(node, reading.modules) is not None:
            continue
        left += [(child, depth + 1) for child in reversed(list(ast.iter_child_nodes(node)))]


def _is_docstring(node: Any) -> bool:
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant) and isinstance(node.value.value, str)
