"""What of a user's own program has no effect on its drives, and what was assumed: told before any number of a run."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import Any

from chatscene.simulate.confined.allow_list import model_of, parse_foreign
from chatscene.simulate.confined.plain_text import Refusal
from chatscene.simulate.confined.undefined import ASSUMED
from chatscene.terms.scene import AS_WRITTEN, OWN_MODEL, ScenicProgram

_LONGEST = 60  # characters of code in a line
_READ = frozenset(("map", "simulator", "signals", "time_step", "timestep"))  # by our world models, whichever is named
_OURS = frozenset(("drivesUntil", "egoStart", "light", "route", "surface", "weather"))  # by our own alone
_SURROUNDINGS = frozenset(("light", "surface", "weather"))  # read wherever there is a light
# What Scenic 3.1.1's simulators read of how they are reached, shown and recorded.
_TO_A_SIMULATOR = frozenset(
    (
        "address",
        "carla_map",
        "debugRender",
        "map_options",
        "port",
        "real_time",
        "record",
        "render",
        "screen_record",
        "screen_record_filename",
        "screen_record_path",
        "snapToGroundDefault",
        "sumo_map",
        "timeout",
        "use2DMap",
    )
)


def left_out(program: ScenicProgram) -> tuple[str, ...]:
    """Lines for a person; none where all that a program says is in its drives."""
    tree = parse_foreign(program.source)
    if isinstance(tree, Refusal):
        return ()
    own = model_of(tree) == OWN_MODEL
    own_lines = (
        *_assumed(program.source),
        *_parameters(program.source, tree, own=own),
        *_records(program.source, tree),
        *_printed(tree),
    )
    return (*_driver(program, tree), *own_lines)


def _assumed(source: str) -> Iterator[str]:
    """Names that nothing defined, and what they were taken to be."""
    for line in source.split("\n"):
        code, found, words = line.partition(ASSUMED)
        if found:
            yield f"assumed: {code.strip().partition(' ')[0]}, which nothing defines, is {words}"


def _driver(program: ScenicProgram, tree: Any) -> Iterator[str]:
    """The behavior of the program's own ego, in whose place the ego under test drives."""
    if program.as_written:
        return
    for node in _nodes(tree):
        if type(node).__name__ == "TrackedAssign" and type(node.target).__name__ == "Ego":
            for part in getattr(node.value, "specifiers", ()):
                if type(part).__name__ == "WithSpecifier" and part.prop == "behavior":
                    does = _code(program.source, part.value)
                    if does == f"{AS_WRITTEN}()":
                        yield "the ego under test drives; --as-written has the ego do what the file says"
                        continue
                    yield (
                        f"the ego under test replaces the program's ego, so its behavior {does} is not used; "
                        "--as-written keeps it"
                    )


def _parameters(source: str, tree: Any, *, own: bool) -> Iterator[str]:
    """Parameters of the whole scenario that neither the program nor its world model reads."""
    told = [one for node in _nodes(tree) if type(node).__name__ == "Param" for one in node.elts]
    names = {one.identifier for one in told}
    read = _READ | _TO_A_SIMULATOR | {n.attr for n in _nodes(tree) if isinstance(n, ast.Attribute)}
    if own:
        read |= _OURS
    elif "light" in names:
        read |= _SURROUNDINGS
    for one in told:
        if one.identifier not in read:
            yield f"param {one.identifier} = {_code(source, one.value)} has no effect here: nothing reads it"


def _records(source: str, tree: Any) -> Iterator[str]:
    for node in _nodes(tree):
        if type(node).__name__.startswith("Record"):
            yield f"`record {_code(source, node.value)}` is not kept; the tracks of all road users are"


def _printed(tree: Any) -> Iterator[str]:
    lines = [n.lineno for n in _nodes(tree) if isinstance(n, ast.Call) and getattr(n.func, "id", "") == "print"]
    if lines:
        yield f"what is printed in line {', '.join(map(str, lines[:3]))} is not shown; --trust shows it"


def _nodes(tree: Any) -> Iterator[Any]:
    return ast.walk(tree)  # Scenic's nodes have attributes that Python's have not


def _code(source: str, node: Any) -> str:
    """A piece of a program in one line."""
    text = " ".join((ast.get_source_segment(source, node) or "").split())
    return text if len(text) <= _LONGEST else f"{text[:_LONGEST]}…"
