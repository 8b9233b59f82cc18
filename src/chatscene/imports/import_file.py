"""A scenario of another tool's format, as a program that runs here like any of a user."""

from __future__ import annotations

import os
import re
import shlex
import textwrap
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, replace
from pathlib import Path

from chatscene.errors import ForeignCodeRefused, MapError, ScenarioError, SettingsError
from chatscene.files.atomic import write_whole
from chatscene.imports.names import labels
from chatscene.imports.open_ground import is_open_ground
from chatscene.imports.openscenario import Carried, Imported, ScenarioFile
from chatscene.imports.stranger_xml import read_xml
from chatscene.imports.variants import Variants, variants_of
from chatscene.imports.written_story import StoryProgram, as_written, played, told_line, written_story
from chatscene.maps.carla_towns import is_town
from chatscene.maps.left_hand import keeps_left
from chatscene.maps.network import name_of
from chatscene.search.generators.foreign import foreign_program
from chatscene.terms.actors import LIMITS
from chatscene.terms.mirroring import IN_THE_MIRROR
from chatscene.terms.plan_text import BEHAVIOR, print_expression, print_plan
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import AS_WRITTEN
from chatscene.terms.storyboard import EGO_ROUTE, Actor, Storyboard

MOST_PROGRAMS = 100  # written at once
CARRIED = "the program that its head carries is taken; its events tell the same to others"
LEFT_OUT = "the program that its head carries is left out: an ego is named, or it, the events or the map were changed"
_TOLD = 3  # parameters named in a note


@dataclass(frozen=True, slots=True, kw_only=True)
class ImportedScenario:
    """What an import wrote.

    Attributes:
        program: The Scenic program; of several variants the first.
        notes: What was taken otherwise than it is written, or left to others, each with its line.
        programs: All programs, one for each variant that was asked for.
        variants: The number of the variant of each of them; none where the file is one scenario.
        refused: Why variants that were asked for became no program, one message each.
        not_as_written: Of each program, what keeps its own ego from driving as its file says.
        notes_as_written: As `notes`, where its own ego drives so.
    """

    program: Path
    map_path: Path
    notes: tuple[str, ...]
    programs: tuple[Path, ...]
    maps: tuple[Path, ...]
    variants: tuple[int, ...] = ()
    count: int = 0
    refused: tuple[str, ...] = ()
    not_as_written: tuple[tuple[str, ...], ...] = ()
    notes_as_written: tuple[str, ...] = ()

    @property
    def command(self) -> str:
        """How it is run."""
        return shlex.join(("chatscene", "run", "--program", str(self.program), "--map", name_of(self.map_path)))

    def __str__(self) -> str:
        """A line per note, and how it is run."""
        more = f" and {len(self.programs) - 1} more" if len(self.programs) > 1 else ""
        return "\n".join((*self.notes, f"{self.program}{more}: run it with {self.command}"))


