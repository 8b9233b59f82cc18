"""ASAM OpenSCENARIO XML, versions 1.0 to 1.3, as a storyboard of this world; what it says beyond that is refused.

The ego's own events are left to the ego under test, controllers and endings to the simulator; a note says so. Heights
are those of the road. What cannot be said is named with its line, all of it at once.
"""

from __future__ import annotations

import math
import os
import re
import shlex
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, TypeVar

from chatscene.errors import MapError, ScenarioError
from chatscene.imports.entities import Entities
from chatscene.imports.environment import surroundings_of
from chatscene.imports.events import plan_of
from chatscene.imports.given import Given, Refused
from chatscene.imports.player import InLane, Player
from chatscene.imports.positions import Pose, Positions
from chatscene.imports.stranger_xml import Element, read_xml
from chatscene.maps.network import check_opendrive, load_network, resolve_map
from chatscene.maps.onward import LENGTH, route_onward
from chatscene.terms.actors import BY_CLASS, LIMITS, Manner
from chatscene.terms.plan import Kind, Name, Phase, Plan
from chatscene.terms.polyline import Polyline
from chatscene.terms.storyboard import EGO_ROUTE, Actor, Start, Storyboard
from chatscene.terms.sums import Sum, number, sum_of, valued
from chatscene.terms.surroundings import Surroundings

_T = TypeVar("_T")

VERSIONS = (0, 1, 2, 3)  # of 1.x
_OFF = 3.0  # [m] from a place to the ego's route, beyond which the place is not on it
_CENTRED = 0.01  # [m] beside the middle of a lane within which somebody is in it
_TURNED = 0.01  # [rad] away from a line, within which somebody faces along it
_DENSE = 2.0  # [m] between points of the ego's route where it is looked for lanes
_LEFT_ALONE = {
    "ControllerAction": "controllers are not taken; everybody drives as its plan says",
    "VisibilityAction": "everybody is visible",
}
_EGO_DOES = "what the ego does is left to the ego under test"
_ABSOLUTE = re.compile(r"/|[A-Za-z]:/")
_GONE = re.compile(r"[^A-Za-z0-9_]")


@dataclass(frozen=True, slots=True, kw_only=True)
class Imported:
    """A scenario of a file.

    Attributes:
        board: What it says.
        map_path: The map that it lies on.
        notes: What was taken otherwise than it is written, or left to others.
    """

    board: Storyboard
    map_path: Path
    notes: tuple[str, ...]


def read_openscenario(path: Path, map_name: str | None = None) -> Imported:
    """Read a scenario.

    Args:
        path: An ``.xosc`` file.
        map_name: A packaged map or an ``.xodr`` file; None for the one that the file names, which lies beside it.

    Raises:
        ScenarioError: It cannot be read, or says what cannot be said here; the message names elements and lines.
        MapError: The map is not there, or is broken.
    """
    root = read_xml(path)
    if root.tag != "OpenSCENARIO":
        raise ScenarioError(f"{path} is no OpenSCENARIO XML: its root is <{root.tag[:40]}>")
    header = root.find("FileHeader")
    version = (header.attributes.get("revMajor"), header.attributes.get("revMinor")) if header else (None, None)
    if version[0] != "1" or str(version[1]) not in map(str, VERSIONS):
        raise ScenarioError(f"{path} is of version {'.'.join(str(part) for part in version)}; known are 1.0 to 1.3")
    if root.find("Entities") is None or root.find("Storyboard", "Init", "Actions") is None:
        raise ScenarioError(f"{path} tells no scenario: it has no Entities, or no Storyboard with an Init")
    given = Given()
    given.declare(root)
    map_path = _map_of(root, path, given, map_name)
    load_network(map_path)  # whatever is the matter with the map, is no fault of a place in the file
    reader = _Reader(root, given, map_path)
    board = reader.board()
    given.raise_refusals(path)
    assert board is not None
    return Imported(board=board, map_path=map_path, notes=tuple(dict.fromkeys(given.notes)))


