"""A user's own programs: a `.scenic` file, or a folder of them, made fit for the search.

Nothing of them is run here. They are read, held against the allow-list, and what the search needs is found in their
text: the world model, the ego, the adversary, the ranges of the parameters, the map. They are to be run by
`chatscene.simulate.confined.simulator.ConfinedSimulator` and by nothing else, unless the user trusts them.
"""

from __future__ import annotations

import ast
import os
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

from chatscene.errors import ForeignCodeRefused, SettingsError
from chatscene.library.load import parameters_in, stated_in
from chatscene.search.generators.one_scene import as_searched
from chatscene.search.generators.parameters import stated, unstated
from chatscene.simulate.confined.allow_list import check_foreign, model_of, parse_foreign, refused
from chatscene.simulate.confined.asked_map import map_of
from chatscene.simulate.confined.plain_text import MAX_CHARACTERS, Refusal, check_text
from chatscene.simulate.confined.rules import OTHERS
from chatscene.simulate.confined.scenic_2 import UNCHANGED, Rewritten, rewrite
from chatscene.simulate.confined.undefined import AHEAD, undefined_in, with_meanings
from chatscene.terms.episode import Role
from chatscene.terms.scene import AS_WRITTEN, OWN_MODEL, ScenicProgram
from chatscene.terms.snippet import ParameterRange
from chatscene.world.models import STANDS_IN
from chatscene.world.searched import searched

ADVERSARY_BEHAVIOR = "AdvBehavior"  # by which a drive tells the adversary from the rest of the traffic
MOST_PROGRAMS = 1_000  # in one folder
MOST_BYTES = 4 * MAX_CHARACTERS

_IMPORTED = re.compile(r"^\s*(?:import|from)\s+([A-Za-z_]\w*)", re.MULTILINE)

_OF_VERIFAI = {"VerifaiDiscreteRange", "VerifaiOptions", "VerifaiRange"}
_DISTRIBUTIONS = _OF_VERIFAI | {"DiscreteRange", "Discrete", "Normal", "Options", "Range", "TruncatedNormal", "Uniform"}
"""Scenic's (https://docs.scenic-lang.org, Distributions)."""
_TEXTS = re.compile(r'''"""(?:.|\n)*?"""|\'{3}(?:.|\n)*?\'{3}''')
"""Texts of several lines, in which no line imports anything."""

_OWN = re.compile(rf"^model +{re.escape(OWN_MODEL)}\b", re.MULTILINE)

_EGO_LINE = "ego = new Car at startOf(egoRoute), facing directionOn(egoRoute, 0), with route egoRoute"


@dataclass(frozen=True, slots=True, kw_only=True)
class ForeignProgram:
    """A program that was not made of our snippets.

    Attributes:
        program: It, with its parameters; it has no snippets, and nothing was said that it could be held against.
        renamed: What its adversary's behavior was called before it was renamed to `ADVERSARY_BEHAVIOR`, or empty.
        map_path: The map that it asks for, absolute; None if it names none.
        rewritten: Its text as it was, as it is run, and what is changed between them.
    """

    path: Path
    program: ScenicProgram
    renamed: str = ""
    map_path: Path | None = None
    rewritten: Rewritten = UNCHANGED

    def changed(self) -> tuple[str, ...]:
        """Lines for a person about what was rewritten, the diff last; none where it runs as it was written."""
        if not (self.rewritten.changes or self.rewritten.meanings):
            return ()
        name = self.path.name
        return (f"{name} is rewritten before it is run:", *self.rewritten.reasons(), self.rewritten.diff(name))

    def varies(self) -> bool:
        """Whether two scenes of it on one route may differ; what does not keep to the allow-list may draw anyhow."""
        program = self.program
        if program.drawn or any(one.high > one.low for one in program.parameters) or check_foreign(program.source):
            return True
        tree: Any = parse_foreign(program.source)
        nodes: Iterator[Any] = (part for node in tree.body for part in _outside_params(node))
        return any(
            (isinstance(one, ast.Name) and one.id in _DISTRIBUTIONS) or getattr(one, "prob", None) is not None
            for one in nodes
        )

    def check_map(self, within: Path) -> None:
        """Hold the map that it asks for to lying in a folder, links followed; one that is not there is never read.

        Raises:
            SettingsError: It lies elsewhere.
        """
        asked = self.map_path
        if asked is None or not os.path.exists(asked):  # noqa: PTH110 - Path.exists() raises for what is too long
            return
        if not asked.is_relative_to(os.path.realpath(within)):
            raise SettingsError(f"{self.path} asks for a map that lies outside the folder; put it below the folder")


