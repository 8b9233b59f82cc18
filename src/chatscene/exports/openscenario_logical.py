"""ASAM OpenSCENARIO XML 1.2, a logical scenario: what the plans say, with parameters; what was driven is not in it.

Beside it lie a file with the distribution of each parameter and the OpenDRIVE map. As it stands, the scenario has the
values of the scene. Whoever acts has a variable that counts his phases, by which the trigger of each event asks whether
its turn has come. Origins and headings are as in `chatscene.exports.openscenario`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from xml.etree import ElementTree as Xml

from chatscene.exports.bodies import wheelbase_of
from chatscene.exports.exporter import KeptScene
from chatscene.exports.openscenario import DATE, actors_of, after, environment
from chatscene.exports.openscenario_entities import entity
from chatscene.exports.retold import retold
from chatscene.exports.xml_element import element
from chatscene.terms.actors import LIMITS, Limits
from chatscene.terms.episode import Track
from chatscene.terms.plan import (
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
    Relation,
    Until,
    walk,
)
from chatscene.terms.plan_text import PARAMETERS, print_expression
from chatscene.terms.polyline import Polyline
from chatscene.terms.storyboard import EGO_ROUTE, Actor, Start, Storyboard
from chatscene.terms.sums import number, product, sum_of, valued

LANE_CHANGE = 3.0  # [s]; in ours it takes as long as a driver takes who follows the new lane
_EXPONENT = re.compile(r"\b\d[\d.]*e[-+]?\d+")  # of a number, which the format does not know in expressions
AHEAD = 60.0  # [m], how far whoever goes straight on has a line to follow
RULES: dict[Relation, str] = {
    "<": "lessThan",
    "<=": "lessOrEqual",
    ">": "greaterThan",
    ">=": "greaterOrEqual",
    "==": "equalTo",
    "!=": "notEqualTo",
}


class OpenScenarioLogical:
    """One ``.xosc`` per scene, its ``_distribution.xosc``, and the map."""

    def files(self, scene: KeptScene) -> Mapping[str, bytes]:
        """The logical scenario of a scene.

        Raises:
            RunError: The format cannot say it; the message names the actor, the phase and what is missing.
        """
        board = retold(scene)
        tracks = {track.actor: track for track in scene.episode.tracks}
        text = "; not said: ".join((f"{scene.episode.scene_id}: {scene.text}", *board.unsaid))
        name = f"{scene.stem}.xosc"
        found = {
            name: _whole(scenario(board, tracks, scene.map.name, text, scene.episode.duration)),
            scene.map.name: scene.map.content,
        }
        if board.parameters:
            found[f"{scene.stem}_distribution.xosc"] = _whole(_distribution(board, name, text))
        return found


def _whole(root: Xml.Element) -> bytes:
    Xml.indent(root)
    return Xml.tostring(root, encoding="UTF-8", xml_declaration=True) + b"\n"


def _header(text: str) -> Xml.Element:
    named = {"revMajor": 1, "revMinor": 2, "date": DATE, "description": text, "author": "chatscene"}
    return element("FileHeader", named)


def _distribution(board: Storyboard, name: str, text: str) -> Xml.Element:
    ranges = [
        element(
            "StochasticDistribution",
            {"parameterName": one.name},
            element("UniformDistribution", {}, element("Range", {"lowerLimit": one.low, "upperLimit": one.high})),
        )
        for one in board.parameters
    ]
    return element(
        "OpenSCENARIO",
        {},
        _header(text),
        element(
            "ParameterValueDistribution",
            {},
            element("ScenarioFile", {"filepath": name}),
            element("Stochastic", {"numberOfTestRuns": 10, "randomSeed": 0}, *ranges),
        ),
    )


def scenario(board: Storyboard, tracks: Mapping[str, Track], map_name: str, text: str, duration: float) -> Xml.Element:
    """The scenario of a storyboard.

    Args:
        board: What is told.
        tracks: Of each actor by name, for its body.
        map_name: The name of the map's file.
        text: What the file is about.
        duration: When the scenario ends [s].
    """
    ego, *others = board.actors
    acting = [one for one in others if one.plan is not None]
    variables = [
        element("VariableDeclaration", {"name": _variable(one), "variableType": "int", "value": 0}) for one in acting
    ]
    told = [_Teller(board, one, tracks[one.name], wheelbase_of(tracks[ego.name]) / 2) for one in acting]
    entities = [element("ScenarioObject", {"name": one.name}, entity(tracks[one.name])) for one in others]
    host = element("Controller", {"name": "host"}, element("Properties", {}, _property("chatscene.role", "ego")))
    entities.insert(
        0,
        element("ScenarioObject", {"name": ego.name}, entity(tracks[ego.name]), element("ObjectController", {}, host)),
    )
    return element(
        "OpenSCENARIO",
        {},
        _header(text),
        *([element("ParameterDeclarations", {}, *_declared(board))] if board.parameters else []),
        *([element("VariableDeclarations", {}, *variables)] if variables else []),
        element("CatalogLocations"),
        element("RoadNetwork", {}, element("LogicFile", {"filepath": map_name})),
        element("Entities", {}, *entities),
        element(
            "Storyboard",
            {},
            element(
                "Init",
                {},
                element(
                    "Actions",
                    {},
                    environment(board.surroundings),
                    _ego(board, ego, tracks[ego.name]),
                    *(_begins(board, one, tracks[one.name]) for one in others),
                ),
            ),
            element(
                "Story",
                {"name": "as planned"},
                element(
                    "Act",
                    {"name": "the plans"},
                    *(one.group() for one in told),
                    element("StartTrigger", {}, after(0.0, "it begins", "greaterOrEqual")),
                ),
            )
            if told
            else element("Story", {"name": "nobody acts"}),
            element("StopTrigger", {}, after(duration, "it is over", "greaterThan")),
        ),
    )


def _property(name: str, value: str) -> Xml.Element:
    return element("Property", {"name": name, "value": value})


def _declared(board: Storyboard) -> Iterator[Xml.Element]:
    for one in board.parameters:
        limits = (("greaterOrEqual", one.low), ("lessOrEqual", one.high))
        constraints = [element("ValueConstraint", {"rule": rule, "value": value}) for rule, value in limits]
        yield element(
            "ParameterDeclaration",
            {"name": one.name, "parameterType": "double", "value": board.values[one.name]},
            element("ConstraintGroup", {}, *constraints),
        )


def _variable(actor: Actor) -> str:
    return f"{re.sub(r'[^A-Za-z0-9_]', '_', actor.name)}_phase"


def spelled(expression: Expression) -> str | float:
    """A number in the format's own language of expressions."""
    match expression:
        case Number(value):
            return float(value)
        case Parameter(name):
            return f"${name}"
        case _:
            text = print_expression(expression).replace(f"{PARAMETERS}.", "$")
            return f"${{{_EXPONENT.sub(lambda found: f'{float(found[0]):.6f}', text)}}}"