def _map_of(root: Element, path: Path, given: Given, map_name: str | None) -> Path:
    if map_name is not None:
        return resolve_map(map_name)
    logic = root.find("RoadNetwork", "LogicFile")
    try:
        named = given.text(logic, "filepath", "").replace("\\", "/") if logic else ""
    except Refused as reason:
        raise ScenarioError(f"{path}: {reason}; name the map with --map") from reason
    if not named:
        raise ScenarioError(f"{path} names no map; name one with --map")
    if not named.endswith(".xodr"):
        raise ScenarioError(f"{path}: its map {named[:60]!r} is no .xodr file; name one with --map")
    where = named if _ABSOLUTE.match(named) else os.path.normpath(path.parent / named)
    beside = path.parent / Path(named).name
    if os.path.normpath(Path.cwd() / where) != os.path.normpath(Path.cwd() / beside):
        raise ScenarioError(
            f"{path}: its map lies in another folder, and none but one beside it is opened unasked; name it with "
            f"--map {shlex.quote(where[:200])}"
        )
    if not beside.is_file():
        raise ScenarioError(
            f"{path}: its map {beside.name!r} does not lie beside it; put it there, or name one with --map"
        )
    check_opendrive(beside)
    return beside


class _Reader:
    def __init__(self, root: Element, given: Given, map_path: Path) -> None:
        self._root, self._given, self._map_path = root, given, map_path
        header = root.find("FileHeader")
        mirrored = header is not None and header.attributes.get("description", "").startswith("CARLA:")
        if header and mirrored:
            given.notes.append(
                f"line {header.line}: its description begins with CARLA:, so y, t and headings count to the right, and "
                "offsets to the right of who drives, as ScenarioRunner reads it"
            )
        self._positions = Positions(given, map_path, mirrored=mirrored)
        self._side = -1 if mirrored else 1
        self._entities = Entities(root, given)
        self._objects = self._entities.objects
        self._lines: dict[str, Polyline] = {}
        self._lanes: dict[str, int] = {}
        self._inits: dict[str, list[Element]] = {}

    def board(self) -> Storyboard | None:
        """The storyboard; None where something was refused."""
        ego = self._attempt(self._entities.ego)
        self._inits = {
            self._given.text(one, "entityRef"): [action for p in one.inside for action in p.inside]
            for one in self._actions().all("Private")
        }
        if ego is None:
            return None
        first = self._attempt(lambda: self._host(ego))
        if first is None:
            return None
        events = self._attempt(lambda: self._events(ego)) or {}
        others = [name for name in self._objects if name != ego]
        made = [self._attempt(partial(self._actor, name, ego, events.get(name))) for name in others]
        actors = [first, *(actor for actor in made if actor is not None)]
        surroundings = self._attempt(lambda: surroundings_of(self._actions(), self._given)) or Surroundings()
        self._endings()
        if not any(actor.plan for actor in actors) and not self._given.refusals:
            self._given.refusals.append(f"line {self._root.line}: nobody but the ego does anything in it")
        return Storyboard(
            actors=tuple(actors),
            lines=self._lines,
            lanes=self._lanes,
            parameters=tuple(sorted(self._given.ranges.values(), key=lambda one: one.name)),
            values={one.name: self._given.nominal[one.name] for one in self._given.ranges.values()},
            surroundings=surroundings,
        )

    def _attempt(self, does: Callable[[], _T]) -> _T | None:
        """What something gives; None where it is refused, which is noted."""
        try:
            return does()
        except Refused as reason:
            self._given.refusals.append(str(reason))
            return None

    def _actions(self) -> Element:
        actions = self._root.find("Storyboard", "Init", "Actions")
        assert actions is not None
        return actions

    # Who

    # Where

    def _place(self, name: str, one: Element, ahead: float) -> Pose | Start:
        """Where somebody's centre is at first."""
        teleport = next((action for action in self._inits.get(name, []) if action.tag == "TeleportAction"), None)
        position = teleport.find("Position") if teleport else None
        if position is None:
            raise Refused(one, "where it is at first is not told; give it a TeleportAction in Init")
        on_line = position.find("TrajectoryPosition")
        if on_line is not None:
            return self._along(on_line, ahead)
        x, y, heading = self._positions.pose(position)
        self._positions.known[name] = (x, y, heading)
        return x + ahead * math.cos(heading), y + ahead * math.sin(heading), heading

    def _along(self, one: Element, ahead: float) -> Start:
        trajectory, turned = one.find("TrajectoryRef", "Trajectory"), one.find("Orientation")
        if trajectory is None:
            raise Refused(one, "its trajectory lies in another file; write it here")
        if turned is not None and turned.attributes.get("type") != "relative":
            raise Refused(turned, 'on a line it is turned beside the line; write type="relative"')
        turn = self._side * self._given.number(turned, "h", "0") if turned else 0.0
        name, _ = self._line_of(trajectory, "")
        along = self._given.sum(one, "s") + number(ahead * math.cos(turn))
        left = self._given.sum(one, "t", "0").times(self._side) + number(ahead * math.sin(turn))
        return Start(line=name, along=along.expression, left=left.expression, turn=round(turn, 6))

    def _line_of(self, trajectory: Element, prefix: str) -> tuple[str, Polyline]:
        """The line of a trajectory and what it is called: as in the file, if that is free or means the same."""
        points = [
            self._positions.pose(position)[:2]
            for vertex in trajectory.walk()
            if vertex.tag == "Vertex"
            for position in vertex.all("Position")
        ]
        if len({(round(x, 3), round(y, 3)) for x, y in points}) < 2:
            raise Refused(trajectory, "it is no line of two points or more; clothoids and curves are not read")
        line = Polyline(points)
        name = _GONE.sub("_", self._given.text(trajectory, "name", ""))
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
                self._given.notes.append(f"line {action.line}: in Init a speed is there at once, whatever its dynamics")
            return self._given.number(target, "value")
        return 0.0

    def _host(self, name: str) -> Actor:
        """The ego, and its route."""
        one = self._objects[name]
        kind, length, width, ahead = self._entities.body(one)
        if kind not in LIMITS or BY_CLASS[kind].row.manner is Manner.WALKS:
            raise Refused(one, "the ego is no vehicle")
        place = self._place(name, one, ahead)
        if isinstance(place, Start):
            raise Refused(one, "the ego begins somewhere on a line; write a WorldPosition or a LanePosition")
        line = self._route(name, one, place)
        self._lines = {EGO_ROUTE: line, **self._lines}
        speed = self._speed(name)
        for action in self._inits.get(name, []):
            if action.tag in _LEFT_ALONE:
                self._given.notes.append(f"line {action.line}: {_LEFT_ALONE[action.tag]}")
            elif action.tag not in ("TeleportAction", "LongitudinalAction") and not action.find("AssignRouteAction"):
                self._given.notes.append(f"line {action.line}: {_EGO_DOES}")
        start = self._on_route(name, one, place, line)
        return Actor(name="ego", kind=kind, length=length, width=width, start=start, speed=speed)

    def _on_route(self, name: str, one: Element, place: Pose, line: Polyline) -> Start:
        """Where on its route the ego begins: as far beside it, and turned as much, as is written."""
        along, left, _ = line.project(*place[:2])
        turn = math.remainder(place[2] - line.heading_at(along), math.tau)
        if self._faces(name) is None:
            if abs(turn) > _TURNED:
                self._given.notes.append(f"line {one.line}: how the ego is turned is not told; it faces along its lane")
            turn = 0.0
        if abs(turn) > math.pi / 2:
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
        place = next(
            position.inside[0]
            for action in self._inits.get(name, [])
            if action.tag == "TeleportAction" and (position := action.find("Position")) is not None
        )
        return None if place.tag == "WorldPosition" and "h" not in place.attributes else place

    def _route(self, name: str, one: Element, place: Pose) -> Polyline:
        asked = [route for action in self._inits.get(name, []) if (route := action.find("AssignRouteAction", "Route"))]
        network = self._positions.network
        if not asked:
            self._given.notes.append(f"line {one.line}: the ego has no route; it goes on by the straightest lanes")
            return self._onward(one, place)
        points = [
            self._positions.pose(position)[:2]
            for waypoint in asked[0].all("Waypoint")
            for position in waypoint.all("Position")
        ]
        if len(points) < 2 or math.dist(points[0], place[:2]) > _OFF:
            points = [place[:2], *points]
        line = Polyline(points)
        if all(network.laneAt(point) is not None for point in line.resampled(_DENSE).points.tolist()):
            return line
        lanes = [network.laneAt(point) for point in points]
        if None in lanes:
            raise Refused(asked[0], f"its waypoint {lanes.index(None) + 1} lies on no lane")
        way = list(dict.fromkeys(lanes))
        linked = [way[0]]
        for lane in way[1:]:
            onward = next((m for m in linked[-1].maneuvers if lane in (m.endLane, m.connectingLane)), None)
            if onward is None:
                raise Refused(asked[0], "from one of its waypoints no lane leads to the next; put waypoints between")
            linked += [part for part in (onward.connectingLane, lane) if part is not None and part not in linked]
        return self._onward(one, place, linked, sum(part.centerline.length for part in linked))

    def _onward(self, one: Element, place: Pose, lanes: Sequence[Any] = (), length: float = LENGTH) -> Polyline:
        try:
            return route_onward(self._positions.network, self._map_path.stem, place[:2], lanes, length).line
        except MapError as error:
            raise Refused(one, str(error)) from error

    # What

    def _actor(self, name: str, ego: str, events: tuple[list[Element], list[Element]] | None) -> Actor | None:
        one = self._objects[name]
        kind, length, width, ahead = self._entities.body(one)
        place = self._place(name, one, ahead)
        prefix = self._prefix(name)
        walks = kind not in LIMITS or BY_CLASS[kind].row.manner is Manner.WALKS or BY_CLASS[kind].lies
        speed = self._speed(name)
        for action in self._inits.get(name, []):
            if action.tag in _LEFT_ALONE:
                self._given.notes.append(f"line {action.line}: {_LEFT_ALONE[action.tag]}")
            elif action.tag not in ("TeleportAction", "LongitudinalAction"):
                raise Refused(action, "in Init, somebody is placed and given a speed; write the rest as an event")
        acts = bool(events and events[0]) or speed != 0
        way, beside = None, 0.0
        if isinstance(place, Start):
            way = place.line if place.line != EGO_ROUTE or place.turn == 0.0 else None
            pose = self._pose_of(place)
            start = place
        else:
            pose = place
            lane = None if walks or not acts else self._positions.lane_line(one, pose)
            way = f"{prefix}Way"
            self._lines[way] = lane or _straight(pose)
            along, left, _ = self._lines[way].project(*pose[:2])
            turn = math.remainder(pose[2] - self._lines[way].heading_at(along), math.tau)
            start = Start(line=way, along=number(along).expression, left=number(left).expression, turn=round(turn, 6))
            way = None if lane is None else way
            beside = 0.0 if lane is None or abs(left) < _CENTRED else left
        self._positions.known.setdefault(name, pose)
        plan: Plan | None = None
        if acts:
            if kind not in LIMITS or BY_CLASS[kind].lies:
                raise Refused(one, "a thing does nothing here")
            player = self._player(name, ego, prefix, kind, speed, None if walks else way, pose, beside)
            moved, first = events or ([], [])
            plan = plan_of(player, moved, self._given, first) if moved else Plan(phases=(self._goes_on(player),))
        return Actor(name=name, kind=kind, length=length, width=width, start=start, speed=speed, plan=plan)

    def _goes_on(self, player: Player) -> Phase:
        speed = number(player.speed).expression
        if player.way is None:
            return Phase("MoveAhead", (speed,))
        beside = (number(player.beside).expression,) if player.beside else ()
        return Phase("DrivePath", (Name(player.way, Kind.PATH), speed, *beside))

    def _player(
        self, name: str, ego: str, prefix: str, kind: str, speed: float, way: str | None, pose: Pose, beside: float
    ) -> Player:
        def lane_from(element: Element, other: str) -> InLane:
            where = self._positions.known.get(other, pose if other == name else None)
            section = self._positions.network.laneSectionAt(where[:2]) if where else None
            if where is None or section is None:
                raise Refused(element, f"{other[:40]!r} stands on no lane")
            return self._positions.in_lane(section, where)

        def lane(element: Element, number: int) -> Polyline:
            line = self._positions.lane_line(element, pose, number)
            assert line is not None
            return line

        def ego_at(position: Element) -> Sum:
            if (on_line := position.find("TrajectoryPosition")) is not None:
                start = self._along(on_line, self._entities.body(self._objects[ego])[3])
                along = sum_of(start.along)
                if start.line != EGO_ROUTE or along is None:
                    raise Refused(position, "it lies on another line than the ego's route")
                return along
            along, aside, _ = self._lines[EGO_ROUTE].project(*self._positions.pose(position)[:2])
            if abs(aside) > _OFF:
                raise Refused(position, f"it is {abs(aside):.0f} m beside the ego's route; put it there")
            return number(round(along, 2))

        section = self._positions.network.laneSectionAt(pose[:2])
        return Player(
            name=name,
            ego=ego,
            prefix=prefix,
            limits=LIMITS[kind],
            walks=BY_CLASS[kind].row.manner is Manner.WALKS,
            speed=speed,
            way=way,
            beside=beside,
            lane=lane,
            lane_from=lane_from,
            left=self._positions.in_lane(section, pose).left if section is not None else 1,
            side=self._side,
            ego_at=ego_at,
            line_of=self._line_of,
            lines=self._lines,
            lanes=self._lanes,
        )

    def _prefix(self, name: str) -> str:
        return f"_{name}"[1:] if name[:1].isalpha() and not _GONE.search(name) else f"a{_GONE.sub('_', name)}"

    def _events(self, ego: str) -> dict[str, tuple[list[Element], list[Element]]]:
        """The events of each actor in their order, and the conditions of its act."""
        found: dict[str, tuple[list[Element], list[Element]]] = {}
        storyboard = self._root.find("Storyboard")
        assert storyboard is not None
        for act in (act for story in storyboard.all("Story") for act in story.all("Act")):
            first = list(self._of_act(act))
            for group in act.all("ManeuverGroup"):
                actors = [ref for one in group.all("Actors") for ref in one.all("EntityRef")]
                if group.all("CatalogReference"):
                    raise Refused(group, "catalogs lie in other files, which are not opened; write the Maneuver here")
                events = [event for maneuver in group.all("Maneuver") for event in maneuver.all("Event")]
                if not events:
                    continue
                if not actors:
                    self._given.refusals.append(str(Refused(group, "the world does not change meanwhile here")))
                    continue
                if len(actors) != 1:
                    self._given.refusals.append(
                        str(Refused(group, "it is of several actors, or of none; write one each"))
                    )
                    continue
                name = self._given.text(actors[0], "entityRef")
                if name == ego:
                    self._given.notes.append(f"line {group.line}: {_EGO_DOES}")
                elif name not in self._objects:
                    raise Refused(actors[0], f"there is no {name[:40]!r}")
                elif name in found:
                    raise Refused(group, f"{name} has events in several groups; write them as one, in their order")
                else:
                    found[name] = events, first
        return found

    def _of_act(self, act: Element) -> Iterator[Element]:
        trigger = act.find("StartTrigger")
        groups = trigger.all("ConditionGroup") if trigger else []
        if len(groups) > 1:
            raise Refused(act, "it begins in one way or another; write its conditions as one group")
        yield from (condition for group in groups for condition in group.all("Condition"))

    # The rest

    def _endings(self) -> None:
        storyboard = self._root.find("Storyboard")
        stops = [one for one in storyboard.walk() if one.tag == "StopTrigger" and one.inside] if storyboard else []
        for one in stops:
            self._given.notes.append(
                f"line {one.line}: a drive ends with a collision, at the end of the route or after 30 s"
            )


def _alike(one: Polyline, other: Polyline) -> bool:
    return one.points.shape == other.points.shape and bool((abs(one.points - other.points) < 1e-6).all())


def _straight(pose: Pose) -> Polyline:
    x, y, heading = pose
    return Polyline([(x, y), (x + 60.0 * math.cos(heading), y + 60.0 * math.sin(heading))])
