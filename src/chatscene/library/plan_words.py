"""A plan in words for a person, one line a phase."""

from __future__ import annotations

from chatscene.terms.plan import (
    PRIMITIVES,
    After,
    AnyOf,
    Arithmetic,
    Boolean,
    Call,
    Comparison,
    Conditional,
    Expression,
    Kind,
    Name,
    Negation,
    Not,
    Number,
    Parameter,
    Phase,
    Plan,
    Until,
)
from chatscene.terms.plan_text import print_expression

# What each primitive does; what stands in square brackets is said only if the argument in it is told.
_DOES = {
    "DrivePath": "follows {path} at {speed}[, {left} to the left of it]",
    "BrakeOnPath": "brakes along {path}[ by {brake}][, {left} to the left of it]",
    "ThrottleOnPath": "holds the pedal down by {throttle} along {path}[, {left} to the left of it][, up to {top}]",
    "SwerveOnPath": "swerves {left} to the left of {path} at {speed}",
    "WeaveOnPath": "weaves about {path} at {speed}, {amplitude} to either side, once in {period}",
    "PaceOnPath": "keeps pace with {other} along {path}[, {ahead} ahead][, up to {top}][, at least at {least}]",
    "KeepStation": "holds its distance to {other} along {path}[, at least at {least}]",
    "FollowTraffic": "follows {path} at {speed}, behind whoever is ahead",
    "WaitFor": "waits until {other} has passed, then follows {way} at {speed}",
    "ReverseStraight": "backs straight at {speed}",
    "ReverseTurning": "backs at {speed} with the wheel turned by {steer}",
    "TurnOff": "turns to the left by {angle} at {speed}[ with a radius of {radius}]",
    "Slide": "slides to a stand, turning about itself by {spin}, braked by {brake}",
    "Park": "stands",
    "MoveAhead": "goes straight ahead at {speed}[, turned to the left by {turn}]",
    "Halt": "stops and stands",
}
_CALLED = {
    "self": "it",
    "ego": "the ego",
    "egoRoute": "the ego's route",
    "advTrajectory": "its way",
    "advLane": "its lane",
    "advKerb": "its way along the kerb",
    "adjacentLane": "the lane beside the ego's",
    "egoMeeting": "where their ways meet",
    "advMeeting": "where their ways meet",
    "acrossMeeting": "where their ways meet",
    "LeadingAgent": "the leader",
    "leaderWay": "the leader's way",
    "crossSignal": "the light of those who cross",
}
_ASKED = {
    "distanceLeft": "what {1} has left on {0} to {2}",
    "headway": "what {1} has left on {0} to be level with {2}",
    "gap": "the distance between {0} and {1}",
    "offsetFrom": "how far left of {0} {1} is",
    "restsWithin": "{1}, braking now, would stop within {2} m of {0}",
    "secondsTo": "the time that {1} needs on {0} to {2}",
    "speed": "the speed of {0}",
    "heading": "the heading of {0}",
    "progress": "how far along {0} {1} is",
    "brakingDistance": "the braking distance of {0}",
    "length": "the length of {0}",
    "eventAt": "the start of the manoeuvre",
    "exitAt": "the end of the junction",
    "entry": "the entry of the junction",
    "ownLane": "the ego's first lane",
    "against": "{0} the wrong way",
    "extended": "{0} from {1} m before it",
    "beside": "a line {1} m to the left of {0}",
    "others": "the others",
}
_RELATIONS = {"<": "is under", "<=": "is at most", ">": "is over", ">=": "is at least", "==": "is", "!=": "is not"}


def describe_plan(plan: Plan) -> tuple[str, ...]:
    """What each phase does and when it ends, one line a phase; and where the plan begins again, if it does."""
    lines = [f"{i}. {_phase(phase)}" for i, phase in enumerate(plan.phases, 1)]
    return (*lines, *(() if plan.loop is None else (f"again from {plan.loop + 1}",)))


def _phase(phase: Phase) -> str:
    values = "".join(f"with {value.name} = {_say(value.expression)}: " for value in phase.values)
    match phase.end:
        case Until(condition):
            end = f", until {in_words(condition)}"
        case After(seconds):
            end = f", for {in_words(seconds)} s"
        case None:
            end = ""
    return f"{values}{_does(phase)}{end}"


def _does(phase: Phase) -> str:
    """What a phase does, without what ends it."""
    takes = PRIMITIVES[phase.primitive].takes
    said = {
        argument.name: _say(given) + (f" {argument.unit}" if argument.unit not in ("", "1") else "")
        for argument in takes
        if (given := phase.argument(argument.name)) is not None
    }
    default = {a.name for a in takes if a.default is not None and phase.argument(a.name) == Number(a.default)}
    out = ""
    for part in _DOES[phase.primitive].replace("]", "[").split("["):
        optional = f"[{part}]" in _DOES[phase.primitive]
        if not (optional and any(f"{{{name}}}" in part for name in default)):
            out += part.format(**said)
    return out


def in_words(expression: Expression) -> str:
    """A condition, a number or a thing in words."""
    return _say(expression)


def _say(expression: Expression, *, inner: bool = False) -> str:  # noqa: C901, PLR0911, PLR0912
    """An expression in words.

    Args:
        expression: What to say.
        inner: Whether it is part of another, and stands in brackets where that would be misread without.
    """
    match expression:
        case Name(name, _):
            return _CALLED.get(name, name)
        case Parameter(name):
            return name
        case Negation(of):
            return f"-{_say(of, inner=True)}"
        case Not(of):
            return f"not ({_say(of)})"
        case Arithmetic(operator, left, right):
            text = f"{_say(left, inner=True)} {operator} {_say(right, inner=True)}"
            return f"({text})" if inner and operator in "+-" else text
        case Comparison(first, links):
            return " ".join((_say(first), *(f"{_RELATIONS[relation]} {_say(right)}" for relation, right in links)))
        case Boolean(operator, terms):
            text = f" {operator} ".join(_say(term, inner=True) for term in terms)
            return f"({text})" if inner else text
        case Conditional(test, then, otherwise):
            return f"{_say(then)} (where {_say(test)}; else {_say(otherwise)})"
        case AnyOf(actor, actors, condition):
            return f"{_say(condition)} for any {actor} of {_say(actors)}"
        case Call("abs", (Call("offsetFrom", (path, actor)),)):
            whose = "its distance" if actor == Name("self", Kind.ACTOR) else f"the distance of {_say(actor)}"
            return f"{whose} from {_say(path)}"
        case Call("abs", (Call("headway", (path, actor, other)),)):
            return f"the distance along {_say(path)} between {_say(actor)} and {_say(other)}"
        case Call("speed", (Name("self"),)):
            return "its speed"
        case Call("gap", (Name("self"), other)) | Call("gap", (other, Name("self"))):
            return f"its distance to {_say(other)}"
        case Call(name, arguments) if name in _ASKED:
            return _ASKED[name].format(*map(_say, arguments))
        case Call(name, arguments):
            return f"{name}({', '.join(map(_say, arguments))})"
        case _:
            return print_expression(expression)
