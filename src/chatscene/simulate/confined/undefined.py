"""Names that a program reads and nothing defines, and what each must mean if only one thing there can be meant.

A behavior is often put beside a place that it was not written for, and then reads `advTrajectory` or `LeadingAgent`,
which only its first home defined. What is wanted follows from where the name is read: a road user, whose speed is
asked, or a way, which somebody follows. Where the program has exactly one such thing, that is assumed, in a line of its
own and with its reason; else the name is refused, and what it could be is listed.
"""

from __future__ import annotations

import ast
import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from enum import Enum, auto
from functools import lru_cache
from importlib.resources import files
from typing import Any

from chatscene.simulate.confined.words import MODULES, dialect_of, outside

ASSUMED = "#: assumed, as nothing defines it: "
"""How the end of a line begins that says what was assumed there."""

AHEAD = "lanesAhead"
_LANES_AHEAD = f"""
def {AHEAD}(user):
    lane = network.laneAt(user)
    if lane is None:
        lane = min(network.lanes, key=lambda one: distance from user to one)
    turns = [m for m in lane.maneuvers if m.type is ManeuverType.STRAIGHT] + list(lane.maneuvers)
    return [lane, turns[0].connectingLane, turns[0].endLane] if len(turns) > 0 else [lane]
"""
_BEHAVIORS = (
    ("scenic.domains.driving", "behaviors.scenic"),
    ("chatscene.world", "carla_behaviors.scenic"),
)
_HEAD = re.compile(r"^behavior (\w+)\((.*)\):", re.MULTILINE)
_DEFINING = frozenset(("BehaviorDef", "MonitorDef", "ScenarioDef", "FunctionDef"))
_WITHIN = frozenset(("BehaviorDef", "MonitorDef", "FunctionDef"))  # which begin with a line of what is assumed
_WORD = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")


class _Wanted(Enum):
    """What is wanted where a name is read."""

    USER = auto()  # who has a speed
    WAY = auto()  # lanes one after the other
    PLACE = auto()  # either
    UNKNOWN = auto()


_PARAMETERS = {"trajectory": _Wanted.WAY, "reference_actor": _Wanted.USER}
"""Of Scenic's own behaviors, by the names of their parameters."""


@dataclass(frozen=True, slots=True, order=True)
class Before:
    """A statement before which another can be written.

    Attributes:
        line: From 1.
        column: From 0.
        deep: Whether it is one of a behavior, a monitor or a function.
    """

    line: int
    column: int
    deep: bool


@dataclass(frozen=True, slots=True)
class Undefined:
    """A name that a program reads and nothing defines.

    Attributes:
        line: Where it is read first, from 1.
        means: What it must mean, as Scenic and in words; None where that is not sure.
        candidates: What it could mean, where that is not sure.
        within: Before which statements it can be defined: the first of each definition that reads it, or one at the top
            level.
    """

    name: str
    line: int
    means: tuple[str, str] | None
    why: str
    candidates: tuple[str, ...]
    within: tuple[Before, ...]

    def hint(self) -> str:
        """The end of a sentence that refuses it: what it could be, and how to say so."""
        could = f"; it could be {' or '.join(self.candidates)}" if self.candidates else ""
        return f"{could}; --param {self.name}=EXPRESSION says what it is"


def defined_in(tree: Any) -> frozenset[str]:
    """Names that a program defines anywhere: what it assigns, its behaviors and their parameters."""
    names: set[str] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Store):
            names.add(node.id)
        elif isinstance(node, ast.arg):
            names.add(node.arg)
        elif type(node).__name__ in _DEFINING:
            names.add(node.name)  # type: ignore[attr-defined]
        elif isinstance(node, ast.Import | ast.ImportFrom):  # held against the list itself, which is enough
            names.update(one.asname or one.name.partition(".")[0] for one in node.names)
    return frozenset(names)


