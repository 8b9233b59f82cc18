"""A scenario as a Scenic program that plays a story (`chatscene.world.story`), and the words it is written in."""

from __future__ import annotations

import textwrap
from collections.abc import Mapping
from dataclasses import asdict, dataclass, field

import shapely
import shapely.affinity

from chatscene.imports.names import ODD, labels
from chatscene.imports.shapes import thinned, thinned_finely
from chatscene.terms.actors import LIMITS
from chatscene.terms.plan import Expression
from chatscene.terms.plan_text import BEHAVIOR, print_expression
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import AS_WRITTEN
from chatscene.terms.snippet import ParameterRange
from chatscene.terms.storyboard import EGO_ROUTE
from chatscene.terms.surroundings import Surroundings
from chatscene.world.actors import QUARTER

_COLUMNS = 110
_OVERLAPS = ", with allowCollisions True"


@dataclass(frozen=True, slots=True)
class Line:
    """A line of the program, by name."""

    name: str


Told = tuple["Told | Line | Expression | str | float | bool | None", ...]


@dataclass(frozen=True, slots=True, kw_only=True)
class Member:
    """Somebody in a story.

    Attributes:
        length: [m].
        width: [m].
        x: Of its centre [m].
        y: Of its centre [m].
        heading: [rad, 0 = +x].
        ahead: How far its centre lies before its origin [m].
        speed: [m/s] at first.
        acts: Whether it does anything; of the ego, whether the file says what.
        bounds: Its largest speed [m/s], acceleration and deceleration [m/s²], where the file says them.
    """

    name: str
    kind: str
    length: float
    width: float
    x: float
    y: float
    heading: float
    ahead: float
    speed: float
    acts: bool
    bounds: tuple[float, ...] = ()


@dataclass(frozen=True, slots=True, kw_only=True)
class StoryProgram:
    """A scenario that is played as a story."""

    members: tuple[Member, ...]
    route: Polyline
    lines: Mapping[str, Polyline] = field(default_factory=dict[str, Polyline])
    acts: Told = ()
    stop: Told | None = None
    variables: Told = ()
    parameters: tuple[ParameterRange, ...] = ()
    surroundings: Surroundings = field(default_factory=Surroundings)


def written_story(story: StoryProgram, name: str) -> str:
    """The program of a story."""
    around = ", ".join(f"{key} = '{value}'" for key, value in asdict(story.surroundings).items())
    acting = [one for one in story.members[1:] if one.acts]
    other = next(iter(acting or story.members[1:]), None)
    within = _overlapping(story.members)
    plays = other is not None and (other.acts or story.stop is not None)  # somebody is to play it to its end
    ego = story.members[0]
    called = labels(one.name for one in story.members)
    blocks = [
        f"# Made of {' '.join(''.join(c if c.isprintable() else ' ' for c in name).split())[:80]}.",
        "\n".join(
            (
                "model chatscene.world.model",
                *([f"param {around}"] if str(story.surroundings) else []),
                *(f"param {p.name} = Range({p.low!r}, {p.high!r})" for p in story.parameters),
            )
        ),
        *(told_line(line, path) for line, path in {EGO_ROUTE: story.route, **story.lines}.items()),
        *([f"behavior {BEHAVIOR}():\n    {played(story)}"] if plays else []),
        *([as_written(f"do {BEHAVIOR}()" if plays else played(story))] if ego.acts else []),
        _ego(ego, story.route) + (_OVERLAPS if ego.name in within else ""),
        *(
            _placed(one, i, called[i], adversary=one is other, plays=one is other and plays)
            + (_OVERLAPS if one.name in within else "")
            for i, one in enumerate(story.members)
            if i
        ),
    ]
    return "\n\n".join(blocks) + "\n"


def told_line(name: str, line: Polyline) -> str:
    """A line, as it stands in a program: the ego's route, or points that are followed as they are."""
    points: list[tuple[float, float]] = [(x, y) for x, y in line.points.tolist()]
    made = "routeThrough" if name == EGO_ROUTE else ""
    kept, digits = (thinned(points), 2) if made else (thinned_finely(points), 3)
    told = ", ".join(f"({points[i][0]:.{digits}f}, {points[i][1]:.{digits}f})" for i in kept)
    return f"{name} = {made}(\n{textwrap.fill(told, _COLUMNS, initial_indent='    ', subsequent_indent='    ')})"


