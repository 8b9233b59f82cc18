"""A stranger's programs: a `.scenic` file of a user's own, or a folder of them, made fit for the search.

Nothing of them is run here. They are read, held against the allow-list, and what the search needs is found in their
text: the ego and its route, the adversary and its behavior, the ranges of the parameters. They are to be run by
`chatscene.simulate.confined.simulator.ConfinedSimulator` and by nothing else.
"""

from __future__ import annotations

import ast
import hashlib
import re
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from chatscene.errors import ForeignCodeRefused
from chatscene.library.load import names_of
from chatscene.simulate.confined.allow_list import check_foreign, refused
from chatscene.simulate.confined.plain_text import MAX_CHARACTERS
from chatscene.terms.scene import ScenicProgram
from chatscene.terms.snippet import ParameterRange

ADVERSARY_BEHAVIOR = "AdvBehavior"  # by which a drive tells the adversary from the rest of the traffic
MOST_PROGRAMS = 1_000  # in one folder

_EGO_LINE = "ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute"


@dataclass(frozen=True, slots=True, kw_only=True)
class ForeignProgram:
    """A program that was not made of our snippets.

    Attributes:
        path: Where it was read.
        program: It, with its parameters; it has no snippets, and nothing was said that it could be held against.
        renamed: What its adversary's behavior was called before it was renamed to `ADVERSARY_BEHAVIOR`, or empty.
    """

    path: Path
    program: ScenicProgram
    renamed: str = ""


def read_foreign(path: Path) -> tuple[ForeignProgram, ...]:
    """Read a program, or every ``.scenic`` file of a folder in order of names.

    Raises:
        ForeignCodeRefused: A file cannot be read, uses what strangers may not use, or lacks an ego, a route or an
            adversary; the message says how to put it right.
    """
    if not path.is_dir():
        return (_read(path),)
    files = sorted(path.glob("*.scenic"))
    if not files:
        raise ForeignCodeRefused(f"the folder {path} holds no .scenic file")
    if len(files) > MOST_PROGRAMS:
        raise ForeignCodeRefused(f"the folder {path} holds {len(files)} programs; at most {MOST_PROGRAMS} are read")
    return tuple(_read(file) for file in files)


def foreign_program(name: str, source: str) -> ScenicProgram:
    """A stranger's text as a program.

    Args:
        name: How to call it; becomes the scenario's id.
        source: Scenic text.

    Raises:
        ForeignCodeRefused: It uses what strangers may not use, or lacks an ego, a route or an adversary.
    """
    return _made(name, source)[0]


def _read(path: Path) -> ForeignProgram:
    try:
        if not path.is_file():
            raise ForeignCodeRefused(f"there is no file {path}; give a .scenic file or a folder of them")
        with path.open("rb") as file:
            text = file.read(4 * MAX_CHARACTERS + 1).decode("utf-8-sig")
    except OSError as error:
        raise ForeignCodeRefused(f"{path} cannot be read: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise ForeignCodeRefused(f"{path} is no text in UTF-8: {error.reason} at byte {error.start}") from error
    program, renamed = _made(path.stem, text.replace("\r\n", "\n"))
    return ForeignProgram(path=path, program=program, renamed=renamed)


def _made(name: str, source: str) -> tuple[ScenicProgram, str]:
    if refusals := check_foreign(source):
        raise ForeignCodeRefused(refused(name, refusals))
    behavior = _adversary_behavior(name, source)
    if behavior != ADVERSARY_BEHAVIOR:
        source = re.sub(rf"\b{behavior}\b", ADVERSARY_BEHAVIOR, source)
    ranges = names_of(source, ()).parameters
    program = ScenicProgram(
        scenario_id=_slug(name),
        source=source,
        parameters=tuple(
            ParameterRange(name=parameter, low=low, high=high, unit="1")
            for parameter, (low, high) in sorted(ranges.items())
        ),
        snippet_ids=(),
        digest=hashlib.blake2b(source.encode(), digest_size=8).hexdigest(),
    )
    return program, behavior if behavior != ADVERSARY_BEHAVIOR else ""


def _slug(name: str) -> str:
    return "-".join(re.findall(r"[a-z0-9]+", name.lower()))[:60].strip("-") or "foreign"


def _adversary_behavior(name: str, source: str) -> str:
    """The behavior of the program's own that its adversary has.

    Raises:
        ForeignCodeRefused: It has no ego with a route, or not exactly one kind of adversary.
    """
    from scenic.syntax.parser import parse_string

    tree = parse_string(source, "exec")
    ego = [n for n in tree.body if type(n).__name__ == "TrackedAssign"]
    if not ego:
        raise ForeignCodeRefused(f"program {name!r} has no ego; add: {_EGO_LINE}")
    if "behavior" in dict(_properties(ego[0].value)):
        raise ForeignCodeRefused(
            f"program {name!r}: the ego at line {ego[0].lineno} has a behavior of its own, and the ego under test is "
            "to drive it; leave its `with behavior …` away"
        )
    if "route" not in dict(_properties(ego[0].value)):
        raise ForeignCodeRefused(
            f"program {name!r}: the ego at line {ego[0].lineno} has no route, so nobody knows where it is to go; add a "
            f'line `egoRoute = selectRoute(maneuver="straight")` and place it like this: {_EGO_LINE}'
        )
    own = {node.name for node in tree.body if type(node).__name__ == "BehaviorDef"}
    used = {behavior for node in _things(tree) if node is not ego[0].value for behavior in _behaviors(node)}
    if ADVERSARY_BEHAVIOR in used & own:
        return ADVERSARY_BEHAVIOR
    if len(used) == 1 and used <= own and ADVERSARY_BEHAVIOR not in own:
        return used.pop()
    found = f"found: {', '.join(sorted(used))}" if used else "nothing besides the ego has a behavior"
    raise ForeignCodeRefused(
        f"program {name!r}: which road user is the adversary? Define `behavior {ADVERSARY_BEHAVIOR}():` and give it to "
        f"one, with `AdvAgent = new Car …, with behavior {ADVERSARY_BEHAVIOR}()`; {found}"
    )


def _things(tree: Any) -> Iterator[Any]:
    return (node for node in ast.walk(tree) if type(node).__name__ == "New")


def _properties(new: Any) -> Iterator[tuple[str, Any]]:
    return ((s.prop, s.value) for s in new.specifiers if type(s).__name__ == "WithSpecifier")


def _behaviors(new: Any) -> Iterator[str]:
    """The names of the behaviors that are given to a thing."""
    for name, value in _properties(new):
        if name == "behavior":
            called = value.func if isinstance(value, ast.Call) else value  # Scenic takes `with behavior Park` too
            yield called.id if isinstance(called, ast.Name) else "?"
