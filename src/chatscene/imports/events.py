"""The events of an actor in OpenSCENARIO, as the phases of a plan."""

from __future__ import annotations

import math
import re
from dataclasses import replace

from chatscene.imports.conditions import Conditions
from chatscene.imports.given import Given, Refused
from chatscene.imports.player import AHEAD, STANDS, Done, Player, State
from chatscene.imports.stranger_xml import Element
from chatscene.maps.neighbours import number_beside
from chatscene.terms.plan import (
    After,
    Call,
    Comparison,
    Expression,
    Kind,
    Name,
    Number,
    Parameter,
    Phase,
    Plan,
    Range,
    Until,
    Value,
    walk,
)
from chatscene.terms.storyboard import OVER, START
from chatscene.terms.sums import Sum, number, quotient


def plan_of(player: Player, events: list[Element], given: Given, first: list[Element] | None = None) -> Plan:
    """The plan that events are.

    Raises:
        Refused: It is none.
    """
    return _Reader(player, given).plan(events, first or [])


class _Reader:
    def __init__(self, player: Player, given: Given) -> None:
        self._player, self._given = player, given
        self._state = State(way=player.way, speed=number(player.speed), left=number(player.beside))
        self._conditions = Conditions(player, given, self._state)

    def plan(self, events: list[Element], first: list[Element]) -> Plan:
        state = self._state
        for index, event in enumerate(events):
            count = event.attributes.get("maximumExecutionCount", "1")
            if self._given.text(event, "maximumExecutionCount", count) != "1":
                raise Refused(event, "it happens more than once; a plan goes through its phases once")
            end = self._conditions.ends(event, events[index - 1] if index else None, first if index == 0 else [])
            if end is not None:
                self._wait(event, end)
            elif index:
                state.phases.pop()  # it is over as it begins
            self._does(event)
        if not state.phases:
            raise Refused(events[0] if events else Element("Maneuver", {}, 0), "nothing is done in it")
        if state.measured:
            way = Name(self._player.measured_on, Kind.PATH)
            begins = Value(START, Call("progress", (way, Name("self", Kind.ACTOR))))
            state.phases[0] = replace(state.phases[0], values=(begins,))
        read = {
            p.name for phase in state.phases for e in _expressions(phase) for p in walk(e) if isinstance(p, Parameter)
        }
        ranges = sorted((r for r in self._given.ranges.values() if r.name in read), key=lambda r: r.name)
        return Plan(phases=tuple(state.phases), parameters=tuple(Range(r.name, r.low, r.high) for r in ranges))

    def _wait(self, event: Element, ends: list[After | Until]) -> None:
        """Let what is done now be done until something, and then, if there is more, until that."""
        state = self._state
        if not state.phases:
            state.phases.append(self._phase(event, None))
        for index, end in enumerate(ends):
            if index:
                state.phases.append(replace(state.phases[-1], end=None, values=()))
            state.phases[-1] = replace(state.phases[-1], end=end)

    def _other(self, one: Element) -> str:
        return self._given.text(one, "entityRef")

    def _does(self, event: Element) -> None:  # noqa: C901
        actions = [action.inside[0] for action in event.all("Action") if len(action.inside) == 1]
        speed, way = None, None
        for action in actions:
            if action.tag == "GlobalAction":
                if action.find("VariableAction", "SetAction") is None:
                    raise Refused(action.inside[0] if action.inside else action, "the world does not change meanwhile")
                continue
            if action.tag != "PrivateAction" or len(action.inside) != 1 or not action.inside[0].inside:
                raise Refused(action, "it is not an action of a road user")
            (kind,) = action.inside
            if kind.tag == "LongitudinalAction" and speed is None:
                speed = kind.inside[0]
            elif kind.tag in ("LateralAction", "RoutingAction") and way is None:
                way = kind.inside[0]
            else:
                raise Refused(kind, "this is not supported here; write speeds, lane changes and trajectories")
        if way is not None:
            self._turns_to(way)
            self._state.turned = self._way_done(way)
        if speed is not None:
            self._state.phases.append(self._phase(event, speed, way))
        elif way is not None:
            self._state.phases.append(self._phase(event, None, way))
        else:
            raise Refused(event, "nothing is done in it")
        if way is not None and speed is None:
            self._state.done = self._state.turned

    def _way_done(self, way: Element) -> Done:
        own, name = Name("self", Kind.ACTOR), self._state.way
        if name in (None, AHEAD):
            return Done()
        line = Name(str(name), Kind.PATH)
        if way.tag == "LaneChangeAction":
            beside = Call("abs", (Call("offsetFrom", (line, own)),))
            return Done(Until(Comparison(beside, (("<", Number(OVER)),))))
        if way.tag == "FollowTrajectoryAction":
            end = Number(round(self._player.lines[str(name)].length, 2))
            return Done(Until(Comparison(Call("distanceLeft", (line, own, end)), (("<", Number(1.0)),))))
        return Done()

    def _turns_to(self, way: Element) -> None:
        """Take another way."""
        state, player = self._state, self._player
        state.left = number(0.0)
        match way.tag:
            case "FollowTrajectoryAction":
                self._follows(way)
            case "LaneChangeAction":
                if self._given.number(way, "targetLaneOffset", "0"):
                    raise Refused(way, "it changes to a line beside a lane; leave out targetLaneOffset")
                if player.walks:
                    raise Refused(way, "pedestrians do not change lanes")
                lane = self._target_lane(way)
                line = player.lane(way, lane)
                name = f"{player.prefix}Way{len(self._own_lines()) + 1 if self._own_lines() else ''}"
                player.lines[name], player.lanes[name] = line, lane
                state.way = name
                dynamics = way.find("LaneChangeActionDynamics")
                self._given.note(dynamics or way, "a lane change takes as long as a driver takes who follows the lane")
            case "LaneOffsetAction":
                target = way.find("LaneOffsetTarget", "AbsoluteTargetLaneOffset")
                if target is None or player.walks:
                    raise Refused(way, "it keeps beside somebody; write an AbsoluteTargetLaneOffset of a vehicle")
                state.left = self._given.sum(target, "value").times(player.left if player.side > 0 else -1)
            case _:
                raise Refused(
                    way, "this is not supported here; write LaneChangeAction or an untimed FollowTrajectoryAction"
                )

    def _own_lines(self) -> list[str]:
        return [name for name in self._player.lines if re.fullmatch(rf"{self._player.prefix}Way\d*", name)]

    def _target_lane(self, way: Element) -> int:
        absolute, relative = (
            way.find("LaneChangeTarget", "AbsoluteTargetLane"),
            way.find("LaneChangeTarget", "RelativeTargetLane"),
        )
        if absolute is not None:
            return round(self._given.number(absolute, "value"))
        if relative is None:
            raise Refused(way, "it names no lane")
        of = self._player.lane_from(relative, self._given.text(relative, "entityRef"))
        return number_beside(of.number, of.left * round(self._given.number(relative, "value")))

    def _follows(self, way: Element) -> None:
        state, player = self._state, self._player
        if way.find("TimeReference", "Timing") is not None:
            raise Refused(
                way, "its vertices have times, and a plan has speeds; write TimeReference None and SpeedActions"
            )
        trajectory = way.find("TrajectoryRef", "Trajectory") or way.find("Trajectory")
        if trajectory is None:
            raise Refused(way, "its trajectory is not there")
        positions = [one for vertex in trajectory.walk() if vertex.tag == "Vertex" for one in vertex.all("Position")]
        relative = [one.inside[0] for one in positions if one.find("RelativeObjectPosition") is not None]
        if relative:
            if len(relative) != 2 or len(positions) != 2 or any(self._other(one) != player.name for one in relative):
                raise Refused(trajectory, "relative to the actor itself, only a straight line can be given")
            dx, dy = self._given.number(relative[1], "dx"), player.side * self._given.number(relative[1], "dy", "0")
            state.way, state.turn = AHEAD, round(math.atan2(dy, dx), 6)
            return
        if player.walks:
            raise Refused(trajectory, "pedestrians do not follow a line; write two RelativeObjectPositions of itself")
        name, line = player.line_of(trajectory, player.prefix)
        stood = state.way == AHEAD and all(phase.primitive == "Halt" for phase in state.phases)
        if state.phases and state.way not in (None, name) and not stood:
            raise Refused(trajectory, "it comes to another line while it drives; write a LaneChangeAction")
        if self._given.sum(way, "initialDistanceOffset", "0").number != 0:
            self._given.note(way, "it follows its line from its position; the given distance is ignored")
        player.lines.setdefault(name, line)
        state.way = name

    def _phase(self, event: Element, speed: Element | None, way: Element | None = None) -> Phase:  # noqa: C901, PLR0911
        """What is done with the way and the speed that hold now."""
        state = self._state
        before, turn = state.speed, state.turn
        state.turn = 0.0
        share: Sum | None = None
        if speed is None:
            if way is None and before.number == 0:
                return Phase("Halt", ())
        else:
            if speed.tag != "SpeedAction":
                return self._keeps_distance(speed)
            relative = speed.find("SpeedActionTarget", "RelativeTargetSpeed")
            if relative is not None:
                return self._keeps(relative)
            target = speed.find("SpeedActionTarget", "AbsoluteTargetSpeed")
            if target is None:
                raise Refused(speed, "it has no target")
            state.speed = self._given.sum(target, "value")
            share = self._pace(speed, before)
        if self._given.least(state.speed) < 0:
            raise Refused(speed or event, "it drives backwards, and its steering is not given")
        stops = state.speed.number == 0
        if state.way in (None, AHEAD):
            if stops:
                return Phase("Halt", ())
            return Phase("MoveAhead", (state.speed.expression, *([Number(turn)] if turn else [])))
        path = Name(str(state.way), Kind.PATH)
        beside = () if state.left.number == 0 else (state.left.expression,)
        if stops:
            return Phase("BrakeOnPath", (path, (share or number(1.0)).expression, *beside))
        if share is not None and share.number != 1:
            return Phase(
                "ThrottleOnPath", (path, share.expression, beside[0] if beside else Number(0), state.speed.expression)
            )
        return Phase("DrivePath", (path, state.speed.expression, *beside))

    def _keeps(self, relative: Element) -> Phase:
        g, state = self._given, self._state
        same = g.text(relative, "speedTargetValueType") == "delta" and g.number(relative, "value") == 0
        if self._other(relative) != self._player.ego or not same or not g.flag(relative, "continuous"):
            raise Refused(
                relative, "of relative speeds only that of the ego is kept, continuously and with a delta of 0"
            )
        if state.way in (None, AHEAD):
            raise Refused(relative, "it keeps its station along no line; write a trajectory or put it in a lane")
        state.done = Done()
        return Phase("KeepStation", (Name(str(state.way), Kind.PATH), Name("ego", Kind.ACTOR)))

    def _keeps_distance(self, action: Element) -> Phase:
        """It keeps a distance along the road to the ego, centre from centre."""
        g, state = self._given, self._state
        if action.tag == "SpeedProfileAction":
            raise Refused(action, "a profile of speeds is not read; write a SpeedAction for each of its entries")
        if action.tag != "LongitudinalDistanceAction":
            raise Refused(action, "it is not read; write SpeedActions")
        side = {"leadingReferencedEntity": 1, "trailingReferencedEntity": -1}.get(g.text(action, "displacement", ""))
        limits = action.find("DynamicConstraints")
        if self._other(action) != self._player.ego or side is None or not g.flag(action, "continuous"):
            raise Refused(action, "of distances only that to the ego is kept, continuously, ahead of it or behind")
        if g.flag(action, "freespace") or "distance" not in action.attributes:
            raise Refused(action, 'it keeps no distance of origins; write distance and freespace="false"')
        if state.way in (None, AHEAD) or limits is None or "maxSpeed" not in limits.attributes:
            raise Refused(action, "it needs a trajectory or a lane to keep its distance along, and a maxSpeed")
        state.done = Done()
        path, ego = Name(str(state.way), Kind.PATH), Name("ego", Kind.ACTOR)
        ahead, top = g.sum(action, "distance").times(side), g.sum(limits, "maxSpeed")
        return Phase("PaceOnPath", (path, ego, ahead.expression, top.expression))

    def _pace(self, action: Element, before: Sum) -> Sum | None:
        """The share of throttle or brake with which a speed changes; None where a driver sees to it."""
        state, dynamics = self._state, action.find("SpeedActionDynamics")
        if dynamics is None:
            raise Refused(action, "it does not say how fast the speed changes")
        shape, dimension = self._given.text(dynamics, "dynamicsShape"), self._given.text(dynamics, "dynamicsDimension")
        value, stops = self._given.sum(dynamics, "value"), state.speed.number == 0
        most = self._player.limits.brake if stops else self._player.limits.throttle
        state.done = self._reached(before)
        if shape == "step":
            state.done = self._stepped(dimension, value)
            if state.done.end is not None:
                self._given.note(
                    dynamics,
                    f"a step takes no time, but what follows waits as if its {dimension} were "
                    "how long it lasts, as ScenarioRunner reads it",
                )
            return None
        change, started = state.speed + before.times(-1), before + state.speed
        if not stops and self._given.least(change) < 0:
            self._given.note(dynamics, "it slows down as a driver does, at a pace of its own")
            return None
        if not stops:
            self._given.note(dynamics, "the pedal is held that gives this pace at rest; drag makes it less at speed")
        if dimension == "rate":
            return self._limited(dynamics, quotient(value, number(most)))
        if change.number is None or value.number is None or started.number is None:
            raise Refused(dynamics, 'how hard it is, hangs on a parameter; write dynamicsDimension="rate"')
        if value.number <= 0 or not change.number:
            return None
        rate = abs(change.number) / value.number
        if dimension == "distance":
            rate = abs(change.number) * started.number / (2 * value.number)
        return self._limited(dynamics, number(rate / most))

    def _limited(self, dynamics: Element, share: Sum) -> Sum:
        if share.number is not None and share.number > 1:
            self._given.note(dynamics, "it is harder than the vehicle can; it does what it can")
            return number(1.0)
        return share

    def _reached(self, before: Sum) -> Done:
        """When a speed is reached."""
        now, then, own = self._state.speed.number, before.number, Call("speed", (Name("self", Kind.ACTOR),))
        if now == 0:
            return Done(Until(Comparison(own, (("<", Number(STANDS)),))))
        if now is None or then is None or now == then:
            return Done()
        near = Number(round(now - 0.1 if now > then else now + 0.1, 6))
        return Done(Until(Comparison(own, ((">=" if now > then else "<=", near),))))

    def _stepped(self, dimension: str, value: Sum) -> Done:
        if value.number == 0:
            return Done()
        if dimension == "time":
            return Done(After(value.expression))
        if dimension == "distance" and self._state.speed.number != 0:
            return Done(After(quotient(value, self._state.speed).expression))
        return Done()


def _expressions(phase: Phase) -> list[Expression]:
    end = phase.end
    return [*phase.arguments, *([] if end is None else [end.condition if isinstance(end, Until) else end.seconds])]
