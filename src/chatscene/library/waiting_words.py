"""What somebody was to do and when it was to begin, in short: for who has not read the program."""

from __future__ import annotations

import re

from chatscene.library.plan_words import in_words
from chatscene.terms.plan import (
    PRIMITIVES,
    After,
    Arithmetic,
    Boolean,
    Call,
    Comparison,
    Expression,
    Name,
    Number,
    Parameter,
    Phase,
    Until,
)

_TO_DO = {
    "DrivePath": "follow {path}[ at {speed}][, {left} to the left of it]",
    "BrakeOnPath": "brake[ along {path}][ by {brake}][, {left} to the left of it]",
    "ThrottleOnPath": "accelerate[ along {path}][, up to {top}]",
    "SwerveOnPath": "swerve[ {left} to the left][ at {speed}]",
    "WeaveOnPath": "weave[ at {speed}]",
    "PaceOnPath": "keep pace with {other}[, {ahead} ahead]",
    "KeepStation": "hold its distance to {other}",
    "FollowTraffic": "follow {path}[ at {speed}], behind whoever is ahead",
    "WaitFor": "wait until {other} has passed, then follow {way}[ at {speed}]",
    "ReverseStraight": "back straight[ at {speed}]",
    "ReverseTurning": "back with the wheel turned[ at {speed}]",
    "TurnOff": "turn[ at {speed}]",
    "Slide": "slide to a stand",
    "Park": "stand",
    "MoveAhead": "go straight ahead[ at {speed}]",
    "Halt": "stop and stand",
}
"""What each primitive is; what stands in square brackets is said only where a number or a thing is told for it."""
_BUILT = re.compile(r"(?P<role>way|beside|next|ours|home)[A-Z]\w*")
"""What a program that is built of a situation calls lines; the author of the situation has never seen these names."""
_LINES = {
    "way": "its way",
    "beside": "the lane beside",
    "next": "the next lane",
    "ours": "the ego's lane, against its direction",
    "home": "its own side of the road",
}
_MEASURED = {
    "headway": (
        "{1} is {than} {bound} m from {2} along the road",
        "{1} is near enough to {2} along the road",
        "{1} is far enough from {2} along the road",
    ),
    "gap": ("{0} is {than} {bound} m from {1}", "{0} is near enough to {1}", "{0} is far enough from {1}"),
    "distanceLeft": ("{1} is {than} {bound} m from {2}", "{1} is near enough to {2}", "{1} is far enough from {2}"),
    "secondsTo": (
        "{1} is {than} {bound} s from {2}",
        "{1} is near enough in time to {2}",
        "{1} is far enough from {2}",
    ),
    "offsetFrom": ("{1} is {than} {bound} m aside of {0}", "{1} has come to {0}", "{1} has left {0}"),
    "speed": ("{0} drives at {than} {bound} m/s", "{0} is slow enough", "{0} is fast enough"),
    "progress": ("{1} is {than} {bound} m along {0}", "{1} is not as far along {0}", "{1} is far enough along {0}"),
}
"""Of each quantity that is waited for: with a number, and where a formula stands in its place, below and above it."""


def to_do_in_words(phase: Phase) -> str:
    """What a phase is, as what was to be done; a number that each scene draws is left out."""
    out = ""
    for part in _TO_DO[phase.primitive].replace("]", "[").split("["):
        optional = f"[{part}]" in _TO_DO[phase.primitive]
        named = {one.name: one for one in PRIMITIVES[phase.primitive].takes if f"{{{one.name}}}" in part}
        given = {name: phase.argument(name) for name in named}
        if optional and any(_is_left_out(value, named[name].default) for name, value in given.items()):
            continue
        units = {name: f" {one.unit}" if one.unit not in ("", "1") else "" for name, one in named.items()}
        out += part.format(**{name: _thing(value) + units[name] for name, value in given.items() if value is not None})
    return out


def _is_left_out(value: Expression | None, default: float | None) -> bool:
    match value:
        case None:
            return True
        case Number(number):
            return default is not None and number == default
        case Name(name, _):
            return _BUILT.fullmatch(name) is not None
        case _:
            return True


def begins_in_words(end: Until | After | None) -> str:
    """When what comes after a phase was to begin."""
    match end:
        case Until(condition):
            return f"once {_condition(condition)}"
        case After(seconds):
            return f"after {in_words(seconds)} s"
        case None:
            return "once what it does before is over, which it never is"


def _condition(condition: Expression) -> str:
    match condition:
        case Boolean(operator, terms):
            return f" {operator} ".join(map(_condition, terms))
        case Comparison(first, ((relation, bound),)) if (measured := _measured(first)) is not None:
            return _compared(*measured, under=relation in ("<", "<="), bound=bound)
        case Call("restsWithin", (path, actor, _)):
            return f"{_thing(actor)}, braking now, would stop beside {_thing(path)}"
        case _:
            return in_words(condition)


def _measured(measured: Expression) -> tuple[Call, bool] | None:
    """What is measured, and whether nothing is taken off it but half the lengths of two: it is then a distance."""
    match measured:
        case Call("abs", (inner,)):
            return _measured(inner)
        case Arithmetic("-", inner, less) if (found := _measured(inner)) is not None:
            return found[0], found[1] and _are_half_lengths(less)
        case Call(name, _) if name in _MEASURED:
            return measured, True
        case _:
            return None


def _are_half_lengths(less: Expression) -> bool:
    match less:
        case Arithmetic("/", Arithmetic("+", Call("length", _), Call("length", _)), Number(2)):
            return True
        case _:
            return False


def _compared(call: Call, whole: bool, *, under: bool, bound: Expression) -> str:
    exact, below, above = _MEASURED[call.function]
    things = [_thing(one) for one in call.arguments]
    if whole and isinstance(bound, Number | Parameter):
        return exact.format(*things, than="less than" if under else "more than", bound=_thing(bound))
    return (below if under else above).format(*things)


def _thing(value: Expression) -> str:
    """Somebody, a line, a place on one, or a number of at most three digits."""
    match value:
        case Name(name, _) if (built := _BUILT.fullmatch(name)) is not None:
            return _LINES[built["role"]]
        case Name(_, _) | Parameter(_):
            return in_words(value)
        case Number(number):
            return f"{number:.3g}"
        case Call("progress", (_, actor)):
            return _thing(actor)
        case Call("eventAt" | "exitAt" | "entry" | "ownLane" | "against", _):
            return in_words(value)
        case _:
            return "that place"
