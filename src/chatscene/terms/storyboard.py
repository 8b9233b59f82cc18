"""Storyboards: who is where at first, along which lines, and what each does then, in a form that leaves and comes back.

The plans in a storyboard are *plain*: their paths are lines by name, their numbers hang on parameters alone, and each
condition compares one live quantity with a number.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from chatscene.terms.plan import Expression, Plan
from chatscene.terms.polyline import Polyline
from chatscene.terms.snippet import ParameterRange
from chatscene.terms.surroundings import Surroundings

EGO_ROUTE = "egoRoute"  # what the line of the ego's route is called
THING = "Prop"  # the class of whatever is no road user
OVER = 0.3  # [m] beside a line within which a change to it is over
START = "start"  # what a plain plan calls where on its way an actor began [m]


@dataclass(frozen=True, slots=True, kw_only=True)
class Start:
    """Where the centre of somebody is at first.

    Attributes:
        along: How far along it [m].
        left: How far to the left of it [m].
        turn: How far it is turned to the left of the line's direction there [rad].
    """

    line: str
    along: Expression
    left: Expression
    turn: float


@dataclass(frozen=True, slots=True, kw_only=True)
class Actor:
    """A road user or a thing.

    Attributes:
        length: [m].
        width: [m].
        start: Where it is at first.
        speed: How fast it is then [m/s].
        plan: What it does; None of the ego, of what stands all the time, and of who is led.
        led: Whether it is led along its track, as no plain plan says what it does.
    """

    name: str
    kind: str
    length: float
    width: float
    start: Start
    speed: float = 0.0
    plan: Plan | None = None
    led: bool = False


@dataclass(frozen=True, slots=True, kw_only=True)
class Storyboard:
    """A logical scenario.

    Attributes:
        actors: The ego first.
        lines: By name; the ego's route first.
        lanes: The number in OpenDRIVE of the lane that a line follows, for each line that somebody changes to.
        parameters: What varies, each within its range.
        unsaid: What plans say and it does not, in words.
        mirrored: Whether it lies on the mirror image of its map.
    """

    actors: tuple[Actor, ...]
    lines: Mapping[str, Polyline]
    lanes: Mapping[str, int] = field(default_factory=dict[str, int])
    parameters: tuple[ParameterRange, ...] = ()
    values: Mapping[str, float] = field(default_factory=dict[str, float])
    surroundings: Surroundings = field(default_factory=Surroundings)
    unsaid: tuple[str, ...] = ()
    mirrored: bool = False