def foreign_files(path: Path) -> tuple[Path, ...]:
    """A program's file, or those of a folder and the folders in it, in order of names, without what others import.

    Raises:
        ForeignCodeRefused: The folder holds none, or too many.
    """
    if not path.is_dir():
        return (path,)
    files = [file for file in sorted(path.rglob("*.scenic")) if file.is_file()]
    imported = {name for file in files for name in _IMPORTED.findall(_TEXTS.sub("", _beginning(file)))}
    programs = tuple(file for file in files if file.stem not in imported)
    if not programs:
        raise ForeignCodeRefused(f"the folder {path} holds no .scenic file")
    if len(programs) > MOST_PROGRAMS:
        raise ForeignCodeRefused(f"the folder {path} holds {len(programs)} programs; at most {MOST_PROGRAMS} are read")
    return programs


def _beginning(file: Path) -> str:
    """As much of a file as a program can have; nothing of one that cannot be read, which is said when it is."""
    try:
        with file.open("rb") as opened:
            return opened.read(MOST_BYTES).decode("utf-8", errors="replace")
    except OSError:
        return ""


def read_foreign(
    path: Path,
    *,
    trusted: bool = False,
    as_written: bool | None = False,
    searched_with: bool = True,
    given: Mapping[str, object] | None = None,
) -> ForeignProgram:
    """Read a program; one of Scenic 2 is rewritten, and says so (`ForeignProgram.changed`).

    Args:
        path: Its file.
        trusted: Whether it may use all of Scenic and Python; else it is held against the allow-list.
        as_written: Whether its own ego drives; None for whether it does where nothing is asked: where it is for another
            world model, or has a behavior of its own that was not imported.
        searched_with: Whether it must say who is the adversary, which a search asks for; else there may be none.
        given: Parameters that it reads and does not state, by name.

    Raises:
        SettingsError: A parameter cannot be given so.
        ForeignCodeRefused: It cannot be read, uses what strangers may not use, or lacks an ego, a route or an
            adversary; the message says how to put it right.
    """
    try:
        if not path.is_file():
            raise ForeignCodeRefused(f"there is no file {path}; give a .scenic file or a folder of them")
        with path.open("rb") as file:
            read = file.read(MOST_BYTES + 1)
        if len(read) > MOST_BYTES:
            raise ForeignCodeRefused(f"{path} has more than {MOST_BYTES} bytes, the most that a program has")
        text = read.decode("utf-8-sig")
    except OSError as error:
        raise ForeignCodeRefused(f"{path} cannot be read: {error.strerror}") from error
    except UnicodeDecodeError as error:
        raise ForeignCodeRefused(f"{path} is not UTF-8 text: {error.reason} at byte {error.start}") from error
    rewritten = as_scenic_3(text.replace("\r\n", "\n"), trusted=trusted)
    rewritten, given = _with_meanings(rewritten, given or {}, trusted=trusted)
    scene = as_searched(rewritten.source, trusted=trusted)
    text = stated(scene.source, given)
    program, renamed, asked = _made(path.stem, text, trusted, as_written, own=str(path), searched_with=searched_with)
    asked = scene.map or asked
    # Not Path.resolve(), which raises where links lead round in a circle.
    map_path = None if asked is None else Path(os.path.realpath(path.parent / asked))
    return ForeignProgram(path=path, program=program, renamed=renamed, map_path=map_path, rewritten=rewritten)