def import_scenario(
    path: Path,
    *,
    out: Path | None = None,
    map_name: str | None = None,
    ego: str | None = None,
    variant: int | None = None,
    at_most: int | None = None,
    given: Mapping[str, object] | None = None,
    within: Path | None = None,
    partly: bool = False,
) -> ImportedScenario:
    """Write a scenario as a Scenic program; nothing of it is run.

    A file of parameter values for a scenario gives a program for each of its variants, with a number behind its name.

    Args:
        path: An ``.xosc`` file, OpenSCENARIO XML: a scenario, or parameter values for one.
        out: The ``.scenic`` file, a new one; None for one beside it with its name.
        map_name: A packaged map or an ``.xodr`` file; None for the one that the file names by a path from its folder.
        ego: What the file calls the ego; None where that is told by the file.
        variant: The number of one variant, from 1; None for all of them.
        at_most: So many variants at most, spread over all of them; None for all, up to a hundred.
        given: Values of parameters in place of those in the file, by name: numbers, truth values or texts.
        within: The folder in which catalogs, scenario and map lie, if they may lie nowhere else.
        partly: Whether variants that cannot be said are left out, and told (`ImportedScenario.refused`); else one of
            them refuses all.

    Raises:
        ScenarioError: It cannot be read, or says what cannot be said here, as does each of its variants; the message
            names each element and its line.
        MapError: The map is not there, or is broken.
        SettingsError: A program is there already, cannot be written, or there is no such variant; nothing is written
            then.
    """
    out = out or path.with_suffix(".scenic")
    if out.suffix != ".scenic":
        raise SettingsError(f"a program's name ends in .scenic, and {str(out)!r} does not")
    root, told = read_xml(path), _told(given or {})
    found = variants_of(root, path, within)
    if found is None:
        if variant is not None:
            raise SettingsError(f"{path} is one scenario and has no variants; leave out --variant")
        _free(out)
        scenario = ScenarioFile(path, map_name, ego=ego, within=within, root=root)
        scenario.check_declared(told)
        return _written({out: _program(_read(scenario, told), path, out)})
    if variant is None and at_most is None and found.count > MOST_PROGRAMS:
        found = found.searched()
    if twice := sorted(set(told) & found.names):
        raise SettingsError(f"{path} sets the values of {twice[0]!r} itself; choose them with --variant")
    chosen = _chosen(found, variant, at_most, path)
    where = {n: out if len(chosen) == 1 else out.with_name(f"{out.stem}-{n}.scenic") for n in chosen}
    for one in where.values():
        _free(one)
    scenario = ScenarioFile(found.scenario, map_name, ego=ego, within=within)
    scenario.check_declared(told)
    made, refused = _programs(
        chosen, where, lambda values: _read(scenario, {**told, **values}, found.spans), path, partly
    )
    every = f"{found.count} variants of {found.scenario.name}"
    if len(chosen) == 1:
        ((number, values),) = chosen.items()
        every = f"variant {number} of {found.count} of {found.scenario.name}" + (f": {_said(values)}" if values else "")
    return replace(
        _written(made, every, *found.notes),
        variants=tuple(number for number in chosen if number not in refused),
        count=found.count,
        refused=tuple(refused.values()),
    )


@dataclass(frozen=True, slots=True)
class _Program:
    """A program that is to be written: its text, its map, what was noted of it, and why it is not driven as written.

    One that a file carries is written as it is carried.
    """

    text: str
    map_path: Path
    notes: tuple[str, ...]
    not_as_written: tuple[str, ...]
    notes_as_written: tuple[str, ...] = ()
    carried: bool = False


def _told(given: Mapping[str, object]) -> dict[str, str]:
    """Values of parameters as a file of OpenSCENARIO writes them."""
    told: dict[str, str] = {}
    for name, value in given.items():
        if not isinstance(value, str | int | float):
            raise SettingsError(f"the parameter {name} is given {value!r}; of OpenSCENARIO it is a number or a text")
        told[name] = str(value).lower() if isinstance(value, bool) else str(value)
    return told


