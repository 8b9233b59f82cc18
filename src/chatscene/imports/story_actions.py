"""The actions of OpenSCENARIO as those of a story (`chatscene.world.story.pace` and `ways`)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from itertools import accumulate, pairwise
from typing import Any

from chatscene.imports.cast import Cast, text_or_number, told_number
from chatscene.imports.environment import NO_MONITORS
from chatscene.imports.given import Refused
from chatscene.imports.opening import LEFT_ALONE
from chatscene.imports.shapes import MOST_TIMES, Shape, thinned_faces, thinned_in_time
from chatscene.imports.stranger_xml import Element
from chatscene.imports.written_story import Told
from chatscene.world.story.pace import NO_TIME, UNBOUND

_NOTHING: Told = ("nothing",)
_TIMES = frozenset(["time", "timeStart", "timeEnd", "startTime", "stopTime"])
_SHAPES = frozenset(["linear", "cubic", "sinusoidal", "step"])


class StoryActions:
    """Reads actions."""

    def __init__(self, cast: Cast) -> None:
        self._cast, self._given = cast, cast.given

    # Of the world

    def of_world(self, action: Element) -> Told:
        """What a GlobalAction does."""
        inner = action.inside[0] if action.inside else action
        g = self._given
        match inner.tag:
            case "EntityAction":
                whom = self._cast.who(inner)
                if inner.find("DeleteEntityAction") is not None:
                    return ("away", whom)
                position = inner.find("AddEntityAction", "Position")
                if position is None:
                    raise Refused(inner, "it neither adds nor deletes")
                return ("come", whom, self._cast.place(position))
            case "ParameterAction" | "VariableAction":
                return self._sets(inner, g.text(inner, f"{inner.tag[:-6].lower()}Ref"))
            case "EnvironmentAction":
                g.note(inner, "light and weather stay as they are in Init")
                return _NOTHING
            case "SetMonitorAction":
                g.note(inner, NO_MONITORS)
                return _NOTHING
            case _:
                raise Refused(inner, "the world does not change so meanwhile here; leave it out")

    def _sets(self, inner: Element, name: str) -> Told:
        if (to := inner.find("SetAction")) is not None:
            return ("set", self._cast.called.of(name), text_or_number(self._given.text(to, "value")))
        for tag, word in (("AddValue", "add"), ("MultiplyByValue", "multiply")):
            if (by := inner.find("ModifyAction", "Rule", tag)) is not None:
                if isinstance(self._cast.at_first(by, name), str) or name in self._cast.texts:
                    raise Refused(by, f"{name[:40]!r} is not a number all along; declare it as one, or write SetAction")
                return (word, self._cast.called.of(name), self._cast.value(by, "value"))
        raise Refused(inner, "it sets nothing")

    # Of a road user

    def of(self, name: str | None, action: Element, *, at_first: bool = False) -> Told:  # noqa: C901, PLR0911, PLR0912
        """What a PrivateAction has somebody do."""
        inner = action.inside[0] if action.inside else action
        match (action.tag, inner.tag):
            case (_, "SpeedAction"):
                return self._speed(inner)
            case (_, "LongitudinalDistanceAction"):
                return self._distance(inner)
            case (_, "SpeedProfileAction"):
                return self._profile(inner)
            case (_, "LaneChangeAction"):
                return self._lane(inner)
            case (_, "LaneOffsetAction"):
                return self._aside(inner)
            case (_, "LateralDistanceAction"):
                return self._beside(inner)
            case ("SynchronizeAction", _):
                return self._meets(action)
            case ("TeleportAction", "Position"):
                return ("jump", self._cast.place(inner))
            case (_, "FollowTrajectoryAction"):
                return self._follows(inner, None if at_first else name)
            case (_, "AssignRouteAction" | "AcquirePositionAction"):
                return self._way(inner, name)
            case ("ControllerAction", _):
                return self._controlled(action)
            case (tag, _) if tag in LEFT_ALONE:
                self._given.note(action, LEFT_ALONE[tag])
                return _NOTHING
            case _:
                raise Refused(
                    inner, "this is not supported here; write speeds, lane changes, distances and trajectories"
                )

    def _controlled(self, action: Element) -> Told:
        if any(self._given.flag(one, "active") for one in action.walk() if "active" in one.attributes):
            raise Refused(action, "it takes over pedals or the wheel; write speeds and lane changes")
        self._given.note(action, LEFT_ALONE["ControllerAction"])
        return _NOTHING

    def _shape(self, one: Element | None, usual: str = "linear") -> str:
        shape = self._given.text(one, "dynamicsShape", usual) if one is not None else "step"
        if shape not in _SHAPES:
            raise Refused(one or Element("?", {}, 0), f"the shape {shape[:40]!r} is not known")
        return shape

    # Speeds

    def _speed(self, one: Element) -> Told:
        dynamics = one.find("SpeedActionDynamics")
        shape = self._shape(dynamics)
        dimension = self._given.text(dynamics, "dynamicsDimension", "time") if dynamics is not None else "time"
        amount = self._cast.value(dynamics, "value", "0") if dynamics is not None else 0.0
        if shape == "step" and not self._cast.mirrored:
            amount = 0.0
        elif shape == "step" and amount != 0.0 and dynamics is not None:
            self._given.note(
                dynamics,
                f"a step takes no time, but what follows waits for its {dimension}, as in ScenarioRunner",
            )
        return ("speed", shape, dimension, amount, self._target(one, "SpeedActionTarget", "TargetSpeed"))

    def _target(self, one: Element, within: str, what: str) -> Told:
        target = one.find(within)
        absolute = target.find(f"Absolute{what}") if target is not None else None
        relative = target.find(f"Relative{what}") if target is not None else None
        if absolute is not None:
            return ("to", self._cast.value(absolute, "value"))
        if relative is None:
            raise Refused(one, "it has no target")
        kind = self._given.text(relative, "speedTargetValueType", "delta")
        if kind not in ("delta", "factor"):
            raise Refused(relative, f"the type {kind[:40]!r} is not known")
        whom = self._cast.who(relative)
        return (kind, whom, self._cast.value(relative, "value"), self._given.flag(relative, "continuous"))

    def _distance(self, one: Element) -> Told:
        unit = "s" if "timeGap" in one.attributes else "m"
        side = self._given.text(one, "displacement", "any")
        limits = one.find("DynamicConstraints")
        told = {"leadingReferencedEntity": 1.0, "trailingReferencedEntity": -1.0}
        bounds = self._bounds(limits, "maxSpeed", "maxAcceleration", "maxDeceleration")
        amount = self._cast.value(one, "timeGap" if unit == "s" else "distance", "0")
        freespace, for_good = self._given.flag(one, "freespace"), self._given.flag(one, "continuous")
        return ("distance", self._cast.who(one), amount, unit, told.get(side, 0.0), freespace, for_good, bounds)

    def _bounds(self, limits: Element | None, *names: str) -> Told:
        """What bounds somebody, by the names of it; what is not told bounds nobody."""
        if limits is None:
            return (UNBOUND,) * len(names)
        for one in sorted(one for one in limits.attributes if one.endswith("Rate") and one not in names):
            self._given.note(limits, f"its {one} is left out; how fast an acceleration changes is not bounded here")
        return tuple(self._bound(limits, name) if name in limits.attributes else UNBOUND for name in names)

    def _bound(self, limits: Element, name: str) -> Any:
        """What bounds somebody, which may vary with parameters; nothing is bound by INF, or by what is not above 0."""
        varies = self._given.sum(limits, name) if limits.attributes[name].startswith("$") else None
        if varies is not None and varies.number is None:
            return told_number(varies)
        most = self._given.limit(limits, name)
        return most if 0.0 < most < UNBOUND else UNBOUND

    def _profile(self, one: Element) -> Told:
        bounds = self._bounds(one.find("DynamicConstraints"), "maxSpeed", "maxAcceleration", "maxDeceleration")
        whom = self._cast.who(one) if "entityRef" in one.attributes else ""
        entries = tuple(
            (self._cast.value(part, "time", str(NO_TIME)), self._cast.value(part, "speed"))
            for part in one.all("SpeedProfileEntry")
        )
        if not entries:
            raise Refused(one, "it has no entry")
        exactly = self._given.text(one, "followingMode", "follow") == "position"
        return ("profile", whom, entries, bounds, exactly)

    def _meets(self, one: Element) -> Told:
        master = one.find("TargetPositionMaster") or one.find("TargetPosition1")
        own = one.find("TargetPosition") or one.find("TargetPosition2")
        if master is None or own is None:
            raise Refused(one, "it names not both places")
        last, whom = one.find("FinalSpeed"), self._cast.who(one, "masterEntityRef")
        final: Told | None = None
        if last is not None and last.inside:
            steady = next((below for below in last.inside[0].inside), None)
            metres = self._cast.value(steady, "distance", "0") if steady is not None else 0.0
            seconds = self._cast.value(steady, "time", "0") if steady is not None else 0.0
            final = (self._final(last.inside[0], whom), metres, seconds)
        return ("meet", whom, self._cast.place(master), self._cast.place(own), final)

    def _final(self, one: Element, master: str) -> Told:
        if one.tag == "AbsoluteSpeed":
            return ("to", self._cast.value(one, "value"))
        kind = self._given.text(one, "speedTargetValueType", "delta")
        if kind not in ("delta", "factor"):
            raise Refused(one, f"the type {kind[:40]!r} is not known")
        return (kind, master, self._cast.value(one, "value"), True)

    # Ways

    def _lane(self, one: Element) -> Told:
        dynamics, target = one.find("LaneChangeActionDynamics"), one.find("LaneChangeTarget")
        absolute = target.find("AbsoluteTargetLane") if target is not None else None
        relative = target.find("RelativeTargetLane") if target is not None else None
        if absolute is not None:
            to: Told = ("to", self._given.number(absolute, "value"))
        elif relative is not None:
            to = ("of", self._cast.who(relative), self._given.number(relative, "value"))
        else:
            raise Refused(one, "it names no lane")
        dimension = self._given.text(dynamics, "dynamicsDimension", "time") if dynamics is not None else "time"
        amount = self._cast.value(dynamics, "value", "0") if dynamics is not None else 0.0
        left = self._cast.value(one, "targetLaneOffset", "0")
        return ("lane", self._shape(dynamics), dimension, amount, to, left)

    def _aside(self, one: Element) -> Told:
        dynamics, target = one.find("LaneOffsetActionDynamics"), one.find("LaneOffsetTarget")
        absolute = target.find("AbsoluteTargetLaneOffset") if target is not None else None
        relative = target.find("RelativeTargetLaneOffset") if target is not None else None
        most = self._given.number(dynamics, "maxLateralAcc", "0") if dynamics is not None else 0.0
        if absolute is not None:
            kind = "mine" if self._cast.mirrored else "to"
            to: Told = (kind, self._signed(absolute))
        elif relative is not None:
            to = ("of", self._cast.who(relative), self._signed(relative))
        else:
            raise Refused(one, "it names no offset")
        return ("aside", self._shape(dynamics, "sinusoidal"), most, to, self._given.flag(one, "continuous", "true"))

    def _signed(self, one: Element) -> Any:
        return told_number(self._given.sum(one, "value").times(self._cast.side))

    def _beside(self, one: Element) -> Told:
        told = {"leftToReferencedEntity": 1.0, "rightToReferencedEntity": -1.0}
        side = told.get(self._given.text(one, "displacement", "any"), 0.0)
        distance = self._cast.value(one, "distance", "0")
        freespace, for_good = self._given.flag(one, "freespace"), self._given.flag(one, "continuous")
        limits = one.find("DynamicConstraints")
        bounds = self._bounds(limits, "maxSpeed", "maxAcceleration", "maxAccelerationRate")
        return ("beside", self._cast.who(one), distance, side, freespace, for_good, *([bounds] if limits else []))

    def _follows(self, one: Element, name: str | None) -> Told:
        trajectory = one.find("TrajectoryRef", "Trajectory") or one.find("Trajectory")
        if trajectory is None:
            raise Refused(one, "its trajectory is not there")
        line, shape = self._cast.line(trajectory, name)
        start, length = self._given.number(one, "initialDistanceOffset", "0"), shape.line.length
        if not 0.0 <= start < length:
            raise Refused(one, f"its line is {length:.0f} m long, and {start:g} m is not on it")
        timing = one.find("TimeReference", "Timing")
        if timing is not None and shape.times is None:
            if any(part.attributes.keys() & _TIMES for part in trajectory.walk()):
                raise Refused(trajectory, "some of its times are missing; give a time wherever one may stand, or none")
            self._given.note(timing, "its line has no times; it is followed at the stated speed")
        if timing is None or shape.times is None:
            faces = _faces(shape, _gone(shape.points))
            return ("line", line, (), start, *((faces or (None,)) if shape.closed else faces), *[True] * shape.closed)
        scale, shift = self._given.number(timing, "scale", "1"), self._given.number(timing, "offset", "0")
        absolute = self._given.text(timing, "domainAbsoluteRelative", "relative") == "absolute"
        times = [time * scale + shift for time in shape.times]
        table, faces = tuple(zip(times, _gone(shape.points), strict=True)), _faces(shape, times)
        mode = one.find("TrajectoryFollowingMode") or one
        steadily = self._given.text(mode, "followingMode", "follow") == "follow"
        if steadily and len(table) > MOST_TIMES:
            self._given.note(one, f"its line has more than {MOST_TIMES} times; it is gone along evenly between them")
        if not steadily or len(table) > MOST_TIMES:
            return ("line", line, (absolute, _thinned(table)), start, *faces)
        return ("line", line, (absolute, table, True), start, *faces)

    def _way(self, one: Element, name: str | None) -> Told:
        if name is None:
            raise Refused(one, "it is of several road users; write one each")
        route = one.find("Route") or one
        line = self._cast.route_of(route, self._cast.positions.known_of(one, name))
        return ("way", self._cast.known(line))


def _faces(shape: Shape, passed: Sequence[float]) -> tuple[Told, ...]:
    """Which way somebody looks where on its line, or when, without what lies between two others evenly.

    None where that is not told.
    """
    if not shape.faces:
        return () if shape.faces is None else ((),)
    turned = shape.faces[0]
    table = [(passed[0], turned)]
    for at, face in zip(passed[1:], shape.faces[1:], strict=True):
        turned += math.remainder(face - turned, math.tau)
        table.append((at, turned))
    return (tuple((round(table[i][0], 3), round(table[i][1], 4)) for i in thinned_faces(table)),)


def _gone(points: tuple[tuple[float, float], ...]) -> list[float]:
    """How much of a line is behind somebody at each of its points [m]."""
    return [0.0, *accumulate(math.dist(a, b) for a, b in pairwise(points))]


def _thinned(table: tuple[tuple[float, float], ...]) -> tuple[tuple[float, float], ...]:
    """A table without what lies between two others evenly."""
    return tuple((round(table[i][0], 3), round(table[i][1], 3)) for i in thinned_in_time(table))