def undefined_in(tree: Any) -> tuple[Undefined, ...]:
    """The names that a program for a driving model reads and nothing defines, in order of lines; none that it calls."""
    known = defined_in(tree) | dialect_of("").names | outside() | set(MODULES) | {"globalParameters"}
    read = {node.id for node in ast.walk(tree) if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load)}
    called = {node.func.id for node in ast.walk(tree) if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)}
    missing = frozenset(read - known - called)
    if not missing:
        return ()
    cast = _Cast(tree)
    sites: dict[str, list[_Site]] = defaultdict(list)
    for statement in tree.body:
        for site in _sites(statement, missing, statement, cast.parameters):
            sites[site.name].append(site)
    found = (_meant(name, sites[name], cast) for name in sorted(sites))
    return tuple(sorted(found, key=lambda one: (one.line, one.name)))


def with_meanings(source: str, undefined: Iterable[Undefined], given: Mapping[str, str]) -> tuple[str, tuple[str, ...]]:
    """A program in which undefined names are defined where they are read.

    Returns:
        The text, and lines about each name that was given a meaning.
    """
    lines, told, ahead = source.split("\n"), list[str](), False
    at: dict[Before, list[str]] = defaultdict(list)
    for one in undefined:
        if one.name in given:
            value, end = given[one.name], ""
            told.append(f"line {one.line}: nothing defines `{one.name}`; it is `{value}`, as you say")
        elif one.means is not None and all(place.deep for place in one.within):
            value, words = one.means
            end = f"  {ASSUMED}{words}"
            told.append(
                f"line {one.line}: nothing defines `{one.name}`; assumed to be {words}, since {one.why}; "
                f"--param {one.name}=EXPRESSION says otherwise"
            )
        else:
            continue
        ahead = ahead or f"{AHEAD}(" in value
        for place in one.within:
            at[place].append(f"{one.name} = {value}{end}")
    for place, made in sorted(at.items(), reverse=True):
        lines[place.line - 1 : place.line - 1] = [" " * place.column + text for text in made]
    text = "\n".join(lines)
    return (f"{text.rstrip()}\n{_LANES_AHEAD}" if ahead else text), tuple(told)


# Where names are read


@dataclass(frozen=True, slots=True)
class _Site:
    name: str
    line: int
    inside: Any  # the outermost behavior, monitor or function, or else the statement at the top level
    wanted: _Wanted


def _sites(node: Any, names: frozenset[str], inside: Any, parameters: _Parameters) -> Iterator[_Site]:
    """Where some names are read in a part of a program, and what is wanted there."""
    for child, wanted in _children(node, parameters):
        if isinstance(child, ast.Name) and isinstance(child.ctx, ast.Load) and child.id in names:
            yield _Site(child.id, child.lineno, inside, wanted)
        here = inside if type(inside).__name__ in _WITHIN or type(child).__name__ not in _WITHIN else child
        yield from _sites(child, names, here, parameters)


def _children(node: Any, parameters: _Parameters) -> Iterator[tuple[Any, _Wanted]]:
    """The parts of a node, and what is wanted of each."""
    wanted: dict[int, _Wanted] = {}
    if type(node).__name__ == "DistanceFromOp":
        wanted = {id(node.target): _Wanted.PLACE, id(node.base): _Wanted.PLACE}
    elif isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
        named = parameters.of(node.func.id)
        for (_, kind), value in zip(named, node.args, strict=False):
            wanted[id(value)] = kind
        wanted |= {id(one.value): dict(named).get(one.arg or "", _Wanted.UNKNOWN) for one in node.keywords}
    elif isinstance(node, ast.Attribute) and node.attr in _of_users():
        wanted[id(node.value)] = _Wanted.USER
    for child in ast.iter_child_nodes(node):
        # A keyword stands between a call and its value.
        held = child.value if isinstance(child, ast.keyword) else child
        yield held, wanted.get(id(held), _Wanted.UNKNOWN)


@lru_cache(maxsize=1)
def _of_users() -> frozenset[str]:
    """What can be read of a road user and of no part of a road."""
    from scenic.core.object_types import Object
    from scenic.domains.driving.roads import Lane, LaneSection

    of_roads = {name for kind in (Lane, LaneSection) for name in (*dir(kind), *vars(kind)["__annotations__"])}
    of_roads |= {one.name for kind in (Lane, LaneSection) for one in vars(kind)["__attrs_attrs__"]}
    return frozenset(Object._defaults) - of_roads  # pyright: ignore[reportPrivateUsage] - told nowhere else


