"""Who is where at first in a scenario of OpenSCENARIO XML: bodies, places, speeds, and the ego's route."""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any, TypeVar

from chatscene.errors import no_such
from chatscene.imports.entities import Entities
from chatscene.imports.given import Given, Refused
from chatscene.imports.positions import Pose, Positions
from chatscene.imports.shapes import line_through, shape_of
from chatscene.imports.stranger_xml import Element
from chatscene.maps.lane_curves import middle_line
from chatscene.maps.onward import LENGTH, SHORTEST
from chatscene.terms.actors import BY_CLASS, LIMITS, REVERSE_SPEED, Manner
from chatscene.terms.polyline import Polyline
from chatscene.terms.storyboard import EGO_ROUTE, Actor, Start
from chatscene.terms.sums import number, valued
from chatscene.world.places import headingLine, laneLine

_T = TypeVar("_T")

OFF = 3.0  # [m] from a place to the ego's route, beyond which the place is not on it
GONE = re.compile(r"[^A-Za-z0-9_]")
_TURNED = 0.01  # [rad] away from a line, within which somebody faces along it
_DRIVES = 30.0  # [s] that the ego's route is long enough for at its first speed
_BACKS = 60.0  # [m] that an ego drives backwards
_LINKS = 6  # lanes between two waypoints of a route
_DENSE = 2.0  # [m] between points of the ego's route where it is looked for lanes
LEFT_ALONE = {
    "ControllerAction": "controllers are not taken; everybody drives as its plan says",
    "ActivateControllerAction": "controllers are not taken; everybody drives as its plan says",
    "VisibilityAction": "everybody is visible",
    "AppearanceAction": "lamps and looks are not shown",
}
COMMAND = "a command to another program is left out"
EGO_DOES = "what the ego does is left to the ego under test"