def _ego(board: Storyboard, ego: Actor, track: Track) -> Xml.Element:
    line = board.lines[EGO_ROUTE]
    heading, axle = line.heading_at(0.0), wheelbase_of(track) / 2
    x, y = line.point_at(0.0)
    at = {"x": x - axle * math.cos(heading), "y": y - axle * math.sin(heading), "h": heading}
    waypoints = [
        element("Waypoint", {"routeStrategy": "shortest"}, element("Position", {}, _world(px, py)))
        for px, py in line.points.tolist()
    ]
    route = element("Route", {"name": EGO_ROUTE, "closed": False}, *waypoints)
    return element(
        "Private",
        {"entityRef": ego.name},
        _private("TeleportAction", element("Position", {}, element("WorldPosition", at))),
        _private("RoutingAction", element("AssignRouteAction", {}, route)),
        *_at_speed(ego.speed),
    )


def _world(x: float, y: float) -> Xml.Element:
    return element("WorldPosition", {"x": x, "y": y})


def _private(tag: str, *inside: Xml.Element) -> Xml.Element:
    return element("PrivateAction", {}, element(tag, {}, *inside))


def _at_speed(speed: float) -> list[Xml.Element]:
    if not speed:
        return []
    return [_private("LongitudinalAction", _speed(Number(speed), "step", "time", Number(0.0)))]


def _begins(board: Storyboard, actor: Actor, track: Track) -> Xml.Element:
    start = actor.start
    axle = wheelbase_of(track) / 2
    along, left = behind(start, axle)
    position = element(
        "TrajectoryPosition",
        {"s": spelled(along), "t": spelled(left)},
        *([element("Orientation", {"type": "relative", "h": start.turn})] if start.turn else []),
        element("TrajectoryRef", {}, _trajectory(start.line, board.lines[start.line])),
    )
    return element(
        "Private",
        {"entityRef": actor.name},
        _private("TeleportAction", element("Position", {}, position)),
        *_at_speed(actor.speed),
    )