class _Parameters:
    """The parameters of behaviors, Scenic's own and a program's, and what is wanted of each."""

    def __init__(self, tree: Any) -> None:
        self._own: dict[str, Any] = {node.name: node for node in _behaviors(tree)}
        self._known: dict[str, tuple[tuple[str, _Wanted], ...]] = {}

    def of(self, behavior: str) -> tuple[tuple[str, _Wanted], ...]:
        """By the name of the behavior, in order; none for what is no behavior."""
        if behavior not in self._known:
            self._known[behavior] = ()  # while it is looked for, as it may do itself
            self._known[behavior] = tuple(self._found(behavior))
        return self._known[behavior]

    def _found(self, behavior: str) -> Iterator[tuple[str, _Wanted]]:
        own = self._own.get(behavior)
        if own is None:
            for name in _of_library().get(behavior, ()):
                yield name, _PARAMETERS.get(name, _Wanted.UNKNOWN)
            return
        for one in own.args.args:
            found = {site.wanted for site in _sites(own, frozenset((one.arg,)), own, self)}
            yield one.arg, _one_of(found)


@lru_cache(maxsize=1)
def _of_library() -> dict[str, tuple[str, ...]]:
    """The parameters of Scenic's behaviors, by name."""
    texts = (files(package).joinpath(name).read_text("utf-8") for package, name in _BEHAVIORS)
    heads = (head for text in texts for head in _HEAD.findall(text))
    return {name: tuple(part.partition("=")[0].strip() for part in given.split(",")) for name, given in heads}


def _one_of(wanted: Iterable[_Wanted]) -> _Wanted:
    """What is wanted where several things are: the most definite of them."""
    found = frozenset(wanted)
    if {_Wanted.USER, _Wanted.WAY} <= found:
        return _Wanted.UNKNOWN
    return next((one for one in (_Wanted.WAY, _Wanted.USER, _Wanted.PLACE) if one in found), _Wanted.UNKNOWN)


# What they can mean


class _Cast:
    """Who is placed in a program, who has which behavior, and the ways that it names.

    Attributes:
        users: The names of those who are placed, in order.
        named: The names that it gives at its top level.
    """

    def __init__(self, tree: Any) -> None:
        self.parameters = _Parameters(tree)
        placed = [(name, new) for node in ast.walk(tree) for name, new in _placed(node)]
        self.users = tuple(dict.fromkeys(name for name, _ in placed if name))
        self.ways = tuple(dict.fromkeys(name for node in tree.body for name in _way(node)))
        given = (target for node in tree.body if isinstance(node, ast.Assign) for target in node.targets)
        self.named = tuple(dict.fromkeys(one.id for one in given if isinstance(one, ast.Name)))
        self._has: dict[str, set[str]] = defaultdict(set)
        for name, new in placed:
            for behavior in _behaviors_of(new):
                self._has[behavior].add(name)
        self._does = {node.name: set(_called(node)) for node in _behaviors(tree)}

    def owners(self, behavior: str) -> frozenset[str]:
        """Who has a behavior, or one that does it; an empty name for somebody who is placed without one."""
        found, seen, left = set[str](), set[str](), [behavior]
        while left:
            one = left.pop()
            if one not in seen:
                seen.add(one)
                found |= self._has[one]
                left += [other for other, does in self._does.items() if one in does]
        return frozenset(found)


def _behaviors(tree: Any) -> Iterator[Any]:
    return (node for node in ast.walk(tree) if type(node).__name__ == "BehaviorDef")


def _called(node: Any) -> Iterator[str]:
    """The names of what a part of a program calls."""
    calls = (one.func for one in ast.walk(node) if isinstance(one, ast.Call))
    return (one.id for one in calls if isinstance(one, ast.Name))