def played(story: StoryProgram) -> str:
    """What plays a story, as it stands in a behavior."""
    names: Told = tuple((one.name, round(one.ahead, 3), *one.bounds) for one in story.members)
    parts = [told(names, 8), told(story.acts, 8)]
    if story.stop is not None or story.variables:
        parts.append(told(story.stop, 8))
    if story.variables:
        parts.append(told(story.variables, 8))
    inner = ",\n        ".join(parts)
    return f"do PlayStory(\n        {inner})"


def as_written(does: str) -> str:
    """The behavior of an ego that does what the file says, where no ego under test drives it."""
    return f"behavior {AS_WRITTEN}():\n    {does}"


def told(value: Told | Line | Expression | str | float | bool | None, indent: int) -> str:  # noqa: PLR0911
    """A part of a story as it stands in a program."""
    if isinstance(value, tuple):
        parts = [told(one, indent + 4) for one in value]
        whole = f"({', '.join(parts)}{',' if len(parts) == 1 else ''})"
        if "\n" not in whole and len(whole) + indent <= _COLUMNS:
            return whole
        return f"({_filled(parts, indent + 4)},)"
    if isinstance(value, Line):
        return value.name
    if isinstance(value, str):
        return f"'{ODD.sub('_', value)}'"
    if value is None or isinstance(value, bool):
        return repr(value)
    if isinstance(value, int | float):
        return f"{round(float(value), 4):g}" if abs(value) < 1e4 else repr(round(float(value), 3))
    return print_expression(value)


def _filled(parts: list[str], indent: int) -> str:
    """Parts one after the other, as many in a line as it holds; what takes several lines begins one."""
    gap = "\n" + " " * indent
    text, room = "", 0
    for i, part in enumerate(parts):
        if i and ("\n" in part or len(part) + 2 > room):
            text += f",{gap}"
            room = _COLUMNS - indent
        elif i:
            text += ", "
        else:
            room = _COLUMNS - indent
        text += part
        room = -1 if "\n" in part else room - len(part) - 2
    return text


def _ego(one: Member, route: Polyline) -> str:
    along, left, _ = route.project(one.x, one.y)
    turn = one.heading - route.heading_at(along)
    beside = f", {left:.3f}" if abs(left) >= 5e-4 else ""
    turned = f", {turn:.4f}" if abs(turn) >= 5e-5 else ""
    wants = f", with wantedSpeed {one.speed:g}" if one.speed >= 1e-3 else ""
    does = f", with behavior {AS_WRITTEN}()" if one.acts else ""
    return (
        f"ego = new {one.kind} at pointOn({EGO_ROUTE}, {along:.3f}{beside}), "
        f"facing directionOn({EGO_ROUTE}, {along:.3f}{turned}), with route {EGO_ROUTE}{_properties(one)}{wants}{does}"
    )


def _overlapping(members: tuple[Member, ...]) -> frozenset[str]:
    """Who stands in somebody else at first, as a trailer on its coupling does."""
    boxes = [
        shapely.affinity.rotate(
            shapely.box(one.x - one.length / 2, one.y - one.width / 2, one.x + one.length / 2, one.y + one.width / 2),
            one.heading,
            use_radians=True,
        )
        for one in members
    ]
    return frozenset(
        one.name
        for i, one in enumerate(members)
        if any(boxes[i].intersects(box) for j, box in enumerate(boxes) if j != i)
    )


def _properties(one: Member) -> str:
    usual = LIMITS.get(one.kind)
    own = (
        []
        if usual and (usual.length, usual.width) == (one.length, one.width)
        else [f"with length {one.length:g}", f"with width {one.width:g}"]
    )
    speed = [f"with speed {one.speed:g}"] if one.speed else []
    return "".join(f", {part}" for part in (*own, *speed))


def _placed(one: Member, number: int, label: str, *, adversary: bool, plays: bool) -> str:
    name = "AdvAgent" if adversary else f"Other{number}"
    does = f", with behavior {BEHAVIOR if plays else 'TakePart'}()" if plays or one.acts else ""
    does += "" if plays else f", with label '{label}'"
    does += ", with role 'adversary'" if adversary and not plays else ""
    return (
        f"{name} = new {one.kind} at ({one.x:.3f}, {one.y:.3f}),\n"
        f"    facing {one.heading - QUARTER:.4f}{does}{_properties(one)}"
    )