class Opening:
    """Reads who is where at first."""

    def __init__(self, root: Element, given: Given, map_path: Path, ego: str | None) -> None:
        self._root, self._given, self._map_path = root, given, map_path
        header = root.find("FileHeader")
        mirrored = header is not None and header.attributes.get("description", "").startswith("CARLA:")
        if header and mirrored:
            given.note(
                header,
                "its description begins with CARLA:, so y, t and headings count to the right, and "
                "offsets to the right of who drives, as ScenarioRunner reads it",
            )
        self._positions = Positions(given, map_path, mirrored=mirrored)
        self._side = -1 if mirrored else 1
        self._entities = Entities(root, given, ego)
        self._objects = self._entities.objects
        self._lines: dict[str, Polyline] = {}
        self._lanes: dict[str, int] = {}
        self._inits: dict[str, list[Element]] = {}
        for one in self._actions().all("Private"):
            for name in self._meant(one):
                told = self._inits.setdefault(name, [])
                told += [action for p in one.inside for action in p.inside]
        for one in self._actions().all("UserDefinedAction"):
            given.note(one, COMMAND)
        self._added()

    def _meant(self, one: Element) -> tuple[str, ...]:
        """The names of those whom an element of Init is about: somebody, or all of a selection; nobody if refused."""
        name = self._given.text(one, "entityRef")
        if name in self._objects or name in self._entities.groups:
            return self._entities.groups.get(name, (name,))
        self._given.refusals.append(str(Refused(one, no_such("entity", name[:40], self._objects))))
        return ()

    def _attempt(self, does: Callable[[], _T]) -> _T | None:
        """What something gives; None where it is refused, which is noted."""
        try:
            return does()
        except Refused as reason:
            self._given.refusals.append(str(reason))
            return None

    def _added(self) -> None:
        """Take whoever is added in Init as placed there, and nobody as there who is taken away in Init."""
        for one in self._actions().all("GlobalAction"):
            entity = one.find("EntityAction")
            if entity is None:
                continue
            add = entity.find("AddEntityAction")
            for name in self._meant(entity):
                if add is not None:
                    self._inits.setdefault(name, []).insert(0, replace(add, tag="TeleportAction"))
                elif entity.find("DeleteEntityAction") is not None:
                    self._objects.pop(name, None)
                    self._given.note(entity, f"{name[:40]} is deleted in Init, so it is not there")

    def setting(self) -> Iterator[Element]:
        """The actions of Init that set parameters or variables."""
        tags = ("ParameterAction", "VariableAction")
        return (one for one in self._actions().all("GlobalAction") if one.inside and one.inside[0].tag in tags)

    def _actions(self) -> Element:
        return self._root.find("Storyboard", "Init", "Actions") or Element("Actions", {}, self._root.line)

    def _place(self, name: str, one: Element, ahead: float) -> Pose | Start:
        """Where somebody's centre is at first."""
        position = self._placed_first(name)
        on_line = position.find("TrajectoryPosition") if position is not None else None
        if on_line is not None:
            return self._along(on_line, ahead)
        x, y, heading = self._origin(name, one)
        self._positions.known[name] = (x, y, heading)
        return x + ahead * math.cos(heading), y + ahead * math.sin(heading), heading

    def _placed_first(self, name: str) -> Element | None:
        """The element that says where somebody is at first: a Position, or a trajectory that it follows."""
        inits = self._inits.get(name, [])
        for action in inits:
            if action.tag == "TeleportAction" and (position := action.find("Position")) is not None:
                return position
        return next((found for action in inits if (found := action.find("FollowTrajectoryAction")) is not None), None)

    def _puts_first(self, name: str, action: Element) -> bool:
        """Whether somebody has its first place by a TeleportAction; by another one, it is put elsewhere at once."""
        return action.find("Position") is self._placed_first(name)

    def _origin(self, name: str, one: Element) -> Pose:
        """Where somebody's origin is at first."""
        place = self._placed_first(name)
        if place is None:
            raise Refused(one, "its first position is not given; add a TeleportAction in Init")
        if place.tag == "Position":
            return self._positions.pose(place)
        line = self._followed(place)
        along = self._given.number(place, "initialDistanceOffset", "0")
        if not 0.0 <= along <= line.length:
            raise Refused(place, f"its line is {line.length:.0f} m long, and {along:g} m is not on it")
        return *line.point_at(along), line.heading_at(along)

    def _followed(self, follows: Element) -> Polyline:
        """The line that somebody follows from the beginning on."""
        trajectory = follows.find("TrajectoryRef", "Trajectory") or follows.find("Trajectory")
        if trajectory is None:
            raise Refused(follows, "its trajectory is not there")
        return shape_of(trajectory, self._given, self._positions.pose).line

    def _along(self, one: Element, ahead: float) -> Start:
        trajectory, turned = one.find("TrajectoryRef", "Trajectory"), one.find("Orientation")
        if trajectory is None:
            raise Refused(one, "its trajectory is not there")
        if turned is not None and turned.attributes.get("type") != "relative":
            raise Refused(turned, 'on a line it is turned beside the line; write type="relative"')
        turn = self._side * self._given.number(turned, "h", "0") if turned else 0.0
        name, _ = self._line_of(trajectory, "")
        along = self._given.sum(one, "s") + number(ahead * math.cos(turn))
        left = self._given.sum(one, "t", "0").times(self._side) + number(ahead * math.sin(turn))
        return Start(line=name, along=along.expression, left=left.expression, turn=round(turn, 6))

    def _line_of(self, trajectory: Element, prefix: str) -> tuple[str, Polyline]:
        """The line of a trajectory and what it is called: as in the file, if that is free or means the same."""
        if trajectory.find("Shape", "Polyline") is None:
            raise Refused(trajectory, "in a plan, a line is one of vertices; write a Polyline")
        if self._given.flag(trajectory, "closed"):
            raise Refused(trajectory, "in a plan, a line has an end; write closed as false")
        line = shape_of(trajectory, self._given, self._positions.pose).line
        name = GONE.sub("_", self._given.text(trajectory, "name", ""))
        usual = f"{prefix}Way"
        for known in (name, usual) if name.endswith("Way") or name == EGO_ROUTE else (usual,):
            if known not in self._lines or _alike(self._lines[known], line):
                self._lines.setdefault(known, line)
                return known, self._lines[known]
        raise Refused(trajectory, "it follows a second line")

    def _pose_of(self, start: Start) -> Pose:
        line, values = self._lines[start.line], self._given.nominal
        along, left = valued(start.along, values), valued(start.left, values)
        heading = line.heading_at(along)
        x, y = line.point_at(along)
        return x - left * math.sin(heading), y + left * math.cos(heading), heading + start.turn

    def _speed(self, name: str) -> float:
        """How fast somebody is at first [m/s]; 0 where nothing is told of it."""
        told = [action for action in self._inits.get(name, []) if action.tag == "LongitudinalAction"]
        for action in told:
            target = action.find("SpeedAction", "SpeedActionTarget", "AbsoluteTargetSpeed")
            if target is None or len(told) > 1:
                raise Refused(action, "in Init, a speed is one number; write one SpeedAction with AbsoluteTargetSpeed")
            dynamics = action.find("SpeedAction", "SpeedActionDynamics")
            shape = self._given.text(dynamics, "dynamicsShape", "step") if dynamics else "step"
            if shape != "step" and self._given.number(dynamics or action, "value", "0"):
                self._given.note(action, "in Init a speed is there at once, whatever its dynamics")
            value = self._given.number(target, "value")
            if value < -REVERSE_SPEED:
                raise Refused(action, f"a body backs at {REVERSE_SPEED:g} m/s at most where a plan drives it")
            return value
        return 0.0

    def _host(self, name: str) -> Actor:
        """The ego, and its route."""
        one = self._objects[name]
        kind, length, width, ahead = self._entities.body(one)
        if kind not in LIMITS or BY_CLASS[kind].row.manner is Manner.WALKS:
            raise Refused(one, "the ego is not a vehicle")
        place = self._place(name, one, ahead)
        if isinstance(place, Start):
            raise Refused(one, "the ego begins somewhere on a line; write a WorldPosition or a LanePosition")
        speed = self._speed(name)
        line = self._route(name, one, place, speed)
        self._lines = {EGO_ROUTE: line, **self._lines}
        for action in self._inits.get(name, []):
            if action.tag in LEFT_ALONE:
                self._given.note(action, LEFT_ALONE[action.tag])
            elif action.tag not in ("TeleportAction", "LongitudinalAction", "RoutingAction"):
                self._given.note(action, EGO_DOES)
        start = self._on_route(name, one, place, line)
        return Actor(name="ego", kind=kind, length=length, width=width, start=start, speed=speed)

    def _on_route(self, name: str, one: Element, place: Pose, line: Polyline) -> Start:
        """Where on its route the ego begins: as far beside it, and turned as much, as is written."""
        along, left, _ = line.project(*place[:2])
        turn = math.remainder(place[2] - line.heading_at(along), math.tau)
        if self._faces(name) is None:
            if abs(turn) > _TURNED:
                self._given.note(one, "the ego's heading is not given; it faces along its lane")
            turn = 0.0
        if abs(turn) > math.pi / 2 and not self._speed(name) < 0.0:
            raise Refused(
                one,
                f"the ego faces {math.degrees(abs(turn)):.0f} degrees away from its way, and it is never sent against "
                "a lane; turn it along its lane",
            )
        return Start(
            line=EGO_ROUTE,
            along=number(round(along, 3)).expression,
            left=number(round(left, 3)).expression,
            turn=round(turn, 4),
        )

    def _faces(self, name: str) -> Element | None:
        """The place of somebody at first, if it tells a direction, which only a WorldPosition may leave open."""
        where = self._placed_first(name)
        place = where.inside[0] if where is not None and where.tag == "Position" else where
        assert place is not None
        return None if place.tag == "WorldPosition" and "h" not in place.attributes else place

    def _route(self, name: str, one: Element, place: Pose, speed: float) -> Polyline:
        inits = self._inits.get(name, [])
        asked = [route for action in inits if (route := action.find("AssignRouteAction", "Route"))]
        follows = [found for action in inits if (found := action.find("FollowTrajectoryAction")) is not None]
        if speed < 0.0:
            return self._backwards(one, place)
        if follows:
            return self._followed(follows[0])
        length = max(LENGTH, _DRIVES * speed)
        if not asked:
            self._given.note(one, "the ego has no route; it goes on by the straightest lanes")
            return self._onward(one, place, length, faced=self._faces(name) is not None)
        return self._line_of_route(asked[0], place)

    def _backwards(self, one: Element, place: Pose) -> Polyline:
        """The way of an ego that backs: straight, the way its back points."""
        x, y, heading = place
        self._given.note(one, "the ego drives backwards; it goes straight")
        return Polyline([(x - d * math.cos(heading), y - d * math.sin(heading)) for d in (0.0, _BACKS)])

    def _line_of_route(self, route: Element, place: Pose | None) -> Polyline:
        """The line of a Route or of a Position to come to, from a place on if one is told."""
        positions = [p for waypoint in route.all("Waypoint") for p in waypoint.all("Position")] or route.all("Position")
        points = [self._positions.pose(position)[:2] for position in positions]
        if self._given.flag(route, "closed"):
            self._given.note(route, "it is closed; it is followed to its last waypoint, and not back to the first")
        if len(points) < 2 and place is not None:
            points = [place[:2], *points]
        line = self._through(route, points)
        if place is None:
            return line
        along, aside, _ = line.project(*place[:2])
        if abs(aside) < OFF and along < line.length - 1.0:
            return line.between(along, line.length)
        return self._through(route, [place[:2], *points])

    def _through(self, route: Element, points: Sequence[tuple[float, float]]) -> Polyline:
        """A line through points: by the lanes that lead there; where none do, straight if there is road all the way."""
        network, line = self._positions.network, line_through(route, points)
        try:
            lanes = _linked([network.laneAt(point) for point in points], route)
        except Refused:
            if all(network.laneAt(point) is not None for point in line.resampled(_DENSE).points.tolist()):
                return line
            raise
        whole = Polyline.join(*(middle_line(lane) for lane in lanes))
        begin, end = (whole.project(*points[i])[0] for i in (0, -1))
        return whole.between(begin, end) if end - begin > OFF else line  # else it leads against the lane

    def _onward(self, one: Element, place: Pose, length: float, *, faced: bool) -> Polyline:
        """The way from a place on by the straightest lanes; straight on beside all lanes and beyond the last.

        Who is told to face against a lane goes against it.
        """
        network, (x, y, heading) = self._positions.network, place
        lane = network.laneAt((x, y))
        if lane is None:
            self._given.note(one, "the ego stands on no lane; its way leads straight on")
            return headingLine(x, y, heading, length)
        line = middle_line(lane)
        along = line.project(x, y)[0]
        if abs(math.remainder(heading - line.heading_at(along), math.tau)) > math.pi / 2 and faced:
            self._given.note(one, "the ego faces against its lane; its way leads against it")
            line, along = Polyline(line.points[::-1]), line.length - along
        else:
            line = laneLine(lane, along + length, middle_line)
        if (left := line.length - along) >= SHORTEST:
            return line.between(along, min(line.length, along + length))
        self._given.note(one, f"the ego's lane ends {max(left, 0.0):.0f} m ahead of it; its way leads straight on")
        end = min(along, line.length - 1e-2)
        straight = headingLine(*line.point_at(line.length), line.heading_at(line.length), SHORTEST)
        return Polyline.join(line.between(end, line.length), straight)