def behind(start: Start, back: float) -> tuple[Expression, Expression]:
    """Where on its line, along and to the left, the point is that lies so far [m] behind somebody's centre."""
    along, left = sum_of(start.along), sum_of(start.left)
    assert along is not None
    assert left is not None
    shifted = along + number(-back * math.cos(start.turn)), left + number(-back * math.sin(start.turn))
    return shifted[0].expression, shifted[1].expression


def _trajectory(name: str, line: Polyline) -> Xml.Element:
    vertices = [element("Vertex", {"time": 0}, element("Position", {}, _world(x, y))) for x, y in line.points.tolist()]
    shape = element("Shape", {}, element("Polyline", {}, *vertices))
    return element("Trajectory", {"name": name, "closed": False}, shape)


def _speed(target: Expression, shape: str, dimension: str, value: Expression) -> Xml.Element:
    dynamics = {"dynamicsShape": shape, "dynamicsDimension": dimension, "value": spelled(value)}
    return element(
        "SpeedAction",
        {},
        element("SpeedActionDynamics", dynamics),
        element("SpeedActionTarget", {}, element("AbsoluteTargetSpeed", {"value": spelled(target)})),
    )


class _Teller:
    """Tells the phases of an actor as events."""

    def __init__(self, board: Storyboard, actor: Actor, track: Track, ego_axle: float) -> None:
        self._board, self._actor, self._axle, self._ego_axle = board, actor, wheelbase_of(track) / 2, ego_axle
        self._limits: Limits = LIMITS[actor.kind]
        self._way: str | None = None

    def group(self) -> Xml.Element:
        """Everything that the actor does."""
        name = self._actor.name
        assert self._actor.plan is not None
        phases = self._actor.plan.phases
        waits = phases[0].primitive == "Halt" and self._actor.speed == 0
        events = [self._event(i, phases) for i in range(1 if waits else 0, len(phases))]
        if not events:  # it stands all the time
            events = [self._event(0, phases)]
        return element(
            "ManeuverGroup",
            {"name": f"{name} acts", "maximumExecutionCount": 1},
            actors_of(name),
            element("Maneuver", {"name": f"{name} as planned"}, *events),
        )

    def _event(self, index: int, phases: tuple[Phase, ...]) -> Xml.Element:
        name = f"{self._actor.name} phase {index}"
        actions = [element("Action", {"name": f"{name}: {what}"}, action) for what, action in self._does(phases[index])]
        if index + 1 < len(phases) or index:
            counted = element("SetAction", {"value": index})
            variable = element("VariableAction", {"variableRef": _variable(self._actor)}, counted)
            actions.append(element("Action", {"name": f"{name}: it is"}, element("GlobalAction", {}, variable)))
        return element(
            "Event",
            {"name": name, "priority": "parallel", "maximumExecutionCount": 1},
            *actions,
            element("StartTrigger", {}, *self._trigger(index, phases[index - 1].end if index else None)),
        )

    def _does(self, phase: Phase) -> Iterator[tuple[str, Xml.Element]]:
        """The actions of a phase, each with a word for it."""
        if phase.primitive in ("Halt", "MoveAhead"):
            turn = phase.argument("turn")
            angle = turn.value if isinstance(turn, Number) else 0.0
            if self._way != "ahead" or angle:
                self._way = "ahead"
                yield "way", _private("RoutingAction", self._ahead(float(angle)))
        else:
            path = phase.argument("path")
            assert isinstance(path, Name)
            if path.id != self._way:
                change = self._way not in (None, "ahead")  # else it stood so far
                self._way = path.id
                if change:
                    yield "way", _private("LateralAction", self._changes(path.id))
                else:
                    yield "way", _private("RoutingAction", self._follows(path.id))
        yield "speed", _private("LongitudinalAction", self._drives(phase))

    def _follows(self, name: str) -> Xml.Element:
        along, _ = behind(self._actor.start, self._axle)
        return _following(_trajectory(name, self._board.lines[name]), spelled(along))

    def _ahead(self, turn: float) -> Xml.Element:
        points = ((0.0, 0.0), (AHEAD * math.cos(turn), AHEAD * math.sin(turn)))
        vertices = [
            element(
                "Vertex",
                {"time": 0},
                element(
                    "Position", {}, element("RelativeObjectPosition", {"entityRef": self._actor.name, "dx": x, "dy": y})
                ),
            )
            for x, y in points
        ]
        shape = element("Shape", {}, element("Polyline", {}, *vertices))
        return _following(element("Trajectory", {"name": "straight ahead", "closed": False}, shape), 0.0)

    def _changes(self, name: str) -> Xml.Element:
        dynamics = {"dynamicsShape": "sinusoidal", "dynamicsDimension": "time", "value": LANE_CHANGE}
        lane = element("AbsoluteTargetLane", {"value": str(self._board.lanes[name])})
        return element(
            "LaneChangeAction",
            {},
            element("LaneChangeActionDynamics", dynamics),
            element("LaneChangeTarget", {}, lane),
        )

    def _drives(self, phase: Phase) -> Xml.Element:
        throttle, brake = Number(self._limits.throttle), Number(self._limits.brake)
        match phase.primitive:
            case "Halt":
                return _speed(Number(0.0), "linear", "rate", brake)
            case "BrakeOnPath":
                return _speed(Number(0.0), "linear", "rate", _share(self._limits.brake, phase.argument("brake")))
            case "ThrottleOnPath":
                top = phase.argument("top")
                assert top is not None
                return _speed(top, "linear", "rate", _share(self._limits.throttle, phase.argument("throttle")))
            case "PaceOnPath":
                return self._keeps(phase)
            case "KeepStation":
                dynamics = {"dynamicsShape": "linear", "dynamicsDimension": "rate", "value": spelled(throttle)}
                beside = {"entityRef": "ego", "value": 0.0, "speedTargetValueType": "delta", "continuous": True}
                return element(
                    "SpeedAction",
                    {},
                    element("SpeedActionDynamics", dynamics),
                    element("SpeedActionTarget", {}, element("RelativeTargetSpeed", beside)),
                )
            case _:
                speed = phase.argument("speed")
                assert speed is not None
                return _speed(speed, "linear", "rate", throttle)

    def _keeps(self, phase: Phase) -> Xml.Element:
        """A distance along the road that it keeps to the ego, ahead of it or behind."""
        told, top = phase.argument("ahead"), phase.argument("top")
        ahead = sum_of(told) if told is not None else None
        assert ahead is not None
        assert top is not None
        leads = valued(ahead.expression, self._board.values) > 0
        limits = {
            "maxAcceleration": self._limits.throttle,
            "maxDeceleration": self._limits.brake,
            "maxSpeed": spelled(top),
        }
        kept = {
            "entityRef": "ego",
            "distance": spelled(ahead.times(1 if leads else -1).expression),
            "freespace": False,
            "continuous": True,
            "coordinateSystem": "road",
            "displacement": "leadingReferencedEntity" if leads else "trailingReferencedEntity",
        }
        return element("LongitudinalDistanceAction", kept, element("DynamicConstraints", limits))

    def _trigger(self, index: int, end: Until | After | None) -> Iterator[Xml.Element]:
        """Groups of conditions, of which one must hold."""
        if index == 0:
            yield after(0.0, f"{self._actor.name} begins", "greaterOrEqual")
        elif isinstance(end, After):
            yield element("ConditionGroup", {}, self._its_turn(index, spelled(end.seconds)))
        elif isinstance(end, Until):
            condition = end.condition
            groups = condition.terms if isinstance(condition, Boolean) and condition.operator == "or" else (condition,)
            for group in groups:
                terms = group.terms if isinstance(group, Boolean) else (group,)
                conditions = [self._ended(f"{self._actor.name} {index}", term, index) for term in terms]
                yield element("ConditionGroup", {}, self._its_turn(index, 0), *conditions)

    def _its_turn(self, index: int, delay: str | float) -> Xml.Element:
        asked = {"variableRef": _variable(self._actor), "rule": "equalTo", "value": index - 1}
        name = f"{self._actor.name} is in phase {index - 1}"
        by_value = element("ByValueCondition", {}, element("VariableCondition", asked))
        return element("Condition", {"name": name, "delay": delay, "conditionEdge": "none"}, by_value)

    def _ended(self, name: str, term: Expression, index: int) -> Xml.Element:
        """A condition by which a phase ends."""
        match term:
            case Comparison(Call("abs", (Call("offsetFrom", (Name(line), _)),)), _) if line in self._board.lanes:
                asked = {
                    "storyboardElementType": "action",
                    "storyboardElementRef": f"{self._actor.name} phase {index - 1}: way",
                    "state": "completeState",
                }
                what = element("StoryboardElementStateCondition", asked)
                named = {"name": f"{name}: the change is over", "delay": 0, "conditionEdge": "none"}
                return element("Condition", named, element("ByValueCondition", {}, what))
            case _:
                return self._condition(name, term)

    def _condition(self, name: str, condition: Expression) -> Xml.Element:
        assert isinstance(condition, Comparison)
        ((relation, bound),) = condition.links
        rule, own = RULES[relation], self._actor.name
        value = "" if isinstance(bound, Arithmetic) and _is_speed(bound) else spelled(bound)
        match condition.first:
            case Call("secondsTo", (_, _, place)):
                who, what = "ego", self._soon(place, rule, value)
            case Call("headway"):
                assert isinstance(bound, Arithmetic)
                alike = {"freespace": False, "coordinateSystem": "road", "relativeDistanceType": "longitudinal"}
                asked = {"entityRef": own, "rule": rule, "value": spelled(bound.left), **alike}
                who, what = "ego", element("TimeHeadwayCondition", asked)
            case Call("speed", (Name("ego"),)):
                who, what = "ego", element("SpeedCondition", {"rule": rule, "value": value})
            case Call("progress", (_, Name("ego"))):
                who, what = "ego", element("TraveledDistanceCondition", {"value": value})
            case Arithmetic("-", Call("progress"), _):
                who, what = own, element("TraveledDistanceCondition", {"value": value})
            case Call("gap") if isinstance(bound, Arithmetic) and _is_closing(bound.left):
                target = element("TimeToCollisionConditionTarget", {}, element("EntityRef", {"entityRef": "ego"}))
                apart = {"relativeDistanceType": "euclidianDistance", "coordinateSystem": "entity"}
                asked = {"freespace": False, "rule": rule, "value": spelled(bound.right), **apart}
                who, what = own, element("TimeToCollisionCondition", asked, target)
            case Call("gap"):
                who, what = own, _apart("euclidianDistance", rule, value)
            case Call("abs", (Call("headway"),)):
                who, what = own, _apart("longitudinal", rule, value, "road")
            case Call("abs", (Call("offsetFrom"),)):
                who, what = own, _apart("lateral", rule, value, "road")
            case _:
                who, what = own, element("SpeedCondition", {"rule": rule, "value": value})
        named = {"name": f"{name}: {what.tag}", "delay": 0, "conditionEdge": "none"}
        triggering = element(
            "TriggeringEntities", {"triggeringEntitiesRule": "any"}, element("EntityRef", {"entityRef": who})
        )
        by_entity = element("ByEntityCondition", {}, triggering, element("EntityCondition", {}, what))
        return element("Condition", named, by_entity)

    def _soon(self, place: Expression, rule: str, value: str | float) -> Xml.Element:
        """That the ego, as fast as it then is, needs some seconds to a place on its route."""
        along = sum_of(place)
        assert along is not None
        there = (along + number(-self._ego_axle)).expression
        line = element("TrajectoryRef", {}, _trajectory(EGO_ROUTE, self._board.lines[EGO_ROUTE]))
        position = element("Position", {}, element("TrajectoryPosition", {"s": spelled(there), "t": 0.0}, line))
        asked = {
            "freespace": False,
            "rule": rule,
            "value": value,
            "relativeDistanceType": "longitudinal",
            "coordinateSystem": "road",
            "routingAlgorithm": "assignedRoute",
        }
        return element("TimeToCollisionCondition", asked, element("TimeToCollisionConditionTarget", {}, position))