def _placed(node: Any) -> Iterator[tuple[str, Any]]:
    """What a statement places, by name."""
    new: Any = getattr(node, "value", None)
    if type(new).__name__ != "New" or new.className in {"Point", "OrientedPoint"}:
        return
    if type(node).__name__ == "TrackedAssign":
        yield "ego", new
    elif isinstance(node, ast.Assign):
        yield from ((one.id, new) for one in node.targets if isinstance(one, ast.Name))
    else:
        yield "", new


def _behaviors_of(new: Any) -> Iterator[str]:
    for one in getattr(new, "specifiers", ()):
        if type(one).__name__ == "WithSpecifier" and one.prop == "behavior":
            called = one.value.func if isinstance(one.value, ast.Call) else one.value
            if isinstance(called, ast.Name):
                yield called.id


def _way(node: Any) -> Iterator[str]:
    """The names that a statement gives to a list of lanes."""
    listed = node.value.elts if isinstance(node, ast.Assign) and isinstance(node.value, ast.List) else ()
    if any(isinstance(one, ast.Attribute) and one.attr == "connectingLane" for one in listed):
        yield from (one.id for one in node.targets if isinstance(one, ast.Name))


def _words(name: str) -> list[str]:
    return [word.lower() for word in _WORD.findall(name)]


def _meant(name: str, sites: list[_Site], cast: _Cast) -> Undefined:
    """What a name must mean, by all places where it is read."""
    line = min(site.line for site in sites)
    wanted = _one_of(site.wanted for site in sites)
    definitions = {id(site.inside): site.inside for site in sites}.values()
    within = tuple(sorted({_before(node) for node in definitions}))
    owners = frozenset(one for node in definitions for one in cast.owners(getattr(node, "name", "")))
    ways = {word for way in cast.ways for word in _words(way)[-1:]} | {
        key for key, kind in _PARAMETERS.items() if kind is _Wanted.WAY
    }
    if wanted is _Wanted.PLACE:
        wanted = _Wanted.WAY if _words(name)[-1:] and _words(name)[-1] in ways else _Wanted.USER
    if wanted is _Wanted.USER:
        found = list(_users(owners, cast))
        why = "a road user is wanted there, and only one is placed besides the ego and the behavior's owner"
    elif wanted is _Wanted.WAY:
        found = list(_whose_way(name, sites, owners, cast))
        why = "a list of lanes is wanted there, and its name or the road user that follows it points to this one"
    else:
        found, why = list[tuple[str, str]](), ""
    alike = [one for one in cast.named if _words(one) == _words(name)]
    if len(alike) == 1:
        found, why = [(alike[0], alike[0])], "only capitals and underscores differ"
    if len(found) == 1:
        return Undefined(name, line, found[0], why, (), within)
    return Undefined(name, line, None, "", tuple(value for value, _ in found), within)


def _before(node: Any) -> Before:
    """Where what a definition or a statement reads can be defined."""
    deep = type(node).__name__ in _WITHIN and node.body[0].lineno > node.lineno
    first = node.body[0] if deep else node
    return Before(first.lineno, first.col_offset, deep)


def _users(owners: frozenset[str], cast: _Cast) -> Iterator[tuple[str, str]]:
    """Who could be meant: the ego is called `ego` and who has the behavior `self`, so none of them."""
    if "" not in owners:
        yield from ((one, one) for one in cast.users if one != "ego" and one not in owners)


def _whose_way(name: str, sites: list[_Site], owners: frozenset[str], cast: _Cast) -> Iterator[tuple[str, str]]:
    """The ways that could be meant: of whom the name begins with, or of who is to follow it."""
    begins = _words(name)[:1]
    named = [one for one in cast.users if _words(one)[:1] == begins]
    follows = any(site.wanted is _Wanted.WAY for site in sites) and len(owners) == 1
    whose = list(owners) if follows and (not named or owners <= {*named}) else named or list(cast.users)
    for one in whose:
        own = [way for way in cast.ways if _words(way)[:1] == _words(one)[:1]]
        if own:
            yield from ((way, f"{way}, the way of {one or 'its road user'}") for way in own)
        else:
            who = "self" if owners == frozenset((one,)) else one
            yield f"{AHEAD}({who})", f"the lane of {one or 'who has the behavior'} and straight on"
