"""A scenario of OpenSCENARIO XML as a storyboard of this world: a plan for each who acts, where plans can say it.

The ego's own events are left to the ego under test, controllers and endings to the simulator; a note says so. Heights
are those of the road.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from functools import partial

from chatscene.imports.environment import surroundings_of
from chatscene.imports.events import plan_of
from chatscene.imports.given import Refused
from chatscene.imports.names import Apart
from chatscene.imports.opening import EGO_DOES, GONE, LEFT_ALONE, OFF, Opening
from chatscene.imports.player import InLane, Player
from chatscene.imports.positions import Pose
from chatscene.imports.stranger_xml import Element
from chatscene.situations.phrases import one_seen
from chatscene.terms.actors import BY_CLASS, LIMITS, Manner
from chatscene.terms.plan import Kind, Name, Phase, Plan
from chatscene.terms.polyline import Polyline
from chatscene.terms.storyboard import EGO_ROUTE, Actor, Start, Storyboard
from chatscene.terms.sums import Sum, number, sum_of
from chatscene.terms.surroundings import Surroundings

_TOWARD = -math.cos(math.radians(20.0))  # the cosine of the turn between two who come straight toward each other
_CENTRED = 0.01  # [m] beside the middle of a lane within which somebody is in it


class PlanReader(Opening):
    """Reads plans."""

    _ego_faces = 0.0

    def _speed(self, name: str) -> float:
        """How fast somebody is at first [m/s]."""
        speed, kind = super()._speed(name), self._entities.body(self._objects[name])[0]
        if kind in LIMITS and speed > LIMITS[kind].top_speed:
            most = f"{one_seen(kind)} goes at {LIMITS[kind].top_speed:g} m/s at most where a plan drives it"
            raise Refused(self._objects[name], f"{most}, and it begins at {speed:g} m/s")
        return speed

    def board(self) -> Storyboard | None:
        """The storyboard; None where something was refused."""
        ego = self._attempt(self._entities.ego)
        if ego is None:
            return None
        first = self._attempt(lambda: self._host(ego))
        if first is None:
            return None
        self._ego_faces = self._pose_of(first.start)[2]
        events = self._attempt(lambda: self._events(ego)) or {}
        others = [name for name in self._objects if name != ego]
        apart = Apart("_")
        prefixes = {name: apart.of(_prefix(name)) for name in others}
        made = [self._attempt(partial(self._actor, name, ego, prefixes[name], events.get(name))) for name in others]
        actors = [first, *(actor for actor in made if actor is not None)]
        self._given.refusals += [str(Refused(one, "a plan sets nothing at first")) for one in self.setting()]
        surroundings = self._attempt(lambda: surroundings_of(self._actions(), self._given)) or Surroundings()
        self._endings()
        if not any(actor.plan for actor in actors) and not self._given.refusals:
            self._given.refusals.append(str(Refused(self._root, "only the ego acts in it")))
        return Storyboard(
            actors=tuple(actors),
            lines=self._lines,
            lanes=self._lanes,
            parameters=tuple(sorted(self._given.ranges.values(), key=lambda one: one.name)),
            values={one.name: self._given.nominal[one.name] for one in self._given.ranges.values()},
            surroundings=surroundings,
        )

    def _actor(
        self, name: str, ego: str, prefix: str, events: tuple[list[Element], list[Element]] | None
    ) -> Actor | None:
        one = self._objects[name]
        kind, length, width, ahead = self._entities.body(one)
        place = self._place(name, one, ahead)
        walks = kind not in LIMITS or BY_CLASS[kind].row.manner is Manner.WALKS or BY_CLASS[kind].lies
        speed = self._speed(name)
        for action in self._inits.get(name, []):
            if action.tag in LEFT_ALONE:
                self._given.note(action, LEFT_ALONE[action.tag])
            elif action.tag == "TeleportAction" and not self._puts_first(name, action):
                raise Refused(action, "it has a place already")
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
        called = name if name != "ego" else Apart("_", (name, *self._objects)).of(name)
        return Actor(name=called, kind=kind, length=length, width=width, start=start, speed=speed, plan=plan)

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
            if abs(aside) > OFF:
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
            toward=math.cos(pose[2] - self._ego_faces) < _TOWARD,
            line_of=self._line_of,
            lines=self._lines,
            lanes=self._lanes,
        )

    def _events(  # noqa: C901 - a case for each thing that a plan does not say
        self, ego: str
    ) -> dict[str, tuple[list[Element], list[Element]]]:
        """The events of each actor in their order, and the conditions of its act."""
        found: dict[str, tuple[list[Element], list[Element]]] = {}
        storyboard = self._root.find("Storyboard")
        assert storyboard is not None
        for act in (act for story in storyboard.all("Story") for act in story.all("Act")):
            first = list(self._of_act(act))
            if (stop := act.find("StopTrigger")) is not None and stop.inside:
                raise Refused(stop, "it ends what its act does; a plan goes on to its end")
            for group in act.all("ManeuverGroup"):
                if self._given.count(group, "maximumExecutionCount", "1") != 1:
                    raise Refused(group, "it happens more than once; a plan goes through its phases once")
                actors = [ref for one in group.all("Actors") for ref in one.all("EntityRef")]
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
                    self._given.note(group, EGO_DOES)
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

    def _endings(self) -> None:
        storyboard = self._root.find("Storyboard")
        stops = [one for one in storyboard.walk() if one.tag == "StopTrigger" and one.inside] if storyboard else []
        for one in stops:
            self._given.note(one, "a drive ends with a collision, at the end of the route or after 30 s")


def _prefix(name: str) -> str:
    """A name as the beginning of one of the program."""
    return name if name[:1].isalpha() and not GONE.search(name) else f"a{GONE.sub('_', name)}"


def _straight(pose: Pose) -> Polyline:
    x, y, heading = pose
    return Polyline([(x, y), (x + 60.0 * math.cos(heading), y + 60.0 * math.sin(heading))])
