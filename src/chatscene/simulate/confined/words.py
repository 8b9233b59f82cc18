"""The part of Scenic that a stranger's program may use, as lists: syntax, names, attributes, properties.

What is not listed is refused, so that a name or a construct that comes new into Scenic is refused until somebody has
looked at it. What our own world model defines is ours and reviewed; its public names are read from its text.
"""

from __future__ import annotations

import ast
from functools import lru_cache
from importlib.resources import files

from chatscene.world.unsupported import UNSUPPORTED


def _set(words: str) -> frozenset[str]:
    return frozenset(words.split())


_PYTHON_SYNTAX: tuple[type[ast.AST], ...] = (
    ast.Module, ast.Expr, ast.Assign, ast.AugAssign, ast.If, ast.While, ast.For, ast.Break, ast.Continue, ast.Pass,
    ast.Name, ast.Load, ast.Store, ast.Constant, ast.Attribute, ast.Subscript, ast.Call, ast.keyword, ast.Tuple,
    ast.List, ast.Slice, ast.Starred,
    ast.arguments, ast.arg, ast.IfExp, ast.BoolOp, ast.And, ast.Or, ast.UnaryOp, ast.USub, ast.UAdd,
    ast.Not, ast.BinOp, ast.Add, ast.Sub, ast.Mult, ast.Div, ast.FloorDiv, ast.Mod, ast.Pow, ast.Compare, ast.Eq,
    ast.NotEq, ast.Lt, ast.LtE, ast.Gt, ast.GtE,
)  # fmt: skip
# Of Python: arithmetic, conditions, loops. No functions, classes, comprehensions, imports or exceptions.

# Of Scenic: placing things, behaviors, requirements, when to end. No simulators, recorders, nested scenarios.
_SCENIC_SYNTAX = """
    Model Param parameter TrackedAssign Ego New
    BehaviorDef Precondition Invariant TryInterrupt InterruptWhenHandler Abort
    Take Wait WaitFor WaitUntil Do DoFor DoUntil Seconds Steps
    Require Always Eventually Next UntilOp ImpliesOp Terminate TerminateSimulation TerminateWhen TerminateSimulationWhen
    TerminateAfter
    WithSpecifier AtSpecifier OffsetBySpecifier OffsetAlongSpecifier DirectionOfSpecifier LeftOf RightOf AheadOf Behind
    BeyondSpecifier FollowingSpecifier FacingSpecifier FacingTowardSpecifier FacingAwayFromSpecifier
    ApparentlyFacingSpecifier
    RelativePositionOp RelativeHeadingOp ApparentHeadingOp DistanceFromOp DistancePastOp AngleFromOp FollowOp
    PositionOfOp Front Back Left Right FrontLeft FrontRight BackLeft BackRight
    DegOp VectorOp FieldAtOp RelativeToOp OffsetAlongOp CanSeeOp
"""

_PLACE = "a thing stands at a place: at, ahead of, behind, left of, right of, beyond, offset by or following"
INSTEAD = UNSUPPORTED | {
    "ClassDef": "a program uses the world model's classes; size and speed are set with `with`, when a thing is made",
    "MonitorDef": "there are no monitors; say it with `require always`, `terminate when` or a behavior",
    "RequireMonitor": "there are no monitors; say it with `require always`, `terminate when` or a behavior",
    "Mutate": "nothing is mutated; make what varies a parameter, `param OPT_... = Range(low, high)`",
    "DoChoose": "a behavior does not choose; let a parameter decide, with `if globalParameters.OPT_... > 0.5:`",
    "DoShuffle": "a behavior does not choose; do one after the other",
    "InSpecifier": _PLACE,
    "OnSpecifier": _PLACE,
    "ContainedInSpecifier": _PLACE,
    "VisibleSpecifier": _PLACE,
    "NotVisibleSpecifier": _PLACE,
}
"""By kind of node: what to write in the place of something that is not on the list."""

PYTHON_NAMES = _set("abs bool float int len max min range round sum")
"""Of Python's own functions."""

SCENIC_NAMES = _set("Discrete DiscreteRange OrientedPoint Range Uniform cos hypot roadDirection self sin")
"""Of Scenic's own; what our world model defines comes to it by itself (`world_words`)."""

ATTRIBUTES = _set(
    """
    coordinates ego_meets_at entry eventAt exitAt line maneuver meets_at pose
    heading length position speed width x y
    """
)
"""What may be read of a thing. The first line is what routes, ways and points offer, the second what actors do."""

METHODS = frozenset(("offset", "project"))
"""What may be called on a thing: a line beside a line, and where on a line a point lies."""

PROPERTIES = _set("allowCollisions behavior heading label length roadDeviation route speed velocity width")
"""What may follow ``with``."""

RESERVED = _set("globalParameters network simulation workspace model param new require")
"""Names that mean something to Scenic, which a program may not define anew."""

PARAMETERS = {"signals": frozenset(("clock", "ego-green", "ego-red"))}
"""Parameters besides ``OPT_…``, and their values."""


@lru_cache(maxsize=1)
def syntax() -> frozenset[type[ast.AST]]:
    """The kinds of nodes that a program's syntax tree may have."""
    from scenic.syntax import ast as scenic

    return frozenset((*_PYTHON_SYNTAX, *(getattr(scenic, name) for name in _SCENIC_SYNTAX.split())))


@lru_cache(maxsize=1)
def world_words() -> frozenset[str]:
    """Public names of our world model: its classes, its behaviors, and the functions it takes from our packages."""
    from scenic.syntax.parser import parse_string

    names: set[str] = set()
    for file in ("model.scenic", "behaviors.scenic"):
        source = files("chatscene.world").joinpath(file).read_text(encoding="utf-8")
        for node in parse_string(source, "exec").body:
            if isinstance(node, ast.ImportFrom) and str(node.module).startswith("chatscene."):
                names.update(alias.asname or alias.name for alias in node.names)
            elif isinstance(name := getattr(node, "name", None), str):
                names.add(name)
    return frozenset(name for name in names - _MIXINS if not name.startswith(("_", "*")))


_MIXINS = frozenset(("Driven", "Placed", "Walking"))
