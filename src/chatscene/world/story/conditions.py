"""The conditions of a story: what must hold for something to begin or to stop.

('time', rule, s)
('value', rule, value, name)             of a variable; a value is a number or a text
('number', rule, value, value)           of two numbers
('element', type, name, state)           of a part of the story
('never',) ('always',)
about ('any' or 'all', (who, …)):
('speed', quantor, whose, rule, m/s) ('acceleration', …, rule, m/s²) ('travelled', …, m)
('stands', quantor, whose, s) ('lost', quantor, whose, s)
('faster', quantor, whose, rule, m/s, than whom, 'longitudinal', 'lateral' or nothing)
('turned', quantor, whose, rad, tolerance, 'road', 'lane' or nothing)
('apart', quantor, whose, rule, m, from whom or place, 'longitudinal' or 'lateral' or '', frame, freespace)
('headway', …, the same, in s) ('collision-in', …, the same, in s)
('reaches', quantor, whose, m, place)
('touches', quantor, whose, (whom, …))
"""

from __future__ import annotations

import math
import operator
from collections.abc import Callable
from typing import Any, Protocol

from chatscene.world.story.entities import Entity, Motion, apart, away, closing, faster, seen
from chatscene.world.story.places import Place

_ROUNDED = 1e-6  # within which two numbers are the same


def _same(one: Any, other: Any) -> bool:
    if isinstance(one, str) or isinstance(other, str):
        return one == other
    return math.isclose(one, other, rel_tol=1e-9, abs_tol=_ROUNDED)


RULES: dict[str, Callable[[Any, Any], bool]] = {
    "lessThan": operator.lt,
    "lessOrEqual": operator.le,
    "greaterThan": operator.gt,
    "greaterOrEqual": operator.ge,
    "equalTo": _same,
    "notEqualTo": lambda one, other: not _same(one, other),
}
_STILL = 1e-3  # [m/s]


class Measured:
    """Asks a rule of something that is measured at each step: it equals what it passes between two of them.

    Args:
        rule: The rule.
        of: What is measured.
        value: What it is compared with.
    """

    def __init__(self, rule: str, of: Callable[[], float], value: float) -> None:
        self._rule, self._of, self._value = rule, of, value
        self._before = math.nan

    def __call__(self) -> bool:
        """Whether it holds now."""
        now, value = self._of(), self._value
        passed = -math.inf < min(self._before, now) < value < max(self._before, now) < math.inf
        self._before = now
        if self._rule in ("equalTo", "notEqualTo"):
            return (passed or _same(now, value)) is (self._rule == "equalTo")
        return RULES[self._rule](now, value)


class World(Protocol):
    """What conditions ask of a story."""

    time: float
    variables: dict[str, Any]

    def entity(self, name: str) -> Entity:
        """Somebody by name."""
        ...

    def place(self, told: tuple[Any, ...]) -> Place:
        """A place."""
        ...

    def is_in(self, kind: str, name: str, state: str) -> bool:
        """Whether a part of the story is in a state, or came into it just now."""
        ...


def truth_of(told: tuple[Any, ...], world: World) -> Callable[[], bool]:
    """What a condition says, to be asked at each step.

    Raises:
        ValueError: There is no such condition.
    """
    kind, *rest = told
    match kind:
        case "always" | "never":
            return lambda: kind == "always"
        case "time":
            return Measured(rest[0], lambda: world.time, rest[1])
        case "number":
            rule = RULES[rest[0]]
            return lambda: rule(rest[1], rest[2])
        case "value":
            return lambda: _compared(rest[0], world.variables.get(rest[2], ""), rest[1])
        case "element":
            return lambda: world.is_in(rest[0], rest[1], rest[2])
        case _:
            quantor, whose, *more = rest
            each = [_about(kind, world.entity(name), more, world) for name in whose]
            held = all if quantor == "all" else any
            return lambda: held([one() for one in each])


def _compared(rule: str, one: Any, other: Any) -> bool:
    """Whether a rule holds of two values: as numbers where both are numbers, else as texts."""
    try:
        return RULES[rule](float(one), float(other))
    except (TypeError, ValueError):
        return RULES[rule](str(one), str(other))


def _about(kind: str, who: Entity, told: list[Any], world: World) -> Callable[[], bool]:  # noqa: C901, PLR0911
    """What a condition says of one of those whom it is about."""
    match kind:
        case "speed":
            return Measured(told[0], lambda: who.speed, told[1])
        case "acceleration":
            return Measured(told[0], lambda: who.gained, told[1])
        case "travelled":
            return lambda: who.travelled >= told[0]
        case "stands":
            return lambda: who.rests >= max(told[0], 1e-9)
        case "lost":
            who.is_watched = True
            return lambda: who.lost > told[0]
        case "faster":
            rule, value, than, *axis = told
            other, along = world.entity(than), axis[0] if axis else ""
            return Measured(rule, lambda: faster(who, other, along), value)
        case "turned":
            angle, near, *frame = told
            return lambda: (
                abs(math.remainder(who.pose[2] - (who.bearing(frame[0]) if frame else 0.0) - angle, math.tau)) <= near
            )
        case "touches":
            others = [world.entity(name) for name in told[0]]
            return lambda: any(other is not who and who.box().intersects(other.box()) for other in others)
        case "reaches":
            place = world.place(told[1])
            return lambda: math.dist(who.origin[:2], place.pose()[:2]) <= told[0]
        case "apart" | "headway" | "collision-in":
            return _between(kind, who, told, world)
        case _:
            raise ValueError(f"a story has no condition {kind!r}")


def _between(kind: str, who: Entity, told: list[Any], world: World) -> Callable[[], bool]:
    """What is asked of the way between two, or between somebody and a place."""
    rule, value, other, how, frame, freespace = told
    if isinstance(other, tuple):
        place = world.place(other)

        def far() -> float:
            return away(who, place.pose()[:2], how, frame, freespace=freespace)

        def motion() -> Motion:
            return place.pose()[:2], place.velocity()
    else:
        whom = world.entity(other)

        def far() -> float:
            return apart(who, whom, how, frame, freespace=freespace)

        def motion() -> Motion:
            return whom.origin[:2], whom.velocity

    def seconds(pace: float) -> float:
        return far() / pace if pace > _STILL else math.inf

    def is_behind() -> bool:
        return seen(who.origin, who.line, motion()[0], frame if how else "entity")[0] < 0.0

    match kind:
        case "apart":
            return Measured(rule, far, value)
        case "headway":  # to somebody behind there is none
            holds = Measured(rule, lambda: math.nan if is_behind() else seconds(who.speed), value)
            return lambda: holds() and not is_behind()
        case _:
            return Measured(rule, lambda: seconds(closing(who, motion(), how, frame)), value)