def _alike(one: Polyline, other: Polyline) -> bool:
    return one.points.shape == other.points.shape and bool((abs(one.points - other.points) < 1e-6).all())


def _linked(lanes: Sequence[Any], route: Element) -> list[Any]:
    """The lanes that lead from one to the next of some, with those."""
    if None in lanes:
        raise Refused(route, f"its waypoint {lanes.index(None) + 1} lies on no lane")
    found = [lanes[0]]
    for lane in lanes[1:]:
        found += _lanes_to(found[-1], lane, route) if lane is not found[-1] else []
    return found


def _lanes_to(first: Any, last: Any, route: Element) -> list[Any]:
    """The lanes from one to another, in driving order, without the first: the fewest."""
    ways: list[list[Any]] = [[first]]
    seen = {first.uid}
    for _ in range(_LINKS):
        longer: list[list[Any]] = []
        for way in ways:
            for maneuver in way[-1].maneuvers:
                parts = [part for part in (maneuver.connectingLane, maneuver.endLane) if part is not None]
                if last in parts:
                    return [*way[1:], *parts[: parts.index(last) + 1]]
                if parts and parts[-1].uid not in seen:
                    seen.add(parts[-1].uid)
                    longer.append([*way, *parts])
        ways = longer
    raise Refused(route, "from one of its waypoints no lane leads to the next; put waypoints between")
