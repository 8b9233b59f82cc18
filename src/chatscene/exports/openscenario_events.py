"""What an actor does, as events of OpenSCENARIO: each phase is one, and the end of that before it is its trigger."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from xml.etree import ElementTree as Xml

from chatscene.exports.bodies import wheelbase_of
from chatscene.exports.openscenario import actors_of, after
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


def variable(actor: Actor) -> str:
    """The variable that says in which phase somebody is."""
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


def world(x: float, y: float) -> Xml.Element:
    """A place of the map [m]."""
    return element("WorldPosition", {"x": x, "y": y})


def private(tag: str, *inside: Xml.Element) -> Xml.Element:
    """An action of one body."""
    return element("PrivateAction", {}, element(tag, {}, *inside))


def trajectory(name: str, line: Polyline) -> Xml.Element:
    """A line to follow, without times."""
    vertices = [element("Vertex", {"time": 0}, element("Position", {}, world(x, y))) for x, y in line.points.tolist()]
    shape = element("Shape", {}, element("Polyline", {}, *vertices))
    return element("Trajectory", {"name": name, "closed": False}, shape)


def speed_action(target: Expression, shape: str, dimension: str, value: Expression) -> Xml.Element:
    """A change to a speed [m/s]."""
    dynamics = {"dynamicsShape": shape, "dynamicsDimension": dimension, "value": spelled(value)}
    return element(
        "SpeedAction",
        {},
        element("SpeedActionDynamics", dynamics),
        element("SpeedActionTarget", {}, element("AbsoluteTargetSpeed", {"value": spelled(target)})),
    )


def behind(start: Start, back: float) -> tuple[Expression, Expression]:
    """Where on its line, along and to the left, the point is that lies so far [m] behind somebody's centre."""
    along, left = sum_of(start.along), sum_of(start.left)
    assert along is not None
    assert left is not None
    shifted = along + number(-back * math.cos(start.turn)), left + number(-back * math.sin(start.turn))
    return shifted[0].expression, shifted[1].expression


class Events:
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
            counts = element("VariableAction", {"variableRef": variable(self._actor)}, counted)
            actions.append(element("Action", {"name": f"{name}: it is"}, element("GlobalAction", {}, counts)))
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
                yield "way", private("RoutingAction", self._ahead(float(angle)))
        else:
            path = phase.argument("path")
            assert isinstance(path, Name)
            if path.id != self._way:
                change = self._way not in (None, "ahead")  # else it stood so far
                self._way = path.id
                if change:
                    yield "way", private("LateralAction", self._changes(path.id))
                else:
                    yield "way", private("RoutingAction", self._follows(path.id))
        yield "speed", private("LongitudinalAction", self._drives(phase))

    def _follows(self, name: str) -> Xml.Element:
        along, _ = behind(self._actor.start, self._axle)
        return _following(trajectory(name, self._board.lines[name]), spelled(along))

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
                return speed_action(Number(0.0), "linear", "rate", brake)
            case "BrakeOnPath":
                return speed_action(Number(0.0), "linear", "rate", _share(self._limits.brake, phase.argument("brake")))
            case "ThrottleOnPath":
                top = phase.argument("top")
                assert top is not None
                return speed_action(top, "linear", "rate", _share(self._limits.throttle, phase.argument("throttle")))
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
                return speed_action(speed, "linear", "rate", throttle)

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
        asked = {"variableRef": variable(self._actor), "rule": "equalTo", "value": index - 1}
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
        line = element("TrajectoryRef", {}, trajectory(EGO_ROUTE, self._board.lines[EGO_ROUTE]))
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