def as_scenic_3(text: str, *, trusted: bool = False) -> Rewritten:
    """A program as Scenic 3 reads it.

    One for our own world model, which Scenic 2 never had, is as it was, and so is a text that is refused before it is
    parsed: nothing of a stranger's is gone through that is longer or deeper than any program.
    """
    refused_anyway = not trusted and bool(check_text(text))
    return Rewritten(text, text, ()) if refused_anyway or _OWN.search(text) else rewrite(text)


def _with_meanings(
    rewritten: Rewritten, given: Mapping[str, object], *, trusted: bool
) -> tuple[Rewritten, dict[str, object]]:
    """A program with its undefined names defined, and which of what is given are its parameters."""
    rewritten, given = _with_ego(rewritten, given, trusted=trusted)
    source = rewritten.source
    tree = None if _OWN.search(source) or (not trusted and check_text(source)) else parse_foreign(source)
    if tree is None or isinstance(tree, Refusal):
        return rewritten, dict(given)
    undefined = [one for one in undefined_in(tree) if not trusted or one.name in given]  # the others may be Python's
    names = {one.name for one in undefined}
    meant = {name: _expression(name, value) for name, value in given.items() if name in names}
    text, told = with_meanings(source, undefined, meant)
    lists = frozenset(re.findall(rf"^ *(\w+) = (?:\[|{AHEAD}\()", text, re.MULTILINE)) & names
    left = {name: value for name, value in given.items() if name not in meant}
    return (rewritten.defined(text, lists, told), left) if told else (rewritten, left)


def _with_ego(
    rewritten: Rewritten, given: Mapping[str, object], *, trusted: bool
) -> tuple[Rewritten, Mapping[str, object]]:
    """A program without an ego with the one that is said, and what else is given."""
    source = rewritten.source
    tree = None if "ego" not in given or (not trusted and check_text(source)) else parse_foreign(source)
    if tree is None or isinstance(tree, Refusal) or _has_ego(tree):
        return rewritten, given
    name, placed = str(given["ego"]), _placed(tree)
    if name not in placed:
        raise SettingsError(f"no ego={name} can be: {_could_be(placed)}")
    node, lines = placed[name], source.split("\n")
    first = lines[node.lineno - 1]
    lines[node.lineno - 1] = f"{first[: node.col_offset]}ego{first[node.col_offset + len(name) :]}"
    lines.insert(node.end_lineno, f"{' ' * node.col_offset}{name} = ego")
    told = f"line {node.lineno}: nothing is the ego; it is `{name}`, as you say"
    left = {one: value for one, value in given.items() if one != "ego"}
    return rewritten.defined("\n".join(lines), frozenset(), (told,)), left


def _could_be(placed: Mapping[str, Any]) -> str:
    return f"--param ego=NAME takes one of: {', '.join(placed)}" if placed else "nothing is placed by name"


def _expression(name: str, value: object) -> str:
    """What is given for a name, as Scenic."""
    text = value if isinstance(value, str) else repr(value)
    if "\n" in text or isinstance(parse_foreign(f"{name} = {text}\n"), Refusal):
        raise SettingsError(f"{name} is given {text!r}; nothing defines that name, so give it an expression")
    return text


def foreign_program(name: str, source: str, *, trusted: bool = False, as_written: bool = False) -> ScenicProgram:
    """A user's text as a program.

    Raises:
        ForeignCodeRefused: It uses what strangers may not use, or lacks an ego, a route or an adversary.
    """
    return _made(name, source, trusted, as_written, own=name)[0]