def _is_speed(bound: Expression) -> bool:
    """Whether a bound hangs on speeds, and so is a time."""
    return any(isinstance(part, Call) and part.function == "speed" for part in walk(bound))


def _is_closing(speeds: Expression) -> bool:
    """Whether speeds are added, as of two who come toward each other."""
    return isinstance(speeds, Arithmetic) and speeds.operator == "+" and _is_speed(speeds)


def _apart(kind: str, rule: str, value: str | float, system: str = "entity") -> Xml.Element:
    """How far somebody's origin is from the ego's."""
    asked = {
        "entityRef": "ego",
        "relativeDistanceType": kind,
        "coordinateSystem": system,
        "freespace": False,
        "rule": rule,
        "value": value,
    }
    return element("RelativeDistanceCondition", asked)


def _share(limit: float, share: Expression | None) -> Expression:
    """A part of what a body can do [m/s²]."""
    of = sum_of(share) if share is not None else None
    assert of is not None
    return product(number(limit), of).expression


def _following(trajectory: Xml.Element, offset: str | float) -> Xml.Element:
    return element(
        "FollowTrajectoryAction",
        {"initialDistanceOffset": offset},
        element("TimeReference", {}, element("None")),
        element("TrajectoryFollowingMode", {"followingMode": "position"}),
        element("TrajectoryRef", {}, trajectory),
    )