def _chosen(found: Variants, variant: int | None, at_most: int | None, path: Path) -> dict[int, Mapping[str, str]]:
    if variant is None:
        if at_most is not None:
            many = min(at_most, found.count)
            return {number: found.number(number) for number in (1 + k * found.count // many for k in range(many))}
        if found.count > MOST_PROGRAMS:
            raise SettingsError(f"{path} has {found.count} variants, too many programs; choose one with --variant N")
        return {number: found.number(number) for number in range(1, found.count + 1)}
    if not 1 <= variant <= found.count:
        raise SettingsError(f"{path} has variants 1 to {found.count}, and no {variant}")
    return {variant: found.number(variant)}


def _programs(
    chosen: Mapping[int, Mapping[str, str]],
    where: Mapping[int, Path],
    said: Callable[[Mapping[str, str]], Imported | Carried],
    path: Path,
    partly: bool,
) -> tuple[dict[Path, _Program], dict[int, str]]:
    """The programs of variants, and why others are none."""
    made, refused = dict[Path, _Program](), dict[int, str]()
    first: ScenarioError | MapError | None = None
    for number, values in chosen.items():
        try:
            made[where[number]] = _program(said(values), path, where[number])
        except (ScenarioError, MapError) as error:
            refused[number] = f"variant {number} of {path}, {_said(values)}: {error}"
            first = first or error
            if not partly or len(refused) == len(chosen):
                kind = ScenarioError if isinstance(first, ScenarioError) else MapError
                raise kind(next(iter(refused.values()))) from first
    return made, refused


def _said(values: Mapping[str, str]) -> str:
    told = [f"{name} = {value}" for name, value in values.items()]
    return ", ".join(told[:_TOLD]) + (f" and {len(told) - _TOLD} more" if len(told) > _TOLD else "")


def _free(out: Path) -> None:
    """Make sure that nothing is overwritten."""
    if out.exists():
        raise SettingsError(f"{out} is there already; delete it, or give another name with --out")


def _read(
    scenario: ScenarioFile, told: Mapping[str, str], spans: Mapping[str, tuple[float, float]] | None = None
) -> Imported | Carried:
    """What a scenario says: the program that it carries, else what its events tell."""
    if (carried := scenario.carried(told, spans)) is not None:
        return replace(carried, notes=(CARRIED, *carried.notes))
    said = scenario.said(told, spans)
    return replace(said, notes=(LEFT_OUT, *said.notes)) if scenario.carries_program else said


def _program(read: Imported | Carried, path: Path, out: Path) -> _Program:
    """The program of what was read."""
    if isinstance(read, Carried):
        text = f"# {path.name} carries this program, and says that its events tell the same to others.\n{read.source}"
        try:
            foreign_program(out.stem, text)
        except ForeignCodeRefused as error:
            why = str(error).partition("\n")[0]
            raise ScenarioError(
                f"{path} carries a program that cannot be run: {why}; leave out its properties"
            ) from error
        why_not = ("it carries a program, which has no events of an ego",)
        return _Program(text, read.map_path, read.notes, why_not, carried=True)
    board = read.board
    if isinstance(board, StoryProgram):
        text = written_story(board, path.name)
    else:
        text = written(board, path.name, read.as_written)
    if keeps_left(read.map_path):
        text = f"# {IN_THE_MIRROR}\n{text}"
    try:
        foreign_program(out.stem, text)
    except ForeignCodeRefused as error:
        why = str(error).partition("\n")[0]  # what follows is for whoever wrote the program
        if read.as_written is not None and not isinstance(board, StoryProgram):
            alone = f"with what its ego does, {why}"
            note = f"{alone}; so it cannot be driven with --as-written"
            left = replace(read, as_written=None, notes=(*read.notes, note), not_as_written=(alone,))
            return _program(left, path, out)
        raise ScenarioError(f"{path} is more than a program of a user's may be: {why}; cut it down") from error
    return _Program(text, read.map_path, read.notes, read.not_as_written, read.notes_as_written)


def _written(made: Mapping[Path, _Program], *notes: str) -> ImportedScenario:
    """Write programs: all of them, or none."""
    done: list[Path] = []
    grounds: dict[Path, Path] = {}  # one file for all programs that lie on the same
    for out, one in made.items():
        if is_open_ground(one.map_path) and one.map_path not in grounds:
            grounds[one.map_path] = out.with_suffix(".xodr")
            _free(grounds[one.map_path])
    maps = tuple(grounds.get(one.map_path, one.map_path) for one in made.values())
    contents = {
        out: (one.text if one.carried else _on(one.text, at, out)).encode()
        for (out, one), at in zip(made.items(), maps, strict=True)
    }
    contents |= {ground: lies.read_bytes() for lies, ground in grounds.items()}
    for out, content in contents.items():
        try:
            write_whole(out, content)
        except OSError as error:
            for written_before in done:
                written_before.unlink(missing_ok=True)
            raise SettingsError(f"cannot write {out}: {error.strerror}") from error
        done.append(out)
    others = [f"{out.name} lies on another map, {at}" for out, at in zip(made, maps, strict=True) if at != maps[0]]
    every = (*notes, *others, *(note for one in made.values() for note in one.notes))
    as_written = (*notes, *others, *(note for one in made.values() for note in one.notes_as_written))
    return ImportedScenario(
        program=done[0],
        map_path=maps[0],
        notes=tuple(dict.fromkeys(every)),
        programs=tuple(made),
        maps=maps,
        not_as_written=tuple(one.not_as_written for one in made.values()),
        notes_as_written=tuple(dict.fromkeys(as_written)),
    )


def _on(text: str, at: Path, out: Path) -> str:
    """A program that names its map: a town of CARLA's by its name, a file by the path from the program's folder.

    It is as it was where its map is a packaged one, which a run takes by its name.
    """
    name = name_of(at)
    if name != str(at) and not is_town(name):
        return text
    path = f"{name}.xodr" if is_town(name) else Path(os.path.relpath(at.resolve(), out.resolve().parent)).as_posix()
    return _MODEL.sub(lambda model: f"param map = localPath({path!r})\n{model[0]}", text, count=1)


# A storyboard as a Scenic program for our own world model, which `chatscene run --program` runs as any of a
# user


_COLUMNS = 100
_MODEL = re.compile(r"^model .*$", re.MULTILINE)


def written(board: Storyboard, name: str, whole: StoryProgram | None = None) -> str:
    """The program of a storyboard.

    Raises:
        ScenarioError: Nobody in it but the ego does anything.
    """
    acting = [actor for actor in board.actors if actor.plan is not None]
    if not acting:
        raise ScenarioError(f"{name}: nobody but the ego does anything, and a program needs somebody who does")
    behaviors = {actor.name: BEHAVIOR if i == 0 else f"{BEHAVIOR}{i + 1}" for i, actor in enumerate(acting)}
    around = ", ".join(f"{key} = '{value}'" for key, value in asdict(board.surroundings).items())
    ego, *others = board.actors
    _, *called = labels(actor.name for actor in board.actors)
    own = {p.name: p for p in (*board.parameters, *(whole.parameters if whole is not None else ()))}
    blocks = [
        f"# Made of {' '.join(''.join(c if c.isprintable() else ' ' for c in name).split())[:80]}.",
        "\n".join(
            (
                "model chatscene.world.model",
                *([f"param {around}"] if str(board.surroundings) else []),
                *(f"param {p.name} = Range({p.low!r}, {p.high!r})" for p in own.values()),
            )
        ),
        *(_line(line, path) for line, path in board.lines.items()),
        *(_behavior(actor, behaviors[actor.name]) for actor in acting),
        *(told_line(name, line) for name, line in (whole.lines.items() if whole is not None else ())),
        *([as_written(played(whole))] if whole is not None else []),
        f"ego = new {ego.kind} {_at(ego)}, with route {EGO_ROUTE}"
        + _properties(ego)
        + (f", with wantedSpeed {ego.speed:g}" if ego.speed >= 1e-3 else "")
        + (f", with behavior {AS_WRITTEN}()" if whole is not None else ""),
        *(_placed(actor, behaviors.get(actor.name, ""), i, called[i]) for i, actor in enumerate(others)),
    ]
    return "\n\n".join(blocks) + "\n"


def _line(name: str, line: Polyline) -> str:
    made = "routeThrough" if name == EGO_ROUTE else "lineThrough"
    points = ", ".join(f"({x:.3f}, {y:.3f})" for x, y in line.points.tolist())
    return (
        f"{name} = {made}(\n" + textwrap.fill(points, _COLUMNS, initial_indent="    ", subsequent_indent="    ") + ")"
    )


def _behavior(actor: Actor, name: str) -> str:
    assert actor.plan is not None
    text = print_plan(replace(actor.plan, parameters=(), constants=()))
    return text.replace(f"behavior {BEHAVIOR}():", f"behavior {name}():", 1).rstrip()


def _properties(actor: Actor) -> str:
    usual = LIMITS.get(actor.kind)
    own = (
        []
        if usual and (usual.length, usual.width) == (actor.length, actor.width)
        else [
            f"with length {actor.length:g}",
            f"with width {actor.width:g}",
        ]
    )
    speed = [f"with speed {actor.speed:g}"] if actor.speed else []
    return "".join(f", {one}" for one in (*own, *speed))


def _at(ego: Actor) -> str:
    """Where the ego begins; beside its route and turned away from it only where that is told."""
    start = ego.start
    along, left = print_expression(start.along), print_expression(start.left)
    beside, turn = f", {left}" if left != "0" and float(left) else "", f", {start.turn:g}" if start.turn else ""
    along = along if float(along) else "0"
    return f"at pointOn({EGO_ROUTE}, {along}{beside}), facing directionOn({EGO_ROUTE}, {along}{turn})"


def _placed(actor: Actor, behavior: str, number: int, label: str) -> str:
    start = actor.start
    along, left = print_expression(start.along), print_expression(start.left)
    name = "AdvAgent" if behavior == BEHAVIOR else f"Other{number + 1}"
    does = f", with behavior {behavior}()" if behavior else ""
    does += f", with label '{label}'" if behavior != BEHAVIOR else ""  # that one is called the adversary
    turn = f", {start.turn:g}" if start.turn else ""
    return (
        f"{name} = new {actor.kind} at pointOn({start.line}, {along}, {left}),\n"
        f"    facing directionOn({start.line}, {along}{turn}){does}{_properties(actor)}"
    )