def _made(
    name: str, source: str, trusted: bool, as_written: bool | None, *, own: str, searched_with: bool = True
) -> tuple[ScenicProgram, str, str | None]:
    """The program, what its adversary's behavior was called if it was renamed, and the map that it asks for."""
    called = f"your program {own}"
    if not source.strip():
        raise ForeignCodeRefused(f"{called} is empty")
    _check_stated(called, source)
    if not trusted and (refusals := check_foreign(source)):
        raise ForeignCodeRefused(refused(called, refusals, source, own=True))
    tree = parse_foreign(source)
    if isinstance(tree, Refusal):
        raise ForeignCodeRefused(refused(called, (tree,), source, own=True))
    model = model_of(tree)
    if model not in STANDS_IN:
        raise ForeignCodeRefused(
            f"{called} is written for the world model {model!r}; known: {', '.join(STANDS_IN)}"
            if model
            else f"{called} does not say what it is written for; begin it with `model {OWN_MODEL}`, {OTHERS}"
        )
    behavior = ADVERSARY_BEHAVIOR
    if as_written is None:
        as_written = model != OWN_MODEL or _driver(tree) not in ("", AS_WRITTEN)
    if model != OWN_MODEL:
        _check_ego(called, tree)
    else:
        behavior = _adversary_behavior(called, tree, as_written, searched_with)
        if behavior != ADVERSARY_BEHAVIOR:
            source = re.sub(rf"\b{behavior}\b", ADVERSARY_BEHAVIOR, source)
    if model == OWN_MODEL:
        _check_ranges(called, tree)
    ranges = parameters_in(tree) if model == OWN_MODEL else {one.name: (one.low, one.high) for one in searched(tree)}
    program = ScenicProgram(
        scenario_id=_slug(name),
        source=source,
        parameters=tuple(
            ParameterRange(name=parameter, low=low, high=high, unit="1")
            for parameter, (low, high) in sorted(ranges.items())
        ),
        snippet_ids=(),
        model=model,
        as_written=as_written,
        own=own,
    )
    path = map_of(tree)[0]
    asked = path if path and path.endswith(".xodr") else None
    return program, behavior if behavior != ADVERSARY_BEHAVIOR else "", asked


def _check_stated(called: str, source: str) -> None:
    """Refuse a program for another world model than ours that reads parameters which nothing states."""
    tree = None if check_text(source) else parse_foreign(source)
    if tree is None or isinstance(tree, Refusal) or model_of(tree) in {"", OWN_MODEL}:
        return  # which is refused by what is wrong there
    if lacking := unstated(tree):
        names = ", ".join(lacking)
        give = f"give each, as in --param {lacking[0]}=VALUE"
        raise ForeignCodeRefused(f"{called} reads parameters that it does not state: {names}; {give}")


def _check_ranges(called: str, tree: Any) -> None:
    """Refuse a program for our own world model with a parameter that is drawn, and not as those that are searched."""
    known = parameters_in(tree)
    for name, value in stated_in(tree):
        drawn = any(isinstance(node, ast.Name) and node.id in _DISTRIBUTIONS for node in ast.walk(value))
        if drawn and not (name in known and name.startswith("OPT_")):
            raise ForeignCodeRefused(
                f"{called}: the parameter {name} at line {value.lineno} is drawn, but cannot be searched: write "
                f"`param {name if name.startswith('OPT_') else f'OPT_{name}'} = Range(LOW, HIGH)` with two numbers"
            )


def _check_ego(called: str, tree: Any) -> None:
    """Refuse a program that places no ego at its top level, nor in the first scenario of one that is composed."""
    if not _has_ego(tree):
        placed = _placed(tree)
        which = f", or say which road user it is: {_could_be(placed)}" if placed else ""
        raise ForeignCodeRefused(f"{called} has no ego; add: ego = new Car{which}")


def _has_ego(tree: Any) -> bool:
    """Whether a program places an ego at its top level, or in the first scenario of one that is composed."""
    return any(
        type(node).__name__ == "TrackedAssign" and type(node.target).__name__ == "Ego" for node in _first_placed(tree)
    )


def _placed(tree: Any) -> dict[str, Any]:
    """What is placed where an ego may be, by name."""
    return {
        node.targets[0].id: node
        for node in _first_placed(tree)
        if isinstance(node, ast.Assign) and type(node.value).__name__ == "New"
        if isinstance(node.targets[0], ast.Name) and len(node.targets) == 1
        if cast("Any", node.value).className not in {"Point", "OrientedPoint"}
    }


