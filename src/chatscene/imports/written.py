"""A storyboard as a Scenic program for our own world model, which `chatscene run --program` runs as any of a user."""

from __future__ import annotations

import textwrap
from dataclasses import asdict, replace

from chatscene.errors import ScenarioError
from chatscene.imports.names import labels
from chatscene.imports.written_story import StoryProgram, as_written, played, told_line
from chatscene.terms.actors import LIMITS
from chatscene.terms.plan_text import BEHAVIOR, print_expression, print_plan
from chatscene.terms.polyline import Polyline
from chatscene.terms.scene import AS_WRITTEN
from chatscene.terms.storyboard import EGO_ROUTE, Actor, Storyboard

_COLUMNS = 100


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
