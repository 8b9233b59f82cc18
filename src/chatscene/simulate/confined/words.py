"""The part of Scenic that a stranger's program may use, as lists: syntax, names, attributes, properties.

There are two such parts (`dialect_of`): one for programs, and parts of programs, for our own world model, whose scenes
are their parameters; and a longer one for programs that were written for Scenic's driving domain or a simulator of it,
which pick places from the road network and say what happens with monitors and scenarios of scenarios. What is not
listed is refused, so that a name or a construct that comes new into Scenic is refused until somebody has looked at it.
What our own world models define is ours and reviewed; their public names are read from their text.
"""

from __future__ import annotations

import ast
import builtins
import re
from dataclasses import dataclass
from functools import lru_cache
from importlib.resources import files

from chatscene.terms.scene import OWN_MODEL
from chatscene.terms.surroundings import Light, Surface, Weather
from chatscene.world.signals import MODES


def _set(words: str) -> frozenset[str]:
    return frozenset(words.split())


_PYTHON_SYNTAX: tuple[type[ast.AST], ...] = (
    ast.Module, ast.Expr, ast.Assign, ast.AugAssign, ast.If, ast.While, ast.For, ast.Break, ast.Continue, ast.Pass,
    ast.Name, ast.Load, ast.Store, ast.Constant, ast.Attribute, ast.Subscript, ast.Call, ast.keyword, ast.Tuple,
    ast.List, ast.Slice, ast.Starred,
    ast.arguments, ast.arg, ast.IfExp, ast.BoolOp, ast.And, ast.Or, ast.UnaryOp, ast.USub, ast.UAdd,
    ast.Not, ast.BinOp, ast.Add, ast.Sub, ast.Mult, ast.Div, ast.FloorDiv, ast.Mod, ast.Pow, ast.Compare, ast.Eq,
    ast.NotEq, ast.Lt, ast.LtE, ast.Gt, ast.GtE, ast.Import, ast.ImportFrom, ast.alias,
)  # fmt: skip
# Of Python: arithmetic, conditions, loops, imports of what only computes. No functions, classes, comprehensions or
# exceptions.

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
_RECORDS = "a program records nothing: the run keeps every track, event and metric of a drive"
INSTEAD = {
    "ScenarioDef": "modular scenarios are not supported; write what `setup` places at the top level of the program, "
    "and what `compose` has happen as behaviors",
    "Override": "modular scenarios are not supported, nor what they override; let a behavior change what it does",
    "Record": _RECORDS,
    "RecordInitial": _RECORDS,
    "RecordFinal": _RECORDS,
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

KINDS = {
    "AltitudeFromOp": "the operator altitude from",
    "AnnAssign": "an annotation",
    "Assert": "assert",
    "AsyncFor": "async for",
    "AsyncFunctionDef": "async def",
    "AsyncWith": "async with",
    "Await": "await",
    "BitAnd": "the operator &",
    "BitOr": "the operator |",
    "BitXor": "the operator ^",
    "ClassDef": "a class",
    "ContainedInSpecifier": "the specifier contained in",
    "Delete": "del",
    "Dict": "a dictionary",
    "DictComp": "a dictionary comprehension",
    "DoChoose": "do choose",
    "DoShuffle": "do shuffle",
    "ExceptHandler": "except",
    "FacingDirectlyAwayFromSpecifier": "the specifier facing directly away from",
    "FacingDirectlyTowardSpecifier": "the specifier facing directly toward",
    "FormattedValue": "an f-string",
    "FunctionDef": "a function",
    "GeneratorExp": "a generator expression",
    "Global": "global",
    "Import": "import",
    "ImportFrom": "from ... import",
    "In": "the operator in",
    "InSpecifier": "the specifier in",
    "InitialScenario": "initial scenario",
    "IntersectsOp": "the operator intersects",
    "Invert": "the operator ~",
    "Is": "the operator is",
    "IsNot": "the operator is not",
    "JoinedStr": "an f-string",
    "LShift": "the operator <<",
    "Lambda": "a lambda",
    "ListComp": "a list comprehension",
    "MatMult": "the operator @",
    "Match": "match",
    "Model": "model",
    "MonitorDef": "a monitor",
    "Mutate": "mutate",
    "NamedExpr": "the operator :=",
    "Nonlocal": "nonlocal",
    "NotIn": "the operator not in",
    "NotVisibleFromOp": "the operator not visible from",
    "NotVisibleOp": "the operator not visible",
    "NotVisibleSpecifier": "the specifier not visible",
    "OnSpecifier": "the specifier on",
    "Override": "override",
    "Param": "param",
    "ParamSpec": "a type parameter",
    "PropertyDef": "a property",
    "RShift": "the operator >>",
    "Raise": "raise",
    "Record": "record",
    "RecordFinal": "record final",
    "RecordInitial": "record initial",
    "RequireMonitor": "require monitor",
    "Return": "return",
    "ScenarioDef": "a scenario",
    "Set": "a set",
    "SetComp": "a set comprehension",
    "Simulator": "simulator",
    "TrackedAssign": "ego or workspace",
    "Try": "try",
    "TryStar": "try",
    "TypeAlias": "a type alias",
    "TypeVar": "a type parameter",
    "TypeVarTuple": "a type parameter",
    "VisibleFromOp": "the operator visible from",
    "VisibleOp": "the operator visible",
    "VisibleSpecifier": "the specifier visible",
    "With": "with",
    "Workspace": "workspace",
    "Yield": "yield",
    "YieldFrom": "yield from",
    "BehaviorDef": "a behavior",
    "comprehension": "a comprehension",
} | dict.fromkeys(
    _set(
        "Above Below Bottom BottomBackLeft BottomBackRight BottomFrontLeft BottomFrontRight"
        " Top TopBackLeft TopBackRight TopFrontLeft TopFrontRight"
    ),
    "a side in three dimensions",
)
"""By kind of node: what a user calls it; the names of the parser mean nothing to him."""

MODULES = {
    "math": _set(
        """
        acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh degrees dist e erf erfc exp exp2 expm1 fabs
        floor fmod frexp fsum gamma gcd hypot inf isclose isfinite isinf isnan ldexp lgamma log log10 log1p log2 modf
        nan nextafter pi pow radians remainder sin sinh sqrt tan tanh tau trunc ulp
        """
    )
}
"""Modules that may be imported, and what may be taken of each: functions of numbers that keep nothing, reach nothing
and always give the same, and constants. `factorial`, `comb`, `perm`, `prod`, `lcm` and `isqrt` are left out: they make
or take whole numbers of any length."""

NO_MODULE = {
    "random": "numbers are drawn with Range, Uniform or Normal, by the seed of the scene",
    "numpy": "it reads and writes files; use math, and lists",
}
"""What to say of modules that are often asked for and may not be imported."""

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

PROPERTIES = _set(
    "allowCollisions backwards behavior heading keepsLimits label length orders roadDeviation role route speed velocity"
    " topSpeed wantedSpeed width"
)
"""What may follow ``with``."""

RESERVED = _set("globalParameters network simulation workspace model param new require")
"""Names that mean something to Scenic, which a program may not define anew."""

PARAMETERS = {
    "signals": frozenset(MODES),
    "egoStart": frozenset(("approach", "at-line")),
    "drivesUntil": frozenset(("arrival", "over")),
    "light": frozenset(str(one) for one in Light),
    "weather": frozenset(str(one) for one in Weather),
    "surface": frozenset(str(one) for one in Surface),
}
"""Parameters besides ``OPT_…``, and their values."""


# What programs of the driving domain need besides. Functions and lambdas compute; no classes of Python's own, no
# decorators, no exceptions.
_DRIVING_PYTHON: tuple[type[ast.AST], ...] = (
    ast.Lambda, ast.ListComp, ast.GeneratorExp, ast.comprehension, ast.In, ast.NotIn, ast.Is, ast.IsNot, ast.Dict,
    ast.Set, ast.Assert, ast.FunctionDef, ast.Return, ast.JoinedStr, ast.FormattedValue,
)  # fmt: skip
_DRIVING_SCENIC = """
    MonitorDef RequireMonitor ScenarioDef Override Record RecordInitial RecordFinal DoChoose DoShuffle Mutate
    TryInterrupt InSpecifier OnSpecifier ContainedInSpecifier VisibleSpecifier NotVisibleSpecifier VisibleOp
    NotVisibleOp VisibleFromOp NotVisibleFromOp
"""
_DRIVING_PYTHON_NAMES = _set(
    """
    all any dict divmod enumerate filter frozenset isinstance iter list map next print reversed set sorted str tuple zip
    """
)
_DRIVING_NAMES = _set(
    """
    Color DiscreteRange Normal Object Options Point PolygonalRegion PolylineRegion RectangularRegion CircularRegion
    TimeSeries TruncatedNormal Uniform Vector VerifaiDiscreteRange VerifaiOptions VerifaiRange everywhere nowhere
    max min
    network road curb sidewalk shoulder roadOrShoulder intersection roadDirection ManeuverType
    DrivingObject Vehicle Car NPCCar Pedestrian Prop Debris
    SetVelocityAction SetSpeedAction SetThrottleAction SetSteerAction SetBrakeAction SetHandBrakeAction SetReverseAction
    RegulatedControlAction SetWalkingDirectionAction SetWalkingSpeedAction SetPositionAction OffsetAction
    ConstantThrottleBehavior DriveAvoidingCollisions AccelerateForwardBehavior WalkForwardBehavior FollowLaneBehavior
    FollowTrajectoryBehavior TurnBehavior LaneChangeBehavior
    withinDistanceToAnyCars withinDistanceToAnyObjs withinDistanceToAnyPedestrians withinDistanceToObjsInLane
    SetLocationAction SetAutopilotAction SetWalkAction SetTrafficLightAction SetVehicleLightStateAction
    SetManualGearShiftAction SetGearAction SetManualFirstGearShiftAction SetJumpAction SetTransformAction
    SetAngularVelocityAction TrackWaypointsAction
    simulation localPath
    RelativePosition RelativeHeading ApparentHeading DistanceFrom DistancePast AngleTo AngleFrom CanSee
    """
)
_DRIVING_ATTRIBUTES = _set(
    """
    currentTime currentRealTime timestep objects agents
    roads connectingRoads allRoads lanes lane laneSection laneGroup laneGroups road roadSections laneSections sections
    section intersection intersections crossings crossing sidewalks sidewalk shoulders shoulder curb curbRegion
    drivableRegion walkableRegion roadRegion laneRegion intersectionRegion crossingRegion sidewalkRegion shoulderRegion
    roadDirection elements element tolerance
    maneuvers maneuversAt type startLane endLane connectingLane intersection conflictingManeuvers reverseManeuvers
    incomingLanes outgoingLanes is3Way is4Way isSignalized signals isTrafficLight openDriveID country
    forwardLanes backwardLanes forwardShoulder backwardShoulder group opposite oppositeLaneGroup adjacentLanes
    fasterLane slowerLane laneToLeft laneToRight isForward isLeft isRight successor predecessor
    _fasterLane _slowerLane _laneToLeft _laneToRight _sidewalk _shoulder _opposite _lane _laneSection _laneGroup _road
    _intersection _crossing _element
    start end value
    centerline leftEdge rightEdge points polygon region orientation uid id name speedLimit tags vehicleTypes parent
    STRAIGHT LEFT_TURN RIGHT_TURN U_TURN
    behavior blueprint rolename color height velocity yaw pitch roll angularSpeed angularVelocity lastActions
    isCar isVehicle isWalker isPedestrian visibleRegion visibleDistance viewAngle roadDeviation
    throttle brake steer left right front back frontLeft frontRight backLeft backRight z
    """
)
_DRIVING_METHODS = _set(
    """
    dot sample append index count keys values items get
    laneAt laneSectionAt laneGroupAt roadAt intersectionAt crossingAt sidewalkAt shoulderAt elementAt sectionAt
    nominalDirectionsAt connectingLaneAt flowFrom shiftedBy distanceToClosest distanceTo signedDistanceTo containsPoint
    containsObject intersects nearestSegmentTo pointAlongBy rotatedBy offsetRotated norm normalized angleTo angleWith
    union intersect getSample
    """
)
_DRIVING_PROPERTIES = _set(
    """
    blueprint rolename color height regionContainedIn requireVisible visibleDistance viewAngle viewAngles position
    physics snapToGround mutator mutationScale yaw shape name
    """
)


@dataclass(frozen=True, slots=True)
class Dialect:
    """A part of Scenic.

    Attributes:
        syntax: The kinds of nodes that a program's syntax tree may have.
        names: What every program finds defined.
        kept: Names that a program may not define anew.
        attributes: What may be read of a thing.
        methods: What may be called on a thing.
        properties: What may follow ``with``.
        free: Whether parameters have any name and value, and loops run over any list.
    """

    syntax: frozenset[type[ast.AST]]
    names: frozenset[str]
    kept: frozenset[str]
    attributes: frozenset[str]
    methods: frozenset[str]
    properties: frozenset[str]
    free: bool


@lru_cache(maxsize=2)
def dialect_of(model: str) -> Dialect:
    """What a program may use that is written for a world model."""
    from scenic.syntax import ast as scenic

    syntax = frozenset((*_PYTHON_SYNTAX, *(getattr(scenic, name) for name in _SCENIC_SYNTAX.split())))
    names = SCENIC_NAMES | PYTHON_NAMES | {"ego"}
    if model == OWN_MODEL:
        given = names | world_words()
        return Dialect(syntax, given, given | RESERVED, ATTRIBUTES, METHODS, PROPERTIES, free=False)
    more = (getattr(scenic, name) for name in _DRIVING_SCENIC.split())
    builtin = names | _DRIVING_PYTHON_NAMES
    return Dialect(
        syntax | frozenset((*_DRIVING_PYTHON, *more)),
        builtin | _DRIVING_NAMES | _defined_in("driving.scenic", "carla_model.scenic", "carla_behaviors.scenic"),
        (builtin | RESERVED | {"simulation", "localPath"}) - {"ego"},
        ATTRIBUTES | _DRIVING_ATTRIBUTES,
        METHODS | _DRIVING_METHODS,
        PROPERTIES | _DRIVING_PROPERTIES,
        free=True,
    )


@lru_cache(maxsize=1)
def known_properties() -> frozenset[str]:
    """The names by which Scenic, a world model or a simulator knows something of a thing."""
    from scenic.core.object_types import Object

    texts = (files("chatscene.world").joinpath(name).read_text("utf-8") for name in _MODEL_TEXTS)
    told = (name for text in texts for name in _PROPERTY.findall(text))
    dialect = dialect_of("")
    own = {*dir(Object), *Object._defaults}  # type: ignore[reportPrivateUsage] - Scenic tells them nowhere else
    return dialect.attributes | dialect.methods | dialect.properties | own | frozenset(told)


@lru_cache(maxsize=1)
def world_words() -> frozenset[str]:
    """Public names of our world model: its classes, its behaviors, and the functions it takes from our packages."""
    return _defined_in("model.scenic", "behaviors.scenic")


def _defined_in(*models: str) -> frozenset[str]:
    names: set[str] = set()
    for file in models:
        source = files("chatscene.world").joinpath(file).read_text(encoding="utf-8")
        names.update(_DEFINES.findall(source))
        for taken in _TAKES.findall(source):
            names.update(alias.asname or alias.name for alias in ast.parse(taken).body[0].names)  # type: ignore[attr-defined]
    return frozenset(name for name in names - _MIXINS if not name.startswith(("_", "*")))


# By its lines, since Scenic's parser takes half a second for them in each process.
_DEFINES = re.compile(r"^(?:class|behavior|monitor|scenario|def) +(\w+)", re.MULTILINE)
_TAKES = re.compile(r"^from chatscene\.\S+ import (?:\([^)]*\)|.*)", re.MULTILINE)
_PROPERTY = re.compile(r"^ +(\w+):", re.MULTILINE)
_MODEL_TEXTS = ("driving.scenic", "carla_model.scenic")
_MIXINS = frozenset(("Driven", "Placed", "Walking", "chatscene_parameter"))


@lru_cache(maxsize=1)
def outside() -> frozenset[str]:
    """Names that Python or Scenic defines for a program that is trusted; the sandbox need not."""
    from scenic.syntax import veneer

    return frozenset(dir(builtins)) | frozenset(veneer.__all__)