def _first_placed(tree: Any) -> Iterator[Any]:
    """The statements of the top level, and of the first scenario of a program that is composed."""
    composed = [node for node in tree.body if type(node).__name__ == "ScenarioDef"]
    yield from tree.body
    for node in composed:
        if node.name == "Main" or len(composed) == 1:
            yield from node.setup or ()


def _slug(name: str) -> str:
    return "-".join(re.findall(r"[a-z0-9]+", name.lower()))[:60].strip("-") or "foreign"


def _driver(tree: Any) -> str:
    """The behavior of a program's own ego; empty where it has none."""
    nodes: Iterator[Any] = ast.walk(tree)
    egos = (n for n in nodes if type(n).__name__ == "TrackedAssign" and type(n.target).__name__ == "Ego")
    return next((name for node in egos for name in _behaviors(node.value)), "")


def _adversary_behavior(called: str, tree: Any, as_written: bool, searched_with: bool) -> str:
    """The behavior of the program's own that its adversary has."""
    ego = [n for n in tree.body if type(n).__name__ == "TrackedAssign"]
    if not ego:
        raise ForeignCodeRefused(f"{called} has no ego; add: {_EGO_LINE}")
    does = _driver(tree)
    if as_written and not does:
        raise ForeignCodeRefused(
            f"{called} does not say what its ego does: the ego at line {ego[0].lineno} has no behavior, so "
            "there is nothing to drive as written; leave out --as-written"
        )
    if not as_written and does not in ("", AS_WRITTEN):
        raise ForeignCodeRefused(
            f"{called}: the ego at line {ego[0].lineno} has a behavior of its own, and the ego under test is "
            "to drive it; leave out its `with behavior …`"
        )
    if "route" not in dict(_properties(ego[0].value)):
        raise ForeignCodeRefused(
            f"{called}: the ego at line {ego[0].lineno} has no route, so nobody knows where it is to go; add a "
            f'line `egoRoute = selectRoute(maneuver="straight")` and place it like this: {_EGO_LINE}'
        )
    own = {node.name for node in tree.body if type(node).__name__ == "BehaviorDef"}
    used = {name for node in _things(tree) if node is not ego[0].value for name in _behaviors(node)} - {AS_WRITTEN}
    if ADVERSARY_BEHAVIOR in used & own:
        return ADVERSARY_BEHAVIOR
    if len(used) == 1 and used <= own and ADVERSARY_BEHAVIOR not in own:
        return used.pop()
    if not searched_with or len(list(_things(tree))) == 1 or any(_plays_adversary(node) for node in _things(tree)):
        return ADVERSARY_BEHAVIOR
    found = f"found: {', '.join(sorted(used))}" if used else "nothing besides the ego has a behavior"
    raise ForeignCodeRefused(
        f"{called}: which road user is the adversary? Define `behavior {ADVERSARY_BEHAVIOR}():` and give it to "
        f"one, with `AdvAgent = new Car …, with behavior {ADVERSARY_BEHAVIOR}()`; {found}"
    )


def _outside_params(statement: Any) -> Iterator[Any]:
    return iter(()) if type(statement).__name__ == "Param" else ast.walk(statement)


def _things(tree: Any) -> Iterator[Any]:
    return (node for node in ast.walk(tree) if type(node).__name__ == "New")


def _plays_adversary(new: Any) -> bool:
    """Whether a thing is given that role, as those of whom a situation says it are."""
    role = dict(_properties(new)).get("role")
    return isinstance(role, ast.Constant) and role.value == Role.ADVERSARY


def _properties(new: Any) -> Iterator[tuple[str, Any]]:
    return ((s.prop, s.value) for s in getattr(new, "specifiers", ()) if type(s).__name__ == "WithSpecifier")


def _behaviors(new: Any) -> Iterator[str]:
    """The names of the behaviors that are given to a thing."""
    for name, value in _properties(new):
        if name == "behavior":
            called = value.func if isinstance(value, ast.Call) else value  # Scenic takes `with behavior Park` too
            yield called.id if isinstance(called, ast.Name) else "?"
